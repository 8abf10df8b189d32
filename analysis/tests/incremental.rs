//! What an edit re-runs: asserted on salsa's events.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use proptest::prelude::*;
use technol_analysis::database::Database;
use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change, Diagnostic, Severity};

struct Memory(BTreeMap<String, String>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }
}

const PROGRAM: &str = "\
DATA
KEYS:  DFM START,HALT_KEY,DOOR
LAMPS: DFM RED,GREEN,BLUE
COUNT: DS 2
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
MODULE_MAIN
LDR START
FL1 1,FIRST
MECH_BEGIN FIRST
FL 1,RED
LDR DOOR
EX0
MECH_END FIRST
MECH_BEGIN SECOND
FL 1,GREEN
AGAIN:
LDR DOOR
EX1
JUM AGAIN
MECH_END SECOND
PROC_BEGIN HELP
FL 0,BLUE
PROC_END HELP
MODULE_MAIN_END
MODULE_INIT
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
";

fn memory(text: &str) -> Memory {
    Memory(BTreeMap::from([("t.plc".to_string(), text.to_string())]))
}

/// Queries that ran in an edit, by name, with how often.
fn executed_by(before: &str, after: &str) -> BTreeMap<String, usize> {
    let log = Arc::new(Mutex::new(Vec::new()));
    let sink = log.clone();
    let db = Database::with_events(Box::new(move |event| {
        if let salsa::EventKind::WillExecute { database_key } = event.kind {
            sink.lock().expect("one thread").push(format!("{database_key:?}"));
        }
    }));
    let mut host = AnalysisHost::with_database(db);
    host.apply(Change {
        project: Some(load("t.plc", &memory(before))),
        texts: vec![("t.plc".to_string(), Arc::from(before))],
    });
    host.analysis().all_diagnostics().expect("nothing cancels it");
    log.lock().expect("one thread").clear();
    host.apply(Change { project: None, texts: vec![("t.plc".to_string(), Arc::from(after))] });
    host.analysis().all_diagnostics().expect("nothing cancels it");
    let mut counts = BTreeMap::new();
    for name in log.lock().expect("one thread").iter() {
        let name = name.split('(').next().unwrap_or_default().to_string();
        *counts.entry(name).or_default() += 1;
    }
    counts
}

fn counts(expected: &[(&str, usize)]) -> BTreeMap<String, usize> {
    expected.iter().map(|(name, count)| ((*name).to_string(), *count)).collect()
}

#[test]
fn typing_in_one_mechanism_runs_nothing_of_another() {
    let after = PROGRAM.replace("FL 1,RED\n", "FL 1,RED,BLUE\n");
    assert_eq!(
        executed_by(PROGRAM, &after),
        counts(&[
            ("sections", 1),
            ("section_lines", 1),
            ("section_outline", 1),
            ("section_declarations", 1),
            ("section_analysis", 1),
            ("section_uses", 1),
            // BLUE is new in the file: its names are joined and judged again.
            ("file_uses", 1),
            ("foreign_uses", 1),
            ("file_lints", 1),
            ("file_diagnostics", 1),
        ])
    );
}

#[test]
fn typing_that_names_nothing_new_runs_no_lint_of_the_project() {
    let after = PROGRAM.replace("FL 0,BLUE\n", "FL 0,BLUE\nFL 0,BLUE\n");
    let ran = executed_by(PROGRAM, &after);
    assert_eq!(
        (ran.get("section_uses"), ran.get("file_uses"), ran.get("file_lints")),
        (Some(&1), None, None)
    );
}

#[test]
fn lines_added_above_run_nothing_but_the_outer_edge() {
    let after = format!("; a comment\n{PROGRAM}").replace("MODULE_MAIN\n", "; another\nMODULE_MAIN\n");
    // Both comments stand between modules: only the lines there are looked at again.
    assert_eq!(
        executed_by(PROGRAM, &after),
        counts(&[
            ("sections", 1),
            ("section_lines", 1),
            ("section_outline", 1),
            ("section_declarations", 1),
            ("section_analysis", 1),
            ("section_uses", 1),
            ("file_diagnostics", 1),
        ])
    );
}

