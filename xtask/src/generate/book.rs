//! The language reference of the book: every page of the catalogue in both languages, one file a chapter, and the
//! diagnostics.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technol_analysis::Language;
use technol_analysis::catalogue::configuration::{
    ConfigurationWord, configuration_markdown, configuration_words,
};
use technol_analysis::catalogue::page::{markdown, symbol_markdown};
use technol_analysis::catalogue::{Entry, SystemSymbol, entries, symbols};
use technol_analysis::diagnostics::{self, RULES};

const FOLDER: &str = "docs/reference";
const NOTICE: &str = "<!-- Written by `cargo xtask generate` from the catalogue. -->\n";

/// The files, with their paths.
pub(super) fn pages() -> Vec<(String, String)> {
    let mut pages = vec![(format!("{FOLDER}/README.md"), index()), diagnostics_page()];
    for language in [Language::En, Language::Cs] {
        for (chapter, entries) in by_chapter(entries(), |entry| entry.chapter) {
            pages
                .push((path(language, "instructions", &chapter), instructions(&chapter, &entries, language)));
        }
        for (chapter, symbols) in by_chapter(symbols(), |symbol| symbol.chapter) {
            pages.push((path(language, "symbols", &chapter), symbol_pages(&chapter, &symbols, language)));
        }
        for (chapter, words) in by_chapter(configuration_words(), |word| word.chapter) {
            pages.push((path(language, "configuration", &chapter), word_pages(&chapter, &words, language)));
        }
    }
    pages
}

fn code(language: Language) -> &'static str {
    match language {
        Language::En => "en",
        Language::Cs => "cs",
    }
}

fn path(language: Language, what: &str, chapter: &str) -> String {
    format!("{FOLDER}/{}/{what}-{chapter}.md", code(language))
}

/// Chapters as numbers first, in their order, the others after them.
type Order = (u32, String);

fn by_chapter<T>(
    items: impl Iterator<Item = T>,
    chapter: impl Fn(&T) -> &'static str,
) -> Vec<(String, Vec<T>)> {
    let mut found: BTreeMap<Order, Vec<T>> = BTreeMap::new();
    for item in items {
        let name = chapter(&item).split(['.', ' ']).next().unwrap_or_default().to_lowercase();
        found.entry((name.parse().unwrap_or(u32::MAX), name)).or_default().push(item);
    }
    found.into_iter().map(|((_, name), items)| (name, items)).collect()
}

fn title(chapter: &str, language: Language) -> String {
    let number = chapter.parse::<u32>().is_ok();
    match (language, number) {
        (Language::En, true) => format!("chapter {chapter} of the manual"),
        (Language::Cs, true) => format!("kapitola {chapter} příručky"),
        (Language::En, false) => String::from("80386 instructions"),
        (Language::Cs, false) => String::from("instrukce 80386"),
    }
}

