//! Properties over generated programs: how a program is watched never changes what it does, and no program,
//! however damaged, makes the runtime panic.

use proptest::collection::vec;
use proptest::prelude::*;

use technol_image::container::{decode_program, encode_program};
use technol_image::op::{
    Arith, BitRef, Compare, Cond, Count, DrTest, Logic, Op, Pc, Place, Raster, Source, Unary, Width,
};
use technol_image::program::{Message, ModuleKind};
use technol_image::{Program, system};
use technol_runtime::{Block, Command, Limits, Resume, Runtime, TickOutcome};

use crate::support::{Bench, Builder, GLOBAL as A, HIDDEN};

/// A part of a generated module.
#[derive(Clone, Debug)]
enum Piece {
    Op(Op),
    /// Jumps over its content.
    Skip(Cond, Vec<Piece>),
    Raster(Vec<Piece>),
    Call(u16),
    Message(bool),
}

/// A part of a generated mechanism.
#[derive(Clone, Debug)]
enum State {
    Plain(Piece),
    Ex,
    ExIf(bool),
    Bex,
    Tex(bool, i64),
    Tim(i64),
    Init,
}

#[derive(Clone, Debug)]
struct Sketch {
    main: Vec<Piece>,
    mechanism: Vec<State>,
    block: Vec<State>,
    rest: Vec<Piece>,
    fast: Vec<Piece>,
    procedures: [Vec<Op>; 2],
}

fn a_bit() -> impl Strategy<Value = BitRef> {
    (0..4_u32, 0..8_u8, prop::bool::weighted(0.1)).prop_map(|(n, bit, indexed)| BitRef {
        addr: A + n,
        bit,
        indexed,
    })
}

fn a_place() -> impl Strategy<Value = Place> {
    (0..24_u32, prop::bool::weighted(0.1)).prop_map(|(n, indexed)| Place { addr: A + n, indexed })
}

fn a_cond() -> impl Strategy<Value = Cond> {
    prop::sample::select(vec![Cond::Always, Cond::IfRlo, Cond::IfNotRlo])
}

fn a_width() -> impl Strategy<Value = Width> {
    prop::sample::select(vec![Width::Byte, Width::Word, Width::DWord, Width::QWord, Width::Real])
}

fn an_integer_width() -> impl Strategy<Value = Width> {
    prop::sample::select(vec![Width::Byte, Width::Word, Width::DWord])
}

fn a_source(width: Width) -> impl Strategy<Value = Source> {
    let constant = if width == Width::Real {
        any::<f64>().prop_map(Source::Real).boxed()
    } else {
        prop_oneof![-3..300_i64, any::<i64>()]
            .prop_map(move |value| Source::Int(value << (64 - width.bits()) >> (64 - width.bits())))
            .boxed()
    };
    prop_oneof![a_place().prop_map(Source::Mem), constant]
}

fn with_source(width: impl Strategy<Value = Width>) -> impl Strategy<Value = (Source, Width)> {
    width.prop_flat_map(|width| (a_source(width), Just(width)))
}

fn bit_op() -> impl Strategy<Value = Op> {
    let logic = prop::sample::select(vec![Logic::And, Logic::Or, Logic::Xor]);
    prop_oneof![
        3 => (a_bit(), any::<bool>()).prop_map(|(bit, neg)| Op::Ldr { bit, neg, push: false }),
        6 => (logic, a_bit(), any::<bool>()).prop_map(|(op, bit, neg)| Op::Logic { op, bit, neg }),
        1 => Just(Op::Complement),
        3 => a_bit().prop_map(Op::Write),
        1 => (a_bit(), any::<bool>(), a_cond()).prop_map(|(bit, value, cond)| Op::Flag { value, bit, cond }),
        1 => (a_bit(), a_bit(), any::<bool>(), a_cond())
            .prop_map(|(dst, src, neg, cond)| Op::MoveBit { dst, src, neg, cond }),
        1 => (any::<bool>(), a_bit(), 0..4_u32)
            .prop_map(|(rising, bit, n)| Op::Edge { rising, bit, state: HIDDEN + n }),
    ]
}

