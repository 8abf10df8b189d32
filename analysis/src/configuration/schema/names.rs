//! Long lists of words, which the catalogue knows.

use crate::catalogue::configuration::{
    ConfigurationPlace, ConfigurationWord, configuration_word, configuration_words,
};

/// A list of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    /// Keys of a PC keyboard: `VK_…`.
    VirtualKey,
    /// Commands of the control: `ID_…`.
    Command,
    /// Commands of the real-time program: `RTMID_…`.
    RtmCommand,
}

impl Names {
    const fn place(self) -> ConfigurationPlace {
        match self {
            Names::VirtualKey => ConfigurationPlace::VirtualKey,
            Names::Command => ConfigurationPlace::Command,
            Names::RtmCommand => ConfigurationPlace::RtmCommand,
        }
    }

    /// All of them, in the order of the manual.
    pub fn words(self) -> impl Iterator<Item = &'static ConfigurationWord> {
        configuration_words().filter(move |word| word.place == self.place())
    }

    /// The word of exactly this spelling.
    #[must_use]
    pub fn word(self, name: &str) -> Option<&'static ConfigurationWord> {
        configuration_word(self.place(), name).filter(|word| word.name == name)
    }

    /// What they are.
    #[must_use]
    pub const fn what(self) -> &'static str {
        match self {
            Names::VirtualKey => "the name of a key, VK_…",
            Names::Command => "a command of the control, ID_…",
            Names::RtmCommand => "a command of the real-time program, RTMID_…",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lists_hold_what_panels_use() {
        for (list, name) in [
            (Names::VirtualKey, "VK_F24"),
            (Names::Command, "ID_MMM_MAN"),
            (Names::Command, "ID_SMRIGHT_BTN15"),
            (Names::RtmCommand, "RTMID_MMM_SEL00"),
            (Names::RtmCommand, "RTMID_IMMM_MOVE01"),
            (Names::RtmCommand, "RTMID_MMM_SHIFT_ACT"),
            (Names::RtmCommand, "RTMID_KEYB3_FUNCTION2_TOGGLE"),
        ] {
            assert_eq!(list.word(name).map(|word| word.name), Some(name));
        }
        assert_eq!(Names::VirtualKey.words().count(), 196);
        assert_eq!(Names::Command.words().count(), 300);
    }

    #[test]
    fn a_word_of_another_list_or_spelling_is_none() {
        assert_eq!(Names::Command.word("VK_F24"), None);
        assert_eq!(Names::VirtualKey.word("vk_f24"), None);
    }
}
