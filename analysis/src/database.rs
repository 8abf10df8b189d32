//! The salsa database: inputs, sections, and the queries everything else is built from.
//!
//! A section is identified by its file, kind, name and ordinal; nothing else about it is part of the identity.
//! What is computed for a section depends on its own lines and on the names it uses, never on where it stands.
//! Absolute lines come in only at the outer edge ([`file_diagnostics`] and the `ide` features).

#![allow(
    missing_docs,
    reason = "salsa's macros write functions without docs; what is written by hand here has them"
)]

use std::collections::BTreeMap;
use std::sync::Arc;

use rustc_hash::FxHashMap;

use crate::configuration::cross::{Configured, ProjectUses};
use crate::configuration::uses::SectionUses;
use crate::configuration::{ConfigKind, Configuration};
use crate::diagnostics::allow::Allows;
use crate::diagnostics::{Diagnostic, Finding};
use crate::project::{IncludeTarget, Settings};
use crate::semantics::analysis::{Device, SectionAnalysis};
use crate::semantics::declarations::{Declarations, Declared, Exports, MacroLine};
use crate::semantics::exports::{FileExpansionExports, FileExports, FileIncludes};
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::layout::{DataBlock, Layout};
use crate::semantics::lints::project::{self as lints, NameUses};
use crate::semantics::lints::uses::{self, Uses};
use crate::semantics::macros::circles::{self, MacroCircle};
use crate::semantics::macros::declare::{self, ExpansionDeclarations, ExpansionExports};
use crate::semantics::macros::definition::{self, MacroDefinition};
use crate::semantics::macros::expand::{self, Expansion};
use crate::semantics::macros::table::{self, FileMacros, MacroMeaning, MacroTable};
use crate::semantics::program::Parts;
use crate::semantics::recursion::RecursiveCall;
use crate::semantics::scope::{Scope, Symbol};
use crate::semantics::structure::Outline;
use crate::semantics::suggest::Spellings;
use crate::semantics::{self, collect};
use crate::syntax::section::SectionKind;
use crate::syntax::{self, ParsedLines};

/// What every query takes.
#[salsa::db]
pub trait Db: salsa::Database {}

/// The database. A clone shares the storage and is a snapshot: while one lives, a writer waits for it.
#[salsa::db]
#[derive(Clone, Default)]
pub struct Database {
    storage: salsa::Storage<Self>,
}

#[salsa::db]
impl salsa::Database for Database {}

#[salsa::db]
impl Db for Database {}

impl Database {
    /// A database that reports salsa's events.
    #[must_use]
    pub fn with_events(observer: Box<dyn Fn(salsa::Event) + Send + Sync>) -> Database {
        Database { storage: salsa::Storage::new(Some(observer)) }
    }
}

/// A program text.
#[salsa::input(debug)]
pub struct SourceFile {
    /// Project path.
    pub path: String,
    /// Content.
    pub text: Arc<str>,
    /// 0-based place in the order of execution; `None` for an included file.
    #[returns(copy)]
    pub order: Option<u8>,
}

/// A configuration file. An input of its own: an edit here re-runs no analysis of a section.
#[salsa::input(debug)]
pub struct ConfigFile {
    /// Project path.
    pub path: String,
    /// Content.
    pub text: Arc<str>,
}

/// The project.
#[salsa::input(debug)]
pub struct Project {
    /// Program files in order of execution.
    pub files: Vec<SourceFile>,
    /// Included files, in order of their first inclusion.
    pub included: Vec<SourceFile>,
    /// Configuration files, in order of the manifest.
    pub configuration: Vec<ConfigFile>,
    /// What the manifest sets.
    pub settings: Arc<Settings>,
    /// Where each T_INCLUDE leads: (path of the including file, spelled name).
    pub includes: Arc<BTreeMap<(String, String), IncludeTarget>>,
}

