//! What the catalogue knows about one instruction or keyword.

/// A text in both languages of the help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bilingual {
    /// English.
    pub en: &'static str,
    /// Czech, with diacritics.
    pub cs: &'static str,
}

/// A type prefix, joined to its operand by a dot (manual 3.9).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Prefix {
    /// `BYTE.`: 8 bits.
    Byte,
    /// `WORD.`: 16 bits.
    Word,
    /// `HIGH.`: the upper byte of a WORD, 8 bits.
    High,
    /// `CNST.`: a direct constant, 32 bits.
    Cnst,
    /// `DWRD.`: 32 bits.
    Dwrd,
    /// `QWRD.`: 64 bits.
    Qwrd,
    /// `REAL.`: 64-bit floating point.
    Real,
}

/// A set of prefixes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PrefixSet(pub u8);

impl PrefixSet {
    /// No prefix.
    pub const NONE: PrefixSet = PrefixSet(0);
    /// BYTE, WORD, HIGH, DWRD, QWRD, REAL: what STO takes.
    pub const STORE: PrefixSet =
        PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::High, Prefix::Dwrd, Prefix::Qwrd, Prefix::Real]);
    /// All seven: what LOD, AD, SU and the comparisons take.
    pub const ALL: PrefixSet = PrefixSet(0x7F);

    /// The set of these prefixes.
    #[must_use]
    pub const fn of(prefixes: &[Prefix]) -> PrefixSet {
        let mut bits = 0;
        let mut i = 0;
        while i < prefixes.len() {
            bits |= 1 << prefixes[i] as u8;
            i += 1;
        }
        PrefixSet(bits)
    }

    /// Whether it holds `prefix`.
    #[must_use]
    pub const fn contains(self, prefix: Prefix) -> bool {
        self.0 & (1 << prefix as u8) != 0
    }
}

/// What an operand does with its cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads it.
    Read,
    /// Writes it.
    Write,
    /// Both.
    ReadWrite,
}

/// What an operand may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperandKind {
    /// A bit: `bit`, and with `extended` also `ADR.bit` and `$+n.bit`; with `negatable` a leading `-`.
    Bit {
        /// Access.
        access: Access,
        /// A leading `-` reads the negation.
        negatable: bool,
        /// `ADR.bit` addressing (manual 3.5).
        extended: bool,
    },
    /// A name that gives the position of a bit in a byte: a bit, or a bit position without a cell of its own.
    BitPosition,
    /// A data cell (or, when `prefixes` holds CNST, a constant) at its declared or prefixed type.
    Data {
        /// Access.
        access: Access,
        /// Prefixes it takes.
        prefixes: PrefixSet,
        /// Declared types it takes without a prefix: Byte, Word, Dwrd (and Cnst for EQUI names and numbers).
        declared: PrefixSet,
        /// A leading `-` negates.
        negatable: bool,
    },
    /// Memory handed by reference: a cell, an array, an area or a text buffer, with optional offset (`+n`, `[BX]`).
    Address(Access),
    /// A counter of TM, TIM, TEX: a BYTE or WORD cell, or `-`/`NIL` for an automatic one.
    AutoCounter,
    /// The time of TIM and TEX: number, EQUI constant or BYTE/WORD cell.
    Time,
    /// A label in code.
    Label,
    /// A mechanism; `MECH_BEGIN` declares it.
    Mechanism {
        /// This operand is the declaration.
        declares: bool,
    },
    /// A procedure; `PROC_BEGIN` declares it.
    Procedure {
        /// This operand is the declaration.
        declares: bool,
    },
    /// A new name that the instruction declares (EQUI).
    NewName,
    /// A bit name declared at its position in a DFM; may be empty.
    NewBit,
    /// An integer constant within these bounds (number, EQUI name or constant expression).
    Number {
        /// Smallest.
        min: i64,
        /// Largest.
        max: i64,
    },
    /// One of these integers (number, EQUI name or constant expression).
    NumberOf(&'static [i64]),
    /// An integer or real constant of any size.
    Constant,
    /// A real constant: a number with a decimal point.
    RealConstant,
    /// One of these keywords.
    Keyword(&'static [&'static str]),
    /// A keyword, or a number within the bounds (CONDR).
    KeywordOrNumber(&'static [&'static str], i64, i64),
    /// A number, name or expression by value for a message: WORD/DWORD cell or constant, `-` when skipped.
    Value(PrefixSet),
    /// A text buffer declared by STR, with optional offset.
    Text(Access),
    /// A text buffer with optional offset, or a literal in apostrophes.
    TextOrLiteral,
    /// A literal in apostrophes, or an address (STR's second operand).
    LiteralOrAddress,
    /// The identifier of an element of the configuration: a literal in apostrophes or the label of a text buffer.
    Identifier(ConfigElement),
    /// A new name that the instruction declares together with its memory (MAP_IN, DEF_IN …).
    Declares(NewCell),
    /// A cell that DEF_IN or DEF_OUT declared; `name[n]` is one element.
    DeclaredElement,
    /// The first of these that fits.
    OneOf(&'static [OperandKind]),
    /// Anything: checked only for well-formedness (operands of 80386 instructions).
    Any,
}

