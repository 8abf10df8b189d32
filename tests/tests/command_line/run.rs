//! `technol run`.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::frame::program;
use crate::lathe::Lathe;
use crate::ran::{Folder, Ran, run};

const DATA: &str = "CTL: DFM GO,DONE,STARTED,,,,,\nSMALL: DS 1\nCOUNT: DS 2\nBIG: DS 4\nSEEN: DS 2\nTEXT: STR 8,'lathe'\nROOM: DS 8";
/// Counts its passes; remembers COUNT when GO comes.
const MAIN: &str = "\
 LOD COUNT
 INR
 STO COUNT
 EDGE_H GO
 JL0 NEXT
 LOD COUNT
 STO SEEN
NEXT:
MECH_BEGIN WORK
 FL 1,STARTED
 TIM -,3
 FL 1,DONE
MECH_END WORK";

fn counter() -> Folder {
    Folder::lone(&program(DATA, MAIN, " LOD CNST.1000\n STO COUNT\n LOD CNST.-1\n STO SMALL\n STO BIG"))
}

fn json_run(folder: &Folder, more: &[&str]) -> Ran {
    let path = folder.path("plc.plc");
    run(&[&["run", &path, "--format", "json"], more].concat())
}

fn values(folder: &Folder, more: &[&str]) -> Value {
    let ran = json_run(folder, more);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{ran:?}");
    ran.json()["values"].clone()
}

#[test]
fn the_report_has_exactly_its_keys() {
    let ran = json_run(&counter(), &["--cycles", "7", "--print", "COUNT"]);
    assert_eq!(ran.code, Some(0));
    let report = ran.json();
    let keys: BTreeSet<&str> = report.as_object().expect("an object").keys().map(String::as_str).collect();
    assert_eq!(keys, ["cycles", "values", "registers", "messages", "screen", "fault"].into());
    assert_eq!(report["cycles"], 7);
    assert_eq!(report["values"], json!({ "COUNT": 1007 }));
    assert_eq!(report["messages"], json!([]));
    assert_eq!(report["screen"], json!({ "transient": [], "persistent": [] }));
    assert_eq!(report["fault"], Value::Null);
    let registers = report["registers"].as_object().expect("an object");
    assert_eq!(registers.len(), 3);
    assert!(registers["RLO"].is_boolean() && registers["DR"].is_i64() && registers["DR_REAL"].is_number());
    assert_eq!(registers["DR"], 1007);
}

#[test]
fn values_have_the_type_of_what_they_are_read_from() {
    let names = "GO,STARTED,SMALL,COUNT,BIG,WORD.SMALL,BYTE.COUNT,BYTE.(COUNT+1),HIGH.COUNT,REAL.ROOM,QWRD.ROOM,TEXT,\
                 CTL.DONE,WORK,CTL";
    let set = ["--set", "REAL.ROOM=2.5", "--set", "GO=1", "--print", names];
    let values = values(&counter(), &[&["--cycles", "1"], &set[..]].concat());
    let expected = json!({
        "GO": true, "STARTED": false, "SMALL": 255, "COUNT": 1001, "BIG": 4_294_967_295_u32,
        // COUNT follows SMALL: 1001 is 3E9h.
        "WORD.SMALL": 0xE9FF, "BYTE.COUNT": 0xE9, "BYTE.(COUNT+1)": 3, "HIGH.COUNT": 3,
        "REAL.ROOM": 2.5, "QWRD.ROOM": 0x4004_0000_0000_0000_u64, "TEXT": "lathe",
        "CTL.DONE": false, "WORK": false, "CTL": 1,
    });
    assert_eq!(values, expected);
}

#[test]
fn a_value_is_set_once_before_its_cycle_and_after_module_init() {
    let folder = counter();
    for (set, cycles, name, expected) in [
        // MODULE_INIT has written 1000 before.
        ("COUNT=5", "1", "COUNT", 6),
        ("COUNT=5@0", "4", "COUNT", 9),
        ("COUNT=5@3", "3", "COUNT", 1003),
        ("COUNT=5@3", "4", "COUNT", 6),
        ("COUNT=5@3", "10", "COUNT", 12),
        // The edge comes in cycle 4: COUNT was 1000 before cycle 0 and is incremented first.
        ("GO=1@4", "10", "SEEN", 1005),
        ("COUNT=0FFFFh", "1", "COUNT", 0),
        ("BYTE.(COUNT+1)=0", "1", "COUNT", 0xE9),
    ] {
        let values = values(&folder, &["--cycles", cycles, "--set", set, "--print", name]);
        assert_eq!(values[name], expected, "--set {set} --cycles {cycles}");
    }
    let two = ["--set", "COUNT=1@2", "--set", "COUNT=50@4", "--cycles", "6", "--print", "COUNT"];
    assert_eq!(values(&folder, &two)["COUNT"], 52, "the option may be given several times");
}

