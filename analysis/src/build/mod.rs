//! From the meaning of a project to its program image.
//!
//! ```text
//! Body of a section ──lower──► SectionCode ─┐
//! declarations ──────layout──► Layout ──────┴─link──► Program ──► DebugInfo ──► Image, listing
//! ```
//!
//! `lower` looks at one section only, so its result is kept as long as the section's meaning stays equal; `link` is
//! the only step that sees the whole project. The same sources always give the same bytes.

mod addresses;
mod block_names;
mod collect;
pub mod debug_info;
mod debug_regions;
pub mod disassembly;
mod fingerprint;
pub mod input;
mod link;
pub mod listing;
mod lower;
mod mnemonic;
mod operands;
mod power_on;
mod relocate;
mod section_code;
mod source_text;

use technol_image::Image;
use technol_image::program::ContentHash;

pub use disassembly::Disassembler;
pub use fingerprint::sources_hash;
pub use input::{BuildProblem, FileInput, ProjectInput, SectionInput};
pub use listing::listing;
pub use lower::lower;
pub use section_code::{
    ClearRange, CodeLine, LineProblem, NestedCode, ProblemKind, ResumePoint, SectionCode, Slot,
};

use crate::semantics::layout::Layout;

/// A built project.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// Program and debug information.
    pub image: Image,
    /// Identity of the program; the target and the debug information carry the same one.
    pub hash: ContentHash,
}

/// Builds a project whose sections are free of errors.
///
/// # Errors
/// Everything that keeps the project from becoming a program, sorted by file and line.
pub fn build(input: &ProjectInput<'_>, layout: &Layout) -> Result<Built, Vec<BuildProblem>> {
    if let Some(overflow) = &layout.overflow {
        let section = input.sections.get(overflow.block);
        let (file, line) = section.map_or((0, 0), |s| (s.file, s.file_line(overflow.line)));
        return Err(vec![BuildProblem { file, line, kind: ProblemKind::Memory(overflow.message.clone()) }]);
    }
    if input.files.len() > usize::from(u16::MAX) {
        let kind = ProblemKind::TableFull("files", usize::from(u16::MAX));
        return Err(vec![BuildProblem { file: 0, line: 0, kind }]);
    }
    let linked = link::link(input, layout)?;
    let debug = debug_info::debug_info(input, layout, &linked);
    let hash = debug.program;
    Ok(Built { image: Image { program: linked.program, debug: Some(debug) }, hash })
}
