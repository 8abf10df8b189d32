//! Cells, constants, times and areas: from the shape of an operand to its meaning (manual 3.9).

use technol_image::op::Width;

use super::address::{PrefixUse, Shape, Term, TermKind};
use super::block;
use super::code::CodeReader;
use super::hir::{Address, Operand};
use super::operands::{access, describe, integer};
use super::program::width;
use super::reference::ReferenceAccess;
use super::scope::{Symbol, SymbolKind};
use super::sum::{shape, sum};
use crate::catalogue::{Access, Entry, Prefix, PrefixSet};
use crate::diagnostics::rules::{names, operands as rules};
use crate::syntax::ast::{Columns, Expr, ExprKind};

/// What a data operand takes.
pub(super) struct ValueRules {
    pub(super) access: Access,
    pub(super) prefixes: PrefixSet,
    pub(super) declared: PrefixSet,
    pub(super) negatable: bool,
}

impl ValueRules {
    fn constants(&self) -> bool {
        self.access == Access::Read
            && (self.prefixes.contains(Prefix::Cnst) || self.declared.contains(Prefix::Cnst))
    }
}

/// A cell or constant with its width.
pub(super) fn value(
    reader: &mut CodeReader<'_>,
    entry: &'static Entry,
    expr: &Expr,
    wanted: &ValueRules,
) -> Option<Operand> {
    let shape = shape(reader, expr)?;
    if shape.block.is_some() {
        block::readable(reader, entry, wanted.access, expr)?;
    }
    if let [Term { kind: TermKind::Real(value), minus, .. }] = shape.terms.as_slice() {
        let value = if shape.negated() == *minus { *value } else { -value };
        return real(reader, entry, expr, &shape, wanted, value);
    }
    let sum = sum(reader, &shape, expr, access(wanted.access))?;
    if sum.bit.is_some() {
        let columns =
            shape.behind.last().map_or_else(|| expr.columns.clone(), |behind| behind.columns.clone());
        let message = format!("{} works on cells, not on bits", entry.name);
        reader.report(&rules::OPERAND_KIND, columns, message);
        return None;
    }
    if sum.constant {
        return integer_value(reader, entry, expr, &shape, wanted);
    }
    let Some(symbol) = sum.symbol.clone().filter(|_| !sum.dollar) else {
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), "$ stands only before a bit: $+n.bit");
        return None;
    };
    if let Some((true, columns)) = shape.sign.clone().filter(|_| !wanted.negatable) {
        let message = format!("{} does not negate its operand", entry.name);
        reader.report(&rules::SIGN_NOT_ALLOWED, columns, message);
        return None;
    }
    let width = match &shape.prefix {
        Some(prefix) => prefixed(reader, entry, wanted, prefix, &symbol, expr)?,
        None => declared(reader, entry, wanted, &symbol, sum.member, expr)?,
    };
    let high = shape.prefix.as_ref().is_some_and(|prefix| prefix.prefix == Prefix::High);
    if !sum.indexed {
        // HIGH. is the second byte of a WORD: a BYTE cell has none.
        reader.overrun(expr.columns.clone(), &symbol, sum.offset, if high { 2 } else { width.bytes() });
    }
    let offset = sum.offset.saturating_add(i64::from(high));
    let address = Address { symbol: symbol.key, offset, indexed: sum.indexed };
    Some(sum.in_block(Operand::Cell { address, width, negated: shape.negated() }))
}

fn prefixed(
    reader: &mut CodeReader<'_>,
    entry: &Entry,
    wanted: &ValueRules,
    prefix: &PrefixUse,
    symbol: &Symbol,
    expr: &Expr,
) -> Option<Width> {
    if prefix.prefix == Prefix::Cnst {
        let message = format!("CNST. needs a constant, {} is {}", symbol.key.name, describe(&symbol.kind));
        reader.report_symbol(&names::WRONG_SYMBOL, expr.columns.clone(), message, &symbol.key);
        return None;
    }
    if !wanted.prefixes.contains(prefix.prefix) {
        if prefix.prefix == Prefix::Real {
            let message = format!("{} computes with integers only; REAL. cannot stand here", entry.name);
            reader.report(&rules::REAL_NOT_ALLOWED, prefix.columns.clone(), message);
        } else {
            let message =
                format!("{} does not take {}.{}", entry.name, prefix.prefix.name(), allowed(wanted.prefixes));
            reader.report(&rules::PREFIX_NOT_ALLOWED, prefix.columns.clone(), message);
        }
        return None;
    }
    if matches!(symbol.kind, SymbolKind::Bit { .. } | SymbolKind::Mechanism) {
        let message = format!("{} is {}, a cell is needed here", symbol.key.name, describe(&symbol.kind));
        reader.report_symbol(&names::WRONG_SYMBOL, expr.columns.clone(), message, &symbol.key);
        return None;
    }
    Some(width(prefix.prefix))
}

