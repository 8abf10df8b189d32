//! The whole chain over a simulated cable, in virtual time: what runs here is the real target and the real adapter,
//! only the line and the clock are simulated.

#[path = "../../../debug-target/tests/session/program.rs"]
#[allow(dead_code)] // parts of it are for other tests
mod program;

#[path = "../common/binary.rs"]
#[allow(dead_code)]
mod binary;
#[path = "../common/lathe.rs"]
#[allow(dead_code)]
mod lathe;
#[path = "../common/patient.rs"]
mod patient;

mod bars;
mod busy;
mod forcing;
mod killed;
mod probe;
mod session;
mod transfers;
mod world;
