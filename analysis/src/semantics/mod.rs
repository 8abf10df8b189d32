//! Declarations, scopes, memory layout, operands and types, equations, structure.

pub mod analysis;
pub mod constant;
pub mod declarations;
pub mod hir;
pub mod reference;
pub mod scope;

mod address;
mod code;
mod equations;
mod flow;
mod operands;
mod structure;
mod suggest;
mod program;
