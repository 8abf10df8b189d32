//! `technol check`.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use crate::frame::program;
use crate::lathe::Lathe;
use crate::ran::{Folder, Ran, run, run_in};

fn found(path: &str) -> Ran {
    run(&["check", path, "--format", "json"])
}

/// File name, line, column, end column and code of each finding.
fn places(ran: &Ran) -> Vec<(String, u64, u64, u64, String)> {
    let number = |v: &Value| v.as_u64().expect("a number");
    let place = |v: &Value| {
        let file = v["file"].as_str().expect("a file").replace('\\', "/");
        let file = file.rsplit('/').next().expect("a name").to_owned();
        let code = v["code"].as_str().expect("a code").to_owned();
        (file, number(&v["line"]), number(&v["column"]), number(&v["endColumn"]), code)
    };
    ran.json_lines().iter().map(place).collect()
}

#[track_caller]
fn expect(ran: &Ran, code: i32, expected: &[(&str, u64, u64, u64, &str)]) {
    assert_eq!(ran.code, Some(code), "{ran:?}");
    let places = places(ran);
    let places: Vec<_> = places.iter().map(|(f, l, c, e, k)| (f.as_str(), *l, *c, *e, k.as_str())).collect();
    assert_eq!(places, expected, "{}", ran.out);
}

#[test]
fn a_clean_project_says_so_and_ends_with_0() {
    let lathe = Lathe::copy();
    for path in [lathe.folder().to_string_lossy().into_owned(), lathe.path("technol.toml")] {
        let out = run(&["check", &path]).ok();
        assert!(out.starts_with("clean:") && out.contains("8 files"), "{out}");
        assert_eq!(run(&["check", &path, "--format", "json"]).ok(), "");
    }
}

#[test]
fn a_mistake_in_the_machine_file_is_found_there() {
    let lathe = Lathe::copy();
    lathe.edit(
        "machine.toml",
        "output = \"P0OUT.0\"\ninput = \"P1IN.0\"",
        "output = \"P0OUT.0\"\ninput = \"P999IN.0\"",
    );
    let out = run(&["check", &lathe.path("technol.toml"), "--format", "json"]);
    expect(&out, 1, &[("machine.toml", 14, 9, 9, "T0014")]);
    std::fs::remove_file(lathe.path("machine.toml")).expect("removed");
    let out = run(&["check", &lathe.path("technol.toml"), "--format", "json"]);
    expect(&out, 1, &[("machine.toml", 1, 1, 1, "T0014")]);
}

#[test]
fn without_a_path_the_project_is_the_present_folder() {
    let lathe = Lathe::copy();
    let out = run_in(&lathe.folder(), &["check"]).ok();
    assert!(out.starts_with("clean:"), "{out}");
    run_in(&lathe.folder(), &["build"]).ok();
    assert!(lathe.folder().join("out").join("lathe.tplc").is_file());
    run_in(&lathe.folder(), &["run", "--cycles", "1"]).ok();
    lathe.edit("spindle.plc", "LDR  SP_REQ_STOP ", "LDR  NOBODY ");
    let finding = run_in(&lathe.folder(), &["check", "--format", "json"]).json();
    let file = finding["file"].as_str().expect("a file");
    assert!(lathe.folder().join(file).is_file(), "a path from here: {file}");
}

#[test]
fn a_mistake_is_one_json_object_a_line_and_ends_with_1() {
    let source = program(
        "CTL: DFM DOOR,,,,,,,\nVALUE: DS 2",
        " LDR DOR\n WR DOOR\n STO VALUE2\n LDR DOOR\n FL1 0,DOOR\n LOD VALUE\n STO VALUE",
        "",
    );
    let folder = Folder::lone(&source);
    let path = folder.path("plc.plc");
    let ran = found(&path);
    assert_eq!((ran.code, ran.err.as_str()), (Some(1), ""));
    let objects = ran.json_lines();
    let keys = ["code", "column", "endColumn", "endLine", "file", "line", "message", "severity"];
    for object in &objects {
        let object = object.as_object().expect("an object");
        assert_eq!(object.keys().map(String::as_str).collect::<BTreeSet<_>>(), keys.into());
    }
    let first = &objects[0];
    assert_eq!(first["file"].as_str().map(str::to_owned), Some(path.clone()));
    assert_eq!([&first["line"], &first["endLine"]], [6, 6]);
    assert_eq!(
        [&first["column"], &first["endColumn"]],
        [6, 9],
        "1-based, the end is behind the last character"
    );
    assert_eq!([&first["severity"], &first["code"]], ["error", "T0301"]);
    assert!(first["message"].as_str().is_some_and(|m| m.contains("DOR") && m.contains("DOOR")), "{first}");
    expect(&ran, 1, &[("plc.plc", 6, 6, 9, "T0301"), ("plc.plc", 8, 6, 12, "T0301")]);

    let human = run(&["check", &path]);
    assert_eq!(human.code, Some(1));
    for part in ["plc.plc:6:6: error T0301", "    \u{20}LDR DOR\n", "^^^\n", "2 errors"] {
        assert!(human.out.contains(part), "`{part}` in:\n{}", human.out);
    }
}

