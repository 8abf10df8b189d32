//! The CAN bus that program and control share (manual 9.4): queues, and procedures called for packets.

use alloc::collections::VecDeque;
use alloc::vec::Vec;

use technol_image::op::Addr;
use technol_image::service::Service;
use technol_runtime::{Call, ControlCall, FaultKind};

mod drive;
mod unit;

pub use drive::CanDrive;
pub(super) use drive::Drives;
pub use unit::CanUnit;
pub(super) use unit::Units;

/// Packets that wait in a queue of a channel.
pub const CAN_QUEUE: usize = 32;
/// Packets that wait for procedures, of all channels.
const CALLS: usize = 128;
/// Packets kept for the other side; the oldest go first.
const SENT: usize = 1024;
/// Packets a channel carries in a millisecond.
const SENT_PER_MILLI: usize = 2;
/// Requests of CAN_RECV_REQ.
const MAX_RECEIVERS: usize = 64;
/// Bytes of a packet in memory.
const LEN: usize = 12;

/// Results in DR.
const OK: i64 = 0;
const TRANSMIT_FULL: i64 = 1;
const RECEIVE_EMPTY: i64 = 2;

/// Object part and node part of an identifier.
const OBJECT: u16 = 0x780;
const NODE: u16 = 0x7F;

/// A packet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CanPacket {
    /// Identifier of 11 bits.
    pub id: u16,
    /// Asks for data instead of bringing them.
    pub remote: bool,
    /// Data bytes that count, 0 to 8.
    pub len: u8,
    /// The data; those behind `len` mean nothing.
    pub data: [u8; 8],
}

impl CanPacket {
    /// A packet with data; of more than 8 bytes the first 8.
    #[must_use]
    pub fn new(id: u16, data: &[u8]) -> CanPacket {
        let len = data.len().min(8);
        let mut packet = CanPacket { id: id & 0x7FF, remote: false, len: len as u8, data: [0; 8] };
        packet.data[..len].copy_from_slice(&data[..len]);
        packet
    }

    /// From its layout in memory; missing bytes are 0.
    fn from_bytes(bytes: &[u8]) -> CanPacket {
        let byte = |n: usize| bytes.get(n).copied().unwrap_or(0);
        let mut data = [0; 8];
        for (n, data) in data.iter_mut().enumerate() {
            *data = byte(4 + n);
        }
        let id = u16::from_le_bytes([byte(0), byte(1)]) & 0x7FF;
        CanPacket { id, remote: byte(2) != 0, len: byte(3).min(8), data }
    }

    fn to_bytes(self) -> [u8; LEN] {
        let mut bytes = [0; LEN];
        bytes[..2].copy_from_slice(&self.id.to_le_bytes());
        bytes[2] = u8::from(self.remote);
        bytes[3] = self.len;
        bytes[4..].copy_from_slice(&self.data);
        bytes
    }
}

/// A channel of the bus.
#[derive(Clone, Debug)]
struct Channel {
    /// Not connected: requests are refused and nothing is sent or received.
    inactive: bool,
    /// Nobody acknowledges: packets stay in the transmit queue.
    blocked: bool,
    /// The cable is cut: nothing is sent, and nothing arrives.
    cut: bool,
    transmit: VecDeque<CanPacket>,
    receive: VecDeque<CanPacket>,
    sent: VecDeque<CanPacket>,
}

impl Default for Channel {
    fn default() -> Channel {
        Channel {
            cut: false,
            inactive: false,
            blocked: false,
            transmit: VecDeque::with_capacity(CAN_QUEUE),
            receive: VecDeque::with_capacity(CAN_QUEUE),
            sent: VecDeque::with_capacity(SENT),
        }
    }
}

/// A request of CAN_RECV_REQ.
#[derive(Clone, Copy, Debug)]
struct Receiver {
    handle: u32,
    can: u8,
    objects: (u16, u16),
    nodes: (u16, u16),
    procedure: u16,
    addr: Addr,
    room: u32,
}

impl Receiver {
    fn wants(&self, can: u8, packet: CanPacket) -> bool {
        let (object, node) = (packet.id & OBJECT, packet.id & NODE);
        can == self.can
            && (self.objects.0..=self.objects.1).contains(&object)
            && (self.nodes.0..=self.nodes.1).contains(&node)
    }
}

/// Both channels.
#[derive(Clone, Debug)]
pub struct CanBus {
    channels: [Channel; 2],
    receivers: Vec<Receiver>,
    /// Packets on the way to procedures, by request, in the order of arrival.
    arrived: VecDeque<(u32, CanPacket)>,
    last_handle: u32,
    lost: u32,
}

impl Default for CanBus {
    fn default() -> CanBus {
        CanBus {
            channels: Default::default(),
            receivers: Vec::with_capacity(MAX_RECEIVERS),
            arrived: VecDeque::with_capacity(CALLS),
            last_handle: 0,
            lost: 0,
        }
    }
}

impl CanBus {
    fn channel(&mut self, can: u8) -> Option<&mut Channel> {
        self.channels.get_mut(usize::from(can).checked_sub(1)?)
    }

    /// Whether a channel (1, 2) works; both do at first.
    pub fn set_active(&mut self, can: u8, active: bool) {
        if let Some(channel) = self.channel(can) {
            channel.inactive = !active;
        }
    }

    /// Nobody on the channel acknowledges packets (true): they stay in the queue of the program.
    pub fn set_blocked(&mut self, can: u8, blocked: bool) {
        if let Some(channel) = self.channel(can) {
            channel.blocked = blocked;
        }
    }

