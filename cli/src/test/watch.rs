//! Running tests again whenever a file changes.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

/// How often the files are looked at.
const PERIOD: Duration = Duration::from_millis(250);

/// What tells one content of a file from another; nothing for one that is not there.
type Print = Option<(SystemTime, u64)>;

/// Files, each as it was before it was read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Look {
    prints: BTreeMap<PathBuf, Print>,
}

impl Look {
    /// The files as they are now.
    pub(super) fn at(files: impl IntoIterator<Item = PathBuf>) -> Look {
        let mut look = Look::default();
        files.into_iter().for_each(|file| look.add(file));
        look
    }

    /// One more file as it is now; one that is there already stays as it was.
    pub(super) fn add(&mut self, file: PathBuf) {
        let print = |file: &PathBuf| {
            let data = std::fs::metadata(file).ok()?;
            Some((data.modified().ok()?, data.len()))
        };
        self.prints.entry(file).or_insert_with_key(print);
    }

    /// Adds the files of another look, as they were there.
    pub(super) fn join(&mut self, other: &Look) {
        for (file, print) in &other.prints {
            self.prints.entry(file.clone()).or_insert(*print);
        }
    }

    pub(super) fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.prints.keys()
    }
}

/// Waits until `now` gives another look than `before`, and then until it stays the same: editors write in several steps.
pub(super) fn wait_for_change(before: &Look, now: impl Fn() -> Look) {
    let mut last = loop {
        std::thread::sleep(PERIOD);
        let look = now();
        if look != *before {
            break look;
        }
    };
    loop {
        std::thread::sleep(PERIOD / 5);
        let look = now();
        if look == last {
            return;
        }
        last = look;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn new_changed_and_vanished_files_are_another_look() {
        let folder = std::env::temp_dir().join(format!("technol-watch-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("a.test.toml");
        let look = || Look::at([file.clone()]);
        let none = look();
        std::fs::write(&file, "a").unwrap();
        let short = look();
        assert_ne!(none, short);
        assert_eq!(short, look());
        std::fs::write(&file, "ab").unwrap();
        assert_ne!(short, look());
        let mut early = Look::default();
        early.join(&short);
        early.add(file.clone());
        assert_eq!(early, short, "what it was before it was read counts");
        assert_eq!(early.files().collect::<Vec<_>>(), [&file]);
        std::fs::remove_dir_all(&folder).unwrap();
        assert_eq!(none, look());
    }
}
