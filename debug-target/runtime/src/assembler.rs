//! The 80386 instructions (manual 3.1 and 22.3): operands, results and flags as on that processor.
//!
//! Registers are mapped when they are read and written: EAX has RLO in it, ECX and EDX are the halves of DR, EBX is the
//! index. One thing differs from the processor: writing BX clears the upper half of EBX, so that `[BX]` always means
//! what a program put in BX.

use technol_image::assembler::{Condition, Function, General, Operand, Part, Register};
use technol_image::op::Width;

use crate::fault::FaultKind;
use crate::memory::Memory;
use crate::registers::{Registers, mask};

/// The bit of EAX that is RLO: weight 40h of AH.
pub(crate) const RLO: u32 = 0x4000;

const CARRY: u16 = 0x001;
const PARITY: u16 = 0x004;
const ZERO: u16 = 0x040;
const SIGN: u16 = 0x080;
const OVERFLOW: u16 = 0x800;

/// Executes one instruction. A fault leaves registers, flags and memory as they were.
pub(crate) fn execute(
    memory: &mut Memory,
    regs: &mut Registers,
    function: Function,
    width: Width,
    to: Operand,
    from: Operand,
) -> Result<(), FaultKind> {
    let operand = read(memory, regs, width, from)?;
    let before = if function == Function::Move { 0 } else { read(memory, regs, width, to)? };
    let (result, flags) = compute(function, width, before, operand, regs.flags);
    if function != Function::Compare {
        match to {
            Operand::Register(register) => set_register(regs, register, result as u32),
            Operand::Cell(place) => memory.write(place, width, regs.bx, result as i64)?,
            // Rejected at load.
            Operand::Number(_) => {}
        }
    }
    regs.flags = flags;
    Ok(())
}

/// Whether a conditional jump jumps.
pub(crate) fn holds(regs: &Registers, condition: Condition) -> bool {
    let any = |flags: u16| regs.flags & flags != 0;
    let less = any(SIGN) != any(OVERFLOW);
    match condition {
        Condition::Overflow => any(OVERFLOW),
        Condition::NoOverflow => !any(OVERFLOW),
        Condition::Below => any(CARRY),
        Condition::AboveOrEqual => !any(CARRY),
        Condition::Equal => any(ZERO),
        Condition::NotEqual => !any(ZERO),
        Condition::BelowOrEqual => any(CARRY | ZERO),
        Condition::Above => !any(CARRY | ZERO),
        Condition::Negative => any(SIGN),
        Condition::NotNegative => !any(SIGN),
        Condition::ParityEven => any(PARITY),
        Condition::ParityOdd => !any(PARITY),
        Condition::Less => less,
        Condition::GreaterOrEqual => !less,
        Condition::LessOrEqual => less || any(ZERO),
        Condition::Greater => !less && !any(ZERO),
        Condition::CxZero => regs.dr as u16 == 0,
        Condition::EcxZero => regs.dr as u32 == 0,
    }
}

/// An operand as an unsigned number.
fn read(memory: &Memory, regs: &Registers, width: Width, operand: Operand) -> Result<u64, FaultKind> {
    Ok(match operand {
        Operand::Register(register) => u64::from(get_register(regs, register)),
        Operand::Cell(place) => (memory.read(place, width, regs.bx)? & mask(width)) as u64,
        Operand::Number(value) => u64::from(value) & mask(width) as u64,
    })
}

fn whole(regs: &Registers, general: General) -> u32 {
    match general {
        General::A => regs.whole_eax(),
        General::B => regs.bx,
        General::C => regs.dr as u32,
        General::D => (regs.dr >> 32) as u32,
    }
}

fn get_register(regs: &Registers, register: Register) -> u32 {
    let value = whole(regs, register.general);
    match register.part {
        Part::Low => value & 0xFF,
        Part::High => value >> 8 & 0xFF,
        Part::Word => value & 0xFFFF,
        Part::Whole => value,
    }
}

fn set_register(regs: &mut Registers, register: Register, value: u32) {
    let old = whole(regs, register.general);
    let new = match (register.part, register.general) {
        (Part::Low, _) => old & !0xFF | value & 0xFF,
        (Part::High, _) => old & !0xFF00 | (value & 0xFF) << 8,
        (Part::Word, General::B) => value & 0xFFFF,
        (Part::Word, _) => old & !0xFFFF | value & 0xFFFF,
        (Part::Whole, _) => value,
    };
    match register.general {
        General::A => {
            regs.rlo = new & RLO != 0;
            regs.eax = new & !RLO;
        }
        General::B => regs.bx = new,
        General::C => regs.set_low(Width::DWord, i64::from(new)),
        General::D => regs.dr = (u64::from(new) << 32 | u64::from(regs.dr as u32)) as i64,
    }
}

/// Result and flags. What the 80386 leaves undefined (overflow of a shift by more than 1, carry of one by more than the
/// width) follows the same formula as the defined cases.
fn compute(function: Function, width: Width, a: u64, b: u64, flags: u16) -> (u64, u16) {
    let bits = width.bits();
    let mask = mask(width) as u64;
    let top = 1_u64 << (bits - 1);
    let count = b & 31;
    let (result, carry, overflow) = match function {
        Function::Move => return (b, flags),
        Function::ShiftLeft | Function::ShiftRight if count == 0 => return (a, flags),
        Function::Add | Function::Increment => {
            let sum = a + b;
            (sum, sum > mask, (a ^ sum) & (b ^ sum) & top != 0)
        }
        Function::Sub | Function::Compare | Function::Decrement => {
            let difference = a.wrapping_sub(b);
            (difference, a < b, (a ^ b) & (a ^ difference) & top != 0)
        }
        Function::And => (a & b, false, false),
        Function::Or => (a | b, false, false),
        Function::Xor => (a ^ b, false, false),
        Function::ShiftLeft => {
            let shifted = a << count;
            let carry = shifted >> bits & 1 != 0;
            (shifted, carry, (shifted & top != 0) != carry)
        }
        Function::ShiftRight => (a >> count, a >> (count - 1) & 1 != 0, a & top != 0),
    };
    let result = result & mask;
    let carry = match function {
        Function::Increment | Function::Decrement => flags & CARRY != 0,
        _ => carry,
    };
    let flag = |bit, set| if set { bit } else { 0 };
    let flags = flag(CARRY, carry)
        | flag(PARITY, (result as u8).count_ones().is_multiple_of(2))
        | flag(ZERO, result == 0)
        | flag(SIGN, result & top != 0)
        | flag(OVERFLOW, overflow);
    (result, flags)
}
