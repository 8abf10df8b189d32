//! User instructions and macros (manual chapter 22).
//!
//! ```text
//! macro_definition(section)      header, T_LOCAL, flags, body lines            definition
//! file_macros(file)              DEF, APPEND, CONTROL, T_INCLUDE in text order  table
//! macro_table(project)           the same over all files, includes joined       table
//! macro_meaning(section, word)   which macro a word calls, by own lines         table
//! expansion(section)             own lines with the lines of the calls          expand, substitute
//! expansion_declarations         what those lines declare                       declare
//! ```
//!
//! An expansion is a flat list of lines: the own lines of the section, each call followed by what it expands to.
//! Everything that reads code walks that list; [`remap`] turns its line numbers into own lines and its columns into
//! those of the call. Sections without calls have no expansion and cost nothing.

pub(crate) mod body;
pub(crate) mod circles;
pub(crate) mod declare;
pub mod definition;
pub mod expand;
pub(crate) mod remap;
mod substitute;
pub(crate) mod table;

/// The prefix of formal parameters in TECHNOL instructions, without its dot.
pub const TMAC: &str = "TMAC";
/// Separates the name of a T_LOCAL symbol from what makes it unique.
const MARK: &str = "@@";
/// Most macros that may call each other, one inside the other.
pub const MAX_DEPTH: usize = 16;
/// Most lines that the calls of one section may expand to.
pub const MAX_LINES: usize = 10_000;

/// A message without what makes the names of T_LOCAL symbols unique.
#[must_use]
pub fn without_marks(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(MARK) {
        shown.push_str(&rest[..at]);
        let tail = &rest[at..];
        let end =
            tail.find(|c: char| !(c.is_ascii_alphanumeric() || matches!(c, '_' | '@'))).unwrap_or(tail.len());
        rest = &tail[end..];
    }
    shown.push_str(rest);
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_local_symbols_are_shown_as_written() {
        assert_eq!(without_marks("there is no label LOOP@@MAIN@2 here"), "there is no label LOOP here");
        assert_eq!(without_marks("A@@X@1, B@@X@1"), "A, B");
        assert_eq!(without_marks("mail@home"), "mail@home");
    }
}
