//! Which macro a word calls at a place: definitions, APPEND_T_MACRO and CONTROL_T_MACRO act from their line on, in
//! the order of the text, with included files where T_INCLUDE joins them and program files in order of execution.

use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use super::definition::Flags;
use crate::catalogue;
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::project::IncludeTarget;
use crate::semantics::declarations::MacroLine;
use crate::syntax::section::SectionKind;

/// Inclusions nested deeper are reported by the loader.
const MAX_INCLUDES: usize = 64;
/// Longest chain of APPEND_T_MACRO from a word to its macro.
const MAX_ALIASES: usize = 8;

/// What a line of a file does to the table.
#[derive(Clone, Debug, PartialEq, Eq, salsa::SalsaValue)]
pub enum Event<'db> {
    /// A definition.
    Define(Section<'db>),
    /// `word` calls the macro `target`.
    Append {
        /// Key of the word.
        word: Arc<str>,
        /// Key of the macro.
        target: Arc<str>,
        /// Flags of its calls.
        flags: Flags,
    },
    /// CONTROL_T_MACRO: macros come before the instructions.
    Control(bool),
    /// T_INCLUDE: the path of the including file is that of the event's file.
    Include(String),
}

/// The events of a file, and of each section from which own line on how many of them have happened.
#[derive(Clone, Debug, Default, PartialEq, Eq, salsa::SalsaValue)]
pub struct FileMacros<'db> {
    /// In text order.
    pub events: Vec<Event<'db>>,
    /// Sections with something before or in them: (own line, number of events before it), ascending.
    pub sections: Vec<(Section<'db>, Vec<(u32, u32)>)>,
}

/// The events of the project.
#[derive(Clone, Debug, Default, PartialEq, Eq, salsa::SalsaValue)]
pub struct MacroTable<'db> {
    /// In text order, without inclusions.
    pub events: Vec<Event<'db>>,
    /// Events that define a word, by its key.
    words: FxHashMap<Arc<str>, Vec<u32>>,
    /// CONTROL_T_MACRO.
    modes: Vec<(u32, bool)>,
    /// By section: (own line, number of events before it).
    sections: FxHashMap<Section<'db>, Vec<(u32, u32)>>,
}

/// The macro a word calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, salsa::SalsaValue)]
pub struct MacroUse<'db> {
    /// Its definition.
    pub definition: Section<'db>,
    /// Flags of APPEND_T_MACRO; those of END_T_MACRO when there are none.
    pub flags: Option<Flags>,
}

/// What a word calls, line by line.
#[derive(Clone, Debug, Default, PartialEq, Eq, salsa::SalsaValue)]
pub struct MacroMeaning<'db> {
    /// From an own line on; nothing before the first one.
    pub from: Vec<(u32, Option<MacroUse<'db>>)>,
    /// It is defined somewhere in the project.
    pub somewhere: bool,
}

impl<'db> MacroMeaning<'db> {
    /// What it calls at an own line.
    #[must_use]
    pub fn at(&self, line: u32) -> Option<MacroUse<'db>> {
        let before = self.from.partition_point(|(from, _)| *from <= line);
        self.from.get(before.checked_sub(1)?)?.1
    }
}

/// Finds the events of a file.
pub(crate) fn of_file(db: &dyn Db, file: SourceFile) -> FileMacros<'_> {
    let mut found = FileMacros::default();
    // Most files have none: then it does not matter where their sections stand.
    let sections = database::sections(db, file).iter();
    let mut lines = sections.clone().map(|section| database::section_macro_lines(db, *section));
    let mut kinds = sections.map(|section| section.kind(db));
    if lines.all(Vec::is_empty) && !kinds.any(|kind| kind == SectionKind::Macro) {
        return found;
    }
    if let Some(root) = database::sections(db, file).first() {
        walk(db, *root, &mut found);
    }
    found
}

