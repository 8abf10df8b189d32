//! Words that stand only in configuration: keys and commands of `*.KbdConfig` files, types of panels, names in the
//! registry and in HTML dialogs, parameters of NC programs (manual 11, 17, 23, 25 and 26).
//!
//! They are no symbols of the program. The long lists are patterns: `MOVE{00-15}{|NEG}` stands for every choice of
//! its braces, and `{2:positive|negative}` in the text for what the second choice means.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::Language;
use super::entry::Bilingual;

mod commands;
mod control;
mod dialogs;
mod expand;
mod keys;
mod realtime;
#[cfg(test)]
mod tests;

/// Where a word stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ConfigurationPlace {
    /// Value of the attribute `VirtualKey` in a `*.KbdConfig`.
    VirtualKey,
    /// Value of the attribute `Command` in a `*.KbdConfig`.
    Command,
    /// Value of the attribute `RtmCommand` in a `*.KbdConfig`.
    RtmCommand,
    /// A type of panels; all but EPU are values of `DeviceType` of an `HMIDevice`.
    Panel,
    /// A key or value in the registry.
    Registry {
        /// The key it stands in.
        key: &'static str,
    },
    /// A word in an HTML dialog.
    Dialog {
        /// Element it stands in, and its attribute when the word is a value.
        element: &'static str,
    },
    /// An element of a `*.SoftMenu`.
    SoftMenu,
    /// A parameter in an NC program.
    NcProgram,
}

/// A word of the configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConfigurationWord {
    /// Its spelling.
    pub name: &'static str,
    /// Where it stands.
    pub place: ConfigurationPlace,
    /// Value when it is left out; empty when the manual names none.
    pub default: &'static str,
    /// What it means.
    pub summary: Bilingual,
    /// Manual chapter.
    pub chapter: &'static str,
}

struct Table {
    words: Vec<ConfigurationWord>,
    /// By name in upper case; a dialog uses some names in several elements.
    by_name: HashMap<String, Vec<usize>>,
}

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    let mut words = Vec::new();
    expand::list(keys::ROWS, ConfigurationPlace::VirtualKey, "11.3.3", &mut words);
    expand::list(commands::ROWS, ConfigurationPlace::Command, "11.3.4", &mut words);
    expand::list(realtime::ROWS, ConfigurationPlace::RtmCommand, "11.3.6", &mut words);
    control::list(&mut words);
    let mut by_name: HashMap<String, Vec<usize>> = HashMap::new();
    for (index, word) in words.iter().enumerate() {
        by_name.entry(word.name.to_ascii_uppercase()).or_default().push(index);
    }
    Table { words, by_name }
});

/// Every word, in the order of the manual within each place.
pub fn configuration_words() -> impl Iterator<Item = &'static ConfigurationWord> {
    TABLE.words.iter()
}

/// The words called `name`, in any case.
pub fn configuration_words_named(name: &str) -> impl Iterator<Item = &'static ConfigurationWord> {
    let found = TABLE.by_name.get(&name.to_ascii_uppercase());
    found.into_iter().flatten().map(|&index| &TABLE.words[index])
}

/// The word `name` that stands in `place`, in any case.
#[must_use]
pub fn configuration_word(place: ConfigurationPlace, name: &str) -> Option<&'static ConfigurationWord> {
    configuration_words_named(name).find(|word| word.place == place)
}

/// The page of a word, as Markdown.
#[must_use]
pub fn configuration_markdown(word: &ConfigurationWord, language: Language) -> String {
    let say = |en, cs| Bilingual { en, cs }.in_language(language);
    let place = match word.place {
        ConfigurationPlace::VirtualKey => value_of("VirtualKey", language),
        ConfigurationPlace::Command => value_of("Command", language),
        ConfigurationPlace::RtmCommand => value_of("RtmCommand", language),
        ConfigurationPlace::Panel => say("Type of a panel", "Typ panelu").to_owned(),
        ConfigurationPlace::Registry { key } => format!("{} `{key}`", say("Registry", "Registr")),
        ConfigurationPlace::Dialog { element } => {
            format!("{} `{element}`", say("HTML dialog", "Dialog HTML"))
        }
        ConfigurationPlace::SoftMenu => {
            say("Element of a `*.SoftMenu`", "Prvek souboru `*.SoftMenu`").to_owned()
        }
        ConfigurationPlace::NcProgram => say("Parameter of an NC program", "Parametr NC programu").to_owned(),
    };
    let default = match word.default {
        "" => String::new(),
        value => format!("\n- {} `{value}`", say("Default", "Implicitně")),
    };
    format!(
        "### {}\n\n{}\n\n- {place}{default}\n- {} {}\n",
        word.name,
        word.summary.in_language(language),
        say("Manual chapter", "Kapitola příručky"),
        word.chapter
    )
}

fn value_of(attribute: &str, language: Language) -> String {
    match language {
        Language::En => format!("Value of `{attribute}` in a `*.KbdConfig`"),
        Language::Cs => format!("Hodnota atributu `{attribute}` v souboru `*.KbdConfig`"),
    }
}