#[test]
fn a_new_variable_runs_only_the_lookups_and_its_own_section() {
    let after = PROGRAM.replace("COUNT: DS 2\n", "COUNT: DS 2\nTOTAL: DS 4\n");
    let ran = executed_by(PROGRAM, &after);
    assert_eq!(ran.get("section_analysis"), Some(&1), "{ran:?}");
    assert_eq!(ran.get("section_lines"), Some(&1), "{ran:?}");
    assert_eq!(ran.get("scope"), Some(&1), "{ran:?}");
}

#[test]
fn a_changed_declaration_runs_those_who_use_it() {
    // DOOR becomes another bit: both mechanisms use it, the procedure does not.
    let after = PROGRAM.replace("START,HALT_KEY,DOOR", "START,DOOR,HALT_KEY");
    let ran = executed_by(PROGRAM, &after);
    assert_eq!(ran.get("section_analysis"), Some(&3), "DATA, FIRST and SECOND: {ran:?}");
}

/// A program with macros in a definition file and in the main file; both mechanisms call them.
const WITH_MACROS: &str = "\
T_INCLUDE copy.inc
DEF_T_MACRO KEEP FROM
T_LOCAL KEPT
DATA_LOCAL
KEPT: DS 1
DATA_LOCAL_END
LDR TMAC.FROM
STO1 KEPT
END_T_MACRO T_END
DATA
KEYS:  DFM START,HALT_KEY,DOOR
LAMPS: DFM RED,GREEN,BLUE
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
MODULE_MAIN
LDR START
FL1 1,FIRST,SECOND,THIRD
MECH_BEGIN FIRST
KEEP DOOR
COPY START,RED
EX
MECH_END FIRST
MECH_BEGIN SECOND
KEEP DOOR
COPY START,GREEN
EX
MECH_END SECOND
MECH_BEGIN THIRD
FL 1,BLUE
EX
MECH_END THIRD
MODULE_MAIN_END
MODULE_INIT
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
";

const COPY: &str = "DEF_T_MACRO COPY FROM,TO\nLDR TMAC.FROM\nWR TMAC.TO\nEND_T_MACRO T_END\n";

/// Queries that ran in an edit of a file of that program.
fn executed_with_macros(edited: &str, from: &str, to: &str) -> BTreeMap<String, usize> {
    executed_in(WITH_MACROS, edited, from, to)
}

fn executed_in(program: &str, edited: &str, from: &str, to: &str) -> BTreeMap<String, usize> {
    let files = [("t.plc", program), ("copy.inc", COPY)];
    let before = files.iter().find(|(path, _)| *path == edited).expect("a file of it").1;
    let after = before.replacen(from, to, 1);
    assert_ne!(before, after);
    let log = Arc::new(Mutex::new(Vec::new()));
    let sink = log.clone();
    let db = Database::with_events(Box::new(move |event| {
        if let salsa::EventKind::WillExecute { database_key } = event.kind {
            sink.lock().expect("one thread").push(format!("{database_key:?}"));
        }
    }));
    let mut host = AnalysisHost::with_database(db);
    let memory = Memory(files.iter().map(|(p, t)| ((*p).to_string(), (*t).to_string())).collect());
    let opened: Arc<str> = Arc::from(memory.0[edited].as_str());
    host.apply(Change { project: Some(load("t.plc", &memory)), texts: vec![(edited.to_string(), opened)] });
    let mut found = host.analysis().all_diagnostics().expect("nothing cancels it");
    // The programs are short, some of their names are not used.
    for (_, list) in &mut found {
        list.retain(|d| d.severity <= Severity::Warning);
    }
    found.retain(|(_, list)| !list.is_empty());
    assert_eq!(found, []);
    log.lock().expect("one thread").clear();
    host.apply(Change { project: None, texts: vec![(edited.to_string(), Arc::from(after.as_str()))] });
    host.analysis().all_diagnostics().expect("nothing cancels it");
    let mut counts = BTreeMap::new();
    for name in log.lock().expect("one thread").iter() {
        *counts.entry(name.split('(').next().unwrap_or_default().to_string()).or_default() += 1;
    }
    counts
}

