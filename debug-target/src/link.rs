//! A way for bytes to the other end and back.

use std::io;
use std::time::Duration;

use technol_wire::Timing;
pub use technol_wire::message::Limits;

/// A byte stream to a peer.
pub trait Link: Send {
    /// Sends all bytes; blocks at most as long as the line takes. An error means that the link is gone.
    fn send(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// Receives some bytes; 0 when none came within `timeout` (zero: what is there already). An error means that
    /// the link is gone.
    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize>;

    /// Bytes the line carries in a second, if that bounds it: then no more is handed over than can be on its way.
    fn bytes_per_second(&self) -> Option<u32> {
        None
    }

    /// Whether a host that falls silent may come back over this same link, as over a cable. Otherwise the link is
    /// given up with its host, so that another one gets its turn.
    fn outlives_host(&self) -> bool {
        false
    }

    /// What fits through: a slow line wants short frames.
    fn limits(&self) -> Limits {
        if self.bytes_per_second().is_some() {
            Limits { max_payload: 240, max_read: 2048, max_breakpoints: 256, window: 8 }
        } else {
            Limits { max_payload: 4000, max_read: 32_000, max_breakpoints: 1024, window: 32 }
        }
    }

    /// Times of the protocol on this link.
    fn timing(&self) -> Timing {
        Timing::default()
    }
}

impl Link for Box<dyn Link> {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        (**self).send(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        (**self).receive(buffer, timeout)
    }

    fn bytes_per_second(&self) -> Option<u32> {
        (**self).bytes_per_second()
    }

    fn outlives_host(&self) -> bool {
        (**self).outlives_host()
    }

    fn limits(&self) -> Limits {
        (**self).limits()
    }

    fn timing(&self) -> Timing {
        (**self).timing()
    }
}
