use super::*;
use crate::connection::{Clock, TargetSpec};
use crate::project::{BuildFailure, Problem};
use crate::session::COMMANDS;
use std::time::{Duration, Instant};
use technol_wire::message::{Event, PlcState, Request};

/// Names of events and answered requests, in order.
fn story(client: &Client) -> Vec<String> {
    let name = |m: &Value| {
        let word = if m["type"] == "event" { &m["event"] } else { &m["command"] };
        format!("{}{}", if m["type"] == "event" { "* " } else { "" }, word.as_str().unwrap_or_default())
    };
    client.timeline().iter().filter(|m| m["event"] != "output").map(name).collect()
}

#[test]
fn capabilities_agree_with_the_handlers() {
    let mut setup = Setup::new();
    let capabilities = setup.client.initialize().unwrap();
    let offers = |field: &str| capabilities.get(field).is_some_and(|v| *v != false);
    for command in COMMANDS.iter().filter_map(|c| c.capability) {
        assert!(offers(command), "{command} is handled but not offered");
    }
    // What is offered and is no request of its own.
    let behaviours =
        ["supportsEvaluateForHovers", "supportsValueFormattingOptions", "supportTerminateDebuggee"];
    for field in capabilities.as_object().unwrap().keys() {
        let handled = COMMANDS.iter().any(|c| c.capability == Some(field.as_str()));
        assert!(handled || behaviours.contains(&field.as_str()), "{field} is offered but not handled");
    }
    assert_eq!(capabilities["exceptionBreakpointFilters"][0]["filter"], "fault");
}

#[test]
fn a_launch_builds_downloads_and_starts() {
    let mut setup = Setup::new();
    let arguments = setup.launch_arguments();
    setup.client.start(arguments, &[]).unwrap();
    setup.client.event(Mark::START, "thread").unwrap();
    let mut story = story(&setup.client);
    story.retain(|s| s != "* progressUpdate"); // as many as the time allows
    assert_eq!(
        story,
        [
            "initialize",
            "* progressStart",
            "* progressEnd",
            "launch",
            "* initialized",
            "configurationDone",
            "* process",
            "* thread"
        ]
    );
    assert_eq!(
        *setup.mock.asked.lock().unwrap(),
        [TargetSpec::Embedded {
            project: setup.folder.path().to_owned(),
            machine: Some(setup.folder.path().join("machine.toml")),
            clock: Clock::Real
        }]
    );
    let order: Vec<String> = setup
        .mock
        .asked_for(|r| !matches!(r, Request::Hello { .. } | Request::Status))
        .iter()
        .map(|r| format!("{r:?}").split([' ', '{', '(']).next().unwrap().to_owned())
        .collect();
    assert_eq!(order, ["Download", "Commit", "SetBreakpoints", "Start"]);
}

#[test]
fn a_program_that_is_there_is_not_downloaded_again() {
    for (download, times) in [("ifStale", 0), ("always", 1), ("never", 0)] {
        let mut setup = Setup::with(Mock::new().running(), |_| {});
        let mut arguments = setup.launch_arguments();
        arguments["download"] = json!(download);
        setup.client.start(arguments, &[]).unwrap();
        assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Commit)).len(), times, "{download}");
        // What runs is ended before it is started from power-on.
        assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Stop)).len(), 1 - times, "{download}");
        assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Start { cold: true, .. })).len(), 1);
    }
}

#[test]
fn the_target_of_the_configuration_wins_over_that_of_the_manifest() {
    let address = |text: &str| TargetSpec::Address { address: text.into(), token_file: None };
    for (asked, manifest, expected) in [
        (Some("tcp:plc:5000"), None, address("tcp:plc:5000")),
        (Some("tcp:plc:5000"), Some("serial:/dev/ttyS0@9600"), address("tcp:plc:5000")),
        (None, Some("serial:/dev/ttyS0@9600"), address("serial:/dev/ttyS0@9600")),
    ] {
        let mut setup = Setup::with(Mock::new(), |b| b.target = manifest.map(str::to_owned));
        let mut arguments = setup.launch_arguments();
        if let Some(asked) = asked {
            arguments["target"] = json!(asked);
        }
        setup.client.start(arguments, &[]).unwrap();
        assert_eq!(*setup.mock.asked.lock().unwrap(), [expected]);
    }
}

