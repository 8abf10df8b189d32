//! Words for the mistakes of the parser.

use super::rules::syntax as rules;
use super::{Finding, Rule};
use crate::syntax::ast::{SyntaxError, SyntaxErrorKind};

/// A syntax error as a finding; `line` is the text of its line.
pub(super) fn finding(error: &SyntaxError, line: &str) -> Finding {
    let (rule, message): (&'static Rule, String) = match &error.kind {
        SyntaxErrorKind::UnexpectedCharacter(c) => {
            (&rules::UNEXPECTED_CHARACTER, format!("the character {} has no meaning here", shown(*c)))
        }
        SyntaxErrorKind::TypographicQuote(c) => {
            (&rules::TYPOGRAPHIC_QUOTE, format!("texts stand in apostrophes '…', not in {c}"))
        }
        SyntaxErrorKind::UnclosedText => {
            (&rules::UNCLOSED_TEXT, "this text never ends; close it with an apostrophe".to_string())
        }
        SyntaxErrorKind::BadNumber => {
            (&rules::BAD_NUMBER, "this number cannot be read; forms are 123, 0F8h, 0001b and 1.5".to_string())
        }
        SyntaxErrorKind::Unbalanced(c) => {
            (&rules::UNBALANCED_BRACKET, format!("the bracket {c} has no partner"))
        }
        SyntaxErrorKind::ExpectedOperand => {
            (&rules::EXPECTED_OPERAND, "an operand is missing here".to_string())
        }
        SyntaxErrorKind::ExpectedComma => {
            (&rules::EXPECTED_COMMA, "a comma is missing before this operand".to_string())
        }
        SyntaxErrorKind::ExpectedOperation => {
            (&rules::EXPECTED_OPERATION, "a label, an instruction or a comment is needed here".to_string())
        }
        SyntaxErrorKind::ExpectedColon => {
            (&rules::EXPECTED_COLON, "a colon is missing behind the declared name".to_string())
        }
        SyntaxErrorKind::TooComplex => {
            (&rules::TOO_COMPLEX, "this operand is too complex; name a part of it with EQUI".to_string())
        }
    };
    let finding = Finding::new(rule, error.line, error.columns.clone(), message);
    let end = error.columns.end;
    match &error.kind {
        SyntaxErrorKind::TypographicQuote(_) => match requoted(line, &error.columns) {
            Some(text) => finding.replace("use apostrophes", error.columns.clone(), text),
            None => finding,
        },
        SyntaxErrorKind::ExpectedColon => finding.replace("add the colon", end..end, ":"),
        SyntaxErrorKind::ExpectedComma => {
            let start = error.columns.start;
            finding.replace("add a comma", start..start, ",")
        }
        _ => finding,
    }
}

fn shown(c: char) -> String {
    if c.is_control() { format!("U+{:04X}", u32::from(c)) } else { c.to_string() }
}

/// The quoted text with apostrophes instead.
fn requoted(line: &str, columns: &std::ops::Range<u32>) -> Option<String> {
    let quoted = line.get(columns.start as usize..columns.end as usize)?;
    let mut chars = quoted.chars();
    chars.next()?;
    let inner = chars.as_str();
    let inner = match inner.chars().last() {
        Some(last) if !last.is_alphanumeric() && last != ' ' => &inner[..inner.len() - last.len_utf8()],
        _ => inner,
    };
    Some(format!("'{}'", inner.replace('\'', "''")))
}
