//! What the target does on each request.

use technol_image::container::decode_program;
use technol_machine::Plant;
use technol_runtime::{Command, StopReason};
use technol_wire::message::{
    BreakpointState, ContentHash, Event, Failure, FileRequest, Limits, LostPolicy, PROTOCOL_VERSION,
    Registers, Request, Response, Resume, feature,
};

use crate::convert;
use crate::core::{Download, TargetCore};
use crate::simulation::Simulation;

/// Longest program that is taken, in bytes.
const MOST_PROGRAM: u32 = 64 << 20;

type Answer = Result<Response, Failure>;

impl TargetCore {
    /// Acts on a request, and answers it. `limits` are those of the link it came over.
    pub fn answer(&mut self, request: Request, limits: Limits) -> Response {
        let answer = match request {
            Request::Hello { session, .. } => Ok(self.hello(session, limits)),
            Request::Status => Ok(Response::Status(self.status())),
            Request::Download { len, hash } => self.announce(len, hash),
            Request::Commit => self.commit(),
            Request::Start { cold, stop_on_entry } => self.start(cold, stop_on_entry),
            Request::Stop => self.stop(),
            Request::Clear => self.clear(),
            Request::SetBreakpoints { pcs } => self.set_breakpoints(&pcs, limits),
            Request::Resume(how) => self.resume(how),
            Request::Pause => self.pause(),
            Request::Registers => {
                self.loaded().map(|s| Response::Registers(convert::registers(s.runtime().registers())))
            }
            Request::MachineRegisters => self
                .loaded()
                .map(|s| Response::MachineRegisters(convert::machine_registers(s.runtime().registers()))),
            Request::SetRegisters(registers) => self.set_registers(registers),
            Request::Read { pieces } => self.read(&pieces, limits),
            Request::Write { addr, bytes } => self.write(addr, &bytes),
            Request::WriteBits { addr, mask, value } => self.write_bits(addr, mask, value),
            Request::CallStack => self.call_stack(),
            Request::Sequences => self
                .loaded()
                .map(|s| Response::Sequences(s.runtime().sequences().map(convert::sequence).collect())),
            Request::SetSequence { sequence, active } => self.set_sequence(sequence, active),
            Request::SetFault { name, on } => self.switch(|plant| plant.set_fault(&name, on)),
            Request::Press { key, down } => self.switch(|plant| plant.press(&key, down)),
            Request::Goodbye { stop } => Ok(self.goodbye(stop)),
            Request::OnLinkLost(policy) => {
                self.lost_policy = policy;
                Ok(Response::Done)
            }
            // The end of the link fills in what it knows about damage.
            Request::Echo { bytes } => Ok(Response::Echo { bytes, damaged: 0 }),
            Request::Files(request) => self.remote_files(&request, limits),
            // Streams belong to the end of a link, which does not ask here.
            Request::Subscribe(_) | Request::Unsubscribe { .. } => Err(Failure::Unsupported),
        };
        answer.unwrap_or_else(Response::Failed)
    }

    fn loaded(&mut self) -> Result<&mut Simulation, Failure> {
        self.simulation.as_mut().ok_or(Failure::NoProgram)
    }

    /// The loaded program, if it is held.
    fn held(&mut self) -> Result<&mut Simulation, Failure> {
        let simulation = self.loaded()?;
        if simulation.runtime().stopped().is_some() { Ok(simulation) } else { Err(Failure::NotStopped) }
    }

    /// A new host finds no break-points of another one, but a program that is held stays so.
    fn hello(&mut self, session: u32, limits: Limits) -> Response {
        if self.session.replace(session) != Some(session) {
            self.events.clear();
            if let Some(simulation) = &mut self.simulation {
                simulation.runtime_mut().set_breakpoints(&[]);
            }
        }
        self.repeat_stop();
        let files = if self.files.is_some() { feature::FILES } else { 0 };
        Response::Hello {
            version: PROTOCOL_VERSION,
            limits,
            boot: self.boot(),
            status: self.status(),
            features: feature::LOST_POLICY
                | feature::ECHO
                | feature::RESUMED_DOWNLOAD
                | feature::STREAMS
                | feature::MACHINE_REGISTERS
                | feature::TRACED_REGISTERS
                | files,
        }
    }

    fn remote_files(&mut self, request: &FileRequest, limits: Limits) -> Answer {
        let Some(folder) = &self.files else { return Err(Failure::Unsupported) };
        if let FileRequest::Store { path } = request {
            let download = self.download.take().filter(Download::is_intact).ok_or(Failure::Incomplete)?;
            return folder.store(path, &download.bytes);
        }
        folder.answer(request, limits)
    }

    fn announce(&mut self, len: u32, hash: ContentHash) -> Answer {
        if len > MOST_PROGRAM {
            return Err(Failure::TooLarge);
        }
        self.download = Some(Download::announced(self.download.take(), len, hash));
        Ok(Response::Done)
    }

    fn commit(&mut self) -> Answer {
        let download = self.download.take().filter(Download::is_intact).ok_or(Failure::Incomplete)?;
        let program =
            decode_program(&download.bytes).map_err(|error| Failure::BadProgram(error.to_string()))?;
        self.load(program, download.hash).map_err(|error| Failure::BadProgram(error.to_string()))?;
        self.events.push(Event::State(self.status()));
        Ok(Response::Done)
    }

