//! Operands of an instruction: how many, and what each place takes.

use std::sync::Arc;

use technol_image::op::Width;

use super::address::Shape;
use super::code::{CodeReader, form};
use super::constant::{ConstExpr, NoValue};
use super::hir::{Address, Operand};
use super::program::no_value;
use super::reference::ReferenceAccess;
use super::scope::SymbolKind;
use super::{alternatives, assembler, bits, data, identifiers, moves};
use crate::catalogue::{self, Access, Entry, EntryKind, OperandKind, OperandSpec, PrefixSet};
use crate::diagnostics::rules::{declarations, lints, names, operands as rules};
use crate::syntax::ast::{Expr, ExprKind, Line, Name};

/// Resolves the operands of a line and checks them against each other.
pub(super) fn resolve(reader: &mut CodeReader<'_>, entry: &'static Entry, line: &Line) -> Vec<Operand> {
    if entry.name == "T_INCLUDE" {
        return Vec::new();
    }
    if let Some(form) = entry.assembler_form() {
        return assembler::resolve(reader, entry, form, line);
    }
    let mut resolved = Vec::with_capacity(line.operands.len());
    let mut specs = entry.operands.iter();
    let mut spec = specs.next();
    for expr in &line.operands {
        let Some(now) = spec else {
            let last = line.operands.last().map_or(expr.columns.end, |last| last.columns.end);
            let columns = expr.columns.start..last;
            let message = match entry.operands.len() {
                0 => format!("{} takes no operand", entry.name),
                _ => format!("too many operands: {}", form(entry)),
            };
            reader.report(&rules::OPERAND_COUNT, columns, message);
            return resolved;
        };
        resolved.push(one(reader, entry, now, expr).unwrap_or(Operand::Skipped));
        if !now.repeatable {
            spec = specs.next();
        }
    }
    let given = line.operands.len();
    let missing = entry.operands.get(given).filter(|s| !s.optional && !s.skippable);
    if let (Some(missing), Some(operation)) = (missing, &line.operation) {
        let message = format!("the operand {} is missing: {}", missing.name, form(entry));
        reader.report(&rules::OPERAND_COUNT, operation.columns.clone(), message);
        return resolved;
    }
    identifiers::typed(reader, entry, line);
    if reader.clean {
        moves::check(reader, entry, line, &mut resolved);
    }
    resolved
}

/// EQUI, DS, STR, DFM: names in constants are looked up, so that they are reported where they stand.
pub(super) fn declaration(reader: &mut CodeReader<'_>, entry: &'static Entry, line: &Line) {
    if matches!(entry.name, "DB" | "DW" | "DD" | "DQ") {
        repetitions(reader, line);
        return initial_values(reader, line);
    }
    let value = match entry.name {
        "EQUI" => line.operands.get(1),
        "DS" | "STR" => line.operands.first(),
        _ => None,
    };
    if entry.name == "STR" {
        overlay(reader, line);
    }
    let Some(value) = value else { return };
    let Ok(expr) = ConstExpr::read(value) else { return };
    let mut used = Vec::new();
    names_in(value, &mut used);
    if used.is_empty() {
        return;
    }
    if entry.name == "EQUI" && circular(reader, line) {
        let message = "this value depends on itself; break the circle with a number";
        reader.report(&declarations::CIRCULAR_CONSTANT, value.columns.clone(), message);
        return;
    }
    for name in used {
        if !constant_name(reader, name) {
            return;
        }
    }
    let bounds =
        if entry.name == "EQUI" { (-0x8000_0000, 0xFFFF_FFFF) } else { (1, super::collect::MAX_LENGTH) };
    match expr.value(&mut |name| super::program::constant(reader.db, reader.project, reader.section, name)) {
        Ok(value) if (bounds.0..=bounds.1).contains(&value) => {}
        Ok(number) if entry.name != "EQUI" => {
            let message = format!("the length {number} is not within 1 and {}", super::collect::MAX_LENGTH);
            reader.report(&declarations::BAD_LENGTH, value.columns.clone(), message);
        }
        _ => {
            reader.report(
                &rules::CONSTANT_TOO_LARGE,
                value.columns.clone(),
                "the value does not fit 32 bits",
            );
        }
    }
    if let (ExprKind::Text(text), Some(SymbolKind::Text { len })) = (
        line.operands.get(1).map_or(&ExprKind::Missing, |o| &o.kind),
        line.label.as_ref().and_then(|label| reader.symbol(&label.text)).map(|symbol| symbol.kind.clone()),
    ) && entry.name == "STR"
        && text.chars().count() > len as usize
    {
        let columns = line.operands[1].columns.clone();
        let message = format!("the text has {} characters, the buffer {len}", text.chars().count());
        reader.report(&declarations::TEXT_TOO_LONG, columns, message);
    }
}