fn instructions(chapter: &str, entries: &[&'static Entry], language: Language) -> String {
    let head = match language {
        Language::En => "Instructions and keywords",
        Language::Cs => "Instrukce a klíčová slova",
    };
    let mut page = format!("{NOTICE}\n# {head}: {}\n", title(chapter, language));
    for entry in entries.iter().filter(|entry| !entry.is_known_only()) {
        let _ = write!(page, "\n{}", markdown(entry, language));
    }
    let known: Vec<String> = entries
        .iter()
        .filter(|entry| entry.is_known_only())
        .map(|entry| format!("`{}`", entry.name))
        .collect();
    if !known.is_empty() {
        let says = match language {
            Language::En => "Known by name only; a program that uses one cannot be built",
            Language::Cs => "Známé jen jménem; program, který některou použije, nelze přeložit",
        };
        let _ = write!(page, "\n{says}: {}.\n", known.join(", "));
    }
    page
}

fn symbol_pages(chapter: &str, symbols: &[&'static SystemSymbol], language: Language) -> String {
    let head = match language {
        Language::En => "Predefined symbols",
        Language::Cs => "Předdefinované symboly",
    };
    let mut page = format!("{NOTICE}\n# {head}: {}\n", title(chapter, language));
    for symbol in symbols {
        let _ = write!(page, "\n{}", symbol_markdown(symbol, language));
    }
    page
}

fn word_pages(chapter: &str, words: &[&'static ConfigurationWord], language: Language) -> String {
    let head = match language {
        Language::En => "Words of configuration files, dialogs and the registry",
        Language::Cs => "Slova konfiguračních souborů, dialogů a registru",
    };
    let mut page = format!("{NOTICE}\n# {head}: {}\n", title(chapter, language));
    for word in words {
        let _ = write!(page, "\n{}", configuration_markdown(word, language));
    }
    page
}

fn diagnostics_page() -> (String, String) {
    let mut page = format!("{NOTICE}\n# Diagnostics\n");
    for rule in RULES {
        let text = diagnostics::explain(rule.code).unwrap_or_default();
        let _ = write!(page, "\n#{text}");
    }
    (format!("{FOLDER}/diagnostics.md"), page)
}

fn index() -> String {
    let mut page = format!(
        "{NOTICE}\n# Language reference\n\nThe same pages are shown by hover in the editor and by `technol explain NAME`. \
         What the manual leaves open is marked \"(this implementation)\".\n\n\
         - [Diagnostics](diagnostics.md)\n"
    );
    for (language, name) in [(Language::En, "English"), (Language::Cs, "Česky")] {
        let _ = write!(page, "\n## {name}\n\n");
        for (chapter, _) in by_chapter(entries(), |entry| entry.chapter) {
            let link = format!("{}/instructions-{chapter}.md", code(language));
            let what = if language == Language::En { "Instructions" } else { "Instrukce" };
            let _ = writeln!(page, "- [{what}: {}]({link})", title(&chapter, language));
        }
        for (chapter, _) in by_chapter(symbols(), |symbol| symbol.chapter) {
            let link = format!("{}/symbols-{chapter}.md", code(language));
            let what = if language == Language::En { "Symbols" } else { "Symboly" };
            let _ = writeln!(page, "- [{what}: {}]({link})", title(&chapter, language));
        }
        for (chapter, _) in by_chapter(configuration_words(), |word| word.chapter) {
            let link = format!("{}/configuration-{chapter}.md", code(language));
            let what = if language == Language::En { "Configuration words" } else { "Slova konfigurace" };
            let _ = writeln!(page, "- [{what}: {}]({link})", title(&chapter, language));
        }
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_symbol_and_rule_is_in_the_book_in_both_languages() {
        let pages = pages();
        for language in [Language::En, Language::Cs] {
            let folder = format!("/{}/", code(language));
            let text: String = pages
                .iter()
                .filter(|(path, _)| path.contains(&folder))
                .map(|(_, text)| text.as_str())
                .collect();
            for entry in entries().filter(|entry| !entry.is_known_only()) {
                assert!(text.contains(&markdown(entry, language)), "{}", entry.name);
            }
            for symbol in symbols() {
                assert!(text.contains(&format!("### {}\n", symbol.spelling)), "{}", symbol.name);
            }
            for word in configuration_words() {
                assert!(text.contains(&configuration_markdown(word, language)), "{}", word.name);
            }
        }
        let rules = &pages.iter().find(|(path, _)| path.ends_with("diagnostics.md")).expect("a page").1;
        for rule in RULES {
            assert!(rules.contains(&format!("## {} {}", rule.code, rule.name)), "{}", rule.code);
        }
    }

    #[test]
    fn every_link_of_the_index_leads_to_a_page() {
        let pages = pages();
        for line in index().lines().filter(|line| line.starts_with("- [")) {
            let link = line.rsplit('(').next().unwrap_or_default().trim_end_matches(')');
            assert!(pages.iter().any(|(path, _)| *path == format!("{FOLDER}/{link}")), "{link}");
        }
    }
}
