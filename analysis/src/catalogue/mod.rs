//! The catalogue: every instruction, keyword, prefix and predefined symbol of TECHNOL as data.
//!
//! It is the single source: operand checks, semantics, hover, completion, signature help, the book and the
//! editors' keyword lists all ask it, and nothing repeats it. One file per manual chapter.

use std::collections::HashMap;
use std::sync::LazyLock;

pub mod cell_type;
pub mod configuration;
pub mod entry;
pub mod logical_elements;
pub mod page;
pub mod symbol;

mod assembler;
mod assembler_jumps;
mod chapter10;
mod chapter12;
mod chapter13;
mod chapter14;
mod chapter16;
mod chapter17;
mod chapter17_cells;
mod chapter18;
mod chapter19;
mod chapter19_axes;
mod chapter22;
mod chapter23;
mod chapter26;
mod chapter27;
mod chapter27_words;
mod chapter3_arithmetic;
mod chapter3_bits;
mod chapter3_compare;
mod chapter3_data;
mod chapter3_declarations;
mod chapter3_jumps;
mod chapter3_memory;
mod chapter3_procedures;
mod chapter3_register;
mod chapter3_strings;
mod chapter3_time;
mod chapter3_types;
mod chapter4;
mod chapter5_cycle;
mod chapter5_lifecycle;
mod chapter7;
mod chapter9;
mod pattern;
#[cfg(test)]
mod tests;
mod transfer;

pub use assembler::{AssemblerForm, register};
pub use cell_type::{CELL_TYPES, CellType, cell_type};
pub use entry::{
    Access, Bilingual, ConfigElement, Effect, Entry, EntryKind, Equation, Example, Form, NewCell,
    OperandKind, OperandSpec, Place, Prefix, PrefixSet, TimeUnit,
};
pub use symbol::{
    Direction, SystemKind, SystemSymbol, block_member, block_members, block_record_len, goes_on, symbol,
    symbols, unit_member, unit_members,
};

pub(crate) use pattern::MAX_LENGTH;

/// A language of the help.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English.
    #[default]
    En,
    /// Czech.
    Cs,
}

impl Bilingual {
    /// The text in `language`.
    #[must_use]
    pub const fn in_language(self, language: Language) -> &'static str {
        match language {
            Language::En => self.en,
            Language::Cs => self.cs,
        }
    }
}

impl Entry {
    /// Whether it is an 80386 instruction.
    #[must_use]
    pub fn is_assembler(&self) -> bool {
        self.chapter == assembler::CHAPTER
    }

    /// How the operands of an 80386 instruction with a defined meaning are written; `None` for those known by
    /// name only.
    #[must_use]
    pub fn assembler_form(&self) -> Option<AssemblerForm> {
        if self.is_assembler() { assembler::form_of(self.name) } else { None }
    }

    /// Whether it is an 80386 instruction known by name only, so that it is not reported as unknown. Such names
    /// make poor suggestions, and a symbol may well be called `LOOP` or `TEST`.
    #[must_use]
    pub fn is_known_only(&self) -> bool {
        self.chapter == assembler::CHAPTER && !self.executable
    }

    /// Whether it is a word that means something only as an operand of a few instructions, like `FAST` or
    /// `TYPE_WORD`: a program may use it as a name everywhere else.
    #[must_use]
    pub fn is_contextual(&self) -> bool {
        self.kind == EntryKind::Keyword && self.chapter == chapter27_words::CHAPTER
    }
}

/// How a prefix is spelled in a source text (manual 3.9).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PrefixSpelling {
    /// What it means.
    pub prefix: Prefix,
    /// `CNTS`, a misspelling of `CNST` that the manual itself uses: accepted with a warning.
    pub misspelled: bool,
}

impl Prefix {
    /// Every prefix.
    pub const ALL: [Prefix; 7] =
        [Prefix::Byte, Prefix::Word, Prefix::High, Prefix::Cnst, Prefix::Dwrd, Prefix::Qwrd, Prefix::Real];

