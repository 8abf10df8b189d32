//! Sums of an operand: one address, constants, `$`, an index.

use technol_image::op::Width;

use super::address::{Behind, Misshape, PrefixUse, Shape, Term, TermKind};
use super::block;
use super::code::CodeReader;
use super::constant::character;
use super::hir::{BlockNumber, Operand};
use super::operands::{describe, integer};
use super::program::width;
use super::reference::ReferenceAccess;
use super::scope::{Symbol, SymbolKind};
use crate::diagnostics::rules::{memory, names, operands as rules, syntax};
use crate::syntax::ast::{Expr, ExprKind, Name};

/// Largest distance from a symbol in bytes, more than any memory has.
const MAX_OFFSET: u64 = 0x0FFF_FFFF;

/// A sum of terms, resolved.
pub(super) struct Sum {
    /// The one symbol with memory in it.
    pub(super) symbol: Option<Symbol>,
    /// `$` stands in it.
    pub(super) dollar: bool,
    pub(super) offset: i64,
    pub(super) indexed: bool,
    /// A name that is a constant, or a number, and nothing else.
    pub(super) constant: bool,
    /// Type of the last member of a structure in it.
    pub(super) member: Option<Width>,
    /// The bit behind the last dot.
    pub(super) bit: Option<(Symbol, u8)>,
    /// Which of the prepared blocks the symbol is a member of.
    pub(super) block: Option<BlockNumber>,
}

impl Default for Sum {
    fn default() -> Self {
        Sum {
            symbol: None,
            dollar: false,
            offset: 0,
            indexed: false,
            constant: true,
            member: None,
            bit: None,
            block: None,
        }
    }
}

impl Sum {
    /// The operand, or the same in one of the prepared blocks.
    pub(super) fn in_block(&self, operand: Operand) -> Operand {
        match self.block {
            Some(number) => Operand::Block { number, member: Box::new(operand) },
            None => operand,
        }
    }
}

/// The shape of an operand; reports what has none.
pub(super) fn shape<'a>(reader: &mut CodeReader<'_>, expr: &'a Expr) -> Option<Shape<'a>> {
    match Shape::of(expr) {
        Ok(shape) => {
            if let Some(prefix) = &shape.prefix {
                misspelled(reader, prefix);
            }
            Some(shape)
        }
        Err(Misshape::Reported) => {
            reader.clean = false;
            None
        }
        Err(Misshape::Form(columns, message)) => {
            reader.report(&rules::OPERAND_KIND, columns, message);
            None
        }
    }
}

/// Reports `CNTS.`.
pub(super) fn misspelled(reader: &mut CodeReader<'_>, prefix: &PrefixUse) {
    if prefix.misspelled {
        let finding = crate::diagnostics::Finding::new(
            &syntax::MISSPELLED_PREFIX,
            reader.line,
            prefix.columns.clone(),
            "CNTS. is read as CNST.",
        );
        reader.push_finding(finding.replace("write CNST", prefix.columns.clone(), "CNST"));
    }
}

pub(super) fn sum(
    reader: &mut CodeReader<'_>,
    shape: &Shape<'_>,
    expr: &Expr,
    uses: ReferenceAccess,
) -> Option<Sum> {
    if let Some(block) = &shape.block {
        return block::member(reader, shape, block, expr);
    }
    let mut sum = Sum::default();
    let element = shape.prefix.as_ref().map(|prefix| width(prefix.prefix).bytes());
    for term in &shape.terms {
        add(reader, &mut sum, term, element, uses)?;
    }
    for (index, behind) in shape.behind.iter().enumerate() {
        dotted(reader, &mut sum, behind, index + 1 == shape.behind.len())?;
    }
    if sum.member.is_some() && sum.symbol.is_none() && !sum.dollar {
        let message = "a member of a structure needs the memory it lies in: base.MEMBER or (base+MEMBER)";
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
        return None;
    }
    if sum.dollar && sum.symbol.is_some() {
        let message = "$ stands for the byte of the bit; no other address can be added to it";
        reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
        return None;
    }
    if !sum.constant && sum.offset.unsigned_abs() > MAX_OFFSET {
        reader.report(&rules::CONSTANT_TOO_LARGE, expr.columns.clone(), "the offset is too large");
        return None;
    }
    Some(sum)
}

/// A name behind a dot: a member of a structure or, as the last one, a bit.
fn dotted(reader: &mut CodeReader<'_>, sum: &mut Sum, behind: &Behind<'_>, last: bool) -> Option<()> {
    let symbol = reader.resolve(behind.name, ReferenceAccess::Read)?;
    match symbol.kind {
        SymbolKind::Member { offset, element, len } => {
            member(reader, sum, behind, (offset, element, len), false)
        }
        SymbolKind::Bit { bit } | SymbolKind::FormalBit { bit } if last && behind.index.is_none() => {
            sum.bit = Some((symbol, bit));
            Some(())
        }
        _ => {
            let need = if last { "a bit or a member of a structure" } else { "a member of a structure" };
            let message =
                format!("{} is {}, {need} is needed here", behind.name.text, describe(&symbol.kind));
            reader.report_symbol(&names::WRONG_SYMBOL, behind.name.columns.clone(), message, &symbol.key);
            None
        }
    }
}

