//! Reading projects from disk for the front end, which does no I/O itself.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use technol_analysis::diagnostics::rules::project::MACHINE_FILE;
use technol_analysis::project::LoadedProject;
use technol_analysis::{Analysis, AnalysisHost, Change, Diagnostic, Position, Span};
use technol_dap::Disk;
use technol_image::{DebugInfo, Program};
use technol_machine::MachineConfig;
use technol_target::MachineFileError;

use crate::exit::Failure;
use crate::identifiers;

/// A project read from disk and its analysis.
pub(crate) struct Project {
    pub(crate) loaded: Arc<LoadedProject>,
    pub(crate) analysis: Analysis,
    /// Project path and text of the machine file, when the manifest names one that can be read.
    machine_file: Option<(String, String)>,
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
        let machine = loaded.manifest.machine.as_ref().map(|file| file.text.clone());
        let machine_file = machine.and_then(|file| {
            let text = std::fs::read_to_string(Path::new(&loaded.root).join(&file)).ok()?;
            Some((file, text))
        });
        Ok(Project { loaded: Arc::new(loaded), analysis: host.analysis(), machine_file })
    }

    /// The machine behind a program of the project; what it says must fit to that.
    pub(crate) fn machine_for(
        &self,
        program: &Program,
        debug: &DebugInfo,
    ) -> Result<Option<MachineConfig>, Failure> {
        let Some(path) = self.machine() else { return Ok(None) };
        let first = |mut errors: Vec<MachineFileError>| {
            errors.sort_by_key(|error| (error.line, error.col));
            Failure::usage(errors.first().map(ToString::to_string).unwrap_or_default())
        };
        let Some((_, text)) = &self.machine_file else {
            // Says why it cannot be read.
            return technol_target::load_machine(&path).map(Some).map_err(|error| first(vec![error]));
        };
        let mistakes = |config: &MachineConfig| identifiers::mistaken(config, program, debug);
        technol_target::parse_machine_for(&path, text, mistakes).map(Some).map_err(first)
    }

    /// The path of a project file as a user of this shell would write it.
    pub(crate) fn display(&self, file: &str) -> PathBuf {
        Path::new(&self.loaded.root).join(file)
    }

    /// All findings, by file, those of the machine file among them.
    pub(crate) fn findings(&self) -> Result<Vec<(String, Vec<Diagnostic>)>, Failure> {
        // Nothing cancels a query here: this process has no writer.
        let mut findings =
            self.analysis.all_diagnostics().map_err(|_| Failure::usage("the check was interrupted"))?;
        if let Some(file) = &self.loaded.manifest.machine {
            let wrong = self.machine_findings();
            if !wrong.is_empty() {
                findings.push((file.text.clone(), wrong));
            }
        }
        Ok(findings)
    }

    /// What is wrong in the machine file. The front end does not know machines; the target does.
    fn machine_findings(&self) -> Vec<Diagnostic> {
        let Some(path) = self.machine() else { return Vec::new() };
        let errors = match &self.machine_file {
            Some((_, text)) => {
                let built = self.analysis.build().ok().and_then(Result::ok);
                let image = built.map(|built| built.image);
                let debug = image.as_ref().and_then(|image| Some((&image.program, image.debug.as_ref()?)));
                let mistakes = |config: &MachineConfig| {
                    debug.map_or_else(Vec::new, |(program, debug)| {
                        identifiers::mistaken(config, program, debug)
                    })
                };
                technol_target::parse_machine_for(&path, text, mistakes).err().unwrap_or_default()
            }
            // Says why it cannot be read.
            None => technol_target::load_machine(&path).err().into_iter().collect(),
        };
        let text = self.machine_file.as_ref().map_or("", |(_, text)| text.as_str());
        errors
            .into_iter()
            .map(|error| {
                let line = error.line.saturating_sub(1);
                let before = error.col.saturating_sub(1) as usize;
                let source = text.lines().nth(line as usize).unwrap_or_default();
                let column = source.chars().take(before).map(char::len_utf8).sum::<usize>() as u32;
                let at = Position { line, column };
                Diagnostic {
                    code: MACHINE_FILE.code,
                    severity: MACHINE_FILE.severity,
                    message: error.message,
                    span: Span { start: at, end: at },
                    related: Vec::new(),
                    fix: None,
                }
            })
            .collect()
    }

    /// Text of a file of the project, an included one or the manifest, when it could be read.
    pub(crate) fn text(&self, file: &str) -> Option<&str> {
        let sources = self.loaded.files.iter().chain(&self.loaded.included).chain(&self.loaded.configuration);
        let sources = sources.map(|f| (&f.path, &f.text));
        let manifest = self.loaded.manifest_file.iter().map(|(path, text)| (path, text));
        let machine = self.machine_file.iter().map(|(path, text)| (path, text.as_str()));
        let sources = sources.chain(manifest).map(|(path, text)| (path, &**text));
        sources.chain(machine).find(|(path, _)| *path == file).map(|(_, text)| text)
    }
}

impl Project {
    /// Folder of the project.
    pub(crate) fn folder(&self) -> PathBuf {
        PathBuf::from(&self.loaded.root)
    }

    /// Every file the project was read from.
    pub(crate) fn files(&self) -> impl Iterator<Item = PathBuf> {
        let sources = self.loaded.files.iter().chain(&self.loaded.included).chain(&self.loaded.configuration);
        let manifest = self.loaded.manifest_file.iter().map(|(path, _)| path);
        sources.map(|file| &file.path).chain(manifest).map(|path| self.display(path)).chain(self.machine())
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
