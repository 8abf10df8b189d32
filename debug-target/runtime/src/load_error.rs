//! Why a program cannot be loaded.

use core::fmt;

use technol_image::op::Pc;

/// The part of a program that is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadItem {
    /// The whole program.
    Program,
    /// A memory region, by index.
    Region(usize),
    /// An operation.
    Op(Pc),
    /// An entry of the statement table, by index.
    Statement(usize),
    /// A module, by index.
    Module(usize),
    /// A sequence, by number.
    Sequence(usize),
    /// A TEX or TIM parameter set, by index.
    Timed(usize),
    /// An ESET parameter set, by index.
    Message(usize),
    /// A parameter set of a service call, by index.
    Service(usize),
    /// A procedure, by number.
    Procedure(usize),
    /// A block of initial data, by index.
    Initial(usize),
}

/// A program that would not run safely. Building it again with this version is the remedy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoadError {
    /// Where.
    pub item: LoadItem,
    /// What.
    pub reason: &'static str,
}

impl LoadError {
    pub(crate) const fn new(item: LoadItem, reason: &'static str) -> LoadError {
        LoadError { item, reason }
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.item {
            LoadItem::Program => f.write_str("program")?,
            LoadItem::Region(n) => write!(f, "memory region {n}")?,
            LoadItem::Op(pc) => write!(f, "operation {pc}")?,
            LoadItem::Statement(n) => write!(f, "statement {n}")?,
            LoadItem::Module(n) => write!(f, "module {n}")?,
            LoadItem::Sequence(n) => write!(f, "sequence {n}")?,
            LoadItem::Timed(n) => write!(f, "TEX/TIM parameters {n}")?,
            LoadItem::Message(n) => write!(f, "message parameters {n}")?,
            LoadItem::Service(n) => write!(f, "parameters of call {n}")?,
            LoadItem::Procedure(n) => write!(f, "procedure {n}")?,
            LoadItem::Initial(n) => write!(f, "initial data {n}")?,
        }
        write!(f, ": {}; build the program again", self.reason)
    }
}

impl core::error::Error for LoadError {}
