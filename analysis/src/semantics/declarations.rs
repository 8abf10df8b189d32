//! What the lines of a section declare. Positions are own lines of the section, so that declarations stay equal
//! while other sections change.

use std::sync::Arc;

use technol_image::op::Width;

use super::constant::ConstExpr;
use super::macros::definition::Flags;
use crate::diagnostics::Finding;
use crate::syntax::ast::{Columns, Expr, Name};

/// Declarations of one section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Declarations {
    /// Memory in order of declaration.
    pub storage: Vec<Storage>,
    /// Names in order of declaration.
    pub names: Vec<Declared>,
    /// EQUI values that need other constants: index into `names`, and the expression.
    pub expressions: Vec<(u32, Expr)>,
    /// Lengths that need constants of other sections: index into `storage`, index into `names`, the expression,
    /// and what it counts.
    pub lengths: Vec<(u32, Option<u32>, Expr, LengthOf)>,
    /// Files named by T_INCLUDE.
    pub includes: Vec<IncludeLine>,
    /// APPEND_T_MACRO, CONTROL_T_MACRO and T_INCLUDE lines, ascending.
    pub macro_lines: Vec<MacroLine>,
    /// Mistakes in the declarations.
    pub findings: Vec<Finding>,
}

/// A T_INCLUDE line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IncludeLine {
    /// 0-based own line.
    pub line: u32,
    /// Columns of the file name, with its apostrophes.
    pub columns: Columns,
    /// The file as spelled, without apostrophes.
    pub name: String,
    /// It stands in apostrophes: searched in the system folder.
    pub quoted: bool,
}

/// A line that decides which words call macros (manual 22).
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum MacroLine {
    /// APPEND_T_MACRO: `word` calls the macro `target`.
    Append {
        /// 0-based own line.
        line: u32,
        /// Key of the word.
        word: Arc<str>,
        /// Key of the macro.
        target: Arc<str>,
        /// Flags of its calls.
        flags: Flags,
    },
    /// CONTROL_T_MACRO.
    Control {
        /// 0-based own line.
        line: u32,
        /// PRE, else POS.
        pre: bool,
    },
    /// T_INCLUDE.
    Include {
        /// 0-based own line.
        line: u32,
        /// Spelled name.
        name: String,
    },
}

impl MacroLine {
    /// 0-based own line.
    #[must_use]
    pub const fn line(&self) -> u32 {
        match self {
            MacroLine::Append { line, .. }
            | MacroLine::Control { line, .. }
            | MacroLine::Include { line, .. } => *line,
        }
    }
}

/// What a text buffer lies over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overlay {
    /// Key of the symbol.
    pub symbol: String,
    /// Byte offset into it, as far as the line alone gives it.
    pub offset: i64,
    /// What is added to the offset and needs constants or members of structures of other sections.
    pub later: Vec<ConstExpr>,
}

/// A piece of memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Storage {
    /// Length in bytes.
    pub len: u32,
    /// Initial content (STR with a text); zero when absent.
    pub initial: Option<Vec<u8>>,
}

/// What a declared length counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthOf {
    /// Bytes (DS).
    Bytes,
    /// Characters; a byte more is reserved (STR).
    Characters,
    /// Elements of this many bytes (DEF_IN, DEF_OUT).
    Elements(u32),
}

impl LengthOf {
    /// Bytes of memory that `count` takes.
    #[must_use]
    pub const fn bytes(self, count: u32) -> u32 {
        match self {
            LengthOf::Bytes => count,
            LengthOf::Characters => count.saturating_add(1),
            LengthOf::Elements(size) => count.saturating_mul(size),
        }
    }
}

/// A declared name.
#[derive(Clone, Debug, PartialEq)]
pub struct Declared {
    /// As written, with its columns.
    pub name: Name,
    /// 0-based own line.
    pub line: u32,
    /// What it stands for.
    pub what: What,
}

