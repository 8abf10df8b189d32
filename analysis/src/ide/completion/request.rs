//! What is asked for: the word at the position and its part in the line, read from the line up to the word alone,
//! because what stands behind it does not matter yet.

use crate::catalogue::{self, Prefix};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::location::{Position, Span};
use crate::semantics::macros::TMAC;
use crate::syntax::ast::{Expr, ExprKind, Line, Name, SyntaxErrorKind};
use crate::syntax::{self, parse_lines};

/// A position where a word may be written.
pub(super) struct Request<'db> {
    pub(super) db: &'db dyn Db,
    pub(super) project: Project,
    pub(super) section: Section<'db>,
    /// Letters of the word before the position.
    pub(super) typed: String,
    /// The whole word.
    pub(super) replace: Span,
    /// Nothing but blanks and a comment follows the word.
    pub(super) at_end: bool,
    pub(super) ask: Ask,
}

/// Part of the line.
pub(super) enum Ask {
    Operation,
    Operand(Operand),
}

/// A place in an operand.
pub(super) struct Operand {
    pub(super) operation: Name,
    /// Number of the operand, from 0.
    pub(super) index: usize,
    pub(super) part: Part,
}

/// Part of the operand.
pub(super) enum Part {
    /// Its beginning, behind a sign or an opening bracket.
    Whole,
    /// Behind `+` or `-` of a sum.
    Addend,
    /// Between `[` and `]`.
    Index,
    /// Behind a type prefix and its dot.
    Typed(Prefix),
    /// Behind `TMAC.` in the body of a macro.
    Parameter,
    /// Behind the dot of an address; its name, when it is a plain one.
    Bit(Option<Name>),
    /// Behind the dot of `BLK[n].`.
    BlockMember,
}

impl Request<'_> {
    /// Own line of the section.
    pub(super) fn own_line(&self) -> u32 {
        let line = self.replace.start.line;
        self.section.lines(self.db).partition_point(|own| *own < line) as u32
    }
}

impl<'db> Request<'db> {
    /// `None` in comments, texts, numbers, behind a complete operand, and outside of the text.
    pub(super) fn at(
        db: &'db dyn Db,
        project: Project,
        file: SourceFile,
        at: Position,
    ) -> Option<Request<'db>> {
        let text = line_text(file.text(db), at.line)?;
        let column = at.column as usize;
        let before = text.get(..column)?;
        let start = before
            .rfind(|c| !is_word(c))
            .map_or(0, |at| at + before[at..].chars().next().map_or(1, char::len_utf8));
        let behind = &text[column..];
        let end = column + behind.find(|c| !is_word(c)).unwrap_or(behind.len());
        let typed = &before[start..];
        if typed.starts_with(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let ask = ask(&before[..start])?;
        let follows = text[end..].trim_start();
        Some(Request {
            db,
            project,
            section: section_at(db, file, at.line)?,
            typed: typed.to_owned(),
            replace: Span::in_line(at.line, start as u32, end as u32),
            at_end: follows.is_empty() || follows.starts_with(';'),
            ask,
        })
    }
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '?' | '@')
}

/// The text of a line; empty for the place behind the last line's end.
fn line_text(text: &str, line: u32) -> Option<&str> {
    let mut lines = syntax::lines(text).skip(line as usize);
    match lines.next() {
        Some(line) => Some(line.text),
        None => (line as usize == syntax::lines(text).count()).then_some(""),
    }
}

/// The section that owns a line; behind the last line the innermost one that is still open.
fn section_at(db: &dyn Db, file: SourceFile, line: u32) -> Option<Section<'_>> {
    let sections = database::sections(db, file);
    if let Some(owner) = sections.iter().find(|section| section.lines(db).binary_search(&line).is_ok()) {
        return Some(*owner);
    }
    let mut inner = *sections.first()?;
    while let Some((child, before)) = inner.children(db).last() {
        let last = *before as usize == inner.lines(db).len();
        if !last || child.closed(db) {
            break;
        }
        inner = *child;
    }
    Some(inner)
}

/// Reads the line up to the word.
fn ask(head: &str) -> Option<Ask> {
    let parsed = parse_lines(head);
    let line = parsed.lines.first().cloned().unwrap_or_default();
    let unclosed = parsed.errors.iter().any(|e| e.kind == SyntaxErrorKind::UnclosedText);
    if line.comment.is_some() || unclosed {
        return None;
    }
    let Some(operation) = &line.operation else {
        let behind = line.label.as_ref().map_or(0, |label| label.columns.end as usize);
        return matches!(head[behind..].trim(), "" | ":").then_some(Ask::Operation);
    };
    if operation.text.eq_ignore_ascii_case("T_INCLUDE") {
        return None;
    }
    operand(&line, operation, &head[operation.columns.end as usize..]).map(Ask::Operand)
}

/// `head` is the text between the operation and the word.
fn operand(line: &Line, operation: &Name, head: &str) -> Option<Operand> {
    let last = line.operands.last();
    let part = match head.trim_end().chars().next_back() {
        None | Some(',' | '(') => Part::Whole,
        Some('[') => Part::Index,
        Some('+' | '-') => {
            if last.is_some_and(is_sum) {
                Part::Addend
            } else {
                Part::Whole
            }
        }
        Some('.') => match open_dot(last?)? {
            Expr { kind: ExprKind::Name(name), .. } if name.text.eq_ignore_ascii_case(TMAC) => {
                Part::Parameter
            }
            Expr { kind: ExprKind::Name(name), .. } => match catalogue::prefix(&name.text) {
                Some(spelling) => Part::Typed(spelling.prefix),
                None => Part::Bit(Some(name.clone())),
            },
            Expr { kind: ExprKind::Index { base, .. }, .. } if is_block(base) => Part::BlockMember,
            _ => Part::Bit(None),
        },
        Some(_) => return None,
    };
    Some(Operand { operation: operation.clone(), index: line.operands.len().saturating_sub(1), part })
}

fn is_block(base: &Expr) -> bool {
    matches!(&base.kind, ExprKind::Name(name) if name.text.eq_ignore_ascii_case("BLK"))
}

/// Whether an operand, read up to the position, ends in an open sum.
fn is_sum(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Sum { .. } => true,
        ExprKind::Parens(inner) | ExprKind::Sign { operand: inner, .. } => is_sum(inner),
        ExprKind::Dot { right, .. } => is_sum(right),
        _ => false,
    }
}

/// What stands before the dot that ends an operand.
fn open_dot(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Dot { left, right } if right.kind == ExprKind::Error && right.columns.is_empty() => {
            Some(left)
        }
        ExprKind::Dot { right: inner, .. }
        | ExprKind::Sum { right: inner, .. }
        | ExprKind::Sign { operand: inner, .. }
        | ExprKind::Parens(inner)
        | ExprKind::Index { index: inner, .. } => open_dot(inner),
        _ => None,
    }
}