    /// Its spelling, without the dot.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Prefix::Byte => "BYTE",
            Prefix::Word => "WORD",
            Prefix::High => "HIGH",
            Prefix::Cnst => "CNST",
            Prefix::Dwrd => "DWRD",
            Prefix::Qwrd => "QWRD",
            Prefix::Real => "REAL",
        }
    }

    /// Width of the access in bytes.
    #[must_use]
    pub const fn bytes(self) -> u32 {
        match self {
            Prefix::Byte | Prefix::High => 1,
            Prefix::Word => 2,
            Prefix::Cnst | Prefix::Dwrd => 4,
            Prefix::Qwrd | Prefix::Real => 8,
        }
    }
}

/// The files of entries, in manual order; the 80386 instructions come last.
static CHAPTERS: &[&[Entry]] = &[
    chapter3_declarations::ENTRIES,
    chapter3_bits::ENTRIES,
    chapter3_jumps::ENTRIES,
    chapter3_types::ENTRIES,
    chapter3_data::ENTRIES,
    chapter3_time::ENTRIES,
    chapter3_arithmetic::ENTRIES,
    chapter3_register::ENTRIES,
    chapter3_compare::ENTRIES,
    chapter3_memory::ENTRIES,
    chapter3_procedures::ENTRIES,
    chapter3_strings::ENTRIES,
    chapter4::ENTRIES,
    chapter5_cycle::ENTRIES,
    chapter5_lifecycle::ENTRIES,
    chapter7::ENTRIES,
    chapter9::ENTRIES,
    chapter10::ENTRIES,
    chapter12::ENTRIES,
    chapter13::ENTRIES,
    chapter14::ENTRIES,
    chapter16::ENTRIES,
    chapter17_cells::ENTRIES,
    chapter17::ENTRIES,
    chapter18::ENTRIES,
    chapter19::ENTRIES,
    chapter19_axes::ENTRIES,
    chapter22::ENTRIES,
    chapter23::ENTRIES,
    chapter26::ENTRIES,
    chapter27::ENTRIES,
    chapter27_words::ENTRIES,
    assembler::ENTRIES,
    assembler_jumps::ENTRIES,
];

static BY_NAME: LazyLock<HashMap<&'static str, &'static Entry>> =
    LazyLock::new(|| entries().map(|entry| (entry.name, entry)).collect());

/// Longest name the catalogue holds; longer ones are not looked up.
const LONGEST_NAME: usize = 40;

/// The entry of a mnemonic or keyword, in any case; `None` when there is none.
#[must_use]
pub fn entry(name: &str) -> Option<&'static Entry> {
    look_up(&BY_NAME, name).copied()
}

/// Every entry, in manual order; the 80386 instructions come last.
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    CHAPTERS.iter().copied().flatten()
}

/// The prefix spelled `name` (without the dot), in any case.
#[must_use]
pub fn prefix(name: &str) -> Option<PrefixSpelling> {
    if name.len() != 4 {
        return None;
    }
    if name.eq_ignore_ascii_case("CNTS") {
        return Some(PrefixSpelling { prefix: Prefix::Cnst, misspelled: true });
    }
    Prefix::ALL
        .into_iter()
        .find(|prefix| name.eq_ignore_ascii_case(prefix.name()))
        .map(|prefix| PrefixSpelling { prefix, misspelled: false })
}

/// Whether `name` is a prefix or a word that stands as an operand of any instruction (`NIL`, `BX`, `GLOBAL` …), in any
/// case.
#[must_use]
pub fn is_keyword(name: &str) -> bool {
    let keyword = |entry: &Entry| entry.kind == EntryKind::Keyword && !entry.is_contextual();
    prefix(name).is_some() || entry(name).is_some_and(keyword)
}

/// Looks `name` up in upper case without touching the heap.
fn look_up<'map, Value>(map: &'map HashMap<&'static str, Value>, name: &str) -> Option<&'map Value> {
    let mut buffer = [0_u8; LONGEST_NAME];
    let upper = buffer.get_mut(..name.len())?;
    upper.copy_from_slice(name.as_bytes());
    upper.make_ascii_uppercase();
    map.get(std::str::from_utf8(upper).ok()?)
}
