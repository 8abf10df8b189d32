//! Files that a host may work with: those in one folder, and nothing outside it.

use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Component, Path, PathBuf};
use std::time::UNIX_EPOCH;

use technol_image::container::hash_bytes;
use technol_wire::message::{ContentHash, Entry, Failure, FileAnswer, FileRequest, Limits, Response};

use crate::keep::replace;

type Answer = Result<Response, Failure>;

/// Bytes that an entry of a list takes beside its name, about.
const ENTRY: usize = 24;
/// Longest file whose sum is told; reading it takes some tenths of a second in which no cycle runs.
const MOST_SUM: u64 = 64 << 20;

/// The folder that is offered cannot be.
#[derive(Debug, thiserror::Error)]
#[error("cannot offer the folder {path}: {source}; make it, or name another one")]
pub struct FolderError {
    path: String,
    source: io::Error,
}

/// A folder whose files are offered to hosts. Paths lead nowhere else: no absolute ones, no `..`, no symbolic links.
#[derive(Clone, Debug)]
pub struct RemoteFolder {
    root: PathBuf,
}

impl RemoteFolder {
    /// Offers a folder that is there.
    ///
    /// # Errors
    /// It is not there, or not a folder.
    pub fn new(path: &Path) -> Result<RemoteFolder, FolderError> {
        let wrong = |source| FolderError { path: path.display().to_string(), source };
        let root = path.canonicalize().map_err(wrong)?;
        if !root.is_dir() {
            return Err(wrong(io::Error::from(ErrorKind::NotADirectory)));
        }
        Ok(RemoteFolder { root })
    }

    /// Acts on a request; [`FileRequest::Store`] is not done here.
    pub(crate) fn answer(&self, request: &FileRequest, limits: Limits) -> Answer {
        match request {
            FileRequest::List { path, from } => self.list(path, *from, limits),
            FileRequest::Read { path, offset, len } => self.read(path, *offset, (*len).min(limits.max_read)),
            FileRequest::Sum { path } => self.sum(path),
            FileRequest::Store { .. } => Err(Failure::Unsupported),
            FileRequest::Copy { from, to } => {
                let (from, to) = (self.existing(from)?, self.free(to)?);
                file(&from)?;
                fs::copy(&from.path, &to.path).map_err(|e| from.failed("copied", &e))?;
                Ok(Response::Done)
            }
            FileRequest::Move { from, to } => {
                let (from, to) = (self.existing(from)?, self.free(to)?);
                fs::rename(&from.path, &to.path).map_err(|e| from.failed("moved", &e))?;
                Ok(Response::Done)
            }
            FileRequest::Delete { path } => {
                let place = self.existing(path)?;
                let is_folder = place.metadata.as_ref().is_some_and(Metadata::is_dir);
                let done = if is_folder { fs::remove_dir(&place.path) } else { fs::remove_file(&place.path) };
                done.map_err(|e| place.failed("deleted", &e))?;
                Ok(Response::Done)
            }
            FileRequest::MakeFolder { path } => {
                let place = self.free(path)?;
                fs::create_dir(&place.path).map_err(|e| place.failed("made", &e))?;
                Ok(Response::Done)
            }
        }
    }

    /// Writes a file, whole or not at all.
    pub(crate) fn store(&self, path: &str, bytes: &[u8]) -> Answer {
        let place = self.place(path)?;
        if place.metadata.is_some() {
            file(&place)?;
        }
        replace(&place.path, bytes).map_err(|e| place.failed("written", &e))?;
        Ok(Response::Done)
    }

    fn list(&self, path: &str, from: u32, limits: Limits) -> Answer {
        let place = if path.is_empty() { self.top()? } else { self.existing(path)? };
        if !place.metadata.as_ref().is_some_and(Metadata::is_dir) {
            return Err(Failure::Refused(format!("`{path}` is not a folder")));
        }
        let failed = |e: &io::Error| place.failed("read", e);
        let mut all = Vec::new();
        for entry in fs::read_dir(&place.path).map_err(|e| failed(&e))? {
            let entry = entry.map_err(|e| failed(&e))?;
            // What cannot be asked for is not told: symbolic links, and names that are no text.
            let (Ok(name), Ok(metadata)) = (entry.file_name().into_string(), entry.metadata()) else {
                continue;
            };
            if metadata.is_dir() || metadata.is_file() {
                all.push(described(name, &metadata));
            }
        }
        all.sort_by(|a, b| a.name.cmp(&b.name));
        let mut room = usize::from(limits.max_read);
        let rest = all.iter().skip(from as usize);
        // One at least, however long its name.
        let fits = rest.clone().enumerate().take_while(|(n, entry)| {
            let takes = entry.name.len() + ENTRY;
            let fits = takes <= room;
            room = room.saturating_sub(takes);
            fits || *n == 0
        });
        let entries: Vec<Entry> = fits.map(|(_, entry)| entry.clone()).collect();
        let more = rest.count() > entries.len();
        Ok(Response::Files(FileAnswer::Entries { entries, more }))
    }

