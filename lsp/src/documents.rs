//! The documents the editor has open: the texts are ours until they are closed.

use std::collections::VecDeque;

use ropey::Rope;
use tower_lsp::ls_types::{TextDocumentContentChangeEvent, Uri};

use crate::positions::{self, Encoding};

/// The instruction that makes another file part of the project.
const INCLUDE: &str = "T_INCLUDE";

/// Changes that are remembered, for one before them that comes late.
const REMEMBERED: usize = 32;

/// A change that was applied.
#[derive(Clone, Debug)]
struct Applied {
    version: i32,
    /// The text it was applied to; ropes share what they have in common.
    before: Rope,
    changes: Vec<TextDocumentContentChangeEvent>,
}

/// An open document.
#[derive(Clone, Debug)]
pub(crate) struct Document {
    /// The client's own spelling of its address, used in everything sent back.
    pub(crate) uri: Uri,
    /// The client's version.
    pub(crate) version: i32,
    /// Its text.
    pub(crate) text: Rope,
    /// The last changes, by version.
    recent: VecDeque<Applied>,
}

impl Document {
    /// A document as it was opened.
    pub(crate) fn new(uri: Uri, version: i32, text: &str) -> Document {
        Document { uri, version, text: Rope::from_str(text), recent: VecDeque::new() }
    }

    /// Applies the changes in their order; each one's range is meant in the text the one before left.
    /// Returns whether a line that includes a file was touched.
    ///
    /// Some clients (Helix 25.01 when keys come fast) let one message overtake another. The version says where a late
    /// one belongs: what overtook it is taken back and applied again behind it.
    pub(crate) fn change(
        &mut self,
        version: i32,
        changes: &[TextDocumentContentChangeEvent],
        encoding: Encoding,
    ) -> bool {
        let in_order = self.recent.partition_point(|it| it.version <= version);
        let overtook = self.recent.split_off(in_order);
        if let Some(first) = overtook.front() {
            self.text = first.before.clone();
        }
        let mut includes = self.apply(version, changes.to_vec(), encoding);
        for it in overtook {
            includes |= self.apply(it.version, it.changes, encoding);
        }
        includes
    }

    fn apply(
        &mut self,
        version: i32,
        changes: Vec<TextDocumentContentChangeEvent>,
        encoding: Encoding,
    ) -> bool {
        let before = self.text.clone();
        let mut includes = false;
        for change in &changes {
            let Some(range) = change.range else {
                self.text = Rope::from_str(&change.text);
                includes = true; // nobody looked
                continue;
            };
            let start = positions::char_index(&self.text, range.start, encoding);
            // An end before the start deletes nothing.
            let end = positions::char_index(&self.text, range.end, encoding).max(start);
            includes |= self.includes_at(start, end);
            self.text.remove(start..end);
            self.text.insert(start, &change.text);
            includes |= self.includes_at(start, start + change.text.chars().count());
        }
        self.version = version;
        self.recent.push_back(Applied { version, before, changes });
        if self.recent.len() > REMEMBERED {
            self.recent.pop_front();
        }
        includes
    }

