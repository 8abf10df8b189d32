//! Running tests again whenever a file changes.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

/// How often the files are looked at.
const PERIOD: Duration = Duration::from_millis(250);

/// What tells one content of a file from another; nothing for one that is not there.
type Print = Option<(SystemTime, u64)>;

/// Files as they were at one moment.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Look {
    prints: BTreeMap<PathBuf, Print>,
}

impl Look {
    pub(super) fn at(files: impl IntoIterator<Item = PathBuf>) -> Look {
        let print = |file: &PathBuf| {
            let data = std::fs::metadata(file).ok()?;
            Some((data.modified().ok()?, data.len()))
        };
        Look { prints: files.into_iter().map(|file| (file.clone(), print(&file))).collect() }
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
        std::fs::remove_dir_all(&folder).unwrap();
        assert_eq!(none, look());
    }
}
