//! What a tick consists of, laid out once when a program is loaded (manual 5.2).

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use technol_image::Program;
use technol_image::program::ModuleKind;

/// A period that MODULE_FASTEST does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PeriodError {
    /// Microseconds.
    pub micros: u16,
}

impl fmt::Display for PeriodError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "MODULE_FASTEST runs every 100, 200, 250, 500 or 1000 µs, not every {}", self.micros)
    }
}

impl core::error::Error for PeriodError {}

/// A run of jobs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlanKind {
    /// Start of the PLC.
    Init,
    /// Stop of the PLC.
    Done,
    /// Clear command.
    Clear,
    /// Fatal error of the control.
    Halt,
    /// Each millisecond.
    Fast,
    /// Each 20 ms, after the fast plan of the same millisecond.
    Cycle,
    /// Each 20 ms while the debugger holds the program.
    Held,
}

/// One step of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Job {
    /// Copy all input ports.
    Inputs,
    /// Copy all output ports.
    Outputs,
    /// Copy the fast input ports.
    FastInputs,
    /// Copy the fast output ports.
    FastOutputs,
    /// What the control copies between MODULE_CYCLICOPERATION and MODULE_FAST.
    FastLinks,
    /// What the control copies before a pass of MODULE_FASTEST.
    FastestInputs,
    /// What the control copies after a pass of MODULE_FASTEST.
    FastestOutputs,
    /// Execute a module, by index.
    Module(usize),
    /// The block cycle, with its two modules.
    Block,
    /// The procedures that the control calls.
    Calls,
    /// `_ON_EVENT` for each queued event.
    Events,
    /// Take the stop requests of the PLC.
    StopRequests,
}

/// All plans of a program.
#[derive(Clone, Debug)]
pub(crate) struct Plans {
    init: Vec<Job>,
    done: Vec<Job>,
    clear: Vec<Job>,
    halt: Vec<Job>,
    fast: Vec<Job>,
    cycle: Vec<Job>,
    held: Vec<Job>,
}

impl Plans {
    /// The plans of a program whose MODULE_FASTEST runs `fastest` times a millisecond.
    pub(crate) fn new(program: &Program, fastest: usize) -> Plans {
        let modules = |kind: ModuleKind| {
            let of_kind = program.modules.iter().enumerate().filter(move |(_, m)| m.kind == kind);
            of_kind.map(|(index, _)| Job::Module(index))
        };
        let around = |before: &[Job], kind, after: &[Job]| {
            before.iter().copied().chain(modules(kind)).chain(after.iter().copied()).collect::<Vec<_>>()
        };
        let mut cycle = vec![Job::Inputs, Job::Calls];
        cycle.extend(modules(ModuleKind::Input));
        cycle.extend([Job::Events, Job::Block]);
        cycle.extend(modules(ModuleKind::Main));
        cycle.extend(modules(ModuleKind::Cont));
        cycle.extend([Job::StopRequests, Job::Outputs]);
        // MODULE_CONT serves the machine while the rest is held, so it sees and moves the real ports.
        let held = if modules(ModuleKind::Cont).next().is_some() {
            around(&[Job::Inputs], ModuleKind::Cont, &[Job::Outputs])
        } else {
            Vec::new()
        };
        let mut fast = vec![Job::FastInputs];
        if modules(ModuleKind::CyclicOperation).next().is_some() {
            fast.extend(modules(ModuleKind::CyclicOperation));
            fast.push(Job::FastLinks);
        }
        fast.extend(modules(ModuleKind::Fast));
        for _ in 0..fastest {
            fast.extend(around(&[Job::FastestInputs], ModuleKind::Fastest, &[Job::FastestOutputs]));
        }
        fast.push(Job::FastOutputs);
        Plans {
            init: around(&[Job::Inputs], ModuleKind::Init, &[]),
            done: around(&[], ModuleKind::Done, &[Job::Outputs]),
            clear: around(&[], ModuleKind::Clear, &[]),
            halt: around(&[], ModuleKind::Halt, &[Job::Outputs]),
            fast,
            cycle,
            held,
        }
    }

    pub(crate) fn job(&self, kind: PlanKind, step: usize) -> Option<Job> {
        let jobs = match kind {
            PlanKind::Init => &self.init,
            PlanKind::Done => &self.done,
            PlanKind::Clear => &self.clear,
            PlanKind::Halt => &self.halt,
            PlanKind::Fast => &self.fast,
            PlanKind::Cycle => &self.cycle,
            PlanKind::Held => &self.held,
        };
        jobs.get(step).copied()
    }
}