/// A length that may need constants of other sections.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extent {
    /// The part that is known.
    pub known: u32,
    /// Further parts: so many times the value of the expression.
    pub open: Vec<(u32, ConstExpr)>,
}

impl Extent {
    /// Adds `other`, each part of it `times`.
    pub fn add(&mut self, other: &Extent, times: u32) {
        self.known = self.known.saturating_add(other.known.saturating_mul(times));
        self.open.extend(other.open.iter().map(|(size, expr)| (size.saturating_mul(times), expr.clone())));
    }

    /// The length, with the values that `constant` knows; `None` when one is missing or out of range.
    #[must_use]
    pub fn value(&self, mut constant: impl FnMut(&ConstExpr) -> Option<i64>) -> Option<u32> {
        let mut total = i64::from(self.known);
        for (size, expr) in &self.open {
            let count = constant(expr).filter(|count| (1..=super::collect::MAX_LENGTH).contains(count))?;
            total = total.checked_add(i64::from(*size) * count)?;
        }
        u32::try_from(total).ok().filter(|total| i64::from(*total) <= super::collect::MAX_LENGTH)
    }
}

/// What a declared name stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// A bit of a DFM byte.
    Bit {
        /// Index into [`Declarations::storage`].
        storage: u32,
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A cell of 1, 2 or 4 bytes (DFM label, DS 1/2/4).
    Cell {
        /// Index into [`Declarations::storage`].
        storage: u32,
    },
    /// An area without type (DS n).
    Area {
        /// Index into [`Declarations::storage`].
        storage: u32,
    },
    /// A cell of a named type, or an array of such cells (MAP_AIN, MAP_AOUT, DEF_IN, DEF_OUT).
    Typed {
        /// Index into [`Declarations::storage`].
        storage: u32,
        /// Type of the cell or of an element.
        element: Width,
        /// Declared with `[n]`, so that `name[n]` is an element.
        array: bool,
    },
    /// A text buffer (STR n).
    Text {
        /// Index into [`Declarations::storage`]; `None` when it lies over another symbol.
        storage: Option<u32>,
        /// The symbol it lies over.
        over: Option<Overlay>,
        /// Maximum number of characters.
        len: u32,
    },
    /// STRUC: its length in bytes.
    Structure(Extent),
    /// A member of a STRUC.
    Member {
        /// Bytes before it.
        offset: Extent,
        /// Type of an element.
        element: Width,
        /// Number of elements.
        count: Extent,
    },
    /// EQUI: the value, when the line alone gives it; else see [`Declarations::expressions`].
    Constant(Option<i64>),
    /// A user instruction (DEF_T_MACRO).
    Macro,
    /// A word that calls a user instruction (APPEND_T_MACRO).
    MacroWord,
    /// Declared by a line with a mistake: known, but nothing more can be said about it.
    Unknown,
    /// MECH_BEGIN: activation bit, and `name_LINE`.
    Mechanism,
    /// PROC_BEGIN.
    Procedure,
    /// `NAME:` in code; visible in its own section.
    Label,
}

/// What others see of a section's declarations: no positions.
#[derive(Clone, Debug, Default, PartialEq, salsa::SalsaValue)]
pub struct Exports {
    /// Length of each piece of memory; `None` when it needs constants of other sections.
    pub storage: Vec<Option<u32>>,
    /// Keys and what they stand for, in order of declaration; without labels.
    pub names: Vec<(Arc<str>, What)>,
    /// Index into [`Declarations::names`] of each.
    pub indices: Vec<u32>,
    /// EQUI values that need other constants: index into `names`.
    pub expressions: Vec<(u32, ConstExpr)>,
    /// Lengths that need other constants: index into `storage`, index into `names`, what it counts.
    pub lengths: Vec<(u32, Option<u32>, ConstExpr, LengthOf)>,
    /// Spelled names of included files.
    pub includes: Vec<(String, bool)>,
}

impl Declared {
    /// Where the name stands in its line.
    #[must_use]
    pub fn columns(&self) -> Columns {
        self.name.columns.clone()
    }
}
