//! Where the program stops and where it cannot.

use serde_json::json;
use technol_dap::client::{Client, Mark};

use crate::child::{Adapter, Site};
use crate::lathe::Lathe;

/// The lathe before its first statement, on a target of its own for each test.
fn at_entry(site: &Site, lathe: &Lathe) -> Adapter {
    let mut launch = site.launch(lathe);
    launch["stopOnEntry"] = json!(true);
    let mut adapter = Adapter::start();
    adapter.client.start(launch, &[]).expect("the program starts");
    adapter
}

#[test]
fn stop_on_entry_holds_before_the_first_statement() {
    let lathe = Lathe::copy();
    let first = lathe.line("main.plc", "EQ   CNST.1");
    for site in [Site::embedded(), Site::tcp(&lathe)] {
        let mut adapter = at_entry(&site, &lathe);
        let stop = adapter.client.event(Mark::START, "stopped").expect("a stop");
        assert_eq!([&stop["reason"], &stop["threadId"]], [&json!("entry"), &json!(1)]);
        let frame = adapter.client.top_frame(1).expect("a frame");
        assert_eq!([&frame["name"], &frame["line"]], [&json!("MODULE_INIT"), &json!(first)]);
        assert_eq!(adapter.client.evaluate("CYCLES", "watch").expect("a value"), "0 (00000000h)");
        let stop = adapter.client.go("next", 1).expect("a step");
        assert_eq!(stop["reason"], "step");
        assert_eq!(adapter.client.top_frame(1).expect("a frame")["line"], first + 1);
        // A restart begins again at the same place.
        let mark = adapter.client.mark();
        adapter.client.request("restart", json!({})).expect("restart");
        let stop = adapter.client.event(mark, "stopped").expect("a stop");
        assert_eq!(stop["reason"], "entry");
        assert_eq!(adapter.client.top_frame(1).expect("a frame")["line"], first);
    }
}

#[test]
fn break_points_are_moved_or_refused_with_the_reason() {
    let lathe = Lathe::copy();
    let mut adapter = at_entry(&Site::embedded(), &lathe);
    let speed = lathe.line("main.plc", "; ---- speed of the spindle");
    for (line, verified, placed, said) in [
        (lathe.line("main.plc", "EDGE_H SP_PULSE"), false, None, "1 ms raster"),
        (lathe.line("main.plc", "LDR  -P3IN.B5"), false, None, "MODULE_CONT"),
        (lathe.line("main.plc", "BLOCKS:     DS 2"), false, None, "no code"),
        (9_999, false, None, "no code"),
        (speed, true, Some(speed + 1), "moved"),
    ] {
        let answer = adapter.client.set_breakpoints(&lathe.path("main.plc"), &[line]).expect("an answer");
        assert_eq!(answer[0]["verified"], verified, "{line}: {answer}");
        assert_eq!(answer[0]["line"], placed.unwrap_or(line), "{line}: {answer}");
        assert!(answer[0]["message"].as_str().is_some_and(|m| m.contains(said)), "{said}: {answer}");
    }
    let foreign = std::env::temp_dir().join("foreign.plc");
    let answer = adapter.client.set_breakpoints(&foreign.to_string_lossy(), &[3]).expect("an answer");
    assert_eq!(answer[0]["verified"], false);
    assert!(answer[0]["message"].as_str().is_some_and(|m| m.contains("does not belong")), "{answer}");
}

#[test]
fn without_debug_everywhere_only_debug_regions_take_break_points() {
    let lathe = Lathe::copy();
    lathe.edit("technol.toml", "everywhere = true", "everywhere = false");
    lathe.edit("chuck.plc", "MODULE_MAIN\n", "MODULE_MAIN\n        DEBUG\n        NOP\n        DEBUG OFF\n");
    let mut adapter = at_entry(&Site::embedded(), &lathe);
    let inside = lathe.line("chuck.plc", "        NOP");
    let mut verified = |file: &str, line: u32| {
        let answer = adapter.client.set_breakpoints(&lathe.path(file), &[line]).expect("an answer");
        (answer[0]["verified"] == true, answer[0]["message"].as_str().unwrap_or_default().to_owned())
    };
    assert_eq!(verified("chuck.plc", inside), (true, String::new()));
    let (placed, why) = verified("spindle.plc", lathe.line("spindle.plc", "LDR  SP_REQ_STOP "));
    assert!(!placed && why.contains("DEBUG"), "{why}");
}

#[test]
fn a_list_of_break_points_replaces_the_one_before() {
    let lathe = Lathe::copy();
    let file = lathe.path("main.plc");
    let lines = ["LOD  CYCLES", "LDR  -READY", "MOVE BYTE.(FAULTS+1),FAULTS"]
        .map(|text| lathe.line("main.plc", text));
    let mut adapter = Adapter::start();
    let client = &mut adapter.client;
    client.start(Site::embedded().launch(&lathe), &[(&file, &lines)]).expect("the program starts");
    let [a, b, c] = lines;
    client.event(Mark::START, "stopped").expect("a stop");
    let mut seen = vec![line(client)];
    seen.extend((0..4).map(|_| next_stop(client)));
    assert_eq!(seen, [a, b, c, a, b], "in every cycle, in the order of execution");
    client.set_breakpoints(&file, &[a]).expect("placed");
    assert_eq!([next_stop(client), next_stop(client)], [a, a]);
    client.set_breakpoints(&file, &[a, c]).expect("placed");
    assert_eq!([next_stop(client), next_stop(client)], [c, a]);
}

/// The line that the program is held at.
fn line(client: &mut Client) -> u32 {
    client.top_frame(1).expect("a frame")["line"].as_u64().expect("a line") as u32
}

/// Goes on to the next break-point: its line.
fn next_stop(client: &mut Client) -> u32 {
    assert_eq!(client.go("continue", 1).expect("a stop")["reason"], "breakpoint");
    line(client)
}
