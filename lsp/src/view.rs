//! What a request sees: one state of one project, whatever happens meanwhile.

use std::sync::Arc;

use ropey::Rope;
use technol_analysis::{Analysis, Language, Location, Position, Span};
use tower_lsp::ls_types as lsp;

use crate::client::Client;
use crate::file_key::FileKey;
use crate::positions;
use crate::project::{FileState, Files, Project};
use crate::settings::Settings;

/// A project as it was when the request came.
pub(crate) struct View {
    /// The analysis of that state.
    pub(crate) analysis: Analysis,
    /// Name of the file the request is about.
    pub(crate) file: String,
    /// The file is no program, see [`Project::is_fragment`].
    pub(crate) fragment: bool,
    /// Language of help texts.
    pub(crate) language: Language,
    /// What the client can do.
    pub(crate) client: Client,
    files: Arc<Files>,
    root: FileKey,
}

impl View {
    /// The present state of `project`.
    pub(crate) fn new(project: &Project, file: &str, settings: Settings, client: Client) -> View {
        View {
            analysis: project.analysis(),
            file: file.to_owned(),
            fragment: project.is_fragment(),
            language: settings.language,
            client,
            files: project.files(),
            root: project.root().clone(),
        }
    }

    /// The state of a file.
    pub(crate) fn state(&self, file: &str) -> Option<&FileState> {
        self.files.get(file)
    }

    /// The analysis' position for the client's, in the request's file.
    pub(crate) fn position(&self, position: lsp::Position) -> Position {
        match self.state(&self.file) {
            Some(state) => positions::to_analysis(&state.text, position, self.client.encoding),
            None => Position::default(),
        }
    }

    /// The client's range for a span of `file`.
    pub(crate) fn range(&self, file: &str, span: Span) -> lsp::Range {
        match self.state(file) {
            Some(state) => positions::to_range(&state.text, span, self.client.encoding),
            // Nothing is known about a text that could not be read: its beginning is all there is.
            None => positions::to_range(&Rope::new(), span, self.client.encoding),
        }
    }

    /// The client's range for a span of the request's file.
    pub(crate) fn range_here(&self, span: Span) -> lsp::Range {
        self.range(&self.file, span)
    }

    /// The address of a file.
    pub(crate) fn uri(&self, file: &str) -> Option<lsp::Uri> {
        match self.state(file) {
            Some(state) => Some(state.uri.clone()),
            None => FileKey::in_project(&self.root, file).uri(),
        }
    }

    /// The client's location for the analysis'.
    pub(crate) fn location(&self, location: &Location) -> Option<lsp::Location> {
        Some(lsp::Location {
            uri: self.uri(&location.file)?,
            range: self.range(&location.file, location.span),
        })
    }
}