#[test]
fn a_mechanism_is_activated_by_its_name() {
    let folder = counter();
    for (cycles, expected) in [
        ("2", json!({ "WORK": false, "STARTED": false, "DONE": false })),
        ("3", json!({ "WORK": true, "STARTED": true, "DONE": false })),
        // The TIM waits the cycles 2, 3 and 4.
        ("5", json!({ "WORK": true, "STARTED": true, "DONE": false })),
        ("6", json!({ "WORK": false, "STARTED": true, "DONE": true })),
    ] {
        let print = ["--set", "WORK=1@2", "--print", "WORK,STARTED,DONE", "--cycles", cycles];
        assert_eq!(values(&folder, &print), expected, "after {cycles} cycles");
    }
}

#[test]
fn what_does_not_exist_or_does_not_fit_ends_with_2_before_anything_runs() {
    let folder = counter();
    for (option, value, said) in [
        ("--print", "NOBODY", "NOBODY"),
        ("--print", "CUONT", "did you mean COUNT?"),
        ("--print", "COUNT,FLOAT.COUNT", "FLOAT"),
        ("--print", "ROOM", "ROOM"),
        ("--set", "NOBODY=1", "NOBODY"),
        ("--set", "COUNT", "NAME=VALUE"),
        ("--set", "COUNT=70000", "65535"),
        ("--set", "COUNT=many", "many"),
        ("--set", "GO=2", "true, false"),
        ("--set", "COUNT=1@soon", "soon"),
        ("--fault", "nothing", "nothing"),
        ("--press", "any-key", "any-key"),
    ] {
        let ran = json_run(&folder, &["--cycles", "1", option, value]);
        ran.failed(2, &[said]);
        assert_eq!(ran.out, "", "{option} {value}");
    }
    run(&["run", &folder.path("plc.plc")]).failed(2, &["--cycles"]);
    run(&["run", &folder.path("plc.plc"), "--cycles", "-1"]).failed(2, &["cycles"]);
    let broken = Folder::lone(&program("", " LDR NOBODY\n JL0 L\nL:", ""));
    json_run(&broken, &["--cycles", "1"]).failed(1, &["plc.plc:5:6", "NOBODY"]);
}

#[test]
fn the_lathe_reports_its_messages_with_the_cycle() {
    let lathe = Lathe::copy();
    let arguments = |more: &'static [&'static str]| {
        let folder = lathe.path("");
        let mut all = vec!["run".to_owned(), folder, "--format".to_owned(), "json".to_owned()];
        all.extend(more.iter().map(|s| (*s).to_owned()));
        run(&all.iter().map(String::as_str).collect::<Vec<_>>())
    };
    let good = arguments(&["--cycles", "1000", "--print", "SP_TURNS,T_ACTUAL,READY"]).json();
    assert_eq!(good["values"], json!({ "SP_TURNS": 1, "T_ACTUAL": 5, "READY": true }));
    let messages = good["messages"].as_array().expect("a list");
    assert_eq!(messages.len(), 1, "{good}");
    assert_eq!([&messages[0]["number"], &messages[0]["set"]], [&json!(901), &json!(true)]);
    assert_eq!(messages[0]["line"], lathe.line("turret.plc", "ESET INFO_TOOL"));
    assert!(messages[0]["cycle"].as_u64().is_some_and(|c| (100..1000).contains(&c)));
    assert_eq!(
        good,
        arguments(&["--cycles", "1000", "--print", "SP_TURNS,T_ACTUAL,READY"]).json(),
        "the same again"
    );

    let bad = arguments(&["--cycles", "1000", "--fault", "ccw-contactor-dead", "--print", "F_SPINDLE,READY"])
        .json();
    assert_eq!(bad["values"], json!({ "F_SPINDLE": true, "READY": false }));
    let numbers: Vec<&Value> =
        bad["messages"].as_array().expect("a list").iter().map(|m| &m["number"]).collect();
    assert_eq!(numbers, [901, 403]);
    assert_eq!(bad["fault"], Value::Null, "a fault of the machine is none of the PLC");

    let stop =
        arguments(&["--cycles", "300", "--press", "emergency-stop@60", "--release", "emergency-stop@90"])
            .json();
    let first = &stop["messages"][0];
    assert_eq!([&first["number"], &first["cycle"]], [100, 60]);

    // Forgotten: a wrong name tells the right ones.
    arguments(&["--cycles", "1", "--fault", "x"]).failed(2, &["turret-jammed", "no-lubrication"]);
}

