//! `--set NAME=VALUE[@CYCLE]`, `--fault NAME[@CYCLE]`, `--press KEY[@CYCLE]`, `--release KEY[@CYCLE]`: what is done to the program and its machine, and when.

use technol_analysis::expression::{self, Assignment, RegisterValues, Target};
use technol_image::system::{IN_PORT_COUNT, IN_PORTS};
use technol_image::{DebugInfo, Program};
use technol_runtime::AccessError;
use technol_target::Simulation;

use crate::arguments::RunArguments;
use crate::exit::Failure;

/// One change, before cycle `cycle`.
struct Change {
    cycle: u64,
    what: What,
}

enum What {
    Set(Assignment),
    Fault(String),
    Key { name: String, down: bool },
}

/// All changes, in the order they were given.
pub(super) struct Changes {
    changes: Vec<Change>,
}

impl Changes {
    /// Reads the options; every name and value is checked against the program.
    pub(super) fn parse(
        arguments: &RunArguments,
        debug: &DebugInfo,
        program: &Program,
    ) -> Result<Changes, Failure> {
        let mut changes = Vec::new();
        for text in &arguments.set {
            changes.push(set(text, debug, program)?);
        }
        for text in &arguments.fault {
            let (name, cycle) = at_cycle("--fault", text)?;
            changes.push(Change { cycle, what: What::Fault(name.to_owned()) });
        }
        for (option, texts, down) in
            [("--press", &arguments.press, true), ("--release", &arguments.release, false)]
        {
            for text in texts {
                let (name, cycle) = at_cycle(option, text)?;
                changes.push(Change { cycle, what: What::Key { name: name.to_owned(), down } });
            }
        }
        Ok(Changes { changes })
    }

    /// Checks the names of faults and keys against the machine.
    pub(super) fn check(&self, simulation: &Simulation) -> Result<(), Failure> {
        let faults: Vec<&str> = simulation.plant().faults().map(|(name, _)| name).collect();
        let keys: Vec<&str> = simulation.plant().keys().map(|(name, _)| name).collect();
        for change in &self.changes {
            match &change.what {
                What::Set(_) => {}
                What::Fault(name) => known("fault", name, &faults)?,
                What::Key { name, .. } => known("key", name, &keys)?,
            }
        }
        Ok(())
    }

    /// Does what is due before a cycle.
    pub(super) fn apply(&mut self, cycle: u64, simulation: &mut Simulation) -> Result<(), Failure> {
        for change in self.changes.iter().filter(|c| c.cycle == cycle) {
            match &change.what {
                What::Set(assignment) => {
                    assign(assignment, simulation).map_err(|e| Failure::usage(format!("--set: {e}")))?;
                }
                What::Fault(name) => simulation
                    .plant_mut()
                    .set_fault(name, true)
                    .map_err(|e| Failure::usage(format!("--fault {name}: {e}")))?,
                What::Key { name, down } => simulation
                    .plant_mut()
                    .press(name, *down)
                    .map_err(|e| Failure::usage(format!("key {name}: {e}")))?,
            }
        }
        Ok(())
    }
}

fn known(what: &str, name: &str, names: &[&str]) -> Result<(), Failure> {
    if names.contains(&name) {
        return Ok(());
    }
    let list = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    Err(Failure::usage(format!("the machine has no {what} `{name}`; it has: {list}")))
}

/// `TEXT[@CYCLE]`
fn at_cycle<'a>(option: &str, text: &'a str) -> Result<(&'a str, u64), Failure> {
    match text.rsplit_once('@') {
        None => Ok((text, 0)),
        Some((before, cycle)) => match cycle.trim().parse() {
            Ok(cycle) => Ok((before, cycle)),
            Err(_) => Err(Failure::usage(format!("{option} {text}: `{cycle}` is not a number of a cycle"))),
        },
    }
}

fn set(text: &str, debug: &DebugInfo, program: &Program) -> Result<Change, Failure> {
    let (assignment, cycle) = at_cycle("--set", text)?;
    let wrong = |why: String| Failure::usage(format!("--set {text}: {why}"));
    let (name, value) =
        assignment.split_once('=').ok_or_else(|| wrong("write NAME=VALUE or NAME=VALUE@CYCLE".to_owned()))?;
    let target = resolve(debug, program, name.trim()).map_err(wrong)?;
    let what = target.assign(value).map_err(|e| wrong(e.to_string()))?;
    Ok(Change { cycle, what: What::Set(what) })
}

/// What a name stands for; a mechanism is its activation bit.
pub(crate) fn resolve(debug: &DebugInfo, program: &Program, name: &str) -> Result<Target, String> {
    Ok(expression::resolve(debug, None, name).map_err(|e| e.to_string())?.in_memory(program))
}

/// Gives memory, an input port or a register its new value.
pub(crate) fn assign(assignment: &Assignment, simulation: &mut Simulation) -> Result<(), AccessError> {
    match assignment {
        Assignment::Bit { addr, bit, value } => {
            if let Some(port) = input_port(*addr) {
                let byte = &mut simulation.inputs_mut()[port];
                *byte = if *value { *byte | 1 << bit } else { *byte & !(1 << bit) };
            }
            simulation.runtime_mut().write_bit(*addr, *bit, *value)
        }
        Assignment::Memory { addr, bytes } => {
            for (address, byte) in (*addr..).zip(bytes) {
                if let Some(port) = input_port(address) {
                    simulation.inputs_mut()[port] = *byte;
                }
            }
            simulation.runtime_mut().write_memory(*addr, bytes)
        }
        Assignment::Registers(change) => {
            let mut registers = simulation.runtime().registers();
            let after = change.apply(values(&registers));
            registers.rlo = after.rlo;
            registers.dr = after.dr;
            registers.dr_real = after.dr_real;
            registers.bx = after.bx;
            simulation.runtime_mut().set_registers(registers);
            Ok(())
        }
    }
}

/// An input port is copied from the machine in each cycle: to set it, the machine's side is set.
pub(crate) fn input_port(addr: u32) -> Option<usize> {
    addr.checked_sub(IN_PORTS).filter(|n| *n < IN_PORT_COUNT).map(|n| n as usize)
}

/// Registers as expressions read them.
pub(crate) fn values(registers: &technol_runtime::Registers) -> RegisterValues {
    RegisterValues { rlo: registers.rlo, dr: registers.dr, dr_real: registers.dr_real, bx: registers.bx }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cycle_may_follow_the_change() {
        let read = |text| at_cycle("--set", text).map_err(|e| e.message);
        assert_eq!(read("A=1"), Ok(("A=1", 0)));
        assert_eq!(read("A=1@250"), Ok(("A=1", 250)));
        assert!(read("A=1@soon").unwrap_err().contains("`soon` is not a number"));
    }
}
