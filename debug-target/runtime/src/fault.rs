//! Run-time faults: what stops the PLC (manual leaves them undefined; here each is named and placed).

use core::fmt;

use technol_image::op::Pc;
use technol_image::program::ModuleKind;
use technol_image::service::Service;

/// What went wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// DIVB by zero, integer or real.
    DivisionByZero,
    /// DIVB: the integer quotient does not fit 32 bits.
    QuotientOverflow,
    /// BIN, BCD, INRBCD, CUBCD: a digit above 9, a negative number, or a number with too many digits.
    BcdRange,
    /// An indexed access outside PLC memory.
    BadAddress {
        /// Effective address.
        addr: i64,
        /// Length of the access in bytes.
        len: u32,
    },
    /// The module did not end within its budget of instructions: an endless loop.
    EndlessLoop,
    /// More than eight values on the equation stack.
    EquationOverflow,
    /// LA, LO or LX without operand on an empty equation stack.
    EquationUnderflow,
    /// Procedures are called too deeply (recursion).
    CallDepth,
    /// A procedure body was entered without a call.
    UnexpectedReturn,
    /// The module ended inside a procedure.
    UnexpectedEnd,
    /// The continuation cell of a sequence was overwritten: it names no EX-type instruction.
    BadContinuation {
        /// Sequence.
        sequence: u16,
        /// Content of the cell.
        point: u16,
    },
    /// The control has no such instruction.
    NoService(Service),
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FaultKind::DivisionByZero => f.write_str("division by zero"),
            FaultKind::QuotientOverflow => f.write_str("the quotient does not fit 32 bits"),
            FaultKind::BcdRange => f.write_str("not a BCD number, or out of the BCD range"),
            FaultKind::BadAddress { addr, len } => {
                write!(f, "indexed access of {len} bytes at address {addr} is outside PLC memory")
            }
            FaultKind::EndlessLoop => f.write_str("endless loop: the module does not end"),
            FaultKind::EquationOverflow => f.write_str("the equation stack is full (8 values)"),
            FaultKind::EquationUnderflow => f.write_str("the equation stack is empty"),
            FaultKind::CallDepth => f.write_str("procedures are called too deeply"),
            FaultKind::UnexpectedReturn => f.write_str("end of a procedure reached without a call"),
            FaultKind::UnexpectedEnd => f.write_str("end of the module reached inside a procedure"),
            FaultKind::NoService(service) => {
                write!(f, "the control of this target does not carry out {}", service.name())
            }
            FaultKind::BadContinuation { point, .. } => {
                write!(
                    f,
                    "the continuation cell of the mechanism holds {point}, which is no EX-type instruction"
                )
            }
        }
    }
}

/// A fault and its place. The PLC is stopped; memory, registers and call stack stay readable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What went wrong.
    pub kind: FaultKind,
    /// Operation that faulted; it had no effect.
    pub pc: Pc,
    /// Sequence it was executed for.
    pub sequence: Option<u16>,
    /// Module it was executed for.
    pub module: ModuleKind,
    /// File of that module, 0-based in execution order.
    pub file: u8,
    /// 20 ms cycle, counted from the start of the PLC.
    pub cycle: u64,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} in {} of file {}, operation {}, cycle {}",
            self.kind,
            self.module.keyword(),
            self.file + 1,
            self.pc,
            self.cycle
        )
    }
}

impl core::error::Error for Fault {}
