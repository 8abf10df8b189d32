//! Messages of the four classes: control, event, stream, bulk. Payloads are postcard-encoded.
//!
//! Rules for change: variants are only ever added at the end; a field is never added to a variant that a released
//! version knows. A peer that meets an unknown variant answers [`Failure::Unsupported`].

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

pub use crate::remote_files::{Entry, FileAnswer, FileRequest};

/// Version of the protocol; peers with another major number do not talk.
pub const PROTOCOL_VERSION: u16 = 1;

/// Number of [`Request`] variants of this version; higher variant numbers are of a later version.
pub const KNOWN_REQUESTS: u32 = 27;

/// What a target can do beyond the first version of this protocol: bits of `features` in [`Response::Hello`]. A host
/// asks for such a thing only when its bit is set, and passes over bits that it does not know.
pub mod feature {
    /// [`Request::OnLinkLost`](super::Request::OnLinkLost).
    pub const LOST_POLICY: u32 = 1;
    /// [`Request::Echo`](super::Request::Echo).
    pub const ECHO: u32 = 1 << 1;
    /// [`Request::Files`](super::Request::Files), and a folder is offered.
    pub const FILES: u32 = 1 << 2;
    /// A download that was cut goes on where it was, when it is announced again.
    pub const RESUMED_DOWNLOAD: u32 = 1 << 3;
    /// [`Request::Subscribe`](super::Request::Subscribe).
    pub const STREAMS: u32 = 1 << 4;
    /// [`Request::MachineRegisters`](super::Request::MachineRegisters).
    pub const MACHINE_REGISTERS: u32 = 1 << 5;
    /// [`Subject::Lines`](super::Subject::Lines).
    pub const TRACED_REGISTERS: u32 = 1 << 6;
}

/// First 16 bytes of the SHA-256 of the encoded program.
pub type ContentHash = [u8; 16];

/// Control class, host to target. Each is answered by exactly one [`Response`], and acted on exactly once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// Opens a session; first message after connecting. Resets the sequence numbers of both sides.
    Hello {
        /// [`PROTOCOL_VERSION`] of the host.
        version: u16,
        /// Random number of this host session: a repeated Hello of the same session is a reconnect.
        session: u32,
    },
    /// Asks for [`Response::Status`].
    Status,
    /// Announces a program; its bytes follow as bulk frames. The running program stays until [`Request::Commit`].
    Download {
        /// Length of the encoded program in bytes.
        len: u32,
        /// Its hash.
        hash: ContentHash,
    },
    /// The announced program is complete: verify it, stop the old one, load it (state Stopped afterwards).
    Commit,
    /// Starts the PLC: cold = memory as after power-on (MODULE_INIT sees DR 0), else DR 1.
    Start {
        /// Clear memory first.
        cold: bool,
        /// Stop before the first statement.
        stop_on_entry: bool,
    },
    /// Stops the PLC through MODULE_DONE.
    Stop,
    /// Runs MODULE_CLEAR.
    Clear,
    /// Replaces all break-points.
    SetBreakpoints {
        /// Operation indices, each the first of a statement.
        pcs: Vec<u32>,
    },
    /// Goes on from a stop, or steps.
    Resume(Resume),
    /// Stops at the next statement.
    Pause,
    /// Reads the registers of the stopped program, or of the last cycle boundary.
    Registers,
    /// Sets registers; only while stopped.
    SetRegisters(Registers),
    /// Reads memory; at most [`Limits::max_read`] bytes in all.
    Read {
        /// Address and length of each piece.
        pieces: Vec<(u32, u16)>,
    },
    /// Writes bytes before the next statement.
    Write {
        /// Address.
        addr: u32,
        /// Bytes.
        bytes: Vec<u8>,
    },
    /// Writes the bits of one byte that `mask` selects.
    WriteBits {
        /// Address.
        addr: u32,
        /// Which bits.
        mask: u8,
        /// Their values.
        value: u8,
    },
    /// Asks for the call stack of the stop.
    CallStack,
    /// Asks for the state of all sequences.
    Sequences,
    /// Activates a mechanism (`true`), or puts it into rest as MECH_INIT does (`false`).
    SetSequence {
        /// Sequence number.
        sequence: u16,
        /// Start or rest.
        active: bool,
    },
    /// Switches a fault of the simulated machine.
    SetFault {
        /// Its name in `machine.toml`.
        name: String,
        /// On or off.
        on: bool,
    },
    /// Presses or releases an operator panel key of the simulated machine.
    Press {
        /// Its name in `machine.toml`.
        key: String,
        /// Pressed or released.
        down: bool,
    },
    /// Lets the host session end: break-points are removed and, as asked, the program runs on or stops.
    Goodbye {
        /// Stop the PLC.
        stop: bool,
    },
    /// Begins a stream of samples, in place of the one with the same number. It ends with the session, with the
    /// program, and when nobody listens any more.
    Subscribe(Subscription),
    /// Ends a stream; one that is not there is no error.
    Unsubscribe {
        /// Its number.
        id: u8,
    },
    /// What to do with a held program when the host is gone without a Goodbye. Holds until another one is told, or
    /// a Goodbye.
    OnLinkLost(LostPolicy),
    /// Sends these bytes back, to measure the line; answered with [`Response::Echo`].
    Echo {
        /// Any bytes.
        bytes: Vec<u8>,
    },
    /// Something about files at the target.
    Files(FileRequest),
    /// Reads the registers of the 80386 that are no registers of the PLC; answered with [`Response::MachineRegisters`].
    MachineRegisters,
}

