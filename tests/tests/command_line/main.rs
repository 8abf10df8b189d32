//! The command line as scripts meet it: exit codes, output formats, what is said when something is wrong.

#[path = "../common/binary.rs"]
mod binary;
#[path = "../common/frame.rs"]
mod frame;
#[path = "../common/lathe.rs"]
mod lathe;

mod build;
mod check;
mod demo;
mod explain;
mod explain_machine;
mod fmt;
mod kept;
mod messages;
mod ran;
mod remote;
mod run;
mod target;
mod test;
mod wired;
