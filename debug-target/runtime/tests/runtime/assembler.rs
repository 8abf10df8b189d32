//! The 80386 instructions against arithmetic written down another way.

use proptest::prelude::*;
use technol_image::assembler::{Condition, Function, General, Operand, Part, Register};
use technol_image::op::{Op, Place, Width};
use technol_runtime::{FaultKind, Registers};

use crate::operation::{check, check_fault, registers};
use crate::support::GLOBAL as A;

const CARRY: u16 = 0x001;
const PARITY: u16 = 0x004;
const ZERO: u16 = 0x040;
const SIGN: u16 = 0x080;
const OVERFLOW: u16 = 0x800;

fn cell(indexed: bool) -> Operand {
    Operand::Cell(Place { addr: A, indexed })
}

fn register(general: General, part: Part) -> Operand {
    Operand::Register(Register { general, part })
}

/// The number as the signed one with the same bits.
fn signed(value: u32, bits: u32) -> i64 {
    let value = i64::from(value) & ((1 << bits) - 1);
    if value >> (bits - 1) == 1 { value - (1 << bits) } else { value }
}

/// Result and flags of `a + b` or `a - b`, from what the flags mean: carry says that the unsigned result does not fit,
/// overflow that the signed one does not.
fn reference(subtract: bool, bits: u32, a: u32, b: u32) -> (u32, u16) {
    let modulus = 1_i64 << bits;
    let of = |a: i64, b: i64| if subtract { a - b } else { a + b };
    let unsigned = of(i64::from(a) % modulus, i64::from(b) % modulus);
    let exact = of(signed(a, bits), signed(b, bits));
    let result = unsigned.rem_euclid(modulus) as u32;
    let mut flags = 0;
    for (flag, set) in [
        (CARRY, !(0..modulus).contains(&unsigned)),
        (PARITY, (0..8).filter(|bit| result >> bit & 1 == 1).count() % 2 == 0),
        (ZERO, result == 0),
        (SIGN, signed(result, bits) < 0),
        (OVERFLOW, !(-modulus / 2..modulus / 2).contains(&exact)),
    ] {
        flags |= if set { flag } else { 0 };
    }
    (result, flags)
}

/// Numbers near the ends of all widths, and any others.
fn a_number() -> impl Strategy<Value = u32> {
    let near =
        prop::sample::select(vec![0_u32, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x7FFF_FFFF, 0x8000_0000]);
    prop_oneof![(near, 0..4_u32).prop_map(|(near, by)| near.wrapping_add(by).wrapping_sub(2)), any::<u32>()]
}

proptest! {
    #[test]
    fn sums_differences_and_comparisons_set_the_flags_of_their_width(
        a in a_number(),
        b in a_number(),
        (width, part) in prop::sample::select(vec![
            (Width::Byte, Part::Low),
            (Width::Word, Part::Word),
            (Width::DWord, Part::Whole),
        ]),
        function in prop::sample::select(vec![Function::Add, Function::Sub, Function::Compare]),
    ) {
        let (result, flags) = reference(function != Function::Add, width.bits(), a, b);
        let len = width.bytes() as usize;
        let before = Registers { dr: i64::from(a), ..registers() };
        // Register and number.
        let op = Op::Assembler { function, width, to: register(General::C, part), from: Operand::Number(b) };
        let keep = !(u32::MAX >> (32 - width.bits()));
        let sum = if function == Function::Compare { a } else { a & keep | result };
        check(&[op], before, &[], Registers { dr: i64::from(sum), flags, ..before }, &[]);
        // Cell and register.
        let op = Op::Assembler { function, width, to: cell(false), from: register(General::C, part) };
        let before = Registers { dr: i64::from(b), ..registers() };
        let written = if function == Function::Compare { a } else { result };
        let (old, new) = (a.to_le_bytes(), written.to_le_bytes());
        let after = Registers { flags, ..before };
        check(&[op], before, &[(A, &old[..len])], after, &[(A, &new[..len])]);
    }
}

