//! Runs the tests of this program in processes of their own.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::path::Path;
use std::process::{Command, Output};
use std::{env, fs, thread};

use super::record::{FOLDER, NOT_LOADED, Places, Recorded, WITHOUT, file_name};

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

/// The uses for which no test fails when the lines with them are left out.
pub(super) fn survivors(
    folder: &Path,
    required: &BTreeSet<String>,
    recorded: &BTreeMap<String, Recorded>,
) -> BTreeSet<String> {
    let (known, mut survivors): (Vec<_>, BTreeSet<_>) = partition(required, recorded);
    // Uses on the same lines share their answer.
    let mut groups: BTreeMap<&Places, Vec<&String>> = BTreeMap::new();
    for using in known {
        groups.entry(&recorded[using].places).or_default().push(using);
    }
    let mut open: Vec<Open<'_>> = groups
        .into_values()
        .map(|uses| Open { tests: recorded[uses[0]].tests.iter().collect(), uses })
        .collect();
    while !open.is_empty() {
        let round = next_round(&mut open);
        let noticed = failed(folder, &round);
        open.retain(|group| !noticed.contains(group.uses[0]));
        let (given_up, rest) = open.into_iter().partition(|group: &Open<'_>| group.tests.is_empty());
        open = rest;
        survivors.extend(given_up.into_iter().flat_map(|group: Open<'_>| group.uses).cloned());
    }
    survivors
}

/// Uses on the same lines that no test has noticed so far.
struct Open<'a> {
    uses: Vec<&'a String>,
    /// Tests that were not tried yet.
    tests: VecDeque<&'a String>,
}

/// For each test at most one use to leave out.
fn next_round<'a>(open: &mut [Open<'a>]) -> BTreeMap<&'a str, &'a str> {
    let mut round = BTreeMap::new();
    for group in open {
        if let Some(at) = group.tests.iter().position(|test| !round.contains_key(test.as_str()))
            && let Some(test) = group.tests.remove(at)
        {
            round.insert(test.as_str(), group.uses[0].as_str());
        }
    }
    round
}

/// The uses that were noticed: their tests failed.
fn failed(folder: &Path, round: &BTreeMap<&str, &str>) -> BTreeSet<String> {
    let without: Vec<String> = round.iter().map(|(test, using)| format!("{test}={using}")).collect();
    let threads = threads().max(2).to_string();
    let mut arguments = vec!["--exact", "--test-threads", &threads];
    arguments.extend(round.keys());
    let mut command = tests(folder, &arguments);
    let output =
        command.env(WITHOUT, without.join("\n")).env("RUST_BACKTRACE", "0").output().expect("it starts");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("test result:"), "the tests broke off:\n{text}");
    let failed = text.lines().filter_map(|line| line.strip_prefix("test ")?.strip_suffix(" ... FAILED"));
    let not_loaded = folder.join(NOT_LOADED);
    failed
        .filter(|test| fs::remove_file(not_loaded.join(file_name(test))).is_err())
        .filter_map(|test| round.get(test))
        .map(|using| (*using).to_owned())
        .collect()
}

/// Those that a program has, and those that none has.
fn partition<'a>(
    required: &'a BTreeSet<String>,
    recorded: &BTreeMap<String, Recorded>,
) -> (Vec<&'a String>, BTreeSet<String>) {
    let (known, unknown): (Vec<_>, Vec<_>) = required.iter().partition(|using| recorded.contains_key(*using));
    (known, unknown.into_iter().cloned().collect())
}
