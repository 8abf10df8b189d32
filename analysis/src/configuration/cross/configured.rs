//! What all configuration files of the project define.

use std::collections::{BTreeMap, BTreeSet};

use crate::catalogue::ConfigElement;
use crate::configuration::channel::{Connection, Parameter, Point, SerialPort};
use crate::configuration::constants::{Constant, ConstantValue};
use crate::configuration::document::Text;
use crate::configuration::messages::Message;
use crate::configuration::table::TableDefinition;
use crate::configuration::{ConfigKind, Contents};
use crate::database::{self, Db, Project};
use crate::location::Location;

/// What the configuration files of the project define.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Configured {
    /// Elements with an identifier; the first is the one that counts.
    pub named: BTreeMap<(ConfigElement, String), Vec<Definition<Defined>>>,
    /// Messages by number; the first is the one that counts.
    pub messages: BTreeMap<i64, Vec<Definition<Message>>>,
    /// Tables in order of the files.
    pub tables: Vec<Definition<TableDefinition>>,
    /// Links.
    pub connections: Vec<Definition<Connection>>,
    /// Serial ports by number.
    pub ports: BTreeMap<i64, Definition<SerialPort>>,
    /// Commands of buttons.
    pub commands: BTreeSet<String>,
    /// Kinds of which there are files, all of them readable.
    pub complete: BTreeSet<ConfigKind>,
}

/// Something with the place of its identifier.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition<T> {
    /// Where.
    pub place: Location,
    /// What.
    pub it: T,
}

/// An element with an identifier.
#[derive(Clone, Debug, PartialEq)]
pub enum Defined {
    /// An input or output.
    Point(Point),
    /// A parameter.
    Parameter(Parameter),
    /// A constant.
    Constant(Constant),
}

/// Collects what the files define.
pub(crate) fn configured(db: &dyn Db, project: Project) -> Configured {
    let mut all = Configured::default();
    let mut broken = BTreeSet::new();
    for file in project.configuration(db) {
        let path = file.path(db);
        let Some(kind) = ConfigKind::of_path(path) else { continue };
        let configuration = database::configuration_file(db, *file);
        all.complete.insert(kind);
        if configuration.broken {
            broken.insert(kind);
        }
        all.add(path, &configuration.contents);
    }
    all.complete.retain(|kind| !broken.contains(kind));
    all
}

impl Configured {
    fn add(&mut self, path: &str, contents: &Contents) {
        let place = |text: &Text| Location { file: path.to_string(), span: text.span };
        match contents {
            Contents::Channel(channel) => {
                for it in &channel.points {
                    self.name(it.element, &it.id, place(&it.id), Defined::Point(it.clone()));
                }
                for it in &channel.parameters {
                    self.name(
                        ConfigElement::Parameter,
                        &it.id,
                        place(&it.id),
                        Defined::Parameter(it.clone()),
                    );
                }
                for it in &channel.connections {
                    self.connections.push(Definition { place: place(&it.source), it: it.clone() });
                }
                for it in &channel.ports {
                    let definition = Definition { place: place(&it.place), it: it.clone() };
                    self.ports.entry(it.number).or_insert(definition);
                }
            }
            Contents::Messages(messages) => {
                for it in messages {
                    let definition = Definition { place: place(&it.place), it: it.clone() };
                    self.messages.entry(it.number).or_default().push(definition);
                }
            }
            Contents::Constants(constants) => {
                for it in constants {
                    self.name(ConfigElement::Constant, &it.id, place(&it.id), Defined::Constant(it.clone()));
                }
            }
            Contents::TableDefinition(it) => {
                self.tables.push(Definition { place: place(&it.id), it: it.clone() });
            }
            Contents::Table(_) => {}
            Contents::Keyboard(it) => {
                self.commands.extend(it.commands.iter().map(|command| command.text.clone()));
            }
        }
    }

    fn name(&mut self, element: ConfigElement, id: &Text, place: Location, it: Defined) {
        self.named.entry((element, id.text.clone())).or_default().push(Definition { place, it });
    }

    /// The element that an identifier names.
    #[must_use]
    pub fn find(&self, element: ConfigElement, id: &str) -> Option<&Definition<Defined>> {
        // The key owns its text; a lookup is rare enough for one copy.
        self.named.get(&(element, id.to_string()))?.first()
    }

    /// Identifiers of one kind of element.
    pub fn identifiers(&self, element: ConfigElement) -> impl Iterator<Item = &str> {
        let from = (element, String::new());
        self.named
            .range(from..)
            .take_while(move |((kind, _), _)| *kind == element)
            .map(|((_, id), _)| id.as_str())
    }

    /// The message of a number.
    #[must_use]
    pub fn message(&self, number: i64) -> Option<&Definition<Message>> {
        self.messages.get(&number)?.first()
    }

    /// A table by its index; `None` when the order of several tables is not known.
    #[must_use]
    pub fn table(&self, index: Option<i64>, listed: bool) -> Option<&Definition<TableDefinition>> {
        if self.tables.len() != 1 && !listed {
            return None;
        }
        self.tables.get(usize::try_from(index?).ok()?)
    }

    /// Values of constants that are plain numbers.
    pub fn numbers(&self) -> impl Iterator<Item = i64> {
        self.named.values().flatten().filter_map(|definition| match &definition.it {
            Defined::Constant(Constant { value: ConstantValue::Number(number), .. }) => Some(*number),
            _ => None,
        })
    }

    /// The kind of file that defines an element.
    #[must_use]
    pub const fn kind_of(element: ConfigElement) -> Option<ConfigKind> {
        match element {
            ConfigElement::Input
            | ConfigElement::Output
            | ConfigElement::AnalogInput
            | ConfigElement::AnalogOutput
            | ConfigElement::LogicalInput
            | ConfigElement::LogicalOutput
            | ConfigElement::Parameter => Some(ConfigKind::Channel),
            ConfigElement::Constant => Some(ConfigKind::Constants),
            ConfigElement::Table | ConfigElement::Column => Some(ConfigKind::TableDefinition),
            ConfigElement::Shared => None,
        }
    }
}
