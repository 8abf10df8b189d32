//! Bytes from one thread to another: the link inside a process, and what a reading thread fills.

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use technol_wire::Timing;

use crate::link::Link;

/// Bytes that wait; a writer waits beyond this.
const CAPACITY: usize = 1 << 20;

#[derive(Debug, Default)]
struct Content {
    bytes: VecDeque<u8>,
    closed: bool,
}

/// One direction.
#[derive(Debug, Default)]
pub(crate) struct Pipe {
    content: Mutex<Content>,
    changed: Condvar,
}

impl Pipe {
    /// No thread panics while it holds the lock, and the content is whole at every moment anyway.
    fn lock(&self) -> MutexGuard<'_, Content> {
        self.content.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits while the pipe is full, until it is closed.
    pub(crate) fn write(&self, bytes: &[u8]) -> io::Result<()> {
        let mut content = self.lock();
        while content.bytes.len() >= CAPACITY && !content.closed {
            content = self.changed.wait(content).unwrap_or_else(PoisonError::into_inner);
        }
        if content.closed {
            return Err(gone());
        }
        content.bytes.extend(bytes);
        self.changed.notify_all();
        Ok(())
    }

    /// What was written before the pipe was closed is still read.
    pub(crate) fn read(&self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        let deadline = Instant::now() + timeout;
        let mut content = self.lock();
        while content.bytes.is_empty() {
            if content.closed {
                return Err(gone());
            }
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Ok(0);
            }
            let waited = self.changed.wait_timeout(content, left);
            content = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        let count = buffer.len().min(content.bytes.len());
        for (to, from) in buffer.iter_mut().zip(content.bytes.drain(..count)) {
            *to = from;
        }
        self.changed.notify_all();
        Ok(count)
    }

    pub(crate) fn close(&self) {
        self.lock().closed = true;
        self.changed.notify_all();
    }
}

fn gone() -> io::Error {
    io::Error::new(io::ErrorKind::BrokenPipe, "the other end has closed the link")
}

/// One end of a link inside the process. Dropping it closes the link for the other end.
#[derive(Debug)]
pub struct MemoryLink {
    incoming: Arc<Pipe>,
    outgoing: Arc<Pipe>,
}

/// Both ends of a link inside the process.
#[must_use]
pub fn pair() -> (MemoryLink, MemoryLink) {
    let (there, back) = (Arc::new(Pipe::default()), Arc::new(Pipe::default()));
    let near = MemoryLink { incoming: Arc::clone(&back), outgoing: Arc::clone(&there) };
    (near, MemoryLink { incoming: there, outgoing: back })
}

impl Link for MemoryLink {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.outgoing.write(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.incoming.read(buffer, timeout)
    }

    /// Silence means nothing here: an end that is gone has closed the link.
    fn timing(&self) -> Timing {
        Timing { silence_us: None, ..Timing::default() }
    }
}

impl Drop for MemoryLink {
    fn drop(&mut self) {
        self.incoming.close();
        self.outgoing.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_arrive_in_order_and_the_end_is_noticed_after_the_last() {
        let (mut near, mut far) = pair();
        let mut buffer = [0; 4];
        assert_eq!(far.receive(&mut buffer, Duration::ZERO).unwrap(), 0);
        near.send(b"abcdef").unwrap();
        drop(near);
        assert_eq!(far.receive(&mut buffer, Duration::ZERO).unwrap(), 4);
        assert_eq!(&buffer, b"abcd");
        assert_eq!(far.receive(&mut buffer, Duration::ZERO).unwrap(), 2);
        assert_eq!(far.receive(&mut buffer, Duration::ZERO).unwrap_err().kind(), io::ErrorKind::BrokenPipe);
        assert!(far.send(b"x").is_err());
    }

    #[test]
    fn a_waiting_end_wakes_up_when_bytes_come() {
        let (mut near, mut far) = pair();
        let reader = std::thread::spawn(move || {
            let mut buffer = [0; 4];
            far.receive(&mut buffer, Duration::from_secs(30)).map(|n| buffer[..n].to_vec())
        });
        near.send(b"hi").unwrap();
        assert_eq!(reader.join().unwrap().unwrap(), b"hi");
    }
}
