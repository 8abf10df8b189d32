//! Comments that allow what a rule reports: `;technol: allow(T0123)`.
//!
//! Behind code the comment holds for its line; on a line of its own for the next line with an operation, and when that
//! line opens a section, for the whole section. `;technol: allow-file(T0123)` in the first comment block holds for the
//! file. A comment that allows nothing is reported itself.

use std::collections::HashMap;

use super::rules::{self, allow};
use super::{Diagnostic, Finding, Fix, Rule};
use crate::database::{self, Db, Section, SourceFile};
use crate::location::Span;
use crate::syntax::ast::{Columns, Line};

const MARK: &str = "technol:";

/// The comments of one section.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Allows {
    /// Comments that allow something.
    comments: Vec<Comment>,
    /// Comments that begin with the mark and cannot be read: own line, columns, what is wrong.
    bad: Vec<(u32, Columns, &'static str)>,
}

/// A comment that allows something.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Comment {
    /// 0-based own line.
    line: u32,
    /// Its columns, from the semicolon to the closing bracket.
    columns: Columns,
    /// It holds for the file.
    file: bool,
    /// Nothing but the comment stands on the line.
    alone: bool,
    /// Codes or names of rules with their columns.
    rules: Vec<(Columns, String)>,
}

/// The comments in the lines of a section.
pub(crate) fn read(lines: &[Line], text: &str) -> Allows {
    let mut allows = Allows::default();
    if !text.contains(MARK) {
        return allows;
    }
    for (number, (line, source)) in lines.iter().zip(crate::syntax::lines(text)).enumerate() {
        let Some(columns) = line.comment.clone() else { continue };
        let Some(comment) = source.text.get(columns.start as usize..) else { continue };
        let own = number as u32;
        match Reading::of(comment, columns.start) {
            None => {}
            Some(Err(why)) => allows.bad.push((own, columns, why)),
            Some(Ok(reading)) => allows.comments.push(Comment {
                line: own,
                columns: columns.start..reading.end,
                file: reading.file,
                alone: line.label.is_none() && line.operation.is_none(),
                rules: reading.rules,
            }),
        }
    }
    allows
}

/// What a comment says.
struct Reading {
    file: bool,
    rules: Vec<(Columns, String)>,
    /// Column behind the closing bracket.
    end: u32,
}

impl Reading {
    /// `None` for a comment that is meant for readers only. `start` is its column.
    fn of(comment: &str, start: u32) -> Option<Result<Reading, &'static str>> {
        let said = comment.trim_start_matches([';', ' ', '\t']).strip_prefix(MARK)?.trim_start();
        let (file, rest) = match said.strip_prefix("allow-file") {
            Some(rest) => (true, rest),
            None => match said.strip_prefix("allow") {
                Some(rest) => (false, rest),
                None => return Some(Err("only allow(…) and allow-file(…) are known here")),
            },
        };
        let Some(inner) = rest.trim_start().strip_prefix('(') else {
            return Some(Err("the rules stand in brackets: allow(T0123)"));
        };
        let Some(close) = inner.find(')') else { return Some(Err("the closing bracket is missing")) };
        let first = start + (comment.len() - inner.len()) as u32;
        let mut rules = Vec::new();
        let mut at = first;
        for part in inner[..close].split(',') {
            let name = part.trim();
            let begin = at + (part.len() - part.trim_start().len()) as u32;
            if name.is_empty() {
                return Some(Err("a rule is missing in the brackets: allow(T0123)"));
            }
            rules.push((begin..begin + name.len() as u32, name.to_string()));
            at += part.len() as u32 + 1;
        }
        Some(Ok(Reading { file, rules, end: first + close as u32 + 1 }))
    }
}

/// Where a comment holds.
enum Reach<'db> {
    File,
    Section(Section<'db>),
    Line(Section<'db>, u32),
    Nowhere,
}

/// One rule that a comment allows.
struct Permit<'db> {
    section: Section<'db>,
    comment: &'db Comment,
    /// Index in its rules.
    index: usize,
    rule: &'static Rule,
    used: bool,
}

/// Takes out what comments of the file allow, and adds what is wrong with them.
pub(super) fn apply<'db>(db: &'db dyn Db, file: SourceFile, found: &mut Vec<(Section<'db>, Finding)>) {
    if !file.text(db).contains(MARK) {
        return;
    }
    let sections = database::sections(db, file);
    let mut outer = HashMap::new();
    for section in sections {
        outer.extend(section.children(db).iter().map(|(child, _)| (*child, *section)));
    }
    let mut wrong = Vec::new();
    let mut permits: Vec<(Reach<'db>, Permit<'db>)> = Vec::new();
    for section in sections {
        let allows = database::section_allows(db, *section);
        for (line, columns, why) in &allows.bad {
            wrong.push((*section, Finding::new(&allow::BAD_ALLOW, *line, columns.clone(), *why)));
        }
        for comment in &allows.comments {
            if comment.file && !in_first_block(db, sections, *section, comment) {
                let message = "allow-file stands in the first comment block of its file; move it there";
                let finding = Finding::new(&allow::BAD_ALLOW, comment.line, comment.columns.clone(), message);
                wrong.push((*section, finding));
                continue;
            }
            permits_of(db, *section, comment, &mut permits, &mut wrong);
        }
    }
    found.retain(|(section, finding)| {
        let mut allowed = false;
        for (reach, permit) in permits.iter_mut().filter(|(_, permit)| permit.rule == finding.rule) {
            let holds = match reach {
                Reach::File => true,
                Reach::Section(whole) => {
                    std::iter::successors(Some(*section), |inner| outer.get(inner).copied())
                        .any(|around| around == *whole)
                }
                Reach::Line(own, line) => own == section && *line == finding.line,
                Reach::Nowhere => false,
            };
            permit.used |= holds;
            allowed |= holds;
        }
        !allowed
    });
    found.extend(permits.iter().filter(|(_, permit)| !permit.used).map(|(_, permit)| {
        let message = format!("{} reports nothing here; remove it", permit.rule.code);
        (permit.section, without(permit.comment, permit.index, &allow::UNUSED_ALLOW, message))
    }));
    found.extend(wrong);
}

