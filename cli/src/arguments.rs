//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

/// Language server, debugger and runtime target for PLC programs in TECHNOL.
#[derive(Debug, Parser)]
#[command(name = "technol", version, about, disable_help_subcommand = true)]
pub(crate) struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Report the mistakes of a project
    Check(CheckArguments),
    /// Build the program image
    Build(BuildArguments),
    /// Run a project on the simulated machine
    Run(RunArguments),
    /// Run the tests of a project in virtual time
    Test(TestArguments),
    /// Be a runtime target that a debugger connects to
    Target(TargetArguments),
    /// Be a debug adapter (on stdio, or for one client after another on TCP)
    Dap(DapArguments),
    /// Be a language server on stdio
    Lsp(LspArguments),
    /// List the serial devices of this computer
    Devices(DevicesArguments),
    /// Test the link to a target, or tell what was recorded on one
    Link(LinkArguments),
    /// Work with the files that a target offers
    Files(FilesArguments),
    /// Convert the sources of a project to another encoding
    Fmt(FmtArguments),
    /// Explain an instruction, a symbol of the control or a diagnostic code
    Explain(ExplainArguments),
    /// Show the whole chain on the lathe example
    Demo(DemoArguments),
}

/// Output format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people.
    Human,
    /// For programs.
    Json,
}

/// Help language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Language {
    /// English.
    En,
    /// Czech.
    Cs,
}

/// `technol check`
#[derive(Debug, Args)]
pub(crate) struct CheckArguments {
    /// Project folder, technol.toml or a lone .plc file
    #[arg(default_value = ".")]
    pub(crate) path: PathBuf,
    /// One line a finding for people, or one JSON object a line
    #[arg(long, value_enum, default_value = "human")]
    pub(crate) format: Format,
}

/// `technol build`
#[derive(Debug, Args)]
pub(crate) struct BuildArguments {
    /// Project folder, technol.toml or a lone .plc file
    #[arg(default_value = ".")]
    pub(crate) path: PathBuf,
    /// Folder for the results [default: `out` in the project folder]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Also write the listing (.LS1) with line numbers, addresses and code
    #[arg(long)]
    pub(crate) listing: bool,
    /// Build even when nothing changed
    #[arg(long)]
    pub(crate) force: bool,
}

/// `technol run`
#[derive(Debug, Args)]
pub(crate) struct RunArguments {
    /// Project folder, technol.toml or a lone .plc file
    #[arg(default_value = ".")]
    pub(crate) path: PathBuf,
    /// How many 20 ms cycles to run
    #[arg(long, value_name = "N", required = false, required_unless_present = "explain_machine")]
    #[arg(default_value_if("explain_machine", "true", "0"), allow_negative_numbers = true)]
    pub(crate) cycles: u64,
    /// Set a bit, variable or mechanism before a cycle (default: before cycle 0, after MODULE_INIT)
    #[arg(long, value_name = "NAME=VALUE[@CYCLE]")]
    pub(crate) set: Vec<String>,
    /// Names to print after the last cycle, comma separated; `TYPE.NAME` as in the language
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub(crate) print: Vec<String>,
    /// For people, or one JSON object
    #[arg(long, value_enum, default_value = "human")]
    pub(crate) format: Format,
    /// Take 20 ms for each cycle instead of running as fast as possible
    #[arg(long)]
    pub(crate) realtime: bool,
    /// Keep PLC_MEM_BACKUP in this file (default: what `[keep]` of the machine file names)
    #[arg(long, value_name = "FILE")]
    pub(crate) backup: Option<PathBuf>,
    /// Append messages, faults and states of the PLC to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) log: Option<PathBuf>,
    /// Switch a fault of the machine on before a cycle (default: before cycle 0)
    #[arg(long, value_name = "NAME[@CYCLE]")]
    pub(crate) fault: Vec<String>,
    /// Press a key of the machine before a cycle, and keep it pressed
    #[arg(long, value_name = "KEY[@CYCLE]")]
    pub(crate) press: Vec<String>,
    /// Release a key of the machine before a cycle
    #[arg(long, value_name = "KEY[@CYCLE]")]
    pub(crate) release: Vec<String>,
    /// Tell what the machine wires to what, and what the program uses that is connected to nothing; run nothing
    #[arg(long)]
    pub(crate) explain_machine: bool,
}

