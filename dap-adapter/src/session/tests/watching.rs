use super::*;
use std::time::{Duration, Instant};
use technol_image::system;
use technol_wire::message::Request;

use crate::forcing::{MASKS, MASKS_LEN};

/// Launched, running, and watching.
fn watching(arguments: Value) -> (Setup, Value) {
    let mut setup = Setup::launched(vec![]);
    let answer = setup.client.request("technol/subscribe", arguments).unwrap();
    (setup, answer)
}

fn set_count(setup: &Setup, value: u16) {
    setup.mock.state().memory[sample::COUNT as usize..][..2].copy_from_slice(&value.to_le_bytes());
}

/// Questions about values; what is forced is looked at apart from that.
fn reads(setup: &Setup) -> usize {
    let masks = MASKS..MASKS + MASKS_LEN;
    let of_values = |pieces: &[(u32, u16)]| pieces.iter().any(|(addr, _)| !masks.contains(addr));
    setup.mock.asked_for(|r| matches!(r, Request::Read { pieces } if of_values(pieces))).len()
}

/// The next event after `mark` in which a watch has this value.
fn told(setup: &mut Setup, mark: Mark, n: usize, value: &str) -> Value {
    setup.client.event_where(mark, "technol/watch", |b| b["watches"][n]["value"] == value).unwrap()
}

#[test]
fn values_come_by_themselves_while_the_program_runs() {
    let (mut setup, answer) = watching(json!({ "period": 20, "mechanisms": true, "watches": [
        { "expression": "COUNT" }, { "expression": "KSMP", "mode": "edges" }, { "expression": "SPINDLE" },
        { "expression": "TITLE" }, { "expression": "RLO" }, { "expression": "NOBODY" },
        { "expression": "COUNT", "mode": "extremes", "hex": true }, { "expression": "CNST.5" },
    ]}));
    assert_eq!((&answer["period"], &answer["note"]), (&json!(20), &Value::Null));
    let errors: Vec<bool> =
        answer["watches"].as_array().unwrap().iter().map(|w| w["error"].is_string()).collect();
    assert_eq!(errors, [false, false, false, true, true, true, false, false]);
    let body = told(&mut setup, Mark::START, 0, "300 (012Ch)");
    let cycle = &body["watches"][0]["cycle"];
    assert_eq!(
        body["watches"][0],
        json!({ "expression": "COUNT", "value": "300 (012Ch)", "stale": false, "cycle": cycle })
    );
    assert!(cycle.as_u64().unwrap() > 7000);
    assert_eq!(body["watches"][7]["value"], "5");

    let mark = setup.client.mark();
    set_count(&setup, 301);
    setup.mock.state().memory[sample::INPUTS as usize] = 0;
    let body = told(&mut setup, mark, 0, "301 (012Dh)");
    assert_eq!(body["watches"][6]["value"], "012Dh");
    assert_eq!(
        (&body["watches"][6]["least"], &body["watches"][6]["greatest"]),
        (&json!("012Ch"), &json!("012Dh"))
    );
    let body = setup.client.event_where(mark, "technol/watch", |b| b["watches"][1]["falls"] == 1).unwrap();
    assert_eq!((&body["watches"][1]["value"], &body["watches"][1]["rises"]), (&json!("false"), &json!(0)));

    let body =
        setup.client.event_where(mark, "technol/watch", |b| b["mechanisms"][0]["stale"] == false).unwrap();
    let spindle = &body["mechanisms"][0];
    assert_eq!(
        (&spindle["name"], &spindle["active"], &spindle["line"]),
        (&json!("SPINDLE"), &json!(true), &json!(21))
    );
    assert!(spindle["value"].as_str().unwrap().starts_with("line 21 EX0"), "{spindle}");
    assert_eq!(body["mechanisms"][1]["value"], "at rest");
    assert_eq!(reads(&setup), 0, "nothing was asked for");

    // Nothing more once the client has enough.
    setup.client.request("technol/subscribe", json!({})).unwrap();
    let mark = setup.client.mark();
    set_count(&setup, 302);
    setup.client.set_patience(Duration::from_millis(400));
    assert!(setup.client.event(mark, "technol/watch").is_err());
}

