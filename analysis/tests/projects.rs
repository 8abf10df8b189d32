//! Projects of several files: manifest, file set, includes, encodings, scopes across files.

use std::collections::BTreeMap;

use technol_analysis::project::{Encoding, FileReader, discover, load};
use technol_analysis::{AnalysisHost, Change, Severity};

#[derive(Default)]
struct Memory(BTreeMap<String, Vec<u8>>);

impl Memory {
    fn with(mut self, path: &str, text: impl AsRef<[u8]>) -> Memory {
        self.0.insert(path.to_string(), text.as_ref().to_vec());
        self
    }
}

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

const MAIN: &str = "\
DATA
KEYS: DFM START,DOOR
;data
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

const FURTHER: &str = "\
DATA
;data
DATA_END
MODULE_MAIN
;main
MODULE_MAIN_END
";

fn main_with(data: &str, main: &str) -> String {
    MAIN.replace(";data\n", data).replace(";main\n", main)
}

fn further_with(data: &str, main: &str) -> String {
    FURTHER.replace(";data\n", data).replace(";main\n", main)
}

/// `file:line:column code` of everything found, with lines and columns from 1; without lints about names that short
/// programs do not use to the end.
fn found(memory: &Memory, root: &str) -> Vec<String> {
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load(root, memory)), texts: Vec::new() });
    let all = host.analysis().all_diagnostics().expect("nothing cancels it");
    all.iter()
        .flat_map(|(file, list)| {
            list.iter().filter(|d| d.severity <= Severity::Warning && d.code != "T1134").map(move |d| {
                format!("{file}:{}:{} {}", d.span.start.line + 1, d.span.start.column + 1, d.code)
            })
        })
        .collect()
}

fn manifest(files: &str) -> String {
    format!("[project]\nname = \"t\"\nfiles = [{files}]\n")
}

#[test]
fn names_of_data_mechanisms_and_procedures_are_known_in_other_files() {
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"b.plc\""))
        .with(
            "p/main.plc",
            main_with("", "FL 1,PUMP,RUN_B\nPROC_CALL HELP\nLOD LEVEL\nAD COUNT_B\nMECH_INIT RUN_B\n"),
        )
        .with(
            "p/b.plc",
            further_with(
                "DFM PUMP\nCOUNT_B: DS 2\nEQUI LEVEL,5\n",
                "MECH_BEGIN RUN_B\nEX\nMECH_END RUN_B\nPROC_BEGIN HELP\nPROC_END HELP\n",
            ),
        );
    assert_eq!(found(&memory, "p"), Vec::<String>::new());
}

#[test]
fn local_data_are_known_in_their_file_only() {
    let local = "DATA_LOCAL\nOWN: DS 2\nDATA_LOCAL_END\n";
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"b.plc\", \"c.plc\""))
        .with("p/main.plc", main_with("", "LOD OWN\n"))
        .with("p/b.plc", further_with("", "LOD OWN\n") + local)
        .with("p/c.plc", further_with("", "LOD OWN\n") + local);
    assert_eq!(found(&memory, "p"), ["main.plc:11:5 T0301"]);
}

#[test]
fn a_name_declared_in_two_files_is_reported_in_both() {
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"b.plc\""))
        .with("p/main.plc", main_with("TANK: DS 1\n", ""))
        .with("p/b.plc", further_with("TANK: DS 2\n", ""));
    assert_eq!(found(&memory, "p"), ["main.plc:3:1 T0201", "b.plc:2:1 T0201"]);
}

#[test]
fn modules_of_the_main_file_are_refused_in_further_files() {
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"b.plc\""))
        .with("p/main.plc", main_with("", ""))
        .with("p/b.plc", "DATA\nDATA_END\nMODULE_INPUT\nMODULE_INPUT_END\n");
    assert_eq!(found(&memory, "p"), ["b.plc:1:1 T0601", "b.plc:3:1 T0602"]);
}

#[test]
fn broken_file_lists_are_reported_in_the_manifest() {
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"b.plc\", \"main.plc\", \"../x.plc\", \"gone.plc\""))
        .with("p/main.plc", main_with("", ""))
        .with("p/b.plc", further_with("", ""));
    assert_eq!(
        found(&memory, "p"),
        ["technol.toml:3:19 T0007", "technol.toml:3:31 T0006", "technol.toml:3:43 T0004"]
    );
}

