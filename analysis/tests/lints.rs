//! The lints of an expert: what they report and, as important, what they leave alone.

mod completed;

use std::collections::BTreeMap;

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change};

struct Memory(BTreeMap<String, String>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let path = path.strip_prefix("p/").unwrap_or(path);
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }
}

/// `file code marked text` of each diagnostic with one of these codes.
fn found(text: &str, codes: &[&str]) -> Vec<String> {
    let files = completed::project_of(text);
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("p", &Memory(files.clone()))), texts: Vec::new() });
    let all = host.analysis().all_diagnostics().expect("nothing cancels it");
    let mut shown = Vec::new();
    for (file, list) in all {
        for d in list.iter().filter(|d| codes.contains(&d.code)) {
            let line = files[&file].lines().nth(d.span.start.line as usize).unwrap_or_default();
            let end = (d.span.end.column as usize).min(line.len());
            shown.push(format!("{file} {} {}", d.code, &line[d.span.start.column as usize..end]));
        }
    }
    shown
}

fn none(text: &str, codes: &[&str]) {
    assert_eq!(found(text, codes), Vec::<String>::new(), "{text}");
}

const NAMES: &[&str] = &["T1131", "T1132", "T1133"];

fn data(declared: &str, main: &str) -> String {
    format!("DATA\n{declared}DATA_END\nMODULE_MAIN\n{main}MODULE_MAIN_END\n")
}

#[test]
fn memory_is_judged_by_what_is_done_with_it() {
    let text = data("A: DS 2\nB: DS 2\nC: DS 2\nD: DS 2\n", "LOD A\nSTO B\nLOD C\nINR\nSTO C\n");
    assert_eq!(found(&text, NAMES), ["main.plc T1131 A", "main.plc T1132 B", "main.plc T1133 D"]);
}

#[test]
fn a_byte_is_its_bits() {
    none(
        &data(
            "IN: DFM A,B\nOUT: DFM C,D\n",
            "LOD P1IN\nSTO IN\nLDR A\nWR C\nLDR B\nWR D\nLOD OUT\nSTO P1OUT\n",
        ),
        NAMES,
    );
    let text = data("IN: DFM A,B\nOUT: DFM C,D\n", "LDR A\nWR C\nLDR B\nWR D\n");
    assert_eq!(
        found(&text, NAMES),
        ["main.plc T1131 A", "main.plc T1131 B", "main.plc T1132 C", "main.plc T1132 D"]
    );
}

#[test]
fn neighbours_reached_by_offset_or_index_are_used() {
    none(&data("A: DS 1\nB: DS 1\nC: DS 2\n", "LOD BYTE.(A+1)\nSTO WORD.(A+2)\nLOD A\nSTO A\n"), NAMES);
    none(&data("A: DS 1\nB: DS 1\nC: DS 300\n", "LOD BYTE.A[BX]\nSTO BYTE.A[BX]\n"), NAMES);
    none(&data("DFM A,B\nDFM A1,B1\n", "LDR A\nLA $+1.A\nWR A,$+1.A\n"), NAMES);
    none(&data("A: DS 8\nB: DS 8\n", "MV A,B,8\nMV B,A,8\n"), NAMES);
    // What is not understood may use anything.
    none(&data("A: DS 2\n", "NONSENSE A\n"), NAMES);
}

#[test]
fn uses_in_other_files_count_unless_a_local_name_hides_it() {
    let first = "DATA\nA: DS 2\nDATA_END\n;=== b.plc\nMODULE_MAIN\nLOD A\nINR\nSTO A\nMODULE_MAIN_END\n";
    none(first, NAMES);
    let local = format!("{first}DATA_LOCAL\nA: DS 2\nDATA_LOCAL_END\n");
    assert_eq!(found(&local, &["T1133"]), ["main.plc T1133 A"]);
    none(
        "DATA\nDATA_END\nMODULE_MAIN\nFL 1,M\nPROC_CALL P\nLOD K\nMODULE_MAIN_END\n;=== b.plc\nDATA\nEQUI K,5\nDATA_END\nMODULE_MAIN\nMECH_BEGIN M\nEX\nMECH_END M\nPROC_BEGIN P\nPROC_END P\nMODULE_MAIN_END\n",
        &["T1134", "T1141", "T1142"],
    );
}

#[test]
fn two_writers_are_two_that_overwrite_each_other() {
    let pair = |first: &str, second: &str| {
        format!("MECH_BEGIN A\n{first}EX\nMECH_END A\nMECH_BEGIN B\n{second}EX\nMECH_END B\nFL 1,A,B\n")
    };
    let wr = "LDR START\nWR MOTOR\n";
    assert_eq!(found(&pair(wr, wr), &["T1130"]), ["main.plc T1130 MOTOR"]);
    assert_eq!(found(&pair("FL 1,MOTOR\n", wr), &["T1130"]), ["main.plc T1130 MOTOR"]);
    // Set here and reset there is how sequences hand over.
    none(&pair("FL 1,MOTOR\n", "FL 0,MOTOR\n"), &["T1130"]);
    none(&format!("{wr}{}", pair("FL 1,LAMP\n", "FL 0,MOTOR\n")), &["T1130"]);
    none(&pair(&format!("{wr}{wr}"), ""), &["T1130"]);
    none(
        "MODULE_INIT\nLDR START\nWR MOTOR\nMODULE_INIT_END\nMODULE_MAIN\nLDR DOOR\nWR MOTOR\nMODULE_MAIN_END\n",
        &["T1130"],
    );
}

