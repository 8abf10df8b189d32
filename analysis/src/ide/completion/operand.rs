//! Completion in operands.

use technol_image::op::Width;

use super::request::{Operand, Part, Request};
use super::{Candidate, CompletionKind, List, Page, operation};
use crate::catalogue::{self, EntryKind, Language, OperandKind, OperandSpec, Prefix, PrefixSet};
use crate::database;
use crate::ide::{cursor, describe};
use crate::semantics::declarations::What;
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::scope::{Symbol, SymbolKind};
use crate::syntax::section::SectionKind;

/// Names, keywords and prefixes that fit the place.
pub(super) fn list(request: &Request<'_>, operand: &Operand, language: Language, list: &mut List) {
    match &operand.part {
        Part::Whole => whole(request, operand, language, list),
        Part::Addend => symbols(request, language, list, |symbol| match symbol.kind {
            SymbolKind::Constant(_) => Some(0),
            _ => is_memory(&symbol.kind).then_some(1),
        }),
        Part::Index => {
            keyword("BX", language, list);
            symbols(request, language, list, |symbol| {
                matches!(symbol.kind, SymbolKind::Constant(_)).then_some(1)
            });
        }
        Part::Parameter => parameters(request, language, list, ""),
        Part::Typed(prefix) => {
            symbols(request, language, list, |symbol| behind_prefix(*prefix, &symbol.kind));
        }
        Part::Bit(base) => {
            let siblings = base.as_ref().map(|base| bits_of(request, &base.key())).unwrap_or_default();
            symbols(request, language, list, |symbol| match symbol.kind {
                SymbolKind::Bit { .. } if siblings.contains(&symbol.key) => Some(0),
                SymbolKind::Bit { .. } | SymbolKind::FormalBit { .. } => Some(1),
                SymbolKind::Member { .. } => Some(u8::from(!siblings.is_empty())),
                _ => None,
            });
        }
        Part::BlockMember => block_members(language, list),
    }
}

fn whole(request: &Request<'_>, operand: &Operand, language: Language, list: &mut List) {
    let Some(kind) = spec(operand) else { return };
    if operand.index == 0 && catalogue::entry(&operand.operation.text).is_none() {
        operation::list_behind_name(request, language, list);
    }
    let (prefixes, keywords) = words(kind);
    for word in keywords {
        keyword(word, language, list);
    }
    if kind == OperandKind::Label {
        labels(request, language, list);
    }
    if kind == (OperandKind::Procedure { declares: true }) {
        event_procedures(language, list);
    }
    if request.section.kind(request.db) == SectionKind::Macro {
        let bare = catalogue::entry(&operand.operation.text).is_none_or(catalogue::Entry::is_assembler);
        parameters(request, language, list, if bare { "" } else { "TMAC." });
        local_symbols(request, language, list);
    }
    let own = own_name(request, operand);
    symbols(request, language, list, |symbol| {
        let fit = fit(kind, &symbol.kind)?;
        Some(if own.as_deref() == Some(&*symbol.key.name) { 0 } else { fit + 1 })
    });
    for prefix in Prefix::ALL.into_iter().filter(|prefix| prefixes.contains(*prefix)) {
        let word = format!("{}.", prefix.name());
        let entry = catalogue::entry(prefix.name());
        let detail = entry.map_or("", |entry| entry.summary.in_language(language)).to_owned();
        let page = entry.map_or(Page::None, Page::Entry);
        list.add(
            3,
            Candidate { label: word.clone(), insert: word, kind: CompletionKind::Prefix, detail, page },
        );
    }
}

/// Names of procedures that the control calls.
fn event_procedures(language: Language, list: &mut List) {
    for entry in catalogue::entries().filter(|entry| entry.kind == EntryKind::EventProcedure) {
        let (label, detail) = (entry.name.to_owned(), entry.summary.in_language(language).to_owned());
        let (insert, kind) = (label.clone(), CompletionKind::Procedure);
        list.add(0, Candidate { label, insert, kind, detail, page: Page::Entry(entry) });
    }
}

