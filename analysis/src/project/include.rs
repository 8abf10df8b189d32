//! T_INCLUDE: which files a text names, and where they are looked for (manual 22).

use crate::semantics::collect::include_of;
use crate::syntax;

/// Where a T_INCLUDE leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum IncludeTarget {
    /// This file, by its project path.
    File(String),
    /// Nowhere; why, and what to do.
    Missing(String),
    /// Back to a file that includes this one; the circle in words.
    Cyclic(String),
}

/// The files a text includes: name as spelled without apostrophes, and whether it stands in apostrophes.
#[must_use]
pub fn include_names(text: &str) -> Vec<(String, bool)> {
    let mut names = Vec::new();
    // Asked after every change: most texts have none, and most lines of the others.
    if !mentions(text) {
        return names;
    }
    for line in syntax::lines(text).filter(|line| mentions(line.text)) {
        let parsed = syntax::parse_lines(line.text);
        let found = parsed.lines.first().and_then(|parsed| include_of(parsed, line.text));
        names.extend(found.map(|(_, name, quoted)| (name, quoted)));
    }
    names
}

fn mentions(text: &str) -> bool {
    const WORD: &[u8] = b"T_INCLUDE";
    text.as_bytes().windows(WORD.len()).any(|w| w[1] == b'_' && w.eq_ignore_ascii_case(WORD))
}