#[test]
fn a_folder_without_manifest_and_main_file_says_so() {
    assert_eq!(found(&Memory::default(), "p"), ["technol.toml:1:1 T0004"]);
    assert_eq!(found(&Memory::default(), "p/x.plc"), ["x.plc:1:1 T0004"]);
}

#[test]
fn a_lone_file_and_a_folder_with_main_plc_are_projects() {
    let memory = Memory::default().with("p/main.plc", main_with("", ""));
    assert_eq!(found(&memory, "p/main.plc"), Vec::<String>::new());
    assert_eq!(found(&memory, "p"), Vec::<String>::new());
    assert_eq!(load("p/main.plc", &memory).manifest.name, "main");
}

#[test]
fn a_file_belongs_to_the_nearest_manifest_that_lists_it() {
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"sub/b.plc\""))
        .with("p/sub/technol.toml", manifest("\"other.plc\""));
    assert_eq!(discover("p/sub/b.plc", &memory), "p");
    assert_eq!(discover("p/main.plc", &memory), "p");
    assert_eq!(discover("p/lone.plc", &memory), "p/lone.plc");
    assert_eq!(discover("p/x.inc", &memory), "p");
}

#[test]
fn constants_and_memory_of_includes_are_known() {
    let memory = Memory::default()
        .with("p/technol.toml", "[project]\ninclude-dirs = [\"lib\"]\nsystem-dir = \"sys\"\n")
        .with(
            "p/main.plc",
            format!(
                "T_INCLUDE sub\\numbers.inc\nT_INCLUDE 'SYS.INC'\n{}",
                main_with("T_INCLUDE cells.inc\n", "LOD SPEED\nSU LEVEL\nSU DEEP\nSTO SPEED\n",)
            ),
        )
        .with("p/sub/numbers.inc", "EQUI LEVEL,DEEP+1 ;from another include\n")
        .with("p/sys/SYS.INC", "EQUI DEEP,7\n")
        .with("p/lib/cells.inc", "SPEED: DS 2\nDFM LAMP\n");
    assert_eq!(found(&memory, "p"), Vec::<String>::new());
}

#[test]
fn includes_are_searched_from_the_folder_of_the_program_file_first_and_in_any_case() {
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"sub/b.plc\""))
        .with("p/main.plc", format!("T_INCLUDE numbers.inc\n{}", main_with("", "LOD CNST.TOP\nSTO SPEED\n")))
        .with("p/NUMBERS.INC", "EQUI TOP,1\n")
        .with(
            "p/sub/b.plc",
            format!(
                "T_INCLUDE deep\\OWN.INC\nT_INCLUDE Numbers.Inc\n{}",
                further_with("SPEED: DS 2\n", "LOD CNST.NEAR\nSTO SPEED\n")
            ),
        )
        .with("p/sub/deep/own.inc", "T_INCLUDE near.inc\n")
        .with("p/sub/near.inc", "EQUI NEAR,2\n");
    assert_eq!(found(&memory, "p"), Vec::<String>::new());
    let loaded = load("p", &memory);
    let included: Vec<&str> = loaded.included.iter().map(|file| file.path.as_str()).collect();
    assert_eq!(included, ["NUMBERS.INC", "sub/deep/own.inc", "sub/near.inc"]);
}

#[test]
fn includes_that_lead_nowhere_or_in_a_circle_are_reported_where_they_stand() {
    let memory = Memory::default()
        .with(
            "p/main.plc",
            format!("T_INCLUDE a.inc\nT_INCLUDE gone.inc\nT_INCLUDE 'sys.inc'\n{}", main_with("", "")),
        )
        .with("p/a.inc", "EQUI KA,1\nT_INCLUDE b.inc\n")
        .with("p/b.inc", "T_INCLUDE a.inc\nEQUI KB,2\n");
    assert_eq!(found(&memory, "p"), ["main.plc:2:11 T0009", "main.plc:3:11 T0009", "b.inc:1:11 T0010"]);
}

#[test]
fn code_and_misplaced_memory_in_includes_are_reported() {
    let memory = Memory::default()
        .with("p/main.plc", format!("T_INCLUDE code.inc\nT_INCLUDE cells.inc\n{}", main_with("", "")))
        .with("p/code.inc", "EQUI KA,1\n  LDR START\n")
        .with("p/cells.inc", "CELL: DS 2\n");
    assert_eq!(found(&memory, "p"), ["code.inc:2:3 T0011", "cells.inc:1:7 T0011"]);
}

