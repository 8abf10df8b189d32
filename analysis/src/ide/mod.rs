//! What the editor asks: a position in, a plain answer out. One file per feature.
//!
//! Here section-relative positions become absolute again; nothing but the editor's requests depends on that.

pub mod completion;
pub mod definition;
pub mod document_symbols;
pub mod hover;
pub mod references;
pub mod signature_help;
pub mod workspace_symbols;

mod configured;
mod configured_word;
mod cursor;
mod describe;
#[cfg(test)]
mod fixture;
#[cfg(test)]
mod macros;
mod questions;
mod symbol_tag;

pub use completion::{Completion, CompletionKind, MOST_COMPLETIONS, completion};
pub use definition::definition;
pub use document_symbols::{DocumentSymbol, document_symbols};
pub use hover::{Hover, hover};
pub use references::{Reference, references};
pub use signature_help::{Parameter, SignatureHelp, signature_help};
pub use symbol_tag::SymbolTag;
pub use workspace_symbols::{WorkspaceSymbol, workspace_symbols};
