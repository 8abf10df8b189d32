//! Connections against the logical elements that DEF_IN and DEF_OUT declare.

use super::logical::{self, Direction, Group};
use super::{ProjectUses, Report};
use crate::catalogue::ConfigElement;
use crate::configuration::channel::Connection;
use crate::configuration::document::Text;
use crate::configuration::{Configuration, Contents};
use crate::diagnostics::rules::configuration as rules;
use crate::semantics::suggest;

/// Looks at the connections of a file, and at what it forgot to connect.
pub(super) fn check(configuration: &Configuration, uses: &ProjectUses, report: &mut Report<'_>) {
    let Contents::Channel(channel) = &configuration.contents else { return };
    let points = channel.points.iter().map(|it| (it.connected, it.name));
    for (connected, name) in points.chain(channel.connections.iter().map(|it| (it.connected, it.name))) {
        if connected.is_none() {
            let message = "without Connected=\"1\" nothing is connected".to_string();
            report.report(&rules::NOT_CONNECTED, name, message);
        }
    }
    for connection in &channel.connections {
        let right = one(&connection.source, Direction::Source, uses, report);
        let right = one(&connection.destination, Direction::Destination, uses, report) && right;
        if right {
            conversion(connection, uses, report);
        }
    }
}

/// Checks one end; returns whether nothing is wrong with it.
fn one(text: &Text, wanted: Direction, uses: &ProjectUses, report: &mut Report<'_>) -> bool {
    let end = logical::end(&text.text);
    if end.group == Group::Unknown {
        let message = format!(
            "{} belongs to no group; write PLC.Input., PLC.Output., ECAT., RTM., CAN[n]. or VKeyboard. before it",
            text.text
        );
        report.report(&rules::CONNECTION_DIRECTION, text.span, message);
        return false;
    }
    if end.group.direction().is_some_and(|is| is != wanted) {
        let message = match wanted {
            Direction::Source => {
                format!("{} is a logical input; a source must be a logical output", text.text)
            }
            Direction::Destination => {
                format!("{} is a logical output; a destination must be a logical input", text.text)
            }
        };
        report.report(&rules::CONNECTION_DIRECTION, text.span, message);
        return false;
    }
    let Some(element) = end.group.element() else { return true };
    if !uses.complete || uses.dynamic.contains(&element) || declared(element, end.name, uses).is_some() {
        return true;
    }
    let instruction = if element == ConfigElement::LogicalInput { "DEF_IN" } else { "DEF_OUT" };
    let spelled = uses.spelled.get(&element);
    let near = suggest::nearest(end.name, spelled.into_iter().flatten().map(String::as_str));
    let group = &text.text[..text.text.len() - end.name.len()];
    let near = near.map(|near| format!("{group}{near}"));
    let message = format!("no {instruction} of the program declares '{}'", end.name);
    report.suggest(&rules::UNKNOWN_LOGICAL_ELEMENT, text.span, message, near.as_deref());
    false
}

/// A logical element of the program: its type, where that is written.
fn declared<'a>(element: ConfigElement, name: &str, uses: &'a ProjectUses) -> Option<&'a Option<String>> {
    let find = |name| {
        let key = (element, name);
        uses.logical.get(&key).or_else(|| uses.cells.get(&key))
    };
    logical::candidates(name).into_iter().find_map(find)
}

/// `Invert` on numbers, `Scale` and `Offset` on bits.
fn conversion(connection: &Connection, uses: &ProjectUses, report: &mut Report<'_>) {
    for text in [&connection.source, &connection.destination] {
        let end = logical::end(&text.text);
        let Some(element) = end.group.element() else { continue };
        let bit = logical::is_bit_of_number(end.name)
            || match declared(element, end.name, uses) {
                Some(Some(kind)) => kind == "TYPE_BIT",
                _ => continue,
            };
        let (span, message) = match (bit, connection.scale, connection.invert) {
            (true, Some(span), _) => {
                (span, format!("{} is a bit; Scale and Offset act on numbers only", text.text))
            }
            (false, _, Some(span)) => (span, format!("{} is a number; Invert acts on bits only", text.text)),
            _ => continue,
        };
        report.report(&rules::CONVERSION_WITHOUT_EFFECT, span, message);
        return;
    }
}