#[test]
fn what_is_looked_at_while_the_program_runs_is_followed_without_asking() {
    let mut setup = Setup::launched(vec![]);
    let value = |setup: &mut Setup| setup.client.evaluate("COUNT", "watch").unwrap();
    assert_eq!(value(&mut setup), "300 (012Ch)");
    assert_eq!(reads(&setup), 1, "nothing follows it yet");
    let deadline = Instant::now() + Duration::from_secs(10);
    while reads(&setup) > 0 {
        assert!(Instant::now() < deadline);
        std::thread::sleep(Duration::from_millis(50));
        setup.mock.state().log.clear();
        value(&mut setup);
    }
    let mark = setup.client.mark();
    set_count(&setup, 301);
    let areas = setup.client.event(mark, "invalidated").unwrap();
    assert_eq!(areas, json!({ "areas": ["variables"] }));
    while value(&mut setup) != "301 (012Dh)" {
        assert!(Instant::now() < deadline, "the view looks again whenever it is told to");
        setup.client.event(mark, "invalidated").unwrap();
    }
    assert_eq!(reads(&setup), 0);

    // What was set is shown at once, though the stream does not know it yet.
    let set = json!({ "expression": "COUNT", "value": "7" });
    setup.client.request("setExpression", set).unwrap();
    assert_eq!(value(&mut setup), "7 (0007h)");
}

#[test]
fn a_value_that_may_be_old_is_marked() {
    let (mut setup, _) = watching(json!({ "period": 20, "watches": [{ "expression": "COUNT" }] }));
    told(&mut setup, Mark::START, 0, "300 (012Ch)");
    let mark = setup.client.mark();
    setup.mock.state().deaf = true;
    let body = told(&mut setup, mark, 0, "300 (012Ch) ?");
    assert_eq!(body["watches"][0]["stale"], true);
    assert_eq!(setup.client.evaluate("COUNT", "watch").unwrap(), "300 (012Ch)", "asked, it is certain");
    setup.mock.state().deaf = false;
    told(&mut setup, mark, 0, "300 (012Ch)");
}

#[test]
fn traced_lines_show_the_registers_behind_them() {
    let mut setup = Setup::launched(vec![]);
    let (main, line) =
        (setup.path("main.plc"), |path: &str, line: u32| json!({ "path": path, "line": line }));
    let lines = json!({ "lines": [line(&main, 20), line(&main, 23), line(&main, 27), line("nowhere.plc", 1), line(&main, 21)] });
    let answer = setup.client.request("technol/trace", lines).unwrap();
    let error = |n: usize| answer["lines"][n]["error"].as_str().map(str::to_owned);
    assert_eq!((error(0), error(1)), (None, None));
    assert!(
        error(2).unwrap().contains("no instruction") && error(3).unwrap().contains("not part"),
        "{answer}"
    );
    assert_eq!(answer["period"], 20);
    let body = setup.client.event(Mark::START, "technol/trace").unwrap();
    let shown = body["lines"].as_array().unwrap();
    assert_eq!(shown.len(), 3);
    assert_eq!(
        shown[0],
        json!({ "path": main, "line": 20, "ran": true, "value": "RLO 1  DR 44 (0000002Ch)", "stale": false,
                "cycle": shown[0]["cycle"] })
    );
    // What did not run since it is traced has no registers to show; what ran earlier has those of then.
    let told = |n: usize| (&shown[n]["line"], &shown[n]["ran"], &shown[n]["value"]);
    assert_eq!(told(1), (&json!(23), &json!(false), &json!("has not run")));
    assert_eq!(told(2), (&json!(21), &json!(false), &json!("RLO 1  DR 44 (0000002Ch)")));
    let mark = setup.client.mark();
    setup.mock.state().memory[sample::COUNT as usize] = 45;
    let changed = |b: &Value| b["lines"][0]["value"] == "RLO 1  DR 45 (0000002Dh)";
    setup.client.event_where(mark, "technol/trace", changed).unwrap();
}

#[test]
fn a_slow_line_is_said_so() {
    let mut setup = Setup::with(Mock::new().on_a_line(960), |_| {});
    let arguments = setup.launch_arguments();
    setup.client.start(arguments, &[]).unwrap();
    let watches = json!([{ "expression": "RATIO" }, { "expression": "SPEED" }, { "expression": "COUNT" }]);
    let answer =
        setup.client.request("technol/subscribe", json!({ "period": 20, "watches": watches })).unwrap();
    assert_eq!(answer["period"], 60);
    let note = answer["note"].as_str().unwrap();
    assert!(note.contains("960 bytes") && note.contains("every 60 ms"), "{note}");
    setup
        .client
        .event_where(Mark::START, "output", |b| b["output"].as_str().unwrap().contains(note))
        .unwrap();
}

#[test]
fn watches_outlive_a_restart() {
    let (mut setup, _) = watching(json!({ "period": 20, "watches": [{ "expression": "COUNT" }] }));
    told(&mut setup, Mark::START, 0, "300 (012Ch)");
    setup.client.request("restart", json!({})).unwrap();
    let mark = setup.client.mark();
    set_count(&setup, 8);
    told(&mut setup, mark, 0, "8 (0008h)");
}

