//! Reading tables of TOML with the place of everything, so that each error says where.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::scenario::{Place, ScenarioError};

/// A value with its place.
pub(super) type Node<'t> = Spanned<DeValue<'t>>;

/// The file that is read, and what is wrong in it.
pub(super) struct Source<'a> {
    /// As the user of the shell would write it.
    pub(super) file: &'a str,
    pub(super) text: &'a str,
    pub(super) errors: Vec<ScenarioError>,
}

/// A key, its place and its value.
pub(super) struct Entry<'d, 't> {
    pub(super) key: &'d str,
    /// First byte of the key.
    pub(super) at: usize,
    pub(super) node: &'d Node<'t>,
}

/// Entries of a table in the order they are written.
pub(super) fn entries<'d, 't>(table: &'d DeTable<'t>) -> Vec<Entry<'d, 't>> {
    let mut entries: Vec<Entry<'d, 't>> =
        table.iter().map(|(key, node)| Entry { key: key.get_ref(), at: key.span().start, node }).collect();
    entries.sort_by_key(|entry| entry.at);
    entries
}

/// The value of a key.
pub(super) fn get<'d, 't>(table: &'d DeTable<'t>, key: &str) -> Option<&'d Node<'t>> {
    table.iter().find(|(name, _)| name.get_ref() == key).map(|(_, node)| node)
}

/// Names and values of a table of names. TOML takes `P1IN.3 = 1` for a table in a table: it is one name here.
pub(super) fn names<'d, 't>(table: &'d DeTable<'t>) -> Vec<(String, Entry<'d, 't>)> {
    let mut found = Vec::new();
    for entry in entries(table) {
        match entry.node.get_ref() {
            DeValue::Table(inner) => {
                for (name, deeper) in names(inner) {
                    let entry = Entry { key: entry.key, at: entry.at, node: deeper.node };
                    found.push((format!("{}.{name}", entry.key), entry));
                }
            }
            _ => found.push((entry.key.to_owned(), entry)),
        }
    }
    found
}

impl Source<'_> {
    /// Notes an error at a byte of the text.
    pub(super) fn error(&mut self, at: usize, message: impl Into<String>) {
        let place = self.place(at);
        self.errors.push(ScenarioError { file: self.file.to_owned(), place, message: message.into() });
    }

    /// Line and column of a byte of the text.
    pub(super) fn place(&self, at: usize) -> Place {
        let before = self.text.get(..at).unwrap_or(self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().map_or(0, |last| last.chars().count()) + 1;
        Place { line: line as u32, column: column as u32 }
    }

    /// Complains about keys that mean nothing here.
    pub(super) fn known(&mut self, table: &DeTable<'_>, of: &str, keys: &[&str]) {
        for entry in entries(table) {
            if !keys.contains(&entry.key) {
                self.error(
                    entry.at,
                    format!("`{}` is no key of {of}; there is: {}", entry.key, keys.join(", ")),
                );
            }
        }
    }

    pub(super) fn table<'d, 't>(&mut self, node: &'d Node<'t>, what: &str) -> Option<&'d DeTable<'t>> {
        match node.get_ref() {
            DeValue::Table(table) => Some(table),
            _ => self.wrong(node, &format!("{what} is a table, {{ name = value }}")),
        }
    }

    /// The tables of an array of tables; one table stands for itself.
    pub(super) fn tables<'d, 't>(&mut self, node: &'d Node<'t>, what: &str) -> Vec<(usize, &'d DeTable<'t>)> {
        let nodes = match node.get_ref() {
            DeValue::Array(nodes) => nodes.iter().collect(),
            _ => vec![node],
        };
        let mut tables = Vec::new();
        for node in nodes {
            tables.extend(self.table(node, what).map(|table| (node.span().start, table)));
        }
        tables
    }

    pub(super) fn text<'d>(&mut self, node: &'d Node<'_>, what: &str) -> Option<&'d str> {
        match node.get_ref() {
            DeValue::String(text) => Some(text),
            _ => self.wrong(node, &format!("{what} is a text between quotation marks")),
        }
    }

    /// Texts with their places: one, or an array of them.
    pub(super) fn texts<'d>(&mut self, node: &'d Node<'_>, what: &str) -> Vec<(Range<usize>, &'d str)> {
        let nodes = match node.get_ref() {
            DeValue::Array(nodes) => nodes.iter().collect(),
            _ => vec![node],
        };
        let mut texts = Vec::new();
        for node in nodes {
            texts.extend(self.text(node, what).map(|text| (node.span(), text)));
        }
        texts
    }

    pub(super) fn boolean(&mut self, node: &Node<'_>, what: &str) -> Option<bool> {
        match node.get_ref() {
            DeValue::Boolean(value) => Some(*value),
            _ => self.wrong(node, &format!("{what} is true or false")),
        }
    }

    /// A whole number from 0 to `most`.
    pub(super) fn number(&mut self, node: &Node<'_>, what: &str, most: u64) -> Option<u64> {
        let number = integer(node).and_then(|value| u64::try_from(value).ok()).filter(|value| *value <= most);
        match number {
            Some(number) => Some(number),
            None => self.wrong(node, &format!("{what} is a whole number from 0 to {most}")),
        }
    }

    /// Whole numbers: one, or an array of them.
    pub(super) fn numbers(&mut self, node: &Node<'_>, what: &str, most: u64) -> Vec<u64> {
        match node.get_ref() {
            DeValue::Array(nodes) => nodes.iter().filter_map(|node| self.number(node, what, most)).collect(),
            _ => self.number(node, what, most).into_iter().collect(),
        }
    }

    /// A value of the language as the debugger would be told it.
    pub(super) fn value(&mut self, node: &Node<'_>) -> Option<String> {
        match node.get_ref() {
            DeValue::String(text) => Some(text.to_string()),
            DeValue::Boolean(value) => Some(value.to_string()),
            DeValue::Integer(_) => match integer(node) {
                Some(value) => Some(value.to_string()),
                None => self.wrong(node, "the number is too large"),
            },
            DeValue::Float(float) => match float.as_str().parse::<f64>() {
                Ok(value) if value.is_finite() => Some(format!("{value:?}")),
                _ => self.wrong(node, "a real is a number with a decimal point"),
            },
            DeValue::Datetime(_) | DeValue::Array(_) | DeValue::Table(_) => {
                self.wrong(node, "a value is a number, true, false or a text")
            }
        }
    }

    fn wrong<T>(&mut self, node: &Node<'_>, message: &str) -> Option<T> {
        self.error(node.span().start, message);
        None
    }
}

/// A whole number of any of TOML's forms.
pub(super) fn integer(node: &Node<'_>) -> Option<i128> {
    match node.get_ref() {
        DeValue::Integer(value) => i128::from_str_radix(value.as_str(), value.radix()).ok(),
        _ => None,
    }
}