fn allowed(prefixes: PrefixSet) -> String {
    let names: Vec<_> =
        Prefix::ALL.iter().filter(|p| prefixes.contains(**p)).map(|p| format!("{}.", p.name())).collect();
    if names.is_empty() {
        "; it takes no prefix".to_string()
    } else {
        format!("; it takes {}", names.join(" "))
    }
}

fn declared(
    reader: &mut CodeReader<'_>,
    entry: &Entry,
    wanted: &ValueRules,
    symbol: &Symbol,
    member: Option<Width>,
    expr: &Expr,
) -> Option<Width> {
    let own = member.map_or_else(|| symbol.kind.clone(), SymbolKind::Cell);
    let found = match own {
        SymbolKind::Cell(width) | SymbolKind::Array { element: width, .. } => width,
        SymbolKind::MechanismLine => Width::Word,
        // A place for REAL or QWORD cells alone gives DS 8 its type.
        SymbolKind::Area { len: 8 } if only_eight(wanted.declared).is_some() => {
            return only_eight(wanted.declared);
        }
        SymbolKind::Area { .. } | SymbolKind::Text { .. } => {
            let message =
                format!("{} has no type; put BYTE., WORD., DWRD., QWRD. or REAL. before it", symbol.key.name);
            reader.report_symbol(&rules::UNTYPED_AREA, expr.columns.clone(), message, &symbol.key);
            return None;
        }
        _ => {
            let message = format!("{} is {}, a cell is needed here", symbol.key.name, describe(&symbol.kind));
            reader.report_symbol(&names::WRONG_SYMBOL, expr.columns.clone(), message, &symbol.key);
            return None;
        }
    };
    let as_prefix = match found {
        Width::Byte => Prefix::Byte,
        Width::Word => Prefix::Word,
        Width::DWord => Prefix::Dwrd,
        Width::QWord if wanted.declared.contains(Prefix::Qwrd) => Prefix::Qwrd,
        Width::Real if wanted.declared.contains(Prefix::Real) => Prefix::Real,
        Width::QWord | Width::Real => {
            let message = format!("{} is 8 bytes long; say QWRD. or REAL.", symbol.key.name);
            reader.report_symbol(&rules::UNTYPED_AREA, expr.columns.clone(), message, &symbol.key);
            return None;
        }
    };
    if wanted.declared.contains(as_prefix) {
        return Some(found);
    }
    let message =
        format!("{} is {}; {} takes {}", symbol.key.name, describe(&own), entry.name, types(wanted.declared));
    reader.report_symbol(&rules::PREFIX_NOT_ALLOWED, expr.columns.clone(), message, &symbol.key);
    None
}

/// The 8-byte type, when the place takes one of them and no other.
fn only_eight(declared: PrefixSet) -> Option<Width> {
    match (declared.contains(Prefix::Qwrd), declared.contains(Prefix::Real)) {
        (true, false) => Some(Width::QWord),
        (false, true) => Some(Width::Real),
        _ => None,
    }
}

fn types(declared: PrefixSet) -> String {
    let names: Vec<_> = [
        (Prefix::Byte, "BYTE cells"),
        (Prefix::Word, "WORD cells"),
        (Prefix::Dwrd, "DWORD cells"),
        (Prefix::Qwrd, "QWORD cells"),
        (Prefix::Real, "REAL cells"),
        (Prefix::Cnst, "constants"),
    ]
    .iter()
    .filter(|(prefix, _)| declared.contains(*prefix))
    .map(|(_, name)| *name)
    .collect();
    names.join(", ")
}

fn no_constant(reader: &mut CodeReader<'_>, entry: &Entry, wanted: &ValueRules, columns: Columns) {
    if wanted.access == Access::Read {
        let message = format!("{} takes no constant here; name a cell", entry.name);
        reader.report(&rules::OPERAND_KIND, columns, message);
    } else {
        let message = format!("{} writes here; name a cell, not a constant", entry.name);
        reader.report(&rules::CONSTANT_DESTINATION, columns, message);
    }
}