#[test]
fn values_are_marked_while_the_link_is_lost_and_come_again_with_it() {
    let mut setup = Setup::new();
    let mut arguments = setup.launch_arguments();
    arguments["target"] = json!("tcp:127.0.0.1:5700");
    setup.client.start(arguments, &[]).unwrap();
    let watches = json!({ "period": 20, "watches": [{ "expression": "COUNT" }] });
    setup.client.request("technol/subscribe", watches).unwrap();
    told(&mut setup, Mark::START, 0, "300 (012Ch)");
    let mark = setup.client.mark();
    setup.mock.state().cut = true;
    told(&mut setup, mark, 0, "300 (012Ch) ?");
    let mark = setup.client.mark();
    set_count(&setup, 4);
    setup.mock.state().cut = false;
    told(&mut setup, mark, 0, "4 (0004h)");
}

#[test]
fn what_is_forced_is_marked_while_the_program_runs_by_whomever_it_is_forced() {
    let (mut setup, _) = watching(json!({ "period": 20, "watches": [
        { "expression": "P1IN.0" }, { "expression": "KSMP" }, { "expression": "P1IN" }, { "expression": "SPINDLE" },
    ]}));
    let watch = |body: &Value, n: usize| {
        let watch = &body["watches"][n];
        (watch["value"].clone(), watch["port"].clone(), watch["forced"].clone())
    };
    let body = told(&mut setup, Mark::START, 1, "true");
    assert_eq!(watch(&body, 0), (json!("true"), json!("P1IN.0"), Value::Null));
    assert_eq!(watch(&body, 1), (json!("true"), json!("P1IN.0"), Value::Null), "a copy of it");

    let mark = setup.client.mark();
    let answer = setup.client.request("technol/force", json!({ "name": "KSMP", "value": 1 })).unwrap();
    assert_eq!(answer["message"], "P1IN.0 (KSMP) is forced to 1");
    let body = told(&mut setup, mark, 1, "true (forced)");
    assert_eq!(watch(&body, 0).2, json!(1));
    assert!(body["watches"][2]["value"].as_str().unwrap().ends_with("(forced .0=1)"), "{body}");
    assert_eq!(watch(&body, 2).1, Value::Null, "only bits are forced from a menu");
    let list = setup.client.event(mark, "technol/forced").unwrap();
    let ours = json!({ "name": "P1IN.0", "symbol": "KSMP", "value": 1, "own": true, "both": false });
    assert_eq!(list, json!({ "forced": [ours] }));

    // Somebody else forces it to 0, which wins.
    let mark = setup.client.mark();
    setup.mock.state().memory[system::IN_FORCE_LOW as usize] = 1;
    let body = told(&mut setup, mark, 1, "true (forced to 0, which wins over forced to 1)");
    assert_eq!(watch(&body, 1).2, json!(0));

    let mark = setup.client.mark();
    setup.client.request("technol/force", json!({ "name": "KSMP", "value": null })).unwrap();
    told(&mut setup, mark, 1, "true");
    let list = setup.client.event(mark, "technol/forced").unwrap();
    assert_eq!(list, json!({ "forced": [] }));
}

#[test]
fn a_client_that_watches_nothing_is_not_told_what_is_forced() {
    let mut setup = Setup::launched(vec![]);
    let mark = setup.client.mark();
    setup.client.request("technol/force", json!({ "name": "KSMP", "value": 1 })).unwrap();
    setup.client.set_patience(Duration::from_millis(200));
    assert!(setup.client.event(mark, "technol/forced").is_err());
}

/// VS Code forgets all threads of a running program when it is told that they are invalid, and then cannot pause it.
#[test]
fn mechanisms_that_start_and_rest_while_the_program_runs_are_told_as_threads() {
    let mut setup = Setup::launched(vec![]);
    setup.client.request("technol/subscribe", json!({ "mechanisms": true })).unwrap();
    setup.client.request("threads", Value::Null).unwrap();
    let started = |id: i64| move |b: &Value| b["reason"] == "started" && b["threadId"] == id;
    setup.client.event_where(Mark::START, "thread", started(2)).unwrap();
    let mark = setup.client.mark();
    setup.mock.state().sequences[1].active = true;
    setup.client.event_where(mark, "thread", started(3)).unwrap();
    let mark = setup.client.mark();
    setup.mock.state().sequences[1].active = false;
    let rests = |b: &Value| b["reason"] == "exited" && b["threadId"] == 3;
    setup.client.event_where(mark, "thread", rests).unwrap();
    let areas = setup.client.event(mark, "invalidated").unwrap();
    assert_eq!(areas["areas"], json!(["variables"]));
}
