//! Macros over several files: definition files, order of the text, places of what is reported.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change, Severity};

struct Memory(BTreeMap<String, String>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }
}

const MAIN: &str = "\
;before
DATA
KEYS: DFM START,DOOR
LAMPS: DFM RED,GREEN
COUNT: DS 2
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
MODULE_MAIN
;main
MODULE_MAIN_END
MODULE_INIT
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
";

fn main_file(before: &str, main: &str) -> String {
    MAIN.replace(";before\n", before).replace(";main\n", main)
}

fn further_file(before: &str, main: &str) -> String {
    format!("{before}DATA\nDATA_END\nMODULE_MAIN\n{main}MODULE_MAIN_END\n")
}

/// `file:line:columns code message`, and what belongs to it, each with the text that its columns hold.
fn check(files: &[(&str, &str)]) -> String {
    let mut memory: BTreeMap<String, String> =
        files.iter().map(|(path, text)| ((*path).to_string(), (*text).to_string())).collect();
    let programs: Vec<&str> = files
        .iter()
        .map(|(path, _)| *path)
        .filter(|path| path.rsplit_once('.').is_some_and(|(_, end)| end == "plc"))
        .collect();
    memory.entry("p/technol.toml".to_string()).or_insert_with(|| {
        format!(
            "[project]\nmain = {:?}\nfiles = {:?}\nsystem-dir = \"system\"\n",
            programs[0].trim_start_matches("p/"),
            programs[1..].iter().map(|path| path.trim_start_matches("p/")).collect::<Vec<_>>()
        )
    });
    let texts = memory.clone();
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("p", &Memory(memory))), texts: Vec::new() });
    let mut shown = String::new();
    let place = |file: &str, span: technol_analysis::Span| {
        let key = if file.starts_with('/') { file.to_string() } else { format!("p/{file}") };
        let line =
            texts.get(&key).and_then(|text| text.lines().nth(span.start.line as usize)).unwrap_or_default();
        let text = line.get(span.start.column as usize..span.end.column as usize).unwrap_or("?");
        format!("{file}:{} «{text}»", span.start.line + 1)
    };
    for (file, found) in host.analysis().all_diagnostics().expect("nothing cancels it") {
        // The programs are short, some of their names are not used.
        for it in found.iter().filter(|it| it.severity <= Severity::Warning) {
            writeln!(shown, "{} {} {}", place(&file, it.span), it.code, it.message).expect("a String");
            for (location, note) in &it.related {
                writeln!(shown, "    {} {note}", place(&location.file, location.span)).expect("a String");
            }
        }
    }
    shown
}

const COPY: &str = "DEF_T_MACRO COPY FROM, TO\n LDR TMAC.FROM\n WR TMAC.TO\nEND_T_MACRO T_END\n";

#[test]
fn definition_files_are_joined_where_they_are_included() {
    let main = main_file(" T_INCLUDE MAC\\COPY.INC\n T_INCLUDE 'TWICE.INC'\n", " TWICE START,RED,GREEN\n");
    let twice = "DEF_T_MACRO TWICE FROM, ONE, TWO\n COPY FROM,ONE\n COPY FROM,TWO\nEND_T_MACRO T_END\n";
    let files = [("p/main.plc", main.as_str()), ("p/MAC/COPY.INC", COPY), ("p/system/TWICE.INC", twice)];
    assert_eq!(check(&files), "");
}

#[test]
fn a_file_may_be_included_by_each_program_file() {
    let main = main_file(" T_INCLUDE COPY.INC\n", " COPY START,RED\n");
    let other = further_file(" T_INCLUDE COPY.INC\n", " COPY DOOR,GREEN\n");
    assert_eq!(check(&[("p/main.plc", &main), ("p/other.plc", &other), ("p/COPY.INC", COPY)]), "");
}

#[test]
fn text_order_decides_what_is_defined() {
    let main = main_file("", " COPY START,RED\n T_INCLUDE COPY.INC\n COPY START,RED\n");
    let other = further_file("", " COPY DOOR,GREEN\n");
    insta::assert_snapshot!(
        check(&[("p/main.plc", &main), ("p/other.plc", &other), ("p/COPY.INC", COPY)]),
        @"
    main.plc:13 «COPY» T1003 COPY is defined further down; a macro must be defined before it is used
        COPY.INC:1 «COPY» COPY is declared here
    "
    );
}

