//! A project: its analysis, and the texts the analysis was given.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use ropey::Rope;
use technol_analysis::project::{FileReader, load};
use technol_analysis::{Analysis, AnalysisHost, Change};
use tower_lsp::ls_types::Uri;

use crate::documents::Document;
use crate::file_key::FileKey;

/// Name of a project's manifest.
pub(crate) const MANIFEST: &str = "technol.toml";

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
    root: FileKey,
    names: HashMap<FileKey, String>,
    files: Arc<Files>,
    revision: u64,
}

impl Project {
    /// Loads the project at `home`; open documents count instead of what is on the disk.
    pub(crate) fn load(home: &Home, documents: &Documents) -> Project {
        let root = match home {
            Home::Folder(folder) => folder.clone(),
            Home::File(file) => file.parent().unwrap_or_else(|| file.clone()),
        };
        let mut project = Project {
            host: AnalysisHost::new(),
            root,
            names: HashMap::new(),
            files: Arc::new(Files::new()),
            revision: 0,
        };
        project.reload(home, documents);
        project
    }

    /// Reads everything again.
    pub(crate) fn reload(&mut self, home: &Home, documents: &Documents) {
        let target = match home {
            Home::Folder(key) | Home::File(key) => key,
        };
        let reader = Reader { documents, texts: RefCell::default() };
        let mut loaded = load(target.as_str(), &reader);
        let mut files = Files::new();
        self.names.clear();
        for file in &mut loaded.files {
            let key = FileKey::in_project(&self.root, &file.path);
            if let Some(document) = documents.get(&key) {
                file.text = document.text.to_string();
            }
            self.add(&mut files, key, &file.path, &file.text, documents);
        }
        // The manifest, and what was read but is no part of the program: places in them can be reported too.
        for (key, text) in reader.texts.into_inner() {
            let name = self.name_for(&key);
            if !files.contains_key(&name) {
                self.add(&mut files, key, &name, &text, documents);
            }
        }
        self.files = Arc::new(files);
        self.host.apply(Change { project: Some(loaded), texts: Vec::new() });
        self.revision += 1;
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
        let state =
            FileState { text: document.text.clone(), uri: document.uri.clone(), version: Some(document.version) };
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
    texts: RefCell<BTreeMap<FileKey, String>>,
}

impl FileReader for Reader<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        // The loader hands back what it was given, so an address that is no path comes through as it is.
        let address = FileKey::in_project(&FileKey::of_path("/"), path);
        let bytes = match self.documents.get(&address) {
            // The mark says UTF-8 whatever encoding the project's files on the disk have.
            Some(document) => format!("\u{feff}{}", document.text).into_bytes(),
            None => std::fs::read(address.path()).map_err(|error| error.to_string())?,
        };
        let text = String::from_utf8_lossy(&bytes);
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text).to_owned();
        self.texts.borrow_mut().insert(address, text);
        Ok(bytes)
    }
}