    /// Whether a line from character `start` to `end` includes a file, or looks like it.
    fn includes_at(&self, start: usize, end: usize) -> bool {
        let lines = self.text.char_to_line(start)..=self.text.char_to_line(end);
        let text =
            self.text.slice(self.text.line_to_char(*lines.start())..self.text.line_to_char(*lines.end() + 1));
        text.to_string().to_ascii_uppercase().contains(INCLUDE)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use tower_lsp::ls_types::{Position, Range};

    use super::*;

    fn document(text: &str) -> Document {
        Document::new("untitled:a".parse().unwrap(), 1, text)
    }

    fn edit(from: (u32, u32), to: (u32, u32), text: &str) -> TextDocumentContentChangeEvent {
        let position = |(line, character)| Position { line, character };
        let range = Some(Range { start: position(from), end: position(to) });
        TextDocumentContentChangeEvent { range, range_length: None, text: text.into() }
    }

    #[test]
    fn several_changes_of_one_message_apply_one_after_the_other() {
        let mut it = document("LDR A\r\nWR B\r\n");
        it.change(
            5,
            &[edit((0, 4), (0, 5), "𝄞"), edit((0, 6), (0, 6), ";"), edit((1, 0), (2, 0), "")],
            Encoding::Utf16,
        );
        assert_eq!((it.text.to_string().as_str(), it.version), ("LDR 𝄞;\r\n", 5));
    }

    #[test]
    fn a_change_without_a_range_replaces_everything() {
        let mut it = document("LDR A");
        let whole = TextDocumentContentChangeEvent { range: None, range_length: None, text: "WR B".into() };
        it.change(2, &[whole], Encoding::Utf8);
        assert_eq!(it.text.to_string(), "WR B");
    }

    /// As Helix 25.01 sent `NOBODY` when its keys came at once.
    #[test]
    fn changes_that_overtook_each_other_make_the_text_that_was_typed() {
        let typed = [(2, "N"), (3, "O"), (4, "B"), (5, "O"), (6, "D"), (7, "Y")];
        for order in [[2, 3, 4, 6, 7, 5], [7, 6, 5, 4, 3, 2], [3, 2, 5, 4, 7, 6], [2, 3, 4, 5, 6, 7]] {
            let mut it = document("LDR  ;");
            for version in order {
                let (_, text) = typed.iter().find(|(v, _)| *v == version).unwrap();
                let place = (0, 5 + version as u32 - 2);
                it.change(version, &[edit(place, place, text)], Encoding::Utf16);
            }
            assert_eq!((it.text.to_string().as_str(), it.version), ("LDR  NOBODY;", 7), "{order:?}");
        }
    }

    #[test]
    fn a_late_change_of_the_whole_text_does_not_undo_what_came_after_it() {
        let mut it = document("LDR A");
        it.change(3, &[edit((0, 3), (0, 3), "x")], Encoding::Utf8);
        let whole = TextDocumentContentChangeEvent { range: None, range_length: None, text: "WR B".into() };
        it.change(2, &[whole], Encoding::Utf8);
        assert_eq!((it.text.to_string().as_str(), it.version), ("WR xB", 3));
    }

    #[test]
    fn only_the_last_changes_are_remembered() {
        let mut it = document("");
        for version in 2..200 {
            it.change(version, &[edit((0, 0), (0, 0), "x")], Encoding::Utf8);
        }
        assert_eq!((it.recent.len(), it.text.len_chars()), (REMEMBERED, 198));
    }

    #[test]
    fn touching_an_include_is_noticed() {
        let mut it = document("LDR A\n t_include 'a.inc'\nWR B\n");
        for (change, noticed) in [
            (edit((0, 0), (0, 0), ";"), false),
            (edit((1, 12), (1, 13), "b"), true),
            (edit((0, 0), (2, 0), ""), true),
            (edit((0, 0), (0, 0), "T_INCLUDE 'x'\n"), true),
            (edit((1, 0), (1, 0), "; "), false),
        ] {
            assert_eq!(it.change(2, std::slice::from_ref(&change), Encoding::Utf16), noticed, "{change:?}");
        }
    }

    #[test]
    fn a_reversed_range_inserts_and_deletes_nothing() {
        let mut it = document("LDR A");
        it.change(2, &[edit((0, 3), (0, 1), "x")], Encoding::Utf8);
        assert_eq!(it.text.to_string(), "LDRx A");
    }

    /// Byte offset of a position by the protocol's own words, without a rope.
    fn offset(text: &str, line: u32, character: u32, encoding: Encoding) -> usize {
        let mut lines = vec![0];
        let bytes = text.as_bytes();
        for (at, byte) in bytes.iter().enumerate() {
            if *byte == b'\n' || (*byte == b'\r' && bytes.get(at + 1) != Some(&b'\n')) {
                lines.push(at + 1);
            }
        }
        let Some(&start) = lines.get(line as usize) else { return text.len() };
        let (mut units, mut end) = (0, start);
        for c in text[start..].chars() {
            units += if encoding == Encoding::Utf8 { c.len_utf8() } else { c.len_utf16() };
            if c == '\n' || c == '\r' || units > character as usize {
                break;
            }
            end += c.len_utf8();
        }
        end
    }

    const TEXT: &str = "([aB;ř€𝄞\u{2028}]|\r\n|\n|\r){0,12}";

    proptest! {
        #[test]
        fn edited_piecewise_equals_the_full_text(
            start in TEXT,
            edits in proptest::collection::vec(((0u32..6, 0u32..8), (0u32..6, 0u32..8), TEXT), 0..8),
            utf8 in any::<bool>(),
        ) {
            let encoding = if utf8 { Encoding::Utf8 } else { Encoding::Utf16 };
            let mut expected = start.clone();
            let mut changes = Vec::new();
            for (from, to, text) in edits {
                let first = offset(&expected, from.0, from.1, encoding);
                let last = offset(&expected, to.0, to.1, encoding).max(first);
                expected.replace_range(first..last, &text);
                changes.push(edit(from, to, &text));
            }
            let mut it = document(&start);
            it.change(2, &changes, encoding);
            prop_assert_eq!(it.text.to_string(), expected);
        }
    }
}
