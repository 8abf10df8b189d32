//! Logical elements: whole tables, identifiers as configurations write them.

use std::collections::HashSet;

use super::*;
use crate::catalogue;

const CZECH: &str = "áčďéěíňóřšťúůýžÁČĎÉĚÍŇÓŘŠŤÚŮÝŽ";

fn element(identifier: &str) -> &'static LogicalElement {
    match find(identifier) {
        Found::Element { element, .. } => element,
        other => panic!("{identifier}: {other:?}"),
    }
}

fn variable(name: &str) -> &'static LogicalElement {
    match find_screen_variable(name) {
        Found::Element { element, .. } => element,
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn every_line_of_the_tables_is_well_formed() {
    for text in [include_str!("elements.txt"), include_str!("shared.txt")] {
        for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with(';')) {
            assert!(table::row(line, "").is_some_and(|elements| !elements.is_empty()), "{line}");
        }
    }
    for line in ["A | BIT | | | | | No Czech", "A | BOOL | | | | | a | b", "A{1..x} | BIT | | | | | a | b"] {
        assert!(table::row(line, "").is_none(), "{line}");
    }
}

#[test]
fn the_tables_hold_what_the_manual_lists() {
    // 214 real-time elements, seven bytes of INOUT08 and the virtual keyboard.
    assert_eq!(logical_elements().count(), 214 + 7 + 1);
    // 290 further variables, the structures of 32 corrections, and those of chapter 20.
    assert_eq!(screen_variables().count(), 290 + 32 + 16 + 16 + 1);
}

#[test]
fn texts_are_sentences_in_both_languages_and_identifiers_unique() {
    let mut seen = HashSet::new();
    for element in logical_elements().chain(screen_variables()) {
        let Bilingual { en, cs } = element.summary;
        assert!(seen.insert(element.identifier), "{} twice", element.identifier);
        assert!(en.ends_with('.') && cs.ends_with('.') && en != cs, "{}: {en} | {cs}", element.identifier);
        assert!(!en.chars().any(|letter| CZECH.contains(letter)), "{}: {en}", element.identifier);
        for text in [element.identifier, element.symbol, en, cs] {
            assert!(!text.contains(['{', '}', '|']), "{}: {text}", element.identifier);
        }
        assert!(element.len != Some(0), "{}", element.identifier);
        assert_eq!(element.len == Some(1), !element.identifier.contains("[#]"), "{}", element.identifier);
    }
}

#[test]
fn the_symbol_of_the_program_exists() {
    for element in logical_elements().chain(screen_variables()).filter(|element| !element.symbol.is_empty()) {
        let name = element.symbol.replace('x', "X");
        assert!(catalogue::symbol(&name).is_some(), "{}: {name}", element.identifier);
    }
}

#[test]
fn case_prefix_and_zero_indices_do_not_matter() {
    let same = ["RTM.Axis[2].Pos0_Ax", "CNC.rtm.AXIS[02].pos0_ax", " RTM.Axis[2].Pos0_Ax "];
    for identifier in same {
        assert_eq!(element(identifier).identifier, "RTM.Axis[#].Pos0_Ax");
    }
    assert_eq!(element("RTM.Axis.Pos0_Ax").identifier, "RTM.Axis[#].Pos0_Ax");
    assert_eq!(element("RTM.Axis[0].Distanc").identifier, "RTM.Axis.Distanc");
    assert_eq!(element("RTM.Control.M43").symbol, "M43PI");
    assert_eq!(element("RTM.Servo[15].Edrv.DrivePos").flow, Flow::Destination);
    assert_eq!(element("can[1].inout08[3].op2").flow, Flow::Destination);
    assert_eq!(element("VKeyboard.VKey[255]").element, ElementType::Bit);
}

#[test]
fn indices_outside_the_element_are_told() {
    for (identifier, wrong) in [
        ("RTM.Axis[16].Pos0_Ax", 16),
        ("RTM.Axis[1].Distanc", 1),
        ("RTM.Man.ManMovePlus_Ax[6]", 6),
        ("CAN[2].INOUT08[1].IP0", 2),
        ("CAN.INOUT08[1].IP0", 0),
        ("VKeyboard.VKey[256]", 256),
    ] {
        assert!(
            matches!(find(identifier), Found::WrongIndex { index, .. } if index == wrong),
            "{identifier}: {:?}",
            find(identifier)
        );
    }
}

