//! Code that no way leads to, and labels that no jump uses.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::Code;
use crate::diagnostics::Finding;
use crate::diagnostics::rules::lints as rules;
use crate::semantics::hir::{Operand, StatementKind};
use crate::syntax::ast::{Expr, ExprKind};

/// Statements that no way leads to: the first of each run is reported.
pub(super) fn unreachable(code: &Code<'_>, findings: &mut Vec<Finding>) {
    let statements = &code.body.statements;
    let targets: BTreeMap<&Arc<str>, usize> = statements
        .iter()
        .enumerate()
        .flat_map(|(index, statement)| statement.labels.iter().map(move |label| (label, index)))
        .collect();
    let mut reached = vec![false; statements.len()];
    let mut open = vec![0];
    // A jump whose target is not understood may lead to any label.
    let mentioned = mentioned(code);
    let jumps = statements.iter().flat_map(|statement| match &statement.kind {
        StatementKind::Instruction(code) => code.operands.as_slice(),
        _ => &[],
    });
    let understood: BTreeSet<&Arc<str>> = jumps
        .filter_map(|operand| match operand {
            Operand::Label(label) => Some(label),
            _ => None,
        })
        .collect();
    let macros = statements.iter().any(|statement| matches!(statement.kind, StatementKind::Macro { .. }));
    open.extend(
        targets
            .iter()
            .filter(|(label, _)| {
                macros || mentioned.contains(label.as_ref()) && !understood.contains(**label)
            })
            .map(|(_, index)| *index),
    );
    while let Some(index) = open.pop() {
        let Some(statement) = statements.get(index).filter(|_| !reached[index]) else { continue };
        reached[index] = true;
        if let StatementKind::Instruction(instruction) = &statement.kind {
            let labels = instruction.operands.iter().filter_map(|operand| match operand {
                Operand::Label(label) => targets.get(label).copied(),
                _ => None,
            });
            open.extend(labels);
            if matches!(instruction.entry.name, "JUM" | "JMP") {
                continue;
            }
        }
        open.push(index + 1);
    }
    let dead =
        |index: usize| !reached[index] && matches!(statements[index].kind, StatementKind::Instruction(_));
    for (index, statement) in statements.iter().enumerate() {
        if dead(index) && (index == 0 || !dead(index - 1)) {
            let message =
                "no way leads here: the line before jumps away, and no jump leads to a label from here on";
            findings.push(Finding::new(
                &rules::UNREACHABLE_CODE,
                statement.line,
                super::operation(code, statement.line),
                message,
            ));
        }
    }
}

/// Labels that no operand of the section names.
pub(super) fn unused_labels(code: &Code<'_>, findings: &mut Vec<Finding>) {
    let mentioned = mentioned(code);
    for (key, (line, columns)) in code.labels {
        if !mentioned.contains(key.as_ref()) {
            let message = format!("no jump leads to {key}; remove the label");
            findings.push(Finding::new(&rules::UNUSED_LABEL, *line, columns.clone(), message));
        }
    }
}

/// Keys of the names in the operands of the section.
fn mentioned(code: &Code<'_>) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for line in code.lines {
        line.operands.iter().for_each(|expr| collect(expr, &mut names));
    }
    names
}

/// Operands are shallow: the parser bounds them.
fn collect(expr: &Expr, names: &mut BTreeSet<String>) {
    match &expr.kind {
        ExprKind::Name(name) => {
            names.insert(name.key());
        }
        ExprKind::Sign { operand, .. } | ExprKind::Parens(operand) => collect(operand, names),
        ExprKind::Sum { left, right, .. } | ExprKind::Dot { left, right } => {
            collect(left, names);
            collect(right, names);
        }
        ExprKind::Index { base, index } => {
            collect(base, names);
            collect(index, names);
        }
        _ => {}
    }
}
