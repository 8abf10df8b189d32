//! The database from outside: changes go in through the host, questions go to snapshots.

use std::collections::BTreeMap;
use std::panic::AssertUnwindSafe;
use std::sync::Arc;

use rustc_hash::FxHashSet;
use salsa::{Cancelled, Durability, Setter};

use crate::database::{self, ConfigFile, Database, Project, SourceFile};
use crate::diagnostics::{Diagnostic, Fix};
use crate::project::{LoadedFile, LoadedProject, include_names};

/// The answer of a snapshot, or that a change overtook it: ask the next snapshot.
pub type Cancellable<T> = Result<T, Cancelled>;

/// Owns the database.
pub struct AnalysisHost {
    db: Database,
    state: State,
    /// Files whose texts came as those of somebody who edits.
    edited: FxHashSet<SourceFile>,
}

/// A change of the project or of texts.
#[derive(Clone, Debug, Default)]
pub struct Change {
    /// The project, when it was loaded or its set of files changed.
    pub project: Option<LoadedProject>,
    /// Texts of files that somebody edits, by project path; files that are not part of the project are ignored.
    pub texts: Vec<(String, Arc<str>)>,
}

/// A snapshot. Cheap to clone; while one lives, [`AnalysisHost::apply`] waits for it after cancelling its queries.
#[derive(Clone)]
pub struct Analysis {
    db: Database,
    state: State,
}

#[derive(Clone, Default)]
struct State {
    project: Option<Project>,
    files: Arc<BTreeMap<String, SourceFile>>,
    configuration: Arc<BTreeMap<String, ConfigFile>>,
    /// Mistakes in the manifest and in the set of files.
    problems: Arc<Vec<(String, Diagnostic)>>,
    /// Project path and text of the manifest.
    manifest: Option<(String, Arc<str>)>,
}

impl Default for AnalysisHost {
    fn default() -> Self {
        AnalysisHost::new()
    }
}

impl AnalysisHost {
    /// A host without a project.
    #[must_use]
    pub fn new() -> AnalysisHost {
        AnalysisHost::with_database(Database::default())
    }

    /// A host over a database of the caller's making, to observe its events.
    #[must_use]
    pub fn with_database(db: Database) -> AnalysisHost {
        AnalysisHost { db, state: State::default(), edited: FxHashSet::default() }
    }

    /// Takes a change. Waits until no snapshot is alive; running queries of snapshots are cancelled.
    pub fn apply(&mut self, change: Change) {
        if let Some(project) = change.project {
            self.load(&project);
        }
        for (path, text) in change.texts {
            if let Some(file) = self.state.files.get(&path).copied() {
                self.edit(file, text);
            } else if let Some(file) = self.state.configuration.get(&path).copied()
                && *file.text(&self.db) != text
            {
                file.set_text(&mut self.db).to(text);
            }
        }
    }

    /// A snapshot of the present state.
    #[must_use]
    pub fn analysis(&self) -> Analysis {
        Analysis { db: self.db.clone(), state: self.state.clone() }
    }

    /// Whether a text names an included file that was not looked for when the project was loaded: load it again.
    #[must_use]
    pub fn needs_reload(&self) -> bool {
        let Some(project) = self.state.project else { return false };
        let known = project.includes(&self.db);
        self.state.files.iter().any(|(path, file)| {
            let names = include_names(file.text(&self.db));
            names.into_iter().any(|(name, _)| !known.contains_key(&(path.clone(), name)))
        })
    }

    /// From now on salsa looks at what depends on this file, and passes over what the other files alone decide. It
    /// takes a file that becomes one of these for changed as a whole, so this happens when it is opened.
    fn edit(&mut self, file: SourceFile, text: Arc<str>) {
        if self.edited.insert(file) || *file.text(&self.db) != text {
            file.set_text(&mut self.db).with_durability(Durability::LOW).to(text);
        }
    }

    fn load(&mut self, loaded: &LoadedProject) {
        let old = std::mem::take(&mut self.state.files);
        let mut files = BTreeMap::new();
        let mut inputs = |host: &mut AnalysisHost, list: &[LoadedFile]| -> Vec<SourceFile> {
            list.iter()
                .map(|file| {
                    let input = host.input(&old, file);
                    files.insert(file.path.clone(), input);
                    input
                })
                .collect()
        };
        let program = inputs(self, &loaded.files);
        let included = inputs(self, &loaded.included);
        let configuration = self.configuration(&loaded.configuration);
        let settings = Arc::new(loaded.settings());
        let includes = Arc::new(loaded.includes.clone());
        match self.state.project {
            None => {
                let project = Project::builder(program, included, configuration, settings, includes)
                    .durability(Durability::MEDIUM)
                    .new(&self.db);
                self.state.project = Some(project);
            }
            Some(project) => {
                if *project.files(&self.db) != program {
                    project.set_files(&mut self.db).to(program);
                }
                if *project.included(&self.db) != included {
                    project.set_included(&mut self.db).to(included);
                }
                if *project.configuration(&self.db) != configuration {
                    project.set_configuration(&mut self.db).to(configuration);
                }
                if *project.settings(&self.db) != settings {
                    project.set_settings(&mut self.db).to(settings);
                }
                if *project.includes(&self.db) != includes {
                    project.set_includes(&mut self.db).to(includes);
                }
            }
        }
        self.state.files = Arc::new(files);
        self.state.problems = Arc::new(lowered(loaded));
        self.state.manifest.clone_from(&loaded.manifest_file);
    }

