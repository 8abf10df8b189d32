//! Logical elements of the control: the ends of the links in the configuration, and the variables that screens
//! and dialogs read by name (manual 18.2, 27.2 to 27.4).
//!
//! They are no symbols of the program. A link joins a source, for instance `CAN[1].INOUT08[2].IP0`, with a
//! destination, for instance `PLC.Input.Door`; [`find`] tells what an identifier means.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::Language;
use super::entry::Bilingual;

mod table;
#[cfg(test)]
mod tests;

/// Type of a logical element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementType {
    /// A bit.
    Bit,
    /// An integer.
    Integer {
        /// 8, 16, 32 or 64.
        bits: u32,
        /// Whether it has a sign.
        signed: bool,
    },
    /// A real of 64 bits.
    Real,
    /// A text.
    Text,
    /// A structure; its items are listed under this name.
    Structure(&'static str),
}

impl ElementType {
    /// Its name in the tables of the manual.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            ElementType::Bit => "BIT".to_owned(),
            ElementType::Integer { bits, signed: true } => format!("INT{bits}"),
            ElementType::Integer { bits, signed: false } => format!("UNS{bits}"),
            ElementType::Real => "REAL".to_owned(),
            ElementType::Text => "STR".to_owned(),
            ElementType::Structure(name) => format!("STRUC {name}").trim_end().to_owned(),
        }
    }
}

/// Which end of a link an element can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// A logical output: `Source` of a link.
    Source,
    /// A logical input: `Destination` of a link.
    Destination,
    /// The manual does not say: either.
    Either,
}

/// An element of the control.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LogicalElement {
    /// Its identifier; `[#]` stands for an index from 0.
    pub identifier: &'static str,
    /// Its type.
    pub element: ElementType,
    /// Number of values of the index; `None` when the manual does not tell it. 1 for an element without index.
    pub len: Option<u32>,
    /// Which end of a link it can be.
    pub flow: Flow,
    /// Unit; empty for none.
    pub unit: &'static str,
    /// The symbol of the program that shows the same; a lower-case `x` stands for the axis. Empty for none.
    pub symbol: &'static str,
    /// What it means.
    pub summary: Bilingual,
    /// Manual chapter.
    pub chapter: &'static str,
    /// Whether screens read it by its last part alone.
    short_name: bool,
}

impl LogicalElement {
    /// The fastest period in which the control serves a link of the element, SLOW or FAST; `None` for a variable of
    /// screens.
    #[must_use]
    pub fn fastest_period(&self) -> Option<&'static str> {
        match self.identifier.split(['.', '[']).next() {
            Some("VKeyboard") => Some("SLOW"),
            Some("CAN" | "RTM") => Some("FAST"),
            _ => None,
        }
    }
}

/// Elements whose names the program or the EtherCAT image gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpenGroup {
    /// `PLC.Input.name`: declared by DEF_IN, a destination.
    Input,
    /// `PLC.Output.name`: declared by DEF_OUT, a source.
    Output,
    /// `ECAT.name`: an element of the process image.
    EtherCat,
}

const OPEN_GROUPS: [(&str, OpenGroup); 3] =
    [("PLC.INPUT.", OpenGroup::Input), ("PLC.OUTPUT.", OpenGroup::Output), ("ECAT.", OpenGroup::EtherCat)];

/// What an identifier means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Found<'text> {
    /// An element of the control.
    Element {
        /// Which.
        element: &'static LogicalElement,
        /// The bit that `.Bit[n]` chooses.
        bit: Option<u32>,
    },
    /// An element that the program or the EtherCAT image declares.
    Open {
        /// Where.
        group: OpenGroup,
        /// Its name, with indices and `.Bit[n]` as written.
        name: &'text str,
    },
    /// The element exists, but not with this index.
    WrongIndex {
        /// Which.
        element: &'static LogicalElement,
        /// The index.
        index: u32,
    },
    /// The element exists, but has no such bit.
    WrongBit {
        /// Which.
        element: &'static LogicalElement,
        /// The bit.
        bit: u32,
    },
    /// No such element.
    Unknown,
}

/// Longer identifiers are not looked up.
const LONGEST: usize = 200;

/// One part of an identifier: `Axis[3]`.
struct Part<'text> {
    name: &'text str,
    index: Option<u32>,
}

