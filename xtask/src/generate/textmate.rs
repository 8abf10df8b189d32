//! The TextMate grammar that colours programs in VS Code and wherever else such grammars are read.
//!
//! A statement is recognised by its first word, so that a name spelled like an instruction keeps its colour as an
//! operand; what stands behind it is coloured word by word.

use std::collections::BTreeSet;

use serde_json::{Value, json};
use technol_analysis::catalogue::{Entry, EntryKind, OperandKind, Prefix, SystemKind, entries, symbols};

/// A name, as the language has it.
const NAME: &str = "[A-Za-z_?@][A-Za-z0-9_?@]*";
/// Nothing of a name before this place.
const FROM: &str = "(?<![A-Za-z0-9_?@])";
/// Nothing of a name, and no colon of a label, behind this place.
const TO: &str = "(?![A-Za-z0-9_?@:])";

pub(super) fn grammar() -> Value {
    let mut patterns = vec![
        json!({ "name": "comment.line.semicolon.technol", "match": ";.*$" }),
        json!({ "name": "string.quoted.single.technol", "match": "'(?:[^'\\r\\n]|'')*'" }),
    ];
    patterns.extend(declarations_of_blocks());
    for (kind, scope, label) in GROUPS {
        let words = names(*kind);
        patterns.push(json!({
            "match": format!("(?i)^[ \\t]*(?:({NAME})(:)[ \\t]*)?({}){TO}", alternatives(&words)),
            "captures": {
                "1": { "name": label },
                "2": { "name": "punctuation.separator.label.technol" },
                "3": { "name": scope },
            },
        }));
    }
    patterns.push(json!({
        "match": format!("^[ \\t]*({NAME})(:)"),
        "captures": {
            "1": { "name": "entity.name.label.technol" },
            "2": { "name": "punctuation.separator.label.technol" },
        },
    }));
    patterns.extend(operands());
    json!({
        "name": "TECHNOL",
        "scopeName": "source.technol",
        "fileTypes": ["plc", "inc"],
        "patterns": patterns,
    })
}

/// What the first word of a statement can be.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    /// Instructions that jump, wait or call.
    Flow,
    /// The other instructions.
    Plain,
    Declaration,
    Directive,
    Structure,
}

/// Each group's scope, and that of a label before it.
const GROUPS: &[(Group, &str, &str)] = &[
    (Group::Declaration, "storage.type.technol", "variable.other.declaration.technol"),
    (Group::Directive, "keyword.control.directive.technol", "entity.name.label.technol"),
    (Group::Structure, "keyword.control.structure.technol", "entity.name.label.technol"),
    (Group::Flow, "keyword.control.flow.technol", "entity.name.label.technol"),
    (Group::Plain, "keyword.other.mnemonic.technol", "entity.name.label.technol"),
];

fn group(entry: &Entry) -> Option<Group> {
    match entry.kind {
        EntryKind::Instruction => {
            let leads_on =
                |kind: OperandKind| matches!(kind, OperandKind::Label | OperandKind::Procedure { .. });
            let flow = entry.ex_type || entry.operands.iter().any(|it| leads_on(it.kind));
            Some(if flow { Group::Flow } else { Group::Plain })
        }
        EntryKind::Declaration => Some(Group::Declaration),
        EntryKind::Directive => Some(Group::Directive),
        EntryKind::Structure => Some(Group::Structure),
        EntryKind::TypePrefix | EntryKind::Keyword | EntryKind::EventProcedure => None,
    }
}

fn names(wanted: Group) -> BTreeSet<String> {
    entries().filter(|it| group(it) == Some(wanted)).map(|it| it.name.to_owned()).collect()
}

fn names_of_kind(wanted: EntryKind) -> BTreeSet<String> {
    entries().filter(|it| it.kind == wanted).map(|it| it.name.to_owned()).collect()
}

/// Lines that name what they open: the name gets the colour of a definition.
fn declarations_of_blocks() -> Vec<Value> {
    let named = |declares: fn(OperandKind) -> bool| -> BTreeSet<String> {
        entries()
            .filter(|it| it.operands.first().is_some_and(|operand| declares(operand.kind)))
            .map(|it| it.name.to_owned())
            .collect()
    };
    let line = |words: &BTreeSet<String>, keyword: &str, name: &str| {
        json!({
            "match": format!("(?i)^[ \\t]*({})[ \\t]+({NAME})", alternatives(words)),
            "captures": { "1": { "name": keyword }, "2": { "name": name } },
        })
    };
    let mechanism = named(|it| it == OperandKind::Mechanism { declares: true });
    let procedure = named(|it| it == OperandKind::Procedure { declares: true });
    let constant = named(|it| it == OperandKind::NewName);
    // `name STRUC`, `member DW ?`: the word comes second.
    let second: BTreeSet<String> = entries()
        .filter(|it| it.forms.iter().any(|form| second_word(form.syntax) == Some(it.name)))
        .map(|it| it.name.to_owned())
        .collect();
    vec![
        line(&mechanism, "keyword.control.structure.technol", "entity.name.class.mechanism.technol"),
        line(&procedure, "keyword.control.structure.technol", "entity.name.function.procedure.technol"),
        line(&constant, "storage.type.technol", "variable.other.constant.technol"),
        json!({
            "match": format!("(?i)^[ \\t]*({NAME})[ \\t]+({}){TO}", alternatives(&second)),
            "captures": { "1": { "name": "variable.other.declaration.technol" }, "2": { "name": "storage.type.technol" } },
        }),
    ]
}

