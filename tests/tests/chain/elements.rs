//! Inputs and outputs named by identifiers (manual 10 and 27).

use technol_machine::config::{Input, Link, Number, Output, Value};
use technol_machine::{Conversion, ElementValue, MachineConfig, Signal};
use technol_runtime::RuntimeEvent;

use crate::coverage::with_mutants;
use crate::plc::Plc;

#[track_caller]
fn holds(plc: &Plc, values: &str) {
    assert_eq!(plc.differences(values), Vec::<String>::new());
    assert_eq!(plc.fault(), None);
}

fn set(plc: &mut Plc, id: &str, value: impl Into<ElementValue>) {
    plc.control().set_input(id, value).expect("an input");
}

fn port(name: &str) -> Signal {
    name.parse().expect("a signal")
}

#[test]
fn mapped_inputs_follow_their_elements_and_hold_their_default_without_one() {
    let init = "MAP_IN DOOR,'inDoor' / MAP_IN OIL,'Oil',1 / MAP_IN DRY,'Dry',0 / MAP_AIN AIR,'Air',6.5 / MAP_AIN TANK,'Tank'";
    let main = "LDR DOOR / WR O0 / LOD REAL.AIR / STO REAL.R1";
    let mut plc = Plc::with_init(init, main);
    holds(&plc, "DOOR=0 OIL=1 AIR=6.5 TANK=0.0");
    plc.run(1);
    holds(&plc, "DOOR=0 OIL=1 REAL.R1=6.5");
    // What comes from outside is there before MODULE_MAIN, in any spelling of the identifier.
    set(&mut plc, "INDOOR", true);
    set(&mut plc, "Air", 4.25);
    plc.set("OIL=0");
    plc.run(1);
    holds(&plc, "O0=1 REAL.R1=4.25 OIL=0 TANK=0.0");
    // A bound cell does not keep what the program writes; a start brings the default back where nothing is bound.
    plc.set("DOOR=0 DRY=1");
    plc.restart();
    holds(&plc, "DOOR=1 OIL=1 DRY=0 AIR=4.25");
}

#[test]
fn mapped_outputs_leave_after_the_modules() {
    let init = "MAP_OUT LAMP,'Lamp',1 / MAP_OUT DARK,'Dark',0 / MAP_AOUT BELT,'Belt',2.5";
    let mut plc =
        Plc::with_init(init, "LDR I0 / JL0 PAST / FL 0,LAMP / LOD CNST.7.5 / STO REAL.BELT / PAST:");
    assert_eq!(plc.control().output("Lamp"), None);
    plc.run(1);
    assert_eq!(plc.control().output("LAMP"), Some(&true.into()));
    assert_eq!(plc.control().output("Dark"), Some(&false.into()));
    assert_eq!(plc.control().output("PLC.Output.Belt"), Some(&2.5.into()));
    plc.set("I0=1");
    plc.run(1);
    assert_eq!(plc.control().output("Lamp"), Some(&false.into()));
    assert_eq!(plc.control().output("Belt"), Some(&7.5.into()));
    plc.control().set_input("Lamp", true).unwrap();
    plc.run(1);
    holds(&plc, "LAMP=0");
}

#[test]
fn several_bits_drive_one_port_and_the_port_is_inverted_last() {
    let init = "MAP_OUT LEFT,'Beacon' / MAP_OUT RIGHT,'beacon',0,FAST / MAP_IN KEY,'Key'";
    let modules = "MODULE_FAST / LDR I1 / WR RIGHT / MODULE_FAST_END";
    let mut plc = Plc::with_modules(init, "LDR I0 / WR LEFT", modules);
    plc.control().wire("Beacon", port("P0OUT.2"), true).unwrap();
    plc.control().wire("Key", port("P3IN.5"), true).unwrap();
    for (given, beacon) in [("IB=0", 4), ("IB=1", 0), ("IB=3", 0), ("IB=2", 0), ("IB=0", 4)] {
        plc.set(given);
        plc.run(2);
        assert_eq!((given, plc.ports()[0]), (given, beacon));
    }
    holds(&plc, "KEY=1");
    plc.input_ports()[2] = 0x20;
    plc.run(1);
    holds(&plc, "KEY=0");
}

