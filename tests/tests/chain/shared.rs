//! Shared names, shared areas, memory that is kept (manual 18).

use technol_machine::Value;

use crate::coverage::with_mutants;
use crate::plc::Plc;

#[track_caller]
fn holds(plc: &Plc, expected: &str) {
    assert_eq!(plc.differences(expected), [""; 0]);
    assert_eq!(plc.fault(), None);
}

fn shared(plc: &mut Plc) -> Vec<(String, Value)> {
    let memory = plc.memory().to_vec();
    let names = plc.control().shared().iter();
    names.map(|it| (String::from_utf8_lossy(&it.name).into_owned(), it.value(&memory))).collect()
}

#[test]
fn screens_see_published_cells_under_their_names() {
    let init = "SHARE_VAR D1,'Count',TYPE_DWORD / SHARE_VAR D1,'Signed',TYPE_INT_8,R1,R2 / SHARE_VAR R1,'Low',TYPE_REAL / \
                SHARE_VAR LONG+2,'Title',TYPE_STR / SHARE_VAR AREA+1,'Part',TYPE_BIN,3 / SHARE_BIT OB,'Lamp',O3 / \
                SHARE_BIT OB+1,'Next',O3";
    let mut plc = Plc::with_init(init, "");
    plc.set("D1=0FFFFFFFEh REAL.R1=-1.5 REAL.R2=3.5 OB=8 DWRD.AREA=44332211h");
    let text = |text: &str| Value::Bytes(text.as_bytes().to_vec());
    let expected = [
        ("Count", Value::Int(0xFFFF_FFFE)),
        ("Signed", Value::Int(-2)),
        ("Low", Value::Real(-1.5)),
        ("Title", Value::Text(b"cdefgh".to_vec())),
        ("Part", text("\x22\x33\x44")),
        ("Lamp", Value::Int(1)),
        ("Next", Value::Int(0)),
    ];
    assert_eq!(shared(&mut plc), expected.map(|(name, value)| (name.to_owned(), value)));
    let memory = plc.memory().to_vec();
    let limits: Vec<_> = plc.control().shared().iter().map(|it| it.limits(&memory)).collect();
    assert_eq!(limits[..2], [[None, None], [Some(-1.5), Some(3.5)]]);
}

#[test]
fn rlo_tells_whether_a_name_was_accepted() {
    let init = "SHARE_VAR D1,'Count',TYPE_DWORD / WR O0 / SHARE_BIT OB,'Count',O3 / WR O1 / SHARE_VAR D2,'count',TYPE_DWORD / WR O2";
    let mut plc = Plc::with_init(init, "");
    holds(&plc, "OB=5");
    // A start forgets the names.
    plc.restart();
    holds(&plc, "OB=5");
    assert_eq!(shared(&mut plc).len(), 2);
}

#[test]
fn a_shared_area_is_granted_in_the_next_cycle() {
    let mut plc =
        Plc::of("MECH_BEGIN M / LOD CNST.7 / SA_READ 1,10,4,D1 / EX0 / STO D2 / FL 1,O0 / MECH_END M");
    plc.control().shared_area_mut(1).expect("an area")[10..14].copy_from_slice(&[1, 2, 3, 4]);
    plc.set("M=1 D2=5");
    plc.run(1);
    holds(&plc, "D1=0 D2=5 M=1 OB=0 RLO=0 DR=0");
    plc.run(1);
    holds(&plc, "D1=04030201h D2=0 M=0 OB=1");
}

#[test]
fn offsets_of_every_type() {
    for offset in ["CNST.300", "300", "W1", "WORD.W1"] {
        let lines = format!(
            "MECH_BEGIN M / SA_READ 1,{offset},2,D1 / EX0 / SA_WRITE 0,{offset},3,Q1 / EX0 / MECH_END M"
        );
        let mut plc = Plc::of(&lines);
        plc.control().shared_area_mut(1).expect("an area")[300..304].copy_from_slice(&[1, 2, 3, 4]);
        plc.set("M=1 W1=300 DWRD.Q1=44332211h");
        plc.run(3);
        holds(&plc, "D1=0201h M=0");
        assert_eq!(plc.control().shared_area_mut(0).expect("an area")[299..304], [0, 0x11, 0x22, 0x33, 0]);
    }
}

#[test]
fn cells_of_every_type() {
    let types: [(&str, i64); 20] = [
        ("INT_8", -1),
        ("INT8", -1),
        ("UNS_8", 0xFF),
        ("UNS8", 0xFF),
        ("BYTE", 0xFF),
        ("INT_16", -0x1101),
        ("INT16", -0x1101),
        ("UNS_16", 0xEEFF),
        ("UNS16", 0xEEFF),
        ("WORD", 0xEEFF),
        ("INT_32", -0x3322_1101),
        ("INT32", -0x3322_1101),
        ("UNS_32", 0xCCDD_EEFF),
        ("UNS32", 0xCCDD_EEFF),
        ("DWORD", 0xCCDD_EEFF),
        ("INT_64", -0x7766_5544_3322_1101),
        ("INT64", -0x7766_5544_3322_1101),
        ("UNS_64", -0x7766_5544_3322_1101),
        ("UNS64", -0x7766_5544_3322_1101),
        ("QWORD", -0x7766_5544_3322_1101),
    ];
    for (name, value) in types {
        with_mutants(|| {
            let init = format!(
                "STRCPY LONG,'Of' / SHARE_VAR Q1,LONG,TYPE_{name} / WR O0 / SHARE_BIT OB,LONG,O1 / WR O1"
            );
            let mut plc = Plc::with_init(&init, "");
            holds(&plc, "O0=1 O1=0");
            plc.set("QWRD.Q1=8899AABBCCDDEEFFh");
            let [(of, found)] = &shared(&mut plc)[..] else { panic!("one name") };
            assert_eq!((of.as_str(), found), ("Of", &Value::Int(value)), "{name}");
        });
    }
    let mut plc = Plc::with_init("STRCPY LONG,'Lit' / SHARE_BIT OB,LONG,O1", "FL 1,O1");
    plc.run(1);
    assert_eq!(shared(&mut plc), [("Lit".to_owned(), Value::Int(1))]);
}