fn real(
    reader: &mut CodeReader<'_>,
    entry: &Entry,
    expr: &Expr,
    shape: &Shape<'_>,
    wanted: &ValueRules,
    value: f64,
) -> Option<Operand> {
    if !wanted.constants() {
        no_constant(reader, entry, wanted, expr.columns.clone());
        return None;
    }
    if !wanted.prefixes.contains(Prefix::Real) {
        let message =
            format!("{} computes with integers only; write a number without decimal point", entry.name);
        reader.report(&rules::REAL_NOT_ALLOWED, expr.columns.clone(), message);
        return None;
    }
    if let Some(prefix) = shape.prefix.as_ref().filter(|p| p.prefix != Prefix::Cnst) {
        let message = "a real constant takes no prefix but CNST.";
        reader.report(&rules::REAL_NOT_ALLOWED, prefix.columns.clone(), message);
        return None;
    }
    if entry.name == "DIVB" && value == 0.0 {
        reader.report(&rules::DIVISION_BY_ZERO, expr.columns.clone(), "this divides by zero");
        return None;
    }
    Some(Operand::Real(value))
}

fn integer_value(
    reader: &mut CodeReader<'_>,
    entry: &Entry,
    expr: &Expr,
    shape: &Shape<'_>,
    wanted: &ValueRules,
) -> Option<Operand> {
    if !wanted.constants() {
        no_constant(reader, entry, wanted, expr.columns.clone());
        return None;
    }
    let prefix = shape.prefix.as_ref();
    let width = match prefix.map(|p| p.prefix) {
        None | Some(Prefix::Cnst) => {
            // A shift count lives in a byte, whatever the constant says.
            Width::DWord
        }
        Some(Prefix::Byte) if wanted.prefixes.contains(Prefix::Byte) => Width::Byte,
        Some(Prefix::Word) if wanted.prefixes.contains(Prefix::Word) => Width::Word,
        Some(Prefix::Dwrd) if wanted.prefixes.contains(Prefix::Dwrd) => Width::DWord,
        Some(other) => {
            let columns = prefix.map_or_else(|| expr.columns.clone(), |p| p.columns.clone());
            let message = format!("{}. cannot stand before a constant in {}", other.name(), entry.name);
            reader.report(&rules::PREFIX_NOT_ALLOWED, columns, message);
            return None;
        }
    };
    let value = folded(reader, expr)?;
    let (low, high) = match width {
        Width::Byte => (-0x80, 0xFF),
        Width::Word => (-0x8000, 0xFFFF),
        _ => (-0x8000_0000, 0xFFFF_FFFF),
    };
    if !(low..=high).contains(&value) {
        let name = match width {
            Width::Byte => "BYTE",
            Width::Word => "WORD",
            _ => "32-bit constant",
        };
        let message = format!("{value} does not fit a {name} ({low} to {high})");
        reader.report(&rules::CONSTANT_TOO_LARGE, expr.columns.clone(), message);
        return None;
    }
    if entry.name == "DIVB" && value == 0 {
        reader.report(&rules::DIVISION_BY_ZERO, expr.columns.clone(), "this divides by zero");
        return None;
    }
    let value = match width {
        Width::Byte => i64::from(value as i8),
        Width::Word => i64::from(value as i16),
        _ => i64::from(value as i32),
    };
    Some(Operand::Integer { value, width })
}

