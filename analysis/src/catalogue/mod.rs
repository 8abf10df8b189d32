//! The catalogue: every instruction, keyword, prefix and predefined symbol of TECHNOL as data.
//!
//! It is the single source: operand checks, semantics, hover, completion, signature help, the book and the
//! editors' keyword lists all ask it, and nothing repeats it. One file per manual chapter.

pub mod entry;

pub use entry::{
    Access, Bilingual, Effect, Entry, EntryKind, Equation, Example, Form, OperandKind, OperandSpec, Place, Prefix,
    PrefixSet, TimeUnit,
};
