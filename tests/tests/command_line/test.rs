//! `technol test`.

use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};
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

    // A mechanism stands where it begins, and has run as often as what follows.
    let begin = lathe.line("spindle.plc", "MECH_BEGIN SP_CONTROL");
    assert!(record.contains(&format!("\nFN:{begin},SP_CONTROL\n")), "{record}");
    let body = record.lines().find_map(|l| l.strip_prefix(&format!("DA:{},", begin + 1)));
    let called = record.lines().find_map(|l| l.strip_prefix("FNDA:")?.strip_suffix(",SP_CONTROL"));
    assert!(called.is_some() && called == body, "{called:?} {body:?}");

    run_in(&root(), &["test", "examples/minimal"]).ok();
}

#[test]
fn the_suite_of_the_lathe_notices_what_is_broken() {
    for (file, old, new, filter, said) in [
        (
            "include/lathe.inc",
            "EQUI T_DEAD,15",
            "EQUI T_DEAD,3",
            "M4 after M3",
            "expected  SP_CCW after 280 ms",
        ),
        (
            "spindle.plc",
            "FL   1,SP_BRAKE",
            "FL   0,SP_BRAKE",
            "M4 after M3",
            "expected  SP_BRAKE within 300 ms",
        ),
        ("spindle.plc", "ERR_SP_CCW\n", "ERR_SP_CW\n", "a dead contactor", "MESSAGE(403)"),
        (
            "turret.plc",
            "TEX1 -,T_INDEXING,TC_ERROR",
            "TEX1 -,T_INDEXING,TC_END",
            "a strobe that stays",
            "F_TURRET",
        ),
        ("turret.plc", "        FL   0,T_CLAMP\n", "", "T5 M6", "expected  never T_"),
        (
            "chuck.plc",
            "        CA\n        WR   CH_LOCKED",
            "        WR   CH_LOCKED",
            "stays closed",
            "FAILED",
        ),
        (
            "main.plc",
            "FL   0,SP_CW,SP_CCW,T_MOTOR,COOL_PUMP",
            "NOP",
            "emergency stop",
            "actual    SP_CW is 1",
        ),
        ("panel.plc", "        BEX ", "        NOP ", "the display", "expected  SHOW"),
        ("lubrication.plc", "LA   -LUB_PRESS", "LA   LUB_PRESS", "no pressure ends", "MESSAGE(801)"),
        ("coolant.plc", "CNST.30", "CNST.3", "a level that sways", "expected  never COOL_LOW"),
    ] {
        let lathe = Lathe::copy();
        lathe.edit(file, old, new);
        let ran = run(&["test", &lathe.path(""), "--filter", filter]);
        assert_eq!(ran.code, Some(1), "{old}: {ran:?}");
        assert!(ran.out.contains(said), "{old}: `{said}` in:\n{}", ran.out);
    }
}

#[test]
fn the_first_test_of_the_documentation_passes() {
    let page = std::fs::read_to_string(root().join("docs/testing.md")).expect("the page");
    let (_, example) = page.split_once("```toml\n").expect("an example");
    let (example, _) = example.split_once("```").expect("its end");
    let lathe = Lathe::copy();
    let file = lathe.path("tests/spindle.test.toml");
    std::fs::write(&file, example).expect("the copy is writable");
    let out = run(&["test", &file]).ok();
    assert!(out.contains("1 passed"), "{out}");
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
        "WORK waits at plc.plc:8 TEX0 -,10,LATE,55 (LDR GO)",
        "message 55 at plc.plc:14",
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
    run(&["test", &folder.path("plc.test.toml")]).failed(2, &["own.toml:3:9", "P1IM.0"]);
    std::fs::remove_file(folder.path("own.toml")).unwrap();
    run(&["test", &folder.path("plc.test.toml")]).failed(2, &["plc.test.toml:1:11", "own.toml"]);
}

/// A process that ends with this, however its test ends.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn watching_runs_again_after_a_change_of_program_or_test() {
    let folder = project(BAD);
    let mut command = Command::new(technol());
    command.args(["test", &folder.path("plc.plc"), "--watch"]).stdin(Stdio::null()).stdout(Stdio::piped());
    let mut running = Running(command.spawn().expect("the program starts"));
    let (sender, lines) = mpsc::channel();
    let output = running.0.stdout.take().expect("a pipe");
    std::thread::spawn(move || {
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                return;
            }
        }
    });
    let until = |wanted: &str| {
        loop {
            let line =
                lines.recv_timeout(Duration::from_secs(60)).unwrap_or_else(|e| panic!("{wanted}: {e}"));
            if line.contains(wanted) {
                return;
            }
        }
    };
    until("0 passed, 1 failed");
    // At once: a change between the last line of a round and the next look must not be lost.
    folder.write("plc.plc", program(DATA, &MAIN.replace("LDR GO", "LDR -GO"), "").as_bytes());
    until("1 passed");
    until("waiting for a change");
    folder.write("plc.test.toml", [BAD, GOOD].concat().as_bytes());
    until("2 tests in 1 file");
    assert!(running.0.try_wait().expect("a process").is_none(), "it runs until it is ended");
}

#[test]
fn a_test_sees_the_configuration_of_the_project() {
    let folder = Folder::lone(&program(DATA, "", " CNF_GET_INT COUNT,'Count'"));
    folder.write("p.ChannelConfig", b"<C><Plc><PlcParam ID=\"Count\" Type=\"Int\">42</PlcParam></Plc></C>");
    folder.write(
        "plc.test.toml",
        b"[[test]]\nname = \"the parameter is read\"\nstep = [{ wait = 20, expect = { COUNT = 42 } }]\n",
    );
    folder.write("technol.toml", b"[project]\nname = \"p\"\nmain = \"plc.plc\"\n");
    let out = run(&["test", &folder.path("technol.toml")]).ok();
    assert!(out.contains("1 passed"), "{out}");
}
