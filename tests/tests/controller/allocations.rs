//! A cycle asks for no memory. Allocations are counted for this thread only.

use allocation_counter::measure;
use technol_image::op::{Addr, Cond, Count, Op, Place, Width};
use technol_image::program::{Message, Module, ModuleKind, Procedure, Program, Region, RegionKind};
use technol_image::service::Service;
use technol_image::system;
use technol_runtime::{Block, BlockMode, Command, PlcState, Runtime, RuntimeEvent};

use crate::lathe;

/// More than happens in one cycle.
const EVENTS: usize = 256;

#[test]
fn a_cycle_of_the_lathe_asks_for_no_memory() {
    let mut simulation = lathe::started();
    let mut events = Vec::with_capacity(EVENTS);
    simulation.cycle(&mut events);
    let mut happened = 0;
    let mut asking = Vec::new();
    for cycle in 1..4_100 {
        // Keys and faults are the host's; it looks them up by name.
        lathe::act(&mut simulation, cycle);
        events.clear();
        let info = measure(|| {
            simulation.cycle(&mut events);
        });
        happened += events.len();
        if info.count_total != 0 {
            asking.push((cycle, info.count_total));
        }
    }
    assert_eq!(simulation.runtime().state(), PlcState::Running);
    assert!(happened > 20, "{happened} events");
    // Not even when the part program begins, in cycle 100, when a key starts a block, or when STOP holds one.
    assert!(asking.is_empty(), "(cycle, allocations) {asking:?}");
}

const DATA: Addr = system::LEN;
const HIDDEN: Addr = DATA + 0x100;
const END: Addr = HIDDEN + 0x10;

/// Calls, messages with handler, counters, copies, events and break-points in reach: all that keeps books.
fn busy() -> Program {
    let region = |kind, start: u32, end: u32| Region { kind, start, len: end - start };
    let cell = |addr| Place { addr, indexed: false };
    let bit = |n| technol_image::BitRef { addr: DATA, bit: n, indexed: false };
    let mut code = Vec::new();
    let mut modules = Vec::new();
    let mut module = |kind, ops: &[Op], code: &mut Vec<Op>| {
        let start = code.len() as u32;
        code.extend_from_slice(ops);
        code.push(Op::ModuleEnd);
        modules.push(Module { kind, file: 0, start, end: code.len() as u32 });
    };
    module(ModuleKind::Fast, &[Op::Call(2), Op::Call(2)], &mut code);
    let main = [
        Op::Ldr { bit: bit(0), neg: false, push: false },
        Op::Complement,
        Op::Write(bit(0)),
        Op::Counter { op: Count::Up, count: cell(DATA + 4), width: Width::Word, state: HIDDEN },
        Op::Message { index: 0, cond: Cond::Always },
        Op::Call(0),
        Op::Copy { src: cell(DATA + 16), dst: cell(DATA + 20), len: 64 },
    ];
    module(ModuleKind::Main, &main, &mut code);
    module(ModuleKind::Cont, &[Op::Call(2)], &mut code);
    let mut procedures = Vec::new();
    let mut procedure = |name: &str, ops: &[Op], code: &mut Vec<Op>| {
        let start = code.len() as u32;
        code.extend_from_slice(ops);
        code.push(Op::Return);
        procedures.push(Procedure { name: name.into(), start, end: code.len() as u32 });
    };
    procedure("OUTER", &[Op::Call(1), Op::Call(1)], &mut code);
    procedure("MIDDLE", &[Op::Call(2), Op::Call(2), Op::Call(2)], &mut code);
    procedure("INNER", &[Op::Complement, Op::Write(bit(1))], &mut code);
    procedure("_ON_ESET", &[Op::Call(2)], &mut code);
    procedure("_ON_EVENT", &[Op::Call(0)], &mut code);
    let source = technol_image::Source::Int(7);
    Program {
        name: "busy".into(),
        regions: vec![
            region(RegionKind::System, 0, DATA),
            region(RegionKind::Global, DATA, HIDDEN),
            region(RegionKind::Hidden, HIDDEN, END),
        ],
        statements: (0..code.len() as u32).collect(),
        code,
        modules,
        procedures,
        messages: vec![Message {
            number: Some((source, Width::Word)),
            sub_id: None,
            set: true,
            parameters: [None, None, None],
        }],
        sequences: vec![],
        timed: vec![],
        services: vec![],
        initial: vec![],
        init_finished: vec![],
        done_finished: vec![],
    }
}

