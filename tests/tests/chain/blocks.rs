//! The part-program block as the program sees it: functions (manual 8.2) and prepared blocks (8.3).

use technol_runtime::{Block, BlockFlag, BlockFlags, BlockReal, Command, Prepared};

use crate::coverage::wrong_rows;
use crate::plc::Plc;

/// In each row: the lines, and what is true while the first of the blocks moves.
#[track_caller]
fn check(blocks: &[Block], rows: &[(&str, &str)]) {
    let wrong = wrong_rows(rows, |(lines, then)| {
        let mut plc = Plc::of(lines);
        plc.set("I0=1");
        for block in blocks {
            plc.command(Command::StartBlock(block.clone()));
        }
        plc.run(1);
        let mut found = plc.differences(then);
        found.extend(plc.fault());
        found
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Three blocks: one with everything, one with little, one with nothing.
fn three() -> [Block; 3] {
    let mut prepared = Prepared {
        flags: BlockFlags::default().with(BlockFlag::First).with(BlockFlag::WithoutTechnology),
        integers: [None, None, Some(-3), None, None],
        reals: [None, None, Some(1.5), Some(2.25), None],
        ..Prepared::default()
    };
    prepared.axes[2] = Some(-12.5);
    prepared.values[BlockReal::BlockLen as usize] = Some(20.0);
    let first = Block {
        m: vec![3, 77],
        t: Some(300),
        h: Some(6),
        rapid: true,
        prepared: Some(Box::new(prepared)),
        ..Block::default()
    };
    let second = Block { m: vec![0, 4], t: Some(12), ..Block::default() };
    [first, second, Block::default()]
}

#[test]
fn bits_of_prepared_blocks() {
    check(
        &three(),
        &[
            ("LDR BLK[0].M2 / WR O0", "O0=1"),
            ("LDR -BLK[0].M2 / WR O0", "O0=0"),
            ("LDR BLK[0].M1 / WR O0 / LDR BLK[1].M1 / WR O1", "O0=0 O1=1"),
            ("LDR I0 / LA BLK[0].FirstBlock / WR O0 / LDR I0 / LA -BLK[1].FirstBlock / WR O1", "O0=1 O1=1"),
            ("LDR I1 / LO BLK[0].TchlOff / WR O0 / LDR I1 / LO BLK[1].TchlOff / WR O1", "O0=1 O1=0"),
            ("LDR I0 / LX BLK[1].Stop / WR O0 / LDR BLK[1].CondStop / WR O1", "O0=0 O1=0"),
            ("LDR BLK[0].AxNC2Move / WR O0 / LDR BLK[0].AxNC1Move / WR O1", "O0=1 O1=0"),
            (
                "LDR BLK[0].IPlc2 / WR O0 / LDR BLK[0].RPlc3 / WR O1 / LDR BLK[0].RPlc4 / WR O2",
                "O0=1 O1=1 O2=0",
            ),
            (
                "LDR BLK[0].HProg / WR O0 / LDR BLK[1].HProg / WR O1 / LDR BLK[1].TProg / WR O2",
                "O0=1 O1=0 O2=1",
            ),
            ("LDR BLK[3].TProg / WR O0 / LDR BLK[16].M2 / WR O1 / LDR BLK[17].M2 / WR O2", "O0=0 O1=0 O2=0"),
            ("LDR BLK[65535].M2 / WR O0", "O0=0"),
        ],
    );
}

#[test]
fn numbers_of_prepared_blocks() {
    check(
        &three(),
        &[
            ("LOD BLK[0].T", "DR64=300"),
            ("LOD BLK[1].T", "DR64=12"),
            ("LOD BLK[2].T", "DR64=12"), // not programmed: that of the block before
            ("LOD CNST.5 / LOD BLK[3].T", "DR64=0"),
            ("LOD CNST.5 / LOD BLK[40].T", "DR64=0"),
            ("LOD BLK[0].BYTE.T", "DR64=44"),
            ("LOD BLK[0].WORD.T", "DR64=300"),
            ("LOD BLK[0].M[14]", "DR64=77h"),
            ("LOD BLK[1].M[2]", "DR64=4"),
            ("LOD BLK[0].IPlcParams[2]", "DR64=-3"),
            ("LOD BLK[0].AxG[1]", "DR64=1"),
            ("LOD CNST.5 / AD BLK[1].T", "DR64=17"),
            ("LOD CNST.5 / SU BLK[1].T", "DR32=-7"),
            ("LOD CNST.3 / ORB BLK[1].T", "DR64=15"),
            ("LOD CNST.5 / ANDB BLK[1].T", "DR64=4"),
            ("LOD CNST.5 / XORB BLK[1].T", "DR64=9"),
            ("LOD CNST.5 / MULB BLK[0].IPlcParams[2]", "DR64=-15"),
            ("LOD CNST.61 / DIVB BLK[1].T", "DR64=5"),
            ("LOD CNST.12 / EQ BLK[1].T / WR O0 / EQ BLK[0].T / WR O1", "O0=1 O1=0"),
            ("LOD CNST.12 / LT BLK[0].T / WR O0 / GT BLK[0].T / WR O1", "O0=1 O1=0"),
            ("LOD CNST.12 / LE BLK[1].T / WR O0 / GE BLK[0].T / WR O1", "O0=1 O1=0"),
            ("LDR I0 / LOD CNST.12 / EQ1 BLK[1].T / WR O0", "O0=1"),
            ("LDR I1 / LOD CNST.12 / EQ1 BLK[1].T / WR O0", "O0=0"),
            ("LOD BLK[0].REAL.H", "DR_REAL=6.0 DR64=6"),
            ("LOD BLK[0].REAL.RPlcParams[2] / AD BLK[0].REAL.RPlcParams[3]", "DR_REAL=3.75"),
            ("LOD BLK[0].REAL.AxNC[2] / SU BLK[0].REAL.BlockLen", "DR_REAL=-32.5"),
            ("LOD BLK[0].REAL.BlockLen / MULB BLK[0].REAL.RPlcParams[2]", "DR_REAL=30.0"),
            ("LOD BLK[0].REAL.BlockLen / DIVB BLK[0].REAL.H / GT BLK[1].REAL.BlockLen / WR O0", "O0=1"),
            ("LOD BLK[1].REAL.BlockLen / EQ CNST.0.0 / WR O0 / LOD BLK[9].REAL.Scale", "O0=1 DR_REAL=0.0"),
            ("LOD CNT_NEXT_BLOCKS", "DR64=2"),
        ],
    );
}

#[test]
fn the_block_whose_number_is_in_bx() {
    check(
        &three(),
        &[
            ("LOD CNST.0 / MOV BX,CX / LOD BLK[BX].T", "DR64=300 BX=0"),
            ("LOD CNST.1 / MOV BX,CX / LOD BLK[BX].WORD.T", "DR64=12 BX=1"),
            ("LOD CNST.3 / MOV BX,CX / LOD BLK[BX].T", "DR64=0"),
            ("LOD CNST.17 / MOV BX,CX / LOD BLK[BX].T", "DR64=0"),
            ("LOD CNST.-1 / MOV BX,CX / LOD BLK[BX].T", "DR64=0"),
            ("LOD CNST.0 / MOV BX,CX / LOD BLK[BX].REAL.RPlcParams[3]", "DR_REAL=2.25"),
            ("LOD CNST.1 / MOV BX,CX / LDR I0 / LA BLK[BX].TProg / LA -BLK[BX].HProg / WR O0", "O0=1"),
            ("LOD CNST.2 / MOV BX,CX / LDR BLK[BX].TProg / WR O0", "O0=0"),
            ("LOD CNST.0 / MOV BX,CX / LDR I0 / LDR BLK[BX].M2 / LA / WR O0", "O0=1"),
            // A jump to the line brings the member too.
            ("LOD CNST.1 / MOV BX,CX / JUM L / LOD BLK[BX].M[2] / L: / LOD BLK[BX].T", "DR64=12"),
        ],
    );
}

/// A block with these M functions that moves for a second.
fn with(m: &[u8]) -> [Block; 1] {
    [Block { m: m.to_vec(), motion_ms: 1000, ..Block::default() }]
}

#[test]
fn functions_of_every_group_have_their_bits_and_cells() {
    let rows: &[(&[u8], &str, &str)] = &[
        (&[0], "LDR M00_PID / LA ZMM1PI / WR O0", "O0=1"),
        (&[1], "LDR M01_PID / LA ZMM1PI / WR O0", "O0=1"),
        (&[2], "LDR M02_PID / LA ZMM1PI / WR O0", "O0=1"),
        (&[30], "LDR M30_PID / LA ZMM1PI / WR O0", "O0=1"),
        (&[4, 3], "LDR M03PI / LA -M04PI / LA -M19PI / LA ZMM2PI / WR O0 / LOD PB06", "O0=1 DR64=03h"),
        (&[3, 4], "LDR M04PI / LA -M03PI / LA -M19PI / LA ZMM2PI / WR O0 / LOD PB06", "O0=1 DR64=04h"),
        (&[3, 5], "LDR -M03PI / LA -M04PI / LA -M19PI / LA ZMM2PI / WR O0 / LOD PB06", "O0=1 DR64=05h"),
        (&[3, 19], "LDR M19PI / LA -M03PI / LA -M04PI / LA ZMM2PI / WR O0 / LOD PB06", "O0=1 DR64=19h"),
        (&[44, 41], "LDR M41PI / LA -M42PI / LA -M43PI / LA -M44PI / LA ZMM3PI / WR O0", "O0=1"),
        (&[41, 42], "LDR M42PI / LA -M41PI / LA -M43PI / LA -M44PI / LA ZMM3PI / WR O0", "O0=1"),
        (&[42, 43], "LDR M43PI / LA -M41PI / LA -M42PI / LA -M44PI / LA ZMM3PI / WR O0", "O0=1"),
        (&[43, 44], "LDR M44PI / LA -M41PI / LA -M42PI / LA -M43PI / LA ZMM3PI / WR O0", "O0=1"),
        (&[90], "LDR ZMM4PI / WR O0 / LDR BLK[0].M4 / WR O1 / LOD BLK[0].M[4]", "O0=1 O1=1 DR64=90h"),
        (&[7], "LDR M07PI / LA -M08PI / LA ZMM5PI / WR O0", "O0=1"),
        (&[8], "LDR M08PI / LA -M07PI / LA ZMM5PI / WR O0", "O0=1"),
        (&[17], "LDR M07PI / LA M08PI / LA ZMM5PI / WR O0", "O0=1"),
        (&[17, 9], "LDR -M07PI / LA -M08PI / LA ZMM5PI / WR O0", "O0=1"),
        (&[50], "LDR M50PI / LA -M51PI / LA ZMM6PI / WR O0", "O0=1"),
        (&[51], "LDR M51PI / LA -M50PI / LA ZMM6PI / WR O0", "O0=1"),
        (&[52], "LDR M50PI / LA M51PI / LA ZMM6PI / WR O0", "O0=1"),
        (&[52, 53], "LDR -M50PI / LA -M51PI / LA ZMM6PI / WR O0", "O0=1"),
        (&[10], "LDR M10PID / LA -M11PID / LA ZMM7PI / WR O0", "O0=1"),
        (&[11], "LDR M11PID / LA -M10PID / LA ZMM7PI / WR O0", "O0=1"),
        (&[48], "LDR ZMM8PI / WR O0 / LOD BLK[0].M[8]", "O0=1 DR64=48h"),
        (&[6], "LDR M06PID / LA -M60PI / LA ZMM9PI / WR O0", "O0=1"),
        (&[60], "LDR M60PI / LA -M06PID / LA ZMM9PI / WR O0", "O0=1"),
        (&[91], "LDR ZMM10PI / WR O0 / LOD PB03", "O0=1 DR64=-6Fh"), // 91h, a BYTE
        (&[61], "LDR ZMM11PI / WR O0 / LOD PB13", "O0=1 DR64=61h"),
        (&[62], "LDR ZMM12PI / WR O0 / LOD PB14", "O0=1 DR64=62h"),
        (&[63], "LDR ZMM13PI / WR O0 / LOD PB15", "O0=1 DR64=63h"),
        (&[77], "LDR ZMM14PI / LA -ZMM13PI / WR O0 / LOD PB16", "O0=1 DR64=77h"),
    ];
    for (m, lines, then) in rows {
        let mut plc = Plc::of(lines);
        plc.runtime().set_m_groups(&[(90, 4), (91, 10), (61, 11), (62, 12), (63, 13)]).expect("free ones");
        let [block] = with(m);
        plc.command(Command::StartBlock(block));
        plc.run(1);
        assert_eq!(plc.differences(then), [""; 0], "{m:?}: {lines}");
    }
}

#[test]
fn numbers_of_the_block_have_their_cells() {
    let block = Block {
        t: Some(87_654_321),
        h: Some(95),
        s: Some(21_159),
        rapid: true,
        motion_ms: 1000,
        ..Block::default()
    };
    check(
        &[block],
        &[
            ("LOD DWRD.PB07", "DR64=-789ABCDFh"), // 87654321h
            ("LOD PB05 / LDR ZMSHPI / LA ZMSTPI / LA ZMSSPI / WR O0", "DR8=95h O0=1"),
            ("LOD WORD.PB11", "DR64=52A7h"),
            ("LDR G00PI / LA AUTPI / LA -CAPI / LA -REFPI / LA -G33PI / WR O0", "O0=1"),
            ("LDR PO_F / LA -PO_POL / LA -INPOS / LA -PO_STOP / WR O0", "O0=1"),
        ],
    );
}

#[test]
fn m40_chooses_the_gear_for_the_speed() {
    let mut plc = Plc::before(
        "[[spindle]]\ngear = [{ max-speed = 200 }, { max-speed = 900 }]",
        "LDR M41PI / WR O0 / LDR M42PI / WR O1 / LDR ZMM3PI / WR O2 / LOD BLK[0].REAL.SpindleSpeed",
    );
    plc.run(1);
    for (m, speed, then) in [
        (vec![40], 630.0, "O0=0 O1=1 O2=1 DR_REAL=630.0"),
        (vec![], 120.0, "O0=1 O1=0 O2=1 DR_REAL=120.0"),
        (vec![], 130.0, "O0=1 O1=0 O2=0 DR_REAL=130.0"),
    ] {
        let mut prepared = Prepared::default();
        prepared.set(BlockReal::SpindleSpeed, speed);
        let prepared = Some(Box::new(prepared));
        plc.command(Command::StartBlock(Block { m, motion_ms: 40, prepared, ..Block::default() }));
        plc.run(1);
        assert_eq!(plc.differences(then), [""; 0], "S{speed}");
        plc.run(3);
    }
}

#[test]
fn one_block_bits_end_with_the_block_and_static_ones_stay() {
    let mut plc =
        Plc::of("LDR M10PID / LO ZMM2PI / LO ZMM7PI / WR O0 / LDR M03PI / WR O1 / LDR BLK[0].M2 / WR O2");
    let [block] = with(&[3, 10]);
    plc.command(Command::StartBlock(Block { motion_ms: 40, ..block }));
    plc.run(1);
    assert_eq!(plc.differences("O0=1 O1=1 O2=1"), [""; 0]);
    plc.run(3);
    assert_eq!(plc.differences("O0=0 O1=1 O2=1"), [""; 0], "the record stays until the next block");
}
