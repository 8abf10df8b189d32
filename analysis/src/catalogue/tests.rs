//! The catalogue as a whole: well-formed entries, whole families, addresses that do not collide.

use std::collections::{HashMap, HashSet};

use technol_image::system;

use super::*;

const CZECH: &str = "áčďéěíňóřšťúůýžÁČĎÉĚÍŇÓŘŠŤÚŮÝŽ";

fn has_diacritics(text: &str) -> bool {
    text.chars().any(|letter| CZECH.contains(letter))
}

#[test]
fn names_are_unique_upper_case_and_short_enough_to_be_keys() {
    let mut seen = HashSet::new();
    for entry in entries() {
        assert!(seen.insert(entry.name), "{} twice", entry.name);
        assert_eq!(entry.name, entry.name.to_ascii_uppercase());
        assert!(!entry.name.is_empty() && entry.name.len() <= 31, "{}", entry.name);
    }
}

#[test]
fn every_entry_has_chapter_and_summary_in_both_languages() {
    for entry in entries() {
        assert!(!entry.chapter.is_empty(), "{}", entry.name);
        let Bilingual { en, cs } = entry.summary;
        assert!(en.ends_with('.') && cs.ends_with('.'), "{}: {en} | {cs}", entry.name);
        assert_ne!(en, cs, "{}", entry.name);
        assert!(!has_diacritics(en), "{}: {en}", entry.name);
    }
}

#[test]
fn every_operand_has_help_and_only_the_last_is_repeatable() {
    for entry in entries() {
        for (index, operand) in entry.operands.iter().enumerate() {
            assert!(!operand.help.en.is_empty() && !operand.help.cs.is_empty(), "{}", entry.name);
            assert!(!operand.repeatable || index + 1 == entry.operands.len(), "{}", entry.name);
        }
        let optional = entry.operands.iter().position(|operand| operand.optional);
        if let Some(first) = optional {
            assert!(entry.operands[first..].iter().all(|operand| operand.optional), "{}", entry.name);
        }
    }
}

#[test]
fn related_entries_exist_and_are_not_the_entry_itself() {
    for entry in entries() {
        for related in entry.related {
            assert!(super::entry(related).is_some(), "{} names {related}", entry.name);
            assert_ne!(*related, entry.name);
        }
    }
}

#[test]
fn every_entry_is_described_in_both_languages_with_examples() {
    for entry in entries() {
        let name = entry.name;
        let Bilingual { en, cs } = entry.description;
        assert!(!en.is_empty() && !has_diacritics(en), "{name}: {en}");
        assert!(has_diacritics(cs), "{name}: {cs}");
        assert!(entry.is_known_only() || !entry.examples.is_empty(), "{name}");
        assert!(entry.is_known_only() || !entry.related.is_empty(), "{name}");
        assert!(!entry.forms.is_empty() || entry.is_known_only(), "{name}");
    }
}

#[test]
fn what_this_implementation_chose_is_marked_in_both_languages() {
    for entry in entries() {
        for Bilingual { en, cs } in [entry.summary, entry.description, entry.errors] {
            assert_eq!(
                en.matches("(this implementation").count(),
                cs.matches("(tato implementace").count(),
                "{}: {en} | {cs}",
                entry.name
            );
        }
    }
}

#[test]
fn errors_are_told_in_both_languages_or_not_at_all() {
    for entry in entries() {
        let Bilingual { en, cs } = entry.errors;
        assert_eq!(en.is_empty(), cs.is_empty(), "{}", entry.name);
        assert!(!has_diacritics(en), "{}: {en}", entry.name);
        assert!(en.is_empty() || (en.ends_with('.') && cs.ends_with('.')), "{}: {en} | {cs}", entry.name);
    }
}

#[test]
fn examples_have_a_note_in_both_languages() {
    for entry in entries() {
        for Example { code, note: Bilingual { en, cs } } in entry.examples {
            assert!(en.ends_with('.') && cs.ends_with('.') && en != cs, "{}: {en} | {cs}", entry.name);
            assert!(!has_diacritics(en), "{}: {en}", entry.name);
            assert!(!code.contains('\t') && !code.ends_with('\n'), "{}: {code}", entry.name);
        }
    }
}

