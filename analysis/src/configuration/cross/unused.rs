//! What files define and the program does not use.

use super::{Configured, ProjectUses, Report};
use crate::catalogue::ConfigElement;
use crate::configuration::constants::{Constant, ConstantValue};
use crate::configuration::document::Text;
use crate::configuration::{Configuration, Contents};
use crate::diagnostics::rules::configuration as rules;
use crate::semantics::suggest;

/// Hints at identifiers and messages that the program does not use. Nothing when some line was not understood.
pub(super) fn check(
    configuration: &Configuration,
    configured: &Configured,
    uses: &ProjectUses,
    report: &mut Report<'_>,
) {
    if !uses.complete {
        return;
    }
    match &configuration.contents {
        Contents::Channel(channel) => {
            for it in &channel.points {
                named(it.element, &it.id, configured, uses, report);
            }
            for it in &channel.parameters {
                named(ConfigElement::Parameter, &it.id, configured, uses, report);
            }
        }
        Contents::Constants(constants) => {
            for it in constants.iter().filter(|it| !is_command(it, configured, uses)) {
                named(ConfigElement::Constant, &it.id, configured, uses, report);
            }
        }
        Contents::Messages(messages) if !uses.messages_from_cells => {
            for it in messages.iter().filter(|it| !uses.messages.contains(&it.number)) {
                let message = format!("the program never reports message {}", it.number);
                report.report(&rules::UNUSED_IDENTIFIER, it.place.span, message);
            }
        }
        _ => {}
    }
}

/// A button sends it, or the procedure of commands compares with its number.
fn is_command(it: &Constant, configured: &Configured, uses: &ProjectUses) -> bool {
    let compared = matches!(it.value, ConstantValue::Number(number) if uses.codes.contains(&number));
    compared || configured.commands.contains(&it.id.text)
}

fn named(
    element: ConfigElement,
    id: &Text,
    configured: &Configured,
    uses: &ProjectUses,
    report: &mut Report<'_>,
) {
    let key = (element, id.text.clone());
    if uses.identifiers.contains(&key) || uses.dynamic.contains(&element) {
        return;
    }
    // Another instruction reads it, and is told so.
    let elsewhere = uses
        .identifiers
        .iter()
        .any(|(other, text)| *text == id.text && configured.find(*other, text).is_none());
    if elsewhere || meant(element, id, configured, uses) {
        return;
    }
    let message = format!("the program never uses '{}'", id.text);
    report.report(&rules::UNUSED_IDENTIFIER, id.span, message);
}

/// The program names something like it that nobody defines: that mistake is reported there.
fn meant(element: ConfigElement, id: &Text, configured: &Configured, uses: &ProjectUses) -> bool {
    let used = uses.identifiers.range((element, String::new())..).take_while(|(kind, _)| *kind == element);
    let unknown = used.map(|(_, text)| text.as_str()).filter(|text| configured.find(element, text).is_none());
    suggest::nearest(&id.text, unknown).is_some()
}