/// Sections nest only a few levels.
fn walk<'db>(db: &'db dyn Db, section: Section<'db>, found: &mut FileMacros<'db>) {
    let mut marks = Vec::new();
    if !found.events.is_empty() {
        marks.push((0, found.events.len() as u32));
    }
    // A definition is known behind its end; its own lines are text.
    let is_macro = section.kind(db) == SectionKind::Macro;
    let own: &[MacroLine] = if is_macro { &[] } else { database::section_macro_lines(db, section) };
    let mut own = own.iter().peekable();
    let mut children = section.children(db).iter().peekable();
    loop {
        let line = own.peek().map(|line| line.line());
        let child = children.peek().map(|(_, before)| *before);
        let before = found.events.len();
        let at = match (line, child) {
            (None, None) => break,
            (Some(line), child) if child.is_none_or(|before| line < before) => {
                if let Some(line) = own.next() {
                    found.events.push(event(line));
                }
                line + 1
            }
            (_, child) => {
                if let Some((nested, _)) = children.next() {
                    walk(db, *nested, found);
                }
                child.unwrap_or_default()
            }
        };
        if found.events.len() > before {
            marks.push((at, found.events.len() as u32));
        }
    }
    if !marks.is_empty() {
        found.sections.push((section, marks));
    }
    if is_macro {
        found.events.push(Event::Define(section));
    }
}

fn event<'db>(line: &MacroLine) -> Event<'db> {
    match line {
        MacroLine::Append { word, target, flags, .. } => {
            Event::Append { word: word.clone(), target: target.clone(), flags: *flags }
        }
        MacroLine::Control { pre, .. } => Event::Control(*pre),
        MacroLine::Include { name, .. } => Event::Include(name.clone()),
    }
}

/// Joins the files.
pub(crate) fn of_project(db: &dyn Db, project: Project) -> MacroTable<'_> {
    let included = project.included(db).iter().map(|file| (file.path(db).as_str(), *file)).collect();
    let mut join = Join { db, project, included, seen: FxHashSet::default(), table: MacroTable::default() };
    for file in project.files(db) {
        join.file(*file, 0);
    }
    join.table
}

struct Join<'db> {
    db: &'db dyn Db,
    project: Project,
    included: FxHashMap<&'db str, SourceFile>,
    /// A file is read where it is included first.
    seen: FxHashSet<SourceFile>,
    table: MacroTable<'db>,
}

impl<'db> Join<'db> {
    fn file(&mut self, file: SourceFile, depth: usize) {
        if depth > MAX_INCLUDES || !self.seen.insert(file) {
            return;
        }
        let own = database::file_macros(self.db, file);
        // Number of events of the project before the n-th of the file.
        let mut before = Vec::with_capacity(own.events.len() + 1);
        for event in &own.events {
            before.push(self.table.events.len() as u32);
            self.event(event, file, depth);
        }
        before.push(self.table.events.len() as u32);
        let start = before.first().copied().unwrap_or_default();
        let marked: FxHashMap<Section<'db>, &Vec<(u32, u32)>> =
            own.sections.iter().map(|(section, marks)| (*section, marks)).collect();
        for section in database::sections(self.db, file) {
            let mut all = vec![(0, start)];
            for (line, count) in marked.get(section).into_iter().copied().flatten() {
                let count = before.get(*count as usize).copied().unwrap_or(start);
                match all.last_mut() {
                    Some(last) if last.0 == *line => last.1 = count,
                    _ => all.push((*line, count)),
                }
            }
            if all.len() > 1 || all[0].1 > 0 {
                self.table.sections.insert(*section, all);
            }
        }
    }

    fn event(&mut self, event: &Event<'db>, file: SourceFile, depth: usize) {
        let number = self.table.events.len() as u32;
        let word = match event {
            Event::Include(name) => {
                let key = (file.path(self.db).clone(), name.clone());
                if let Some(IncludeTarget::File(path)) = self.project.includes(self.db).get(&key)
                    && let Some(file) = self.included.get(path.as_str()).copied()
                {
                    self.file(file, depth + 1);
                }
                return;
            }
            Event::Control(pre) => {
                self.table.modes.push((number, *pre));
                None
            }
            Event::Define(section) => Some(section.name(self.db).clone()).filter(|name| !name.is_empty()),
            Event::Append { word, .. } => Some(word.clone()),
        };
        if let Some(word) = word {
            self.table.words.entry(word).or_default().push(number);
        }
        self.table.events.push(event.clone());
    }
}

