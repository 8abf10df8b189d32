//! An XML text as plain data with places, and nothing of what the parser offers beyond that.

use crate::location::{Position, Span};
use crate::syntax::lines;

/// A well-formed text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Document {
    /// Elements in order of the text; the first is the root.
    pub elements: Vec<Element>,
}

/// An element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    /// Its name, and where the opening tag has it.
    pub name: Text,
    /// Index of the element around it.
    pub parent: Option<usize>,
    /// Attributes in order of the text.
    pub attributes: Vec<Attribute>,
    /// Text directly inside it, without the blanks around.
    pub content: Text,
    /// Comment behind it on its last line.
    pub note: String,
}

/// An attribute.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attribute {
    /// Its name.
    pub name: Text,
    /// Its value without quotes.
    pub value: Text,
}

/// A text with its place.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Text {
    /// The text, references resolved.
    pub text: String,
    /// Where; a value that is empty has an empty place.
    pub span: Span,
}

impl Document {
    /// Elements directly inside the element at `index`. Walks everything inside it: not for elements that nest.
    pub fn children(&self, index: usize) -> impl Iterator<Item = (usize, &Element)> {
        let inside = self.elements.iter().enumerate().skip(index + 1);
        inside
            .take_while(move |(_, it)| it.parent.is_some_and(|parent| parent >= index))
            .filter(move |(_, it)| it.parent == Some(index))
    }

    /// The element around another.
    #[must_use]
    pub fn parent(&self, element: &Element) -> Option<&Element> {
        self.elements.get(element.parent?)
    }

    /// Elements of this name.
    pub fn named<'a>(&'a self, name: &'a str) -> impl Iterator<Item = (usize, &'a Element)> {
        self.elements.iter().enumerate().filter(move |(_, it)| it.name.text == name)
    }
}

impl Element {
    /// The attribute of this name.
    #[must_use]
    pub fn attribute(&self, name: &str) -> Option<&Text> {
        self.attributes.iter().find(|it| it.name.text == name).map(|it| &it.value)
    }
}

impl Text {
    /// As an integer: decimal, or hexadecimal with `0x`.
    #[must_use]
    pub fn integer(&self) -> Option<i64> {
        integer(&self.text)
    }
}

/// An integer as configuration files write it: decimal with an optional sign, or hexadecimal with `0x`.
#[must_use]
pub fn integer(text: &str) -> Option<i64> {
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) if digits.starts_with(['+', '-']) => None,
        Some(digits) => i64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}

/// Where lines begin, to turn byte offsets into places.
pub(super) struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    pub(super) fn of(text: &'a str) -> Lines<'a> {
        let mut starts = vec![0];
        let mut at = 0;
        for line in lines(text) {
            at += line.text.len() + line.end.len();
            if !line.end.is_empty() {
                starts.push(at);
            }
        }
        Lines { text, starts }
    }

    pub(super) fn position(&self, offset: usize) -> Position {
        let offset = offset.min(self.text.len());
        let line = self.starts.partition_point(|start| *start <= offset).saturating_sub(1);
        let start = self.starts.get(line).copied().unwrap_or(0);
        Position { line: line as u32, column: (offset - start) as u32 }
    }

    pub(super) fn span(&self, range: std::ops::Range<usize>) -> Span {
        Span { start: self.position(range.start), end: self.position(range.end.max(range.start)) }
    }

    /// The character that an offset lies in; at the end of a line the last one of the line.
    pub(super) fn character(&self, offset: usize) -> Span {
        let whole = |at: usize| (0..=at).rev().find(|at| self.text.is_char_boundary(*at)).unwrap_or(0);
        let at = |start: usize| self.text.get(start..).and_then(|rest| rest.chars().next());
        let mut start = whole(offset.min(self.text.len()));
        let first = self.position(start).column == 0;
        if !first && matches!(at(start), None | Some('\r' | '\n')) {
            start = whole(start - 1);
        }
        let len = at(start).filter(|c| *c != '\n').map_or(0, char::len_utf8);
        self.span(start..start + len)
    }

    /// The byte offset of a line and a character in it, both counted from 1 as XML does: only a line feed ends a line.
    pub(super) fn offset(&self, row: u32, column: u32) -> usize {
        let above = self.text.split_inclusive('\n').take(row.saturating_sub(1) as usize);
        let start: usize = above.map(str::len).sum();
        let rest = self.text.get(start..).unwrap_or_default();
        let line = rest.split('\n').next().unwrap_or_default();
        let skipped = line.char_indices().nth(column.saturating_sub(1) as usize);
        start + skipped.map_or(line.trim_end_matches('\r').len(), |(at, _)| at)
    }
}
