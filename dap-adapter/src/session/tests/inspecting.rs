use super::*;
use technol_wire::message::{Registers, Request};

/// Stopped, with the innermost frame.
fn looking() -> (Setup, Value) {
    let mut setup = Setup::stopped();
    let frame = setup.client.top_frame(2).unwrap();
    (setup, frame)
}

fn named<'a>(variables: &'a [Value], name: &str) -> &'a Value {
    variables.iter().find(|v| v["name"] == name).unwrap_or_else(|| panic!("no {name} in {variables:?}"))
}

#[test]
fn registers_are_shown_in_all_widths() {
    let (mut setup, frame) = looking();
    let registers = setup.client.scope(&frame, "Registers").unwrap();
    assert_eq!(
        Setup::lines(&registers),
        [
            "RLO = true",
            "DR8 = 44 (2Ch)",
            "DR16 = 300 (012Ch)",
            "DR32 = 300 (0000012Ch)",
            "DR64 = 300 (000000000000012Ch)",
            "DR_REAL = 0.5",
            "BX = 0 (00000000h)",
            "Equation stack = 2 pushed",
        ]
    );
    let stack = setup.client.children(&named(&registers, "Equation stack")["variablesReference"]).unwrap();
    assert_eq!(Setup::lines(&stack), ["top = false", "top - 1 = true"]);
    assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Registers)), [], "the stop brought them along");
}

#[test]
fn variables_are_read_in_one_round_trip() {
    let (mut setup, frame) = looking();
    let variables = setup.client.scope(&frame, "Variables").unwrap();
    assert_eq!(
        Setup::lines(&variables),
        [
            "INPUTS = 1 (01h)",
            "OUTPUTS = 0 (00h)",
            "COUNT = 300 (012Ch)",
            "SPEED = 4294967295 (0FFFFFFFFh, -1)",
            "TITLE = 'abc'",
            "TABLE = 20 bytes: 00 07 00 00 00 00 00 00 00 00 00 00 00 00 00 00 …",
            "RATIO = 2.5",
            "LONELY = true",
        ]
    );
    assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Read { .. })).len(), 1);
    let bits = setup.client.children(&named(&variables, "INPUTS")["variablesReference"]).unwrap();
    assert_eq!(Setup::lines(&bits), ["KSMP = true", "KSMM = false"]);
    assert_eq!(bits[0]["evaluateName"], "KSMP");
    assert_eq!(bits[0]["type"], "bit");
}

#[test]
fn areas_are_shown_page_by_page() {
    let (mut setup, frame) = looking();
    let variables = setup.client.scope(&frame, "Variables").unwrap();
    let table = named(&variables, "TABLE");
    assert_eq!(table["indexedVariables"], 20);
    let page = |start: u32, filter: &str| json!({ "variablesReference": table["variablesReference"], "start": start, "count": 2, "filter": filter });
    let body = setup.client.request("variables", page(1, "indexed")).unwrap();
    assert_eq!(Setup::lines(body["variables"].as_array().unwrap()), ["[1] = 7 (07h)", "[2] = 0 (00h)"]);
    let body = setup.client.request("variables", page(19, "indexed")).unwrap();
    assert_eq!(body["variables"].as_array().unwrap().len(), 1);
    let body = setup.client.request("variables", page(0, "named")).unwrap();
    assert_eq!(body["variables"], json!([]));
}

#[test]
fn numbers_can_be_shown_in_hexadecimal_only() {
    let (mut setup, _) = looking();
    let arguments = json!({ "expression": "COUNT", "context": "watch", "format": { "hex": true } });
    assert_eq!(setup.client.request("evaluate", arguments).unwrap()["result"], "012Ch");
}

#[test]
fn mechanisms_tell_their_state() {
    let (mut setup, frame) = looking();
    let mechanisms = setup.client.scope(&frame, "Mechanisms").unwrap();
    assert_eq!(Setup::lines(&mechanisms), ["SPINDLE = line 21 EX0 LDR KSMP (1.2 s)", "TURRET = at rest"]);
    let spindle = named(&mechanisms, "SPINDLE")["variablesReference"].clone();
    let details = setup.client.children(&spindle).unwrap();
    assert_eq!(
        Setup::lines(&details),
        ["active = true", "line = 21", "state = EX0", "condition = LDR KSMP", "in state for = 1.2 s"]
    );
    let set =
        |name: &str, value: &str| json!({ "variablesReference": spindle, "name": name, "value": value });
    let body = setup.client.request("setVariable", set("active", "0")).unwrap();
    assert_eq!(body["value"], "false");
    assert_eq!(
        setup.mock.asked_for(|r| matches!(r, Request::SetSequence { .. })),
        [Request::SetSequence { sequence: 0, active: false }]
    );
    assert!(setup.refusal("setVariable", set("line", "20")).contains("start or stop the mechanism"));
    let details = setup.client.children(&spindle).unwrap();
    assert_eq!(Setup::lines(&details)[0], "active = false", "read anew after the change");
}

