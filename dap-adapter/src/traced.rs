//! Which data register tells what a traced line did.

use technol_image::Op;
use technol_image::op::{Arith, Pc, Width};
use technol_image::program::Program;
use technol_wire::message::TracedRegister;

/// Statements that are looked at before a line which does not work with a data register itself.
const LOOK_BACK: usize = 64;

/// The register to show behind the line that begins there: the one it works with. A line without one (a bit, a jump)
/// follows the line before it, so that a number that needs 64 bits is not cut in the middle of a calculation.
pub(crate) fn register_behind(program: &Program, pc: Pc) -> TracedRegister {
    let behind = program.statements.partition_point(|first| *first <= pc);
    let lines = program.statements[..behind].iter().rev().take(LOOK_BACK);
    for (distance, first) in lines.enumerate() {
        let ops = program.code.iter().enumerate().skip(*first as usize);
        let own = |at: &usize| program.statements.binary_search(&(*at as Pc)).is_err();
        let ops = ops.take_while(|(at, _)| *at == *first as usize || own(at)).map(|(_, op)| op);
        // What is before the beginning of a section is executed somewhere else.
        if distance > 0 && ops.clone().any(|op| matches!(op, Op::Return | Op::ModuleEnd)) {
            break;
        }
        match ops.clone().filter_map(register).max() {
            // Behind a line with reals DR64 has their integers.
            Some(TracedRegister::Real) if distance > 0 => return TracedRegister::Dr64,
            Some(register) => return register,
            None => {}
        }
        if ops.clone().any(|op| matches!(op, Op::SeqBegin(_))) {
            break;
        }
    }
    TracedRegister::Dr32
}

/// The register that an operation works with; `None`: with bits, or with memory only.
fn register(op: &Op) -> Option<TracedRegister> {
    match op {
        // The product of two double words has 64 bits.
        Op::Arith { op: Arith::Mul, width: Width::DWord, .. } => Some(TracedRegister::Dr64),
        Op::IntToReal(_) => Some(TracedRegister::Real),
        Op::Load { width, .. }
        | Op::Store { width, .. }
        | Op::Arith { width, .. }
        | Op::Compare { width, .. }
        | Op::Unary { width, .. }
        | Op::BcdToBin(width)
        | Op::BinToBcd(width)
        | Op::Shift { width, .. }
        | Op::RloToDr(width) => Some(of_width(*width)),
        Op::IncrementBcd | Op::DrToRlo(_) | Op::IndexFromDr | Op::Assembler { .. } => {
            Some(TracedRegister::Dr32)
        }
        _ => None,
    }
}

fn of_width(width: Width) -> TracedRegister {
    match width {
        Width::Byte | Width::Word | Width::DWord => TracedRegister::Dr32,
        Width::QWord => TracedRegister::Dr64,
        Width::Real => TracedRegister::Real,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use TracedRegister::{Dr32, Dr64, Real};
    use technol_image::op::{BitRef, Cond, Place, Source};

    /// Each line with its operations.
    fn program(lines: &[&[Op]]) -> Program {
        let mut program = Program::without_code("traced".into(), Vec::new());
        for line in lines {
            program.statements.push(program.code.len() as Pc);
            program.code.extend_from_slice(line);
        }
        program
    }

    fn registers(lines: &[&[Op]]) -> Vec<TracedRegister> {
        let program = program(lines);
        program.statements.iter().map(|pc| register_behind(&program, *pc)).collect()
    }

    const CELL: Place = Place { addr: 0, indexed: false };
    const BIT: Op = Op::Write(BitRef { addr: 0, bit: 0, indexed: false });

    fn load(width: Width) -> Op {
        Op::Load { src: Source::Mem(CELL), width, neg: false }
    }

    fn multiply(width: Width) -> Op {
        Op::Arith { op: Arith::Mul, src: Source::Mem(CELL), width }
    }

    #[test]
    fn a_line_shows_the_register_it_works_with() {
        for (op, register) in [
            (load(Width::Byte), Dr32),
            (load(Width::DWord), Dr32),
            (load(Width::QWord), Dr64),
            (load(Width::Real), Real),
            (multiply(Width::Word), Dr32),
            (multiply(Width::DWord), Dr64),
            (multiply(Width::Real), Real),
            (Op::IntToReal(Width::Word), Real),
            (Op::Store { dst: CELL, width: Width::QWord, cond: Cond::IfRlo }, Dr64),
            (Op::Shift { left: true, count: Source::Int(3), width: Width::QWord }, Dr64),
            (BIT, Dr32),
        ] {
            assert_eq!(registers(&[&[op]]), [register], "{op:?}");
        }
    }

    #[test]
    fn a_line_without_a_number_follows_the_one_before_it() {
        let lines: &[&[Op]] = &[
            &[BIT],
            &[load(Width::QWord)],
            &[BIT, BIT],
            &[load(Width::Word)],
            &[BIT],
            &[load(Width::Real)],
            &[BIT],
        ];
        assert_eq!(registers(lines), [Dr32, Dr64, Dr64, Dr32, Dr32, Real, Dr64]);
    }

    #[test]
    fn a_section_does_not_follow_the_one_before_it() {
        for end in [Op::ModuleEnd, Op::Return] {
            assert_eq!(registers(&[&[load(Width::QWord), end], &[BIT]]), [Dr64, Dr32]);
            assert_eq!(registers(&[&[load(Width::QWord)], &[end], &[BIT]]), [Dr64, Dr64, Dr32]);
        }
        assert_eq!(registers(&[&[load(Width::QWord)], &[Op::SeqBegin(0)], &[BIT]]), [Dr64, Dr32, Dr32]);
        assert_eq!(registers(&[]), []);
    }
}
