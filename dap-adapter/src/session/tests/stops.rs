use super::*;
use crate::mock::stop;
use technol_wire::message::{Event, Fault, FaultKind, Request, Resume};

fn fault() -> Fault {
    Fault { kind: FaultKind::DivisionByZero, pc: sample::pc(23), module: 3, sequence: Some(0), cycle: 77 }
}

#[test]
fn a_stop_belongs_to_the_thread_of_its_mechanism() {
    let mut setup = Setup::stopped();
    let stopped = setup.client.event(Mark::START, "stopped").unwrap();
    assert_eq!(
        stopped,
        json!({
            "reason": "breakpoint", "threadId": 2, "allThreadsStopped": true,
            "description": "break-point, cycle 123",
        })
    );
    // The thread is announced before it stops.
    let names: Vec<&Value> = setup
        .client
        .timeline()
        .iter()
        .filter(|m| m["event"] == "thread" || m["event"] == "stopped")
        .collect();
    let ids: Vec<&Value> = names.iter().map(|m| &m["body"]["threadId"]).collect();
    assert_eq!(ids, [&json!(1), &json!(2), &json!(2)]);
    assert_eq!(names[2]["event"], "stopped");
}

#[test]
fn active_mechanisms_are_threads_with_their_state() {
    let mut setup = Setup::stopped();
    let threads = setup.client.request("threads", Value::Null).unwrap();
    assert_eq!(
        threads["threads"],
        json!([
            { "id": 1, "name": "PLC cycle" },
            { "id": 2, "name": "SPINDLE · line 21 EX0 LDR KSMP (1.2 s)" },
        ])
    );
    setup.client.request("threads", Value::Null).unwrap();
    assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Sequences)).len(), 1, "asked once per stop");
}

#[test]
fn threads_are_told_while_the_program_runs() {
    let mut setup = Setup::launched(vec![]);
    setup.mock.state().sequences[1].active = true;
    let threads = setup.client.request("threads", Value::Null).unwrap();
    assert_eq!(threads["threads"][2], json!({ "id": 3, "name": "TURRET · line 4 (0 ms)" }));
}

#[test]
fn the_stack_holds_procedure_mechanism_and_module() {
    let mut setup = Setup::launched(vec![stop(StopReason::Step, 35, Some(0), &[35])]);
    setup.client.event(Mark::START, "stopped").unwrap();
    let body = setup.client.request("stackTrace", json!({ "threadId": 2 })).unwrap();
    let frame = |f: &Value| format!("{} {}", f["name"].as_str().unwrap(), f["line"]);
    let frames: Vec<String> = body["stackFrames"].as_array().unwrap().iter().map(frame).collect();
    assert_eq!(frames, ["STEP 35", "SPINDLE 18", "MODULE_MAIN 18"]);
    assert_eq!(body["totalFrames"], 3);
    let body =
        setup.client.request("stackTrace", json!({ "threadId": 2, "startFrame": 1, "levels": 1 })).unwrap();
    assert_eq!(body["stackFrames"].as_array().unwrap().len(), 1);
    assert_eq!(body["stackFrames"][0]["name"], "SPINDLE");
    let body = setup.client.request("stackTrace", json!({ "threadId": 1 })).unwrap();
    assert_eq!(frame(&body["stackFrames"][0]), "MODULE_MAIN 18");
}

#[test]
fn another_mechanism_shows_its_state_line() {
    let mut setup = Setup::stopped();
    {
        let mut state = setup.mock.state();
        state.sequences[1].active = true;
        state.sequences[1].line = 5;
    }
    let frame = setup.client.top_frame(3).unwrap();
    assert_eq!((&frame["name"], &frame["line"]), (&json!("TURRET"), &json!(5)));
    assert_eq!(frame["source"]["path"], setup.path("turret.plc"));
    let scopes = setup.client.request("scopes", json!({ "frameId": frame["id"] })).unwrap();
    let names: Vec<&Value> = scopes["scopes"].as_array().unwrap().iter().map(|s| &s["name"]).collect();
    assert_eq!(
        names,
        ["Local to turret.plc", "Variables", "Mechanisms", "Inputs", "Outputs", "Control interface"],
        "registers belong to what executes"
    );
}

#[test]
fn steps_stay_in_the_mechanism_whose_thread_is_stepped() {
    for (command, thread, expected) in [
        ("next", 2, Resume::Over { sequence: Some(0) }),
        ("next", 3, Resume::Over { sequence: Some(1) }),
        ("next", 1, Resume::Over { sequence: None }),
        ("stepIn", 2, Resume::Into),
        ("stepOut", 2, Resume::Out),
        ("continue", 2, Resume::Continue),
    ] {
        let mut setup = Setup::stopped();
        setup.mock.will_stop(stop_in_spindle(StopReason::Step, 21));
        let stopped = setup.client.go(command, thread).unwrap();
        assert_eq!(stopped["reason"], "step");
        let resumed = setup.mock.asked_for(|r| matches!(r, Request::Resume(_)));
        assert_eq!(resumed, [Request::Resume(expected)], "{command}");
        assert_eq!(setup.client.top_frame(2).unwrap()["line"], 21);
    }
}

