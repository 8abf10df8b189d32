//! Results as JUnit XML, the form that build servers read.

use std::fmt::Write as _;

use super::discover::stem;
use super::execute::Verdict;
use super::report;
use super::scenario::Test;
use crate::paint::Paint;

/// The whole document. Times are those that the tests took.
pub(super) fn document(project: &str, results: &[(&Test, &Verdict)]) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // Writing to a string does not fail.
    let _ = writeln!(out, "<testsuites name=\"{}\" {}>", escape(project), totals(results));
    let mut rest = results;
    while let Some((first, _)) = rest.first() {
        let own = rest.iter().take_while(|(test, _)| test.file == first.file).count();
        let (suite, others) = rest.split_at(own);
        rest = others;
        let _ = writeln!(out, "  <testsuite name=\"{}\" {}>", escape(&first.file), totals(suite));
        for (test, verdict) in suite {
            out.push_str(&case(test, verdict));
        }
        out.push_str("  </testsuite>\n");
    }
    out.push_str("</testsuites>\n");
    out
}

fn case(test: &Test, verdict: &Verdict) -> String {
    let (class, name) = (escape(stem(&test.file)), escape(&test.name));
    let (file, line) = (escape(&test.file), test.place.line);
    let took = verdict.took.as_secs_f64();
    let head = format!(
        "    <testcase classname=\"{class}\" name=\"{name}\" file=\"{file}\" line=\"{line}\" time=\"{took:.3}\""
    );
    match &verdict.failure {
        None => format!("{head}/>\n"),
        Some(failure) => {
            let problems = failure.problems.iter();
            let message: Vec<String> = problems
                .map(|problem| format!("expected {}, {}", problem.expected, problem.actual))
                .collect();
            let text = report::failure(test, failure, Paint::none());
            format!(
                "{head}>\n      <failure type=\"failure\" message=\"{}\">{}</failure>\n    </testcase>\n",
                escape(&message.join("; ")),
                escape(&text)
            )
        }
    }
}

fn totals(results: &[(&Test, &Verdict)]) -> String {
    let failures = results.iter().filter(|(_, verdict)| verdict.failure.is_some()).count();
    let time: f64 = results.iter().map(|(_, verdict)| verdict.took.as_secs_f64()).sum();
    format!(
        "tests=\"{}\" failures=\"{failures}\" errors=\"0\" skipped=\"0\" time=\"{time:.3}\"",
        results.len()
    )
}

/// Text for an attribute or an element; characters that XML has no way to write become replacement characters.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' => out.push_str("&#10;"),
            '\t' => out.push_str("&#9;"),
            c if c < ' ' || matches!(c, '\u{7F}'..='\u{9F}' | '\u{FFFE}' | '\u{FFFF}') => {
                out.push('\u{FFFD}')
            }
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_for_attributes_and_elements() {
        assert_eq!(
            escape("a < b && \"c\"\r\n\u{1b}[1mž"),
            "a &lt; b &amp;&amp; &quot;c&quot;\u{FFFD}&#10;\u{FFFD}[1mž"
        );
    }
}
