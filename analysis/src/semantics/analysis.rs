//! What the analysis of one section gives.

use super::hir::{Body, SymbolKey};
pub use super::identifiers::{IdentifierText, IdentifierUse};
use super::reference::Reference;
use crate::diagnostics::Finding;
use crate::syntax::ast::Columns;

/// The code of one section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionAnalysis {
    /// Mistakes, in line order.
    pub findings: Vec<Finding>,
    /// Resolved statements.
    pub body: Body,
    /// Uses of names, in order of the text.
    pub references: Vec<Reference>,
    /// Accesses that end outside the declared memory of their symbol.
    pub overruns: Vec<Overrun>,
    /// Identifiers of the configuration in it, in order of the text.
    pub identifiers: Vec<IdentifierUse>,
    /// Procedures it calls, with the place of the call.
    pub calls: Vec<(SymbolKey, u32, Columns)>,
}

/// An access that ends outside the declared memory of its symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overrun {
    /// 0-based own line.
    pub line: u32,
    /// Columns of the operand.
    pub columns: Columns,
    /// The symbol.
    pub symbol: SymbolKey,
    /// Byte offset of the access from the symbol.
    pub offset: i64,
    /// Its length in bytes.
    pub bytes: u32,
    /// Length declared for the symbol in bytes.
    pub declared: u32,
    /// Line and columns in the expansion of the section, when it stands in one.
    pub expanded: Option<(u32, Columns)>,
}
