//! Reads a project: manifest or lone file, program files, included files.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::include::{IncludeTarget, include_names};
use super::manifest::{EncodingChoice, Manifest, Spanned, parse_manifest};
use super::path::{folder, has_extension, is_absolute, project_path, readable, slashes, whole};
use super::{Encoding, FileReader, LoadedFile, LoadedProject, MANIFEST, decode};
use crate::diagnostics::rules::project as rules;
use crate::diagnostics::{Diagnostic, Rule};
use crate::location::{Location, Span};

/// Reads the project at a folder, at a manifest, or of a lone `.plc` file.
///
/// Never fails: what cannot be read is among the [problems](LoadedProject::problems).
pub fn load(root_or_file: &str, reader: &dyn FileReader) -> LoadedProject {
    let given = slashes(root_or_file);
    let given = if given == "/" { given.as_str() } else { given.trim_end_matches('/') };
    let mut project = LoadedProject::default();
    if is_program(given) {
        project.root = folder(given).to_string();
        let name = given.rsplit('/').next().unwrap_or(given).to_string();
        project.manifest.name = name[..name.len() - 4].to_string();
        project.manifest.main = Spanned { text: name, span: 0..0 };
    } else {
        let (root, name) = if has_extension(given, "toml") {
            (folder(given), given.rsplit('/').next().unwrap_or(given))
        } else {
            (if given == "." { "" } else { given }, MANIFEST)
        };
        project.root = root.to_string();
        read_manifest(&mut project, name, reader);
    }
    let lone = is_program(given);
    let mut loader = Loader { project, reader, open: Vec::new(), done: BTreeSet::new() };
    loader.program_files();
    loader.include_graph();
    // A lone text belongs to nobody's machine.
    if !lone {
        super::configuration::find(&mut loader);
    }
    loader.project
}

fn is_program(path: &str) -> bool {
    has_extension(path, "plc") || has_extension(path, "inc")
}

/// What to hand to [`load`] for a file: the nearest folder above it whose manifest lists it, or the file itself.
pub fn discover(file: &str, reader: &dyn FileReader) -> String {
    let file = slashes(file);
    let mut at = folder(&file);
    loop {
        if let Ok(bytes) = reader.read(&readable(at, MANIFEST)) {
            let (manifest, _) = parse_manifest(&decode(&bytes, None).text);
            let own = whole("", &file);
            let mut listed = std::iter::once(&manifest.main).chain(&manifest.files);
            let is_inc = has_extension(&own, "inc");
            if is_inc || listed.any(|entry| whole(at, &slashes(&entry.text)) == own) {
                return if at.is_empty() { ".".to_string() } else { at.to_string() };
            }
        }
        if at.is_empty() || at == "/" {
            return file;
        }
        at = folder(at);
    }
}

fn read_manifest(project: &mut LoadedProject, name: &str, reader: &dyn FileReader) {
    let last = project.root.rsplit('/').next().unwrap_or_default().to_string();
    match reader.read(&readable(&project.root, name)) {
        Ok(bytes) => {
            let decoded = decode(&bytes, Some(Encoding::Utf8));
            let (manifest, errors) = parse_manifest(&decoded.text);
            if let Some((at, why)) = decoded.problem {
                let span = undecodable(&decoded.text, at);
                let message = format!("{why}; a manifest is always UTF-8");
                project.problems.push((name.to_string(), problem(&rules::UNDECODABLE, span, message)));
            }
            for error in errors {
                let span = Span::of_bytes(&decoded.text, error.range);
                project.problems.push((name.to_string(), problem(error.rule, span, error.message)));
            }
            project.manifest = manifest;
            project.manifest_file = Some((name.to_string(), Arc::from(decoded.text)));
        }
        Err(why) => {
            project.manifest = Manifest::default();
            // A folder with a main.plc and nothing else is a project too.
            if reader.read(&readable(&project.root, &project.manifest.main.text)).is_err() {
                let message = format!("{name} cannot be read ({why}); create it, or name a .plc file");
                project
                    .problems
                    .push((name.to_string(), problem(&rules::MISSING_FILE, Span::default(), message)));
            }
        }
    }
    if project.manifest.name.is_empty() {
        project.manifest.name = if last.is_empty() { "program".to_string() } else { last };
    }
}

