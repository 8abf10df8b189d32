//! Fixtures: programs with marked mistakes, and programs without any.
//!
//! A marker is a comment line under the line it marks: `;   ^^^^ T0301 part of the message`. The carets stand under
//! the columns of the diagnostic. A fixture that begins with `;use NAME` stands inside the complete program
//! `fixtures/frame/NAME.plc`, at its line `;here`. Every diagnostic must have a marker and every marker a diagnostic; what
//! is `quiet` may stay without.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change, Diagnostic, Severity};

struct Memory(BTreeMap<String, Vec<u8>>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).cloned().ok_or_else(|| "no such file".to_string())
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let inside = |path: &String| {
            let (at, name) = path.rsplit_once('/').unwrap_or(("", path));
            (at == folder).then(|| name.to_string())
        };
        self.0.keys().filter_map(inside).collect()
    }
}

fn check(files: &[(&str, &str)], root: &str) -> Vec<(String, Vec<Diagnostic>)> {
    let memory = Memory(files.iter().map(|(p, t)| ((*p).to_string(), t.as_bytes().to_vec())).collect());
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load(root, &memory)), texts: Vec::new() });
    host.analysis().all_diagnostics().expect("nothing cancels it")
}

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
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

/// (line, start, end, code, part of the message)
type Mark = (u32, u32, u32, String, String);

fn markers(text: &str) -> Vec<Mark> {
    let mut marks = Vec::new();
    let mut last = 0;
    for (number, line) in text.lines().enumerate() {
        let trimmed = line.trim_start_matches([';', ' ']);
        if !(line.starts_with(';') && trimmed.starts_with('^')) {
            last = number as u32;
            continue;
        }
        let start = line.find('^').expect("checked") as u32;
        let carets = trimmed.chars().take_while(|c| *c == '^').count() as u32;
        let mut words = trimmed.trim_start_matches('^').trim().splitn(2, ' ');
        let code = words.next().unwrap_or_default().to_string();
        marks.push((last, start, start + carets, code, words.next().unwrap_or_default().trim().to_string()));
    }
    marks
}

/// What needs no marker: hints, and lints about names that a short program does not use to the end.
fn quiet(d: &Diagnostic) -> bool {
    d.severity > Severity::Warning || matches!(d.code, "T1134" | "T1135")
}

/// What differs between markers and diagnostics; empty when nothing does.
fn difference(text: &str, found: &[Diagnostic]) -> String {
    let mut expected = markers(text);
    let mut report = String::new();
    for d in found {
        let (start, end) = (d.span.start, d.span.end);
        let hit = expected.iter().position(|(line, from, to, code, part)| {
            *line == start.line
                && *from == start.column
                && (*to == end.column || end.column == start.column)
                && *code == d.code
                && d.message.contains(part.as_str())
        });
        if let Some(at) = hit {
            expected.remove(at);
        } else if !quiet(d) {
            let source = text.lines().nth(start.line as usize).unwrap_or_default();
            let (line, from, to) = (start.line + 1, start.column, end.column);
            writeln!(report, "  unexpected {}:{from}..{to} {} {}\n    | {source}", line, d.code, d.message)
                .expect("a String");
        }
    }
    for (line, from, to, code, part) in expected {
        writeln!(report, "  missing {}:{from}..{to} {code} {part}", line + 1).expect("a String");
    }
    report
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
