//! Registers of the 80386 beside those of the PLC.

use serde_json::json;
use technol_dap::client::Mark;

use crate::child::Adapter;
use crate::frame::program;

/// Names and values of the registers where the program stops first, after these lines of MODULE_INIT.
fn registers_after(lines: &str) -> Vec<(String, String)> {
    let folder = tempfile::tempdir().expect("a folder");
    let source = program("VALUE: DS 2", "", &format!("{lines}\n STO VALUE"));
    let path = folder.path().join("registers.plc");
    std::fs::write(&path, &source).expect("written");
    let line = source.lines().position(|line| line == " STO VALUE").expect("the line") + 1;
    let mut adapter = Adapter::start();
    let launch = json!({ "program": path, "target": "embedded", "clock": "virtual" });
    let place = path.to_string_lossy();
    adapter.client.start(launch, &[(&place, &[line as u32])]).expect("the program starts");
    let stop = adapter.client.event(Mark::START, "stopped").expect("a stop");
    let frame = adapter.client.top_frame(stop["threadId"].as_i64().expect("a thread")).expect("a frame");
    assert_eq!(frame["line"], line);
    let rows = adapter.client.scope(&frame, "Registers").expect("registers");
    let text = |row: &serde_json::Value, key: &str| row[key].as_str().expect("a text").to_owned();
    rows.iter().map(|row| (text(row, "name"), text(row, "value"))).collect()
}

#[test]
fn eax_and_the_flags_are_shown_where_a_program_has_such_instructions() {
    let shown = registers_after(" MOV EAX,10003h\n CMP EAX,10003h\n LOD CNST.5");
    let of = |name: &str| shown.iter().find(|(n, _)| n == name).map(|(_, value)| value.as_str());
    assert_eq!(of("EAX"), Some("65539 (00010003h)"), "{shown:?}");
    assert_eq!(of("Flags"), Some("PF ZF"), "{shown:?}");
    assert_eq!(of("DR16"), Some("5 (0005h)"), "{shown:?}");

    let shown = registers_after(" LOD CNST.5");
    assert!(shown.iter().all(|(name, _)| name != "EAX" && name != "Flags"), "{shown:?}");
    assert!(shown.iter().any(|(name, _)| name == "DR16"), "{shown:?}");
}
