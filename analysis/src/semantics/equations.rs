//! Logic equations: when LDR pushes, what takes it back, what is left (manual 3.2, 3.6).
//!
//! The decision is static, from top to bottom: LDR opens an equation or pushes when one is open; only terminal
//! instructions close it; jumps and labels change nothing.

use technol_image::op::STACK_DEPTH;

use crate::catalogue::{Effect, Entry, Equation};
use crate::diagnostics::Finding;
use crate::diagnostics::rules::{equations as rules, macros};
use crate::semantics::macros::definition::StackFlag;
use crate::syntax::ast::Columns;

/// A place in the section.
type Spot = (u32, Columns);

/// An open equation.
#[derive(Clone, Debug)]
struct Open {
    /// Where it began.
    began: Spot,
    /// An instruction overwrote its RLO; reported when nothing worse comes of it.
    lost: Option<Finding>,
}

/// State between two lines.
#[derive(Debug, Default)]
pub(super) struct Equations {
    open: Option<Open>,
    /// LDRs that pushed and whose value is still on the stack, with where the pushed part began.
    pushed: Vec<(Spot, Spot)>,
    findings: Vec<Finding>,
    /// In the state before a call: number of findings until then.
    reported: usize,
    /// A line that could not be read may have opened or closed anything.
    unsure: bool,
}

impl Equations {
    /// A line that could not be read.
    pub(super) fn unreadable(&mut self) {
        self.unsure = true;
    }

    /// An instruction; gives whether it is an LDR that pushes.
    pub(in crate::semantics) fn step(
        &mut self,
        entry: &Entry,
        has_operand: bool,
        line: u32,
        columns: &Columns,
    ) -> bool {
        match entry.equation {
            Equation::None | Equation::Modify => {}
            Equation::Open => return self.load((line, columns.clone())),
            Equation::Combine if has_operand => {}
            Equation::Combine => self.pop(entry, line, columns),
            Equation::Overwrite => {
                if let Some(open) = self.open.as_mut().filter(|_| !entry.reads.contains(&Effect::Rlo)) {
                    let message = format!(
                        "{} overwrites RLO, so the equation that is open here has no effect; close it first",
                        entry.name
                    );
                    let (began, at) = open.began.clone();
                    let finding = Finding::new(&rules::LOST_EQUATION, line, columns.clone(), message);
                    open.lost = Some(finding.beside(began, at, "the equation begins here"));
                }
            }
            Equation::Terminal => self.findings.extend(self.open.take().and_then(|open| open.lost)),
        }
        false
    }

    /// A macro is called; gives the state before it.
    pub(super) fn enter(&mut self, flag: StackFlag) -> Equations {
        let before = Equations {
            open: self.open.clone(),
            pushed: self.pushed.clone(),
            findings: Vec::new(),
            reported: self.findings.len(),
            unsure: false,
        };
        if flag == StackFlag::Begin {
            self.open = None;
            self.pushed.clear();
        }
        before
    }

    /// The lines of a macro are over: what counts from here on is what its flag says.
    pub(super) fn leave(&mut self, before: Equations, flag: StackFlag, spot: Spot, word: &str) {
        let clean = self.findings.len() == before.reported;
        if clean
            && before.open.is_some()
            && self.pushed.len() > before.pushed.len()
            && flag != StackFlag::Push
        {
            let message = format!(
                "an equation is open here, and {word} begins another one that does not take it back; close it before"
            );
            self.findings.push(Finding::new(&macros::MACRO_FLAG_MISMATCH, spot.0, spot.1.clone(), message));
        }
        let unmoved = match flag {
            StackFlag::Push if before.open.is_some() => self.pushed.len() <= before.pushed.len(),
            StackFlag::Pop => !before.pushed.is_empty() && self.pushed.len() >= before.pushed.len(),
            _ => false,
        };
        if clean && unmoved {
            let message = format!(
                "{} says that {word} moves RLO to or from the stack, but no instruction of its body does",
                flag.word()
            );
            self.findings.push(Finding::new(&macros::MACRO_FLAG_MISMATCH, spot.0, spot.1.clone(), message));
        }
        let lost = self.open.take().and_then(|open| open.lost);
        self.open = before.open;
        self.pushed = before.pushed;
        match flag {
            StackFlag::Normal => {}
            StackFlag::Begin => {
                self.open = None;
                self.pushed.clear();
            }
            StackFlag::End => {
                self.findings.extend(self.open.take().and_then(|open| open.lost).or(lost));
            }
            StackFlag::Push => {
                self.load(spot);
            }
            StackFlag::Pop => {
                if let Some((_, began)) = self.pushed.pop() {
                    self.open = Some(Open { began, lost: None });
                } else if clean {
                    let message = format!(
                        "{word} takes a value from the stack (T_POP), but no LDR pushed one before the call"
                    );
                    self.findings.push(Finding::new(&rules::POP_WITHOUT_PUSH, spot.0, spot.1, message));
                }
            }
        }
    }

    /// As if an LDR stood before the first line.
    pub(in crate::semantics) fn push_one(&mut self) {
        self.load((0, 0..0));
    }

    /// What the lines so far leave: an open equation, and pushed values.
    pub(in crate::semantics) fn left(&self) -> (bool, usize) {
        (self.open.is_some(), self.pushed.len())
    }

    fn load(&mut self, spot: Spot) -> bool {
        let now = Open { began: spot.clone(), lost: None };
        let Some(before) = self.open.replace(now) else { return false };
        if self.pushed.len() == STACK_DEPTH {
            let message = format!("this LDR pushes a value, but the stack holds {STACK_DEPTH} already");
            self.findings.push(Finding::new(&rules::STACK_TOO_DEEP, spot.0, spot.1.clone(), message));
        }
        self.pushed.push((spot, before.began));
        true
    }

    fn pop(&mut self, entry: &Entry, line: u32, columns: &Columns) {
        if let Some((_, began)) = self.pushed.pop() {
            self.open = Some(Open { began, lost: None });
        } else {
            let message = format!(
                "{} without operand takes a value from the stack, but no LDR pushed one; give it an operand",
                entry.name
            );
            self.findings.push(Finding::new(&rules::POP_WITHOUT_PUSH, line, columns.clone(), message));
        }
    }

    /// CHECK, or the end of the section. A procedure may hand RLO to its caller.
    pub(super) fn check(&mut self, returns_rlo: bool) {
        let left = std::mem::take(&mut self.pushed);
        let open = self.open.take();
        if left.is_empty()
            && let Some(open) = open.filter(|_| !returns_rlo)
        {
            let message = "this equation is never closed: its result goes nowhere; add WR, FL1 or another \
                               terminal instruction";
            self.findings.push(Finding::new(&rules::OPEN_EQUATION, open.began.0, open.began.1, message));
        }
        for (push, began) in left {
            let message = "this LDR pushes the RLO of the equation that is still open, and nothing takes it back; \
                           close that equation before, or add LA, LO or LX without operand";
            let finding = Finding::new(&rules::VALUE_LEFT_ON_STACK, push.0, push.1, message);
            self.findings.push(finding.beside(began.0, began.1, "the open equation begins here"));
        }
    }

    /// What was found; nothing when a line could not be read, since every conclusion after it would be a guess.
    pub(super) fn finish(self) -> Vec<Finding> {
        if self.unsure { Vec::new() } else { self.findings }
    }
}
