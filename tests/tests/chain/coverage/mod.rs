//! Every entry of the catalogue, and every way to write its operands, is tested at run time, and so that another
//! meaning would be noticed.
//!
//! The tests of this file's neighbours run once more in a process of their own that writes down the programs they
//! load. From them follows which test uses what of the catalogue. Then mutants of these programs are made, and tests
//! that load them run until one fails:
//!
//! - For each use, the lines that have it do nothing. Nobody fools that by mentioning a mnemonic: a line that is not
//!   executed, or whose effect nobody looks at, makes no test fail.
//! - For each operation that the lines were made into, its [alterations](altered).

mod altered;
mod exempt;
mod mutants;
mod record;
mod required;
mod uses;

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::path::Path;

use mutants::Open;
use record::{Meeting, Places};

pub(crate) use record::{loaded, mutated, recorded, with_mutants, wrong_rows};

#[test]
fn the_tests_notice_what_is_left_out_and_what_means_something_else() {
    let folder = tempfile::tempdir().expect("a folder");
    mutants::record(folder.path());
    let wrong = [unexpected_of_uses(folder.path()), unexpected_of_alterations(folder.path())].concat();
    assert!(wrong.is_empty(), "{wrong}");
}

/// Every entry of the catalogue, and every way to write its operands.
fn unexpected_of_uses(folder: &Path) -> String {
    let required = required::required();
    let recorded = record::recorded_uses(folder);
    let (known, unknown): (Vec<_>, Vec<_>) = required.iter().partition(|using| recorded.contains_key(*using));
    // Uses on the same lines share their answer.
    let mut groups: BTreeMap<&Places, Vec<&String>> = BTreeMap::new();
    for using in known {
        groups.entry(&recorded[using].places).or_default().push(using);
    }
    let expected = exempt::EXEMPT.iter().flat_map(|(uses, ..)| *uses).copied().collect();
    let open = groups.into_values().map(|uses| {
        let tests = tried(uses[0], &recorded[uses[0]].tests, &expected);
        Open::new(uses, tests)
    });
    let mut survivors = mutants::survivors(folder, open.collect());
    survivors.extend(unknown.into_iter().cloned());
    unexpected("uses", required.len(), &survivors, &expected)
}

/// Every operation that the lines of the tests were made into: all alterations with `TECHNOL_MUTANTS=all`, and otherwise a
/// third of them, always the same.
fn unexpected_of_alterations(folder: &Path) -> String {
    let all = env::var("TECHNOL_MUTANTS").is_ok_and(|asked| asked == "all");
    let chosen = |alteration: &str| all || record::hash(alteration).is_multiple_of(3);
    let mut recorded = record::recorded_alterations(folder);
    recorded.retain(|alteration, _| chosen(alteration));
    let expected = altered::EXEMPT.iter().flat_map(|(alterations, _)| *alterations).copied();
    let expected = expected.filter(|alteration| chosen(alteration)).collect();
    let open = recorded
        .iter()
        .map(|(alteration, of)| Open::new(vec![alteration], tried(alteration, &of.tests, &expected)));
    let survivors = mutants::survivors(folder, open.collect());
    unexpected("other meanings", recorded.len(), &survivors, &expected)
}

/// The tests to try: of an exception only so many, as they all would have to run.
fn tried<'a>(mutant: &str, tests: &'a [Meeting], expected: &BTreeSet<&str>) -> &'a [Meeting] {
    const OF_AN_EXCEPTION: usize = 20;
    if expected.contains(mutant) { &tests[..tests.len().min(OF_AN_EXCEPTION)] } else { tests }
}

/// Those that no test notices are the exceptions.
fn unexpected(what: &str, count: usize, survivors: &BTreeSet<String>, expected: &BTreeSet<&str>) -> String {
    let untested: Vec<&str> =
        survivors.iter().map(String::as_str).filter(|mutant| !expected.contains(mutant)).collect();
    let stale: Vec<&str> = expected.iter().copied().filter(|mutant| !survivors.contains(*mutant)).collect();
    if untested.is_empty() && stale.is_empty() {
        return String::new();
    }
    format!(
        "no test fails for {} of {count} {what}:\n{}\n{} exceptions are noticed, or are none:\n{}\n",
        untested.len(),
        untested.join("\n"),
        stale.len(),
        stale.join("\n")
    )
}

#[test]
fn every_exception_names_a_test() {
    let known = mutants::names();
    for (uses, why, test) in exempt::EXEMPT {
        assert!(known.contains(*test), "{uses:?} ({why}): there is no test {test}");
    }
}
