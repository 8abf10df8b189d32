//! The stack of the target is bounded.

use technol_runtime::{Command, Runtime};

use crate::lathe;

/// What a tick may need, in a build that optimises nothing. In an optimised one it is a small part of that.
const TICK: usize = 64 << 10;

/// Runs in a thread of its own whose stack is this long; too little of it ends the whole test process.
fn with_stack(len: usize, work: impl FnOnce() + Send + 'static) {
    std::thread::Builder::new().stack_size(len).spawn(work).expect("a thread").join().expect("it ends well");
}

#[test]
fn a_tick_fits_into_a_small_stack_whatever_the_program_does() {
    let program = lathe::image().program.clone();
    let runtime = Box::new(Runtime::new(program).expect("the lathe can be loaded"));
    with_stack(TICK, move || {
        let mut runtime = runtime;
        let mut events = Vec::with_capacity(64);
        let inputs = [0xFF; 128];
        runtime.command(Command::StartPlc { cold: true });
        for _ in 0..2_000 {
            runtime.tick(&inputs, &mut events);
            events.clear();
        }
    });
}