impl Entry {
    /// The memory its first operand declares.
    #[must_use]
    pub fn declares(&self) -> Option<NewCell> {
        match self.operands.first()?.kind {
            OperandKind::Declares(new) => Some(new),
            _ => None,
        }
    }
}

/// What an identifier names in the configuration files of the project.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ConfigElement {
    /// `Input` of a ChannelConfig (MAP_IN).
    Input,
    /// `Output` of a ChannelConfig (MAP_OUT).
    Output,
    /// `AnalogInput` of a ChannelConfig (MAP_AIN).
    AnalogInput,
    /// `AnalogOutput` of a ChannelConfig (MAP_AOUT).
    AnalogOutput,
    /// The destination of a `Connection`, without `PLC.Input.` (DEF_IN).
    LogicalInput,
    /// The source of a `Connection`, without `PLC.Output.` (DEF_OUT).
    LogicalOutput,
    /// `PlcParam` of a ChannelConfig (CNF_GET_…).
    Parameter,
    /// A constant of a PlcConstants file (CONST_GET).
    Constant,
    /// A PLC table, with or without its extension (PLCT_…).
    Table,
    /// A column of a PLC table by its identifier (PLCT_…).
    Column,
    /// The name under which a cell is shared with the control's screens (SHARE_VAR, SHARE_BIT).
    Shared,
}

/// Memory that an instruction declares for its operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NewCell {
    /// One bit (MAP_IN, MAP_OUT).
    Bit,
    /// A REAL cell of 8 bytes (MAP_AIN, MAP_AOUT).
    Real,
    /// A cell of the type that the third operand names; `name[n]` declares n elements (DEF_IN, DEF_OUT).
    Typed,
}

/// One operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OperandSpec {
    /// Name as the help shows it.
    pub name: &'static str,
    /// What it may be.
    pub kind: OperandKind,
    /// It may be left out (with everything after it).
    pub optional: bool,
    /// It may be repeated, comma separated (always the last one).
    pub repeatable: bool,
    /// `-` or an empty place stands for "not given".
    pub skippable: bool,
    /// What it means.
    pub help: Bilingual,
}

/// One way to write an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Form {
    /// As the help shows it, for instance `WR [ADR.]bit [, …]`.
    pub syntax: &'static str,
}

/// Part an instruction plays in a logic equation (manual 3.2, 3.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equation {
    /// None: leaves RLO and the stack alone.
    None,
    /// LDR: opens an equation, or pushes when one is open.
    Open,
    /// LA, LO, LX: combines with the operand, or pops.
    Combine,
    /// CA: changes RLO in place.
    Modify,
    /// Overwrites RLO without a push (EQ, EDGE_H, TM, CU, CONDR …).
    Overwrite,
    /// Closes the equation.
    Terminal,
}

/// What an instruction reads or writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// RLO.
    Rlo,
    /// DR at the operand's width.
    Dr,
    /// All 64 bits of DR.
    Dr64,
    /// DR_REAL.
    DrReal,
    /// The equation stack.
    Stack,
    /// Memory.
    Memory,
}

