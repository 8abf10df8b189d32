//! The bare library of `debug-target/bare` and a C program that uses it, built once for each test process.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// Folder of the bare crate, which is no member of the workspace.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("debug-target").join("bare")
}

/// Builds the library; a room or a dependency that links the standard library makes this fail.
fn library() -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("..").join("bare");
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["build", "--locked", "--manifest-path"]).arg(folder().join("Cargo.toml"));
    // A flag for the tests (coverage, say) may need the standard library.
    command.arg("--target-dir").arg(&target).env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    let output = command.output().expect("cargo runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "the library without a standard library cannot be built:\n{said}");
    target.join("debug").join("libtechnol_bare.a")
}

/// Whether `program --version` can be run.
pub(crate) fn available(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// The program `replay`, in front of the library; `None`, loudly, without a C compiler.
pub(crate) fn replay() -> Option<&'static Path> {
    static PROGRAM: OnceLock<Option<PathBuf>> = OnceLock::new();
    PROGRAM.get_or_init(|| example("replay")).as_deref()
}

/// The program `control`, in the same way.
pub(crate) fn control() -> Option<&'static Path> {
    static PROGRAM: OnceLock<Option<PathBuf>> = OnceLock::new();
    PROGRAM.get_or_init(|| example("control")).as_deref()
}

fn example(name: &str) -> Option<PathBuf> {
    let library = library();
    if cfg!(windows) || !available("cc") {
        eprintln!("SKIPPED: no C compiler (`cc`): the library was built, but nothing was run from C");
        return None;
    }
    // Tests run at the same time, each in a process of its own.
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}-{}", std::process::id()));
    let mut command = Command::new("cc");
    command.args(["-std=c11", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O1", "-o"]).arg(&program);
    command.arg(folder().join("example").join(format!("{name}.c"))).arg(library);
    let output = command.output().expect("cc runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "the C program cannot be built:\n{said}");
    Some(program)
}

/// Text of the header.
pub(crate) fn header() -> String {
    let path = folder().join("include").join("technol.h");
    std::fs::read_to_string(path).expect("the header of the library")
}
