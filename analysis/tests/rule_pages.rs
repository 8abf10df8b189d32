//! The examples of the rules: `wrong` has the mistake and no other, `right` has none, and the fixes remedy it.

mod completed;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use completed::project_of;
use technol_analysis::diagnostics::{RULES, Rule};
use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change, Diagnostic, Fix, Severity};

/// Rules whose mistake no text shows, with where they are tested.
const NOT_IN_A_TEXT: &[(&str, &str)] = &[
    ("T0005", "needs 65 files: projects.rs"),
    ("T0013", "needs bytes that are no text: projects.rs"),
    ("T0014", "needs the machine, which the command line reads: cli"),
];

/// Rules that `build` reports.
const OF_THE_BUILD: &[&str] = &["T0801", "T0802", "T0803"];

/// Rules of the project file, the target and the editor, which the manual does not mention.
const NO_CHAPTER: &[&str] = &[
    "T0001", "T0002", "T0003", "T0004", "T0006", "T0008", "T0013", "T0014", "T0110", "T0801", "T0803",
    "T0902", "T1051", "T1052", "T1053", "T1054",
];

/// Mistakes that cannot come alone: the rule, and what comes with it.
const COMPANIONS: &[(&str, &[&str])] = &[];

type Files = BTreeMap<String, String>;

struct Memory<'a>(&'a Files);

impl FileReader for Memory<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let path = path.strip_prefix("p/").unwrap_or(path);
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }

    fn list(&self, folder: &str) -> Vec<String> {
        if folder == "p" { self.0.keys().cloned().collect() } else { Vec::new() }
    }
}

fn host(files: &Files) -> AnalysisHost {
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("p", &Memory(files))), texts: Vec::new() });
    host
}

fn check(files: &Files) -> Vec<(String, Diagnostic)> {
    let all = host(files).analysis().all_diagnostics().expect("nothing cancels it");
    all.into_iter().flat_map(|(file, list)| list.into_iter().map(move |d| (file.clone(), d))).collect()
}

fn build(files: &Files) -> Vec<(String, Diagnostic)> {
    host(files).analysis().build().expect("nothing cancels it").err().unwrap_or_default()
}

fn found(rule: &Rule, files: &Files) -> Vec<(String, Diagnostic)> {
    if OF_THE_BUILD.contains(&rule.code) { build(files) } else { check(files) }
}

fn shown(found: &[(String, Diagnostic)]) -> String {
    let mut text = String::new();
    for (file, d) in found {
        let start = d.span.start;
        writeln!(text, "    {file}:{}:{} {} {}", start.line + 1, start.column + 1, d.code, d.message)
            .expect("a String");
    }
    text
}

/// What counts for an example of `rule`: examples are short, so that some of their names are not used.
fn counts(rule: &Rule, d: &Diagnostic) -> bool {
    d.code == rule.code || d.severity <= Severity::Warning && !matches!(d.code, "T1134" | "T1135")
}

fn is_lint(rule: &Rule) -> bool {
    rule.code.starts_with("T11")
}

fn examined() -> impl Iterator<Item = &'static Rule> {
    RULES.iter().copied().filter(|rule| !NOT_IN_A_TEXT.iter().any(|(code, _)| *code == rule.code))
}

#[test]
fn every_rule_says_what_why_and_shows_both_programs() {
    let mut report = String::new();
    for rule in RULES {
        let texts = [rule.explanation, rule.why, rule.wrong, rule.right];
        if texts.iter().any(|text| text.trim().len() < 3) || rule.why.len() < 20 {
            writeln!(report, "{} {}: a part of its page is missing", rule.code, rule.name).expect("a String");
        }
        if rule.chapter.is_empty() && !is_lint(rule) && !NO_CHAPTER.contains(&rule.code) {
            writeln!(report, "{} {}: no chapter", rule.code, rule.name).expect("a String");
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

#[test]
fn the_wrong_program_has_this_mistake_and_no_other() {
    let mut report = String::new();
    for rule in examined() {
        let found = found(rule, &project_of(rule.wrong));
        let codes: BTreeSet<&str> =
            found.iter().filter(|(_, d)| counts(rule, d)).map(|(_, d)| d.code).collect();
        let companions = COMPANIONS.iter().find(|(code, _)| *code == rule.code).map_or(&[][..], |(_, c)| c);
        let expected: BTreeSet<&str> = std::iter::once(rule.code).chain(companions.iter().copied()).collect();
        if codes != expected {
            writeln!(report, "{} {}:\n{}", rule.code, rule.name, shown(&found)).expect("a String");
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

#[test]
fn the_right_program_has_no_mistake() {
    let mut report = String::new();
    for rule in examined() {
        let mut found = check(&project_of(rule.right));
        if OF_THE_BUILD.contains(&rule.code) {
            found.extend(build(&project_of(rule.right)));
        }
        found.retain(|(_, d)| counts(rule, d));
        if !found.is_empty() {
            writeln!(report, "{} {}:\n{}", rule.code, rule.name, shown(&found)).expect("a String");
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

#[test]
fn a_fix_removes_the_mistake_and_brings_no_other() {
    let mut report = String::new();
    for rule in examined() {
        let files = project_of(rule.wrong);
        let before = found(rule, &files);
        let fixes: Vec<(&String, &Fix)> = before
            .iter()
            .filter(|(_, d)| d.code == rule.code)
            .filter_map(|(file, d)| Some((file, d.fix.as_ref()?)))
            .collect();
        if fixes.is_empty() == rule.fix {
            writeln!(report, "{} {}: fix is {}, offered: {}", rule.code, rule.name, rule.fix, fixes.len())
                .expect("a String");
        }
        for (file, fix) in fixes {
            let mut fixed = files.clone();
            let text = fixed.get_mut(file).expect("a file of the project");
            *text = applied(text, fix);
            let after = found(rule, &fixed);
            let count = |list: &[(String, Diagnostic)], own: bool| {
                list.iter().filter(|(_, d)| counts(rule, d) && (d.code == rule.code) == own).count()
            };
            if count(&after, true) >= count(&before, true) || count(&after, false) > count(&before, false) {
                let after = shown(&after);
                writeln!(report, "{} {}: {}:\n{after}{}", rule.code, rule.name, fix.title, fixed[file])
                    .expect("a String");
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

/// The text with the edits of a fix.
fn applied(text: &str, fix: &Fix) -> String {
    let starts: Vec<usize> =
        std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
    let at = |position: technol_analysis::Position| {
        starts.get(position.line as usize).map_or(text.len(), |start| start + position.column as usize)
    };
    let mut edits: Vec<(usize, usize, &str)> =
        fix.edits.iter().map(|(span, new)| (at(span.start), at(span.end), new.as_str())).collect();
    edits.sort_unstable();
    let mut fixed = text.to_string();
    for (start, end, new) in edits.into_iter().rev() {
        fixed.replace_range(start..end, new);
    }
    fixed
}
