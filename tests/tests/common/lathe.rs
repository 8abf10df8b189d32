//! A copy of the lathe of `examples/` that a test may build in and change.

use std::path::{Path, PathBuf};

use tempfile::TempDir;

/// The copy; it goes away with this.
pub(crate) struct Lathe {
    folder: TempDir,
}

impl Lathe {
    pub(crate) fn copy() -> Lathe {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let example = crate::binary::root().join("examples").join("lathe");
        copy(&example, folder.path());
        Lathe { folder }
    }

    /// Folder of the project, as the file system spells it.
    pub(crate) fn folder(&self) -> PathBuf {
        self.folder.path().canonicalize().expect("the copy is there")
    }

    pub(crate) fn path(&self, file: &str) -> String {
        self.folder().join(file).to_string_lossy().into_owned()
    }

    fn text(&self, file: &str) -> String {
        std::fs::read_to_string(self.folder().join(file)).expect("a file of the lathe")
    }

    /// 1-based number of the only line that holds a text.
    pub(crate) fn line(&self, file: &str, text: &str) -> u32 {
        let source = self.text(file);
        let mut found = source.lines().zip(1..).filter(|(line, _)| line.contains(text)).map(|(_, n)| n);
        let first = found.next().unwrap_or_else(|| panic!("{file} does not hold `{text}`"));
        assert_eq!(found.next(), None, "`{text}` stands more than once in {file}");
        first
    }

    /// Replaces the first occurrence of a text.
    pub(crate) fn edit(&self, file: &str, old: &str, new: &str) {
        let source = self.text(file);
        assert!(source.contains(old), "{file} does not hold `{old}`");
        std::fs::write(self.folder().join(file), source.replacen(old, new, 1)).expect("the copy is writable");
    }
}

/// Copies a folder without what was built in it.
fn copy(from: &Path, to: &Path) {
    for entry in std::fs::read_dir(from).expect("the example is there") {
        let entry = entry.expect("an entry");
        let target = to.join(entry.file_name());
        if entry.path().is_file() {
            std::fs::copy(entry.path(), target).expect("a file is copied");
        } else if entry.file_name() != "out" {
            std::fs::create_dir(&target).expect("a folder is made");
            copy(&entry.path(), &target);
        }
    }
}
