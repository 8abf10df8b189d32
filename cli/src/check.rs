//! `technol check`: the mistakes of a project, for people or as one JSON object a line.

use std::fmt::Write as _;
use std::io::Write as _;

use serde_json::json;
use technol_analysis::{Diagnostic, Position, Severity};

use crate::arguments::{CheckArguments, Format};
use crate::exit::{self, Outcome};
use crate::files::Project;
use crate::paint::Paint;

/// Counts by severity.
#[derive(Default)]
struct Totals {
    errors: u64,
    warnings: u64,
    others: u64,
}

/// Checks and reports. Exit 0 without errors, 1 with errors, 2 when nothing could be checked.
pub(crate) fn check(arguments: &CheckArguments) -> Outcome {
    let project = Project::open(&arguments.path)?;
    let findings = project.findings()?;
    let paint = Paint::stdout();
    let mut totals = Totals::default();
    let mut out = std::io::stdout().lock();
    for (file, diagnostics) in &findings {
        for diagnostic in diagnostics {
            match diagnostic.severity {
                Severity::Error => totals.errors += 1,
                Severity::Warning => totals.warnings += 1,
                _ => totals.others += 1,
            }
            let text = match arguments.format {
                Format::Human => human(&project, file, diagnostic, paint),
                Format::Json => json_line(&project, file, diagnostic),
            };
            // A closed pipe (`| head`) ends the output, not the check.
            let _ = writeln!(out, "{text}");
        }
    }
    if arguments.format == Format::Human {
        let _ = writeln!(out, "{}", summary(&project, &totals, paint));
    }
    Ok(if totals.errors > 0 { exit::ERRORS } else { exit::OK })
}

/// One finding as people read it: place, severity, code, message, the line with a marker, the remedy.
pub(crate) fn human(project: &Project, file: &str, diagnostic: &Diagnostic, paint: Paint) -> String {
    let name = match diagnostic.severity {
        Severity::Error => paint.red("error"),
        Severity::Warning => paint.yellow("warning"),
        Severity::Info => paint.cyan("note"),
        Severity::Hint => paint.dim("hint"),
    };
    let text = project.text(file);
    let start = diagnostic.span.start;
    let mut out = format!(
        "{}:{}:{}: {name} {}: {}",
        project.display(file).display(),
        start.line + 1,
        column(text, start),
        diagnostic.code,
        diagnostic.message
    );
    if let Some(line) = text.and_then(|t| t.lines().nth(start.line as usize)) {
        let end = if diagnostic.span.end.line == start.line { diagnostic.span.end.column } else { u32::MAX };
        out.push_str(&marked(line, start.column as usize, end as usize, paint));
    }
    // Writing to a string does not fail.
    for (place, note) in &diagnostic.related {
        let at = place.span.start;
        let column = column(project.text(&place.file), at);
        let _ =
            write!(out, "\n    {}:{}:{column}: {note}", project.display(&place.file).display(), at.line + 1);
    }
    if let Some(fix) = &diagnostic.fix {
        let _ = write!(out, "\n    {} {}", paint.green("fix:"), fix.title);
    }
    out
}

/// The source line and a marker under the bytes `start..end`.
fn marked(line: &str, start: usize, end: usize, paint: Paint) -> String {
    let start = start.min(line.len());
    let end = end.clamp(start, line.len());
    let (Some(before), Some(marked)) = (line.get(..start), line.get(start..end)) else {
        return String::new();
    };
    let blanks: String = before.chars().map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
    let marker = "^".repeat(marked.chars().count().max(1));
    format!("\n    {line}\n    {blanks}{}", paint.red(marker))
}

fn json_line(project: &Project, file: &str, diagnostic: &Diagnostic) -> String {
    let text = project.text(file);
    let severity = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "info",
        Severity::Hint => "hint",
    };
    json!({
        "file": project.display(file).to_string_lossy(),
        "line": diagnostic.span.start.line + 1,
        "column": column(text, diagnostic.span.start),
        "endLine": diagnostic.span.end.line + 1,
        "endColumn": column(text, diagnostic.span.end),
        "severity": severity,
        "code": diagnostic.code,
        "message": diagnostic.message,
    })
    .to_string()
}

/// 1-based column in characters.
fn column(text: Option<&str>, position: Position) -> u32 {
    let line = text.and_then(|t| t.lines().nth(position.line as usize)).unwrap_or_default();
    let bytes = (position.column as usize).min(line.len());
    line.get(..bytes).map_or(position.column, |before| before.chars().count() as u32) + 1
}

fn summary(project: &Project, totals: &Totals, paint: Paint) -> String {
    if totals.errors + totals.warnings + totals.others == 0 {
        let files = project.loaded.files.len() as u64;
        let lines: u64 = project.loaded.files.iter().map(|f| f.text.lines().count() as u64).sum();
        return format!(
            "{}: {} in {} without findings",
            paint.green("clean"),
            count(lines, "line"),
            count(files, "file")
        );
    }
    let mut parts = Vec::new();
    if totals.errors > 0 {
        parts.push(paint.red(count(totals.errors, "error")));
    }
    if totals.warnings > 0 {
        parts.push(paint.yellow(count(totals.warnings, "warning")));
    }
    if totals.others > 0 {
        parts.push(count(totals.others, "hint"));
    }
    parts.join(", ")
}

/// `1 line`, `2 lines`.
pub(crate) fn count(n: impl Into<u64>, what: &str) -> String {
    let n = n.into();
    if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters_and_start_at_one() {
        let text = "LDR ALFA\n; příčný posuv\n";
        assert_eq!(column(Some(text), Position { line: 0, column: 4 }), 5);
        assert_eq!(column(Some(text), Position { line: 1, column: 9 }), 7);
        assert_eq!(column(Some(text), Position { line: 7, column: 3 }), 1, "a place behind the text");
        assert_eq!(column(None, Position { line: 0, column: 3 }), 1);
    }

    #[test]
    fn counts_use_the_plural() {
        assert_eq!(count(1_u64, "error"), "1 error");
        assert_eq!(count(0_u64, "error"), "0 errors");
        assert_eq!(count(7_u64, "file"), "7 files");
    }
}
