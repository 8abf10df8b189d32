//! The supervisor: what happens in a millisecond, in which order (manual 5.2, 5.3).

mod block_cycle;
mod called;
mod life;

use alloc::vec::Vec;
use core::cell::RefCell;

use technol_image::op::{Op, Pc};
use technol_image::program::ModuleKind;

pub(crate) use self::called::PlcEvent;
use crate::code::is_stoppable;
use crate::context::{Context, Root};
use crate::control::{Control, ControlMessage, NoControl, Rate};
use crate::debugger::Line;
use crate::event::{PlcState, RateKind, RuntimeEvent};
use crate::execute::{Exit, World, run, run_watched};
use crate::plan::{Job, PlanKind};
use crate::ports::{self, InputImage};
use crate::runtime::{Position, Runtime, TickOutcome};
use crate::trace::{Recorder, Untraced};

/// Messages the control may report by itself in a cycle; the others wait for the next.
const MESSAGES_PER_CYCLE: usize = 16;

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

    /// Acts on commands until one of them needs a plan; else the millisecond of a running PLC.
    fn next_plan(&mut self, world: &mut World<'_>) -> Option<PlanKind> {
        while let Some(command) = self.commands.pop_front() {
            if let Some(plan) = self.act(command, world) {
                return Some(plan);
            }
        }
        self.state.is_cycling().then_some(PlanKind::Fast)
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

    fn report_overrun(&mut self, rate: RateKind, limit: Option<u64>, events: &mut Vec<RuntimeEvent>) {
        let executed = core::mem::take(&mut self.spent);
        if let Some(limit) = limit.filter(|limit| executed > *limit) {
            events.push(RuntimeEvent::Overrun { cycle: self.cycle(), rate, executed, limit });
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

    /// Tells what the control reports by itself.
    fn take_messages(&self, world: &mut World<'_>) {
        for _ in 0..MESSAGES_PER_CYCLE {
            let Some(message) = world.control.next_message() else { return };
            let ControlMessage { call, number, sub_id, set, parameters } = message;
            let at = self.program.code.iter().position(|op| *op == Op::Service(call));
            // What no line reports has no place.
            let pc = at.map_or(Pc::MAX, |pc| pc as u32);
            let cycle = self.cycle();
            world.events.push(RuntimeEvent::Message { cycle, number, sub_id, set, parameters, pc });
        }
    }
}

fn at_start(plan: PlanKind) -> Position {
    Position { plan, step: 0, entered: false }
}
