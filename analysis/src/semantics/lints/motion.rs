//! Blocks that only move must pass the block modules in one go (manual 5.3).

use technol_image::program::ModuleKind;

use super::Code;
use crate::diagnostics::Finding;
use crate::diagnostics::rules::lints as rules;
use crate::semantics::hir::StatementKind;
use crate::syntax::section::SectionKind;

/// An EX-type instruction that no conditional jump can pass by. BEX does not wait.
pub(super) fn waits(code: &Code<'_>, findings: &mut Vec<Finding>) {
    let SectionKind::Module(kind @ (ModuleKind::BlockInit | ModuleKind::BlockDone)) = code.kind else {
        return;
    };
    for statement in &code.body.statements {
        let StatementKind::Instruction(instruction) = &statement.kind else { continue };
        let name = instruction.entry.name;
        if instruction.entry.ex_type && name != "BEX" {
            let message = format!(
                "every block waits here, one that only moves too; put {name} behind a conditional jump, so that such a \
                 block passes {} in one go",
                kind.keyword()
            );
            let columns = super::operation(code, statement.line);
            findings.push(Finding::new(&rules::MOTION_BLOCK_WAIT, statement.line, columns, message));
            return;
        }
        // From the first jump on there are several ways, and whoever wrote it thought of them.
        if matches!(name, "JL0" | "JL1" | "JUM") {
            return;
        }
    }
}