/// The second word of a form whose first is the place of a name.
fn second_word(syntax: &str) -> Option<&str> {
    let mut words = syntax.split(' ');
    let name = words.next()?.chars().all(|c| c.is_ascii_lowercase());
    words.next().filter(|_| name)
}

/// What can stand behind the first word.
fn operands() -> Vec<Value> {
    let prefixes: BTreeSet<String> = Prefix::ALL.iter().map(|it| it.name().to_owned()).collect();
    let is_constant = |kind: SystemKind| matches!(kind, SystemKind::Constant(_));
    let system = |constant: bool| -> BTreeSet<String> {
        symbols().filter(|it| is_constant(it.kind) == constant).map(|it| numberless(it.name)).collect()
    };
    let word = |scope: &str, words: &BTreeSet<String>| json!({ "name": scope, "match": format!("(?i){FROM}(?:{}){TO}", alternatives(words)) });
    vec![
        json!({
            "match": format!("(?i){FROM}({})(\\.)", alternatives(&prefixes)),
            "captures": {
                "1": { "name": "storage.modifier.prefix.technol" },
                "2": { "name": "punctuation.accessor.technol" },
            },
        }),
        word("constant.language.technol", &names_of_kind(EntryKind::Keyword)),
        word("support.function.event.technol", &names_of_kind(EntryKind::EventProcedure)),
        word("support.variable.system.technol", &system(false)),
        word("support.constant.system.technol", &system(true)),
        json!({
            "name": "constant.numeric.technol",
            "match": format!("(?i){FROM}(?:[0-9]+\\.[0-9]+|[0-9][0-9A-F]*H|[01]+B|[0-9]+D?){TO}"),
        }),
        json!({ "name": "variable.language.here.technol", "match": "\\$" }),
        json!({ "name": "keyword.operator.technol", "match": "[-+?]" }),
        json!({ "name": "punctuation.separator.technol", "match": "," }),
        json!({ "name": "variable.other.technol", "match": NAME }),
    ]
}

/// A symbol's name with each run of digits standing for any number: the families of ports count to hundreds, and
/// a grammar need not know where they end.
fn numberless(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        if !c.is_ascii_digit() {
            out.push(c);
        } else if !out.ends_with("\\d+") {
            out.push_str("\\d+");
        }
    }
    out
}

/// The words as alternatives of a pattern, longer ones first: the first that fits is taken.
fn alternatives(words: &BTreeSet<String>) -> String {
    let mut words: Vec<&str> = words.iter().map(String::as_str).collect();
    words.sort_by_key(|it| (std::cmp::Reverse(it.len()), *it));
    // A set that is empty must match nothing, not everything.
    if words.is_empty() { "(?!)".to_owned() } else { words.join("|").replace('?', "\\?") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_of_the_catalogue_is_somewhere_in_the_grammar() {
        let text = grammar().to_string();
        for entry in entries().filter(|it| it.kind != EntryKind::TypePrefix) {
            assert!(text.contains(entry.name), "{}", entry.name);
        }
    }

    #[test]
    fn jumps_and_waits_are_told_from_the_rest() {
        let flow = names(Group::Flow);
        for (name, expected) in [("JL1", true), ("TEX0", true), ("EX", true), ("LDR", false), ("STO", false)]
        {
            assert_eq!(flow.contains(name), expected, "{name}");
        }
    }

    #[test]
    fn families_of_symbols_become_one_pattern() {
        assert_eq!(numberless("P128IN"), "P\\d+IN");
        assert_eq!(numberless("TYPE_INT_16"), "TYPE_INT_\\d+");
    }

    #[test]
    fn a_structure_s_word_comes_second() {
        assert_eq!(second_word("member DB ?"), Some("DB"));
        assert_eq!(second_word("name: DS 1"), None);
        assert_eq!(second_word("WR [ADR.]bit"), None);
    }
}