#[test]
fn typing_in_one_mechanism_runs_nothing_of_another_also_with_macros() {
    let own = [
        ("sections", 1),
        ("section_lines", 1),
        ("section_outline", 1),
        ("section_declarations", 1),
        ("section_analysis", 1),
        ("section_uses", 1),
        ("file_uses", 1),
        ("foreign_uses", 1),
        ("file_lints", 1),
        ("file_diagnostics", 1),
    ];
    // A mechanism without calls looks for calls; one with calls is expanded again.
    let mut expected = own.to_vec();
    expected.push(("expansion", 1));
    assert_eq!(executed_with_macros("t.plc", "FL 1,BLUE\n", "FL 1,BLUE,RED\n"), counts(&expected));
    expected.push(("expansion_declarations", 1));
    assert_eq!(
        executed_with_macros("t.plc", "KEEP DOOR\nCOPY START,RED\n", "KEEP DOOR\nCOPY START,BLUE\n"),
        counts(&expected)
    );
}

#[test]
fn typing_in_one_mechanism_runs_nothing_of_another_also_when_instructions_may_be_macros() {
    let before = format!("CONTROL_T_MACRO PRE\n{WITH_MACROS}");
    let expected = [
        ("sections", 1),
        ("section_lines", 1),
        ("section_outline", 1),
        ("section_declarations", 1),
        ("section_analysis", 1),
        ("section_uses", 1),
        ("file_uses", 1),
        ("foreign_uses", 1),
        ("file_lints", 1),
        ("file_diagnostics", 1),
        ("expansion", 1),
        ("expansion_declarations", 1),
    ];
    let ran = executed_in(&before, "t.plc", "COPY START,RED\n", "COPY START,BLUE\n");
    assert_eq!(ran, counts(&expected));
}

#[test]
fn lines_added_above_run_nothing_but_the_outer_edge_also_with_macros() {
    let ran = executed_with_macros("t.plc", "MODULE_INPUT\n", "; a comment\nMODULE_INPUT\n");
    assert_eq!(ran.get("section_analysis"), Some(&1), "the lines between modules: {ran:?}");
    assert_eq!(ran.get("scope"), None, "{ran:?}");
    assert_eq!(ran.get("macro_meaning"), None, "{ran:?}");
    let ran = executed_with_macros("t.plc", "EX\nMECH_END FIRST", "EX\n; a comment\nMECH_END FIRST");
    assert_eq!(ran.get("section_analysis"), Some(&1), "{ran:?}");
    assert_eq!(ran.get("expansion"), Some(&1), "{ran:?}");
}

#[test]
fn an_edited_body_runs_only_the_sections_that_use_it() {
    let ran = executed_with_macros("copy.inc", "WR TMAC.TO\n", "WR TMAC.TO,RED\n");
    assert_eq!(ran.get("expansion"), Some(&2), "FIRST and SECOND: {ran:?}");
    assert_eq!(ran.get("section_analysis"), Some(&3), "both and the definition: {ran:?}");
    assert_eq!(ran.get("macro_table"), None, "{ran:?}");
    assert_eq!(ran.get("scope"), None, "{ran:?}");
    let ran = executed_with_macros("copy.inc", "WR TMAC.TO\n", "WR TMAC.TO ;a comment\n");
    assert_eq!(ran.get("expansion"), None, "{ran:?}");
    assert_eq!(ran.get("section_analysis"), Some(&1), "the definition: {ran:?}");
}

