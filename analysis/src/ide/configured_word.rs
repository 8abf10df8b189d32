//! Words that the control gives a meaning to, in attributes of configuration files.

use crate::catalogue::Language;
use crate::catalogue::configuration::{
    ConfigurationPlace, ConfigurationWord, configuration_markdown, configuration_word,
};
use crate::configuration::document::{Document, Element};
use crate::configuration::schema::{self, ValueKind};
use crate::configuration::{ConfigKind, parse};
use crate::location::Position;

/// Help on the word at a position. Reads the text once more: only this question needs all of its attributes.
pub(super) fn hover(path: &str, text: &str, at: Position, language: Language) -> Option<super::Hover> {
    let kind = ConfigKind::of_path(path)?;
    let document = parse(text).ok()?;
    let (element, attribute) = document.elements.iter().find_map(|element| {
        let attribute = element.attributes.iter().find(|it| it.value.span.touches(at))?;
        Some((element, attribute))
    })?;
    let word = word(kind, &document, element, &attribute.name.text, attribute.value.text.trim())?;
    Some(super::Hover { markdown: configuration_markdown(word, language), span: attribute.value.span })
}

fn word(
    kind: ConfigKind,
    document: &Document,
    element: &Element,
    attribute: &str,
    value: &str,
) -> Option<&'static ConfigurationWord> {
    let parent = document.parent(element).map(|it| it.name.text.as_str());
    let spec = schema::element(kind, &element.name.text, parent)?.attribute(attribute)?;
    match (spec.value, element.name.text.as_str(), attribute) {
        (ValueKind::Named(names), ..) => names.word(value),
        (_, "HMIDevice", "DeviceType") => configuration_word(ConfigurationPlace::Panel, value),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::fixture;
    use crate::Language;

    fn hover(file: &str, text: &str, language: Language) -> String {
        let it = fixture(&format!("//- main.plc\nMODULE_MAIN\nMODULE_MAIN_END\n//- {file}\n{text}\n"));
        let found = it.analysis.hover(&it.file, it.at, language).expect("not cancelled");
        found.map_or_else(|| "nothing".to_owned(), |hover| hover.markdown)
    }

    fn key(attribute: &str) -> String {
        format!("<KeyboardConfig><KeyConfig ScanCode=\"0x6A\" {attribute}/></KeyboardConfig>")
    }

    #[test]
    fn a_word_of_a_button_shows_what_it_means() {
        let at = |attribute: &str| hover("a.KbdConfig", &key(attribute), Language::En);
        insta::assert_snapshot!(at("VirtualKey=\"VK_F<CURSOR>1\""), @"
        ### VK_F1

        Key of a PC: F1.

        - Value of `VirtualKey` in a `*.KbdConfig`
        - Manual chapter 11.3.3
        ");
        insta::assert_snapshot!(at("Command=\"ID_MMM_MAN<CURSOR>\""), @"
        ### ID_MMM_MAN

        Switches manual motion on.

        - Value of `Command` in a `*.KbdConfig`
        - Manual chapter 11.3.4
        ");
        let czech = hover("a.KbdConfig", &key("RtmCommand=\"<CURSOR>RTMID_MMM_SEL00\""), Language::Cs);
        insta::assert_snapshot!(czech, @"
        ### RTMID_MMM_SEL00

        Předvolí NC osu 00 pro ruční pohyb.

        - Hodnota atributu `RtmCommand` v souboru `*.KbdConfig`
        - Kapitola příručky 11.3.6
        ");
    }

    #[test]
    fn a_type_of_panel_shows_what_it_is() {
        let text = "<C><HMI><HMIDevice No=\"0\" DeviceType=\"Panel<CURSOR>Kla50\"/></HMI></C>";
        insta::assert_snapshot!(hover("a.ChannelConfig", text, Language::En), @"
        ### PanelKla50

        Panel on the CAN bus with up to 112 buttons and two wheels, at most four.

        - Type of a panel
        - Manual chapter 11.1
        ");
    }

    #[test]
    fn a_word_of_another_attribute_and_an_unknown_one_show_nothing() {
        for attribute in
            ["VirtualKey=\"ID_MMM<CURSOR>_MAN\"", "Command=\"ID_N<CURSOR>O\"", "Type=\"Mul<CURSOR>ti\""]
        {
            assert_eq!(hover("a.KbdConfig", &key(attribute), Language::En), "nothing", "{attribute}");
        }
    }
}
