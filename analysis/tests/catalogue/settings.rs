//! Where an instruction stands in the frame, and the lines it needs around it.

use technol_analysis::catalogue::{Effect, Entry, EntryKind, Equation, Place};

/// Lines around a case and the section they stand in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Setting {
    pub(crate) section: Section,
    pub(crate) before: String,
    pub(crate) after: String,
}

/// A place in the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Section {
    /// Before DATA.
    Before,
    /// In a section of the frame.
    Of(&'static str),
    /// In a mechanism.
    Sequence,
    /// The line is the first or last one of a section, or STOP: it stands in the frame by itself.
    Frame,
}

/// Instructions that stand within others: section, lines before and behind. `{operands}` are those of the case,
/// `{labels}` the same as labels, `{case}` its number.
const WITHIN: &[(&str, Section, &str, &str)] = &[
    ("MECH_BEGIN", Section::Of("MODULE_MAIN"), "", "EX\nMECH_END {operands}"),
    ("MECH_END", Section::Of("MODULE_MAIN"), "MECH_BEGIN W_NEW{case}\nEX", ""),
    ("PROC_BEGIN", Section::Of("MODULE_MAIN"), "", "PROC_END {operands}"),
    ("PROC_END", Section::Of("MODULE_MAIN"), "PROC_BEGIN W_NEW{case}", ""),
    ("STRUC", Section::Of("DATA"), "", "W_MEMBER{case} DB ?\nW_NEW{case} ENDS"),
    ("ENDS", Section::Of("DATA"), "W_NEW{case} STRUC\nW_MEMBER{case} DB ?", ""),
    ("DB", Section::Of("DATA"), "W_STRUC{case} STRUC", "W_STRUC{case} ENDS"),
    ("DW", Section::Of("DATA"), "W_STRUC{case} STRUC", "W_STRUC{case} ENDS"),
    ("DD", Section::Of("DATA"), "W_STRUC{case} STRUC", "W_STRUC{case} ENDS"),
    ("DQ", Section::Of("DATA"), "W_STRUC{case} STRUC", "W_STRUC{case} ENDS"),
    ("TM", Section::Of("MODULE_MAIN"), "DFTM1 W_END{case}", "W_END{case}:"),
    ("DEF_T_MACRO", Section::Before, "", "END_T_MACRO"),
    ("END_T_MACRO", Section::Before, "DEF_T_MACRO W_MACRO{case}", ""),
    ("T_LOCAL", Section::Before, "DEF_T_MACRO W_MACRO{case}", "{labels}\nEND_T_MACRO"),
    ("APPEND_T_MACRO", Section::Before, "DEF_T_MACRO W_MACRO{case}\nEND_T_MACRO", ""),
    ("TMAC", Section::Before, "DEF_T_MACRO W_MACRO{case} parameter", "END_T_MACRO"),
    ("MODULE_INIT_FINISHED", Section::Of("MODULE_MAIN"), "", ""),
    ("MODULE_DONE_FINISHED", Section::Of("MODULE_MAIN"), "", ""),
];

/// Whether an entry stands within other lines.
pub(crate) fn is_within(entry: &Entry) -> bool {
    WITHIN.iter().any(|(name, ..)| *name == entry.name)
}

/// The setting of an instruction; `with_operand` tells LA and LO which end of a bracket they are.
pub(crate) fn setting(entry: &Entry, operands: &str, with_operand: bool, case: usize) -> Setting {
    let labels: Vec<String> = operands.split(',').map(|name| format!("{}:", name.trim())).collect();
    let fill = |text: &str| {
        let text = text.replace("{operands}", operands).replace("{labels}", &labels.join("\n"));
        text.replace("{case}", &case.to_string())
    };
    if let Some((_, section, before, after)) = WITHIN.iter().find(|(name, ..)| *name == entry.name) {
        return Setting { section: *section, before: fill(before), after: fill(after) };
    }
    if entry.name == "STOP" || entry.kind == EntryKind::Structure {
        return Setting { section: Section::Frame, before: String::new(), after: String::new() };
    }
    let section = match entry.place {
        Place::Data | Place::DataOrFileLevel | Place::AnyModule => Section::Of("DATA"),
        Place::Anywhere | Place::FileLevel => Section::Before,
        Place::FileLevelOrModule | Place::Code | Place::Main | Place::MechanismHost => {
            Section::Of("MODULE_MAIN")
        }
        Place::Init | Place::InitOrProcedure => Section::Of("MODULE_INIT"),
        Place::Sequence => Section::Sequence,
    };
    let (before, after) = match entry.equation {
        Equation::None => ("", ""),
        Equation::Open => ("", "WR W_BIT"),
        Equation::Combine if with_operand => ("LDR W_BIT", "WR W_BIT2"),
        Equation::Combine => ("LDR W_BIT\nLDR W_BIT2", "WR W_BIT2"),
        Equation::Modify => ("LDR W_BIT", "WR W_BIT2"),
        // What goes on with an equation needs one; what begins anew gets none.
        Equation::Overwrite if entry.reads.contains(&Effect::Rlo) => ("LDR W_BIT", "WR W_BIT2"),
        Equation::Overwrite => ("", "WR W_BIT2"),
        Equation::Terminal => ("LDR W_BIT", ""),
    };
    Setting { section, before: before.to_string(), after: after.to_string() }
}
