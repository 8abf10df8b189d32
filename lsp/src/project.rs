//! A project: its analysis, and the texts the analysis was given.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

use ropey::Rope;
use technol_analysis::project::{FileReader, load};
use technol_analysis::{Analysis, AnalysisHost, Change};
use tower_lsp::ls_types::Uri;

use crate::documents::Document;
use crate::file_key::FileKey;

/// What makes a project one.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Home {
    /// A folder with a manifest.
    Folder(FileKey),
    /// A file outside every project.
    File(FileKey),
}

/// Open documents by file.
pub(crate) type Documents = HashMap<FileKey, Document>;

/// A file as the analysis has it.
#[derive(Clone, Debug)]
pub(crate) struct FileState {
    /// Its text.
    pub(crate) text: Rope,
    /// Its address, in the client's spelling when it is open.
    pub(crate) uri: Uri,
    /// The document's version when it is open.
    pub(crate) version: Option<i32>,
}

/// Files by the name the analysis has for them.
pub(crate) type Files = HashMap<String, FileState>;

/// A loaded project.
pub(crate) struct Project {
    host: AnalysisHost,
    home: Home,
    root: FileKey,
    names: HashMap<FileKey, String>,
    files: Arc<Files>,
    /// Files that were looked for and are not there.
    missed: BTreeSet<FileKey>,
    revision: u64,
}

impl Project {
    /// Loads the project at `home`; open documents count instead of what is on the disk.
    pub(crate) fn load(home: &Home, documents: &Documents) -> Project {
        let root = match home {
            Home::Folder(folder) => folder.clone(),
            Home::File(file) => file.parent().unwrap_or_else(|| FileKey::of_path("/")),
        };
        let mut project = Project {
            host: AnalysisHost::new(),
            home: home.clone(),
            root,
            names: HashMap::new(),
            files: Arc::new(Files::new()),
            missed: BTreeSet::new(),
            revision: 0,
        };
        project.reload(documents);
        project
    }

    /// Reads everything again.
    pub(crate) fn reload(&mut self, documents: &Documents) {
        let reader =
            Reader { documents, alias: self.alias(), texts: RefCell::default(), missed: RefCell::default() };
        let mut loaded = match (&self.home, &reader.alias) {
            (_, Some((path, _))) => load(path, &reader),
            (Home::Folder(key) | Home::File(key), None) => load(key.as_str(), &reader),
        };
        let mut files = Files::new();
        let mut open = Vec::new();
        self.names.clear();
        for file in loaded.files.iter_mut().chain(&mut loaded.included).chain(&mut loaded.configuration) {
            let key = reader.key_of(FileKey::in_project(&self.root, &file.path));
            if let Some(document) = documents.get(&key) {
                file.text = document.text.to_string().into();
                open.push((file.path.clone(), file.text.clone()));
            }
            self.add(&mut files, key, &file.path, &file.text, documents);
        }
        self.missed = reader.missed.into_inner();
        // The manifest, and what was read but is no part of the program: places in them can be reported too.
        for (key, text) in reader.texts.into_inner() {
            let name = self.name_for(&key);
            if !self.names.contains_key(&key) && !files.contains_key(&name) {
                self.add(&mut files, key, &name, &text, documents);
            }
        }
        self.files = Arc::new(files);
        self.host.apply(Change { project: Some(loaded), texts: open });
        self.revision += 1;
    }

    /// A path by which the loader takes a lone text for a program, when its own name does not say so: a text that
    /// was never saved, or one with another ending.
    fn alias(&self) -> Option<(String, FileKey)> {
        let Home::File(key) = &self.home else { return None };
        if key.is_file() && (key.has_ending(".plc") || key.has_ending(".inc")) {
            return None;
        }
        let name = key.name().rsplit(':').next().unwrap_or_default();
        Some((self.root.join(&format!("{name}.plc")).as_str().to_owned(), key.clone()))
    }

    /// A file to be included that no project includes: what it says about a whole program means nothing.
    pub(crate) fn is_fragment(&self) -> bool {
        matches!(&self.home, Home::File(key) if key.has_ending(".inc"))
    }