    fn read(&self, path: &str, offset: u64, len: u16) -> Answer {
        let place = self.existing(path)?;
        let size = file(&place)?;
        let piece = || -> io::Result<Vec<u8>> {
            let mut source = File::open(&place.path)?;
            source.seek(SeekFrom::Start(offset.min(size)))?;
            let mut bytes = Vec::new();
            source.take(u64::from(len)).read_to_end(&mut bytes)?;
            Ok(bytes)
        };
        let bytes = piece().map_err(|e| place.failed("read", &e))?;
        Ok(Response::Files(FileAnswer::Bytes { bytes, size }))
    }

    fn sum(&self, path: &str) -> Answer {
        let place = self.existing(path)?;
        if file(&place)? > MOST_SUM {
            return Err(Failure::TooLarge);
        }
        let bytes = fs::read(&place.path).map_err(|e| place.failed("read", &e))?;
        let hash: ContentHash = hash_bytes(&bytes);
        Ok(Response::Files(FileAnswer::Sum { size: bytes.len() as u64, hash }))
    }

    /// The folder itself, which may be listed and nothing else.
    fn top(&self) -> Result<Place, Failure> {
        let metadata = fs::symlink_metadata(&self.root).map_err(|e| said(".", "read", &e))?;
        Ok(Place { said: String::new(), path: self.root.clone(), metadata: Some(metadata) })
    }

    fn existing(&self, path: &str) -> Result<Place, Failure> {
        let place = self.place(path)?;
        if place.metadata.is_none() {
            return Err(Failure::NotFound(format!("`{path}` does not exist")));
        }
        Ok(place)
    }

    fn free(&self, path: &str) -> Result<Place, Failure> {
        let place = self.place(path)?;
        if place.metadata.is_some() {
            return Err(Failure::Refused(format!("`{path}` exists already")));
        }
        Ok(place)
    }

    /// Where a path of the host leads.
    fn place(&self, path: &str) -> Result<Place, Failure> {
        if let Some(why) = fault_in(path) {
            return Err(Failure::Refused(format!("`{path}` {why}")));
        }
        let names: Vec<&str> = path.split('/').collect();
        let mut there = self.root.clone();
        let mut metadata = None;
        for (at, name) in names.iter().enumerate() {
            there.push(name);
            let last = at + 1 == names.len();
            metadata = match fs::symlink_metadata(&there) {
                Ok(found) if found.is_symlink() => {
                    return Err(Failure::Refused(format!("`{path}` leads through a symbolic link")));
                }
                Ok(found) if last || found.is_dir() => Some(found),
                Ok(_) => return Err(Failure::Refused(format!("`{name}` in `{path}` is not a folder"))),
                Err(error) if error.kind() == ErrorKind::NotFound && last => None,
                Err(error) if error.kind() == ErrorKind::NotFound => {
                    return Err(Failure::NotFound(format!("the folder of `{path}` does not exist")));
                }
                Err(error) => return Err(said(path, "reached", &error)),
            };
        }
        Ok(Place { said: path.to_owned(), path: there, metadata })
    }
}

/// A path that stays inside.
struct Place {
    /// As the host says it.
    said: String,
    path: PathBuf,
    /// `None`: nothing is there.
    metadata: Option<Metadata>,
}

impl Place {
    fn failed(&self, done: &str, error: &io::Error) -> Failure {
        said(&self.said, done, error)
    }
}

fn said(path: &str, done: &str, error: &io::Error) -> Failure {
    Failure::Refused(format!("`{path}` cannot be {done}: {error}"))
}

