//! Operands that must fit each other: MOVE, MV, TEX and TIM, shifts, and comparisons with what was loaded.

use technol_image::op::Width;

use super::address::Shape;
use super::code::CodeReader;
use super::hir::Operand;
use super::scope::{Symbol, SymbolKind};
use crate::catalogue::{Effect, Entry};
use crate::diagnostics::Rule;
use crate::diagnostics::rules::{lints, operands as rules};
use crate::syntax::ast::{Expr, Line};

/// Most characters of the buffer for a number (manual 3.18).
const MOST_DIGITS: u32 = 10;

/// Checks the operands of a line against each other; each of them is valid by itself. The prefix of a counter is
/// handed on to the time that it covers.
pub(super) fn check(reader: &mut CodeReader<'_>, entry: &Entry, line: &Line, resolved: &mut [Operand]) {
    match entry.name {
        "MOVE" | "MOVE1" => same_type(reader, line, resolved),
        "TIM" | "TEX0" | "TEX1" => covered_time(reader, line, resolved),
        "MV" => copied(reader, line, resolved),
        "RL" | "RR" => shift(reader, line, resolved),
        "BINSTR" | "BCDSTR" => number_text(reader, entry, line, resolved),
        "STRCPY" | "STRADD" | "MEMCPY" | "MEMCMP" => super::texts::check(reader, entry, line, resolved),
        "CLEAR" => cleared(reader, line, resolved),
        "SA_READ" | "SA_WRITE" => shared(reader, line, resolved),
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

fn covered_time(reader: &mut CodeReader<'_>, line: &Line, resolved: &mut [Operand]) {
    let (Some(counter), Some(time)) = (line.operands.first(), line.operands.get(1)) else { return };
    let prefix = Shape::of(counter).ok().and_then(|shape| shape.prefix);
    let [Operand::Cell { width: of_counter, .. }, time_operand, ..] = resolved else {
        return untyped_time(reader, time, resolved.get(1));
    };
    match (&prefix, time_operand) {
        (Some(_), Operand::Cell { width, .. }) => *width = *of_counter,
        (Some(prefix), Operand::Integer { .. }) => {
            let message = format!(
                "{}. before the counter covers the time too, which then must be a cell, not a constant",
                prefix.prefix.name()
            );
            reader.report(&rules::PREFIX_COVERS_TIME, time.columns.clone(), message);
        }
        (None, Operand::Integer { value, .. }) if *of_counter == Width::Byte && *value > 0xFF => {
            let message =
                format!("a BYTE counts to 255 and never reaches {value}; declare the counter with DS 2");
            reader.report(&lints::COUNTER_TOO_NARROW, time.columns.clone(), message);
        }
        (None, Operand::Cell { width, .. }) if *width != Width::DWord && width != of_counter => {
            let message = format!(
                "the counter is {}, the time {}; both must have one type",
                name(*of_counter),
                name(*width)
            );
            reader.report(&rules::DIFFERENT_TYPES, time.columns.clone(), message);
        }
        (None, time_operand) => untyped_time(reader, time, Some(time_operand)),
        _ => {}
    }
}

/// A time cell that only a prefix before the counter would give a type.
fn untyped_time(reader: &mut CodeReader<'_>, time: &Expr, operand: Option<&Operand>) {
    if let Some(Operand::Cell { width: Width::DWord, address, .. }) = operand {
        let message =
            format!("{} is neither BYTE nor WORD; put a prefix before the counter", address.symbol.name);
        reader.report(&rules::UNTYPED_AREA, time.columns.clone(), message);
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

/// CLEAR: two cells of one data area, or GLOBAL or INTERNAL with ALL.
fn cleared(reader: &mut CodeReader<'_>, line: &Line, resolved: &[Operand]) {
    let [first, last] = resolved else { return };
    let fits = match (first, last) {
        (Operand::Area { address: begin, .. }, Operand::Area { address: end, .. }) => {
            begin.symbol.scope == end.symbol.scope && !begin.indexed && !end.indexed
        }
        (Operand::Keyword("GLOBAL" | "INTERNAL"), Operand::Keyword("ALL")) => true,
        _ => false,
    };
    if !fits {
        let message = "CLEAR takes two cells of one data area, or GLOBAL,ALL, or INTERNAL,ALL";
        let columns = line.operands[0].columns.start..line.operands[1].columns.end;
        reader.report(&rules::OPERAND_KIND, columns, message);
    }
}

/// The buffer of BINSTR and BCDSTR.
fn number_text(reader: &mut CodeReader<'_>, entry: &Entry, line: &Line, resolved: &[Operand]) {
    for (operand, expr) in resolved.iter().zip(&line.operands) {
        let Operand::Area { address, .. } = operand else { continue };
        let symbol = reader.symbol(&address.symbol.name);
        if let Some(Symbol { kind: SymbolKind::Text { len }, .. }) = symbol
            && *len > MOST_DIGITS
        {
            let message =
                format!("{} takes a buffer of 1 to {MOST_DIGITS} characters, this one has {len}", entry.name);
            reader.report(&lints::NUMBER_TEXT_SIZE, expr.columns.clone(), message);
        }
    }
}

/// A block of a shared area, when both its ends are known (manual 18.3).
fn shared(reader: &mut CodeReader<'_>, line: &Line, resolved: &[Operand]) {
    const AREA_LEN: i64 = 32_000;
    let [_, Operand::Integer { value: offset, .. }, Operand::Integer { value: size, .. }, ..] = resolved
    else {
        return;
    };
    let end = offset.saturating_add(*size);
    if *offset < 0 || end > AREA_LEN {
        let message =
            format!("the block {offset} to {end} does not lie in the {AREA_LEN} bytes of a shared area");
        let columns = line.operands[1].columns.start..line.operands[2].columns.end;
        reader.report(&rules::NUMBER_OUT_OF_RANGE, columns, message);
    }
}

fn shift(reader: &mut CodeReader<'_>, line: &Line, resolved: &[Operand]) {
    if let Some(Operand::Integer { value, .. }) = resolved.first()
        && !(0..=255).contains(value)
    {
        let message = format!("{value} is no shift count: 0 to 255");
        reader.report(&rules::NUMBER_OUT_OF_RANGE, line.operands[0].columns.clone(), message);
    }
}

/// What the lines before left in DR, as far as the text tells.
#[derive(Debug, Default)]
pub(super) struct Loaded {
    /// A BYTE or WORD cell, sign-extended.
    width: Option<Width>,
    /// Instruction that changed only a part of DR since all 64 bits were valid.
    partly: Option<&'static str>,
}

impl Loaded {
    /// An instruction; gives what is wrong with its operand.
    pub(super) fn step(
        &mut self,
        entry: &'static Entry,
        operands: &[Operand],
    ) -> Option<(&'static Rule, String)> {
        let found = match (entry.name, operands) {
            ("EQ" | "EQ1", [Operand::Integer { value, width: Width::DWord }]) => self.never_equal(*value),
            (
                "DIVB",
                [Operand::Integer { width: Width::DWord, .. } | Operand::Cell { width: Width::DWord, .. }],
            ) => self.partly.map(|by| {
                let message = format!(
                    "this divides all 64 bits of DR, but {by} changed only the lower ones; a negative or larger \
                     result of it is divided wrongly"
                );
                (&rules::STALE_DIVIDEND, message)
            }),
            _ => None,
        };
        self.follow(entry, operands);
        found
    }

    fn never_equal(&self, value: i64) -> Option<(&'static Rule, String)> {
        let (range, name) = match self.width? {
            Width::Byte => (0x80..=0xFF, "BYTE"),
            _ => (0x8000..=0xFFFF, "WORD"),
        };
        range.contains(&value).then(|| {
            let message =
                format!("a {name} cell loads with its sign, so DR is never {value}; write {name}.{value}");
            (&rules::NEVER_EQUAL, message)
        })
    }

    fn follow(&mut self, entry: &'static Entry, operands: &[Operand]) {
        let writes =
            entry.writes.iter().any(|effect| matches!(effect, Effect::Dr | Effect::Dr64 | Effect::DrReal));
        if !writes && !entry.ex_type {
            return;
        }
        *self = match (entry.name, operands) {
            ("LOD", [Operand::Cell { width: width @ (Width::Byte | Width::Word), negated: false, .. }]) => {
                Loaded { width: Some(*width), partly: None }
            }
            ("AD" | "SU", [Operand::Cell { width, .. } | Operand::Integer { width, .. }])
                if width.bytes() < 8 =>
            {
                Loaded { width: None, partly: Some(self.partly.unwrap_or(entry.name)) }
            }
            ("INR" | "DCR" | "INV", [] | [Operand::Skipped | Operand::Keyword("DWRD")]) => {
                Loaded { width: None, partly: Some(self.partly.unwrap_or(entry.name)) }
            }
            _ => Loaded::default(),
        };
    }
}
