//! `*.PlcConstants`.

use super::channel::identifier;
use super::document::{Document, Text};
use super::duplicates;
use super::problem::Problem;
use super::schema::automatic;
use crate::diagnostics::rules::configuration as rules;

/// A constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Constant {
    /// Its identifier.
    pub id: Text,
    /// Its value.
    pub value: ConstantValue,
    /// Comment behind it.
    pub note: String,
}

/// Value of a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstantValue {
    /// A number.
    Number(i64),
    /// Numbered by the control: `SA0INT`, `SA0REAL`, `PLCCOMMAND`.
    Automatic(&'static str),
    /// Neither; reported already.
    Wrong,
}

/// Reads the constants.
pub(super) fn read(document: &Document, problems: &mut Vec<Problem>) -> Vec<Constant> {
    let mut constants = Vec::new();
    for (_, element) in document.named("Constant") {
        let Some(id) = identifier(element, "ID") else { continue };
        let value = element.attribute("Value");
        let value = match value {
            Some(text) => match (text.integer(), automatic(&text.text)) {
                (Some(number), _) => {
                    if !(-0x8000_0000..=0xFFFF_FFFF).contains(&number) {
                        let message = format!("{number} does not fit the 32 bits of a constant");
                        problems.push(Problem::new(&rules::WRONG_CONFIGURATION_VALUE, text.span, message));
                    }
                    ConstantValue::Number(number)
                }
                (None, Some(word)) => ConstantValue::Automatic(word),
                (None, None) => ConstantValue::Wrong,
            },
            None => ConstantValue::Wrong,
        };
        constants.push(Constant { id, value, note: element.note.clone() });
    }
    duplicates::find(constants.iter().map(|it| (it.id.text.as_str(), &it.id)), "identifier", problems);
    constants
}
