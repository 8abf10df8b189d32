//! A mistake in a configuration file.

use crate::diagnostics::Rule;
use crate::location::Span;

/// A mistake, with places of its own file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Rule it breaks.
    pub rule: &'static Rule,
    /// Where.
    pub span: Span,
    /// What is wrong and what to do.
    pub message: String,
    /// Another place of the file that belongs to it, with what it is.
    pub beside: Option<(Span, String)>,
    /// A remedy: title, place, text.
    pub fix: Option<(String, Span, String)>,
}

impl Problem {
    /// A mistake without remedy.
    #[must_use]
    pub fn new(rule: &'static Rule, span: Span, message: String) -> Problem {
        Problem { rule, span, message, beside: None, fix: None }
    }

    /// Adds another place.
    #[must_use]
    pub fn beside(mut self, span: Span, note: &str) -> Problem {
        self.beside = Some((span, note.to_string()));
        self
    }

    /// Adds a fix that replaces the place of the mistake.
    #[must_use]
    pub fn replace(mut self, text: &str) -> Problem {
        self.fix = Some((format!("write {text}"), self.span, text.to_string()));
        self
    }
}