/// What the operand may be; anything for a user instruction, `None` when there is no such operand.
fn spec(operand: &Operand) -> Option<OperandKind> {
    let Some(entry) = catalogue::entry(&operand.operation.text) else { return Some(OperandKind::Any) };
    let repeated = || entry.operands.last().filter(|spec| spec.repeatable);
    let spec: &OperandSpec = entry.operands.get(operand.index).or_else(repeated)?;
    Some(spec.kind)
}

/// Prefixes and keywords an operand takes.
fn words(kind: OperandKind) -> (PrefixSet, &'static [&'static str]) {
    match kind {
        OperandKind::Data { prefixes, .. } => (prefixes, &[]),
        OperandKind::OneOf(kinds) => {
            let mut all = (PrefixSet::NONE, &[] as &'static [&'static str]);
            for (prefixes, words) in kinds.iter().map(|kind| words(*kind)) {
                all.0 = PrefixSet(all.0.0 | prefixes.0);
                // An operand has at most one list of keywords.
                all.1 = if words.is_empty() { all.1 } else { words };
            }
            all
        }
        OperandKind::AutoCounter => (PrefixSet::NONE, &["NIL"]),
        OperandKind::Keyword(words) | OperandKind::KeywordOrNumber(words, ..) => (PrefixSet::NONE, words),
        OperandKind::Any => (PrefixSet::ALL, &[]),
        _ => (PrefixSet::NONE, &[]),
    }
}

/// How well a symbol fits an operand, 0 best.
fn fit(operand: OperandKind, symbol: &SymbolKind) -> Option<u8> {
    let constant = matches!(symbol, SymbolKind::Constant(_));
    let typed = |set: PrefixSet| width(symbol).is_some_and(|width| set.contains(prefix_of(width)));
    let fits = |good: bool, fit: u8| good.then_some(fit);
    match operand {
        OperandKind::Bit { extended, .. } => match symbol {
            SymbolKind::Bit { .. } => Some(0),
            SymbolKind::Mechanism => Some(1),
            _ => fits(extended && is_memory(symbol), 1),
        },
        OperandKind::Data { declared, .. } | OperandKind::Value(declared) => {
            fits(typed(declared), 0).or_else(|| fits(constant && declared.contains(Prefix::Cnst), 1))
        }
        OperandKind::AutoCounter => fits(typed(COUNTERS), 0),
        OperandKind::Time => fits(constant, 0).or_else(|| fits(typed(COUNTERS), 1)),
        OperandKind::Address(_) | OperandKind::LiteralOrAddress => fits(is_memory(symbol), 0),
        OperandKind::Mechanism { declares: false } => fits(*symbol == SymbolKind::Mechanism, 0),
        OperandKind::Procedure { declares: false } => fits(*symbol == SymbolKind::Procedure, 0),
        OperandKind::Number { .. }
        | OperandKind::NumberOf(_)
        | OperandKind::Constant
        | OperandKind::KeywordOrNumber(..) => fits(constant, 1),
        OperandKind::BitPosition => {
            fits(matches!(symbol, SymbolKind::Bit { .. } | SymbolKind::FormalBit { .. }), 0)
        }
        OperandKind::Text(_) | OperandKind::TextOrLiteral => {
            fits(matches!(symbol, SymbolKind::Text { .. }), 0)
        }
        OperandKind::Identifier(_) => fits(matches!(symbol, SymbolKind::Text { .. }), 1),
        OperandKind::DeclaredElement => {
            fits(is_memory(symbol) || matches!(symbol, SymbolKind::Bit { .. }), 1)
        }
        OperandKind::OneOf(kinds) => kinds.iter().filter_map(|kind| fit(*kind, symbol)).min(),
        OperandKind::Any => fits(!matches!(symbol, SymbolKind::Macro | SymbolKind::Unknown), 0),
        OperandKind::Label
        | OperandKind::Mechanism { declares: true }
        | OperandKind::Procedure { declares: true }
        | OperandKind::NewName
        | OperandKind::NewBit
        | OperandKind::RealConstant
        | OperandKind::Declares(_)
        | OperandKind::Keyword(_) => None,
    }
}