/// Every kind of operand an entry takes, those inside alternatives too.
fn kinds(entry: &Entry) -> Vec<OperandKind> {
    fn flat(kind: OperandKind, all: &mut Vec<OperandKind>) {
        match kind {
            OperandKind::OneOf(kinds) => kinds.iter().for_each(|kind| flat(*kind, all)),
            kind => all.push(kind),
        }
    }
    let mut all = Vec::new();
    entry.operands.iter().for_each(|operand| flat(operand.kind, &mut all));
    all
}

#[test]
fn only_instructions_of_the_80386_take_anything() {
    for entry in entries().filter(|entry| entry.chapter != assembler::CHAPTER) {
        assert!(!kinds(entry).contains(&OperandKind::Any), "{}", entry.name);
    }
}

#[test]
fn alternatives_are_several_and_not_nested() {
    for entry in entries() {
        for operand in entry.operands {
            if let OperandKind::OneOf(kinds) = operand.kind {
                assert!(kinds.len() > 1, "{}: {}", entry.name, operand.name);
                let nested = kinds.iter().any(|kind| matches!(kind, OperandKind::OneOf(_)));
                assert!(!nested, "{}: {}", entry.name, operand.name);
            }
        }
    }
}

#[test]
fn operands_of_one_entry_have_different_names() {
    for entry in entries() {
        let mut seen = HashSet::new();
        for operand in entry.operands {
            assert!(seen.insert(operand.name), "{}: {} twice", entry.name, operand.name);
        }
    }
}

/// Whether `word` stands in the text by itself.
fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '?'))).any(|it| it == word)
}

/// A word that stands as an operand has a page of its own, is a predefined symbol or a member of INOUTS, or the page
/// of its instruction tells what it means.
#[test]
fn keywords_of_operands_are_known_or_described_where_they_stand() {
    let mut unknown = Vec::new();
    for entry in entries() {
        for kind in kinds(entry) {
            let (OperandKind::Keyword(words) | OperandKind::KeywordOrNumber(words, ..)) = kind else {
                continue;
            };
            for word in words {
                let key = word.to_ascii_uppercase();
                let known =
                    super::entry(&key).is_some() || symbol(&key).is_some() || unit_member(&key).is_some();
                let told = |Bilingual { en, cs }: Bilingual| has_word(en, word) && has_word(cs, word);
                let described = told(entry.description) || entry.operands.iter().any(|it| told(it.help));
                if !known && !described {
                    unknown.push(format!("{}: {word}", entry.name));
                }
            }
        }
    }
    assert!(unknown.is_empty(), "{unknown:#?}");
}

/// Words that stand behind the name they declare.
const STRUCTURE_WORDS: &[&str] = &["STRUC", "ENDS", "DB", "DW", "DD", "DQ"];

#[test]
fn examples_use_the_entry_they_stand_at_and_only_known_mnemonics() {
    for entry in entries() {
        for example in entry.examples {
            let upper = example.code.to_ascii_uppercase();
            assert!(upper.contains(entry.name), "{}: {}", entry.name, example.code);
            for line in example.code.lines() {
                let code = line.rsplit(':').next().unwrap_or(line);
                // The lines of a structure begin with a name: `TOOLDATA STRUC`, `TOOL_NO DW ?`.
                let known = |word: &str| super::entry(word).is_some();
                let mut words = code.split_whitespace();
                if let Some(first) = words.next() {
                    let second = words.next().filter(|word| STRUCTURE_WORDS.contains(word));
                    assert!(known(first) || second.is_some_and(known), "{}: {line}", entry.name);
                }
            }
        }
    }
}

#[test]
fn terminal_instructions_are_those_of_the_ruling() {
    let expected: HashSet<&str> = [
        "WR", "JL0", "JL1", "STO0", "STO1", "FL1", "MOVR1", "MOVE1", "ESET1", "CONRD", "EX", "EX0", "EX1",
        "BEX", "TEX0", "TEX1", "TIM",
    ]
    .into();
    let found: HashSet<&str> =
        entries().filter(|entry| entry.equation == Equation::Terminal).map(|entry| entry.name).collect();
    assert_eq!(found, expected);
}

#[test]
fn instructions_that_write_rlo_take_part_in_the_equation() {
    for entry in entries().filter(|entry| entry.writes.contains(&Effect::Rlo)) {
        assert!(entry.equation != Equation::None || entry.name == "PROC_CALL", "{}", entry.name);
    }
}

#[test]
fn ex_type_instructions_stand_only_in_sequences() {
    for entry in entries() {
        assert_eq!(entry.ex_type, entry.place == Place::Sequence, "{}", entry.name);
    }
}

