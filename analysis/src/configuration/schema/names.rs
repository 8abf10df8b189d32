//! Long lists of names.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use super::keys;

/// A list of names.
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
    /// All of them.
    #[must_use]
    pub fn all(self) -> &'static BTreeSet<String> {
        static VIRTUAL_KEYS: LazyLock<BTreeSet<String>> = LazyLock::new(|| expanded(keys::VIRTUAL_KEYS));
        static COMMANDS: LazyLock<BTreeSet<String>> = LazyLock::new(|| expanded(keys::COMMANDS));
        static RTM_COMMANDS: LazyLock<BTreeSet<String>> = LazyLock::new(|| expanded(keys::RTM_COMMANDS));
        match self {
            Names::VirtualKey => &VIRTUAL_KEYS,
            Names::Command => &COMMANDS,
            Names::RtmCommand => &RTM_COMMANDS,
        }
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

fn expanded(patterns: &[&str]) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    for word in patterns.iter().flat_map(|line| line.split_whitespace()) {
        all.extend(expand(word));
    }
    all
}

/// `A{0-2}` and `A{|B}`: each choice of the braces, numbers as wide as the first.
fn expand(pattern: &str) -> Vec<String> {
    let mut done = vec![String::new()];
    for part in pattern.split('{') {
        let (choices, rest) = match part.split_once('}') {
            Some((choices, rest)) => (choices_of(choices), rest),
            None => (vec![String::new()], part),
        };
        done = done
            .iter()
            .flat_map(|head| choices.iter().map(move |choice| format!("{head}{choice}{rest}")))
            .collect();
    }
    done
}

fn choices_of(text: &str) -> Vec<String> {
    let range = text
        .split_once('-')
        .and_then(|(first, last)| Some((first.len(), first.parse::<u32>().ok()?, last.parse::<u32>().ok()?)));
    match range {
        Some((width, first, last)) => (first..=last).map(|number| format!("{number:0width$}")).collect(),
        None => text.split('|').map(str::to_string).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braces_stand_for_each_of_their_choices() {
        assert_eq!(expand("A"), ["A"]);
        assert_eq!(expand("A{8-11}B"), ["A8B", "A9B", "A10B", "A11B"]);
        assert_eq!(
            expand("{|I}M{00-01}{|N}"),
            ["M00", "M00N", "M01", "M01N", "IM00", "IM00N", "IM01", "IM01N"]
        );
    }

    #[test]
    fn the_lists_hold_what_panels_use() {
        assert!(Names::VirtualKey.all().contains("VK_F24"));
        assert!(Names::Command.all().contains("ID_MMM_MAN"));
        assert!(Names::Command.all().contains("ID_SMRIGHT_BTN15"));
        for name in
            ["RTMID_MMM_SEL00", "RTMID_IMMM_MOVE01", "RTMID_MMM_SHIFT_ACT", "RTMID_KEYB3_FUNCTION2_TOGGLE"]
        {
            assert!(Names::RtmCommand.all().contains(name), "{name}");
        }
        assert_eq!(Names::VirtualKey.all().len(), 196);
        assert_eq!(Names::Command.all().len(), 300);
    }
}
