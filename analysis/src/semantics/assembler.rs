//! Operands of the 80386 instructions that have a defined meaning in TECHNOL: moves, sums, logic, shifts, comparisons
//! and conditional jumps over registers, cells and numbers (manual 3.1 and 22.3).
//!
//! The other instructions are known by name only; their operands stay unchecked.

use std::sync::Arc;

use technol_image::op::Width;

use super::code::CodeReader;
use super::hir::{Address, Operand};
use super::reference::ReferenceAccess;
use super::scope::SymbolKind;
use super::sum::{shape, sum};
use crate::catalogue::{self, AssemblerForm, Entry};
use crate::diagnostics::rules::{names, operands as rules};
use crate::syntax::ast::{Columns, Expr, ExprKind, Line};

/// Longest shift that the processor makes.
const MOST_SHIFTED: i64 = 31;

/// An operand as the processor sees it.
struct Place {
    what: What,
    /// Bytes; `None` when nothing says it.
    bytes: Option<u32>,
    columns: Columns,
    operand: Operand,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum What {
    Register,
    Memory,
    Number(i64),
}

/// Resolves the operands of an instruction of that form and checks them against each other.
pub(super) fn resolve(
    reader: &mut CodeReader<'_>,
    entry: &'static Entry,
    form: AssemblerForm,
    line: &Line,
) -> Vec<Operand> {
    let wanted = match form {
        AssemblerForm::Jump | AssemblerForm::One => 1,
        AssemblerForm::Move | AssemblerForm::Two | AssemblerForm::Shift => 2,
    };
    let given = &line.operands;
    if given.len() != wanted || given.iter().any(|expr| matches!(expr.kind, ExprKind::Missing)) {
        let columns = match (given.get(wanted), &line.operation) {
            (Some(more), _) => more.columns.clone(),
            (None, Some(operation)) => operation.columns.clone(),
            (None, None) => 0..0,
        };
        let plural = if wanted == 1 { "operand" } else { "operands" };
        let message = format!("{} takes {wanted} {plural}", entry.name);
        reader.report(&rules::OPERAND_COUNT, columns, message);
        return Vec::new();
    }
    if form == AssemblerForm::Jump {
        return jump(reader, &given[0]).into_iter().collect();
    }
    let writes = entry.name != "CMP";
    let access = match (form, writes) {
        (AssemblerForm::Move, _) => ReferenceAccess::Write,
        (_, true) => ReferenceAccess::ReadWrite,
        (_, false) => ReferenceAccess::Read,
    };
    let Some(to) = place(reader, &given[0], access) else { return Vec::new() };
    if let What::Number(_) = to.what {
        let message = format!("the first operand of {} is a register or a cell, not a number", entry.name);
        reader.report(&rules::CONSTANT_DESTINATION, to.columns, message);
        return Vec::new();
    }
    let Some(second) = given.get(1) else {
        let bytes = sized(reader, &to, None);
        return vec![to.typed(bytes)];
    };
    let Some(from) = place(reader, second, ReferenceAccess::Read) else { return vec![to.operand] };
    let bytes = if form == AssemblerForm::Shift {
        shifted(reader, &to, &from)
    } else {
        fitting(reader, entry, &to, &from)
    };
    vec![to.typed(bytes), from.typed(bytes)]
}

impl Place {
    /// The operand for an instruction of that many bytes.
    fn typed(self, bytes: Option<u32>) -> Operand {
        let width = match bytes {
            Some(1) => Width::Byte,
            Some(2) => Width::Word,
            Some(4) => Width::DWord,
            Some(8) => Width::QWord,
            _ => return self.operand,
        };
        match self.operand {
            Operand::Area { address, .. } => Operand::Cell { address, width, negated: false },
            other => other,
        }
    }
}

fn jump(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<Operand> {
    if let ExprKind::Name(name) = &expr.kind {
        return reader.label(name).map(Operand::Label);
    }
    reader.report(&rules::OPERAND_KIND, expr.columns.clone(), "a label is needed here");
    None
}

/// A register, a cell or a number.
fn place(reader: &mut CodeReader<'_>, expr: &Expr, uses: ReferenceAccess) -> Option<Place> {
    let columns = expr.columns.clone();
    if let ExprKind::Name(name) = &expr.kind
        && let Some(bytes) = catalogue::register(&name.text)
    {
        let word = catalogue::entry(&name.text).filter(|entry| entry.kind == catalogue::EntryKind::Keyword);
        let operand = match word {
            Some(word) => Operand::Keyword(word.name),
            None => Operand::Text(Arc::from(name.key())),
        };
        return Some(Place { what: What::Register, bytes: Some(bytes), columns, operand });
    }
    let shape = shape(reader, expr)?;
    let sum = sum(reader, &shape, expr, uses)?;
    if sum.constant {
        let value = super::operands::integer(reader, expr)?;
        let operand = Operand::Integer { value, width: Width::DWord };
        return Some(Place { what: What::Number(value), bytes: None, columns, operand });
    }
    let prefix = shape.prefix.as_ref().map(|prefix| super::program::width(prefix.prefix).bytes());
    let plain = !sum.dollar && sum.bit.is_none() && sum.block.is_none() && !shape.negated();
    let symbol = sum.symbol.filter(|_| plain);
    let Some(symbol) = symbol else {
        reader.report(&rules::OPERAND_KIND, columns, "a register, a cell or a number is needed here");
        return None;
    };
    let own = match sum.member.map_or_else(|| symbol.kind.clone(), SymbolKind::Cell) {
        SymbolKind::Cell(width) | SymbolKind::Array { element: width, .. } => Some(width.bytes()),
        SymbolKind::MechanismLine => Some(2),
        SymbolKind::Area { .. } | SymbolKind::Text { .. } => None,
        kind => {
            let message =
                format!("{} is {}, a cell is needed here", symbol.key.name, super::operands::describe(&kind));
            reader.report_symbol(&names::WRONG_SYMBOL, columns, message, &symbol.key);
            return None;
        }
    };
    let bytes = prefix.or(own);
    if !sum.indexed {
        reader.overrun(columns.clone(), &symbol, sum.offset, bytes.unwrap_or(1));
    }
    let len = symbol.bytes().unwrap_or(1);
    let address = Address { symbol: symbol.key, offset: sum.offset, indexed: sum.indexed };
    Some(Place { what: What::Memory, bytes, columns, operand: Operand::Area { address, len } })
}

/// How wide the operation is; reports when nothing says it.
fn sized(reader: &mut CodeReader<'_>, to: &Place, from: Option<&Place>) -> Option<u32> {
    let bytes = to.bytes.or(from.and_then(|from| from.bytes));
    if bytes.is_none() {
        let message = "nothing says how many bytes; put BYTE., WORD. or DWRD. before the cell";
        reader.report(&rules::UNTYPED_AREA, to.columns.clone(), message);
    }
    bytes
}

/// Both operands of one width; gives its bytes.
fn fitting(reader: &mut CodeReader<'_>, entry: &Entry, to: &Place, from: &Place) -> Option<u32> {
    if to.what == What::Memory && from.what == What::Memory {
        let message = format!("one operand of {} must be a register or a number", entry.name);
        reader.report(&rules::OPERAND_KIND, from.columns.clone(), message);
        return None;
    }
    if let (Some(to_bytes), Some(from_bytes)) = (to.bytes, from.bytes)
        && to_bytes != from_bytes
    {
        let message = format!("the first operand has {} bits, the second {}", to_bytes * 8, from_bytes * 8);
        reader.report(&rules::DIFFERENT_TYPES, to.columns.start..from.columns.end, message);
        return None;
    }
    let bytes = sized(reader, to, Some(from))?;
    let What::Number(value) = from.what else { return Some(bytes) };
    let bits = bytes.min(4) * 8;
    if !(-(1_i64 << (bits - 1))..1_i64 << bits).contains(&value) {
        let message = format!("{value} does not fit {bits} bits");
        reader.report(&rules::CONSTANT_TOO_LARGE, from.columns.clone(), message);
    }
    Some(bytes)
}

/// A value and how far it is shifted; gives the bytes of the value.
fn shifted(reader: &mut CodeReader<'_>, to: &Place, count: &Place) -> Option<u32> {
    let bytes = sized(reader, to, None);
    let cl = matches!(&count.operand, Operand::Text(name) if &**name == "CL");
    match count.what {
        What::Number(value) if !(0..=MOST_SHIFTED).contains(&value) => {
            let message = format!("{value} is no shift count: 0 to {MOST_SHIFTED}");
            reader.report(&rules::NUMBER_OUT_OF_RANGE, count.columns.clone(), message);
        }
        What::Number(_) => {}
        _ if cl => {}
        _ => {
            let message = "a shift count is a number or CL";
            reader.report(&rules::OPERAND_KIND, count.columns.clone(), message);
        }
    }
    bytes
}
