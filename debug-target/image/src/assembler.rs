//! The 80386 instructions that a program may mix with those of TECHNOL (manual 3.1 and 22.3).
//!
//! The general registers are views of what TECHNOL works with: bit 40h of AH is RLO, ECX is the low half of DR and
//! EDX its high half, BX is the index. Only the rest of EAX, and the flags, exist for these instructions alone.

use serde::{Deserialize, Serialize};

use crate::op::{Place, Width};

/// A general register of 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum General {
    /// EAX; bit 40h of its second byte is RLO.
    A,
    /// EBX, the index register.
    B,
    /// ECX, the low half of DR.
    C,
    /// EDX, the high half of DR.
    D,
}

/// A part of a general register.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Part {
    /// Bits 0 to 7.
    Low,
    /// Bits 8 to 15.
    High,
    /// Bits 0 to 15.
    Word,
    /// All 32 bits.
    Whole,
}

/// A register as an instruction names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Register {
    /// Which register.
    pub general: General,
    /// Which of its bits.
    pub part: Part,
}

impl Register {
    /// CL, the register that counts shifts.
    pub const CL: Register = Register { general: General::C, part: Part::Low };

    /// All registers with their names.
    pub const ALL: [(&'static str, Register); 16] = {
        const fn r(general: General, part: Part) -> Register {
            Register { general, part }
        }
        [
            ("AL", r(General::A, Part::Low)),
            ("AH", r(General::A, Part::High)),
            ("AX", r(General::A, Part::Word)),
            ("EAX", r(General::A, Part::Whole)),
            ("BL", r(General::B, Part::Low)),
            ("BH", r(General::B, Part::High)),
            ("BX", r(General::B, Part::Word)),
            ("EBX", r(General::B, Part::Whole)),
            ("CL", Register::CL),
            ("CH", r(General::C, Part::High)),
            ("CX", r(General::C, Part::Word)),
            ("ECX", r(General::C, Part::Whole)),
            ("DL", r(General::D, Part::Low)),
            ("DH", r(General::D, Part::High)),
            ("DX", r(General::D, Part::Word)),
            ("EDX", r(General::D, Part::Whole)),
        ]
    };

    /// The register of that name (upper case).
    #[must_use]
    pub fn named(name: &str) -> Option<Register> {
        Register::ALL.iter().find(|(known, _)| *known == name).map(|(_, register)| *register)
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Register::ALL.iter().find(|(_, known)| *known == self).map_or("?", |(name, _)| name)
    }

    /// Its width.
    #[must_use]
    pub const fn width(self) -> Width {
        match self.part {
            Part::Low | Part::High => Width::Byte,
            Part::Word => Width::Word,
            Part::Whole => Width::DWord,
        }
    }
}

/// An operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Operand {
    /// A register.
    Register(Register),
    /// A memory cell of the width of the instruction.
    Cell(Place),
    /// A number; only its low bits count, as many as the instruction is wide.
    Number(u32),
}

/// What an instruction does with its operands. Flags as on the 80386.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Function {
    /// MOV: the flags stay.
    Move,
    /// ADD.
    Add,
    /// SUB.
    Sub,
    /// AND: clears carry and overflow.
    And,
    /// OR: clears carry and overflow.
    Or,
    /// XOR: clears carry and overflow.
    Xor,
    /// CMP: the flags of SUB and nothing else.
    Compare,
    /// INC: adds the second operand, which is the number 1; the carry stays.
    Increment,
    /// DEC: subtracts the second operand, which is the number 1; the carry stays.
    Decrement,
    /// SHL: by the low 5 bits of a number or of CL; by 0 the flags stay.
    ShiftLeft,
    /// SHR: as SHL.
    ShiftRight,
}

/// When a conditional jump jumps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Condition {
    /// JO.
    Overflow,
    /// JNO.
    NoOverflow,
    /// JB, JC, JNAE: carry.
    Below,
    /// JAE, JNB, JNC: no carry.
    AboveOrEqual,
    /// JE, JZ: zero.
    Equal,
    /// JNE, JNZ.
    NotEqual,
    /// JBE, JNA: carry or zero.
    BelowOrEqual,
    /// JA, JNBE.
    Above,
    /// JS.
    Negative,
    /// JNS.
    NotNegative,
    /// JP, JPE: an even number of ones in the low byte.
    ParityEven,
    /// JNP, JPO.
    ParityOdd,
    /// JL, JNGE: sign differs from overflow.
    Less,
    /// JGE, JNL.
    GreaterOrEqual,
    /// JLE, JNG: less, or zero.
    LessOrEqual,
    /// JG, JNLE.
    Greater,
    /// JCXZ: CX is 0.
    CxZero,
    /// JECXZ: ECX is 0.
    EcxZero,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op::Op;

    #[test]
    fn registers_are_found_by_their_names_and_as_wide_as_they_say() {
        for (name, register) in Register::ALL {
            assert_eq!(Register::named(name), Some(register));
            assert_eq!(register.name(), name);
            let width = match name.as_bytes() {
                [b'E', ..] => Width::DWord,
                [_, b'X'] => Width::Word,
                _ => Width::Byte,
            };
            assert_eq!(register.width(), width, "{name}");
        }
        assert_eq!(Register::named("SI"), None);
    }

    #[test]
    fn an_operation_stays_as_small_as_without_these_instructions() {
        // The largest others carry a real constant of 8 bytes beside other things.
        assert_eq!((size_of::<Operand>(), size_of::<Op>()), (8, 24));
    }
}
