//! Lexer, resilient line parser, lossless tree, typed lines and the cut into sections. Every entry returns
//! (result, errors), never `Err`.
//!
//! TECHNOL is a language of lines: nothing the parser decides about a line depends on another one. So a line is
//! parsed once into [`ast::Line`], sections are cut by the first words of the lines alone, and the tree is both
//! put together.

pub mod ast;
pub mod kind;
mod lexer;
mod line;
mod lines;
mod operand;
pub mod section;
mod split;
mod tree;

pub use kind::{SyntaxKind, SyntaxNode, SyntaxToken, Technol};
pub use line::{ParsedLines, parse_lines};
pub use lines::{SourceLine, lines};
pub use split::split;
pub use tree::{Parse, parse};

/// The words of a line and what stands between them: kind and columns, covering the line.
pub(crate) fn tokens(line: &str) -> Vec<(SyntaxKind, ast::Columns)> {
    let mut tokens = Vec::new();
    lexer::lex(line, &mut tokens);
    tokens.into_iter().map(|token| (token.kind, token.columns())).collect()
}
