//! Runs one test.

use std::time::{Duration, Instant};

use technol_image::{DebugInfo, Program};
use technol_machine::{BlockMode, BlockStart, ControlData};
use technol_runtime::{Command, RuntimeEvent};
use technol_target::Simulation;

use super::condition::{Condition, Look};
use super::history::{Entry, History};
use super::machines::Machines;
use super::messages::Messages;
use super::scenario::{Action, Check, Guard, Place, Step, Test, Time};
use super::state::Mechanisms;
use crate::run::changes::assign;

/// What all tests share.
pub(super) struct Bench<'a> {
    pub(super) program: &'a Program,
    /// What the control has on its disk at power-on.
    pub(super) data: &'a ControlData,
    pub(super) debug: &'a DebugInfo,
    pub(super) mechanisms: &'a Mechanisms,
    pub(super) machines: &'a Machines,
    /// Count how often each statement is executed.
    pub(super) coverage: bool,
}

/// What a test came to.
#[derive(Debug)]
pub(super) struct Verdict {
    pub(super) failure: Option<Failure>,
    /// Virtual time.
    pub(super) ms: u64,
    /// Time that it took.
    pub(super) took: Duration,
    /// For each operation how often a statement there was executed.
    pub(super) counts: Option<Vec<u32>>,
}

/// Why a test failed.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Failure {
    /// 1-based; 0 is before the first one.
    pub(super) step: usize,
    pub(super) step_name: Option<String>,
    pub(super) place: Place,
    /// Virtual time since the start of the test.
    pub(super) ms: u64,
    pub(super) cycle: u64,
    pub(super) problems: Vec<Problem>,
    pub(super) history: Vec<Entry>,
}

/// Something that was not as it should be.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Problem {
    pub(super) expected: String,
    pub(super) actual: String,
}

/// The outcome of a part of a test.
type Passed = Result<(), Vec<Problem>>;

/// Runs a test from power-on.
pub(super) fn execute(test: &Test, bench: &Bench<'_>) -> Verdict {
    let start = Instant::now();
    let machine = bench.machines.get(test.machine);
    let mut simulation = match Simulation::new(bench.program.clone(), machine.config.as_ref()) {
        Ok(simulation) => simulation,
        Err(error) => {
            let problem = problem("a program that can be loaded", error.to_string());
            let failure = Failure {
                step: 0,
                step_name: None,
                place: test.place,
                ms: 0,
                cycle: 0,
                problems: vec![problem],
                history: Vec::new(),
            };
            return Verdict { failure: Some(failure), ms: 0, took: start.elapsed(), counts: None };
        }
    };
    simulation.set_data(bench.data.clone());
    simulation.runtime_mut().count_statements(bench.coverage);
    let mut run = Run {
        simulation,
        mechanisms: bench.mechanisms,
        history: History::new(bench.debug, bench.mechanisms, &test.values),
        messages: Messages::default(),
        guards: test.guards.iter().collect(),
        events: Vec::new(),
        rejected: None,
        ms: 0,
    };
    let failed = run.all(test);
    let ms = run.ms;
    let cycle = run.simulation.runtime().cycle();
    let counts = run.simulation.runtime().statement_counts().map(<[u32]>::to_vec);
    let failure = failed.err().map(|(number, problems)| {
        let step = number.checked_sub(1).and_then(|n| test.steps.get(n));
        Failure {
            step: number,
            step_name: step.and_then(|step| step.name.clone()),
            place: step.map_or(test.place, |step| step.place),
            ms,
            cycle,
            problems,
            history: run.history.told(),
        }
    });
    Verdict { failure, ms, took: start.elapsed(), counts }
}

/// A test in progress.
struct Run<'a> {
    simulation: Simulation,
    mechanisms: &'a Mechanisms,
    history: History<'a>,
    messages: Messages,
    guards: Vec<&'a Guard>,
    /// Emptied after each millisecond.
    events: Vec<RuntimeEvent>,
    /// A block that was not accepted.
    rejected: Option<String>,
    ms: u64,
}

