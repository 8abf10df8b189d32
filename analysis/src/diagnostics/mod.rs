//! What the front end reports: rules with codes, and diagnostics that quote them.
//!
//! While something is analysed a mistake is a [`Finding`]: positioned in its section, so that text added above
//! leaves it equal. At the outer edge it becomes a [`Diagnostic`] with absolute lines and the severity the
//! project's `[lints]` ask for.

pub mod allow;
mod devices;
pub(crate) mod file;
pub mod rules;
mod syntax;

use crate::location::{Location, Span};
use crate::semantics::hir::SymbolKey;
use crate::syntax::ast::Columns;

pub use rules::{RULES, explain, rule};

/// How serious a diagnostic is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// The program cannot be built.
    Error,
    /// Probably a mistake.
    Warning,
    /// Worth knowing.
    Info,
    /// A suggestion, shown unobtrusively.
    Hint,
}

impl Severity {
    /// Lower-case name, as `[lints]`, `check` and JSON spell it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Info => "info",
            Severity::Hint => "hint",
        }
    }
}

/// A mistake in a file, with absolute positions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Code of its rule, for instance `T0301`.
    pub code: &'static str,
    /// Severity after the project's `[lints]`.
    pub severity: Severity,
    /// What is wrong and what to do.
    pub message: String,
    /// Where.
    pub span: Span,
    /// Other places that belong to it, with what they are.
    pub related: Vec<(Location, String)>,
    /// A remedy that can be applied as it stands.
    pub fix: Option<Fix>,
}

/// A change that remedies a diagnostic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What it does.
    pub title: String,
    /// Replacements in the same file.
    pub edits: Vec<(Span, String)>,
}

/// A kind of mistake.
#[derive(Debug)]
pub struct Rule {
    /// `T` and four digits; never reused.
    pub code: &'static str,
    /// Kebab-case name.
    pub name: &'static str,
    /// Severity without `[lints]`.
    pub severity: Severity,
    /// Code with this mistake cannot be lowered: `[lints]` may not lower the severity.
    pub fixed: bool,
    /// What it means, and the remedy: one paragraph of Markdown.
    pub explanation: &'static str,
    /// Why it matters: one paragraph of Markdown.
    pub why: &'static str,
    /// A program text with this mistake, see [`rules`] for how it is completed.
    pub wrong: &'static str,
    /// The same text as it should be.
    pub right: &'static str,
    /// A fix is offered, at least for some of its mistakes; the one in `wrong` has it.
    pub fix: bool,
    /// What it marks is superfluous: editors show it faded.
    pub unnecessary: bool,
    /// Chapter of the manual, for instance `4.3`; empty for lints that the manual does not mention.
    pub chapter: &'static str,
}

impl Rule {
    /// A rule that says nothing: each rule names what differs.
    pub const BASE: Rule = Rule {
        code: "",
        name: "",
        severity: Severity::Warning,
        fixed: false,
        explanation: "",
        why: "",
        wrong: "",
        right: "",
        fix: false,
        unnecessary: false,
        chapter: "",
    };
}

impl PartialEq for Rule {
    fn eq(&self, other: &Rule) -> bool {
        self.code == other.code
    }
}

impl Eq for Rule {}

/// A mistake in a section, with own lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Rule it breaks.
    pub rule: &'static Rule,
    /// 0-based own line of the section.
    pub line: u32,
    /// Columns in it.
    pub columns: Columns,
    /// What is wrong and what to do.
    pub message: String,
    /// Other places that belong to it.
    pub related: Vec<(Anchor, String)>,
    /// A remedy: title, and replacements.
    pub fix: Option<(String, Vec<OwnEdit>)>,
}

/// A replacement in the finding's section: own line, columns, text.
pub type OwnEdit = (u32, Columns, String);

/// A place a finding refers to, without absolute lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// In the same section.
    Own {
        /// 0-based own line.
        line: u32,
        /// Columns in it.
        columns: Columns,
    },
    /// In a macro that the section calls.
    Expanded {
        /// 0-based line of the section's expansion.
        line: u32,
        /// Columns in it.
        columns: Columns,
    },
    /// Where a symbol is declared.
    Symbol(SymbolKey),
    /// An absolute place; only findings made at the outer edge have one.
    Place(Location),
}

impl Finding {
    /// A finding without related places and fix.
    #[must_use]
    pub fn new(rule: &'static Rule, line: u32, columns: Columns, message: impl Into<String>) -> Finding {
        Finding { rule, line, columns, message: message.into(), related: Vec::new(), fix: None }
    }

    /// Adds a place of the same section.
    #[must_use]
    pub fn beside(mut self, line: u32, columns: Columns, note: impl Into<String>) -> Finding {
        self.related.push((Anchor::Own { line, columns }, note.into()));
        self
    }

    /// Adds the declaration of a symbol.
    #[must_use]
    pub fn declared_at(mut self, symbol: &SymbolKey) -> Finding {
        self.related.push((Anchor::Symbol(symbol.clone()), format!("{} is declared here", symbol.name)));
        self
    }

    /// Adds a fix that replaces columns of the finding's own line.
    #[must_use]
    pub fn replace(mut self, title: impl Into<String>, columns: Columns, text: impl Into<String>) -> Finding {
        self.fix = Some((title.into(), vec![(self.line, columns, text.into())]));
        self
    }

    /// Whether code with this finding cannot be lowered.
    #[must_use]
    pub fn blocks(&self) -> bool {
        self.rule.severity == Severity::Error
    }
}
