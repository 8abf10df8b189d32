//! `cargo xtask test`: everything that has to hold before a change lands.

use crate::generate;
use crate::run::{self, available, cargo, npm};

/// Folders with an npm package and the scripts to run in each.
const PACKAGES: &[(&str, &str, &[&str])] = &[
    ("VS Code extension", "editors/vscode", &["build", "test"]),
    ("debug adapter, driven by Microsoft's test client", "tests/debug-adapter", &["test"]),
];

/// What the tests in real editors need, with the variable that names another program, and what is skipped without it.
const EDITORS: &[(&str, &str, &str)] = &[
    ("nvim", "TECHNOL_NVIM", "the test in Neovim: nvim (0.10 or newer) is not installed"),
    ("hx", "TECHNOL_HX", "the test in Helix: hx is not installed"),
    ("tmux", "TECHNOL_TMUX", "the test in Helix: tmux is not installed"),
];

/// Runs all checks and tests, cheapest first, and says at the end what was skipped.
pub(crate) fn test() -> Result<(), String> {
    let mut skipped = Vec::new();
    cargo("formatting", &["fmt", "--all", "--check"])?;
    cargo("lints", &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"])?;
    generate::generate(true)?;
    bare()?;
    if available("cargo", &["nextest", "--version"]) {
        cargo("tests", &["nextest", "run", "--workspace", "--no-fail-fast"])?;
    } else {
        println!("cargo-nextest is not installed: using the slower `cargo test`");
        cargo("tests", &["test", "--workspace", "--no-fail-fast", "--lib", "--bins", "--tests"])?;
    }
    cargo("documentation tests", &["test", "--workspace", "--doc", "--quiet"])?;
    if available(if cfg!(windows) { "npm.cmd" } else { "npm" }, &["--version"]) {
        // The Node tests drive the real binary.
        let packages = ["build", "--package", "technol", "--package", "technol-tests", "--bins"];
        cargo("the binaries for the editors' tests", &packages)?;
        for (what, folder, scripts) in PACKAGES {
            npm(&format!("{what}: packages"), folder, &["ci", "--no-audit", "--no-fund"])?;
            for script in *scripts {
                npm(&format!("{what}: {script}"), folder, &["run", script])?;
            }
        }
    } else {
        skipped.push("the editors' tests: Node.js (20 or newer) with npm is not installed");
    }
    for (name, variable, what) in EDITORS {
        let program = std::env::var(variable).unwrap_or_else(|_| (*name).to_owned());
        if !available(&program, &[if *name == "tmux" { "-V" } else { "--version" }]) {
            skipped.push(what);
        }
    }
    println!();
    for what in &skipped {
        println!("SKIPPED {what}");
    }
    println!("all tests passed{}", if skipped.is_empty() { "" } else { " but the skipped ones" });
    Ok(())
}

/// The rooms for a controller, without a standard library. With it the C compiler's tests are less of a surprise too.
fn bare() -> Result<(), String> {
    let manifest = "debug-target/bare/Cargo.toml";
    cargo("formatting of the C library", &["fmt", "--manifest-path", manifest, "--check"])?;
    let target = run::target_folder().join("bare");
    let target = target.to_string_lossy();
    let place = ["--locked", "--manifest-path", manifest, "--target-dir", &target];
    let lints = [&["clippy"], &place[..], &["--", "-D", "warnings"]].concat();
    cargo("lints of the C library", &lints)?;
    cargo("the runtime without a standard library", &[&["build"], &place[..]].concat())
}

/// Builds the VS Code extension.
pub(crate) fn package() -> Result<(), String> {
    npm("VS Code extension: packages", "editors/vscode", &["ci", "--no-audit", "--no-fund"])?;
    npm("VS Code extension: .vsix", "editors/vscode", &["run", "package"])
}
