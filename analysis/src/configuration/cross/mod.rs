//! Configuration files and program against each other. What is wrong is reported where it is wrong: in the source or
//! in the configuration file.
//!
//! The sources are looked at section by section, and depend on the configuration alone; what a configuration file
//! needs of the program comes from all its sections together, without places.

mod commands;
mod configured;
mod connections;
mod identifiers;
pub(crate) mod logical;
mod messages;
mod ports;
mod program;
mod repeated;
mod tables;
mod unused;

use crate::database::{self, ConfigFile, Db, Project, Section};
use crate::diagnostics::{Diagnostic, Finding, Fix, Rule};
use crate::location::{Location, Span};

pub(crate) use configured::configured;
pub use configured::{Configured, Defined, Definition};
pub use program::ProjectUses;
pub(crate) use program::project_uses;

/// What is wrong in a section.
pub(crate) fn of_section(db: &dyn Db, project: Project, section: Section<'_>) -> Vec<Finding> {
    // Most programs of a test, and every lone file, have no configuration: they should not pay for it.
    if project.configuration(db).is_empty() {
        return Vec::new();
    }
    let uses = database::section_identifiers(db, project, section);
    let configured = database::configured(db, project);
    let mut findings = Vec::new();
    identifiers::check(uses, configured, &mut findings);
    messages::check(uses, configured, &mut findings);
    let listed = project.settings(db).configuration_listed;
    tables::check(uses, configured, listed, &mut findings);
    ports::check(uses, configured, &mut findings);
    commands::check(uses, configured, &mut findings);
    findings
}

/// What is wrong in a configuration file, with the severities of the project, sorted.
pub(crate) fn of_file(db: &dyn Db, project: Project, file: ConfigFile) -> Vec<Diagnostic> {
    let configuration = database::configuration_file(db, file);
    let mut report = Report { db, project, path: file.path(db), found: Vec::new() };
    for problem in &configuration.problems {
        let mut found = diagnostic(problem.rule, problem.span, problem.message.clone());
        if let Some((span, note)) = &problem.beside {
            found.related.push((Location { file: file.path(db).clone(), span: *span }, note.clone()));
        }
        found.fix = problem
            .fix
            .as_ref()
            .map(|(title, span, text)| Fix { title: title.clone(), edits: vec![(*span, text.clone())] });
        report.add(found);
    }
    if !configuration.broken {
        let configured = database::configured(db, project);
        let uses = database::configuration_uses(db, project);
        repeated::check(configuration, configured, &mut report);
        connections::check(configuration, uses, &mut report);
        tables::check_values(configuration, configured, &mut report);
        commands::check_buttons(configuration, configured, uses, &mut report);
        messages::check_persistent(configuration, uses, &mut report);
        unused::check(configuration, configured, uses, &mut report);
    }
    let mut found = report.found;
    found.sort_by(|a, b| (a.span, a.code, &a.message).cmp(&(b.span, b.code, &b.message)));
    found.dedup();
    found
}

/// Diagnostics of a configuration file in the making.
struct Report<'db> {
    db: &'db dyn Db,
    project: Project,
    path: &'db str,
    found: Vec<Diagnostic>,
}

impl Report<'_> {
    /// Reports a mistake; one with a likely remedy offers that for its place.
    fn suggest(&mut self, rule: &'static Rule, span: Span, message: String, near: Option<&str>) {
        let mut diagnostic = diagnostic(rule, span, message);
        if let Some(near) = near {
            diagnostic.message = format!("{}; did you mean {near}?", diagnostic.message);
            let edits = vec![(span, near.to_string())];
            diagnostic.fix = Some(Fix { title: format!("write {near}"), edits });
        }
        self.add(diagnostic);
    }

    /// Reports a mistake.
    fn report(&mut self, rule: &'static Rule, span: Span, message: String) {
        self.add(diagnostic(rule, span, message));
    }

    fn add(&mut self, mut diagnostic: Diagnostic) {
        match self.project.settings(self.db).lints.get(diagnostic.code) {
            Some(None) => return,
            Some(Some(severity)) => diagnostic.severity = *severity,
            None => {}
        }
        self.found.push(diagnostic);
    }
}

/// A diagnostic with the severity of its rule.
fn diagnostic(rule: &'static Rule, span: Span, message: String) -> Diagnostic {
    let (code, severity) = (rule.code, rule.severity);
    Diagnostic { code, severity, message, span, related: Vec::new(), fix: None }
}
