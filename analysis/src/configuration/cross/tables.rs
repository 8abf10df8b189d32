//! PLCT_ instructions and values of tables against the definitions of tables.

use super::{Configured, Definition, Report};
use crate::catalogue::ConfigElement;
use crate::configuration::table::{ColumnKind, TableDefinition};
use crate::configuration::uses::{ColumnUse, IdentifierUse, SectionUses, TableUse};
use crate::configuration::{ConfigKind, Configuration, Contents};
use crate::diagnostics::rules::configuration as rules;
use crate::diagnostics::{Anchor, Finding};
use crate::semantics::suggest;
use crate::syntax::ast::Columns;

/// Looks at the tables a section uses.
pub(super) fn check(uses: &SectionUses, configured: &Configured, listed: bool, findings: &mut Vec<Finding>) {
    if !configured.complete.contains(&ConfigKind::TableDefinition) {
        return;
    }
    for it in uses.identifiers.iter().filter(|it| it.element == ConfigElement::Column) {
        findings.extend(column_name(it, configured, listed));
    }
    for it in &uses.cells {
        findings.extend(index(it, configured));
        if let Some(table) = configured.table(it.table.as_ref().map(|(index, _)| *index), listed) {
            findings.extend(column(it, table));
        }
    }
}

fn index(it: &TableUse, configured: &Configured) -> Option<Finding> {
    let (index, columns) = it.table.as_ref()?;
    let count = configured.tables.len();
    if (0..count as i64).contains(index) {
        return None;
    }
    let tables = if count == 1 { "table".to_string() } else { "tables".to_string() };
    let message = format!("there is no table {index}: the project defines {count} {tables}, counted from 0");
    Some(Finding::new(&rules::UNKNOWN_TABLE, it.line, columns.clone(), message))
}

fn column_name(it: &IdentifierUse, configured: &Configured, listed: bool) -> Option<Finding> {
    let tables: Vec<_> = match configured.table(it.table, listed) {
        Some(table) => vec![table],
        None => configured.tables.iter().collect(),
    };
    let mut names = tables.iter().flat_map(|table| &table.it.columns).map(|column| column.id.text.as_str());
    if names.clone().any(|name| name == &*it.text) {
        return None;
    }
    let near = suggest::nearest(&it.text, &mut names);
    let table = tables.first().filter(|_| tables.len() == 1);
    let of = table
        .map_or_else(|| "no table of the project".to_string(), |t| format!("the table {}", t.it.id.text));
    let none = if table.is_some() { "no" } else { "a" };
    let columns = it.place.columns.clone();
    let finding = |message| Finding::new(&rules::UNKNOWN_COLUMN, it.place.line, columns.clone(), message);
    Some(match near {
        Some(near) => finding(format!("{of} has {none} column '{}'; did you mean '{near}'?", it.text))
            .replace(format!("write '{near}'"), columns.clone(), format!("'{near}'")),
        None => finding(format!("{of} has {none} column '{}'", it.text)),
    })
}

fn column(it: &TableUse, table: &Definition<TableDefinition>) -> Option<Finding> {
    let all = &table.it.columns;
    let (column, columns): (_, &Columns) = match it.column.as_ref()? {
        ColumnUse::Number(number, columns) => {
            let Some(column) = all.iter().find(|column| column.number == *number) else {
                let message =
                    format!("the table {} has no column {number}; it has {}", table.it.id.text, all.len());
                let mut finding = Finding::new(&rules::UNKNOWN_COLUMN, it.line, columns.clone(), message);
                finding.related.push((Anchor::Place(table.place.clone()), "the table".to_string()));
                return Some(finding);
            };
            (column, columns)
        }
        ColumnUse::Named(name, columns) => (all.iter().find(|column| column.id.text == *name)?, columns),
    };
    let wanted = match it.entry.rsplit('_').next()? {
        "INT" => ColumnKind::Int,
        "REAL" => ColumnKind::Real,
        "STR" => ColumnKind::String,
        "BIN" => ColumnKind::Binary,
        _ => return None,
    };
    let kind = column.kind.filter(|kind| *kind != wanted)?;
    let (id, name) = (&column.id.text, kind.name());
    let message = format!("the column {id} has the type {name}; {} works on {}", it.entry, wanted.name());
    let mut finding = Finding::new(&rules::COLUMN_TYPE, it.line, columns.clone(), message);
    let mut place = table.place.clone();
    place.span = column.id.span;
    finding.related.push((Anchor::Place(place), "the column".to_string()));
    Some(finding)
}

/// Values of a `*.PlcT` against the definition of its table.
pub(super) fn check_values(configuration: &Configuration, configured: &Configured, report: &mut Report<'_>) {
    let Contents::Table(table) = &configuration.contents else { return };
    if !configured.complete.contains(&ConfigKind::TableDefinition) || table.id.text.is_empty() {
        return;
    }
    let Some(definition) = configured.tables.iter().find(|it| it.it.id.text == table.id.text) else {
        let near =
            suggest::nearest(&table.id.text, configured.tables.iter().map(|it| it.it.id.text.as_str()));
        let message = format!("no *.PlcTDef of the project defines the table {}", table.id.text);
        report.suggest(&rules::UNKNOWN_TABLE, table.id.span, message, near);
        return;
    };
    let columns = &definition.it.columns;
    let mut count = 0;
    for cell in &table.cells {
        // A table with one mistake a row would fill the list of problems.
        if count == 100 {
            break;
        }
        let Some(column) = columns.iter().find(|column| column.id.text == cell.column.text) else {
            count += 1;
            let near =
                suggest::nearest(&cell.column.text, columns.iter().map(|column| column.id.text.as_str()));
            let (name, table) = (&cell.column.text, &definition.it.id.text);
            let message = format!("the table {table} has no column {name}");
            report.suggest(&rules::UNKNOWN_COLUMN, cell.column.span, message, near);
            continue;
        };
        let needed = match column.kind {
            Some(ColumnKind::Int) if !is_integer(&cell.value.text) => "a whole number of 32 bits",
            Some(ColumnKind::Real) if !is_real(&cell.value.text) => "a number with a decimal point",
            _ => continue,
        };
        count += 1;
        let message =
            format!("the column {} needs {needed}, not \"{}\"", column.id.text, short(&cell.value.text));
        report.report(&rules::TABLE_VALUE, cell.value.span, message);
    }
}

fn is_integer(text: &str) -> bool {
    text.parse::<i64>().is_ok_and(|number| (-0x8000_0000..=0xFFFF_FFFF).contains(&number))
}

fn is_real(text: &str) -> bool {
    text.parse::<f64>().is_ok_and(f64::is_finite)
}

fn short(text: &str) -> String {
    text.chars().take(40).collect()
}
