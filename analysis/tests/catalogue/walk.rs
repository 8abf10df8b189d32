//! A walk through the catalogue: each entry checks clean in each of its forms and with each operand that its
//! specification allows, hovers in both languages, completes, has signature help, and rejects wrong operands.
//!
//! Lines are made from the data of the catalogue and stand in a frame program with one name of each kind; nothing is
//! left out but what the lists of exceptions name, each with its reason.

use std::fmt::Write as _;

use technol_analysis::catalogue::{Entry, EntryKind, OperandKind, entries, entry, page};
use technol_analysis::{AnalysisHost, Diagnostic, Language, Position, Severity};

use super::program::{MAIN, Program, check, project, shown};
use super::settings::{Section, Setting, is_within, setting};
use super::{forms, samples};

/// What a form or operand is warned of by design: entry, code, reason. Each must come.
const WARNED: &[(&str, &str, &str)] = &[
    ("SPI_AX", "T1105", "the form without an axis means the last one"),
    ("ANALOG_PORT", "T1106", "a port in a cell is not checked"),
];

/// Operands that fit their place but not what stands beside them: entry, operand, its text, reason.
const BESIDE_OTHERS: &[(&str, &str, &str, &str)] = &[
    ("MV", "src", "W_WORD", "shorter than the count"),
    ("MV", "dest", "W_WORD", "shorter than the count"),
    ("MV", "num", "16777215", "longer than the memory"),
    ("MEMCPY", "num", "16777215", "longer than the buffers"),
    ("MEMCMP", "num", "16777215", "longer than the buffers"),
    ("CLEAR", "begin", "W_AREA[BX]", "the range is known when it is built"),
    ("CLEAR", "end", "W_AREA[BX]", "the range is known when it is built"),
    ("CLEAR", "begin", "GLOBAL", "only with ALL, as a form has it"),
    ("CLEAR", "begin", "INTERNAL", "only with ALL, as a form has it"),
    ("CLEAR", "end", "ALL", "only with GLOBAL or INTERNAL, as forms have it"),
    ("STR", "n", "1048575", "longer than the memory it lies over"),
    ("END_T_MACRO", "stackflag", "T_PUSH", "the body must leave a value"),
    ("END_T_MACRO", "stackflag", "T_POP", "the body must take a value"),
    ("SA_READ", "size", "32000", "longer than the memory"),
    ("SA_READ", "cell", "W_WORD", "shorter than the size"),
    ("SA_WRITE", "size", "32000", "longer than the memory"),
    ("SA_WRITE", "cell", "W_WORD", "shorter than the size"),
    ("SHARE_VAR", "cell", "W_WORD", "shorter than the length"),
    ("SHARE_VAR", "min", "32000", "longer than the memory"),
    ("COM_SEND_STR", "buffer", "W_WORD", "shorter than the count"),
    ("COM_SEND_STR", "length", "65535", "longer than the buffer"),
];

/// Operands whose wrong values are no mistake of the operand: entry, operand, reason.
const TAKES_ANY_WORD: &[(&str, &str, &str)] =
    &[("T_INCLUDE", "file", "any word is the name of a file; a missing file is T0009: projects.rs")];

/// A line under test.
struct Case {
    line: String,
    setting: Setting,
}

impl Case {
    fn new(entry: &Entry, line: String, case: usize) -> Case {
        let body = without_label(&line);
        let operands = body.trim().split_once(' ').map_or("", |(_, operands)| operands.trim());
        let mut setting = setting(entry, operands, !operands.is_empty(), case);
        let label = format!("W_LABEL{case}");
        if line.contains(&label) {
            setting.after = format!("{}\n{label}:", setting.after);
        }
        Case { line, setting }
    }
}

/// The line from its operation on: behind `NAME: `, or behind the name of a structure or member.
fn without_label(line: &str) -> &str {
    let first = first_word(line);
    let rest = line[first.len()..].trim_start();
    let named = first.ends_with(':') || STRUCTURE_WORDS.contains(&first_word(rest));
    if named { rest } else { line }
}

