//! A number for the state of a runtime.

use core::fmt::{self, Write};

use crate::runtime::Runtime;

/// Takes a runtime apart so that a new field cannot be forgotten here.
pub(crate) fn of(runtime: &Runtime) -> u64 {
    let Runtime {
        // Made from the program, which is the same, or asked for by the host.
        program: _,
        code: _,
        plans: _,
        limits: _,
        fast_inputs: _,
        fast_outputs: _,
        // Looking at a program does not change what it does.
        coverage: _,
        trace: _,
        debugger: _,
        machine,
        main,
        fast,
        cont,
        position,
        state,
        fault,
        commands,
        entry_dr,
        block,
        plc_events,
        shorted,
        outputs,
        spent,
    } = runtime;
    let crate::execute::Machine { memory, millis, init_seen, done_seen, state_since } = machine;
    let mut hash = Fnv::new();
    hash.add(memory.bytes());
    hash.add(outputs);
    hash.add(shorted);
    for ctx in [main, fast, cont] {
        let crate::registers::Registers { rlo, dr, dr_real, bx, stack, depth, eax, flags } = ctx.regs;
        hash.add(&[u8::from(rlo), stack, depth]);
        hash.add(&dr.to_le_bytes());
        hash.add(&dr_real.to_bits().to_le_bytes());
        hash.add(&bx.to_le_bytes());
        hash.add(&eax.to_le_bytes());
        hash.add(&flags.to_le_bytes());
        hash.show(&(ctx.pc, &ctx.calls, ctx.root, ctx.rewound));
    }
    hash.show(&(millis, init_seen, done_seen, state_since));
    hash.show(&(position, state, fault, commands, entry_dr, block, plc_events, spent));
    hash.0
}

/// 64-bit FNV-1a over eight bytes at a time.
struct Fnv(u64);

impl Fnv {
    fn new() -> Fnv {
        Fnv(0xCBF2_9CE4_8422_2325)
    }

    fn add(&mut self, bytes: &[u8]) {
        let (words, rest) = bytes.as_chunks();
        for word in words {
            self.add_word(u64::from_le_bytes(*word));
        }
        if !rest.is_empty() {
            self.add_word(rest.iter().fold(1, |word, byte| word << 8 | u64::from(*byte)));
        }
    }

    fn add_word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01B3);
        self.0 ^= self.0 >> 32;
    }

    /// Adds how a value shows itself, in which every field of it takes part.
    fn show(&mut self, value: &dyn fmt::Debug) {
        // Writing into the hash does not fail.
        let _ = write!(self, "{value:?}");
    }
}

impl Write for Fnv {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}
