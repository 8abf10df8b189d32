//! `technol test`.

use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;

use crate::binary::{root, technol};
use crate::frame::program;
use crate::lathe::Lathe;
use crate::ran::{Folder, run, run_in};

const DATA: &str = "CTL: DFM GO,DONE,,,,,,\nCOUNT: DS 2";
const MAIN: &str = "\
MECH_BEGIN WORK
 LDR GO
 TEX0 -,10,LATE,55
 LOD COUNT
 INR
 STO COUNT
 JUM READY
LATE:
 ESET
READY:
MECH_END WORK";

const GOOD: &str = "[[test]]\nname = \"it counts\"\nstep = [{ set = { GO = 1, WORK = 1 }, wait = 20, expect = { COUNT = 1 } }]\n";
const BAD: &str = "[[test]]\nname = \"it comes late\"\n\n  [[test.step]]\n  set = { WORK = 1 }\n  until = \"COUNT == 1\"\n  at-most = \"15 cycles\"\n";

/// A lone program with these tests.
fn project(tests: &str) -> Folder {
    let folder = Folder::lone(&program(DATA, MAIN, ""));
    folder.write("plc.test.toml", tests.as_bytes());
    folder
}

#[test]
fn the_suite_of_the_lathe_passes_and_reaches_every_state() {
    let folder = tempfile::tempdir().expect("a folder");
    let (junit, lcov) = (folder.path().join("results.xml"), folder.path().join("lathe.info"));
    let out = run_in(
        &root(),
        &[
            "test",
            "examples/lathe",
            "--junit",
            &junit.to_string_lossy(),
            "--coverage",
            &lcov.to_string_lossy(),
        ],
    )
    .ok();
    assert!(!out.contains("FAILED") && !out.contains('\u{1b}'), "{out}");
    assert!(!out.contains("never"), "every state of every mechanism: {out}");
    let passed = out.lines().filter(|line| line.starts_with("  ok ")).count();
    assert!(passed > 40, "{out}");
    assert!(out.contains(&format!("\n{passed} passed; ")), "{out}");

    let xml = std::fs::read_to_string(&junit).expect("the results");
    assert_eq!(xml.matches("<testcase ").count(), passed);
    assert!(xml.contains(&format!("<testsuites name=\"lathe\" tests=\"{passed}\" failures=\"0\"")), "{xml}");

    let info = std::fs::read_to_string(&lcov).expect("the coverage");
    assert_eq!(info.matches("SF:").count(), info.matches("end_of_record").count());
    let record =
        info.split("end_of_record").find(|r| r.contains("spindle.plc")).expect("a record for each file");
    let lathe = Lathe::copy();
    let line = lathe.line("spindle.plc", "TIM  CNT_DEAD,T_DEAD");
    let hits = record.lines().find_map(|l| l.strip_prefix(&format!("DA:{line},"))).expect("a line with code");
    assert!(hits.parse::<u32>().is_ok_and(|hits| hits > 10), "{hits}");
    assert_eq!(record.lines().filter(|l| l.starts_with("DA:") && l.ends_with(",0")).count(), 0, "{record}");

    run_in(&root(), &["test", "examples/minimal"]).ok();
}

#[test]
fn a_failed_test_tells_the_step_and_what_led_to_it() {
    let folder = project(&[GOOD, BAD].concat());
    let ran = run(&["test", &folder.path("plc.plc"), "--junit", &folder.path("out.xml")]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(1), ""), "{ran:?}");
    let place = format!("{}:7:3: step 1, at 300 ms, cycle 15", folder.path("plc.test.toml"));
    for part in [
        "2 tests in 1 file",
        "  ok      it counts",
        "  FAILED  it comes late",
        &place,
        "expected  COUNT == 1 within 300 ms",
        "actual    COUNT is 0",
        "WORK waits at plc.plc:7 TEX0 -,10,LATE,55 (LDR GO)",
        "message 55 at plc.plc:13",
        "WORK is idle",
        "1 passed, 1 failed; 0.32 s of PLC time",
    ] {
        assert!(ran.out.contains(part), "`{part}` in:\n{}", ran.out);
    }
    let xml = std::fs::read_to_string(folder.path("out.xml")).expect("the results");
    assert!(
        xml.contains("<failure type=\"failure\" message=\"expected COUNT == 1 within 300 ms, COUNT is 0\">"),
        "{xml}"
    );

    // The same in whatever number of threads.
    let lines = |out: &str| -> Vec<String> {
        out.lines().filter(|line| !line.contains("of PLC time")).map(str::to_owned).collect()
    };
    let one = run(&["test", &folder.path("plc.plc"), "--jobs", "1"]);
    assert_eq!(lines(&one.out), lines(&ran.out));
    let filtered = run(&["test", &folder.path("plc.plc"), "--filter", "COUNTS"]).ok();
    assert!(filtered.contains("1 passed, 1 left out by the filter"), "{filtered}");
    let single = run(&["test", &folder.path("plc.test.toml"), "--filter", "counts"]).ok();
    assert!(single.contains("1 passed"), "{single}");
}