/// Words that stand behind the name they declare.
const STRUCTURE_WORDS: &[&str] = &["STRUC", "ENDS", "DB", "DW", "DD", "DQ"];

fn first_word(line: &str) -> &str {
    line.split_whitespace().next().unwrap_or_default()
}

/// The section that a first or last line belongs to.
fn without_end(word: &str) -> &str {
    word.strip_suffix("_END").unwrap_or(word)
}

/// A program with all the cases; each line ends with `;@` and its number.
fn program(cases: &[Case]) -> String {
    let mut frame = Program::default();
    samples::DATA.lines().for_each(|line| frame.add("DATA", line));
    samples::INIT.lines().for_each(|line| frame.add("MODULE_INIT", line));
    let mut sequence = Vec::new();
    for (number, Case { line, setting }) in cases.iter().enumerate() {
        let marked = format!("{line} ;@{number}");
        let lines = setting.before.lines().chain([marked.as_str()]).chain(setting.after.lines());
        match setting.section {
            Section::Before => lines.for_each(|line| frame.before(line)),
            Section::Of(section) => lines.for_each(|line| frame.add(section, line)),
            Section::Sequence => sequence.extend(lines.map(str::to_string)),
            Section::Frame if line == "STOP" => {}
            Section::Frame => frame.add_section(without_end(first_word(line))),
        }
    }
    if !sequence.is_empty() {
        frame.add("MODULE_MAIN", "MECH_BEGIN W_WALK");
        for line in &sequence {
            frame.add("MODULE_MAIN", line);
        }
        frame.add("MODULE_MAIN", "MECH_END W_WALK");
    }
    samples::MAIN.lines().for_each(|line| frame.add("MODULE_MAIN", line));
    let mut text = frame.text();
    for (number, case) in cases.iter().enumerate().filter(|(_, case)| case.setting.section == Section::Frame)
    {
        text = text.replacen(&format!("\n{}\n", case.line), &format!("\n{} ;@{number}\n", case.line), 1);
        if let Some(rest) = text.strip_prefix(&format!("{}\n", case.line)) {
            text = format!("{} ;@{number}\n{rest}", case.line);
        }
    }
    text
}

fn host_of(cases: &[Case]) -> (String, AnalysisHost) {
    let text = program(cases);
    let host = project(&text);
    (text, host)
}

/// The row of a case.
fn row(text: &str, number: usize) -> u32 {
    let mark = format!(";@{number}");
    let row = text.lines().position(|line| line.ends_with(&mark));
    row.unwrap_or_else(|| panic!("case {number} is not in\n{text}")) as u32
}

fn line_of(text: &str, row: u32) -> &str {
    text.lines().nth(row as usize).expect("a row of the text")
}

/// Instructions and what else stands first in a line.
fn is_operation(entry: &Entry) -> bool {
    !matches!(entry.kind, EntryKind::TypePrefix | EntryKind::Keyword | EntryKind::EventProcedure)
}

/// The instruction of a line.
fn entry_of(line: &str) -> Option<&'static Entry> {
    entry(first_word(without_label(line))).filter(|entry| is_operation(entry))
}

/// The lines of each form; the error says what is not understood.
fn lines_of_forms(entry: &'static Entry) -> Result<Vec<String>, String> {
    let mut lines = Vec::new();
    for form in entry.forms {
        for variant in forms::variants(form.syntax) {
            let typed = variant.contains("TYPE.");
            let prefixes: Vec<_> =
                if typed { forms::prefixes(entry).into_iter().map(Some).collect() } else { vec![None] };
            if prefixes.is_empty() {
                return Err(format!("{}: no prefix fits {variant}", entry.name));
            }
            let carried = forms::carried(&variant);
            let of = if is_operation(entry) { entry } else { entry_of(&carried).unwrap_or(entry) };
            for prefix in prefixes {
                let line = forms::line(of, &carried, lines.len(), prefix);
                lines.push(line.map_err(|word| format!("{}: what is {word} in {variant}?", entry.name))?);
            }
        }
    }
    Ok(lines)
}

