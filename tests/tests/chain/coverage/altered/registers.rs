//! Registers that an operation changes and should not, or the other way round. What an instruction writes, the
//! catalogue says.

use technol_analysis::catalogue::{self, entry::Effect};
use technol_image::op::{Arith, BitRef, Cond, Op, Place, Source, Width};
use technol_image::program::Program;

use super::{Change, Changes, names};

/// Bytes behind the memory of the program that the inserted operations work with.
pub(super) const SPARE: u32 = 32;

/// The name under which its registers are altered: all widths and operands of an instruction together, but a real
/// form writes another register.
pub(super) fn name(program: &Program, op: &Op) -> Option<String> {
    match op {
        // These never go on behind themselves.
        Op::Ex { .. } | Op::Jump { cond: Cond::Always, .. } => None,
        // Not in the catalogue, or only a part of its line.
        Op::Assembler { .. } | Op::AssemblerJump { .. } | Op::IndexFromDr | Op::SelectBlock { .. } => None,
        _ => {
            let mnemonic = names::mnemonic(program, op)?;
            Some(if is_real(op) { format!("{mnemonic} of reals") } else { mnemonic.to_owned() })
        }
    }
}

fn is_real(op: &Op) -> bool {
    match op {
        Op::Load { width, .. }
        | Op::Arith { width, .. }
        | Op::Compare { width, .. }
        | Op::Unary { width, .. }
        | Op::Store { width, .. }
        | Op::Move { width, .. } => *width == Width::Real,
        _ => false,
    }
}

pub(super) fn others(program: &Program, op: &Op) -> Changes {
    let Some(entry) = names::mnemonic(program, op).and_then(catalogue::entry) else { return Vec::new() };
    let writes = |effects: &[Effect]| entry.writes.iter().any(|it| effects.contains(it));
    let spare = program.memory_len();
    let mut changes = Vec::new();
    let mut around = |what: &str, before: &[Op], behind: &[Op]| {
        changes.push((what.to_owned(), Change::Around(before.to_vec(), behind.to_vec())));
    };
    let bit = |addr: u32| BitRef { addr, bit: 0, indexed: false };
    let cell = |addr: u32| Place { addr, indexed: false };
    let load_bit = |addr: u32, neg: bool| Op::Ldr { bit: bit(addr), neg, push: false };
    let (zero, rlo, dr, real) = (spare, spare + 1, spare + 8, spare + 16);
    if writes(&[Effect::Rlo]) {
        around("RLO stays", &[Op::Write(bit(rlo))], &[load_bit(rlo, false)]);
        around("RLO 0", &[], &[load_bit(zero, false)]);
        around("RLO 1", &[], &[load_bit(zero, true)]);
    } else {
        around("RLO turned", &[], &[Op::Complement]);
    }
    let store = |addr: u32, width: Width| Op::Store { dst: cell(addr), width, cond: Cond::Always };
    let load = |addr: u32, width: Width| Op::Load { src: Source::Mem(cell(addr)), width, neg: false };
    let turn = |n: i64| Op::Arith { op: Arith::Xor, src: Source::Int(n), width: Width::QWord };
    // TEX loads DR where it jumps, and not where it goes on.
    if writes(&[Effect::Dr, Effect::Dr64]) && !matches!(op, Op::Timed(_)) {
        let zero = Op::Load { src: Source::Int(0), width: Width::QWord, neg: false };
        around("DR stays", &[store(dr, Width::QWord)], &[load(dr, Width::QWord)]);
        around("DR 0", &[], &[zero]);
        around("DR turned above 16 bits", &[], &[turn(1 << 20)]);
    } else {
        around("DR turned", &[], &[turn(1)]);
    }
    if writes(&[Effect::DrReal]) && (is_real(op) || matches!(op, Op::IntToReal(_) | Op::Call(_))) {
        let back = [store(dr, Width::QWord), load(real, Width::Real), load(dr, Width::QWord)];
        around("DR_REAL stays", &[store(real, Width::Real)], &back);
    } else {
        let more = Op::Arith { op: Arith::Add, src: Source::Real(1.0), width: Width::Real };
        around("DR_REAL more", &[], &[store(dr, Width::QWord), more, load(dr, Width::QWord)]);
    }
    changes
}
