//! Where configuration files name what the program names too: for the editor.

use super::Contents;
use super::cross::logical;
use super::document::Text;
use crate::catalogue::ConfigElement;
use crate::location::Span;

/// Something that has a name in configuration files and in the program.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Subject {
    /// An element by its identifier; that of a logical element is in its normal form.
    Named(ConfigElement, String),
    /// A message by its number.
    Message(i64),
}

/// A place of a configuration file that names something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mention {
    /// What it may name: a connection may add an index or a bit to the name of its element.
    pub subjects: Vec<Subject>,
    /// Where.
    pub span: Span,
    /// It defines it.
    pub defines: bool,
}

/// The mentions of a file, in no particular order.
#[must_use]
pub fn mentions(contents: &Contents) -> Vec<Mention> {
    let mut all = Vec::new();
    let mut named = |element, text: &Text, defines| {
        let subjects = vec![Subject::Named(element, text.text.clone())];
        all.push(Mention { subjects, span: text.span, defines });
    };
    match contents {
        Contents::Channel(channel) => {
            for it in &channel.points {
                named(it.element, &it.id, true);
            }
            for it in &channel.parameters {
                named(ConfigElement::Parameter, &it.id, true);
            }
            for it in &channel.connections {
                for text in [&it.source, &it.destination] {
                    let end = logical::end(&text.text);
                    if let Some(element) = end.group.element() {
                        let names = logical::candidates(end.name).into_iter();
                        let subjects = names.map(|name| Subject::Named(element, name)).collect();
                        all.push(Mention { subjects, span: text.span, defines: false });
                    }
                }
            }
        }
        Contents::Messages(messages) => {
            for it in messages {
                let subjects = vec![Subject::Message(it.number)];
                all.push(Mention { subjects, span: it.place.span, defines: true });
            }
        }
        Contents::Constants(constants) => {
            for it in constants {
                named(ConfigElement::Constant, &it.id, true);
            }
        }
        Contents::TableDefinition(table) => {
            for it in &table.columns {
                named(ConfigElement::Column, &it.id, true);
            }
        }
        Contents::Table(table) => {
            for it in &table.cells {
                named(ConfigElement::Column, &it.column, false);
            }
        }
        Contents::Keyboard(keyboard) => {
            for it in &keyboard.commands {
                named(ConfigElement::Constant, it, false);
            }
        }
    }
    all
}