/// Where an instruction may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In code: any module, mechanism or procedure.
    Code,
    /// Anywhere: code, data, between modules (EQUI, DEBUG, T_INCLUDE, comments).
    Anywhere,
    /// In DATA or DATA_LOCAL.
    Data,
    /// In DATA, in DATA_LOCAL or between modules (STRUC).
    DataOrFileLevel,
    /// Between modules.
    FileLevel,
    /// Between modules or inside any module (DATA_LOCAL).
    FileLevelOrModule,
    /// In a mechanism, MODULE_BLOCK_INIT or MODULE_BLOCK_DONE.
    Sequence,
    /// In MODULE_MAIN (PROC_BEGIN).
    Main,
    /// In MODULE_MAIN, MODULE_FAST or (with a warning) MODULE_CONT (MECH_BEGIN).
    MechanismHost,
    /// In MODULE_INIT (EDEF …).
    Init,
    /// In MODULE_INIT or a procedure called from it (MAP_IN …).
    InitOrProcedure,
    /// In any module (STR).
    AnyModule,
}

/// Unit in which an instruction counts time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeUnit {
    /// Interface cycles: 20 ms, in MODULE_FAST 1 ms.
    Cycle,
    /// Passes of the surrounding DFTM block.
    Raster,
}

/// What an entry is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryKind {
    /// An instruction that becomes code.
    Instruction,
    /// A declaration (DFM, DS, EQUI, STR).
    Declaration,
    /// Opens or closes a block (module, mechanism, procedure, data).
    Structure,
    /// A directive to the compiler (DEBUG, CHECK, T_INCLUDE, macros).
    Directive,
    /// A type prefix.
    TypePrefix,
    /// A keyword that stands as an operand (NIL, BX, GLOBAL, ON …).
    Keyword,
    /// A reserved procedure name.
    EventProcedure,
}

/// An example of the help: a fragment that checks clean where it belongs.
///
/// Top-level sections (`DATA` … `DATA_END`, `MODULE_…` … `MODULE_…_END`) stand for those of a program. Of the lines
/// outside of them declarations go into DATA, MECH_BEGIN … MECH_END and PROC_BEGIN … PROC_END into MODULE_MAIN;
/// the rest is code of a mechanism when an instruction in it needs one, else of MODULE_MAIN. Names that an example
/// does not declare are those of the plant of the help, `tests/fixtures/catalogue/plant.plc`, so that a name means
/// the same thing on every page; labels that are not there follow the fragment. `tests/catalogue/examples.rs` checks
/// each one in such a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Example {
    /// Source lines.
    pub code: &'static str,
    /// What it does.
    pub note: Bilingual,
}

/// One instruction or keyword.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Upper-case mnemonic or keyword; prefixes without the dot.
    pub name: &'static str,
    /// What it is.
    pub kind: EntryKind,
    /// Manual chapter, for instance `3.6`.
    pub chapter: &'static str,
    /// Ways to write it.
    pub forms: &'static [Form],
    /// Operands in order.
    pub operands: &'static [OperandSpec],
    /// Part in an equation.
    pub equation: Equation,
    /// EX-type: may hold a sequence, moves its continuation (manual 4.3).
    pub ex_type: bool,
    /// Where it may stand.
    pub place: Place,
    /// What it reads.
    pub reads: &'static [Effect],
    /// What it writes.
    pub writes: &'static [Effect],
    /// Unit of its time operand.
    pub time_unit: Option<TimeUnit>,
    /// `build` can lower it; the others are known to the editor but refused by `build` with a clear error.
    pub executable: bool,
    /// One sentence.
    pub summary: Bilingual,
    /// The help page's body (Markdown paragraphs); empty for entries whose page is not written yet.
    pub description: Bilingual,
    /// What goes wrong and how the program learns of it (RLO, DR, a fault); empty when nothing can.
    pub errors: Bilingual,
    /// Examples.
    pub examples: &'static [Example],
    /// Related entries.
    pub related: &'static [&'static str],
}