#[test]
fn look_up_ignores_case_and_finds_nothing_else() {
    assert_eq!(entry("ldr").map(|entry| entry.name), Some("LDR"));
    assert_eq!(entry("_on_eset").map(|entry| entry.name), Some("_ON_ESET"));
    assert!(entry("LDRX").is_none());
    assert!(entry("").is_none());
    assert!(entry(&"A".repeat(1000)).is_none());
    assert!(entry("ČÁRA").is_none());
    assert_eq!(symbol("p1in").map(|symbol| symbol.name), Some("P1IN"));
    assert_eq!(symbol("DWAXNCFEED").map(|symbol| symbol.spelling), Some("dwAxNcFeed"));
    assert!(symbol("P0IN").is_none());
    assert!(symbol("P96OUT").is_none());
}

#[test]
fn prefixes_are_found_in_any_case_and_the_misspelling_is_told() {
    for expected in Prefix::ALL {
        let found = prefix(&expected.name().to_ascii_lowercase());
        assert_eq!(found, Some(PrefixSpelling { prefix: expected, misspelled: false }));
        assert!(entry(expected.name()).is_some(), "{}", expected.name());
    }
    assert_eq!(prefix("Cnts"), Some(PrefixSpelling { prefix: Prefix::Cnst, misspelled: true }));
    assert_eq!(prefix("DWORD"), None);
    assert!(is_keyword("nil") && is_keyword("BX") && is_keyword("cnts"));
    assert!(!is_keyword("LDR") && !is_keyword("P1IN"));
    // Words of a few instructions are free names.
    assert!(!is_keyword("FAST") && !is_keyword("TYPE_WORD"));
}

#[test]
fn families_of_ports_are_complete_and_at_their_places() {
    for (before, first, count, after, base) in [
        ("P", 1, 128, "IN", system::IN_PORTS),
        ("P", 0, 96, "OUT", system::OUT_PORTS),
        ("SETL_P", 1, 128, "IN", system::IN_FORCE_LOW),
        ("SETH_P", 1, 128, "IN", system::IN_FORCE_HIGH),
        ("SETL_P", 0, 96, "OUT", system::OUT_FORCE_LOW),
        ("SETH_P", 0, 96, "OUT", system::OUT_FORCE_HIGH),
        ("ERRLI_P", 0, 96, "OUT", system::OUT_SHORTED),
    ] {
        for index in 0..count {
            let name = format!("{before}{}{after}", first + index);
            let expected = SystemKind::Cell { addr: base + index, prefix: Prefix::Byte };
            assert_eq!(symbol(&name).map(|symbol| symbol.kind), Some(expected), "{name}");
        }
    }
}

#[test]
fn the_block_interface_lies_where_the_supervisor_expects_it() {
    let bit = |at: technol_image::op::BitRef| Some(SystemKind::Bit { addr: at.addr, bit: at.bit });
    let kind = |name: &str| symbol(name).map(|symbol| symbol.kind);
    assert_eq!(kind("PO_F"), bit(system::PO_F));
    assert_eq!(kind("M41PI"), bit(system::M41PI));
    assert_eq!(kind("M44PI"), Some(SystemKind::Bit { addr: system::M41PI.addr, bit: 6 }));
    assert_eq!(kind("ZMM1PI"), bit(system::ZMM1PI));
    assert_eq!(kind("ZMM9PI"), Some(SystemKind::Bit { addr: system::ZMM1PI.addr + 1, bit: 0 }));
    assert_eq!(kind("ZMM14PI"), Some(SystemKind::Bit { addr: system::ZMM1PI.addr + 1, bit: 5 }));
    assert_eq!(kind("ZMSHPI"), bit(system::ZMSHPI));
    assert_eq!(kind("PB07"), Some(SystemKind::Cell { addr: system::PB00 + 7, prefix: Prefix::Byte }));
    assert_eq!(kind("PLCEVENT_START_REQ"), Some(SystemKind::Constant(system::event::START_REQ)));
}

#[test]
fn axis_families_have_every_axis() {
    for (before, after, axes) in [("MP", "PI", 16), ("VAZBA_", "", 16), ("KH", "0", 16), ("EXM_", "1", 6)] {
        for axis in ["X", "Y", "Z"].map(str::to_owned).into_iter().chain((4..=axes).map(|n| n.to_string())) {
            let name = format!("{before}{axis}{after}");
            assert!(
                matches!(symbol(&name), Some(SystemSymbol { kind: SystemKind::Bit { .. }, .. })),
                "{name}"
            );
        }
    }
    assert!(symbol("EXM_71").is_none());
}

