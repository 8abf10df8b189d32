//! Declarations, scopes, memory layout, operands and types, equations, structure.

pub mod declarations;
pub mod hir;