/// What becomes of a held program when its host is lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum LostPolicy {
    /// It runs on, without break-points.
    #[default]
    RunOn,
    /// It stays held, with its break-points, until a host comes back.
    StayStopped,
    /// The PLC is stopped through MODULE_DONE.
    StopPlc,
}

/// How to go on from a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Resume {
    /// Run.
    Continue,
    /// To the next statement executed anywhere.
    Into,
    /// To the next statement at the same or a lower call depth; with a sequence: in that sequence.
    Over {
        /// Mechanism or block module to stay in.
        sequence: Option<u16>,
    },
    /// Out of the procedure, sequence or module.
    Out,
}

/// Control class, target to host.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Response {
    /// Done, nothing to tell.
    Done,
    /// To [`Request::Hello`].
    Hello {
        /// [`PROTOCOL_VERSION`] of the target.
        version: u16,
        /// What fits.
        limits: Limits,
        /// Counts target starts: a change tells the host that everything was lost.
        boot: u32,
        /// State at this moment, with the hash of the program.
        status: Status,
        /// What this target can do, bits of [`feature`].
        features: u32,
    },
    /// To [`Request::Status`].
    Status(Status),
    /// To [`Request::SetBreakpoints`]: for each, whether it is set.
    Breakpoints(Vec<BreakpointState>),
    /// To [`Request::Registers`].
    Registers(Registers),
    /// To [`Request::Read`]: the pieces one after the other, and the cycle they belong to.
    Memory {
        /// Cycle.
        cycle: u64,
        /// Bytes.
        bytes: Vec<u8>,
    },
    /// To [`Request::CallStack`], innermost first.
    CallStack(Vec<Frame>),
    /// To [`Request::Sequences`].
    Sequences(Vec<SequenceState>),
    /// Refused or impossible.
    Failed(Failure),
    /// To [`Request::Echo`].
    Echo {
        /// The same bytes.
        bytes: Vec<u8>,
        /// Frames that arrived damaged at the target since its link was opened.
        damaged: u32,
    },
    /// To [`Request::Files`].
    Files(FileAnswer),
    /// To [`Request::MachineRegisters`].
    MachineRegisters(MachineRegisters),
}

/// Why a request failed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Failure {
    /// The request is not known to this version.
    Unsupported,
    /// The payload does not decode.
    Malformed,
    /// Another protocol version is needed.
    Version,
    /// No session: Hello comes first.
    NoSession,
    /// No program is loaded.
    NoProgram,
    /// Only possible while the program is stopped in the debugger.
    NotStopped,
    /// Only possible while the program is running.
    NotRunning,
    /// Address or length outside memory.
    OutOfRange,
    /// Bytes are missing, or their hash differs from the announced one.
    Incomplete,
    /// The program does not pass the checks of the runtime; the text says why.
    BadProgram(String),
    /// No such thing (sequence, fault, key); the text names it.
    NotFound(String),
    /// Longer than [`Limits`] allow.
    TooLarge,
    /// Not permitted, or the system of the target does not do it; the text says why.
    Refused(String),
}

