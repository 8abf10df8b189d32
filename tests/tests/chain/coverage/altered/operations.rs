//! Other operations in the place of one.

use technol_image::assembler::{Condition, Function, Operand};
use technol_image::op::{
    Arith, BitRef, Compare, Cond, Count, DrTest, Logic, Op, Place, Raster, Source, Unary, Width,
};

type Others = Vec<(String, Op)>;

const WIDTHS: [Width; 5] = [Width::Byte, Width::Word, Width::DWord, Width::QWord, Width::Real];
const INTEGERS: [Width; 4] = [Width::Byte, Width::Word, Width::DWord, Width::QWord];
const COUNTERS: [Width; 2] = [Width::Byte, Width::Word];
const DECIMAL: [Width; 2] = [Width::Word, Width::DWord];
const CONDITIONS: [Cond; 3] = [Cond::Always, Cond::IfRlo, Cond::IfNotRlo];
const LOGIC: [Logic; 3] = [Logic::And, Logic::Or, Logic::Xor];
const ARITHMETIC: [Arith; 7] =
    [Arith::Add, Arith::Sub, Arith::Mul, Arith::Div, Arith::Or, Arith::And, Arith::Xor];
const RELATIONS: [Compare; 5] = [Compare::Eq, Compare::Lt, Compare::Gt, Compare::Le, Compare::Ge];
const UNARY: [Unary; 4] = [Unary::Increment, Unary::Decrement, Unary::Negate, Unary::Absolute];
const RASTERS: [Raster; 4] = [Raster::Tenth, Raster::Second, Raster::TenSeconds, Raster::HundredSeconds];
const COUNTS: [Count; 3] = [Count::Up, Count::Down, Count::UpBcd];
const FUNCTIONS: [Function; 7] = [
    Function::Move,
    Function::Add,
    Function::Sub,
    Function::And,
    Function::Or,
    Function::Xor,
    Function::Compare,
];
const JUMPS: [Condition; 18] = [
    Condition::Overflow,
    Condition::NoOverflow,
    Condition::Below,
    Condition::AboveOrEqual,
    Condition::Equal,
    Condition::NotEqual,
    Condition::BelowOrEqual,
    Condition::Above,
    Condition::Negative,
    Condition::NotNegative,
    Condition::ParityEven,
    Condition::ParityOdd,
    Condition::Less,
    Condition::GreaterOrEqual,
    Condition::LessOrEqual,
    Condition::Greater,
    Condition::CxZero,
    Condition::EcxZero,
];

/// The operations it can be confused with, each with what they are instead.
pub(super) fn others(op: &Op) -> Others {
    bits(op)
        .or_else(|| moves(op))
        .or_else(|| calculations(op))
        .or_else(|| conversions(op))
        .unwrap_or_else(|| rest(op))
}

/// Each of `all` but `is`.
fn each<T: Copy + PartialEq + std::fmt::Debug>(all: &[T], is: T, make: impl Fn(T) -> Op) -> Others {
    all.iter().filter(|it| **it != is).map(|it| (format!("{it:?}"), make(*it))).collect()
}

fn one(what: &str, op: Op) -> Others {
    vec![(what.to_owned(), op)]
}

/// The next bit of the byte.
pub(super) fn beside(bit: BitRef) -> BitRef {
    BitRef { bit: (bit.bit + 1) % 8, ..bit }
}

/// The byte behind the first one.
pub(super) fn behind(place: Place) -> Place {
    Place { addr: place.addr + 1, ..place }
}

fn other_source(source: Source, make: impl Fn(Source) -> Op) -> Others {
    match source {
        Source::Mem(place) => {
            let mut others = one("a byte further", make(Source::Mem(behind(place))));
            if place.indexed {
                others.extend(one("not indexed", make(Source::Mem(Place { indexed: false, ..place }))));
            }
            others
        }
        Source::Int(n) => vec![
            ("one more".to_owned(), make(Source::Int(n.wrapping_add(1)))),
            ("one less".to_owned(), make(Source::Int(n.wrapping_sub(1)))),
        ],
        Source::Real(r) => one("more", make(Source::Real(r + 0.25))),
    }
}