const COUNTERS: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::Word]);

fn behind_prefix(prefix: Prefix, symbol: &SymbolKind) -> Option<u8> {
    match (prefix, symbol) {
        (Prefix::Cnst, SymbolKind::Constant(_)) => Some(0),
        (Prefix::Cnst, _) => None,
        (Prefix::High, SymbolKind::Cell(Width::Word)) => Some(0),
        (_, symbol) => is_memory(symbol).then_some(1),
    }
}

/// It has bytes of its own that an address may name.
fn is_memory(symbol: &SymbolKind) -> bool {
    matches!(
        symbol,
        SymbolKind::Cell(_)
            | SymbolKind::Array { .. }
            | SymbolKind::Area { .. }
            | SymbolKind::Text { .. }
            | SymbolKind::MechanismLine
    )
}

/// Declared width of a cell.
fn width(symbol: &SymbolKind) -> Option<Width> {
    match symbol {
        SymbolKind::Cell(width) | SymbolKind::Array { element: width, .. } => Some(*width),
        SymbolKind::MechanismLine => Some(Width::Word),
        _ => None,
    }
}

const fn prefix_of(width: Width) -> Prefix {
    match width {
        Width::Byte => Prefix::Byte,
        Width::Word => Prefix::Word,
        Width::DWord => Prefix::Dwrd,
        Width::QWord => Prefix::Qwrd,
        Width::Real => Prefix::Real,
    }
}

/// MECH_END and PROC_END mean the section they stand in.
fn own_name(request: &Request<'_>, operand: &Operand) -> Option<String> {
    let closes = match request.section.kind(request.db) {
        SectionKind::Mechanism => "MECH_END",
        SectionKind::Procedure => "PROC_END",
        _ => return None,
    };
    operand.operation.text.eq_ignore_ascii_case(closes).then(|| request.section.name(request.db).to_string())
}

/// What predefined symbols are worse than the program's names, keywords and prefixes: there are more of them than an
/// answer holds.
const PREDEFINED: u8 = 4;

/// Adds the visible symbols that `fit` takes: local ones, those of the project, predefined ones.
fn symbols(request: &Request<'_>, language: Language, list: &mut List, fit: impl Fn(&Symbol) -> Option<u8>) {
    let scope = database::scope(request.db, request.project);
    let file = cursor::local_file(request.db, request.project, request.section);
    let locals = file.and_then(|file| scope.locals.get(usize::from(file)));
    for (key, symbol) in locals.into_iter().flatten().chain(&scope.globals) {
        // T_LOCAL symbols of the calls of macros have no name that could be written.
        if let Some(fit) = fit(symbol).filter(|_| list.matches(key) && !key.contains("@@")) {
            let name = cursor::spelling(request.db, request.project, &symbol.key);
            list.add(fit, candidate(symbol, name, describe::kind(symbol, language)));
        }
    }
    for system in catalogue::symbols() {
        if !list.matches(system.name) {
            continue;
        }
        let shadowed =
            scope.globals.contains_key(system.name) || locals.is_some_and(|l| l.contains_key(system.name));
        let Some(symbol) = database::system_symbol(system.name).filter(|_| !shadowed) else { continue };
        if let Some(fit) = fit(&symbol) {
            let detail = system.summary.in_language(language).to_owned();
            list.add(PREDEFINED + fit, candidate(&symbol, system.name.to_owned(), detail));
        }
    }
}

fn block_members(language: Language, list: &mut List) {
    for member in catalogue::block_members() {
        if !list.matches(member.name) {
            continue;
        }
        let kind = crate::semantics::program::system_kind(&member.kind);
        let key = SymbolKey { scope: SymbolScope::System, name: format!("BLK.{}", member.name).into() };
        let detail = member.summary.in_language(language).to_owned();
        list.add(0, candidate(&Symbol { key, kind }, member.name.to_owned(), detail));
    }
}

