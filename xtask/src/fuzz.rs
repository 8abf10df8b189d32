//! `cargo xtask fuzz`: looks for inputs that break something.

use std::process::Command;

use crate::run::{available, root, step};

/// Minutes when none are given.
const MINUTES: u32 = 30;

/// What the fuzzer is told: inputs are short, ten seconds are a hang, and 4 GB too much memory.
const LIMITS: &[&str] = &["-len_control=0", "-timeout=10", "-rss_limit_mb=4096"];

/// A fuzz target.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Target {
    name: &'static str,
    /// Longest input in bytes.
    len: u32,
    /// Inputs that are kept as tests, seen from the folder `fuzz`.
    kept: &'static str,
}

const TARGETS: &[Target] = &[
    Target { name: "front_end", len: 4096, kept: "../analysis/tests/corpus" },
    Target { name: "image", len: 512, kept: "corpus/image" },
    Target { name: "link_frames", len: 1024, kept: "corpus/link_frames" },
    Target { name: "link_messages", len: 1024, kept: "corpus/link_messages" },
    Target { name: "link_target", len: 2048, kept: "corpus/link_target" },
    Target { name: "machine", len: 4096, kept: "corpus/machine" },
    Target { name: "scenario", len: 4096, kept: "corpus/scenario" },
];

/// Target and minutes from words: either may be left out.
pub(crate) fn choose(words: &[&str]) -> Result<(&'static Target, u32), String> {
    let (name, minutes) = match words {
        [] => (None, None),
        [name, minutes] => (Some(*name), Some(*minutes)),
        [word] if word.starts_with(|c: char| c.is_ascii_alphabetic()) => (Some(*word), None),
        [word] => (None, Some(*word)),
        _ => return Err("fuzz takes a target and a number of minutes".to_owned()),
    };
    let target = match name {
        None => &TARGETS[0],
        Some(name) => TARGETS.iter().find(|target| target.name == name).ok_or_else(|| {
            let names: Vec<&str> = TARGETS.iter().map(|target| target.name).collect();
            format!("{name} is no fuzz target; there is: {}", names.join(", "))
        })?,
    };
    match minutes.map(str::parse) {
        None => Ok((target, MINUTES)),
        Some(Ok(minutes @ 1..=100_000)) => Ok((target, minutes)),
        Some(_) => Err(format!("{} is no number of minutes from 1 to 100000", minutes.unwrap_or_default())),
    }
}

/// Runs a fuzz target for a number of minutes.
pub(crate) fn fuzz(words: &[&str]) -> Result<(), String> {
    let (target, minutes) = choose(words)?;
    if !available("cargo", &["fuzz", "--version"]) {
        return Err(
            "cargo-fuzz is missing: `cargo install cargo-fuzz`; it needs a C++ compiler too, and runs on \
                    Linux and macOS"
                .to_owned(),
        );
    }
    let found = format!("found/{}", target.name);
    let mut command = Command::new("cargo");
    command
        .args(["fuzz", "run", "--fuzz-dir", ".", "--sanitizer", "none", "--debug-assertions", target.name])
        // New inputs go into the first folder; the ones kept as tests are a beginning.
        .args([&found, target.kept, "--"])
        .args(LIMITS)
        .arg(format!("-max_len={}", target.len))
        .arg(format!("-max_total_time={}", u64::from(minutes) * 60))
        .current_dir(root().join("fuzz"))
        // cargo-fuzz asks the compiler for options that a stable one has, but hides.
        .env("RUSTC_BOOTSTRAP", "1");
    let folder = root().join("fuzz").join(&found);
    std::fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    step(&format!("fuzzing {} for {minutes} minutes", target.name), &mut command).map_err(|error| {
        format!(
            "{error}; an input that breaks something is in fuzz/artifacts/{}, see CONTRIBUTING.md",
            target.name
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn target_and_minutes_may_be_left_out() {
        let chosen = |words: &[&str]| choose(words).map(|(target, minutes)| (target.name, minutes));
        assert_eq!(chosen(&[]), Ok(("front_end", 30)));
        assert_eq!(chosen(&["5"]), Ok(("front_end", 5)));
        assert_eq!(chosen(&["image"]), Ok(("image", 30)));
        assert_eq!(chosen(&["scenario", "2"]), Ok(("scenario", 2)));
        let unknown = "imag is no fuzz target; there is: front_end, image, link_frames, link_messages, link_target, machine, scenario";
        assert_eq!(chosen(&["imag"]), Err(unknown.to_owned()));
    }

    #[test]
    fn what_is_no_number_of_minutes_is_refused() {
        for word in ["0", "-1", "1.5", "100001", "1x"] {
            let refused = Err(format!("{word} is no number of minutes from 1 to 100000"));
            assert_eq!(choose(&[word]), refused);
            assert_eq!(choose(&["image", word]), refused);
        }
    }

    #[test]
    fn every_target_is_built_and_its_kept_inputs_are_there() {
        let manifest =
            std::fs::read_to_string(root().join("fuzz/Cargo.toml")).expect("the crate of the targets");
        assert_eq!(manifest.matches("[[bin]]").count(), TARGETS.len());
        for target in TARGETS {
            assert!(manifest.contains(&format!("name = \"{}\"", target.name)), "{target:?}");
            assert!(root().join("fuzz").join(target.kept).is_dir(), "{target:?}");
        }
    }
}
