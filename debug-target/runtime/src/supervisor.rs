//! The supervisor: what happens in a millisecond, and the life of the PLC (manual 5.2, 5.3).

use alloc::vec::Vec;
use core::cell::RefCell;

use technol_image::op::Op;
use technol_image::program::{ModuleKind, RegionKind, SequenceKind};
use technol_image::system;

use crate::block::{QUEUE_LEN, Rejection, Stage};
use crate::code::{is_stoppable, module_of};
use crate::context::{Context, Root};
use crate::control::{Control, ControlMessage, Hold, NoControl, Rate};
use crate::debugger::{Line, StopReason, module_and_file};
use crate::event::{Command, PlcState, RateKind, RuntimeEvent};
use crate::execute::{Exit, World, run, run_watched};
use crate::fault::{Fault, FaultKind};
use crate::plan::{Job, PlanKind};
use crate::ports::{self, InputImage};
use crate::runtime::{Position, Runtime, TickOutcome};
use crate::sequence;
use crate::trace::{Recorder, Untraced};

/// Messages the control may report by itself in a cycle; the others wait for the next.
const MESSAGES_PER_CYCLE: usize = 16;
/// A call of an event procedure that waits for its cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlcEvent {
    /// `_ON_EVENT` with this code.
    Event(i64),
    /// `_ON_CMD` with code and key.
    Command { code: i32, pressed: bool },
}
/// Procedures the control may call in a cycle; the others wait for the next.
const CALLS_PER_CYCLE: usize = 256;

/// How far a job came.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Progress {
    Done,
    /// Held by the debugger or by a fault.
    Stopped,
}

impl Runtime {
    /// One millisecond of the PLC: MODULE_FAST, and in every 20th the 20 ms cycle. When the debugger stops
    /// in the middle, later calls execute only MODULE_CONT until [`resume`](Runtime::resume); the call after
    /// that finishes the millisecond. Events are appended in the order they happen.
    ///
    /// There is no control: an instruction that needs one is a fault.
    pub fn tick(&mut self, inputs: &InputImage, events: &mut Vec<RuntimeEvent>) -> TickOutcome {
        self.tick_with(inputs, &mut NoControl, events)
    }

    /// As [`tick`](Runtime::tick), with a control around the program.
    pub fn tick_with(
        &mut self,
        inputs: &InputImage,
        control: &mut dyn Control,
        events: &mut Vec<RuntimeEvent>,
    ) -> TickOutcome {
        let world = &mut World { control, events };
        self.drop_held_tick_for_a_start();
        if self.debugger.stop.is_some() {
            self.hold(inputs, world);
            return TickOutcome::Stopped;
        }
        if self.position.is_none() {
            self.position = self.next_plan(world).map(at_start);
        }
        while let Some(position) = self.position {
            let Some(job) = self.plans.job(position.plan, position.step) else {
                self.position = self.finish_plan(position.plan, world).map(at_start);
                continue;
            };
            if self.perform(job, inputs, world) == Progress::Stopped {
                return TickOutcome::Stopped;
            }
            self.position = Some(Position { step: position.step + 1, entered: false, ..position });
        }
        TickOutcome::Done
    }

    /// A start does not wait for a held tick to be finished.
    fn drop_held_tick_for_a_start(&mut self) {
        if self.debugger.stop.is_none() {
            return;
        }
        let start = self.commands.iter().rposition(|c| matches!(c, Command::StartPlc { .. }));
        if let Some(at) = start {
            // One by one: what `drain` does with the rest looks like recursion to whoever measures the stack.
            for _ in 0..at {
                self.commands.pop_front();
            }
            self.debugger.stop = None;
            self.debugger.focus = Line::Main;
            self.position = None;
        }
    }

    /// Acts on commands until one of them needs a plan; else the millisecond of a running PLC.
    fn next_plan(&mut self, world: &mut World<'_>) -> Option<PlanKind> {
        while let Some(command) = self.commands.pop_front() {
            if let Some(plan) = self.act(command, world) {
                return Some(plan);
            }
        }
        self.state.is_cycling().then_some(PlanKind::Fast)
    }

