//! Lints that look at the whole project: names that nobody reads, writes, calls or starts.
//!
//! A name is judged in the file that declares it. That file reads its own uses and those that other files make of names they
//! do not declare themselves; both hold no positions.

use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use super::memory::Memory;
use super::overlays;
use super::uses::{Use, place_of};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::diagnostics::rules::lints as rules;
use crate::diagnostics::{Finding, Rule};
use crate::semantics::declarations::{Declarations, Declared, What};
use crate::syntax::section::SectionKind;

/// What is done with names, and who writes bits in every cycle.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NameUses {
    names: FxHashMap<Arc<str>, Use>,
    writers: FxHashMap<Arc<str>, Vec<Writer>>,
}

/// A section that takes part in every cycle and writes a bit.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Writer {
    /// As messages call it.
    section: Arc<str>,
    /// With WR or MOVR.
    coil: bool,
    mechanism: bool,
}

impl NameUses {
    fn add(&mut self, name: &Arc<str>, what: Use) {
        let before = self.names.entry(name.clone()).or_default();
        *before = before.and(what);
    }

    fn of(&self, name: &str) -> Use {
        self.names.get(name).copied().unwrap_or_default()
    }
}

/// Joins the uses of the sections of a file.
pub(crate) fn file_uses(db: &dyn Db, file: SourceFile) -> NameUses {
    let mut joined = NameUses::default();
    for section in database::sections(db, file) {
        let uses = database::section_uses(db, *section);
        for (name, what) in &uses.names {
            joined.add(name, *what);
            if uses.cyclic && what.any(Use::WRITE) {
                let writer = Writer {
                    section: described(db, *section),
                    coil: what.any(Use::COIL),
                    mechanism: section.kind(db) == SectionKind::Mechanism,
                };
                joined.writers.entry(name.clone()).or_default().push(writer);
            }
        }
    }
    joined.writers.retain(|_, writers| writers.iter().any(|writer| writer.coil || writer.mechanism));
    joined
}

fn described(db: &dyn Db, section: Section<'_>) -> Arc<str> {
    match section.kind(db) {
        SectionKind::Module(kind) => format!("{} of {}", kind.keyword(), section.file(db).path(db)).into(),
        _ => section.name(db).clone(),
    }
}

/// The uses of names that a file does not declare.
pub(crate) fn foreign_uses(db: &dyn Db, file: SourceFile) -> NameUses {
    let own: FxHashSet<&Arc<str>> = database::file_exports(db, file)
        .sections
        .iter()
        .flat_map(|(_, exports)| exports.names.iter().map(|(name, _)| name))
        .collect();
    let mut uses = database::file_uses(db, file).clone();
    uses.names.retain(|name, _| !own.contains(name) && crate::catalogue::symbol(name).is_none());
    uses.writers.retain(|name, _| !own.contains(name) && crate::catalogue::symbol(name).is_none());
    uses
}

/// The uses that files make of names of other files.
pub(crate) fn shared_uses(db: &dyn Db, project: Project) -> NameUses {
    let mut joined = NameUses::default();
    for file in project.files(db).iter().chain(project.included(db)) {
        let uses = database::foreign_uses(db, *file);
        for (name, what) in &uses.names {
            joined.add(name, *what);
        }
        for (name, writers) in &uses.writers {
            joined.writers.entry(name.clone()).or_default().extend(writers.iter().cloned());
        }
    }
    joined
}

/// What the lints find in a file: index in its sections, and the finding.
pub(crate) fn file_lints(db: &dyn Db, project: Project, file: SourceFile) -> Vec<(u32, Finding)> {
    // What an included file declares may be meant for other projects too.
    if file.order(db).is_none() {
        return Vec::new();
    }
    let mut judge = Judge {
        db,
        sections: database::sections(db, file),
        own: database::file_uses(db, file),
        shared: database::shared_uses(db, project),
        found: Vec::new(),
    };
    for (index, section) in judge.sections.iter().enumerate() {
        let declarations = database::resolved_declarations(db, project, *section);
        if !declarations.names.is_empty() {
            judge.section(index as u32, declarations, section.kind(db) == SectionKind::DataLocal);
        }
    }
    judge.found
}

struct Judge<'db> {
    db: &'db dyn Db,
    sections: &'db [Section<'db>],
    own: &'db NameUses,
    shared: &'db NameUses,
    found: Vec<(u32, Finding)>,
}

