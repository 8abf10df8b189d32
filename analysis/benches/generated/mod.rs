//! Programs for the benchmarks.

#![allow(dead_code, reason = "each benchmark uses its part")]

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technol_analysis::project::{FileReader, LoadedProject, load};

/// Files in memory.
struct Memory(BTreeMap<String, String>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }
}

/// A program of about `lines` lines in one file: mechanisms of 21 lines, each with its own cells.
pub(crate) fn program(lines: usize) -> String {
    file("", lines, true)
}

/// One file of a program; the names of its mechanisms and cells end in `tag` and a number.
fn file(tag: &str, lines: usize, first: bool) -> String {
    let count = (lines / 30).max(1);
    let mut text = String::from("DATA\n");
    for n in 0..count {
        let n = format!("{tag}{n}");
        writeln!(text, "IN{n}: DFM A{n},B{n}\nOUT{n}: DFM E{n},F{n}\nCELL{n}: DS 2").expect("a String");
    }
    text.push_str("DATA_END\n");
    if first {
        text.push_str(
            "MODULE_INPUT\nMODULE_INPUT_END\nMODULE_BLOCK_INIT\nMODULE_BLOCK_INIT_END\n\
             MODULE_BLOCK_DONE\nMODULE_BLOCK_DONE_END\n",
        );
    }
    text.push_str("MODULE_MAIN\n");
    for number in 0..count {
        let n = format!("{tag}{number}");
        write!(
            text,
            "  LDR E{n}\n  WR A{n}\n  LDR F{n}\n  WR B{n}\n  LDR A{n}\n  FL1 1,MECH{n}\nMECH_BEGIN MECH{n}\n  FL 1,E{n}     ;start\n  LDR A{n}\n  LA -B{n}\n  \
             LDR E{n}\n  LO F{n}\n  LA\n  TEX0 -,500,ERR{n}\n  LOD CELL{n}\n  AD CNST.{number}\n  STO CELL{n}\n  \
             EQ CNST.100\n  JL0 NEXT{n}\n  FL 0,F{n}\nNEXT{n}:\n  TIM -,10\n  JUM END{n}\nERR{n}:\n  ESET 5\n\
             END{n}:\nMECH_END MECH{n}\n"
        )
        .expect("a String");
    }
    text.push_str("MODULE_MAIN_END\n");
    if first {
        text.push_str(
            "MODULE_INIT\nMODULE_INIT_END\nMODULE_CLEAR\nMODULE_CLEAR_END\n\
             MODULE_HALT\nMODULE_HALT_END\n",
        );
    }
    if first {
        text.push_str("STOP\n");
    }
    text
}

/// A project of one file, `t.plc`.
pub(crate) fn project(text: &str) -> LoadedProject {
    load("t.plc", &Memory(BTreeMap::from([("t.plc".to_string(), text.to_string())])))
}

/// A project of files of about so many lines, and the texts with their paths.
pub(crate) fn project_of(lines: &[usize]) -> (LoadedProject, Vec<(String, String)>) {
    let texts: Vec<(String, String)> = lines
        .iter()
        .enumerate()
        .map(|(n, lines)| (format!("F{n}.PLC"), file(&format!("X{n}Y"), *lines, n == 0)))
        .collect();
    let names: Vec<String> = texts.iter().map(|(path, _)| format!("\"{path}\"")).collect();
    let manifest =
        format!("[project]\nname = \"many\"\nmain = {}\nfiles = [{}]\n", names[0], names[1..].join(", "));
    let mut all: BTreeMap<String, String> = texts.iter().cloned().collect();
    all.insert("technol.toml".to_string(), manifest);
    (load("technol.toml", &Memory(all)), texts)
}

/// The text with one edit in the mechanism that `turn` falls on.
pub(crate) fn edit(text: &str, turn: usize) -> String {
    let mechanisms: Vec<usize> = text.match_indices("  AD CNST.").map(|(at, _)| at).collect();
    let at = mechanisms[turn * 37 % mechanisms.len()];
    let (before, after) = text.split_at(at);
    match turn % 4 {
        0 => format!("{before}  AD CNST.9{}", &after["  AD CNST.".len()..]),
        1 => format!("{before}  AD CNST.7\n{after}"),
        2 => format!("{before}  AD UNKNOWN{turn}\n{after}"),
        _ => format!("{before};nothing new\n{after}"),
    }
}
