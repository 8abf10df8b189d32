//! The project as a whole: which sections take part in it, the names they declare, and their clashes.

use std::collections::BTreeMap;
use std::sync::Arc;

use rustc_hash::FxHashMap;
use technol_image::op::Width;

use super::constant::{ConstExpr, NoValue};
use super::constants::Constants;
use super::declarations::{Declarations, Exports, Extent, What};
use super::exports::AllExports;
use super::hir::{SymbolKey, SymbolScope};
use super::scope::{Clash, Routine, Scope, Symbol, SymbolKind};
use crate::catalogue::{Prefix, SystemKind};
use crate::database::{self, Db, Project, Section, Site, SourceFile};
use crate::project::IncludeTarget;
use crate::syntax::section::SectionKind;

/// A section that takes part in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, salsa::SalsaValue)]
pub struct Part<'db> {
    /// The section.
    pub section: Section<'db>,
    /// 0-based program file it belongs to; an included file belongs to the one that includes it first.
    pub file: u8,
    /// What it is to the program: the File section of an included file is Data or DataLocal when it is included
    /// there.
    pub kind: SectionKind,
    /// It belongs to an included file.
    pub included: bool,
}

/// A T_INCLUDE that leads to a file whose memory is declared already.
#[derive(Clone, Debug, PartialEq, Eq, salsa::SalsaValue)]
pub struct Repeated<'db> {
    /// Where the line stands.
    pub section: Section<'db>,
    /// Spelled name.
    pub name: String,
}

/// The parts of the program in order of files and text.
#[derive(Clone, Debug, Default, PartialEq, Eq, salsa::SalsaValue)]
pub struct Parts<'db> {
    /// Sections; an included file's follow the section that includes it.
    pub parts: Vec<Part<'db>>,
    /// Inclusions that would declare memory twice.
    pub repeated: Vec<Repeated<'db>>,
}

/// Finds the parts.
pub(crate) fn parts(db: &dyn Db, project: Project) -> Parts<'_> {
    let included: FxHashMap<&str, SourceFile> =
        project.included(db).iter().map(|file| (file.path(db).as_str(), *file)).collect();
    let mut walk = Walk { db, project, included, seen: BTreeMap::new(), found: Parts::default() };
    for (order, file) in project.files(db).iter().enumerate() {
        for section in database::sections(db, *file) {
            let part = Part { section: *section, file: order as u8, kind: section.kind(db), included: false };
            walk.visit(part);
        }
    }
    walk.found
}

struct Walk<'db> {
    db: &'db dyn Db,
    project: Project,
    included: FxHashMap<&'db str, SourceFile>,
    /// Included files seen, with whether they have memory in the program.
    seen: BTreeMap<&'db str, bool>,
    found: Parts<'db>,
}

impl<'db> Walk<'db> {
    fn visit(&mut self, part: Part<'db>) {
        self.found.parts.push(part);
        let from = part.section.file(self.db).path(self.db);
        let file = part.section.file(self.db);
        for name in database::file_includes(self.db, file).of_section(part.section) {
            let key = (from.clone(), name.clone());
            let Some(IncludeTarget::File(path)) = self.project.includes(self.db).get(&key) else { continue };
            let Some((path, file)) = self.included.get_key_value(path.as_str()).map(|(p, f)| (*p, *f)) else {
                continue;
            };
            let holds = matches!(part.kind, SectionKind::Data | SectionKind::DataLocal);
            let memory = holds && database::file_includes(self.db, file).memory;
            if let Some(before) = self.seen.get_mut(path) {
                if memory && std::mem::replace(before, true) {
                    self.found.repeated.push(Repeated { section: part.section, name: name.clone() });
                    continue;
                }
                if !memory {
                    continue;
                }
                // Seen for its constants only: this inclusion gives it its memory.
                self.found.parts.retain(|p| p.section.file(self.db) != file);
            }
            self.seen.insert(path, memory);
            for section in database::sections(self.db, file) {
                let own = section.kind(self.db);
                let kind = if own == SectionKind::File && holds { part.kind } else { own };
                self.visit(Part { section: *section, file: part.file, kind, included: true });
            }
        }
    }
}

/// Names and memory of the project.
pub(crate) fn scope(db: &dyn Db, project: Project) -> Scope {
    let parts = &database::parts(db, project).parts;
    let all = AllExports::read(db, project);
    let constants = Constants::resolve(&all, parts);
    let mut scope = Scope { locals: vec![FxHashMap::default(); project.files(db).len()], ..Scope::default() };
    for part in parts {
        for (part, exports, _) in all.of(part) {
            for (name, what) in &exports.names {
                declare(&mut scope, db, &part, exports, name, what, &constants);
            }
        }
    }
    scope.circular = constants.circular;
    mechanism_lines(&mut scope);
    local_clashes(&mut scope);
    scope
}

