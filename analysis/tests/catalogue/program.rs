//! A complete program around a fragment, as `catalogue::Example` describes it: the fragment where it belongs, and the
//! plant of the help for the names it does not declare.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technol_analysis::catalogue::{self, Entry, OperandKind, Place};
use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change, Diagnostic, Severity};

/// The plant: each line declares one name, so that a fragment may declare that name itself.
const PLANT: &str = include_str!("../fixtures/catalogue/plant.plc");

/// Sections every first file has, in order.
const SECTIONS: &[&str] = &[
    "DATA",
    "MODULE_INPUT",
    "MODULE_BLOCK_INIT",
    "MODULE_BLOCK_DONE",
    "MODULE_MAIN",
    "MODULE_INIT",
    "MODULE_CLEAR",
    "MODULE_HALT",
];

/// The main file.
pub(crate) const MAIN: &str = "main.plc";

const MANIFEST: &str = "[project]\nname = \"help\"\nmain = \"main.plc\"\nsystem-dir = \"system\"\n";

struct Memory(BTreeMap<String, String>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let path = path.strip_prefix("help/").unwrap_or(path);
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }
}

/// The project of a main file; files that it includes are there and empty.
pub(crate) fn project(text: &str) -> AnalysisHost {
    let mut files = BTreeMap::from([
        ("technol.toml".to_string(), MANIFEST.to_string()),
        (MAIN.to_string(), text.to_string()),
    ]);
    for line in text.lines().filter(|line| first_word(line).eq_ignore_ascii_case("T_INCLUDE")) {
        let name = line.split_whitespace().nth(1).unwrap_or_default().replace('\\', "/");
        let path = match name.strip_prefix('\'') {
            Some(name) => format!("system/{}", name.trim_end_matches('\'')),
            None => name,
        };
        files.insert(path, String::new());
    }
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("help", &Memory(files))), texts: Vec::new() });
    host
}

/// Lints that judge a whole program: a fragment starts no mechanism, uses no result, resets no axis.
const OF_A_WHOLE_PROGRAM: std::ops::RangeInclusive<&str> = "T1111"..="T1199";

/// What is wrong with the main file.
pub(crate) fn check(host: &AnalysisHost) -> Vec<Diagnostic> {
    let found = host.analysis().diagnostics(MAIN).expect("nothing cancels it");
    let counts = |d: &Diagnostic| d.severity <= Severity::Warning && !OF_A_WHOLE_PROGRAM.contains(&d.code);
    found.into_iter().filter(counts).collect()
}

/// `line: code message` and the line itself.
pub(crate) fn shown(text: &str, found: &[Diagnostic]) -> String {
    let one = |d: &Diagnostic| {
        let line = d.span.start.line;
        let source = text.lines().nth(line as usize).unwrap_or_default();
        format!("    {} {}\n      | {source}\n", d.code, d.message)
    };
    found.iter().map(one).collect()
}

/// A program: the text of each section, without its first and last line, and what stands before DATA.
#[derive(Clone, Default)]
pub(crate) struct Program {
    before: String,
    sections: Vec<(String, String)>,
}

impl Program {
    /// The fragment alone, each line where it belongs.
    pub(crate) fn of(fragment: &str) -> Program {
        let mut program = Program::default();
        let mut loose = Loose::default();
        let mut open: Option<String> = None;
        for line in fragment.lines() {
            let word = first_word(line).to_ascii_uppercase();
            match &open {
                Some(section) if word == format!("{section}_END") => open = None,
                Some(section) => program.add(&section.clone(), line),
                None if is_section(&word) => {
                    program.add_section(&word);
                    open = Some(word);
                }
                None => loose.line(line, &mut program),
            }
        }
        loose.finish(&mut program);
        program
    }

    /// Adds a line to a section.
    pub(crate) fn add(&mut self, section: &str, line: &str) {
        self.add_section(section);
        let (_, text) = self.sections.iter_mut().find(|(name, _)| name == section).expect("added above");
        text.push_str(line);
        text.push('\n');
    }

