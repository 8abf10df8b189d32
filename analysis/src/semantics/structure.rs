//! The structure of a program file: which modules, in which order, closed by what (manual 5.1 to 5.4).

use technol_image::program::ModuleKind;

use super::suggest;
use crate::catalogue::{self, EntryKind};
use crate::database::{self, Db, Section, SourceFile};
use crate::diagnostics::Finding;
use crate::diagnostics::rules::{lints, macros, structure as rules};
use crate::syntax::ast::{Columns, ExprKind, Line};
use crate::syntax::section::SectionKind;

const MAIN_FILE: &[SectionKind] = &[
    SectionKind::Data,
    SectionKind::Module(ModuleKind::Input),
    SectionKind::Module(ModuleKind::BlockInit),
    SectionKind::Module(ModuleKind::BlockDone),
    SectionKind::Module(ModuleKind::Main),
    SectionKind::Module(ModuleKind::Init),
    SectionKind::Module(ModuleKind::Clear),
    SectionKind::Module(ModuleKind::Halt),
];
const FURTHER_FILE: &[SectionKind] = &[SectionKind::Data, SectionKind::Module(ModuleKind::Main)];

/// The keyword that opens a section.
#[must_use]
pub const fn opening(kind: SectionKind) -> &'static str {
    match kind {
        SectionKind::File => "",
        SectionKind::Data => "DATA",
        SectionKind::DataLocal => "DATA_LOCAL",
        SectionKind::Module(module) => module.keyword(),
        SectionKind::Mechanism => "MECH_BEGIN",
        SectionKind::Procedure => "PROC_BEGIN",
        SectionKind::Macro => "DEF_T_MACRO",
    }
}

/// The keyword that closes a section.
#[must_use]
pub fn closing(kind: SectionKind) -> String {
    match kind {
        SectionKind::Mechanism => "MECH_END".to_string(),
        SectionKind::Procedure => "PROC_END".to_string(),
        SectionKind::Macro => "END_T_MACRO".to_string(),
        other => format!("{}_END", opening(other)),
    }
}

/// What the structure of a file needs to know of the lines of a section.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// Closing lines: own line, columns of the keyword, keyword in upper case, key of the name behind it.
    ends: Vec<(u32, Columns, String, String)>,
    /// Keywords that unknown words were probably meant to be; the words are reported as unknown.
    misspelled: Vec<&'static str>,
    /// STOP lines.
    stops: Vec<(u32, Columns)>,
    /// DEBUG lines, and whether they switch break-points on.
    debugs: Vec<(u32, Columns, bool)>,
    /// Last line with an operation.
    last: Option<(u32, Columns)>,
}

/// The outline of a section's lines.
pub(crate) fn outline(lines: &[Line]) -> Outline {
    let mut outline = Outline::default();
    for (number, line) in lines.iter().enumerate() {
        let Some(operation) = &line.operation else { continue };
        let at = (number as u32, operation.columns.clone());
        match catalogue::entry(&operation.text) {
            Some(entry) if matches!(entry.kind, EntryKind::Structure | EntryKind::Directive) => {
                if entry.name.ends_with("_END") || entry.name == "END_T_MACRO" {
                    outline.ends.push((at.0, at.1.clone(), entry.name.to_string(), first_name(line)));
                } else if entry.name == "STOP" {
                    outline.stops.push(at.clone());
                } else if entry.name == "DEBUG" {
                    outline.debugs.push((at.0, at.1.clone(), first_name(line) != "OFF"));
                }
            }
            Some(_) => {}
            None => {
                let known = catalogue::entries().map(|entry| entry.name);
                let near = suggest::nearest(&operation.text, known).and_then(catalogue::entry);
                outline.misspelled.extend(near.filter(|e| e.kind == EntryKind::Structure).map(|e| e.name));
            }
        }
        outline.last = Some(at);
    }
    outline
}

/// Mistakes in the structure of a file, each in the section it belongs to.
pub(crate) fn check(db: &dyn Db, file: SourceFile) -> Vec<(Section<'_>, Finding)> {
    let mut check = Check { db, sections: database::sections(db, file), found: Vec::new() };
    let strays = check.stray_ends();
    let misspelled = check.misspelled();
    check.unclosed(&strays, &misspelled);
    check.wrong_ends();
    check.report_strays(&strays, &misspelled);
    check.debug_left_on();
    if let Some(order) = file.order(db) {
        check.modules(order, &strays, &misspelled);
        check.data_first();
        check.stop(order);
    }
    check.found
}

