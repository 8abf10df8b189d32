//! `technol test`: unit tests of a PLC program in virtual time (docs/testing.md).

mod condition;
mod coverage;
mod discover;
mod execute;
mod fields;
#[cfg(any(test, feature = "fuzzing"))]
mod fixture;
mod history;
#[cfg(any(test, feature = "fuzzing"))]
pub mod hostile;
mod junit;
mod machines;
mod messages;
mod pool;
mod read;
mod report;
mod scenario;
mod state;
#[cfg(test)]
mod tests;
mod watch;

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Instant;

use technol_image::Image;

use crate::arguments::TestArguments;
use crate::exit::{self, Failure, Outcome};
use crate::files::Project;
use crate::out::say;
use crate::paint::Paint;
use condition::Names;
use coverage::Coverage;
use execute::{Bench, Verdict};
use machines::Machines;
use read::{Reader, ScenarioFile};
use scenario::Test;
use state::Mechanisms;
use watch::Look;

/// Runs the tests. Exit 0 when all pass; 1 when one fails or the program has errors; 2 for a broken scenario.
pub(crate) fn test(arguments: &TestArguments) -> Outcome {
    if !arguments.watch {
        return once(arguments, &mut Look::default());
    }
    loop {
        // Looked at before anything is read: what changes while the tests run is a change, too.
        let mut look = Look::at(dependencies(arguments));
        if let Err(failure) = once(arguments, &mut look) {
            eprintln!("technol: {failure}");
        }
        let number = crate::check::count(look.files().count() as u64, "file");
        say!("{}", Paint::stdout().dim(format!("waiting for a change of {number}; Ctrl-C ends")));
        watch::wait_for_change(&look, || {
            let scenarios = discover::project_of(&arguments.path).map(|found| scenario_files(&found));
            Look::at(look.files().cloned().chain(scenarios.unwrap_or_default()))
        });
        say!("");
    }
}

/// The files of the project and its scenario files, as far as they can be found.
fn dependencies(arguments: &TestArguments) -> Vec<PathBuf> {
    let Ok(found) = discover::project_of(&arguments.path) else { return Vec::new() };
    let project = Project::open(&found.project).map(|project| project.files().collect::<Vec<_>>());
    project.unwrap_or_default().into_iter().chain(scenario_files(&found)).collect()
}

/// One round. What the tests depend on is added to `look`.
fn once(arguments: &TestArguments, look: &mut Look) -> Outcome {
    let found = discover::project_of(&arguments.path)?;
    let project = Project::open(&found.project)?;
    let scenarios = scenario_files(&found);
    project.files().chain(scenarios.iter().cloned()).for_each(|file| look.add(file));
    crate::build::configuration_errors(&project)?;
    let built = crate::build::image(&project)?;
    let Image { program, debug } = built.image;
    let debug = debug.ok_or_else(|| Failure::usage("the build has no debug information"))?;
    let mechanisms = Mechanisms::new(&program, &debug, &|file| project.text(file));
    let mut machines = Machines::default();
    let names = Names { program: &program, debug: &debug, mechanisms: &mechanisms };
    let mut reader = Reader { names, machines: &mut machines, machine: project.machine() };
    let tests = read_all(&scenarios, &mut reader);
    look.join(machines.looked());
    let tests = tests?;
    if tests.is_empty() {
        return Err(Failure::usage(format!(
            "{}: no tests; they stand in files *.test.toml beside the program or in its folder tests (docs/testing.md)",
            arguments.path.display()
        )));
    }
    let all = tests.len();
    let chosen: Vec<Test> =
        tests.into_iter().filter(|test| is_chosen(test, arguments.filter.as_deref())).collect();
    if chosen.is_empty() {
        let filter = arguments.filter.as_deref().unwrap_or_default();
        return Err(Failure::usage(format!("--filter {filter}: none of the {all} tests is called so")));
    }
    // What a test changes in tables and backed-up memory ends with it.
    let (data, _) =
        crate::control_data::control_data(Some(&project.loaded), None, None).map_err(Failure::usage)?;
    let bench = Bench {
        program: &program,
        data: &data,
        debug: &debug,
        mechanisms: &mechanisms,
        machines: &machines,
        coverage: arguments.coverage.is_some(),
    };
    let verdicts = run(&project, &chosen, all, arguments.jobs, &bench);
    write_files(arguments, &project, &chosen, &verdicts, &bench)?;
    let failed = verdicts.iter().any(|verdict| verdict.failure.is_some());
    Ok(if failed { exit::ERRORS } else { exit::OK })
}

