//! `*.KbdConfig`.

use super::channel::identifier;
use super::document::{Document, Text};
use super::duplicates;
use super::problem::Problem;

/// Commands of buttons for the PLC program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Keyboard {
    /// Values of `PlcCommand`.
    pub commands: Vec<Text>,
}

/// Reads the buttons.
pub(super) fn read(document: &Document, problems: &mut Vec<Problem>) -> Keyboard {
    let buttons = || document.named("KeyConfig");
    let codes = buttons().filter_map(|(_, it)| it.attribute("ScanCode"));
    duplicates::find(codes.filter_map(|code| Some((code.integer()?, code))), "scan code", problems);
    let functions = document.named("Function").filter_map(|(_, it)| {
        let place = it.attribute("No")?;
        Some(((it.parent, place.integer()?), place))
    });
    duplicates::find(functions, "function number", problems);
    let elements =
        document.elements.iter().filter(|it| matches!(it.name.text.as_str(), "KeyConfig" | "Function"));
    Keyboard { commands: elements.filter_map(|it| identifier(it, "PlcCommand")).collect() }
}