    fn start(&mut self, cold: bool, stop_on_entry: bool) -> Answer {
        let simulation = self.loaded()?;
        simulation.start(cold);
        if stop_on_entry {
            simulation.runtime_mut().stop_at_entry();
        }
        self.pacer.at_once();
        Ok(Response::Done)
    }

    fn stop(&mut self) -> Answer {
        if !self.loaded()?.runtime().state().is_cycling() {
            return Err(Failure::NotRunning);
        }
        self.stop_plc();
        Ok(Response::Done)
    }

    fn clear(&mut self) -> Answer {
        self.loaded()?.runtime_mut().command(Command::ClearPlc);
        self.pacer.at_once();
        Ok(Response::Done)
    }

    fn set_breakpoints(&mut self, pcs: &[u32], limits: Limits) -> Answer {
        let simulation = self.loaded()?;
        let (taken, rest) = pcs.split_at(pcs.len().min(usize::from(limits.max_breakpoints)));
        let results = simulation.runtime_mut().set_breakpoints(taken);
        let too_many = rest.iter().map(|_| BreakpointState::TooMany);
        Ok(Response::Breakpoints(results.into_iter().map(convert::breakpoint).chain(too_many).collect()))
    }

    fn resume(&mut self, how: Resume) -> Answer {
        let simulation = self.held()?;
        let plc = simulation.runtime_mut();
        if plc.stopped().is_some_and(|stop| stop.reason == StopReason::Fault) {
            return Err(Failure::NotRunning);
        }
        plc.resume(convert::resume(how));
        self.pacer.at_once();
        self.note_hold();
        Ok(Response::Done)
    }

    fn pause(&mut self) -> Answer {
        let simulation = self.loaded()?;
        if !simulation.runtime().state().is_cycling() {
            return Err(Failure::NotRunning);
        }
        simulation.runtime_mut().pause();
        Ok(Response::Done)
    }

    fn set_registers(&mut self, registers: Registers) -> Answer {
        let runtime = self.held()?.runtime_mut();
        runtime.set_registers(convert::registers_back(registers, runtime.registers()));
        Ok(Response::Done)
    }

    fn read(&mut self, pieces: &[(u32, u16)], limits: Limits) -> Answer {
        let plc = self.loaded()?.runtime();
        let total: usize = pieces.iter().map(|(_, len)| usize::from(*len)).sum();
        if total > usize::from(limits.max_read) {
            return Err(Failure::TooLarge);
        }
        let mut bytes = Vec::with_capacity(total);
        for (addr, len) in pieces {
            let start = *addr as usize;
            let piece = plc
                .memory()
                .get(start..start.saturating_add(usize::from(*len)))
                .ok_or(Failure::OutOfRange)?;
            bytes.extend_from_slice(piece);
        }
        Ok(Response::Memory { cycle: plc.cycle(), bytes })
    }

    fn write(&mut self, addr: u32, bytes: &[u8]) -> Answer {
        let written = self.loaded()?.runtime_mut().write_memory(addr, bytes);
        written.map(|()| Response::Done).map_err(|_| Failure::OutOfRange)
    }

    fn write_bits(&mut self, addr: u32, mask: u8, value: u8) -> Answer {
        let plc = self.loaded()?.runtime_mut();
        let old = plc.memory().get(addr as usize).copied().ok_or(Failure::OutOfRange)?;
        let written = plc.write_memory(addr, &[old & !mask | value & mask]);
        written.map(|()| Response::Done).map_err(|_| Failure::OutOfRange)
    }

    fn call_stack(&mut self) -> Answer {
        let stack = self.held()?.runtime().call_stack();
        Ok(Response::CallStack(convert::frames(&stack)))
    }

    fn set_sequence(&mut self, number: u16, active: bool) -> Answer {
        let plc = self.loaded()?.runtime_mut();
        let unknown = || Failure::NotFound(format!("sequence {number}"));
        let sequence = plc.program().sequences.get(usize::from(number)).cloned().ok_or_else(unknown)?;
        plc.write_bit(sequence.active_addr, sequence.active_bit, active).map_err(|_| Failure::OutOfRange)?;
        if !active {
            for cell in [sequence.resume_cell, sequence.wait_cell, sequence.line_cell] {
                plc.write_memory(cell, &[0, 0]).map_err(|_| Failure::OutOfRange)?;
            }
        }
        Ok(Response::Done)
    }

    fn switch(&mut self, act: impl FnOnce(&mut Plant) -> Result<(), technol_machine::UnknownName>) -> Answer {
        match act(self.loaded()?.plant_mut()) {
            Ok(()) => Ok(Response::Done),
            Err(unknown) => Err(Failure::NotFound(unknown.to_string())),
        }
    }

    fn goodbye(&mut self, stop: bool) -> Response {
        self.let_go();
        if stop {
            self.stop_plc();
        }
        self.session = None;
        self.download = None;
        self.lost_policy = LostPolicy::default();
        Response::Done
    }
}