struct Check<'db> {
    db: &'db dyn Db,
    sections: &'db [Section<'db>],
    found: Vec<(Section<'db>, Finding)>,
}

/// A closing line without a section.
struct Stray<'db> {
    section: Section<'db>,
    line: u32,
    columns: Columns,
    /// Closing keyword, upper case.
    keyword: String,
    /// Key of the name behind it.
    name: String,
}

/// A word near a structure keyword: the keyword it was meant to be.
struct Misspelled<'db> {
    section: Section<'db>,
    keyword: &'static str,
}

impl<'db> Check<'db> {
    fn lines(&self, section: Section<'db>) -> &'db [Line] {
        &database::section_lines(self.db, section).lines
    }

    fn opening_columns(&self, section: Section<'db>) -> Columns {
        let line = self.lines(section).first();
        line.map_or(0..0, |line| line.operation.as_ref().map_or(0..line.len, |name| name.columns.clone()))
    }

    fn add(&mut self, section: Section<'db>, finding: Finding) {
        self.found.push((section, finding));
    }

    fn outline(&self, section: Section<'db>) -> &'db Outline {
        database::section_outline(self.db, section)
    }

    fn stray_ends(&self) -> Vec<Stray<'db>> {
        let mut strays = Vec::new();
        for section in self.sections.iter().filter(|s| s.kind(self.db) != SectionKind::Macro) {
            let outline = self.outline(*section);
            // The last line of a closed section is its own closing line.
            let closed = section.kind(self.db) != SectionKind::File && section.closed(self.db);
            let own = if closed { outline.ends.len().saturating_sub(1) } else { outline.ends.len() };
            for (line, columns, keyword, name) in &outline.ends[..own] {
                strays.push(Stray {
                    section: *section,
                    line: *line,
                    columns: columns.clone(),
                    keyword: keyword.clone(),
                    name: name.clone(),
                });
            }
        }
        strays
    }

    fn misspelled(&self) -> Vec<Misspelled<'db>> {
        let sections = self.sections.iter();
        sections
            .flat_map(|section| {
                let words = self.outline(*section).misspelled.iter();
                words.map(|keyword| Misspelled { section: *section, keyword })
            })
            .collect()
    }

    fn unclosed(&mut self, strays: &[Stray<'db>], misspelled: &[Misspelled<'db>]) {
        for section in self.sections {
            let kind = section.kind(self.db);
            let end = closing(kind);
            if section.closed(self.db) || misspelled.iter().any(|m| m.section == *section && m.keyword == end)
            {
                continue;
            }
            let name = section.name(self.db);
            // END_T_MACRO is followed by flags, not by the name.
            let unnamed = name.is_empty() || kind == SectionKind::Macro;
            let shown = if unnamed { end.clone() } else { format!("{end} {name}") };
            let late = strays.iter().any(|s| s.keyword == end && (unnamed || *s.name == **name));
            let (rule, message) = if late && kind == SectionKind::Macro {
                let message =
                    "another definition, DATA or a module begins before END_T_MACRO; close this macro first";
                (&macros::MACRO_NESTED, message.to_string())
            } else if late {
                let message = format!("something else begins before {shown}; close {} first", opening(kind));
                (&rules::NESTED_BLOCK, message)
            } else {
                (&rules::UNCLOSED_BLOCK, format!("{} is never closed; {shown} is missing", opening(kind)))
            };
            let columns = self.opening_columns(*section);
            self.add(*section, Finding::new(rule, 0, columns, message));
        }
    }

