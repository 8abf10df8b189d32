//! Writes the words and texts of a pattern.

use super::{ConfigurationPlace, ConfigurationWord};
use crate::catalogue::entry::Bilingual;

/// Pattern of the names, text in English and in Czech.
///
/// In a pattern `{a|b}` is a choice of texts and `{00-15}` of numbers as wide as the first; in a text `{n}` is what
/// the n-th brace of the pattern chose and `{n:x|y}` the x or y that belongs to the choice.
pub(super) type Row = (&'static str, &'static str, &'static str);

/// The text that a choice stands for and its number among the choices.
type Choice = (String, usize);

/// Adds the words of the rows.
pub(super) fn list(
    rows: &'static [Row],
    place: ConfigurationPlace,
    chapter: &'static str,
    words: &mut Vec<ConfigurationWord>,
) {
    for (pattern, en, cs) in rows {
        words.extend(names(pattern).into_iter().map(|(name, choices)| ConfigurationWord {
            name: kept(name),
            place,
            default: "",
            summary: Bilingual { en: kept(filled(en, &choices)), cs: kept(filled(cs, &choices)) },
            chapter,
        }));
    }
}

/// The table is built once and lives as long as the process.
fn kept(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

/// Every name of a pattern with what its braces chose.
fn names(pattern: &str) -> Vec<(String, Vec<Choice>)> {
    let mut parts = pattern.split('{');
    let mut done = vec![(parts.next().unwrap_or_default().to_owned(), Vec::new())];
    for part in parts {
        let (choices, rest) = part.split_once('}').unwrap_or((part, ""));
        let texts = texts(choices);
        done = done
            .iter()
            .flat_map(|(head, chosen)| {
                texts.iter().enumerate().map(move |(index, text)| {
                    let mut chosen = chosen.clone();
                    chosen.push((text.clone(), index));
                    (format!("{head}{text}{rest}"), chosen)
                })
            })
            .collect();
    }
    done
}

fn texts(choices: &str) -> Vec<String> {
    let range = choices
        .split_once('-')
        .and_then(|(first, last)| Some((first.len(), first.parse::<u32>().ok()?, last.parse::<u32>().ok()?)));
    match range {
        Some((width, first, last)) => (first..=last).map(|number| format!("{number:0width$}")).collect(),
        None => choices.split('|').map(str::to_owned).collect(),
    }
}

/// The text with its braces replaced; one that names no choice stays as it is, so that the tests see it.
fn filled(template: &str, choices: &[Choice]) -> String {
    let mut parts = template.split('{');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (reference, rest) = part.split_once('}').unwrap_or((part, ""));
        match meaning(reference, choices) {
            Some(meaning) => text.push_str(meaning),
            None => text.extend(["{", reference, "}"]),
        }
        text.push_str(rest);
    }
    text
}

fn meaning<'text>(reference: &'text str, choices: &'text [Choice]) -> Option<&'text str> {
    let (number, meanings) = match reference.split_once(':') {
        Some((number, meanings)) => (number, Some(meanings)),
        None => (reference, None),
    };
    let (text, index) = choices.get(number.parse::<usize>().ok()?.checked_sub(1)?)?;
    match meanings {
        Some(meanings) => meanings.split('|').nth(*index),
        None => Some(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_gives_every_choice_and_its_meaning() {
        let found: Vec<_> = names("M{8-10}{|N}")
            .into_iter()
            .map(|(name, choices)| format!("{name} {}", filled("{1}{2:+|-}.", &choices)))
            .collect();
        assert_eq!(found, ["M8 8+.", "M8N 8-.", "M9 9+.", "M9N 9-.", "M10 10+.", "M10N 10-."]);
        let padded: Vec<_> = names("{00-02}").into_iter().map(|(name, _)| name).collect();
        assert_eq!(padded, ["00", "01", "02"]);
    }

    #[test]
    fn a_text_that_names_no_choice_shows_it() {
        assert_eq!(filled("{1} {0} {2:a|b}", &[("A".to_owned(), 5)]), "A {0} {2:a|b}");
        assert_eq!(filled("{1:a|b}", &[("A".to_owned(), 5)]), "{1:a|b}");
    }
}
