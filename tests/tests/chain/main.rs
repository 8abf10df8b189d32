//! From source text to what the program does: the real front end, the real build, the real virtual machine.

#[path = "../common/frame.rs"]
mod frame;

mod arithmetic;
mod bits;
mod can;
mod comparisons;
mod data;
mod ethercat;
mod lathe;
mod licences;
mod macros;
mod mechanisms;
mod messages;
mod plc;
mod serial;
mod texts;
mod time;