impl<'a> Run<'a> {
    /// All steps; the number of the one that failed.
    fn all(&mut self, test: &'a Test) -> Result<(), (usize, Vec<Problem>)> {
        self.simulation.start(true);
        // MODULE_INIT; no time goes by.
        self.tick();
        self.no_fault().map_err(|problems| (0, problems))?;
        for (number, step) in (1..).zip(&test.steps) {
            self.step(number, step).map_err(|problems| (number, problems))?;
        }
        Ok(())
    }

    fn step(&mut self, number: usize, step: &'a Step) -> Passed {
        let fault_expected = step.checks.iter().any(|check| matches!(check, Check::PlcFault(_)));
        let name = step.name.as_deref().map_or(String::new(), |name| format!(": {name}"));
        let cycle = self.simulation.runtime().cycle();
        self.history.step(self.ms, cycle, format!("step {number} (line {}){name}", step.place.line));
        for action in &step.actions {
            if let Some(text) = action.text() {
                self.history.step(self.ms, self.simulation.runtime().cycle(), text);
            }
            self.act(action)?;
        }
        // What the step has set comes before what follows from it.
        self.history.look(self.ms, self.simulation.runtime());
        self.guards.retain(|guard| guard.name.as_ref().is_none_or(|name| !step.ends.contains(name)));
        self.guards.extend(&step.guards);
        let passed = self.time(&step.time);
        // A fault that is expected ends the waiting and is judged below.
        if !(fault_expected && self.simulation.runtime().fault().is_some()) {
            passed?;
            self.no_fault()?;
        }
        let problems: Vec<Problem> = step.checks.iter().filter_map(|check| self.check(check)).collect();
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }

    fn act(&mut self, action: &Action) -> Passed {
        let failed = |expected: String, actual: String| Err(vec![Problem { expected, actual }]);
        match action {
            Action::Start { cold } => {
                self.simulation.start(*cold);
                self.tick();
                self.no_fault()?;
            }
            Action::Stop { power_off } => {
                self.simulation.runtime_mut().command(Command::StopPlc { power_off: *power_off });
            }
            Action::CentralAnnulment => {
                let block = BlockStart { mode: BlockMode::CentralAnnulment, ..BlockStart::default() };
                return self.start_block(&block);
            }
            Action::Acknowledge => {
                if self.simulation.control_mut().acknowledge().is_none() {
                    return failed("a message to acknowledge".to_owned(), "the screen shows none".to_owned());
                }
            }
            Action::Clear => self.simulation.runtime_mut().command(Command::ClearPlc),
            Action::Halt => self.simulation.runtime_mut().command(Command::Halt),
            Action::Fault { name, on } => {
                if let Err(error) = self.simulation.plant_mut().set_fault(name, *on) {
                    return failed(format!("a fault {name} of the machine"), error.to_string());
                }
            }
            Action::Key { name, down } => {
                if let Err(error) = self.simulation.plant_mut().press(name, *down) {
                    return failed(format!("a key {name} of the machine"), error.to_string());
                }
            }
            Action::Set { text, assignment, .. } => {
                if let Err(error) = assign(assignment, &mut self.simulation) {
                    return failed(format!("{text} in the memory of the PLC"), error.to_string());
                }
            }
            Action::Block(block) => return self.start_block(block),
        }
        Ok(())
    }

    fn start_block(&mut self, block: &BlockStart) -> Passed {
        let started = self.simulation.start_block(block);
        started.map_err(|why| vec![problem("a block that starts", why.to_string())])
    }

    fn time(&mut self, time: &Time) -> Passed {
        match time {
            Time::None => Ok(()),
            Time::Wait { ms } => {
                for _ in 0..*ms {
                    self.millisecond()?;
                }
                Ok(())
            }
            Time::Until { condition, at_least, at_most } => self.until(condition, *at_least, *at_most),
        }
    }

    fn until(&mut self, condition: &Condition, at_least: u64, at_most: u64) -> Passed {
        let begun = self.ms;
        let text = &condition.text;
        while !condition.holds(&self.look()) {
            if self.ms - begun >= at_most {
                let actual = condition.explain(&self.look());
                return Err(vec![problem(&format!("{text} within {at_most} ms"), actual)]);
            }
            self.millisecond()?;
        }
        let took = self.ms - begun;
        if took < at_least {
            let expected = format!("{text} after {at_least} ms at the earliest");
            return Err(vec![problem(&expected, format!("it came true after {took} ms"))]);
        }
        Ok(())
    }

