//! Debug sessions through the real program: `technol dap` as a child process, targets in its own process, at a TCP
//! port and at the end of a serial line.

#[path = "../common/binary.rs"]
mod binary;
#[path = "../common/frame.rs"]
mod frame;
#[path = "../common/lathe.rs"]
mod lathe;

mod attach;
mod breakpoints;
mod child;
mod console;
mod forcing;
mod machine_registers;
mod session;
mod trouble;
mod watching;
