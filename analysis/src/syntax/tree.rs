//! The lossless tree: sections, lines, and in them the tokens under nodes for the parts of the line.
//!
//! The tree says nothing that the typed lines do not say; it is there for what needs every character in its
//! place (formatting, selection, colours). It is put together from the cut and the parsed lines.

use rowan::{GreenNode, GreenNodeBuilder, Language};

use super::ast::{Expr, ExprKind, Line, SyntaxError};
use super::kind::{SyntaxKind, SyntaxNode, Technol};
use super::lexer::Token;
use super::line::parse_line;
use super::lines::{SourceLine, lines};
use super::section::{RawSection, SectionKind};
use super::split::split;

/// A parsed file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parse {
    /// The tree; its text is the source, whatever that is.
    pub green: GreenNode,
    /// At most one per line, ascending; lines of the file.
    pub errors: Vec<SyntaxError>,
}

impl Parse {
    /// Root of the tree, to walk it.
    #[must_use]
    pub fn root(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.green.clone())
    }
}

/// Parses a file.
#[must_use]
pub fn parse(text: &str) -> Parse {
    let sections = split(text);
    let mut tree = Tree {
        builder: GreenNodeBuilder::new(),
        tokens: Vec::new(),
        errors: Vec::new(),
        lines: lines(text).enumerate(),
        sections: &sections,
    };
    tree.section(0);
    Parse { green: tree.builder.finish(), errors: tree.errors }
}

struct Tree<'a, L> {
    builder: GreenNodeBuilder<'static>,
    tokens: Vec<Token>,
    errors: Vec<SyntaxError>,
    lines: L,
    sections: &'a [RawSection],
}

impl<'a, L: Iterator<Item = (usize, SourceLine<'a>)>> Tree<'a, L> {
    /// Sections nest only a few levels: module, mechanism, DATA_LOCAL, macro.
    fn section(&mut self, index: usize) {
        let sections = self.sections;
        let section = &sections[index];
        self.builder.start_node(raw(section_kind(section.kind)));
        let mut own = 0;
        for (child, before) in &section.children {
            self.own_lines(before - own);
            own = *before;
            self.section(*child);
        }
        self.own_lines(section.lines.len() as u32 - own);
        self.builder.finish_node();
    }

    fn own_lines(&mut self, count: u32) {
        for _ in 0..count {
            let Some((number, source)) = self.lines.next() else { return };
            let (line, problem) = parse_line(source.text, &mut self.tokens);
            if let Some((columns, kind)) = problem {
                self.errors.push(SyntaxError { line: number as u32, columns, kind });
            }
            LineTree { builder: &mut self.builder, text: source.text, tokens: &self.tokens, at: 0 }
                .line(&line);
            if !source.end.is_empty() {
                self.builder.token(raw(SyntaxKind::Newline), source.end);
            }
            self.builder.finish_node();
        }
    }
}

struct LineTree<'a> {
    builder: &'a mut GreenNodeBuilder<'static>,
    text: &'a str,
    tokens: &'a [Token],
    at: usize,
}

impl LineTree<'_> {
    fn line(&mut self, line: &Line) {
        self.start(SyntaxKind::Line);
        if let Some(label) = &line.label {
            self.tokens_to(label.columns.start);
            self.start(SyntaxKind::Label);
            self.tokens_to(label.columns.end);
            let colon = self.tokens[self.at..].iter().find(|t| t.kind != SyntaxKind::Whitespace);
            if let Some(colon) = colon.filter(|t| t.kind == SyntaxKind::Colon) {
                self.tokens_to(colon.end);
            }
            self.builder.finish_node();
        }
        if let Some(operation) = &line.operation {
            self.tokens_to(operation.columns.start);
            self.start(SyntaxKind::Operation);
            self.tokens_to(operation.columns.end);
            self.builder.finish_node();
        }
        for operand in &line.operands {
            self.operand(operand);
        }
        self.tokens_to(line.len);
    }

    fn operand(&mut self, expr: &Expr) {
        if expr.columns.is_empty() {
            return;
        }
        self.tokens_to(expr.columns.start);
        self.start(operand_kind(&expr.kind));
        match &expr.kind {
            ExprKind::Sign { operand, .. } => self.operand(operand),
            ExprKind::Parens(inner) => self.operand(inner),
            ExprKind::Sum { left, right, .. } | ExprKind::Dot { left, right } => {
                self.operand(left);
                self.operand(right);
            }
            ExprKind::Index { base, index } => {
                self.operand(base);
                self.operand(index);
            }
            _ => {}
        }
        self.tokens_to(expr.columns.end);
        self.builder.finish_node();
    }

    fn start(&mut self, kind: SyntaxKind) {
        self.builder.start_node(raw(kind));
    }

    /// Tokens that end at or before a column.
    fn tokens_to(&mut self, column: u32) {
        while let Some(token) = self.tokens.get(self.at).filter(|t| t.end <= column) {
            self.builder.token(raw(token.kind), &self.text[token.start as usize..token.end as usize]);
            self.at += 1;
        }
    }
}

fn raw(kind: SyntaxKind) -> rowan::SyntaxKind {
    Technol::kind_to_raw(kind)
}

fn section_kind(kind: SectionKind) -> SyntaxKind {
    match kind {
        SectionKind::File => SyntaxKind::File,
        SectionKind::Data => SyntaxKind::Data,
        SectionKind::DataLocal => SyntaxKind::DataLocal,
        SectionKind::Module(_) => SyntaxKind::Module,
        SectionKind::Mechanism => SyntaxKind::Mechanism,
        SectionKind::Procedure => SyntaxKind::Procedure,
        SectionKind::Macro => SyntaxKind::Macro,
    }
}

fn operand_kind(kind: &ExprKind) -> SyntaxKind {
    match kind {
        ExprKind::Dash => SyntaxKind::SkippedOperand,
        ExprKind::Dollar => SyntaxKind::DollarOperand,
        ExprKind::Name(_) => SyntaxKind::NameOperand,
        ExprKind::Number(_) => SyntaxKind::NumberOperand,
        ExprKind::Text(_) => SyntaxKind::TextOperand,
        ExprKind::Sign { .. } => SyntaxKind::SignOperand,
        ExprKind::Sum { .. } => SyntaxKind::SumOperand,
        ExprKind::Parens(_) => SyntaxKind::ParensOperand,
        ExprKind::Index { .. } => SyntaxKind::IndexOperand,
        ExprKind::Dot { .. } => SyntaxKind::DotOperand,
        ExprKind::Missing | ExprKind::Error => SyntaxKind::ErrorOperand,
    }
}