    fn act(&mut self, command: Command, world: &mut World<'_>) -> Option<PlanKind> {
        match command {
            Command::StartPlc { cold } => {
                self.start(cold, world);
                world.control.start(cold);
                if cold {
                    world.control.power_on(self.machine.memory.bytes_mut());
                }
                return Some(PlanKind::Init);
            }
            Command::StopPlc { power_off } => {
                if self.state == PlcState::Stopping {
                    self.enter_stopped(world.events);
                } else if self.state.is_cycling() {
                    self.abort_block(world);
                    self.machine.done_seen = 0;
                    self.entry_dr = i64::from(!power_off);
                    self.set_state(PlcState::Stopping, world.events);
                    return Some(PlanKind::Done);
                }
            }
            Command::ClearPlc => return Some(PlanKind::Clear),
            Command::Halt => return (self.state != PlcState::Halted).then_some(PlanKind::Halt),
            Command::StartBlock(block) => {
                let accepted = if self.state.is_cycling() {
                    self.block.accept(block)
                } else {
                    Err(Rejection::NotRunning)
                };
                if let Err(rejection) = accepted {
                    world.events.push(RuntimeEvent::BlockRejected(rejection));
                } else if self.block.request_start(&mut self.machine.memory) {
                    self.queue_event(system::event::START_REQ);
                }
            }
            Command::ContinueBlock => {
                if self.block.request_restart(world.control.is_held(), &mut self.machine.memory) {
                    self.queue_event(system::event::START_REQ);
                }
            }
            Command::StopBlock { emergency } => {
                let request = if emergency { system::STOP_EMERGENCY_REQ } else { system::STOP_REQ };
                self.machine.memory.set_flag(request, self.state.is_cycling());
            }
            Command::AbortBlock => {
                self.machine.memory.set_flag(system::AUTPI, false);
                self.machine.memory.set_flag(system::CAPI, true);
                self.abort_block(world);
            }
            Command::Event(code) => self.queue_event(code),
            Command::PlcCommand { code, pressed } => self.queue_call(PlcEvent::Command { code, pressed }),
        }
        None
    }

    /// A plan is complete. Returns the plan that follows in the same millisecond.
    fn finish_plan(&mut self, plan: PlanKind, world: &mut World<'_>) -> Option<PlanKind> {
        if plan == PlanKind::Halt {
            self.abort_block(world);
        }
        let events = &mut *world.events;
        match plan {
            PlanKind::Init | PlanKind::Done => self.settle(events),
            PlanKind::Clear | PlanKind::Held => {}
            PlanKind::Halt => self.set_state(PlcState::Halted, events),
            PlanKind::Fast => {
                self.report_overrun(RateKind::Fast, self.limits.per_fast, events);
                if self.machine.millis.is_multiple_of(20) {
                    return Some(PlanKind::Cycle);
                }
                self.end_millisecond(events);
            }
            PlanKind::Cycle => {
                self.report_overrun(RateKind::Cycle, self.limits.per_cycle, events);
                self.end_millisecond(events);
            }
        }
        self.spent = 0;
        None
    }

    fn end_millisecond(&mut self, events: &mut Vec<RuntimeEvent>) {
        self.block.advance();
        self.machine.millis += 1;
        self.settle(events);
    }

    /// Starting and stopping end when all files have reported.
    fn settle(&mut self, events: &mut Vec<RuntimeEvent>) {
        let bits = |files: &[u8]| files.iter().fold(0_u64, |bits, file| bits | 1 << file);
        let missing_init = bits(&self.program.init_finished) & !self.machine.init_seen;
        let missing_done = bits(&self.program.done_finished) & !self.machine.done_seen;
        match self.state {
            PlcState::Starting if missing_init == 0 => self.set_state(PlcState::Running, events),
            PlcState::Stopping if missing_done == 0 => self.enter_stopped(events),
            _ => {}
        }
    }

