//! Reading projects from disk for the front end, which does no I/O itself.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use technol_analysis::project::{FileReader, LoadedProject};
use technol_analysis::{Analysis, AnalysisHost, Change, Diagnostic};

use crate::exit::Failure;

/// Reads files from disk.
pub(crate) struct Disk;

impl FileReader for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        std::fs::read(path).map_err(|error| error.to_string())
    }
}

/// A project read from disk and its analysis.
pub(crate) struct Project {
    pub(crate) loaded: Arc<LoadedProject>,
    pub(crate) analysis: Analysis,
}

impl Project {
    /// Reads the project at `path`: a folder with a `technol.toml`, the manifest itself or a lone `.plc` file.
    pub(crate) fn open(path: &Path) -> Result<Project, Failure> {
        if !path.exists() {
            return Err(Failure::usage(format!(
                "{}: no such file or folder; name a project folder, a technol.toml or a .plc file",
                path.display()
            )));
        }
        let loaded = technol_analysis::project::load(&path.to_string_lossy(), &Disk);
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(loaded.clone()), texts: Vec::new() });
        Ok(Project { loaded: Arc::new(loaded), analysis: host.analysis() })
    }

    /// The path of a project file as a user of this shell would write it.
    pub(crate) fn display(&self, file: &str) -> PathBuf {
        Path::new(&self.loaded.root).join(file)
    }

    /// All findings, by file.
    pub(crate) fn findings(&self) -> Result<Vec<(String, Vec<Diagnostic>)>, Failure> {
        // Nothing cancels a query here: this process has no writer.
        self.analysis.all_diagnostics().map_err(|_| Failure::usage("the check was interrupted"))
    }

    /// Text of a file of the project, an included one or the manifest, when it could be read.
    pub(crate) fn text(&self, file: &str) -> Option<&str> {
        let sources = self.loaded.files.iter().chain(&self.loaded.included).map(|f| (&f.path, &f.text));
        let manifest = self.loaded.manifest_file.iter().map(|(path, text)| (path, text));
        sources.chain(manifest).find(|(path, _)| *path == file).map(|(_, text)| &**text)
    }
}

impl Project {
    /// Folder of the project.
    pub(crate) fn folder(&self) -> PathBuf {
        PathBuf::from(&self.loaded.root)
    }

    /// Name of the project: what results are called.
    pub(crate) fn name(&self) -> String {
        self.loaded.manifest.name.clone()
    }

    /// The machine file that the manifest names.
    pub(crate) fn machine(&self) -> Option<PathBuf> {
        self.loaded.manifest.machine.as_ref().map(|file| self.folder().join(&file.text))
    }
}
