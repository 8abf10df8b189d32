//! Places that take operands of several kinds: which of them an operand is.
//!
//! Each alternative is tried as if it stood alone; what it reports and records is taken back unless it is chosen. So
//! a wrong operand gives one finding, whatever the number of alternatives.

use super::code::{CodeReader, Mark};
use super::hir::Operand;
use super::identifiers::element_words;
use super::operands;
use crate::catalogue::{Entry, NewCell, OperandKind, Prefix, PrefixSet};
use crate::diagnostics::rules::{declarations, memory, names, operands as rules};
use crate::diagnostics::{Finding, Rule};
use crate::semantics::reference::Reference;
use crate::syntax::ast::{Expr, ExprKind};

/// What an alternative that does not fit reported and recorded.
struct Refusal {
    findings: Vec<Finding>,
    references: Vec<Reference>,
}

impl Refusal {
    fn has(&self, rule: &Rule) -> bool {
        self.findings.iter().any(|finding| finding.rule == rule)
    }

    /// The operand has the form of this alternative, only its value or prefix is wrong.
    fn is_near(&self) -> bool {
        let by_kind: [&Rule; 6] = [
            &rules::OPERAND_KIND,
            &rules::CONSTANT_DESTINATION,
            &names::WRONG_SYMBOL,
            &names::UNKNOWN_LABEL,
            &declarations::NOT_CONSTANT,
            &memory::NO_ALTERNATIVE,
        ];
        !by_kind.into_iter().any(|rule| self.has(rule))
    }
}

/// The first of `kinds` that the operand is; reports an operand that is none of them.
pub(super) fn one_of(
    reader: &mut CodeReader<'_>,
    entry: &'static Entry,
    kinds: &[OperandKind],
    expr: &Expr,
) -> Option<Operand> {
    let mark = reader.mark();
    let mut refusals = Vec::with_capacity(kinds.len());
    for kind in kinds {
        reader.clean = true;
        let operand = operands::of_kind(reader, entry, *kind, expr);
        if operand.is_some() && reader.clean {
            reader.clean = mark.clean;
            return operand;
        }
        refusals.push(take_back(reader, &mark));
    }
    reader.clean = false;
    let silent = refusals.iter().position(|refusal| refusal.findings.is_empty());
    let unknown = || refusals.iter().position(|refusal| refusal.has(&names::UNKNOWN_SYMBOL));
    let near = || refusals.iter().position(Refusal::is_near);
    // Declared with a mistake or misread: that is reported where it happened.
    if let Some(chosen) = silent.or_else(unknown).or_else(near) {
        let refusal = refusals.swap_remove(chosen);
        reader.out.findings.extend(refusal.findings);
        reader.out.references.extend(refusal.references);
        return None;
    }
    let list: Vec<String> = kinds.iter().map(|kind| words(*kind)).collect();
    let message = format!("{} stands here; {} takes {}", spelled(reader, expr), entry.name, joined(&list));
    let references = refusals.into_iter().find(|refusal| !refusal.references.is_empty());
    reader.out.references.extend(references.into_iter().flat_map(|refusal| refusal.references));
    reader.report(&memory::NO_ALTERNATIVE, expr.columns.clone(), message);
    None
}

fn take_back(reader: &mut CodeReader<'_>, mark: &Mark) -> Refusal {
    let out = &mut reader.out;
    out.overruns.truncate(mark.overruns);
    out.identifiers.truncate(mark.identifiers);
    Refusal {
        findings: out.findings.split_off(mark.findings),
        references: out.references.split_off(mark.references),
    }
}

/// The operand in words.
fn spelled(reader: &CodeReader<'_>, expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Name(name) => match reader.symbol(&name.text) {
            Some(symbol) => format!("{} ({})", name.text, operands::describe(&symbol.kind)),
            None => name.text.clone(),
        },
        ExprKind::Text(_) => "a text".to_string(),
        ExprKind::Number(_) => "a number".to_string(),
        _ => "something else".to_string(),
    }
}

/// `a, b or c`, each once.
fn joined(list: &[String]) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in list {
        if !parts.contains(&part.as_str()) {
            parts.push(part);
        }
    }
    match parts.split_last() {
        None => String::new(),
        Some((last, [])) => (*last).to_string(),
        Some((last, before)) => format!("{} or {last}", before.join(", ")),
    }
}

/// What a kind of operand is, in words.
fn words(kind: OperandKind) -> String {
    match kind {
        OperandKind::Bit { .. } => "a bit".to_string(),
        OperandKind::Data { declared, .. } => types(declared),
        OperandKind::Value(types_taken) => types(types_taken),
        OperandKind::Address(_) => "an address".to_string(),
        OperandKind::AutoCounter => "a BYTE or WORD cell".to_string(),
        OperandKind::Time => "a number or a BYTE or WORD cell".to_string(),
        OperandKind::Label => "a label".to_string(),
        OperandKind::Mechanism { .. } => "a mechanism".to_string(),
        OperandKind::Procedure { .. } => "a procedure".to_string(),
        OperandKind::NewName | OperandKind::NewBit => "a new name".to_string(),
        OperandKind::Declares(NewCell::Bit) => "the name of a new bit".to_string(),
        OperandKind::Declares(_) => "the name of a new cell".to_string(),
        OperandKind::Number { min, max } => format!("a number {min} to {max}"),
        OperandKind::NumberOf(numbers) => {
            let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
            format!("a number out of {}", numbers.join(", "))
        }
        OperandKind::Constant => "a constant".to_string(),
        OperandKind::RealConstant => "a number with a decimal point".to_string(),
        OperandKind::BitPosition => "the name of a bit".to_string(),
        OperandKind::Keyword(words) => words.join(", "),
        OperandKind::KeywordOrNumber(words, min, max) => {
            format!("{}, a number {min} to {max}", words.join(", "))
        }
        OperandKind::Text(_) => "a text buffer".to_string(),
        OperandKind::TextOrLiteral => "a text buffer, a text in apostrophes".to_string(),
        OperandKind::LiteralOrAddress => "a text in apostrophes, an address".to_string(),
        OperandKind::Identifier(element) => format!("the identifier of {}", element_words(element)),
        OperandKind::DeclaredElement => "a cell of DEF_IN or DEF_OUT".to_string(),
        OperandKind::OneOf(kinds) => {
            let list: Vec<String> = kinds.iter().map(|kind| words(*kind)).collect();
            list.join(", ")
        }
        OperandKind::Any => "anything".to_string(),
    }
}

fn types(set: PrefixSet) -> String {
    let cells: Vec<&str> = [
        (Prefix::Byte, "BYTE"),
        (Prefix::Word, "WORD"),
        (Prefix::Dwrd, "DWORD"),
        (Prefix::Qwrd, "QWORD"),
        (Prefix::Real, "REAL"),
    ]
    .into_iter()
    .filter_map(|(prefix, name)| set.contains(prefix).then_some(name))
    .collect();
    match (cells.is_empty(), set.contains(Prefix::Cnst)) {
        (true, true) => "a constant".to_string(),
        (true, false) => "a cell".to_string(),
        (false, true) => format!("a {} cell, a constant", cells.join("/")),
        (false, false) => format!("a {} cell", cells.join("/")),
    }
}
