//! One session, three ways to the target: what the editor sees must be the same.

use serde_json::{Value, json};
use technol_dap::client::{Client, Mark};

use crate::child::{Adapter, Site, refusal};
use crate::lathe::Lathe;

const CALL: &str = "PROC_CALL TURRET_STEPS";
const DEAD_TIME: &str = "TIM  CNT_DEAD,T_DEAD";

#[test]
fn a_session_on_the_embedded_target() {
    let lathe = Lathe::copy();
    play(&Site::embedded(), &lathe);
}

#[test]
fn a_session_over_tcp_is_the_same() {
    let lathe = Lathe::copy();
    let mut site = Site::tcp(&lathe);
    let there = play(&site, &lathe);
    assert!(site.target.as_mut().expect("a process").is_running(), "the target outlives the session");
    assert_eq!(there, play(&Site::embedded(), &lathe));
}

#[test]
fn a_session_over_a_serial_line_is_the_same() {
    let lathe = Lathe::copy();
    let Some(mut site) = Site::serial(&lathe) else { return };
    let there = play(&site, &lathe);
    assert!(site.target.as_mut().expect("a process").is_running(), "the target outlives the session");
    assert_eq!(there, play(&Site::embedded(), &lathe));
}

/// The session; answers all that was seen at the stops.
fn play(site: &Site, lathe: &Lathe) -> Vec<String> {
    let mut adapter = Adapter::start();
    let mut session = Session { client: &mut adapter.client, lathe, seen: Vec::new() };
    let (turret, spindle) = (lathe.path("turret.plc"), lathe.path("spindle.plc"));
    let (call, dead_time) = (lathe.line("turret.plc", CALL), lathe.line("spindle.plc", DEAD_TIME));
    let placed = session
        .client
        .start(site.launch(lathe), &[(&turret, &[call]), (&spindle, &[dead_time])])
        .expect("the program starts");
    for (placed, line) in placed.iter().zip([call, dead_time]) {
        assert_eq!((&placed[0]["verified"], &placed[0]["line"]), (&json!(true), &json!(line)));
    }
    session.steps_through_a_procedure(&placed[0][0]["id"], call);
    let thread = session.stops_in_the_mechanism(&placed[1][0]["id"], dead_time);
    session.shows_the_state(thread);
    session.evaluates(thread);
    session.changes_values(thread);
    session.steps_over_the_dead_time(thread, dead_time);
    let seen = std::mem::take(&mut session.seen);
    session.stops_where_a_break_point_is_set_while_it_runs();
    session.pauses_and_ends();
    assert_eq!(adapter.exit_code(), Some(0));
    seen
}

struct Session<'a> {
    client: &'a mut Client,
    lathe: &'a Lathe,
    /// What must not depend on the way to the target.
    seen: Vec<String>,
}

