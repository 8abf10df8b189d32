//! Examples of the help check clean inside a complete program.

use std::fmt::Write as _;

use technol_analysis::catalogue::entries;

use super::program::{Program, check, project, shown};

#[test]
fn every_example_of_the_help_checks_clean_where_it_belongs() {
    let mut report = String::new();
    let mut count = 0;
    for entry in entries() {
        for example in entry.examples {
            let text = Program::of(example.code).with_plant().text();
            let found = check(&project(&text));
            count += 1;
            if !found.is_empty() {
                let found = shown(&text, &found);
                writeln!(report, "{}:\n{found}{}", entry.name, example.code).expect("a String");
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
    assert!(count >= 270, "only {count} examples");
}

#[test]
fn the_plant_of_the_help_checks_clean() {
    let text = Program::default().with_plant().text();
    let found = check(&project(&text));
    assert!(found.is_empty(), "{}", shown(&text, &found));
}
