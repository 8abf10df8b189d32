//! One name per file, however its address is spelled.

use std::path::PathBuf;

use tower_lsp::ls_types::Uri;

/// A file's absolute path with `/`, or, for a text that is no file (a new one), its whole address.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct FileKey(String);

impl FileKey {
    /// The key of an address.
    pub(crate) fn of_uri(uri: &Uri) -> FileKey {
        let path = uri.scheme().as_str().eq_ignore_ascii_case("file").then(|| uri.to_file_path()).flatten();
        path.map_or_else(
            || FileKey(uri.as_str().to_owned()),
            |path| FileKey::of_path(&path.to_string_lossy()),
        )
    }

    /// The key of an absolute path, `.` and `..` resolved by their letters.
    pub(crate) fn of_path(path: &str) -> FileKey {
        let path = path.replace('\\', "/");
        let mut parts: Vec<&str> = Vec::new();
        for part in path.split('/') {
            match part {
                "" | "." => {}
                ".." => _ = parts.pop(),
                part => parts.push(part),
            }
        }
        let root = if path.starts_with('/') { "/" } else { "" };
        let mut key = format!("{root}{}", parts.join("/"));
        if key.as_bytes().get(1) == Some(&b':') {
            key[..1].make_ascii_uppercase(); // a drive letter's case means nothing
        }
        FileKey(key)
    }

    /// The key of `name` as a project at `root` calls it: relative to it, or absolute.
    pub(crate) fn in_project(root: &FileKey, name: &str) -> FileKey {
        if is_path(name) {
            return FileKey::of_path(name);
        }
        FileKey::of_path(&format!("{}/{name}", root.0))
    }

    /// Whether it names a file of the file system.
    pub(crate) fn is_file(&self) -> bool {
        is_path(&self.0)
    }

    /// The path or address as text.
    pub(crate) fn as_str(&self) -> &str {
        &self.0
    }

    /// The file's path.
    pub(crate) fn path(&self) -> PathBuf {
        PathBuf::from(&self.0)
    }

    /// Last part of the path.
    pub(crate) fn name(&self) -> &str {
        self.0.rsplit('/').next().unwrap_or_default()
    }

    /// Whether the name ends like this, in any case.
    pub(crate) fn has_ending(&self, ending: &str) -> bool {
        let (name, ending) = (self.0.as_bytes(), ending.as_bytes());
        name.len() > ending.len() && name[name.len() - ending.len()..].eq_ignore_ascii_case(ending)
    }

    /// The folder it is in; `None` above a root and for what is no file.
    pub(crate) fn parent(&self) -> Option<FileKey> {
        let (parent, name) = self.0.rsplit_once('/')?;
        if !self.is_file() || name.is_empty() {
            return None;
        }
        Some(FileKey(if parent.is_empty() { "/".into() } else { parent.into() }))
    }

    /// A file in this folder.
    pub(crate) fn join(&self, name: &str) -> FileKey {
        FileKey::of_path(&format!("{}/{name}", self.0))
    }

    /// Whether `other` is this folder or in it.
    pub(crate) fn contains(&self, other: &FileKey) -> bool {
        let rest = other.0.strip_prefix(self.0.as_str());
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('/') || self.0.ends_with('/'))
    }

    /// Its address, where no client has spelled one. `None` for a path no address can be made of.
    pub(crate) fn uri(&self) -> Option<Uri> {
        if self.is_file() { Uri::from_file_path(self.path()) } else { self.0.parse().ok() }
    }
}

fn is_path(text: &str) -> bool {
    text.starts_with('/') || text.as_bytes().get(1) == Some(&b':')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(uri: &str) -> FileKey {
        FileKey::of_uri(&uri.parse().unwrap())
    }

    #[test]
    fn one_file_has_one_key_however_it_is_spelled() {
        for spelling in [
            "file:///a/b%20c/d.plc",
            "file:///a/./b%20c/d.plc",
            "file:///a/x/../b%20c/d.plc",
            "FILE:///a/b%20c/d.plc",
        ] {
            assert_eq!(key(spelling).as_str(), "/a/b c/d.plc", "{spelling}");
        }
        assert_eq!(FileKey::of_path("c:\\plc\\main.plc").as_str(), "C:/plc/main.plc");
    }

    #[test]
    fn what_is_no_file_keeps_its_address() {
        let it = key("untitled:Untitled-1");
        assert_eq!((it.as_str(), it.is_file(), it.parent()), ("untitled:Untitled-1", false, None));
        assert_eq!(it.uri().unwrap().as_str(), "untitled:Untitled-1");
    }

    #[test]
    fn names_of_a_project_become_keys_and_addresses() {
        let root = FileKey::of_path("/plc");
        assert_eq!(FileKey::in_project(&root, "inc/const.inc").as_str(), "/plc/inc/const.inc");
        assert_eq!(FileKey::in_project(&root, "/other/a.inc").as_str(), "/other/a.inc");
        assert_eq!(FileKey::of_path("/plc/v ř.plc").uri().unwrap().as_str(), "file:///plc/v%20%C5%99.plc");
    }

    #[test]
    fn endings_count_in_any_case() {
        let file = FileKey::of_path("/plc/MAIN.Plc");
        assert!(file.has_ending(".plc") && !file.has_ending(".inc"));
        assert!(!FileKey::of_path("/x").has_ending("long/x"));
    }

    #[test]
    fn folders_know_what_is_in_them() {
        let folder = FileKey::of_path("/plc/a");
        assert!(folder.contains(&FileKey::of_path("/plc/a/b.plc")) && folder.contains(&folder));
        assert!(!folder.contains(&FileKey::of_path("/plc/ab.plc")));
        assert!(FileKey::of_path("/").contains(&folder));
        assert_eq!(folder.parent().unwrap().parent().unwrap().as_str(), "/");
        assert_eq!(FileKey::of_path("/").parent(), None);
    }
}
