//! What files declare for others, one value for each file.
//!
//! A project has some ten thousand sections, and who joins them all must ask each, whatever was edited. Joined by file
//! first, an edit asks the sections of its own file and one value of each other file.

use rustc_hash::FxHashMap;

use super::declarations::Exports;
use super::macros::declare::ExpansionExports;
use super::program::Part;
use crate::database::{self, Db, Project, Section, SiteOf, SourceFile};
use crate::syntax::section::SectionKind;

/// What the sections of a file declare for others.
#[derive(Clone, Debug, Default, PartialEq, salsa::SalsaValue)]
pub struct FileExports<'db> {
    /// Sections that declare something, in text order.
    pub sections: Vec<(Section<'db>, Exports)>,
}

/// What the macros that the sections of a file call declare for others.
#[derive(Clone, Debug, Default, PartialEq, salsa::SalsaValue)]
pub struct FileExpansionExports<'db> {
    /// Sections whose macros declare something, in text order.
    pub sections: Vec<(Section<'db>, ExpansionExports)>,
}

/// The files that a file includes.
#[derive(Clone, Debug, Default, PartialEq, Eq, salsa::SalsaValue)]
pub struct FileIncludes<'db> {
    /// Sections with T_INCLUDE and the spelled names.
    sections: FxHashMap<Section<'db>, Vec<String>>,
    /// The file declares memory.
    pub memory: bool,
}

impl<'db> FileExports<'db> {
    pub(crate) fn of(db: &'db dyn Db, file: SourceFile) -> FileExports<'db> {
        let all = database::sections(db, file).iter().map(|it| (*it, database::section_exports(db, *it)));
        let sections = all
            .filter(|(_, it)| !it.names.is_empty() || !it.storage.is_empty())
            .map(|(section, it)| (section, it.clone()))
            .collect();
        FileExports { sections }
    }
}

impl<'db> FileExpansionExports<'db> {
    pub(crate) fn of(db: &'db dyn Db, project: Project, file: SourceFile) -> FileExpansionExports<'db> {
        let sections = database::sections(db, file)
            .iter()
            .map(|section| (*section, database::expansion_exports(db, project, *section)))
            .filter(|(_, it)| **it != ExpansionExports::default())
            .map(|(section, it)| (section, it.clone()))
            .collect();
        FileExpansionExports { sections }
    }
}

impl<'db> FileIncludes<'db> {
    pub(crate) fn of(db: &'db dyn Db, file: SourceFile) -> FileIncludes<'db> {
        let mut found = FileIncludes::default();
        for section in database::sections(db, file) {
            let exports = database::section_exports(db, *section);
            found.memory |= !exports.storage.is_empty();
            if !exports.includes.is_empty() {
                let names = exports.includes.iter().map(|(name, _)| name.clone()).collect();
                found.sections.insert(*section, names);
            }
        }
        found
    }

    /// Spelled names that a section includes.
    pub(crate) fn of_section(&self, section: Section<'db>) -> &[String] {
        self.sections.get(&section).map_or(&[], Vec::as_slice)
    }
}

/// What all sections of a project declare for others.
pub(super) struct AllExports<'db> {
    own: FxHashMap<Section<'db>, &'db Exports>,
    expanded: FxHashMap<Section<'db>, &'db ExpansionExports>,
}

impl<'db> AllExports<'db> {
    pub(super) fn read(db: &'db dyn Db, project: Project) -> AllExports<'db> {
        let mut all = AllExports { own: FxHashMap::default(), expanded: FxHashMap::default() };
        for file in project.files(db).iter().chain(project.included(db)) {
            let own = &database::file_exports(db, *file).sections;
            all.own.extend(own.iter().map(|(section, it)| (*section, it)));
            if database::has_macros(db, project) {
                let expanded = &database::file_expansion_exports(db, project, *file).sections;
                all.expanded.extend(expanded.iter().map(|(section, it)| (*section, it)));
            }
        }
        all
    }

    /// What a part exports: its own lines, then the macros it calls. The part's kind is the one the names count for.
    pub(super) fn of(&self, part: &Part<'db>) -> impl Iterator<Item = (Part<'db>, &'db Exports, SiteOf)> {
        let own = self.own.get(&part.section).map(|exports| (*part, *exports, SiteOf::Own));
        let part = *part;
        let expanded = self.expanded.get(&part.section).map(|expanded| {
            let local = Part { kind: SectionKind::DataLocal, ..part };
            [(local, &expanded.local, SiteOf::Local), (part, &expanded.other, SiteOf::Other)]
        });
        own.into_iter().chain(expanded.into_iter().flatten())
    }
}
