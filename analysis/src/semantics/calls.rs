//! Calls of macros in the code of a section: what stands between its own lines and the lines of an expansion.

use std::sync::Arc;

use super::code::CodeReader;
use super::hir::{SymbolKey, SymbolScope};
use super::macros::definition::{FLAG_WORDS, FlagProblem, Flags};
use super::macros::expand::{Body, Call, Problem};
use super::macros::{self, table};
use super::reference::{ReferenceAccess, Referent};
use crate::database::{self, NameRef};
use crate::diagnostics::Finding;
use crate::diagnostics::rules::{macros as rules, operands};
use crate::syntax::ast::{ExprKind, Line, Name};

impl<'db> CodeReader<'db> {
    /// A line that calls a macro; the lines it expands to follow.
    pub(super) fn call(&mut self, call: &'db Call<'db>, line: &Line) {
        self.misplaced = false;
        let key = SymbolKey { scope: SymbolScope::Macro, name: call.word.clone() };
        self.refer(call.columns.clone(), Referent::Symbol(key.clone()), ReferenceAccess::Call);
        let name = line.operation.as_ref().map_or("", |operation| operation.text.as_str());
        let (rule, columns, message) = match &call.problem {
            None => {
                self.open_call(call);
                return;
            }
            Some(Problem::Circle) => {
                self.unreadable = true;
                return;
            }
            Some(Problem::Brackets(columns)) => {
                self.open_call(call);
                let message = format!("{name} takes operands with brackets only when its flags say C_1");
                (&rules::MACRO_BRACKETS, columns.clone(), message)
            }
            Some(Problem::Later) => {
                let message =
                    format!("{name} is defined further down; a macro must be defined before it is used");
                (&rules::MACRO_USED_BEFORE, call.columns.clone(), message)
            }
            Some(Problem::TooLarge) => {
                if std::mem::replace(&mut self.too_large, true) {
                    self.unreadable = true;
                    return;
                }
                let message = format!(
                    "{name} cannot be expanded: macros may be nested {} deep, and the macros of a section may have {} lines",
                    macros::MAX_DEPTH,
                    macros::MAX_LINES
                );
                (&rules::MACRO_TOO_LARGE, call.columns.clone(), message)
            }
            Some(Problem::Arguments { expected, given }) => {
                let plural = if *expected == 1 { "" } else { "s" };
                let message = format!("{name} takes {expected} operand{plural}, {given} given");
                (&rules::MACRO_ARGUMENTS, call.columns.clone(), message)
            }
            Some(Problem::Empty(number)) => {
                let message = format!("operand {number} of {name} is empty; a macro needs all of them");
                (&rules::MACRO_ARGUMENTS, call.columns.clone(), message)
            }
        };
        self.unreadable |= call.problem.as_ref().is_some_and(Problem::stops);
        self.report_symbol(rule, columns, message, &key);
    }

    pub(super) fn open_call(&mut self, call: &'db Call<'db>) {
        let before = self.equations.enter(call.flags.stack);
        self.open_calls.push((call, before));
    }

    /// Ends the calls whose last line is behind.
    pub(super) fn leave_calls(&mut self) {
        while let Some((call, before)) = self.open_calls.pop_if(|(call, _)| call.end <= self.line) {
            self.equations.leave(before, call.flags.stack, (call.line, call.columns.clone()), &call.word);
        }
    }

    /// Own line of the section that the current line belongs to.
    pub(super) fn own_line(&self) -> u32 {
        let origin = self.expansion.and_then(|it| it.origins.get(self.line as usize));
        origin.map_or(self.line, |origin| origin.own)
    }