    fn report_overrun(&mut self, rate: RateKind, limit: Option<u64>, events: &mut Vec<RuntimeEvent>) {
        let executed = core::mem::take(&mut self.spent);
        if let Some(limit) = limit.filter(|limit| executed > *limit) {
            events.push(RuntimeEvent::Overrun { cycle: self.cycle(), rate, executed, limit });
        }
    }

    fn start(&mut self, cold: bool, world: &mut World<'_>) {
        if cold {
            self.initialise_memory();
        }
        if let Some(hidden) = self.program.region(RegionKind::Hidden) {
            self.machine.memory.fill(hidden.start as usize, hidden.len as usize, 0);
        }
        self.abort_block(world);
        self.machine.memory.set_flag(system::INPOS, true);
        self.machine.millis = 0;
        self.machine.init_seen = 0;
        self.machine.done_seen = 0;
        self.machine.state_since.fill(0);
        if let Some(trace) = &mut self.trace {
            trace.forget();
        }
        self.plc_events.clear();
        [&mut self.main, &mut self.fast, &mut self.cont].into_iter().for_each(Context::reset);
        self.outputs.fill(0);
        self.spent = 0;
        self.fault = None;
        self.debugger.step = None;
        self.debugger.focus = Line::Main;
        self.entry_dr = i64::from(!cold);
        self.set_state(PlcState::Starting, world.events);
    }

    /// Content of memory when a program is loaded and at a cold start.
    pub(crate) fn initialise_memory(&mut self) {
        let memory = self.machine.memory.bytes_mut();
        memory.fill(0);
        for data in &self.program.initial {
            let start = data.addr as usize;
            memory[start..start + data.bytes.len()].copy_from_slice(&data.bytes);
        }
    }

    fn enter_stopped(&mut self, events: &mut Vec<RuntimeEvent>) {
        self.outputs.fill(0);
        self.set_state(PlcState::Stopped, events);
    }

    fn set_state(&mut self, state: PlcState, events: &mut Vec<RuntimeEvent>) {
        if self.state != state {
            self.state = state;
            events.push(RuntimeEvent::StateChanged(state));
        }
    }

    /// MODULE_CONT goes on while the rest is held.
    fn hold(&mut self, inputs: &InputImage, world: &mut World<'_>) {
        let starting = self.position.is_some_and(|p| p.plan == PlanKind::Init);
        self.debugger.held_millis += 1;
        if !self.state.is_cycling() || starting || !self.debugger.held_millis.is_multiple_of(20) {
            return;
        }
        let held = self.position.replace(at_start(PlanKind::Held));
        let spent = self.spent;
        let mut step = 0;
        while let Some(job) = self.plans.job(PlanKind::Held, step) {
            if self.perform(job, inputs, world) == Progress::Stopped {
                return;
            }
            step += 1;
            self.position = Some(Position { step, ..at_start(PlanKind::Held) });
        }
        self.position = held;
        self.spent = spent;
    }

    fn perform(&mut self, job: Job, inputs: &InputImage, world: &mut World<'_>) -> Progress {
        let memory = &mut self.machine.memory;
        let millis = self.machine.millis;
        match job {
            Job::Inputs => {
                ports::copy_inputs(memory, inputs);
                world.control.inputs(Rate::Slow, millis, memory.bytes_mut());
            }
            Job::Outputs => {
                world.control.outputs(Rate::Slow, millis, memory.bytes_mut());
                ports::copy_outputs(memory, &mut self.outputs, &self.shorted);
                self.take_messages(world);
            }
            Job::FastInputs => {
                for port in &self.fast_inputs {
                    ports::copy_input(memory, inputs, *port);
                }
                world.control.inputs(Rate::Fast, millis, memory.bytes_mut());
                self.block.tell_position(memory, world.control);
            }
            Job::FastOutputs => {
                world.control.outputs(Rate::Fast, millis, memory.bytes_mut());
                for port in &self.fast_outputs {
                    ports::copy_output(memory, &mut self.outputs, &self.shorted, *port);
                }
            }
            Job::FastLinks => world.control.fast_links(millis, memory.bytes_mut()),
            Job::FastestInputs => world.control.inputs(Rate::Fastest, millis, memory.bytes_mut()),
            Job::FastestOutputs => world.control.outputs(Rate::Fastest, millis, memory.bytes_mut()),
            Job::Module(index) => return self.run_module(index, world),
            Job::Block => {
                let progress = self.run_block(world);
                self.block.publish(&mut self.machine.memory, world.control);
                return progress;
            }
            Job::Calls => return self.run_calls(world),
            Job::Events => return self.run_events(world),
            Job::StopRequests => self.take_stop_request(world),
        }
        Progress::Done
    }

