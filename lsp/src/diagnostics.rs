//! Diagnostics on their way to the client.

use std::collections::{BTreeMap, BTreeSet};

use technol_analysis::{Cancellable, Diagnostic, Severity};
use tower_lsp::ls_types as lsp;

use crate::file_key::FileKey;
use crate::project::Home;
use crate::view::View;

/// Codes of rules about single lines, the only ones that hold for a fragment of a program.
const SPELLING: &str = "T01";

/// The diagnostics of one state of a project.
#[derive(Debug)]
pub(crate) struct Diagnosed {
    /// The project.
    pub(crate) home: Home,
    /// Its state.
    pub(crate) revision: u64,
    /// All of the project was looked at, so that files without an entry have no diagnostics.
    pub(crate) complete: bool,
    /// Files with diagnostics, and all open files.
    pub(crate) files: Vec<DiagnosedFile>,
}

/// The diagnostics of a file.
#[derive(Debug)]
pub(crate) struct DiagnosedFile {
    /// Its address.
    pub(crate) uri: lsp::Uri,
    /// Version of the document they were computed from, when it is open.
    pub(crate) version: Option<i32>,
    /// What was found.
    pub(crate) found: Vec<lsp::Diagnostic>,
}

/// What was found in the open files, which somebody looks at: told before the rest of the project is looked at.
pub(crate) fn diagnose_open(view: &View, open: &BTreeSet<String>) -> Cancellable<Vec<DiagnosedFile>> {
    let mut files = Vec::new();
    for file in open {
        files.extend(diagnosed(view, file, view.analysis.diagnostics(file)?));
    }
    Ok(files)
}

/// Everything found in a project, and an entry for each open file, so that its version is told.
pub(crate) fn diagnose(view: &View, open: &BTreeSet<String>) -> Cancellable<Vec<DiagnosedFile>> {
    let mut found: BTreeMap<String, Vec<Diagnostic>> = view.analysis.all_diagnostics()?.into_iter().collect();
    for file in open {
        found.entry(file.clone()).or_default();
    }
    Ok(found.into_iter().filter_map(|(file, found)| diagnosed(view, &file, found)).collect())
}

fn diagnosed(view: &View, file: &str, mut found: Vec<Diagnostic>) -> Option<DiagnosedFile> {
    found.retain(|it| !view.fragment || it.code.starts_with(SPELLING));
    Some(DiagnosedFile {
        uri: view.uri(file)?,
        version: view.state(file).and_then(|it| it.version),
        found: found.iter().map(|it| to_client(view, file, it)).collect(),
    })
}

/// The protocol's form of a diagnostic of `file`.
pub(crate) fn to_client(view: &View, file: &str, diagnostic: &Diagnostic) -> lsp::Diagnostic {
    let severity = match diagnostic.severity {
        Severity::Error => lsp::DiagnosticSeverity::ERROR,
        Severity::Warning => lsp::DiagnosticSeverity::WARNING,
        Severity::Info => lsp::DiagnosticSeverity::INFORMATION,
        Severity::Hint => lsp::DiagnosticSeverity::HINT,
    };
    let related: Vec<_> = diagnostic
        .related
        .iter()
        .filter(|_| view.client.related_places)
        .filter_map(|(place, message)| {
            let location = view.location(place)?;
            Some(lsp::DiagnosticRelatedInformation { location, message: message.clone() })
        })
        .collect();
    lsp::Diagnostic {
        range: view.range(file, diagnostic.span),
        severity: Some(severity),
        code: Some(lsp::NumberOrString::String(diagnostic.code.to_owned())),
        source: Some("technol".into()),
        message: diagnostic.message.clone(),
        tags: (view.client.diagnostic_tags && is_unnecessary(diagnostic))
            .then(|| vec![lsp::DiagnosticTag::UNNECESSARY]),
        related_information: (!related.is_empty()).then_some(related),
        ..lsp::Diagnostic::default()
    }
}

/// What is marked does nothing: editors show it faded.
fn is_unnecessary(diagnostic: &Diagnostic) -> bool {
    technol_analysis::diagnostics::rule(diagnostic.code).is_some_and(|rule| rule.unnecessary)
}

/// What the client was told last, so that it is told of every change and of nothing else.
#[derive(Debug, Default)]
pub(crate) struct Published {
    files: BTreeMap<FileKey, Told>,
}

/// Diagnostics of one file, by the project that found them: an included file can belong to several.
#[derive(Debug)]
struct Told {
    uri: lsp::Uri,
    version: Option<i32>,
    found: BTreeMap<Home, Vec<lsp::Diagnostic>>,
}

