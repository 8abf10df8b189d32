//! Frames and messages of the TECHNOL debug protocol. `PROTOCOL.md` beside this crate describes it for people
//! who write another end.
//!
//! `no_std` + `alloc`; nothing here knows a clock or a port: time comes in as microseconds, bytes come in and go
//! out as slices.
//!
//! - [`frame`]: one frame to bytes and back.
//! - [`message`]: what the frames carry.
//! - [`HostSession`] and [`TargetSession`]: the two ends as state machines. Both are driven the same way: hand
//!   over what arrived (`receive`), let time pass (`poll`), take what has to be sent (`transmit`), act on what
//!   came out (`next`), in this order, again at the time that `poll` returned or when bytes arrive.
#![no_std]

extern crate alloc;

mod arrived;
mod bulk;
mod events;
pub mod frame;
mod host;
pub mod message;
mod parts;
mod remote_files;
mod silence;
mod stream;
mod target;
mod timing;

pub use arrived::Arrived;
pub use frame::{Frame, FrameDecoder, FrameError};
pub use host::{HostEvent, HostSession, LossReason, Ticket};
pub use stream::{
    Freshness, Layout, MechanismSample, Ran, Sample, SampleDecoder, SampleSource, Streams, Taken, TraceSample,
};
pub use target::{TargetInput, TargetSession};
pub use timing::Timing;
