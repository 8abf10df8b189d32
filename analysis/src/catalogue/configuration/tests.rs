//! The words are complete, unique in their places and described in both languages.

use std::collections::HashSet;

use super::ConfigurationPlace::{
    Command, Dialog, NcProgram, Panel, Registry, RtmCommand, SoftMenu, VirtualKey,
};
use super::*;

fn count(test: impl Fn(&ConfigurationWord) -> bool) -> usize {
    configuration_words().filter(|word| test(word)).count()
}

#[test]
fn every_list_has_as_many_words_as_the_manual() {
    assert_eq!(count(|word| word.place == VirtualKey), 196);
    assert_eq!(count(|word| word.place == Command), 300);
    // The list of the manual has 352; the text also describes function 0 held for each of the 8 keyboards.
    assert_eq!(count(|word| word.place == RtmCommand), 352 + 8);
    assert_eq!(count(|word| word.place == Panel), 6);
    assert_eq!(count(|word| matches!(word.place, Registry { .. })), 8 + 13 + 2 + 4);
    assert_eq!(count(|word| matches!(word.place, Dialog { .. })), 42);
    assert_eq!(count(|word| word.place == SoftMenu), 1);
    assert_eq!(count(|word| word.place == NcProgram), 2);
}

#[test]
fn families_have_every_number() {
    let all = |place, before: &str, numbers: std::ops::RangeInclusive<u32>, width: usize, after: &str| {
        for number in numbers {
            let name = format!("{before}{number:0width$}{after}");
            assert!(configuration_word(place, &name).is_some(), "{name}");
        }
    };
    all(VirtualKey, "VK_F", 1..=24, 1, "");
    all(VirtualKey, "VK_OEM_", 1..=8, 1, "");
    for side in ["TOP", "LEFT", "RIGHT", "BOTTOM"] {
        all(Command, &format!("ID_SM{side}_BTN"), 0..=15, 1, "");
    }
    all(Command, "ID_FILE_MRU_FILE", 1..=16, 1, "");
    all(Command, "ID_MMM_MOVE", 0..=15, 2, "NEG");
    for kind in ["M", "IM"] {
        for after in ["", "NEG", "RT", "NEGRT"] {
            all(RtmCommand, &format!("RTMID_{kind}MM_MOVE"), 0..=15, 2, after);
        }
    }
    for after in ["", "_TOGGLE", "_SWITCH"] {
        all(RtmCommand, "RTMID_KEYB", 0..=7, 1, &format!("_FUNCTION3{after}"));
    }
    for step in [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] {
        assert!(configuration_word(RtmCommand, &format!("RTMID_MMM_KNOB_STEP{step}")).is_some(), "{step}");
    }
}

#[test]
fn every_word_has_chapter_and_text_in_both_languages_and_is_unique_in_its_place() {
    let mut seen = HashSet::new();
    for word in configuration_words() {
        assert!(seen.insert((word.place, word.name.to_ascii_uppercase())), "{} twice", word.name);
        let Bilingual { en, cs } = word.summary;
        assert!(en.ends_with('.') && cs.ends_with('.'), "{}: {en} | {cs}", word.name);
        assert!(!en.contains(['{', '}']) && !cs.contains(['{', '}']), "{}: {en} | {cs}", word.name);
        assert!(!en.contains("  ") && !cs.contains("  "), "{}: {en} | {cs}", word.name);
        assert_ne!(en, cs, "{}", word.name);
        assert_eq!(
            en.contains("(this implementation)"),
            cs.contains("(tato implementace)"),
            "{}: a choice of this implementation is marked in both languages",
            word.name
        );
        assert!(!word.chapter.is_empty(), "{}", word.name);
    }
}

#[test]
fn no_word_of_a_panel_is_a_symbol_of_the_program() {
    for word in configuration_words().filter(|word| matches!(word.place, VirtualKey | Command | RtmCommand)) {
        assert!(crate::catalogue::symbol(word.name).is_none(), "{}", word.name);
        assert!(crate::catalogue::entry(word.name).is_none(), "{}", word.name);
    }
}

#[test]
fn look_up_ignores_case_and_keeps_the_places_apart() {
    assert_eq!(configuration_word(VirtualKey, "vk_escape").map(|word| word.name), Some("VK_ESCAPE"));
    assert!(configuration_word(Command, "VK_ESCAPE").is_none());
    assert!(configuration_word(VirtualKey, "VK_F25").is_none());
    assert_eq!(configuration_words_named("PlcTColID").count(), 2);
    assert_eq!(configuration_words_named("ČÁRA").count(), 0);
}

#[test]
fn a_page_tells_where_the_word_stands() {
    let page = |name: &str, language| {
        let word = configuration_words_named(name).next();
        word.map(|word| configuration_markdown(word, language)).unwrap_or_default()
    };
    insta::assert_snapshot!(page("RTMID_IMMM_MOVE03NEGRT", Language::En), @r"
    ### RTMID_IMMM_MOVE03NEGRT

    Moves NC axis 03 by hand in the negative direction at rapid traverse; chooses MAN at once.

    - Value of `RtmCommand` in a `*.KbdConfig`
    - Manual chapter 11.3.6
    ");
    insta::assert_snapshot!(page("RTMID_IMMM_MOVEZNEGX", Language::Cs), @r"
    ### RTMID_IMMM_MOVEZNEGX

    Ruční pohyb dvou geometrických os, Z v záporném a X v kladném směru; okamžitě zvolí MAN.

    - Hodnota atributu `RtmCommand` v souboru `*.KbdConfig`
    - Kapitola příručky 11.3.6
    ");
    insta::assert_snapshot!(page("EtherCATMasterCycleTime", Language::Cs), @r"
    ### EtherCATMasterCycleTime

    Cyklus masteru v µs.

    - Registr `HKLM\Software\MEFI\WinCNC\Machine\Common`
    - Implicitně `1000`
    - Kapitola příručky 26.1
    ");
}