#[test]
fn ports_show_the_names_the_program_gives_their_bits() {
    let (mut setup, frame) = looking();
    let inputs = setup.client.scope(&frame, "Inputs").unwrap();
    assert_eq!(Setup::lines(&inputs), ["P1IN = 3 (03h)"]);
    let bits = setup.client.children(&inputs[0]["variablesReference"]).unwrap();
    assert_eq!(Setup::lines(&bits)[..3], ["0 KSMP = true", "1 KSMM = true", "2 = false"]);
    assert_eq!(bits[1]["evaluateName"], "P1IN.1");
}

#[test]
fn setting_a_variable_writes_just_that() {
    let (mut setup, frame) = looking();
    let scopes = setup.client.request("scopes", json!({ "frameId": frame["id"] })).unwrap();
    let reference = |name: &str| {
        scopes["scopes"].as_array().unwrap().iter().find(|s| s["name"] == name).unwrap()["variablesReference"]
            .clone()
    };
    let globals = reference("Variables");
    for (name, value, shown) in [
        ("COUNT", "-2", "65534 (0FFFEh, -2)"),
        ("RATIO", "1.25", "1.25"),
        ("TITLE", "'no'", "'no'"),
        ("LONELY", "0", "false"),
    ] {
        let mark = setup.client.mark();
        let arguments = json!({ "variablesReference": globals, "name": name, "value": value });
        let body = setup.client.request("setVariable", arguments).unwrap();
        assert_eq!(body["value"], shown, "{name}");
        let invalidated = setup.client.event(mark, "invalidated").unwrap();
        assert_eq!(invalidated, json!({ "areas": ["variables"] }));
    }
    assert_eq!(
        setup.mock.asked_for(|r| matches!(r, Request::Write { .. } | Request::WriteBits { .. })),
        [
            Request::Write { addr: sample::COUNT, bytes: vec![0xFE, 0xFF] },
            Request::Write { addr: sample::RATIO, bytes: 1.25_f64.to_le_bytes().to_vec() },
            Request::Write { addr: sample::TITLE, bytes: b"no\0\0\0\0\0\0\0".to_vec() },
            Request::WriteBits { addr: sample::LONELY, mask: 8, value: 0 },
        ]
    );
    let wrong = json!({ "variablesReference": globals, "name": "COUNT", "value": "70000" });
    assert_eq!(setup.refusal("setVariable", wrong), "`COUNT`: 70000 does not fit: -32768 to 65535");
    let unknown = json!({ "variablesReference": globals, "name": "NOBODY", "value": "1" });
    assert_eq!(setup.refusal("setVariable", unknown), "there is no `NOBODY` here");
    let stale = json!({ "variablesReference": 999, "name": "COUNT", "value": "1" });
    assert!(setup.refusal("setVariable", stale).contains("there is no variable number 999"));
}

#[test]
fn registers_are_set_while_stopped() {
    let (mut setup, frame) = looking();
    let scopes = setup.client.request("scopes", json!({ "frameId": frame["id"] })).unwrap();
    let registers = scopes["scopes"][0]["variablesReference"].clone();
    let arguments = json!({ "variablesReference": registers, "name": "DR8", "value": "0" });
    assert_eq!(setup.client.request("setVariable", arguments).unwrap()["value"], "0 (00h)");
    let set = setup.mock.asked_for(|r| matches!(r, Request::SetRegisters(_)));
    let Request::SetRegisters(Registers { dr, .. }) = set[0] else { panic!() };
    assert_eq!(dr, 0x100);
    assert_eq!(setup.client.evaluate("DR16", "watch").unwrap(), "256 (0100h)");
}

