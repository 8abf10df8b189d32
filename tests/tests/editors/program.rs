//! Editors that are installed, or not.

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// An editor takes no longer than this for its test.
const PATIENCE: Duration = Duration::from_secs(300);

/// What an editor's program is called, and the environment variable that names another one.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    pub(crate) variable: &'static str,
}

/// One that is there.
pub(crate) struct Found {
    pub(crate) path: PathBuf,
    pub(crate) version: (u32, u32),
}

/// The program; without it says that its test is skipped. One that was named has to be there.
pub(crate) fn find(program: &Program) -> Option<Found> {
    find_as(program, "--version")
}

/// The same for one that is asked for its version in another way.
pub(crate) fn find_as(program: &Program, ask: &str) -> Option<Found> {
    let named = std::env::var_os(program.variable).map(PathBuf::from);
    let path = named.clone().unwrap_or_else(|| PathBuf::from(program.name));
    let output = Command::new(&path).arg(ask).stdin(Stdio::null()).output();
    match output {
        Ok(output) if output.status.success() => {
            Some(Found { path, version: version(&String::from_utf8_lossy(&output.stdout)) })
        }
        _ => {
            assert_eq!(named, None, "{} names a program that does not run", program.variable);
            eprintln!("SKIPPED: {} is not installed; {} may name it", program.name, program.variable);
            None
        }
    }
}

/// The first two numbers of `NVIM v0.10.4` or `helix 25.01.1`.
fn version(text: &str) -> (u32, u32) {
    let word = text.split_whitespace().map(|w| w.trim_start_matches('v'));
    let mut number = word.filter(|w| w.starts_with(|c: char| c.is_ascii_digit())).flat_map(|w| w.split('.'));
    let mut next = || number.next().and_then(|n| n.parse().ok()).unwrap_or(0);
    (next(), next())
}

/// The PATH with the folder of the `technol` under test in front.
pub(crate) fn path_with_technol() -> OsString {
    let folder = crate::binary::technol().parent().map(PathBuf::from);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = folder.into_iter().chain(std::env::split_paths(&path));
    std::env::join_paths(folders).expect("folders without separators")
}

/// Runs a program to its end; one that hangs is ended.
pub(crate) fn run(mut command: Command) -> Output {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the editor starts");
    let deadline = Instant::now() + PATIENCE;
    while child.try_wait().expect("a child").is_none() {
        if Instant::now() >= deadline {
            child.kill().expect("the editor ends");
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    child.wait_with_output().expect("what it said")
}

#[test]
fn versions_are_recognised() {
    assert_eq!(version("NVIM v0.10.4\nBuild type: Release"), (0, 10));
    assert_eq!(version("helix 25.01.1 (e7ac2fcd)"), (25, 1));
    assert_eq!(version("something else"), (0, 0));
}