/// The value of a constant operand whose names are known to be constants.
fn folded(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<i64> {
    let bare = super::address::without_prefix(expr);
    let value = super::constant::ConstExpr::read(&bare).ok().and_then(|constant| {
        constant
            .value(&mut |name| super::program::constant(reader.db, reader.project, reader.section, name))
            .ok()
    });
    if value.is_none() {
        reader.report(&rules::CONSTANT_TOO_LARGE, expr.columns.clone(), "the value is too large");
    }
    value
}

/// A constant of any size, integer or real.
pub(super) fn constant(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<Operand> {
    let shape = shape(reader, expr)?;
    if let [Term { kind: TermKind::Real(value), minus, .. }] = shape.terms.as_slice() {
        return Some(Operand::Real(if shape.negated() == *minus { *value } else { -value }));
    }
    integer(reader, expr).map(|value| Operand::Integer { value, width: Width::DWord })
}

/// A number with a decimal point.
pub(super) fn real_constant(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<Operand> {
    match constant(reader, expr)? {
        Operand::Integer { value, .. } => {
            let message = format!("a real number is needed here; write {value}.0");
            reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
            None
        }
        real => Some(real),
    }
}

/// The time of TIM and TEX: number, constant, BYTE or WORD cell, `(cell+n)`.
pub(super) fn time(reader: &mut CodeReader<'_>, entry: &'static Entry, expr: &Expr) -> Option<Operand> {
    let shape = shape(reader, expr)?;
    if let Some(prefix) = shape.prefix.as_ref().filter(|p| p.prefix != Prefix::Cnst) {
        let message = "the prefix of the counter covers the time too; write it there";
        reader.report(&rules::PREFIX_NOT_ALLOWED, prefix.columns.clone(), message);
        return None;
    }
    if matches!(shape.terms.as_slice(), [Term { kind: TermKind::Real(_), .. }]) {
        reader.report(&rules::REAL_NOT_ALLOWED, expr.columns.clone(), "a time is a whole number of cycles");
        return None;
    }
    let total = sum(reader, &shape, expr, ReferenceAccess::Read)?;
    if total.constant {
        let value = folded(reader, expr)?;
        if (0..=0xFFFF).contains(&value) {
            return Some(Operand::Integer { value, width: Width::Word });
        }
        let message = format!("{value} is not within 0 and 65535 cycles");
        reader.report(&rules::NUMBER_OUT_OF_RANGE, expr.columns.clone(), message);
        return None;
    }
    if let Some((true, columns)) = shape.sign.clone() {
        reader.report(&rules::SIGN_NOT_ALLOWED, columns, "a time cannot be negated");
        return None;
    }
    let symbol = total.symbol.filter(|_| !total.dollar && total.bit.is_none() && total.block.is_none());
    let Some(symbol) = symbol else {
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), "a time is a number, a constant or a cell");
        return None;
    };
    let width = match total.member.map_or_else(|| symbol.kind.clone(), SymbolKind::Cell) {
        SymbolKind::Cell(width @ (Width::Byte | Width::Word)) => width,
        SymbolKind::MechanismLine => Width::Word,
        // The counter's prefix gives the width; without one it is reported below.
        SymbolKind::Area { .. } | SymbolKind::Cell(_) => Width::DWord,
        _ => {
            let message =
                format!("{} is {}, {} needs a time", symbol.key.name, describe(&symbol.kind), entry.name);
            reader.report_symbol(&names::WRONG_SYMBOL, expr.columns.clone(), message, &symbol.key);
            return None;
        }
    };
    let address = Address { symbol: symbol.key, offset: total.offset, indexed: total.indexed };
    Some(Operand::Cell { address, width, negated: false })
}

/// An address without access width: MV, CLEAR.
pub(super) fn area(reader: &mut CodeReader<'_>, expr: &Expr, uses: Access) -> Option<Operand> {
    place(reader, expr, uses, "an address is needed here: name, name+n or name[BX]", |kind| {
        matches!(
            kind,
            SymbolKind::Cell(_)
                | SymbolKind::Array { .. }
                | SymbolKind::Area { .. }
                | SymbolKind::Text { .. }
                | SymbolKind::MechanismLine
        )
    })
}

/// A text buffer, with offset or BX.
pub(super) fn text(reader: &mut CodeReader<'_>, expr: &Expr, uses: Access) -> Option<Operand> {
    text_needed(reader, expr, uses, "a text buffer declared by STR is needed here")
}

/// A text buffer where something else may stand too; `need` says what.
pub(super) fn text_needed(
    reader: &mut CodeReader<'_>,
    expr: &Expr,
    uses: Access,
    need: &'static str,
) -> Option<Operand> {
    place(reader, expr, uses, need, |kind| matches!(kind, SymbolKind::Text { .. } | SymbolKind::Area { .. }))
}

fn place(
    reader: &mut CodeReader<'_>,
    expr: &Expr,
    uses: Access,
    need: &'static str,
    fits: fn(&SymbolKind) -> bool,
) -> Option<Operand> {
    let shape = shape(reader, expr)?;
    if let Some(prefix) = &shape.prefix {
        let message = "an address takes no type prefix here";
        reader.report(&rules::PREFIX_NOT_ALLOWED, prefix.columns.clone(), message);
        return None;
    }
    if shape.block.is_some() || shape.negated() || matches!(&expr.kind, ExprKind::Text(_)) {
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), need);
        return None;
    }
    let sum = sum(reader, &shape, expr, access(uses))?;
    let Some(symbol) = sum.symbol.filter(|_| !sum.dollar && sum.bit.is_none()) else {
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), need);
        return None;
    };
    let Some(len) = symbol.bytes().filter(|_| fits(&symbol.kind)) else {
        let message = format!("{} is {}; {need}", symbol.key.name, describe(&symbol.kind));
        reader.report_symbol(&names::WRONG_SYMBOL, expr.columns.clone(), message, &symbol.key);
        return None;
    };
    let address = Address { symbol: symbol.key, offset: sum.offset, indexed: sum.indexed };
    Some(Operand::Area { address, len })
}
