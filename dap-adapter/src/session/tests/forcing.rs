use super::*;
use technol_image::op::Addr;
use technol_image::system;
use technol_wire::message::{Request, Resume};

const IN_LOW: Addr = system::IN_FORCE_LOW;
const IN_HIGH: Addr = system::IN_FORCE_HIGH;
const OUT_LOW: Addr = system::OUT_FORCE_LOW;
const OUT_HIGH: Addr = system::OUT_FORCE_HIGH;

fn bits(addr: Addr, mask: u8, value: u8) -> Request {
    Request::WriteBits { addr, mask, value }
}

fn writes(setup: &Setup) -> Vec<Request> {
    setup.mock.asked_for(|r| matches!(r, Request::WriteBits { .. }))
}

fn console(setup: &mut Setup, line: &str) -> String {
    setup.client.evaluate(line, "repl").unwrap()
}

fn mask(setup: &Setup, addr: Addr) -> u8 {
    setup.mock.state().memory[addr as usize]
}

fn says(setup: &mut Setup, mark: Mark, text: &str) -> Value {
    setup
        .client
        .event_where(mark, "output", |b| b["output"].as_str().is_some_and(|t| t.contains(text)))
        .unwrap_or_else(|e| panic!("{text}: {e}"))
}

fn attached(mock: Mock, more: &Value) -> Setup {
    let mut setup = Setup::with(mock, |_| {});
    setup.client.initialize().unwrap();
    let mut arguments = json!({ "program": setup.folder.path(), "target": "tcp:plc:5000" });
    for (name, value) in more.as_object().unwrap() {
        arguments[name] = value.clone();
    }
    setup.client.request("attach", arguments).unwrap();
    setup.client.request("configurationDone", Value::Null).unwrap();
    setup
}

#[test]
fn a_bit_is_forced_by_the_name_of_its_port_or_of_its_copy() {
    let mut setup = Setup::launched(vec![]);
    assert_eq!(console(&mut setup, "force P1IN.3 1"), "P1IN.3 is forced to 1");
    assert_eq!(console(&mut setup, "force ksmp 0"), "P1IN.0 (KSMP) is forced to 0");
    assert_eq!(console(&mut setup, "force SMP 1"), "P0OUT.4 (SMP) is forced to 1");
    assert_eq!(console(&mut setup, "force SMP 0"), "P0OUT.4 (SMP) is forced to 0");
    // At no moment does a bit fall back to what is sensed.
    assert_eq!(
        writes(&setup),
        [
            bits(IN_HIGH, 8, 8),
            bits(IN_LOW, 8, 0),
            bits(IN_LOW, 1, 1),
            bits(IN_HIGH, 1, 0),
            bits(OUT_HIGH, 16, 16),
            bits(OUT_LOW, 16, 0),
            bits(OUT_LOW, 16, 16),
            bits(OUT_HIGH, 16, 0),
        ]
    );
    assert_eq!(console(&mut setup, "forced"), "P1IN.0 (KSMP) = 0\nP1IN.3 = 1\nP0OUT.4 (SMP) = 0");
    assert_eq!(console(&mut setup, "unforce KSMP"), "P1IN.0 (KSMP) is not forced any more");
    assert_eq!(console(&mut setup, "unforce KSMP"), "P1IN.0 (KSMP) was not forced");
    assert_eq!(console(&mut setup, "force P1IN 0A5h"), "P1IN is forced to 165");
    assert_eq!((mask(&setup, IN_LOW), mask(&setup, IN_HIGH)), (0x5A, 0xA5));
    assert_eq!(console(&mut setup, "unforce all"), "9 bits are not forced any more");
    assert_eq!(console(&mut setup, "unforce ALL"), "nothing was forced");
    assert_eq!(console(&mut setup, "forced"), "nothing is forced");
    let masks = IN_LOW as usize..system::OUT_SHORTED as usize;
    assert!(setup.mock.state().memory[masks].iter().all(|b| *b == 0));
}

#[test]
fn what_cannot_be_forced_is_told_why() {
    let mut setup = Setup::launched(vec![]);
    for (line, why) in [
        (
            "force COUNT 1",
            "`COUNT` is not a bit or byte of a port, nor a copy of one: only ports can be forced; \
             `NAME = VALUE` sets anything once",
        ),
        ("force LIMIT 1", "`LIMIT` is a constant: only ports can be forced"),
        (
            "force P1IN.3",
            "usage: force NAME VALUE — hold a bit (0, 1) or byte (0 to 255) of a port at a value",
        ),
        ("unforce LONELY", "`LONELY` is not a bit or byte of a port"),
    ] {
        let said = setup.refusal("evaluate", json!({ "expression": line, "context": "repl" }));
        assert!(said.starts_with(why), "{line}: {said}");
    }
    for line in ["force NOBODY 1", "force P1IN.3 2", "force P1IN 256", "force P1IN.9 1"] {
        let said = setup.refusal("evaluate", json!({ "expression": line, "context": "repl" }));
        assert!(!said.is_empty(), "{line}");
    }
    let said = setup.refusal("technol/force", json!({ "name": "P1IN.3" }));
    assert!(said.contains("`value` must be a number, or null"), "{said}");
    assert_eq!(writes(&setup), [], "nothing is tried");
}