    /// One millisecond with everything that must hold in it.
    fn millisecond(&mut self) -> Passed {
        self.tick();
        self.ms += 1;
        self.no_fault()?;
        if let Some(why) = self.rejected.take() {
            return Err(vec![problem("a block that the control accepts", why)]);
        }
        let look = self.look();
        let broken = self.guards.iter().find(|guard| guard.condition.holds(&look) != guard.always);
        match broken {
            Some(guard) => Err(vec![problem(&guard.text(), guard.condition.explain(&look))]),
            None => Ok(()),
        }
    }

    fn tick(&mut self) {
        self.simulation.tick(&mut self.events);
        let cycle = self.simulation.runtime().cycle();
        for event in std::mem::take(&mut self.events) {
            match &event {
                RuntimeEvent::Message { number, set: true, .. } => self.messages.show(*number),
                RuntimeEvent::BlockRejected(why) => self.rejected = Some(why.to_string()),
                _ => {}
            }
            self.history.event(self.ms, cycle, &event);
        }
        self.history.look(self.ms, self.simulation.runtime());
    }

    fn no_fault(&self) -> Passed {
        match self.simulation.runtime().fault() {
            Some(fault) => Err(vec![problem("no fault of the PLC", self.history.fault(fault))]),
            None => Ok(()),
        }
    }

    fn check(&mut self, check: &Check) -> Option<Problem> {
        match check {
            Check::Holds(condition) => {
                let look = self.look();
                let wrong = !condition.holds(&look);
                wrong.then(|| problem(&condition.text, condition.explain(&look)))
            }
            Check::Message(number) => {
                if self.messages.tick_off(*number) {
                    return None;
                }
                Some(problem(
                    &format!("message {number}"),
                    format!("shown and not ticked off yet: {}", self.open()),
                ))
            }
            Check::NoMessage(number) => {
                let open = self.messages.is_open(*number);
                open.then(|| problem(&format!("no message {number}"), "it has been shown".to_owned()))
            }
            Check::NoMessages => {
                let any = self.messages.open().next().is_some();
                any.then(|| problem("no message", format!("shown: {}", self.open())))
            }
            Check::Screen(_) | Check::Listed { .. } | Check::NothingListed => self.check_shown(check),
            Check::PlcFault(text) => {
                let fault = self.simulation.runtime().fault().map(|fault| self.history.fault(fault));
                let right = fault.as_ref().is_some_and(|fault| fault.contains(text));
                let actual = fault.unwrap_or_else(|| "no fault".to_owned());
                (!right).then(|| problem(&format!("a fault of the PLC: {text}"), actual))
            }
        }
    }

    /// What the operator sees.
    fn check_shown(&self, check: &Check) -> Option<Problem> {
        let board = self.simulation.control().board();
        let told = |number: Option<u32>| number.map_or("none".to_owned(), |number| number.to_string());
        let listed = || {
            let numbers: Vec<String> = board.persistent().map(|it| it.number.to_string()).collect();
            format!("listed: {}", if numbers.is_empty() { "none".to_owned() } else { numbers.join(", ") })
        };
        match *check {
            Check::Screen(wanted) => {
                let actual = board.transient().next().map(|it| it.number);
                let expected = format!("message to acknowledge: {}", told(wanted));
                (actual != wanted).then(|| problem(&expected, told(actual)))
            }
            Check::Listed { number, listed: wanted } => {
                let wrong = board.persistent().any(|it| it.number == number) != wanted;
                let not = if wanted { "" } else { "not " };
                wrong.then(|| problem(&format!("message {number} is {not}listed"), listed()))
            }
            _ => board.persistent().next().map(|_| problem("no listed message", listed())),
        }
    }

    fn open(&self) -> String {
        let open: Vec<String> = self.messages.open().map(|number| number.to_string()).collect();
        if open.is_empty() { "none".to_owned() } else { open.join(", ") }
    }

    fn look(&self) -> Look<'_> {
        Look { runtime: self.simulation.runtime(), messages: &self.messages, mechanisms: self.mechanisms }
    }
}

fn problem(expected: &str, actual: String) -> Problem {
    Problem { expected: expected.to_owned(), actual }
}