/// Constants stay integers or reals.
fn widths_of(source: Source, width: Width, wanted: &[Width], make: impl Fn(Width) -> Op) -> Others {
    let fits = |it: &Width| match source {
        Source::Mem(_) => true,
        Source::Int(_) => *it != Width::Real,
        Source::Real(_) => *it == Width::Real,
    };
    let wanted: Vec<Width> = wanted.iter().copied().filter(fits).collect();
    each(&wanted, width, make)
}

fn bits(op: &Op) -> Option<Others> {
    Some(match *op {
        Op::Ldr { bit, neg, push } => [
            one("the other value", Op::Ldr { bit, neg: !neg, push }),
            // One more on the stack is seen by nobody.
            if push { one("no push", Op::Ldr { bit, neg, push: false }) } else { Vec::new() },
            one("the next bit", Op::Ldr { bit: beside(bit), neg, push }),
        ]
        .concat(),
        Op::Logic { op, bit, neg } => [
            each(&LOGIC, op, |op| Op::Logic { op, bit, neg }),
            one("the other value", Op::Logic { op, bit, neg: !neg }),
            one("the next bit", Op::Logic { op, bit: beside(bit), neg }),
            one("LDR", Op::Ldr { bit, neg, push: false }),
        ]
        .concat(),
        Op::LogicPop(op) => each(&LOGIC, op, Op::LogicPop),
        Op::Edge { rising, bit, state } => [
            one("the other edge", Op::Edge { rising: !rising, bit, state }),
            one("the next bit", Op::Edge { rising, bit: beside(bit), state }),
            one("LDR", Op::Ldr { bit, neg: !rising, push: false }),
        ]
        .concat(),
        Op::Write(bit) => one("the next bit", Op::Write(beside(bit))),
        Op::Flag { value, bit, cond } => [
            one("the other value", Op::Flag { value: !value, bit, cond }),
            one("the next bit", Op::Flag { value, bit: beside(bit), cond }),
            each(&CONDITIONS, cond, |cond| Op::Flag { value, bit, cond }),
        ]
        .concat(),
        Op::MoveBit { dst, src, neg, cond } => [
            one("the other value", Op::MoveBit { dst, src, neg: !neg, cond }),
            one("the other way", Op::MoveBit { dst: src, src: dst, neg, cond }),
            one("the bit beside the source", Op::MoveBit { dst, src: beside(src), neg, cond }),
            one("the bit beside the destination", Op::MoveBit { dst: beside(dst), src, neg, cond }),
            each(&CONDITIONS, cond, |cond| Op::MoveBit { dst, src, neg, cond }),
        ]
        .concat(),
        Op::Jump { target, cond } => each(&CONDITIONS, cond, |cond| Op::Jump { target, cond }),
        _ => return None,
    })
}

fn moves(op: &Op) -> Option<Others> {
    Some(match *op {
        Op::Load { src, width, neg } => [
            // A number is loaded whole, whatever its width.
            match src {
                Source::Mem(_) => each(&WIDTHS, width, |width| Op::Load { src, width, neg }),
                Source::Int(_) | Source::Real(_) => Vec::new(),
            },
            one("the other sign", Op::Load { src, width, neg: !neg }),
            other_source(src, |src| Op::Load { src, width, neg }),
        ]
        .concat(),
        Op::Store { dst, width, cond } => [
            each(&WIDTHS, width, |width| Op::Store { dst, width, cond }),
            one("a byte further", Op::Store { dst: behind(dst), width, cond }),
            each(&CONDITIONS, cond, |cond| Op::Store { dst, width, cond }),
        ]
        .concat(),
        Op::Move { dst, src, width, cond } => [
            each(&INTEGERS, same_bytes(width), |width| Op::Move { dst, src, width, cond }),
            one("the other way", Op::Move { dst: src, src: dst, width, cond }),
            one("a byte further", Op::Move { dst: behind(dst), src, width, cond }),
            each(&CONDITIONS, cond, |cond| Op::Move { dst, src, width, cond }),
        ]
        .concat(),
        Op::Copy { src, dst, len } => [
            one("the other way", Op::Copy { src: dst, dst: src, len }),
            one("a byte more", Op::Copy { src, dst, len: len + 1 }),
            one("a byte less", Op::Copy { src, dst, len: len - 1 }),
        ]
        .concat(),
        Op::Clear { addr, len } => [
            one("a byte more", Op::Clear { addr, len: len + 1 }),
            one("a byte less", Op::Clear { addr, len: len - 1 }),
            one("without the first byte", Op::Clear { addr: addr + 1, len: len - 1 }),
        ]
        .concat(),
        _ => return None,
    })
}

