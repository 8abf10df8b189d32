//! Ports that are forced: the program sees it, the machine feels it, a restart keeps it and the end of the session ends it.

use serde_json::{Value, json};
use technol_dap::client::{Client, Mark};

use crate::child::{Adapter, Site};
use crate::lathe::Lathe;

/// Executed in each cycle, behind the copies of the inputs.
const PLACE: &str = "WR   ESTOP_SEEN";

fn value(client: &mut Client, expression: &str) -> String {
    client.evaluate(expression, "watch").unwrap_or_else(|e| panic!("{expression}: {e}"))
}

fn order(client: &mut Client, line: &str) -> String {
    client.evaluate(line, "repl").unwrap_or_else(|e| panic!("{line}: {e}"))
}

fn says(client: &mut Client, mark: Mark, text: &str) {
    let is_it = |b: &Value| b["output"].as_str().is_some_and(|t| t.contains(text));
    client.event_where(mark, "output", is_it).unwrap_or_else(|e| panic!("{text}: {e}"));
}

#[test]
fn the_program_sees_what_is_forced_from_its_first_cycle_on() {
    let lathe = Lathe::copy();
    for site in [Site::embedded(), Site::tcp(&lathe)] {
        let mut adapter = Adapter::start();
        let client = &mut adapter.client;
        let place = lathe.line("main.plc", PLACE);
        client
            .start(site.launch(&lathe), &[(&lathe.path("main.plc"), &[place])])
            .expect("the program starts");
        client.event(Mark::START, "stopped").expect("the break-point");
        assert_eq!(value(client, "K_CW"), "false");
        assert_eq!(order(client, "force K_CW 1"), "P1IN.0 (K_CW) is forced to 1");
        assert_eq!(value(client, "P1IN.0"), "false (forced to 1)", "the program has not looked yet");
        client.go("continue", 1).expect("the next cycle");
        assert_eq!([value(client, "K_CW"), value(client, "P1IN.0")], ["true (forced)"; 2]);

        let mark = client.mark();
        client.request("restart", Value::Null).expect("a restart");
        let stop = client.event(mark, "stopped").expect("the break-point");
        assert_eq!(stop["reason"], "breakpoint", "the stop before the first statement is not shown");
        assert_eq!(value(client, "CYCLES").split(' ').next(), Some("1"), "it is the first cycle");
        assert_eq!(value(client, "K_CW"), "true (forced)");
        says(client, mark, "1 bit is forced; `forced` lists them");

        order(client, "unforce K_CW");
        client.go("continue", 1).expect("the next cycle");
        assert_eq!([value(client, "K_CW"), value(client, "P1IN.0")], ["false", "false"]);
    }
}

#[test]
fn the_machine_feels_what_is_forced_until_the_session_ends() {
    let lathe = Lathe::copy();
    let site = Site::tcp(&lathe);
    let mut adapter = Adapter::start();
    let client = &mut adapter.client;
    let place = lathe.line("main.plc", PLACE);
    let main = lathe.path("main.plc");
    client.start(site.launch(&lathe), &[(&main, &[place])]).expect("the program starts");
    client.event(Mark::START, "stopped").expect("the break-point");
    order(client, "force SP_CW 1");
    // The contactor takes 120 ms, that is six cycles, and two for the ports.
    for _ in 0..8 {
        client.go("continue", 1).expect("the next cycle");
    }
    assert_eq!([value(client, "SP_CW"), value(client, "P0OUT.0")], ["false (forced to 1)"; 2]);
    assert_eq!(value(client, "K_CW"), "true", "the contactor is on");
    client.set_breakpoints(&main, &[]).expect("none");
    let mark = client.mark();
    client.disconnect(json!({ "terminateDebuggee": false })).expect("the adapter lets go");
    says(client, mark, "not forced any more: P0OUT.0 (SP_CW)");
    assert_eq!(adapter.exit_code(), Some(0));

    let mut adapter = Adapter::initialized();
    let client = &mut adapter.client;
    client.request("attach", json!({ "program": lathe.folder(), "target": site.address })).expect("attach");
    client.event(Mark::START, "initialized").expect("initialized");
    client.request("configurationDone", Value::Null).expect("configurationDone");
    assert_eq!(order(client, "forced"), "nothing is forced");
}