/// Names in the number of elements of a member: `n DUP (?)`.
fn repetitions(reader: &mut CodeReader<'_>, line: &Line) {
    for pair in line.operands.windows(2) {
        let [times, word] = pair else { continue };
        if !super::structures::is_word(word, "DUP") {
            continue;
        }
        let mut used = Vec::new();
        names_in(times, &mut used);
        if used.is_empty() || used.into_iter().any(|name| !constant_name(reader, name)) {
            continue;
        }
        let most = super::collect::MAX_LENGTH;
        if let Some(value) = integer(reader, times)
            && !(1..=most).contains(&value)
        {
            let message = format!("the number of elements is not within 1 and {most}");
            reader.report(&declarations::BAD_LENGTH, times.columns.clone(), message);
        }
    }
}

/// Values of a member: constants, `?`, texts. What stands before and behind DUP is read by [`repetitions`].
fn initial_values(reader: &mut CodeReader<'_>, line: &Line) {
    let is =
        |expr: Option<&Expr>, word: &str| expr.is_some_and(|expr| super::structures::is_word(expr, word));
    for (at, operand) in line.operands.iter().enumerate() {
        if is(Some(operand), "?") || is(Some(operand), "DUP") || is(line.operands.get(at + 1), "DUP") {
            continue;
        }
        if let ExprKind::Name(name) = &operand.kind
            && !constant_name(reader, name)
        {
            return;
        }
    }
}

/// What a STR lies over.
fn overlay(reader: &mut CodeReader<'_>, line: &Line) {
    let Some(expr) = line.operands.get(1) else { return };
    if matches!(expr.kind, ExprKind::Text(_) | ExprKind::Missing | ExprKind::Error) {
        return;
    }
    let Some(Operand::Area { address, .. }) = data::area(reader, expr, Access::ReadWrite) else { return };
    let sites = crate::database::sites(reader.db, reader.project).get(&address.symbol);
    let file = reader.section.file(reader.db);
    if sites.is_some_and(|sites| sites.iter().all(|site| site.section.file(reader.db) != file)) {
        let message =
            format!("{} is declared in another file; declare the buffer there", address.symbol.name);
        reader.report(&lints::OVERLAY_ELSEWHERE, expr.columns.clone(), message);
    }
    let own =
        line.label.as_ref().and_then(|label| reader.symbol(&label.text)).map(|symbol| symbol.kind.clone());
    let under = reader.symbol(&address.symbol.name).cloned();
    if let (Some(SymbolKind::Text { len }), Some(under)) = (own, under) {
        reader.overrun(expr.columns.clone(), &under, address.offset, len.saturating_add(1));
    }
}

/// Whether a name in a constant expression is a constant; reports it when not.
pub(super) fn constant_name(reader: &mut CodeReader<'_>, name: &Name) -> bool {
    let Some(symbol) = reader.resolve(name, ReferenceAccess::Read) else { return false };
    if matches!(symbol.kind, SymbolKind::Constant(_)) {
        return true;
    }
    let message = format!("{} is {}, a constant is needed here", name.text, describe(&symbol.kind));
    reader.report_symbol(&names::WRONG_SYMBOL, name.columns.clone(), message, &symbol.key);
    false
}