/// Declarations that get memory together.
pub(crate) struct Block<'db> {
    /// The part they belong to.
    pub(crate) part: Part<'db>,
    /// What they count as.
    pub(crate) kind: SectionKind,
    /// With all lengths and constants.
    pub(crate) declarations: &'db Declarations,
    /// They stand in macros that the part calls.
    pub(crate) expanded: bool,
}

/// The declarations of the project in order of memory: those of a section's macros follow its own.
pub(crate) fn blocks(db: &dyn Db, project: Project) -> Vec<Block<'_>> {
    let mut blocks = Vec::new();
    for part in &database::parts(db, project).parts {
        let declarations = database::resolved_declarations(db, project, part.section);
        blocks.push(Block { part: *part, kind: part.kind, declarations, expanded: false });
        if !database::has_macros(db, project) {
            continue;
        }
        let expanded = database::resolved_expansion(db, project, part.section);
        // Whatever else the section is, a macro makes no second mechanism or module of it.
        let other = if part.kind == SectionKind::Data { SectionKind::Data } else { SectionKind::File };
        for (kind, declarations) in [(SectionKind::DataLocal, &expanded.local), (other, &expanded.other)] {
            if !declarations.names.is_empty() || !declarations.storage.is_empty() {
                blocks.push(Block { part: *part, kind, declarations, expanded: true });
            }
        }
    }
    blocks
}

fn declare(
    scope: &mut Scope,
    db: &dyn Db,
    part: &Part<'_>,
    exports: &Exports,
    name: &Arc<str>,
    what: &What,
    constants: &Constants,
) {
    let key = SymbolKey { scope: owner(part, what), name: name.clone() };
    let kind = kind_of(part, exports, name, what, constants);
    let routine = || Routine { key: key.clone(), file: part.file, outer: part.section.outer(db).clone() };
    match what {
        What::Mechanism => scope.mechanisms.push(routine()),
        What::Procedure => scope.procedures.push(routine()),
        _ => {}
    }
    let table = match key.scope {
        SymbolScope::File(file) => match scope.locals.get_mut(usize::from(file)) {
            Some(table) => table,
            None => return,
        },
        SymbolScope::Global | SymbolScope::System => &mut scope.globals,
        SymbolScope::Macro => &mut scope.macros,
    };
    let symbol = Symbol { key: key.clone(), kind };
    if *what == What::MacroWord {
        // A word may be appended to another macro, or again to its own with other flags.
        table.entry(name.clone()).or_insert(symbol);
        return;
    }
    if let Some(before) = table.get(name) {
        if let Some(clash) = clash(&before.kind, &symbol.kind, constants.conflicts.contains(name.as_ref())) {
            scope.clashes.insert(key, clash);
        }
        return;
    }
    table.insert(name.clone(), symbol);
}

fn clash(before: &SymbolKind, now: &SymbolKind, conflict: bool) -> Option<Clash> {
    let cell = |kind: &SymbolKind| {
        matches!(
            kind,
            SymbolKind::Bit { .. }
                | SymbolKind::Cell(_)
                | SymbolKind::Array { .. }
                | SymbolKind::Area { .. }
                | SymbolKind::Text { .. }
        )
    };
    match (before, now) {
        (SymbolKind::Constant(_), SymbolKind::Constant(_)) => conflict.then_some(Clash::Values),
        // Members of two structures may share a name when they mean the same.
        (SymbolKind::Member { .. }, SymbolKind::Member { .. }) if before == now => None,
        (SymbolKind::Mechanism, other) | (other, SymbolKind::Mechanism) if cell(other) => {
            Some(Clash::MechanismAndCell)
        }
        _ => Some(Clash::Twice),
    }
}

/// Every mechanism has a WORD `name_LINE`; a name that is taken already clashes.
fn mechanism_lines(scope: &mut Scope) {
    for mechanism in &scope.mechanisms {
        let name: Arc<str> = Arc::from(crate::syntax::ast::key(&format!("{}_LINE", mechanism.key.name)));
        let key = SymbolKey { scope: SymbolScope::Global, name: name.clone() };
        match scope.globals.get(&name) {
            Some(Symbol { kind: SymbolKind::MechanismLine, .. }) => {}
            Some(_) => {
                scope.clashes.entry(key).or_insert(Clash::Twice);
            }
            None => {
                scope.globals.insert(name, Symbol { key, kind: SymbolKind::MechanismLine });
            }
        }
    }
}

fn local_clashes(scope: &mut Scope) {
    for local in &scope.locals {
        for (name, symbol) in local {
            if scope.globals.contains_key(name) {
                scope.clashes.entry(symbol.key.clone()).or_insert(Clash::LocalAndGlobal);
            }
        }
    }
}

