//! The command line as scripts meet it: exit codes, output formats, what is said when something is wrong.

#[path = "../shared/binary.rs"]
mod binary;
#[path = "../shared/frame.rs"]
mod frame;
#[path = "../shared/lathe.rs"]
mod lathe;

mod build;
mod check;
mod demo;
mod explain;
mod ran;
mod run;
mod target;
