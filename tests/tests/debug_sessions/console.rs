//! The debug console: the simulated machine and the mechanisms by hand, on every kind of target.

use serde_json::json;
use technol_dap::client::Mark;

use crate::child::{Adapter, Site, refusal};
use crate::lathe::Lathe;

#[test]
fn a_fault_of_the_machine_is_switched_from_the_console() {
    let lathe = Lathe::copy();
    for site in [Site::embedded(), Site::tcp(&lathe)] {
        let mut adapter = Adapter::start();
        let client = &mut adapter.client;
        // The message of the shared error handler, when a contactor does not answer.
        let error = lathe.line("spindle.plc", "SP_ERROR:") + 1;
        let mut launch = site.launch(&lathe);
        launch["stopOnEntry"] = json!(true);
        client.start(launch, &[(&lathe.path("spindle.plc"), &[error])]).expect("the program starts");
        client.event(Mark::START, "stopped").expect("a stop");
        client.evaluate("fault ccw-contactor-dead on", "repl").expect("a fault of the lathe");
        let stop = client.go("continue", 1).expect("a stop");
        assert_eq!(stop["reason"], "breakpoint");
        assert_eq!(client.evaluate("DR16", "watch").expect("a value"), "403 (0193h)");
        let thread = stop["threadId"].as_i64().expect("a thread");
        assert_eq!(client.top_frame(thread).expect("a frame")["name"], "SP_CONTROL");

        let why = refusal(client, "evaluate", json!({ "expression": "fault nothing on", "context": "repl" }));
        assert!(why.contains("nothing") && why.contains("turret-jammed"), "{why}");
        let why = refusal(client, "evaluate", json!({ "expression": "press any-key", "context": "repl" }));
        assert!(why.contains("any-key") && why.contains("emergency-stop"), "{why}");
    }
}

#[test]
fn mechanisms_are_started_and_put_into_rest() {
    let lathe = Lathe::copy();
    let mut adapter = Adapter::start();
    let client = &mut adapter.client;
    let first = lathe.line("chuck.plc", "MECH_BEGIN CHUCK_OPEN") + 1;
    let mut launch = Site::embedded().launch(&lathe);
    launch["stopOnEntry"] = json!(true);
    client.start(launch, &[(&lathe.path("chuck.plc"), &[first])]).expect("the program starts");
    client.event(Mark::START, "stopped").expect("a stop");
    // MODULE_INIT puts no chuck into rest.
    client.evaluate("start CHUCK_OPEN", "repl").expect("a mechanism");
    let stop = client.go("continue", 1).expect("a stop");
    let thread = stop["threadId"].as_i64().expect("a thread");
    let frame = client.top_frame(thread).expect("a frame");
    assert_eq!([&frame["name"], &frame["line"]], [&json!("CHUCK_OPEN"), &json!(first)]);
    client.evaluate("stop CHUCK_OPEN", "repl").expect("a mechanism");
    assert_eq!(client.evaluate("CHUCK_OPEN", "watch").expect("a state"), "at rest");
    let why = refusal(client, "evaluate", json!({ "expression": "start BLOCKS", "context": "repl" }));
    assert!(why.contains("BLOCKS"), "{why}");
    let help = client.evaluate("help", "repl").expect("the list");
    for command in ["fault", "press", "release", "start", "stop", "help"] {
        assert!(help.contains(command), "{command}: {help}");
    }
}