#[test]
fn expressions_are_evaluated_in_every_context() {
    let (mut setup, frame) = looking();
    for (expression, value) in [
        ("KSMP", "true"),
        ("ksmm", "false"),
        ("P1IN.1", "true"),
        ("COUNT", "300 (012Ch)"),
        ("RLO", "true"),
        ("DR", "300 (000000000000012Ch)"),
        ("LIMIT", "12 (0Ch)"),
        ("SPINDLE", "line 21 EX0 LDR KSMP (1.2 s)"),
    ] {
        for context in ["hover", "watch", "repl", "variables", "clipboard"] {
            assert_eq!(setup.client.evaluate(expression, context).unwrap(), value, "{expression} {context}");
        }
    }
    let body =
        setup.client.request("evaluate", json!({ "expression": "INPUTS", "context": "watch" })).unwrap();
    assert_eq!(Setup::lines(&setup.client.children(&body["variablesReference"]).unwrap())[0], "KSMP = true");
    let body =
        setup.client.request("evaluate", json!({ "expression": "TABLE", "context": "watch" })).unwrap();
    assert_eq!(body["indexedVariables"], 20);
    // Local data are seen from the frames of their file.
    setup.mock.state().sequences[1].active = true;
    setup.client.request("setExpression", json!({ "expression": "TURRET", "value": "1" })).unwrap();
    let turret = setup.client.top_frame(3).unwrap();
    let arguments = json!({ "expression": "STEP_NO", "frameId": turret["id"], "context": "watch" });
    assert_eq!(setup.client.request("evaluate", arguments).unwrap()["result"], "0 (00h)");
    let gone = json!({ "expression": "KSMP", "frameId": 77 });
    assert!(setup.refusal("evaluate", gone).contains("no stack frame number 77"));
    assert_eq!(frame["id"], 1);
}

#[test]
fn a_running_program_can_be_looked_at_and_changed() {
    let mut setup = Setup::launched(vec![]);
    assert_eq!(setup.client.evaluate("COUNT", "watch").unwrap(), "300 (012Ch)");
    let arguments = json!({ "expression": "KSMM", "value": "true" });
    assert_eq!(
        setup.client.request("setExpression", arguments).unwrap(),
        json!({ "value": "true", "type": "bit" })
    );
    assert_eq!(setup.client.evaluate("KSMM", "watch").unwrap(), "true");
    let constant = json!({ "expression": "LIMIT", "value": "1" });
    assert_eq!(setup.refusal("setExpression", constant), "`LIMIT` cannot be changed: it is a constant");
    let register = json!({ "expression": "RLO", "value": "1" });
    assert!(setup.refusal("setExpression", register).contains("needs a program that is stopped"));
}

#[test]
fn the_console_takes_commands() {
    let mut setup = Setup::launched(vec![]);
    for (line, said) in [
        ("fault stuck contactor on", "fault stuck contactor is on"),
        ("press start", "key start pressed"),
        ("hold start", "key start held down"),
        ("start turret", "TURRET started"),
        ("stop TURRET", "TURRET put into rest"),
        ("COUNT = 12", "COUNT = 12 (000Ch)"),
        ("plc clear", "PLC clear ordered"),
    ] {
        assert_eq!(setup.client.evaluate(line, "repl").unwrap(), said);
    }
    assert!(setup.client.evaluate("help", "repl").unwrap().contains("release KEY "));
    for (line, error) in [
        ("fault stuck contactor", "usage: fault NAME on|off — switch a fault of the simulated machine"),
        ("fault other on", "the target refuses: `other` is not known; there is stuck contactor"),
        ("start NOBODY", "there is no mechanism `NOBODY`"),
        ("plc dance", "usage: plc start|stop|clear — start, stop or clear the PLC"),
    ] {
        assert_eq!(setup.refusal("evaluate", json!({ "expression": line, "context": "repl" })), error);
    }
    // The same words are expressions anywhere else.
    assert!(setup.client.evaluate("press start", "watch").is_err());
    let is_release = |r: &Request| *r == Request::Press { key: "start".into(), down: false };
    let deadline = std::time::Instant::now() + std::time::Duration::from_secs(3);
    while setup.mock.asked_for(is_release).is_empty() {
        assert!(std::time::Instant::now() < deadline, "the key is never let go");
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
}

#[test]
fn names_and_commands_are_completed() {
    let mut setup = Setup::launched(vec![]);
    let labels = |setup: &mut Setup, text: &str| {
        let arguments = json!({ "text": text, "column": text.len() + 1 });
        let body = setup.client.request("completions", arguments).unwrap();
        let targets = body["targets"].as_array().unwrap().clone();
        targets.iter().map(|t| t["label"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(labels(&mut setup, "ks"), ["KSMP", "KSMM"]);
    assert_eq!(labels(&mut setup, "st"), ["start", "stop", "STEP_NO"]);
    assert_eq!(labels(&mut setup, "start sp"), ["SPEED", "SPINDLE"]);
}