pub(super) fn problem(rule: &'static Rule, span: Span, message: String) -> Diagnostic {
    Diagnostic { code: rule.code, severity: rule.severity, message, span, related: Vec::new(), fix: None }
}

/// The place in a decoded text of the first byte that has no character. Replacement characters are longer than what
/// they stand for and a byte order mark is not in the text: the place is that of the first of them.
pub(super) fn undecodable(text: &str, byte: usize) -> Span {
    match text.find('\u{FFFD}') {
        Some(at) => Span::of_bytes(text, at..at + '\u{FFFD}'.len_utf8()),
        None => Span::of_bytes(text, byte..byte),
    }
}

pub(super) struct Loader<'a> {
    pub(super) project: LoadedProject,
    pub(super) reader: &'a dyn FileReader,
    /// Files whose inclusions are being followed, outermost first.
    open: Vec<String>,
    /// Files whose inclusions are known.
    done: BTreeSet<String>,
}

impl Loader<'_> {
    pub(super) fn manifest_problem(
        &mut self,
        rule: &'static Rule,
        entry: &Spanned,
        message: String,
    ) -> Option<&mut Diagnostic> {
        let (path, span) = match &self.project.manifest_file {
            Some((path, text)) => (path.clone(), Span::of_bytes(text, entry.span.clone())),
            None => (entry.text.clone(), Span::default()),
        };
        self.project.problems.push((path, problem(rule, span, message)));
        self.project.problems.last_mut().map(|(_, diagnostic)| diagnostic)
    }

    pub(super) fn encoding(&self) -> Option<Encoding> {
        match self.project.manifest.encoding {
            EncodingChoice::Auto => None,
            EncodingChoice::Fixed(encoding) => Some(encoding),
        }
    }

    fn program_files(&mut self) {
        // An unreadable folder is reported once.
        if self.project.manifest_file.is_none() && !self.project.problems.is_empty() {
            return;
        }
        let manifest = &self.project.manifest;
        let entries: Vec<Spanned> = std::iter::once(&manifest.main).chain(&manifest.files).cloned().collect();
        let mut seen: BTreeMap<String, Spanned> = BTreeMap::new();
        for entry in entries {
            let path = project_path(&self.project.root, &slashes(&entry.text));
            let name = &entry.text;
            if is_absolute(&path) || path.starts_with("../") {
                let message = format!("{name} lies outside the project folder; move it into the folder");
                self.manifest_problem(&rules::OUTSIDE_FILE, &entry, message);
                continue;
            }
            if let Some(first) = seen.get(&path).cloned() {
                let message = format!("{name} is listed twice; remove one entry");
                let first = self.project.manifest_file.as_ref().map(|(file, text)| {
                    let span = Span::of_bytes(text, first.span);
                    (Location { file: file.clone(), span }, "the first one".to_string())
                });
                if let Some(diagnostic) = self.manifest_problem(&rules::DUPLICATE_FILE, &entry, message) {
                    diagnostic.related.extend(first);
                }
                continue;
            }
            seen.insert(path.clone(), entry.clone());
            match self.read(&path) {
                Ok((text, encoding)) => {
                    let order = Some(self.project.files.len() as u8);
                    self.project.files.push(LoadedFile { path, text, encoding, order });
                }
                Err(why) => {
                    let message = format!(
                        "{name} cannot be read: {why}; create it, or correct `main` and `files` of [project] in \
                         technol.toml, which name the files of the program"
                    );
                    self.manifest_problem(&rules::MISSING_FILE, &entry, message);
                }
            }
        }
    }

    fn read(&mut self, path: &str) -> Result<(Arc<str>, Encoding), String> {
        let bytes = self.reader.read(&readable(&self.project.root, path))?;
        let decoded = decode(&bytes, self.encoding());
        if let Some((at, why)) = decoded.problem {
            let span = undecodable(&decoded.text, at);
            let message = format!("{why}; set `encoding` in technol.toml, or save the file again");
            self.project.problems.push((path.to_string(), problem(&rules::UNDECODABLE, span, message)));
        }
        Ok((Arc::from(decoded.text), decoded.encoding))
    }

    fn include_graph(&mut self) {
        for index in 0..self.project.files.len() {
            let file = self.project.files[index].clone();
            self.follow(&file.path, &file.text);
        }
    }

    fn follow(&mut self, path: &str, text: &str) {
        if !self.done.insert(path.to_string()) {
            return;
        }
        self.open.push(path.to_string());
        for (name, quoted) in include_names(text) {
            let key = (path.to_string(), name.clone());
            if self.project.includes.contains_key(&key) {
                continue;
            }
            let (target, next) = self.target(&name, quoted);
            self.project.includes.insert(key, target);
            if let Some((path, text)) = next {
                self.follow(&path, &text);
            }
        }
        self.open.pop();
    }

    /// Where a name leads, and the file to follow when it is new.
    fn target(&mut self, name: &str, quoted: bool) -> (IncludeTarget, Option<(String, Arc<str>)>) {
        // Each level follows one more file; a chain this long is a mistake, and following it needs a stack.
        if self.open.len() > 64 {
            return (IncludeTarget::Missing("inclusions are nested more than 64 deep".to_string()), None);
        }
        let places = match self.places(name, quoted) {
            Ok(places) => places,
            Err(why) => return (IncludeTarget::Missing(why), None),
        };
        let mut tried = Vec::new();
        for place in places {
            let path = project_path(&self.project.root, &place);
            if let Some(at) = self.open.iter().position(|open| *open == path) {
                let mut circle: Vec<&str> = self.open[at..].iter().map(String::as_str).collect();
                circle.push(&path);
                return (IncludeTarget::Cyclic(circle.join(" → ")), None);
            }
            if self.project.files.iter().any(|file| file.path == path) {
                return (
                    IncludeTarget::Missing(format!("{path} is a program file of the project already")),
                    None,
                );
            }
            // The control's file names know no case.
            let known = |file: &&LoadedFile| file.path.eq_ignore_ascii_case(&path);
            if let Some(file) = self.project.included.iter().find(known) {
                return (IncludeTarget::File(file.path.clone()), None);
            }
            let (dir, own) = path.rfind('/').map_or(("", path.as_str()), |at| path.split_at(at + 1));
            let mut spellings = vec![path.clone()];
            for other in [own.to_ascii_uppercase(), own.to_ascii_lowercase()] {
                let other = format!("{dir}{other}");
                if !spellings.contains(&other) {
                    spellings.push(other);
                }
            }
            for path in spellings {
                if let Ok((text, encoding)) = self.read(&path) {
                    let file = LoadedFile { path: path.clone(), text: text.clone(), encoding, order: None };
                    self.project.included.push(file);
                    return (IncludeTarget::File(path.clone()), Some((path, text)));
                }
            }
            tried.push(path);
        }
        (IncludeTarget::Missing(format!("{name} is not found; looked for {}", tried.join(", "))), None)
    }

    /// Paths to try, relative to the root or absolute.
    fn places(&self, name: &str, quoted: bool) -> Result<Vec<String>, String> {
        let name = slashes(name);
        if is_absolute(&name) {
            return Ok(vec![name]);
        }
        let manifest = &self.project.manifest;
        let under = |dir: &str| if dir.is_empty() { name.clone() } else { format!("{dir}/{name}") };
        if quoted {
            let Some(system) = &manifest.system_dir else {
                return Err(format!(
                    "'{name}' is searched in the system folder; set `system-dir` in technol.toml"
                ));
            };
            return Ok(vec![under(slashes(&system.text).trim_end_matches('/'))]);
        }
        // The PLC source is the program file that is being read, also within the files it includes.
        let source = self.open.first().map_or("", |file| folder(file));
        let main = slashes(&manifest.main.text);
        let dirs =
            manifest.include_dirs.iter().map(|dir| slashes(&dir.text).trim_end_matches('/').to_string());
        let mut places: Vec<String> = Vec::new();
        for dir in [source.to_string(), folder(&main).to_string()].into_iter().chain(dirs) {
            let place = under(&dir);
            if !places.contains(&place) {
                places.push(place);
            }
        }
        Ok(places)
    }
}