/// A part of a file, see [`SectionKind`].
#[salsa::tracked(debug)]
pub struct Section<'db> {
    /// The file it stands in.
    #[returns(copy)]
    pub file: SourceFile,
    /// What it is.
    #[returns(copy)]
    pub kind: SectionKind,
    /// Key of its name; empty for nameless ones.
    pub name: Arc<str>,
    /// 0-based number among the sections of this kind and name in the file.
    #[returns(copy)]
    pub ordinal: u32,
    /// Its own lines.
    #[tracked]
    pub text: Arc<str>,
    /// Its closing line is there.
    #[tracked]
    #[returns(copy)]
    pub closed: bool,
    /// Sections around it, outermost first, without the File section.
    #[tracked]
    pub outer: Vec<SectionKind>,
    /// Nested sections, each with the number of own lines before it.
    #[tracked]
    pub children: Vec<(Section<'db>, u32)>,
    /// 0-based file line of each own line. Only the outer edge may read this.
    #[tracked]
    pub lines: Vec<u32>,
}

/// Where a name is declared: the section, and the index in the names of its declarations, see [`declared`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, salsa::SalsaValue)]
pub struct Site<'db> {
    /// The section.
    pub section: Section<'db>,
    /// Which of its declarations.
    pub of: SiteOf,
    /// Index in their names.
    pub index: u32,
}

/// Which declarations of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, salsa::SalsaValue)]
pub enum SiteOf {
    /// Those of its own lines.
    Own,
    /// Those in DATA_LOCAL of the macros it calls.
    Local,
    /// The others in the macros it calls.
    Other,
}

/// A name as a section sees it.
#[salsa::interned(debug)]
pub struct NameRef<'db> {
    /// Key of the name.
    pub key: Arc<str>,
    /// File whose local names are visible; `None` in an included file.
    #[returns(copy)]
    pub file: Option<u8>,
}

/// The sections of a file, in text order; the first is the [`SectionKind::File`] section.
#[salsa::tracked]
pub fn sections<'db>(db: &'db dyn Db, file: SourceFile) -> Vec<Section<'db>> {
    let raw = syntax::split(file.text(db));
    let mut made: Vec<Option<Section<'db>>> = vec![None; raw.len()];
    // Inner sections follow the outer ones, so children exist before their parent is made.
    for index in (0..raw.len()).rev() {
        let part = &raw[index];
        let mut outer = Vec::new();
        let mut up = part.parent;
        while let Some(parent) = up {
            if raw[parent].kind != SectionKind::File {
                outer.insert(0, raw[parent].kind);
            }
            up = raw[parent].parent;
        }
        let children = part
            .children
            .iter()
            .filter_map(|(child, before)| Some((made[*child]?, *before)))
            .collect::<Vec<_>>();
        made[index] = Some(Section::new(
            db,
            file,
            part.kind,
            Arc::from(part.name.as_str()),
            part.ordinal,
            Arc::from(part.text.as_str()),
            part.closed,
            outer,
            children,
            part.lines.clone(),
        ));
    }
    made.into_iter().flatten().collect()
}

/// The lines of a section.
#[salsa::tracked]
pub fn section_lines<'db>(db: &'db dyn Db, section: Section<'db>) -> ParsedLines {
    syntax::parse_lines(section.text(db))
}

/// Comments of a section that allow what rules report.
#[salsa::tracked]
pub fn section_allows<'db>(db: &'db dyn Db, section: Section<'db>) -> Allows {
    crate::diagnostics::allow::read(&section_lines(db, section).lines, section.text(db))
}

/// What a section does with names, without positions.
#[salsa::tracked]
pub fn section_uses<'db>(db: &'db dyn Db, section: Section<'db>) -> Uses {
    uses::uses(section_lines(db, section), section.text(db), section.kind(db))
}

/// What a file does with names.
#[salsa::tracked]
pub fn file_uses(db: &dyn Db, file: SourceFile) -> NameUses {
    lints::file_uses(db, file)
}