    fn run_module(&mut self, index: usize, world: &mut World<'_>) -> Progress {
        let module = self.program.modules[index];
        let dr = matches!(module.kind, ModuleKind::Init | ModuleKind::Done).then_some(self.entry_dr);
        self.enter(Line::of(module.kind), Root::Module(index), module.start, dr);
        self.execute(Line::of(module.kind), is_stoppable(module.kind), world)
    }

    /// Begins the pass of this step unless it has begun already.
    fn enter(&mut self, line: Line, root: Root, pc: u32, dr: Option<i64>) {
        let Some(position) = &mut self.position else { return };
        if core::mem::replace(&mut position.entered, true) {
            return;
        }
        let budget = self.limits.per_pass;
        let ctx = self.context(line);
        ctx.enter(root, pc, budget);
        ctx.regs.dr = dr.unwrap_or(ctx.regs.dr);
    }

    /// Executes until the pass is over or held.
    fn execute(&mut self, line: Line, stoppable: bool, world: &mut World<'_>) -> Progress {
        let exit = match self.trace.take() {
            Some(mut trace) => {
                trace.enter(self.machine.cycle(), self.line(line).regs.dr_real);
                let exit = self.execute_recorded(line, stoppable, world, &mut trace);
                self.trace = Some(trace);
                exit
            }
            None => self.execute_recorded(line, stoppable, world, &mut Untraced),
        };
        match exit {
            Exit::End => {
                self.spent += self.line(line).spent();
                if let Some(position) = &mut self.position {
                    position.entered = false;
                }
                Progress::Done
            }
            Exit::Stop(reason) => {
                self.debugger.hold(reason, line);
                Progress::Stopped
            }
            Exit::Fault(kind) => {
                self.enter_faulted(kind, line, world.events);
                Progress::Stopped
            }
        }
    }

    fn execute_recorded(
        &mut self,
        line: Line,
        stoppable: bool,
        world: &mut World<'_>,
        recorder: &mut impl Recorder,
    ) -> Exit {
        let Runtime { program, code, machine, debugger, main, fast, cont, coverage, .. } = self;
        let ctx = match line {
            Line::Main => main,
            Line::Fast => fast,
            Line::Cont => cont,
        };
        if let Some(coverage) = coverage {
            let counted = RefCell::new(coverage);
            let watch = |machine: &_, ctx: &Context| {
                let stop = || debugger.reason_to_stop(program, code, machine, ctx);
                let reason = if stoppable { stop() } else { None };
                // Nobody asks again when a statement that is held before is resumed: it counts once.
                counted.borrow_mut().hit(ctx.pc);
                reason
            };
            run_watched(program, code, machine, ctx, world, &watch, recorder)
        } else if debugger.is_watching(stoppable) {
            let watch = |machine: &_, ctx: &_| {
                if stoppable { debugger.reason_to_stop(program, code, machine, ctx) } else { None }
            };
            run_watched(program, code, machine, ctx, world, &watch, recorder)
        } else {
            run(program, code, machine, ctx, world, stoppable, recorder)
        }
    }

