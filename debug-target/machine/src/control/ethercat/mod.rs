//! The EtherCAT master and its slaves (manual 26). Its instructions take several cycles; each place in the program has at
//! most one request.

use alloc::vec::Vec;

use technol_runtime::{Call, FaultKind};

use super::transfer::Transfers;

pub(crate) mod layout;
mod order;
mod process;
mod requests;
mod slave;

pub use slave::{EcatSlave, EcatState};

use order::{Answer, NO_ANSWER, NO_MAILBOX, NO_SLAVE, Order, Request, STATE_LEN};

/// Cycles until a slave that does not answer is given up.
const TIMEOUT: u32 = 50;
/// Slaves of a master.
const MAX_SLAVES: u16 = 256;

/// Master 0 with its slaves.
#[derive(Clone, Debug)]
pub struct EtherCat {
    state: EcatState,
    goal: EcatState,
    slaves: Vec<EcatSlave>,
    answer_cycles: u32,
    transfers: Transfers<Request>,
    /// The program starts the exchange; it has done so.
    start_by_program: bool,
    started: bool,
    /// Requests of states that were taken up.
    asked: [bool; 5],
    image: process::Image,
}

impl Default for EtherCat {
    fn default() -> EtherCat {
        EtherCat {
            state: EcatState::Operational,
            goal: EcatState::Operational,
            slaves: Vec::new(),
            answer_cycles: 2,
            transfers: Transfers::default(),
            start_by_program: false,
            started: false,
            asked: [false; 5],
            image: process::Image::default(),
        }
    }
}

impl EtherCat {
    /// The slave at a place of the wiring, from 0; it and those before it are added when they are missing. `None`: places end at
    /// 255.
    pub fn slave_mut(&mut self, place: u16) -> Option<&mut EcatSlave> {
        if place >= MAX_SLAVES {
            return None;
        }
        let len = self.slaves.len().max(usize::from(place) + 1);
        self.slaves.resize_with(len, EcatSlave::default);
        self.slaves.get_mut(usize::from(place))
    }

    /// State of the master; OPERATIONAL at first.
    #[must_use]
    pub fn state(&self) -> EcatState {
        self.state
    }

    /// Cycles of 20 ms until a slave has answered: 2 at first, at least 1.
    pub fn set_answer_cycles(&mut self, cycles: u32) {
        self.answer_cycles = cycles.clamp(1, TIMEOUT - 1);
    }

    /// Makes room for an instruction of the program and its longest data.
    pub(super) fn prepare(&mut self, call: u16, len: usize) {
        self.transfers.prepare(call, Request::with_room(len));
    }

    /// A start of the PLC: its transfers are forgotten.
    pub(super) fn start(&mut self, cold: bool) {
        self.transfers.forget();
        self.asked = [false; 5];
        if cold {
            self.power_on();
        }
    }

    fn power_on(&mut self) {
        self.started = false;
        let state = if self.start_by_program { EcatState::Init } else { EcatState::Operational };
        (self.state, self.goal) = (state, state);
        self.slaves.iter_mut().for_each(|slave| slave.power_on(state));
    }

    /// Nobody reaches these slaves; they lose their connection and stop exchanging outputs.
    pub(super) fn set_lost(&mut self, lost: impl Fn(u16) -> bool) {
        for (place, slave) in (0..).zip(&mut self.slaves) {
            slave.set_lost(lost(place));
        }
    }

    /// Why the drive of a slave is in error.
    pub(super) fn set_error(&mut self, error: impl Fn(u16) -> Option<u16>) {
        for (place, slave) in (0..).zip(&mut self.slaves) {
            if let Some(drive) = &mut slave.drive {
                drive.machine.set_cause(error(place));
            }
        }
    }

    /// A cycle of 20 ms begins.
    pub(super) fn cycle(&mut self) {
        self.state = self.state.toward(self.goal);
        for slave in self.slaves.iter_mut().filter(|slave| slave.is_reached()) {
            slave.state = slave.state.toward(slave.goal);
        }
        let mut transfers = core::mem::take(&mut self.transfers);
        for request in transfers.under_way_mut().filter(|request| request.result.is_none()) {
            request.waited += 1;
            request.result = self.carry_out(request);
        }
        self.transfers = transfers;
    }

