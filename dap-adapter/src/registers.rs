//! The registers as the user sees and sets them.

use technol_analysis::expression::{self, RegisterChange, RegisterValues};
use technol_image::op::{STACK_DEPTH, Width};
use technol_wire::message::{MachineRegisters, Registers};

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

/// A register of the 80386 that is none of the PLC: EBX is BX, ECX and EDX are the halves of DR.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MachineRegister {
    Eax,
    Flags,
}

pub(crate) const MACHINE: [(&str, MachineRegister); 2] =
    [("EAX", MachineRegister::Eax), ("Flags", MachineRegister::Flags)];

/// The flags that instructions set and conditional jumps ask, at their places in EFLAGS.
const FLAGS: [(u16, &str); 5] = [(1, "CF"), (4, "PF"), (0x40, "ZF"), (0x80, "SF"), (0x800, "OF")];

impl MachineRegister {
    pub(crate) fn type_name(self) -> &'static str {
        match self {
            MachineRegister::Eax => "DWRD",
            MachineRegister::Flags => "bits",
        }
    }

    pub(crate) fn show(self, registers: MachineRegisters, hex: bool) -> String {
        match self {
            MachineRegister::Eax => values::register(u64::from(registers.eax), Width::DWord, hex),
            MachineRegister::Flags => {
                let set = FLAGS.iter().filter(|(mask, _)| registers.flags & mask != 0);
                let names: Vec<&str> = set.map(|(_, name)| *name).collect();
                if names.is_empty() { "none".into() } else { names.join(" ") }
            }
        }
    }
}

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

    /// The register as expressions know it; the stack is none.
    pub(crate) fn target(self) -> Option<expression::Register> {
        Some(match self {
            Register::Rlo => expression::Register::Rlo,
            Register::Dr(Width::Real) => expression::Register::DrReal,
            Register::Dr(width) => expression::Register::DrPart(width),
            Register::Bx => expression::Register::Bx,
            Register::Stack => return None,
        })
    }
}

impl From<expression::Register> for Register {
    fn from(register: expression::Register) -> Self {
        match register {
            expression::Register::Rlo => Register::Rlo,
            expression::Register::Dr => Register::Dr(Width::QWord),
            expression::Register::DrPart(width) => Register::Dr(width),
            expression::Register::DrReal => Register::Dr(Width::Real),
            expression::Register::Bx => Register::Bx,
        }
    }
}

/// The registers after a change; the equation stack stays.
pub(crate) fn changed(registers: &Registers, change: RegisterChange) -> Registers {
    let Registers { rlo, dr, dr_real, bx, .. } = *registers;
    let RegisterValues { rlo, dr, dr_real, bx } = change.apply(RegisterValues { rlo, dr, dr_real, bx });
    Registers { rlo, dr, dr_real, bx, ..*registers }
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
        let shown: Vec<String> =
            ALL.iter().map(|(n, r)| format!("{n} = {}", r.show(&sample(), false))).collect();
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
    fn flags_are_told_by_name_and_eax_as_a_number() {
        let shown = |flags, register: MachineRegister| {
            register.show(MachineRegisters { eax: 0x1_4000, flags }, false)
        };
        assert_eq!(shown(0, MachineRegister::Eax), "81920 (00014000h)");
        assert_eq!(shown(0, MachineRegister::Flags), "none");
        assert_eq!(shown(0x8C5, MachineRegister::Flags), "CF PF ZF SF OF");
        assert_eq!(shown(0x40, MachineRegister::Flags), "ZF");
    }

    #[test]
    fn the_stack_is_listed_from_the_top() {
        let registers = Registers { stack: 0b001, depth: 2, ..sample() };
        assert_eq!(stack(&registers), [false, true]);
        assert_eq!(stack(&Registers { depth: 200, ..sample() }).len(), STACK_DEPTH);
    }

    #[test]
    fn setting_a_part_keeps_the_rest() {
        assert_eq!(
            changed(&sample(), RegisterChange::Dr(Width::Byte, 0)),
            Registers { dr: -256, ..sample() }
        );
        assert_eq!(changed(&sample(), RegisterChange::DrReal(2.0)), Registers { dr_real: 2.0, ..sample() });
    }
}
