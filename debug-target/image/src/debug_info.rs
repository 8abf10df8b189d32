//! Debug information: maps code, memory and mechanisms back to source. Never sent to the target.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::op::{Addr, Pc, Width};
use crate::program::{ContentHash, ModuleKind};

/// A source file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SourceFile {
    /// Path relative to the project folder, `/`-separated.
    pub path: String,
    /// First 16 bytes of the SHA-256 of its bytes.
    pub hash: ContentHash,
    /// `Some(n)`: the n-th file of the project in execution order; `None`: an included file.
    pub order: Option<u8>,
}

/// A source line that has code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Line {
    /// First operation; the line's code ends where the next entry starts or its module ends.
    pub pc: Pc,
    /// Index into [`DebugInfo::files`].
    pub file: u16,
    /// 1-based line.
    pub line: u32,
    /// The line lies in a DEBUG region.
    pub in_debug_region: bool,
}

/// Who sees a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Scope {
    /// Declared in DATA: the whole project.
    Global,
    /// Declared in DATA_LOCAL of this file (0-based, execution order).
    File(u8),
    /// Predefined interface cell.
    System,
}

/// What a symbol stands for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum SymbolKind {
    /// A bit.
    Bit {
        /// Byte address.
        addr: Addr,
        /// Bit number 0..=7.
        bit: u8,
    },
    /// A typed cell, or a byte cell declared by a DFM label.
    Cell {
        /// Address.
        addr: Addr,
        /// Declared type.
        width: Width,
    },
    /// An untyped area (`DS n`), needs a prefix.
    Area {
        /// Address.
        addr: Addr,
        /// Length in bytes.
        len: u32,
    },
    /// A text buffer (`STR n`): n characters and a zero.
    Text {
        /// Address.
        addr: Addr,
        /// Maximum number of characters.
        len: u32,
    },
    /// A constant (EQUI).
    Constant {
        /// Value.
        value: i64,
    },
    /// A mechanism: index into `Program::sequences`.
    Mechanism {
        /// Sequence.
        sequence: u16,
    },
    /// A procedure: index into `Program::procedures`.
    Procedure {
        /// Procedure.
        procedure: u16,
    },
    /// A label in code.
    Label {
        /// Operation it stands before.
        pc: Pc,
    },
}

/// A named thing the debugger can show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Symbol {
    /// Name as declared.
    pub name: String,
    /// Visibility.
    pub scope: Scope,
    /// Meaning and place.
    pub kind: SymbolKind,
    /// Index into [`DebugInfo::files`] and 1-based line of the declaration; `None` for predefined symbols.
    pub declared: Option<(u16, u32)>,
}

/// A state of a mechanism: an EX-type instruction.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct State {
    /// Resume point number, 1-based.
    pub point: u16,
    /// 1-based line.
    pub line: u32,
    /// Mnemonic, for instance `TEX0`.
    pub mnemonic: String,
    /// Source text of the condition before it (the lines since the last EX-type instruction), shortened.
    pub condition: String,
}

/// A sequence (mechanism or block module) as shown to people.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Mechanism {
    /// Name as written; `MODULE_BLOCK_INIT` or `MODULE_BLOCK_DONE` for the block modules.
    pub name: String,
    /// Index into `Program::sequences`.
    pub sequence: u16,
    /// Index into [`DebugInfo::files`].
    pub file: u16,
    /// Module it stands in.
    pub module: ModuleKind,
    /// 1-based first and last line.
    pub lines: (u32, u32),
    /// Its states in source order.
    pub states: Vec<State>,
}

/// Everything a debugger needs besides the program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DebugInfo {
    /// Hash of the program this belongs to.
    pub program: ContentHash,
    /// Source files.
    pub files: Vec<SourceFile>,
    /// Lines with code, ascending by `pc`.
    pub lines: Vec<Line>,
    /// Symbols: user symbols in declaration order, then the predefined ones that the program uses.
    pub symbols: Vec<Symbol>,
    /// Mechanisms and block modules, by sequence number.
    pub mechanisms: Vec<Mechanism>,
}

impl DebugInfo {
    /// The line entry that covers `pc`.
    #[must_use]
    pub fn line_at(&self, pc: Pc) -> Option<&Line> {
        // What comes from no operation comes from no line.
        if pc == Pc::MAX {
            return None;
        }
        let n = self.lines.partition_point(|l| l.pc <= pc);
        self.lines.get(n.checked_sub(1)?)
    }

    /// File path and 1-based line of `pc`.
    #[must_use]
    pub fn position(&self, pc: Pc) -> Option<(&str, u32)> {
        let line = self.line_at(pc)?;
        Some((self.files.get(line.file as usize)?.path.as_str(), line.line))
    }
}