/// What a file does with names that it does not declare.
#[salsa::tracked]
pub fn foreign_uses(db: &dyn Db, file: SourceFile) -> NameUses {
    lints::foreign_uses(db, file)
}

/// What files do with names of other files.
#[salsa::tracked]
pub fn shared_uses(db: &dyn Db, project: Project) -> NameUses {
    lints::shared_uses(db, project)
}

/// Names of a file that nobody uses as they are meant: index in its sections, and the finding.
#[salsa::tracked]
pub fn file_lints(db: &dyn Db, project: Project, file: SourceFile) -> Vec<(u32, Finding)> {
    lints::file_lints(db, project, file)
}

/// What the structure of the file needs of a section's lines.
#[salsa::tracked]
pub fn section_outline<'db>(db: &'db dyn Db, section: Section<'db>) -> Outline {
    semantics::structure::outline(&section_lines(db, section).lines)
}

/// What a section declares, with own-line positions.
#[salsa::tracked]
pub fn section_declarations<'db>(db: &'db dyn Db, section: Section<'db>) -> Declarations {
    collect::collect(section_lines(db, section), section.text(db), section.kind(db))
}

/// What a section declares for others, without positions.
#[salsa::tracked]
pub fn section_exports<'db>(db: &'db dyn Db, section: Section<'db>) -> Exports {
    collect::exports(section_declarations(db, section))
}

/// What the sections of a file declare for others: whoever reads all files depends on one value for each.
#[salsa::tracked]
pub fn file_exports(db: &dyn Db, file: SourceFile) -> FileExports<'_> {
    FileExports::of(db, file)
}

/// What the macros that the sections of a file call declare for others.
#[salsa::tracked]
pub fn file_expansion_exports(db: &dyn Db, project: Project, file: SourceFile) -> FileExpansionExports<'_> {
    FileExpansionExports::of(db, project, file)
}

/// The files that the sections of a file include.
#[salsa::tracked]
pub fn file_includes(db: &dyn Db, file: SourceFile) -> FileIncludes<'_> {
    FileIncludes::of(db, file)
}

/// Lines of a section that decide which words call macros.
#[salsa::tracked]
pub fn section_macro_lines<'db>(db: &'db dyn Db, section: Section<'db>) -> Vec<MacroLine> {
    section_declarations(db, section).macro_lines.clone()
}

/// The macro that a section defines.
#[salsa::tracked]
pub fn macro_definition<'db>(db: &'db dyn Db, section: Section<'db>) -> MacroDefinition {
    definition::read(db, section)
}

/// Definitions and directives of macros in a file, in text order.
#[salsa::tracked]
pub fn file_macros(db: &dyn Db, file: SourceFile) -> FileMacros<'_> {
    table::of_file(db, file)
}

/// Definitions and directives of macros in the project, in text order.
#[salsa::tracked]
pub fn macro_table(db: &dyn Db, project: Project) -> MacroTable<'_> {
    table::of_project(db, project)
}

/// Whether the project has macros: without them nothing else about macros is asked.
#[salsa::tracked(returns(copy))]
pub fn has_macros(db: &dyn Db, project: Project) -> bool {
    !macro_table(db, project).is_empty()
}

/// Whether CONTROL_T_MACRO PRE stands somewhere: then instructions may be macros.
#[salsa::tracked(returns(copy))]
pub fn macros_before(db: &dyn Db, project: Project) -> bool {
    macro_table(db, project).has_pre()
}

/// What a word calls in a section.
#[salsa::tracked]
pub fn macro_meaning<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
    word: NameRef<'db>,
) -> MacroMeaning<'db> {
    table::meaning(db, project, section, word.key(db))
}

/// Whether a word calls a macro somewhere in the project.
#[salsa::tracked(returns(copy))]
pub fn macro_somewhere<'db>(db: &'db dyn Db, project: Project, word: NameRef<'db>) -> bool {
    macro_table(db, project).has(word.key(db))
}

/// The lines of a section with its calls expanded; `None` when it has none. Ask [`expansion_of`].
#[salsa::tracked]
pub fn expansion<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> Option<Expansion<'db>> {
    expand::expand(db, project, section)
}

