//! Reads the tables of logical elements.
//!
//! A line is `identifier | type | elements | flow | unit | symbol | English | Czech`; `;` begins a comment line.
//! `{a..b}` in the identifier makes one element for each number; `{}` repeats the number in texts and symbol.

use super::{ElementType, Flow, LogicalElement};
use crate::catalogue::entry::Bilingual;

/// The elements of a table. A line that is not well formed is left out; the tests look for such lines.
pub(super) fn read(text: &'static str, chapter: &'static str) -> Vec<LogicalElement> {
    let lines = text.lines().filter(|line| !line.is_empty() && !line.starts_with(';'));
    lines.filter_map(|line| row(line, chapter)).flatten().collect()
}

/// The elements of one line.
pub(super) fn row(line: &'static str, chapter: &'static str) -> Option<Vec<LogicalElement>> {
    let columns: Vec<&str> = line.split('|').map(str::trim).collect();
    let [identifier, element, len, flow, unit, symbol, en, cs] = columns[..] else { return None };
    let len = match len {
        "" => Some(1),
        "#" => None,
        number => Some(number.parse().ok()?),
    };
    let (flow, short_name) = match flow {
        "" => (Flow::Either, true),
        "-" => (Flow::Either, false),
        ">" => (Flow::Source, true),
        "<" => (Flow::Destination, true),
        _ => return None,
    };
    let element = element_type(element)?;
    let elements = numbers(identifier)?.into_iter().map(|number| LogicalElement {
        identifier: number.place(identifier),
        element,
        len,
        flow,
        unit,
        symbol: number.place(symbol),
        summary: Bilingual { en: number.sentence(en), cs: number.sentence(cs) },
        chapter,
        short_name,
    });
    Some(elements.collect())
}

fn element_type(name: &'static str) -> Option<ElementType> {
    Some(match name {
        "BIT" => ElementType::Bit,
        "REAL" => ElementType::Real,
        "STR" => ElementType::Text,
        _ => {
            if let Some(structure) = name.strip_prefix('<') {
                return structure.strip_suffix('>').map(ElementType::Structure);
            }
            let (signed, bits) = match name.strip_prefix("INT") {
                Some(bits) => (true, bits),
                None => (false, name.strip_prefix("UNS")?),
            };
            ElementType::Integer { bits: bits.parse().ok()?, signed }
        }
    })
}

/// A member of a family, or the only element of a line.
struct Member {
    number: Option<u32>,
}

impl Member {
    /// `text` with the number in the place of its braces.
    fn place(&self, text: &'static str) -> &'static str {
        let (Some(number), Some(from), Some(to)) = (self.number, text.find('{'), text.find('}')) else {
            return text;
        };
        leaked(format!("{}{number}{}", &text[..from], self.place(&text[to + 1..])))
    }

    fn sentence(&self, text: &'static str) -> &'static str {
        leaked(format!("{}.", self.place(text)))
    }
}

/// A text of the table, which is read once and lives as long as the process.
fn leaked(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

/// The numbers of the family that `{a..b}` describes.
fn numbers(identifier: &str) -> Option<Vec<Member>> {
    let Some((_, rest)) = identifier.split_once('{') else { return Some(vec![Member { number: None }]) };
    let (first, last) = rest.split_once('}')?.0.split_once("..")?;
    let (first, last): (u32, u32) = (first.parse().ok()?, last.parse().ok()?);
    Some((first..=last).map(|number| Member { number: Some(number) }).collect())
}
