//! `technol demo`, and output that nobody reads to its end.

use std::process::{Command, Stdio};

use crate::binary::technol;
use crate::lathe::Lathe;
use crate::ran::run;

#[test]
fn the_demonstration_runs_through_and_is_plain_in_a_pipe() {
    let lathe = Lathe::copy();
    for arguments in [&["demo"][..], &["demo", &lathe.path("")]] {
        let out = run(arguments).ok();
        assert!(!out.contains('\u{1b}'), "no escape codes");
        for part in
            ["Check", "Build", "Registers", "Mechanisms", "SP_CONTROL", "CNT_DEAD", "SP_TURNS", "Try next"]
        {
            assert!(out.contains(part), "`{part}` in:\n{out}");
        }
        let line = lathe.line("spindle.plc", "TIM  CNT_DEAD,T_DEAD");
        assert!(out.contains(&format!("spindle.plc:{line}")), "{out}");
    }
    let file = lathe.path("memory.bin");
    run(&["demo", &lathe.path(""), "--backup", &file]).ok();
    assert_eq!(std::fs::read(file).expect("the memory is kept").len(), 10_000);
    run(&["demo", &lathe.path("nowhere")]).failed(2, &["nowhere", "examples/lathe"]);
    lathe.edit("spindle.plc", "LDR  SP_REQ_STOP ", "LDR  NOBODY ");
    run(&["demo", &lathe.path("")]).failed(1, &["1 error"]);
}

#[test]
fn a_closed_pipe_is_no_crash() {
    let lathe = Lathe::copy();
    let folder = lathe.path("");
    lathe.edit("spindle.plc", "LDR  SP_REQ_STOP ", "LDR  NOBODY ");
    for arguments in [
        &["check", &folder][..],
        &["check", &folder, "--format", "json"],
        &["explain", "LDR"],
        &["run", &folder, "--cycles", "5"],
        &["build", &folder],
        &["demo"],
        &["--help"],
    ] {
        let mut child = Command::new(technol())
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        // As `| head -0`.
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!said.contains("panicked"), "{arguments:?}: {said}");
        assert!(output.status.code().is_some_and(|c| c < 3), "{arguments:?}: {:?}", output.status);
    }
}
