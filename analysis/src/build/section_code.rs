//! The code of one section before it has a place: what [`lower`](super::lower) makes and [`link`](super::link) joins.

use std::sync::Arc;

use technol_image::op::{Addr, Op};
use technol_image::program::{Message, Timed};
use technol_image::service::ServiceCall;

use crate::diagnostics::Rule;
use crate::diagnostics::rules::{build, names, operands};
use crate::semantics::hir::SymbolKey;
use crate::syntax::section::SectionKind;

/// Code of one section. Nothing in it depends on other sections, so it is computed once for a text.
///
/// Operations carry numbers where the image has addresses:
///
/// | in an operation | is here |
/// |---|---|
/// | data address | index into [`slots`](Self::slots) |
/// | jump target | index into [`ops`](Self::ops) |
/// | procedure, sequence of MECH_INIT | index into [`names`](Self::names) |
/// | TEX, TIM, message and call parameters | index into [`timed`](Self::timed), [`messages`](Self::messages), [`services`](Self::services) |
/// | CLEAR | address: index into [`clears`](Self::clears) |
/// | resume point, of its own sequence | final |
/// | source line, file | 0, set by `link` |
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionCode {
    /// Operations; a nested section has a [`Op::Nop`] as its place.
    pub ops: Vec<Op>,
    /// Data addresses.
    pub slots: Vec<Slot>,
    /// Names of procedures and mechanisms.
    pub names: Vec<SymbolKey>,
    /// First operation and own line of each line with code, ascending.
    pub lines: Vec<CodeLine>,
    /// Labels and the operation they stand before.
    pub labels: Vec<(Arc<str>, u32)>,
    /// Nested mechanisms and procedures, ascending by place.
    pub nested: Vec<NestedCode>,
    /// Parameters of TEX0, TEX1, TIM.
    pub timed: Vec<Timed>,
    /// Parameters of ESET, ESET1.
    pub messages: Vec<Message>,
    /// Parameters of calls of services.
    pub services: Vec<ServiceCall>,
    /// Ranges of CLEAR.
    pub clears: Vec<ClearRange>,
    /// EX-type instructions; number n is at `n - 1`.
    pub points: Vec<ResumePoint>,
    /// Number of automatic counters (WORD).
    pub counters: u32,
    /// Number of hidden state bytes.
    pub states: u32,
    /// MODULE_INIT_FINISHED stands here.
    pub init_finished: bool,
    /// MODULE_DONE_FINISHED stands here.
    pub done_finished: bool,
    /// Own 0-based lines and reasons why the section cannot become a program.
    pub problems: Vec<LineProblem>,
}

/// A line with code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CodeLine {
    /// First operation.
    pub op: u32,
    /// 0-based own line.
    pub line: u32,
}

/// An address to be filled in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Slot {
    /// A symbol and an offset in bytes.
    Symbol {
        /// Which.
        key: SymbolKey,
        /// Added to its address.
        offset: i64,
    },
    /// Automatic counter number n of the section.
    Counter(u32),
    /// Hidden state byte number n of the section.
    State(u32),
    /// An address of the system region: a member of a prepared block.
    Fixed(Addr),
}

/// The place of a nested section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NestedCode {
    /// Operation that stands for it.
    pub op: u32,
    /// Mechanism or Procedure.
    pub kind: SectionKind,
    /// Key of its name.
    pub name: Arc<str>,
    /// Ordinal within the file.
    pub ordinal: u32,
}

/// What CLEAR zeroes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClearRange {
    /// From one address up to another and `tail` bytes more.
    Span {
        /// Slot of the first byte.
        begin: u32,
        /// Slot of the start of the last variable.
        end: u32,
        /// Length of the last variable.
        tail: u32,
    },
    /// CLEAR GLOBAL,ALL.
    Global,
    /// CLEAR INTERNAL,ALL.
    Internal,
}

