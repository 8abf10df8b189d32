//! `cargo xtask fuzz`: looks for texts that break the front end.

use std::process::Command;

use crate::run::{available, root, step};

/// Minutes when none are given.
const MINUTES: u32 = 30;

/// What the fuzzer is told: texts are short, ten seconds are a hang, and 4 GB too much memory.
const LIMITS: &[&str] = &["-max_len=4096", "-len_control=0", "-timeout=10", "-rss_limit_mb=4096"];

/// Runs the fuzz target for a number of minutes, in words.
pub(crate) fn fuzz(minutes: Option<&str>) -> Result<(), String> {
    let minutes = match minutes {
        None => MINUTES,
        Some(word) => match word.parse() {
            Ok(minutes @ 1..=100_000) => minutes,
            _ => return Err(format!("{word} is no number of minutes from 1 to 100000")),
        },
    };
    if !available("cargo", &["fuzz", "--version"]) {
        return Err(
            "cargo-fuzz is missing: `cargo install cargo-fuzz`; it needs a C++ compiler too, and runs on \
                    Linux and macOS"
                .to_owned(),
        );
    }
    let mut command = Command::new("cargo");
    command
        .args(["fuzz", "run", "--fuzz-dir", ".", "--sanitizer", "none", "--debug-assertions", "front_end"])
        // New texts go into the first folder; the ones kept as tests are a beginning.
        .args(["corpus/front_end", "../analysis/tests/corpus", "--"])
        .args(LIMITS)
        .arg(format!("-max_total_time={}", u64::from(minutes) * 60))
        .current_dir(root().join("fuzz"))
        // cargo-fuzz asks the compiler for options that a stable one has, but hides.
        .env("RUSTC_BOOTSTRAP", "1");
    let found = root().join("fuzz/corpus/front_end");
    std::fs::create_dir_all(&found).map_err(|error| format!("cannot make {}: {error}", found.display()))?;
    step(&format!("fuzzing for {minutes} minutes"), &mut command).map_err(|error| {
        format!("{error}; a text that breaks something is in fuzz/artifacts/front_end, see CONTRIBUTING.md")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_of_minutes_is_refused() {
        for word in ["0", "-1", "x", "1.5", "100001"] {
            assert_eq!(fuzz(Some(word)), Err(format!("{word} is no number of minutes from 1 to 100000")));
        }
    }
}
