//! Completion at the place of the operation.

use super::request::Request;
use super::{Candidate, CompletionKind, List, Page};
use crate::catalogue::{self, Entry, EntryKind, Language};
use crate::database;
use crate::ide::cursor;
use crate::ide::describe;
use crate::semantics::place::Context;
use crate::syntax::section::SectionKind;

/// Instructions that may stand in the section, words that close it, and the project's own instructions.
pub(super) fn list(request: &Request<'_>, language: Language, list: &mut List) {
    let included = request.section.file(request.db).order(request.db).is_none();
    let context = Context::of(request.db, request.project, request.section, included);
    for entry in catalogue::entries() {
        if is_operation(entry) && list.matches(entry.name) && may_stand(request, &context, entry) {
            add_entry(request, entry, language, list);
        }
    }
    let scope = database::scope(request.db, request.project);
    let table = database::macro_table(request.db, request.project);
    let own = request.own_line();
    for key in table.visible(request.section, own) {
        let Some(symbol) = scope.macros.get(key) else { continue };
        if list.matches(key) {
            let name = cursor::spelling(request.db, request.project, &symbol.key);
            let candidate = Candidate {
                label: name.clone(),
                insert: name,
                kind: CompletionKind::Macro,
                detail: describe::kind(symbol, language),
                page: Page::Symbol(symbol.key.clone()),
            };
            list.add(0, candidate);
        }
    }
}

/// Words that stand behind the name they declare: `NAME STRUC`, `MEMBER DB ?`.
pub(super) fn list_behind_name(request: &Request<'_>, language: Language, list: &mut List) {
    let included = request.section.file(request.db).order(request.db).is_none();
    let context = Context::of(request.db, request.project, request.section, included);
    let words = ["STRUC", "ENDS", "DB", "DW", "DD", "DQ"].into_iter().filter_map(catalogue::entry);
    for entry in words.filter(|entry| may_stand(request, &context, entry)) {
        add_entry(request, entry, language, list);
    }
}

fn is_operation(entry: &Entry) -> bool {
    matches!(
        entry.kind,
        EntryKind::Instruction | EntryKind::Declaration | EntryKind::Structure | EntryKind::Directive
    )
}

fn may_stand(request: &Request<'_>, context: &Context, entry: &Entry) -> bool {
    let own = request.section.kind(request.db);
    if let Some(closes) = closes(entry.name) {
        let around = request.section.outer(request.db);
        return closes(own) || around.iter().any(|kind| closes(*kind));
    }
    if matches!(entry.name, "MECH_BEGIN" | "PROC_BEGIN")
        && matches!(own, SectionKind::Mechanism | SectionKind::Procedure)
    {
        return false;
    }
    // The body of a macro goes wherever the macro is used.
    own == SectionKind::Macro && entry.kind != EntryKind::Structure || context.refuses(entry).is_none()
}

/// For a closing word: which sections it closes.
fn closes(name: &str) -> Option<Box<dyn Fn(SectionKind) -> bool + '_>> {
    Some(match name {
        "DATA_END" => Box::new(|kind| kind == SectionKind::Data),
        "DATA_LOCAL_END" => Box::new(|kind| kind == SectionKind::DataLocal),
        "MECH_END" => Box::new(|kind| kind == SectionKind::Mechanism),
        "PROC_END" => Box::new(|kind| kind == SectionKind::Procedure),
        "END_T_MACRO" => Box::new(|kind| kind == SectionKind::Macro),
        _ => {
            let keyword = name.strip_suffix("_END").filter(|keyword| keyword.starts_with("MODULE_"))?;
            Box::new(move |kind| matches!(kind, SectionKind::Module(module) if module.keyword() == keyword))
        }
    })
}

fn add_entry(request: &Request<'_>, entry: &'static Entry, language: Language, list: &mut List) {
    let own = request.section.kind(request.db);
    let names_itself = matches!(
        (entry.name, own),
        ("MECH_END", SectionKind::Mechanism) | ("PROC_END", SectionKind::Procedure)
    );
    let declared = database::section_declarations(request.db, request.section).names.first();
    let insert = match declared.filter(|_| names_itself && request.at_end) {
        Some(declared) => format!("{} {}", entry.name, declared.name.text),
        None => entry.name.to_owned(),
    };
    let structure = entry.kind == EntryKind::Structure;
    let candidate = Candidate {
        label: entry.name.to_owned(),
        insert,
        kind: if structure { CompletionKind::Structure } else { CompletionKind::Instruction },
        detail: entry.summary.in_language(language).to_owned(),
        page: Page::Entry(entry),
    };
    // What `build` refuses comes last.
    list.add(u8::from(!entry.executable), candidate);
}