    /// The inputs of configuration files; those that were there before stay the same ones.
    fn configuration(&mut self, list: &[LoadedFile]) -> Vec<ConfigFile> {
        let old = std::mem::take(&mut self.state.configuration);
        let mut files = BTreeMap::new();
        let mut inputs = Vec::new();
        for file in list {
            let input = match old.get(&file.path).copied() {
                Some(input) => {
                    if *input.text(&self.db) != file.text {
                        input.set_text(&mut self.db).to(file.text.clone());
                    }
                    input
                }
                None => ConfigFile::builder(file.path.clone(), file.text.clone())
                    .path_durability(Durability::HIGH)
                    .new(&self.db),
            };
            files.insert(file.path.clone(), input);
            inputs.push(input);
        }
        self.state.configuration = Arc::new(files);
        inputs
    }

    fn input(&mut self, old: &BTreeMap<String, SourceFile>, file: &LoadedFile) -> SourceFile {
        match old.get(&file.path) {
            Some(input) => {
                if *input.text(&self.db) != file.text {
                    input.set_text(&mut self.db).to(file.text.clone());
                }
                if input.order(&self.db) != file.order {
                    input.set_order(&mut self.db).to(file.order);
                }
                *input
            }
            None => SourceFile::builder(file.path.clone(), file.text.clone(), file.order)
                .durability(Durability::MEDIUM)
                .path_durability(Durability::HIGH)
                .new(&self.db),
        }
    }
}

/// The problems of loading with the severities of `[lints]`.
fn lowered(loaded: &LoadedProject) -> Vec<(String, Diagnostic)> {
    let lints = &loaded.manifest.lints;
    let mut problems = Vec::new();
    for (file, problem) in &loaded.problems {
        match lints.get(problem.code) {
            Some(None) => {}
            Some(Some(severity)) => {
                problems.push((file.clone(), Diagnostic { severity: *severity, ..problem.clone() }));
            }
            None => problems.push((file.clone(), problem.clone())),
        }
    }
    problems
}

impl Analysis {
    /// Runs a question against the database; `None` inside when no project is loaded.
    pub(crate) fn with<T>(&self, question: impl FnOnce(&Database, Option<Project>) -> T) -> Cancellable<T> {
        Cancelled::catch(AssertUnwindSafe(|| question(&self.db, self.state.project)))
    }

    /// The input of a file by its project path.
    pub(crate) fn file(&self, path: &str) -> Option<SourceFile> {
        self.state.files.get(path).copied()
    }

    /// The input of a configuration file by its project path.
    pub(crate) fn configuration_file(&self, path: &str) -> Option<ConfigFile> {
        self.state.configuration.get(path).copied()
    }

    /// Mistakes of one file, sorted; `technol.toml` and configuration files have some too.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn diagnostics(&self, file: &str) -> Cancellable<Vec<Diagnostic>> {
        let mut found: Vec<Diagnostic> =
            self.state.problems.iter().filter(|(path, _)| path == file).map(|(_, d)| d.clone()).collect();
        if let Some(source) = self.file(file) {
            let own = self.with(|db, project| {
                project
                    .map_or_else(Vec::new, |project| database::file_diagnostics(db, project, source).clone())
            })?;
            found.extend(own);
        }
        if let Some(file) = self.configuration_file(file) {
            let own = self.with(|db, project| {
                project.map_or_else(Vec::new, |project| {
                    database::configuration_diagnostics(db, project, file).clone()
                })
            })?;
            found.extend(own);
        }
        found.sort_by(|a, b| (a.span, a.code).cmp(&(b.span, b.code)));
        Ok(found)
    }

    /// The change that allows a diagnostic of a file on its line; `None` when its rule cannot be allowed, or when the
    /// file is no program text.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn allow(&self, file: &str, diagnostic: &Diagnostic) -> Cancellable<Option<Fix>> {
        let Some(source) = self.file(file) else { return Ok(None) };
        self.with(|db, _| {
            let line = crate::syntax::lines(source.text(db)).nth(diagnostic.span.start.line as usize)?;
            crate::diagnostics::allow::fix(diagnostic, line.text)
        })
    }

    /// Mistakes of every file that has some, program files in order of execution first.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn all_diagnostics(&self) -> Cancellable<Vec<(String, Vec<Diagnostic>)>> {
        let mut all = Vec::new();
        for path in self.file_paths()? {
            let found = self.diagnostics(&path)?;
            if !found.is_empty() {
                all.push((path, found));
            }
        }
        Ok(all)
    }

    /// Project paths of everything that can have diagnostics: manifest, program files in order of execution,
    /// included files, configuration files, files that could not be read.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn file_paths(&self) -> Cancellable<Vec<String>> {
        let mut paths: Vec<String> = self.state.manifest.iter().map(|(path, _)| path.clone()).collect();
        let sources = self.with(|db, project| {
            let Some(project) = project else { return Vec::new() };
            let files = project.files(db).iter().chain(project.included(db));
            let configuration = project.configuration(db).iter().map(|file| file.path(db).clone());
            files.map(|file| file.path(db).clone()).chain(configuration).collect()
        })?;
        paths.extend(sources);
        for (path, _) in self.state.problems.iter() {
            if !paths.contains(path) {
                paths.push(path.clone());
            }
        }
        Ok(paths)
    }

    /// The text of a file of the project, or of its manifest.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn text(&self, file: &str) -> Cancellable<Option<Arc<str>>> {
        if let Some((_, text)) = self.state.manifest.as_ref().filter(|(path, _)| path == file) {
            return Ok(Some(text.clone()));
        }
        if let Some(file) = self.configuration_file(file) {
            return self.with(|db, _| Some(file.text(db).clone()));
        }
        let Some(source) = self.file(file) else { return Ok(None) };
        self.with(|db, _| Some(source.text(db).clone()))
    }
}