/// The parts between the dots; `None` for text that is no identifier.
fn parts(identifier: &str) -> Option<Vec<Part<'_>>> {
    if identifier.len() > LONGEST {
        return None;
    }
    identifier
        .split('.')
        .map(|part| {
            let part = part.trim();
            let Some((name, rest)) = part.split_once('[') else {
                return (!part.is_empty()).then_some(Part { name: part, index: None });
            };
            let digits = rest.strip_suffix(']')?.trim();
            let index = digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok())??;
            (!name.is_empty()).then_some(Part { name, index: Some(index) })
        })
        .collect()
}

/// Names of the parts in upper case, joined with dots.
fn key(parts: &[Part<'_>]) -> String {
    let names: Vec<String> = parts.iter().map(|part| part.name.to_ascii_uppercase()).collect();
    names.join(".")
}

struct Tables {
    elements: Vec<LogicalElement>,
    variables: Vec<LogicalElement>,
    /// Elements by identifier without indices.
    by_identifier: HashMap<String, usize>,
    /// Variables by name, and items of structures as `<S>.item`.
    by_name: HashMap<String, usize>,
    /// Elements by their last part.
    by_short_name: HashMap<String, usize>,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let elements = table::read(include_str!("logical_elements/elements.txt"), "27.4");
    let variables = table::read(include_str!("logical_elements/shared.txt"), "18.2.3");
    let keyed = |list: &[LogicalElement]| -> HashMap<String, usize> {
        let keys = list.iter().map(|element| without_indices(element.identifier).to_ascii_uppercase());
        keys.enumerate().map(|(index, key)| (key, index)).collect()
    };
    let by_short_name = elements.iter().enumerate().filter(|(_, element)| element.short_name);
    let by_short_name = by_short_name
        .filter_map(|(index, element)| Some((short_name(element.identifier)?.to_ascii_uppercase(), index)))
        .collect();
    Tables { by_identifier: keyed(&elements), by_name: keyed(&variables), by_short_name, elements, variables }
});

/// `A[#].B[1]` as `A.B`.
fn without_indices(pattern: &str) -> String {
    pattern.split('.').map(|part| part.split('[').next().unwrap_or(part)).collect::<Vec<_>>().join(".")
}

/// The name by which screens read an element of the groups Axis, Servo, Spindle, Man and Control.
fn short_name(identifier: &'static str) -> Option<&'static str> {
    let (group, name) = identifier.strip_prefix("RTM.")?.split_once('.')?;
    let name = name.split('[').next()?;
    (!group.is_empty() && !name.contains('.')).then_some(name)
}

/// Every element of the control that can be the end of a link, in the order of the manual.
pub fn logical_elements() -> impl Iterator<Item = &'static LogicalElement> {
    TABLES.elements.iter()
}

/// Every variable that only screens and dialogs read, in the order of the manual.
pub fn screen_variables() -> impl Iterator<Item = &'static LogicalElement> {
    TABLES.variables.iter()
}

/// What the identifier of a link's end means. Case and a leading `CNC.` do not matter, an index 0 is the same as
/// none, and `.Bit[n]` chooses a bit of an integer (manual 27.3).
#[must_use]
pub fn find(identifier: &str) -> Found<'_> {
    let identifier = identifier.trim();
    let identifier = strip_prefix(identifier, "CNC.").unwrap_or(identifier);
    for (prefix, group) in OPEN_GROUPS {
        if let Some(name) = strip_prefix(identifier, prefix) {
            return Found::Open { group, name };
        }
    }
    let Some(parts) = parts(identifier) else { return Found::Unknown };
    resolve(&parts, |key| TABLES.by_identifier.get(key).map(|&index| &TABLES.elements[index]))
}

/// What the name of a variable on a screen means: a variable of the control, an item of a structured one, or an
/// element of the groups of real-time elements by its identifier or by its last part (manual 18.2.2).
#[must_use]
pub fn find_screen_variable(name: &str) -> Found<'_> {
    let name = name.trim();
    let Some(parts) = parts(name) else { return Found::Unknown };
    let found = resolve(&parts, |key| {
        let variable = |key: &str| TABLES.by_name.get(key).map(|&index| &TABLES.variables[index]);
        let item = || {
            let (base, item) = key.split_once('.')?;
            let ElementType::Structure(structure) = variable(base)?.element else { return None };
            variable(&format!("<{structure}>.{item}"))
        };
        let short = || TABLES.by_short_name.get(key).map(|&index| &TABLES.elements[index]);
        variable(key).or_else(item).or_else(short)
    });
    match found {
        Found::Unknown => find(name),
        found => found,
    }
}