fn candidate(symbol: &Symbol, name: String, detail: String) -> Candidate {
    let kind = match symbol.kind {
        SymbolKind::Bit { .. } | SymbolKind::FormalBit { .. } => CompletionKind::Bit,
        SymbolKind::Cell(_) | SymbolKind::Array { .. } | SymbolKind::MechanismLine | SymbolKind::Unknown => {
            CompletionKind::Cell
        }
        SymbolKind::Area { .. } => CompletionKind::Area,
        SymbolKind::Text { .. } => CompletionKind::Text,
        SymbolKind::Member { .. } => CompletionKind::Cell,
        SymbolKind::Structure { .. } => CompletionKind::Area,
        SymbolKind::Constant(_) => CompletionKind::Constant,
        SymbolKind::Mechanism => CompletionKind::Mechanism,
        SymbolKind::Procedure => CompletionKind::Procedure,
        SymbolKind::Macro => CompletionKind::Macro,
    };
    Candidate { label: name.clone(), insert: name, kind, detail, page: Page::Symbol(symbol.key.clone()) }
}

/// The parameters of the macro around the position.
fn parameters(request: &Request<'_>, language: Language, list: &mut List, prefix: &str) {
    let detail = match language {
        Language::En => "parameter of the macro",
        Language::Cs => "parametr makra",
    };
    for name in &database::macro_definition(request.db, request.section).parameters {
        formal(&format!("{prefix}{}", name.text), detail, list);
    }
}

fn local_symbols(request: &Request<'_>, language: Language, list: &mut List) {
    let detail = match language {
        Language::En => "symbol of the macro",
        Language::Cs => "symbol makra",
    };
    for (_, name) in &database::macro_definition(request.db, request.section).locals {
        formal(&name.text, detail, list);
    }
}

fn formal(word: &str, detail: &str, list: &mut List) {
    let candidate = Candidate {
        label: word.to_owned(),
        insert: word.to_owned(),
        kind: CompletionKind::Parameter,
        detail: detail.to_owned(),
        page: Page::None,
    };
    list.add(0, candidate);
}

fn keyword(word: &str, language: Language, list: &mut List) {
    let entry = catalogue::entry(word).filter(|entry| entry.kind == EntryKind::Keyword);
    let detail = entry.map_or("", |entry| entry.summary.in_language(language)).to_owned();
    let page = entry.map_or(Page::None, Page::Entry);
    let kind = CompletionKind::Keyword;
    list.add(0, Candidate { label: word.to_owned(), insert: word.to_owned(), kind, detail, page });
}

fn labels(request: &Request<'_>, language: Language, list: &mut List) {
    let detail = match language {
        Language::En => "label",
        Language::Cs => "návěští",
    };
    for declared in &database::section_declarations(request.db, request.section).names {
        if declared.what == What::Label {
            let name = declared.name.text.clone();
            let candidate = Candidate {
                label: name.clone(),
                insert: name,
                kind: CompletionKind::Label,
                detail: detail.to_owned(),
                page: Page::None,
            };
            list.add(0, candidate);
        }
    }
}

/// The bits declared in the byte `key` names.
fn bits_of(request: &Request<'_>, key: &str) -> Vec<SymbolKey> {
    let file = cursor::local_file(request.db, request.project, request.section);
    let name = database::NameRef::new(request.db, std::sync::Arc::from(key), file);
    let Some(symbol) = database::lookup(request.db, request.project, name) else { return Vec::new() };
    let Some(site) = cursor::sites(request.db, request.project, &symbol.key).first() else {
        return Vec::new();
    };
    if site.of != database::SiteOf::Own {
        return Vec::new();
    }
    let names = &database::section_declarations(request.db, site.section).names;
    let Some(What::Cell { storage }) = names.get(site.index as usize).map(|d| &d.what) else {
        return Vec::new();
    };
    let bits = names.iter().filter(|d| matches!(&d.what, What::Bit { storage: of, .. } if of == storage));
    let scope: SymbolScope = symbol.key.scope;
    bits.map(|d| SymbolKey { scope, name: std::sync::Arc::from(d.name.key()) }).collect()
}