fn data_op() -> impl Strategy<Value = Op> {
    use prop::sample::select;
    let narrow = || select(vec![Width::Byte, Width::Word]);
    let functions = vec![Arith::Add, Arith::Sub, Arith::Mul, Arith::Div, Arith::Or, Arith::And, Arith::Xor];
    let real = select(vec![Arith::Add, Arith::Sub, Arith::Mul]);
    let relations = vec![Compare::Eq, Compare::Lt, Compare::Gt, Compare::Le, Compare::Ge];
    let unary = vec![Unary::Increment, Unary::Decrement, Unary::Negate, Unary::Absolute];
    prop_oneof![
        (with_source(a_width()), any::<bool>()).prop_map(|((src, width), neg)| Op::Load { src, width, neg }),
        (a_place(), a_width(), a_cond()).prop_map(|(dst, width, cond)| Op::Store { dst, width, cond }),
        (a_place(), a_place(), a_width(), a_cond()).prop_map(|(dst, src, width, cond)| Op::Move {
            dst,
            src,
            width,
            cond
        }),
        (select(functions), with_source(an_integer_width())).prop_map(|(op, (src, width))| Op::Arith {
            op,
            src,
            width
        }),
        (real, a_source(Width::Real)).prop_map(|(op, src)| Op::Arith { op, src, width: Width::Real }),
        (select(relations), with_source(a_width()), any::<bool>())
            .prop_map(|(op, (src, width), if_rlo)| Op::Compare { op, src, width, if_rlo }),
        (select(unary), a_width()).prop_map(|(op, width)| Op::Unary { op, width }),
        (any::<bool>(), 0..70_i64, an_integer_width()).prop_map(|(left, n, width)| Op::Shift {
            left,
            count: Source::Int(n),
            width
        }),
        an_integer_width().prop_map(|width| Op::DrToRlo(DrTest::NonZero(width))),
        an_integer_width().prop_map(Op::RloToDr),
        an_integer_width().prop_map(Op::IntToReal),
        (a_place(), narrow()).prop_map(|(count, width)| Op::Timer { count, width }),
        (a_place(), narrow(), 0..4_u32).prop_map(|(count, width, n)| Op::Counter {
            op: Count::Up,
            count,
            width,
            state: HIDDEN + 8 + n
        }),
        (a_place(), a_place(), 0..9_u32).prop_map(|(src, dst, len)| Op::Copy { src, dst, len }),
        (0..361_u16, 1..9_u8).prop_map(|(offset, len)| Op::SelectBlock { offset, len }),
        Just(Op::IndexFromDr),
        an_assembler_op(),
        Just(Op::IncrementBcd),
    ]
}

fn an_assembler_op() -> impl Strategy<Value = Op> {
    use technol_image::assembler::{Function, General, Operand, Part, Register};
    let functions = vec![
        Function::Move,
        Function::Add,
        Function::Sub,
        Function::Xor,
        Function::Compare,
        Function::ShiftLeft,
        Function::ShiftRight,
    ];
    let registers = prop::sample::select(vec![General::A, General::C, General::D]);
    (prop::sample::select(functions), registers, a_place(), any::<u32>(), any::<bool>()).prop_map(
        |(function, general, place, number, to_cell)| {
            let register = Operand::Register(Register { general, part: Part::Word });
            let to = if to_cell { Operand::Cell(place) } else { register };
            let from = match function {
                Function::ShiftLeft | Function::ShiftRight => Operand::Register(Register::CL),
                _ if to_cell => register,
                _ => Operand::Number(number),
            };
            Op::Assembler { function, width: Width::Word, to, from }
        },
    )
}

fn an_op() -> impl Strategy<Value = Op> {
    prop_oneof![3 => bit_op(), 2 => data_op()]
}