    fn enter_faulted(&mut self, kind: FaultKind, line: Line, events: &mut Vec<RuntimeEvent>) {
        let ctx = self.line(line);
        let (module, file) = module_and_file(&self.program, ctx);
        let sequence = self.code.sequence_of(ctx.outermost());
        let fault = Fault { kind, pc: ctx.pc, sequence, module, file, cycle: self.cycle() };
        self.fault = Some(fault);
        self.outputs.fill(0);
        self.position = None;
        self.debugger.hold(StopReason::Fault, line);
        events.push(RuntimeEvent::Fault(fault));
        self.set_state(PlcState::Faulted, events);
    }

    /// Block cycle: as far as it comes in this cycle.
    fn run_block(&mut self, world: &mut World<'_>) -> Progress {
        if self.block.take_start(&mut self.machine.memory) {
            world.control.hold(Hold::Go);
            self.block.tell_position(&mut self.machine.memory, world.control);
            self.queue_event(system::event::START);
        }
        self.block.take_axes(&mut self.machine.memory, world.control);
        loop {
            match self.block.stage {
                Stage::Idle => {
                    if !self.block.begin(&mut self.machine.memory, world.control) {
                        return Progress::Done;
                    }
                    if self.block.lacks_feed(&self.machine.memory) {
                        world.events.push(RuntimeEvent::BlockRejected(Rejection::NoFeed));
                        self.abort_block(world);
                        return Progress::Done;
                    }
                    world.events.push(RuntimeEvent::BlockStarted { cycle: self.cycle() });
                    self.activate(SequenceKind::BlockInit);
                }
                Stage::Preparing => {
                    if self.run_block_module(ModuleKind::BlockInit, world) == Progress::Stopped {
                        return Progress::Stopped;
                    }
                    if self.is_active(SequenceKind::BlockInit) {
                        return Progress::Done;
                    }
                    self.block.release(&mut self.machine.memory, world.control);
                }
                Stage::Moving { .. } => {
                    if self.block.lost(world.control) {
                        self.stop_block(Hold::Stop, world);
                    }
                    if !self.block.arrived(world.control) {
                        return Progress::Done;
                    }
                    self.block.reach(&mut self.machine.memory);
                }
                Stage::Dwelling { .. } => {
                    if !self.block.has_dwelt() {
                        return Progress::Done;
                    }
                    self.block.close(&mut self.machine.memory);
                    self.activate(SequenceKind::BlockDone);
                }
                Stage::Closing => {
                    if self.run_block_module(ModuleKind::BlockDone, world) == Progress::Stopped {
                        return Progress::Stopped;
                    }
                    if !self.is_active(SequenceKind::BlockDone) {
                        if self.block.finish(&mut self.machine.memory) {
                            self.queue_event(system::event::STOP);
                        }
                        world.events.push(RuntimeEvent::BlockFinished { cycle: self.cycle() });
                    }
                    return Progress::Done;
                }
            }
        }
    }

    fn run_block_module(&mut self, kind: ModuleKind, world: &mut World<'_>) -> Progress {
        match self.program.modules.iter().position(|m| m.kind == kind) {
            Some(index) => self.run_module(index, world),
            None => Progress::Done,
        }
    }

    fn activate(&mut self, kind: SequenceKind) {
        if let Some(number) = self.sequence_of_kind(kind) {
            sequence::rest(&self.program, &mut self.machine, number);
            let bit = sequence::activation(&self.program.sequences[usize::from(number)]);
            // Without its module nothing would ever clear the bit.
            let has_module =
                module_of(&self.program, self.program.sequences[usize::from(number)].start).is_some();
            self.machine.memory.set_flag(bit, has_module);
        }
    }

    fn is_active(&self, kind: SequenceKind) -> bool {
        self.sequence_of_kind(kind).is_some_and(|number| {
            let bit = sequence::activation(&self.program.sequences[usize::from(number)]);
            self.machine.memory.flag(bit)
        })
    }

