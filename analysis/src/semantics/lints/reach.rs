//! Code that no way leads to, and labels that no jump uses.

use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use super::Code;
use crate::diagnostics::Finding;
use crate::diagnostics::rules::lints as rules;
use crate::semantics::hir::{Instruction, Operand, Statement, StatementKind};

/// Statements that no way leads to, the first of each run, and labels that nothing names.
pub(super) fn check(code: &Code<'_>, findings: &mut Vec<Finding>) {
    let statements = &code.body.statements;
    let mut jumped = FxHashSet::default();
    let mut named = FxHashSet::default();
    for operand in statements.iter().filter_map(instruction).flat_map(|code| &code.operands) {
        match operand {
            Operand::Label(label) => _ = jumped.insert(&**label),
            // An operand whose meaning is not modelled, such as the target of a jump of the 80386.
            Operand::Text(text) => _ = named.insert(&**text),
            _ => {}
        }
    }
    for (key, (line, columns)) in code.labels {
        // A label that a macro makes its own belongs to the definition, not to this call.
        let own = !key.contains("@@");
        if own && !jumped.contains(&**key) && !named.contains(&**key) {
            let message = format!("no jump leads to {key}; remove the label");
            findings.push(Finding::new(&rules::UNUSED_LABEL, *line, columns.clone(), message));
        }
    }
    unreachable(code, &named, findings);
}

fn instruction(statement: &Statement) -> Option<&Instruction> {
    match &statement.kind {
        StatementKind::Instruction(instruction) => Some(instruction),
        _ => None,
    }
}

fn always_leaves(instruction: &Instruction) -> bool {
    matches!(instruction.entry.name, "JUM" | "JMP")
}

fn unreachable(code: &Code<'_>, named: &FxHashSet<&str>, findings: &mut Vec<Finding>) {
    let statements = &code.body.statements;
    if !statements.iter().filter_map(instruction).any(always_leaves) {
        return;
    }
    let targets: FxHashMap<&Arc<str>, usize> = statements
        .iter()
        .enumerate()
        .flat_map(|(index, statement)| statement.labels.iter().map(move |label| (label, index)))
        .collect();
    let mut open: Vec<usize> =
        targets.iter().filter(|(label, _)| named.contains(&****label)).map(|(_, index)| *index).collect();
    open.push(0);
    let mut reached = vec![false; statements.len()];
    while let Some(index) = open.pop() {
        let Some(statement) = statements.get(index).filter(|_| !reached[index]) else { continue };
        reached[index] = true;
        if let Some(instruction) = instruction(statement) {
            open.extend(instruction.operands.iter().filter_map(|operand| match operand {
                Operand::Label(label) => targets.get(label).copied(),
                _ => None,
            }));
            if always_leaves(instruction) {
                continue;
            }
        }
        open.push(index + 1);
    }
    let dead = |index: usize| !reached[index] && instruction(&statements[index]).is_some();
    for (index, statement) in statements.iter().enumerate() {
        if dead(index) && (index == 0 || !dead(index - 1)) {
            let message =
                "no way leads here: the line before jumps away, and no jump leads to a label from here on";
            let columns = super::operation(code, statement.line);
            findings.push(Finding::new(&rules::UNREACHABLE_CODE, statement.line, columns, message));
        }
    }
}
