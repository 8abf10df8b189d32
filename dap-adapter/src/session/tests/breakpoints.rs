use super::*;
use technol_wire::message::{Event, Request};

/// `line: verified message`, as a table.
fn shown(breakpoints: &Value) -> Vec<String> {
    let list = breakpoints.as_array().unwrap();
    let text = |b: &Value| {
        let message = b["message"].as_str().map(|m| format!(" {m}")).unwrap_or_default();
        format!("{}: {}{message}", b["line"], b["verified"])
    };
    list.iter().map(text).collect()
}

#[test]
fn breakpoints_go_to_code_or_say_why_not() {
    let mut setup = Setup::launched(vec![]);
    let path = setup.path("main.plc");
    let breakpoints = setup.client.set_breakpoints(&path, &[12, 22, 10, 9, 28, 29, 41, 39, 34, 43]).unwrap();
    assert_eq!(
        shown(&breakpoints),
        [
            "12: true",
            "23: true line 22 has no code; moved to the next line that has",
            "11: true line 10 has no code; moved to the next line that has",
            "9: false no code follows this line in its section",
            "28: false a module of the 1 ms raster takes no break-points: it cannot be held",
            "29: false a module of the 1 ms raster takes no break-points: it cannot be held",
            "41: false MODULE_CONT never stops: it keeps running while the debugger holds the rest",
            "39: false no code follows this line in its section",
            "34: true",
            "43: false no code follows this line in its section",
        ]
    );
    let pcs = |lines: &[u32]| {
        let mut pcs: Vec<u32> = lines.iter().map(|l| sample::pc(*l)).collect();
        pcs.sort_unstable();
        Request::SetBreakpoints { pcs }
    };
    let sent = setup.mock.asked_for(|r| matches!(r, Request::SetBreakpoints { .. }));
    assert_eq!(sent.last(), Some(&pcs(&[12, 23, 11, 34])));
}

#[test]
fn what_the_target_refuses_is_not_verified() {
    let mut setup = Setup::launched(vec![]);
    let path = setup.path("main.plc");
    // The mock refuses line 20, and takes four at most.
    let breakpoints = setup.client.set_breakpoints(&path, &[11, 20, 12, 13, 23]).unwrap();
    let full = "the target has no room for more break-points; remove one";
    assert_eq!(
        shown(&breakpoints),
        [
            "11: true".into(),
            format!("20: false {full}"),
            "12: true".into(),
            "13: true".into(),
            format!("23: false {full}")
        ]
    );
}

#[test]
fn outside_debug_regions_nothing_stops_unless_the_project_allows_it() {
    let mut setup = Setup::with(Mock::new(), |b| b.only_debug_regions = true);
    let arguments = setup.launch_arguments();
    let path = setup.path("main.plc");
    let placed = setup.client.start(arguments, &[(&path, &[14, 15])]).unwrap();
    let shown = shown(&placed[0]);
    assert_eq!(shown[0], "14: true");
    assert!(shown[1].starts_with("15: false outside a DEBUG region"), "{shown:?}");
}

#[test]
fn early_breakpoints_are_placed_when_the_program_is_there() {
    let mut setup = Setup::new();
    setup.client.initialize().unwrap();
    let path = setup.path("main.plc");
    let early = setup.client.set_breakpoints(&path, &[19]).unwrap();
    assert_eq!(shown(&early), ["19: false waits for the program to be loaded"]);
    let arguments = setup.launch_arguments();
    setup.client.request("launch", arguments).unwrap();
    let changed = setup.client.event(Mark::START, "breakpoint").unwrap();
    assert_eq!(changed["reason"], "changed");
    assert_eq!(changed["breakpoint"]["id"], early[0]["id"]);
    assert_eq!(changed["breakpoint"]["verified"], true);
}

#[test]
fn numbers_stay_with_their_lines() {
    let mut setup = Setup::launched(vec![]);
    let path = setup.path("main.plc");
    let ids = |b: &Value| b.as_array().unwrap().iter().map(|b| b["id"].as_i64().unwrap()).collect::<Vec<_>>();
    let first = setup.client.set_breakpoints(&path, &[11, 12]).unwrap();
    let second = setup.client.set_breakpoints(&path, &[12, 13]).unwrap();
    assert_eq!((ids(&first), ids(&second)), (vec![1, 2], vec![2, 3]));
    setup.client.set_breakpoints(&path, &[]).unwrap();
    let sent = setup.mock.asked_for(|r| matches!(r, Request::SetBreakpoints { .. }));
    assert_eq!(sent.last(), Some(&Request::SetBreakpoints { pcs: vec![] }));
}

