//! Cells that an instruction declares together with their memory: MAP_IN, MAP_OUT, MAP_AIN, MAP_AOUT (manual 10),
//! DEF_IN, DEF_OUT (manual 27.6).
//!
//! A bit gets a byte of its own: the control writes it while the program runs, and so it never shares a byte with
//! bits that the program writes.

use technol_image::op::Width;

use super::collect::{MAX_LENGTH, Reader};
use super::declarations::{LengthOf, What};
use super::program::width;
use crate::catalogue::{CellType, NewCell, cell_type};
use crate::diagnostics::rules::{declarations, memory};
use crate::syntax::ast::{Expr, ExprKind, Line, Name};

/// Characters of a `TYPE_STR` and bytes of a `TYPE_BIN` without `[n]`. The manual gives no length.
const DEFAULT_LENGTH: u32 = 255;

/// Declares what the first operand of `line` names.
pub(super) fn declare(reader: &mut Reader, number: u32, line: &Line, new: NewCell) {
    let Some((name, count)) = line.operands.first().and_then(named) else { return };
    if reader.broken(number) {
        reader.declare(name.clone(), number, What::Unknown);
        return;
    }
    let what = match new {
        NewCell::Bit if count.is_none() => What::Bit { storage: reader.storage(1, None), bit: 0 },
        NewCell::Real if count.is_none() => {
            What::Typed { storage: reader.storage(8, None), element: Width::Real, array: false }
        }
        NewCell::Bit | NewCell::Real => What::Unknown,
        NewCell::Typed => return typed(reader, number, line, name, count),
    };
    reader.declare(name.clone(), number, what);
}

/// `name` or `name[n]`.
fn named(expr: &Expr) -> Option<(&Name, Option<&Expr>)> {
    match &expr.kind {
        ExprKind::Name(name) => Some((name, None)),
        ExprKind::Index { base, index } => match &base.kind {
            ExprKind::Name(name) => Some((name, Some(index))),
            _ => None,
        },
        _ => None,
    }
}

fn typed(reader: &mut Reader, number: u32, line: &Line, name: &Name, count: Option<&Expr>) {
    let found = line.operands.get(2).and_then(|operand| match &operand.kind {
        ExprKind::Name(word) => cell_type(&word.text),
        _ => None,
    });
    let (element, counts) = match (found, count) {
        (Some(CellType::Bit), None) => {
            let storage = reader.storage(1, None);
            reader.declare(name.clone(), number, What::Bit { storage, bit: 0 });
            return;
        }
        (Some(CellType::Bit), Some(count)) => {
            let message = "an array of bits has no elements that an instruction could name; declare single bits, or \
                           an array of TYPE_BYTE";
            reader.report(&memory::ARRAY_OF_BITS, number, count.columns.clone(), message.to_string());
            (None, None)
        }
        (Some(CellType::Cell(prefix)), _) => {
            let element = width(prefix);
            (Some(element), Some(LengthOf::Elements(element.bytes())))
        }
        (Some(CellType::Text), _) => (None, Some(LengthOf::Characters)),
        (Some(CellType::Block), _) => (None, Some(LengthOf::Bytes)),
        (None, _) => (None, None),
    };
    let len = counts.and_then(|counts| Some((counts, length(reader, number, count, counts)?)));
    let Some((counts, (known, later))) = len else {
        reader.declare(name.clone(), number, What::Unknown);
        return;
    };
    let storage = reader.storage(counts.bytes(known), None);
    let what = match (element, counts) {
        (Some(element), _) => What::Typed { storage, element, array: count.is_some() },
        (None, LengthOf::Characters) => What::Text { storage: Some(storage), over: None, len: known },
        (None, _) => What::Area { storage },
    };
    let index = reader.declare(name.clone(), number, what);
    if let Some(expr) = later {
        reader.found.lengths.push((storage, Some(index), expr, counts));
    }
}

/// The declared count, or the expression that gives it when other sections know its constants; `None` after a
/// mistake.
fn length(
    reader: &mut Reader,
    number: u32,
    count: Option<&Expr>,
    counts: LengthOf,
) -> Option<(u32, Option<Expr>)> {
    let Some(count) = count else {
        let single = matches!(counts, LengthOf::Elements(_));
        return Some((if single { 1 } else { DEFAULT_LENGTH }, None));
    };
    let most = match counts {
        LengthOf::Elements(size) => MAX_LENGTH / i64::from(size),
        _ => MAX_LENGTH,
    };
    let expr = reader.constant(number, count)?;
    let mut used = Vec::new();
    expr.names(&mut used);
    match expr.literal() {
        Some(len) if (1..=most).contains(&len) => Some((len as u32, None)),
        None if !used.is_empty() => Some((0, Some(count.clone()))),
        _ => {
            let message = format!("the number of elements is not within 1 and {most}");
            reader.report(&declarations::BAD_LENGTH, number, count.columns.clone(), message);
            None
        }
    }
}