    pub(crate) fn add_section(&mut self, section: &str) {
        if !self.sections.iter().any(|(name, _)| name == section) {
            self.sections.push((section.to_string(), String::new()));
        }
    }

    fn lines(&self) -> impl Iterator<Item = &str> {
        self.before.lines().chain(self.sections.iter().flat_map(|(_, text)| text.lines()))
    }

    /// Adds what the plant declares and this program does not.
    pub(crate) fn with_plant(mut self) -> Program {
        let own: Vec<String> = self.lines().flat_map(declared).collect();
        let taken = |lines: &[&str]| lines.iter().flat_map(|line| declared(line)).any(|it| own.contains(&it));
        let mut open: Option<&str> = None;
        let mut block: Vec<&str> = Vec::new();
        for line in PLANT.lines().filter(|line| !line.starts_with(';')) {
            let word = first_word(line);
            match open {
                None if is_section(word) => open = Some(word),
                None => {}
                Some(section) if word.strip_suffix("_END") == Some(section) => open = None,
                Some(section) => {
                    block.push(line);
                    let within = ["MECH_BEGIN", "PROC_BEGIN"].contains(&first_word(block[0]));
                    if within && !["MECH_END", "PROC_END"].contains(&word) {
                        continue;
                    }
                    if !taken(&block) {
                        for line in &block {
                            self.add(section, line);
                        }
                    }
                    block.clear();
                }
            }
        }
        self
    }

    /// The text of the file.
    pub(crate) fn text(&self) -> String {
        let mut text = self.before.clone();
        let body =
            |name: &str| self.sections.iter().find(|(own, _)| own == name).map_or("", |(_, text)| text);
        let further = self.sections.iter().map(|(name, _)| name.as_str());
        for name in SECTIONS.iter().copied().chain(further.filter(|name| !SECTIONS.contains(name))) {
            writeln!(text, "{name}\n{}{name}_END", body(name)).expect("a String");
        }
        text.push_str("STOP\n");
        text
    }
}

/// Lines outside of sections.
#[derive(Default)]
struct Loose {
    code: Vec<String>,
    /// Closing word of the block the line stands in.
    block: Option<&'static str>,
    /// Something in the code needs a mechanism.
    sequence: bool,
}

impl Loose {
    fn line(&mut self, line: &str, program: &mut Program) {
        let word = operation(line).to_ascii_uppercase();
        if let Some(end) = self.block {
            match end {
                "END_T_MACRO" => program.before(line),
                "ENDS" => program.add("DATA", line),
                _ => program.add("MODULE_MAIN", line),
            }
            if word == end {
                self.block = None;
            }
            return;
        }
        let entry = catalogue::entry(&word);
        let place = entry.map(|entry| entry.place);
        match (word.as_str(), place) {
            ("MECH_BEGIN", _) => self.open("MECH_END", "MODULE_MAIN", line, program),
            ("PROC_BEGIN", _) => self.open("PROC_END", "MODULE_MAIN", line, program),
            ("STRUC", _) => self.open("ENDS", "DATA", line, program),
            ("DEF_T_MACRO", _) => {
                program.before(line);
                self.block = Some("END_T_MACRO");
            }
            ("STOP", _) => {}
            ("STR", _) | (_, Some(Place::Data | Place::DataOrFileLevel)) => program.add("DATA", line),
            (_, Some(Place::Init | Place::InitOrProcedure)) => program.add("MODULE_INIT", line),
            ("CHECK", _) => self.code.push(line.to_string()),
            (_, Some(Place::Anywhere | Place::FileLevel)) => program.before(line),
            _ => {
                self.sequence |= place == Some(Place::Sequence);
                self.code.push(line.to_string());
            }
        }
    }

    fn open(&mut self, end: &'static str, section: &str, line: &str, program: &mut Program) {
        program.add(section, line);
        self.block = Some(end);
    }

