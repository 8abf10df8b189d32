//! `*.PlcTDef` and `*.PlcT`.

use std::collections::HashMap;

use super::document::{Document, Element, Text};
use super::duplicates;
use super::problem::Problem;
use crate::diagnostics::rules::configuration as rules;

/// Structure of a table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TableDefinition {
    /// Name of the table; empty when it has none.
    pub id: Text,
    /// Columns in order of their numbers.
    pub columns: Vec<Column>,
}

/// A column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its number.
    pub number: i64,
    /// Its name.
    pub id: Text,
    /// Type of its values; `None` when that is none.
    pub kind: Option<ColumnKind>,
}

/// Type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// Real number.
    Real,
    /// 32-bit integer.
    Int,
    /// Text.
    String,
    /// Bytes.
    Binary,
}

/// Values of a table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// Name of the table; empty when it has none.
    pub id: Text,
    /// Number of rows that stand in the file.
    pub rows: usize,
    /// Its values, row by row.
    pub cells: Vec<Cell>,
    /// Rows: place of the word `Line`, and how many of `cells` come before and in it.
    pub lines: Vec<(Text, std::ops::Range<usize>)>,
}

/// A value of a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Name of its column.
    pub column: Text,
    /// The value.
    pub value: Text,
}

impl ColumnKind {
    /// As `ColType` spells it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            ColumnKind::Real => "REAL",
            ColumnKind::Int => "INT",
            ColumnKind::String => "STRING",
            ColumnKind::Binary => "BINARY",
        }
    }

    fn of(text: &str) -> Option<ColumnKind> {
        let all = [ColumnKind::Real, ColumnKind::Int, ColumnKind::String, ColumnKind::Binary];
        all.into_iter().find(|kind| kind.name() == text)
    }
}

/// Reads a definition.
pub(super) fn read_definition(document: &Document, problems: &mut Vec<Problem>) -> TableDefinition {
    let parts = Parts::of(document);
    let Some((definition, element)) = document.named("Definition").next() else {
        missing(document, "Definition", problems);
        return TableDefinition::default();
    };
    let mut columns = Vec::new();
    for (index, col) in document.named("Col").filter(|(_, it)| it.parent == Some(definition)) {
        let id = parts.get(index, "ColID").cloned();
        let kind = parts.get(index, "ColType");
        for (name, part) in [("ColID", id.as_ref()), ("ColType", kind)] {
            if part.is_none() {
                needed(col, name, problems);
            }
        }
        let Some(number) = col.attribute("No").and_then(Text::integer) else { continue };
        let place = col.attribute("No").map_or(col.name.span, |it| it.span);
        let kind = kind.and_then(|it| ColumnKind::of(&it.text));
        columns.push((
            Text { text: number.to_string(), span: place },
            Column { number, id: id.unwrap_or_default(), kind },
        ));
    }
    duplicates::find(columns.iter().map(|(no, it)| (it.number, no)), "number", problems);
    let named = columns.iter().filter(|(_, it)| !it.id.text.is_empty());
    duplicates::find(named.map(|(_, it)| (it.id.text.as_str(), &it.id)), "name", problems);
    count(parts.get(definition, "ColsCount"), columns.len(), "column", problems);
    for (name, wanted) in [("DefinitionID", true), ("ColsCount", true)] {
        if wanted && parts.get(definition, name).is_none() {
            needed(element, name, problems);
        }
    }
    columns.sort_by_key(|(_, it)| it.number);
    for (wanted, (place, column)) in columns.iter().enumerate() {
        if column.number > wanted as i64 {
            let message = format!("there is no column {wanted}; columns are numbered from 0 without gaps");
            problems.push(Problem::new(&rules::TABLE_COUNT, place.span, message));
            break;
        }
    }
    let id = parts.get(definition, "DefinitionID").cloned().unwrap_or_default();
    TableDefinition { id, columns: columns.into_iter().map(|(_, column)| column).collect() }
}

/// Reads the values.
pub(super) fn read_table(document: &Document, problems: &mut Vec<Problem>) -> Table {
    let parts = Parts::of(document);
    let mut table = Table::default();
    if let Some((definition, element)) = document.named("Definition").next() {
        for name in ["DefinitionID", "LinesCount"] {
            if parts.get(definition, name).is_none() {
                needed(element, name, problems);
            }
        }
        table.id = parts.get(definition, "DefinitionID").cloned().unwrap_or_default();
        let rows = document.named("Line").filter(|(_, it)| it.parent == Some(0)).count();
        count(parts.get(definition, "LinesCount"), rows, "row", problems);
    } else {
        missing(document, "Definition", problems);
    }
    let mut numbers = Vec::new();
    // Rows stand directly in the root and do not nest, so each element is looked at once.
    for (index, line) in document.named("Line").filter(|(_, it)| it.parent == Some(0)) {
        let from = table.cells.len();
        for (_, col) in document.children(index).filter(|(_, it)| it.name.text == "Col") {
            if let Some(column) = col.attribute("ColID") {
                table.cells.push(Cell { column: column.clone(), value: col.content.clone() });
            }
        }
        let own = &table.cells[from..];
        duplicates::find(own.iter().map(|it| (it.column.text.as_str(), &it.column)), "column", problems);
        table.lines.push((line.name.clone(), from..table.cells.len()));
        if let Some(number) = line.attribute("No") {
            numbers.push(number);
        }
    }
    table.rows = table.lines.len();
    duplicates::find(numbers.iter().filter_map(|it| Some((it.integer()?, *it))), "number", problems);
    table
}

/// Texts of elements by what they stand in.
struct Parts<'a>(HashMap<(usize, &'a str), &'a Text>);

impl<'a> Parts<'a> {
    fn of(document: &'a Document) -> Parts<'a> {
        let mut all = HashMap::new();
        for element in &document.elements {
            if let Some(parent) = element.parent {
                all.entry((parent, element.name.text.as_str())).or_insert(&element.content);
            }
        }
        Parts(all)
    }

    fn get(&self, parent: usize, name: &str) -> Option<&'a Text> {
        self.0.get(&(parent, name)).copied()
    }
}

fn count(stated: Option<&Text>, found: usize, what: &str, problems: &mut Vec<Problem>) {
    let Some(stated) = stated else { return };
    if stated.integer().is_some_and(|number| number != found as i64) {
        let plural = if found == 1 { "" } else { "s" };
        let message = format!("{} is stated, but the file has {found} {what}{plural}", stated.text);
        let number = found.to_string();
        problems.push(Problem::new(&rules::TABLE_COUNT, stated.span, message).replace(&number));
    }
}

fn needed(element: &Element, name: &str, problems: &mut Vec<Problem>) {
    let message = format!("{} needs an element {name}", element.name.text);
    problems.push(Problem::new(&rules::MISSING_ATTRIBUTE, element.name.span, message));
}

fn missing(document: &Document, name: &str, problems: &mut Vec<Problem>) {
    if let Some(root) = document.elements.first() {
        needed(root, name, problems);
    }
}
