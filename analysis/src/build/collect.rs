//! Building from the database: collects what the queries know, and turns what went wrong into diagnostics.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use technol_image::program::ContentHash;

use super::input::{BuildProblem, FileInput, ProjectInput, SectionInput};
use super::section_code::SectionCode;
use super::{Built, build, fingerprint, listing, lower};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::diagnostics::{Diagnostic, Severity};
use crate::host::{Analysis, Cancellable};
use crate::location::Span;
use crate::semantics::macros::expand::Expansion;
use crate::semantics::program;
use crate::syntax::section::SectionKind;

/// The code of a section. Made again only when the meaning of the section changes, not when it moves.
#[salsa::tracked]
pub fn section_code<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> SectionCode {
    let body = &database::section_analysis(db, project, section).body;
    lower(section.kind(db), section_length(db, section), body)
}

/// Number of own lines of a section. A query of its own: a comment changes the text but not this.
#[salsa::tracked(returns(copy))]
pub fn section_length<'db>(db: &'db dyn Db, section: Section<'db>) -> u32 {
    section.text(db).lines().count() as u32
}

/// Own lines of a section that call macros, each with whether it takes break-points.
#[salsa::tracked]
pub fn macro_call_lines<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> Vec<(u32, bool)> {
    database::expansion_of(db, project, section).map_or_else(Vec::new, Expansion::call_lines)
}

fn call_lines<'db>(db: &'db dyn Db, project: Project, section: Section<'db>) -> &'db [(u32, bool)] {
    if database::has_macros(db, project) { macro_call_lines(db, project, section) } else { &[] }
}

/// Whether sections of this kind become code.
const fn has_code(kind: SectionKind) -> bool {
    matches!(kind, SectionKind::Module(_) | SectionKind::Mechanism | SectionKind::Procedure)
}

fn all_files(db: &dyn Db, project: Project) -> impl Iterator<Item = SourceFile> {
    project.files(db).iter().chain(project.included(db)).copied()
}

/// Collects the input of a build.
fn collect(db: &dyn Db, project: Project) -> ProjectInput<'_> {
    let mut index = HashMap::new();
    let mut files = Vec::new();
    for file in all_files(db, project) {
        index.insert(file, files.len() as u16);
        files.push(FileInput { path: file.path(db), order: file.order(db), text: file.text(db) });
    }
    let sections = program::blocks(db, project).into_iter().map(|block| {
        let section = block.part.section;
        let code = has_code(block.kind) && !block.expanded;
        SectionInput {
            file: index.get(&section.file(db)).copied().unwrap_or_default(),
            owner: block.part.file,
            kind: block.kind,
            name: section.name(db),
            ordinal: section.ordinal(db),
            lines: section.lines(db),
            text: section.text(db),
            declarations: block.declarations,
            code: code.then(|| section_code(db, project, section)),
            calls: if code { call_lines(db, project, section) } else { &[] },
        }
    });
    let settings = project.settings(db);
    ProjectInput {
        name: &settings.name,
        debug_everywhere: settings.debug_everywhere,
        sections: sections.collect(),
        files,
    }
}

/// The problems, each at the text of its line.
fn diagnostics(input: &ProjectInput<'_>, problems: &[BuildProblem]) -> Vec<(String, Diagnostic)> {
    let mut lines: HashMap<u16, Vec<&str>> = HashMap::new();
    let located = problems.iter().map(|problem| {
        let file = input.files.get(usize::from(problem.file));
        let text = file.map_or("", |f| f.text);
        let lines = lines.entry(problem.file).or_insert_with(|| text.lines().collect());
        let line = lines.get(problem.line as usize).copied().unwrap_or_default();
        (file.map_or_else(String::new, |f| f.path.to_owned()), diagnostic(problem, line))
    });
    located.collect()
}

fn diagnostic(problem: &BuildProblem, line: &str) -> Diagnostic {
    let code = super::source_text::without_comment(line).trim_end();
    let start = code.len() - code.trim_start().len();
    Diagnostic {
        code: problem.kind.rule().code,
        severity: Severity::Error,
        message: problem.kind.message(),
        span: Span::in_line(problem.line, start as u32, code.len() as u32),
        related: Vec::new(),
        fix: None,
    }
}

impl Analysis {
    /// Builds the project. A project with errors is refused with them; otherwise the refusal names what the target
    /// cannot execute or hold. `Ok(Err(…))` is empty when no project is loaded.
    ///
    /// Configuration files belong to the control, nothing of them goes into the image: their errors hinder no build,
    /// see [`Analysis::configuration_errors`].
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn build(&self) -> Cancellable<Result<Built, Vec<(String, Diagnostic)>>> {
        let errors = self.errors(false)?;
        if !errors.is_empty() {
            return Ok(Err(errors));
        }
        self.with(|db, project| {
            let Some(project) = project else { return Err(Vec::new()) };
            let input = collect(db, project);
            let problems = match build(&input, database::layout(db, project)) {
                Ok(built) => return Ok(built),
                Err(problems) => problems,
            };
            Err(diagnostics(&input, &problems))
        })
    }

    /// Errors in configuration files. Whoever builds must show them: the program is built in spite of them, but
    /// the control cannot take the files as they are.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn configuration_errors(&self) -> Cancellable<Vec<(String, Diagnostic)>> {
        self.errors(true)
    }

    /// Errors, either of the configuration files or of everything else.
    fn errors(&self, in_configuration: bool) -> Cancellable<Vec<(String, Diagnostic)>> {
        let configuration: BTreeSet<String> = self.with(|db, project| {
            let files = project.map_or(&[][..], |project| project.configuration(db));
            files.iter().map(|file| file.path(db).clone()).collect()
        })?;
        let mut errors = Vec::new();
        for path in self.file_paths()? {
            if configuration.contains(&path) == in_configuration {
                let wrong = self.diagnostics(&path)?.into_iter().filter(|d| d.severity == Severity::Error);
                errors.extend(wrong.map(|d| (path.clone(), d)));
            }
        }
        Ok(errors)
    }

    /// The `.LS1` listing of a build of this snapshot.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn listing(&self, built: &Built) -> Cancellable<String> {
        self.with(|db, project| {
            let files: Vec<SourceFile> = project.map_or_else(Vec::new, |p| all_files(db, p).collect());
            listing(built, files.iter().map(|file| (file.path(db).as_str(), file.text(db).as_ref())))
        })
    }

    /// A hash over compiler version, settings and texts: equal hashes mean that a build would change nothing.
    ///
    /// # Errors
    /// A change overtook the question.
    pub fn sources_hash(&self) -> Cancellable<ContentHash> {
        self.with(|db, project| {
            let files: Vec<SourceFile> = project.map_or_else(Vec::new, |p| all_files(db, p).collect());
            let settings = project.map(|p| Arc::clone(p.settings(db))).unwrap_or_default();
            let texts =
                files.iter().map(|file| (file.path(db).as_str(), file.order(db), file.text(db).as_ref()));
            fingerprint::sources_hash(&settings.name, settings.debug_everywhere, texts)
        })
    }
}
