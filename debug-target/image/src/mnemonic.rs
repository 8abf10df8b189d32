//! Mnemonics of the kinds of operations: what a listing and reports call them (manual chapters 3, 4 and 22.3).

use crate::assembler::Function;
use crate::op::{Arith, Compare, Count, Logic, Raster, Unary};

impl Logic {
    /// The mnemonic of its instruction.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Logic::And => "LA",
            Logic::Or => "LO",
            Logic::Xor => "LX",
        }
    }
}

impl Arith {
    /// The mnemonic of its instruction.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Arith::Add => "AD",
            Arith::Sub => "SU",
            Arith::Mul => "MULB",
            Arith::Div => "DIVB",
            Arith::Or => "ORB",
            Arith::And => "ANDB",
            Arith::Xor => "XORB",
        }
    }
}

impl Compare {
    /// The mnemonic of its instruction; that of EQ1 is EQ, too.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Compare::Eq => "EQ",
            Compare::Lt => "LT",
            Compare::Gt => "GT",
            Compare::Le => "LE",
            Compare::Ge => "GE",
        }
    }
}

impl Unary {
    /// The mnemonic of its instruction.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Unary::Increment => "INR",
            Unary::Decrement => "DCR",
            Unary::Negate => "INV",
            Unary::Absolute => "ABS",
        }
    }
}

impl Count {
    /// The mnemonic of its instruction.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Count::Up => "CU",
            Count::Down => "CD",
            Count::UpBcd => "CUBCD",
        }
    }
}

impl Raster {
    /// The mnemonic of its instruction.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Raster::Tenth => "DFTM01",
            Raster::Second => "DFTM1",
            Raster::TenSeconds => "DFTM10",
            Raster::HundredSeconds => "DFTM100",
        }
    }
}

impl Function {
    /// The mnemonic of its instruction.
    #[must_use]
    pub const fn mnemonic(self) -> &'static str {
        match self {
            Function::Move => "MOV",
            Function::Add => "ADD",
            Function::Sub => "SUB",
            Function::And => "AND",
            Function::Or => "OR",
            Function::Xor => "XOR",
            Function::Compare => "CMP",
            Function::Increment => "INC",
            Function::Decrement => "DEC",
            Function::ShiftLeft => "SHL",
            Function::ShiftRight => "SHR",
        }
    }
}
