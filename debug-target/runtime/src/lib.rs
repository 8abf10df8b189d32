//! Virtual machine and cycle supervisor of TECHNOL programs.
//!
//! `no_std` + `alloc`, deterministic: no clock, no input or output, no randomness. One [`Runtime::tick`] is
//! one millisecond of the PLC; everything from outside (inputs, [commands](Command), values written by a
//! debugger) enters between two ticks or while the debugger holds the program.
//!
//! A [`Program`](technol_image::Program) is validated completely when it is loaded, so that a damaged or
//! hostile one is a [`LoadError`] and never a panic later; what only shows at run time (division by zero, an
//! index outside memory, an endless loop) is a [`Fault`] that stops the PLC and leaves everything readable.
#![no_std]

extern crate alloc;

mod arithmetic;
mod assembler;
mod block;
mod calls;
mod code;
mod context;
mod continuous;
pub mod control;
mod coverage;
mod data;
mod debugger;
mod decimal;
mod equation;
mod event;
mod execute;
mod fault;
mod fused;
mod load_error;
mod m_functions;
mod memory;
mod operands;
mod plan;
mod ports;
mod prepared;
mod registers;
mod root;
mod runtime;
mod sequence;
mod state_hash;
mod supervisor;
mod texts;
mod timing;
mod trace;
mod validate;

pub use block::{Block, BlockMode, Rejection, Shared};
pub use control::{
    AxesOfBlock, BlockMotion, BlockSpindle, BlockWay, Call, Control, ControlCall, ControlMessage, Hold,
    NoControl, Rate,
};
pub use debugger::{BreakpointError, Frame, Resume, Stop, StopReason};
pub use event::{Command, PlcState, RateKind, RuntimeEvent};
pub use fault::{Fault, FaultKind};
pub use load_error::{LoadError, LoadItem};
pub use m_functions::GroupError;
pub use memory::AccessError;
pub use plan::PeriodError;
pub use ports::{InputImage, OutputImage};
pub use prepared::{BLOCK_AXES, BLOCK_PARAMETERS, BlockFlag, BlockFlags, BlockReal, Prepared};
pub use registers::Registers;
pub use root::root;
pub use runtime::{Limits, Runtime, TickOutcome};
pub use sequence::SequenceState;
pub use state_hash::StateHash;
pub use trace::{TraceEntry, TraceValues};
