//! Shorthands the chapter files are written with: an entry starts from one of the patterns here and names only
//! what differs from it.

use super::entry::{
    Access, Bilingual, Effect, Entry, EntryKind, Equation, Example, Form, OperandKind, OperandSpec, Place,
    Prefix, PrefixSet,
};

/// Declared types a data operand takes: BYTE, WORD, DWORD.
pub(super) const CELLS: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Dwrd]);
/// Declared types a source takes: the cells and constants.
pub(super) const VALUES: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Dwrd, Prefix::Cnst]);
/// Declared types of a counter.
pub(super) const COUNTERS: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::Word]);
/// Prefixes of MULB and DIVB: all but QWRD.
pub(super) const FACTORS: PrefixSet =
    PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::High, Prefix::Cnst, Prefix::Dwrd, Prefix::Real]);
/// Prefixes of the bitwise instructions: all but REAL.
pub(super) const INTEGERS: PrefixSet =
    PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::High, Prefix::Cnst, Prefix::Dwrd, Prefix::Qwrd]);
/// Prefixes of a shift count.
pub(super) const SHIFTS: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::High, Prefix::Cnst]);
/// Declared types of a shift count.
pub(super) const SHIFT_CELLS: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::Cnst]);
/// The number of a message: a WORD cell or a constant.
pub(super) const MESSAGE: PrefixSet = PrefixSet::of(&[Prefix::Word, Prefix::Cnst]);
/// A value handed to a message: a DWORD cell or a constant.
pub(super) const MESSAGE_VALUE: PrefixSet = PrefixSet::of(&[Prefix::Dwrd, Prefix::Cnst]);

/// Most bytes that DS or STR reserves, more than any data area holds.
pub(crate) const MAX_LENGTH: i64 = 0xF_FFFF;

const NO_TEXT: Bilingual = text("", "");

/// An instruction without operands and effects that `build` can lower.
pub(super) const INSTRUCTION: Entry = Entry {
    name: "",
    kind: EntryKind::Instruction,
    chapter: "",
    forms: &[],
    operands: &[],
    equation: Equation::None,
    ex_type: false,
    place: Place::Code,
    reads: &[],
    writes: &[],
    time_unit: None,
    executable: true,
    summary: NO_TEXT,
    description: NO_TEXT,
    errors: NO_TEXT,
    examples: &[],
    related: &[],
};
/// A declaration in DATA or DATA_LOCAL.
pub(super) const DECLARATION: Entry =
    Entry { kind: EntryKind::Declaration, place: Place::Data, ..INSTRUCTION };
/// The first or last line of a block.
pub(super) const STRUCTURE: Entry =
    Entry { kind: EntryKind::Structure, place: Place::FileLevel, ..INSTRUCTION };
/// A directive to the compiler.
pub(super) const DIRECTIVE: Entry =
    Entry { kind: EntryKind::Directive, place: Place::Anywhere, ..INSTRUCTION };
/// A type prefix.
pub(super) const PREFIX: Entry = Entry { kind: EntryKind::TypePrefix, chapter: "3.9", ..INSTRUCTION };
/// A keyword that stands as an operand.
pub(super) const KEYWORD: Entry = Entry { kind: EntryKind::Keyword, ..INSTRUCTION };
/// A procedure the system calls.
pub(super) const EVENT_PROCEDURE: Entry =
    Entry { kind: EntryKind::EventProcedure, place: Place::Main, chapter: "3.17", ..INSTRUCTION };
/// Holds a sequence (EX, EX0, TIM …).
pub(super) const WAITING: Entry = Entry {
    chapter: "4.2",
    equation: Equation::Terminal,
    ex_type: true,
    place: Place::Sequence,
    writes: &[Effect::Memory],
    ..INSTRUCTION
};

/// An instruction that `build` refuses.
pub(super) const UNMODELLED: Entry = Entry { executable: false, ..INSTRUCTION };
/// The same in DATA.
pub(super) const UNMODELLED_DATA: Entry = Entry { executable: false, ..DECLARATION };
/// An instruction of a sequence that takes several cycles.
pub(super) const MULTI_CYCLE: Entry =
    Entry { ex_type: true, place: Place::Sequence, equation: Equation::Overwrite, ..UNMODELLED };

/// A text in both languages.
pub(super) const fn text(en: &'static str, cs: &'static str) -> Bilingual {
    Bilingual { en, cs }
}

