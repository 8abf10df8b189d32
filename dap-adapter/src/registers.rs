//! The registers as the user sees and sets them.

use technol_image::op::{STACK_DEPTH, Width};
use technol_wire::message::Registers;

use crate::values;

/// A register or a part of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Register {
    Rlo,
    Dr(Width),
    Bx,
    Stack,
}

/// In the order of display.
pub(crate) const ALL: [(&str, Register); 8] = [
    ("RLO", Register::Rlo),
    ("DR8", Register::Dr(Width::Byte)),
    ("DR16", Register::Dr(Width::Word)),
    ("DR32", Register::Dr(Width::DWord)),
    ("DR64", Register::Dr(Width::QWord)),
    ("DR_REAL", Register::Dr(Width::Real)),
    ("BX", Register::Bx),
    ("Equation stack", Register::Stack),
];

impl Register {
    pub(crate) fn type_name(self) -> &'static str {
        match self {
            Register::Rlo => "bit",
            Register::Dr(width) => values::type_name(width),
            Register::Bx => "DWRD",
            Register::Stack => "bits",
        }
    }

    pub(crate) fn show(self, registers: &Registers, hex: bool) -> String {
        match self {
            Register::Rlo => values::bit(registers.rlo),
            Register::Dr(Width::Real) => values::real(registers.dr_real),
            Register::Dr(width) => values::register(registers.dr as u64, width, hex),
            Register::Bx => values::register(u64::from(registers.bx), Width::DWord, hex),
            Register::Stack => {
                let pushed = stack(registers);
                if pushed.is_empty() { "empty".into() } else { format!("{} pushed", pushed.len()) }
            }
        }
    }

    /// The registers after this one was set.
    pub(crate) fn set(self, registers: &Registers, text: &str) -> Result<Registers, String> {
        let mut new = *registers;
        match self {
            Register::Rlo => new.rlo = values::parse_bit(text)?,
            Register::Dr(Width::Real) => new.dr_real = f64::from_bits(values::parse_cell(text, Width::Real)?),
            Register::Dr(width) => {
                // As STO does in the other direction: a part is replaced, the rest stays.
                let keep = (registers.dr as u64).checked_shr(width.bits()).unwrap_or(0);
                let rest = keep.checked_shl(width.bits()).unwrap_or(0);
                new.dr = (rest | values::parse_cell(text, width)?) as i64;
            }
            Register::Bx => new.bx = values::parse_cell(text, Width::DWord)? as u32,
            Register::Stack => return Err("the equation stack cannot be set; the equation would not balance".into()),
        }
        Ok(new)
    }
}

/// The pushed values, top first.
pub(crate) fn stack(registers: &Registers) -> Vec<bool> {
    let depth = usize::from(registers.depth).min(STACK_DEPTH);
    (0..depth).rev().map(|n| registers.stack >> n & 1 == 1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Registers {
        Registers { rlo: true, dr: -2, dr_real: 1.5, bx: 16, stack: 0b101, depth: 3 }
    }

    #[test]
    fn parts_of_dr_are_signed_with_hexadecimal() {
        let shown: Vec<String> = ALL.iter().map(|(n, r)| format!("{n} = {}", r.show(&sample(), false))).collect();
        assert_eq!(
            shown,
            [
                "RLO = true",
                "DR8 = -2 (0FEh)",
                "DR16 = -2 (0FFFEh)",
                "DR32 = -2 (0FFFFFFFEh)",
                "DR64 = -2 (0FFFFFFFFFFFFFFFEh)",
                "DR_REAL = 1.5",
                "BX = 16 (00000010h)",
                "Equation stack = 3 pushed",
            ]
        );
    }

    #[test]
    fn the_stack_is_listed_from_the_top() {
        let registers = Registers { stack: 0b001, depth: 2, ..sample() };
        assert_eq!(stack(&registers), [false, true]);
        assert_eq!(stack(&Registers { depth: 200, ..sample() }).len(), STACK_DEPTH);
    }

    #[test]
    fn setting_a_part_keeps_the_rest() {
        let set = |register: Register, text| register.set(&sample(), text).map(|r| r.dr);
        assert_eq!(set(Register::Dr(Width::Byte), "0"), Ok(-256));
        assert_eq!(set(Register::Dr(Width::QWord), "7"), Ok(7));
        assert_eq!(Register::Dr(Width::Real).set(&sample(), "2").map(|r| r.dr_real), Ok(2.0));
        assert!(set(Register::Stack, "0").is_err());
    }
}