fn owner(part: &Part<'_>, what: &What) -> SymbolScope {
    let local = part.kind == SectionKind::DataLocal;
    match what {
        What::Macro | What::MacroWord => SymbolScope::Macro,
        What::Constant(_) | What::Mechanism | What::Procedure => SymbolScope::Global,
        _ if local => SymbolScope::File(part.file),
        _ => SymbolScope::Global,
    }
}

fn kind_of(part: &Part<'_>, exports: &Exports, name: &str, what: &What, constants: &Constants) -> SymbolKind {
    // DFM and DS outside DATA are reported where they stand.
    if part.kind == SectionKind::File
        && matches!(what, What::Bit { .. } | What::Cell { .. } | What::Area { .. })
    {
        return SymbolKind::Unknown;
    }
    let length = |storage: u32| {
        let known = exports.storage.get(storage as usize).copied().flatten();
        known.or_else(|| {
            let (.., expr, counts) = exports.lengths.iter().find(|(s, ..)| *s == storage)?;
            let len = constants.value(expr).filter(|len| (1..=super::collect::MAX_LENGTH).contains(len))?;
            Some(counts.bytes(len as u32))
        })
    };
    match what {
        What::Bit { bit, .. } => SymbolKind::Bit { bit: *bit },
        What::Cell { storage } | What::Area { storage } => match length(*storage) {
            Some(1) => SymbolKind::Cell(Width::Byte),
            Some(2) => SymbolKind::Cell(Width::Word),
            Some(4) => SymbolKind::Cell(Width::DWord),
            Some(len) => SymbolKind::Area { len },
            None => SymbolKind::Unknown,
        },
        What::Typed { element, array: false, .. } => SymbolKind::Cell(*element),
        What::Typed { storage, element, array: true } => {
            length(*storage).map_or(SymbolKind::Unknown, |len| SymbolKind::Array {
                element: *element,
                len: len / element.bytes(),
            })
        }
        What::Text { storage: Some(storage), .. } => length(*storage)
            .map_or(SymbolKind::Unknown, |len| SymbolKind::Text { len: len.saturating_sub(1) }),
        What::Text { len, .. } => SymbolKind::Text { len: *len },
        What::Constant(_) => {
            constants.values.get(name).copied().flatten().map_or(SymbolKind::Unknown, SymbolKind::Constant)
        }
        What::Structure(length) => length
            .value(|expr| constants.value(expr))
            .map_or(SymbolKind::Unknown, |len| SymbolKind::Structure { len }),
        What::Member { offset, element, count } => {
            let value = |extent: &Extent| extent.value(|expr| constants.value(expr));
            match (value(offset), value(count)) {
                (Some(offset), Some(len)) => SymbolKind::Member { offset, element: *element, len },
                _ => SymbolKind::Unknown,
            }
        }
        What::Mechanism => SymbolKind::Mechanism,
        What::Procedure => SymbolKind::Procedure,
        What::Macro | What::MacroWord => SymbolKind::Macro,
        What::Label | What::Unknown => SymbolKind::Unknown,
    }
}

/// Where names are declared.
pub(crate) fn sites<'db>(db: &'db dyn Db, project: Project) -> FxHashMap<SymbolKey, Vec<Site<'db>>> {
    let all = AllExports::read(db, project);
    let mut sites: FxHashMap<SymbolKey, Vec<Site<'db>>> = FxHashMap::default();
    for part in &database::parts(db, project).parts {
        for (part, exports, of) in all.of(part) {
            for ((name, what), index) in exports.names.iter().zip(&exports.indices) {
                let key = SymbolKey { scope: owner(&part, what), name: name.clone() };
                sites.entry(key).or_default().push(Site { section: part.section, of, index: *index });
            }
        }
    }
    sites
}

/// A section's declarations with lengths and constants that need other sections filled in.
pub(crate) fn resolved(
    db: &dyn Db,
    project: Project,
    section: Section<'_>,
    mut declarations: Declarations,
) -> Declarations {
    let mut value = |name: &str| constant(db, project, section, name);
    for (index, expr) in &declarations.expressions {
        let value = ConstExpr::read(expr).ok().and_then(|e| e.value(&mut value).ok());
        if let Some(declared) = declarations.names.get_mut(*index as usize) {
            declared.what = What::Constant(value);
        }
    }
    for (storage, name, expr, counts) in &declarations.lengths {
        let len = ConstExpr::read(expr).ok().and_then(|e| e.value(&mut value).ok());
        let Some(len) = len.filter(|len| (1..=super::collect::MAX_LENGTH).contains(len)) else { continue };
        let len = len as u32;
        if let Some(piece) = declarations.storage.get_mut(*storage as usize) {
            piece.len = counts.bytes(len);
        }
        if let Some(declared) = name.and_then(|name| declarations.names.get_mut(name as usize)) {
            match &mut declared.what {
                What::Area { storage } if matches!(len, 1 | 2 | 4) => {
                    declared.what = What::Cell { storage: *storage };
                }
                What::Text { len: characters, .. } => *characters = len,
                _ => {}
            }
        }
    }
    for declared in &mut declarations.names {
        let What::Text { over: Some(over), .. } = &mut declared.what else { continue };
        for step in std::mem::take(&mut over.later) {
            // A name that is neither constant nor member is reported where the operand is read.
            let sum = step
                .value(&mut |name| distance(db, project, section, name))
                .ok()
                .and_then(|step| over.offset.checked_add(step));
            over.offset = sum.unwrap_or(over.offset);
        }
    }
    declarations
}

