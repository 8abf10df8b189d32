//! The runtime's words in the words of the protocol, which knows nothing of the runtime.

use technol_image::program::ModuleKind;
use technol_runtime as runtime;
use technol_wire::message as wire;

pub(crate) fn module(kind: ModuleKind) -> u8 {
    // The order of the enumeration is the protocol's numbering; the test holds it.
    kind as u8
}

pub(crate) fn state(state: runtime::PlcState) -> wire::PlcState {
    match state {
        runtime::PlcState::Stopped => wire::PlcState::Stopped,
        runtime::PlcState::Starting => wire::PlcState::Starting,
        runtime::PlcState::Running => wire::PlcState::Running,
        runtime::PlcState::Stopping => wire::PlcState::Stopping,
        runtime::PlcState::Halted => wire::PlcState::Halted,
        runtime::PlcState::Faulted => wire::PlcState::Faulted,
    }
}

pub(crate) fn registers(r: runtime::Registers) -> wire::Registers {
    wire::Registers { rlo: r.rlo, dr: r.dr, dr_real: r.dr_real, bx: r.bx, stack: r.stack, depth: r.depth }
}

pub(crate) fn machine_registers(r: runtime::Registers) -> wire::MachineRegisters {
    wire::MachineRegisters { eax: r.whole_eax(), flags: r.flags }
}

/// What the host does not know stays as it is `now`.
pub(crate) fn registers_back(r: wire::Registers, now: runtime::Registers) -> runtime::Registers {
    let wire::Registers { rlo, dr, dr_real, bx, stack, depth } = r;
    runtime::Registers { rlo, dr, dr_real, bx, stack, depth, ..now }
}

pub(crate) fn frames(frames: &[runtime::Frame]) -> Vec<wire::Frame> {
    let frame = |f: &runtime::Frame| wire::Frame {
        pc: f.pc,
        procedure: f.procedure,
        sequence: f.sequence,
        module: module(f.module),
    };
    frames.iter().map(frame).collect()
}

pub(crate) fn stopped(plc: &runtime::Runtime, stop: &runtime::Stop) -> wire::Stopped {
    let reason = match stop.reason {
        runtime::StopReason::Breakpoint => wire::StopReason::Breakpoint,
        runtime::StopReason::Step => wire::StopReason::Step,
        runtime::StopReason::Pause => wire::StopReason::Pause,
        runtime::StopReason::Entry => wire::StopReason::Entry,
        runtime::StopReason::Fault => wire::StopReason::Fault,
    };
    wire::Stopped {
        reason,
        pc: stop.pc,
        module: module(stop.module),
        sequence: stop.sequence,
        cycle: plc.cycle(),
        registers: registers(plc.registers()),
        frames: frames(&stop.call_stack),
    }
}

pub(crate) fn sequence(s: runtime::SequenceState) -> wire::SequenceState {
    wire::SequenceState {
        sequence: s.sequence,
        active: s.active,
        resume: s.resume,
        line: s.line,
        since: u32::try_from(s.cycles_in_state).unwrap_or(u32::MAX),
    }
}

pub(crate) fn breakpoint(result: Result<(), runtime::BreakpointError>) -> wire::BreakpointState {
    match result {
        Ok(()) => wire::BreakpointState::Set,
        Err(runtime::BreakpointError::NotAStatement) => wire::BreakpointState::NotAStatement,
        Err(runtime::BreakpointError::InFast) => wire::BreakpointState::InFast,
        Err(runtime::BreakpointError::InCont) => wire::BreakpointState::InCont,
    }
}

pub(crate) fn resume(how: wire::Resume) -> runtime::Resume {
    match how {
        wire::Resume::Continue => runtime::Resume::Continue,
        wire::Resume::Into => runtime::Resume::StepInto,
        wire::Resume::Over { sequence } => runtime::Resume::StepOver { sequence },
        wire::Resume::Out => runtime::Resume::StepOut,
    }
}

pub(crate) fn fault(fault: &runtime::Fault) -> wire::Fault {
    let kind = match fault.kind {
        runtime::FaultKind::DivisionByZero => wire::FaultKind::DivisionByZero,
        runtime::FaultKind::QuotientOverflow => wire::FaultKind::QuotientOverflow,
        runtime::FaultKind::BcdRange => wire::FaultKind::BcdRange,
        runtime::FaultKind::BadAddress { .. } => wire::FaultKind::BadAddress,
        runtime::FaultKind::EndlessLoop => wire::FaultKind::EndlessLoop,
        runtime::FaultKind::EquationOverflow => wire::FaultKind::StackOverflow,
        runtime::FaultKind::EquationUnderflow => wire::FaultKind::StackUnderflow,
        runtime::FaultKind::CallDepth => wire::FaultKind::CallDepth,
        runtime::FaultKind::UnexpectedReturn => wire::FaultKind::UnexpectedReturn,
        runtime::FaultKind::UnexpectedEnd => wire::FaultKind::UnexpectedEnd,
        runtime::FaultKind::BadContinuation { .. } => wire::FaultKind::BadContinuation,
        runtime::FaultKind::NoService(_) => wire::FaultKind::NoService,
    };
    wire::Fault {
        kind,
        pc: fault.pc,
        module: module(fault.module),
        sequence: fault.sequence,
        cycle: fault.cycle,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_are_numbered_in_the_order_of_the_protocol() {
        assert!(ModuleKind::ALL.into_iter().map(module).eq(0..12));
    }
}
