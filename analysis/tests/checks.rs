//! Fixtures: programs with marked mistakes, and programs without any.
//!
//! A marker is a comment line under the line it marks: `;   ^^^^ T0301 part of the message`. The carets stand under
//! the columns of the diagnostic. A fixture that begins with `;use NAME` stands inside the complete program
//! `fixtures/frame/NAME.plc`, at its line `;here`. Every diagnostic must have a marker and every marker a diagnostic; what
//! is `quiet` may stay without.

mod markers;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use markers::{check, difference, read};

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures")
}

/// The program a fixture stands for.
fn complete(text: &str) -> String {
    let Some(name) = text.lines().next().and_then(|line| line.strip_prefix(";use ")) else {
        return text.to_string();
    };
    let frame = read(&fixtures().join(format!("frame/{}.plc", name.trim())));
    let body = &text[text.find('\n').map_or(text.len(), |at| at + 1)..];
    assert!(frame.contains(";here\n"), "the frame {name} has no line ;here");
    frame.replacen(";here\n", body, 1)
}

#[test]
fn every_fixture_gives_exactly_the_marked_diagnostics() {
    let mut report = String::new();
    let mut count = 0;
    let mut entries: Vec<_> =
        std::fs::read_dir(fixtures()).expect("the folder").map(|e| e.expect("an entry").path()).collect();
    entries.sort();
    for path in entries.iter().filter(|p| p.extension().is_some_and(|e| e == "plc")) {
        let text = complete(&read(path));
        let found = check(&[("t.plc", &text)], "t.plc");
        let found = found.into_iter().flat_map(|(_, d)| d).collect::<Vec<_>>();
        let difference = difference(&text, &found);
        if !difference.is_empty() {
            writeln!(report, "{}:\n{difference}", path.file_name().unwrap_or_default().display())
                .expect("a String");
        }
        count += 1;
    }
    assert!(report.is_empty(), "\n{report}");
    assert!(count >= 40, "only {count} fixtures");
}
