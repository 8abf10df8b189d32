//! Help on what stands at a position.

use std::fmt::Write;

use super::cursor::{self, Cursor, Meaning, Word};
use super::describe;
use crate::catalogue::{self, EntryKind, Language, page};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::location::{Position, Span};
use crate::semantics::declarations::What;
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::layout::PlacedKind;
use crate::syntax::{self, ast::Line};

/// Help on a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// Markdown.
    pub markdown: String,
    /// The word.
    pub span: Span,
}

/// For instructions, keywords and predefined symbols their page of the catalogue; for the project's own names the
/// line that declares them with its comment, what they are, and where they lie.
#[must_use]
pub fn hover(db: &dyn Db, project: Project, file: SourceFile, at: Position, language: Language) -> Option<Hover> {
    let cursor = Cursor::at(db, project, file, at)?;
    let word = cursor.word()?;
    let markdown = match cursor.meaning(word)? {
        Meaning::Entry(entry) => page::markdown(entry, language),
        Meaning::Symbol(key) => symbol(db, project, &key, language)?,
        Meaning::Label(key) => label(&cursor, &key, language)?,
        Meaning::File(path) => format!("`{path}`\n"),
    };
    Some(Hover { markdown, span: cursor.span(word.columns()) })
}

/// Help on a symbol of the project or of the system.
pub(super) fn symbol(db: &dyn Db, project: Project, key: &SymbolKey, language: Language) -> Option<String> {
    if key.scope == SymbolScope::System {
        return Some(page::symbol_markdown(catalogue::symbol(&key.name)?, language));
    }
    let known = cursor::symbol(db, project, key)?;
    let mut markdown = String::new();
    let declaration = declaration(db, project, key);
    if let Some(declaration) = &declaration {
        // Writing to a String never fails.
        let _ = write!(markdown, "```technol\n{}\n```\n", declaration.code);
    }
    markdown.push_str(&describe::kind(known, language));
    if let Some(address) = address(db, project, key) {
        let _ = write!(markdown, " · {address}");
    }
    if let Some(declaration) = &declaration {
        let _ = write!(markdown, " · `{}`:{}", declaration.file, declaration.line + 1);
        if !declaration.comment.is_empty() {
            let _ = write!(markdown, "\n\n{}", declaration.comment);
        }
    }
    markdown.push('\n');
    if let Some(entry) = catalogue::entry(&key.name).filter(|entry| entry.kind == EntryKind::EventProcedure) {
        let _ = write!(markdown, "\n---\n\n{}", page::markdown(entry, language));
    }
    Some(markdown)
}

fn label(cursor: &Cursor<'_>, key: &str, language: Language) -> Option<String> {
    let names = &database::section_declarations(cursor.db, cursor.section).names;
    let declared = names.iter().find(|d| d.what == What::Label && d.name.key() == key)?;
    let line = source_line(cursor.db, cursor.section, declared.line)?;
    let kind = match language {
        Language::En => "label",
        Language::Cs => "návěští",
    };
    let place = *cursor.section.lines(cursor.db).get(declared.line as usize)? + 1;
    let file = cursor.section.file(cursor.db).path(cursor.db);
    let mut markdown = format!("```technol\n{}\n```\n{kind} · `{file}`:{place}\n", line.code);
    if !line.comment.is_empty() {
        let _ = write!(markdown, "\n{}\n", line.comment);
    }
    Some(markdown)
}

/// The line that declares a symbol.
struct Declaration {
    code: String,
    comment: String,
    file: String,
    /// 0-based, in the file.
    line: u32,
}

fn declaration(db: &dyn Db, project: Project, key: &SymbolKey) -> Option<Declaration> {
    let site = cursor::sites(db, project, key).first()?;
    let declared = database::section_declarations(db, site.section).names.get(site.index as usize)?;
    let source = source_line(db, site.section, declared.line)?;
    Some(Declaration {
        code: source.code,
        comment: source.comment,
        file: site.section.file(db).path(db).clone(),
        line: *site.section.lines(db).get(declared.line as usize)?,
    })
}

struct CodeAndComment {
    code: String,
    comment: String,
}

/// An own line of a section without the blanks around it, and its comment without the semicolon.
fn source_line(db: &dyn Db, section: Section<'_>, own: u32) -> Option<CodeAndComment> {
    let text = syntax::lines(section.text(db)).nth(own as usize)?.text;
    let line: &Line = database::section_lines(db, section).lines.get(own as usize)?;
    let (code, comment) = match &line.comment {
        Some(columns) => text.split_at(columns.start as usize),
        None => (text, ""),
    };
    let comment = comment.trim_start_matches([';', '-', '=', '*', ' ', '\t']).trim_end();
    Some(CodeAndComment { code: code.trim().to_owned(), comment: comment.to_owned() })
}

/// Where a symbol lies in PLC memory.
fn address(db: &dyn Db, project: Project, key: &SymbolKey) -> Option<String> {
    let placed = database::layout(db, project).place(key)?;
    let addr = describe::hexadecimal(u64::from(placed.addr));
    Some(match placed.kind {
        PlacedKind::Bit(bit) => format!("{addr}.{bit}"),
        _ => addr,
    })
}