impl Session<'_> {
    /// The stop after `mark`: its body is noted, its thread answered.
    fn stop(&mut self, mark: Mark) -> (Value, i64) {
        let body = self.client.event(mark, "stopped").expect("a stop");
        assert_eq!(body["allThreadsStopped"], true);
        self.seen.push(body.to_string());
        let thread = body["threadId"].as_i64().expect("a thread");
        (body, thread)
    }

    /// Frames of a thread, innermost first: name, file, line.
    fn stack(&mut self, thread: i64) -> Vec<(String, String, u32)> {
        let body = self.client.request("stackTrace", json!({ "threadId": thread })).expect("a stack");
        let frames = body["stackFrames"].as_array().expect("frames");
        assert_eq!(body["totalFrames"], frames.len());
        let frame = |f: &Value| {
            let text = |v: &Value| v.as_str().expect("text").to_owned();
            (text(&f["name"]), text(&f["source"]["name"]), f["line"].as_u64().expect("a line") as u32)
        };
        let frames: Vec<_> = frames.iter().map(frame).collect();
        self.seen.push(format!("{frames:?}"));
        frames
    }

    /// A step; answers the innermost frame it ends in.
    fn step(&mut self, command: &str, thread: i64) -> (String, String, u32) {
        let mark = self.client.mark();
        self.client.request(command, json!({ "threadId": thread })).expect("a step");
        let (body, thread) = self.stop(mark);
        assert_eq!(body["reason"], "step", "{command}");
        self.stack(thread).swap_remove(0)
    }

    fn value(&mut self, expression: &str) -> String {
        let value = self.client.evaluate(expression, "watch");
        value.unwrap_or_else(|e| panic!("{expression}: {e}"))
    }

    fn scope(&mut self, thread: i64, name: &str) -> Value {
        let frame = self.client.top_frame(thread).expect("a frame");
        let body = self.client.request("scopes", json!({ "frameId": frame["id"] })).expect("scopes");
        let scopes = body["scopes"].as_array().expect("a list");
        let found = scopes.iter().find(|s| s["name"] == name);
        found.unwrap_or_else(|| panic!("`{name}` among {body}"))["variablesReference"].clone()
    }

    /// `name = value` of all variables under a reference.
    fn listed(&mut self, reference: &Value) -> Vec<String> {
        let children = self.client.children(reference).expect("variables");
        let text = |v: &Value| {
            format!("{} = {}", v["name"].as_str().expect("name"), v["value"].as_str().expect("value"))
        };
        let listed: Vec<String> = children.iter().map(text).collect();
        self.seen.extend(listed.clone());
        listed
    }

    fn steps_through_a_procedure(&mut self, id: &Value, call: u32) {
        let (body, thread) = self.stop(Mark::START);
        assert_eq!((&body["reason"], &body["hitBreakpointIds"]), (&json!("breakpoint"), &json!([id])));
        let file = || "turret.plc".to_owned();
        let begin = self.lathe.line("turret.plc", "PROC_BEGIN TURRET_STEPS");
        assert_eq!(self.stack(thread)[0], ("TURRET_CHANGE".to_owned(), file(), call));
        assert_eq!(self.step("stepIn", thread), ("TURRET_STEPS".to_owned(), file(), begin + 1));
        assert_eq!(self.stack(thread)[1], ("TURRET_CHANGE".to_owned(), file(), call), "the caller");
        // The first statement calls another procedure, which `next` runs through and `stepIn` enters.
        assert_eq!(self.step("next", thread), ("TURRET_STEPS".to_owned(), file(), begin + 2));
        assert_eq!(self.step("stepOut", thread), ("TURRET_CHANGE".to_owned(), file(), call + 1));
        let (name, ..) = self.step("stepOut", thread);
        assert_eq!(name, "MODULE_MAIN", "out of the mechanism");
        assert_eq!(self.step("next", thread).0, "TURRET_CHANGE", "`next` belongs to its thread");
    }

    fn stops_in_the_mechanism(&mut self, id: &Value, line: u32) -> i64 {
        // The turret's break-point is in the way of nothing: the disc turns once.
        let mark = self.client.mark();
        self.client.request("continue", json!({ "threadId": 1 })).expect("it goes on");
        let (body, thread) = self.stop(mark);
        assert_eq!((&body["reason"], &body["hitBreakpointIds"]), (&json!("breakpoint"), &json!([id])));
        let frames = self.stack(thread);
        assert_eq!(frames[0], ("SP_CONTROL".to_owned(), "spindle.plc".to_owned(), line));
        assert_eq!(frames[1].0, "MODULE_MAIN");
        // On the way the turret has sent its message.
        let message = self
            .client
            .event_where(Mark::START, "output", |b| {
                b["output"].as_str().is_some_and(|text| text.contains("message 901"))
            })
            .expect("the ESET");
        assert_eq!(message["source"]["name"], "turret.plc");
        assert_eq!(message["line"], self.lathe.line("turret.plc", "ESET INFO_TOOL"));
        self.seen.push(message["output"].to_string());
        thread
    }

    fn shows_the_state(&mut self, thread: i64) {
        let body = self.client.request("threads", Value::Null).expect("threads");
        let threads = body["threads"].as_array().expect("a list");
        let name = |id: i64| {
            let found = threads.iter().find(|t| t["id"] == id).unwrap_or_else(|| panic!("{id} in {body}"));
            found["name"].as_str().expect("a name").to_owned()
        };
        assert_eq!(name(1), "PLC cycle");
        let waits = self.lathe.line("spindle.plc", DEAD_TIME) - 2;
        assert!(name(thread).starts_with(&format!("SP_CONTROL · line {waits} TEX0")), "{}", name(thread));
        assert!(threads.iter().any(|t| t["name"].as_str().is_some_and(|n| n.starts_with("SHOW"))));
        self.seen.push(body.to_string());

        let registers = self.scope(thread, "Registers");
        let registers = self.listed(&registers);
        let names: Vec<&str> = registers.iter().filter_map(|r| r.split(' ').next()).collect();
        assert_eq!(names, ["RLO", "DR8", "DR16", "DR32", "DR64", "DR_REAL", "BX", "Equation"]);
        assert_eq!(registers[0], "RLO = true", "the standstill switch has let the TEX0 pass");

        let variables = self.scope(thread, "Variables");
        let variables = self.listed(&variables);
        for line in ["SP_TURNS = 1 (0001h)", "T_ACTUAL = 5 (05h)", "SP_WANT_CW = false"] {
            assert!(variables.iter().any(|v| v == line), "{line} among {variables:?}");
        }
        let local = self.scope(thread, "Local to spindle.plc");
        assert_eq!(self.listed(&local), ["CNT_DEAD = 0 (00h)"]);
        let mechanisms = self.scope(thread, "Mechanisms");
        let mechanisms = self.listed(&mechanisms);
        assert!(mechanisms.contains(&"TURRET_CHANGE = at rest".to_owned()), "{mechanisms:?}");
        let inputs = self.scope(thread, "Inputs");
        let port = self.client.children(&inputs).expect("ports")[0].clone();
        assert_eq!(port["name"], "P1IN");
        assert!(self.listed(&port["variablesReference"]).contains(&"2 SP_STAND = true".to_owned()));
        let outputs = self.scope(thread, "Outputs");
        self.listed(&outputs);
    }

    fn evaluates(&mut self, thread: i64) {
        for (expression, value) in [
            ("SP_TURNS", "1 (0001h)"),
            ("sp_turns", "1 (0001h)"),
            ("P1IN.SP_STAND", "true"),
            ("P1IN.K_CW", "false"),
            ("OP1.B1", "true"),
            ("BYTE.SP_TURNS", "1 (01h)"),
            ("BLOCKS+2", "901 (0385h)"),
            ("WORD.(T_USED+8)", "1 (0001h)"),
            ("DWRD.T_USED+6", "65536 (00010000h)"),
            ("HIGH.BLOCKS", "0 (00h)"),
            ("RLO", "true"),
        ] {
            assert_eq!(self.value(expression), value, "{expression}");
        }
        let line = self.lathe.line("spindle.plc", DEAD_TIME) - 2;
        assert_eq!(self.value("SP_CONTROL_LINE").split(' ').next(), Some(line.to_string().as_str()));
        assert!(self.value("SP_CONTROL").starts_with(&format!("line {line} TEX0")));
        let frame = self.client.top_frame(thread).expect("a frame")["id"].clone();
        // The last one is an area without a type: it has to be told how to be read.
        for (expression, part) in [("NOBODY", "NOBODY"), ("BLOCKS+", "not complete"), ("T_USED+8", "T_USED")]
        {
            let arguments = json!({ "expression": expression, "frameId": frame });
            let why = refusal(self.client, "evaluate", arguments);
            assert!(why.contains(part), "{expression}: {why}");
        }
    }

    fn changes_values(&mut self, thread: i64) {
        let variables = self.scope(thread, "Variables");
        let registers = self.scope(thread, "Registers");
        let set = |client: &mut Client, scope: &Value, name: &str, value: &str| {
            let arguments = json!({ "variablesReference": scope, "name": name, "value": value });
            client.request("setVariable", arguments).map(|body| body["value"].clone())
        };
        let answer = set(self.client, &variables, "ERRORS", "0FFh").expect("a number");
        assert_eq!(answer, "255 (00FFh)");
        assert_eq!(self.value("ERRORS"), "255 (00FFh)");
        set(self.client, &registers, "DR64", "-1").expect("a register");
        set(self.client, &registers, "DR8", "2").expect("a part of a register");
        assert_eq!(self.value("DR16"), "-254 (0FF02h)", "the upper part of DR stays");
        let why = set(self.client, &variables, "SP_RUNS", "maybe").expect_err("no bit").to_string();
        assert!(why.contains("maybe") && why.contains("true, false"), "{why}");
        let why = set(self.client, &variables, "T_COUNT", "256").expect_err("too big").to_string();
        assert!(why.contains("256") && why.contains("255"), "{why}");

        for (expression, value, shown, other, others) in [
            ("WORD.(T_USED+2)", "0201h", "513 (0201h)", "BYTE.(T_USED+3)", "2 (02h)"),
            ("IP6.B7", "true", "true", "IP6", "128 (80h, -128)"),
            ("DWRD.SP_STARTS", "65537", "65537 (00010001h)", "SP_STARTS", "1 (0001h)"),
        ] {
            let body = self
                .client
                .request("setExpression", json!({ "expression": expression, "value": value }))
                .unwrap_or_else(|e| panic!("{expression}: {e}"));
            assert_eq!(body["value"], shown, "{expression}");
            assert_eq!(self.value(other), others, "{expression}");
        }
        let why = refusal(self.client, "setExpression", json!({ "expression": "CNST.5", "value": "6" }));
        assert!(why.contains("CNST.5"), "{why}");
    }

    /// The TIM counts the cycles it waits; with 14 of 15 counted it waits one more and passes in the next.
    fn steps_over_the_dead_time(&mut self, thread: i64, line: u32) {
        for file in ["spindle.plc", "turret.plc"] {
            let none = self.client.set_breakpoints(&self.lathe.path(file), &[]).expect("an empty list");
            assert_eq!(none, json!([]));
        }
        let start = self.lathe.line("spindle.plc", "SP_START:");
        // A mechanism that waits goes on behind the EX-type instruction it passed last.
        for (expected, counted) in [
            (line - 1, Some("1")),
            (line, Some("14")),
            (line - 1, Some("15")),
            (line, None),
            (start + 1, None),
        ] {
            let (name, file, at) = self.step("next", thread);
            assert_eq!((name.as_str(), file.as_str(), at), ("SP_CONTROL", "spindle.plc", expected));
            if counted == Some("14") {
                let local = self.scope(thread, "Local to spindle.plc");
                let set = json!({ "variablesReference": local, "name": "CNT_DEAD", "value": "14" });
                self.client.request("setVariable", set).expect("a local cell");
            }
            if let Some(counted) = counted {
                assert_eq!(self.value("CNT_DEAD").split(' ').next(), Some(counted));
            }
        }
        assert_eq!(self.value("CNT_DEAD"), "0 (00h)", "the counter restarts when the state is left");
    }

    fn stops_where_a_break_point_is_set_while_it_runs(&mut self) {
        self.client.request("continue", json!({ "threadId": 1 })).expect("it goes on");
        let why = refusal(self.client, "stackTrace", json!({ "threadId": 1 }));
        assert!(why.contains("pause"), "{why}");
        let line = self.lathe.line("panel.plc", "TIM  -,50");
        let mark = self.client.mark();
        let placed = self.client.set_breakpoints(&self.lathe.path("panel.plc"), &[line]).expect("placed");
        assert_eq!((&placed[0]["verified"], &placed[0]["line"]), (&json!(true), &json!(line)));
        let (body, thread) = self.stop(mark);
        assert_eq!(
            (&body["reason"], &body["hitBreakpointIds"]),
            (&json!("breakpoint"), &json!([placed[0]["id"]]))
        );
        assert_eq!(self.stack(thread)[0].2, line);
        self.client.set_breakpoints(&self.lathe.path("panel.plc"), &[]).expect("an empty list");
    }

    fn pauses_and_ends(&mut self) {
        self.client.request("continue", json!({ "threadId": 1 })).expect("it goes on");
        let body = self.client.go("pause", 1).expect("a pause");
        assert_eq!(body["reason"], "pause");
        let before = self.value("CYCLES");
        assert_eq!(self.value("CYCLES"), before, "held");
        let mark = self.client.mark();
        self.client.request("terminate", Value::Null).expect("terminate");
        self.client.event(mark, "terminated").expect("the end of the program");
        self.client.disconnect(json!({})).expect("the adapter closes the connection");
    }
}