    fn add(&mut self, files: &mut Files, key: FileKey, name: &str, text: &str, documents: &Documents) {
        let state = match documents.get(&key) {
            Some(open) => {
                FileState { text: open.text.clone(), uri: open.uri.clone(), version: Some(open.version) }
            }
            None => match key.uri() {
                Some(uri) => FileState { text: Rope::from_str(text), uri, version: None },
                None => return,
            },
        };
        files.insert(name.to_owned(), state);
        self.names.insert(key, name.to_owned());
    }

    /// The name the analysis has, or would have, for a file.
    fn name_for(&self, key: &FileKey) -> String {
        let inside = key.as_str().strip_prefix(self.root.as_str()).and_then(|rest| rest.strip_prefix('/'));
        inside.unwrap_or(key.as_str()).to_owned()
    }

    /// Takes over the new text of an open document. Returns whether the file is part of this project.
    pub(crate) fn edit(&mut self, key: &FileKey, document: &Document) -> bool {
        let Some(name) = self.names.get(key) else { return false };
        let state = FileState {
            text: document.text.clone(),
            uri: document.uri.clone(),
            version: Some(document.version),
        };
        Arc::make_mut(&mut self.files).insert(name.clone(), state);
        let text: Arc<str> = document.text.to_string().into();
        self.host.apply(Change { project: None, texts: vec![(name.clone(), text)] });
        self.revision += 1;
        true
    }

    /// Whether the file is part of the program, or its manifest.
    pub(crate) fn contains(&self, key: &FileKey) -> bool {
        self.names.contains_key(key)
    }

    /// Whether the project is another one when this file appears, changes or goes.
    pub(crate) fn hangs_on(&self, key: &FileKey) -> bool {
        let in_folder = matches!(self.home, Home::Folder(_)) && self.root.contains(key);
        in_folder || self.contains(key) || self.missed.contains(key)
    }

    /// The analysis' name of a file.
    pub(crate) fn name_of(&self, key: &FileKey) -> Option<&str> {
        self.names.get(key).map(String::as_str)
    }

    /// The project's folder.
    pub(crate) fn root(&self) -> &FileKey {
        &self.root
    }

    /// What the analysis says now. Writers wait for it to be dropped.
    pub(crate) fn analysis(&self) -> Analysis {
        self.host.analysis()
    }

    /// The texts as the analysis has them now.
    pub(crate) fn files(&self) -> Arc<Files> {
        Arc::clone(&self.files)
    }

    /// Number of the present state; grows with each change.
    pub(crate) fn revision(&self) -> u64 {
        self.revision
    }
}

/// Reads files for the loader: open documents first, then the disk. Remembers what it read.
struct Reader<'a> {
    documents: &'a Documents,
    /// A path that stands for a text with another address.
    alias: Option<(String, FileKey)>,
    texts: RefCell<BTreeMap<FileKey, String>>,
    missed: RefCell<BTreeSet<FileKey>>,
}

impl Reader<'_> {
    /// The file a path stands for.
    fn key_of(&self, key: FileKey) -> FileKey {
        match &self.alias {
            Some((path, file)) if key.as_str() == path => file.clone(),
            _ => key,
        }
    }
}

impl FileReader for Reader<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let key = self.key_of(FileKey::of_path(path));
        let bytes = match self.documents.get(&key) {
            // The mark says UTF-8 whatever encoding the project's files on the disk have.
            Some(document) => format!("\u{feff}{}", document.text).into_bytes(),
            None if key.is_file() => std::fs::read(key.path()).map_err(|error| {
                self.missed.borrow_mut().insert(key.clone());
                error.to_string()
            })?,
            None => return Err("the editor has closed it".to_owned()),
        };
        let text = String::from_utf8_lossy(&bytes);
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text).to_owned();
        self.texts.borrow_mut().insert(key, text);
        Ok(bytes)
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let folder = FileKey::of_path(folder);
        let entries = std::fs::read_dir(folder.path()).into_iter().flatten().flatten();
        let files = entries.filter(|entry| entry.file_type().is_ok_and(|kind| !kind.is_dir()));
        let mut names: BTreeSet<String> =
            files.filter_map(|entry| entry.file_name().into_string().ok()).collect();
        // A document that was not saved yet is there too.
        let open = self.documents.keys().filter(|key| key.parent().as_ref() == Some(&folder));
        names.extend(open.map(|key| key.name().to_owned()));
        names.into_iter().collect()
    }
}
