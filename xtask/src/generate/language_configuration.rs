//! VS Code's language configuration: comments, brackets, words, and what folds.

use serde_json::{Value, json};
use technol_analysis::catalogue::{EntryKind, entries};

use super::case::any_case;

pub(super) fn configuration() -> Value {
    let blocks = blocks();
    let starts: Vec<&str> = blocks.iter().map(|(start, _)| *start).collect();
    let ends: Vec<&str> = blocks.iter().map(|(_, end)| *end).collect();
    json!({
        "comments": { "lineComment": ";" },
        "brackets": [["(", ")"], ["[", "]"]],
        "autoClosingPairs": [
            { "open": "(", "close": ")", "notIn": ["string", "comment"] },
            { "open": "[", "close": "]", "notIn": ["string", "comment"] },
            { "open": "'", "close": "'", "notIn": ["string", "comment"] },
        ],
        "surroundingPairs": [["(", ")"], ["[", "]"], ["'", "'"]],
        "wordPattern": "[A-Za-z0-9_?@]+",
        "folding": { "markers": { "start": line_of(&starts), "end": line_of(&ends) } },
    })
}

/// A line whose first word is one of `words`. VS Code drops the flags of folding patterns, hence both cases.
fn line_of(words: &[&str]) -> String {
    let words: Vec<String> = words.iter().map(|it| any_case(it)).collect();
    format!("^[ \\t]*(?:{})(?![A-Za-z0-9_?@:])", words.join("|"))
}

/// The words that open and close a block: `X` … `X_END`, `X_BEGIN` … `X_END`, `DEF_X` … `END_X`.
fn blocks() -> Vec<(&'static str, &'static str)> {
    let names: Vec<&'static str> = entries()
        .filter(|it| matches!(it.kind, EntryKind::Structure | EntryKind::Directive))
        .map(|it| it.name)
        .collect();
    let mut blocks = Vec::new();
    for start in &names {
        let stem = start.strip_suffix("_BEGIN").unwrap_or(start);
        let ends = [format!("{stem}_END"), format!("END_{}", start.strip_prefix("DEF_").unwrap_or(start))];
        if let Some(end) = names.iter().find(|name| ends.iter().any(|end| end == *name)) {
            blocks.push((*start, *end));
        }
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_block_is_found() {
        let blocks = blocks();
        for block in [
            ("DATA", "DATA_END"),
            ("DATA_LOCAL", "DATA_LOCAL_END"),
            ("MODULE_MAIN", "MODULE_MAIN_END"),
            ("MECH_BEGIN", "MECH_END"),
            ("PROC_BEGIN", "PROC_END"),
            ("DEF_T_MACRO", "END_T_MACRO"),
        ] {
            assert!(blocks.contains(&block), "{block:?}");
        }
    }
}
