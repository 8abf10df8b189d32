//! A link over TCP.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Duration;

use crate::link::Link;
use crate::pipe::Pipe;

/// A peer that takes nothing for this long is gone.
const SEND_TIMEOUT: Duration = Duration::from_secs(2);

/// A TCP connection. A thread reads it, so that waiting for bytes has any precision.
#[derive(Debug)]
pub struct TcpLink {
    stream: TcpStream,
    incoming: Arc<Pipe>,
    reader: Option<JoinHandle<()>>,
}

impl TcpLink {
    /// Takes over a connection.
    pub fn new(stream: TcpStream) -> io::Result<TcpLink> {
        stream.set_nonblocking(false)?;
        stream.set_nodelay(true)?;
        stream.set_write_timeout(Some(SEND_TIMEOUT))?;
        let incoming = Arc::new(Pipe::default());
        let (mut source, pipe) = (stream.try_clone()?, Arc::clone(&incoming));
        let reader = thread::Builder::new().name("tcp link".into()).spawn(move || {
            let mut buffer = [0; 8192];
            loop {
                match source.read(&mut buffer) {
                    Ok(0) => break,
                    Ok(count) if pipe.write(&buffer[..count]).is_err() => break,
                    Ok(_) => {}
                    Err(error) if error.kind() == ErrorKind::Interrupted => {}
                    Err(_) => break,
                }
            }
            pipe.close();
        })?;
        Ok(TcpLink { stream, incoming, reader: Some(reader) })
    }
}

impl Link for TcpLink {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.stream.write_all(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.incoming.read(buffer, timeout)
    }
}

impl Drop for TcpLink {
    fn drop(&mut self) {
        self.incoming.close();
        // Wakes the reader; a connection that is gone already has woken it itself.
        let _ = self.stream.shutdown(Shutdown::Both);
        if let Some(reader) = self.reader.take() {
            let _ = reader.join();
        }
    }
}
