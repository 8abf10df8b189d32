//! Runs the tests of this program in processes of their own.

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::Mutex;
use std::thread;

use super::record::{FOLDER, NOT_LOADED, Places, Recorded, WITHOUT};

/// Tests tried one by one before the rest is tried together.
const ONE_BY_ONE: usize = 3;

fn tests(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env::current_exe().expect("this program"));
    command.args(arguments).env(FOLDER, folder);
    command
}

/// Runs all tests but those of coverage, which writes down what they load.
pub(super) fn record(folder: &Path) {
    // On the main thread a test has no name.
    let output = tests(folder, &["--skip", "coverage::", "--test-threads", &threads().max(2).to_string()]).output();
    let Output { status, stdout, .. } = output.expect("it starts");
    assert!(status.success(), "{}", String::from_utf8_lossy(&stdout));
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
    let queue = Mutex::new(groups.into_values());
    let found = Mutex::new(Vec::new());
    thread::scope(|scope| {
        for _ in 0..threads() {
            scope.spawn(|| {
                loop {
                    let Some(group) = queue.lock().expect("no thread panics").next() else { return };
                    if !is_noticed(folder, group[0], &recorded[group[0]].tests) {
                        found.lock().expect("no thread panics").extend(group);
                    }
                }
            });
        }
    });
    survivors.extend(found.into_inner().expect("no thread panics").into_iter().cloned());
    survivors
}

/// Those that a program has, and those that none has.
fn partition<'a>(
    required: &'a BTreeSet<String>,
    recorded: &BTreeMap<String, Recorded>,
) -> (Vec<&'a String>, BTreeSet<String>) {
    let (known, unknown): (Vec<_>, Vec<_>) = required.iter().partition(|using| recorded.contains_key(*using));
    (known, unknown.into_iter().cloned().collect())
}

/// Whether one of the tests fails without the lines.
fn is_noticed(folder: &Path, using: &str, candidates: &[String]) -> bool {
    let (first, rest) = candidates.split_at(candidates.len().min(ONE_BY_ONE));
    let groups = first.iter().map(std::slice::from_ref).chain([rest]).filter(|group| !group.is_empty());
    groups.into_iter().any(|group| {
        let mut arguments = vec!["--exact", "--test-threads", "1"];
        arguments.extend(group.iter().map(String::as_str));
        let output =
            tests(folder, &arguments).env(WITHOUT, using).env("RUST_BACKTRACE", "0").output().expect("it starts");
        !output.status.success() && output.status.code() != Some(NOT_LOADED)
    })
}
