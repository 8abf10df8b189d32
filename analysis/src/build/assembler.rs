//! The 80386 instructions: from names to operations and back (manual 3.1 and 22.3).

use technol_image::assembler::{Condition, Function, General, Operand as Given, Part, Register};
use technol_image::op::{Op, Place, Width};

use super::mnemonic::Form;
use super::section_code::{ProblemKind, SectionCode};
use crate::semantics::hir::Operand;

const FUNCTIONS: &[Function] = &[
    Function::Move,
    Function::Add,
    Function::Sub,
    Function::And,
    Function::Or,
    Function::Xor,
    Function::Compare,
    Function::Increment,
    Function::Decrement,
    Function::ShiftLeft,
    Function::ShiftRight,
];

/// The first name of each condition is the one a listing shows.
const JUMPS: &[(&str, Condition)] = &[
    ("JO", Condition::Overflow),
    ("JNO", Condition::NoOverflow),
    ("JB", Condition::Below),
    ("JC", Condition::Below),
    ("JNAE", Condition::Below),
    ("JAE", Condition::AboveOrEqual),
    ("JNB", Condition::AboveOrEqual),
    ("JNC", Condition::AboveOrEqual),
    ("JE", Condition::Equal),
    ("JZ", Condition::Equal),
    ("JNE", Condition::NotEqual),
    ("JNZ", Condition::NotEqual),
    ("JBE", Condition::BelowOrEqual),
    ("JNA", Condition::BelowOrEqual),
    ("JA", Condition::Above),
    ("JNBE", Condition::Above),
    ("JS", Condition::Negative),
    ("JNS", Condition::NotNegative),
    ("JP", Condition::ParityEven),
    ("JPE", Condition::ParityEven),
    ("JNP", Condition::ParityOdd),
    ("JPO", Condition::ParityOdd),
    ("JL", Condition::Less),
    ("JNGE", Condition::Less),
    ("JGE", Condition::GreaterOrEqual),
    ("JNL", Condition::GreaterOrEqual),
    ("JLE", Condition::LessOrEqual),
    ("JNG", Condition::LessOrEqual),
    ("JG", Condition::Greater),
    ("JNLE", Condition::Greater),
    ("JCXZ", Condition::CxZero),
    ("JECXZ", Condition::EcxZero),
];

/// How `mnemonic` (upper case) is translated; `None` when it is no 80386 instruction that the target executes.
pub(super) fn form(mnemonic: &str) -> Option<Form> {
    let function = FUNCTIONS.iter().find(|function| function.mnemonic() == mnemonic);
    let jump = || JUMPS.iter().find(|(name, _)| *name == mnemonic);
    function
        .map(|function| Form::Assembler(*function))
        .or_else(|| jump().map(|(_, condition)| Form::AssemblerJump(*condition)))
}

/// The mnemonic of a conditional jump.
pub(super) fn jump(condition: Condition) -> &'static str {
    JUMPS.iter().find(|(_, known)| *known == condition).map_or("?", |(name, _)| name)
}

/// An instruction as text.
pub(super) fn text(function: Function, to: Given, from: Given, cell: impl Fn(Place) -> String) -> String {
    let name = function.mnemonic();
    let operand = |operand: Given| match operand {
        Given::Register(register) => register.name().to_owned(),
        Given::Cell(place) => cell(place),
        Given::Number(value) => value.to_string(),
    };
    match function {
        Function::Increment | Function::Decrement => format!("{name} {}", operand(to)),
        _ => format!("{name} {},{}", operand(to), operand(from)),
    }
}

impl SectionCode {
    /// The operation of the instruction `name` with operands that the check has accepted.
    pub(super) fn assembler(
        &mut self,
        function: Function,
        name: &'static str,
        list: &[Operand],
    ) -> Result<Op, ProblemKind> {
        let shift = matches!(function, Function::ShiftLeft | Function::ShiftRight);
        let (to, first) = self.processor_operand(name, list, 0)?;
        let (from, second) = match function {
            Function::Increment | Function::Decrement => (Given::Number(1), None),
            _ => self.processor_operand(name, list, 1)?,
        };
        let width = first.ok_or(ProblemKind::Operand(1, name))?;
        if second.is_some_and(|second| second != width && !shift) {
            return Err(ProblemKind::Operand(2, name));
        }
        if !matches!(width, Width::Byte | Width::Word | Width::DWord) {
            return Err(ProblemKind::NotExecutable(format!("{name} with 64 bits")));
        }
        let bx = Given::Register(Register { general: General::B, part: Part::Word });
        let cx = Given::Register(Register { general: General::C, part: Part::Word });
        if function == Function::Move && to == bx && from == cx {
            return Ok(Op::IndexFromDr);
        }
        Ok(Op::Assembler { function, width, to, from })
    }

    /// An operand and its width, which a number has not.
    fn processor_operand(
        &mut self,
        name: &'static str,
        list: &[Operand],
        n: usize,
    ) -> Result<(Given, Option<Width>), ProblemKind> {
        let register = |word: &str| match Register::named(word) {
            Some(register) => Ok((Given::Register(register), Some(register.width()))),
            None => Err(ProblemKind::NotExecutable(format!("{name} with the register {word}"))),
        };
        match list.get(n) {
            Some(Operand::Keyword(word)) => register(word),
            Some(Operand::Text(word)) => register(word),
            Some(Operand::Cell { address, width, negated: false }) => {
                Ok((Given::Cell(self.address(address)), Some(*width)))
            }
            // The check lets pass what fits, signed or unsigned; the low bits are the same.
            Some(Operand::Integer { value, .. }) => Ok((Given::Number(*value as u32), None)),
            _ => Err(ProblemKind::Operand(n + 1, name)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_condition_has_a_name_and_every_name_a_form() {
        for (name, condition) in JUMPS {
            assert_eq!(form(name), Some(Form::AssemblerJump(*condition)), "{name}");
            assert_eq!(form(jump(*condition)), Some(Form::AssemblerJump(*condition)), "{name}");
        }
        for function in FUNCTIONS {
            let name = function.mnemonic();
            assert_eq!(form(name), Some(Form::Assembler(*function)), "{name}");
        }
        assert_eq!((form("JXX"), form("ADC")), (None, None));
    }
}
