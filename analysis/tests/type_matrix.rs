//! Which declared types and prefixes each instruction of chapter 3 takes: the table of the manual (3.9), row by row.

use std::collections::{BTreeMap, BTreeSet};

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change, Severity};

struct Memory(BTreeMap<String, Vec<u8>>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).cloned().ok_or_else(|| "no such file".to_string())
    }
}

/// Instruction, declared types, prefixes: B BYTE, W WORD, H HIGH, C constant, D DWRD, Q QWRD, R REAL.
const ROWS: &[(&str, &str, &str)] = &[
    ("LOD", "BWCD", "BWHCDQR"),
    ("STO", "BWD", "BWHDQR"),
    ("STO0", "BWD", "BWHDQR"),
    ("STO1", "BWD", "BWHDQR"),
    ("MOVE", "BWD", "BWHDQR"),
    ("MOVE1", "BWD", "BWHDQR"),
    ("TM", "BW", "BW"),
    ("CU", "BW", ""),
    ("CD", "BW", ""),
    ("CUBCD", "BW", ""),
    ("AD", "BWCD", "BWHCDQR"),
    ("SU", "BWCD", "BWHCDQR"),
    ("MULB", "BWCD", "BWHCDR"),
    ("DIVB", "BWCD", "BWHCDR"),
    // Of two statements about QWRD the wider one holds.
    ("ORB", "BWCD", "BWHCDQ"),
    ("ANDB", "BWCD", "BWHCDQ"),
    ("XORB", "BWCD", "BWHCDQ"),
    ("RR", "BC", "BHC"),
    ("RL", "BC", "BHC"),
    ("EQ", "BWCD", "BWHCDQR"),
    ("EQ1", "BWCD", "BWHCDQR"),
    ("LT", "BWCD", "BWHCDQR"),
    ("GT", "BWCD", "BWHCDQR"),
    ("LE", "BWCD", "BWHCDQR"),
    ("GE", "BWCD", "BWHCDQR"),
    ("TIM", "BW", "BW"),
    ("TEX0", "BW", "BW"),
    ("TEX1", "BW", "BW"),
];

/// An operand of that declared type, without a prefix.
const DECLARED: &[(char, &str)] = &[('B', "SMALL"), ('W', "MIDDLE"), ('D', "LARGE"), ('C', "TEN")];
/// An operand with that prefix.
const PREFIXED: &[(char, &str)] = &[
    ('B', "BYTE.TABLE"),
    ('W', "WORD.TABLE"),
    ('H', "HIGH.MIDDLE"),
    ('C', "CNST.5"),
    ('D', "DWRD.TABLE"),
    ('Q', "QWRD.TABLE"),
    ('R', "REAL.TABLE"),
];

fn line(instruction: &str, operand: &str) -> String {
    match instruction {
        "MOVE" | "MOVE1" => format!("        {instruction} {operand},{operand}"),
        // A prefix covers the time too, which then is a cell.
        "TIM" if operand.contains('.') => format!("        TIM {operand},TABLE+4"),
        "TIM" => format!("        TIM {operand},5"),
        "TEX0" | "TEX1" if operand.contains('.') => {
            format!("        {instruction} {operand},TABLE+4,FAILED")
        }
        "TEX0" | "TEX1" => format!("        {instruction} {operand},5,FAILED"),
        _ => format!("        {instruction} {operand}"),
    }
}

/// The letters of those operands that an instruction takes.
fn taken(instruction: &str, operands: &[(char, &str)]) -> BTreeSet<char> {
    let frame = include_str!("fixtures/frame/main.plc");
    let before = frame.find(";here").expect("the place of the lines");
    let first = frame[..before].lines().count() as u32 + 1;
    let lines: Vec<String> = operands.iter().map(|(_, operand)| line(instruction, operand)).collect();
    let body = format!("        MECH_BEGIN ROW\n{}\nFAILED: EX\n        MECH_END ROW\n", lines.join("\n"));
    let text = frame.replacen(";here\n", &body, 1);
    let files = BTreeMap::from([("t.plc".to_string(), text.into_bytes())]);
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("t.plc", &Memory(files))), texts: Vec::new() });
    let found = host.analysis().all_diagnostics().expect("nothing cancels it");
    let wrong: BTreeSet<u32> = found
        .iter()
        .flat_map(|(_, list)| list)
        .filter(|d| d.severity == Severity::Error)
        .map(|d| d.span.start.line)
        .collect();
    let letters = operands.iter().enumerate();
    letters.filter(|(n, _)| !wrong.contains(&(first + *n as u32))).map(|(_, (letter, _))| *letter).collect()
}

#[test]
fn each_instruction_takes_the_declared_types_of_its_row() {
    for (instruction, declared, _) in ROWS {
        assert_eq!(taken(instruction, DECLARED), declared.chars().collect(), "{instruction}");
    }
}

#[test]
fn each_instruction_takes_the_prefixes_of_its_row() {
    for (instruction, _, prefixes) in ROWS {
        assert_eq!(taken(instruction, PREFIXED), prefixes.chars().collect(), "{instruction}");
    }
}

#[test]
fn real_constants_stand_where_reals_are_computed() {
    for (instruction, declared, prefixes) in ROWS {
        let reals = declared.contains('C') && prefixes.contains('R');
        let operands = [('r', "1.5"), ('c', "CNST.-4.8")];
        assert_eq!(taken(instruction, &operands).len(), if reals { 2 } else { 0 }, "{instruction}");
    }
}