#[test]
fn a_failed_build_lists_its_errors() {
    let problem = |line| Problem {
        file: "/p/spindle.plc".into(),
        line,
        column: 3,
        code: "T0201".into(),
        message: "unknown name `KSMQ`".into(),
    };
    let failure = BuildFailure::Errors((1..=5).map(problem).collect());
    let mut setup = Setup::with(Mock::new(), |b| b.failure = Some(failure));
    setup.client.initialize().unwrap();
    let arguments = setup.launch_arguments();
    let message = setup.refusal("launch", arguments.clone());
    assert!(
        message.starts_with("the build failed with 5 errors: spindle.plc:1: unknown name `KSMQ` [T0201]"),
        "{message}"
    );
    let output = setup.client.event_where(Mark::START, "output", |b| b["line"] == 5).unwrap();
    assert_eq!(output["output"], "/p/spindle.plc:5:3: error [T0201]: unknown name `KSMQ`\n");
    assert_eq!(output["source"]["path"], "/p/spindle.plc");
    // The session can be used again.
    assert!(setup.refusal("launch", arguments).starts_with("the build failed"));
}

#[test]
fn a_target_that_is_not_there_is_told_as_the_connector_told_it() {
    let reason =
        "nothing listens at tcp:plc:5000: connection refused; start `technol target --listen tcp:plc:5000`";
    let mut setup = Setup::with(Mock::absent(reason), |_| {});
    setup.client.initialize().unwrap();
    let arguments = setup.launch_arguments();
    assert_eq!(setup.refusal("launch", arguments), reason);
}

#[test]
fn another_protocol_version_is_refused() {
    let mut setup = Setup::new();
    setup.mock.state().version = 7;
    setup.client.initialize().unwrap();
    let arguments = setup.launch_arguments();
    assert_eq!(
        setup.refusal("launch", arguments),
        "the target speaks protocol 7, this adapter 1; update the older one"
    );
}

#[test]
fn attaching_to_another_program_tells_the_remedy() {
    let mut setup = Setup::with(Mock::new().running(), |_| {});
    setup.mock.state().status.program = Some([7; 16]);
    setup.client.initialize().unwrap();
    let arguments = json!({ "program": setup.folder.path(), "target": "tcp:plc:5000" });
    assert_eq!(
        setup.refusal("attach", arguments),
        "the target runs another program than `sample`; launch with `download: \"ifStale\"` to replace it, \
         or open the sources it was built from"
    );
    let arguments = json!({ "program": setup.folder.path() });
    assert!(setup.refusal("attach", arguments).contains("nothing to attach to"));
}

#[test]
fn attaching_starts_nothing_and_leaving_stops_nothing() {
    let mut setup = Setup::with(Mock::new().running(), |_| {});
    setup.client.initialize().unwrap();
    setup
        .client
        .request("attach", json!({ "program": setup.folder.path(), "target": "tcp:plc:5000" }))
        .unwrap();
    setup.client.event(Mark::START, "initialized").unwrap();
    setup.client.request("configurationDone", Value::Null).unwrap();
    let process = setup.client.event(Mark::START, "process").unwrap();
    assert_eq!(process, json!({ "name": "sample", "startMethod": "attach" }));
    setup.client.disconnect(Value::Null).unwrap();
    assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Start { .. } | Request::Stop)), []);
    assert_eq!(
        setup.mock.asked_for(|r| matches!(r, Request::Goodbye { .. })),
        [Request::Goodbye { stop: false }]
    );
}

#[test]
fn attaching_to_a_held_program_shows_where_it_is_held() {
    let mut setup = Setup::with(Mock::new().running(), |_| {});
    setup.mock.state().status.held = true;
    setup.client.initialize().unwrap();
    setup
        .client
        .request("attach", json!({ "program": setup.folder.path(), "target": "tcp:plc:5000" }))
        .unwrap();
    setup.client.request("configurationDone", Value::Null).unwrap();
    let stopped = setup.client.event(Mark::START, "stopped").unwrap();
    assert_eq!((&stopped["reason"], &stopped["threadId"]), (&json!("pause"), &json!(2)));
    assert_eq!(setup.client.top_frame(2).unwrap()["line"], 21);
}

