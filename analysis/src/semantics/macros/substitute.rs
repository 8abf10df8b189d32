//! Puts actual operands and unique names into a line of a body, word by word, and keeps where each piece came from.

use super::TMAC;
use crate::syntax::SyntaxKind;
use crate::syntax::ast::{Columns, key};

/// Where a piece of an expanded line was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Spot {
    /// Index into the definitions of the expansion; `None` for the section itself.
    pub definition: Option<u16>,
    /// 0-based own line there.
    pub line: u32,
    /// Column there.
    pub column: u32,
}

/// A piece of an expanded line.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Segment {
    /// Columns of the expanded line.
    pub columns: Columns,
    /// Where it was written.
    pub spot: Spot,
    /// Length there; differs from the columns' for a renamed word.
    pub len: u32,
}

/// Text with its origin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Traced {
    pub(super) text: String,
    pub(super) segments: Vec<Segment>,
}

/// What stands for the names of a body.
pub(super) struct Bindings {
    /// Key of a formal parameter and its actual operand.
    pub(super) parameters: Vec<(String, Traced)>,
    /// Key of a T_LOCAL symbol and its unique name.
    pub(super) locals: Vec<(String, String)>,
}

impl Traced {
    /// Text that stands in one place as it is.
    pub(super) fn plain(text: &str, spot: Spot) -> Traced {
        let len = text.len() as u32;
        Traced { text: text.to_owned(), segments: vec![Segment { columns: 0..len, spot, len }] }
    }

    /// Some columns of it.
    pub(super) fn slice(&self, columns: &Columns) -> Traced {
        let mut cut = Traced {
            text: self.text.get(columns.start as usize..columns.end as usize).unwrap_or_default().to_owned(),
            segments: Vec::new(),
        };
        for segment in &self.segments {
            let start = segment.columns.start.max(columns.start);
            let end = segment.columns.end.min(columns.end);
            if start >= end {
                continue;
            }
            let exact = segment.columns.end - segment.columns.start == segment.len;
            let skipped = if exact { start - segment.columns.start } else { 0 };
            cut.segments.push(Segment {
                columns: start - columns.start..end - columns.start,
                spot: Spot { column: segment.spot.column + skipped, ..segment.spot },
                len: if exact { end - start } else { segment.len },
            });
        }
        cut
    }

    fn push(&mut self, text: &str, spot: Spot, len: u32) {
        let start = self.text.len() as u32;
        self.text.push_str(text);
        let end = self.text.len() as u32;
        let exact = end - start == len;
        if let Some(last) = self.segments.last_mut() {
            let next = Spot { column: last.spot.column + last.len, ..last.spot };
            if exact && last.columns.end - last.columns.start == last.len && next == spot {
                last.columns.end = end;
                last.len += len;
                return;
            }
        }
        self.segments.push(Segment { columns: start..end, spot, len });
    }

    fn append(&mut self, other: &Traced) {
        let start = self.text.len() as u32;
        self.text.push_str(&other.text);
        self.segments.extend(other.segments.iter().map(|segment| Segment {
            columns: segment.columns.start + start..segment.columns.end + start,
            ..segment.clone()
        }));
    }
}

