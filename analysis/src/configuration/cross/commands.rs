//! Commands of buttons, constants, and the procedure that takes them.

use super::{Configured, Defined, ProjectUses, Report};
use crate::catalogue::ConfigElement;
use crate::configuration::constants::ConstantValue;
use crate::configuration::uses::SectionUses;
use crate::configuration::{ConfigKind, Configuration, Contents};
use crate::diagnostics::Finding;
use crate::diagnostics::rules::configuration as rules;
use crate::semantics::suggest;

/// Numbers that the procedure of commands compares with.
pub(super) fn check(uses: &SectionUses, configured: &Configured, findings: &mut Vec<Finding>) {
    if !configured.complete.contains(&ConfigKind::Constants) {
        return;
    }
    for it in uses.codes.iter().filter(|it| it.sure) {
        if configured.numbers().any(|number| number == it.number) {
            continue;
        }
        let message =
            format!("no constant of the project has the value {}; no command has this number", it.number);
        let columns = it.place.columns.clone();
        findings.push(Finding::new(&rules::UNKNOWN_COMMAND_CODE, it.place.line, columns, message));
    }
}

/// Commands that nobody defines, or that the program does not take.
pub(super) fn check_buttons(
    configuration: &Configuration,
    configured: &Configured,
    uses: &ProjectUses,
    report: &mut Report<'_>,
) {
    let Contents::Keyboard(keyboard) = &configuration.contents else { return };
    if !configured.complete.contains(&ConfigKind::Constants) {
        return;
    }
    for command in &keyboard.commands {
        let Some(found) = configured.find(ConfigElement::Constant, &command.text) else {
            let near = suggest::nearest(&command.text, configured.identifiers(ConfigElement::Constant));
            let message = format!("no *.PlcConstants of the project defines {}", command.text);
            report.suggest(&rules::UNKNOWN_COMMAND, command.span, message, near);
            continue;
        };
        let fetched = uses.identifiers.contains(&(ConfigElement::Constant, command.text.clone()))
            || uses.dynamic.contains(&ConfigElement::Constant);
        let number = match &found.it {
            Defined::Constant(constant) => match constant.value {
                ConstantValue::Number(number) => Some(number),
                _ => None,
            },
            _ => None,
        };
        let compared = uses.hands_on || number.is_some_and(|number| uses.codes.contains(&number));
        if !uses.complete || (uses.takes_commands && (fetched || compared)) {
            continue;
        }
        let message = if uses.takes_commands {
            format!(
                "the program does not take {}: no CONST_GET asks for it, _ON_CMD does not compare with it",
                command.text
            )
        } else {
            format!("nobody takes {}: the program has no procedure _ON_CMD", command.text)
        };
        report.report(&rules::COMMAND_IGNORED, command.span, message);
    }
}
