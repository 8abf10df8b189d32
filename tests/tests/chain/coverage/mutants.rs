//! Runs the tests of this program in processes of their own.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::path::Path;
use std::process::{Command, Output};
use std::{env, fs, thread};

use super::record::{FOLDER, MUTANTS, Meeting, NOT_LOADED, NOTICED};

fn tests(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env::current_exe().expect("this program"));
    command.args(arguments).env(FOLDER, folder);
    command
}

/// Runs all tests but those of coverage, which writes down what they load.
pub(super) fn record(folder: &Path) {
    // On the main thread a test has no name.
    let output =
        tests(folder, &["--skip", "coverage::", "--test-threads", &threads().max(2).to_string()]).output();
    let Output { status, stdout, .. } = output.expect("it starts");
    assert!(status.success(), "{}", String::from_utf8_lossy(&stdout));
}

/// Names of the tests of this program.
pub(super) fn names() -> BTreeSet<String> {
    let output = Command::new(env::current_exe().expect("this program")).arg("--list").output();
    let listed = String::from_utf8(output.expect("it starts").stdout).expect("names are letters");
    listed.lines().filter_map(|line| line.strip_suffix(": test")).map(str::to_owned).collect()
}

fn threads() -> usize {
    thread::available_parallelism().map_or(1, Into::into)
}

/// Mutants that no test tells from the program.
pub(super) fn survivors(folder: &Path, mutants: Vec<Open<'_>>) -> BTreeSet<String> {
    let mut survivors = BTreeSet::new();
    let mut open = mutants;
    while !open.is_empty() {
        let rounds = next_rounds(&mut open);
        let noticed: BTreeSet<String> = thread::scope(|scope| {
            let runs: Vec<_> = (0..)
                .zip(&rounds)
                .map(|(number, round)| scope.spawn(move || noticed(folder, number, round)))
                .collect();
            runs.into_iter().flat_map(|run| run.join().expect("the tests ran")).collect()
        });
        open.retain(|mutant| !noticed.contains(mutant.names[0]));
        let (given_up, rest) = open.into_iter().partition(|mutant: &Open<'_>| mutant.tests.is_empty());
        open = rest;
        survivors.extend(given_up.into_iter().flat_map(|mutant: Open<'_>| mutant.names).cloned());
    }
    survivors
}

/// A mutant that no test has noticed so far.
pub(super) struct Open<'a> {
    /// Its names: uses on the same lines are one mutant.
    names: Vec<&'a String>,
    /// Tests that were not tried yet.
    tests: VecDeque<&'a Meeting>,
}

impl<'a> Open<'a> {
    /// A mutant of the programs that these tests load.
    pub(super) fn new(names: Vec<&'a String>, tests: &'a [Meeting]) -> Open<'a> {
        Open { names, tests: tests.iter().collect() }
    }
}

/// The tests of a process, each with the mutants that it meets.
type Round<'a> = BTreeMap<&'a str, Vec<&'a str>>;

/// Each mutant meets a test in one of the processes. A test that is no table can meet one only.
fn next_rounds<'a>(open: &mut [Open<'a>]) -> Vec<Round<'a>> {
    let mut rounds = vec![Round::new(); threads()];
    let mut taken: Vec<BTreeSet<&str>> = vec![BTreeSet::new(); rounds.len()];
    for (number, mutant) in open.iter_mut().enumerate() {
        let process = number % rounds.len();
        let (round, taken) = (&mut rounds[process], &mut taken[process]);
        let free = |meeting: &&Meeting| {
            if meeting.single { !round.contains_key(&*meeting.test) } else { !taken.contains(&*meeting.test) }
        };
        let Some(at) = mutant.tests.iter().position(free) else { continue };
        let Some(meeting) = mutant.tests.remove(at) else { continue };
        if meeting.single {
            taken.insert(&meeting.test);
        }
        round.entry(&meeting.test).or_default().push(mutant.names[0]);
    }
    rounds.retain(|round| !round.is_empty());
    rounds
}

/// The mutants that were noticed: their tests failed, or rows of tables did.
fn noticed(folder: &Path, process: usize, round: &Round<'_>) -> BTreeSet<String> {
    let (plan, rows) = (folder.join(format!("plan-{process}")), folder.join(format!("noticed-{process}")));
    let mutants =
        round.iter().flat_map(|(test, mutants)| mutants.iter().map(move |it| format!("{test}={it}\n")));
    fs::write(&plan, mutants.collect::<String>()).expect("a file");
    fs::write(&rows, "").expect("a file");
    let mut arguments = vec!["--exact", "--test-threads", "2"];
    arguments.extend(round.keys());
    let mut command = tests(folder, &arguments);
    command.env(MUTANTS, plan).env(NOTICED, &rows).env("RUST_BACKTRACE", "0");
    let output = command.output().expect("it starts");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("test result:"), "the tests broke off:\n{text}");
    let mut noticed: BTreeSet<String> =
        fs::read_to_string(rows).expect("a file").lines().map(str::to_owned).collect();
    for test in text.lines().filter_map(|line| line.strip_prefix("test ")?.strip_suffix(" ... FAILED")) {
        if let Some([mutant]) = round.get(test).map(Vec::as_slice)
            && !said(&text, test).contains(NOT_LOADED)
        {
            noticed.insert((*mutant).to_owned());
        }
    }
    noticed
}

/// What a failed test said.
fn said<'a>(output: &'a str, test: &str) -> &'a str {
    let Some((_, said)) = output.split_once(&format!("---- {test} stdout ----")) else { return "" };
    said.split("\n---- ").next().unwrap_or_default()
}
