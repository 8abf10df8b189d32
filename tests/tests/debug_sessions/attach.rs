//! Attaching to a program that runs already.

use std::time::Duration;

use serde_json::{Value, json};
use technol_dap::client::{Client, Mark};

use crate::binary::technol;
use crate::child::{Adapter, PATIENCE, Process, Site};
use crate::lathe::Lathe;

/// Starts the lathe on the target and leaves it running.
fn leave_running(site: &Site, lathe: &Lathe) {
    let mut adapter = Adapter::start();
    adapter.client.start(site.launch(lathe), &[]).expect("the program starts");
    adapter.client.disconnect(json!({ "terminateDebuggee": false })).expect("the adapter lets go");
    assert_eq!(adapter.exit_code(), Some(0));
}

fn attached(site: &Site, lathe: &Lathe) -> Adapter {
    let mut adapter = Adapter::initialized();
    let client = &mut adapter.client;
    client.request("attach", json!({ "program": lathe.folder(), "target": site.address })).expect("attach");
    client.event(Mark::START, "initialized").expect("initialized");
    client.request("configurationDone", Value::Null).expect("configurationDone");
    adapter
}

fn cycles(client: &mut Client) -> u64 {
    let text = client.evaluate("CYCLES", "watch").expect("a value of a running program");
    text.split(' ').next().and_then(|n| n.parse().ok()).unwrap_or_else(|| panic!("a number: {text}"))
}

#[test]
fn attach_finds_the_program_running_and_leaves_it_running() {
    let lathe = Lathe::copy();
    let site = Site::tcp(&lathe);
    leave_running(&site, &lathe);

    let mut adapter = attached(&site, &lathe);
    let client = &mut adapter.client;
    let first = cycles(client);
    while cycles(client) == first {
        std::thread::sleep(Duration::from_millis(5));
    }
    let said = |client: &Client, what: &str| client.timeline().iter().any(|m| m.to_string().contains(what));
    assert!(!said(client, "downloaded"), "the target has the program already");

    let line = lathe.line("panel.plc", "TIM  -,50");
    let mark = client.mark();
    client.set_breakpoints(&lathe.path("panel.plc"), &[line]).expect("placed");
    let stop = client.event(mark, "stopped").expect("a stop");
    assert_eq!(stop["reason"], "breakpoint");
    let held = cycles(client);
    client.disconnect(json!({})).expect("the adapter lets go");
    assert_eq!(adapter.exit_code(), Some(0));

    // Its break-points went with the debugger, and the program went on.
    let mut adapter = attached(&site, &lathe);
    let now = cycles(&mut adapter.client);
    assert!(now > held, "{now} cycles, {held} when it was held");
}

#[test]
fn attach_refuses_sources_that_the_program_was_not_built_from() {
    let lathe = Lathe::copy();
    let site = Site::tcp(&lathe);
    leave_running(&site, &lathe);
    lathe.edit("include/lathe.inc", "EQUI T_DEAD,15", "EQUI T_DEAD,16");

    let attach = json!({ "program": lathe.folder(), "target": site.address });
    let mut adapter = Adapter::initialized();
    let why = adapter.refusal("attach", attach.clone());
    assert!(why.contains("another program") && why.contains("`lathe`"), "{why}");
    assert!(why.contains("download") && why.contains("sources"), "the remedy: {why}");

    // The same session may try again, after the sources are as they were.
    lathe.edit("include/lathe.inc", "EQUI T_DEAD,16", "EQUI T_DEAD,15");
    adapter.client.request("attach", attach).expect("the hashes are equal");
}

#[test]
fn attach_refuses_a_target_without_a_program() {
    let lathe = Lathe::copy();
    let site = Site::tcp(&lathe);
    let mut adapter = Adapter::initialized();
    let why = adapter.refusal("attach", json!({ "program": lathe.folder(), "target": site.address }));
    assert!(why.contains("none") && why.contains("launch"), "{why}");
}

#[test]
fn launch_with_download_never_refuses_another_program() {
    let lathe = Lathe::copy();
    let site = Site::tcp(&lathe);
    let mut launch = site.launch(&lathe);
    launch["download"] = json!("never");
    let mut adapter = Adapter::initialized();
    let why = adapter.refusal("launch", launch);
    assert!(why.contains("another program") && why.contains("download"), "{why}");
}

#[test]
fn a_target_serves_one_debugger_after_another_but_not_two_at_once() {
    let lathe = Lathe::copy();
    let site = Site::tcp(&lathe);
    let mut first = Adapter::start();
    first.client.start(site.launch(&lathe), &[]).expect("the program starts");
    let mut second = Adapter::initialized();
    let why = second.refusal("attach", json!({ "program": lathe.folder(), "target": site.address }));
    assert!(why.contains("no other debugger"), "{why}");
    assert!(cycles(&mut first.client) < u64::MAX, "the first session goes on");
    first.client.disconnect(json!({ "terminateDebuggee": false })).expect("the adapter lets go");
    second
        .client
        .request("attach", json!({ "program": lathe.folder(), "target": site.address }))
        .expect("the target is free");
}

#[test]
fn the_adapter_serves_editors_over_tcp() {
    let lathe = Lathe::copy();
    let mut adapter = Process::start(technol(), &["dap", "--listen", "tcp:127.0.0.1:0"]);
    let address = adapter.address();
    let address = address.strip_prefix("tcp:").expect("a TCP address");
    let line = lathe.line("spindle.plc", "TIM  CNT_DEAD,T_DEAD");
    for _ in 0..2 {
        let mut client = Client::connect(address).expect("the adapter listens");
        client.set_patience(PATIENCE);
        let launch = Site::embedded().launch(&lathe);
        client.start(launch, &[(&lathe.path("spindle.plc"), &[line])]).expect("the program starts");
        let stop = client.event(Mark::START, "stopped").expect("a stop");
        assert_eq!(stop["reason"], "breakpoint");
        client.disconnect(json!({ "terminateDebuggee": true })).expect("the connection closes");
        assert!(adapter.is_running(), "it waits for the next editor");
    }
}