#[test]
fn calls_messages_events_and_blocks_without_m_functions_ask_for_no_memory() {
    let mut plc = Runtime::new(busy()).expect("it can be loaded");
    let mut events = Vec::with_capacity(EVENTS);
    let inputs = [0; 128];
    plc.command(Command::StartPlc { cold: true });
    plc.tick(&inputs, &mut events);
    let (mut messages, mut blocks) = (0, 0);
    for cycle in 0..500_u32 {
        events.clear();
        let info = measure(|| {
            // As much as fits into the queues: what is too much has to be refused without asking for memory too.
            for n in 0..20 {
                if cycle % 3 == 0 {
                    plc.command(Command::Event(n));
                }
                if cycle % 50 == 0 && n < 10 {
                    let motion_ms = 30;
                    let block = Block { motion_ms, mode: BlockMode::Auto, ..Block::default() };
                    plc.command(Command::StartBlock(block));
                }
            }
            for _ in 0..20 {
                plc.tick(&inputs, &mut events);
            }
        });
        assert_eq!(info.count_total, 0, "allocations in cycle {cycle}");
        messages += events.iter().filter(|e| matches!(e, RuntimeEvent::Message { .. })).count();
        blocks += events.iter().filter(|e| matches!(e, RuntimeEvent::BlockFinished { .. })).count();
    }
    assert_eq!((messages, blocks, plc.state()), (500, 100, PlcState::Running));
}

#[test]
fn a_fault_asks_for_no_memory() {
    let mut program = busy();
    let main =
        program.modules.iter().find(|m| m.kind == ModuleKind::Main).expect("it has one").start as usize;
    program.code[main] = Op::IncrementBcd;
    program.code[main + 1] = Op::IncrementBcd;
    program.code[main + 2] =
        Op::Load { src: technol_image::Source::Int(0xFF), width: Width::Word, neg: false };
    program.code[main + 3] = Op::IncrementBcd;
    let mut plc = Runtime::new(program).expect("it can be loaded");
    let mut events = Vec::with_capacity(EVENTS);
    let inputs = [0; 128];
    plc.command(Command::StartPlc { cold: true });
    let info = measure(|| {
        for _ in 0..100 {
            plc.tick(&inputs, &mut events);
        }
    });
    assert_eq!((plc.state(), info.count_total), (PlcState::Faulted, 0));
}

#[test]
fn memory_of_the_target_for_the_lathe_is_far_below_four_mebibytes() {
    let bytes = technol_image::encode(lathe::image());
    let machine = lathe::machine();
    let info = measure(|| {
        // As a target does it: the bytes that were downloaded, the program out of them, the simulation in front of it.
        let image = technol_image::decode(&bytes).expect("it was just encoded");
        let program = image.program;
        let mut simulation =
            technol_target::Simulation::new(program, Some(&machine)).expect("it can be loaded");
        let mut events = Vec::with_capacity(EVENTS);
        simulation.start(true);
        for _ in 0..1_000 {
            simulation.cycle(&mut events);
            events.clear();
        }
    });
    let image = bytes.len();
    println!("lathe: image {image} bytes, most memory in use {} bytes", info.bytes_max);
    assert!(info.bytes_max + (image as u64) < 1 << 20, "{info:?}");
}

/// The program of all families, with something at the other end of each.
fn families() -> technol_target::Simulation {
    let mut simulation =
        technol_target::Simulation::new(crate::families::program(), None).expect("it can be loaded");
    crate::families::furnish(&mut simulation);
    simulation.start(true);
    simulation
}

#[test]
fn a_cycle_with_instructions_of_every_family_asks_for_no_memory() {
    let mut simulation = families();
    let mut events = Vec::with_capacity(EVENTS);
    // MODULE_INIT declares: what it says is kept.
    simulation.cycle(&mut events);
    let mut messages = 0;
    for cycle in 1..400_u32 {
        // The other side of the buses is the host's.
        crate::families::feed(&mut simulation, cycle);
        events.clear();
        let info = measure(|| {
            simulation.cycle(&mut events);
        });
        messages += events.len();
        assert_eq!(info.count_total, 0, "allocations in cycle {cycle}");
    }
    assert_eq!(simulation.runtime().fault(), None);
    assert_eq!(simulation.runtime().state(), PlcState::Running);
    assert!(messages > 1_000, "{messages} messages");
    crate::families::happened(&mut simulation);
}

#[test]
fn the_program_of_all_families_executes_every_service() {
    let mut simulation = families();
    simulation.runtime_mut().count_statements(true);
    let mut events = Vec::with_capacity(EVENTS);
    for cycle in 0..100 {
        crate::families::feed(&mut simulation, cycle);
        simulation.cycle(&mut events);
        events.clear();
    }
    let executed = crate::families::executed(simulation.runtime());
    let called = executed.iter().filter_map(|op| match op {
        Op::Service(index) => Some(simulation.runtime().program().services[usize::from(*index)].service),
        _ => None,
    });
    let called: Vec<Service> = called.collect();
    let missing: Vec<_> = Service::ALL.iter().filter(|it| !called.contains(it)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
