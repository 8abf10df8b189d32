//! Members of the prepared blocks: `BLK[n].member`, `BLK[BX].REAL.member` (manual 8.3.2).

use std::sync::Arc;

use super::address::{BlockIndex, Shape, TermKind};
use super::bits::BitRules;
use super::code::CodeReader;
use super::hir::{BlockNumber, Operand, SymbolKey, SymbolScope};
use super::operands::{address_of, describe, integer};
use super::program::system_kind;
use super::reference::{ReferenceAccess, Referent};
use super::scope::{Symbol, SymbolKind};
use super::suggest;
use super::sum::{Sum, is_bx, sum, within};
use crate::catalogue::{self, Access, Entry};
use crate::diagnostics::rules::{memory, names, operands as rules};
use crate::syntax::ast::Expr;

/// Instructions that read cells of a prepared block.
const READERS: &[&str] =
    &["LOD", "AD", "SU", "ORB", "ANDB", "XORB", "MULB", "DIVB", "EQ", "EQ1", "LE", "LT", "GE", "GT"];
/// Largest number of a block, beyond any queue.
const MAX_BLOCK: i64 = 0xFFFF;

/// Whether an instruction may read a cell of a prepared block; reports it when not.
pub(super) fn readable(reader: &mut CodeReader<'_>, entry: &Entry, uses: Access, expr: &Expr) -> Option<()> {
    if uses == Access::Read && READERS.contains(&entry.name) {
        return Some(());
    }
    let message = if uses == Access::Read {
        format!("{} does not read prepared blocks; load the member by LOD first", entry.name)
    } else {
        "prepared blocks can only be read".to_string()
    };
    reader.report(&memory::BLOCK_ACCESS, expr.columns.clone(), message);
    None
}

/// A bit of a prepared block.
pub(super) fn bit(
    reader: &mut CodeReader<'_>,
    shape: &Shape<'_>,
    expr: &Expr,
    wanted: &BitRules,
    negated: bool,
) -> Option<Operand> {
    if wanted.access != Access::Read || !wanted.extended {
        let message = if wanted.access == Access::Read {
            "only LDR, LA, LO and LX read bits of prepared blocks"
        } else {
            "prepared blocks can only be read"
        };
        reader.report(&memory::BLOCK_ACCESS, expr.columns.clone(), message);
        return None;
    }
    let found = sum(reader, shape, expr, ReferenceAccess::Read)?;
    let symbol = found.symbol.clone()?;
    if let SymbolKind::Bit { bit } = symbol.kind {
        return Some(found.in_block(Operand::Bit { address: address_of(&symbol), bit, negated }));
    }
    let message = format!("{} is {}, a bit is needed here", symbol.key.name, describe(&symbol.kind));
    reader.report(&names::WRONG_SYMBOL, expr.columns.clone(), message);
    None
}

/// The member that a shape with `BLK[n].` names.
pub(super) fn member(
    reader: &mut CodeReader<'_>,
    shape: &Shape<'_>,
    block: &BlockIndex<'_>,
    expr: &Expr,
) -> Option<Sum> {
    let Some(index) = block.index else {
        let message = "say which block: BLK[0] is the current one, BLK[1] the next, BLK[BX] the one in BX";
        reader.report(&rules::OPERAND_KIND, block.columns.clone(), message);
        return None;
    };
    let number = if is_bx(index) { BlockNumber::Indexed } else { BlockNumber::Fixed(fixed(reader, index)?) };
    let ([term], []) = (shape.terms.as_slice(), shape.behind.as_slice()) else {
        let message = "one member of the block can stand behind BLK[n].";
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
        return None;
    };
    let (name, element) = match &term.kind {
        TermKind::Name(name) => (*name, None),
        TermKind::Indexed(name, element) => (*name, Some(*element)),
        _ => return None,
    };
    let Some(system) = catalogue::block_member(&name.text) else {
        let near = suggest::nearest(&name.text, catalogue::block_members().map(|member| member.name));
        let near = near.and_then(catalogue::block_member).map(|member| member.spelling);
        let message = match near {
            Some(near) => format!("a block has no member {}; did you mean {near}?", name.text),
            None => format!("a block has no member {}", name.text),
        };
        reader.report(&names::UNKNOWN_SYMBOL, name.columns.clone(), message);
        return None;
    };
    let key = SymbolKey { scope: SymbolScope::System, name: Arc::from(format!("BLK.{}", system.name)) };
    reader.refer(name.columns.clone(), Referent::Symbol(key.clone()), ReferenceAccess::Read);
    let kind = system_kind(&system.kind);
    let mut found = Sum { constant: false, block: Some(number), ..Sum::default() };
    match (&kind, element) {
        (SymbolKind::Array { element: width, len }, Some(element)) => {
            let n = integer(reader, element)?;
            within(reader, name, element, n, *len)?;
            found.offset = n * i64::from(width.bytes());
        }
        (SymbolKind::Array { .. }, None) => {
            let message = format!("{0} has several elements; write {0}[n]", system.spelling);
            reader.report(&rules::OPERAND_KIND, term.columns.clone(), message);
            return None;
        }
        (_, Some(_)) => {
            let message = format!("{} is {} and has no elements", system.spelling, describe(&kind));
            reader.report(&rules::OPERAND_KIND, term.columns.clone(), message);
            return None;
        }
        (_, None) => {}
    }
    found.symbol = Some(Symbol { key, kind });
    Some(found)
}

fn fixed(reader: &mut CodeReader<'_>, index: &Expr) -> Option<u32> {
    let number = integer(reader, index)?;
    if (0..=MAX_BLOCK).contains(&number) {
        return Some(number as u32);
    }
    let message = format!("{number} is no block: 0 is the current one, 1 the next");
    reader.report(&rules::NUMBER_OUT_OF_RANGE, index.columns.clone(), message);
    None
}