/// `technol test`
#[derive(Debug, Args)]
pub(crate) struct TestArguments {
    /// Project folder, technol.toml, a lone .plc file or a single .test.toml file
    #[arg(default_value = ".")]
    pub(crate) path: PathBuf,
    /// Only tests whose file or name holds this text, in any case
    #[arg(long, value_name = "TEXT")]
    pub(crate) filter: Option<String>,
    /// How many tests run at the same time [default: one for each processor]
    #[arg(long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,
    /// Also write the results as JUnit XML
    #[arg(long, value_name = "FILE")]
    pub(crate) junit: Option<PathBuf>,
    /// Also write which lines were executed (lcov), and print the states that mechanisms were in
    #[arg(long, value_name = "FILE")]
    pub(crate) coverage: Option<PathBuf>,
    /// Run them again whenever a file changes, until Ctrl-C
    #[arg(long)]
    pub(crate) watch: bool,
}

/// `technol target`
#[derive(Debug, Args)]
pub(crate) struct TargetArguments {
    /// Image to load at the start (a debugger can download another one)
    pub(crate) image: Option<PathBuf>,
    /// Listen for a debugger
    #[arg(long, value_name = "tcp:HOST:PORT", required_unless_present = "serial", conflicts_with = "serial")]
    pub(crate) listen: Option<String>,
    /// Serve a debugger on a serial line
    #[arg(long, value_name = "DEVICE[@BAUD][,rtscts]")]
    pub(crate) serial: Option<String>,
    /// The machine behind the program
    #[arg(long, value_name = "machine.toml")]
    pub(crate) machine: Option<PathBuf>,
    /// Project whose configuration files (parameters, constants, tables) the control has
    #[arg(long, value_name = "PATH")]
    pub(crate) configuration: Option<PathBuf>,
    /// Keep PLC_MEM_BACKUP in this file (default: what `[keep]` of the machine file names)
    #[arg(long, value_name = "FILE")]
    pub(crate) backup: Option<PathBuf>,
    /// Append messages, faults and states of the PLC to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) log: Option<PathBuf>,
    /// Clock of the program
    #[arg(long, value_enum, default_value = "real")]
    pub(crate) clock: ClockName,
    /// Start the loaded program at once
    #[arg(long, requires = "image")]
    pub(crate) start: bool,
    /// Folder whose files debuggers may list, get, put, copy, move and delete [default: none]
    #[arg(long, value_name = "DIR")]
    pub(crate) files: Option<PathBuf>,
    /// Let in only who knows the token in this file; needed to listen for other computers [default: TECHNOL_TOKEN]
    #[arg(long, value_name = "FILE", requires = "listen")]
    pub(crate) token_file: Option<PathBuf>,
    /// Record what goes over the serial line or connection; `technol link log` reads it
    #[arg(long, value_name = "FILE")]
    pub(crate) record: Option<PathBuf>,
}

/// `technol devices`
#[derive(Debug, Args)]
pub(crate) struct DevicesArguments {
    /// For people, or a JSON array
    #[arg(long, value_enum, default_value = "human")]
    pub(crate) format: Format,
}

/// `technol link`
#[derive(Debug, Args)]
pub(crate) struct LinkArguments {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: LinkCommand,
}

/// What to do with a link.
#[derive(Debug, Subcommand)]
pub(crate) enum LinkCommand {
    /// Measure round trip, throughput and errors, and say whether the cable is fit (exit code 1: it is not)
    Test(LinkTestArguments),
    /// Tell in words what was recorded with `--record`
    Log {
        /// The recording
        file: PathBuf,
        /// Image of the program that ran, from `technol build`: watched values then have their names
        #[arg(long, value_name = "IMAGE")]
        program: Option<PathBuf>,
    },
}

/// `technol link test`
#[derive(Debug, Args)]
pub(crate) struct LinkTestArguments {
    /// Where the target is
    #[arg(long, value_name = "ADDRESS")]
    pub(crate) target: String,
    /// File with the token of a target on the network [default: TECHNOL_TOKEN]
    #[arg(long, value_name = "FILE")]
    pub(crate) token_file: Option<PathBuf>,
    /// How long to send
    #[arg(long, value_name = "N", default_value = "5", value_parser = clap::value_parser!(u32).range(1..=3600))]
    pub(crate) seconds: u32,
}