#[test]
fn disconnecting_ends_what_was_launched_unless_told_otherwise() {
    for (arguments, stop) in [
        (Value::Null, true),
        (json!({ "terminateDebuggee": true }), true),
        (json!({ "terminateDebuggee": false }), false),
    ] {
        let mut setup = Setup::launched(vec![]);
        setup.client.disconnect(arguments).unwrap();
        assert_eq!(
            setup.mock.asked_for(|r| matches!(r, Request::Goodbye { .. })),
            [Request::Goodbye { stop }]
        );
    }
}

#[test]
fn a_client_that_vanishes_ends_what_it_launched() {
    let mut setup = Setup::launched(vec![]);
    let mock = setup.mock.clone();
    // The old client goes away when another one takes its place.
    setup.client = Client::new(std::io::empty(), std::io::sink());
    let deadline = Instant::now() + Duration::from_secs(5);
    while mock.asked_for(|r| *r == Request::Goodbye { stop: true }).is_empty() {
        assert!(Instant::now() < deadline, "no goodbye");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn terminating_runs_the_plc_to_its_end() {
    let mut setup = Setup::stopped();
    setup.client.request("terminate", Value::Null).unwrap();
    let exited = setup.client.event(Mark::START, "exited").unwrap();
    assert_eq!(exited, json!({ "exitCode": 0 }));
    setup.client.event(Mark::START, "terminated").unwrap();
    let order = setup.mock.asked_for(|r| matches!(r, Request::Resume(_) | Request::Stop));
    assert!(matches!(order[..], [Request::Resume(_), Request::Stop]), "{order:?}");
    setup.client.disconnect(Value::Null).unwrap();
}

#[test]
fn a_plc_that_does_not_end_is_cut_off() {
    let mut setup = Setup::launched(vec![]);
    setup.mock.state().never_stops = true;
    setup.client.request("terminate", Value::Null).unwrap();
    setup.client.event(Mark::START, "terminated").unwrap();
    assert_eq!(
        setup.mock.asked_for(|r| matches!(r, Request::Goodbye { .. })),
        [Request::Goodbye { stop: true }]
    );
}

#[test]
fn a_restart_keeps_session_and_breakpoints() {
    let mut setup = Setup::stopped();
    let path = setup.path("main.plc");
    setup.client.set_breakpoints(&path, &[19]).unwrap();
    setup.mock.will_stop(stop_in_spindle(StopReason::Breakpoint, 19));
    // The stop at the end of `restart` must not be mistaken for the one before.
    setup.mock.state().status.held = false;
    let mark = setup.client.mark();
    setup.client.request("restart", Value::Null).unwrap();
    let stopped = setup.client.event(mark, "stopped").unwrap();
    assert_eq!(stopped["hitBreakpointIds"], json!([1]));
    assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Start { cold: true, .. })).len(), 2);
    assert_eq!(
        setup.mock.asked_for(|r| matches!(r, Request::Commit)).len(),
        1,
        "nothing changed, nothing downloaded"
    );
}

#[test]
fn a_lost_link_ends_the_session() {
    let mut setup = Setup::launched(vec![]);
    setup.mock.state().cut = true;
    let mark = Mark::START;
    let output = setup.client.event_where(mark, "output", |b| b["category"] == "important").unwrap();
    assert!(output["output"].as_str().unwrap().starts_with("the link to the target is lost: "), "{output}");
    setup.client.event(mark, "terminated").unwrap();
    assert!(
        setup.refusal("evaluate", json!({ "expression": "KSMP" })).contains("after the session has ended")
    );
    setup.client.disconnect(Value::Null).unwrap();
}

#[test]
fn a_disconnect_gets_through_while_a_build_takes_long() {
    let mut setup = Setup::with(Mock::new(), |b| b.delay = Duration::from_secs(20));
    setup.client.initialize().unwrap();
    let arguments = setup.launch_arguments();
    let launch = setup.client.send("launch", arguments).unwrap();
    let started = Instant::now();
    setup.client.disconnect(Value::Null).unwrap();
    assert!(started.elapsed() < Duration::from_secs(5));
    assert!(
        matches!(setup.client.response(launch), Err(ClientError::Refused { message, .. }) if message == "cancelled")
    );
}

#[test]
fn states_of_the_plc_are_told() {
    let mut setup = Setup::launched(vec![]);
    let mut status = setup.mock.state().status;
    status.plc = PlcState::Halted;
    setup.mock.say(Event::State(status));
    let is_halt = |b: &Value| b["output"] == "PLC halted, cycle 100\n";
    setup.client.event_where(Mark::START, "output", is_halt).unwrap();
}
