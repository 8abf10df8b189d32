//! The features as questions to a snapshot.

use super::{Completion, DocumentSymbol, Hover, Reference, SignatureHelp, WorkspaceSymbol};
use crate::catalogue::Language;
use crate::database::{Database, Project, SourceFile};
use crate::location::{Location, Position};
use crate::{Analysis, Cancellable};

impl Analysis {
    /// Help on what stands at a position.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn hover(&self, file: &str, at: Position, language: Language) -> Cancellable<Option<Hover>> {
        if let Some(own) = self.configuration_file(file) {
            return self.with(|db, project| {
                project.and_then(|project| super::configured::hover_in_file(db, project, own, at, language))
            });
        }
        self.ask(file, |db, project, source| super::hover(db, project, source, at, language))
    }

    /// Where the name at a position is declared.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn definition(&self, file: &str, at: Position) -> Cancellable<Vec<Location>> {
        if let Some(own) = self.configuration_file(file) {
            return self.with(|db, project| {
                project.map_or_else(Vec::new, |it| super::configured::definition_in_file(db, it, own, at))
            });
        }
        self.ask(file, |db, project, source| super::definition(db, project, source, at))
    }

    /// Uses of the name at a position, in order of files and text.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn references(
        &self,
        file: &str,
        at: Position,
        include_declaration: bool,
    ) -> Cancellable<Vec<Reference>> {
        if let Some(own) = self.configuration_file(file) {
            return self.with(|db, project| {
                let all = |it| super::configured::references_in_file(db, it, own, at, include_declaration);
                project.map_or_else(Vec::new, all)
            });
        }
        self.ask(file, |db, project, source| super::references(db, project, source, at, include_declaration))
    }

    /// Outline of a file.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn document_symbols(&self, file: &str) -> Cancellable<Vec<DocumentSymbol>> {
        self.ask(file, |db, _, source| super::document_symbols(db, source))
    }

    /// Declared names of the project that match a query, best first.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn workspace_symbols(&self, query: &str) -> Cancellable<Vec<WorkspaceSymbol>> {
        self.with(|db, project| project.map_or_else(Vec::new, |it| super::workspace_symbols(db, it, query)))
    }

    /// Words that may be written at a position, best first.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn completion(&self, file: &str, at: Position, language: Language) -> Cancellable<Vec<Completion>> {
        self.ask(file, |db, project, source| super::completion(db, project, source, at, language))
    }

    /// The operands of the instruction that is being written at a position.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn signature_help(
        &self,
        file: &str,
        at: Position,
        language: Language,
    ) -> Cancellable<Option<SignatureHelp>> {
        self.ask(file, |db, project, source| super::signature_help(db, project, source, at, language))
    }

    /// A question about a file; the empty answer when it does not belong to the project.
    fn ask<T: Default>(
        &self,
        file: &str,
        question: impl FnOnce(&Database, Project, SourceFile) -> T,
    ) -> Cancellable<T> {
        let source = self.file(file);
        self.with(|db, project| match (project, source) {
            (Some(project), Some(source)) => question(db, project, source),
            _ => T::default(),
        })
    }
}
