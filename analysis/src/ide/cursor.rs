//! What stands at a position: the section, the line, the word, and what the word means.

use std::sync::Arc;

use crate::catalogue::{self, Entry, EntryKind};
use crate::database::{self, Db, NameRef, Project, Section, SourceFile};
use crate::location::{Location, Position, Span};
use crate::semantics::declarations::{IncludeLine, What};
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::layout::line_key;
use crate::semantics::reference::Referent;
use crate::semantics::scope::{Symbol, SymbolKind};
use crate::syntax::ast::{Columns, Line, Name, SIGNIFICANT};

/// A position with what surrounds it.
pub(super) struct Cursor<'db> {
    pub(super) db: &'db dyn Db,
    pub(super) project: Project,
    pub(super) section: Section<'db>,
    /// 0-based own line of the section.
    pub(super) own: u32,
    pub(super) line: &'db Line,
    /// As asked.
    pub(super) at: Position,
}

/// A word at a position, and its part in the line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Word<'db> {
    /// Before the colon.
    Label(&'db Name),
    /// Mnemonic or keyword.
    Operation(&'db Name),
    /// In an operand.
    Operand(&'db Name),
    /// A T_INCLUDE's file.
    Include(&'db IncludeLine),
}

/// What a word means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    /// An instruction, keyword or prefix.
    Entry(&'static Entry),
    /// A symbol of the project or of the system.
    Symbol(SymbolKey),
    /// A label of the section.
    Label(Arc<str>),
    /// A parameter or T_LOCAL symbol of the macro around it.
    Formal(Arc<str>),
    /// An included file, by its project path.
    File(String),
}

impl<'db> Cursor<'db> {
    /// `None` past the last line.
    pub(super) fn at(
        db: &'db dyn Db,
        project: Project,
        file: SourceFile,
        at: Position,
    ) -> Option<Cursor<'db>> {
        let owner =
            |section: &Section<'db>| Some((*section, section.lines(db).binary_search(&at.line).ok()?));
        let (section, own) = database::sections(db, file).iter().find_map(owner)?;
        let line = database::section_lines(db, section).lines.get(own)?;
        Some(Cursor { db, project, section, own: own as u32, line, at })
    }

    /// The word that contains or touches the position; the one to the right where two touch.
    pub(super) fn word(&self) -> Option<Word<'db>> {
        let column = self.at.column;
        let touches = |columns: &Columns| columns.start <= column && column <= columns.end;
        let includes = &database::section_declarations(self.db, self.section).includes;
        if let Some(include) = includes.iter().find(|i| i.line == self.own && touches(&i.columns)) {
            return Some(Word::Include(include));
        }
        let label = self.line.label.as_ref().map(Word::Label);
        let operation = self.line.operation.as_ref().map(Word::Operation);
        let mut words: Vec<Word<'db>> = label.into_iter().chain(operation).collect();
        for operand in &self.line.operands {
            words.extend(operand.names().into_iter().map(Word::Operand));
        }
        words.into_iter().rev().find(|word| touches(word.columns()))
    }

    /// What a word means; `None` when nobody knows.
    pub(super) fn meaning(&self, word: Word<'db>) -> Option<Meaning> {
        match word {
            Word::Include(include) => self.included(include),
            Word::Label(name) => self.named(name),
            // A macro may stand for an instruction.
            Word::Operation(name) => self.named(name).or_else(|| operation(name)),
            Word::Operand(name) => {
                self.named(name).or_else(|| operand_word(name)).or_else(|| self.looked_up(name))
            }
        }
    }

    /// Where columns of the line are in the file.
    pub(super) fn span(&self, columns: &Columns) -> Span {
        Span::in_line(self.at.line, columns.start, columns.end)
    }

    /// The file whose local names are visible here.
    pub(super) fn local_file(&self) -> Option<u8> {
        local_file(self.db, self.project, self.section)
    }

    /// What the analysis says, else the declaration at this place.
    fn named(&self, name: &Name) -> Option<Meaning> {
        let references = &database::section_analysis(self.db, self.project, self.section).references;
        let from = references.partition_point(|r| r.line < self.own);
        let here = references[from..].iter().take_while(|r| r.line == self.own);
        if let Some(reference) = here.into_iter().find(|r| r.columns == name.columns) {
            return Some(match &reference.referent {
                Referent::Symbol(key) => Meaning::Symbol(key.clone()),
                Referent::Label(key) => Meaning::Label(key.clone()),
                Referent::Formal(key) => Meaning::Formal(key.clone()),
            });
        }
        let declarations = database::section_declarations(self.db, self.section);
        let declares = |d: &&crate::semantics::declarations::Declared| {
            d.line == self.own && d.name.columns == name.columns
        };
        let declared = declarations.names.iter().find(declares)?;
        if declared.what == What::Label {
            return Some(Meaning::Label(Arc::from(name.key())));
        }
        if matches!(declared.what, What::Macro | What::MacroWord) {
            return Some(Meaning::Symbol(SymbolKey {
                scope: SymbolScope::Macro,
                name: Arc::from(name.key()),
            }));
        }
        self.symbol(name).map(|symbol| Meaning::Symbol(symbol.key.clone()))
    }

    /// Names in lines the analysis does not look at, for instance broken ones and macros.
    fn looked_up(&self, name: &Name) -> Option<Meaning> {
        if let Some(symbol) = self.symbol(name) {
            return Some(Meaning::Symbol(symbol.key.clone()));
        }
        let key = name.key();
        let declarations = database::section_declarations(self.db, self.section);
        let label = declarations.names.iter().any(|d| d.what == What::Label && d.name.key() == key);
        label.then(|| Meaning::Label(Arc::from(key)))
    }

    fn symbol(&self, name: &Name) -> Option<&'db Symbol> {
        let name = NameRef::new(self.db, Arc::from(name.key()), self.local_file());
        database::lookup(self.db, self.project, name).as_ref()
    }

    fn included(&self, include: &IncludeLine) -> Option<Meaning> {
        let from = self.section.file(self.db).path(self.db).clone();
        match self.project.includes(self.db).get(&(from, include.name.clone()))? {
            crate::project::IncludeTarget::File(path) => Some(Meaning::File(path.clone())),
            _ => None,
        }
    }
}

