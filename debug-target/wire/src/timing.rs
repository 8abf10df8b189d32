//! Times of the protocol.

/// How long each end waits. The defaults suit 115200 baud and are right for faster links as well.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timing {
    /// The host pings when it has neither sent nor heard anything for this long, in microseconds.
    pub ping_us: u64,
    /// The peer is gone after this much silence, in microseconds; `None`: the link itself tells.
    pub silence_us: Option<u64>,
    /// A request or event without answer is repeated after this long, in microseconds; doubled after the first
    /// repetition of a request. (A Hello is repeated at `ping_us`.)
    pub resend_us: u64,
    /// How often a request or a download is repeated without any progress before the link counts as lost.
    pub retries: u32,
    /// After this much quiet a delimiter goes first, in microseconds, to end whatever noise the line picked up.
    pub idle_us: u64,
}

impl Default for Timing {
    fn default() -> Self {
        Timing {
            ping_us: 100_000,
            silence_us: Some(950_000),
            resend_us: 150_000,
            retries: 12,
            idle_us: 5_000,
        }
    }
}