/// The lines of a section with its calls expanded; `None` when it has none.
pub fn expansion_of<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
) -> Option<&'db Expansion<'db>> {
    if has_macros(db, project) { expansion(db, project, section).as_ref() } else { None }
}

/// What the expansions of a section declare.
#[salsa::tracked]
pub fn expansion_declarations<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
) -> ExpansionDeclarations {
    let found = expansion_of(db, project, section);
    found.map_or_else(ExpansionDeclarations::default, |it| declare::declarations(it, section.kind(db)))
}

/// What the expansions of a section declare for others, without positions.
#[salsa::tracked]
pub fn expansion_exports<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> ExpansionExports {
    declare::exports(expansion_declarations(db, project, section))
}

/// The declarations in the expansions of a section with lengths and constants that need others filled in.
#[salsa::tracked]
pub fn resolved_expansion<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
) -> ExpansionDeclarations {
    let own = expansion_declarations(db, project, section);
    ExpansionDeclarations {
        local: semantics::program::resolved(db, project, section, own.local.clone()),
        other: semantics::program::resolved(db, project, section, own.other.clone()),
        ..own.clone()
    }
}

/// Macros that call themselves.
#[salsa::tracked]
pub fn macro_circles(db: &dyn Db, project: Project) -> Vec<MacroCircle<'_>> {
    circles::find(db, project)
}

/// The declaration at a site.
pub fn declared<'db>(db: &'db dyn Db, project: Project, site: Site<'db>) -> Option<&'db Declared> {
    let names = match site.of {
        SiteOf::Own => &section_declarations(db, site.section).names,
        SiteOf::Local => &expansion_declarations(db, project, site.section).local.names,
        SiteOf::Other => &expansion_declarations(db, project, site.section).other.names,
    };
    names.get(site.index as usize)
}

/// The sections that take part in the program, in order.
#[salsa::tracked]
pub fn parts(db: &dyn Db, project: Project) -> Parts<'_> {
    semantics::program::parts(db, project)
}

/// What a section of an included file is to the program, and the program file it belongs to.
#[salsa::tracked(returns(copy))]
pub fn inclusion<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> Option<(SectionKind, u8)> {
    let part = parts(db, project).parts.iter().find(|part| part.section == section)?;
    Some((part.kind, part.file))
}

/// A section's declarations with the lengths and constants that need other sections filled in: what the layout
/// of memory reads.
#[salsa::tracked]
pub fn resolved_declarations<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> Declarations {
    semantics::program::resolved(db, project, section, section_declarations(db, section).clone())
}

/// Names of the project.
#[salsa::tracked]
pub fn scope(db: &dyn Db, project: Project) -> Scope {
    semantics::program::scope(db, project)
}

/// Where the names of the project are declared.
#[salsa::tracked]
pub fn sites(db: &dyn Db, project: Project) -> FxHashMap<SymbolKey, Vec<Site<'_>>> {
    semantics::program::sites(db, project)
}

/// The spellings of all names, to offer a similar one.
#[salsa::tracked]
pub fn spellings(db: &dyn Db, project: Project) -> Spellings {
    Spellings::of(scope(db, project))
}

/// What a name means where it is used: local to the file, else global, else predefined.
#[salsa::tracked]
pub fn lookup<'db>(db: &'db dyn Db, project: Project, name: NameRef<'db>) -> Option<Symbol> {
    let scope = scope(db, project);
    let key = name.key(db);
    let local = name.file(db).and_then(|file| scope.locals.get(usize::from(file))?.get(key));
    local.or_else(|| scope.globals.get(key)).cloned().or_else(|| system_symbol(key))
}

/// The code of a section: mistakes, resolved statements, uses of names.
#[salsa::tracked]
pub fn section_analysis<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> SectionAnalysis {
    semantics::code::analyse(db, project, section)
}