#[test]
fn warnings_alone_end_with_0_and_lints_change_severities() {
    let source = program("VALUE: DS 1", " LOD VALUE\n EQ CNST.255\n JL0 L\n INR\nL:\n STO VALUE", "");
    let manifest = |lints: &str| format!("[project]\nmain = \"main.plc\"\n[lints]\n{lints}\n");
    let folder = Folder::with(&[("main.plc", source.as_bytes()), ("technol.toml", manifest("").as_bytes())]);
    let ran = found(&folder.path(""));
    assert_eq!(ran.code, Some(0), "{ran:?}");
    let finding = ran.json();
    assert_eq!(finding["severity"], "warning");
    let code = finding["code"].as_str().expect("a code").to_owned();
    for (severity, exit, shown) in [
        ("off", 0, None),
        ("hint", 0, Some("hint")),
        ("warning", 0, Some("warning")),
        ("error", 1, Some("error")),
    ] {
        folder.write("technol.toml", manifest(&format!("{code} = \"{severity}\"")).as_bytes());
        let ran = found(&folder.path(""));
        assert_eq!(ran.code, Some(exit), "{severity}: {ran:?}");
        let severities: Vec<Value> = ran.json_lines().iter().map(|f| f["severity"].clone()).collect();
        assert_eq!(severities, shown.map(|s| json!(s)).into_iter().collect::<Vec<_>>());
    }
}

#[test]
fn wrong_usage_and_missing_files_end_with_2() {
    let folder = Folder::with(&[]);
    run(&["check", &folder.path("nowhere")]).failed(2, &["nowhere", "technol.toml"]);
    run(&["check", ".", "--format", "xml"]).failed(2, &["xml", "human", "json"]);
    run(&["check", "one", "two"]).failed(2, &["two"]);
    run(&["chek"]).failed(2, &["chek", "check"]);
    run(&[]).failed(2, &["check", "build", "run", "target", "dap", "lsp", "explain", "demo"]);
}

#[test]
fn files_that_cannot_be_read_are_findings_where_they_are_named() {
    let folder = Folder::with(&[("technol.toml", b"[project]\nfiles = [\"more.plc\"]\n")]);
    let source = program("", " NOP", "");
    folder.write("main.plc", source.as_bytes());
    let ran = found(&folder.path(""));
    expect(&ran, 1, &[("technol.toml", 2, 10, 20, "T0004")]);
    assert!(ran.out.contains("more.plc"), "{}", ran.out);

    let with_include = format!("T_INCLUDE gone.inc\n{source}");
    let folder = Folder::with(&[("plc.plc", with_include.as_bytes())]);
    expect(&found(&folder.path("plc.plc")), 1, &[("plc.plc", 1, 11, 19, "T0009")]);

    // A folder that is no project: the remedy is told.
    let ran = found(&Folder::with(&[]).path(""));
    assert_eq!(ran.code, Some(1));
    assert!(ran.json()["message"].as_str().is_some_and(|m| m.contains(".plc")), "{ran:?}");
}

