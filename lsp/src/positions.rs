//! Positions of the protocol and of the analysis, converted here and nowhere else.
//!
//! The protocol counts columns in UTF-16 code units, or in bytes when the client offered that; the analysis counts
//! bytes. Lines end at `\n`, `\r\n` or a lone `\r` on both sides. Whatever a client sends is met with a place in
//! the text: past the line's end means its end, past the last line means the end of the text, and the inside of
//! a character means its start.

use ropey::{Rope, RopeSlice};
use technol_analysis::{Position, Span};
use tower_lsp::ls_types as lsp;

/// What the protocol's columns count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// Bytes.
    Utf8,
    /// UTF-16 code units.
    Utf16,
}

impl Encoding {
    /// Bytes when the client offers them (no conversion), else UTF-16, which every client knows.
    pub(crate) fn negotiate(offered: Option<&[lsp::PositionEncodingKind]>) -> Encoding {
        match offered {
            Some(kinds) if kinds.contains(&lsp::PositionEncodingKind::UTF8) => Encoding::Utf8,
            _ => Encoding::Utf16,
        }
    }

    /// Its name in the protocol.
    pub(crate) fn kind(self) -> lsp::PositionEncodingKind {
        match self {
            Encoding::Utf8 => lsp::PositionEncodingKind::UTF8,
            Encoding::Utf16 => lsp::PositionEncodingKind::UTF16,
        }
    }

    fn width(self, character: char) -> usize {
        match self {
            Encoding::Utf8 => character.len_utf8(),
            Encoding::Utf16 => character.len_utf16(),
        }
    }
}

/// Index of the character at the client's `position`.
pub(crate) fn char_index(text: &Rope, position: lsp::Position, encoding: Encoding) -> usize {
    let line = position.line as usize;
    if line >= text.len_lines() {
        return text.len_chars();
    }
    text.line_to_char(line) + walk(text.line(line), position.character as usize, |c| encoding.width(c)).chars
}

/// The analysis' position for the client's.
pub(crate) fn to_analysis(text: &Rope, position: lsp::Position, encoding: Encoding) -> Position {
    let line = position.line as usize;
    if line >= text.len_lines() {
        let last = text.len_lines() - 1;
        return Position { line: last as u32, column: text.line(last).len_bytes() as u32 };
    }
    let walked = walk(text.line(line), position.character as usize, |c| encoding.width(c));
    Position { line: position.line, column: walked.bytes as u32 }
}

/// The client's position for the analysis'.
pub(crate) fn to_client(text: &Rope, position: Position, encoding: Encoding) -> lsp::Position {
    let line = (position.line as usize).min(text.len_lines() - 1);
    let column = if line < position.line as usize { usize::MAX } else { position.column as usize };
    let walked = walk(text.line(line), column, char::len_utf8);
    let character = match encoding {
        Encoding::Utf8 => walked.bytes,
        Encoding::Utf16 => walked.utf16,
    };
    lsp::Position { line: line as u32, character: character as u32 }
}

/// The client's range for the analysis' span.
pub(crate) fn to_range(text: &Rope, span: Span, encoding: Encoding) -> lsp::Range {
    lsp::Range { start: to_client(text, span.start, encoding), end: to_client(text, span.end, encoding) }
}

/// How far a walk along a line came.
#[derive(Default)]
struct Walked {
    chars: usize,
    bytes: usize,
    utf16: usize,
}