/// Adds the offset of a member, or of its n-th element.
fn member(
    reader: &mut CodeReader<'_>,
    sum: &mut Sum,
    behind: &Behind<'_>,
    (offset, element, len): (u32, Width, u32),
    minus: bool,
) -> Option<()> {
    sum.constant = false;
    let mut distance = i64::from(offset);
    match behind.index {
        None => {}
        Some(index) if is_bx(index) => sum.indexed = true,
        Some(index) => {
            let number = integer(reader, index)?;
            within(reader, behind.name, index, number, len)?;
            distance += number * i64::from(element.bytes());
        }
    }
    sum.member = Some(element);
    let Some(total) = sum.offset.checked_add(if minus { -distance } else { distance }) else {
        reader.report(&rules::CONSTANT_TOO_LARGE, behind.columns.clone(), "the value is too large");
        return None;
    };
    sum.offset = total;
    Some(())
}

/// Whether an index is BX, which the program sets at run time.
pub(super) fn is_bx(index: &Expr) -> bool {
    matches!(&index.kind, ExprKind::Name(name) if name.text.eq_ignore_ascii_case("BX"))
}

/// Whether an array of `len` elements has the element `number`; reports it when not.
pub(super) fn within(
    reader: &mut CodeReader<'_>,
    name: &Name,
    index: &Expr,
    number: i64,
    len: u32,
) -> Option<()> {
    if (0..i64::from(len)).contains(&number) {
        return Some(());
    }
    let last = len.saturating_sub(1);
    let message = format!("{} has the elements 0 to {last}, there is no {number}", name.text);
    reader.report(&memory::INDEX_OUTSIDE_ARRAY, index.columns.clone(), message);
    None
}

fn add(
    reader: &mut CodeReader<'_>,
    sum: &mut Sum,
    term: &Term<'_>,
    element: Option<u32>,
    uses: ReferenceAccess,
) -> Option<()> {
    let value = match &term.kind {
        TermKind::Integer(value) => *value,
        TermKind::Text(text) => {
            if let Some(value) = character(text) {
                value
            } else {
                let message = "a character constant is one character in apostrophes";
                reader.report(&rules::OPERAND_KIND, term.columns.clone(), message);
                return None;
            }
        }
        TermKind::Real(_) => {
            let message = "a number with a decimal point cannot be part of an address or sum";
            reader.report(&rules::REAL_NOT_ALLOWED, term.columns.clone(), message);
            return None;
        }
        TermKind::Dollar => {
            sum.dollar = true;
            sum.constant = false;
            return Some(());
        }
        TermKind::Name(name)
            if name.text.eq_ignore_ascii_case("BX") && sum.symbol.is_some() && !term.minus =>
        {
            sum.indexed = true;
            return Some(());
        }
        TermKind::Name(name) => {
            let symbol = reader.resolve(name, uses)?;
            match symbol.kind {
                SymbolKind::Constant(value) => value,
                SymbolKind::Member { offset, element, len } => {
                    let behind = Behind { name, index: None, columns: term.columns.clone() };
                    return member(reader, sum, &behind, (offset, element, len), term.minus);
                }
                _ => return memory(reader, sum, term, symbol, name),
            }
        }
        TermKind::Indexed(name, index) => return indexed(reader, sum, term, (name, index), element, uses),
    };
    let step = if term.minus { value.checked_neg() } else { Some(value) };
    advance(reader, sum, term, step)
}

/// `name[index]`, of an array, a structure or an area whose elements have a size.
fn indexed(
    reader: &mut CodeReader<'_>,
    sum: &mut Sum,
    term: &Term<'_>,
    (name, index): (&Name, &Expr),
    element: Option<u32>,
    uses: ReferenceAccess,
) -> Option<()> {
    let symbol = reader.resolve(name, uses)?;
    if let SymbolKind::Member { offset, element, len } = symbol.kind {
        let behind = Behind { name, index: Some(index), columns: term.columns.clone() };
        return member(reader, sum, &behind, (offset, element, len), term.minus);
    }
    if is_bx(index) {
        sum.indexed = true;
        return memory(reader, sum, term, symbol, name);
    }
    let number = integer(reader, index)?;
    let size = match symbol.kind {
        SymbolKind::Array { element, len } => {
            within(reader, name, index, number, len)?;
            element.bytes()
        }
        SymbolKind::Area { .. } if element.is_some() => element.unwrap_or(1),
        _ => {
            let message = format!(
                "{} is {}: name[n] is for arrays; write {}+n for a byte offset, or {}[BX]",
                name.text,
                describe(&symbol.kind),
                name.text,
                name.text
            );
            reader.report(&rules::OPERAND_KIND, term.columns.clone(), message);
            return None;
        }
    };
    advance(reader, sum, term, number.checked_mul(i64::from(size)))?;
    memory(reader, sum, term, symbol, name)
}

/// Goes so many bytes on; `None` is more than a number holds.
fn advance(reader: &mut CodeReader<'_>, sum: &mut Sum, term: &Term<'_>, bytes: Option<i64>) -> Option<()> {
    let Some(offset) = bytes.and_then(|bytes| sum.offset.checked_add(bytes)) else {
        reader.report(&rules::CONSTANT_TOO_LARGE, term.columns.clone(), "the value is too large");
        return None;
    };
    sum.offset = offset;
    Some(())
}

fn memory(
    reader: &mut CodeReader<'_>,
    sum: &mut Sum,
    term: &Term<'_>,
    symbol: Symbol,
    name: &Name,
) -> Option<()> {
    sum.constant = false;
    if matches!(symbol.kind, SymbolKind::Procedure | SymbolKind::Macro) {
        let message = format!("{} is {} and has no memory", name.text, describe(&symbol.kind));
        reader.report_symbol(&names::WRONG_SYMBOL, name.columns.clone(), message, &symbol.key);
        return None;
    }
    if term.minus || sum.symbol.is_some() {
        let message = format!("{} is an address; to an address only constants can be added", name.text);
        reader.report(&rules::OPERAND_KIND, name.columns.clone(), message);
        return None;
    }
    sum.symbol = Some(symbol);
    Some(())
}
