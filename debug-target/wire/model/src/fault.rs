//! What happens to bytes on their way.

use crate::random::Random;

/// One fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// One bit of a byte is another one.
    BitError,
    /// A byte does not arrive.
    Lost,
    /// A byte arrives that nobody sent, before the one meant.
    Inserted,
    /// A byte arrives twice.
    Repeated,
    /// So many bytes from there on arrive as noise.
    Burst(usize),
}

impl Fault {
    /// The kinds, with a burst that fits into two of the shortest frames.
    pub const KINDS: [Fault; 5] =
        [Fault::BitError, Fault::Lost, Fault::Inserted, Fault::Repeated, Fault::Burst(8)];

    /// Lets the fault happen to these bytes at this place, which must exist.
    pub fn strike(self, bytes: &mut Vec<u8>, at: usize, random: &mut Random) {
        match self {
            Fault::BitError => bytes[at] ^= 1 << random.below(8),
            Fault::Lost => drop(bytes.remove(at)),
            Fault::Inserted => bytes.insert(at, random.below(256) as u8),
            Fault::Repeated => bytes.insert(at, bytes[at]),
            Fault::Burst(len) => {
                for byte in bytes.iter_mut().skip(at).take(len) {
                    *byte = random.below(256) as u8;
                }
            }
        }
    }
}

/// How often which fault happens: probabilities from 0 to 1. The default is a clean line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Faults {
    /// A bit is flipped, for each bit.
    pub bit_error: f64,
    /// A byte does not arrive, for each byte.
    pub lost: f64,
    /// A byte is put in before it, for each byte.
    pub inserted: f64,
    /// A byte arrives twice, for each byte.
    pub repeated: f64,
    /// A burst of noise begins, for each byte.
    pub burst: f64,
    /// How many bytes a burst makes noise of.
    pub burst_len: usize,
    /// A whole frame (what ends with a zero) does not arrive.
    pub frame_lost: f64,
    /// A frame arrives a second time, up to 60 ms later.
    pub frame_doubled: f64,
    /// A frame comes up to 60 ms late, and so behind others.
    pub frame_late: f64,
}

impl Faults {
    /// Only flipped bits, this often.
    #[must_use]
    pub fn bit_errors(rate: f64) -> Self {
        Faults { bit_error: rate, ..Faults::default() }
    }

    /// Nothing happens to bytes.
    pub(crate) fn spares_bytes(&self) -> bool {
        [self.bit_error, self.lost, self.inserted, self.repeated, self.burst].iter().all(|p| *p <= 0.0)
    }
}
