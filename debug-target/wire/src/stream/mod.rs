//! The stream class: samples of what the host watches, as it changes. Never repeated; a sample that is lost is
//! noticed with the next one, and until then the host knows how old its values are.

mod bits;
mod decode;
mod encode;
mod fold;
mod host;
mod layout;
mod target;

use alloc::vec::Vec;

pub use decode::{SampleDecoder, Taken};
pub use host::Freshness;
pub(crate) use host::Listener;
pub use layout::Layout;
pub use target::{MechanismSample, Ran, SampleSource, Streams, TraceSample};

/// What a stream told.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sample {
    /// Number of the stream.
    pub id: u8,
    /// Number of the sample: the target counts 20 ms, also while the program is held. Wraps at 2³².
    pub number: u32,
    /// Low 32 bits of the PLC cycle it belongs to.
    pub cycle: u32,
    /// The values, in the order of the [`Layout`].
    pub values: Vec<u64>,
    /// Extremes are those of the numbers after `number - window`.
    pub window: u32,
    /// That reaches back to the sample that was told before this one: no extreme is missing.
    pub contiguous: bool,
}