/// Further names of the memory of SIM_SPEED_PT, NlcAxisEnable and CAN_DRIVE_MSTAT, and of elements of BUKON00 and
/// SHIFT_X.
const OTHER_NAMES: &[&str] = &[
    "OTACKY_VR",
    "NELKOR_FLAG",
    "CAN_MDRIVE_STAT",
    "BUKON10",
    "BUKON180",
    "BUKON181",
    "SHIFT_Y",
    "SHIFT_Z",
    "SHIFT_4",
    "SHIFT_5",
    "SHIFT_6",
];

#[test]
fn numbered_families_are_complete() {
    let names = |before: &str, after: &str, numbers: std::ops::RangeInclusive<u32>| {
        numbers.map(|number| format!("{before}{number}{after}")).collect::<Vec<_>>()
    };
    let axes = |before: &str, after: &str| {
        ["X", "Y", "Z", "4", "5", "6"].map(|axis| format!("{before}{axis}{after}")).to_vec()
    };
    let families = [
        names("REF_SERV_", "", 1..=16),
        names("FeaturePlc", "", 0..=9),
        names("wEdrvDriveStatus", "", 0..=15),
        names("flEdrvEncLatchEn", "", 0..=15),
        names("CAN_DATA_", "", 1..=7),
        names("BUKON", "", 180..=181),
        axes("MM_", "0"),
        axes("MM_", "1"),
        axes("SHIFT_", ""),
    ];
    for name in families.into_iter().flatten() {
        assert!(symbol(&name).is_some(), "{name}");
    }
    for beyond in ["REF_SERV_0", "REF_SERV_17", "FEATUREPLC10", "CAN_DATA_8", "MM_70", "SHIFT_7"] {
        assert!(symbol(beyond).is_none(), "{beyond}");
    }
    let value = |name: &str| symbol(name).map(|symbol| symbol.kind);
    assert_eq!(value("FeaturePlc9"), Some(SystemKind::Constant(10)));
}

#[test]
fn english_has_no_czech_letters_and_both_mark_what_this_implementation_chose() {
    for symbol in symbols().chain(block_members()).chain(unit_members()) {
        let Bilingual { en, cs } = symbol.summary;
        assert!(!has_diacritics(en), "{}: {en}", symbol.name);
        let (ours, nase) = (en.contains("this implementation"), cs.contains("tato implementace"));
        assert_eq!(ours, nase, "{}: {en} | {cs}", symbol.name);
    }
}

#[test]
fn no_two_symbols_share_memory_unless_one_is_a_bit_of_the_other() {
    let mut owners: HashMap<u32, &str> = HashMap::new();
    let mut bits: HashMap<(u32, u8), &str> = HashMap::new();
    for symbol in symbols() {
        let (addr, len) = match symbol.kind {
            SystemKind::Bit { addr, bit } => {
                assert!(bit < 8, "{}", symbol.name);
                assert!(addr < system::LEN, "{}", symbol.name);
                let other = bits.insert((addr, bit), symbol.name);
                assert_eq!(other, None, "{} lies on another bit", symbol.name);
                continue;
            }
            SystemKind::Cell { addr, prefix } => (addr, prefix.bytes()),
            SystemKind::Array { addr, element, len } => (addr, element.bytes() * len),
            SystemKind::Area { addr, len } => (addr, len),
            SystemKind::FormalBit { bit } => {
                assert!(bit < 8, "{}", symbol.name);
                continue;
            }
            SystemKind::Member { .. } | SystemKind::Constant(_) => continue,
        };
        assert!(len > 0 && addr + len <= system::LEN, "{}", symbol.name);
        if OTHER_NAMES.contains(&symbol.name) {
            continue;
        }
        for byte in addr..addr + len {
            let other = owners.insert(byte, symbol.name);
            assert_eq!(other, None, "{} lies on another symbol", symbol.name);
        }
    }
}