/// Walks along `line` as far as whole characters fit into `column` of the given width, not into the line's end.
fn walk(line: RopeSlice<'_>, column: usize, width: impl Fn(char) -> usize) -> Walked {
    let mut walked = Walked::default();
    let mut left = column;
    for character in line.chars() {
        let wide = width(character);
        if wide > left || matches!(character, '\n' | '\r') {
            break;
        }
        left -= wide;
        walked.chars += 1;
        walked.bytes += character.len_utf8();
        walked.utf16 += character.len_utf16();
    }
    walked
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn at(line: u32, character: u32) -> lsp::Position {
        lsp::Position { line, character }
    }

    /// `a` 1 byte, `ř` 2 bytes, `€` 3 bytes, `𝄞` 4 bytes and two UTF-16 units.
    const MIXED: &str = "ař€𝄞b\r\nx\n\n𝄞";

    #[test]
    fn columns_count_what_was_negotiated() {
        let text = Rope::from_str(MIXED);
        // (byte column, UTF-16 column) of the same places
        for (bytes, units) in [(0, 0), (1, 1), (3, 2), (6, 3), (10, 5), (11, 6)] {
            let place = Position { line: 0, column: bytes };
            assert_eq!(to_client(&text, place, Encoding::Utf16), at(0, units));
            assert_eq!(to_client(&text, place, Encoding::Utf8), at(0, bytes));
            assert_eq!(to_analysis(&text, at(0, units), Encoding::Utf16), place);
            assert_eq!(to_analysis(&text, at(0, bytes), Encoding::Utf8), place);
        }
    }

    #[test]
    fn places_outside_the_text_are_moved_into_it() {
        let text = Rope::from_str(MIXED);
        for (asked, column) in [(at(0, 4), 6), (at(0, 99), 11), (at(1, 2), 1), (at(2, 5), 0)] {
            let expected = Position { line: asked.line, column };
            assert_eq!(to_analysis(&text, asked, Encoding::Utf16), expected, "{asked:?}");
        }
        assert_eq!(to_analysis(&text, at(9, 0), Encoding::Utf16), Position { line: 3, column: 4 });
        assert_eq!(to_client(&text, Position { line: 9, column: 0 }, Encoding::Utf16), at(3, 2));
        assert_eq!(to_client(&Rope::new(), Position { line: 1, column: 7 }, Encoding::Utf8), at(0, 0));
    }

    #[test]
    fn utf8_is_taken_only_when_it_is_offered() {
        let (utf8, utf16) = (lsp::PositionEncodingKind::UTF8, lsp::PositionEncodingKind::UTF16);
        assert_eq!(Encoding::negotiate(None), Encoding::Utf16);
        assert_eq!(Encoding::negotiate(Some(&[])), Encoding::Utf16);
        assert_eq!(Encoding::negotiate(Some(std::slice::from_ref(&utf16))), Encoding::Utf16);
        assert_eq!(Encoding::negotiate(Some(&[utf16, utf8])), Encoding::Utf8);
    }

    fn encoding() -> impl Strategy<Value = Encoding> {
        prop_oneof![Just(Encoding::Utf8), Just(Encoding::Utf16)]
    }

    proptest! {
        /// There and back for the start of every character; and a client may ask for any place at all.
        #[test]
        fn every_character_keeps_its_place(text in "([a;ř€𝄞\u{85}\u{2028}]|\r\n|\n|\r){0,40}", encoding in encoding(),
                                           line in 0u32..50, character in 0u32..50) {
            let rope = Rope::from_str(&text);
            for index in 0..=rope.len_chars() {
                let line = rope.char_to_line(index);
                let column = rope.char_to_byte(index) - rope.line_to_byte(line);
                let inside_end = index > 0 && index < rope.len_chars() && rope.char(index) == '\n' && rope.char(index - 1) == '\r';
                if inside_end { continue; }
                let place = Position { line: line as u32, column: column as u32 };
                let client = to_client(&rope, place, encoding);
                prop_assert_eq!(to_analysis(&rope, client, encoding), place);
                prop_assert_eq!(char_index(&rope, client, encoding), index);
            }
            let anywhere = lsp::Position { line, character };
            let place = to_analysis(&rope, anywhere, encoding);
            let index = char_index(&rope, anywhere, encoding);
            prop_assert_eq!(rope.char_to_byte(index), rope.line_to_byte(place.line as usize) + place.column as usize);
        }
    }
}
