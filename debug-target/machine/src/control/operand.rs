//! Operands whose width the instruction decides and not the declaration.

use technol_image::service::Arg;
use technol_runtime::{Call, FaultKind};

use super::data::Content;

/// An integer: the value of a cell or constant, or the first four bytes of a text.
pub(super) fn integer(call: &Call<'_>, n: usize) -> Result<i64, FaultKind> {
    match call.arg(n) {
        Arg::Area { .. } => {
            let mut all = [0; 4];
            fill(&mut all, call.content(n)?);
            Ok(i64::from(i32::from_le_bytes(all)))
        }
        _ => Ok(call.integer(n)?.unwrap_or(0)),
    }
}

/// A real number: a constant, or eight bytes of whatever is named.
pub(super) fn real(call: &Call<'_>, n: usize) -> Result<f64, FaultKind> {
    match call.arg(n) {
        Arg::Cell { neg: false, .. } | Arg::Area { .. } => {
            let mut all = [0; 8];
            fill(&mut all, call.content(n)?);
            Ok(f64::from_le_bytes(all))
        }
        _ => Ok(call.real(n)?.unwrap_or(0.0)),
    }
}

/// Writes a value: an integer at the width of the cell (four bytes to a text), a real as eight bytes, a text with its end
/// mark, bytes as they are. Nothing goes past the end of the operand.
pub(super) fn store(call: &mut Call<'_>, n: usize, content: Content<'_>) -> Result<(), FaultKind> {
    match content {
        Content::Int(value) if !matches!(call.arg(n), Arg::Area { .. }) => call.store(n, value),
        Content::Int(value) => cut(call, n, &(value as i32).to_le_bytes()),
        Content::Real(value) => cut(call, n, &value.to_le_bytes()),
        Content::Text(text) => call.store_text(n, text),
        Content::Bytes(bytes) => cut(call, n, bytes),
    }
}

fn cut(call: &mut Call<'_>, n: usize, bytes: &[u8]) -> Result<(), FaultKind> {
    let Some((addr, len)) = call.area(n)? else { return Ok(()) };
    call.write(addr, &bytes[..bytes.len().min(len as usize)])
}

fn fill(all: &mut [u8], from: &[u8]) {
    for (place, byte) in all.iter_mut().zip(from) {
        *place = *byte;
    }
}
