//! The executable part of an image.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::op::{Addr, Op, Pc, Place, Source, Width};
use crate::service::ServiceCall;

/// First 16 bytes of the SHA-256 of an encoded [`Program`].
pub type ContentHash = [u8; 16];

/// A part of PLC memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum RegionKind {
    /// Interface cells shared with the control; layout in [`system`](crate::system).
    System,
    /// DATA of all files, and the activation bit, continuation, wait and `mech_LINE` cells of mechanisms.
    Global,
    /// DATA_LOCAL of all files and automatic counters.
    Local,
    /// Edge and count states: zeroed at every start of the PLC.
    Hidden,
}

/// Extent of a region; regions are disjoint and ascending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Region {
    /// Which one.
    pub kind: RegionKind,
    /// First byte.
    pub start: Addr,
    /// Length in bytes.
    pub len: u32,
}

/// Kinds of modules (manual chapter 5).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum ModuleKind {
    /// MODULE_INPUT: first in each 20 ms cycle.
    Input,
    /// MODULE_BLOCK_INIT: preparatory functions of a block.
    BlockInit,
    /// MODULE_BLOCK_DONE: closing functions of a block.
    BlockDone,
    /// MODULE_MAIN: each 20 ms.
    Main,
    /// MODULE_INIT: once at PLC start.
    Init,
    /// MODULE_DONE: once at PLC stop.
    Done,
    /// MODULE_CLEAR: once on the clear command.
    Clear,
    /// MODULE_HALT: once at a fatal error of the control.
    Halt,
    /// MODULE_FAST: each millisecond.
    Fast,
    /// MODULE_CONT: each 20 ms, also while the debugger holds the rest.
    Cont,
    /// MODULE_CYCLICOPERATION: each millisecond, before MODULE_FAST.
    CyclicOperation,
    /// MODULE_FASTEST: once to ten times a millisecond, see [`FASTEST_PERIODS`].
    Fastest,
}

/// Periods of MODULE_FASTEST in microseconds; the last one is the default.
pub const FASTEST_PERIODS: [u16; 5] = [100, 200, 250, 500, 1000];

impl ModuleKind {
    /// All kinds in the order of their numbers, which the debug protocol uses.
    pub const ALL: [ModuleKind; 12] = [
        ModuleKind::Input,
        ModuleKind::BlockInit,
        ModuleKind::BlockDone,
        ModuleKind::Main,
        ModuleKind::Init,
        ModuleKind::Done,
        ModuleKind::Clear,
        ModuleKind::Halt,
        ModuleKind::Fast,
        ModuleKind::Cont,
        ModuleKind::CyclicOperation,
        ModuleKind::Fastest,
    ];

    /// The kind with that number.
    #[must_use]
    pub fn from_number(number: u8) -> Option<ModuleKind> {
        ModuleKind::ALL.get(usize::from(number)).copied()
    }

    /// The keyword that opens the module.
    #[must_use]
    pub const fn keyword(self) -> &'static str {
        match self {
            ModuleKind::Input => "MODULE_INPUT",
            ModuleKind::BlockInit => "MODULE_BLOCK_INIT",
            ModuleKind::BlockDone => "MODULE_BLOCK_DONE",
            ModuleKind::Main => "MODULE_MAIN",
            ModuleKind::Init => "MODULE_INIT",
            ModuleKind::Done => "MODULE_DONE",
            ModuleKind::Clear => "MODULE_CLEAR",
            ModuleKind::Halt => "MODULE_HALT",
            ModuleKind::Fast => "MODULE_FAST",
            ModuleKind::Cont => "MODULE_CONT",
            ModuleKind::CyclicOperation => "MODULE_CYCLICOPERATION",
            ModuleKind::Fastest => "MODULE_FASTEST",
        }
    }

    /// It runs in the raster of a millisecond or faster, which no debugger can hold.
    #[must_use]
    pub const fn is_fast(self) -> bool {
        matches!(self, ModuleKind::Fast | ModuleKind::CyclicOperation | ModuleKind::Fastest)
    }
}

/// One module of one file. Execution order within a kind is the order in [`Program::modules`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Module {
    /// Kind.
    pub kind: ModuleKind,
    /// 0-based file in execution order.
    pub file: u8,
    /// First operation.
    pub start: Pc,
    /// One past the last operation, which is [`Op::ModuleEnd`].
    pub end: Pc,
}