impl<'db> MacroTable<'db> {
    /// No macro is defined.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// CONTROL_T_MACRO PRE stands somewhere.
    #[must_use]
    pub fn has_pre(&self) -> bool {
        self.modes.iter().any(|(_, pre)| *pre)
    }

    /// Whether a word calls a macro somewhere.
    #[must_use]
    pub fn has(&self, word: &str) -> bool {
        self.words.contains_key(word)
    }

    /// All definitions that a word may stand for, wherever it is used.
    pub fn definitions(&self, word: &str) -> Vec<Section<'db>> {
        let mut found: Vec<Section<'db>> = Vec::new();
        let mut wanted = vec![word];
        let mut seen = FxHashSet::default();
        while let Some(word) = wanted.pop().filter(|_| seen.len() < MAX_LINKS) {
            if !seen.insert(word.to_owned()) {
                continue;
            }
            for number in self.words.get(word).into_iter().flatten() {
                match self.events.get(*number as usize) {
                    Some(Event::Define(section)) if !found.contains(section) => found.push(*section),
                    Some(Event::Append { target, .. }) => wanted.push(target),
                    _ => {}
                }
            }
        }
        found
    }

    /// The words visible at an own line of a section.
    pub fn visible(&self, section: Section<'db>, line: u32) -> impl Iterator<Item = &Arc<str>> {
        let count = self.count(section, line);
        self.words.iter().filter(move |(_, at)| at.iter().any(|n| *n < count)).map(|(word, _)| word)
    }

    fn count(&self, section: Section<'db>, line: u32) -> u32 {
        let marks = self.sections.get(&section).map_or(&[][..], Vec::as_slice);
        let before = marks.partition_point(|(from, _)| *from <= line);
        before.checked_sub(1).and_then(|at| marks.get(at)).map_or(0, |(_, count)| *count)
    }

    /// What a word calls when so many events have happened.
    fn resolve(&self, word: &str, count: u32) -> Option<MacroUse<'db>> {
        let pre = self.modes.iter().rev().find(|(at, _)| *at < count).is_some_and(|(_, pre)| *pre);
        if !pre && is_instruction(word) {
            return None;
        }
        let mut flags = None;
        let mut word = word;
        for _ in 0..MAX_ALIASES {
            let latest = self.words.get(word)?.iter().rev().find(|at| **at < count)?;
            match self.events.get(*latest as usize)? {
                Event::Define(definition) => return Some(MacroUse { definition: *definition, flags }),
                Event::Append { target, flags: own, .. } => {
                    flags = flags.or(Some(*own));
                    if **target == *word {
                        // It only sets the flags: the definition stands before it.
                        let earlier = self.words.get(word)?.iter().rev().filter(|at| *at < latest);
                        let define = earlier.filter_map(|at| match self.events.get(*at as usize) {
                            Some(Event::Define(definition)) => Some(*definition),
                            _ => None,
                        });
                        return define.into_iter().next().map(|definition| MacroUse { definition, flags });
                    }
                    word = target;
                }
                _ => return None,
            }
        }
        None
    }
}

/// Most words followed from one to another.
const MAX_LINKS: usize = 64;

/// A word of the language at the place of the operation.
pub(crate) fn is_instruction(word: &str) -> bool {
    use catalogue::EntryKind;
    catalogue::entry(word).is_some_and(|entry| {
        !matches!(entry.kind, EntryKind::TypePrefix | EntryKind::Keyword | EntryKind::EventProcedure)
    })
}

/// What a word calls in a section.
pub(crate) fn meaning<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
    word: &str,
) -> MacroMeaning<'db> {
    let table = database::macro_table(db, project);
    let mut meaning = MacroMeaning { from: Vec::new(), somewhere: table.words.contains_key(word) };
    if !meaning.somewhere {
        return meaning;
    }
    let mut last = None;
    for (line, count) in table.sections.get(&section).into_iter().flatten() {
        let now = table.resolve(word, *count);
        if now != last {
            meaning.from.push((*line, now));
            last = now;
        }
    }
    meaning
}
