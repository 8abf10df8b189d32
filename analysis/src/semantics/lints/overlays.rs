//! Text buffers that lie over the same memory (manual 3.18).

use crate::diagnostics::Rule;
use crate::diagnostics::rules::lints as rules;
use crate::semantics::declarations::{Declarations, Declared, What};

/// Buffers of a section that lie over memory another buffer of it lies over, with what to say about them.
pub(super) fn of(declarations: &Declarations) -> Vec<(&'static Rule, &Declared, String)> {
    let mut seen: Vec<(&str, i64, i64, &Declared)> = Vec::new();
    let mut found = Vec::new();
    for name in &declarations.names {
        let What::Text { over: Some(over), len, .. } = &name.what else { continue };
        // One byte more is reserved for the end of the text.
        let (start, end) = (over.offset, over.offset + i64::from(*len) + 1);
        let before = seen
            .iter()
            .find(|(symbol, first, last, _)| *symbol == over.symbol && start < *last && *first < end);
        if let Some((_, first, last, other)) = before {
            let (shown, other) = (&name.name.text, &other.name.text);
            found.push(if (*first, *last) == (start, end) {
                (&rules::SECOND_NAME, name, format!("{shown} is a second name of the text {other}"))
            } else {
                let message = format!(
                    "{shown} lies over the same bytes of {} as {other}: writing one changes the other",
                    over.symbol
                );
                (&rules::OVERLAPPING_OVERLAYS, name, message)
            });
        }
        seen.push((&over.symbol, start, end, name));
    }
    found
}
