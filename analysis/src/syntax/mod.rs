//! Lexer, resilient line parser, lossless tree, typed lines and the cut into sections. Every entry returns
//! (result, errors), never `Err`.

pub mod ast;
pub mod section;