/// An EX-type instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ResumePoint {
    /// Its operation.
    pub op: u32,
    /// 0-based own line.
    pub line: u32,
    /// How it is written in the manual, for instance `TEX0`.
    pub mnemonic: &'static str,
}

/// Why a line cannot be built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineProblem {
    /// 0-based own line.
    pub line: u32,
    /// Which.
    pub kind: ProblemKind,
}

/// Reasons why a program cannot be built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProblemKind {
    /// An instruction the target cannot execute yet.
    NotExecutable(String),
    /// An operand of a kind that this instruction has no code for: its number (1-based) and the instruction.
    Operand(usize, &'static str),
    /// A jump to a label that is not in this section.
    Label(String),
    /// The counter and the time cell of TEX or TIM have different widths.
    MixedWidths(&'static str),
    /// A constant time that its counter cannot reach.
    TimeTooLong(i64),
    /// An address outside of the data area it starts in.
    OutsideArea(String),
    /// A name without memory.
    NoAddress(String),
    /// CLEAR over two areas, or backwards.
    Clear,
    /// A table of the image is full: what it holds and how many.
    TableFull(&'static str, usize),
    /// A mechanism or procedure that stands in no module, or deeper than one.
    Misplaced(String),
    /// The section has errors.
    Incomplete,
    /// Memory is full.
    Memory(String),
}

impl ProblemKind {
    /// Its rule.
    #[must_use]
    pub fn rule(&self) -> &'static Rule {
        match self {
            ProblemKind::NotExecutable(_) => &build::NOT_EXECUTABLE,
            ProblemKind::TableFull(..) | ProblemKind::Memory(_) => &build::TOO_LARGE,
            ProblemKind::Label(_) => &names::UNKNOWN_LABEL,
            ProblemKind::MixedWidths(_) => &operands::DIFFERENT_TYPES,
            ProblemKind::TimeTooLong(_) => &operands::NUMBER_OUT_OF_RANGE,
            ProblemKind::OutsideArea(_) => &operands::ACCESS_OUTSIDE_DATA,
            ProblemKind::Operand(..)
            | ProblemKind::Misplaced(_)
            | ProblemKind::NoAddress(_)
            | ProblemKind::Clear
            | ProblemKind::Incomplete => &build::NOT_TRANSLATABLE,
        }
    }

    /// What is wrong and what to do about it.
    #[must_use]
    pub fn message(&self) -> String {
        match self {
            ProblemKind::NotExecutable(name) => format!("not executable on this target yet: {name}"),
            ProblemKind::Operand(n, name) => format!("operand {n} of {name} cannot be translated"),
            ProblemKind::Label(name) => {
                format!("the label {name} is not in this module, mechanism or procedure")
            }
            ProblemKind::MixedWidths(name) => format!(
                "the counter and the time of {name} have different types; both must be BYTE or both WORD"
            ),
            ProblemKind::TimeTooLong(time) => {
                format!(
                    "the counter can never reach {time}; use a WORD counter or a time from 0 to its maximum"
                )
            }
            ProblemKind::OutsideArea(name) => format!("the access at {name} leaves the data area"),
            ProblemKind::NoAddress(name) => format!("{name} has no address in PLC memory"),
            ProblemKind::Clear => {
                "CLEAR needs two variables of one data area, the first one not after the second".to_owned()
            }
            ProblemKind::TableFull(what, limit) => {
                format!("too many {what}: a program holds at most {limit}")
            }
            ProblemKind::Misplaced(name) => {
                format!("{name} must stand in a module, and not inside another mechanism or procedure")
            }
            ProblemKind::Incomplete => "this section has errors; correct them first".to_owned(),
            ProblemKind::Memory(message) => message.clone(),
        }
    }
}

impl SectionCode {
    /// The next operation starts the code of `line`, unless an earlier one did.
    pub(super) fn push_line(&mut self, line: u32) {
        let op = self.ops.len() as u32;
        if self.lines.last().is_none_or(|last| last.line != line) {
            self.lines.push(CodeLine { op, line });
        }
    }
}
