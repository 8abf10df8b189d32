//! What may be written at a position.

mod identifier;
mod operand;
mod operation;
mod request;
#[cfg(test)]
mod tests;

use self::request::{Ask, Request};
use super::workspace_symbols::rank;
use crate::catalogue::Language;
use crate::database::{Db, Project, SourceFile};
use crate::location::{Position, Span};

/// A word that may be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// As listed.
    pub label: String,
    /// What it is.
    pub kind: CompletionKind,
    /// A few words about it.
    pub detail: String,
    /// Its help page (Markdown), when the list is short enough to carry pages.
    pub documentation: Option<String>,
    /// What to write.
    pub insert: String,
    /// What it replaces: the word at the position.
    pub replace: Span,
}

/// What a completion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CompletionKind {
    /// An instruction, declaration or directive.
    Instruction,
    /// A word that opens or closes a section.
    Structure,
    /// A word that stands as an operand.
    Keyword,
    /// A type prefix with its dot.
    Prefix,
    /// A bit.
    Bit,
    /// A cell or a row of cells.
    Cell,
    /// An area without type.
    Area,
    /// A text buffer.
    Text,
    /// A constant.
    Constant,
    /// A mechanism.
    Mechanism,
    /// A procedure.
    Procedure,
    /// A user instruction.
    Macro,
    /// A label in code.
    Label,
    /// A parameter or T_LOCAL symbol in the body of a macro.
    Parameter,
}

/// Longest answer. One of this length may lack words: ask again when another letter is typed.
pub const MOST_COMPLETIONS: usize = 1_000;

/// Longest list whose entries carry their help page.
const WITH_PAGES: usize = 40;

/// Words that may stand at a position and hold the letters typed so far, best first: at the place of the operation
/// the instructions allowed there, in an operand the names of the kinds it takes, behind the dot of an address
/// bits, behind the dot of a type cells, between apostrophes identifiers of configuration files. Nothing in comments,
/// other texts and numbers. At most [`MOST_COMPLETIONS`].
#[must_use]
pub fn completion(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    at: Position,
    language: Language,
) -> Vec<Completion> {
    if let Some(found) = identifier::list(db, project, file, at, language) {
        return found;
    }
    let Some(request) = Request::at(db, project, file, at) else { return Vec::new() };
    let mut list = List { typed: request.typed.to_ascii_uppercase(), found: Vec::new() };
    match &request.ask {
        Ask::Operation => operation::list(&request, language, &mut list),
        Ask::Operand(operand) => operand::list(&request, operand, language, &mut list),
    }
    list.finish(&request, language)
}

/// A word that may become a [`Completion`].
struct Candidate {
    label: String,
    insert: String,
    kind: CompletionKind,
    detail: String,
    /// Where its page comes from.
    page: Page,
}

/// Where a help page comes from.
enum Page {
    None,
    Entry(&'static crate::catalogue::Entry),
    Symbol(crate::semantics::hir::SymbolKey),
}

/// Candidates that match what is typed.
struct List {
    /// Upper case.
    typed: String,
    found: Vec<(u8, u8, Candidate)>,
}

impl List {
    /// Whether a name matches what is typed; asked before a candidate is made, because most do not.
    fn matches(&self, key: &str) -> bool {
        rank(key, &self.typed).is_some()
    }

    /// `fit` is 0 for what fits best.
    fn add(&mut self, fit: u8, candidate: Candidate) {
        if let Some(rank) = rank(&candidate.label.to_ascii_uppercase(), &self.typed) {
            self.found.push((rank, fit, candidate));
        }
    }

    fn finish(mut self, request: &Request<'_>, language: Language) -> Vec<Completion> {
        self.found.sort_by_cached_key(|(rank, fit, it)| (*rank, *fit, it.label.to_ascii_uppercase()));
        self.found.truncate(MOST_COMPLETIONS);
        let pages = self.found.len() <= WITH_PAGES;
        let completion = |(_, _, candidate): (u8, u8, Candidate)| Completion {
            documentation: if pages { candidate.page.text(request, language) } else { None },
            label: candidate.label,
            kind: candidate.kind,
            detail: candidate.detail,
            insert: candidate.insert,
            replace: request.replace,
        };
        self.found.into_iter().map(completion).collect()
    }
}

impl Page {
    fn text(&self, request: &Request<'_>, language: Language) -> Option<String> {
        match self {
            Page::None => None,
            Page::Entry(entry) => Some(crate::catalogue::page::markdown(entry, language)),
            Page::Symbol(key) => super::hover::symbol(request.db, request.project, key, language),
        }
    }
}
