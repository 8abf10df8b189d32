//! Blocks of the part program that move axes: what the program sees of them (manual 8.1, 8.2, 23.1).

use technol_runtime::{Command, RuntimeEvent};

use crate::plc::Plc;

/// Axis 1 at 20 mm/s by 500 mm/s²: 10 mm take 540 ms.
const BLOCK: &str = "[[block]]\non = 'P1IN.0'\naxes = [[0, 10.0]]\nfeed = 1200\n";
const KEYS: &str = "[control]\nstart = 'P1IN.1'\nstop = 'P1IN.2'\nemergency-stop = 'P1IN.3'\n";
/// The bits of the timelines, copied into outputs.
const WATCH: &str = "LDR PO_F / WR O0 / LDR PO_OSXPI / WR O1 / LDR INPOS / WR O2 / LDR PO_POL / WR O3 / \
                     LDR PO_STOP / WR O4 / LDR BLOCK_RESTART / WR O5 / LDR SF_RUN / WR O6 / LDR SF_STOPPOSCHANGED / WR O7 / \
                     LOD OB / STO P0OUT";
const NAMES: [&str; 8] =
    ["PO_F", "PO_OSXPI", "INPOS", "PO_POL", "PO_STOP", "BLOCK_RESTART", "SF_RUN", "SF_STOPPOSCHANGED"];

/// A drawing of the bits, a character a cycle; `drive` gives the keys of each cycle.
fn draw(plc: &mut Plc, cycles: u32, drive: impl Fn(u32) -> u8) -> String {
    let mut lines: Vec<String> = NAMES.iter().map(|name| format!("{name:17} ")).collect();
    for cycle in 0..cycles {
        plc.inputs()[0] = drive(cycle);
        plc.run(1);
        for (bit, line) in lines.iter_mut().enumerate() {
            line.push(if plc.ports()[0] >> bit & 1 != 0 { '#' } else { '_' });
        }
    }
    lines.join("\n")
}

fn started(machine: &str, lines: &str) -> Plc {
    let mut plc = Plc::before(&format!("{machine}{KEYS}"), lines);
    plc.run(2);
    plc
}

