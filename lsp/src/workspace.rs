//! Open documents and the projects they belong to.

use std::collections::BTreeMap;

use technol_analysis::configuration::ConfigKind;
use technol_analysis::project::MANIFEST;
use tower_lsp::ls_types::{TextDocumentContentChangeEvent, Uri};

use crate::documents::Document;
use crate::file_key::FileKey;
use crate::positions::Encoding;
use crate::project::{Documents, Home, Project};

/// Everything the server knows about the user's files.
#[derive(Default)]
pub(crate) struct Workspace {
    documents: Documents,
    projects: BTreeMap<Home, Project>,
    folders: Vec<FileKey>,
}

/// What became of the projects in a step.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Effects {
    /// Projects with something new.
    pub(crate) changed: Vec<Home>,
    /// Projects that are gone.
    pub(crate) dropped: Vec<Home>,
    /// Projects whose file list may be another now: they want [`Workspace::reload`].
    pub(crate) reload: Vec<Home>,
}

impl Workspace {
    /// The editor's folders: projects in their roots are loaded even while none of their files is open.
    pub(crate) fn set_folders(&mut self, folders: Vec<FileKey>) -> Effects {
        self.folders = folders;
        self.settle(Effects::default())
    }

    /// The editor's folders.
    pub(crate) fn folders(&self) -> &[FileKey] {
        &self.folders
    }

    /// A document was opened.
    pub(crate) fn open(&mut self, document: Document) -> Effects {
        let key = FileKey::of_uri(&document.uri);
        self.documents.insert(key.clone(), document);
        let mut effects = self.spread(&key);
        if key.name() == MANIFEST {
            effects.reload = self.containing(&key);
        }
        if is_configuration(&key) && self.containing(&key).is_empty() {
            // Perhaps a new file beside the program.
            let near = self.projects.iter().filter(|(_, it)| it.hangs_on(&key));
            effects.reload = near.map(|(home, _)| home.clone()).collect();
        }
        self.settle(effects)
    }

    /// A document was changed. `Err` when it is not open.
    pub(crate) fn change(
        &mut self,
        uri: &Uri,
        version: i32,
        changes: &[TextDocumentContentChangeEvent],
        encoding: Encoding,
    ) -> Result<Effects, String> {
        let key = FileKey::of_uri(uri);
        let Some(document) = self.documents.get_mut(&key) else {
            return Err(format!("{} was changed but is not open; the change is lost", uri.as_str()));
        };
        let structural = document.change(version, changes, encoding) || key.name() == MANIFEST;
        let mut effects = self.spread(&key);
        if structural {
            effects.reload = self.containing(&key);
        }
        Ok(effects)
    }

    /// A document was closed: what is on the disk counts again.
    pub(crate) fn close(&mut self, uri: &Uri) -> Effects {
        let key = FileKey::of_uri(uri);
        if self.documents.remove(&key).is_none() {
            return Effects::default();
        }
        let affected = self.containing(&key);
        let mut effects = self.settle(Effects::default());
        for home in affected {
            if self.projects.contains_key(&home) {
                effects.reload.push(home);
            }
        }
        effects
    }

    /// Files changed on the disk.
    pub(crate) fn touched(&mut self, keys: &[FileKey]) -> Effects {
        let concerned =
            self.projects.iter().filter(|(_, project)| keys.iter().any(|key| project.hangs_on(key)));
        let reload = concerned.map(|(home, _)| home.clone());
        let effects = Effects { reload: reload.collect(), ..Effects::default() };
        self.settle(effects)
    }

    /// Reads the projects again, and moves documents whose project is another now.
    pub(crate) fn reload(&mut self, homes: &[Home]) -> Effects {
        let mut effects = Effects::default();
        for home in homes {
            if let Some(project) = self.projects.get_mut(home) {
                project.reload(&self.documents);
                effects.changed.push(home.clone());
            }
        }
        self.settle(effects)
    }

    /// The project that answers for a file, with the file's name in it.
    pub(crate) fn project_of(&self, uri: &Uri) -> Option<(&Project, &str)> {
        let key = FileKey::of_uri(uri);
        // A folder's project goes before a file's own one; the nearest folder goes first.
        let mut found: Vec<_> = self.projects.iter().filter(|(_, it)| it.contains(&key)).collect();
        found.sort_by_key(|(home, it)| (!is_home_folder(home), std::cmp::Reverse(it.root().as_str().len())));
        found.first().and_then(|(_, project)| Some((*project, project.name_of(&key)?)))
    }

    /// The project of a home.
    pub(crate) fn project(&self, home: &Home) -> Option<&Project> {
        self.projects.get(home)
    }

    /// All projects.
    pub(crate) fn projects(&self) -> impl Iterator<Item = &Project> {
        self.projects.values()
    }

    /// Gives an open document's text to every project that has the file.
    fn spread(&mut self, key: &FileKey) -> Effects {
        let mut effects = Effects::default();
        let Some(document) = self.documents.get(key) else { return effects };
        for (home, project) in &mut self.projects {
            if project.edit(key, document) {
                effects.changed.push(home.clone());
            }
        }
        effects
    }

    fn containing(&self, key: &FileKey) -> Vec<Home> {
        self.projects.iter().filter(|(_, it)| it.contains(key)).map(|(home, _)| home.clone()).collect()
    }

    /// Loads the projects that are wanted now and drops the others: a folder's project is wanted by the editor's
    /// folders and by open documents below it, a file's own one by the open file that is in no other project.
    fn settle(&mut self, mut effects: Effects) -> Effects {
        let mut wanted = Vec::new();
        for folder in self.folders.clone() {
            if let Some(home) = self.discover(&folder) {
                self.ensure(&home, &mut effects);
                wanted.push(home);
            }
        }
        let mut open: Vec<FileKey> = self.documents.keys().cloned().collect();
        open.sort();
        let mut lone = Vec::new();
        for key in open {
            let home = key.parent().and_then(|folder| self.discover(&folder));
            if let Some(home) = home {
                self.ensure(&home, &mut effects);
                wanted.push(home);
            }
            lone.push(key);
        }
        for key in lone {
            let housed =
                wanted.iter().any(|home| self.projects.get(home).is_some_and(|it| it.contains(&key)));
            // A configuration file outside of every project is no program: nothing is known about it.
            if !housed && key.name() != MANIFEST && !is_configuration(&key) {
                let home = Home::File(key);
                self.ensure(&home, &mut effects);
                wanted.push(home);
            }
        }
        self.projects.retain(|home, _| {
            let keep = wanted.contains(home);
            if !keep {
                effects.dropped.push(home.clone());
            }
            keep
        });
        effects.changed.retain(|home| wanted.contains(home));
        effects.reload.retain(|home| wanted.contains(home));
        effects
    }

    fn ensure(&mut self, home: &Home, effects: &mut Effects) {
        if !self.projects.contains_key(home) {
            self.projects.insert(home.clone(), Project::load(home, &self.documents));
            effects.changed.push(home.clone());
        }
    }

    /// The nearest folder with a manifest, from `folder` upwards.
    fn discover(&self, folder: &FileKey) -> Option<Home> {
        let mut folder = Some(folder.clone());
        while let Some(key) = folder {
            let manifest = key.join(MANIFEST);
            if self.documents.contains_key(&manifest) || manifest.path().is_file() {
                return Some(Home::Folder(key));
            }
            folder = key.parent();
        }
        None
    }
}

fn is_configuration(key: &FileKey) -> bool {
    ConfigKind::of_path(key.name()).is_some()
}

fn is_home_folder(home: &Home) -> bool {
    matches!(home, Home::Folder(_))
}
