//! Operands as s-expressions, from the typed line and from the tree.

#![allow(dead_code, unreachable_pub, reason = "each test file uses a part of it")]

use technol_analysis::syntax::ast::{Expr, ExprKind, Line, Number};
use technol_analysis::syntax::{SyntaxKind, SyntaxNode};

/// A line: `label: (operation operand …)`.
pub fn line(line: &Line) -> String {
    let label = line.label.as_ref().map(|l| format!("{}: ", l.text)).unwrap_or_default();
    let Some(operation) = &line.operation else { return label.trim_end().to_owned() };
    let words: Vec<_> =
        std::iter::once(operation.text.clone()).chain(line.operands.iter().map(expr)).collect();
    format!("{label}({})", words.join(" "))
}

/// An operand.
pub fn expr(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Missing => "_".into(),
        ExprKind::Dash => "dash".into(),
        ExprKind::Dollar => "$".into(),
        ExprKind::Name(name) => name.text.clone(),
        ExprKind::Number(Number::Integer(n)) => n.to_string(),
        ExprKind::Number(Number::Real(n)) => format!("{n:?}"),
        ExprKind::Text(text) => format!("{text:?}"),
        ExprKind::Sign { negative: true, operand } => format!("(neg {})", expr(operand)),
        ExprKind::Sign { negative: false, operand } => format!("(pos {})", expr(operand)),
        ExprKind::Sum { minus, left, right } => {
            format!("({} {} {})", if *minus { '-' } else { '+' }, expr(left), expr(right))
        }
        ExprKind::Parens(inner) => format!("(paren {})", expr(inner)),
        ExprKind::Index { base, index } => format!("(index {} {})", expr(base), expr(index)),
        ExprKind::Dot { left, right } => format!("(dot {} {})", expr(left), expr(right)),
        ExprKind::Error => "error".into(),
    }
}

/// Kinds and columns of an operand, deepest last: what the tree must show too.
pub fn shape_of_expr(e: &Expr, out: &mut Vec<(SyntaxKind, u32, u32)>) {
    let kind = match &e.kind {
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
    };
    if !e.columns.is_empty() {
        out.push((kind, e.columns.start, e.columns.end));
    }
    match &e.kind {
        ExprKind::Sign { operand: inner, .. } | ExprKind::Parens(inner) => shape_of_expr(inner, out),
        ExprKind::Sum { left, right, .. } | ExprKind::Dot { left, right } => {
            shape_of_expr(left, out);
            shape_of_expr(right, out);
        }
        ExprKind::Index { base, index } => {
            shape_of_expr(base, out);
            shape_of_expr(index, out);
        }
        _ => {}
    }
}

/// Kinds and columns of all operand nodes of a LINE node.
pub fn shape_of_line(node: &SyntaxNode) -> Vec<(SyntaxKind, u32, u32)> {
    let start = u32::from(node.text_range().start());
    node.descendants()
        .skip(1)
        .filter(|n| !matches!(n.kind(), SyntaxKind::Label | SyntaxKind::Operation))
        .map(|n| {
            (n.kind(), u32::from(n.text_range().start()) - start, u32::from(n.text_range().end()) - start)
        })
        .collect()
}