#[test]
fn either_limit_may_be_left_out() {
    let init = "SHARE_VAR D1,'A',TYPE_DWORD,-,REAL.R2 / SHARE_VAR D1,'B',TYPE_DWORD,REAL.R1,- / SHARE_VAR D1,'C',TYPE_DWORD,R2 / \
                SHARE_VAR D1,'D',TYPE_DWORD,-,R1";
    let mut plc = Plc::with_init(init, "");
    plc.set("REAL.R1=1.5 REAL.R2=2.5");
    let memory = plc.memory().to_vec();
    let limits: Vec<_> = plc.control().shared().iter().map(|it| it.limits(&memory)).collect();
    assert_eq!(limits, [[None, Some(2.5)], [Some(1.5), None], [Some(2.5), None], [None, Some(1.5)]]);
}

#[test]
fn what_stands_before_a_transfer_is_executed_once() {
    let mut plc = Plc::of("MECH_BEGIN M / LOD W1 / INR / STO W1 / SA_WRITE 0,31996,4,D1 / EX0 / MECH_END M");
    plc.set("M=1 D1=11223344h");
    plc.run(1);
    assert_eq!(plc.control().shared_area_mut(0).expect("an area")[31996..], [0; 4]);
    plc.run(1);
    assert_eq!(plc.control().shared_area_mut(0).expect("an area")[31996..], [0x44, 0x33, 0x22, 0x11]);
    holds(&plc, "W1=1 M=0");
    assert_eq!(plc.control().shared_area_mut(1).expect("an area")[31996..], [0; 4]);
    // A power-on clears the areas, a start alone does not.
    plc.restart();
    assert_eq!(plc.control().shared_area_mut(0).expect("an area")[31996], 0x44);
    plc.restart_cold();
    assert_eq!(plc.control().shared_area_mut(0).expect("an area")[31996], 0);
}

#[test]
fn bytes_outside_the_area_are_an_error() {
    let mut plc =
        Plc::of("MECH_BEGIN M / SA_WRITE 0,W1,4,D1 / WR O2 / CONDR 0 / WR O0 / FL 1,O1 / MECH_END M");
    plc.set("M=1 W1=31997 OB=4");
    plc.run(1);
    holds(&plc, "OB=3 M=0");
    plc.set("M=1 W1=31996 OB=0");
    plc.run(1);
    holds(&plc, "OB=2 M=0");
}

#[test]
fn the_error_of_either_direction_is_a_number_in_dr() {
    for transfer in ["SA_READ", "SA_WRITE"] {
        for place in ["0,W1", "1,W2"] {
            with_mutants(|| {
                let mut plc = Plc::of(&format!(
                    "MECH_BEGIN M / LOD CNST.-1 / LDR -I0 / {transfer} {place},4,D1 / WR O0 / STO QWRD.Q1 / FL 1,O1 / MECH_END M"
                ));
                plc.set("M=1 W1=31997 W2=-1 D1=77 OB=1");
                plc.run(1);
                holds(&plc, "OB=2 QWRD.Q1=1 D1=77 M=0");
            });
        }
    }
}

#[test]
fn a_transfer_begins_anew_when_its_line_was_left_for_a_cycle() {
    let mut plc = Plc::of("MECH_BEGIN M / SA_READ 0,0,4,D1 / EX0 / MECH_END M");
    plc.control().shared_area_mut(0).expect("an area")[0] = 9;
    plc.set("M=1");
    plc.run(1);
    plc.set("M=0");
    plc.run(3);
    plc.set("M=1");
    plc.run(1);
    holds(&plc, "M=1 D1=0");
    plc.run(1);
    holds(&plc, "M=0 D1=9");
}

#[test]
fn memory_is_kept_while_the_power_is_off() {
    let mut plc = Plc::of("LDR I0 / FL1 1,REQ_BACKUP_MEM");
    plc.set("WORD.PLC_MEM_BACKUP=1234h BYTE.(PLC_MEM_BACKUP+9999)=5 W1=7");
    plc.run(1);
    assert_eq!(plc.control().times_saved(), 0);
    plc.set("I0=1");
    plc.run(1);
    // Saved, and the request taken back.
    holds(&plc, "REQ_BACKUP_MEM=0");
    assert_eq!(plc.control().times_saved(), 1);
    plc.set("I0=0 WORD.PLC_MEM_BACKUP=1");
    plc.restart_cold();
    holds(&plc, "WORD.PLC_MEM_BACKUP=1234h BYTE.(PLC_MEM_BACKUP+9999)=5 W1=0");
    // A stop saves, too.
    plc.set("WORD.PLC_MEM_BACKUP=77");
    plc.stop();
    plc.restart_cold();
    holds(&plc, "WORD.PLC_MEM_BACKUP=77");
}
