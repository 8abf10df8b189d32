//! ESET, ESET1, EDEF against the messages of the files.

use super::{Configured, Definition, ProjectUses, Report};
use crate::configuration::messages::Message;
use crate::configuration::uses::{MessageUse, SectionUses};
use crate::configuration::{ConfigKind, Configuration, Contents};
use crate::diagnostics::rules::configuration as rules;
use crate::diagnostics::{Anchor, Finding, Rule};
use crate::syntax::ast::Columns;

/// Looks at the messages of a section.
pub(super) fn check(uses: &SectionUses, configured: &Configured, findings: &mut Vec<Finding>) {
    if !configured.complete.contains(&ConfigKind::Errors) {
        return;
    }
    // What TEX leaves in DR is a message when the section reports what is in DR.
    let from_dr = uses.messages.iter().any(|it| it.number.is_none() && !it.in_cell);
    for it in &uses.messages {
        let Some(number) = it.number else { continue };
        let reported = it.values.is_some() || from_dr;
        match configured.message(number) {
            None if reported => {
                let message = format!("no *.PlcErrors of the project has a message {number}");
                let columns = it.place.columns.clone();
                findings.push(Finding::new(&rules::UNKNOWN_MESSAGE, it.place.line, columns, message));
            }
            None => {}
            Some(known) => {
                findings.extend(values(it, known));
                findings.extend(validity(it, known));
            }
        }
    }
}

fn finding(
    it: &MessageUse,
    rule: &'static Rule,
    columns: &Columns,
    message: String,
    known: &Definition<Message>,
) -> Finding {
    let mut finding = Finding::new(rule, it.place.line, columns.clone(), message);
    finding.related.push((Anchor::Place(known.place.clone()), "the message".to_string()));
    finding
}

fn values(it: &MessageUse, known: &Definition<Message>) -> Option<Finding> {
    let given = it.values.as_ref()?;
    let shown = known.it.values;
    // Nobody reads the text of a message that goes.
    let goes = matches!(it.set, Some((0, _)));
    let missing = (0..shown).find(|index| !given.given.get(*index).copied().unwrap_or(false));
    let extra = (shown..given.given.len()).find(|index| given.given[*index]);
    let plural = if shown == 1 { "" } else { "s" };
    let message = match (missing, extra) {
        (Some(index), _) if !goes => {
            format!(
                "the text of message {} shows {shown} value{plural}; par{} is missing",
                known.it.number,
                index + 1
            )
        }
        (_, Some(index)) => {
            format!(
                "the text of message {} shows {shown} value{plural}; par{} is not shown",
                known.it.number,
                index + 1
            )
        }
        _ => return None,
    };
    Some(finding(it, &rules::MESSAGE_VALUES, &given.columns, message, known))
}

fn validity(it: &MessageUse, known: &Definition<Message>) -> Option<Finding> {
    let persistent = known.it.persistent?;
    let number = known.it.number;
    let (columns, message) = match (&it.set, &it.mode) {
        (Some((_, columns)), _) if !persistent => {
            (columns, format!("message {number} is Transient: it is neither shown nor removed by `set`"))
        }
        (_, Some((mode, columns))) => match ((mode >> 2) & 3, persistent) {
            (0, true) => (columns, format!("message {number} is Persistent, but this mode never ends it")),
            (end, false) if end != 0 => {
                (columns, format!("message {number} is Transient: a condition for its end has no effect"))
            }
            _ => return None,
        },
        _ => return None,
    };
    Some(finding(it, &rules::MESSAGE_VALIDITY, columns, message, known))
}

/// Persistent messages that nothing removes.
pub(super) fn check_persistent(configuration: &Configuration, uses: &ProjectUses, report: &mut Report<'_>) {
    let Contents::Messages(messages) = &configuration.contents else { return };
    if !uses.complete || uses.messages_from_dr {
        return;
    }
    for it in messages.iter().filter(|it| it.persistent == Some(true)) {
        if uses.shown.contains(&it.number) && !uses.removed.contains(&it.number) {
            let message = format!("the program shows message {} and never removes it", it.number);
            report.report(&rules::MESSAGE_STAYS, it.place.span, message);
        }
    }
}