#[test]
fn each_period_is_served_when_it_is_due() {
    let init = "DEF_IN A,'In',TYPE_INT_16 / DEF_IN B,'In',TYPE_INT_16,-,FAST / DEF_IN C,'In',TYPE_INT_16,-,FASTEST / \
                DEF_IN D,'In',TYPE_INT_16,-,ONDEMAND / \
                DEF_OUT OA,'Slow',TYPE_INT_16 / DEF_OUT OF,'Fast',TYPE_INT_16,-,FAST / \
                DEF_OUT OG,'Fastest',TYPE_INT_16,-,FASTEST / DEF_OUT OD,'Never',TYPE_INT_16,9,ONDEMAND";
    let modules = "MODULE_FASTEST / LOD WORD.C / STO WORD.OA / STO WORD.OF / STO WORD.OG / STO WORD.OD / \
                   MODULE_FASTEST_END";
    let mut plc = Plc::with_modules(init, "LDR I0 / JL0 PAST / UPDATE_IN D / PAST:", modules);
    plc.run(1);
    plc.tick(5);
    set(&mut plc, "In", 7_i64);
    plc.tick(1);
    holds(&plc, "A=0 B=7 C=7 D=0 OA=7");
    let sent =
        |plc: &mut Plc| ["Slow", "Fast", "Fastest", "Never"].map(|id| plc.control().output(id).cloned());
    let [zero, seven] = [0_i64, 7].map(|value| Some(ElementValue::from(value)));
    assert_eq!(sent(&mut plc), [zero, seven.clone(), seven.clone(), None]);
    plc.run(1);
    plc.tick(1);
    holds(&plc, "A=7 D=0");
    assert_eq!(sent(&mut plc)[0], seven);
    // On demand the program alone says when.
    plc.set("I0=1");
    plc.run(2);
    holds(&plc, "D=7");
}

#[test]
fn cells_have_the_type_that_is_declared() {
    let init = "DEF_IN FLAG,'Flag',TYPE_BIT,1 / DEF_IN SMALL,'N',TYPE_INT_8,-3 / DEF_IN UNS,'N',TYPE_UNS_8 / \
                DEF_IN WIDE,'N',TYPE_QWORD / DEF_IN GAP,'N',TYPE_REAL,1.5 / DEF_IN WHOLE,'X',TYPE_INT32 / \
                DEF_IN NAME[4],'Name',TYPE_STR / DEF_OUT TEXT[6],'Text',TYPE_STR / DEF_IN POS[3],'Pos',TYPE_INT_16,6";
    let main = "LOD POS[0] / STO W1 / LOD POS[2] / STO W2 / STRCPY TEXT,NAME / LOD BYTE.UNS / STO D1 / LOD WHOLE / STO D2";
    let mut plc = Plc::with_init(init, main);
    plc.run(1);
    holds(&plc, "FLAG=1 SMALL=-3 UNS=0 WIDE=0 GAP=1.5 W1=6 W2=6");
    assert_eq!(plc.control().output("Text"), Some(&b""[..].into()));
    set(&mut plc, "Flag", 0_i64);
    set(&mut plc, "N", 254_i64);
    set(&mut plc, "X", -2.5);
    set(&mut plc, "Name", &b"abcdef"[..]);
    set(&mut plc, "PLC.Input.Pos[2]", -8_i64);
    plc.run(1);
    // POS has no source but for its last element; the text is cut to four characters.
    holds(&plc, "FLAG=0 SMALL=-2 UNS=254 WIDE=254 GAP=254.0 D1=-2 D2=-2 W1=6 W2=-8");
    assert_eq!(plc.control().output("Text"), Some(&b"abcd"[..].into()));
}