/// Event class, target to host: repeated until acknowledged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Event {
    /// The program stopped in the debugger. Brings what an editor shows first.
    Stopped(Stopped),
    /// The program goes on.
    Resumed,
    /// State of the PLC changed.
    State(Status),
    /// The program failed; state Faulted.
    Fault(Fault),
    /// An ESET/ESET1 message.
    Message {
        /// 20 ms cycle.
        cycle: u64,
        /// Number.
        number: u16,
        /// Supplementary number.
        sub_id: Option<i64>,
        /// Show or remove.
        set: bool,
        /// Values for the text.
        parameters: Vec<i64>,
        /// The ESET.
        pc: u32,
    },
    /// A cycle took too long.
    Overrun {
        /// 20 ms cycle.
        cycle: u64,
        /// The 1 ms raster (else the 20 ms one).
        fast: bool,
    },
    /// A line for the user.
    Log(String),
}

/// Where and why the program stopped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stopped {
    /// Why.
    pub reason: StopReason,
    /// Next operation.
    pub pc: u32,
    /// Module kind index in the order of `technol_image::program::ModuleKind`.
    pub module: u8,
    /// Sequence that is executing.
    pub sequence: Option<u16>,
    /// 20 ms cycle.
    pub cycle: u64,
    /// Registers.
    pub registers: Registers,
    /// Call stack, innermost first.
    pub frames: Vec<Frame>,
}

/// Reason of a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum StopReason {
    /// A break-point.
    Breakpoint,
    /// A step is complete.
    Step,
    /// Asked by the user.
    Pause,
    /// Before the first statement.
    Entry,
    /// A fault; it follows as its own event.
    Fault,
}

/// One level of the call stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Frame {
    /// Next operation (innermost) or the call in progress.
    pub pc: u32,
    /// Procedure.
    pub procedure: Option<u16>,
    /// Sequence.
    pub sequence: Option<u16>,
    /// Module kind index.
    pub module: u8,
}

/// Registers of the 80386 that are no registers of the PLC. EBX is BX, ECX and EDX are the halves of DR.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct MachineRegisters {
    /// EAX, with RLO as bit 4000h.
    pub eax: u32,
    /// Flags at their places in EFLAGS: carry 1, parity 4, zero 40h, sign 80h, overflow 800h.
    pub flags: u16,
}

/// Registers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Registers {
    /// RLO.
    pub rlo: bool,
    /// DR, all 64 bits.
    pub dr: i64,
    /// DR_REAL.
    pub dr_real: f64,
    /// Index register.
    pub bx: u32,
    /// Equation stack, bit 0 = first pushed.
    pub stack: u8,
    /// Number of pushed values.
    pub depth: u8,
}

/// State of a mechanism or block module.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SequenceState {
    /// Sequence number.
    pub sequence: u16,
    /// Activation bit.
    pub active: bool,
    /// Resume point; 0 = start.
    pub resume: u16,
    /// `mech_LINE`.
    pub line: u16,
    /// 20 ms cycles (1 ms passes in MODULE_FAST) since the state was entered.
    pub since: u32,
}

/// What became of a break-point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum BreakpointState {
    /// Set.
    Set,
    /// Not the start of a statement.
    NotAStatement,
    /// MODULE_FAST takes none.
    InFast,
    /// MODULE_CONT never stops.
    InCont,
    /// No room for more.
    TooMany,
}

/// A run-time fault.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// What happened.
    pub kind: FaultKind,
    /// The operation.
    pub pc: u32,
    /// Module kind index.
    pub module: u8,
    /// Sequence.
    pub sequence: Option<u16>,
    /// 20 ms cycle.
    pub cycle: u64,
}

/// Kinds of run-time faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FaultKind {
    /// DIVB by zero.
    DivisionByZero,
    /// The quotient does not fit.
    QuotientOverflow,
    /// A BCD conversion outside its range.
    BcdRange,
    /// More than eight pushed values.
    StackOverflow,
    /// An operand-less LA/LO/LX with an empty stack.
    StackUnderflow,
    /// An indexed address outside memory.
    BadAddress,
    /// One pass did not end.
    EndlessLoop,
    /// Procedures nested too deeply.
    CallDepth,
    /// End of a procedure without a call.
    UnexpectedReturn,
    /// End of a module inside a procedure.
    UnexpectedEnd,
    /// The continuation cell of a sequence names no EX-type instruction.
    BadContinuation,
    /// An instruction that the control of the target does not carry out.
    NoService,
}

