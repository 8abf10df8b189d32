//! Uses of names in code, for the editor.

use std::sync::Arc;

use super::hir::SymbolKey;
use crate::syntax::ast::Columns;

/// What a use does with the symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ReferenceAccess {
    /// Declares it.
    Declare,
    /// Reads it.
    Read,
    /// Writes it.
    Write,
    /// Both.
    ReadWrite,
    /// Jumps to it.
    Jump,
    /// Calls it, or names a mechanism.
    Call,
}

/// What a name in code refers to.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Referent {
    /// A symbol of the project or of the system.
    Symbol(SymbolKey),
    /// A label of the same section, by its key.
    Label(Arc<str>),
    /// A parameter or T_LOCAL symbol of the macro that the section defines, by its key.
    Formal(Arc<str>),
}

/// A use of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// 0-based own line of the section.
    pub line: u32,
    /// Columns of the name.
    pub columns: Columns,
    /// What it names.
    pub referent: Referent,
    /// What is done with it.
    pub access: ReferenceAccess,
}
