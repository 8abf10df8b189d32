//! What an operation is called: its mnemonic, and what its operand is.

use technol_image::assembler::Operand;
use technol_image::op::{Cond, DrTest, Op, Source};
use technol_image::program::Program;

/// The mnemonic that an operation comes from. Operations that hold the program together have none.
pub(super) fn mnemonic(program: &Program, op: &Op) -> Option<&'static str> {
    let conditional = |names: [&'static str; 3], cond: Cond| match cond {
        Cond::Always => names[0],
        Cond::IfRlo => names[1],
        Cond::IfNotRlo => names[2],
    };
    Some(match *op {
        Op::Ldr { .. } => "LDR",
        Op::Logic { op, .. } | Op::LogicPop(op) => op.mnemonic(),
        Op::Complement => "CA",
        Op::Edge { rising, .. } => if_else(rising, "EDGE_H", "EDGE_L"),
        Op::Write(_) => "WR",
        Op::Flag { cond, .. } => conditional(["FL", "FL1", "?"], cond),
        Op::MoveBit { cond, .. } => conditional(["MOVR", "MOVR1", "?"], cond),
        Op::Jump { cond, .. } => conditional(["JUM", "JL1", "JL0"], cond),
        Op::Load { .. } => "LOD",
        Op::Store { cond, .. } => conditional(["STO", "STO1", "STO0"], cond),
        Op::Move { cond, .. } => conditional(["MOVE", "MOVE1", "?"], cond),
        Op::Arith { op, .. } => op.mnemonic(),
        Op::Compare { if_rlo: true, .. } => "EQ1",
        Op::Compare { op, .. } => op.mnemonic(),
        Op::Unary { op, .. } => op.mnemonic(),
        Op::IncrementBcd => "INRBCD",
        Op::BcdToBin(_) => "BIN",
        Op::BinToBcd(_) => "BCD",
        Op::Shift { left, .. } => if_else(left, "RL", "RR"),
        Op::DrToRlo(_) => "CONDR",
        Op::RloToDr(_) => "CONRD",
        Op::IntToReal(_) => "REAL",
        Op::Raster { rate, .. } => rate.mnemonic(),
        Op::Timer { .. } => "TM",
        Op::Counter { op, .. } => op.mnemonic(),
        Op::Copy { .. } => "MV",
        Op::Clear { .. } => "CLEAR",
        Op::Call(_) => "PROC_CALL",
        Op::SeqInit(_) => "MECH_INIT",
        Op::Ex { .. } => "EX",
        Op::ExIf { wait_when, .. } => if_else(wait_when, "EX1", "EX0"),
        Op::Bex { .. } => "BEX",
        Op::Timed(n) => match program.timed[usize::from(n)].wait_when {
            None => "TIM",
            Some(wait_when) => if_else(wait_when, "TEX1", "TEX0"),
        },
        Op::Message { cond, .. } => conditional(["ESET", "ESET1", "?"], cond),
        Op::Service(n) => program.services[usize::from(n)].service.name(),
        Op::IndexFromDr => "MOV",
        Op::Assembler { function, .. } => function.mnemonic(),
        Op::AssemblerJump { .. } => "Jcc",
        Op::SelectBlock { .. } => "BLK[BX]",
        Op::Nop
        | Op::Return
        | Op::SeqBegin(_)
        | Op::SeqEnd(_)
        | Op::InitFinished(_)
        | Op::DoneFinished(_)
        | Op::ModuleEnd => return None,
    })
}

/// The name of the operation at `at`.
pub(super) fn name(program: &Program, at: usize) -> Option<String> {
    let op = &program.code[at];
    let mnemonic = mnemonic(program, op)?;
    let detail = match *op {
        Op::Ldr { neg, push, .. } => {
            format!("{}{}", if_else(neg, " negated", ""), if_else(push, " in an equation", ""))
        }
        Op::Logic { neg: true, .. } | Op::MoveBit { neg: true, .. } => " negated".to_owned(),
        Op::LogicPop(_) => " of the stack".to_owned(),
        Op::Flag { value, .. } => format!(" {}", u8::from(value)),
        Op::Load { src, width, neg } => {
            format!(" {width:?} {}{}", source(src), if_else(neg, " negated", ""))
        }
        Op::Arith { src, width, .. } | Op::Compare { src, width, .. } => {
            format!(" {width:?} {}", source(src))
        }
        Op::Store { width, .. }
        | Op::Move { width, .. }
        | Op::Unary { width, .. }
        | Op::RloToDr(width)
        | Op::IntToReal(width)
        | Op::BcdToBin(width)
        | Op::BinToBcd(width)
        | Op::Timer { width, .. }
        | Op::Counter { width, .. } => format!(" {width:?}"),
        Op::Shift { count, width, .. } => format!(" {width:?} by {}", source(count)),
        Op::DrToRlo(DrTest::NonZero(width)) => format!(" {width:?}"),
        Op::DrToRlo(DrTest::Bit(_)) => " bit".to_owned(),
        Op::Assembler { width, to, from, .. } => format!(" {width:?} {},{}", operand(to), operand(from)),
        Op::AssemblerJump { condition, .. } => format!(" {condition:?}"),
        // Instructions that take several cycles begin with one.
        Op::Bex { .. } => match program.code.get(at + 1) {
            Some(next @ Op::Service(_)) => format!(" of {}", self::mnemonic(program, next)?),
            _ => String::new(),
        },
        _ => String::new(),
    };
    Some(format!("{mnemonic}{detail}"))
}

fn source(source: Source) -> &'static str {
    match source {
        Source::Mem(place) => if_else(place.indexed, "indexed cell", "cell"),
        Source::Int(_) | Source::Real(_) => "number",
    }
}

fn operand(operand: Operand) -> &'static str {
    match operand {
        Operand::Register(register) => register.name(),
        Operand::Cell(_) => "cell",
        Operand::Number(_) => "number",
    }
}

fn if_else(condition: bool, yes: &'static str, no: &'static str) -> &'static str {
    if condition { yes } else { no }
}