fn strip_prefix<'text>(text: &'text str, prefix: &str) -> Option<&'text str> {
    let head = text.get(..prefix.len())?;
    head.eq_ignore_ascii_case(prefix).then(|| &text[prefix.len()..])
}

/// The element of the parts, else the bit of the element that the parts but the last name.
fn resolve<'text>(
    parts: &[Part<'text>],
    element: impl Fn(&str) -> Option<&'static LogicalElement>,
) -> Found<'text> {
    let exactly = |parts: &[Part<'text>]| match element(&key(parts)) {
        None => Found::Unknown,
        Some(element) => match wrong_index(element, parts) {
            Some(index) => Found::WrongIndex { element, index },
            None => Found::Element { element, bit: None },
        },
    };
    let found = exactly(parts);
    let Some((last, base)) = parts.split_last().filter(|_| found == Found::Unknown) else { return found };
    let Some(bit) = chosen_bit(last) else { return Found::Unknown };
    match exactly(base) {
        Found::Element { element, .. } => match element.element {
            ElementType::Integer { bits, .. } if bit < bits => Found::Element { element, bit: Some(bit) },
            _ => Found::WrongBit { element, bit },
        },
        other => other,
    }
}

/// `Bit[n]`, or `BITn` as screens write it.
fn chosen_bit(part: &Part<'_>) -> Option<u32> {
    let number = strip_prefix(part.name, "BIT")?;
    match part.index {
        Some(index) => number.is_empty().then_some(index),
        None if number.is_empty() => Some(0),
        None => number.parse().ok().filter(|_| number.bytes().all(|byte| byte.is_ascii_digit())),
    }
}

/// The first index that the element does not have.
fn wrong_index(element: &LogicalElement, parts: &[Part<'_>]) -> Option<u32> {
    let fits = |index| element.len.is_none_or(|len| index < len);
    if element.identifier.split('.').count() != parts.len() {
        // By its last part alone: the index of the group stands there.
        let index = parts.last().and_then(|part| part.index).unwrap_or(0);
        return (!fits(index)).then_some(index);
    }
    element.identifier.split('.').zip(parts).find_map(|(pattern, part)| {
        let index = part.index.unwrap_or(0);
        let right = match pattern.split_once('[') {
            None => index == 0,
            Some((_, "#]")) => fits(index),
            Some((_, literal)) => literal.trim_end_matches(']').parse() == Ok(index),
        };
        (!right).then_some(index)
    })
}

/// The help on an element (Markdown).
#[must_use]
pub fn element_markdown(element: &LogicalElement, language: Language) -> String {
    let say = |en: &'static str, cs: &'static str| match language {
        Language::En => en,
        Language::Cs => cs,
    };
    let flow = match element.flow {
        Flow::Source => say("\n- Source of a link", "\n- Zdroj spoje (Source)"),
        Flow::Destination => say("\n- Destination of a link", "\n- Cíl spoje (Destination)"),
        Flow::Either => "",
    };
    let mut kind = element.element.name();
    if let Some(len) = element.len.filter(|len| *len > 1) {
        kind = format!("{len} × {kind}");
    }
    if !element.unit.is_empty() {
        kind = format!("{kind}, {}", element.unit);
    }
    let period = match element.fastest_period() {
        None => String::new(),
        Some(period) => format!("\n- {} {period}", say("Fastest period:", "Nejrychlejší perioda:")),
    };
    let symbol = match element.symbol {
        "" => String::new(),
        symbol => format!("\n- {} `{symbol}`", say("Symbol of the program", "Symbol programu")),
    };
    format!(
        "### {}\n\n{}\n\n- {kind}{flow}{period}{symbol}\n- {} {}\n",
        element.identifier,
        element.summary.in_language(language),
        say("Manual chapter", "Kapitola příručky"),
        element.chapter,
    )
}
