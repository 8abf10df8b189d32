//! Symbols that the model leaves alone, and why.

use std::collections::BTreeSet;

use technol_analysis::catalogue::symbols;

/// What is not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// The control does not write it.
    Written,
    /// The control does not read it.
    Read,
}
use Way::{Read, Written};

/// Symbols, a `*` standing for any letters.
pub(crate) struct Exemption {
    pub(crate) way: Way,
    pub(crate) symbols: &'static str,
    pub(crate) why: &'static str,
}

impl Exemption {
    /// Spellings of all symbols that are exempt in this way.
    pub(crate) fn names(way: Way) -> BTreeSet<&'static str> {
        let patterns = EXEMPT.iter().filter(|it| it.way == way).flat_map(|it| it.symbols.split_whitespace());
        let named = patterns.flat_map(|pattern| {
            symbols().map(|symbol| symbol.spelling).filter(move |name| fits(pattern, name))
        });
        named.collect()
    }
}

/// Whether a pattern names it.
pub(crate) fn fits(pattern: &str, name: &str) -> bool {
    match pattern.split_once('*') {
        None => pattern == name,
        Some((before, after)) => name
            .strip_prefix(before)
            .is_some_and(|rest| (0..=rest.len()).any(|at| fits(after, &rest[at..]))),
    }
}

const fn exempt(way: Way, symbols: &'static str, why: &'static str) -> Exemption {
    Exemption { way, symbols, why }
}

pub(crate) const EXEMPT: &[Exemption] = &[
    exempt(Written, "X", "y"),
    exempt(Read, "X", "y"),
];