    fn finish(mut self, program: &mut Program) {
        if self.code.is_empty() {
            return;
        }
        let labels: Vec<String> = self.code.iter().filter_map(|line| label(line)).collect();
        let missing: Vec<String> =
            self.code.iter().flat_map(|line| jumps(line)).filter(|it| !labels.contains(it)).collect();
        self.code.extend(missing.into_iter().map(|label| format!("{label}:")));
        if self.sequence {
            self.code.insert(0, "MECH_BEGIN FRAGMENT".to_string());
            self.code.push("MECH_END FRAGMENT".to_string());
        }
        self.code.iter().for_each(|line| program.add("MODULE_MAIN", line));
    }
}

impl Program {
    pub(crate) fn before(&mut self, line: &str) {
        self.before.push_str(line);
        self.before.push('\n');
    }
}

fn is_section(word: &str) -> bool {
    matches!(word, "DATA" | "DATA_LOCAL")
        || word.starts_with("MODULE_") && !word.ends_with("_END") && !word.ends_with("_FINISHED")
}

fn first_word(line: &str) -> &str {
    line.split_whitespace().next().unwrap_or_default()
}

/// The label before the operation.
fn label(line: &str) -> Option<String> {
    let (before, _) = line.split_once(':')?;
    (!before.contains([';', '\'', ' '])).then(|| before.to_ascii_uppercase())
}

/// The line behind its label.
fn without_label(line: &str) -> &str {
    if label(line).is_some() { line.split_once(':').map_or("", |(_, rest)| rest) } else { line }
}

/// The operation; the second word of the lines of a structure, whose name stands first.
fn operation(line: &str) -> &str {
    let mut words = without_label(line).split_whitespace();
    let first = words.next().unwrap_or_default();
    let structure = |word: &&str| ["STRUC", "ENDS"].contains(word);
    words.next().filter(structure).unwrap_or(first)
}

/// Operands, cut at commas outside of texts, without a comment.
fn operands(line: &str) -> Vec<String> {
    let rest = without_label(line).trim_start();
    let rest = rest.strip_prefix(first_word(rest)).unwrap_or_default();
    let mut operands = vec![String::new()];
    let mut text = false;
    for c in rest.chars() {
        text ^= c == '\'';
        match c {
            ';' if !text => break,
            ',' if !text => operands.push(String::new()),
            _ => operands.last_mut().expect("never empty").push(c),
        }
    }
    operands.into_iter().map(|operand| operand.trim().to_ascii_uppercase()).collect()
}

/// Labels that a line jumps to.
fn jumps(line: &str) -> Vec<String> {
    let Some(entry) = catalogue::entry(operation(line)) else { return Vec::new() };
    let operands = operands(line);
    let at_label = |(at, _): &(usize, &String)| {
        entry.operands.get(*at).is_some_and(|operand| operand.kind == OperandKind::Label)
    };
    operands.iter().enumerate().filter(at_label).map(|(_, operand)| operand.clone()).collect()
}

/// Names that a line of DATA, MODULE_INIT or MODULE_MAIN declares for the whole project.
fn declared(line: &str) -> Vec<String> {
    let operation = operation(line).to_ascii_uppercase();
    let operands = operands(line);
    let first = || {
        let name = operands.first().map_or("", |operand| operand.as_str());
        let end = name.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(name.len());
        vec![name[..end].to_string()]
    };
    let declares = |entry: &Entry| {
        entry.operands.first().is_some_and(|operand| {
            matches!(
                operand.kind,
                OperandKind::Declares(_)
                    | OperandKind::NewName
                    | OperandKind::Mechanism { declares: true }
                    | OperandKind::Procedure { declares: true }
            )
        })
    };
    match operation.as_str() {
        "DFM" => operands.into_iter().chain(label(line)).filter(|name| !name.is_empty()).collect(),
        "DS" | "STR" => label(line).into_iter().collect(),
        "STRUC" | "DB" | "DW" | "DD" | "DQ" => vec![first_word(line).to_ascii_uppercase()],
        _ if catalogue::entry(&operation).is_some_and(declares) => first(),
        _ => Vec::new(),
    }
}