    /// The cable of a channel is cut, or is there.
    pub(super) fn set_cut(&mut self, cut: impl Fn(u8) -> bool) {
        for (can, channel) in (1..).zip(&mut self.channels) {
            channel.cut = cut(can);
        }
    }

    /// A packet arrives: for the procedures that asked for it, else for CAN_RECV. Without room it is lost.
    pub fn feed(&mut self, can: u8, packet: CanPacket) {
        let Some(channel) = self.channel(can).filter(|channel| !channel.inactive && !channel.cut) else {
            return;
        };
        let room = channel.receive.len() < CAN_QUEUE;
        let wanted: Vec<u32> =
            self.receivers.iter().filter(|r| r.wants(can, packet)).map(|r| r.handle).collect();
        if wanted.is_empty() && room {
            if let Some(channel) = self.channel(can) {
                channel.receive.push_back(packet);
            }
        } else if wanted.is_empty() || self.arrived.len() + wanted.len() > CALLS {
            self.lost = self.lost.saturating_add(1);
        } else {
            self.arrived.extend(wanted.into_iter().map(|handle| (handle, packet)));
        }
    }

    /// Takes what was sent on a channel; of more than 1024 packets the last.
    pub fn take_sent(&mut self, can: u8) -> Vec<CanPacket> {
        self.channel(can).map(|channel| channel.sent.drain(..).collect()).unwrap_or_default()
    }

    /// Packets that arrived and found no room, since power-on.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.lost
    }

    /// One millisecond.
    pub(super) fn tick(&mut self) {
        let works = |channel: &&mut Channel| !channel.blocked && !channel.inactive && !channel.cut;
        for channel in self.channels.iter_mut().filter(works) {
            for _ in 0..SENT_PER_MILLI {
                let Some(packet) = channel.transmit.pop_front() else { break };
                if channel.sent.len() == SENT {
                    channel.sent.pop_front();
                }
                channel.sent.push_back(packet);
            }
        }
    }

    /// A start of the PLC: its requests and what waits is forgotten.
    pub(super) fn start(&mut self) {
        for channel in &mut self.channels {
            channel.transmit.clear();
            channel.receive.clear();
        }
        self.receivers.clear();
        self.arrived.clear();
    }

    /// The next procedure, with its packet in memory.
    pub(super) fn next_call(&mut self, memory: &mut [u8]) -> Option<ControlCall> {
        loop {
            let (handle, packet) = self.arrived.pop_front()?;
            // A request may have been cancelled since.
            let Some(receiver) = self.receivers.iter().find(|known| known.handle == handle) else { continue };
            let len = (receiver.room as usize).min(LEN);
            let start = receiver.addr as usize;
            if let Some(target) = memory.get_mut(start..start.saturating_add(len)) {
                target.copy_from_slice(&packet.to_bytes()[..len]);
            }
            return Some(ControlCall { procedure: receiver.procedure, dr: i64::from(receiver.can) });
        }
    }

    pub(super) fn execute(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        match call.service() {
            Service::CanSend => self.send(call),
            Service::CanRecv => self.receive(call),
            Service::CanRecvReq => self.request(call),
            _ => self.cancel(call),
        }
    }

    fn send(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let can = number(call, 0)? as u8;
        let bytes = match call.area(1)? {
            Some((addr, _)) => call.bytes(addr, LEN as u32)?,
            None => &[],
        };
        let packet = CanPacket::from_bytes(bytes);
        let channel =
            self.channel(can).filter(|channel| !channel.inactive && channel.transmit.len() < CAN_QUEUE);
        let result = match channel {
            Some(channel) => {
                channel.transmit.push_back(packet);
                OK
            }
            None => TRANSMIT_FULL,
        };
        call.set_dr(result);
        Ok(())
    }

    fn receive(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let can = number(call, 0)? as u8;
        let Some((addr, room)) = call.area(1)? else { return Ok(()) };
        let packet = self.channel(can).and_then(|channel| channel.receive.pop_front());
        call.set_dr(if packet.is_some() { OK } else { RECEIVE_EMPTY });
        match packet {
            Some(packet) => call.write(addr, &packet.to_bytes()[..LEN.min(room as usize)]),
            None => Ok(()),
        }
    }

    fn request(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let can = number(call, 0)? as u8;
        let range = |n: usize| -> Result<(u16, u16), FaultKind> {
            let low = number(call, n)?;
            Ok((low, if call.is_given(n + 1) { number(call, n + 1)? } else { low }))
        };
        let (objects, nodes) = (range(1)?, range(3)?);
        let (procedure, area) = (call.procedure(5), call.area(6)?);
        let active = self.channel(can).is_some_and(|channel| !channel.inactive);
        let accepted = active && self.receivers.len() < MAX_RECEIVERS;
        call.set_rlo(false);
        let (Some(procedure), Some((addr, room)), true) = (procedure, area, accepted) else { return Ok(()) };
        // A handle is positive in the DWORD that keeps it.
        self.last_handle = self.last_handle % i32::MAX.unsigned_abs() + 1;
        let handle = self.last_handle;
        self.receivers.push(Receiver { handle, can, objects, nodes, procedure, addr, room });
        call.set_rlo(true);
        call.set_dr(i64::from(handle));
        Ok(())
    }

    fn cancel(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let handle = call.integer(0)?;
        let before = self.receivers.len();
        self.receivers.retain(|known| Some(i64::from(known.handle)) != handle);
        call.set_rlo(self.receivers.len() < before);
        Ok(())
    }
}

/// A constant operand of a few bits; 0 for anything else.
fn number(call: &Call<'_>, n: usize) -> Result<u16, FaultKind> {
    Ok(call.integer(n)?.and_then(|number| u16::try_from(number).ok()).unwrap_or(0))
}
