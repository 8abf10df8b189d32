//! Comments that allow what a rule reports: where they hold, and what is wrong with them.

mod completed;

use std::collections::BTreeMap;

use technol_analysis::project::{FileReader, load};
use technol_analysis::{Analysis, AnalysisHost, Change};

struct Memory(BTreeMap<String, String>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let path = path.strip_prefix("p/").unwrap_or(path);
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }
}

fn analysis(text: &str) -> Analysis {
    let memory = Memory(completed::project_of(text));
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("p", &memory)), texts: Vec::new() });
    host.analysis()
}

/// Code and marked text of what is reported as a warning or worse.
fn found(text: &str) -> Vec<String> {
    let source = completed::project_of(text)["main.plc"].clone();
    let diagnostics = analysis(text).diagnostics("main.plc").expect("nothing cancels it");
    let of_interest =
        diagnostics.iter().filter(|d| d.severity <= technol_analysis::Severity::Warning || d.code < "T11");
    of_interest
        .map(|d| {
            let line = source.lines().nth(d.span.start.line as usize).unwrap_or_default();
            let end = (d.span.end.column as usize).min(line.len());
            format!("{} {}", d.code, &line[d.span.start.column as usize..end])
        })
        .collect()
}

/// One lost equation.
const LOST: &str = "LDR START\nEDGE_H DOOR\nWR MOTOR\n";

#[test]
fn without_a_comment_the_rule_reports() {
    assert_eq!(found(LOST), ["T0504 EDGE_H"]);
}

#[test]
fn behind_code_it_holds_for_its_line() {
    assert_eq!(found("LDR START\nEDGE_H DOOR ;technol: allow(T0504)\nWR MOTOR\n"), Vec::<String>::new());
    assert_eq!(
        found("LDR START ; technol: allow(T0504)\nEDGE_H DOOR\nWR MOTOR\n"),
        ["T1051 T0504", "T0504 EDGE_H"]
    );
}

#[test]
fn alone_it_holds_for_the_next_operation_whatever_its_case_and_name() {
    let text =
        "LDR START\n;technol: allow(lost-equation) the edge alone counts\n\nHERE:\nEDGE_H DOOR\nWR MOTOR\n";
    assert_eq!(found(text), Vec::<String>::new());
    let text = "LDR START\n;technol: allow(t0504)\nLA DOOR\nEDGE_H DOOR\nWR MOTOR\n";
    assert_eq!(found(text), ["T1051 t0504", "T0504 EDGE_H"]);
}

#[test]
fn before_a_section_it_holds_for_all_of_it() {
    let mechanism = format!("MECH_BEGIN CLAMP\n{LOST}EX\n{LOST}MECH_END CLAMP\nFL 1,CLAMP\n");
    assert_eq!(found(&mechanism), ["T0504 EDGE_H", "T0504 EDGE_H"]);
    assert_eq!(found(&format!(";technol: allow(T0504)\n; why\n{mechanism}")), Vec::<String>::new());
    // A comment before a module holds for the mechanisms in it too.
    let module = format!(
        "MODULE_INPUT\nMODULE_INPUT_END\n;technol: allow(T0504)\nMODULE_MAIN\n{mechanism}MODULE_MAIN_END\n"
    );
    let text = completed::project_of(&module)["main.plc"]
        .replace(";technol: allow(T0504)\n", "")
        .replace("MODULE_MAIN\n", ";technol: allow(T0504)\nMODULE_MAIN\n");
    assert_eq!(found(&format!(";=== main.plc\n{text}")), Vec::<String>::new());
    // It does not hold for the section behind.
    let two = format!("{mechanism}{}", mechanism.replace("CLAMP", "CLOSE").replace("MOTOR", "LAMP"));
    assert_eq!(found(&format!(";technol: allow(T0504)\n{two}")), ["T0504 EDGE_H", "T0504 EDGE_H"]);
}

#[test]
fn for_the_file_it_stands_in_the_first_comment_block() {
    let text = completed::project_of(LOST)["main.plc"].clone();
    let first = format!(";=== main.plc\n; a lathe\n; technol: allow-file(T0504)\n{text}");
    assert_eq!(found(&first), Vec::<String>::new());
    let late = format!(";=== main.plc\n{text}").replace("STOP\n", ";technol: allow-file(T0504)\nSTOP\n");
    assert_eq!(found(&late), ["T0504 EDGE_H", "T1054 ;technol: allow-file(T0504)"]);
}

#[test]
fn several_rules_are_judged_one_by_one() {
    let text = "LDR START\nEDGE_H DOOR ;technol: allow(T0504, T0202,T9999 ,T0301)\nWR MOTOR\n";
    assert_eq!(found(text), ["T1051 T0202", "T1052 T9999", "T1053 T0301"]);
}

#[test]
fn what_cannot_be_read_is_reported() {
    for comment in ["allow", "allow()", "allow(T0504", "alow(T0504)", "allow(T0504,)", ""] {
        let text = format!("LDR START\nWR MOTOR ;technol: {comment}\n");
        assert!(found(&text).first().is_some_and(|it| it.starts_with("T1054")), "{comment}");
    }
}

#[test]
fn the_editor_writes_the_comment() {
    let cases = [
        ("EDGE_H DOOR", "EDGE_H DOOR ;technol: allow(T0504)"),
        ("EDGE_H DOOR  ", "EDGE_H DOOR ;technol: allow(T0504)  "),
        ("EDGE_H DOOR ; edge", "EDGE_H DOOR ;technol: allow(T0504) ; edge"),
        ("EDGE_H DOOR ;technol: allow(T0202)", "EDGE_H DOOR ;technol: allow(T0202, T0504)"),
    ];
    for (line, expected) in cases {
        let text = format!("LDR START\n{line}\nWR MOTOR\n");
        let analysis = analysis(&text);
        let diagnostics = analysis.diagnostics("main.plc").expect("nothing cancels it");
        let lost = diagnostics.iter().find(|d| d.code == "T0504").expect("it is reported");
        let fix = analysis.allow("main.plc", lost).expect("nothing cancels it").expect("it can be allowed");
        let (span, new) = &fix.edits[0];
        let mut fixed = line.to_string();
        fixed.insert_str(span.start.column as usize, new);
        assert_eq!(fixed, expected);
        assert!(!found(&text.replace(line, &fixed)).iter().any(|it| it.starts_with("T0504")), "{fixed}");
    }
}

#[test]
fn an_error_of_the_build_cannot_be_allowed() {
    let analysis = analysis("LDR NOWHERE\nWR MOTOR\n");
    let diagnostics = analysis.diagnostics("main.plc").expect("nothing cancels it");
    let unknown = diagnostics.iter().find(|d| d.code == "T0301").expect("it is reported");
    assert_eq!(analysis.allow("main.plc", unknown).expect("nothing cancels it"), None);
}
