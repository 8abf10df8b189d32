//! Structures of the assembler: `NAME STRUC`, members by DB, DW, DD, DQ, `NAME ENDS` (manual 18.1).
//!
//! A structure declares no memory. A member is a distance from the beginning of whatever it is used with, with a
//! type of its own.

use technol_image::op::Width;

use super::collect::{MAX_LENGTH, Reader};
use super::declarations::{Extent, What};
use crate::diagnostics::rules::{declarations, memory};
use crate::syntax::ast::{Columns, Expr, ExprKind, Line, Name};

/// A STRUC whose ENDS is still to come.
pub(super) struct Open {
    /// Its name, and where in the declared names it stands.
    name: Option<(Name, u32)>,
    line: u32,
    columns: Columns,
    length: Extent,
}

/// `NAME STRUC`.
pub(super) fn open(reader: &mut Reader, number: u32, line: &Line) {
    let columns = operation(line);
    let label = taken(reader, line);
    if reader.structure.is_some() {
        let message = "a structure cannot hold another one; end the first with NAME ENDS".to_string();
        reader.report(&memory::STRUCTURE_FORM, number, columns.clone(), message);
        finish(reader);
    }
    if label.is_none() && !reader.broken(number) {
        let message = "a structure needs a name: NAME STRUC".to_string();
        reader.report(&memory::STRUCTURE_FORM, number, columns.clone(), message);
    }
    let name = label.map(|name| {
        let index = reader.declare(name.clone(), number, What::Unknown);
        (name, index)
    });
    reader.structure = Some(Open { name, line: number, columns, length: Extent::default() });
}

/// `NAME ENDS`.
pub(super) fn close(reader: &mut Reader, number: u32, line: &Line) {
    let columns = operation(line);
    let label = taken(reader, line);
    let Some(open) = &reader.structure else {
        let message = "no structure is open here; it begins with NAME STRUC".to_string();
        reader.report(&memory::STRUCTURE_FORM, number, columns, message);
        return;
    };
    let wanted = open.name.as_ref().map(|(name, _)| name.clone());
    let wrong = match (&label, &wanted) {
        (Some(label), Some(wanted)) => (label.key() != wanted.key()).then(|| label.columns.clone()),
        (None, _) => Some(columns),
        (Some(_), None) => None,
    };
    if let (Some(columns), Some(wanted)) = (wrong, &wanted) {
        let message = format!("this ends the structure {0}: write {0} ENDS", wanted.text);
        reader.report(&memory::STRUCTURE_FORM, number, columns, message);
    }
    finish(reader);
}

/// A line between STRUC and ENDS: memory is declared elsewhere.
pub(super) fn inside(reader: &mut Reader, number: u32, operation: &Name) {
    if ["DFM", "DS", "STR"].iter().any(|word| operation.text.eq_ignore_ascii_case(word)) {
        let message = format!(
            "{} declares memory; a structure holds members by DB, DW, DD and DQ only",
            operation.text
        );
        reader.report(&memory::STRUCTURE_FORM, number, operation.columns.clone(), message);
    }
}

/// The structure is complete: its length is known.
fn finish(reader: &mut Reader) {
    let Some(open) = reader.structure.take() else { return };
    if let Some((_, index)) = open.name
        && let Some(declared) = reader.found.names.get_mut(index as usize)
    {
        declared.what = What::Structure(open.length);
    }
}

/// The lines end while a structure is open.
pub(super) fn end(reader: &mut Reader) {
    let Some(open) = &reader.structure else { return };
    let name = open.name.as_ref().map_or("NAME", |(name, _)| name.text.as_str());
    let message = format!("this structure does not end; {name} ENDS is missing");
    let (line, columns) = (open.line, open.columns.clone());
    reader.report(&memory::STRUCTURE_FORM, line, columns, message);
    finish(reader);
}

/// `MEMBER DB ?`, and bytes without a name.
pub(super) fn member(reader: &mut Reader, number: u32, line: &Line) {
    let label = taken(reader, line);
    let element = match line.operation.as_ref().map(|name| name.text.to_ascii_uppercase()).as_deref() {
        Some("DB") => Width::Byte,
        Some("DW") => Width::Word,
        Some("DD") => Width::DWord,
        _ => Width::QWord,
    };
    if reader.structure.is_none() {
        let message =
            "this stands only between NAME STRUC and NAME ENDS; memory is declared by DFM, DS or STR";
        reader.report(&memory::MEMBER_FORM, number, operation(line), message.to_string());
        if let Some(label) = label {
            reader.declare(label, number, What::Unknown);
        }
        return;
    }
    let count = if reader.broken(number) { None } else { count(reader, number, line, element) };
    let Some(open) = &mut reader.structure else { return };
    let offset = open.length.clone();
    if let Some(count) = &count {
        open.length.add(count, element.bytes());
    }
    let Some(label) = label else { return };
    let what = count.map_or(What::Unknown, |count| What::Member { offset, element, count });
    reader.declare(label, number, what);
}

/// How many elements the operands declare: `?`, `0`, `1,2,3`, `'text'`, `n DUP (?)`.
fn count(reader: &mut Reader, number: u32, line: &Line, element: Width) -> Option<Extent> {
    let mut total = Extent::default();
    let mut operands = line.operands.iter().peekable();
    if operands.peek().is_none() {
        let message = "a value or ? is missing: MEMBER DB ?".to_string();
        reader.report(&memory::MEMBER_FORM, number, operation(line), message);
        return None;
    }
    while let Some(operand) = operands.next() {
        let repeated = operands.next_if(|next| is_word(next, "DUP")).is_some();
        if repeated {
            let values = operands.next().is_some_and(|next| matches!(next.kind, ExprKind::Parens(_)));
            if !values {
                let message = "the value in brackets is missing: n DUP (?)".to_string();
                reader.report(&memory::MEMBER_FORM, number, operand.columns.clone(), message);
                return None;
            }
            repetition(reader, number, operand, &mut total)?;
            continue;
        }
        total.known = total.known.saturating_add(match &operand.kind {
            ExprKind::Missing | ExprKind::Error => return None,
            ExprKind::Text(text) if element == Width::Byte => text.chars().count() as u32,
            _ => 1,
        });
    }
    Some(total)
}

fn repetition(reader: &mut Reader, number: u32, times: &Expr, total: &mut Extent) -> Option<()> {
    let expr = reader.constant(number, times)?;
    let mut used = Vec::new();
    expr.names(&mut used);
    match expr.literal() {
        Some(times @ 1..=MAX_LENGTH) => total.known = total.known.saturating_add(times as u32),
        None if !used.is_empty() => total.open.push((1, expr)),
        _ => {
            let message = format!("the number of elements is not within 1 and {MAX_LENGTH}");
            reader.report(&declarations::BAD_LENGTH, number, times.columns.clone(), message);
            return None;
        }
    }
    Some(())
}

/// The name in front of the line's own operation. Names of lines before it name nothing.
fn taken(reader: &mut Reader, line: &Line) -> Option<Name> {
    let own = line.label.clone();
    if own.is_some() {
        reader.pending.pop();
    }
    own
}

pub(super) fn is_word(expr: &Expr, word: &str) -> bool {
    matches!(&expr.kind, ExprKind::Name(name) if name.text.eq_ignore_ascii_case(word))
}

fn operation(line: &Line) -> Columns {
    line.operation.as_ref().map_or(0..0, |name| name.columns.clone())
}
