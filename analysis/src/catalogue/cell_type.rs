//! Keywords that name the type of a cell for the control: DEF_IN, DEF_OUT, SHARE_VAR (manual 18.2 and 27.6).

use super::entry::Prefix;

/// The type a keyword names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CellType {
    /// `TYPE_BIT`.
    Bit,
    /// An integer or real cell, at the width of this prefix (Byte, Word, Dwrd, Qwrd, Real).
    Cell(Prefix),
    /// `TYPE_STR`: a text.
    Text,
    /// `TYPE_BIN`: a binary block.
    Block,
}

/// Every keyword. The manual spells the sized integers with and without the second underscore.
pub const CELL_TYPES: &[&str] = &[
    "TYPE_BIT",
    "TYPE_INT_8",
    "TYPE_INT8",
    "TYPE_UNS_8",
    "TYPE_UNS8",
    "TYPE_BYTE",
    "TYPE_INT_16",
    "TYPE_INT16",
    "TYPE_UNS_16",
    "TYPE_UNS16",
    "TYPE_WORD",
    "TYPE_INT_32",
    "TYPE_INT32",
    "TYPE_UNS_32",
    "TYPE_UNS32",
    "TYPE_DWORD",
    "TYPE_INT_64",
    "TYPE_INT64",
    "TYPE_UNS_64",
    "TYPE_UNS64",
    "TYPE_QWORD",
    "TYPE_REAL",
    "TYPE_STR",
    "TYPE_BIN",
];

/// The type that `word` names, in any case; `None` when it names none.
#[must_use]
pub fn cell_type(word: &str) -> Option<CellType> {
    let name = CELL_TYPES.iter().find(|name| name.eq_ignore_ascii_case(word))?.strip_prefix("TYPE_")?;
    let digits = name.trim_start_matches(|c: char| !c.is_ascii_digit());
    Some(match (name, digits) {
        ("BIT", _) => CellType::Bit,
        ("STR", _) => CellType::Text,
        ("BIN", _) => CellType::Block,
        ("REAL", _) => CellType::Cell(Prefix::Real),
        ("BYTE", _) | (_, "8") => CellType::Cell(Prefix::Byte),
        ("WORD", _) | (_, "16") => CellType::Cell(Prefix::Word),
        ("DWORD", _) | (_, "32") => CellType::Cell(Prefix::Dwrd),
        _ => CellType::Cell(Prefix::Qwrd),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_keyword_names_a_width() {
        for (word, found) in [
            ("type_int_8", CellType::Cell(Prefix::Byte)),
            ("TYPE_UNS8", CellType::Cell(Prefix::Byte)),
            ("TYPE_BYTE", CellType::Cell(Prefix::Byte)),
            ("TYPE_INT16", CellType::Cell(Prefix::Word)),
            ("TYPE_WORD", CellType::Cell(Prefix::Word)),
            ("TYPE_UNS_32", CellType::Cell(Prefix::Dwrd)),
            ("TYPE_DWORD", CellType::Cell(Prefix::Dwrd)),
            ("TYPE_INT_64", CellType::Cell(Prefix::Qwrd)),
            ("TYPE_QWORD", CellType::Cell(Prefix::Qwrd)),
            ("TYPE_REAL", CellType::Cell(Prefix::Real)),
            ("TYPE_BIT", CellType::Bit),
            ("TYPE_STR", CellType::Text),
            ("TYPE_BIN", CellType::Block),
        ] {
            assert_eq!(cell_type(word), Some(found), "{word}");
        }
        assert_eq!(cell_type("TYPE_INT_24"), None);
        assert_eq!(cell_type("INT_8"), None);
    }
}
