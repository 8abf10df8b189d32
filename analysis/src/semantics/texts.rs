//! Sizes of texts and binary strings: STRCPY, STRADD, MEMCPY, MEMCMP (manual 3.18).

use super::code::CodeReader;
use super::hir::Operand;
use super::scope::SymbolKind;
use crate::catalogue::Entry;
use crate::diagnostics::rules::memory as rules;
use crate::syntax::ast::Line;

/// Checks the sizes of both operands against each other.
pub(super) fn check(reader: &mut CodeReader<'_>, entry: &Entry, line: &Line, resolved: &[Operand]) {
    let [to, from, rest @ ..] = resolved else { return };
    let number = match rest.first() {
        Some(Operand::Integer { value, .. }) => Some(*value),
        _ => None,
    };
    match (entry.name, from) {
        ("STRCPY" | "STRADD", Operand::Text(text)) => {
            let len = text.chars().count() as i64;
            literal(reader, line, to, number.map_or(len, |number| len.min(number)));
        }
        ("MEMCPY" | "MEMCMP", _) => binary(reader, entry, line, [to, from], number),
        _ => {}
    }
}

/// A literal in a text buffer.
fn literal(reader: &mut CodeReader<'_>, line: &Line, to: &Operand, len: i64) {
    let Some(room) = room(reader, to, false) else { return };
    if len > room {
        let message = format!("{len} characters are written, there is room for {}", room.max(0));
        reader.report(&rules::TEXT_CUT, line.operands[1].columns.clone(), message);
    }
}

/// Bytes of binary strings: the byte behind the characters counts as well.
fn binary(reader: &mut CodeReader<'_>, entry: &Entry, line: &Line, both: [&Operand; 2], number: Option<i64>) {
    let rooms = both.map(|operand| room(reader, operand, true));
    if let Some(number) = number {
        for (room, expr) in rooms.into_iter().zip(&line.operands) {
            if let Some(room) = room.filter(|room| number > *room) {
                let message = format!("{number} bytes are taken, the buffer has {} from here", room.max(0));
                reader.report(&rules::COPY_SIZE, expr.columns.clone(), message);
            }
        }
        return;
    }
    let ([Some(to), Some(from)], Some(operation)) = (rooms, &line.operation) else { return };
    if to != from {
        let message = format!(
            "the buffers have {} and {} bytes from here; give {} the number of bytes",
            to.max(0),
            from.max(0),
            entry.name
        );
        reader.report(&rules::COPY_SIZE, operation.columns.clone(), message);
    }
}

/// Characters, or bytes, from the place an operand names to the end of its symbol; `None` when BX decides.
fn room(reader: &CodeReader<'_>, operand: &Operand, bytes: bool) -> Option<i64> {
    let Operand::Area { address, .. } = operand else { return None };
    let symbol = reader.symbol(&address.symbol.name).filter(|_| !address.indexed)?;
    let len = match symbol.kind {
        SymbolKind::Text { len } if !bytes => len,
        _ => symbol.bytes()?,
    };
    Some(i64::from(len) - address.offset)
}