#[test]
fn what_is_broken_ends_with_2_and_nothing_runs() {
    let folder =
        project(&[GOOD, "[[test]]\nname = \"b\"\nstep = [{ set = { CONT = 1 }, wiat = 5 }]\n"].concat());
    let ran = run(&["test", &folder.path("plc.plc")]);
    let file = folder.path("plc.test.toml");
    ran.failed(
        2,
        &[
            &format!("{file}:6:19: error: CONT is not declared in this program; did you mean COUNT?"),
            &format!("{file}:6:31: error: `wiat` is no key of a step; there is: name, start"),
            "no test was run: 2 mistakes",
        ],
    );
    assert_eq!(ran.out, "");

    let none = Folder::lone(&program(DATA, MAIN, ""));
    run(&["test", &none.path("plc.plc")]).failed(2, &["no tests", "*.test.toml"]);
    run(&["test", &none.path("nowhere")]).failed(2, &["nowhere"]);
    run(&["test", &none.path("nowhere.test.toml")]).failed(2, &["nowhere.test.toml", "no such file"]);
    let good = project(GOOD);
    run(&["test", &good.path("plc.plc"), "--filter", "nothing"]).failed(2, &["--filter nothing", "1 test"]);
    run(&["test", &good.path("plc.plc"), "--jobs", "0"]).failed(2, &["--jobs"]);
    run(&["test", &good.path("plc.plc"), "--junit", &good.path("no/such/folder.xml")])
        .failed(2, &["folder.xml"]);
    let broken = Folder::lone(&program("", " LDR NOBODY\n JL0 L\nL:", ""));
    broken.write("plc.test.toml", GOOD.as_bytes());
    run(&["test", &broken.path("plc.plc")]).failed(1, &["plc.plc:5:6", "NOBODY"]);
}

#[test]
fn a_test_may_bring_its_own_machine_or_none() {
    let folder = project(
        "machine = \"own.toml\"\n[[test]]\nname = \"own\"\nstep = [{ press = \"go\", wait = 40, expect = { P1IN.0 = 1 } }]\n\
         [[test]]\nname = \"none\"\nmachine = \"none\"\nstep = [{ set = { P1IN.0 = 1 }, wait = 40, expect = { P1IN.0 = 1 } }]\n",
    );
    folder.write("own.toml", b"[[key]]\nname = \"go\"\ninput = \"P1IN.0\"\n");
    run(&["test", &folder.path("plc.test.toml")]).ok();
    folder.write("own.toml", b"[[key]]\nname = \"go\"\ninput = \"P1IM.0\"\n");
    run(&["test", &folder.path("plc.test.toml")]).failed(2, &["plc.test.toml:1:11", "own.toml:3", "P1IM.0"]);
}

#[test]
fn watching_runs_again_after_a_change_of_program_or_test() {
    let folder = project(BAD);
    let mut child = Command::new(technol())
        .args(["test", &folder.path("plc.plc"), "--watch"])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let (sender, lines) = mpsc::channel();
    let output = child.stdout.take().expect("a pipe");
    std::thread::spawn(move || {
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                return;
            }
        }
    });
    let until = |wanted: &str| loop {
        let line = lines.recv_timeout(Duration::from_secs(60)).unwrap_or_else(|e| panic!("{wanted}: {e}"));
        if line.contains(wanted) {
            return;
        }
    };
    until("0 passed, 1 failed");
    until("waiting for a change");
    // Ten cycles later the mechanism gives up; now the program does without GO.
    folder.write("plc.plc", program(DATA, &MAIN.replace("LDR GO", "LDR -GO"), "").as_bytes());
    until("1 passed");
    until("waiting for a change");
    folder.write("plc.test.toml", [BAD, GOOD].concat().as_bytes());
    until("2 tests in 1 file");
    child.kill().expect("it runs until it is ended");
    child.wait().expect("it has ended");
    assert!(Path::new(&folder.path("plc.plc")).exists());
}