#[test]
fn a_fault_of_the_program_ends_with_3_and_names_the_place() {
    let main = "MECH_BEGIN WORKER\n LOD VALUE\n EX\n EX\n DIVB ZERO\n STO VALUE\nMECH_END WORKER";
    let source = program("VALUE: DS 2\nZERO: DS 2", main, " FL 1,WORKER\n LOD CNST.9\n STO VALUE");
    let folder = Folder::lone(&source);
    let line = source.lines().position(|l| l.contains("DIVB")).expect("the division") + 1;
    let ran = json_run(&folder, &["--cycles", "100", "--print", "VALUE"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(3), ""), "{ran:?}");
    let report = ran.json();
    assert_eq!(
        report["fault"],
        json!({
            "message": "division by zero", "file": "plc.plc", "line": line, "module": "MODULE_MAIN",
            "mechanism": "WORKER", "cycle": 2,
        })
    );
    assert_eq!([&report["cycles"], &report["values"]["VALUE"]], [2, 9], "up to the fault; readable after it");

    let human = run(&["run", &folder.path("plc.plc"), "--cycles", "100"]);
    assert_eq!(human.code, Some(3));
    assert!(human.out.contains(&format!("division by zero at plc.plc:{line} in WORKER")), "{}", human.out);

    let endless = program("CTL: DFM NEVER,,,,,,,", "AGAIN:\n LDR NEVER\n JL0 AGAIN", "");
    let line = endless.lines().position(|l| l.contains("JL0")).expect("the jump") + 1;
    let ran = json_run(&Folder::lone(&endless), &["--cycles", "5"]);
    assert_eq!(ran.code, Some(3), "an endless loop is stopped: {ran:?}");
    let fault = &ran.json()["fault"];
    assert!([line - 1, line].iter().any(|l| fault["line"] == *l), "{fault}");
}

#[test]
fn real_time_takes_its_time() {
    let start = Instant::now();
    let ran = json_run(&counter(), &["--cycles", "26", "--realtime", "--print", "COUNT"]);
    assert_eq!(ran.json()["values"]["COUNT"], 1026);
    assert!(start.elapsed() >= Duration::from_millis(25 * 20), "{:?}", start.elapsed());
}

#[test]
fn the_report_for_people_names_all_of_it() {
    let out = run(&["run", &counter().path("plc.plc"), "--cycles", "3", "--print", "COUNT,GO,TEXT"]).ok();
    for part in ["3 cycles", "COUNT  1003", "GO     false", "TEXT   'lathe'", "RLO", "DR 1003 (0x3eb)"] {
        assert!(out.contains(part), "`{part}` in:\n{out}");
    }
}

#[test]
fn a_machine_that_cannot_be_read_is_an_error_with_its_place() {
    let source = program("", " NOP", "");
    let manifest = b"[machine]\nfile = \"plant.toml\"\n";
    let folder = Folder::with(&[("technol.toml", manifest), ("main.plc", source.as_bytes())]);
    let go = || run(&["run", &folder.path(""), "--cycles", "1"]);
    go().failed(2, &["plant.toml", "machine"]);
    folder.write("plant.toml", b"[[contact]]\noutput = \"P0OUT.0\"\ninptu = \"P1IN.0\"\n");
    go().failed(2, &["plant.toml:3", "inptu"]);
    folder.write("plant.toml", b"[[contact]]\noutput = \"P99OUT.0\"\ninput = \"P1IN.0\"\n");
    go().failed(2, &["plant.toml:2", "P99OUT.0"]);
}