#[test]
fn mapped_elements_of_a_millisecond() {
    let init = "STRCPY LONG,'Gap' / MAP_IN KEY,'Key',-,FAST / MAP_AIN GAP,LONG,-,FAST / STRCPY LONG,'Belt' / \
                MAP_AOUT BELT,LONG,-,FAST / STRCPY LONG,'Lamp' / MAP_OUT LAMP,LONG,-,FAST / MAP_AOUT REST,'Rest'";
    let mut plc = Plc::with_init(init, "");
    plc.run(1);
    let sent = |plc: &mut Plc| ["Belt", "Lamp", "Rest"].map(|id| plc.control().output(id).cloned());
    assert_eq!(sent(&mut plc), [Some(0.0.into()), Some(false.into()), Some(0.0.into())]);
    plc.tick(5);
    set(&mut plc, "Key", true);
    set(&mut plc, "Gap", 2.5);
    plc.set("BELT=7.5 LAMP=1 REST=1.5");
    plc.tick(1);
    holds(&plc, "KEY=1 GAP=2.5");
    assert_eq!(sent(&mut plc), [Some(7.5.into()), Some(true.into()), Some(0.0.into())]);
    plc.tick(20);
    assert_eq!(sent(&mut plc)[2], Some(1.5.into()));
}

#[test]
fn every_type_has_its_width_and_its_sign() {
    // The low bytes of 8899AABBCCDDEEFFh, without sign and with it.
    let widths: [(&[&str], &str, i128); 4] = [
        (&["UNS_8", "UNS8", "BYTE"], "0FFh", 0xFF),
        (&["UNS_16", "UNS16", "WORD"], "0EEFFh", 0xEEFF),
        (&["UNS_32", "UNS32", "DWORD"], "0CCDDEEFFh", 0xCCDD_EEFF),
        (&["UNS_64", "UNS64", "QWORD"], "8899AABBCCDDEEFFh", 0x8899_AABB_CCDD_EEFF),
    ];
    for ((unsigned, content, value), bits) in widths.into_iter().zip([8, 16, 32, 64]) {
        let signed = [format!("INT_{bits}"), format!("INT{bits}")].map(|name| (name, value - (1 << bits)));
        let types = unsigned.iter().map(|name| (name.to_string(), value)).chain(signed);
        for (name, sent) in types {
            with_mutants(|| {
                let init = format!(
                    "STRCPY LONG,'In' / DEF_IN GOT,LONG,TYPE_{name},-,SLOW / STRCPY LONG,'Out' / DEF_OUT SENT,LONG,TYPE_{name},-,SLOW"
                );
                let wide = if bits == 64 { "QWRD." } else { "" };
                let mut plc = Plc::with_init(
                    &init,
                    &format!("LOD QWRD.Q1 / STO {wide}SENT / LOD {wide}GOT / STO QWRD.Q2"),
                );
                set(&mut plc, "In", ElementValue::Int(0x8899_AABB_CCDD_EEFF));
                plc.set("QWRD.Q1=8899AABBCCDDEEFFh");
                plc.run(1);
                holds(&plc, &format!("GOT={content} QWRD.Q2={}", value - (1 << bits)));
                assert_eq!(plc.control().output("Out"), Some(&ElementValue::Int(sent)), "{name}");
            });
        }
    }
    let mut plc = Plc::with_init("DEF_OUT SENT,'Out',TYPE_REAL", "LOD CNST.-1.5 / STO REAL.SENT");
    plc.run(1);
    assert_eq!(plc.control().output("Out"), Some(&ElementValue::Real(-1.5)));
}

#[test]
fn blocks_keep_their_bytes() {
    let init = "DEF_IN GOT[4],'In',TYPE_BIN / DEF_OUT SENT[4],'Out',TYPE_BIN";
    let mut plc = Plc::with_init(init, "LOD GOT / STO SENT");
    set(&mut plc, "In", &[1, 0, 3, 4, 5][..]);
    plc.run(1);
    holds(&plc, "DWRD.GOT=04030001h");
    assert_eq!(plc.control().output("Out"), Some(&[1, 0, 3, 4][..].into()));
}

