//! What the program `technol` does. A library only so that the fuzz targets can reach it: there is no other user.

mod arguments;
mod build;
mod check;
mod connector;
mod control_data;
mod dap;
mod demo;
mod exit;
mod explain;
mod files;
mod fmt;
mod identifiers;
mod link;
mod out;
mod paint;
mod remote;
mod remote_files;
mod run;
mod target;
mod test;

#[cfg(any(test, feature = "fuzzing"))]
pub use test::hostile;

use std::process::ExitCode;

use clap::Parser as _;

use crate::arguments::{Arguments, Command, LspArguments};

/// The program: reads the arguments of the process and does what they say. Exit codes are those of `technol --help`.
#[must_use]
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version go to stdout with code 0, usage errors to stderr with code 2.
            let code = if error.use_stderr() { exit::USAGE } else { exit::OK };
            // Nothing is left to do when even the message cannot be written.
            let _ = error.print();
            return ExitCode::from(code);
        }
    };
    let result = match arguments.command {
        Command::Check(arguments) => check::check(&arguments),
        Command::Build(arguments) => build::build(&arguments),
        Command::Run(arguments) => run::run(&arguments),
        Command::Test(arguments) => test::test(&arguments),
        Command::Target(arguments) => target::target(&arguments),
        Command::Dap(arguments) => dap::dap(&arguments),
        // `--stdio` only names what happens anyway.
        Command::Lsp(LspArguments { stdio: _ }) => Ok(dap::lsp()),
        Command::Devices(arguments) => Ok(link::list_devices(&arguments)),
        Command::Link(arguments) => link::link(&arguments.command),
        Command::Files(arguments) => remote_files::files(&arguments),
        Command::Fmt(arguments) => fmt::fmt(&arguments),
        Command::Explain(arguments) => explain::explain(&arguments),
        Command::Demo(arguments) => demo::demo(&arguments),
    };
    match result {
        Ok(code) => ExitCode::from(code),
        Err(failure) => {
            eprintln!("technol: {failure}");
            ExitCode::from(failure.code)
        }
    }
}