#[test]
fn rlo_is_a_bit_of_ah_and_dr_lies_in_ecx_and_edx() {
    let put = |general, part: Part, value| {
        let to = Register { general, part };
        Op::Assembler {
            function: Function::Move,
            width: to.width(),
            to: Operand::Register(to),
            from: Operand::Number(value),
        }
    };
    let start = Registers { eax: 0x1111_1111, ..registers() };
    let check = |op, after: Registers| check(&[op], start, &[], after, &[]);
    check(put(General::A, Part::High, 0xFF), Registers { rlo: true, eax: 0x1111_BF11, ..start });
    check(put(General::A, Part::High, 0xBF), Registers { eax: 0x1111_BF11, ..start });
    check(put(General::A, Part::Whole, u32::MAX), Registers { rlo: true, eax: 0xFFFF_BFFF, ..start });
    check(put(General::A, Part::Low, 0x40), Registers { eax: 0x1111_1140, ..start });
    check(put(General::C, Part::Whole, 0xFFFF_FFFF), Registers { dr: 0x0123_4567_FFFF_FFFF, ..start });
    check(put(General::C, Part::High, 0), Registers { dr: 0x0123_4567_89AB_00EF, ..start });
    check(
        put(General::D, Part::Whole, 0xFFFF_FFFF),
        Registers { dr: 0xFFFF_FFFF_89AB_CDEF_u64 as i64, ..start },
    );
    check(put(General::D, Part::Word, 0), Registers { dr: 0x0123_0000_89AB_CDEF, ..start });
    check(put(General::B, Part::Whole, 0x1_0002), Registers { bx: 0x1_0002, ..start });
}

#[test]
fn eax_set_from_outside_never_holds_a_second_rlo() {
    let before = Registers { eax: u32::MAX, ..registers() };
    let to_cx = Op::Assembler {
        function: Function::Move,
        width: Width::DWord,
        to: register(General::C, Part::Whole),
        from: register(General::A, Part::Whole),
    };
    let after = Registers { eax: 0xFFFF_BFFF, dr: 0x0123_4567_FFFF_BFFF, ..registers() };
    check(&[to_cx], before, &[], after, &[]);
}

#[test]
fn an_access_outside_memory_changes_neither_registers_nor_flags() {
    let before = Registers { bx: 0x7000_0000, eax: 5, flags: CARRY, ..registers() };
    let fault = |len| FaultKind::BadAddress { addr: i64::from(A) + 0x7000_0000, len };
    for (function, from) in [
        (Function::Move, Operand::Number(1)),
        (Function::Sub, Operand::Number(1)),
        (Function::Compare, register(General::A, Part::Word)),
        (Function::Increment, Operand::Number(1)),
        (Function::ShiftLeft, Operand::Number(1)),
    ] {
        let op = Op::Assembler { function, width: Width::Word, to: cell(true), from };
        check_fault(&[op], before, &[], 0, fault(2));
    }
    let to = register(General::C, Part::Whole);
    let op = Op::Assembler { function: Function::Add, width: Width::DWord, to, from: cell(true) };
    check_fault(&[op], before, &[], 0, fault(4));
}

#[test]
fn jumps_test_flags_and_change_nothing() {
    let cases = [
        (Condition::Overflow, Condition::NoOverflow, OVERFLOW, 0),
        (Condition::Below, Condition::AboveOrEqual, CARRY, ZERO),
        (Condition::Equal, Condition::NotEqual, ZERO, CARRY),
        (Condition::BelowOrEqual, Condition::Above, CARRY, SIGN),
        (Condition::BelowOrEqual, Condition::Above, ZERO, OVERFLOW),
        (Condition::Negative, Condition::NotNegative, SIGN, OVERFLOW),
        (Condition::ParityEven, Condition::ParityOdd, PARITY, ZERO),
        (Condition::Less, Condition::GreaterOrEqual, SIGN, SIGN | OVERFLOW),
        (Condition::LessOrEqual, Condition::Greater, SIGN, SIGN | OVERFLOW | CARRY),
        (Condition::LessOrEqual, Condition::Greater, ZERO, 0),
    ];
    for (yes, no, holding, failing) in cases {
        for (condition, flags, jumped) in
            [(yes, holding, true), (no, holding, false), (yes, failing, false), (no, failing, true)]
        {
            let before = Registers { flags, ..registers() };
            let ops = [Op::AssemblerJump { condition, target: 2 }, Op::Complement];
            check(&ops, before, &[], Registers { rlo: !jumped, ..before }, &[]);
        }
    }
}
