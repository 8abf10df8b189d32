//! Uses that no line can be left out for, with the reason and what shows their effect.

/// Uses, and why.
pub(super) const EXEMPT: &[(&[&str], &str)] = &[];
