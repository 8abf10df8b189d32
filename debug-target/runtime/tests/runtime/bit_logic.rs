//! LDR, LA, LO, LX, CA, EDGE, WR, FL, MOVR and jumps (manual 3.5 to 3.7).

use technol_image::op::{BitRef, Cond, Logic, Op};
use technol_runtime::FaultKind;

use crate::operation::{check, check_fault, registers, with_rlo};
use crate::support::{Builder, GLOBAL as A, HIDDEN, bit, ldr, set};

const BIT: BitRef = bit(A, 3);
const SET: &[u8] = &[0b0000_1000];
const CLEAR: &[u8] = &[0b1111_0111];

fn content(value: bool) -> &'static [u8] {
    if value { SET } else { CLEAR }
}

#[test]
fn ldr_loads_the_bit_or_its_negation() {
    for (value, neg, rlo) in
        [(false, false, false), (true, false, true), (false, true, true), (true, true, false)]
    {
        for before in [false, true] {
            let ldr = Op::Ldr { bit: BIT, neg, push: false };
            check(&[ldr], with_rlo(before), &[(A, content(value))], with_rlo(rlo), &[]);
        }
    }
}

#[test]
fn every_bit_number_has_its_own_weight() {
    for number in 0..8 {
        let memory: &[u8] = &[1 << number];
        check(&[ldr(bit(A, number))], with_rlo(false), &[(A, memory)], with_rlo(true), &[]);
        let other = bit(A, (number + 1) % 8);
        check(&[ldr(other)], with_rlo(true), &[(A, memory)], with_rlo(false), &[]);
        check(&[Op::Write(bit(A, number))], with_rlo(true), &[], with_rlo(true), &[(A, memory)]);
    }
}

#[test]
fn logic_follows_its_truth_table() {
    let tables = [
        (Logic::And, [false, false, false, true]),
        (Logic::Or, [false, true, true, true]),
        (Logic::Xor, [false, true, true, false]),
    ];
    for (op, table) in tables {
        for (n, result) in table.into_iter().enumerate() {
            let (rlo, value) = (n & 2 != 0, n & 1 != 0);
            for neg in [false, true] {
                let logic = Op::Logic { op, bit: BIT, neg };
                check(&[logic], with_rlo(rlo), &[(A, content(value ^ neg))], with_rlo(result), &[]);
            }
        }
    }
}

#[test]
fn pushed_value_is_combined_and_removed() {
    let tables = [
        (Logic::And, [false, false, false, true]),
        (Logic::Or, [false, true, true, true]),
        (Logic::Xor, [false, true, true, false]),
    ];
    for (op, table) in tables {
        for (n, result) in table.into_iter().enumerate() {
            let (rlo, value) = (n & 2 != 0, n & 1 != 0);
            let ops = [Op::Ldr { bit: BIT, neg: false, push: true }, Op::LogicPop(op)];
            check(&ops, with_rlo(rlo), &[(A, content(value))], with_rlo(result), &[]);
        }
    }
}

#[test]
fn stack_holds_eight_values_last_in_first_out() {
    let push = |neg| Op::Ldr { bit: BIT, neg, push: true };
    // RLO = 1 goes in first, then seven zeros; the bit itself is 0.
    let ops: Vec<Op> = [push(false); 8].into();
    let mut after = with_rlo(false);
    (after.stack, after.depth) = (0b1000_0000, 8);
    check(&ops, with_rlo(true), &[], after, &[]);

    let mut ops = ops;
    ops.push(push(false));
    check_fault(&ops, with_rlo(true), &[], 8, FaultKind::EquationOverflow);

    ops.pop();
    ops.extend([Op::LogicPop(Logic::Or); 8]);
    check(&ops, with_rlo(true), &[], with_rlo(true), &[]);
    ops.truncate(15);
    let mut one_left = with_rlo(false);
    (one_left.stack, one_left.depth) = (1, 1);
    check(&ops, with_rlo(true), &[], one_left, &[]);
}

#[test]
fn empty_stack_faults() {
    check_fault(&[Op::LogicPop(Logic::And)], registers(), &[], 0, FaultKind::EquationUnderflow);
}

#[test]
fn complement_inverts_rlo() {
    check(&[Op::Complement], with_rlo(false), &[], with_rlo(true), &[]);
    check(&[Op::Complement], with_rlo(true), &[], with_rlo(false), &[]);
    check(&[Op::Complement, Op::Complement], with_rlo(true), &[], with_rlo(true), &[]);
}

#[test]
fn write_changes_only_its_bit() {
    check(&[Op::Write(BIT)], with_rlo(true), &[(A, &[0x81])], with_rlo(true), &[(A, &[0x89])]);
    check(&[Op::Write(BIT)], with_rlo(false), &[(A, &[0xFF])], with_rlo(false), &[(A, &[0xF7])]);
}

