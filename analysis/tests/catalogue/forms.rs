//! Lines from the forms of the help: `LDR [-][ADR.]bit` becomes `LDR W_BIT` and `LDR -W_BYTE.W_BIT`.
//!
//! `[…]` is left out or taken, `a|b` stands for each of them, `…` for nothing more. A word that names an operand becomes
//! a sample of it; of all other words [`GENERIC`] says what they stand for.

use technol_analysis::catalogue::{self, Entry, OperandKind, OperandSpec, Prefix, PrefixSet};

use super::samples::{Around, fitting};

/// Words of forms that are no operands by themselves.
const GENERIC: &[(&str, &str)] = &[
    ("n", "2"),
    ("m", "1"),
    ("offset", "1"),
    ("number", "5"),
    ("real", "2.5"),
    ("c", "A"),
    ("ADR", "W_BYTE"),
    ("ADR2", "W_BYTE"),
    ("name", "W_AREA"),
    ("cell", "W_AREA"),
    ("text", "W_TEXT"),
    ("time", "50"),
    ("label", "W_LABEL{case}"),
    ("file", "WALK.INC"),
    ("INSTRUCTION", "LOD"),
    ("parameter", "parameter"),
    ("prefix", "BYTE"),
    ("CX", "CX"),
    ("DUP", "DUP"),
];

/// A variant of a form: its text with groups and alternatives decided.
pub(crate) fn variants(syntax: &str) -> Vec<String> {
    let mut all = Vec::new();
    for optional in [false, true] {
        for chosen in alternatives(&groups(syntax, optional).replace('…', "")) {
            if !all.contains(&chosen) {
                all.push(chosen);
            }
        }
    }
    all
}

/// Takes or leaves the groups in brackets. A bracket right behind a word is an index.
fn groups(syntax: &str, take: bool) -> String {
    let mut text = String::new();
    // For each open bracket: whether it is an index.
    let mut open: Vec<bool> = Vec::new();
    for c in syntax.chars() {
        let left_out = !take && open.iter().any(|index| !index);
        match c {
            '[' => {
                let index = text.ends_with(|c: char| c.is_ascii_alphanumeric()) && !left_out;
                open.push(index);
                if index {
                    text.push(c);
                }
            }
            ']' => {
                if open.pop() == Some(true) {
                    text.push(c);
                }
            }
            _ if left_out => {}
            _ => text.push(c),
        }
    }
    text
}

/// `FL 0|1, bit` is `FL 0, bit` and `FL 1, bit`.
fn alternatives(text: &str) -> Vec<String> {
    let word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '|';
    let Some(bar) = text.find('|') else { return vec![text.to_string()] };
    let start = text[..bar].rfind(|c| !word(c)).map_or(0, |at| at + 1);
    let end = text[bar..].find(|c| !word(c)).map_or(text.len(), |at| bar + at);
    let each = |choice: &str| alternatives(&format!("{}{choice}{}", &text[..start], &text[end..]));
    text[start..end].split('|').flat_map(each).collect()
}

/// Instructions that carry forms which are only an operand.
const CARRIERS: &[(&str, &str)] = &[
    ("BYTE", "LOD {}"),
    ("WORD", "LOD {}"),
    ("HIGH", "LOD {}"),
    ("CNST", "LOD {}"),
    ("DWRD", "LOD {}"),
    ("QWRD", "LOD {}"),
    ("name[", "LOD BYTE.{}"),
    ("(name[", "LOD BYTE.{}"),
    ("text+", "STRCPY {},'A'"),
    ("TMAC", "LOD {}"),
    ("-TMAC", "LOD {}"),
];

/// The whole line of a form that is only an operand.
pub(crate) fn carried(variant: &str) -> String {
    let carrier = CARRIERS.iter().find(|(start, _)| variant.starts_with(start));
    carrier.map_or_else(|| variant.to_string(), |(_, line)| line.replace("{}", variant))
}

/// The source line of a variant; the error is a word nobody knows.
pub(crate) fn line(
    entry: &Entry,
    variant: &str,
    case: usize,
    prefix: Option<Prefix>,
) -> Result<String, String> {
    let mut text = String::new();
    let mut rest = variant;
    while let Some(c) = rest.chars().next() {
        if c == '\'' {
            let end = rest[1..].find('\'').map_or(rest.len(), |at| at + 2);
            text.push_str(if end == 3 { "'A'" } else { "'Walk'" });
            rest = &rest[end..];
        } else if c.is_ascii_alphabetic() || c == '_' {
            let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
            let around = Around { memory: text.ends_with('.') || rest[end..].starts_with('+'), case };
            let behind = rest[end..].trim_start();
            let structure = ["STRUC", "ENDS", "DB ", "DW ", "DD ", "DQ "];
            let first = text.is_empty()
                && (behind.starts_with(':') || structure.iter().any(|word| behind.starts_with(word)));
            text.push_str(&word(entry, &rest[..end], around, prefix, first)?);
            rest = &rest[end..];
        } else {
            text.push(c);
            rest = &rest[c.len_utf8()..];
        }
    }
    Ok(text)
}

fn word(
    entry: &Entry,
    word: &str,
    around: Around,
    prefix: Option<Prefix>,
    declares: bool,
) -> Result<String, String> {
    let is_name = |operand: &&OperandSpec| {
        operand.name == word || word.strip_suffix(|c: char| c.is_ascii_digit()) == Some(operand.name)
    };
    if declares {
        return Ok(format!("W_NEW{}", around.case));
    }
    if word == "TYPE" {
        return prefix.map(|prefix| prefix.name().to_string()).ok_or_else(|| "TYPE".to_string());
    }
    if let Some(operand) = entry.operands.iter().find(is_name) {
        let digit = operand.name != word;
        let text = fitting(entry, operand, around);
        // Names that must be new differ in their digit too.
        let new = matches!(operand.kind, OperandKind::NewBit | OperandKind::NewName);
        return Ok(if new && digit { format!("{text}_{word}") } else { text });
    }
    if let Some((_, text)) = GENERIC.iter().find(|(generic, _)| *generic == word) {
        return Ok(text.replace("{case}", &around.case.to_string()));
    }
    let keyword = |kind: OperandKind| {
        match kind {
        OperandKind::Keyword(words) | OperandKind::KeywordOrNumber(words, ..) => words.contains(&word),
        OperandKind::OneOf(kinds) => kinds.iter().any(|kind| {
            matches!(kind, OperandKind::Keyword(words) | OperandKind::KeywordOrNumber(words, ..) if words.contains(&word))
        }),
        _ => false,
    }
    };
    let known = catalogue::entry(word).is_some()
        || catalogue::symbol(word).is_some()
        || entry.operands.iter().any(|operand| keyword(operand.kind));
    if known { Ok(word.to_string()) } else { Err(word.to_string()) }
}

/// Prefixes that TYPE may stand for: those of the first operand that takes some, without CNST and HIGH, which have
/// forms of their own.
pub(crate) fn prefixes(entry: &Entry) -> Vec<Prefix> {
    let of = |kind: OperandKind| match kind {
        OperandKind::Data { prefixes, .. } => prefixes,
        OperandKind::AutoCounter => PrefixSet::of(&[Prefix::Byte, Prefix::Word]),
        _ => PrefixSet::NONE,
    };
    let set = entry.operands.iter().map(|operand| of(operand.kind)).find(|set| *set != PrefixSet::NONE);
    let fits = |prefix: &Prefix| {
        set.is_some_and(|set| set.contains(*prefix)) && !matches!(prefix, Prefix::Cnst | Prefix::High)
    };
    Prefix::ALL.into_iter().filter(fits).collect()
}
