//! Tasks of the project: `cargo xtask generate | test | bench | fuzz | package`.

mod fuzz;
mod generate;
mod run;
mod test;

use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask TASK

  generate [--check]  write the files derived from the catalogue (with --check: fail when one is stale)
  test                formatting, lints, all tests, stale generated files, the editors' tests
  bench               all benchmarks; docs/design/performance.md says how to read them
  fuzz [TARGET] [MINUTES]
                      looks for inputs that break something: front_end (the default), image, machine, scenario;
                      30 minutes; needs cargo-fuzz
  package             the VS Code extension as a .vsix
";

/// All benchmarks; without naming them cargo would also run the unit tests as such.
const BENCHMARKS: &[&str] = &[
    "bench",
    "--package=technol-analysis",
    "--package=technol-runtime",
    "--bench=parse",
    "--bench=check",
    "--bench=latency",
    "--bench=build",
    "--bench=cycle",
    "--bench=against_c",
];

/// The lathe through a million cycles, several times: same inputs, same result.
const SAME_AGAIN: &[&str] =
    &["test", "--release", "--package=technol-tests", "--test=controller", "same_again", "--", "--nocapture"];

/// Frames through the simulated cable for each kind of fault, and a long session of an editor over it.
const MANY_FRAMES: &[&str] = &["test", "--release", "--package=technol-wire", "--test=link", "million"];
const LONG_SESSION: &[&str] = &["test", "--release", "--package=technol-tests", "--test=link", "session"];

/// Programs whose operations mean something else, in each way that is known; a test has to notice each.
const MUTANTS: &[&str] = &["test", "--release", "--package=technol-tests", "--test=chain", "coverage"];

fn bench() -> Result<(), String> {
    run::cargo("benchmarks", BENCHMARKS)?;
    for (what, arguments) in [("a million frames", MANY_FRAMES), ("a long session", LONG_SESSION)] {
        let mut link = run::command(arguments);
        run::step(&format!("{what} over a bad cable"), link.env("TECHNOL_FRAMES", "1000000"))?;
    }
    let mut lathe = run::command(SAME_AGAIN);
    run::step("a million cycles of the lathe", lathe.env("TECHNOL_CYCLES", "1000000"))?;
    let mut mutants = run::command(MUTANTS);
    run::step("operations that mean something else", mutants.env("TECHNOL_MUTANTS", "all"))
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match words.as_slice() {
        ["generate"] => generate::generate(false),
        ["generate", "--check"] => generate::generate(true),
        ["test"] => test::test(),
        ["bench"] => bench(),
        ["fuzz", words @ ..] => fuzz::fuzz(words),
        ["package"] => test::package(),
        _ => {
            eprint!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}