/// Whether the EQUI of a line is where a circle of constants was found.
fn circular(reader: &CodeReader<'_>, line: &Line) -> bool {
    let Some(Expr { kind: ExprKind::Name(name), .. }) = line.operands.first() else { return false };
    reader.symbol(&name.text).is_some_and(|symbol| symbol.kind == SymbolKind::Unknown)
        && crate::database::scope(reader.db, reader.project).circular.contains(name.key().as_str())
}

pub(super) fn names_in<'a>(expr: &'a Expr, found: &mut Vec<&'a Name>) {
    match &expr.kind {
        ExprKind::Name(name) => found.push(name),
        ExprKind::Sign { operand, .. } | ExprKind::Parens(operand) => names_in(operand, found),
        ExprKind::Sum { left, right, .. } => {
            names_in(left, found);
            names_in(right, found);
        }
        ExprKind::Dot { right, .. } => names_in(right, found),
        _ => {}
    }
}

fn one(
    reader: &mut CodeReader<'_>,
    entry: &'static Entry,
    spec: &OperandSpec,
    expr: &Expr,
) -> Option<Operand> {
    match &expr.kind {
        ExprKind::Missing => {
            if spec.skippable || spec.optional {
                return Some(Operand::Skipped);
            }
            let columns = expr.columns.clone();
            let message = format!("the operand {} is missing: {}", spec.name, form(entry));
            reader.report(&rules::OPERAND_COUNT, columns, message);
            return None;
        }
        ExprKind::Dash
            if spec.skippable || matches!(spec.kind, OperandKind::AutoCounter | OperandKind::Any) =>
        {
            return Some(Operand::Skipped);
        }
        ExprKind::Name(name)
            if name.text.eq_ignore_ascii_case("NIL")
                && (spec.skippable || matches!(spec.kind, OperandKind::AutoCounter)) =>
        {
            return Some(Operand::Skipped);
        }
        ExprKind::Dash => {
            let message = format!("{} must be given: {}", spec.name, form(entry));
            reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
            return None;
        }
        ExprKind::Error => {
            reader.clean = false;
            return None;
        }
        _ => {}
    }
    of_kind(reader, entry, spec.kind, expr)
}

/// An operand that is given, as one of a kind.
pub(super) fn of_kind(
    reader: &mut CodeReader<'_>,
    entry: &'static Entry,
    kind: OperandKind,
    expr: &Expr,
) -> Option<Operand> {
    let counters = PrefixSet::of(&[catalogue::Prefix::Byte, catalogue::Prefix::Word]);
    match kind {
        OperandKind::Bit { access, negatable, extended } => {
            bits::bit(reader, expr, &bits::BitRules { access, negatable, extended })
        }
        OperandKind::Data { access, prefixes, declared, negatable } => {
            data::value(reader, entry, expr, &data::ValueRules { access, prefixes, declared, negatable })
        }
        OperandKind::Value(prefixes) => {
            let rules =
                data::ValueRules { access: Access::Read, prefixes, declared: prefixes, negatable: false };
            data::value(reader, entry, expr, &rules)
        }
        OperandKind::AutoCounter => {
            let rules = data::ValueRules {
                access: Access::ReadWrite,
                prefixes: counters,
                declared: counters,
                negatable: false,
            };
            data::value(reader, entry, expr, &rules)
        }
        OperandKind::Time => data::time(reader, entry, expr),
        OperandKind::Address(access) => data::area(reader, expr, access),
        OperandKind::Text(access) => data::text(reader, expr, access),
        OperandKind::TextOrLiteral => match &expr.kind {
            ExprKind::Text(text) => Some(Operand::Text(Arc::from(text.as_str()))),
            _ => data::text(reader, expr, Access::Read),
        },
        OperandKind::LiteralOrAddress => match &expr.kind {
            ExprKind::Text(text) => Some(Operand::Text(Arc::from(text.as_str()))),
            _ => data::area(reader, expr, Access::Read),
        },
        OperandKind::Label => label(reader, expr),
        OperandKind::Mechanism { .. } => {
            let symbol = routine(reader, expr, &SymbolKind::Mechanism, "a mechanism")?;
            Some(Operand::Mechanism(symbol))
        }
        OperandKind::Procedure { .. } => {
            let symbol = routine(reader, expr, &SymbolKind::Procedure, "a procedure")?;
            Some(Operand::Procedure(symbol))
        }
        OperandKind::Number { min, max } => number(reader, expr, min, max),
        OperandKind::NumberOf(numbers) => number_of(reader, expr, numbers),
        OperandKind::Constant => data::constant(reader, expr),
        OperandKind::RealConstant => data::real_constant(reader, expr),
        OperandKind::BitPosition => bits::position(reader, expr),
        OperandKind::Keyword(words) => keyword(reader, expr, words),
        OperandKind::KeywordOrNumber(words, min, max) => match &expr.kind {
            ExprKind::Name(name) if words.iter().any(|word| word.eq_ignore_ascii_case(&name.text)) => {
                keyword(reader, expr, words)
            }
            _ => number(reader, expr, min, max),
        },
        OperandKind::NewName | OperandKind::NewBit => Some(Operand::Skipped),
        OperandKind::Identifier(element) => identifiers::identifier(reader, entry, element, expr),
        OperandKind::Declares(new) => identifiers::declared(reader, entry, new, expr),
        OperandKind::DeclaredElement => identifiers::element(reader, expr),
        OperandKind::OneOf(kinds) => alternatives::one_of(reader, entry, kinds, expr),
        OperandKind::Any => Some(any(reader, expr)),
    }
}

