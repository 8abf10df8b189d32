//! Sections: the unit of incremental work.
//!
//! A file is cut into data blocks, modules, mechanisms, procedures and macro definitions by looking only at the
//! first words of its lines. A section owns its opening and closing line and every line between them that does
//! not belong to a section nested in it. Nothing in it is absolute: a position is (own line, columns), so that
//! text added above, below or in a nested section changes nothing here.

use technol_image::program::ModuleKind;

/// What a section is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SectionKind {
    /// Lines between modules.
    File,
    /// DATA … DATA_END.
    Data,
    /// DATA_LOCAL … DATA_LOCAL_END.
    DataLocal,
    /// MODULE_x … MODULE_x_END.
    Module(ModuleKind),
    /// MECH_BEGIN … MECH_END.
    Mechanism,
    /// PROC_BEGIN … PROC_END.
    Procedure,
    /// DEF_T_MACRO … END_T_MACRO.
    Macro,
}

/// A section as cut from a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RawSection {
    /// What it is.
    pub kind: SectionKind,
    /// Key of its name (mechanism, procedure, macro); empty for others.
    pub name: String,
    /// 0-based number among the sections of this kind and name in the file.
    pub ordinal: u32,
    /// Index of the section it is nested in.
    pub parent: Option<usize>,
    /// Its own lines with their ends, concatenated.
    pub text: String,
    /// 0-based file line of each own line, ascending.
    pub lines: Vec<u32>,
    /// Nested sections: index, and the number of own lines that stand before it.
    pub children: Vec<(usize, u32)>,
    /// Its closing line is there.
    pub closed: bool,
}
