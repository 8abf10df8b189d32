//! Texts to begin with: fixtures, examples, and the pages of the rules.

use std::path::{Path, PathBuf};

use technol_analysis::diagnostics::RULES;

use super::completed::project_of;

/// Every seed, always in the same order.
pub(crate) fn all() -> Vec<Vec<u8>> {
    let mut seeds = Vec::new();
    for folder in ["analysis/tests/fixtures", "analysis/tests/fixtures/frame", "examples/minimal"] {
        seeds.extend(files(folder).into_iter().map(|(_, text)| text));
    }
    for (name, text) in files("examples/lathe") {
        let own = if name == "main.plc" || name == "technol.toml" { name } else { format!("x{name}") };
        seeds.push([format!(";=== {own}\n").into_bytes(), text].concat());
    }
    for rule in RULES {
        for text in [rule.wrong, rule.right] {
            let project = project_of(text);
            let whole =
                project.iter().flat_map(|(name, text)| [";=== ", name, "\n", text]).collect::<String>();
            seeds.push(format!(";edit 0 400 700\n{whole}").into_bytes());
        }
    }
    seeds
}

fn root() -> PathBuf {
    // The fuzzer's crate and this one are neighbours.
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Name and content of the files of a folder of the repository, by their names.
fn files(folder: &str) -> Vec<(String, Vec<u8>)> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap_or_else(|e| panic!("{folder}: {e}"));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.is_file());
    paths.sort();
    paths
        .into_iter()
        .map(|path| {
            let text = std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            (path.file_name().unwrap_or_default().to_string_lossy().into_owned(), text)
        })
        .collect()
}
