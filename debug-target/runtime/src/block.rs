//! A block of a part program as it is handed to the PLC (manual 5.2 and 8.1).

mod cycle;

use core::fmt;

use crate::prepared::{BlockFlag, BlockReal, Prepared};

pub(crate) use cycle::{BlockCycle, QUEUE_LEN, Stage};

/// How a block was started.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BlockMode {
    /// Automatic: AUTPI.
    #[default]
    Auto,
    /// Central annulment: CAPI.
    CentralAnnulment,
    /// Reference run: REFPI.
    Reference,
    /// None of these (manual data input, jog).
    Other,
}

/// What copies of a block share, so that handing one on asks for no memory.
#[cfg(target_has_atomic = "ptr")]
pub type Shared<T> = alloc::sync::Arc<T>;
/// What copies of a block share, so that handing one on asks for no memory.
#[cfg(not(target_has_atomic = "ptr"))]
pub type Shared<T> = alloc::rc::Rc<T>;

/// A part-program block as handed to the PLC.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block {
    /// M functions, 0..=99, in the order they are written.
    pub m: Shared<[u8]>,
    /// T function, at most eight digits.
    pub t: Option<u32>,
    /// Spindle value for PB11/PB12, 0..=7FFFh.
    pub s: Option<u16>,
    /// H function, 0..=99.
    pub h: Option<u8>,
    /// The movement takes this many milliseconds; 0 is a block without movement. It does not count where the control
    /// moves axes to the targets of the block.
    pub motion_ms: u32,
    /// Rapid traverse: G00PI.
    pub rapid: bool,
    /// Mode of the start.
    pub mode: BlockMode,
    /// What the block tells beyond its functions; for `BLK[n]`.
    pub prepared: Option<Shared<Prepared>>,
}

impl Block {
    /// It has this property.
    #[must_use]
    pub fn has(&self, flag: BlockFlag) -> bool {
        self.prepared.as_ref().is_some_and(|prepared| prepared.flags.has(flag))
    }

    fn is_stop(&self, conditional: bool) -> bool {
        self.m.iter().any(|m| *m == 0 || *m == 1 && conditional)
    }

    /// M02 or M30: the part program ends here.
    #[must_use]
    pub fn ends_program(&self) -> bool {
        self.m.iter().any(|m| matches!(m, 2 | 30))
    }

    /// Milliseconds of its dwell, which is programmed in seconds (manual 27.4).
    pub(crate) fn dwell_ms(&self) -> u32 {
        let seconds = self.prepared.as_ref().and_then(|prepared| prepared.value(BlockReal::Delay));
        // More than fits, or no number, is the nearest that does.
        (seconds.unwrap_or(0.0) * 1000.0 + 0.5) as u32
    }

    pub(crate) fn has_targets(&self) -> bool {
        self.prepared.as_ref().is_some_and(|prepared| prepared.axes.iter().any(Option::is_some))
    }
}

/// Why a block was not accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rejection {
    /// The PLC is not running.
    NotRunning,
    /// 16 blocks are waiting already.
    QueueFull,
    /// An M or H function above 99, T above 99999999 or S above 7FFFh.
    OutOfRange,
    /// It moves axes, not by rapid traverse, and no block has programmed a feed. The part program ends with it.
    NoFeed,
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Rejection::NotRunning => "the PLC is not running; start it first",
            Rejection::QueueFull => "16 blocks are waiting already; wait until one has finished",
            Rejection::NoFeed => {
                "a block with targets has no feed; program a feed in it or before it, or rapid traverse"
            }
            Rejection::OutOfRange => "a function is out of range (M and H 0..99, T 8 digits, S 0..32767)",
        })
    }
}
