//! Serving clients: over any pair of byte streams, standard input and output, or TCP.

use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel, sync_channel};

use crate::connection::Connector;
use crate::outbox::{Outbox, QUEUE};
use crate::project::Builder;
use crate::session::{ClientInput, Session};
use crate::transport::Decoder;

/// Bytes read at once.
const READ: usize = 64 * 1024;

/// What an adapter needs from outside.
#[derive(Clone)]
pub struct Surroundings {
    /// Opens links to targets.
    pub connector: Arc<dyn Connector>,
    /// Builds programs.
    pub builder: Arc<dyn Builder>,
}

/// Serves one client and returns when it disconnected or is gone, and everything has been written.
///
/// Three threads: one reads and cuts messages, one writes, and this one runs the session. The reading thread may
/// outlive the session until its stream ends (a read cannot be interrupted).
pub fn serve(
    input: impl Read + Send + 'static,
    output: impl Write + Send + 'static,
    surroundings: &Surroundings,
) -> io::Result<()> {
    let (received, inbox) = channel();
    let (sink, outgoing) = sync_channel(QUEUE);
    std::thread::Builder::new().name("dap read".into()).spawn(move || read(input, &received))?;
    let writer =
        std::thread::Builder::new().name("dap write".into()).spawn(move || write(output, &outgoing))?;
    let Surroundings { connector, builder } = surroundings.clone();
    Session::new(inbox, Outbox::new(sink), connector, builder).run();
    // The session has dropped the sink: the writer ends when all is written.
    writer.join().unwrap_or(Ok(()))
}

/// Serves one client on standard input and output.
pub fn serve_stdio(surroundings: &Surroundings) -> io::Result<()> {
    serve(io::stdin(), io::stdout(), surroundings)
}

/// Serves every client that connects, each in a session of its own, until the listener fails.
pub fn serve_tcp(listener: &TcpListener, surroundings: &Surroundings) -> io::Result<()> {
    loop {
        let (stream, _) = listener.accept()?;
        let surroundings = surroundings.clone();
        std::thread::Builder::new()
            .name("dap session".into())
            .spawn(move || serve_stream(&stream, &surroundings))?;
    }
}

/// Serves the client at the other end of a connection and closes it.
pub fn serve_stream(stream: &TcpStream, surroundings: &Surroundings) -> io::Result<()> {
    stream.set_nodelay(true)?;
    // A client that does not read must not hold the writing thread for ever.
    stream.set_write_timeout(Some(std::time::Duration::from_secs(10)))?;
    let result = serve(stream.try_clone()?, stream.try_clone()?, surroundings);
    // Ends the reading thread as well.
    let _ = stream.shutdown(std::net::Shutdown::Both);
    result
}

fn read(mut input: impl Read, received: &Sender<ClientInput>) {
    let mut decoder = Decoder::default();
    let mut buffer = vec![0; READ];
    loop {
        match input.read(&mut buffer) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Ok(0) | Err(_) => break,
            Ok(n) => decoder.push(&buffer[..n]),
        }
        while let Some(incoming) = decoder.next() {
            if received.send(ClientInput::Incoming(incoming)).is_err() {
                return;
            }
        }
    }
    // The session may be over already.
    let _ = received.send(ClientInput::Gone);
}

fn write(mut output: impl Write, outgoing: &Receiver<Vec<u8>>) -> io::Result<()> {
    while let Ok(bytes) = outgoing.recv() {
        output.write_all(&bytes)?;
        output.flush()?;
    }
    Ok(())
}