/// Scenario files of what was found.
fn scenario_files(found: &discover::Found) -> Vec<PathBuf> {
    if let Some(only) = &found.only {
        return vec![only.clone()];
    }
    let path = found.project.as_path();
    if path.is_dir() {
        return discover::scenarios(path, None);
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let program = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("plc"));
    let lone = path.file_stem().and_then(|stem| stem.to_str()).filter(|_| program);
    discover::scenarios(folder, lone)
}

/// Reads all scenario files; every mistake in any of them is printed.
fn read_all(files: &[PathBuf], reader: &mut Reader<'_>) -> Result<Vec<Test>, Failure> {
    let paint = Paint::stderr();
    let mut tests = Vec::new();
    let mut mistakes = 0_u64;
    for path in files {
        let shown = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|e| Failure::usage(format!("{shown}: {e}")))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        match reader.read(&ScenarioFile { shown: &shown, folder, text: &text }) {
            Ok(more) => tests.extend(more),
            Err(errors) => {
                for error in &errors {
                    let place = format!("{}:{}:{}", error.file, error.place.line, error.place.column);
                    eprintln!("{place}: {}: {}", paint.red("error"), error.message);
                    mistakes += 1;
                }
            }
        }
    }
    if mistakes == 0 {
        return Ok(tests);
    }
    Err(Failure::usage(format!(
        "no test was run: {} in scenario files",
        crate::check::count(mistakes, "mistake")
    )))
}

fn is_chosen(test: &Test, filter: Option<&str>) -> bool {
    let Some(filter) = filter else { return true };
    let filter = filter.to_lowercase();
    test.name.to_lowercase().contains(&filter) || discover::stem(&test.file).to_lowercase().contains(&filter)
}

/// Runs the chosen tests and tells about each.
fn run(
    project: &Project,
    tests: &[Test],
    all: usize,
    jobs: Option<NonZeroUsize>,
    bench: &Bench<'_>,
) -> Vec<Verdict> {
    let paint = Paint::stdout();
    let mut files: Vec<&str> = tests.iter().map(|test| test.file.as_str()).collect();
    files.dedup();
    say!("{}", report::title(&project.name(), tests.len(), files.len(), paint));
    let width = tests.iter().map(|test| test.name.chars().count()).max().unwrap_or(0);
    let start = Instant::now();
    let jobs = jobs.or_else(|| std::thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN);
    let mut file = String::new();
    let verdicts = pool::each(
        tests,
        jobs,
        |test| execute::execute(test, bench),
        |test, verdict| {
            if file != test.file {
                file.clone_from(&test.file);
                say!("{file}");
            }
            say!("{}", report::line(test, verdict, width, paint));
        },
    );
    for (test, verdict) in tests.iter().zip(&verdicts) {
        if let Some(failure) = &verdict.failure {
            say!("\n{}", report::failure(test, failure, paint).trim_end());
        }
    }
    say!("\n{}", report::summary(&verdicts, all - tests.len(), start.elapsed(), paint));
    verdicts
}

/// Writes what `--junit` and `--coverage` ask for.
fn write_files(
    arguments: &TestArguments,
    project: &Project,
    tests: &[Test],
    verdicts: &[Verdict],
    bench: &Bench<'_>,
) -> Result<(), Failure> {
    let write = |file: &Path, text: String| {
        std::fs::write(file, text).map_err(|e| Failure::usage(format!("{}: {e}", file.display())))
    };
    if let Some(file) = &arguments.junit {
        let results: Vec<_> = tests.iter().zip(verdicts).collect();
        write(file, junit::document(&project.name(), &results))?;
    }
    if let Some(file) = &arguments.coverage {
        let coverage = Coverage::of(verdicts, bench.program, bench.debug, bench.mechanisms);
        say!("\n{}", coverage.table(Paint::stdout()).trim_end());
        write(file, coverage.lcov(&|path| project.display(path).display().to_string()))?;
    }
    Ok(())
}