/// The value of a constant as a section sees it.
pub(crate) fn constant(db: &dyn Db, project: Project, section: Section<'_>, name: &str) -> Option<i64> {
    let name = database::NameRef::new(db, Arc::from(name), section.file(db).order(db));
    match database::lookup(db, project, name) {
        Some(Symbol { kind: SymbolKind::Constant(value), .. }) => Some(*value),
        _ => None,
    }
}

/// What a name adds to an address: a constant, or a member of a structure.
fn distance(db: &dyn Db, project: Project, section: Section<'_>, name: &str) -> Option<i64> {
    let key = database::NameRef::new(db, Arc::from(name), section.file(db).order(db));
    match database::lookup(db, project, key) {
        Some(Symbol { kind: SymbolKind::Constant(value), .. }) => Some(*value),
        Some(Symbol { kind: SymbolKind::Member { offset, .. }, .. }) => Some(i64::from(*offset)),
        _ => None,
    }
}

/// Why the value of an expression is not known, as a section sees it.
pub(crate) fn no_value(
    db: &dyn Db,
    project: Project,
    section: Section<'_>,
    expr: &ConstExpr,
) -> Option<NoValue> {
    expr.value(&mut |name| constant(db, project, section, name)).err()
}

/// What a predefined symbol stands for.
#[must_use]
pub fn system_kind(kind: &SystemKind) -> SymbolKind {
    match kind {
        SystemKind::Bit { bit, .. } => SymbolKind::Bit { bit: *bit },
        SystemKind::FormalBit { bit } => SymbolKind::FormalBit { bit: *bit },
        SystemKind::Cell { prefix, .. } => SymbolKind::Cell(width(*prefix)),
        SystemKind::Array { element, len, .. } => SymbolKind::Array { element: width(*element), len: *len },
        SystemKind::Area { len, .. } => SymbolKind::Area { len: *len },
        SystemKind::Member { offset, element, len } => {
            SymbolKind::Member { offset: *offset, element: width(*element), len: *len }
        }
        SystemKind::Constant(value) => SymbolKind::Constant(*value),
    }
}

/// Width of an access with a prefix.
#[must_use]
pub const fn width(prefix: Prefix) -> Width {
    match prefix {
        Prefix::Byte | Prefix::High => Width::Byte,
        Prefix::Word => Width::Word,
        Prefix::Cnst | Prefix::Dwrd => Width::DWord,
        Prefix::Qwrd => Width::QWord,
        Prefix::Real => Width::Real,
    }
}

/// Whether bytes at an offset from a symbol lie in the data area the symbol belongs to.
pub(crate) fn inside_data(
    db: &dyn Db,
    project: Project,
    symbol: &SymbolKey,
    offset: i64,
    bytes: u32,
) -> bool {
    let layout = database::layout(db, project);
    let start = match symbol.scope {
        SymbolScope::System => {
            crate::catalogue::symbol(&symbol.name).and_then(|system| system_address(&system.kind))
        }
        SymbolScope::Macro => None,
        SymbolScope::Global | SymbolScope::File(_) => layout.place(symbol).map(|placed| placed.addr),
    };
    // Without an address the layout failed, which is reported by itself.
    let Some(start) = start else { return true };
    let (low, high) = match symbol.scope {
        SymbolScope::System | SymbolScope::Macro => (0, technol_image::system::LEN),
        SymbolScope::Global => (technol_image::system::LEN, layout.local_start()),
        SymbolScope::File(_) => (layout.local_start(), layout.local_start() + layout.local_len),
    };
    let first = i64::from(start).saturating_add(offset);
    first >= i64::from(low) && first.saturating_add(i64::from(bytes)) <= i64::from(high)
}

fn system_address(kind: &SystemKind) -> Option<u32> {
    match kind {
        SystemKind::Bit { addr, .. }
        | SystemKind::Cell { addr, .. }
        | SystemKind::Array { addr, .. }
        | SystemKind::Area { addr, .. } => Some(*addr),
        SystemKind::FormalBit { .. } | SystemKind::Member { .. } | SystemKind::Constant(_) => None,
    }
}
