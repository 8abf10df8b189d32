//! Serial ports of the program (COM_*) on real lines: `[[serial]]` with `port` in `machine.toml`.
//!
//! What the program sends leaves at the pace of its simulated line; what arrives waits for the next cycle. Nothing here waits for a
//! device: each has a thread of its own, with queues that have an end.

use std::io::{ErrorKind, Read, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TryRecvError, TryRecvError::Empty, sync_channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use technol_machine::config::Serial;
use technol_machine::{MachineConfig, SimulatedControl};

use crate::serial::open_port;

/// Pieces that wait on the way to a device, and from it.
const PIECES: usize = 64;
/// Bytes of a piece.
const PIECE: usize = 256;
/// How long a device is waited for in one go.
const WAIT: Duration = Duration::from_millis(5);
/// Until a device that does not work is tried again.
const AGAIN: Duration = Duration::from_millis(500);
const BAUD: u32 = 9600;

/// All lines of a control.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    lines: Vec<Line>,
}

/// A device at a channel.
#[derive(Debug)]
struct Line {
    channel: u8,
    /// It is open.
    works: Arc<AtomicBool>,
    end: Arc<AtomicBool>,
    out: Option<SyncSender<Vec<u8>>>,
    arrived: Receiver<Vec<u8>>,
    thread: Option<JoinHandle<()>>,
}

impl Lines {
    /// Opens what the machine names. A device that is not there is waited for; the program sees PLC_COM_ERROR until then.
    pub(crate) fn open(machine: Option<&MachineConfig>) -> Lines {
        let named = machine.map(|machine| machine.serial.as_slice()).unwrap_or_default();
        Lines { lines: named.iter().filter_map(Line::open).collect() }
    }

    /// Between two cycles: what the program has sent goes out, what has arrived comes in.
    pub(crate) fn exchange(&mut self, control: &mut SimulatedControl) {
        for line in &mut self.lines {
            let port = control.serial_mut(line.channel);
            port.set_failed(!line.works.load(Ordering::Relaxed));
            let sent = port.take_sent();
            if let Some(out) = line.out.as_ref().filter(|_| !sent.is_empty()) {
                // A device that takes nothing loses what comes, as an open line does.
                let _ = out.try_send(sent);
            }
            // An arrived piece goes in as a whole; what has no room is told to the program.
            for piece in line.arrived.try_iter().take(PIECES) {
                port.feed(&piece);
            }
        }
    }
}

impl Line {
    fn open(described: &Serial) -> Option<Line> {
        let device = described.port.clone()?;
        let baud = described.baud.unwrap_or(BAUD);
        let (out, outgoing) = sync_channel(PIECES);
        let (incoming, arrived) = sync_channel(PIECES);
        let (works, end) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicBool::new(false)));
        let (open, ended) = (Arc::clone(&works), Arc::clone(&end));
        let thread = thread::spawn(move || {
            while !ended.load(Ordering::Relaxed) {
                if let Ok(mut port) = open_port(&device, baud, WAIT) {
                    open.store(true, Ordering::Relaxed);
                    carry(port.as_mut(), &outgoing, &incoming, &ended);
                    open.store(false, Ordering::Relaxed);
                }
                if !ended.load(Ordering::Relaxed) {
                    // What was meant for a device that is gone does not wait for another one.
                    while outgoing.try_recv().is_ok() {}
                    thread::park_timeout(AGAIN);
                }
            }
        });
        Some(Line { channel: described.channel, works, end, out: Some(out), arrived, thread: Some(thread) })
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        // Without a sender the thread carries what is left and ends.
        self.out = None;
        self.end.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            // It has nothing to report; a panic in it has already been printed.
            let _ = thread.join();
        }
    }
}

/// Carries bytes both ways until the device is gone or the target ends.
fn carry(
    port: &mut (impl Read + Write + ?Sized),
    outgoing: &Receiver<Vec<u8>>,
    incoming: &SyncSender<Vec<u8>>,
    ended: &AtomicBool,
) {
    let mut buffer = [0; PIECE];
    loop {
        loop {
            match outgoing.try_recv() {
                Ok(piece) => {
                    if !write(port, &piece, ended) {
                        return;
                    }
                }
                Err(Empty) => break,
                Err(TryRecvError::Disconnected) => return,
            }
        }
        match port.read(&mut buffer) {
            Ok(0) => return,
            // A program that takes nothing loses what comes.
            Ok(count) => drop(incoming.try_send(buffer[..count].to_vec())),
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted) => {}
            Err(_) => return,
        }
    }
}

/// Writes a piece, however often the device has to be waited for; false when it is gone or the target ends.
fn write(port: &mut (impl Write + ?Sized), mut piece: &[u8], ended: &AtomicBool) -> bool {
    while !piece.is_empty() {
        match port.write(piece) {
            Ok(count) => piece = &piece[count..],
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted) => {
                if ended.load(Ordering::Relaxed) {
                    return false;
                }
            }
            Err(_) => return false,
        }
    }
    true
}
