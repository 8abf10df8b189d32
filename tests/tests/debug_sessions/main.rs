//! Debug sessions through the real program: `technol dap` as a child process, targets in its own process, at a TCP
//! port and at the end of a serial line.

#[path = "../common/binary.rs"]
mod binary;
#[path = "../common/frame.rs"]
mod frame;
#[path = "../common/lathe.rs"]
mod lathe;
#[cfg(unix)]
#[path = "../common/patient.rs"]
mod patient;

mod attach;
mod breakpoints;
mod child;
mod console;
mod forcing;
mod machine_registers;
#[cfg(unix)]
mod noise;
mod session;
mod trouble;
mod watching;
