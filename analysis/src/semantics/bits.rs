//! Bits: `bit`, `ADR.bit`, `$+n.bit` (manual 3.5).

use super::block;
use super::code::CodeReader;
use super::hir::{Address, Operand};
use super::operands::{access, address_of, describe};
use super::reference::ReferenceAccess;
use super::scope::{Symbol, SymbolKind};
use super::sum::{shape, sum};
use crate::catalogue::Access;
use crate::diagnostics::rules::{names, operands as rules};
use crate::syntax::ast::{Expr, ExprKind, Name};

/// What a bit operand takes.
pub(super) struct BitRules {
    pub(super) access: Access,
    pub(super) negatable: bool,
    pub(super) extended: bool,
}

/// A bit: `bit`, `ADR.bit`, `$+n.bit`.
pub(super) fn bit(reader: &mut CodeReader<'_>, expr: &Expr, wanted: &BitRules) -> Option<Operand> {
    let shape = shape(reader, expr)?;
    if let Some(prefix) = &shape.prefix {
        let message = format!("a bit takes no type prefix; write it without {}.", prefix.prefix.name());
        reader.report(&rules::PREFIX_NOT_ALLOWED, prefix.columns.clone(), message);
        return None;
    }
    if let Some((true, columns)) = shape.sign.clone().filter(|_| !wanted.negatable) {
        reader.report(&rules::SIGN_NOT_ALLOWED, columns, "this operand cannot be negated");
        return None;
    }
    let negated = shape.negated();
    if let Some(name) = shape.plain_name() {
        let symbol = reader.resolve(name, access(wanted.access))?;
        return plain_bit(reader, name, &symbol, negated);
    }
    if shape.block.is_some() {
        return block::bit(reader, &shape, expr, wanted, negated);
    }
    if shape.behind.is_empty() {
        let message = "a bit is needed here: a bit name, ADR.bit or $+n.bit";
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
        return None;
    }
    if !wanted.extended {
        let message = "this instruction takes a bit by its plain name only";
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
        return None;
    }
    let sum = sum(reader, &shape, expr, access(wanted.access))?;
    let Some((mask, bit)) = sum.bit.clone() else {
        let last = shape.behind.last().map_or_else(|| expr.columns.clone(), |behind| behind.columns.clone());
        let message = "this is a member of a structure; a bit is needed behind the last dot";
        reader.report(&rules::OPERAND_KIND, last, message);
        return None;
    };
    let base = if sum.dollar { Some(mask) } else { sum.symbol };
    let Some(base) = base.filter(|base| base.kind != SymbolKind::Mechanism && base.bytes().is_some()) else {
        let message = "an address is needed before the dot: a cell, name+n, name[BX] or $+n";
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
        return None;
    };
    // Stepping from one DFM byte to its neighbours is what `bit+n` and `$+n` are for.
    if !sum.indexed && !matches!(base.kind, SymbolKind::Bit { .. }) {
        reader.overrun(expr.columns.clone(), &base, sum.offset, 1);
    }
    let address = Address { symbol: base.key, offset: sum.offset, indexed: sum.indexed };
    Some(Operand::Bit { address, bit, negated })
}

/// A name that gives the position of a bit; the byte comes from another operand.
pub(super) fn position(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<Operand> {
    let ExprKind::Name(name) = &expr.kind else {
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), "the name of a bit is needed here");
        return None;
    };
    let symbol = reader.resolve(name, ReferenceAccess::Read)?;
    let (SymbolKind::Bit { bit } | SymbolKind::FormalBit { bit }) = symbol.kind else {
        let message = format!("{} is {}, a bit is needed here", name.text, describe(&symbol.kind));
        reader.report_symbol(&names::WRONG_SYMBOL, name.columns.clone(), message, &symbol.key);
        return None;
    };
    Some(Operand::Bit { address: address_of(&symbol), bit, negated: false })
}

fn plain_bit(reader: &mut CodeReader<'_>, name: &Name, symbol: &Symbol, negated: bool) -> Option<Operand> {
    match symbol.kind {
        SymbolKind::Bit { bit } => Some(Operand::Bit { address: address_of(symbol), bit, negated }),
        SymbolKind::Mechanism => Some(Operand::Bit { address: address_of(symbol), bit: 0, negated }),
        SymbolKind::FormalBit { .. } => {
            let message =
                format!("{} is only a position; write the cell before it: ADR.{}", name.text, name.text);
            reader.report(&names::WRONG_SYMBOL, name.columns.clone(), message);
            None
        }
        _ => {
            let message = format!("{} is {}, a bit is needed here", name.text, describe(&symbol.kind));
            reader.report_symbol(&names::WRONG_SYMBOL, name.columns.clone(), message, &symbol.key);
            None
        }
    }
}