fn label(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<Operand> {
    if let ExprKind::Name(name) = &expr.kind {
        return reader.label(name).map(Operand::Label);
    }
    reader.report(&rules::OPERAND_KIND, expr.columns.clone(), "a label is needed here");
    None
}

fn routine(
    reader: &mut CodeReader<'_>,
    expr: &Expr,
    wanted: &SymbolKind,
    what: &str,
) -> Option<super::hir::SymbolKey> {
    let ExprKind::Name(name) = &expr.kind else {
        reader.report(
            &rules::OPERAND_KIND,
            expr.columns.clone(),
            format!("the name of {what} is needed here"),
        );
        return None;
    };
    let symbol = reader.resolve(name, ReferenceAccess::Call)?;
    if symbol.kind == *wanted {
        return Some(symbol.key);
    }
    let message = format!("{} is {}, {what} is needed here", name.text, describe(&symbol.kind));
    reader.report_symbol(&names::WRONG_SYMBOL, name.columns.clone(), message, &symbol.key);
    None
}

fn keyword(reader: &mut CodeReader<'_>, expr: &Expr, words: &'static [&'static str]) -> Option<Operand> {
    if let ExprKind::Name(name) = &expr.kind
        && let Some(word) = words.iter().find(|word| word.eq_ignore_ascii_case(&name.text))
    {
        return Some(Operand::Keyword(word));
    }
    let message = format!("{} is needed here", words.join(" or "));
    reader.report(&rules::OPERAND_KIND, expr.columns.clone(), message);
    None
}

/// An integer constant within bounds.
fn number(reader: &mut CodeReader<'_>, expr: &Expr, min: i64, max: i64) -> Option<Operand> {
    let value = integer(reader, expr)?;
    if (min..=max).contains(&value) {
        return Some(Operand::Integer { value, width: Width::DWord });
    }
    let message = match (min, max) {
        (0, 1) => format!("{value} cannot stand here, only 0 or 1"),
        _ => format!("{value} is not within {min} and {max}"),
    };
    reader.report(&rules::NUMBER_OUT_OF_RANGE, expr.columns.clone(), message);
    None
}

/// An integer constant out of a list.
fn number_of(reader: &mut CodeReader<'_>, expr: &Expr, numbers: &[i64]) -> Option<Operand> {
    let value = integer(reader, expr)?;
    if numbers.contains(&value) {
        return Some(Operand::Integer { value, width: Width::DWord });
    }
    let known: Vec<String> = numbers.iter().map(ToString::to_string).collect();
    let message = format!("{value} cannot stand here, only {}", known.join(", "));
    reader.report(&rules::NUMBER_OUT_OF_RANGE, expr.columns.clone(), message);
    None
}

/// The value of an integer constant expression.
pub(super) fn integer(reader: &mut CodeReader<'_>, expr: &Expr) -> Option<i64> {
    let bare = super::address::without_prefix(expr);
    let shape = Shape::of(expr).ok();
    if let Some(prefix) = shape.as_ref().and_then(|shape| shape.prefix.as_ref()) {
        super::sum::misspelled(reader, prefix);
        if prefix.prefix != catalogue::Prefix::Cnst {
            let message = format!("{}. cannot stand before a number here", prefix.prefix.name());
            reader.report(&rules::PREFIX_NOT_ALLOWED, prefix.columns.clone(), message);
            return None;
        }
    }
    let constant = match ConstExpr::read(&bare) {
        Ok(constant) => constant,
        Err(why) => {
            match why.message() {
                Some((columns, message)) => reader.report(&declarations::NOT_CONSTANT, columns, message),
                None => reader.clean = false,
            }
            return None;
        }
    };
    let mut used = Vec::new();
    names_in(&bare, &mut used);
    for name in used {
        if !constant_name(reader, name) {
            return None;
        }
    }
    match no_value(reader.db, reader.project, reader.section, &constant) {
        None => constant
            .value(&mut |name| super::program::constant(reader.db, reader.project, reader.section, name))
            .ok(),
        Some(NoValue::Overflow | NoValue::Name(_)) => {
            reader.report(&rules::CONSTANT_TOO_LARGE, expr.columns.clone(), "the value is too large");
            None
        }
    }
}

/// An operand whose rules are not modelled: names that mean something are recorded, nothing is reported.
fn any(reader: &mut CodeReader<'_>, expr: &Expr) -> Operand {
    if let ExprKind::Name(name) = &expr.kind {
        let word = catalogue::entry(&name.text).filter(|entry| entry.kind == EntryKind::Keyword);
        if let Some(word) = word {
            return Operand::Keyword(word.name);
        }
    }
    let mut named = Vec::new();
    names_in(expr, &mut named);
    for name in named {
        let known = reader.symbol(&name.text).cloned();
        if let Some(symbol) = known {
            let referent = super::reference::Referent::Symbol(symbol.key);
            reader.refer(name.columns.clone(), referent, ReferenceAccess::Read);
        }
    }
    match &expr.kind {
        ExprKind::Name(name) => Operand::Text(Arc::from(name.key())),
        _ => Operand::Skipped,
    }
}

/// What a symbol is, for messages.
pub(super) fn describe(kind: &SymbolKind) -> &'static str {
    match kind {
        SymbolKind::Bit { .. } => "a bit",
        SymbolKind::FormalBit { .. } => "a bit position without a cell",
        SymbolKind::Cell(Width::Byte) => "a BYTE cell",
        SymbolKind::Cell(Width::Word) => "a WORD cell",
        SymbolKind::Cell(Width::DWord) => "a DWORD cell",
        SymbolKind::Cell(Width::QWord) => "a QWORD cell",
        SymbolKind::Cell(Width::Real) => "a REAL cell",
        SymbolKind::Array { .. } => "an array",
        SymbolKind::Area { .. } => "an area without type",
        SymbolKind::Text { .. } => "a text buffer",
        SymbolKind::Member { .. } => "a member of a structure",
        SymbolKind::Structure { .. } => "a structure",
        SymbolKind::Constant(_) => "a constant",
        SymbolKind::Mechanism => "a mechanism",
        SymbolKind::MechanismLine => "the line cell of a mechanism",
        SymbolKind::Procedure => "a procedure",
        SymbolKind::Macro => "a macro",
        SymbolKind::Unknown => "declared with a mistake",
    }
}

/// The use of a cell as the editor counts it.
pub(super) const fn access(access: Access) -> ReferenceAccess {
    match access {
        Access::Read => ReferenceAccess::Read,
        Access::Write => ReferenceAccess::Write,
        Access::ReadWrite => ReferenceAccess::ReadWrite,
    }
}

/// The address of a symbol.
pub(super) fn address_of(symbol: &super::scope::Symbol) -> Address {
    Address { symbol: symbol.key.clone(), offset: 0, indexed: false }
}