/// Expands a line of a body. `bare`: formal parameters need no TMAC. here (80386 instructions, calls of macros).
pub(super) fn line(
    text: &str,
    operation: Option<&Columns>,
    bare: bool,
    origin: Spot,
    with: &Bindings,
) -> Traced {
    let tokens = crate::syntax::tokens(text);
    let mut out = Traced::default();
    // Everything before the operands: label and operation.
    let head = operation.map_or(u32::MAX, |columns| columns.end);
    let mut at = 0;
    let mut covered = false;
    let mut operand_end = 0;
    while let Some((kind, columns)) = tokens.get(at) {
        let word = &text[columns.start as usize..columns.end as usize];
        let spot = Spot { column: origin.column + columns.start, ..origin };
        let len = columns.end - columns.start;
        at += 1;
        let in_head = columns.start < head;
        if !in_head && at > operand_end {
            operand_end = at - 1 + comma(&tokens[at - 1..]);
            covered = tokens[at - 1..operand_end]
                .windows(2)
                .any(|pair| pair[1].0 == SyntaxKind::Dot && is_tmac(text, &pair[0]));
            operand_end += 1;
        }
        if *kind != SyntaxKind::Name {
            out.push(word, spot, len);
            continue;
        }
        if !in_head
            && is_tmac(text, &(*kind, columns.clone()))
            && tokens.get(at).is_some_and(|t| t.0 == SyntaxKind::Dot)
        {
            at += 1;
            continue;
        }
        let name = key(word);
        let is_operation = operation == Some(columns);
        let local = with.locals.iter().find(|(own, _)| *own == name && !is_operation);
        let actual = with.parameters.iter().find(|(own, _)| *own == name && !in_head && (bare || covered));
        match (local, actual) {
            (Some((_, unique)), _) => out.push(unique, spot, len),
            (None, Some((_, actual))) => out.append(actual),
            (None, None) => out.push(word, spot, len),
        }
    }
    out
}

/// Number of tokens before the next comma.
fn comma(tokens: &[(SyntaxKind, Columns)]) -> usize {
    tokens.iter().position(|(kind, _)| *kind == SyntaxKind::Comma).unwrap_or(tokens.len())
}

fn is_tmac(text: &str, (kind, columns): &(SyntaxKind, Columns)) -> bool {
    *kind == SyntaxKind::Name
        && text
            .get(columns.start as usize..columns.end as usize)
            .is_some_and(|word| word.eq_ignore_ascii_case(TMAC))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn expand(text: &str, bare: bool) -> Traced {
        let here = |column| Spot { definition: None, line: 9, column };
        let with = Bindings {
            parameters: vec![
                ("P".to_owned(), Traced::plain("ALFA", here(3))),
                ("Q".to_owned(), Traced::plain("(BUN+3)", here(9))),
            ],
            locals: vec![("NEXT".to_owned(), "NEXT@@MAIN@1".to_owned())],
        };
        let parsed = crate::syntax::parse_lines(text);
        let operation = parsed.lines[0].operation.as_ref().map(|name| name.columns.clone());
        line(text, operation.as_ref(), bare, Spot { definition: Some(0), line: 2, column: 0 }, &with)
    }

    #[test]
    fn parameters_and_local_names_are_replaced_word_by_word() {
        for (text, bare, expected) in [
            (" LDR TMAC.P", false, " LDR ALFA"),
            (" LO -tmac.p", false, " LO -ALFA"),
            (" WR TMAC.Q.P,P", false, " WR (BUN+3).ALFA,P"),
            (" STO1 TMAC.BYTE.Q", false, " STO1 BYTE.(BUN+3)"),
            (" STO1 BYTE.TMAC.Q", false, " STO1 BYTE.(BUN+3)"),
            (" LDR P", false, " LDR P"),
            (" MOV AL,P", true, " MOV AL,ALFA"),
            ("NEXT: JUM NEXT", false, "NEXT@@MAIN@1: JUM NEXT@@MAIN@1"),
            ("NEXT:", false, "NEXT@@MAIN@1:"),
            (" STRCPY TMAC.P,'TMAC.P NEXT'", false, " STRCPY ALFA,'TMAC.P NEXT'"),
            (" P TMAC.Q", false, " P (BUN+3)"),
            (" WR TMAC.P,TMAC.P", false, " WR ALFA,ALFA"),
        ] {
            assert_eq!(expand(text, bare).text, expected, "{text}");
        }
    }

    #[test]
    fn every_piece_knows_where_it_was_written() {
        let traced = expand(" WR TMAC.P,NEXT", false);
        assert_eq!(traced.text, " WR ALFA,NEXT@@MAIN@1");
        let shown: Vec<_> = traced
            .segments
            .iter()
            .map(|s| (s.columns.clone(), s.spot.definition.is_none(), s.spot.column, s.len))
            .collect();
        assert_eq!(
            shown,
            [(0..4, false, 0, 4), (4..8, true, 3, 4), (8..9, false, 10, 1), (9..21, false, 11, 4)]
        );
    }
}
