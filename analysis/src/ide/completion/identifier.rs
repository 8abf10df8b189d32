//! Completion between apostrophes: identifiers of configuration files.

use super::{Completion, CompletionKind, MOST_COMPLETIONS, rank};
use crate::catalogue::{self, Language};
use crate::configuration::uses;
use crate::database::{Db, Project, SourceFile};
use crate::ide::configured;
use crate::location::{Position, Span};
use crate::syntax::ast::SyntaxErrorKind;
use crate::syntax::{self, parse_lines};

/// The identifiers that fit; `None` when the position is not between apostrophes of an operand that takes one.
pub(super) fn list(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    at: Position,
    language: Language,
) -> Option<Vec<Completion>> {
    let line = syntax::lines(file.text(db)).nth(at.line as usize)?.text;
    let before = line.get(..at.column as usize)?;
    let parsed = parse_lines(before);
    let open = parsed.errors.iter().find(|error| error.kind == SyntaxErrorKind::UnclosedText)?;
    let start = open.columns.start as usize;
    let typed = before.get(start + 1..)?;
    let head = parse_lines(before.get(..start)?);
    let head = head.lines.first()?;
    let entry = catalogue::entry(&head.operation.as_ref()?.text)?;
    let element = uses::element_at(entry, head.operands.len().saturating_sub(1))?;
    // Up to the closing apostrophe; without one, what is typed.
    let behind = &line[at.column as usize..];
    let closed = behind.find('\'').filter(|end| !behind[..*end].contains([',', ';']));
    let end = at.column + closed.unwrap_or(0) as u32;
    let replace = Span::in_line(at.line, start as u32 + 1, end);
    let close = if closed.is_some() { "" } else { "'" };
    let typed = typed.to_ascii_uppercase();
    let mut found: Vec<(u8, Completion)> = configured::identifiers(db, project, element, language)
        .into_iter()
        .filter_map(|(label, detail)| {
            let rank = rank(&label.to_ascii_uppercase(), &typed)?;
            let insert = format!("{label}{close}");
            let kind = CompletionKind::Text;
            Some((rank, Completion { label, kind, detail, documentation: None, insert, replace }))
        })
        .collect();
    found.sort_by(|a, b| (a.0, &a.1.label).cmp(&(b.0, &b.1.label)));
    found.truncate(MOST_COMPLETIONS);
    Some(found.into_iter().map(|(_, completion)| completion).collect())
}
