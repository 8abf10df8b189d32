//! TEX0 and TEX1 whose time-out goes on where success does.

use super::Code;
use crate::diagnostics::Finding;
use crate::diagnostics::rules::lints as rules;
use crate::semantics::hir::{Operand, StatementKind};

/// The error label of a TEX stands at the next statement.
pub(super) fn without_path(code: &Code<'_>, findings: &mut Vec<Finding>) {
    let statements = &code.body.statements;
    for (index, statement) in statements.iter().enumerate() {
        let StatementKind::Instruction(instruction) = &statement.kind else { continue };
        if !matches!(instruction.entry.name, "TEX0" | "TEX1") {
            continue;
        }
        let Some((place, label)) = instruction.operands.iter().enumerate().find_map(|(place, operand)| {
            if let Operand::Label(label) = operand { Some((place, label)) } else { None }
        }) else {
            continue;
        };
        if statements.get(index + 1).is_some_and(|next| next.labels.contains(label)) {
            let columns = code
                .lines
                .get(statement.line as usize)
                .and_then(|line| line.operands.get(place))
                .map_or(0..0, |operand| operand.columns.clone());
            let message = format!(
                "{label} stands at the next instruction: a time-out goes on as if the condition had come; lead it elsewhere"
            );
            findings.push(Finding::new(&rules::TIMEOUT_WITHOUT_PATH, statement.line, columns, message));
        }
    }
}