#[test]
fn views_show_what_is_forced_by_whomever() {
    let mut setup = Setup::stopped();
    console(&mut setup, "force KSMP 1");
    {
        let memory = &mut setup.mock.state().memory;
        memory[IN_LOW as usize] |= 0b010;
        memory[IN_LOW as usize] |= 0b100;
        memory[IN_HIGH as usize] |= 0b100;
    }
    let frame = setup.client.top_frame(2).unwrap();
    let inputs = setup.client.scope(&frame, "Inputs").unwrap();
    assert_eq!(Setup::lines(&inputs), ["P1IN = 3 (03h) (forced .0=1 .1=0 .2=0)"]);
    let rows = setup.client.children(&inputs[0]["variablesReference"]).unwrap();
    assert_eq!(
        Setup::lines(&rows)[..4],
        [
            "0 KSMP = true (forced)",
            "1 KSMM = true (forced to 0)",
            "2 = false (forced to 0, which wins over forced to 1)",
            "3 = false"
        ]
    );
    assert_eq!(setup.client.evaluate("P1IN.0", "watch").unwrap(), "true (forced)");
    assert_eq!(
        console(&mut setup, "forced"),
        "P1IN.0 (KSMP) = 1\nP1IN.1 (KSMM) = 0, not by this session\n\
         P1IN.2 = 0 (both masks are set: 0 wins), not by this session"
    );
    assert!(rows.iter().all(|r| r.get("__vscodeVariableMenuContext").is_none()), "only VS Code knows it");
    // Somebody takes our force away: that is told, not hidden.
    setup.mock.state().memory[IN_HIGH as usize] = 0;
    let said = console(&mut setup, "forced");
    assert!(said.ends_with("P1IN.0 (KSMP) was forced to 1, and somebody else has changed that"), "{said}");
}

#[test]
fn editors_force_by_a_request() {
    let mut setup = Setup::launched(vec![]);
    let mark = setup.client.mark();
    let body = setup.client.request("technol/force", json!({ "name": "KSMP", "value": 1 })).unwrap();
    assert_eq!(body, json!({ "message": "P1IN.0 (KSMP) is forced to 1" }));
    says(&mut setup, mark, "P1IN.0 (KSMP) is forced to 1");
    setup.mock.state().memory[OUT_LOW as usize] = 1;
    let body = setup.client.request("technol/forced", Value::Null).unwrap();
    assert_eq!(
        body["forced"],
        json!([
            { "name": "P1IN.0", "symbol": "KSMP", "value": 1, "own": true, "both": false },
            { "name": "P0OUT.0", "value": 0, "own": false, "both": false },
        ])
    );
    let null = setup.client.request("technol/force", json!({ "name": "KSMP", "value": null })).unwrap();
    assert_eq!(null["message"], "P1IN.0 (KSMP) is not forced any more");
}

#[test]
fn a_restart_begins_with_everything_forced_again() {
    let mut setup = Setup::launched(vec![]);
    console(&mut setup, "force KSMP 1");
    console(&mut setup, "force SMP 0");
    let mark = setup.client.mark();
    let before = setup.mock.state().log.len();
    setup.client.request("restart", Value::Null).unwrap();
    let log = setup.mock.state().log[before..].to_vec();
    let at = |wanted: &Request| {
        log.iter().position(|r| r == wanted).unwrap_or_else(|| panic!("{wanted:?}: {log:?}"))
    };
    let start = at(&Request::Start { cold: true, stop_on_entry: true });
    let go_on = at(&Request::Resume(Resume::Continue));
    // The inputs of the first pass have been copied already.
    for wanted in [bits(IN_HIGH, 1, 1), bits(OUT_LOW, 16, 16), bits(system::IN_PORTS, 1, 1)] {
        assert!((start..go_on).contains(&at(&wanted)), "{wanted:?}");
    }
    assert_eq!((mask(&setup, IN_HIGH), mask(&setup, OUT_LOW)), (1, 16));
    // The client hears nothing of the stop in between.
    setup.client.request("threads", Value::Null).unwrap();
    let quiet = |m: &Value| m["event"] != "stopped" && m["event"] != "continued";
    assert!(setup.client.timeline().iter().all(quiet));
    setup.client.request("pause", json!({ "threadId": 1 })).unwrap();
    setup.client.event(mark, "stopped").unwrap();
    says(&mut setup, mark, "2 bits are forced; `forced` lists them");
}