#[test]
fn a_new_macro_runs_only_the_lookups_and_its_own_section() {
    let ran = executed_with_macros(
        "t.plc",
        "T_INCLUDE copy.inc\n",
        "T_INCLUDE copy.inc\nDEF_T_MACRO NONE\nNOP\nEND_T_MACRO\n",
    );
    assert_eq!(ran.get("macro_table"), Some(&1), "{ran:?}");
    assert_eq!(ran.get("expansion"), Some(&1), "its own section, which has no calls: {ran:?}");
    assert_eq!(ran.get("section_analysis"), Some(&2), "the definition and the lines around it: {ran:?}");
}

type Found = Vec<(String, Vec<Diagnostic>)>;

fn from_scratch(text: &str) -> Found {
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("t.plc", &memory(text))), texts: Vec::new() });
    host.analysis().all_diagnostics().expect("nothing cancels it")
}

/// An edit of lines: where, how many go, what comes.
#[derive(Clone, Debug)]
struct Edit {
    at: prop::sample::Index,
    removed: usize,
    added: Vec<usize>,
}

const LINES: &[&str] = &[
    "LDR START",
    "LDR -DOOR",
    "LA",
    "LO RED",
    "WR GREEN,BLUE",
    "WR COUNT",
    "FL 1,SECOND",
    "EX",
    "TEX0 -,50,AGAIN",
    "AGAIN:",
    "JUM AGAIN",
    "JL0 NOWHERE",
    "LOD COUNT",
    "LOD STRANGE+2",
    "STO BYTE.COUNT",
    "EQ 'A'",
    "MECH_BEGIN SECOND",
    "MECH_END SECOND",
    "MECH_BEGIN THIRD",
    "MECH_END THIRD",
    "PROC_BEGIN HELP",
    "PROC_CALL HELP",
    "PROC_END HELP",
    "MODULE_MAIN",
    "MODULE_MAIN_END",
    "DATA",
    "NEW: DS 2",
    "DFM RED,,STRANGE",
    "DATA_END",
    "DATA_LOCAL",
    "DATA_LOCAL_END",
    "EQUI KA,KB+1",
    "EQUI KB,7",
    "EQUI KA,3",
    "DS KA",
    "TEXT: STR KA,'abcdef'",
    "STOP",
    "DEBUG ON",
    "CHECK",
    "nonsense here",
    "LOD 'open",
    "DFTM1 AGAIN",
    "DEF_T_MACRO FLASH A,B",
    "DEF_T_MACRO LDR A",
    "T_LOCAL NEXT,CELL",
    "LDR TMAC.A",
    "FL1 1,TMAC.B.RED",
    "FLASH RED,GREEN",
    "FLASH COUNT",
    "DOUBLE RED,(COUNT+1)",
    "END_T_MACRO",
    "END_T_MACRO T_PUSH,C_1,D_ON",
    "APPEND_T_MACRO DOUBLE,FLASH,T_END",
    "CONTROL_T_MACRO PRE",
    "CONTROL_T_MACRO POS",
    "CELL: DS 1",
    "NEXT:",
    "; comment",
    "",
];

fn edits() -> impl Strategy<Value = Vec<Edit>> {
    let edit = (any::<prop::sample::Index>(), 0usize..4, prop::collection::vec(0..LINES.len(), 0..4))
        .prop_map(|(at, removed, added)| Edit { at, removed, added });
    prop::collection::vec(edit, 1..12)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn edited_is_the_same_as_from_scratch(edits in edits()) {
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(load("t.plc", &memory(PROGRAM))), texts: Vec::new() });
        let mut lines: Vec<String> = PROGRAM.lines().map(str::to_string).collect();
        for edit in edits {
            let at = edit.at.index(lines.len() + 1).min(lines.len());
            let end = (at + edit.removed).min(lines.len());
            lines.splice(at..end, edit.added.iter().map(|line| LINES[*line].to_string()));
            let text = lines.join("\n");
            host.apply(Change { project: None, texts: vec![("t.plc".to_string(), Arc::from(text.as_str()))] });
            let edited = host.analysis().all_diagnostics().expect("nothing cancels it");
            prop_assert_eq!(edited, from_scratch(&text), "{}", text);
        }
    }
}