/// One way to write an instruction.
pub(super) const fn form(syntax: &'static str) -> Form {
    Form { syntax }
}

/// An example with its note.
pub(super) const fn example(code: &'static str, en: &'static str, cs: &'static str) -> Example {
    Example { code, note: text(en, cs) }
}

/// An operand that must be given, once.
pub(super) const fn operand(
    name: &'static str,
    kind: OperandKind,
    en: &'static str,
    cs: &'static str,
) -> OperandSpec {
    OperandSpec { name, kind, optional: false, repeatable: false, skippable: false, help: text(en, cs) }
}

impl OperandSpec {
    /// The same operand, which may be left out.
    pub(super) const fn or_nothing(mut self) -> OperandSpec {
        self.optional = true;
        self
    }

    /// The same operand, which must be given, be it as `-`.
    pub(super) const fn required(mut self) -> OperandSpec {
        self.optional = false;
        self
    }

    /// The same operand, comma separated any number of times.
    pub(super) const fn repeated(mut self) -> OperandSpec {
        self.repeatable = true;
        self
    }

    /// The same operand, where `-` stands for "not given".
    pub(super) const fn or_dash(mut self) -> OperandSpec {
        self.skippable = true;
        self
    }
}

/// A bit that is read; a leading `-` negates it.
pub(super) const READ_BIT: OperandKind =
    OperandKind::Bit { access: Access::Read, negatable: true, extended: true };
/// A bit that is read as it is (the source of MOVR).
pub(super) const SOURCE_BIT: OperandKind =
    OperandKind::Bit { access: Access::Read, negatable: false, extended: true };
/// A bit that is written.
pub(super) const WRITE_BIT: OperandKind =
    OperandKind::Bit { access: Access::Write, negatable: false, extended: true };
/// A bit given by its name only (EDGE_H, EDGE_L).
pub(super) const NAMED_BIT: OperandKind =
    OperandKind::Bit { access: Access::Read, negatable: false, extended: false };

/// A value that is read at its type; takes these prefixes and declared types.
pub(super) const fn source(prefixes: PrefixSet, declared: PrefixSet) -> OperandKind {
    OperandKind::Data { access: Access::Read, prefixes, declared, negatable: false }
}

/// What LOD loads: any value, negated by a leading `-`.
pub(super) const LOADED: OperandKind =
    OperandKind::Data { access: Access::Read, prefixes: PrefixSet::ALL, declared: VALUES, negatable: true };
/// What AD, SU and the comparisons take.
pub(super) const COMPARED: OperandKind = source(PrefixSet::ALL, VALUES);
/// Where STO stores.
pub(super) const STORED: OperandKind = OperandKind::Data {
    access: Access::Write,
    prefixes: PrefixSet::STORE,
    declared: CELLS,
    negatable: false,
};
/// The number of an NC axis.
pub(super) const AXIS: OperandSpec = operand(
    "axis",
    OperandKind::Number { min: 1, max: 16 },
    "Number of the NC axis, 1 to 16",
    "Číslo NC osy 1 až 16",
);
/// An unsigned byte by value: number, EQUI constant or BYTE cell.
pub(super) const BYTE_VALUE: OperandKind =
    OperandKind::OneOf(&[OperandKind::Number { min: 0, max: 0xFF }, BYTE_CELL]);
/// An unsigned word by value: number, EQUI constant or WORD cell.
pub(super) const WORD_VALUE: OperandKind =
    OperandKind::OneOf(&[OperandKind::Number { min: 0, max: 0xFFFF }, WORD_CELL]);
/// A BYTE cell that is read.
pub(super) const BYTE_CELL: OperandKind =
    source(PrefixSet::of(&[Prefix::Byte]), PrefixSet::of(&[Prefix::Byte]));
/// A WORD cell that is read.
pub(super) const WORD_CELL: OperandKind =
    source(PrefixSet::of(&[Prefix::Word]), PrefixSet::of(&[Prefix::Word]));
/// A DWORD cell that is read.
pub(super) const DWORD_CELL: OperandKind =
    source(PrefixSet::of(&[Prefix::Dwrd]), PrefixSet::of(&[Prefix::Dwrd]));

/// A BYTE or WORD counter that is read and written.
pub(super) const COUNTER: OperandKind = OperandKind::Data {
    access: Access::ReadWrite,
    prefixes: PrefixSet::NONE,
    declared: COUNTERS,
    negatable: false,
};
