//! The time of a cycle beside that of a C program of the same logic, made by `gcc -O2` and run in turn with it.
//! `cargo bench -p technol-runtime --bench against_c`
//!
//! Both run the same program on the same changing inputs, and their memory has to be the same at the end.

#[path = "against_c/c_program.rs"]
mod c_program;
#[path = "against_c/mixture.rs"]
mod mixture;
#[path = "../tests/runtime/support/mod.rs"]
mod support;

use std::time::Instant;

use c_program::CProgram;
use mixture::{Mixture, PORTS, next_inputs};
use support::{Bench, Builder, END, GLOBAL};
use technol_image::op::{Cond, Op};

/// Cycles that are timed at once.
const CYCLES: u32 = 400;
/// Times each form is timed; the least counts, since others share the machine.
const ROUNDS: usize = 12;
const OPERATIONS: usize = 10_000;
/// Lines that an editor shows.
const WINDOW: u32 = 40;

/// Nanoseconds of a cycle, and a number for what is in memory then.
#[derive(Clone, Copy, Debug)]
struct Timing {
    ns: f64,
    memory: u64,
}

/// FNV-1a, as the C program does it.
fn hash(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xCBF2_9CE4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01B3))
}

/// The program in the virtual machine, started.
fn loaded(ops: &[mixture::Item], armed: bool) -> Bench {
    let builder = Builder::new().main(|b| {
        mixture::write(ops, b);
        let end = b.label();
        b.jump(end, Cond::Always);
        b.op(Op::Nop);
        b.place(end);
    });
    let mut bench = builder.load().started();
    if armed {
        // The NOP that is always jumped over.
        let nop = bench.plc.program().modules[0].end - 2;
        assert_eq!(bench.plc.set_breakpoints(&[nop]), [Ok(())]);
    }
    bench
}

/// The program with a trace of the lines that begin there.
fn traced(ops: &[mixture::Item], lines: std::ops::Range<u32>) -> Bench {
    let mut bench = loaded(ops, false);
    assert!(bench.plc.set_trace(&[lines]) > 0);
    bench
}

fn time(bench: &mut Bench, seed: &mut u64) -> Timing {
    let mut spent = f64::MAX;
    // In parts, so that one interruption does not spoil all.
    for _ in 0..10 {
        let start = Instant::now();
        for _ in 0..CYCLES / 10 {
            next_inputs(seed, &mut bench.inputs[..PORTS]);
            bench.cycles(1);
        }
        spent = spent.min(start.elapsed().as_secs_f64() * 1e9 / f64::from(CYCLES / 10));
    }
    Timing { ns: spent, memory: hash(&bench.plc.memory()[GLOBAL as usize..END as usize]) }
}

fn least(timings: impl Iterator<Item = f64>) -> f64 {
    timings.fold(f64::MAX, f64::min)
}

fn compare(name: &str, mixture: Mixture) {
    let items = mixture.generate(OPERATIONS);
    let operations = items.len();
    let mut plain = loaded(&items, false);
    let mut armed = loaded(&items, true);
    let mut window = traced(&items, 5_000..5_000 + WINDOW);
    let mut whole = traced(&items, 0..u32::MAX);
    // Inputs of a cycle cost something too; an empty program says how much.
    let mut empty = loaded(&[], false);
    let c = CProgram::compile(name, &items);
    let (mut seeds, mut times) = ([1; 5], [const { Vec::new() }; 6]);
    for _ in 0..ROUNDS {
        let of_plain = time(&mut plain, &mut seeds[0]);
        times[0].push(of_plain.ns);
        for (n, bench) in [(1, &mut armed), (2, &mut window), (3, &mut whole)] {
            let timing = time(bench, &mut seeds[n]);
            times[n].push(timing.ns);
            assert_eq!(of_plain.memory, timing.memory);
        }
        times[4].push(time(&mut empty, &mut seeds[4]).ns);
    }
    if let Some(c) = &c {
        let of_c = c.run(CYCLES * ROUNDS as u32);
        times[5].push(of_c.ns);
        assert_eq!(plain.plc.memory().len(), END as usize);
        let of_plc = hash(&plain.plc.memory()[GLOBAL as usize..END as usize]);
        assert_eq!(of_plc, of_c.memory, "{name}: the C program computes something else");
        // Once more each, so that a busy moment does not decide.
        times[5].push(c.run(CYCLES * ROUNDS as u32).ns);
        times[0].push(time(&mut plain, &mut seeds[0]).ns);
        times[5].push(c.run(CYCLES * ROUNDS as u32).ns);
    }
    let [plain, armed, window, whole, empty, in_c] = times.map(|times| least(times.into_iter()));
    let per = |ns: f64| (ns - empty) / operations as f64;
    println!("{name}: {operations} operations in a cycle");
    println!("  runtime               {:8.1} µs   {:6.3} ns per operation", plain / 1e3, per(plain));
    println!("  break-point not hit   {:8.1} µs   {:+6.2} %", armed / 1e3, (armed / plain - 1.0) * 100.0);
    let slower = |ns: f64| (ns - empty) / (plain - empty);
    println!("  trace of {WINDOW} lines     {:8.1} µs   {:6.2} times", window / 1e3, slower(window));
    println!("  trace of all lines    {:8.1} µs   {:6.2} times", whole / 1e3, slower(whole));
    println!("  of it inputs, outputs {:8.1} µs", empty / 1e3);
    if c.is_some() {
        let c_per = in_c / operations as f64;
        println!("  C, gcc -O2            {:8.1} µs   {c_per:6.3} ns per operation", in_c / 1e3);
        println!("  runtime / C           {:8.2}", (plain - empty) / in_c);
    }
}

fn main() {
    // `cargo test --benches` only asks whether it starts.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    // `cargo bench` names the bench; a word of one's own chooses one of them.
    let chosen = std::env::args().nth(1).filter(|word| !word.starts_with('-'));
    for (name, data_percent) in [("bits", 0), ("mixed", 40), ("data", 100)] {
        if chosen.as_deref().is_none_or(|word| word == name) {
            compare(name, Mixture { data_percent });
        }
    }
}