impl<'db> Word<'db> {
    /// Its columns.
    pub(super) fn columns(&self) -> &'db Columns {
        match self {
            Word::Label(name) | Word::Operation(name) | Word::Operand(name) => &name.columns,
            Word::Include(include) => &include.columns,
        }
    }
}

/// An instruction, declaration, directive or word of structure.
fn operation(name: &Name) -> Option<Meaning> {
    let entry = catalogue::entry(&name.text)?;
    let operand_only =
        matches!(entry.kind, EntryKind::TypePrefix | EntryKind::Keyword | EntryKind::EventProcedure);
    (!operand_only).then_some(Meaning::Entry(entry))
}

/// Prefixes, keywords and reserved procedure names.
fn operand_word(name: &Name) -> Option<Meaning> {
    if let Some(spelling) = catalogue::prefix(&name.text) {
        return catalogue::entry(spelling.prefix.name()).map(Meaning::Entry);
    }
    let entry = catalogue::entry(&name.text)?;
    matches!(entry.kind, EntryKind::Keyword | EntryKind::EventProcedure).then_some(Meaning::Entry(entry))
}

/// The file whose local names are visible in a section: its own, or the one that includes it.
pub(super) fn local_file(db: &dyn Db, project: Project, section: Section<'_>) -> Option<u8> {
    section.file(db).order(db).or_else(|| {
        database::parts(db, project).parts.iter().find(|part| part.section == section).map(|part| part.file)
    })
}