#[test]
fn a_file_that_changed_since_the_build_is_pointed_out() {
    let mut setup = Setup::launched(vec![]);
    let path = setup.path("main.plc");
    std::fs::write(&path, "; something else\n").unwrap();
    let breakpoints = setup.client.set_breakpoints(&path, &[12]).unwrap();
    assert_eq!(
        shown(&breakpoints),
        ["12: true the file has changed since the build; restart to bring lines and code together"]
    );
}

#[test]
fn files_are_found_by_any_spelling_of_their_path() {
    let mut setup = Setup::launched(vec![]);
    let roundabout = setup.path("sub/../main.plc");
    let breakpoints = setup.client.set_breakpoints(&roundabout, &[12]).unwrap();
    assert_eq!(shown(&breakpoints), ["12: true"]);
    #[cfg(unix)]
    {
        let link = setup.path("link.plc");
        std::os::unix::fs::symlink(setup.path("main.plc"), &link).unwrap();
        assert_eq!(shown(&setup.client.set_breakpoints(&link, &[13]).unwrap()), ["13: true"]);
    }
    let foreign = setup.path("other.plc");
    let breakpoints = setup.client.set_breakpoints(&foreign, &[1]).unwrap();
    assert_eq!(shown(&breakpoints), ["1: false the file does not belong to the program"]);
}

#[test]
fn conditions_are_refused_in_words() {
    let mut setup = Setup::launched(vec![]);
    let arguments = json!({
        "source": { "path": setup.path("main.plc") },
        "breakpoints": [{ "line": 12, "logMessage": "x" }, { "line": 13, "hitCondition": "3" }, { "line": 14, "condition": "" }],
    });
    let body = setup.client.request("setBreakpoints", arguments).unwrap();
    let verified: Vec<bool> =
        body["breakpoints"].as_array().unwrap().iter().map(|b| b["verified"] == true).collect();
    assert_eq!(verified, [false, false, true]);
}

#[test]
fn without_debugging_none_is_armed() {
    let mut setup = Setup::new();
    let mut arguments = setup.launch_arguments();
    arguments["noDebug"] = json!(true);
    arguments["stopOnEntry"] = json!(true);
    let path = setup.path("main.plc");
    setup.client.start(arguments, &[(&path, &[12])]).unwrap();
    for sent in setup.mock.asked_for(|r| matches!(r, Request::SetBreakpoints { .. })) {
        assert_eq!(sent, Request::SetBreakpoints { pcs: vec![] });
    }
    let started = setup.mock.asked_for(|r| matches!(r, Request::Start { .. }));
    assert_eq!(started, [Request::Start { cold: true, stop_on_entry: false }]);
}

#[test]
fn a_stop_names_the_breakpoint_that_was_hit() {
    let mut setup = Setup::launched(vec![]);
    let path = setup.path("main.plc");
    setup.client.set_breakpoints(&path, &[11, 19]).unwrap();
    let mark = setup.client.mark();
    setup.mock.say(Event::Stopped(stop_in_spindle(StopReason::Breakpoint, 19)));
    let stopped = setup.client.event(mark, "stopped").unwrap();
    assert_eq!(stopped["hitBreakpointIds"], json!([2]));
}

#[test]
fn locations_and_sources_can_be_asked_for() {
    let mut setup = Setup::launched(vec![]);
    let source = json!({ "path": setup.path("main.plc") });
    let body = setup
        .client
        .request("breakpointLocations", json!({ "source": source, "line": 20, "endLine": 24 }))
        .unwrap();
    let lines: Vec<i64> =
        body["breakpoints"].as_array().unwrap().iter().map(|b| b["line"].as_i64().unwrap()).collect();
    assert_eq!(lines, [20, 21, 23, 24]);
    let body = setup.client.request("loadedSources", Value::Null).unwrap();
    assert_eq!(body["sources"][1], json!({ "name": "turret.plc", "path": setup.path("turret.plc") }));
    let body = setup.client.request("source", json!({ "source": source, "sourceReference": 0 })).unwrap();
    assert!(body["content"].as_str().unwrap().starts_with("; line 1\n"));
}