/// The cases of an entry's forms.
fn cases_of_forms(entry: &'static Entry) -> Result<Vec<Case>, String> {
    let case = |(number, line): (usize, String)| {
        let of = if is_within(entry) { entry } else { entry_of(&line).unwrap_or(entry) };
        Case::new(of, line, number)
    };
    Ok(lines_of_forms(entry)?.into_iter().enumerate().map(case).collect())
}

/// A line with these operands.
fn compose(entry: &Entry, operands: &[String], case: usize) -> String {
    let name = entry.name;
    let operands = operands.join(",");
    match name {
        "DS" | "STR" | "DFM" => format!("W_NEW{case}: {name} {operands}"),
        "STRUC" | "ENDS" | "DB" | "DW" | "DD" | "DQ" => format!("W_NEW{case} {name} {operands}"),
        _ => format!("{name} {operands}"),
    }
    .trim_end()
    .to_string()
}

/// All operands, each as something that fits.
fn usual(entry: &Entry, case: usize) -> Vec<String> {
    let around = samples::Around { case, ..samples::Around::default() };
    let mut operands: Vec<String> =
        entry.operands.iter().map(|operand| samples::fitting(entry, operand, around)).collect();
    for (at, operand) in entry.operands.iter().enumerate().filter(|(_, it)| it.kind == OperandKind::NewBit) {
        operands[at] = format!("W_NEW{case}_{}", operand.name);
    }
    operands
}

/// The cases with each operand that the specification allows.
fn cases_of_operands(entry: &'static Entry) -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    let mut add = |operands: &dyn Fn(usize) -> Vec<String>| {
        let number = cases.len();
        let line = compose(entry, &operands(number), number);
        cases.push(Case::new(entry, line, number));
    };
    add(&|number| usual(entry, number));
    for (at, operand) in entry.operands.iter().enumerate() {
        for text in samples::samples(operand) {
            let excepted = |(name, of, it, _): &(&str, &str, &str, &str)| {
                *name == entry.name && *of == operand.name && *it == text
            };
            if BESIDE_OTHERS.iter().any(excepted) {
                continue;
            }
            add(&|number| {
                let mut operands = usual(entry, number);
                // Both operands of MOVE have one type, and so have counter and time.
                let timed = matches!(entry.name, "TIM" | "TEX0" | "TEX1") && text == "W_BYTE";
                let together = matches!(entry.name, "MOVE" | "MOVE1") || timed && at < 2;
                let places = if together { 0..2 } else { at..at + 1 };
                operands[places].fill(text.clone());
                operands
            });
        }
    }
    cases
}

/// Whether the findings are those that are expected of an entry; what is wrong when not.
fn unexpected(entry: &Entry, text: &str, mut found: Vec<Diagnostic>) -> Option<String> {
    let warned = |d: &Diagnostic| WARNED.iter().any(|(name, code, _)| *name == entry.name && *code == d.code);
    found.retain(|d| !warned(d));
    (!found.is_empty()).then(|| {
        format!(
            "{}:
{}",
            entry.name,
            shown(text, &found)
        )
    })
}

#[test]
fn every_form_checks_clean_where_it_belongs() {
    let mut report = String::new();
    let mut count = 0;
    for entry in entries() {
        let cases = cases_of_forms(entry).unwrap_or_else(|why| {
            writeln!(report, "{why}").expect("a String");
            Vec::new()
        });
        let (text, host) = host_of(&cases);
        let found = check(&host);
        count += cases.len();
        report.extend(unexpected(entry, &text, found));
    }
    assert!(report.is_empty(), "\n{report}");
    assert!(count > 750, "only {count} lines");
}