#[test]
fn a_block_moves_its_axis_and_ends_where_the_axis_arrives() {
    let mut plc = started(BLOCK, WATCH);
    let drawn = draw(&mut plc, 34, |_| 1);
    // 540 ms are 27 cycles.
    insta::assert_snapshot!(drawn, @r"
    PO_F              ###########################_______
    PO_OSXPI          ###########################_______
    INPOS             #__________________________#######
    PO_POL            ___________________________#######
    PO_STOP           __________________________________
    BLOCK_RESTART     __________________________________
    SF_RUN            ###########################_______
    SF_STOPPOSCHANGED __________________________________
    ");
    assert_eq!(plc.differences("QWRD.B_POL_EX=27100000h DWRD.B_POL=80000"), [""; 0], "10 mm");
}

#[test]
fn stop_holds_the_axis_and_start_leads_on() {
    let mut plc = started(BLOCK, WATCH);
    let drawn = draw(&mut plc, 54, |cycle| match cycle {
        10..12 => 1 | 4,
        25..27 => 1 | 2,
        _ => 1,
    });
    // The stop is taken at the end of its cycle; 20 mm/s by 500 mm/s² stand after 40 ms, by 2000 mm/s² after 10.
    insta::assert_snapshot!(drawn, @r"
    PO_F              ##########################################____________
    PO_OSXPI          ##########################################____________
    INPOS             #___________##############________________############
    PO_POL            __________________________________________############
    PO_STOP           ___________##############_____________________________
    BLOCK_RESTART     _________________________#################____________
    SF_RUN            ###########______________#################____________
    SF_STOPPOSCHANGED ______________________________________________________
    ");
    assert_eq!(plc.differences("QWRD.B_POL_EX=27100000h"), [""; 0]);
}

#[test]
fn an_emergency_stop_holds_the_axis_and_annulment_ends_the_block() {
    let mut plc = started(BLOCK, WATCH);
    let drawn = draw(&mut plc, 20, |cycle| if cycle == 10 { 1 | 8 } else { 1 });
    // The stop is taken at the end of its cycle; 20 mm/s by 500 mm/s² stand after 40 ms, by 2000 mm/s² after 10.
    insta::assert_snapshot!(drawn, @r"
    PO_F              ####################
    PO_OSXPI          ####################
    INPOS             #__________#########
    PO_POL            ____________________
    PO_STOP           ___________#########
    BLOCK_RESTART     ____________________
    SF_RUN            ###########_________
    SF_STOPPOSCHANGED ____________________
    ");
    plc.command(Command::AbortBlock);
    plc.run(20);
    assert_eq!(plc.differences("O0=0 O1=0 O2=1 O3=0"), [""; 0]);
}

#[test]
fn an_axis_that_the_program_holds_keeps_the_block_waiting() {
    let mut plc = started(BLOCK, "LDR I0 / JL0 L / POS_RESET 1 / L: LDR I1 / JL0 M / POS_INIT 1 / M:");
    plc.set("I1=1");
    plc.run(1);
    plc.set("I1=0");
    plc.inputs()[0] = 1;
    plc.run(60);
    assert_eq!(plc.differences("PO_F=1 PO_POL=0 QWRD.B_POL_EX=0"), [""; 0]);
    plc.set("I0=1");
    plc.run(32);
    assert_eq!(plc.differences("PO_F=0 PO_POL=1 QWRD.B_POL_EX=27100000h"), [""; 0]);
}

#[test]
fn a_position_error_that_is_too_great_ends_the_movement_and_start_does_not_lead_on() {
    let mut plc = started(BLOCK, "LDR I0 / FL1 0,VAZBA_X");
    plc.inputs()[0] = 1;
    plc.run(10);
    plc.set("I0=1");
    plc.run(15);
    assert_eq!(plc.differences("PO_F=1 PO_STOP=1 PO_POL=0 BZH13=1"), [""; 0]);
    plc.set("I0=0");
    plc.command(Command::ContinueBlock);
    plc.run(5);
    assert_eq!(plc.differences("PO_F=1 PO_STOP=1 PO_POL=0"), [""; 0]);
    plc.command(Command::AbortBlock);
    plc.run(2);
    assert_eq!(plc.differences("PO_F=0"), [""; 0]);
}

#[test]
fn a_block_without_any_feed_is_refused_and_the_program_ends_with_it() {
    use technol_runtime::{Block, Prepared, Rejection, Shared};
    let mut plc = started("", "LDR I0");
    let mut prepared = Prepared::default();
    prepared.axes[0] = Some(10.0);
    plc.command(Command::StartBlock(Block { prepared: Some(Shared::new(prepared)), ..Block::default() }));
    plc.command(Command::StartBlock(Block::default()));
    let events = plc.events(10);
    assert!(events.contains(&RuntimeEvent::BlockRejected(Rejection::NoFeed)));
    assert!(!events.iter().any(|e| matches!(e, RuntimeEvent::BlockStarted { .. })));
    assert_eq!(plc.differences("PO_F=0 QWRD.B_POL_EX=0"), [""; 0]);
}

#[test]
fn g96_turns_the_spindle_faster_towards_the_middle() {
    let machine = "[[spindle]]\nnumber = 1\ngear = [{ max-speed = 2000 }]\n\
                   [[block]]\non = 'P1IN.0'\nm = [3, 41]\nspeed = 400\naxes = [[0, 40.0]]\nrapid = true\n\
                   [[block]]\nflags = ['const-cut-speed']\ncutting-speed = 90\nspeed-limit = 1000\naxes = [[0, 5.0]]\nfeed = 600\n\
                   [[block]]\nspeed = 100\n";
    let mut plc = started(machine, "LDR BLK[0].ConstCutSpeed / WR O0 / LOD BLK[0].REAL.ConstCuttingSpeed");
    plc.inputs()[0] = 1;
    plc.run(20);
    // 400 of 2000 rev/min.
    assert_eq!(plc.differences("WORD.PB11=6553 WORD.VYSOVERS=6553 AKRR_ACT_V=0 O0=0"), [""; 0]);
    plc.run(60);
    assert_eq!(plc.differences("O0=1 AKRR_ACT_V=90000 AKRR_ACT_SMAX=1000000 DR_REAL=90000.0"), [""; 0]);
    plc.run(100);
    // Under 14.3 mm the limit counts: half of the range. PB11 stays as programmed.
    assert_eq!(
        plc.differences("AKRR_ACT_S=1000000 AKRR_ACT_OUT=16384 WORD.VYSOVERS=16384 WORD.PB11=6553"),
        [""; 0]
    );
    plc.run(80);
    assert_eq!(plc.differences("O0=0 AKRR_ACT_S=0 WORD.VYSOVERS=1638"), [""; 0], "G97");
}

#[test]
fn m30_ends_the_program_wherever_it_stands() {
    let machine = "[[block]]\non = 'P1IN.0'\nmotion-ms = 20\n[[block]]\nm = [30]\nmotion-ms = 20\n\
                   [[block]]\nm = [3]\nmotion-ms = 20\n\
                   [[block]]\non = 'P1IN.4'\nm = [4]\nmotion-ms = 20\n";
    let mut plc = started(machine, "EDGE_H PO_F / JL0 L / LOD W1 / INR / STO W1 / L:");
    plc.inputs()[0] = 1;
    plc.run(20);
    assert_eq!(plc.differences("W1=2 M03PI=0 PO_STOP=0"), [""; 0]);
    plc.inputs()[0] = 0x11;
    plc.run(10);
    assert_eq!(plc.differences("W1=3 M04PI=1"), [""; 0]);
}
