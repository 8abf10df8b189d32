//! Places in source text, as every answer of this crate gives them.

use crate::syntax::lines;

/// A position: 0-based line, and column in bytes of the line (UTF-8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Position {
    /// 0-based line.
    pub line: u32,
    /// 0-based column in bytes.
    pub column: u32,
}

/// A range; the end is exclusive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// First position.
    pub start: Position,
    /// First position after it.
    pub end: Position,
}

/// A range in a file of the project.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Location {
    /// Project path: relative to the root with `/`; files outside the root keep their absolute path.
    pub file: String,
    /// Where in it.
    pub span: Span,
}

impl Span {
    /// A range within one line.
    #[must_use]
    pub const fn in_line(line: u32, start: u32, end: u32) -> Span {
        Span { start: Position { line, column: start }, end: Position { line, column: end } }
    }

    /// Whether `position` lies in the range or at its end.
    #[must_use]
    pub fn touches(&self, position: Position) -> bool {
        self.start <= position && position <= self.end
    }

    /// The range of a byte range of `text`; offsets past the end mean the end.
    #[must_use]
    pub fn of_bytes(text: &str, bytes: std::ops::Range<usize>) -> Span {
        Span { start: Position::of_byte(text, bytes.start), end: Position::of_byte(text, bytes.end) }
    }
}

impl Position {
    /// The position of a byte offset of `text`; an offset past the end means the end.
    #[must_use]
    pub fn of_byte(text: &str, offset: usize) -> Position {
        let offset = offset.min(text.len());
        let (mut line, mut start) = (0, 0);
        for own in lines(text) {
            let next = start + own.text.len() + own.end.len();
            if offset < next || own.end.is_empty() {
                break;
            }
            (line, start) = (line + 1, next);
        }
        Position { line, column: (offset - start) as u32 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn byte_offsets_become_lines_and_columns() {
        let text = "ab\ncde\n";
        assert_eq!(Position::of_byte(text, 0), Position { line: 0, column: 0 });
        assert_eq!(Position::of_byte(text, 4), Position { line: 1, column: 1 });
        assert_eq!(Position::of_byte(text, 7), Position { line: 2, column: 0 });
        assert_eq!(Position::of_byte(text, 99), Position { line: 2, column: 0 });
    }

    #[test]
    fn lines_are_those_of_the_editors() {
        let text = "a\rbc\r\nd";
        assert_eq!(Position::of_byte(text, 1), Position { line: 0, column: 1 });
        assert_eq!(Position::of_byte(text, 3), Position { line: 1, column: 1 });
        assert_eq!(Position::of_byte(text, 6), Position { line: 2, column: 0 });
        assert_eq!(Position::of_byte(text, 7), Position { line: 2, column: 1 });
    }
}
