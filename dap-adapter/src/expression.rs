//! Expressions of the debugger, resolved to what the tree can show.

use technol_image::debug_info::{DebugInfo, Scope, Symbol, SymbolKind};
use technol_image::op::Width;

use crate::registers::{self, Register};
use crate::tree::Shown;

/// What an expression names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Named {
    Thing(Shown),
    Constant(i64),
}

/// TEMPORARY until technol_analysis::expression is there.
pub(crate) fn resolve(debug: &DebugInfo, order: Option<u8>, text: &str) -> Result<Named, String> {
    let text = text.trim();
    if let Some((_, r)) = registers::ALL.iter().find(|(n, _)| n.eq_ignore_ascii_case(text)) {
        return Ok(Named::Thing(Shown::Register(*r)));
    }
    if text.eq_ignore_ascii_case("DR") {
        return Ok(Named::Thing(Shown::Register(Register::Dr(Width::QWord))));
    }
    if let Some((base, bit)) = text.rsplit_once('.') {
        if let (Ok(bit @ 0..=7), Ok(Named::Thing(Shown::Cell { addr, .. }))) =
            (bit.parse::<u8>(), resolve(debug, order, base))
        {
            return Ok(Named::Thing(Shown::Bit { addr, bit }));
        }
    }
    let sees = |s: &&Symbol| s.name.eq_ignore_ascii_case(text) && (!matches!(s.scope, Scope::File(n) if Some(n) != order));
    let symbol = debug.symbols.iter().find(sees).ok_or_else(|| format!("there is no `{text}`"))?;
    Ok(Named::Thing(match symbol.kind {
        SymbolKind::Bit { addr, bit } => Shown::Bit { addr, bit },
        SymbolKind::Cell { addr, width } => Shown::Cell { addr, width },
        SymbolKind::Area { addr, len } => Shown::Area { addr, len },
        SymbolKind::Text { addr, len } => Shown::Text { addr, len },
        SymbolKind::Mechanism { sequence } => Shown::Mechanism(sequence),
        SymbolKind::Constant { value } => return Ok(Named::Constant(value)),
        _ => return Err(format!("`{text}` has no value")),
    }))
}
