//! State of one line of execution: the 20 ms modules, MODULE_FAST and MODULE_CONT each have their own.

use alloc::vec::Vec;

use technol_image::op::Pc;

use crate::registers::Registers;

/// Procedures may be nested this deeply at run time; more is a recursion.
pub(crate) const MAX_CALLS: usize = 64;
/// Stands for "no sequence" where a number is stored.
pub(crate) const NO_SEQUENCE: u16 = u16::MAX;

/// What the supervisor started.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Root {
    /// A module, by index into `Program::modules`.
    Module(usize),
    /// An event procedure, called on behalf of the first MODULE_MAIN.
    Procedure,
}

/// A call that has not returned.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Call {
    /// Operation after the call.
    pub(crate) ret: Pc,
    /// Registers of the caller, when they come back at the return (`_ON_ESET`).
    pub(crate) saved: Option<Registers>,
}

/// One line of execution.
#[derive(Clone, Debug)]
pub(crate) struct Context {
    pub(crate) regs: Registers,
    /// Operation executed next.
    pub(crate) pc: Pc,
    pub(crate) calls: Vec<Call>,
    pub(crate) root: Root,
    /// Operations left in this pass before it counts as an endless loop.
    pub(crate) budget: u32,
    /// Budget at the start of the pass.
    pub(crate) granted: u32,
    /// Sequence that executed MECH_INIT on itself in this pass: its EX-type instructions no longer move it.
    pub(crate) rewound: u16,
    /// Number of activations so far; tells one module pass from the next.
    pub(crate) activation: u64,
    /// The operation at `pc` was stopped at: it does not stop again.
    pub(crate) skip_stop: bool,
}

impl Context {
    pub(crate) fn new() -> Context {
        Context { calls: Vec::with_capacity(MAX_CALLS), ..Context::without_calls() }
    }

    fn without_calls() -> Context {
        Context {
            regs: Registers::default(),
            pc: 0,
            calls: Vec::new(),
            root: Root::Module(0),
            budget: 0,
            granted: 0,
            rewound: NO_SEQUENCE,
            activation: 0,
            skip_stop: false,
        }
    }

    /// As new, in the memory it has.
    pub(crate) fn reset(&mut self) {
        let mut calls = core::mem::take(&mut self.calls);
        calls.clear();
        *self = Context { calls, ..Context::without_calls() };
    }

    /// Begins a pass at `pc`. RLO, DR and DR_REAL are what the last pass left, as on the real processor.
    pub(crate) fn enter(&mut self, root: Root, pc: Pc, budget: u32) {
        self.regs.close_equation();
        self.pc = pc;
        self.calls.clear();
        self.root = root;
        self.budget = budget;
        self.granted = budget;
        self.rewound = NO_SEQUENCE;
        self.activation += 1;
    }

    /// Operations executed in this pass.
    pub(crate) fn spent(&self) -> u64 {
        u64::from(self.granted - self.budget)
    }

    /// Where the outermost level is: the last call made by the module, or `pc` itself.
    pub(crate) fn outermost(&self) -> Pc {
        self.calls.first().map_or(self.pc, |call| call.ret.saturating_sub(1))
    }
}
