//! `technol`: language server, debugger and runtime target for PLC programs in TECHNOL, in one binary.

fn main() -> std::process::ExitCode {
    technol_cli::main()
}