/// The sections of a file that may name devices: they have such an instruction, or a word that may call a macro.
#[salsa::tracked]
pub fn device_sections(db: &dyn Db, file: SourceFile) -> Vec<Section<'_>> {
    let all = sections(db, file).iter().copied();
    all.filter(|section| {
        semantics::devices::may_name(section_lines(db, *section), section_uses(db, *section))
    })
    .collect()
}

/// What is done with devices.
pub type Devices = std::collections::BTreeSet<Device>;

/// What a section does with devices; without positions, so that it stays equal while its other lines change.
#[salsa::tracked]
pub fn section_devices<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> Devices {
    section_analysis(db, project, section).devices.iter().map(|used| used.device).collect()
}

/// What the project does with devices.
#[salsa::tracked]
pub fn project_devices(db: &dyn Db, project: Project) -> Devices {
    let files = project.files(db).iter().chain(project.included(db));
    // With CONTROL_T_MACRO PRE any instruction may be a macro.
    let any = macros_before(db, project);
    let sections = files.flat_map(|file| if any { sections(db, *file) } else { device_sections(db, *file) });
    sections.flat_map(|section| section_devices(db, project, *section)).copied().collect()
}

/// All mistakes of a file, with absolute positions, sorted.
#[salsa::tracked]
pub fn file_diagnostics(db: &dyn Db, project: Project, file: SourceFile) -> Vec<Diagnostic> {
    crate::diagnostics::file::collect(db, project, file)
}

/// A configuration file as read.
#[salsa::tracked]
pub fn configuration_file(db: &dyn Db, file: ConfigFile) -> Configuration {
    let kind = ConfigKind::of_path(file.path(db)).unwrap_or(ConfigKind::Channel);
    crate::configuration::read(kind, file.text(db))
}

/// What the configuration files of the project define.
#[salsa::tracked]
pub fn configured(db: &dyn Db, project: Project) -> Configured {
    crate::configuration::cross::configured(db, project)
}

/// What a section takes from configuration files.
#[salsa::tracked]
pub fn section_identifiers<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> SectionUses {
    crate::configuration::uses::collect(db, project, section)
}

/// What the program takes from configuration files.
#[salsa::tracked]
pub fn configuration_uses(db: &dyn Db, project: Project) -> ProjectUses {
    crate::configuration::cross::project_uses(db, project)
}

/// All mistakes of a configuration file, sorted.
#[salsa::tracked]
pub fn configuration_diagnostics(db: &dyn Db, project: Project, file: ConfigFile) -> Vec<Diagnostic> {
    crate::configuration::cross::of_file(db, project, file)
}

/// Where everything lies in memory.
#[salsa::tracked]
pub fn layout(db: &dyn Db, project: Project) -> Layout {
    let blocks: Vec<DataBlock<'_>> = semantics::program::blocks(db, project)
        .into_iter()
        .map(|block| DataBlock {
            kind: block.kind,
            name: block.part.section.name(db),
            file: block.part.file,
            declarations: block.declarations,
        })
        .collect();
    Layout::compute(&blocks)
}

/// Whether bytes at an offset from a symbol lie in the data of the program, or in the control's own cells for a
/// predefined symbol.
pub fn inside_data(db: &dyn Db, project: Project, symbol: &SymbolKey, offset: i64, bytes: u32) -> bool {
    semantics::program::inside_data(db, project, symbol, offset, bytes)
}

/// Calls that close a circle of procedures.
#[salsa::tracked]
pub fn recursive_calls(db: &dyn Db, project: Project) -> Vec<RecursiveCall<'_>> {
    semantics::recursion::recursive_calls(db, project)
}

/// A predefined symbol.
#[must_use]
pub fn system_symbol(key: &str) -> Option<Symbol> {
    let system = crate::catalogue::symbol(key)?;
    let kind = semantics::program::system_kind(&system.kind);
    Some(Symbol { key: SymbolKey { scope: SymbolScope::System, name: Arc::from(system.name) }, kind })
}
