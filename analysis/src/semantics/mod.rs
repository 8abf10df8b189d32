//! Declarations, scopes, memory layout, operands and types, equations, structure.
//!
//! `collect` reads what a section declares, `program` joins that to the scope of the project, `code` walks the lines
//! of a section and asks the others: `place` where an instruction may stand, `operands`, `address`, `sum`,
//! `bits`, `data` and `moves` what its operands mean, `equations` and `flow` what happens between lines. `structure` looks at whole
//! files, `lints` at what an expert would remark, `devices` at uses of tables, buses and axes that hardly do what was
//! meant.

pub mod analysis;
pub(crate) mod code;
pub(crate) mod collect;
pub mod constant;
pub mod declarations;
pub mod hir;
pub mod layout;
pub mod lints;
pub mod macros;
pub mod program;
pub mod recursion;
pub mod reference;
pub mod scope;
pub mod structure;
pub(crate) mod suggest;

mod address;
mod alternatives;
mod assembler;
mod bits;
mod block;
mod calls;
mod constants;
mod data;
pub(crate) mod devices;
mod equations;
pub mod exports;
mod flow;
mod identifiers;
mod moves;
mod new_cells;
mod operands;
pub(crate) mod place;
mod structures;
mod sum;
mod texts;
