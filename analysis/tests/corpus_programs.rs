//! Complete programs that use each idiom of the language, chapter by chapter.
//!
//! A project is `NAME.plc` with every other file `NAME.*` beside it. Each must be clean, or give exactly the findings
//! that its markers name (see `markers`).

mod markers;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::Path;

use markers::{check, difference, read};
use technol_analysis::catalogue;

/// File names and texts of each project, by the name of the project.
fn projects() -> BTreeMap<String, Vec<(String, String)>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus_programs");
    let mut projects: BTreeMap<String, Vec<(String, String)>> = BTreeMap::new();
    for entry in std::fs::read_dir(folder).expect("the folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let project = name.split('.').next().unwrap_or_default().to_string();
        projects.entry(project).or_default().push((name, read(&path)));
    }
    projects
}

#[test]
fn every_program_gives_exactly_the_marked_diagnostics() {
    let mut report = String::new();
    let projects = projects();
    for (name, files) in &projects {
        let settings = format!("[project]\nname = \"{name}\"\nmain = \"{name}.plc\"\nencoding = \"utf-8\"\n");
        let mut all = vec![("technol.toml", settings.as_str())];
        all.extend(files.iter().map(|(file, text)| (file.as_str(), text.as_str())));
        let found = check(&all, "");
        let nothing = Vec::new();
        for (file, text) in &all {
            let found = found.iter().find(|(path, _)| path == file).map_or(&nothing, |(_, found)| found);
            let difference = difference(text, found);
            if !difference.is_empty() {
                writeln!(report, "{file}:\n{difference}").expect("a String");
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
    assert!(projects.len() >= 15, "only {} projects", projects.len());
}

#[test]
fn every_instruction_occurs_in_a_program() {
    let mut words = BTreeSet::new();
    for (_, text) in projects().into_values().flatten() {
        for line in text.lines() {
            let code = line.split(';').next().unwrap_or_default();
            words.extend(
                code.split(|c: char| !(c.is_alphanumeric() || c == '_')).map(str::to_ascii_uppercase),
            );
        }
    }
    let missing: Vec<&str> = catalogue::entries()
        .filter(|entry| !entry.is_known_only() && !words.contains(entry.name))
        .map(|entry| entry.name)
        .collect();
    assert!(missing.is_empty(), "no program uses {missing:?}");
}