/// Moving a real moves its eight bytes.
fn same_bytes(width: Width) -> Width {
    if width == Width::Real { Width::QWord } else { width }
}

fn calculations(op: &Op) -> Option<Others> {
    Some(match *op {
        Op::Arith { op, src, width } => {
            let takes = |op: Arith, width: Width| match op {
                Arith::Add | Arith::Sub => true,
                Arith::Mul | Arith::Div => width != Width::QWord,
                Arith::Or | Arith::And | Arith::Xor => width != Width::Real,
            };
            let functions: Vec<Arith> = ARITHMETIC.into_iter().filter(|op| takes(*op, width)).collect();
            let widths: Vec<Width> = WIDTHS.into_iter().filter(|width| takes(op, *width)).collect();
            [
                each(&functions, op, |op| Op::Arith { op, src, width }),
                widths_of(src, width, &widths, |width| Op::Arith { op, src, width }),
                other_source(src, |src| Op::Arith { op, src, width }),
            ]
            .concat()
        }
        Op::Compare { op, src, width, if_rlo } => [
            each(&RELATIONS, op, |op| Op::Compare { op, src, width, if_rlo }),
            widths_of(src, width, &WIDTHS, |width| Op::Compare { op, src, width, if_rlo }),
            other_source(src, |src| Op::Compare { op, src, width, if_rlo }),
            one("the part of RLO", Op::Compare { op, src, width, if_rlo: !if_rlo }),
        ]
        .concat(),
        Op::Unary { op, width } => [
            each(&UNARY, op, |op| Op::Unary { op, width }),
            each(&WIDTHS, width, |width| Op::Unary { op, width }),
        ]
        .concat(),
        Op::Shift { left, count, width } => [
            one("the other way", Op::Shift { left: !left, count, width }),
            each(&INTEGERS, width, |width| Op::Shift { left, count, width }),
            other_source(count, |count| Op::Shift { left, count, width }),
        ]
        .concat(),
        _ => return None,
    })
}

fn conversions(op: &Op) -> Option<Others> {
    Some(match *op {
        Op::IncrementBcd => one("INR", Op::Unary { op: Unary::Increment, width: Width::Word }),
        Op::BcdToBin(width) => {
            [each(&DECIMAL, width, Op::BcdToBin), one("BCD", Op::BinToBcd(width))].concat()
        }
        Op::BinToBcd(width) => {
            [each(&DECIMAL, width, Op::BinToBcd), one("BIN", Op::BcdToBin(width))].concat()
        }
        Op::DrToRlo(DrTest::NonZero(width)) => {
            let other = |width| Op::DrToRlo(DrTest::NonZero(width));
            [each(&INTEGERS, width, other), one("bit 0", Op::DrToRlo(DrTest::Bit(0)))].concat()
        }
        Op::DrToRlo(DrTest::Bit(bit)) => [
            one("the next bit", Op::DrToRlo(DrTest::Bit((bit + 1) % 32))),
            one("the bit before", Op::DrToRlo(DrTest::Bit((bit + 31) % 32))),
            one("any bit", Op::DrToRlo(DrTest::NonZero(Width::DWord))),
        ]
        .concat(),
        Op::RloToDr(width) => each(&INTEGERS, width, Op::RloToDr),
        Op::IntToReal(width) => each(&INTEGERS, width, Op::IntToReal),
        Op::Raster { rate, end } => each(&RASTERS, rate, |rate| Op::Raster { rate, end }),
        Op::Timer { count, width } => [
            each(&COUNTERS, width, |width| Op::Timer { count, width }),
            one("a byte further", Op::Timer { count: behind(count), width }),
        ]
        .concat(),
        Op::Counter { op, count, width, state } => [
            each(&COUNTS, op, |op| Op::Counter { op, count, width, state }),
            each(&COUNTERS, width, |width| Op::Counter { op, count, width, state }),
            one("a byte further", Op::Counter { op, count: behind(count), width, state }),
        ]
        .concat(),
        _ => return None,
    })
}