/// Where columns of an own line of a section are.
pub(super) fn location(db: &dyn Db, section: Section<'_>, own: u32, columns: &Columns) -> Option<Location> {
    let line = *section.lines(db).get(own as usize)?;
    let file = section.file(db).path(db).clone();
    Some(Location { file, span: Span::in_line(line, columns.start, columns.end) })
}

/// Where a symbol is declared; the cell `name_LINE` is declared with its mechanism.
pub(super) fn sites<'db>(db: &'db dyn Db, project: Project, key: &SymbolKey) -> &'db [database::Site<'db>] {
    let sites = database::sites(db, project);
    if let Some(found) = sites.get(key) {
        return found;
    }
    line_of(db, project, key).and_then(|mechanism| sites.get(mechanism)).map_or(&[], Vec::as_slice)
}

/// The mechanism whose `name_LINE` cell a symbol is.
pub(super) fn line_of<'db>(db: &'db dyn Db, project: Project, key: &SymbolKey) -> Option<&'db SymbolKey> {
    if key.scope != SymbolScope::Global {
        return None;
    }
    let scope = database::scope(db, project);
    let key_of = |name: &str| Some(&scope.globals.get(name).filter(|s| s.kind == SymbolKind::Mechanism)?.key);
    if let Some(mechanism) = key.name.strip_suffix("_LINE").and_then(key_of) {
        return Some(mechanism);
    }
    // The name of a long mechanism leaves no room for the whole ending.
    let cut = key.name.len() >= SIGNIFICANT;
    let mut keys = scope.mechanisms.iter().map(|routine| &routine.key).filter(|_| cut);
    keys.find(|mechanism| line_key(&mechanism.name) == *key.name)
}

/// A symbol by its key.
pub(super) fn symbol<'db>(db: &'db dyn Db, project: Project, key: &SymbolKey) -> Option<&'db Symbol> {
    let file = match key.scope {
        SymbolScope::File(file) => Some(file),
        SymbolScope::Macro => return database::scope(db, project).macros.get(&key.name),
        SymbolScope::Global | SymbolScope::System => None,
    };
    database::lookup(db, project, NameRef::new(db, key.name.clone(), file)).as_ref()
}

/// A symbol's name as its declaration spells it.
pub(super) fn spelling(db: &dyn Db, project: Project, key: &SymbolKey) -> String {
    if let Some(name) = database::sites(db, project).get(key).and_then(|sites| declared(db, project, sites)) {
        return name.to_owned();
    }
    let mechanism = line_of(db, project, key).map(|mechanism| sites(db, project, mechanism));
    match mechanism.and_then(|sites| declared(db, project, sites)) {
        Some(name) => format!("{name}_LINE"),
        None => key.name.to_string(),
    }
}

/// The name as the first of its declarations spells it.
fn declared<'db>(db: &'db dyn Db, project: Project, sites: &[database::Site<'db>]) -> Option<&'db str> {
    database::declared(db, project, *sites.first()?).map(|declared| declared.name.text.as_str())
}

/// The formal parameters of a user instruction, as its definition spells them; `None` when nothing of that name is
/// one.
pub(super) fn macro_parameters(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    name: &str,
) -> Option<Vec<String>> {
    let name = NameRef::new(db, Arc::from(crate::syntax::ast::key(name)), file.order(db));
    let symbol = database::lookup(db, project, name).as_ref().filter(|it| it.kind == SymbolKind::Macro)?;
    let site = sites(db, project, &symbol.key).first()?;
    let declared = database::section_declarations(db, site.section).names.get(site.index as usize)?;
    let text = crate::syntax::lines(site.section.text(db)).nth(declared.line as usize)?.text;
    let header = text.get(declared.name.columns.end as usize..)?.split(';').next()?;
    let word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '?' | '@');
    Some(header.split(|c: char| !word(c)).filter(|word| !word.is_empty()).map(str::to_owned).collect())
}
