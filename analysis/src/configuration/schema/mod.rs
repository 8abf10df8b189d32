//! What configuration files may hold, as data: elements, attributes, values.
//!
//! The manual describes the elements that a PLC program has to do with, and leaves others out. An element whose
//! attributes it lists completely is *closed*: anything else in it is reported. In the others an unknown word is
//! taken as it is.

mod channel;
mod keyboard;
mod motion;
mod names;
mod other;

use super::kind::ConfigKind;
use crate::catalogue::entry::Bilingual;

pub use names::Names;

/// An element.
#[derive(Debug)]
pub struct ElementSpec {
    /// Its name.
    pub name: &'static str,
    /// Elements it stands in; empty for a root, and where the manual does not say.
    pub parents: &'static [&'static str],
    /// Its attributes.
    pub attributes: &'static [AttributeSpec],
    /// What its text may be; `None` for an element without text.
    pub content: Option<ValueKind>,
    /// It has the attributes and elements listed here and no others.
    pub closed: bool,
    /// Chapter of the manual.
    pub chapter: &'static str,
    /// What it is for.
    pub help: Bilingual,
}

/// An attribute.
#[derive(Debug)]
pub struct AttributeSpec {
    /// Its name.
    pub name: &'static str,
    /// What its value may be.
    pub value: ValueKind,
    /// The element means nothing without it.
    pub mandatory: bool,
    /// Value when it is left out; empty when the manual names none.
    pub default: &'static str,
    /// What it means.
    pub help: Bilingual,
}

/// What a value may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ValueKind {
    /// Any text.
    Any,
    /// A text that is not empty.
    Text,
    /// An integer within these bounds.
    Integer(i64, i64),
    /// A hexadecimal number `0x…`, at most this.
    Hex(i64),
    /// A number, with or without a decimal point, within these bounds.
    Real(f64, f64),
    /// One of these integers.
    Numbers(&'static [i64]),
    /// One of these words.
    Words(&'static [&'static str]),
    /// One of many words.
    Named(Names),
    /// A number, or one of these words.
    IntegerOr(&'static [&'static str]),
}

/// The elements of a kind of file.
#[must_use]
pub const fn elements(kind: ConfigKind) -> &'static [ElementSpec] {
    match kind {
        ConfigKind::Channel => channel::ELEMENTS,
        ConfigKind::Errors => other::ERRORS,
        ConfigKind::Constants => other::CONSTANTS,
        ConfigKind::TableDefinition => other::TABLE_DEFINITION,
        ConfigKind::Table => other::TABLE,
        ConfigKind::Keyboard => keyboard::ELEMENTS,
    }
}

/// An element of a kind of file by its name and the name of the element around it.
#[must_use]
pub fn element(kind: ConfigKind, name: &str, parent: Option<&str>) -> Option<&'static ElementSpec> {
    let fits = |spec: &&ElementSpec| {
        let inside = parent.is_some_and(|parent| spec.parents.contains(&parent));
        spec.name == name && (inside || spec.parents.is_empty())
    };
    elements(kind).iter().find(fits)
}

/// The word of a constant that the control numbers itself.
pub(super) fn automatic(text: &str) -> Option<&'static str> {
    other::AUTOMATIC.iter().copied().find(|word| *word == text)
}

impl ElementSpec {
    /// The attribute of this name.
    #[must_use]
    pub fn attribute(&self, name: &str) -> Option<&'static AttributeSpec> {
        self.attributes.iter().find(|spec| spec.name == name)
    }
}

impl ValueKind {
    /// What is needed, when `value` is not that.
    #[must_use]
    pub fn objection(self, value: &str) -> Option<String> {
        let trimmed = value.trim();
        let integer = || super::document::integer(trimmed);
        let (fits, needed) = match self {
            ValueKind::Any => return None,
            ValueKind::Text => (!trimmed.is_empty(), "a text that is not empty".to_string()),
            ValueKind::Integer(min, max) => {
                (integer().is_some_and(|n| (min..=max).contains(&n)), bounds(min, max))
            }
            ValueKind::Hex(max) => {
                let fits = trimmed.len() > 2 && trimmed[..2].eq_ignore_ascii_case("0x");
                let fits = fits && integer().is_some_and(|n| (0..=max).contains(&n));
                (fits, format!("a hexadecimal number from 0x00 to 0x{max:X}"))
            }
            ValueKind::Real(min, max) => {
                let number = trimmed.parse::<f64>().ok().filter(|number| number.is_finite());
                let needed = if min <= f64::MIN && max >= f64::MAX {
                    "a number with a decimal point".to_string()
                } else {
                    format!("a number from {min} to {max}")
                };
                (number.is_some_and(|number| (min..=max).contains(&number)), needed)
            }
            ValueKind::Numbers(numbers) => {
                (integer().is_some_and(|n| numbers.contains(&n)), listed(numbers.iter().map(i64::to_string)))
            }
            ValueKind::Words(words) => {
                (words.contains(&trimmed), listed(words.iter().map(|word| (*word).to_string())))
            }
            ValueKind::Named(names) => (names.word(trimmed).is_some(), names.what().to_string()),
            ValueKind::IntegerOr(words) => (
                integer().is_some() || words.contains(&trimmed),
                format!("a number, {}", listed(words.iter().map(|word| (*word).to_string()))),
            ),
        };
        (!fits).then_some(needed)
    }

