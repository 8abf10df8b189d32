//! Complete programs that use each idiom of the language, chapter by chapter.
//!
//! A project is `NAME.plc` with every other file `NAME.*` beside it. Each must be clean, or give exactly the findings
//! that its markers name (see `markers`).

mod markers;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::Path;

use markers::{check, difference, read};
use technol_analysis::catalogue::{self, EntryKind};

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

/// Words of a line of code that can be its instruction: the first one behind a label, and the one behind a name.
fn instructions(line: &str) -> impl Iterator<Item = String> {
    let code = line.split(';').next().unwrap_or_default();
    let behind_label = code
        .split_once(':')
        .map_or(code, |(label, rest)| if label.trim().contains([' ', '\'']) { code } else { rest });
    behind_label.split_whitespace().take(2).map(str::to_ascii_uppercase)
}

/// All words of a line of code.
fn words(line: &str) -> impl Iterator<Item = String> {
    let code = line.split(';').next().unwrap_or_default();
    code.split(|c: char| !(c.is_alphanumeric() || c == '_')).map(str::to_ascii_uppercase)
}

#[test]
fn every_instruction_occurs_in_a_program() {
    let code = |name: &str| Path::new(name).extension().is_some_and(|end| end == "plc" || end == "inc");
    let (mut used, mut named) = (BTreeSet::new(), BTreeSet::new());
    for (_, text) in projects().into_values().flatten().filter(|(name, _)| code(name)) {
        for line in text.lines() {
            used.extend(instructions(line));
            named.extend(words(line));
        }
    }
    let stands_alone = |entry: &catalogue::Entry| {
        !matches!(entry.kind, EntryKind::TypePrefix | EntryKind::Keyword | EntryKind::EventProcedure)
    };
    let missing: Vec<&str> = catalogue::entries()
        .filter(|entry| !entry.is_known_only())
        .filter(|entry| !if stands_alone(entry) { &used } else { &named }.contains(entry.name))
        .map(|entry| entry.name)
        .collect();
    assert!(missing.is_empty(), "no program uses {missing:?}");
}