#[test]
fn two_definitions_of_one_name_are_reported_at_both() {
    let main = main_file(&format!("{COPY} T_INCLUDE COPY.INC\n"), " COPY START,RED\n");
    insta::assert_snapshot!(check(&[("p/main.plc", &main), ("p/COPY.INC", COPY)]), @"
    main.plc:1 «COPY» T1002 the macro COPY is defined more than once
        COPY.INC:1 «COPY» also declared here
    COPY.INC:1 «COPY» T1002 the macro COPY is defined more than once
        main.plc:1 «COPY» also declared here
    ");
}

#[test]
fn a_mistake_in_an_expansion_stands_at_the_call_and_shows_the_line_of_the_definition() {
    let twice = format!(
        "{COPY}DEF_T_MACRO TWICE FROM\n COPY TMAC.FROM,NOWHERE\n LDR START\n STO1 TMAC.FROM\nEND_T_MACRO T_END\n"
    );
    let main = main_file(" T_INCLUDE TWICE.INC\n", " TWICE START ;call\n COPY COUNT,RED\n");
    insta::assert_snapshot!(check(&[("p/main.plc", &main), ("p/TWICE.INC", &twice)]), @"
    main.plc:14 «TWICE» T0301 NOWHERE is not declared; declare it with DFM, DS or EQUI
        TWICE.INC:6 «NOWHERE» this line of the macro COPY
        TWICE.INC:6 «COPY» this line of the macro TWICE
    main.plc:14 «START» T0304 START is a bit, a cell is needed here
        main.plc:3 «START» START is declared here
        TWICE.INC:8 «STO1 TMAC.FROM» this line of the macro TWICE
    main.plc:15 «COUNT» T0304 COUNT is a WORD cell, a bit is needed here
        main.plc:5 «COUNT» COUNT is declared here
        TWICE.INC:2 «LDR TMAC.FROM» this line of the macro COPY
    ");
}

#[test]
fn a_macro_without_t_local_can_be_called_once() {
    let body = "DEF_T_MACRO KEEP FROM\n DATA_LOCAL\nKEPT: DS 1\n DATA_LOCAL_END\n LDR TMAC.FROM\n STO1 KEPT\nEND_T_MACRO T_END\n";
    let once = main_file(" T_INCLUDE KEEP.INC\n", " KEEP START\n LOD KEPT\n STO COUNT\n");
    insta::assert_snapshot!(check(&[("p/main.plc", &once), ("p/KEEP.INC", body)]), @"KEEP.INC:3 «KEPT» T1016 KEPT is not in T_LOCAL: it would be declared again by every call of KEEP");
    let twice = main_file(" T_INCLUDE KEEP.INC\n", " KEEP START\n KEEP DOOR\n");
    insta::assert_snapshot!(check(&[("p/main.plc", &twice), ("p/KEEP.INC", body)]), @"
    main.plc:14 «KEEP» T0201 KEPT is declared more than once
        KEEP.INC:3 «KEPT» also declared here
    main.plc:15 «KEEP» T0201 KEPT is declared more than once
        KEEP.INC:3 «KEPT» also declared here
    KEEP.INC:3 «KEPT» T1016 KEPT is not in T_LOCAL: it would be declared again by every call of KEEP
    ");
}

#[test]
fn a_name_that_many_calls_declare_shows_a_few_of_its_other_places() {
    let body = "DEF_T_MACRO KEEP FROM\n DATA_LOCAL\nKEPT: DS 1\n DATA_LOCAL_END\n LDR TMAC.FROM\n STO1 KEPT\nEND_T_MACRO T_END\n";
    let many = main_file(" T_INCLUDE KEEP.INC\n", &" KEEP START\n".repeat(200));
    let found = check(&[("p/main.plc", &many), ("p/KEEP.INC", body)]);
    assert_eq!(found.matches("T0201").count(), 200);
    assert_eq!(found.matches("also declared here").count(), 200 * 5);
}

#[test]
fn data_and_code_of_definition_files_keep_their_rules() {
    let main = main_file(" T_INCLUDE BAD.INC\n", "");
    let bad = format!("{COPY} COPY START,RED\n LDR START\n WR RED\n");
    insta::assert_snapshot!(check(&[("p/main.plc", &main), ("p/BAD.INC", &bad)]), @"
    BAD.INC:5 «COPY» T0011 an included file may not hold code; move LDR into a program file
        BAD.INC:2 «LDR» this line of the macro COPY
    ");
}

#[test]
fn a_call_between_modules_may_declare_constants() {
    let numbers = "DEF_T_MACRO NUMBERS FIRST\n EQUI ERR_A,FIRST\n EQUI ERR_B,TMAC.FIRST+1\nEND_T_MACRO\n NUMBERS 4512h\n";
    let main = main_file(" T_INCLUDE NUMBERS.INC\n", " LOD CNST.ERR_B\n STO COUNT\n");
    insta::assert_snapshot!(check(&[("p/main.plc", &main), ("p/NUMBERS.INC", numbers)]), @"NUMBERS.INC:2 «FIRST» T1008 FIRST is a parameter: an instruction takes it as TMAC.FIRST");
}

#[test]
fn macros_and_cells_may_share_a_name() {
    let text = COPY.replace("COPY", "COUNT");
    let main = main_file(&text, " COUNT START,RED\n LOD COUNT\n STO COUNT\n");
    assert_eq!(check(&[("p/main.plc", &main)]), "");
}

#[test]
fn bounds_hold_for_macros_that_double_each_other() {
    let mut text = String::from("DEF_T_MACRO D0\n LDR START\n WR RED\nEND_T_MACRO T_END\n");
    for n in 1..40 {
        let calls = format!(" D{}\n", n - 1).repeat(4);
        write!(text, "DEF_T_MACRO D{n}\n{calls}END_T_MACRO\n").expect("a String");
    }
    let found = check(&[("p/main.plc", &main_file(&text, " D7\n D39\n"))]);
    assert!(found.contains("«D7» T1005") && found.matches("T1005").count() == 1, "{found}");
}
