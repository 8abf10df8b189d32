//! From source text to what the program does: the real front end, the real build, the real virtual machine.

#[path = "../common/frame.rs"]
mod frame;

mod arithmetic;
mod assembler;
mod axes;
mod bits;
mod blocks;
mod can;
mod channel;
mod comparisons;
mod configuration;
mod coverage;
mod data;
mod elements;
mod ethercat;
mod field;
mod interface;
mod lathe;
mod licences;
mod macros;
mod mechanisms;
mod messages;
mod modules;
mod plc;
mod registers;
mod serial;
mod shared;
mod slides;
mod tables;
mod texts;
mod time;