    pub(super) fn body(&self, line: u32) -> Option<&'db Body> {
        self.expansion?.origins.get(line as usize)?.body.as_ref()
    }

    /// The current line belongs to a macro.
    pub(super) fn in_expansion(&self) -> bool {
        self.body(self.line).is_some()
    }

    /// A line stands in DATA_LOCAL of a macro.
    pub(super) fn is_local_data(&self, line: u32) -> bool {
        self.body(line).is_some_and(|body| body.local)
    }

    pub(super) fn in_local_data(&self) -> bool {
        self.is_local_data(self.line)
    }

    pub(super) fn t_local(&mut self, line: &Line) {
        let columns = line.operation.as_ref().map_or(0..0, |operation| operation.columns.clone());
        let message = "T_LOCAL stands in macros only, directly behind DEF_T_MACRO";
        self.report(&rules::T_LOCAL_PLACE, columns, message);
    }

    /// APPEND_T_MACRO word, macro, flags.
    pub(super) fn append(&mut self, line: &Line) {
        let name_of = |index: usize| match line.operands.get(index).map(|operand| &operand.kind) {
            Some(ExprKind::Name(name)) => Some(name.clone()),
            _ => None,
        };
        let (Some(word), Some(target)) = (name_of(0), name_of(1)) else {
            let message = "two names are needed: APPEND_T_MACRO word, macro [, flags]";
            let mut given = line.operands.iter().take(2);
            let wrong = given.find(|operand| !matches!(operand.kind, ExprKind::Name(_)));
            if let Some(operand) = wrong {
                self.report(&operands::OPERAND_KIND, operand.columns.clone(), message);
            } else {
                let columns = line.operation.as_ref().map_or(0..0, |operation| operation.columns.clone());
                self.report(&operands::OPERAND_COUNT, columns, message);
            }
            return;
        };
        let key = NameRef::new(self.db, Arc::from(target.key()), None);
        if database::macro_meaning(self.db, self.project, self.section, key).somewhere {
            let key = SymbolKey { scope: SymbolScope::Macro, name: Arc::from(target.key()) };
            self.refer(target.columns.clone(), Referent::Symbol(key), ReferenceAccess::Call);
        } else {
            let message = format!("{} is no macro of this project", target.text);
            self.report(&rules::APPENDED_UNKNOWN, target.columns.clone(), message);
        }
        let hidden = table::is_instruction(&word.text);
        if hidden && !database::macros_before(self.db, self.project) {
            let message = format!(
                "{} stays the instruction; only CONTROL_T_MACRO PRE lets a macro replace it",
                word.text
            );
            self.report(&rules::MACRO_HIDDEN, word.columns, message);
        }
        let (_, problems) = Flags::read(line.operands.get(2..).unwrap_or_default());
        for problem in problems {
            let finding = flag_finding(&problem, self.line);
            self.push_finding(finding);
        }
    }

    /// A parameter that the body of a macro takes without TMAC.
    pub(super) fn parameter_without_prefix(&self, name: &Name) -> bool {
        let Some((expansion, body)) = self.expansion.zip(self.body(self.line)) else { return false };
        let Some(definition) = expansion.definitions.get(usize::from(body.definition)) else { return false };
        let written = expansion.written(self.line, &name.columns);
        let parameters = &database::macro_definition(self.db, *definition).parameters;
        written.is_some_and(|(spot, _)| spot.definition == Some(body.definition))
            && parameters.iter().any(|parameter| parameter.key() == name.key())
    }
}

/// A mistake in a list of flags.
pub(super) fn flag_finding(problem: &FlagProblem, line: u32) -> Finding {
    let words = FLAG_WORDS.concat().join(", ");
    let (columns, message) = match problem {
        FlagProblem::Unknown(columns) => (columns, format!("this is no flag; flags are {words}")),
        FlagProblem::Order(columns) => {
            (columns, "flags stand in the order stack, conversion, debugging".to_string())
        }
        FlagProblem::Twice(columns) => (columns, "a flag of this kind is given already".to_string()),
    };
    let rule = match problem {
        FlagProblem::Order(_) => &rules::MACRO_FLAG_ORDER,
        FlagProblem::Unknown(_) | FlagProblem::Twice(_) => &rules::MACRO_FLAGS,
    };
    Finding::new(rule, line, columns.clone(), message)
}