#[test]
fn memory_is_included_once() {
    let memory = Memory::default()
        .with("p/technol.toml", manifest("\"b.plc\""))
        .with("p/main.plc", main_with("T_INCLUDE cells.inc\n", ""))
        .with("p/b.plc", further_with("T_INCLUDE cells.inc\n", ""))
        .with("p/cells.inc", "CELL: DS 2\n");
    assert_eq!(found(&memory, "p"), ["b.plc:2:11 T0012"]);
}

#[test]
fn a_file_that_is_no_text_in_the_declared_encoding_is_reported() {
    let memory = Memory::default()
        .with("p/technol.toml", "[project]\nencoding = \"utf-8\"\n")
        .with("p/main.plc", [b"; \xE8e\xF9ka\n", main_with("", "").as_bytes()].concat());
    assert_eq!(found(&memory, "p"), ["main.plc:1:3 T0013"]);
    let auto =
        Memory::default().with("p/main.plc", [b"; \xE8e\x9Aka\n", main_with("", "").as_bytes()].concat());
    assert_eq!(found(&auto, "p"), Vec::<String>::new());
    let loaded = load("p", &auto);
    assert_eq!(loaded.files[0].encoding, Encoding::Windows1250);
    assert!(loaded.files[0].text.starts_with("; češka"));
}

#[test]
fn lints_change_severities_and_switch_rules_off() {
    let text = main_with("  A_NAME_THAT_IS_LONGER_THAN_31_CHARS: DS 2\n  DS 4\n", "");
    let severities = |lints: &str| {
        let memory = Memory::default()
            .with("p/technol.toml", format!("[lints]\n{lints}\n"))
            .with("p/main.plc", text.clone());
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(load("p", &memory)), texts: Vec::new() });
        let found = host.analysis().diagnostics("main.plc").expect("nothing cancels it");
        let memory = |code: &str| code.starts_with("T02");
        found.iter().map(|d| (d.code, d.severity)).filter(|(code, _)| memory(code)).collect::<Vec<_>>()
    };
    assert_eq!(severities(""), [("T0202", Severity::Warning), ("T0210", Severity::Warning)]);
    assert_eq!(severities("T0202 = \"error\"\nT0210 = \"off\""), [("T0202", Severity::Error)]);
    assert_eq!(severities("t0210 = \"hint\"").last(), Some(&("T0210", Severity::Hint)));
}

#[test]
fn an_include_that_appears_while_typing_asks_for_a_reload() {
    let memory = Memory::default().with("p/main.plc", main_with("", "")).with("p/a.inc", "EQUI KA,1\n");
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("p", &memory)), texts: Vec::new() });
    assert!(!host.needs_reload());
    let text = format!("T_INCLUDE a.inc\n{}", main_with("", ""));
    host.apply(Change { project: None, texts: vec![("main.plc".to_string(), text.as_str().into())] });
    assert!(host.needs_reload());
    let memory = memory.with("p/main.plc", text);
    host.apply(Change { project: Some(load("p", &memory)), texts: Vec::new() });
    assert!(!host.needs_reload());
    assert_eq!(host.analysis().file_paths().expect("nothing cancels it"), ["main.plc", "a.inc"]);
}

/// Reads from the disk, as the command line does.
struct Disk;

impl FileReader for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        std::fs::read(path).map_err(|error| error.to_string())
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        entries.filter_map(|entry| entry.file_name().into_string().ok()).collect()
    }
}

#[test]
fn the_examples_have_no_mistakes() {
    for name in ["minimal", "lathe"] {
        let root = format!("{}/../examples/{name}", env!("CARGO_MANIFEST_DIR").replace('\\', "/"));
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(load(&root, &Disk)), texts: Vec::new() });
        let found = host.analysis().all_diagnostics().expect("nothing cancels it");
        let shown: Vec<String> = found
            .iter()
            .flat_map(|(file, list)| {
                list.iter().map(move |d| format!("{file}:{} {} {}", d.span.start.line + 1, d.code, d.message))
            })
            .collect();
        assert_eq!(shown, Vec::<String>::new(), "{name}");
    }
}