const WORDS: &[&str] = &[
    "DEF_T_MACRO",
    "END_T_MACRO",
    "APPEND_T_MACRO",
    "CONTROL_T_MACRO",
    "T_LOCAL",
    "TMAC",
    "T_PUSH",
    "PRE",
    "LDR",
    "LA",
    "WR",
    "FL",
    "LOD",
    "STO",
    "EQ",
    "MOVE",
    "MV",
    "CLEAR",
    "TEX0",
    "TIM",
    "TM",
    "RR",
    "CONDR",
    "ESET",
    "DS",
    "DFM",
    "EQUI",
    "STR",
    "MECH_INIT",
    "PROC_CALL",
    "JL0",
    "DFTM1",
    "MOV",
    "START",
    "RED",
    "COUNT",
    "FIRST",
    "HELP",
    "NEW",
    "BYTE",
    "WORD",
    "HIGH",
    "CNST",
    "CNTS",
    "REAL",
    "BX",
    "NIL",
    "ALL",
    "-",
    "+",
    "$",
    ".",
    ",",
    "(",
    ")",
    "[",
    "]",
    ":",
    "0",
    "1",
    "8",
    "0FFh",
    "9223372036854775807",
    "1.5",
    "'A'",
    "'text'",
    "'",
    " ",
    " ",
    "ž",
    "\u{2019}",
    ";x",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_line_anywhere_gives_diagnostics_within_the_text(
        words in prop::collection::vec(0..WORDS.len(), 0..14),
        at in any::<prop::sample::Index>(),
    ) {
        let mut lines: Vec<String> = PROGRAM.lines().map(str::to_string).collect();
        let line: String = words.iter().map(|word| WORDS[*word]).collect::<Vec<_>>().join(" ");
        lines.insert(at.index(lines.len()), line.replace(" . ", ".").replace(" - ", " -"));
        let text = lines.join("\n");
        for (_, found) in from_scratch(&text) {
            for diagnostic in found {
                let (start, end) = (diagnostic.span.start, diagnostic.span.end);
                let source = lines.get(start.line as usize).map_or("", String::as_str);
                let within = start <= end
                    && source.is_char_boundary(start.column as usize)
                    && (source.is_char_boundary(end.column as usize) || end.column as usize <= source.len() + 1);
                prop_assert!(within, "{diagnostic:?} in {source:?}");
            }
        }
    }
}

#[test]
fn a_change_cancels_what_is_running() {
    use std::sync::mpsc;

    let (started, has_started) = mpsc::channel();
    let (flagged, is_flagged) = mpsc::channel();
    let is_flagged = Mutex::new(Some(is_flagged));
    let db = Database::with_events(Box::new(move |event| match event.kind {
        // The first analysis stands still until the change is on its way.
        salsa::EventKind::WillExecute { database_key }
            if format!("{database_key:?}").starts_with("section_analysis") =>
        {
            if let Some(flag) = is_flagged.lock().expect("not poisoned").take() {
                started.send(()).expect("the test waits");
                flag.recv().expect("the change sets the flag");
            }
        }
        salsa::EventKind::DidSetCancellationFlag => flagged.send(()).unwrap_or_default(),
        _ => {}
    }));
    let mut host = AnalysisHost::with_database(db);
    host.apply(Change { project: Some(load("t.plc", &memory(PROGRAM))), texts: Vec::new() });
    let snapshot = host.analysis();
    let worker = std::thread::spawn(move || snapshot.all_diagnostics().is_err());
    has_started.recv().expect("the worker analyses");
    host.apply(Change { project: None, texts: vec![("t.plc".to_string(), Arc::from("STOP\n"))] });
    assert!(worker.join().expect("it does not panic"), "the running question was cancelled");
    assert!(host.analysis().all_diagnostics().is_ok());
}
