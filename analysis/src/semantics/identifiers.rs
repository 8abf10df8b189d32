//! Operands that name something outside the program text: identifiers of the configuration, and the cells that
//! instructions declare for them.

use std::sync::Arc;

use technol_image::op::Width;

use super::code::{CodeReader, form};
use super::constant::ConstExpr;
use super::data;
use super::hir::{Address, Operand, SymbolKey};
use super::operands::{address_of, constant_name, describe, names_in};
use super::reference::ReferenceAccess;
use super::scope::{Symbol, SymbolKind};
use super::sum::{shape, sum};
use crate::catalogue::{self, Access, CellType, ConfigElement, Entry, NewCell, Prefix};
use crate::database::{self, SiteOf};
use crate::diagnostics::rules::{declarations, memory, names, operands as rules};
use crate::syntax::ast::{Columns, Expr, ExprKind, Line};
use crate::syntax::section::SectionKind;

/// An identifier of the configuration in the program, for the cross-check with the configuration files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IdentifierUse {
    /// What it names.
    pub element: ConfigElement,
    /// The instruction.
    pub entry: &'static Entry,
    /// The identifier.
    pub text: IdentifierText,
    /// 0-based own line.
    pub line: u32,
    /// Columns of the operand, apostrophes included.
    pub columns: Columns,
    /// Type of the cell that the same line declares or shares.
    pub declared: Option<CellType>,
    /// The line declares `name[n]`.
    pub array: bool,
}

/// Where the text of an identifier stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum IdentifierText {
    /// In apostrophes in the line itself.
    Literal(Arc<str>),
    /// In a text buffer, which the program may fill at run time.
    Buffer(SymbolKey),
}

/// The element in words.
pub(super) const fn element_words(element: ConfigElement) -> &'static str {
    match element {
        ConfigElement::Input => "an input",
        ConfigElement::Output => "an output",
        ConfigElement::AnalogInput => "an analogue input",
        ConfigElement::AnalogOutput => "an analogue output",
        ConfigElement::LogicalInput => "a logical input",
        ConfigElement::LogicalOutput => "a logical output",
        ConfigElement::Parameter => "a parameter",
        ConfigElement::Constant => "a PLC constant",
        ConfigElement::Table => "a table",
        ConfigElement::Column => "a column",
        ConfigElement::Shared => "a shared value",
    }
}

/// `'ID'` or the label of a text buffer.
pub(super) fn identifier(
    reader: &mut CodeReader<'_>,
    entry: &'static Entry,
    element: ConfigElement,
    expr: &Expr,
) -> Option<Operand> {
    let (operand, text) = if let ExprKind::Text(text) = &expr.kind {
        let text = literal(reader, element, text, expr)?;
        (Operand::Text(text.clone()), IdentifierText::Literal(text))
    } else {
        let need = "an identifier in apostrophes or the label of a text buffer is needed here";
        let operand = data::text_needed(reader, expr, Access::Read, need)?;
        let Operand::Area { address, .. } = &operand else { return Some(operand) };
        let text = IdentifierText::Buffer(address.symbol.clone());
        (operand, text)
    };
    let (line, columns) = (reader.line, expr.columns.clone());
    let used = IdentifierUse { element, entry, text, line, columns, declared: None, array: false };
    reader.out.identifiers.push(used);
    Some(operand)
}

fn literal(reader: &mut CodeReader<'_>, element: ConfigElement, text: &str, expr: &Expr) -> Option<Arc<str>> {
    let logical = matches!(element, ConfigElement::LogicalInput | ConfigElement::LogicalOutput);
    let message = if text.trim().is_empty() {
        format!("this identifier of {} is empty", element_words(element))
    } else if logical && text.trim_end().ends_with(']') {
        "an identifier does not end in an index; name[n] declares the array".to_string()
    } else {
        return Some(Arc::from(text));
    };
    reader.report(&memory::BAD_IDENTIFIER, expr.columns.clone(), message);
    None
}

/// Tells the identifiers of a line which cell they belong to.
pub(super) fn typed(reader: &mut CodeReader<'_>, entry: &Entry, line: &Line) {
    let number = reader.line;
    let mut own = reader.out.identifiers.iter_mut().rev().take_while(|used| used.line == number).peekable();
    if own.peek().is_none() {
        return;
    }
    let named = line.operands.iter().find_map(|operand| match &operand.kind {
        ExprKind::Name(name) => catalogue::cell_type(&name.text),
        _ => None,
    });
    let declared = named.or(match entry.declares() {
        Some(NewCell::Bit) => Some(CellType::Bit),
        Some(NewCell::Real) => Some(CellType::Cell(Prefix::Real)),
        Some(NewCell::Typed) | None => None,
    });
    let array = entry.declares().is_some()
        && line.operands.first().is_some_and(|first| matches!(first.kind, ExprKind::Index { .. }));
    for used in own {
        used.declared = declared;
        used.array = array;
    }
}