#[test]
fn a_mechanism_is_started_by_any_write_but_a_zero() {
    let text = |start: &str| format!("MECH_BEGIN A\nEX\nMECH_END A\n{start}");
    for start in ["FL 1,A\n", "LDR START\nFL1 1,A\n", "LDR START\nWR A\n", "NONSENSE A\n"] {
        none(&text(start), &["T1134"]);
    }
    for start in ["FL 0,A\n", "MECH_INIT A\n", "LDR A\nWR MOTOR\n"] {
        assert_eq!(found(&text(start), &["T1134"]), ["main.plc T1134 A"], "{start}");
    }
}

#[test]
fn an_endless_wait_is_one_for_a_bit_that_stays_zero() {
    let text = |wait: &str, more: &str| format!("MECH_BEGIN A\n{wait}MECH_END A\nFL 1,A\n{more}");
    assert_eq!(found(&text("LDR M0\nEX0\n", ""), &["T1135"]), ["main.plc T1135 EX0"]);
    assert_eq!(found(&text("LDR M0\nEX0\n", "FL 0,M0\n"), &["T1135"]), ["main.plc T1135 EX0"]);
    none(&text("LDR M0\nEX0\n", "FL 1,M0\n"), &["T1135"]);
    none(&text("LDR M0\nEX1\n", ""), &["T1135"]);
    none(&text("LDR -M0\nEX0\n", ""), &["T1135"]);
    none(&text("LDR M0\nLO M1\nEX0\n", "FL 1,M1\n"), &["T1135"]);
    none(&text("LDR M0\nTEX0 -,50,LATE\nFL 1,LAMP\nLATE:\n", ""), &["T1135"]);
    none(&text("LDR CAPI\nEX0\n", ""), &["T1135"]);
}

#[test]
fn code_behind_a_jump_is_reached_by_labels_of_any_instruction() {
    none("LDR START\nJL0 A\nJUM B\nA:\nFL 1,LAMP\nB:\n", &["T1139", "T1140"]);
    none(
        "FL 1,M\nMECH_BEGIN M\nLDR DOOR\nTEX0 -,50,LATE\nJUM END\nLATE:\nFL 1,LAMP\nEND:\nMECH_END M\n",
        &["T1139", "T1140"],
    );
    none("DFTM1 END\nJUM END\nEND:\n", &["T1139"]);
    none("JUM OVER\nPROC_BEGIN P\nFL 0,LAMP\nPROC_END P\nOVER:\nPROC_CALL P\n", &["T1139"]);
    let text = "JUM OVER\nFL 1,LAMP\nFL 1,MOTOR\nDEAD:\nFL 0,MOTOR\nOVER:\n";
    assert_eq!(found(text, &["T1139", "T1140"]), ["main.plc T1139 FL", "main.plc T1140 DEAD"]);
}

#[test]
fn only_the_control_writes_its_cells() {
    let codes = &["T1147"];
    none("LDR CAPI\nWR STOPPI,P1OUT.M0\n", codes);
    none("LOD P1IN\nSTO P1OUT\n", codes);
    assert_eq!(found("LOD SMALL\nSTO P1IN\n", codes), ["main.plc T1147 P1IN"]);
    assert_eq!(found("FL 1,P1IN.M0\n", codes), ["main.plc T1147 P1IN"]);
}

#[test]
fn registers_are_followed_from_line_to_line_only() {
    let codes = &["T1149", "T1150", "T1151", "T1155"];
    assert_eq!(found("LOD SMALL\nGE CNST.128\nWR LAMP\n", codes), ["main.plc T1150 CNST.128"]);
    none("LOD SMALL\nGE BYTE.128\nWR LAMP\n", codes);
    none("LOD SMALL\nHERE:\nGE CNST.128\nWR LAMP\nLDR START\nJL0 HERE\n", codes);
    none("LOD LARGE\nGE CNST.40000\nWR LAMP\n", codes);
    assert_eq!(found("LOD CNST.1Ah\nBIN\nSTO MIDDLE\n", codes), ["main.plc T1151 BIN"]);
    none("LOD CNST.12000\nBCD DWRD\nSTO LARGE\n", codes);
    none("LOD REAL.RATIO\nAD REAL.RATIO\nSTO REAL.RATIO\n", codes);
    assert_eq!(found("LOD REAL.RATIO\nAD CNST.1\nSTO REAL.RATIO\n", codes), ["main.plc T1155 REAL.RATIO"]);
    none("LOD REAL.RATIO\nAD CNST.1\nSTO LARGE\n", codes);
}

#[test]
fn debug_regions_are_closed_in_the_order_of_the_text() {
    let text = |first: &str, last: &str| {
        format!("{first}MODULE_INPUT\nMODULE_INPUT_END\nMODULE_MAIN\nFL 1,LAMP\n{last}MODULE_MAIN_END\n")
    };
    none(&text("DEBUG ON\n", "DEBUG OFF\n"), &["T1148"]);
    assert_eq!(found(&text("", "DEBUG\n"), &["T1148"]), ["main.plc T1148 DEBUG"]);
    assert_eq!(found(&text("DEBUG OFF\n", "DEBUG ON\n"), &["T1148"]), ["main.plc T1148 DEBUG"]);
}

#[test]
fn a_wait_behind_a_test_is_no_wait_of_every_block() {
    let block = |code: &str| format!("MODULE_BLOCK_DONE\n{code}MODULE_BLOCK_DONE_END\n");
    none(&block("LDR M0\nJL0 END\nEX\nEND:\n"), &["T1136"]);
    none(&block("BEX\nFL 1,LAMP\n"), &["T1136"]);
    assert_eq!(found(&block("FL 1,LAMP\nTIM -,5\n"), &["T1136"]), ["main.plc T1136 TIM"]);
    none("FL 1,M\nMECH_BEGIN M\nEX\nMECH_END M\n", &["T1136"]);
}
