use super::*;
use proptest::prelude::*;
use std::time::Duration;

#[test]
fn requests_at_the_wrong_time_are_refused_and_harmless() {
    let mut setup = Setup::new();
    assert!(setup.refusal("launch", json!({})).contains("before `initialize`"));
    setup.client.initialize().unwrap();
    assert!(setup.refusal("initialize", json!({})).contains("twice"));
    assert!(setup.refusal("evaluate", json!({ "expression": "X" })).contains("before `launch` or `attach`"));
    assert!(setup.refusal("launch", json!({})).contains("missing field `program`"));
    let arguments = setup.launch_arguments();
    setup.client.request("launch", arguments.clone()).unwrap();
    assert!(setup.refusal("launch", arguments).contains("twice"));
    assert!(setup.refusal("stackTrace", json!({ "threadId": 1 })).contains("before the program runs"));
    setup.client.request("configurationDone", Value::Null).unwrap();
    assert!(setup.refusal("configurationDone", Value::Null).contains("under way"));
    assert!(
        setup.refusal("stackTrace", json!({ "threadId": 1 })).contains("needs a program that is stopped")
    );
    assert_eq!(setup.refusal("teleport", Value::Null), "the request `teleport` is not known here");
    setup.client.request("threads", Value::Null).unwrap();
}

#[test]
fn terminating_before_anything_runs_ends_the_session() {
    let mut setup = Setup::new();
    setup.client.initialize().unwrap();
    setup.client.request("terminate", Value::Null).unwrap();
    setup.client.event(Mark::START, "terminated").unwrap();
    setup.client.request("terminate", Value::Null).unwrap();
    setup.client.disconnect(Value::Null).unwrap();
}

#[test]
fn a_refusal_carries_the_words_clients_look_for() {
    let mut setup = Setup::launched(vec![]);
    let Err(ClientError::Refused { response, .. }) = setup.client.request("next", json!({ "threadId": 1 }))
    else {
        panic!()
    };
    assert_eq!(response["message"], "notStopped");
    assert_eq!(response["body"]["error"]["id"], 5);
    assert_eq!(response["body"]["error"]["showUser"], false);
}

#[test]
fn malformed_messages_are_answered_or_told_and_survived() {
    let mut setup = Setup::new();
    let frame = |body: &str| format!("Content-Length: {}\r\n\r\n{body}", body.len());
    let broken = frame(r#"{"seq": 90, "type": "request", "command": "threads", "arguments": {"#);
    setup.client.send_raw(broken.as_bytes()).unwrap();
    let Err(ClientError::Refused { message, .. }) = setup.client.response(90) else { panic!() };
    assert!(message.starts_with("the message is not valid JSON"), "{message}");
    for junk in
        ["nonsense\r\n\r\n".to_owned(), frame("{"), frame("[]"), frame("{\"command\": 7}"), frame("null")]
    {
        let mark = setup.client.mark();
        setup.client.send_raw(junk.as_bytes()).unwrap();
        let told = setup.client.event(mark, "output").unwrap();
        assert_eq!(told["category"], "stderr", "{junk}");
    }
    setup.client.initialize().unwrap();
}

#[test]
fn lines_are_counted_as_the_client_counts() {
    let mut setup = Setup::new();
    setup.mock.will_stop(stop_in_spindle(StopReason::Breakpoint, 20));
    setup.client.request("initialize", json!({ "linesStartAt1": false, "columnsStartAt1": false })).unwrap();
    let arguments = setup.launch_arguments();
    setup.client.request("launch", arguments).unwrap();
    let path = setup.path("main.plc");
    let placed = setup.client.set_breakpoints(&path, &[11]).unwrap();
    assert_eq!((&placed[0]["verified"], &placed[0]["line"]), (&json!(true), &json!(11)));
    setup.client.request("configurationDone", Value::Null).unwrap();
    setup.client.event(Mark::START, "stopped").unwrap();
    let frame = setup.client.top_frame(2).unwrap();
    assert_eq!((&frame["line"], &frame["column"]), (&json!(19), &json!(0)));
}

#[test]
fn a_client_that_closes_at_any_point_ends_the_session() {
    for phase in 0..3 {
        let (adapter_in, mut client_out) = std::io::pipe().unwrap();
        let (client_in, adapter_out) = std::io::pipe().unwrap();
        let surroundings = Mock::new().surroundings(SampleBuilder::default());
        let adapter = std::thread::spawn(move || crate::serve(adapter_in, adapter_out, &surroundings));
        use std::io::Write;
        let text = ["", "Content-Length: 300\r\n\r\n{\"seq\"", "Content-Length: 2\r\n\r\n{}"][phase];
        client_out.write_all(text.as_bytes()).unwrap();
        drop(client_out);
        drop(client_in);
        let deadline = std::time::Instant::now() + Duration::from_secs(5);
        while !adapter.is_finished() {
            assert!(std::time::Instant::now() < deadline, "phase {phase}");
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

/// Wild arguments: anything JSON can be, under names that handlers look at.
fn arguments() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        (0_i64..6).prop_map(Value::from),
        "[A-Z.=0-9 ]{0,12}".prop_map(Value::from),
        prop_oneof!["KSMP", "SPINDLE", "main.plc", "TABLE"].prop_map(Value::from),
    ];
    let keys = prop::sample::select(vec![
        "threadId",
        "frameId",
        "variablesReference",
        "name",
        "value",
        "expression",
        "context",
        "source",
        "path",
        "breakpoints",
        "line",
        "start",
        "count",
        "levels",
        "startFrame",
        "filters",
        "text",
        "column",
    ]);
    leaf.prop_recursive(2, 20, 6, move |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..4).prop_map(Value::from),
            prop::collection::vec((keys.clone(), inner), 0..8)
                .prop_map(|pairs| pairs.into_iter().map(|(k, v)| (k.to_owned(), v)).collect::<Value>()),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// Whatever a client asks while stopped: one answer each, and the session lives.
    #[test]
    fn every_request_is_answered_once_whatever_it_says(
        requests in prop::collection::vec((0..crate::session::COMMANDS.len(), arguments()), 1..20),
    ) {
        let mut setup = Setup::stopped();
        let harmless = |name: &str| !matches!(name, "disconnect" | "terminate" | "restart");
        let mut sent = Vec::new();
        for (command, arguments) in requests {
            let name = crate::session::COMMANDS[command].name;
            if harmless(name) {
                sent.push(setup.client.send(name, arguments).unwrap());
            }
        }
        for seq in sent {
            match setup.client.response(seq) {
                Ok(_) | Err(ClientError::Refused { .. }) => {}
                Err(error) => prop_assert!(false, "{error}"),
            }
            let answers = setup.client.timeline().iter().filter(|m| m["request_seq"] == seq).count();
            prop_assert_eq!(answers, 1);
        }
        setup.client.request("threads", Value::Null).unwrap();
    }
}