#[test]
fn links_carry_outputs_to_inputs() {
    let init = "DEF_OUT GATE,'Gate',TYPE_BIT,1 / DEF_IN SHUT,'Shut',TYPE_BIT / DEF_OUT SPEED[2],'Speed',TYPE_INT_16 / \
                DEF_IN RATE,'Rate',TYPE_REAL,0.5 / DEF_IN ASKED,'Asked',TYPE_INT_32,-,ONDEMAND / \
                DEF_OUT HELD,'Held',TYPE_INT_16,-3,ONDEMAND / DEF_IN OPEN,'Open',TYPE_BIT";
    let main = "LDR SHUT / WR O0 / LDR I0 / WR GATE / LOD W1 / STO SPEED[1] / LDR I1 / JL0 PAST / UPDATE_IN ASKED / PAST:";
    let mut plc = Plc::with_init(init, main);
    holds(&plc, "GATE=1 HELD=0FFFDh");
    let invert = Conversion { invert: true, ..Conversion::default() };
    let scaled = Conversion { scale: 0.25, offset: 1.0, ..Conversion::default() };
    let control = plc.control();
    control.connect("PLC.Output.Gate", "PLC.Input.Shut", invert).unwrap();
    control.connect("PLC.Output.Gate", "PLC.Input.Open", Conversion::default()).unwrap();
    control.connect("PLC.Output.Speed[1]", "PLC.Input.Rate", scaled).unwrap();
    control.connect("PLC.Output.Held", "PLC.Input.Asked", Conversion::default()).unwrap();
    plc.set("W1=-6 GATE=0");
    plc.run(1);
    // Links of 20 ms are served before the modules and after them.
    holds(&plc, "O0=1 SHUT=1 OPEN=0 RATE=-0.5 ASKED=0");
    plc.set("IB=3");
    plc.run(1);
    holds(&plc, "O0=1 SHUT=0 OPEN=1 ASKED=-3");
    plc.run(1);
    holds(&plc, "O0=0");
}

#[test]
fn update_in_fetches_one_element_or_all_and_leaves_the_registers() {
    let init = "DEF_IN POS[3],'Pos',TYPE_INT_32,-,ONDEMAND / DEF_OUT LAMP,'Lamp',TYPE_BIT / DEF_IN KEY,'Key',TYPE_BIT,-,ONDEMAND";
    let read = "LOD POS[0] / STO D1 / LOD POS[1] / STO D2 / LOD POS[2] / STO QWRD.Q1";
    for (fetch, expected) in [
        ("POS[1]", "D1=0 D2=2 QWRD.Q1=0"),
        ("POS", "D1=1 D2=2 QWRD.Q1=3"),
        ("LAMP", "D1=0 D2=0 QWRD.Q1=0"),
        ("KEY", "D1=0 D2=0 QWRD.Q1=0"),
    ] {
        let main = format!("LOD CNST.77 / LDR I0 / UPDATE_IN {fetch} / WR O0 / STO W1 / {read}");
        let mut plc = Plc::with_init(init, &main);
        for (id, value) in [("Pos", 1_i64), ("Pos[1]", 2), ("Pos[2]", 3)] {
            set(&mut plc, id, value);
        }
        // Any number but 0 is a bit.
        set(&mut plc, "Key", 2_i64);
        plc.set("I0=1");
        plc.run(1);
        holds(&plc, &format!("W1=77 O0=1 {expected} KEY={}", u8::from(fetch == "KEY")));
        assert_eq!(plc.control().output("Lamp"), Some(&false.into()));
    }
}

#[test]
fn an_identifier_may_be_in_a_text_buffer() {
    let init = "STRCPY LONG,'Door' / MAP_IN DOOR,LONG / STRCPY LONG,'' / MAP_IN NONE,LONG,1";
    let mut plc = Plc::with_init(init, "");
    set(&mut plc, "door", true);
    plc.run(1);
    holds(&plc, "DOOR=1 NONE=1");
}

#[test]
fn what_is_no_identifier_is_refused() {
    let mut plc = Plc::of("");
    for id in ["", " ", "PLC.Input.", "dveře"] {
        let refused = plc.control().set_input(id, true).unwrap_err();
        assert_eq!(refused.to_string(), "an identifier has 1 to 255 ASCII characters", "{id}");
    }
    let long = ElementValue::Bytes(vec![0; 65_537]);
    assert_eq!(
        plc.control().set_input("a", long).unwrap_err().to_string(),
        "a text or block has at most 65536 bytes"
    );
}