/// `technol files`
#[derive(Debug, Args)]
pub(crate) struct FilesArguments {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: FilesCommand,
    /// Where the target is
    #[arg(long, value_name = "ADDRESS", global = true, default_value = "tcp:127.0.0.1:5700")]
    pub(crate) target: String,
    /// File with the token of a target on the network [default: TECHNOL_TOKEN]
    #[arg(long, value_name = "FILE", global = true)]
    pub(crate) token_file: Option<PathBuf>,
}

/// What to do with files. Paths at the target are relative to the folder it offers, with `/`.
#[derive(Debug, Subcommand)]
pub(crate) enum FilesCommand {
    /// List a folder
    Ls {
        /// The folder
        #[arg(default_value = "")]
        path: String,
    },
    /// Fetch a file
    Get {
        /// The file at the target
        from: String,
        /// Where to put it [default: its name, here]
        to: Option<PathBuf>,
    },
    /// Send a file, in place of an old one
    Put {
        /// The file here
        from: PathBuf,
        /// Its path at the target; with `/` at the end: the folder [default: its name]
        to: Option<String>,
    },
    /// Copy a file at the target
    Cp {
        /// The file
        from: String,
        /// The new one
        to: String,
    },
    /// Move a file or folder at the target
    Mv {
        /// What
        from: String,
        /// Where to
        to: String,
    },
    /// Delete a file or an empty folder
    Rm {
        /// What
        path: String,
    },
    /// Make a folder
    Mkdir {
        /// The folder
        path: String,
    },
}

/// Clock of a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ClockName {
    /// A cycle takes 20 ms.
    Real,
    /// Cycles run as fast as they can.
    Virtual,
}

/// `technol dap`
#[derive(Debug, Args)]
pub(crate) struct DapArguments {
    /// Listen for editors instead of using stdio
    #[arg(long, value_name = "tcp:HOST:PORT")]
    pub(crate) listen: Option<String>,
    /// Record what goes over the links to targets; `technol link log` reads it
    #[arg(long, value_name = "FILE")]
    pub(crate) record: Option<PathBuf>,
}

/// `technol lsp`
#[derive(Debug, Args)]
pub(crate) struct LspArguments {
    /// Talk over stdio: the only way there is; many editors say it all the same
    #[arg(long)]
    pub(crate) stdio: bool,
}

/// `technol fmt`
#[derive(Debug, Args)]
pub(crate) struct FmtArguments {
    /// Project folder, technol.toml, or single source files
    #[arg(default_value = ".")]
    pub(crate) paths: Vec<PathBuf>,
    /// Encoding the files are written in
    #[arg(long, value_enum)]
    pub(crate) encoding: EncodingName,
    /// Encoding the files have [default: as the project says, else detected]
    #[arg(long, value_enum, value_name = "ENCODING")]
    pub(crate) from: Option<EncodingName>,
    /// Change nothing; exit 1 when a file has another encoding
    #[arg(long)]
    pub(crate) check: bool,
}

/// Encoding of source files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum EncodingName {
    /// UTF-8.
    #[value(name = "utf-8")]
    Utf8,
    /// Windows-1250.
    #[value(name = "windows-1250")]
    Windows1250,
    /// CP852, DOS Latin 2.
    #[value(name = "cp852")]
    Cp852,
}

/// `technol explain`
#[derive(Debug, Args)]
pub(crate) struct ExplainArguments {
    /// Instruction, keyword, symbol of the control, or code such as T0301
    #[arg(required_unless_present_any = ["list", "search"], conflicts_with_all = ["list", "search"])]
    pub(crate) name: Option<String>,
    /// List everything there is a page for
    #[arg(long, conflicts_with = "search")]
    pub(crate) list: bool,
    /// List the pages that hold all of these words
    #[arg(long, value_name = "WORDS")]
    pub(crate) search: Option<String>,
    /// Language of the page
    #[arg(long, value_enum, default_value = "en")]
    pub(crate) language: Language,
}

/// `technol demo`
#[derive(Debug, Args)]
pub(crate) struct DemoArguments {
    /// Another copy of the lathe example [default: the one this binary was built with]
    pub(crate) path: Option<PathBuf>,
    /// Keep PLC_MEM_BACKUP in this file (default: what `[keep]` of the machine file names)
    #[arg(long, value_name = "FILE")]
    pub(crate) backup: Option<PathBuf>,
}