#[test]
fn continue_tells_that_all_threads_go_on() {
    let mut setup = Setup::stopped();
    let body = setup.client.request("continue", json!({ "threadId": 2 })).unwrap();
    assert_eq!(body, json!({ "allThreadsContinued": true }));
    assert_eq!(
        setup.refusal("next", json!({ "threadId": 2 })),
        "`next` needs a program that is stopped; use `pause` first"
    );
}

#[test]
fn a_running_program_can_be_paused() {
    let mut setup = Setup::launched(vec![]);
    let stopped = setup.client.go("pause", 1).unwrap();
    assert_eq!(stopped["reason"], "pause");
    // Pausing once more is no error: the two may cross.
    setup.client.request("pause", json!({ "threadId": 1 })).unwrap();
}

#[test]
fn a_stop_on_entry_is_before_the_first_statement() {
    let mut setup = Setup::new();
    let mut arguments = setup.launch_arguments();
    arguments["stopOnEntry"] = json!(true);
    setup.client.start(arguments, &[]).unwrap();
    let stopped = setup.client.event(Mark::START, "stopped").unwrap();
    assert_eq!((&stopped["reason"], &stopped["threadId"]), (&json!("entry"), &json!(1)));
    assert_eq!(setup.client.top_frame(1).unwrap()["name"], "MODULE_MAIN");
}

#[test]
fn a_resumption_by_somebody_else_is_reported() {
    let mut setup = Setup::stopped();
    setup.mock.say(Event::Resumed);
    let continued = setup.client.event(Mark::START, "continued").unwrap();
    assert_eq!(continued, json!({ "threadId": 1, "allThreadsContinued": true }));
}

#[test]
fn a_fault_stops_with_its_reason() {
    let mut setup = Setup::launched(vec![]);
    setup.mock.say(Event::Stopped(stop_in_spindle(StopReason::Fault, 23)));
    setup.mock.say(Event::Fault(fault()));
    let stopped = setup.client.event(Mark::START, "stopped").unwrap();
    assert_eq!((&stopped["reason"], &stopped["text"]), (&json!("exception"), &json!("division by zero")));
    let info = setup.client.request("exceptionInfo", json!({ "threadId": 2 })).unwrap();
    assert_eq!(info["description"], "division by zero at main.plc:23 in SPINDLE, cycle 77");
    assert_eq!(info["breakMode"], "always");
    let output = setup.client.event_where(Mark::START, "output", |b| b["line"] == 23).unwrap();
    assert_eq!(output["output"], "PLC fault: division by zero at main.plc:23 in SPINDLE, cycle 77\n");
    assert_eq!(
        setup.refusal("continue", json!({ "threadId": 2 })),
        "the PLC stands after a fault; restart it to go on"
    );
}

#[test]
fn a_fault_without_details_stops_all_the_same() {
    let mut setup = Setup::launched(vec![]);
    setup.mock.say(Event::Stopped(stop_in_spindle(StopReason::Fault, 23)));
    assert_eq!(setup.client.event(Mark::START, "stopped").unwrap()["reason"], "exception");
}

#[test]
fn a_fault_nobody_wants_to_look_at_ends_the_session() {
    let mut setup = Setup::launched(vec![]);
    setup.client.request("setExceptionBreakpoints", json!({ "filters": [] })).unwrap();
    setup.mock.say(Event::Fault(fault()));
    setup.mock.say(Event::Stopped(stop_in_spindle(StopReason::Fault, 23)));
    assert_eq!(setup.client.event(Mark::START, "exited").unwrap(), json!({ "exitCode": 1 }));
    setup.client.event(Mark::START, "terminated").unwrap();
}

#[test]
fn messages_of_the_program_are_shown_with_their_place() {
    let mut setup = Setup::launched(vec![]);
    setup.mock.say(Event::Message {
        cycle: 9,
        number: 42,
        sub_id: Some(3),
        set: true,
        parameters: vec![1, -2],
        pc: sample::pc(19),
    });
    let output = setup.client.event_where(Mark::START, "output", |b| b["category"] == "stdout").unwrap();
    assert_eq!(output["output"], "message 42/3 (1, -2), cycle 9\n");
    assert_eq!((&output["line"], &output["source"]["name"]), (&json!(19), &json!("main.plc")));
}

#[test]
fn swarms_of_overruns_are_summed_up() {
    let mut setup = Setup::launched(vec![]);
    for cycle in 0..30 {
        setup.mock.say(Event::Overrun { cycle, fast: false });
    }
    setup
        .client
        .event_where(Mark::START, "output", |b| b["output"] == "29 more overruns within a second\n")
        .unwrap();
    let told = setup.client.timeline().iter().filter(|m| m.to_string().contains("overrun")).count();
    assert_eq!(told, 2);
}