    /// Breaks the block in progress, rewinds the block modules and forgets queued blocks.
    fn abort_block(&mut self, world: &mut World<'_>) {
        world.control.end_block(self.machine.memory.bytes_mut());
        if !self.block.abort(&mut self.machine.memory) {
            return;
        }
        for kind in [SequenceKind::BlockInit, SequenceKind::BlockDone] {
            if let Some(number) = self.sequence_of_kind(kind) {
                sequence::rest(&self.program, &mut self.machine, number);
            }
        }
        world.events.push(RuntimeEvent::BlockAborted { cycle: self.cycle() });
    }

    fn take_stop_request(&mut self, world: &mut World<'_>) {
        if let Some(code) = self.block.take_stop_request(&mut self.machine.memory) {
            self.queue_event(code);
            let emergency = code == system::event::STOP_EMERGENCY_REQ;
            self.stop_block(if emergency { Hold::Emergency } else { Hold::Stop }, world);
        }
    }

    fn stop_block(&mut self, hold: Hold, world: &mut World<'_>) {
        world.control.hold(hold);
        if self.block.stop(&mut self.machine.memory) {
            self.queue_event(system::event::STOP);
        }
        self.block.tell_position(&mut self.machine.memory, world.control);
    }

    fn queue_event(&mut self, code: i64) {
        self.queue_call(PlcEvent::Event(code));
    }

    /// Events nobody handles are dropped, and so is one beyond the bound.
    fn queue_call(&mut self, event: PlcEvent) {
        if self.handler(event).is_some() && self.plc_events.len() < QUEUE_LEN {
            self.plc_events.push_back(event);
        }
    }

    fn handler(&self, event: PlcEvent) -> Option<u16> {
        match event {
            PlcEvent::Event(_) => self.code.on_event,
            PlcEvent::Command { .. } => self.code.on_cmd,
        }
    }

    /// Procedures that the control calls.
    fn run_calls(&mut self, world: &mut World<'_>) -> Progress {
        for _ in 0..CALLS_PER_CYCLE {
            if !self.position.is_some_and(|p| p.entered) {
                let memory = self.machine.memory.bytes_mut();
                let Some(call) = world.control.next_call(memory) else { return Progress::Done };
                let procedure = self.program.procedures.get(usize::from(call.procedure));
                let Some(start) = procedure.map(|procedure| procedure.start) else { continue };
                self.enter(Line::Main, Root::Procedure, start, Some(call.dr));
            }
            if self.execute(Line::Main, true, world) == Progress::Stopped {
                return Progress::Stopped;
            }
        }
        Progress::Done
    }

    fn run_events(&mut self, world: &mut World<'_>) -> Progress {
        loop {
            if !self.position.is_some_and(|p| p.entered) {
                let Some(event) = self.plc_events.pop_front() else { return Progress::Done };
                let Some(procedure) = self.handler(event) else { continue };
                let start = self.program.procedures[usize::from(procedure)].start;
                let dr = match event {
                    PlcEvent::Event(code) => code,
                    PlcEvent::Command { code, .. } => i64::from(code),
                };
                self.enter(Line::Main, Root::Procedure, start, Some(dr));
                if let PlcEvent::Command { pressed, .. } = event {
                    self.main.regs.rlo = pressed;
                }
            }
            if self.execute(Line::Main, true, world) == Progress::Stopped {
                return Progress::Stopped;
            }
        }
    }

    /// Tells what the control reports by itself.
    fn take_messages(&self, world: &mut World<'_>) {
        for _ in 0..MESSAGES_PER_CYCLE {
            let Some(message) = world.control.next_message() else { return };
            let ControlMessage { call, number, sub_id, set, parameters } = message;
            let at = self.program.code.iter().position(|op| *op == Op::Service(call));
            let pc = at.map_or(0, |pc| pc as u32);
            let cycle = self.cycle();
            world.events.push(RuntimeEvent::Message { cycle, number, sub_id, set, parameters, pc });
        }
    }
}

fn at_start(plan: PlanKind) -> Position {
    Position { plan, step: 0, entered: false }
}
