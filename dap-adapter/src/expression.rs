//! Expressions of the debugger, resolved to what the tree can show.

use technol_analysis::expression::{self, ExpressionError, Target};
use technol_image::debug_info::{DebugInfo, Scope, SymbolKind};

use crate::tree::Shown;

/// What an expression names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Named {
    Thing(Shown),
    Constant(i64),
}

/// Finds what `text` names, seen from the file with this place in execution order.
pub(crate) fn resolve(debug: &DebugInfo, order: Option<u8>, text: &str) -> Result<Named, String> {
    let shown = match expression::resolve(debug, order, text) {
        Ok(Target::Bit { addr, bit }) => Shown::Bit { addr, bit },
        Ok(Target::Cell { addr, width }) => Shown::Cell { addr, width },
        Ok(Target::Text { addr, len }) => Shown::Text { addr, len },
        Ok(Target::Register(register)) => Shown::Register(register.into()),
        Ok(Target::Mechanism(sequence)) => Shown::Mechanism(sequence),
        Ok(Target::Constant(value)) => return Ok(Named::Constant(value)),
        // An area has no value, but it can be looked into.
        Err(error @ ExpressionError::NeedsType(_)) => {
            area(debug, order, text).ok_or_else(|| error.to_string())?
        }
        Err(error) => return Err(error.to_string()),
    };
    Ok(Named::Thing(shown))
}

fn area(debug: &DebugInfo, order: Option<u8>, text: &str) -> Option<Shown> {
    let name = text.trim();
    let mut areas =
        debug.symbols.iter().filter(|s| s.name.eq_ignore_ascii_case(name)).filter_map(|s| match s.kind {
            SymbolKind::Area { addr, len } => Some((s.scope, Shown::Area { addr, len })),
            _ => None,
        });
    let local = areas.clone().find(|(scope, _)| order.is_some_and(|n| *scope == Scope::File(n)));
    local.or_else(|| areas.next()).map(|(_, shown)| shown)
}

/// The memory behind something shown, to be given a value.
pub(crate) fn target(shown: &Shown) -> Option<Target> {
    match *shown {
        Shown::Bit { addr, bit } => Some(Target::Bit { addr, bit }),
        Shown::Cell { addr, width } => Some(Target::Cell { addr, width }),
        Shown::Text { addr, len } => Some(Target::Text { addr, len }),
        Shown::Register(register) => register.target().map(Target::Register),
        _ => None,
    }
}
