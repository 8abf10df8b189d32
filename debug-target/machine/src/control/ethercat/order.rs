//! What an instruction asks of the EtherCAT master, and what it gets back.

use alloc::vec::Vec;

use technol_image::op::Addr;
use technol_image::service::Service;
use technol_runtime::{Call, FaultKind};

use super::slave::EcatState;

/// There is no such master, no such slave.
pub(super) const NO_MASTER: u32 = 1;
pub(super) const NO_SLAVE: u32 = 2;
/// It did not answer in time.
pub(super) const NO_ANSWER: u32 = 3;
/// The slave is in INIT or BOOTSTRAP.
pub(super) const NO_MAILBOX: u32 = 4;
/// The length is 0 or more than the place has, or the answer is longer.
pub(super) const BAD_LENGTH: u32 = 5;
/// No such command.
pub(super) const BAD_COMMAND: u32 = 6;
/// The flags do not name one element.
pub(super) const BAD_ELEMENT: u32 = 7;

/// Bytes of the answer with a state.
pub(super) const STATE_LEN: u32 = 4;

/// What to do.
#[derive(Clone, Copy, Debug)]
pub(super) enum Order {
    ReadObject {
        slave: u16,
        index: u16,
        subindex: u8,
    },
    WriteObject {
        slave: u16,
        index: u16,
        subindex: u8,
    },
    ReadRegister {
        slave: u16,
        drive: u8,
        idn: u16,
        element: u8,
    },
    WriteRegister {
        slave: u16,
        drive: u8,
        idn: u16,
        element: u8,
    },
    /// `None`: the master with all its slaves.
    Lead {
        slave: Option<u16>,
        goal: EcatState,
    },
    /// `None`: the master.
    State {
        slave: Option<u16>,
    },
}

impl Order {
    /// The slave it is about.
    pub(super) fn slave(self) -> Option<u16> {
        match self {
            Order::ReadObject { slave, .. }
            | Order::WriteObject { slave, .. }
            | Order::ReadRegister { slave, .. }
            | Order::WriteRegister { slave, .. } => Some(slave),
            Order::Lead { slave, .. } | Order::State { slave } => slave,
        }
    }
}

/// What came back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Answer {
    /// Data for the program, in [`Request::data`].
    Data,
    /// More data than the program has room for.
    TooLong,
    /// So many bytes were written.
    Written(usize),
    /// It is done.
    Done,
}

/// An instruction that is being carried out.
#[derive(Clone, Debug)]
pub(super) struct Request {
    pub(super) order: Result<Order, u32>,
    /// Cycles since it began.
    pub(super) waited: u32,
    pub(super) result: Option<Result<Answer, u32>>,
    /// What is written, or what was read.
    pub(super) data: Vec<u8>,
    /// Where data go, and how many were asked for.
    target: Option<Addr>,
    wanted: u32,
    length: Option<Addr>,
    flags: Option<(Addr, u8)>,
}

impl Default for Request {
    fn default() -> Request {
        Request::with_room(0)
    }
}

impl Request {
    /// A place for data of so many bytes.
    pub(super) fn with_room(len: usize) -> Request {
        Request {
            order: Err(BAD_COMMAND),
            waited: 0,
            result: None,
            data: Vec::with_capacity(len),
            target: None,
            wanted: 0,
            length: None,
            flags: None,
        }
    }

    /// Takes the operands as they are now.
    pub(super) fn take(&mut self, call: &Call<'_>) -> Result<(), FaultKind> {
        let mut data = core::mem::take(&mut self.data);
        data.clear();
        *self = Request { data, ..Request::default() };
        self.order = self.read(call)?;
        Ok(())
    }

