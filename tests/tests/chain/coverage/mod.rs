//! Every entry of the catalogue, and every way to write its operands, is tested at run time: where the lines
//! that use it do nothing, a test fails.
//!
//! The tests of this file's neighbours run once more in a process of their own that writes down the programs they
//! load. From them follows which test uses what of the catalogue. Then, for each use, tests that have it run with
//! those lines left out of the program, until one of them fails. Nobody fools that by mentioning a mnemonic: a line
//! that is not executed, or whose effect nobody looks at, makes no test fail.

mod exempt;
mod mutants;
mod record;
mod required;
mod uses;

use std::collections::BTreeSet;

pub(crate) use record::{concerns, left_out, loaded, recorded};

#[test]
fn every_entry_of_the_catalogue_has_a_test_that_fails_without_it() {
    let folder = tempfile::tempdir().expect("a folder");
    mutants::record(folder.path());
    let required = required::required();
    let survivors = mutants::survivors(folder.path(), &required, &record::recorded_uses(folder.path()));
    let expected: BTreeSet<&str> = exempt::EXEMPT.iter().flat_map(|(uses, ..)| *uses).copied().collect();
    let untested: Vec<&str> =
        survivors.iter().map(String::as_str).filter(|using| !expected.contains(using)).collect();
    let stale: Vec<&str> = expected.iter().copied().filter(|using| !survivors.contains(*using)).collect();
    assert!(
        untested.is_empty() && stale.is_empty(),
        "{} of {} uses have no test that fails when the lines with them do nothing:\n{}\n\
         {} exceptions are tested, or are no uses:\n{}",
        untested.len(),
        required.len(),
        untested.join("\n"),
        stale.len(),
        stale.join("\n")
    );
}

#[test]
fn every_exception_names_a_test() {
    let known = mutants::names();
    for (uses, why, test) in exempt::EXEMPT {
        assert!(known.contains(*test), "{uses:?} ({why}): there is no test {test}");
    }
}
