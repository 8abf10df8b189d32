//! Collects what is wrong in a file and gives it absolute positions: the outer edge of the analysis.

use super::rules::{
    declarations, macros, operands, project as project_rules, sequences, syntax as syntax_rules,
};
use super::{Anchor, Diagnostic, Finding, Fix, allow, syntax};
use crate::catalogue;
use crate::configuration::cross;
use crate::database::{self, Db, Project, Section, Site, SiteOf, SourceFile};
use crate::location::{Location, Span};
use crate::project::IncludeTarget;
use crate::semantics::analysis::Overrun;
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::macros::{expand::Expansion, remap, without_marks};
use crate::semantics::scope::Clash;
use crate::semantics::structure;
use crate::syntax::ast::Columns;

/// So many other declarations are shown with one: a macro that declares a name may be called a thousand times.
const OTHER_PLACES: usize = 5;

/// All mistakes of a file, sorted.
pub(crate) fn collect(db: &dyn Db, project: Project, file: SourceFile) -> Vec<Diagnostic> {
    let mut found: Vec<(Section<'_>, Finding)> = Vec::new();
    for section in database::sections(db, file) {
        of_section(db, project, *section, &mut found);
    }
    found.extend(structure::check(db, file));
    clashes(db, project, file, &mut found);
    recursion(db, project, file, &mut found);
    let sections = database::sections(db, file);
    found.extend(
        database::file_lints(db, project, file)
            .iter()
            .filter_map(|(index, finding)| Some((*sections.get(*index as usize)?, finding.clone()))),
    );
    allow::apply(db, file, &mut found);
    let mut diagnostics: Vec<Diagnostic> =
        found.iter().filter_map(|(section, finding)| absolute(db, project, *section, finding)).collect();
    diagnostics.sort_by(|a, b| (a.span, a.code, &a.message).cmp(&(b.span, b.code, &b.message)));
    diagnostics.dedup();
    diagnostics
}

fn of_section<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
    found: &mut Vec<(Section<'db>, Finding)>,
) {
    let analysis = database::section_analysis(db, project, section);
    let declared = database::section_declarations(db, section);
    let own = || declared.findings.iter().chain(&analysis.findings);
    if let Some(expansion) = database::expansion_of(db, project, section) {
        let expanded = database::expansion_declarations(db, project, section);
        let findings = expanded.local.findings.iter().chain(&expanded.other.findings);
        found.extend(findings.map(|finding| (section, finding.clone())));
        found.extend(in_expansion(db, expansion).into_iter().map(|finding| (section, finding)));
    }
    let parsed = database::section_lines(db, section);
    let mut texts = crate::syntax::lines(section.text(db)).enumerate();
    for error in &parsed.errors {
        let text = texts.find(|(number, _)| *number as u32 == error.line).map_or("", |(_, line)| line.text);
        let include = parsed.lines.get(error.line as usize).and_then(|line| line.operation.as_ref());
        let include = include.is_some_and(|name| name.text.eq_ignore_ascii_case("T_INCLUDE"));
        let unknown = own().any(|f| f.line == error.line && f.rule == &syntax_rules::UNKNOWN_INSTRUCTION);
        if !include && !unknown {
            found.push((section, syntax::finding(error, text)));
        }
    }
    found.extend(own().map(|finding| (section, finding.clone())));
    let overruns =
        analysis.overruns.iter().filter_map(|overrun| Some((section, past(db, project, overrun)?)));
    found.extend(overruns);
    found.extend(cross::of_section(db, project, section).into_iter().map(|finding| (section, finding)));
    found.extend(
        super::devices::of_section(db, project, analysis).into_iter().map(|finding| (section, finding)),
    );
    includes(db, project, section, found);
}

/// Mistakes of the parser that come of what a call hands to its macro; those of the bodies themselves are reported
/// at the definitions.
fn in_expansion(db: &dyn Db, expansion: &Expansion<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    for error in &expansion.parsed.errors {
        let origin = expansion.origins.get(error.line as usize);
        let Some(body) = origin.and_then(|origin| origin.body.as_ref()) else { continue };
        let Some(definition) = expansion.definitions.get(usize::from(body.definition)) else { continue };
        let broken = &database::section_lines(db, *definition).errors;
        if broken.binary_search_by_key(&body.line, |error| error.line).is_err() {
            found.push(remap::finding(expansion, syntax::finding(error, &body.text)));
        }
    }
    found
}

/// An access that ends outside its symbol: an error when it leaves the data area, a warning when it begins inside the
/// symbol. One that begins outside was written with an offset: it is meant for a neighbour.
fn past(db: &dyn Db, project: Project, overrun: &Overrun) -> Option<Finding> {
    let name = without_marks(&overrun.symbol.name);
    let outside = !database::inside_data(db, project, &overrun.symbol, overrun.offset, overrun.bytes);
    let finding = |rule, message: String| {
        let mut finding =
            Finding::new(rule, overrun.line, overrun.columns.clone(), message).declared_at(&overrun.symbol);
        if let Some((line, columns)) = overrun.expanded.clone() {
            finding.related.push((Anchor::Expanded { line, columns }, "this line of the macro".to_string()));
        }
        Some(finding)
    };
    if outside {
        let message = format!("this access to {name}{:+} leaves the data area", overrun.offset);
        return finding(&operands::ACCESS_OUTSIDE_DATA, message);
    }
    if !(0..i64::from(overrun.declared)).contains(&overrun.offset) {
        return None;
    }
    // `WORD.BZH09` reads BZH09 and BZH10, as the control means it.
    let end = overrun.offset + i64::from(overrun.bytes);
    if overrun.symbol.scope == SymbolScope::System && catalogue::goes_on(&name, end) {
        return None;
    }
    let bytes = |n: u32| if n == 1 { "1 byte".to_string() } else { format!("{n} bytes") };
    let message = if overrun.offset == 0 {
        format!("{} are accessed, but {name} has {}", bytes(overrun.bytes), bytes(overrun.declared))
    } else {
        let (length, declared) = (bytes(overrun.bytes), bytes(overrun.declared));
        format!("{length} are accessed from offset {}, but {name} has {declared}", overrun.offset)
    };
    finding(&operands::ACCESS_PAST_CELL, message)
}

fn includes<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
    found: &mut Vec<(Section<'db>, Finding)>,
) {
    let declared = database::section_declarations(db, section);
    if declared.includes.is_empty() {
        return;
    }
    let path = section.file(db).path(db);
    for include in &declared.includes {
        let finding =
            |rule, message: String| Finding::new(rule, include.line, include.columns.clone(), message);
        match project.includes(db).get(&(path.clone(), include.name.clone())) {
            Some(IncludeTarget::Missing(why)) => {
                found.push((section, finding(&project_rules::MISSING_INCLUDE, why.clone())));
            }
            Some(IncludeTarget::Cyclic(circle)) => {
                let message = format!("the files include each other: {circle}");
                found.push((section, finding(&project_rules::CYCLIC_INCLUDE, message)));
            }
            Some(IncludeTarget::File(target)) => {
                let repeated = &database::parts(db, project).repeated;
                if repeated.iter().any(|r| r.section == section && r.name == include.name) {
                    let message =
                        format!("{target} declares memory and is included already; include it once");
                    found.push((section, finding(&project_rules::INCLUDED_TWICE, message)));
                }
            }
            None => {}
        }
    }
}

/// Names declared more than once, at each of their places in the file.
fn clashes<'db>(
    db: &'db dyn Db,
    project: Project,
    file: SourceFile,
    found: &mut Vec<(Section<'db>, Finding)>,
) {
    let scope = database::scope(db, project);
    if scope.clashes.is_empty() {
        return;
    }
    let sites = database::sites(db, project);
    for (key, clash) in &scope.clashes {
        let mut places: Vec<Site<'db>> = sites.get(key).cloned().unwrap_or_default();
        if *clash == Clash::LocalAndGlobal {
            let global = SymbolKey { scope: SymbolScope::Global, name: key.name.clone() };
            places.extend(sites.get(&global).into_iter().flatten());
        }
        for (index, site) in places.iter().enumerate().filter(|(_, site)| site.section.file(db) == file) {
            let Some((name, line, columns)) = declared_at(db, project, *site) else { continue };
            let others = places.iter().enumerate().filter(|(other, _)| *other != index).take(OTHER_PLACES);
            let (rule, message) = match clash {
                Clash::Twice if key.scope == SymbolScope::Macro => {
                    (&macros::MACRO_REDEFINED, format!("the macro {name} is defined more than once"))
                }
                Clash::Twice if places.len() == 1 => (
                    &declarations::DUPLICATE_NAME,
                    format!("{name} is declared by its mechanism already: each has a WORD name_LINE"),
                ),
                Clash::Twice => (&declarations::DUPLICATE_NAME, format!("{name} is declared more than once")),
                Clash::MechanismAndCell => (
                    &declarations::DUPLICATE_NAME,
                    format!("{name} is a cell and a mechanism; a mechanism declares a bit of its name"),
                ),
                Clash::LocalAndGlobal => (
                    &declarations::DUPLICATE_NAME,
                    format!("{name} is declared in DATA and in DATA_LOCAL of this file"),
                ),
                Clash::Values => (
                    &declarations::CONFLICTING_CONSTANT,
                    format!("{name} has different values in the project"),
                ),
            };
            let mut finding = Finding::new(rule, line, columns, message);
            for (_, other) in others {
                if let Some(location) = site_location(db, project, *other) {
                    finding.related.push((Anchor::Place(location), "also declared here".to_string()));
                }
            }
            found.push((site.section, finding));
        }
    }
}

fn recursion<'db>(
    db: &'db dyn Db,
    project: Project,
    file: SourceFile,
    found: &mut Vec<(Section<'db>, Finding)>,
) {
    for call in database::recursive_calls(db, project) {
        if call.section.file(db) == file {
            let message = format!("procedures call each other in a circle: {}", call.circle);
            found.push((
                call.section,
                Finding::new(&sequences::RECURSION, call.line, call.columns.clone(), message),
            ));
        }
    }
}

/// Name, own line and columns of a declaration; one that a macro makes stands at the call.
fn declared_at(db: &dyn Db, project: Project, site: Site<'_>) -> Option<(String, u32, Columns)> {
    let declared = database::declared(db, project, site)?;
    let columns = match expanded(db, project, site) {
        Some((expansion, line)) => expansion.shown(line, &declared.name.columns),
        None => declared.columns(),
    };
    Some((without_marks(&declared.name.text), declared.line, columns))
}

/// The expansion a declaration stands in, and its line there.
fn expanded<'db>(db: &'db dyn Db, project: Project, site: Site<'db>) -> Option<(&'db Expansion<'db>, u32)> {
    let lines = match site.of {
        SiteOf::Own => return None,
        SiteOf::Local => &database::expansion_declarations(db, project, site.section).local_lines,
        SiteOf::Other => &database::expansion_declarations(db, project, site.section).other_lines,
    };
    let expansion = database::expansion_of(db, project, site.section)?;
    Some((expansion, *lines.get(site.index as usize)?))
}

