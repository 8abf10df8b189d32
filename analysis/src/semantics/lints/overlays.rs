//! Text buffers that lie over the same memory (manual 3.18).

use crate::semantics::declarations::{Declarations, Declared, What};

/// Buffers of a section that lie over memory another buffer of it lies over, with what to say about them.
pub(super) fn of(declarations: &Declarations) -> Vec<(&Declared, String)> {
    let mut seen: Vec<(&str, i64, i64, &Declared)> = Vec::new();
    let mut found = Vec::new();
    for name in &declarations.names {
        let What::Text { over: Some(over), len, .. } = &name.what else { continue };
        // One byte more is reserved for the end of the text.
        let (start, end) = (over.offset, over.offset + i64::from(*len) + 1);
        let before = seen
            .iter()
            .find(|(symbol, first, last, _)| *symbol == over.symbol && start < *last && *first < end);
        if let Some((.., other)) = before {
            let message = format!(
                "{} lies over the same bytes of {} as {}: writing one changes the other",
                name.name.text, over.symbol, other.name.text
            );
            found.push((name, message));
        }
        seen.push((&over.symbol, start, end, name));
    }
    found
}
