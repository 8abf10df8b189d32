//! The TECHNOL front end: text to meaning to program image.
//!
//! Pure: no I/O, no threads, no protocol types. Texts come in, plain data goes out.

pub mod catalogue;
pub mod semantics;
pub mod syntax;