    fn wrong_ends(&mut self) {
        for section in self.sections {
            let kind = section.kind(self.db);
            let lines = self.lines(*section);
            if kind == SectionKind::File || !section.closed(self.db) || lines.len() < 2 {
                continue;
            }
            let number = lines.len() as u32 - 1;
            let Some(operation) = lines.last().and_then(|line| line.operation.as_ref()) else { continue };
            let wanted = closing(kind);
            if !operation.text.eq_ignore_ascii_case(&wanted) {
                let message = format!("{} is open here; it is closed by {wanted}", opening(kind));
                let finding =
                    Finding::new(&rules::UNEXPECTED_END, number, operation.columns.clone(), message)
                        .beside(0, self.opening_columns(*section), "it begins here")
                        .replace(format!("write {wanted}"), operation.columns.clone(), wanted.as_str());
                self.add(*section, finding);
                continue;
            }
            self.wrong_name(*section, &lines[lines.len() - 1], number);
        }
    }

    fn wrong_name(&mut self, section: Section<'db>, line: &Line, number: u32) {
        let kind = section.kind(self.db);
        if !matches!(kind, SectionKind::Mechanism | SectionKind::Procedure) {
            return;
        }
        let ([operand], begun) = (line.operands.as_slice(), self.lines(section).first()) else { return };
        let ExprKind::Name(name) = &operand.kind else { return };
        let own = begun.and_then(|line| line.operands.first());
        let Some(ExprKind::Name(own)) = own.map(|operand| &operand.kind) else { return };
        if name.key() != own.key() {
            let message = format!("{} {} is open here, not {}", opening(kind), own.text, name.text);
            let finding = Finding::new(&rules::UNEXPECTED_END, number, name.columns.clone(), message)
                .beside(0, own.columns.clone(), "it begins here")
                .replace(format!("write {}", own.text), name.columns.clone(), own.text.as_str());
            self.add(section, finding);
        }
    }

    fn report_strays(&mut self, strays: &[Stray<'db>], misspelled: &[Misspelled<'db>]) {
        for stray in strays {
            let explained = self.sections.iter().any(|section| {
                let name = section.name(self.db);
                !section.closed(self.db)
                    && closing(section.kind(self.db)) == stray.keyword
                    && (name.is_empty()
                        || section.kind(self.db) == SectionKind::Macro
                        || **name == *stray.name)
            });
            let opener = opener_of(&stray.keyword);
            if explained || misspelled.iter().any(|m| m.keyword == opener) {
                continue;
            }
            let message = format!("{} closes nothing; {opener} is missing before it", stray.keyword);
            let finding = Finding::new(&rules::UNEXPECTED_END, stray.line, stray.columns.clone(), message);
            self.add(stray.section, finding);
        }
    }

    fn modules(&mut self, order: u8, strays: &[Stray<'db>], misspelled: &[Misspelled<'db>]) {
        for section in self.sections {
            let kind = section.kind(self.db);
            let is_module = matches!(kind, SectionKind::Data | SectionKind::Module(_));
            let keyword = opening(kind);
            let columns = self.opening_columns(*section);
            if is_module && section.ordinal(self.db) > 0 {
                let message = format!("{keyword} stands in this file already; join the two");
                self.add(*section, Finding::new(&rules::REPEATED_MODULE, 0, columns, message));
            } else if order > 0 && is_main_only(kind) {
                let message = format!("{keyword} stands in the main file only");
                self.add(*section, Finding::new(&rules::FORBIDDEN_MODULE, 0, columns, message));
            }
        }
        let mandatory = if order == 0 { MAIN_FILE } else { FURTHER_FILE };
        let missing: Vec<&str> = mandatory
            .iter()
            .filter(|kind| !self.sections.iter().any(|section| section.kind(self.db) == **kind))
            .filter(|kind| !misspelled.iter().any(|m| m.keyword == opening(**kind)))
            .filter(|kind| !strays.iter().any(|stray| stray.keyword == closing(**kind)))
            .map(|kind| opening(*kind))
            .collect();
        let Some(section) = self.sections.first().copied().filter(|_| !missing.is_empty()) else { return };
        let (section, line, columns) = self.stop_lines().into_iter().next().unwrap_or_else(|| {
            let first = self.sections.get(1).copied().unwrap_or(section);
            (first, 0, self.opening_columns(first))
        });
        let file = if order == 0 { "the main file" } else { "this file" };
        let message = format!("{file} lacks {}; a module may be empty", missing.join(", "));
        self.add(section, Finding::new(&rules::MISSING_MODULE, line, columns, message));
    }