#[test]
fn links_of_1_ms_are_served_between_cyclicoperation_and_fast() {
    let init = "DEF_OUT SENT,'Sent',TYPE_INT_16,-,FAST / DEF_IN GOT,'Got',TYPE_INT_16,-,FAST";
    let modules = "MODULE_CYCLICOPERATION / LOD W1 / STO SENT / MODULE_CYCLICOPERATION_END / \
                   MODULE_FAST / LOD GOT / STO W2 / MODULE_FAST_END";
    let mut plc = Plc::with_modules(init, "", modules);
    plc.control().connect("Sent", "Got", Conversion::default()).unwrap();
    plc.set("W1=5");
    plc.tick(1);
    holds(&plc, "W2=5");
}

#[test]
fn a_machine_describes_elements() {
    let input = |id: &str, port: Option<&str>, value| Input {
        id: id.to_owned(),
        port: port.map(str::to_owned),
        invert: port.is_some(),
        value,
    };
    let machine = MachineConfig {
        input: vec![
            input("Door", Some("P2IN.1"), None),
            input("Gap", None, Some(Value::Real(Number(1.5)))),
            input("Name", None, Some(Value::Text("ab".to_owned()))),
        ],
        output: vec![Output { id: "Lamp".to_owned(), port: "P1OUT.3".to_owned(), invert: false }],
        link: vec![Link {
            source: "PLC.Output.Rate".to_owned(),
            destination: "PLC.Input.Half".to_owned(),
            invert: false,
            scale: Some(Number(0.5)),
            offset: None,
        }],
        ..MachineConfig::default()
    };
    let init = "MAP_IN DOOR,'Door' / MAP_AIN GAP,'Gap' / DEF_IN NAME[4],'Name',TYPE_STR / MAP_OUT LAMP,'Lamp' / \
                DEF_OUT RATE,'Rate',TYPE_INT_16 / DEF_IN HALF,'Half',TYPE_REAL";
    let mut plc = Plc::on_machine(
        Some(&machine),
        init,
        "LDR DOOR / WR LAMP / STRCMP NAME,'ab' / WR O0 / LOD CNST.7 / STO RATE",
        "",
    );
    plc.run(1);
    holds(&plc, "DOOR=1 GAP=1.5 O0=1 HALF=3.5");
    assert_eq!(plc.ports()[1], 8);
    plc.input_ports()[1] = 2;
    plc.run(1);
    holds(&plc, "DOOR=0");
    assert_eq!(plc.ports()[1], 0);
}

#[test]
fn a_mapped_bit_may_begin_a_message() {
    let mut plc = Plc::with_init("MAP_IN DOOR,'Door' / EDEF -,DOOR,FIVE,-,0001b", "");
    plc.run(2);
    set(&mut plc, "Door", true);
    let numbers = plc.events(1).into_iter().filter_map(|event| match event {
        RuntimeEvent::Message { number, .. } => Some(number),
        _ => None,
    });
    assert_eq!(numbers.collect::<Vec<_>>(), [5]);
}

#[test]
fn slow_elements_change_with_the_cycle_and_fast_ones_with_the_millisecond() {
    for (period, got, sent) in [(",-,SLOW", 0, 0), ("", 0, 0), (",-,FAST", 5, 7)] {
        let init = format!("DEF_IN GOT,'In',TYPE_INT_16{period} / DEF_OUT SENT,'Out',TYPE_INT_16{period}");
        let mut plc = Plc::with_modules(&init, "", "MODULE_FAST / LOD W1 / STO SENT / MODULE_FAST_END");
        plc.run(1);
        plc.tick(1);
        set(&mut plc, "In", 5_i64);
        plc.set("W1=7");
        plc.tick(1);
        holds(&plc, &format!("GOT={got} SENT=7"));
        assert_eq!(plc.control().output("Out"), Some(&ElementValue::Int(sent)), "{period}");
        plc.tick(20);
        holds(&plc, "GOT=5");
        assert_eq!(plc.control().output("Out"), Some(&7_i64.into()), "{period}");
    }
}
