//! Running commands in the workspace, with a heading and the time each took.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// The root of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_path_buf).unwrap_or_default()
}

/// Where cargo puts what it builds.
pub(crate) fn target_folder() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Runs `cargo` in the root.
pub(crate) fn cargo(what: &str, arguments: &[&str]) -> Result<(), String> {
    step(what, &mut command(arguments))
}

/// `cargo` in the root.
pub(crate) fn command(arguments: &[&str]) -> Command {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let mut command = Command::new(cargo);
    command.args(arguments).current_dir(root());
    command
}

/// Runs `npm` in a folder of the workspace.
pub(crate) fn npm(what: &str, folder: &str, arguments: &[&str]) -> Result<(), String> {
    let program = if cfg!(windows) { "npm.cmd" } else { "npm" };
    step(what, Command::new(program).args(arguments).current_dir(root().join(folder)))
}

/// Whether `program --version` can be run.
pub(crate) fn available(program: &str, arguments: &[&str]) -> bool {
    Command::new(program)
        .args(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

/// Runs a command, with a heading and the time it took.
pub(crate) fn step(what: &str, command: &mut Command) -> Result<(), String> {
    println!("\n=== {what}");
    let start = Instant::now();
    let status = command.status().map_err(|e| format!("{what}: cannot start {command:?}: {e}"))?;
    println!("=== {what}: {status}, {:.1} s", start.elapsed().as_secs_f64());
    if status.success() { Ok(()) } else { Err(format!("{what} failed ({status})")) }
}
