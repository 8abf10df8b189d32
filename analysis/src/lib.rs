//! The TECHNOL front end: text to meaning to program image.
//!
//! Pure: no I/O, no threads, no protocol types. Texts come in, plain data goes out.
//!
//! ```text
//! project::load ──► LoadedProject ──Change──► AnalysisHost ──► Analysis (snapshot) ──► plain answers
//! ```
//! [`AnalysisHost`] owns the database and takes changes; an [`Analysis`] is a cheap snapshot that answers questions
//! on any thread and is cancelled by the next change.

pub mod build;
pub mod catalogue;
pub mod configuration;
pub mod database;
pub mod diagnostics;
pub mod explain;
pub mod expression;
mod host;
pub mod ide;
pub mod location;
pub mod project;
pub mod semantics;
pub mod syntax;

pub use build::Built;
pub use catalogue::Language;
pub use diagnostics::{Diagnostic, Fix, Severity};
pub use host::{Analysis, AnalysisHost, Cancellable, Change};
pub use ide::{
    Completion, CompletionKind, DocumentSymbol, Hover, Parameter, Reference, SignatureHelp, SymbolTag,
    WorkspaceSymbol,
};
pub use location::{Location, Position, Span};
pub use salsa::Cancelled;
pub use semantics::reference::ReferenceAccess;
