//! What `build` needs to know about a project: plain data, collected from the database.

use super::section_code::{ProblemKind, SectionCode};
use crate::semantics::declarations::Declarations;
use crate::semantics::layout::DataBlock;
use crate::syntax::section::SectionKind;

/// A project without errors.
#[derive(Clone, Debug, Default)]
pub struct ProjectInput<'a> {
    /// Project name.
    pub name: &'a str,
    /// Every line takes break-points (`[debug] everywhere`).
    pub debug_everywhere: bool,
    /// Files in execution order, then the included ones.
    pub files: Vec<FileInput<'a>>,
    /// Sections of all files in order of the program; those of an included file stand where it is included.
    pub sections: Vec<SectionInput<'a>>,
}

/// A source file.
#[derive(Clone, Copy, Debug)]
pub struct FileInput<'a> {
    /// Path relative to the project folder, `/`-separated.
    pub path: &'a str,
    /// Place in execution order; `None` for an included file.
    pub order: Option<u8>,
    /// Content.
    pub text: &'a str,
}

/// A section with what was computed for it.
#[derive(Clone, Copy, Debug)]
pub struct SectionInput<'a> {
    /// Index of its file.
    pub file: u16,
    /// File in execution order that its code and local data belong to: its own, or the one that includes it.
    pub owner: u8,
    /// What it is to the program.
    pub kind: SectionKind,
    /// Key of its name; empty when it has none.
    pub name: &'a str,
    /// 0-based number among the sections of this kind and name in the file.
    pub ordinal: u32,
    /// 0-based file line of each own line.
    pub lines: &'a [u32],
    /// Own lines with their ends.
    pub text: &'a str,
    /// What they declare.
    pub declarations: &'a Declarations,
    /// Their code; `None` for sections without code.
    pub code: Option<&'a SectionCode>,
    /// Own lines that call macros, ascending, each with whether it takes break-points in a DEBUG region.
    pub calls: &'a [(u32, bool)],
}

impl SectionInput<'_> {
    /// 0-based file line of an own line; the last one for lines past the end.
    #[must_use]
    pub fn file_line(&self, own: u32) -> u32 {
        self.lines.get(own as usize).or(self.lines.last()).copied().unwrap_or(0)
    }
}

impl ProjectInput<'_> {
    /// The sections as the layout wants them, with the same indices.
    #[must_use]
    pub fn blocks(&self) -> Vec<DataBlock<'_>> {
        let blocks = self.sections.iter().map(|section| DataBlock {
            kind: section.kind,
            name: section.name,
            file: section.owner,
            declarations: section.declarations,
        });
        blocks.collect()
    }
}

/// Why a line of the project cannot be built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BuildProblem {
    /// Index into [`ProjectInput::files`].
    pub file: u16,
    /// 0-based line of the file.
    pub line: u32,
    /// Which.
    pub kind: ProblemKind,
}