impl Published {
    /// Takes over the diagnostics of a project; returns what to tell the client. What other files have stays as it is
    /// unless these are `complete`.
    pub(crate) fn update(
        &mut self,
        home: &Home,
        files: Vec<DiagnosedFile>,
        complete: bool,
    ) -> Vec<lsp::PublishDiagnosticsParams> {
        let mut messages = Vec::new();
        let mut named = BTreeSet::new();
        for file in files {
            let key = FileKey::of_uri(&file.uri);
            named.insert(key.clone());
            let told = self.files.entry(key).or_insert_with(|| Told {
                uri: file.uri.clone(),
                version: None,
                found: BTreeMap::new(),
            });
            let before = told.found.insert(home.clone(), file.found.clone()).unwrap_or_default();
            // A new version is told even when nothing else is new: the client learns that it was looked at.
            if before != file.found || told.version != file.version {
                told.uri = file.uri;
                told.version = file.version;
                messages.push(told.message());
            }
        }
        if complete {
            messages.extend(self.withdraw(home, |key| !named.contains(key)));
        }
        messages
    }

    /// The project is gone, and what it found with it.
    pub(crate) fn drop_project(&mut self, home: &Home) -> Vec<lsp::PublishDiagnosticsParams> {
        self.withdraw(home, |_| true)
    }

    fn withdraw(
        &mut self,
        home: &Home,
        which: impl Fn(&FileKey) -> bool,
    ) -> Vec<lsp::PublishDiagnosticsParams> {
        let mut messages = Vec::new();
        self.files.retain(|key, told| {
            if which(key)
                && let Some(found) = told.found.remove(home)
                && !found.is_empty()
            {
                if told.found.is_empty() {
                    told.version = None; // nobody looks at it any more, in whatever version
                }
                messages.push(told.message());
            }
            !told.found.is_empty()
        });
        messages
    }
}

impl Told {
    fn message(&self) -> lsp::PublishDiagnosticsParams {
        let mut diagnostics: Vec<lsp::Diagnostic> = Vec::new();
        for it in self.found.values().flatten() {
            if !diagnostics.contains(it) {
                diagnostics.push(it.clone());
            }
        }
        lsp::PublishDiagnosticsParams { uri: self.uri.clone(), diagnostics, version: self.version }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn home(name: &str) -> Home {
        Home::Folder(FileKey::of_path(name))
    }

    fn file(name: &str, version: Option<i32>, messages: &[&str]) -> DiagnosedFile {
        let found = messages
            .iter()
            .map(|it| lsp::Diagnostic { message: (*it).to_owned(), ..lsp::Diagnostic::default() })
            .collect();
        DiagnosedFile { uri: format!("file:///{name}").parse().unwrap(), version, found }
    }

    fn told(messages: &[lsp::PublishDiagnosticsParams]) -> Vec<String> {
        let line = |it: &lsp::PublishDiagnosticsParams| {
            let found: Vec<_> = it.diagnostics.iter().map(|it| it.message.as_str()).collect();
            format!("{} {:?} {}", it.uri.path(), it.version, found.join("+"))
        };
        messages.iter().map(line).collect()
    }

    #[test]
    fn the_client_hears_what_is_new_and_what_is_gone_once() {
        let mut published = Published::default();
        let a = home("/a");
        let first = published.update(&a, vec![file("x", None, &["bad"]), file("y", None, &["worse"])], true);
        assert_eq!(told(&first), ["/x None bad", "/y None worse"]);
        assert!(
            published
                .update(&a, vec![file("x", None, &["bad"]), file("y", None, &["worse"])], true)
                .is_empty()
        );
        assert_eq!(told(&published.update(&a, vec![file("x", None, &["bad"])], true)), ["/y None "]);
        assert_eq!(told(&published.drop_project(&a)), ["/x None "]);
        assert!(published.drop_project(&a).is_empty());
    }

    #[test]
    fn the_open_files_come_first_and_take_nothing_back() {
        let mut published = Published::default();
        let a = home("/a");
        published.update(&a, vec![file("x", Some(1), &["bad"]), file("y", None, &["worse"])], true);
        let open = published.update(&a, vec![file("x", Some(2), &["new"])], false);
        assert_eq!(told(&open), ["/x Some(2) new"]);
        let all = published.update(&a, vec![file("x", Some(2), &["new"])], true);
        assert_eq!(told(&all), ["/y None "]);
    }

    #[test]
    fn every_version_is_told_even_without_news() {
        let mut published = Published::default();
        assert_eq!(
            told(&published.update(&home("/a"), vec![file("x", Some(1), &[])], true)),
            ["/x Some(1) "]
        );
        assert_eq!(
            told(&published.update(&home("/a"), vec![file("x", Some(2), &[])], true)),
            ["/x Some(2) "]
        );
        assert!(published.update(&home("/a"), vec![file("x", Some(2), &[])], true).is_empty());
    }

    #[test]
    fn a_file_of_two_projects_shows_the_diagnostics_of_both() {
        let mut published = Published::default();
        published.update(&home("/a"), vec![file("x", None, &["same", "a"])], true);
        let both = published.update(&home("/b"), vec![file("x", None, &["same", "b"])], true);
        assert_eq!(told(&both), ["/x None same+a+b"]);
        assert_eq!(told(&published.drop_project(&home("/a"))), ["/x None same+b"]);
    }
}