#[test]
fn fused_equation_equals_its_parts() {
    // ((a and not b) or c) xor d, negated, written twice: all sixteen inputs.
    let ops = [
        ldr(bit(A, 0)),
        Op::Logic { op: Logic::And, bit: bit(A, 1), neg: true },
        Op::Logic { op: Logic::Or, bit: bit(A, 2), neg: false },
        Op::Logic { op: Logic::Xor, bit: bit(A, 3), neg: false },
        Op::Complement,
        Op::Write(bit(A + 1, 0)),
        Op::Write(bit(A + 1, 7)),
    ];
    for inputs in 0..16_u8 {
        let [a, b, c, d] = [0, 1, 2, 3].map(|n| inputs >> n & 1 != 0);
        let result = !(((a && !b) || c) ^ d);
        let written: &[u8] = if result { &[0x81] } else { &[0x00] };
        check(&ops, with_rlo(true), &[(A, &[inputs])], with_rlo(result), &[(A + 1, written)]);
    }
}

#[test]
fn flag_writes_a_constant_when_its_condition_holds() {
    for (cond, rlo, acts) in [
        (Cond::Always, false, true),
        (Cond::Always, true, true),
        (Cond::IfRlo, false, false),
        (Cond::IfRlo, true, true),
        (Cond::IfNotRlo, false, true),
        (Cond::IfNotRlo, true, false),
    ] {
        let writes: &[(u32, &[u8])] = if acts { &[(A, SET)] } else { &[] };
        let flag = |value| Op::Flag { value, bit: BIT, cond };
        check(&[flag(true)], with_rlo(rlo), &[(A, &[0])], with_rlo(rlo), writes);
        let writes: &[(u32, &[u8])] = if acts { &[(A, CLEAR)] } else { &[] };
        check(&[flag(false)], with_rlo(rlo), &[(A, &[0xFF])], with_rlo(rlo), writes);
    }
}

#[test]
fn move_bit_copies_between_bytes() {
    let movr = |neg, cond| Op::MoveBit { dst: bit(A + 1, 6), src: BIT, neg, cond };
    let always = Cond::Always;
    check(&[movr(false, always)], registers(), &[(A, SET)], registers(), &[(A + 1, &[0x40])]);
    check(&[movr(true, always)], registers(), &[(A, CLEAR)], registers(), &[(A + 1, &[0x40])]);
    check(&[movr(false, Cond::IfRlo)], with_rlo(false), &[(A, SET)], with_rlo(false), &[]);
    check(&[movr(false, Cond::IfRlo)], with_rlo(true), &[(A, SET)], with_rlo(true), &[(A + 1, &[0x40])]);
    check(&[movr(false, Cond::IfNotRlo)], with_rlo(true), &[(A, SET)], with_rlo(true), &[]);
}

#[test]
fn jump_follows_its_condition() {
    for (cond, rlo, taken) in [
        (Cond::Always, false, true),
        (Cond::IfRlo, true, true),
        (Cond::IfRlo, false, false),
        (Cond::IfNotRlo, true, false),
        (Cond::IfNotRlo, false, true),
    ] {
        let ops = [Op::Jump { target: 2, cond }, set(BIT, true), Op::Nop];
        let writes: &[(u32, &[u8])] = if taken { &[] } else { &[(A, SET)] };
        check(&ops, with_rlo(rlo), &[(A, &[0])], with_rlo(rlo), writes);
    }
}

#[test]
fn indexed_bits_move_with_bx_in_both_directions() {
    let here = BitRef { indexed: true, ..bit(A + 4, 3) };
    for (bx, addr) in [(0, A + 4), (3, A + 7), (-4_i32 as u32, A)] {
        let mut before = with_rlo(false);
        before.bx = bx;
        let after = |rlo| technol_runtime::Registers { rlo, ..before };
        check(&[ldr(here)], before, &[(addr, SET)], after(true), &[]);
        check(&[set(here, true)], before, &[], before, &[(addr, SET)]);
    }
    let mut before = with_rlo(true);
    before.bx = -(A as i32) as u32;
    let outside = BitRef { indexed: true, ..bit(A - 1, 0) };
    let fault = FaultKind::BadAddress { addr: -1, len: 1 };
    for op in [ldr(outside), Op::Write(outside), set(outside, true)] {
        check_fault(&[op], before, &[], 0, fault);
    }
}

#[test]
fn edge_fires_once_per_change_and_never_first() {
    // Ruling 21, for a bit that is 1 at the start and then follows this pattern.
    let pattern = [true, true, false, false, true, false, true];
    for (rising, expected) in [
        (true, [false, false, false, false, true, false, true]),
        (false, [false, false, true, false, false, true, false]),
    ] {
        let mut bench = Builder::new()
            .main(|b| {
                b.op(Op::Edge { rising, bit: BIT, state: HIDDEN });
                b.op(Op::Write(bit(A + 1, 0)));
            })
            .load()
            .started();
        for (n, (value, fires)) in pattern.into_iter().zip(expected).enumerate() {
            bench.set(BIT, value);
            bench.cycles(1);
            assert_eq!(bench.bit(bit(A + 1, 0)), fires, "rising {rising}, pass {n}");
            assert_eq!(bench.byte(HIDDEN), 2 | u8::from(value));
        }
    }
}

#[test]
fn edge_keeps_the_other_registers() {
    let edge = Op::Edge { rising: true, bit: BIT, state: HIDDEN };
    check(&[edge], with_rlo(true), &[(A, SET)], with_rlo(false), &[(HIDDEN, &[3])]);
    check(&[edge], with_rlo(false), &[(A, SET), (HIDDEN, &[2])], with_rlo(true), &[(HIDDEN, &[3])]);
}
