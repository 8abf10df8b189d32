//! The page of a rule in Markdown.

use std::fmt::Write as _;

use crate::diagnostics::Rule;

/// The page: what it means and how to change its severity, why it matters, a wrong and a right program.
pub(super) fn markdown(rule: &Rule) -> String {
    let mut page = format!("# {} {}\n\n", rule.code, rule.name);
    let mut facts = vec![format!("**{}**", rule.severity.name())];
    if !rule.chapter.is_empty() {
        facts.push(format!("manual {}", rule.chapter));
    }
    if rule.fix {
        facts.push("the editor offers a fix".to_string());
    }
    let setting = if rule.fixed {
        "It cannot be lowered: such a program cannot be built.".to_string()
    } else {
        let code = rule.code;
        format!(
            "`[lints] {code} = \"off\"` in technol.toml (or `hint`, `warning`, `error`) changes it for the project, \
             a comment `;technol: allow({code})` for a line, a section or a file."
        )
    };
    // Writing to a String cannot fail.
    let _ = write!(page, "{}. {setting}\n\n{}\n", facts.join(", "), rule.explanation);
    section(&mut page, "Why", rule.why, None);
    section(&mut page, "Wrong", rule.wrong, Some("technol"));
    section(&mut page, "Right", rule.right, Some("technol"));
    page
}

fn section(page: &mut String, title: &str, text: &str, code: Option<&str>) {
    if text.is_empty() {
        return;
    }
    let text = text.trim_end();
    let _ = match code {
        Some(language) => write!(page, "\n## {title}\n\n```{language}\n{text}\n```\n"),
        None => write!(page, "\n## {title}\n\n{text}\n"),
    };
}
