//! `*.PlcErrors`.

use super::channel::identifier;
use super::document::{Document, Text};
use super::duplicates;
use super::problem::Problem;
use crate::diagnostics::rules::configuration as rules;

/// Most values a text shows.
pub const MOST_VALUES: usize = 3;

/// A message of the PLC program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// Its number.
    pub number: i64,
    /// `No`.
    pub place: Text,
    /// `Type`: `Err`, `Info` ….
    pub kind: String,
    /// It stays until the program removes it; `None` when `Validity` is wrong.
    pub persistent: Option<bool>,
    /// Its text.
    pub text: Text,
    /// Number of values the text shows.
    pub values: usize,
    /// Comment behind it.
    pub note: String,
}

/// Reads the messages.
pub(super) fn read(document: &Document, problems: &mut Vec<Problem>) -> Vec<Message> {
    // Text by the number of the PlcError it stands in: one pass, however the elements nest.
    let mut texts = std::collections::HashMap::new();
    for (_, element) in document.named("Text") {
        if let Some(parent) = element.parent {
            texts.entry(parent).or_insert(&element.content);
        }
    }
    let mut messages = Vec::new();
    for (index, element) in document.named("PlcError") {
        let text = texts.get(&index).copied();
        if text.is_none() {
            let message = "PlcError needs an element Text: what the operator reads".to_string();
            problems.push(Problem::new(&rules::MISSING_ATTRIBUTE, element.name.span, message));
        }
        let text = text.cloned().unwrap_or_default();
        let values = placeholders(&text, problems);
        let Some(place) = identifier(element, "No") else { continue };
        let Some(number) = place.integer() else { continue };
        messages.push(Message {
            number,
            place,
            kind: element.attribute("Type").map(|it| it.text.clone()).unwrap_or_default(),
            persistent: element.attribute("Validity").and_then(|it| match it.text.as_str() {
                "Transient" => Some(false),
                "Persistent" => Some(true),
                _ => None,
            }),
            text,
            values,
            note: element.note.clone(),
        });
    }
    duplicates::find(messages.iter().map(|it| (it.number, &it.place)), "number", problems);
    messages
}

/// Number of values in a text; reports words with `%` that show none, and values that never come.
fn placeholders(text: &Text, problems: &mut Vec<Problem>) -> usize {
    let mut count = 0;
    let mut rest = text.text.as_str();
    while let Some(at) = rest.find('%') {
        let mut following = rest[at + 1..].chars();
        match following.next() {
            Some('d' | 'X') => count += 1,
            Some(letter) if letter.is_ascii_alphabetic() => {
                let message = format!("%{letter} shows no value; only %d (decimal) and %X (hexadecimal) do");
                problems.push(Problem::new(&rules::MESSAGE_TEXT, text.span, message));
            }
            _ => {}
        }
        rest = following.as_str();
    }
    if count > MOST_VALUES {
        let message = format!("the text shows {count} values; a message carries at most {MOST_VALUES}");
        problems.push(Problem::new(&rules::MESSAGE_TEXT, text.span, message));
    }
    count.min(MOST_VALUES)
}
