//! Resolved code of a section: what lowering reads. Symbols are still names, labels still names; bit positions,
//! widths and constants are final.

use std::sync::Arc;

use technol_image::op::Width;

use crate::catalogue::Entry;
use crate::syntax::section::SectionKind;

/// Who owns a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, salsa::SalsaValue)]
pub enum SymbolScope {
    /// DATA of any file, mechanisms, procedures.
    Global,
    /// DATA_LOCAL of the n-th file.
    File(u8),
    /// Predefined; the address comes from the catalogue.
    System,
    /// Words that call macros: they stand at the place of the operation only, so they are apart from all others.
    Macro,
}

/// A symbol of the project: scope and key (upper case, 31 characters).
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, salsa::SalsaValue)]
pub struct SymbolKey {
    /// Who owns it.
    pub scope: SymbolScope,
    /// Key of the name.
    pub name: Arc<str>,
}

/// An address: a symbol's byte (for a bit: the byte that holds it) plus an offset, plus BX when indexed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    /// The symbol.
    pub symbol: SymbolKey,
    /// Byte offset.
    pub offset: i64,
    /// BX is added at run time.
    pub indexed: bool,
}

/// A resolved operand.
#[derive(Clone, Debug, PartialEq)]
pub enum Operand {
    /// Not given: `-`, `NIL` or empty.
    Skipped,
    /// A bit. For a mechanism (its activation bit) the number comes with the layout, `bit` is 0 here.
    Bit {
        /// Its byte.
        address: Address,
        /// Bit number 0..=7.
        bit: u8,
        /// Read the negation.
        negated: bool,
    },
    /// A data cell. `HIGH.x` arrives as a Byte at offset + 1.
    Cell {
        /// Where.
        address: Address,
        /// Access width.
        width: Width,
        /// Negate the value.
        negated: bool,
    },
    /// An integer constant, sign already applied, sign-extended from `width`.
    Integer {
        /// Value.
        value: i64,
        /// Width of the operation (DWord for CNST. and EQUI).
        width: Width,
    },
    /// A real constant, sign already applied.
    Real(f64),
    /// An address without access width (MV, CLEAR); `len` is the declared length of the symbol in bytes.
    Area {
        /// Where.
        address: Address,
        /// Declared length of the whole symbol.
        len: u32,
    },
    /// A label of the same body.
    Label(Arc<str>),
    /// A mechanism.
    Mechanism(SymbolKey),
    /// A procedure.
    Procedure(SymbolKey),
    /// A keyword, upper case.
    Keyword(&'static str),
    /// A text literal.
    Text(Arc<str>),
    /// A member of one of the prepared blocks, `BLK[n].member` (manual 8.3).
    Block {
        /// Which block.
        number: BlockNumber,
        /// The bit or cell; its address is the offset in the record of a block.
        member: Box<Operand>,
    },
}

/// Which of the prepared blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockNumber {
    /// The n-th; 0 is the current one.
    Fixed(u32),
    /// The number is in BX.
    Indexed,
}

/// An instruction.
#[derive(Clone, Debug, PartialEq)]
pub struct Instruction {
    /// Catalogue entry.
    pub entry: &'static Entry,
    /// Operands in order; left-out trailing ones are absent.
    pub operands: Vec<Operand>,
    /// LDR: an equation is open, the old RLO is pushed.
    pub push: bool,
}

/// One own line of a section that means something to lowering.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// 0-based own line.
    pub line: u32,
    /// Labels that stand before it (a label may have a line of its own).
    pub labels: Vec<Arc<str>>,
    /// What it does; `None` for labels at the end of the section.
    pub kind: StatementKind,
}

/// What a statement does.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// An instruction.
    Instruction(Instruction),
    /// A nested mechanism or procedure stands here.
    Nested {
        /// Mechanism or Procedure.
        kind: SectionKind,
        /// Key of its name.
        name: Arc<str>,
        /// Ordinal within the file.
        ordinal: u32,
    },
    /// Nothing: carries labels only.
    Empty,
}

/// The code of one section. When `complete` is false the section has errors and cannot be lowered.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Body {
    /// Statements in order.
    pub statements: Vec<Statement>,
    /// No error stood in the way.
    pub complete: bool,
}
