//! An input: a project as one text.
//!
//! The first line may be `;edit F A B`: in the F-th file the text between A and B, in thousandths of its length, goes
//! and comes back. Each line `;=== name.ext` begins another file; what stands before the first one is `main.plc`. All
//! of it may be any bytes.

use std::collections::BTreeMap;

use technol_analysis::project::FileReader;

/// Begins the line that names the next file.
pub(crate) const FILE: &[u8] = b";=== ";
/// Begins the line about the edit.
pub(crate) const EDIT: &[u8] = b";edit ";

/// Files by their path.
#[derive(Default)]
pub(crate) struct Input {
    pub(crate) files: BTreeMap<String, Vec<u8>>,
    pub(crate) edit: Edit,
}

/// What is edited: a file by its number, and the part of its text in thousandths.
#[derive(Clone, Copy, Default)]
pub(crate) struct Edit {
    pub(crate) file: usize,
    pub(crate) from: usize,
    pub(crate) to: usize,
}

impl Input {
    pub(crate) fn of(bytes: &[u8]) -> Input {
        let mut input = Input::default();
        let mut name = "main.plc".to_string();
        for (number, line) in bytes.split_inclusive(|byte| *byte == b'\n').enumerate() {
            if let Some(rest) = line.strip_prefix(FILE) {
                name = String::from_utf8_lossy(rest).trim().to_string();
                input.files.entry(name.clone()).or_default();
            } else if number == 0 && line.starts_with(EDIT) {
                input.edit = edit(&line[EDIT.len()..]);
            } else {
                input.files.entry(name.clone()).or_default().extend_from_slice(line);
            }
        }
        input
    }

    /// What to hand to `load`.
    pub(crate) fn root(&self) -> &'static str {
        if self.files.contains_key("technol.toml") { "" } else { "main.plc" }
    }
}

fn edit(line: &[u8]) -> Edit {
    let line = String::from_utf8_lossy(line);
    let mut numbers = line.split_whitespace().map(|word| word.parse::<usize>().unwrap_or(0));
    let mut next = || numbers.next().unwrap_or(0);
    Edit { file: next(), from: next().min(1000), to: next().min(1000) }
}

impl FileReader for Input {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.files.get(path).cloned().ok_or_else(|| "no such file".to_string())
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let inside = |path: &String| {
            let (at, name) = path.rsplit_once('/').unwrap_or(("", path));
            (at == folder).then(|| name.to_string())
        };
        self.files.keys().filter_map(inside).collect()
    }
}