#[test]
fn a_restart_that_stops_on_entry_stops_once() {
    let mut setup = Setup::new();
    let mut arguments = setup.launch_arguments();
    arguments["stopOnEntry"] = json!(true);
    setup.client.start(arguments, &[]).unwrap();
    setup.client.event(Mark::START, "stopped").unwrap();
    console(&mut setup, "force KSMP 1");
    setup.mock.state().status.held = false;
    let mark = setup.client.mark();
    setup.client.request("restart", Value::Null).unwrap();
    assert_eq!(setup.client.event(mark, "stopped").unwrap()["reason"], "entry");
    assert_eq!(mask(&setup, IN_HIGH), 1);
    assert_eq!(setup.mock.asked_for(|r| matches!(r, Request::Resume(_))), []);
}

#[test]
fn the_end_of_a_session_ends_what_it_forced_and_nothing_else() {
    let mock = Mock::new().running();
    mock.state().memory[OUT_HIGH as usize + 7] = 0x80;
    let mut setup = attached(mock, &json!({}));
    says(&mut setup, Mark::START, "1 bit is forced; `forced` lists them");
    console(&mut setup, "force KSMP 1");
    console(&mut setup, "force P1IN.7 0");
    let mark = setup.client.mark();
    setup.client.disconnect(Value::Null).unwrap();
    let body = says(&mut setup, mark, "not forced any more: P1IN.0 (KSMP), P1IN.7\n");
    assert_eq!(body["category"], "important");
    assert_eq!((mask(&setup, IN_HIGH), mask(&setup, IN_LOW), mask(&setup, OUT_HIGH + 7)), (0, 0, 0x80));
}

#[test]
fn what_is_forced_is_kept_when_it_was_asked_for() {
    let mut setup = attached(Mock::new().running(), &json!({ "keepForced": true }));
    console(&mut setup, "force KSMP 1");
    let mark = setup.client.mark();
    setup.client.disconnect(Value::Null).unwrap();
    says(&mut setup, mark, "still forced, as `keepForced` says: P1IN.0 (KSMP)");
    assert_eq!(mask(&setup, IN_HIGH), 1);
}

#[test]
fn a_link_that_comes_back_finds_what_was_forced_and_not_what_failed() {
    let mut setup = attached(Mock::new().running(), &json!({}));
    console(&mut setup, "force KSMP 1");
    let mark = setup.client.mark();
    setup.mock.state().cut = true;
    let failed = setup.refusal("evaluate", json!({ "expression": "force KSMM 1", "context": "repl" }));
    assert!(failed.contains("link"), "{failed}");
    says(&mut setup, mark, "the link to the target is lost");
    {
        // What an order without an answer, and a cold start, may have left behind.
        let state = &mut setup.mock.state();
        state.memory[IN_HIGH as usize] = 0b10;
        state.cut = false;
    }
    says(&mut setup, mark, "the link to the target is back");
    assert_eq!((mask(&setup, IN_HIGH), mask(&setup, IN_LOW)), (0b01, 0));
    assert_eq!(console(&mut setup, "forced"), "P1IN.0 (KSMP) = 1");
}

#[test]
fn a_target_that_is_lost_for_good_may_still_force() {
    let mut setup = attached(Mock::new().running(), &json!({ "reconnect": 0 }));
    console(&mut setup, "force KSMP 1");
    let mark = setup.client.mark();
    setup.mock.state().cut = true;
    says(&mut setup, mark, "it may still force: P1IN.0 (KSMP); `unforce all`");
}

#[test]
fn vs_code_offers_its_menu_for_bits_of_ports_and_for_their_copies() {
    let mut setup = Setup::new();
    setup.mock.state().stops.push_back(stop_in_spindle(StopReason::Breakpoint, 20));
    setup.client.request("initialize", json!({ "clientID": "vscode", "adapterID": "technol" })).unwrap();
    let arguments = setup.launch_arguments();
    setup.client.request("launch", arguments).unwrap();
    setup.client.request("configurationDone", Value::Null).unwrap();
    setup.client.event(Mark::START, "stopped").unwrap();
    let frame = setup.client.top_frame(2).unwrap();
    let offered = |rows: &[Value]| {
        let menu = |r: &Value| r["__vscodeVariableMenuContext"] == "technolPortBit";
        rows.iter().map(menu).collect::<Vec<_>>()
    };
    let inputs = setup.client.scope(&frame, "Inputs").unwrap();
    assert_eq!(offered(&inputs), [false], "a byte takes more than 0 and 1");
    let bits = setup.client.children(&inputs[0]["variablesReference"]).unwrap();
    assert_eq!(offered(&bits), [true; 8]);
    let variables = setup.client.scope(&frame, "Variables").unwrap();
    assert_eq!(offered(&variables), [false; 8]);
    let copies = setup.client.children(&variables[0]["variablesReference"]).unwrap();
    assert_eq!(offered(&copies), [true; 2]);
}