/// A sequential logic unit: a mechanism or one of the two block modules.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sequence {
    /// What it is.
    pub kind: SequenceKind,
    /// Byte address of the activation bit.
    pub active_addr: Addr,
    /// Bit number of the activation bit.
    pub active_bit: u8,
    /// WORD: number of the resume point to continue at; 0 = start.
    pub resume_cell: Addr,
    /// WORD: number of the resume point that is being waited at (its counter runs); 0 = none.
    pub wait_cell: Addr,
    /// WORD: `mech_LINE`, source line of the state, 0 when not active.
    pub line_cell: Addr,
    /// The [`Op::SeqBegin`].
    pub start: Pc,
    /// The [`Op::SeqEnd`].
    pub end: Pc,
    /// Source line of MECH_BEGIN.
    pub line: u16,
    /// `resume[n-1]` is the operation after EX-type instruction number n.
    pub resume: Vec<Pc>,
}

/// What a [`Sequence`] is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum SequenceKind {
    /// A mechanism.
    Mechanism,
    /// MODULE_BLOCK_INIT.
    BlockInit,
    /// MODULE_BLOCK_DONE.
    BlockDone,
}

/// Parameters of TEX0, TEX1 and TIM.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timed {
    /// TEX0: `Some(false)`, TEX1: `Some(true)` (waits while RLO equals it), TIM: `None`.
    pub wait_when: Option<bool>,
    /// Counter cell.
    pub count: Place,
    /// Width of the counter and of a time cell (Byte or Word, unsigned).
    pub width: Width,
    /// Limit in cycles.
    pub time: Source,
    /// Continue here when the limit expires (TEX only).
    pub error: Option<Pc>,
    /// Value loaded into DR on that jump, with its width.
    pub code: Option<(Source, Width)>,
    /// Resume point.
    pub point: u16,
    /// Source line.
    pub line: u16,
}

/// Parameters of ESET and ESET1; `None` = left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Message {
    /// Message number; from DR16 when left out.
    pub number: Option<(Source, Width)>,
    /// Supplementary number.
    pub sub_id: Option<(Source, Width)>,
    /// Show (true, default) or remove (false) a persistent message.
    pub set: bool,
    /// Values for the message text.
    pub parameters: [Option<(Source, Width)>; 3],
}

/// A procedure.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Procedure {
    /// Name, upper case; reserved names start with `_ON_`.
    pub name: String,
    /// First operation of the body.
    pub start: Pc,
    /// One past its [`Op::Return`].
    pub end: Pc,
}

/// Initial content written when a program is loaded.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct InitialData {
    /// First byte.
    pub addr: Addr,
    /// Content.
    pub bytes: Vec<u8>,
}

/// An executable program. Data only; the runtime validates it on load.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Program {
    /// Project name.
    pub name: String,
    /// Memory regions, ascending; PLC memory is as long as the end of the last one.
    pub regions: Vec<Region>,
    /// Code of all modules, sequences and procedures.
    pub code: Vec<Op>,
    /// First operation of each source line that has code, ascending: where break-points and steps stop.
    pub statements: Vec<Pc>,
    /// Modules in execution order.
    pub modules: Vec<Module>,
    /// Mechanisms and block modules.
    pub sequences: Vec<Sequence>,
    /// Parameters of TEX0, TEX1, TIM.
    pub timed: Vec<Timed>,
    /// Parameters of ESET, ESET1.
    pub messages: Vec<Message>,
    /// Calls of [`Op::Service`].
    pub services: Vec<ServiceCall>,
    /// Procedures.
    pub procedures: Vec<Procedure>,
    /// Initial memory.
    pub initial: Vec<InitialData>,
    /// Files (0-based) that contain MODULE_INIT_FINISHED: the start waits for each.
    pub init_finished: Vec<u8>,
    /// Files that contain MODULE_DONE_FINISHED.
    pub done_finished: Vec<u8>,
}

impl Program {
    /// A program with memory and nothing to do.
    #[must_use]
    pub fn without_code(name: String, regions: Vec<Region>) -> Program {
        Program {
            name,
            regions,
            code: Vec::new(),
            statements: Vec::new(),
            modules: Vec::new(),
            sequences: Vec::new(),
            timed: Vec::new(),
            messages: Vec::new(),
            services: Vec::new(),
            procedures: Vec::new(),
            initial: Vec::new(),
            init_finished: Vec::new(),
            done_finished: Vec::new(),
        }
    }

    /// Length of PLC memory in bytes.
    #[must_use]
    pub fn memory_len(&self) -> u32 {
        self.regions.iter().map(|r| r.start.saturating_add(r.len)).max().unwrap_or(0)
    }

    /// The region of that kind.
    #[must_use]
    pub fn region(&self, kind: RegionKind) -> Option<Region> {
        self.regions.iter().copied().find(|r| r.kind == kind)
    }

    /// The procedure of that (upper-case) name.
    #[must_use]
    pub fn procedure(&self, name: &str) -> Option<u16> {
        self.procedures.iter().position(|p| p.name == name).and_then(|i| u16::try_from(i).ok())
    }
}
