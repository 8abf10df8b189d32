//! Declarations, scopes, memory layout, operands and types, equations, structure.

pub mod analysis;
pub mod constant;
pub mod declarations;
pub mod hir;
pub mod reference;
pub mod scope;

mod address;
pub(crate) mod code;
pub(crate) mod collect;
mod equations;
mod flow;
mod operands;
mod place;
mod structure;
mod suggest;
pub mod program;