#[test]
fn a_bit_of_an_integer_is_chosen_by_its_number() {
    let bit = |identifier: &str| match find(identifier) {
        Found::Element { bit, .. } => bit,
        other => panic!("{identifier}: {other:?}"),
    };
    assert_eq!(bit("CAN[1].INOUT08[1].IP3.Bit[7]"), Some(7));
    assert_eq!(bit("CAN[1].INOUT08[1].IP3.Bit"), Some(0));
    assert_eq!(bit("RTM.Servo[3].Edrv.DriveStatus.bit15"), Some(15));
    for wrong in ["CAN[1].INOUT08[1].IP3.Bit[8]", "RTM.Axis[1].Pos0_Ax.Bit[0]", "RTM.Control.M03.Bit[0]"] {
        assert!(matches!(find(wrong), Found::WrongBit { .. }), "{wrong}");
    }
}

#[test]
fn names_of_the_program_and_of_ethercat_are_left_to_them() {
    for (identifier, group, name) in [
        ("PLC.Input.Door.Closed[2]", OpenGroup::Input, "Door.Closed[2]"),
        ("cnc.plc.output.Lamp", OpenGroup::Output, "Lamp"),
        ("ECAT.Drive 1.Inputs.Status word", OpenGroup::EtherCat, "Drive 1.Inputs.Status word"),
    ] {
        assert_eq!(find(identifier), Found::Open { group, name });
    }
}

#[test]
fn what_is_no_element_is_unknown() {
    for identifier in [
        "",
        ".",
        "RTM",
        "RTM.Axis",
        "RTM.Axis[x].Pos0_Ax",
        "RTM.Axis[1.Pos0_Ax",
        "RTM.Axis[-1].Pos0_Ax",
        "PLC.Input",
        "RTM.Axis[99999999999].Pos0_Ax",
        "VKeyboard",
        "[1]",
        "RTM..M03",
        "Žádný.prvek",
        "Bit[1]",
    ] {
        assert_eq!(find(identifier), Found::Unknown, "{identifier}");
    }
    assert_eq!(find(&"A.".repeat(1000)), Found::Unknown);
}

#[test]
fn screens_read_variables_items_and_elements_by_their_last_part() {
    assert_eq!(variable("Pos0_Ax[3]").identifier, "RTM.Axis[#].Pos0_Ax");
    assert_eq!(variable("RTM.Servo[3].Edrv.State").identifier, "RTM.Servo[#].Edrv.State");
    assert_eq!(variable("InputOutput_CAN2_7.INOUT_IN3[7]").identifier, "<INOUTS>.INOUT_IN3[#]");
    assert_eq!(variable("DriveStatus_CAN1[4].CAN_AX_READY").element, ElementType::Bit);
    assert_eq!(variable("ActualBlock_Flags.FirstBlock").element, ElementType::Bit);
    assert_eq!(variable("KnobSelAx15").len, Some(1));
    assert!(matches!(find_screen_variable("Pos0_Ax[16]"), Found::WrongIndex { index: 16, .. }));
    assert_eq!(find_screen_variable("BlockRestart"), Found::Unknown);
    assert_eq!(find_screen_variable("PotControl_PotF.INOUT_MODE"), Found::Unknown);
}

#[test]
fn the_help_names_type_unit_symbol_and_direction() {
    let page = element_markdown(element("RTM.Control.FeedOvrMultiplier"), Language::En);
    assert!(page.contains("UNS16, ‰") && page.contains("`FEED_OVR_MULTIPLIER`"), "{page}");
    let page = element_markdown(element("CAN[1].INOUT08.IP0"), Language::Cs);
    assert!(page.contains("32 × UNS8") && page.contains("Zdroj spoje") && page.contains("FAST"), "{page}");
    assert_eq!(element("VKeyboard.VKey[1]").fastest_period(), Some("SLOW"));
    assert_eq!(variable("InputPort[19]").fastest_period(), None);
}