fn rest(op: &Op) -> Others {
    match *op {
        Op::Ex { point, line } => {
            let ex = |wait_when| Op::ExIf { wait_when, point, line };
            [one("EX0", ex(false)), one("EX1", ex(true)), one("BEX", Op::Bex { point, line }), other_line(op)]
                .concat()
        }
        Op::ExIf { wait_when, point, line } => [
            one("the other value", Op::ExIf { wait_when: !wait_when, point, line }),
            one("EX", Op::Ex { point, line }),
            one("BEX", Op::Bex { point, line }),
            other_line(op),
        ]
        .concat(),
        // Whose line it is cannot be seen: what waits behind it tells its own.
        Op::Bex { point, line } => one("EX", Op::Ex { point, line }),
        Op::Assembler { function, width, to, from } => {
            assembler(function, to, from, |function, to, from| Op::Assembler { function, width, to, from })
        }
        Op::AssemblerJump { condition, target } => {
            // The next one is the opposite for each second.
            let at = JUMPS.iter().position(|it| *it == condition).unwrap_or_default();
            let next = [1, 2, 3, 4, JUMPS.len() - 1].map(|n| JUMPS[(at + n) % JUMPS.len()]);
            each(&next, condition, |condition| Op::AssemblerJump { condition, target })
        }
        Op::Message { index, cond } => each(&CONDITIONS, cond, |cond| Op::Message { index, cond }),
        Op::SelectBlock { offset, len } => one("a byte further", Op::SelectBlock { offset: offset + 1, len }),
        _ => Vec::new(),
    }
}

/// The line that `mech_LINE` tells.
fn other_line(op: &Op) -> Others {
    let other = match *op {
        Op::Ex { point, line } => Op::Ex { point, line: line + 1 },
        Op::ExIf { wait_when, point, line } => Op::ExIf { wait_when, point, line: line + 1 },
        _ => return Vec::new(),
    };
    one("the next line", other)
}

fn assembler(
    function: Function,
    to: Operand,
    from: Operand,
    make: impl Fn(Function, Operand, Operand) -> Op,
) -> Others {
    let mut others = match function {
        Function::ShiftLeft => one("SHR", make(Function::ShiftRight, to, from)),
        Function::ShiftRight => one("SHL", make(Function::ShiftLeft, to, from)),
        Function::Increment => {
            [one("DEC", make(Function::Decrement, to, from)), one("ADD", make(Function::Add, to, from))]
                .concat()
        }
        Function::Decrement => {
            [one("INC", make(Function::Increment, to, from)), one("SUB", make(Function::Sub, to, from))]
                .concat()
        }
        _ => each(&FUNCTIONS, function, |function| make(function, to, from)),
    };
    match from {
        Operand::Number(n) if !matches!(function, Function::Increment | Function::Decrement) => {
            others.extend(one("one more", make(function, to, Operand::Number(n.wrapping_add(1)))));
        }
        Operand::Cell(place) => {
            others.extend(one("a byte further", make(function, to, Operand::Cell(behind(place)))));
        }
        _ => {}
    }
    others
}