fn a_piece() -> impl Strategy<Value = Piece> {
    let leaf = prop_oneof![
        12 => an_op().prop_map(Piece::Op),
        1 => (0..2_u16).prop_map(Piece::Call),
        1 => any::<bool>().prop_map(Piece::Message),
    ];
    leaf.prop_recursive(2, 16, 6, |inner| {
        prop_oneof![
            (a_cond(), vec(inner.clone(), 0..5)).prop_map(|(cond, pieces)| Piece::Skip(cond, pieces)),
            vec(inner, 0..5).prop_map(Piece::Raster),
        ]
    })
}

fn a_state() -> impl Strategy<Value = State> {
    prop_oneof![
        4 => a_piece().prop_map(State::Plain),
        1 => Just(State::Ex),
        1 => any::<bool>().prop_map(State::ExIf),
        1 => Just(State::Bex),
        1 => (any::<bool>(), 0..4_i64).prop_map(|(wait_when, time)| State::Tex(wait_when, time)),
        1 => (0..4_i64).prop_map(State::Tim),
        1 => Just(State::Init),
    ]
}

fn a_sketch() -> impl Strategy<Value = Sketch> {
    let states = || vec(a_state(), 1..10);
    let pieces = || vec(a_piece(), 0..10);
    (pieces(), states(), states(), pieces(), pieces(), vec(bit_op(), 0..4), vec(an_op(), 0..4)).prop_map(
        |(main, mechanism, block, rest, fast, first, second)| Sketch {
            main,
            mechanism,
            block,
            rest,
            fast,
            procedures: [first, second],
        },
    )
}

fn write_pieces(b: &mut Builder, pieces: &[Piece]) {
    for piece in pieces {
        match piece {
            Piece::Op(op) => {
                b.op(*op);
            }
            Piece::Skip(cond, inner) => {
                let end = b.label();
                b.jump(end, *cond);
                write_pieces(b, inner);
                b.place(end);
            }
            Piece::Raster(inner) => {
                let end = b.label();
                b.raster(Raster::Tenth, end);
                write_pieces(b, inner);
                b.place(end);
            }
            Piece::Call(n) => {
                b.op(Op::Call(*n));
            }
            Piece::Message(conditional) => {
                let cond = if *conditional { Cond::IfRlo } else { Cond::Always };
                b.message(Message { number: None, sub_id: None, set: true, parameters: [None; 3] }, cond);
            }
        }
    }
}

fn write_states(b: &mut Builder, number: u16, states: &[State]) {
    let error = b.label();
    for (n, state) in states.iter().enumerate() {
        let counter = A + 0x40 + 0x20 * u32::from(number) + 2 * n as u32;
        match state {
            State::Plain(piece) => write_pieces(b, std::slice::from_ref(piece)),
            State::Ex => drop(b.ex()),
            State::ExIf(wait_when) => drop(b.ex_if(*wait_when)),
            State::Bex => drop(b.bex()),
            State::Tex(wait_when, time) => {
                b.tex(*wait_when, counter, Source::Int(*time), error, Some(7));
            }
            State::Tim(time) => drop(b.tim(counter, Source::Int(*time))),
            State::Init => drop(b.op(Op::SeqInit(number))),
        }
    }
    b.place(error);
    b.op(Op::Complement);
}

fn write(sketch: &Sketch) -> Program {
    let mut b = Builder::new();
    for (name, body) in ["_ON_ESET", "P"].into_iter().zip(&sketch.procedures) {
        b.procedure(name, body.iter().copied());
    }
    b.block_module(ModuleKind::BlockInit, |b| write_states(b, 0, &sketch.block));
    b.module(ModuleKind::Main, 0, |b| {
        write_pieces(b, &sketch.main);
        // Started again whenever it has ended.
        b.op(Op::Flag { value: true, bit: crate::support::bit(activation(1), 0), cond: Cond::Always });
        b.mechanism(|b| write_states(b, 1, &sketch.mechanism));
    });
    b.module(ModuleKind::Main, 1, |b| write_pieces(b, &sketch.rest));
    b.module(ModuleKind::Fast, 0, |b| write_pieces(b, &sketch.fast));
    b.module(ModuleKind::Cont, 0, |b| b.op(Op::Complement));
    b.build()
}