/// Length of what has to be a file.
fn file(place: &Place) -> Result<u64, Failure> {
    match &place.metadata {
        Some(metadata) if metadata.is_file() => Ok(metadata.len()),
        _ => Err(Failure::Refused(format!("`{}` is not a file", place.said))),
    }
}

/// Why a path is not taken, before any look at the disk.
fn fault_in(path: &str) -> Option<&'static str> {
    if path.is_empty() {
        return Some("names no file");
    }
    if path.contains(['\\', ':', '\0']) {
        return Some("holds a character that paths here do not have; names are separated by `/`");
    }
    let one_plain_name = |name: &str| {
        let mut parts = Path::new(name).components();
        matches!((parts.next(), parts.next()), (Some(Component::Normal(part)), None) if part == name)
    };
    if path.split('/').all(one_plain_name) { None } else { Some("leads out of the folder that is offered") }
}

fn described(name: String, metadata: &Metadata) -> Entry {
    let modified = metadata.modified().ok().and_then(|at| at.duration_since(UNIX_EPOCH).ok());
    Entry {
        name,
        folder: metadata.is_dir(),
        size: if metadata.is_dir() { 0 } else { metadata.len() },
        modified: modified.map_or(0, |since| since.as_secs()),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // tests
mod tests {
    use super::*;

    const LIMITS: Limits = Limits { max_payload: 240, max_read: 100, max_breakpoints: 1, window: 1 };

    fn folder() -> (tempfile::TempDir, RemoteFolder) {
        let outer = tempfile::tempdir().unwrap();
        let root = outer.path().join("offered");
        fs::create_dir(&root).unwrap();
        fs::write(outer.path().join("secret"), "secret").unwrap();
        let folder = RemoteFolder::new(&root).unwrap();
        (outer, folder)
    }

    fn ask(folder: &RemoteFolder, request: &FileRequest) -> Answer {
        folder.answer(request, LIMITS)
    }

    fn text(path: &str) -> String {
        path.to_owned()
    }

    /// Everything that can be done with a path.
    fn all(path: &str) -> Vec<FileRequest> {
        let (path, good) = (text(path), text("good"));
        vec![
            FileRequest::List { path: path.clone(), from: 0 },
            FileRequest::Read { path: path.clone(), offset: 0, len: 10 },
            FileRequest::Sum { path: path.clone() },
            FileRequest::Copy { from: path.clone(), to: text("new") },
            FileRequest::Copy { from: good.clone(), to: path.clone() },
            FileRequest::Move { from: path.clone(), to: text("new") },
            FileRequest::Move { from: good, to: path.clone() },
            FileRequest::Delete { path: path.clone() },
            FileRequest::MakeFolder { path },
        ]
    }

    #[test]
    fn no_path_leads_out() {
        let (outer, folder) = folder();
        folder.store("good", b"good").unwrap();
        let absolute = outer.path().join("secret").display().to_string();
        let ways = [
            "..",
            "../secret",
            "a/../../secret",
            "./good",
            ".",
            "/",
            "/etc/passwd",
            "good/",
            "a//b",
            "//server/x",
            "C:/x",
            "C:x",
            "..\\secret",
            "a\0b",
            absolute.as_str(),
        ];
        for way in ways {
            for request in all(way) {
                let answer = ask(&folder, &request);
                assert!(matches!(answer, Err(Failure::Refused(_))), "{request:?}: {answer:?}");
            }
            assert!(matches!(folder.store(way, b"x"), Err(Failure::Refused(_))), "{way}");
        }
        assert_eq!(fs::read(outer.path().join("secret")).unwrap(), b"secret");
        assert_eq!(fs::read_dir(outer.path()).unwrap().count(), 2);
        assert_eq!(fs::read_dir(outer.path().join("offered")).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn no_symbolic_link_leads_out() {
        use std::os::unix::fs::symlink;
        let (outer, folder) = folder();
        folder.store("good", b"good").unwrap();
        symlink(outer.path(), folder.root.join("up")).unwrap();
        symlink(outer.path().join("secret"), folder.root.join("link")).unwrap();
        symlink(outer.path().join("not there"), folder.root.join("dangling")).unwrap();
        for way in ["up", "up/secret", "up/new", "link", "dangling"] {
            for request in all(way) {
                let answer = ask(&folder, &request);
                assert!(matches!(answer, Err(Failure::Refused(_))), "{request:?}: {answer:?}");
            }
            assert!(matches!(folder.store(way, b"x"), Err(Failure::Refused(_))), "{way}");
        }
        let listed = ask(&folder, &FileRequest::List { path: text(""), from: 0 }).unwrap();
        let Response::Files(FileAnswer::Entries { entries, more: false }) = listed else {
            panic!("{listed:?}")
        };
        assert_eq!(entries.iter().map(|e| e.name.as_str()).collect::<Vec<_>>(), ["good"]);
        assert_eq!(fs::read(outer.path().join("secret")).unwrap(), b"secret");
        assert!(!outer.path().join("not there").exists() && !outer.path().join("new").exists());
    }

    #[test]
    fn files_are_copied_moved_and_deleted_and_nothing_is_overwritten_on_the_way() {
        let (_outer, folder) = folder();
        let done = |request| assert_eq!(ask(&folder, &request), Ok(Response::Done));
        let refused = |request: FileRequest, why: &str| match ask(&folder, &request) {
            Err(Failure::Refused(text) | Failure::NotFound(text)) => assert!(text.contains(why), "{text}"),
            other => panic!("{request:?}: {other:?}"),
        };
        folder.store("a", b"first").unwrap();
        folder.store("a", b"second").unwrap();
        done(FileRequest::MakeFolder { path: text("sub") });
        done(FileRequest::Copy { from: text("a"), to: text("sub/b") });
        refused(FileRequest::Copy { from: text("a"), to: text("sub/b") }, "exists already");
        refused(FileRequest::Copy { from: text("sub"), to: text("other") }, "is not a file");
        refused(FileRequest::Move { from: text("a"), to: text("sub/b") }, "exists already");
        refused(FileRequest::Move { from: text("no"), to: text("new") }, "does not exist");
        refused(FileRequest::MakeFolder { path: text("x/y") }, "does not exist");
        refused(FileRequest::MakeFolder { path: text("a/y") }, "is not a folder");
        done(FileRequest::Move { from: text("a"), to: text("c") });
        refused(FileRequest::Delete { path: text("sub") }, "cannot be deleted");
        done(FileRequest::Delete { path: text("sub/b") });
        done(FileRequest::Delete { path: text("sub") });
        assert_eq!(fs::read(folder.root.join("c")).unwrap(), b"second");
        let sum = ask(&folder, &FileRequest::Sum { path: text("c") }).unwrap();
        assert_eq!(sum, Response::Files(FileAnswer::Sum { size: 6, hash: hash_bytes(b"second") }));
    }

    #[test]
    fn long_lists_and_files_come_in_pieces() {
        let (_outer, folder) = folder();
        for n in 0..25 {
            folder.store(&format!("file{n:02}"), &vec![n; 250]).unwrap();
        }
        let mut names = Vec::new();
        loop {
            let from = names.len() as u32;
            let answer = ask(&folder, &FileRequest::List { path: text(""), from }).unwrap();
            let Response::Files(FileAnswer::Entries { entries, more }) = answer else { panic!("{answer:?}") };
            assert!(!entries.is_empty() && entries.len() < 5);
            assert!(entries.iter().all(|e| e.size == 250 && !e.folder && e.modified > 0));
            names.extend(entries.into_iter().map(|e| e.name));
            if !more {
                break;
            }
        }
        assert_eq!(names, (0..25).map(|n| format!("file{n:02}")).collect::<Vec<_>>());

        let read = |offset| match ask(&folder, &FileRequest::Read { path: text("file03"), offset, len: 9999 })
        {
            Ok(Response::Files(FileAnswer::Bytes { bytes, size: 250 })) => bytes,
            other => panic!("{other:?}"),
        };
        assert_eq!(
            [read(0).len(), read(200).len(), read(250).len(), read(u64::MAX / 2).len()],
            [100, 50, 0, 0]
        );
    }

    #[test]
    fn a_folder_that_is_not_there_is_not_offered() {
        let (outer, _) = folder();
        let error = RemoteFolder::new(&outer.path().join("no")).unwrap_err().to_string();
        assert!(
            error.starts_with("cannot offer the folder") && error.ends_with("or name another one"),
            "{error}"
        );
        assert!(RemoteFolder::new(&outer.path().join("secret")).is_err());
    }
}
