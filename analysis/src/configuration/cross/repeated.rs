//! The same identifier or number in two files.

use super::{Configured, Definition, Report};
use crate::catalogue::ConfigElement;
use crate::configuration::document::Text;
use crate::configuration::{Configuration, Contents};
use crate::diagnostics::rules::configuration as rules;

/// Reports what another file defined before.
pub(super) fn check(configuration: &Configuration, configured: &Configured, report: &mut Report<'_>) {
    match &configuration.contents {
        Contents::Channel(channel) => {
            for it in &channel.points {
                named(it.element, &it.id, configured, report);
            }
            for it in &channel.parameters {
                named(ConfigElement::Parameter, &it.id, configured, report);
            }
        }
        Contents::Constants(constants) => {
            for it in constants {
                named(ConfigElement::Constant, &it.id, configured, report);
            }
        }
        Contents::Messages(messages) => {
            for it in messages {
                other(&it.place, configured.message(it.number), report);
            }
        }
        Contents::TableDefinition(table) => {
            let first = configured.tables.iter().find(|it| it.it.id.text == table.id.text);
            other(&table.id, first.filter(|_| !table.id.text.is_empty()), report);
        }
        Contents::Table(_) | Contents::Keyboard(_) => {}
    }
}

fn named(element: ConfigElement, id: &Text, configured: &Configured, report: &mut Report<'_>) {
    other(id, configured.find(element, &id.text), report);
}

fn other<T>(own: &Text, first: Option<&Definition<T>>, report: &mut Report<'_>) {
    let Some(first) = first.filter(|first| first.place.file != report.path) else { return };
    let message = format!("{} is defined in {} already", own.text, first.place.file);
    let mut diagnostic = super::diagnostic(&rules::DUPLICATE_IDENTIFIER, own.span, message);
    diagnostic.related.push((first.place.clone(), "the first one".to_string()));
    report.add(diagnostic);
}