#[test]
fn symbol_names_are_unique_upper_case_and_not_instructions() {
    let mut seen = HashSet::new();
    for symbol in symbols() {
        assert!(seen.insert(symbol.name), "{} twice", symbol.name);
        assert_eq!(symbol.name, symbol.spelling.to_ascii_uppercase());
        assert!(symbol.name.len() <= 31, "{}", symbol.name);
        assert!(entry(symbol.name).is_none(), "{}", symbol.name);
        assert!(!symbol.chapter.is_empty(), "{}", symbol.name);
        assert!(symbol.summary.en.ends_with('.') && symbol.summary.cs.ends_with('.'), "{}", symbol.name);
        assert_ne!(symbol.summary.en, symbol.summary.cs, "{}", symbol.name);
    }
}

#[test]
fn backed_up_memory_has_10000_bytes() {
    let kind = symbol("PLC_MEM_BACKUP").map(|symbol| symbol.kind);
    assert!(matches!(kind, Some(SystemKind::Area { len: 10_000, .. })), "{kind:?}");
}

#[test]
fn axes_and_spindles_find_their_cells_where_the_catalogue_puts_them() {
    use technol_image::op::BitRef;
    use technol_image::system::motion;
    let kind = |name: &str| symbol(name).unwrap_or_else(|| panic!("{name}")).kind;
    for &(name, addr) in motion::CELLS {
        assert_eq!(kind(name).bytes().map(|(addr, _)| addr), Some(addr), "{name}");
    }
    let at = |place: BitRef| SystemKind::Bit { addr: place.addr, bit: place.bit };
    for &(name, place) in motion::BITS {
        assert_eq!(kind(name), at(place), "{name}");
    }
    for &(name, family) in motion::FAMILIES {
        assert_eq!(kind(name), at(family.of(0)), "{name}");
    }
    for &(name, family) in motion::SIX_FAMILIES {
        assert_eq!(kind(name), at(family.of(0)), "{name}");
    }
    assert_eq!(kind("EXM_60"), at(motion::EXTERNAL_PLUS.of(5)));
    // The other axes follow the first in every family.
    for (axis, name) in
        [(1, "MPYPI"), (5, "MP6PI"), (6, "MP7PI"), (13, "MP14PI"), (14, "MP15PI"), (15, "MP16PI")]
    {
        assert_eq!(kind(name), at(motion::ENABLE.of(axis)), "{name}");
    }
    let loops = kind("REF_SERV_16");
    let first = motion::SERVO_SWITCH;
    let last = u32::from(first.bit) + 15;
    assert_eq!(loops, SystemKind::Bit { addr: first.addr + last / 8, bit: (last % 8) as u8 });
    for space in 1..=4 {
        let name = format!("POSITION_POS{}_EX", space + 1);
        assert_eq!(kind(&name).bytes(), Some((motion::POSITION_POS1 + space * 128, 128)), "{name}");
    }
}

#[test]
fn the_control_knows_where_the_backed_up_memory_lies() {
    use technol_image::system::data;
    let kind = |name: &str| symbol(name).map(|symbol| symbol.kind);
    let area = SystemKind::Area { addr: data::PLC_MEM_BACKUP, len: data::PLC_MEM_BACKUP_LEN };
    assert_eq!(kind("PLC_MEM_BACKUP"), Some(area));
    let request = data::REQ_BACKUP_MEM;
    assert_eq!(kind("REQ_BACKUP_MEM"), Some(SystemKind::Bit { addr: request.addr, bit: request.bit }));
}

#[test]
fn the_control_finds_analogue_channels_and_drives_where_the_catalogue_puts_them() {
    use technol_image::system::devices;
    let kind = |name: &str| symbol(name).unwrap_or_else(|| panic!("{name}")).kind;
    for &(name, addr) in devices::CELLS {
        assert_eq!(kind(name).bytes().map(|(addr, _)| addr), Some(addr), "{name}");
    }
    for &(name, place) in devices::BITS {
        assert_eq!(kind(name), SystemKind::Bit { addr: place.addr, bit: place.bit }, "{name}");
    }
    // Those of the other drives follow.
    assert_eq!(kind("flEdrvError15"), SystemKind::Bit { addr: devices::EDRV_ERROR.addr + 1, bit: 7 });
    assert_eq!(kind("dwEdrvDrivePos15").bytes(), Some((devices::EDRV_POSITION + 60, 4)));
    assert_eq!(kind("AIN_CONNECTED"), SystemKind::FormalBit { bit: 0 });
    assert_eq!(kind("AOUT_CONNECTED"), SystemKind::FormalBit { bit: 1 });
}