#[test]
fn every_operand_that_the_specification_allows_checks_clean() {
    let mut report = String::new();
    let mut count = 0;
    for entry in entries().filter(|entry| !entry.operands.is_empty() && !takes_anything(entry)) {
        let cases = cases_of_operands(entry);
        let (text, host) = host_of(&cases);
        count += cases.len();
        report.extend(unexpected(entry, &text, check(&host)));
    }
    assert!(report.is_empty(), "\n{report}");
    assert!(count > 2500, "only {count} lines");
}

#[test]
fn every_expected_warning_comes() {
    for (name, code, reason) in WARNED {
        let entry = entry(name).unwrap_or_else(|| panic!("{name} is no entry"));
        let forms = cases_of_forms(entry).expect("every_form_checks_clean tells");
        let comes = [forms, cases_of_operands(entry)].iter().any(|cases| {
            let (_, host) = host_of(cases);
            check(&host).iter().any(|d| d.code == *code)
        });
        assert!(comes, "{name} is no longer warned with {code}: {reason}");
    }
}

/// Instructions of the 80386, which have operands of their own kind.
fn takes_anything(entry: &Entry) -> bool {
    entry.operands.iter().any(|operand| operand.kind == OperandKind::Any)
}

/// Groups of rules that may reject an operand: form of a line, declarations, names, operands, structure (the name at
/// the end of a block), macros.
const REJECTS: [&str; 6] = ["T01", "T02", "T03", "T04", "T06", "T10"];