fn permits_of<'db>(
    db: &'db dyn Db,
    section: Section<'db>,
    comment: &'db Comment,
    permits: &mut Vec<(Reach<'db>, Permit<'db>)>,
    wrong: &mut Vec<(Section<'db>, Finding)>,
) {
    for (index, (columns, name)) in comment.rules.iter().enumerate() {
        let Some(rule) = rules::find(name) else {
            let message = format!("there is no rule {name}");
            wrong
                .push((section, Finding::new(&allow::UNKNOWN_ALLOW, comment.line, columns.clone(), message)));
            continue;
        };
        if !can_be_allowed(rule) {
            let message = format!("{} {} cannot be allowed", rule.code, rule.name);
            wrong.push((section, without(comment, index, &allow::ALLOW_FIXED, message)));
            continue;
        }
        let permit = Permit { section, comment, index, rule, used: false };
        permits.push((reach(db, section, comment), permit));
    }
}

fn can_be_allowed(rule: &Rule) -> bool {
    let own = [&allow::UNUSED_ALLOW, &allow::UNKNOWN_ALLOW, &allow::ALLOW_FIXED, &allow::BAD_ALLOW];
    !rule.fixed && !own.contains(&rule)
}

fn reach<'db>(db: &'db dyn Db, section: Section<'db>, comment: &Comment) -> Reach<'db> {
    if comment.file {
        return Reach::File;
    }
    if !comment.alone {
        return Reach::Line(section, comment.line);
    }
    let lines = &database::section_lines(db, section).lines;
    let behind = comment.line + 1;
    let next = (behind..lines.len() as u32).find(|line| lines[*line as usize].operation.is_some());
    let inner = section.children(db).iter().find(|(_, before)| *before >= behind);
    match (inner, next) {
        (Some((child, before)), Some(next)) if *before <= next => Reach::Section(*child),
        (Some((child, _)), None) => Reach::Section(*child),
        (_, Some(next)) => Reach::Line(section, next),
        (None, None) => Reach::Nowhere,
    }
}

/// Before anything but comments: in the File section, and before its first operation and its first child.
fn in_first_block(db: &dyn Db, sections: &[Section<'_>], section: Section<'_>, comment: &Comment) -> bool {
    let lines = &database::section_lines(db, section).lines;
    let code = lines.iter().position(|line| line.operation.is_some() || line.label.is_some());
    sections.first() == Some(&section)
        && comment.alone
        && code.is_none_or(|code| comment.line < code as u32)
        && section.children(db).first().is_none_or(|(_, before)| comment.line < *before)
}

/// A finding at one rule of a comment, with the fix that takes it out.
fn without(comment: &Comment, index: usize, rule: &'static Rule, message: String) -> Finding {
    let finding = Finding::new(rule, comment.line, comment.rules[index].0.clone(), message);
    let others: Vec<&str> = comment
        .rules
        .iter()
        .enumerate()
        .filter(|(at, _)| *at != index)
        .map(|(_, (_, name))| &**name)
        .collect();
    let word = if comment.file { "allow-file" } else { "allow" };
    let text = match others.as_slice() {
        [] => String::new(),
        others => format!(";{MARK} {word}({})", others.join(", ")),
    };
    finding.replace("remove it from the comment", comment.columns.clone(), text)
}

/// The edit that allows a diagnostic on its line; `None` when its rule cannot be allowed. `line` is the text of that
/// line without its end.
pub(crate) fn fix(diagnostic: &Diagnostic, line: &str) -> Option<Fix> {
    let rule = rules::rule(diagnostic.code).filter(|rule| can_be_allowed(rule))?;
    let parsed = crate::syntax::parse_lines(line);
    let parsed = parsed.lines.first()?;
    let number = diagnostic.span.start.line;
    let insert = |at: usize, text: String| {
        let at = at as u32;
        let title = format!("allow {} {} here", rule.code, rule.name);
        Some(Fix { title, edits: vec![(Span::in_line(number, at, at), text)] })
    };
    let Some(columns) = &parsed.comment else {
        let end = line.trim_end().len();
        return insert(end, format!(" ;{MARK} allow({})", rule.code));
    };
    let start = columns.start as usize;
    match Reading::of(line.get(start..)?, columns.start) {
        Some(Ok(reading)) if !reading.file => insert(reading.end as usize - 1, format!(", {}", rule.code)),
        _ => insert(start, format!(";{MARK} allow({}) ", rule.code)),
    }
}
