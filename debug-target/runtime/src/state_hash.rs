//! Numbers for states: of a runtime, and of what is around it.

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
    let mut hash = StateHash::new();
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
        hash.add_shown(&(ctx.pc, &ctx.calls, ctx.root, ctx.rewound));
    }
    hash.add_shown(&(millis, init_seen, done_seen, state_since));
    hash.add_shown(&(position, state, fault, commands, entry_dr, block, plc_events, spent));
    hash.value()
}

/// Makes a number of a state: 64-bit FNV-1a over eight bytes at a time. Equal states give equal numbers; the numbers
/// are for comparisons within one version of this crate, not to be kept.
#[derive(Clone, Debug)]
pub struct StateHash(u64);

impl Default for StateHash {
    fn default() -> StateHash {
        StateHash::new()
    }
}

impl StateHash {
    /// Of nothing yet.
    #[must_use]
    pub fn new() -> StateHash {
        StateHash(0xCBF2_9CE4_8422_2325)
    }

    /// The number of how a value shows itself: every field of it takes part, also those that are added later.
    #[must_use]
    pub fn of_shown(value: &dyn fmt::Debug) -> u64 {
        let mut hash = StateHash::new();
        hash.add_shown(value);
        hash.value()
    }

    /// The number of bytes, for areas that are too long to show each of them.
    #[must_use]
    pub fn of_bytes(bytes: &[u8]) -> u64 {
        let mut hash = StateHash::new();
        hash.add(bytes);
        hash.value()
    }

    /// Adds bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        let (words, rest) = bytes.as_chunks();
        for word in words {
            self.add_word(u64::from_le_bytes(*word));
        }
        if !rest.is_empty() {
            self.add_word(rest.iter().fold(1, |word, byte| word << 8 | u64::from(*byte)));
        }
    }

    /// Adds how a value shows itself.
    pub fn add_shown(&mut self, value: &dyn fmt::Debug) {
        // Writing into the hash does not fail.
        let _ = write!(self, "{value:?}");
    }

    /// The number of all that was added.
    #[must_use]
    pub fn value(&self) -> u64 {
        self.0
    }

    fn add_word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01B3);
        self.0 ^= self.0 >> 32;
    }
}

impl Write for StateHash {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}
