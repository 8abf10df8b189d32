//! Messages that the control reports by itself (manual 14.3).

use technol_runtime::RuntimeEvent;

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
fn a_start_forgets_the_bindings_of_the_last_run() {
    let mut plc = Plc::with_init("EDEF -,I0,FIVE,-,0001b", "");
    plc.run(1);
    plc.restart();
    plc.run(1);
    plc.set("IB=1");
    assert_eq!(shown(&plc.events(1)).len(), 1);
}