fn activation(sequence: u16) -> u32 {
    crate::support::SEQUENCE_CELLS + 8 * u32::from(sequence)
}

/// Milliseconds that the properties look at: six cycles and the first tick of DFTM01.
const MILLIS: u64 = 110;

fn start(program: &Program) -> Bench {
    let mut bench = Bench::new(program.clone());
    bench.plc.set_limits(Limits { per_pass: 2_000, per_cycle: Some(40), per_fast: Some(10) });
    bench.command(Command::StartPlc { cold: true });
    bench.command(Command::StartBlock(Block { m: [3].into(), motion_ms: 30, ..Block::default() }));
    bench
}

/// Runs to the end; at each stop `next` says how to go on.
fn run(bench: &mut Bench, mut next: impl FnMut(&mut Runtime) -> Resume) {
    while bench.plc.fault().is_none() && bench.plc.millis() < MILLIS {
        if bench.tick() == TickOutcome::Stopped && bench.plc.fault().is_none() {
            let how = next(&mut bench.plc);
            bench.plc.resume(how);
        }
    }
}

fn free_run(program: &Program) -> Bench {
    let mut bench = start(program);
    run(&mut bench, |_| unreachable!("nothing stops a free run"));
    bench
}

fn assert_same(a: &Bench, b: &Bench) {
    assert_eq!(a.plc.fault(), b.plc.fault());
    assert_eq!(format!("{:?}", a.events), format!("{:?}", b.events));
    assert_eq!(a.plc.outputs(), b.plc.outputs());
    assert_eq!(a.plc.memory(), b.plc.memory());
    assert_eq!(a.plc.state_hash(), b.plc.state_hash());
}

fn a_resume() -> impl Strategy<Value = Resume> {
    prop::sample::select(vec![
        Resume::StepInto,
        Resume::StepOver { sequence: None },
        Resume::StepOver { sequence: Some(0) },
        Resume::StepOver { sequence: Some(1) },
        Resume::StepOut,
        Resume::Continue,
    ])
}