    /// The result, when it is time for one.
    fn carry_out(&mut self, request: &mut Request) -> Option<Result<Answer, u32>> {
        let order = match request.order {
            Ok(order) => order,
            Err(error) => return Some(Err(error)),
        };
        if order.slave().is_some_and(|slave| usize::from(slave) >= self.slaves.len()) {
            return Some(Err(NO_SLAVE));
        }
        let ready = match order {
            Order::Lead { slave, goal } => self.are_in(slave, goal),
            _ => request.waited >= self.answer_cycles && order.slave().is_none_or(|n| self.answers(n)),
        };
        match ready {
            true => Some(self.answer(order, request)),
            false if request.waited >= TIMEOUT => Some(Err(NO_ANSWER)),
            false => None,
        }
    }

    fn answers(&self, slave: u16) -> bool {
        self.slaves.get(usize::from(slave)).is_some_and(EcatSlave::is_reached)
    }

    fn are_in(&self, slave: Option<u16>, goal: EcatState) -> bool {
        match slave {
            Some(slave) => self.slaves.get(usize::from(slave)).is_some_and(|slave| slave.is_in(goal)),
            None => self.state == goal && self.slaves.iter().all(|slave| slave.is_in(goal)),
        }
    }

    fn answer(&mut self, order: Order, request: &mut Request) -> Result<Answer, u32> {
        let slave = match order {
            Order::Lead { .. } => return Ok(Answer::Done),
            Order::State { slave } => {
                let slave = slave.and_then(|slave| self.slaves.get(usize::from(slave)));
                let state = slave.map_or(self.state, |slave| slave.state);
                let len = request.wanted().min(STATE_LEN) as usize;
                return Ok(request.put(&(state as u32).to_le_bytes()[..len]));
            }
            _ => order.slave().and_then(|slave| self.slaves.get_mut(usize::from(slave))),
        };
        let slave = slave.ok_or(NO_SLAVE)?;
        if !slave.state.has_mailbox() {
            return Err(NO_MAILBOX);
        }
        let data = &request.data;
        match order {
            Order::ReadObject { index, subindex, .. } => {
                slave.refresh(index, subindex);
                slave.objects.upload(index, subindex).map(|bytes| request.put(bytes))
            }
            Order::WriteObject { index, subindex, .. } => {
                slave.objects.download(index, subindex, data).map(|()| Answer::Written(data.len()))
            }
            Order::ReadRegister { drive, idn, element, .. } => {
                slave.read_register(drive, idn, element).map(|bytes| request.put(bytes))
            }
            Order::WriteRegister { drive, idn, element, .. } => {
                slave.write_register(drive, idn, element, data).map(|()| Answer::Written(data.len()))
            }
            Order::Lead { .. } | Order::State { .. } => Ok(Answer::Done),
        }
    }

    /// A command to lead begins: who is addressed gets the goal.
    fn lead(&mut self, slave: Option<u16>, goal: EcatState) {
        if let Some(slave) = slave {
            if let Some(slave) = self.slaves.get_mut(usize::from(slave)) {
                slave.goal = goal;
            }
        } else {
            self.goal = goal;
            self.slaves.iter_mut().for_each(|slave| slave.goal = goal);
        }
    }

    pub(super) fn execute(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        if self.transfers.is_under_way(call) {
            return self.transfers.end_when(call, Request::finish);
        }
        let request = self.transfers.begin(call, |request| request.take(call))?;
        request.finish(call)?;
        if let Ok(Order::Lead { slave, goal }) = request.order {
            self.lead(slave, goal);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::EcatState::{Bootstrap, Init, Operational, PreOperational, SafeOperational};

    #[test]
    fn states_are_left_up_one_by_one_down_at_once_and_bootstrap_by_init() {
        for (from, goal, expected) in [
            (Init, Operational, [PreOperational, SafeOperational, Operational, Operational]),
            (Operational, PreOperational, [PreOperational; 4]),
            (Operational, Bootstrap, [Init, Bootstrap, Bootstrap, Bootstrap]),
            (Bootstrap, SafeOperational, [Init, PreOperational, SafeOperational, SafeOperational]),
            (Bootstrap, Init, [Init; 4]),
        ] {
            let mut state = from;
            for next in expected {
                state = state.toward(goal);
                assert_eq!(state, next, "{from:?} to {goal:?}");
            }
        }
    }
}
