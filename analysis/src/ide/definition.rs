//! Where a name is declared.

use super::cursor::{self, Cursor, Meaning};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::location::{Location, Position, Span};
use crate::semantics::declarations::What;
use crate::semantics::hir::SymbolKey;

/// Declarations of what stands at a position: of a symbol (of its mechanism, for `name_LINE`), of a label, or the
/// beginning of an included file. Empty for the words of the language and for predefined symbols.
#[must_use]
pub fn definition(db: &dyn Db, project: Project, file: SourceFile, at: Position) -> Vec<Location> {
    let Some(cursor) = Cursor::at(db, project, file, at) else { return Vec::new() };
    match cursor.word().and_then(|word| cursor.meaning(word)) {
        Some(Meaning::Symbol(key)) => symbol(db, project, &key),
        Some(Meaning::Label(key)) => label(db, cursor.section, &key),
        Some(Meaning::File(path)) => vec![Location { file: path, span: Span::default() }],
        Some(Meaning::Entry(_)) | None => Vec::new(),
    }
}

/// Where a symbol is declared.
pub(super) fn symbol(db: &dyn Db, project: Project, key: &SymbolKey) -> Vec<Location> {
    let sites = cursor::sites(db, project, key).iter();
    sites
        .filter_map(|site| {
            let declared = database::section_declarations(db, site.section).names.get(site.index as usize)?;
            cursor::location(db, site.section, declared.line, &declared.name.columns)
        })
        .collect()
}

/// Where a label of a section stands.
pub(super) fn label(db: &dyn Db, section: Section<'_>, key: &str) -> Vec<Location> {
    let names = database::section_declarations(db, section).names.iter();
    names
        .filter(|declared| declared.what == What::Label && declared.name.key() == key)
        .filter_map(|declared| cursor::location(db, section, declared.line, &declared.name.columns))
        .collect()
}
