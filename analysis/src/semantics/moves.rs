//! Operands that must fit each other: MOVE, MV, TEX and TIM, shifts.

use technol_image::op::Width;

use super::address::Shape;
use super::code::CodeReader;
use super::hir::Operand;
use super::scope::Symbol;
use crate::catalogue::Entry;
use crate::diagnostics::rules::operands as rules;
use crate::syntax::ast::Line;

/// Checks the operands of a line against each other; each of them is valid by itself.
pub(super) fn check(reader: &mut CodeReader<'_>, entry: &Entry, line: &Line, resolved: &[Operand]) {
    match entry.name {
        "MOVE" | "MOVE1" => same_type(reader, line, resolved),
        "TIM" | "TEX0" | "TEX1" => covered_time(reader, line, resolved),
        "MV" => copied(reader, line, resolved),
        "RL" | "RR" => shift(reader, line, resolved),
        _ => {}
    }
}

fn same_type(reader: &mut CodeReader<'_>, line: &Line, resolved: &[Operand]) {
    let [Operand::Cell { width: to, .. }, Operand::Cell { width: from, .. }] = resolved else { return };
    if to != from {
        let message = format!(
            "the destination is {}, the source {}; both must have one type, or use LOD and STO",
            name(*to),
            name(*from)
        );
        let columns = line.operands[0].columns.start..line.operands[1].columns.end;
        reader.report(&rules::DIFFERENT_TYPES, columns, message);
    }
}

const fn name(width: Width) -> &'static str {
    match width {
        Width::Byte => "BYTE",
        Width::Word => "WORD",
        Width::DWord => "DWORD",
        Width::QWord => "QWORD",
        Width::Real => "REAL",
    }
}

fn covered_time(reader: &mut CodeReader<'_>, line: &Line, resolved: &[Operand]) {
    let (Some(counter), Some(time)) = (line.operands.first(), line.operands.get(1)) else { return };
    let prefix = Shape::of(counter).ok().and_then(|shape| shape.prefix);
    match (&prefix, resolved.get(1)) {
        (Some(prefix), Some(Operand::Integer { .. })) => {
            let message = format!(
                "{}. before the counter covers the time too, which then must be a cell, not a constant",
                prefix.prefix.name()
            );
            reader.report(&rules::PREFIX_COVERS_TIME, time.columns.clone(), message);
        }
        (None, Some(Operand::Cell { width: Width::DWord, address, .. })) => {
            let message = format!("{} is neither BYTE nor WORD; put a prefix before the counter", address.symbol.name);
            reader.report(&rules::UNTYPED_AREA, time.columns.clone(), message);
        }
        _ => {}
    }
}

/// The ranges of MV against the declared lengths.
fn copied(reader: &mut CodeReader<'_>, line: &Line, resolved: &[Operand]) {
    let [source, destination, Operand::Integer { value: count, .. }] = resolved else { return };
    for (operand, expr) in [(source, &line.operands[0]), (destination, &line.operands[1])] {
        let Operand::Area { address, .. } = operand else { continue };
        let symbol: Option<Symbol> = reader.symbol(&address.symbol.name).cloned();
        if let Some(symbol) = symbol.filter(|_| !address.indexed) {
            let bytes = u32::try_from(*count).unwrap_or(u32::MAX);
            reader.overrun(expr.columns.clone(), &symbol, address.offset, bytes);
        }
    }
}

fn shift(reader: &mut CodeReader<'_>, line: &Line, resolved: &[Operand]) {
    if let Some(Operand::Integer { value, .. }) = resolved.first() {
        if !(0..=255).contains(value) {
            let message = format!("{value} is no shift count: 0 to 255");
            reader.report(&rules::NUMBER_OUT_OF_RANGE, line.operands[0].columns.clone(), message);
        }
    }
}