    /// Words a value may be, to find the one that was meant.
    #[must_use]
    pub fn words(self) -> Vec<&'static str> {
        match self {
            ValueKind::Words(words) | ValueKind::IntegerOr(words) => words.to_vec(),
            ValueKind::Named(names) => names.words().map(|word| word.name).collect(),
            _ => Vec::new(),
        }
    }
}

fn bounds(min: i64, max: i64) -> String {
    match (min, max) {
        (0, 1) => "0 or 1".to_string(),
        (min, i64::MAX) => format!("a whole number from {min}"),
        (i64::MIN, _) => "a whole number".to_string(),
        _ => format!("a whole number from {min} to {max}"),
    }
}

fn listed(words: impl Iterator<Item = String>) -> String {
    let words: Vec<String> = words.collect();
    match words.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => words.join(""),
    }
}

/// 0 or 1.
const FLAG: ValueKind = ValueKind::Integer(0, 1);
/// Any real number.
const REAL: ValueKind = ValueKind::Real(f64::MIN, f64::MAX);
/// Any whole number from 0.
const COUNT: ValueKind = ValueKind::Integer(0, i64::MAX);

/// An attribute that may be left out.
const fn optional(
    name: &'static str,
    value: ValueKind,
    default: &'static str,
    en: &'static str,
    cs: &'static str,
) -> AttributeSpec {
    AttributeSpec { name, value, mandatory: false, default, help: Bilingual { en, cs } }
}

/// An attribute that must be there.
const fn needed(name: &'static str, value: ValueKind, en: &'static str, cs: &'static str) -> AttributeSpec {
    AttributeSpec { name, value, mandatory: true, default: "", help: Bilingual { en, cs } }
}

/// An element without text and attributes that takes what is listed and no more.
const fn closed(
    name: &'static str,
    chapter: &'static str,
    en: &'static str,
    cs: &'static str,
) -> ElementSpec {
    ElementSpec {
        name,
        parents: &[],
        attributes: &[],
        content: None,
        closed: true,
        chapter,
        help: Bilingual { en, cs },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_that_is_left_out_is_one_that_may_be_written() {
        for kind in ConfigKind::ALL {
            for spec in elements(kind) {
                assert!(!spec.help.en.is_empty() && !spec.help.cs.is_empty(), "{}", spec.name);
                for parent in spec.parents {
                    assert!(elements(kind).iter().any(|it| it.name == *parent), "{parent} of {}", spec.name);
                }
                for attribute in spec.attributes {
                    let name = format!("{}.{}", spec.name, attribute.name);
                    assert!(!attribute.help.en.is_empty() && !attribute.help.cs.is_empty(), "{name}");
                    assert!(!attribute.mandatory || attribute.default.is_empty(), "{name}");
                    if !attribute.default.is_empty() {
                        assert_eq!(attribute.value.objection(attribute.default), None, "{name}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_book_describes_every_element_and_attribute() {
        let page = include_str!("../../../../docs/configuration.md");
        for kind in ConfigKind::ALL {
            for extension in kind.extensions() {
                assert!(page.contains(&format!("`*.{extension}`")), "*.{extension}");
            }
            for spec in elements(kind) {
                assert!(page.contains(&format!("`{}`", spec.name)), "{}", spec.name);
                for attribute in spec.attributes {
                    assert!(
                        page.contains(&format!("`{}`", attribute.name)),
                        "{}.{}",
                        spec.name,
                        attribute.name
                    );
                }
            }
        }
    }

    #[test]
    fn values_are_judged_by_their_kind() {
        let says = |kind: ValueKind, value: &str| kind.objection(value).unwrap_or_else(|| "fits".to_string());
        assert_eq!(says(FLAG, "1"), "fits");
        assert_eq!(says(FLAG, "2"), "0 or 1");
        assert_eq!(says(ValueKind::Integer(0, 128), "129"), "a whole number from 0 to 128");
        assert_eq!(says(ValueKind::Hex(0xFF), "0x6C"), "fits");
        assert_eq!(says(ValueKind::Hex(0xFF), "6C"), "a hexadecimal number from 0x00 to 0xFF");
        assert_eq!(says(ValueKind::Hex(0xFF), "0x"), "a hexadecimal number from 0x00 to 0xFF");
        assert_eq!(says(REAL, "28.82"), "fits");
        assert_eq!(says(REAL, "NaN"), "a number with a decimal point");
        assert_eq!(says(ValueKind::Words(&["A", "B", "C"]), "D"), "A, B or C");
        assert_eq!(says(ValueKind::IntegerOr(&["SA0INT", "SA0REAL"]), "12"), "fits");
    }
}