/// What the target is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Status {
    /// PLC state.
    pub plc: PlcState,
    /// Held by the debugger.
    pub held: bool,
    /// 20 ms cycle since start.
    pub cycle: u64,
    /// Loaded program.
    pub program: Option<ContentHash>,
}

/// State of the PLC.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum PlcState {
    /// No program.
    Empty,
    /// Not running.
    Stopped,
    /// MODULE_INIT done, waiting for MODULE_INIT_FINISHED.
    Starting,
    /// Running.
    Running,
    /// Waiting for MODULE_DONE_FINISHED.
    Stopping,
    /// After MODULE_HALT.
    Halted,
    /// After a fault.
    Faulted,
}

impl PlcState {
    /// Cycles are executed in this state.
    #[must_use]
    pub const fn is_cycling(self) -> bool {
        matches!(self, PlcState::Starting | PlcState::Running | PlcState::Stopping)
    }
}

/// What fits through this target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Limits {
    /// Longest payload of a frame in bytes.
    pub max_payload: u16,
    /// Most bytes in one [`Request::Read`].
    pub max_read: u16,
    /// Most break-points.
    pub max_breakpoints: u16,
    /// Bulk frames in flight.
    pub window: u8,
}

/// Bulk class, host to target: a piece of the announced program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Chunk {
    /// Offset in bytes.
    pub offset: u32,
    /// Bytes.
    pub bytes: Vec<u8>,
}

/// Bulk class, target to host: what has arrived.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ChunkAck {
    /// All bytes before this offset have arrived.
    pub complete: u32,
    /// Further pieces (offset, length) that have arrived out of order.
    pub islands: Vec<(u32, u32)>,
}

/// What a stream samples, and how often.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Subscription {
    /// Number of the stream, below [`MOST_STREAMS`], chosen by the host.
    pub id: u8,
    /// A sample every so many 20 ms cycles; at least 1.
    pub period: u16,
    /// What is sampled.
    pub subject: Subject,
}

/// Number of streams a target has.
pub const MOST_STREAMS: u8 = 8;

/// What a stream samples. The order is that of the values in its samples, see [`crate::Layout`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Subject {
    /// Pieces of memory.
    Variables(Vec<Item>),
    /// Mechanisms and block modules, by sequence number: active, resume point, line, cycle the state was entered in.
    Mechanisms(Vec<u16>),
    /// The registers behind lines: whether the line ran in the last cycle, RLO and DR behind it.
    Trace {
        /// First operation of each line.
        pcs: Vec<u32>,
        /// All 64 bits of DR, else the low 32.
        wide: bool,
    },
    /// The same, with the register that each line works with.
    Lines(Vec<TracedLine>),
}

/// A line whose registers a stream tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TracedLine {
    /// Its first operation.
    pub pc: u32,
    /// What is told beside RLO.
    pub register: TracedRegister,
}

/// A data register of a traced line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum TracedRegister {
    /// The low 32 bits of DR.
    Dr32,
    /// All of DR.
    Dr64,
    /// DR_REAL, of a line that works with reals; 0 of another.
    Real,
}

/// A piece of memory in a stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Item {
    /// Address.
    pub addr: u32,
    /// What lies there.
    pub kind: ItemKind,
    /// What is told about it.
    pub mode: Mode,
}

/// Form of a piece of memory; numbers are little endian.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum ItemKind {
    /// One bit of the byte, 0 to 7.
    Bit(u8),
    /// A number without sign of 1, 2, 4 or 8 bytes.
    Unsigned(u8),
    /// A number with sign of 1, 2, 4 or 8 bytes.
    Signed(u8),
    /// A real number of 8 bytes.
    Real,
}

/// What is told about a piece of memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Mode {
    /// Its value when a sample is due.
    Value,
    /// The same, and a change makes a sample due at the end of its cycle, whatever the period.
    OnChange,
    /// Its value, its least and its greatest value since the sample before; looked at every millisecond.
    Extremes,
    /// Its value, and how often it has risen and fallen since the stream began (modulo 65536); looked at
    /// every millisecond.
    Edges,
}
