//! Markers: `;   ^^^^ T0301 part of the message` under the columns of a diagnostic.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

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

/// Every diagnostic of the project that `root` names.
pub(crate) fn check(files: &[(&str, &str)], root: &str) -> Vec<(String, Vec<Diagnostic>)> {
    let memory = Memory(files.iter().map(|(p, t)| ((*p).to_string(), t.as_bytes().to_vec())).collect());
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load(root, &memory)), texts: Vec::new() });
    host.analysis().all_diagnostics().expect("nothing cancels it")
}

/// The text of a file that must be there.
pub(crate) fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
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
pub(crate) fn difference(text: &str, found: &[Diagnostic]) -> String {
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