    /// The operands as an order; the inner error goes to the program.
    fn read(&mut self, call: &Call<'_>) -> Result<Result<Order, u32>, FaultKind> {
        let length = match call.service() {
            Service::EcatCoeRead | Service::EcatCoeWrite => Some(5),
            Service::EcatCommand => matches!(call.integer(2)?, Some(20 | 21)).then_some(4),
            _ => Some(6),
        };
        if let Some(n) = length {
            self.length = call.area(n)?.map(|(addr, _)| addr);
        }
        if word(call, 0)? != 0 {
            return Ok(Err(NO_MASTER));
        }
        let slave = word(call, 1)?;
        match call.service() {
            Service::EcatCommand => self.command(call, slave),
            Service::EcatCoeRead | Service::EcatCoeWrite => {
                let (index, subindex) = (word(call, 2)?, word(call, 3)? as u8);
                let place = self.place(call, 4, 5)?;
                Ok(place.and_then(|(addr, len)| {
                    Ok(if call.service() == Service::EcatCoeRead {
                        Order::ReadObject { slave, index, subindex }
                    } else {
                        self.keep(call, addr, len)?;
                        Order::WriteObject { slave, index, subindex }
                    })
                }))
            }
            _ => {
                let (drive, element, idn) = (word(call, 2)? as u8, word(call, 3)? as u8, word(call, 4)?);
                self.flags = call.area(3)?.map(|(addr, _)| (addr, element));
                let place = self.place(call, 5, 6)?;
                if !element.is_power_of_two() {
                    return Ok(Err(BAD_ELEMENT));
                }
                Ok(place.and_then(|(addr, len)| {
                    Ok(if call.service() == Service::EcatSoeRead {
                        Order::ReadRegister { slave, drive, idn, element }
                    } else {
                        self.keep(call, addr, len)?;
                        Order::WriteRegister { slave, drive, idn, element }
                    })
                }))
            }
        }
    }

    fn command(&mut self, call: &Call<'_>, slave: u16) -> Result<Result<Order, u32>, FaultKind> {
        let command = call.integer(2)?.unwrap_or(0);
        let slave = (command >= 11 && command != 20).then_some(slave);
        if matches!(command, 20 | 21) {
            return Ok(self.place(call, 3, 4)?.map(|_| Order::State { slave }));
        }
        let goal = EcatState::of(if slave.is_some() { command - 10 } else { command });
        Ok(goal.map(|goal| Order::Lead { slave, goal }).ok_or(BAD_COMMAND))
    }

    /// Takes the place of data and their length: operands `n` and `len`.
    fn place(
        &mut self,
        call: &Call<'_>,
        n: usize,
        len: usize,
    ) -> Result<Result<(Addr, u32), u32>, FaultKind> {
        let wanted = call.unsigned(len)?.and_then(|len| u32::try_from(len).ok()).unwrap_or(0);
        let Some((addr, room)) = call.area(n)? else { return Ok(Err(BAD_LENGTH)) };
        if wanted == 0 || wanted > room {
            return Ok(Err(BAD_LENGTH));
        }
        (self.target, self.wanted) = (Some(addr), wanted);
        Ok(Ok((addr, wanted)))
    }

    /// Hands the result to the program; `false` when there is none yet.
    pub(super) fn finish(&self, call: &mut Call<'_>) -> Result<bool, FaultKind> {
        let Some(result) = &self.result else {
            call.set_rlo(false);
            call.set_dr(0);
            return Ok(false);
        };
        let mut error = result.as_ref().err().copied().unwrap_or(0);
        let mut count = 0;
        match (result, self.target) {
            (Ok(Answer::TooLong), _) => error = BAD_LENGTH,
            (Ok(Answer::Data), Some(addr)) => {
                call.write(addr, &self.data)?;
                count = self.data.len();
            }
            (Ok(Answer::Written(written)), _) => count = *written,
            _ => {}
        }
        if let (Some(length), false) = (self.length, matches!(result, Ok(Answer::Done))) {
            call.write(length, &(count as u32).to_le_bytes())?;
        }
        if let (Some((addr, element)), 0) = (self.flags, error) {
            call.write(addr, &[element])?;
        }
        call.set_rlo(true);
        call.set_dr(i64::from(error));
        Ok(true)
    }

    /// Takes what is written.
    fn keep(&mut self, call: &Call<'_>, addr: Addr, len: u32) -> Result<(), u32> {
        self.data.extend_from_slice(call.bytes(addr, len).map_err(|_| BAD_LENGTH)?);
        Ok(())
    }

    /// What was read, if the program has room for it.
    pub(super) fn put(&mut self, bytes: &[u8]) -> Answer {
        if bytes.len() > self.wanted as usize {
            return Answer::TooLong;
        }
        self.data.clear();
        self.data.extend_from_slice(bytes);
        Answer::Data
    }

    /// Bytes the program wants.
    pub(super) fn wanted(&self) -> u32 {
        self.wanted
    }
}

/// An unsigned operand of at most 16 bits.
fn word(call: &Call<'_>, n: usize) -> Result<u16, FaultKind> {
    Ok(call.unsigned(n)?.unwrap_or(0) as u16)
}