#[test]
fn includes_that_go_round_in_a_circle_are_reported_once() {
    let source = format!("T_INCLUDE a.inc\n{}", program("", " NOP", ""));
    let folder = Folder::with(&[
        ("plc.plc", source.as_bytes()),
        ("a.inc", b"; first\nT_INCLUDE b.inc\n"),
        ("b.inc", b"EQUI ONE,1\nT_INCLUDE a.inc\n"),
    ]);
    let ran = found(&folder.path("plc.plc"));
    expect(&ran, 1, &[("b.inc", 2, 11, 16, "T0010")]);
    for name in ["a.inc", "b.inc"] {
        assert!(ran.json()["message"].as_str().is_some_and(|m| m.contains(name)), "{ran:?}");
    }
    let itself = format!("T_INCLUDE plc.plc\n{}", program("", " NOP", ""));
    let ran = found(&Folder::lone(&itself).path("plc.plc"));
    assert_eq!((ran.code, places(&ran).len()), (Some(1), 1), "{ran:?}");
}

#[test]
fn bytes_that_are_no_text_are_found_where_they_are() {
    let source = program("", " NOP", "").into_bytes();
    // 0xF8 is ř in Windows-1250 and no UTF-8; 0x81 is nothing in Windows-1250.
    for (encoding, comment, expected) in [
        ("utf-8", &b"; dve\xF8e\n"[..], Some((6, "UTF-8"))),
        ("windows-1250", b"; dve\x81e\n", Some((6, "Windows-1250"))),
        ("windows-1250", b"; dve\xF8e\n", None),
        ("cp852", b"; dve\xFDe\n", None),
        ("auto", b"; dve\xF8e\n", None),
        ("auto", "; dveře\n".as_bytes(), None),
    ] {
        let manifest = format!("[project]\nencoding = \"{encoding}\"\n");
        let text = [comment, &source].concat();
        let folder = Folder::with(&[("technol.toml", manifest.as_bytes()), ("main.plc", &text)]);
        let ran = found(&folder.path(""));
        match expected {
            Some((column, name)) => {
                expect(&ran, 1, &[("main.plc", 1, column, column + 1, "T0013")]);
                assert!(ran.out.contains(name) && ran.out.contains("encoding"), "{}", ran.out);
            }
            None => expect(&ran, 0, &[]),
        }
    }
}

#[test]
fn any_bytes_are_checked_without_a_crash() {
    // A generator of its own, so that a failure can be repeated.
    let mut state = 0x2545_F491_4F6C_DD1D_u64;
    let mut bytes = Vec::new();
    for _ in 0..4096 {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        bytes.push(state as u8);
    }
    let folder = Folder::with(&[("noise.plc", &bytes), ("empty.plc", b""), ("zeros.plc", &[0; 300])]);
    for name in ["noise.plc", "empty.plc", "zeros.plc"] {
        let ran = found(&folder.path(name));
        assert_eq!((ran.code, ran.err.as_str()), (Some(1), ""), "{name}");
        assert!(!places(&ran).is_empty());
    }
}

#[test]
fn mistakes_in_the_manifest_are_found_in_the_manifest() {
    let source = program("", " NOP", "");
    for (manifest, line, column, code, severity, said) in [
        ("[project]\nmian = \"main.plc\"\n", 2, 1, "T0002", "warning", "main"),
        ("[project]\nname = \"x\n", 2, 10, "T0001", "error", "TOML"),
        ("[project]\nencoding = \"latin2\"\n", 2, 12, "T0003", "error", "windows-1250"),
        ("[project]\nname = 5\n", 2, 8, "T0003", "error", "name"),
        ("[target]\naddress = \"usb\"\n", 2, 11, "T0003", "error", "serial:"),
        ("[lints]\nT9999 = \"off\"\n", 2, 1, "T0008", "warning", "T9999"),
        ("[project]\nmain = \"none.plc\"\n", 2, 8, "T0004", "error", "none.plc"),
    ] {
        let folder = Folder::with(&[("technol.toml", manifest.as_bytes()), ("main.plc", source.as_bytes())]);
        let ran = found(&folder.path(""));
        let findings = places(&ran);
        let place: Vec<_> = findings.iter().map(|(f, l, c, _, k)| (f.as_str(), *l, *c, k.as_str())).collect();
        assert_eq!(place, [("technol.toml", line, column, code)], "{manifest}{}", ran.out);
        let finding = ran.json();
        assert_eq!(finding["severity"], severity, "{manifest}");
        assert_eq!(ran.code, Some(i32::from(severity == "error")), "{manifest}");
        assert!(finding["message"].as_str().is_some_and(|m| m.contains(said)), "{said}: {finding}");
    }
}