/// Where a name is declared; in the definition when a macro declares it.
pub(crate) fn site_location(db: &dyn Db, project: Project, site: Site<'_>) -> Option<Location> {
    let declared = database::declared(db, project, site)?;
    let (section, line, columns) = match expanded(db, project, site) {
        Some((expansion, line)) => expansion.defined(db, line, &declared.name.columns)?,
        None => (site.section, declared.line, declared.columns()),
    };
    let file = section.file(db).path(db).clone();
    Some(Location { file, span: span(db, section, line, &columns) })
}

fn span(db: &dyn Db, section: Section<'_>, line: u32, columns: &Columns) -> Span {
    let lines = section.lines(db);
    let line = lines.get(line as usize).or(lines.last()).copied().unwrap_or(0);
    Span::in_line(line, columns.start, columns.end)
}

fn absolute(db: &dyn Db, project: Project, section: Section<'_>, finding: &Finding) -> Option<Diagnostic> {
    let severity = match project.settings(db).lints.get(finding.rule.code) {
        Some(None) => return None,
        Some(Some(severity)) => *severity,
        None => finding.rule.severity,
    };
    let place = |line: u32, columns: &Columns| span(db, section, line, columns);
    let mut related = Vec::new();
    for (anchor, note) in &finding.related {
        match anchor {
            Anchor::Own { line, columns } => {
                let file = section.file(db).path(db).clone();
                related.push((Location { file, span: place(*line, columns) }, note.clone()));
            }
            Anchor::Expanded { line, columns } => {
                let expansion = database::expansion_of(db, project, section);
                if let Some((definition, line, columns)) =
                    expansion.and_then(|it| it.defined(db, *line, columns))
                {
                    let file = definition.file(db).path(db).clone();
                    related
                        .push((Location { file, span: span(db, definition, line, &columns) }, note.clone()));
                }
            }
            Anchor::Symbol(key) => {
                let sites = database::sites(db, project).get(key);
                let location = sites.and_then(|sites| site_location(db, project, *sites.first()?));
                related.extend(location.map(|location| (location, note.clone())));
            }
            Anchor::Place(location) => related.push((location.clone(), note.clone())),
        }
    }
    let fix = finding.fix.as_ref().map(|(title, edits)| Fix {
        title: title.clone(),
        edits: edits.iter().map(|(line, columns, text)| (place(*line, columns), text.clone())).collect(),
    });
    Some(Diagnostic {
        code: finding.rule.code,
        severity,
        message: finding.message.clone(),
        span: place(finding.line, &finding.columns),
        related,
        fix,
    })
}