proptest! {
    #[test]
    fn stepping_n_times_equals_running_n(sketch in a_sketch()) {
        let program = write(&sketch);
        let mut stepped = start(&program);
        stepped.plc.pause();
        run(&mut stepped, |_| Resume::StepInto);
        assert_same(&free_run(&program), &stepped);
    }

    #[test]
    fn run_through_break_points_equals_a_run_without(sketch in a_sketch(), choice in vec(any::<bool>(), 256)) {
        let program = write(&sketch);
        let chosen = program.statements.iter().filter(|pc| choice[**pc as usize % choice.len()]);
        let breakpoints: Vec<Pc> = chosen.copied().collect();
        let mut broken = start(&program);
        broken.plc.set_breakpoints(&breakpoints);
        run(&mut broken, |_| Resume::Continue);
        assert_same(&free_run(&program), &broken);
    }

    #[test]
    fn any_mixture_of_steps_and_break_points_changes_nothing(
        sketch in a_sketch(),
        choice in vec(prop::bool::weighted(0.2), 64),
        moves in vec(a_resume(), 1..20),
    ) {
        let program = write(&sketch);
        let mut n = 0;
        let mut debugged = start(&program);
        debugged.plc.pause();
        run(&mut debugged, |plc| {
            n += 1;
            let chosen = plc.program().statements.iter().filter(|pc| choice[(**pc as usize + n) % choice.len()]);
            let breakpoints: Vec<Pc> = chosen.copied().collect();
            plc.set_breakpoints(&breakpoints);
            moves[n % moves.len()]
        });
        assert_same(&free_run(&program), &debugged);
    }

    #[test]
    fn damaged_program_is_refused_or_runs_without_panic(
        sketch in a_sketch(),
        damage in vec((any::<prop::sample::Index>(), any::<u8>()), 1..12),
    ) {
        let mut bytes = encode_program(&write(&sketch));
        for (at, value) in damage {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        if let Ok(program) = decode_program(&bytes) {
            run_wild(program);
        }
    }

    #[test]
    fn program_of_arbitrary_operations_is_refused_or_runs_without_panic(
        ops in vec(a_wild_op(), 1..40),
    ) {
        let mut b = Builder::new();
        b.procedure("_ON_ESET", [Op::Nop]);
        b.block_module(ModuleKind::BlockInit, Builder::ex);
        b.module(ModuleKind::Fast, 0, |b| b.op(Op::Complement));
        b.module(ModuleKind::Main, 0, |b| {
            b.mechanism(|b| {
                b.ex();
                b.ops(ops);
            });
        });
        run_wild(b.build());
    }
}

fn a_wild_op() -> impl Strategy<Value = Op> {
    prop_oneof![
        6 => an_op(),
        1 => (0..60_u32, a_cond()).prop_map(|(target, cond)| Op::Jump { target, cond }),
        1 => (0..60_u32).prop_map(|end| Op::Raster { rate: Raster::Tenth, end }),
        1 => (0..3_u16).prop_map(Op::Call),
        1 => Just(Op::Return),
        1 => Just(Op::ModuleEnd),
        1 => (0..3_u16).prop_map(Op::SeqInit),
        1 => (0..3_u16, any::<u16>()).prop_map(|(point, line)| Op::Ex { point, line }),
        1 => (0..3_u16, any::<bool>()).prop_map(|(point, wait_when)| Op::ExIf { wait_when, point, line: 1 }),
        1 => (a_bit(), any::<bool>()).prop_map(|(bit, neg)| Op::Ldr { bit, neg, push: true }),
        1 => Just(Op::LogicPop(Logic::Or)),
        1 => (a_place(), any::<u32>()).prop_map(|(src, len)| Op::Copy { src, dst: src, len }),
        1 => (any::<u32>(), 0..0x9000_u32).prop_map(|(addr, len)| Op::Clear { addr: addr % 0x9000, len }),
        1 => (0..70_u8).prop_map(Op::InitFinished),
    ]
}

/// Runs with everything the outside can do: commands, break-points, steps, overwritten cells.
fn run_wild(program: Program) {
    let Ok(mut plc) = Runtime::new(program) else { return };
    plc.set_limits(Limits { per_pass: 500, ..Limits::default() });
    let everywhere: Vec<Pc> = (0..200).collect();
    let mut events = vec![];
    for n in 0..150_u32 {
        match n {
            0 => plc.command(Command::StartPlc { cold: true }),
            10 => {
                plc.command(Command::StartBlock(Block {
                    m: [3, 10].into(),
                    motion_ms: 5,
                    ..Block::default()
                }));
            }
            40 => drop(plc.set_breakpoints(&everywhere)),
            70 => drop(plc.set_breakpoints(&[])),
            90 => plc.command(Command::AbortBlock),
            100 => plc.command(Command::ClearPlc),
            110 => plc.command(Command::StopPlc { power_off: true }),
            120 => plc.command(Command::StartPlc { cold: false }),
            140 => plc.command(Command::Halt),
            _ => {}
        }
        let cells = system::LEN + 0x200 + n % 16;
        let _ = plc.write_memory(cells, &[(n % 3) as u8]);
        if plc.tick(&[0xA5; 128], &mut events) == TickOutcome::Stopped {
            assert!(plc.stopped().is_some());
            assert!(!plc.call_stack().is_empty());
            plc.resume(if n % 2 == 0 { Resume::Continue } else { Resume::StepOut });
        }
        let _ = (plc.sequences().count(), plc.state_hash());
    }
}
