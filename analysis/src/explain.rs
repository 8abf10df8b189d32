//! The page of anything that has a name (an instruction, a symbol of the control, a configuration word, a rule), the list of them, and the
//! search in them.

use std::collections::BTreeSet;

use crate::catalogue::configuration::{
    ConfigurationWord, configuration_markdown, configuration_words, configuration_words_named,
};
use crate::catalogue::{self, EntryKind, Language, SystemSymbol};
use crate::diagnostics::{self, Rule};
use crate::semantics::suggest::nearest;

/// What has a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Topic {
    /// An instruction or declaration.
    Instruction,
    /// A directive, keyword, prefix, module or reserved procedure.
    Keyword,
    /// A predefined symbol.
    Symbol,
    /// A word of configuration files, dialogs or the registry.
    Configuration,
    /// A diagnostic.
    Rule,
}

/// A line of the list of pages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Title {
    /// What it is.
    pub topic: Topic,
    /// The name to ask for.
    pub name: String,
    /// Chapter of the manual; empty where it has none.
    pub chapter: &'static str,
    /// One sentence.
    pub summary: String,
}

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
    let words: Vec<String> =
        configuration_words_named(name).map(|word| configuration_markdown(word, language)).collect();
    if !words.is_empty() {
        return Ok(words.join("\n"));
    }
    diagnostics::explain(&name.to_ascii_uppercase()).ok_or_else(|| {
        let entries = catalogue::entries().map(|entry| entry.name);
        let rules = diagnostics::RULES.iter().map(|rule| rule.code);
        let symbols = catalogue::symbols().map(|symbol| symbol.name);
        let words = configuration_words().map(|word| word.name);
        nearest(name, entries.chain(rules)).or_else(|| nearest(name, symbols.chain(words)))
    })
}

/// Every page there is: instructions, keywords, symbols, configuration words, rules, each in the order of the manual.
/// A name that is spelled like another one before it is on the page of that one, or has none.
#[must_use]
pub fn titles(language: Language) -> Vec<Title> {
    let mut titles: Vec<Title> = catalogue::entries().map(|entry| of_entry(entry, language)).collect();
    titles.sort_by_key(|title| title.topic);
    titles.extend(catalogue::symbols().map(|symbol| of_symbol(symbol, language)));
    let mut taken = BTreeSet::new();
    let words = configuration_words().filter(|word| {
        let key = word.name.to_ascii_uppercase();
        let own = catalogue::entry(&key).is_none() && catalogue::symbol(&key).is_none();
        own && taken.insert(key)
    });
    titles.extend(words.map(|word| of_word(word, language)));
    titles.extend(diagnostics::RULES.iter().map(|rule| of_rule(rule)));
    titles
}

/// The pages that hold every one of the words, in any case and without regard to diacritics; those with all of them
/// in the name come first, then those with them in the summary.
#[must_use]
pub fn search(words: &str, language: Language) -> Vec<Title> {
    let words: Vec<String> = words.split_whitespace().map(plain).collect();
    if words.is_empty() {
        return Vec::new();
    }
    let holds = |text: &str| {
        let text = plain(text);
        words.iter().all(|word| text.contains(word.as_str()))
    };
    let mut found: Vec<(u8, Title)> = Vec::new();
    for title in titles(language) {
        let rank = if holds(&title.name) {
            0
        } else if holds(&format!("{} {}", title.name, title.summary)) {
            1
        } else if explain(&title.name, language).is_ok_and(|page| holds(&page)) {
            2
        } else {
            continue;
        };
        found.push((rank, title));
    }
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, title)| title).collect()
}

fn of_entry(entry: &catalogue::Entry, language: Language) -> Title {
    let topic = match entry.kind {
        EntryKind::Instruction | EntryKind::Declaration => Topic::Instruction,
        _ => Topic::Keyword,
    };
    let name =
        if entry.kind == EntryKind::TypePrefix { format!("{}.", entry.name) } else { entry.name.to_owned() };
    Title { topic, name, chapter: entry.chapter, summary: entry.summary.in_language(language).to_owned() }
}

fn of_symbol(symbol: &SystemSymbol, language: Language) -> Title {
    Title {
        topic: Topic::Symbol,
        name: symbol.spelling.to_owned(),
        chapter: symbol.chapter,
        summary: symbol.summary.in_language(language).to_owned(),
    }
}

fn of_word(word: &ConfigurationWord, language: Language) -> Title {
    Title {
        topic: Topic::Configuration,
        name: word.name.to_owned(),
        chapter: word.chapter,
        summary: word.summary.in_language(language).to_owned(),
    }
}

fn of_rule(rule: &Rule) -> Title {
    let first = rule.explanation.split_inclusive(". ").next().unwrap_or_default();
    Title {
        topic: Topic::Rule,
        name: rule.code.to_owned(),
        chapter: rule.chapter,
        summary: format!("{}: {}", rule.name, first.trim_end()),
    }
}

/// Lower case, Czech letters without their marks.
fn plain(text: &str) -> String {
    text.chars()
        .flat_map(char::to_lowercase)
        .map(|c| match c {
            'á' => 'a',
            'č' => 'c',
            'ď' => 'd',
            'é' | 'ě' => 'e',
            'í' => 'i',
            'ň' => 'n',
            'ó' => 'o',
            'ř' => 'r',
            'š' => 's',
            'ť' => 't',
            'ú' | 'ů' => 'u',
            'ý' => 'y',
            'ž' => 'z',
            other => other,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_prefixes_symbols_and_rules_have_a_page() {
        for name in ["ldr", "TEX0", "CNST.", "P1IN", "t0301", "vk_f1"] {
            assert!(explain(name, Language::En).is_ok(), "{name}");
        }
        assert_ne!(explain("TEX0", Language::En), explain("TEX0", Language::Cs));
    }

    #[test]
    fn an_unknown_name_gets_its_neighbour() {
        assert_eq!(explain("MECHBEGIN", Language::En), Err(Some("MECH_BEGIN")));
        assert_eq!(explain("QQQQQQQQ", Language::En), Err(None));
    }

    #[test]
    fn every_title_leads_to_a_page() {
        for title in titles(Language::Cs) {
            assert!(explain(&title.name, Language::Cs).is_ok(), "{}", title.name);
            assert!(!title.summary.is_empty(), "{}", title.name);
        }
    }

    #[test]
    fn a_search_needs_all_words_and_puts_names_first() {
        let names = |words: &str, language| -> Vec<String> {
            search(words, language).into_iter().map(|title| title.name).collect()
        };
        assert_eq!(names("mech_begin", Language::En)[0], "MECH_BEGIN");
        let timeouts = names("time mechanism", Language::En);
        assert!(timeouts.contains(&"TEX0".to_owned()), "{timeouts:?}");
        assert!(!timeouts.contains(&"STRCPY".to_owned()), "{timeouts:?}");
        assert_eq!(names("rizeni hlaseni", Language::Cs), names("řízení HLÁŠENÍ", Language::Cs));
        assert!(names("hlaseni", Language::Cs).contains(&"ESET".to_owned()));
        assert!(names("qqqqqq", Language::En).is_empty() && names("  ", Language::En).is_empty());
        assert_eq!(names("t0301", Language::En)[0], "T0301");
    }
}
