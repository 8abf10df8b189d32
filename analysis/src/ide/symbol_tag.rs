//! Kinds of things an outline lists.

use crate::semantics::declarations::What;

/// What a listed thing is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SymbolTag {
    /// A module.
    Module,
    /// DATA or DATA_LOCAL.
    Data,
    /// A mechanism.
    Mechanism,
    /// A procedure.
    Procedure,
    /// A user instruction.
    Macro,
    /// A bit.
    Bit,
    /// A cell with a type.
    Cell,
    /// An area without type.
    Area,
    /// A text buffer.
    Text,
    /// A constant.
    Constant,
}

impl SymbolTag {
    /// The tag of a declaration; `None` for what is not listed.
    pub(super) fn of(what: &What) -> Option<SymbolTag> {
        match what {
            What::Bit { .. } => Some(SymbolTag::Bit),
            What::Cell { .. } | What::Typed { .. } | What::Unknown => Some(SymbolTag::Cell),
            What::Member { .. } => Some(SymbolTag::Cell),
            What::Area { .. } | What::Structure(_) => Some(SymbolTag::Area),
            What::Text { .. } => Some(SymbolTag::Text),
            What::Constant(_) => Some(SymbolTag::Constant),
            What::Macro | What::MacroWord => Some(SymbolTag::Macro),
            What::Mechanism => Some(SymbolTag::Mechanism),
            What::Procedure => Some(SymbolTag::Procedure),
            What::Label => None,
        }
    }
}
