//! One operation, executed freely and under the debugger, with everything it may touch compared.

use technol_image::op::{Addr, Op};
use technol_runtime::{FaultKind, Registers, Resume, Stop, TickOutcome};

use crate::support::{Bench, Builder};

/// Bytes at an address.
pub(crate) type Bytes<'a> = (Addr, &'a [u8]);

/// Registers that no operation under test produces by accident.
pub(crate) fn registers() -> Registers {
    Registers { dr: 0x0123_4567_89AB_CDEF, dr_real: 0.625, ..Registers::default() }
}

pub(crate) fn with_dr(dr: i64) -> Registers {
    Registers { dr, ..registers() }
}

pub(crate) fn with_rlo(rlo: bool) -> Registers {
    Registers { rlo, ..registers() }
}

/// Executes `ops` as MODULE_MAIN from `before` and compares all registers and all of memory.
#[track_caller]
pub(crate) fn check(
    ops: &[Op],
    before: Registers,
    memory: &[Bytes<'_>],
    after: Registers,
    writes: &[Bytes<'_>],
) {
    let (start, bench) = run(ops, before, memory);
    assert_eq!(bench.plc.fault(), None, "{ops:?}");
    let got = bench.plc.registers();
    assert_eq!(
        (Registers { dr_real: 0.0, ..got }, got.dr_real.to_bits()),
        (Registers { dr_real: 0.0, ..after }, after.dr_real.to_bits()),
        "{ops:?} from {before:x?} gave {got:x?}, expected {after:x?}"
    );
    let mut expected = start;
    for (addr, bytes) in writes {
        expected[*addr as usize..][..bytes.len()].copy_from_slice(bytes);
    }
    for (addr, (got, expected)) in bench.plc.memory().iter().zip(&expected).enumerate() {
        assert_eq!(got, expected, "{ops:?}: byte {addr:#x}");
    }
}

/// Executes `ops` and expects a fault at operation `pc` that changed nothing.
#[track_caller]
pub(crate) fn check_fault(ops: &[Op], before: Registers, memory: &[Bytes<'_>], pc: u32, kind: FaultKind) {
    let (start, bench) = run(ops, before, memory);
    let fault = bench.plc.fault().unwrap_or_else(|| panic!("{ops:?} did not fault"));
    assert_eq!((fault.kind, fault.pc), (kind, pc), "{ops:?}");
    if pc == 0 {
        assert_eq!(bench.plc.registers(), before, "{ops:?}");
        assert!(bench.plc.memory() == start, "{ops:?} changed memory");
    }
}

/// Free run and single steps must agree; returns memory before and the bench after.
#[track_caller]
fn run(ops: &[Op], before: Registers, memory: &[Bytes<'_>]) -> (Vec<u8>, Bench) {
    let mut bench = Builder::new().main(|b| b.ops(ops.iter().copied())).load().started();
    for (addr, bytes) in memory {
        bench.plc.write_memory(*addr, bytes).expect("cell in memory");
    }
    bench.plc.set_registers(before);
    let start = bench.plc.memory().to_vec();
    let mut stepped = bench.clone();
    stepped.plc.pause();
    for _ in 0..=ops.len() + 1 {
        if stepped.tick() == TickOutcome::Done || stepped.plc.fault().is_some() {
            break;
        }
        assert!(matches!(stepped.plc.stopped(), Some(Stop { .. })));
        stepped.plc.resume(Resume::StepInto);
    }
    bench.tick();
    assert_eq!(bench.plc.fault(), stepped.plc.fault(), "{ops:?} freely and stepped");
    // Single steps leave the loop before a module's start would clear the equation stack.
    assert_eq!(bench.plc.state_hash(), stepped.plc.state_hash(), "{ops:?} freely and stepped");
    (start, bench)
}