impl Judge<'_> {
    fn uses(&self, name: &str, local: bool) -> Use {
        let own = self.own.of(name);
        if local { own } else { own.and(self.shared.of(name)) }
    }

    fn add(&mut self, section: u32, rule: &'static Rule, name: &Declared, message: String) {
        self.found.push((section, Finding::new(rule, name.line, name.columns(), message)));
    }

    fn section(&mut self, section: u32, declarations: &Declarations, local: bool) {
        let memory = Memory::of(declarations, |name| self.uses(name, local));
        for (index, name) in declarations.names.iter().enumerate() {
            if let Some(what) = memory.uses(index) {
                self.memory(section, name, what, local);
                continue;
            }
            let shown = &name.name.text;
            let what = self.uses(&name.name.key(), false);
            let used = what.any(Use::USED);
            match name.what {
                What::Mechanism if !what.any(Use::SET) => {
                    let message = format!("nothing starts the mechanism {shown}; FL 1,{shown} does");
                    self.add(section, &rules::MECHANISM_NEVER_STARTED, name, message);
                }
                What::Constant(_) if !used => {
                    let message = format!("the constant {shown} is never used");
                    self.add(section, &rules::UNUSED_CONSTANT, name, message);
                }
                What::Procedure if !used && !name.name.key().starts_with("_ON_") => {
                    let message = format!("nothing calls the procedure {shown}");
                    self.add(section, &rules::UNUSED_PROCEDURE, name, message);
                }
                What::Macro if !used => {
                    let message = format!("nothing uses the macro {shown}");
                    self.add(section, &rules::UNUSED_MACRO, name, message);
                }
                _ => {}
            }
        }
        for (rule, name, message) in overlays::of(declarations) {
            self.add(section, rule, name, message);
        }
    }

    /// A declared bit, cell, area or text.
    fn memory(&mut self, section: u32, name: &Declared, what: Use, local: bool) {
        let shown = &name.name.text;
        if !what.any(Use::USED) {
            self.add(section, &rules::UNUSED_VARIABLE, name, format!("{shown} is never used"));
        } else if !what.any(Use::READ.and(Use::NAMED)) {
            self.add(section, &rules::NEVER_READ, name, format!("{shown} is written, but nothing reads it"));
        } else if what.any(Use::AWAITED) && !what.any(Use::SET) {
            self.awaited(section, name);
        } else if what.any(Use::READ) && !what.any(Use::WRITE) {
            let message = format!("{shown} is read, but nothing writes it: it stays 0");
            self.add(section, &rules::NEVER_WRITTEN, name, message);
        }
        if matches!(name.what, What::Bit { .. }) && what.any(Use::COIL) {
            self.writers(section, name, local);
        }
    }

    /// A wait that never ends, at the wait when it stands in this file.
    fn awaited(&mut self, section: u32, name: &Declared) {
        let shown = &name.name.text;
        let message =
            format!("this waits for {shown}, but nothing sets it: the sequence stays here for ever");
        let key = name.name.key();
        if let Some((at, line, columns)) = self.place(&key, Use::AWAITED) {
            self.found.push((at, Finding::new(&rules::ENDLESS_WAIT, line, columns, message)));
        } else {
            let message = format!("a sequence waits for {shown}, but nothing sets it");
            self.add(section, &rules::ENDLESS_WAIT, name, message);
        }
    }

    /// A bit that one section writes with WR in every cycle, and another one too.
    fn writers(&mut self, section: u32, name: &Declared, local: bool) {
        let key = name.name.key();
        let lists = [Some(self.own), (!local).then_some(self.shared)];
        let writers: Vec<&Writer> =
            lists.into_iter().flatten().filter_map(|uses| uses.writers.get(key.as_str())).flatten().collect();
        let Some(coil) = writers.iter().position(|writer| writer.coil) else { return };
        let other = writers.iter().enumerate().find(|(index, writer)| {
            *index != coil && (writer.coil || writer.mechanism && writers[coil].mechanism)
        });
        let Some((_, other)) = other else { return };
        let shown = &name.name.text;
        let message = format!(
            "WR writes {shown} in {} in every pass, and {} writes it too: the later one wins; let one of them write it",
            writers[coil].section, other.section
        );
        match self.place(&key, Use::COIL) {
            Some((at, line, columns)) => {
                self.found.push((at, Finding::new(&rules::TWO_WRITERS, line, columns, message)));
            }
            None => self.add(section, &rules::TWO_WRITERS, name, message),
        }
    }

    /// The first place in this file where something is done with a name: index of the section, own line and columns.
    fn place(&self, key: &str, what: Use) -> Option<(u32, u32, crate::syntax::ast::Columns)> {
        self.sections.iter().enumerate().find_map(|(index, section)| {
            let uses = database::section_uses(self.db, *section);
            let fits = (what != Use::COIL || uses.cyclic)
                && uses
                    .names
                    .binary_search_by(|(name, _)| (**name).cmp(key))
                    .is_ok_and(|at| uses.names[at].1.any(what));
            if !fits {
                return None;
            }
            let lines = &database::section_lines(self.db, *section).lines;
            let (line, columns) = place_of(lines, key, what)?;
            Some((index as u32, line, columns))
        })
    }
}
