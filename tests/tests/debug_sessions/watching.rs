//! Watching a program that runs, on every kind of target.

use serde_json::{Value, json};
use technol_dap::client::Mark;

use crate::child::{Adapter, Site};
use crate::lathe::Lathe;

fn number(value: &Value) -> u64 {
    let text = value.as_str().expect("a value");
    text.split(' ').next().and_then(|n| n.parse().ok()).unwrap_or_else(|| panic!("{text}"))
}

/// CYCLES counts the cycles of the lathe, so each sample proves itself.
fn watch(site: &Site, lathe: &Lathe) {
    let mut adapter = Adapter::start();
    let client = &mut adapter.client;
    client.start(site.launch(lathe), &[]).expect("the program starts");
    let watches = json!([{ "expression": "CYCLES" }, { "expression": "SP_CONTROL" }, { "expression": "P1IN.SP_STAND" }]);
    let arguments = json!({ "period": 20, "mechanisms": true, "watches": watches });
    let answer = client.request("technol/subscribe", arguments).expect("a subscription");
    assert_eq!((&answer["period"], &answer["note"]), (&json!(20), &Value::Null), "{answer}");
    let counted = |b: &Value| b["watches"][0]["stale"] == false && b["watches"][1]["stale"] == false;
    let first = client.event_where(Mark::START, "technol/watch", counted).expect("values");
    let mark = client.mark();
    let cycle = |b: &Value| b["watches"][0]["cycle"].as_u64().unwrap_or(0);
    let later = client
        .event_where(mark, "technol/watch", |b| counted(b) && cycle(b) > cycle(&first) + 20)
        .expect("more values");
    let ahead = |body: &Value| number(&body["watches"][0]["value"]).wrapping_sub(cycle(body));
    assert_eq!(ahead(&first), ahead(&later), "value and cycle belong together: {first} {later}");
    assert_ne!(later["watches"][1]["value"], "…", "{later}");
    let names: Vec<&str> =
        later["mechanisms"].as_array().expect("all").iter().filter_map(|m| m["name"].as_str()).collect();
    assert!(names.contains(&"SP_CONTROL") && names.contains(&"TURRET_CHANGE"), "{names:?}");

    // What is looked at follows without being asked for.
    let value = client.evaluate("CYCLES", "watch").expect("a value");
    assert!(number(&json!(value)) >= number(&later["watches"][0]["value"]));

    // The line that counts, behind it DR; one that only an emergency stop reaches has nothing to show.
    let (path, line) = (lathe.path("main.plc"), lathe.line("main.plc", "LOD  CYCLES"));
    let unreached = lathe.line("main.plc", "FL   1,STOP_EMERGENCY_REQ");
    let lines = json!({ "lines": [{ "path": path, "line": line }, { "path": path, "line": unreached }] });
    let answer = client.request("technol/trace", lines).expect("a trace");
    assert_eq!(answer["lines"][0]["error"], Value::Null, "{answer}");
    let ran = |b: &Value| b["lines"][0]["ran"] == true;
    let body = client.event_where(Mark::START, "technol/trace", ran).expect("registers");
    assert!(body["lines"][0]["value"].as_str().expect("text").starts_with("RLO "), "{body}");
    assert_eq!(
        [&body["lines"][1]["ran"], &body["lines"][1]["value"]],
        [&json!(false), &json!("has not run")]
    );

    let body = client.go("pause", 1).expect("a pause");
    assert_eq!(body["reason"], "pause");
    client.disconnect(json!({})).expect("the adapter closes the connection");
}

#[test]
fn a_running_program_is_watched_on_the_embedded_target() {
    watch(&Site::embedded(), &Lathe::copy());
}

#[test]
fn a_running_program_is_watched_over_tcp() {
    let lathe = Lathe::copy();
    watch(&Site::tcp(&lathe), &lathe);
}

#[test]
fn a_running_program_is_watched_over_a_serial_line() {
    let lathe = Lathe::copy();
    let Some(site) = Site::serial(&lathe) else { return };
    watch(&site, &lathe);
}

/// Numbers that need 64 bits, or are real, are not cut to the 32 bits that most lines work with.
#[test]
fn a_traced_line_shows_the_register_it_works_with() {
    let lathe = Lathe::copy();
    lathe.edit("main.plc", "BLOCKS:     DS 2", "BIG:        DS 4\nBLOCKS:     DS 2");
    let code = [
        ("LOD  CNST.100000", "DR 100000 (000186A0h)"),
        ("STO  BIG", "DR 100000 (000186A0h)"),
        ("LOD  BIG", "DR 100000 (000186A0h)"),
        ("MULB BIG", "DR64 10000000000 (00000002540BE400h)"),
        ("FL   0,BLOCK_BROKEN", "DR64 10000000000 (00000002540BE400h)"),
        ("LOD  CNST.2.5", "DR_REAL 2.5"),
        ("AD   CNST.0.25", "DR_REAL 2.75"),
    ];
    let lines = code.map(|(line, _)| line).join("\n        ");
    lathe.edit("main.plc", "        LOD  CYCLES\n", &format!("        {lines}\n        LOD  CYCLES\n"));
    let first = lathe.line("main.plc", "LOD  CNST.100000");

    let mut adapter = Adapter::start();
    let client = &mut adapter.client;
    client.start(Site::embedded().launch(&lathe), &[]).expect("the program starts");
    let path = lathe.path("main.plc");
    let places = (0..code.len() as u32).map(|n| json!({ "path": path, "line": first + n }));
    let places: Vec<Value> = places.collect();
    client.request("technol/trace", json!({ "lines": places })).expect("a trace");
    let ran = |b: &Value| b["lines"].as_array().is_some_and(|l| l.iter().all(|l| l["ran"] == true));
    let body = client.event_where(Mark::START, "technol/trace", ran).expect("registers");
    for (shown, (line, expected)) in body["lines"].as_array().expect("lines").iter().zip(code) {
        let shown = shown["value"].as_str().expect("text");
        assert_eq!(shown.split_once("  ").map(|(_, register)| register), Some(expected), "{line}: {body}");
    }
    client.disconnect(json!({})).expect("the adapter closes the connection");
}
