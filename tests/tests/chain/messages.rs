//! Messages that the control reports by itself (manual 14.3).

use technol_runtime::RuntimeEvent;

use crate::coverage::with_mutants;
use crate::plc::Plc;

/// Number, supplementary number, shown, parameters of each message.
type Shown = (u32, Option<i64>, bool, [Option<i64>; 3]);

fn shown(events: &[RuntimeEvent]) -> Vec<Shown> {
    let message = |event: &RuntimeEvent| match *event {
        RuntimeEvent::Message { number, sub_id, set, parameters, .. } => {
            Some((number, sub_id, set, parameters))
        }
        _ => None,
    };
    events.iter().filter_map(message).collect()
}

#[test]
fn edges_begin_and_end_messages() {
    let mut plc =
        Plc::with_init("EDEF -,I0,FIVE,-,1001b / EDEF -,I1,6,7,0010b,D1 / EDEF OB,I2,8,-,0001b", "");
    plc.set("D1=44 IB=2");
    // A bit that is 1 at the start has no edge, a change of bits nobody watches no message.
    assert_eq!(shown(&plc.events(2)), []);
    plc.set("IB=3");
    assert_eq!(shown(&plc.events(1)), [(5, None, true, [None; 3])]);
    assert_eq!(shown(&plc.events(1)), []);
    plc.set("IB=0 D1=-9");
    let expected = [(5, None, false, [None; 3]), (6, Some(7), true, [Some(-9), None, None])];
    assert_eq!(shown(&plc.events(1)), expected);
    // The third looks at the bit of I2 in the byte of OB.
    plc.set("IB=4");
    assert_eq!(shown(&plc.events(1)), []);
    plc.set("OB=4");
    assert_eq!(shown(&plc.events(1)), [(8, None, true, [None; 3])]);
}

#[test]
fn every_pair_of_edges() {
    // Mode, message at the rising edge of I0, message at the falling one.
    let modes = [
        ("0000b", None, None),
        ("0001b", Some(true), None),
        ("0010b", None, Some(true)),
        ("0100b", Some(false), None),
        ("0110b", Some(false), Some(true)),
        ("1000b", None, Some(false)),
        ("1001b", Some(true), Some(false)),
    ];
    for (mode, rising, falling) in modes {
        let mut plc = Plc::with_init(&format!("EDEF -,I0,FIVE,-,{mode}"), "");
        plc.run(1);
        for (bit, expected) in [("I0=1", rising), ("I0=0", falling), ("I0=1", rising)] {
            plc.set(bit);
            let sets: Vec<bool> = shown(&plc.events(1)).into_iter().map(|(_, _, set, _)| set).collect();
            assert_eq!(sets, Vec::from_iter(expected), "{mode}, {bit}");
        }
    }
}

#[test]
fn one_edge_may_begin_and_end_a_message() {
    for (mode, expected) in [("0101b", [2, 0]), ("1010b", [0, 2])] {
        let mut plc = Plc::with_init(&format!("EDEF -,I0,FIVE,-,{mode}"), "");
        plc.run(1);
        for (bit, count) in ["I0=1", "I0=0"].into_iter().zip(expected) {
            plc.set(bit);
            let sets: Vec<bool> = shown(&plc.events(1)).into_iter().map(|(_, _, set, _)| set).collect();
            assert_eq!(sets, [true, false][..count], "{mode}, {bit}");
        }
    }
}

#[test]
fn operands_of_edef_are_taken_at_the_start_but_for_the_parameters() {
    let init = "LOD CNST.300 / STO W1 / LOD CNST.70000 / STO D1 / EDEF BYTE.AREA,I0,W1,D1,0001b,-,D2 / \
                EDEF -,I1,WORD.W1,DWRD.D1,0001b,DWRD.D2,-,DWRD.AREA / EDEF -,I2,CNST.7,CNST.-2,0001b,-,-,D2 / \
                EDEF B1,I3,8,-,0001b,-,DWRD.D2,-";
    let mut plc = Plc::with_init(init, "");
    plc.run(1);
    plc.set("W1=1 D1=2 D2=80044 IB=6 B1=8 DWRD.AREA=100001h");
    let expected = [
        (300, Some(70_000), true, [None, Some(80_044), None]),
        (300, Some(70_000), true, [Some(80_044), None, Some(0x10_0001)]),
        (7, Some(-2), true, [None, None, Some(80_044)]),
        (8, None, true, [None, Some(80_044), None]),
    ];
    assert_eq!(shown(&plc.events(1)), expected);
}

/// What these lines report in one cycle.
#[track_caller]
fn reports(given: &str, lines: &str, expected: &[Shown]) {
    with_mutants(|| {
        let mut plc = Plc::of(lines);
        plc.set(given);
        assert_eq!(shown(&plc.events(1)), expected, "{lines}");
    });
}

#[test]
fn messages_have_their_numbers_and_values() {
    let given = "W1=300 D1=70000 D2=-9 DWRD.AREA=100007h";
    let none = [None; 3];
    let messages: [(&str, Shown); 10] = [
        ("LOD CNST.44 / ESET", (44, None, true, none)),
        // The number is in 16 bits of DR.
        ("LOD DWRD.AREA / ESET", (7, None, true, none)),
        ("ESET CNST.7", (7, None, true, none)),
        ("ESET W1,D1,-,D2,D1", (300, Some(70_000), true, [Some(-9), Some(70_000), None])),
        (
            "ESET WORD.AREA,DWRD.D1,0,DWRD.D2,CNST.-3,DWRD.AREA",
            (7, Some(70_000), false, [Some(-9), Some(-3), Some(0x10_0007)]),
        ),
        (
            "LOD CNST.9 / ESET -,CNST.2,-,CNST.1,DWRD.D1,CNST.6",
            (9, Some(2), true, [Some(1), Some(70_000), Some(6)]),
        ),
        ("ESET FIVE,-,1,-,-,D2", (5, None, true, [None, None, Some(-9)])),
        ("ESET FIVE,-,-,D1,-,-", (5, None, true, [Some(70_000), None, None])),
        ("ESET 12,-,-,3,-", (12, None, true, [Some(3), None, None])),
        ("ESET 12,3,0,-,-,-", (12, Some(3), false, none)),
    ];
    for (lines, expected) in messages {
        reports(given, lines, &[expected]);
        let conditional = lines.replace("ESET", "LDR I0 / ESET1");
        reports(given, &conditional, &[]);
        reports(&format!("{given} I0=1"), &conditional, &[expected]);
    }
}

#[test]
fn a_message_calls_the_procedure_and_the_registers_stay() {
    let lines = "PROC_BEGIN _ON_ESET / STO D1 / LOD W1 / INR / STO W1 / LDR I1 / WR O1 / PROC_END _ON_ESET / \
                 LOD CNST.33 / LDR -I0 / ESET 70 / STO D2 / WR O0 / LDR I0 / ESET1 71";
    let mut plc = Plc::of(lines);
    plc.run(1);
    assert_eq!(plc.differences("D1=70 W1=1 D2=33 O0=1"), [""; 0]);
    plc.set("I0=1");
    plc.run(1);
    assert_eq!(plc.differences("D1=71 W1=3 D2=33 O0=0"), [""; 0]);
}

#[test]
fn a_start_forgets_the_bindings_of_the_last_run() {
    let mut plc = Plc::with_init("EDEF -,I0,FIVE,-,0001b", "");
    plc.run(1);
    plc.restart();
    plc.run(1);
    plc.set("IB=1");
    assert_eq!(shown(&plc.events(1)).len(), 1);
}
