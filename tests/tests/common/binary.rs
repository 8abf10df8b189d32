//! The program under test: `TECHNOL_BIN`, or what `cargo build -p technol` makes in the profile of the tests.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

use serde_json::Value;

/// Folder of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests are in the workspace").to_path_buf()
}

/// Path of `technol`.
pub(crate) fn technol() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(|| {
        if let Some(program) = std::env::var_os("TECHNOL_BIN") {
            return PathBuf::from(program);
        }
        // nextest starts a process for each test: one build for a run is enough.
        let run = std::env::var("NEXTEST_RUN_ID").ok();
        if let Some(program) = run.as_deref().and_then(built_in_run) {
            return program;
        }
        let program = build();
        if let Some(run) = run {
            remember(&run, &program);
        }
        program
    })
}

fn build() -> PathBuf {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["build", "--package", "technol", "--message-format=json-render-diagnostics"]);
    if !cfg!(debug_assertions) {
        command.arg("--release");
    }
    let output = command.current_dir(root()).stderr(Stdio::inherit()).output().expect("cargo runs");
    assert!(output.status.success(), "`cargo build -p technol` failed");
    let messages = String::from_utf8_lossy(&output.stdout);
    let mut artifacts = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let program = artifacts.find_map(|message| {
        let ours = message["reason"] == "compiler-artifact" && message["target"]["name"] == "technol";
        message["executable"].as_str().filter(|_| ours).map(PathBuf::from)
    });
    program.expect("cargo names the program it has built")
}

/// Where the run of nextest in progress says what it has built.
fn note() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("technol-of-run")
}

fn built_in_run(run: &str) -> Option<PathBuf> {
    let text = std::fs::read_to_string(note()).ok()?;
    let (id, program) = text.split_once('\n')?;
    (id == run).then(|| PathBuf::from(program))
}

fn remember(run: &str, program: &Path) {
    // Whole or not at all: other tests read it at the same time.
    let mut file = tempfile::NamedTempFile::new_in(env!("CARGO_TARGET_TMPDIR")).expect("a temporary file");
    write!(file, "{run}\n{}", program.display()).expect("the note is written");
    file.persist(note()).expect("the note is in its place");
}