    fn data_first(&mut self) {
        let top = self.sections.iter().find(|section| {
            section.outer(self.db).is_empty()
                && matches!(
                    section.kind(self.db),
                    SectionKind::Data | SectionKind::DataLocal | SectionKind::Module(_)
                )
        });
        let data = self.sections.iter().find(|section| section.kind(self.db) == SectionKind::Data);
        if let (Some(top), Some(data)) = (top, data)
            && top != data
        {
            let message = format!("DATA must stand before {}", opening(top.kind(self.db)));
            let finding = Finding::new(&rules::DATA_NOT_FIRST, 0, self.opening_columns(*data), message);
            self.add(*data, finding);
        }
    }

    /// The last DEBUG of the file, when it switches break-points on.
    fn debug_left_on(&mut self) {
        let last = self
            .sections
            .iter()
            .flat_map(|section| self.outline(*section).debugs.iter().map(move |debug| (*section, debug)))
            .max_by_key(|(section, (line, ..))| file_line(self.db, *section, *line));
        if let Some((section, (line, columns, true))) = last {
            let message =
                "break-points stay possible to the end of the file; close the region with DEBUG OFF";
            self.add(section, Finding::new(&lints::DEBUG_LEFT_ON, *line, columns.clone(), message));
        }
    }

    fn stop_lines(&self) -> Vec<(Section<'db>, u32, Columns)> {
        let sections = self.sections.iter();
        sections
            .flat_map(|section| {
                let stops = self.outline(*section).stops.iter();
                stops.map(|(line, columns)| (*section, *line, columns.clone()))
            })
            .collect()
    }

    fn stop(&mut self, order: u8) {
        let stops = self.stop_lines();
        let Some((section, line, columns)) = stops.first().cloned() else {
            if order == 0 {
                self.missing_stop();
            }
            return;
        };
        if section.kind(self.db) != SectionKind::File {
            // Within a section that is never closed it stands there only because of that.
            if section.closed(self.db) {
                let message =
                    format!("STOP stands inside {}; move it to the end", opening(section.kind(self.db)));
                self.add(section, Finding::new(&rules::STOP_MISPLACED, line, columns, message));
            }
            return;
        }
        let at = file_line(self.db, section, line);
        let follows = self.sections.iter().any(|other| {
            let last = self.outline(*other).last.as_ref();
            last.is_some_and(|(number, _)| file_line(self.db, *other, *number) > at)
        });
        if follows {
            let message = "only comments may follow STOP; move it to the end of the file";
            self.add(section, Finding::new(&rules::STOP_MISPLACED, line, columns, message));
        }
    }

    /// Reported at the last line that says something.
    fn missing_stop(&mut self) {
        let last = self
            .sections
            .iter()
            .filter_map(|section| {
                let (number, columns) = self.outline(*section).last.as_ref()?;
                Some((file_line(self.db, *section, *number), *section, *number, columns.clone()))
            })
            .max_by_key(|(at, ..)| *at);
        let (section, number, columns) = match last {
            Some((_, section, number, columns)) => (section, number, columns),
            None => match self.sections.first() {
                Some(section) => (*section, 0, 0..0),
                None => return,
            },
        };
        let message = "the main file must end with STOP";
        self.add(section, Finding::new(&rules::STOP_MISPLACED, number, columns, message));
    }
}

fn is_main_only(kind: SectionKind) -> bool {
    matches!(
        kind,
        SectionKind::Module(
            ModuleKind::Input
                | ModuleKind::BlockInit
                | ModuleKind::BlockDone
                | ModuleKind::Halt
                | ModuleKind::Cont
        )
    )
}

fn opener_of(keyword: &str) -> String {
    match keyword {
        "MECH_END" => "MECH_BEGIN".to_string(),
        "PROC_END" => "PROC_BEGIN".to_string(),
        "END_T_MACRO" => "DEF_T_MACRO".to_string(),
        other => other.strip_suffix("_END").unwrap_or(other).to_string(),
    }
}

fn first_name(line: &Line) -> String {
    match line.operands.first().map(|operand| &operand.kind) {
        Some(ExprKind::Name(name)) => name.key(),
        _ => String::new(),
    }
}

fn file_line(db: &dyn Db, section: Section<'_>, own: u32) -> u32 {
    section.lines(db).get(own as usize).copied().unwrap_or(0)
}
