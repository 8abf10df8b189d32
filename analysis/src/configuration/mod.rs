//! Configuration files: what the control knows about the machine and the PLC program refers to.
//!
//! Pure like the rest of this crate: texts come in, plain data with places goes out. [`read`] looks at one file
//! alone; [`cross`] holds the files and the program against each other.
//!
//! ```text
//! text ──xml──► Document ──validate, one reader a kind──► Configuration ──┐
//! section_analysis ──uses──► SectionUses ─────────────────────────────────┴──cross──► diagnostics on both sides
//! ```

pub mod channel;
pub mod constants;
pub mod cross;
mod decode;
pub mod document;
mod duplicates;
pub mod keyboard;
mod kind;
pub mod mentions;
pub mod messages;
pub mod places;
pub mod problem;
pub mod schema;
pub mod table;
pub mod uses;
mod validate;
mod xml;

pub use decode::decode;
pub use kind::ConfigKind;
pub use xml::{MOST_BYTES, MOST_NODES, parse};

use channel::Channel;
use constants::Constant;
use keyboard::Keyboard;
use messages::Message;
use problem::Problem;
use table::{Table, TableDefinition};

/// A configuration file as read.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// What it defines; nothing when the file is broken.
    pub contents: Contents,
    /// What is wrong in it by itself, in order of the text.
    pub problems: Vec<Problem>,
    /// It is no well-formed XML: nobody knows what it defines.
    pub broken: bool,
}

/// What a file defines.
#[derive(Clone, Debug, PartialEq)]
pub enum Contents {
    /// `*.ChannelConfig`.
    Channel(Channel),
    /// `*.PlcErrors`.
    Messages(Vec<Message>),
    /// `*.PlcConstants`.
    Constants(Vec<Constant>),
    /// `*.PlcTDef`.
    TableDefinition(TableDefinition),
    /// `*.PlcT`.
    Table(Table),
    /// `*.KbdConfig`.
    Keyboard(Keyboard),
}

/// Most mistakes that are reported in one file.
const MOST_PROBLEMS: usize = 1_000;

/// Reads a file.
#[must_use]
pub fn read(kind: ConfigKind, text: &str) -> Configuration {
    let document = match parse(text) {
        Ok(document) => document,
        Err(problem) => {
            return Configuration { contents: empty(kind), problems: vec![*problem], broken: true };
        }
    };
    let mut problems = Vec::new();
    validate::validate(kind, &document, &mut problems);
    let contents = match kind {
        ConfigKind::Channel => Contents::Channel(channel::read(&document, &mut problems)),
        ConfigKind::Errors => Contents::Messages(messages::read(&document, &mut problems)),
        ConfigKind::Constants => Contents::Constants(constants::read(&document, &mut problems)),
        ConfigKind::TableDefinition => {
            Contents::TableDefinition(table::read_definition(&document, &mut problems))
        }
        ConfigKind::Table => Contents::Table(table::read_table(&document, &mut problems)),
        ConfigKind::Keyboard => Contents::Keyboard(keyboard::read(&document, &mut problems)),
    };
    problems.sort_by_key(|it| (it.span, it.rule.code));
    problems.truncate(MOST_PROBLEMS);
    Configuration { contents, problems, broken: false }
}

/// A text of a file as the control has it in memory: single bytes, shown in Windows-1250.
#[must_use]
pub fn control_bytes(text: &str) -> Vec<u8> {
    crate::semantics::collect::text_bytes(text)
}

/// The text that bytes of the control stand for.
#[must_use]
pub fn control_text(bytes: &[u8]) -> String {
    encoding_rs::WINDOWS_1250.decode_without_bom_handling(bytes).0.into_owned()
}

fn empty(kind: ConfigKind) -> Contents {
    match kind {
        ConfigKind::Channel => Contents::Channel(Channel::default()),
        ConfigKind::Errors => Contents::Messages(Vec::new()),
        ConfigKind::Constants => Contents::Constants(Vec::new()),
        ConfigKind::TableDefinition => Contents::TableDefinition(TableDefinition::default()),
        ConfigKind::Table => Contents::Table(Table::default()),
        ConfigKind::Keyboard => Contents::Keyboard(Keyboard::default()),
    }
}
