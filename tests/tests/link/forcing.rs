//! What an editor forced is forced again when the link comes back, whatever became of it meanwhile.

use serde_json::{Value, json};
use technol_dap::client::{Client, Mark};
use technol_image::system::{IN_FORCE_HIGH, IN_PORTS, OUT_FORCE_LOW};
use technol_link_model::LineOptions;
use technol_wire::message::{Request, Response};

use crate::lathe::Lathe;
use crate::session::{editor, lathe_machine, launch};
use crate::world::{LIMITS, Shared};

fn byte(shared: &Shared, addr: u32) -> u8 {
    let world = shared.world();
    world.core.simulation().expect("a program").runtime().memory()[addr as usize]
}

fn says(editor: &mut Client, mark: Mark, text: &str) {
    let is_it = |b: &Value| b["output"].as_str().is_some_and(|t| t.contains(text));
    editor.event_where(mark, "output", is_it).unwrap_or_else(|e| panic!("{text}: {e}"));
}

#[test]
fn what_is_forced_outlives_a_cut_and_a_cold_start_behind_it() {
    let lathe = Lathe::copy();
    let shared = Shared::new(LineOptions::default(), lathe_machine(&lathe));
    let mut editor = editor(&shared);
    editor.start(launch(&lathe), &[]).expect("the program starts");
    for line in ["force K_CW 1", "force SP_CCW 0"] {
        editor.evaluate(line, "repl").unwrap_or_else(|e| panic!("{line}: {e}"));
    }
    shared.think(100_000);
    assert_eq!((byte(&shared, IN_FORCE_HIGH), byte(&shared, OUT_FORCE_LOW)), (1, 2));
    assert_eq!(byte(&shared, IN_PORTS) & 1, 1, "the program sees it");

    let mark = editor.mark();
    shared.world().cable.set_cut(true);
    says(&mut editor, mark, "the link to the target is lost");
    {
        // Somebody at the machine switches the PLC off and on.
        let mut world = shared.world();
        let start = Request::Start { cold: true, stop_on_entry: false };
        assert_eq!(world.core.answer(start, LIMITS), Response::Done);
        let until = world.now + 200_000;
        while world.now < until {
            world.run(until);
        }
    }
    assert_eq!((byte(&shared, IN_FORCE_HIGH), byte(&shared, IN_PORTS) & 1), (0, 0), "its memory is new");
    shared.world().cable.set_cut(false);
    says(&mut editor, mark, "the link to the target is back");
    shared.think(100_000);
    assert_eq!((byte(&shared, IN_FORCE_HIGH), byte(&shared, OUT_FORCE_LOW)), (1, 2));
    assert_eq!(byte(&shared, IN_PORTS) & 1, 1, "the program sees it again");

    let mark = editor.mark();
    editor.disconnect(json!({ "terminateDebuggee": false })).expect("the adapter lets go");
    says(&mut editor, mark, "not forced any more: P1IN.0 (K_CW), P0OUT.1 (SP_CCW)");
    assert_eq!((byte(&shared, IN_FORCE_HIGH), byte(&shared, OUT_FORCE_LOW)), (0, 0));
}
