//! The page of anything that has a name: an instruction, a symbol of the control, a rule.

use crate::catalogue::{self, Language};
use crate::diagnostics;
use crate::semantics::suggest::nearest;

/// The page as Markdown: the one that hover shows, or the documentation of a rule.
///
/// # Errors
/// Nothing has that name: the known name that looks most like it, if one does.
pub fn explain(name: &str, language: Language) -> Result<String, Option<&'static str>> {
    let name = name.trim().trim_end_matches('.');
    if let Some(entry) = catalogue::entry(name) {
        return Ok(catalogue::page::markdown(entry, language));
    }
    if let Some(symbol) = catalogue::symbol(name) {
        return Ok(catalogue::page::symbol_markdown(symbol, language));
    }
    diagnostics::explain(&name.to_ascii_uppercase()).ok_or_else(|| {
        let entries = catalogue::entries().map(|entry| entry.name);
        let rules = diagnostics::RULES.iter().map(|rule| rule.code);
        let symbols = catalogue::symbols().map(|symbol| symbol.name);
        nearest(name, entries.chain(rules)).or_else(|| nearest(name, symbols))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_prefixes_symbols_and_rules_have_a_page() {
        for name in ["ldr", "TEX0", "CNST.", "P1IN", "t0301"] {
            assert!(explain(name, Language::En).is_ok(), "{name}");
        }
        assert_ne!(explain("TEX0", Language::En), explain("TEX0", Language::Cs));
    }

    #[test]
    fn an_unknown_name_gets_its_neighbour() {
        assert_eq!(explain("MECHBEGIN", Language::En), Err(Some("MECH_BEGIN")));
        assert_eq!(explain("QQQQQQQQ", Language::En), Err(None));
    }
}
