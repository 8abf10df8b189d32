//! Serial ports of the program (manual 23): bounded queues for each logical channel; the line empties the transmit queue at
//! its speed.

use alloc::collections::{BTreeMap, VecDeque};
use alloc::vec::Vec;

use technol_image::service::Service;
use technol_runtime::{Call, FaultKind};

/// Characters that wait in a queue of a channel.
pub const SERIAL_QUEUE: usize = 256;
/// Characters kept for the other side of the line; the oldest go first.
const SENT: usize = 4096;
/// Bits of a character on the line, start and stop with it.
const CHARACTER_BITS: u32 = 10;

/// Flags of COM_CONTROL STATE.
const ERROR: i64 = 1;
const NOT_CONFIGURED: i64 = 2;
const SEND_OVER: i64 = 4;
const RECV_OVER: i64 = 8;

/// A logical channel with its line.
#[derive(Clone, Debug)]
pub struct SerialPort {
    baud: u32,
    failed: bool,
    transmit: VecDeque<u8>,
    receive: VecDeque<u8>,
    sent: VecDeque<u8>,
    /// Bit times, in thousandths, that the line has had for the character on it.
    elapsed: u32,
    send_over: bool,
    recv_over: bool,
}

impl Default for SerialPort {
    fn default() -> SerialPort {
        SerialPort {
            baud: 9600,
            failed: false,
            transmit: VecDeque::with_capacity(SERIAL_QUEUE),
            receive: VecDeque::with_capacity(SERIAL_QUEUE),
            sent: VecDeque::with_capacity(SENT),
            elapsed: 0,
            send_over: false,
            recv_over: false,
        }
    }
}

impl SerialPort {
    /// Speed of the line in bits a second, 9600 at first; 0 stops it.
    pub fn set_baud(&mut self, baud: u32) {
        self.baud = baud;
    }

    /// The line is broken (true): nothing comes or goes, the program sees PLC_COM_ERROR.
    pub fn set_failed(&mut self, failed: bool) {
        self.failed = failed;
    }

    /// The line is broken.
    #[must_use]
    pub fn is_failed(&self) -> bool {
        self.failed
    }

    /// Characters that arrive for the program. Those for which its queue has no room are lost, which it is told
    /// by PLC_COM_RECV_OVER; on a broken line nothing arrives.
    pub fn feed(&mut self, bytes: &[u8]) {
        if self.failed {
            return;
        }
        let room = SERIAL_QUEUE.saturating_sub(self.receive.len());
        self.receive.extend(bytes.iter().take(room));
        self.recv_over |= bytes.len() > room;
    }

    /// Takes what the program sent and the line has carried; of more than 4096 characters the last.
    pub fn take_sent(&mut self) -> Vec<u8> {
        self.sent.drain(..).collect()
    }

    /// One millisecond of the line.
    fn tick(&mut self) {
        if self.failed || self.transmit.is_empty() {
            self.elapsed = 0;
            return;
        }
        self.elapsed = self.elapsed.saturating_add(self.baud);
        while self.elapsed >= CHARACTER_BITS * 1000 {
            let Some(byte) = self.transmit.pop_front() else { return };
            self.elapsed -= CHARACTER_BITS * 1000;
            if self.sent.len() == SENT {
                self.sent.pop_front();
            }
            self.sent.push_back(byte);
        }
    }

    /// All of them, or none.
    fn queue(&mut self, bytes: &[u8]) -> bool {
        let full = bytes.len() > SERIAL_QUEUE - self.transmit.len();
        self.send_over |= full;
        let taken = !full && !self.failed;
        if taken {
            self.transmit.extend(bytes);
        }
        taken
    }

    fn state(&self) -> i64 {
        let flags = [(self.failed, ERROR), (self.send_over, SEND_OVER), (self.recv_over, RECV_OVER)];
        flags.iter().filter(|(set, _)| *set).map(|(_, flag)| flag).sum()
    }

    fn clear(&mut self) {
        self.receive.clear();
        (self.send_over, self.recv_over) = (false, false);
    }
}

/// The channels that are configured.
#[derive(Clone, Debug, Default)]
pub(super) struct Serial {
    ports: BTreeMap<u8, SerialPort>,
}

impl Serial {
    pub(super) fn configured(&self, number: u8) -> Option<&SerialPort> {
        self.ports.get(&number)
    }

    pub(super) fn port(&mut self, number: u8) -> &mut SerialPort {
        self.ports.entry(number).or_default()
    }

    /// One millisecond.
    pub(super) fn tick(&mut self) {
        self.ports.values_mut().for_each(SerialPort::tick);
    }

    /// A start of the PLC: what waits in the queues is gone.
    pub(super) fn start(&mut self) {
        for port in self.ports.values_mut() {
            port.transmit.clear();
            port.clear();
        }
    }

    pub(super) fn execute(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let number = call.integer(0)?.and_then(|number| u8::try_from(number).ok());
        let port = number.and_then(|number| self.ports.get_mut(&number));
        match call.service() {
            Service::ComSend => {
                let value = if call.is_given(1) { call.integer(1)? } else { None };
                let byte = value.unwrap_or(call.dr()) as u8;
                call.set_rlo(!port.is_some_and(|port| port.queue(&[byte])));
            }
            Service::ComSendStr => {
                // More than a queue can ever hold is refused, whatever lies there.
                let len = call.unsigned(2)?.map_or(0, |len| len.clamp(0, SERIAL_QUEUE as i64 + 1) as u32);
                let bytes = match call.area(1)? {
                    Some((addr, _)) => call.bytes(addr, len)?,
                    None => &[],
                };
                let queued = port.is_some_and(|port| port.queue(bytes));
                call.set_rlo(!queued);
            }
            Service::ComRecv => {
                let byte = port.and_then(|port| port.receive.pop_front());
                call.set_rlo(byte.is_none());
                match byte {
                    Some(byte) if call.is_given(1) => call.store(1, i64::from(byte))?,
                    Some(byte) => call.set_dr(i64::from(byte)),
                    None => {}
                }
            }
            _ => match (call.keyword(1), port) {
                (Some("CLEAR"), port) => {
                    if let Some(port) = port {
                        port.clear();
                    }
                }
                (Some("RECEIVED"), port) => {
                    call.set_dr(port.map_or(0, |port| port.receive.len() as i64));
                }
                (_, port) => call.set_dr(port.map_or(NOT_CONFIGURED, |port| port.state())),
            },
        }
        Ok(())
    }
}
