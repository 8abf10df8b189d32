//! What goes into the runtime (commands) and what comes out of it (events).

use technol_image::op::Pc;

use crate::block::{Block, Rejection};
use crate::fault::Fault;

/// State of the PLC.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PlcState {
    /// Not running; outputs are off.
    Stopped,
    /// Running, but a file has not yet executed MODULE_INIT_FINISHED.
    Starting,
    /// Running.
    Running,
    /// Running, MODULE_DONE was executed, waiting for MODULE_DONE_FINISHED.
    Stopping,
    /// MODULE_HALT was executed.
    Halted,
    /// A run-time fault; outputs are off.
    Faulted,
}

impl PlcState {
    /// Cycles are executed in this state.
    #[must_use]
    pub const fn is_cycling(self) -> bool {
        matches!(self, PlcState::Starting | PlcState::Running | PlcState::Stopping)
    }
}

/// Something the control asks for; acted on at the next tick boundary, in order.
///
/// StartPlc, StopPlc, ClearPlc and Halt each take a tick of their own in which PLC time does not advance.
/// StartPlc is acted on even while the debugger holds the program.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Starts (or restarts) the PLC: MODULE_INIT, then cycles.
    StartPlc {
        /// Power-on: memory is zeroed and initialised, DR = 0. Otherwise memory stays and DR = 1.
        cold: bool,
    },
    /// MODULE_DONE, then stop. A second one stops without waiting for MODULE_DONE_FINISHED.
    StopPlc {
        /// Power is being switched off: DR = 0, otherwise 1.
        power_off: bool,
    },
    /// MODULE_CLEAR once.
    ClearPlc,
    /// Fatal error of the control: MODULE_HALT once, then halted.
    Halt,
    /// Starts a part-program block; at most 16 are queued.
    StartBlock(Block),
    /// Start after a stop: the stopped block goes on, or the program behind M00.
    ContinueBlock,
    /// The STOP key or the emergency stop of the control: as STOP_REQ and STOP_EMERGENCY_REQ of the program.
    StopBlock {
        /// Emergency stop.
        emergency: bool,
    },
    /// Central annulment: breaks the block and forgets queued ones.
    AbortBlock,
    /// Calls the procedure `_ON_EVENT` with this code in DR in the next cycle; at most 16 calls are queued.
    Event(i64),
    /// A key or menu item with a PLC command: calls the procedure `_ON_CMD` in the next cycle, among the events.
    PlcCommand {
        /// Its code, in DR.
        code: i32,
        /// Pressed (RLO = 1) or released.
        pressed: bool,
    },
}

/// A rate at which modules are executed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RateKind {
    /// MODULE_FAST, 1 ms.
    Fast,
    /// The other modules, 20 ms.
    Cycle,
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum RuntimeEvent {
    /// ESET or ESET1 was executed.
    Message {
        /// 20 ms cycle.
        cycle: u64,
        /// Message number.
        number: u32,
        /// Supplementary number.
        sub_id: Option<i64>,
        /// Shown (true) or removed (false; persistent messages).
        set: bool,
        /// Values for the message text.
        parameters: [Option<i64>; 3],
        /// The operation.
        pc: Pc,
    },
    /// A pass needed more instructions than [`Limits`](crate::Limits) grants its rate.
    Overrun {
        /// 20 ms cycle.
        cycle: u64,
        /// Which rate.
        rate: RateKind,
        /// Instructions executed.
        executed: u64,
        /// Instructions granted.
        limit: u64,
    },
    /// The PLC is in another state.
    StateChanged(PlcState),
    /// The program faulted; the PLC is stopped.
    Fault(Fault),
    /// A block was taken over: its functions are in the block cells.
    BlockStarted {
        /// 20 ms cycle.
        cycle: u64,
    },
    /// All functions and the movement of a block are done.
    BlockFinished {
        /// 20 ms cycle.
        cycle: u64,
    },
    /// A block was broken off by AbortBlock, StopPlc or Halt.
    BlockAborted {
        /// 20 ms cycle.
        cycle: u64,
    },
    /// A block was not accepted.
    BlockRejected(Rejection),
}