/// The name that MAP_IN, DEF_IN and the like declare. What it declares is checked by the declarations.
pub(super) fn declared(
    reader: &mut CodeReader<'_>,
    entry: &'static Entry,
    new: NewCell,
    expr: &Expr,
) -> Option<Operand> {
    let (name, count) = match &expr.kind {
        ExprKind::Name(name) => (name, None),
        ExprKind::Index { base, index } => match &base.kind {
            ExprKind::Name(name) => (name, Some(index)),
            _ => return no_name(reader, entry, expr),
        },
        _ => return no_name(reader, entry, expr),
    };
    if let Some(count) = count {
        if new != NewCell::Typed {
            let message = format!("{} declares a single cell; leave out [n]", entry.name);
            reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
            return None;
        }
        count_names(reader, count)?;
    }
    let symbol = reader.symbol(&name.text)?;
    if symbol.kind == SymbolKind::Unknown {
        reader.clean = false;
        return None;
    }
    Some(in_memory(symbol, 0).unwrap_or(Operand::Skipped))
}

fn no_name(reader: &mut CodeReader<'_>, entry: &Entry, expr: &Expr) -> Option<Operand> {
    let message = format!("a new name is needed here: {}", form(entry));
    reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
    None
}

/// Names in the number of elements; a number alone is checked where it is declared.
fn count_names(reader: &mut CodeReader<'_>, count: &Expr) -> Option<()> {
    let Ok(expr) = ConstExpr::read(count) else {
        reader.clean = false;
        return None;
    };
    let mut used = Vec::new();
    names_in(count, &mut used);
    if used.is_empty() {
        return Some(());
    }
    for name in used {
        if !constant_name(reader, name) {
            return None;
        }
    }
    let value =
        expr.value(&mut |name| super::program::constant(reader.db, reader.project, reader.section, name));
    if !matches!(value, Ok(1..=super::collect::MAX_LENGTH)) {
        let message = format!("the number of elements is not within 1 and {}", super::collect::MAX_LENGTH);
        reader.report(&declarations::BAD_LENGTH, count.columns.clone(), message);
        return None;
    }
    Some(())
}

/// A symbol, or one element of it, as an operand.
fn in_memory(symbol: &Symbol, offset: i64) -> Option<Operand> {
    let address = Address { offset, ..address_of(symbol) };
    match symbol.kind {
        SymbolKind::Bit { bit } => Some(Operand::Bit { address, bit, negated: false }),
        SymbolKind::Cell(width) => Some(Operand::Cell { address, width, negated: false }),
        SymbolKind::Array { .. } | SymbolKind::Area { .. } | SymbolKind::Text { .. } => {
            Some(Operand::Area { address, len: symbol.bytes()? })
        }
        _ => None,
    }
}

/// A cell that DEF_IN or DEF_OUT declared, or one element of it.
pub(super) fn element(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<Operand> {
    let need = "the name of a logical input or output is needed here: name or name[n]";
    let plain = match &expr.kind {
        ExprKind::Name(_) => true,
        ExprKind::Index { base, .. } => matches!(base.kind, ExprKind::Name(_)),
        _ => false,
    };
    if !plain {
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), need);
        return None;
    }
    let shape = shape(reader, expr)?;
    let sum = sum(reader, &shape, expr, ReferenceAccess::ReadWrite)?;
    let Some(symbol) = sum.symbol.filter(|_| !sum.indexed) else {
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), need);
        return None;
    };
    if !is_logical(reader, &symbol.key) {
        let message =
            format!("{} is {}, not declared by DEF_IN or DEF_OUT", symbol.key.name, describe(&symbol.kind));
        reader.report_symbol(&names::WRONG_SYMBOL, expr.columns.clone(), message, &symbol.key);
        return None;
    }
    match (&symbol.kind, &expr.kind) {
        (SymbolKind::Array { element, .. }, ExprKind::Index { .. }) => {
            let address = Address { offset: sum.offset, ..address_of(&symbol) };
            Some(Operand::Cell { address, width: Width::clone(element), negated: false })
        }
        _ => in_memory(&symbol, sum.offset),
    }
}

/// Whether an instruction with a type declares the symbol.
fn is_logical(reader: &CodeReader<'_>, key: &SymbolKey) -> bool {
    let sites = database::sites(reader.db, reader.project).get(key);
    sites.into_iter().flatten().any(|site| {
        let (db, project) = (reader.db, reader.project);
        if !matches!(site.section.kind(db), SectionKind::Module(_) | SectionKind::Procedure) {
            return false;
        }
        let line = if let (SiteOf::Other, Some(expansion)) =
            (site.of, database::expansion_of(db, project, site.section))
        {
            let lines = &database::expansion_declarations(db, project, site.section).other_lines;
            let line = lines.get(site.index as usize);
            line.and_then(|line| expansion.parsed.lines.get(*line as usize))
        } else {
            let lines = &database::section_lines(db, site.section).lines;
            let declared = database::declared(db, project, *site);
            declared.and_then(|declared| lines.get(declared.line as usize))
        };
        let entry = line.and_then(|line| catalogue::entry(&line.operation.as_ref()?.text));
        entry.and_then(Entry::declares) == Some(NewCell::Typed)
    })
}