#[test]
fn every_operand_rejects_what_does_not_fit() {
    let mut report = String::new();
    let mut count = 0;
    for entry in entries().filter(|entry| !takes_anything(entry)) {
        for (at, operand) in entry.operands.iter().enumerate() {
            if TAKES_ANY_WORD.iter().any(|(name, of, _)| *name == entry.name && *of == operand.name) {
                continue;
            }
            let wrong = samples::wrong(operand.kind);
            assert!(!wrong.is_empty(), "{} has no wrong {}", entry.name, operand.name);
            let case = |(number, text): (usize, &String)| {
                let mut operands = usual(entry, number);
                operands[at].clone_from(text);
                Case::new(entry, compose(entry, &operands, number), number)
            };
            let cases: Vec<Case> = wrong.iter().enumerate().map(case).collect();
            let (text, host) = host_of(&cases);
            let found = check(&host);
            for (number, wrong) in wrong.iter().enumerate() {
                count += 1;
                let row = row(&text, number);
                let columns = columns_of(line_of(&text, row), at);
                let rejects = |d: &&Diagnostic| {
                    d.span.start.line == row
                        && d.severity == Severity::Error
                        && REJECTS.iter().any(|group| d.code.starts_with(group))
                        && d.span.start.column < columns.end.max(columns.start + 1)
                        && d.span.end.column >= columns.start
                };
                if !found.iter().any(|d| rejects(&d)) {
                    let here: Vec<Diagnostic> =
                        found.iter().filter(|d| d.span.start.line == row).cloned().collect();
                    let name = operand.name;
                    writeln!(
                        report,
                        "{} {name} takes {wrong}:\n    | {}\n{}",
                        entry.name,
                        line_of(&text, row),
                        shown(&text, &here)
                    )
                    .expect("a String");
                }
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
    assert!(count > 1500, "only {count} lines");
}

/// Columns of an operand in a line; commas inside texts do not occur here.
fn columns_of(line: &str, at: usize) -> std::ops::Range<u32> {
    let code = line.split(';').next().unwrap_or_default();
    let body = without_label(code);
    let start = code.len() - body.len();
    let mut words = body.splitn(2, ' ');
    let operation = words.next().unwrap_or_default();
    let mut from = start + operation.len() + 1;
    for (number, operand) in words.next().unwrap_or_default().split(',').enumerate() {
        if number == at {
            return from as u32..(from + operand.trim_end().len()) as u32;
        }
        from += operand.len() + 1;
    }
    panic!("operand {at} is not in {line}")
}

#[test]
fn every_word_shows_its_page_in_both_languages() {
    let mut report = String::new();
    for entry in entries() {
        let cases = cases_of_forms(entry).expect("every_form_checks_clean tells");
        let (text, host) = host_of(&cases);
        for number in 0..cases.len() {
            let row = row(&text, number);
            let Some(column) = find_word(line_of(&text, row), entry.name) else {
                continue; // a form of another instruction
            };
            for language in [Language::En, Language::Cs] {
                let at = Position { line: row, column };
                let hover = host.analysis().hover(MAIN, at, language).expect("not cancelled");
                let page = page::markdown(entry, language);
                if !hover.is_some_and(|hover| hover.markdown.contains(&page)) {
                    writeln!(report, "{}: {}", entry.name, line_of(&text, row)).expect("a String");
                }
            }
        }
        let shown = (0..cases.len())
            .any(|number| find_word(line_of(&text, row(&text, number)), entry.name).is_some());
        assert!(shown || entry.is_known_only(), "{} is in none of its forms", entry.name);
    }
    assert!(report.is_empty(), "\n{report}");
}

/// Where a word stands by itself.
fn find_word(line: &str, word: &str) -> Option<u32> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let code = line.split(';').next().unwrap_or_default();
    code.match_indices(word)
        .find(|(at, _)| !code[..*at].ends_with(is_word) && !code[at + word.len()..].starts_with(is_word))
        .map(|(at, _)| at as u32)
}

#[test]
fn every_word_is_offered_when_its_beginning_is_typed() {
    let mut report = String::new();
    for entry in entries() {
        let cases = cases_of_forms(entry).expect("every_form_checks_clean tells");
        let Some((number, column)) = cases
            .iter()
            .enumerate()
            .find_map(|(number, case)| find_word(&case.line, entry.name).map(|column| (number, column)))
        else {
            assert!(entry.is_known_only(), "{} is in none of its forms", entry.name);
            continue;
        };
        let typed = &entry.name[..entry.name.len().div_ceil(2)];
        let case = &cases[number];
        let line = format!("{}{typed}", &case.line[..column as usize]);
        let typing = Case { line: line.clone(), setting: typed_at(entry, case) };
        let text = program(&[typing]);
        let row = row(&text, 0);
        let host = project(&text);
        let at = Position { line: row, column: line.len() as u32 };
        let offered = host.analysis().completion(MAIN, at, Language::En).expect("not cancelled");
        // Prefixes are offered with their dot, TMAC with a parameter behind it.
        let label = |label: &str| label.split('.').next() == Some(entry.name);
        if !offered.iter().any(|it| label(&it.label)) {
            writeln!(report, "{}: {line} in {:?}", entry.name, case.setting.section).expect("a String");
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

/// Where the beginning of a word is typed: a closing word inside of what it closes, an opening one between modules.
fn typed_at(entry: &Entry, case: &Case) -> Setting {
    let mut setting = case.setting.clone();
    if setting.section == Section::Frame {
        let closes = entry.name.strip_suffix("_END");
        setting.section = closes.map_or(Section::Before, Section::Of);
    }
    setting
}

#[test]
fn every_instruction_with_operands_has_signature_help_for_each() {
    let mut report = String::new();
    for entry in entries().filter(|entry| is_operation(entry)) {
        let operands = usual(entry, 0);
        let line = compose(entry, &operands, 0);
        let (text, host) = host_of(&[Case::new(entry, line, 0)]);
        let row = row(&text, 0);
        for (at, operand) in entry.operands.iter().enumerate() {
            for language in [Language::En, Language::Cs] {
                let column = columns_of(line_of(&text, row), at).start;
                let at_operand = Position { line: row, column };
                let help = host.analysis().signature_help(MAIN, at_operand, language).expect("not cancelled");
                let active = help.and_then(|help| {
                    let active = help.parameters.get(help.active? as usize)?.clone();
                    Some(help.label[active.label.0 as usize..active.label.1 as usize].to_string())
                });
                if !active.as_ref().is_some_and(|active| active.contains(operand.name)) {
                    writeln!(report, "{}: {} is {active:?}", entry.name, operand.name).expect("a String");
                }
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
}
