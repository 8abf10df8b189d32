//! A session over a cable that damages bits and is cut, in real time: adapter, cable and target are processes.

use std::time::Duration;

use serde_json::json;
use technol_dap::client::Mark;

use crate::child::{Adapter, Site};
use crate::lathe::Lathe;
use crate::patient::{ask, step};

/// One bit in ten thousand, and a second without a cable after each six.
const ERRORS: f64 = 1e-4;
const BETWEEN_CUTS: u32 = 6;
/// Executed in each cycle.
const PLACE: &str = "WR   ESTOP_SEEN";

#[test]
fn a_session_in_real_time_gets_through_noise_and_cuts() {
    let lathe = Lathe::copy();
    let site = Site::noisy(&lathe, ERRORS, BETWEEN_CUTS);
    let mut adapter = Adapter::start();
    let editor = &mut adapter.client;
    let mut launch = site.launch(&lathe);
    launch["onLinkLost"] = json!("stayStopped");
    launch["reconnect"] = json!(60);
    let (main, place) = (lathe.path("main.plc"), lathe.line("main.plc", PLACE));
    editor.start(launch, &[(&main, &[place])]).expect("the program is downloaded and starts");
    let stopped = editor.event(Mark::START, "stopped").expect("the break-point");
    assert_eq!(stopped["reason"], "breakpoint");
    let mut thread = stopped["threadId"].as_i64().expect("a thread");
    let watches = json!({ "period": 100, "watches": [{ "expression": "CYCLES" }] });
    ask(editor, "technol/subscribe", &watches);

    // Long enough for two cuts.
    for n in 0..120 {
        thread = step(editor, thread);
        std::thread::sleep(Duration::from_millis(120));
        if n % 10 == 0 {
            // What was set is what is there, however often it was sent.
            ask(editor, "setExpression", &json!({ "expression": "BX", "value": (n + 7).to_string() }));
            let shown = ask(editor, "evaluate", &json!({ "expression": "BX", "context": "watch" }));
            let shown = shown["result"].as_str().expect("a value").to_owned();
            assert!(shown.starts_with(&format!("{} (", n + 7)), "{shown} at {n}");
        }
    }
    let mark = editor.mark();
    ask(editor, "continue", &json!({ "threadId": thread }));
    let again = editor.event_where(mark, "stopped", |b| b["reason"] == "breakpoint");
    again.expect("the break-point is still there");
    let said =
        editor.timeline().iter().any(|e| e["body"]["output"].as_str().is_some_and(|t| t.contains("is back")));
    assert!(said, "it was really cut");
}
