//! What the catalogue demands a run-time test for.

use std::collections::BTreeSet;

use technol_analysis::catalogue::{Entry, EntryKind, OperandKind, OperandSpec, Prefix, PrefixSet, entries};

/// The uses that must be tested: each entry, and each way to write each of its operands.
pub(super) fn required() -> BTreeSet<String> {
    entries().filter(|entry| !entry.is_known_only()).flat_map(of_entry).collect()
}

fn of_entry(entry: &Entry) -> Vec<String> {
    let mut uses = vec![entry.name.to_owned()];
    // What the others say is said to the compiler; at run time only their effect shows.
    let operands = if entry.kind == EntryKind::Instruction { entry.operands } else { &[] };
    for spec in operands {
        uses.extend(
            of_operand(spec).into_iter().map(|variant| format!("{} {}: {variant}", entry.name, spec.name)),
        );
    }
    uses
}

fn of_operand(spec: &OperandSpec) -> BTreeSet<String> {
    let mut variants = BTreeSet::new();
    of_kind(spec.kind, &mut variants);
    if spec.optional {
        variants.insert("left out".to_owned());
    }
    if spec.skippable {
        variants.insert("-".to_owned());
    }
    if spec.repeatable {
        variants.insert("repeated".to_owned());
    }
    variants
}

fn of_kind(kind: OperandKind, variants: &mut BTreeSet<String>) {
    let mut insert = |variant: &str| {
        variants.insert(variant.to_owned());
    };
    match kind {
        OperandKind::Bit { negatable, extended, .. } => {
            insert("bit");
            if negatable {
                insert("negated");
            }
            if extended {
                insert("adr.bit");
            }
        }
        OperandKind::Data { prefixes, declared, negatable, .. } => {
            for prefix in in_set(prefixes) {
                insert(&format!("{}.", prefix.name()));
            }
            for declared in in_set(declared) {
                insert(match declared {
                    Prefix::Byte => "BYTE cell",
                    Prefix::Word => "WORD cell",
                    Prefix::Dwrd => "DWORD cell",
                    Prefix::Cnst => "number",
                    Prefix::High | Prefix::Qwrd | Prefix::Real => continue,
                });
            }
            if negatable {
                insert("negated");
            }
        }
        OperandKind::AutoCounter => ["BYTE cell", "WORD cell", "-", "NIL"].into_iter().for_each(insert),
        OperandKind::Time => ["BYTE cell", "WORD cell", "number"].into_iter().for_each(insert),
        OperandKind::NumberOf(numbers) => numbers.iter().for_each(|n| insert(&format!("={n}"))),
        OperandKind::Keyword(words) => words.iter().for_each(|word| insert(&word.to_ascii_uppercase())),
        OperandKind::KeywordOrNumber(words, ..) => {
            for word in words {
                insert(&word.to_ascii_uppercase());
            }
            insert("number");
        }
        OperandKind::Value(prefixes) => {
            in_set(prefixes).for_each(|prefix| insert(&format!("{}.", prefix.name())));
        }
        OperandKind::TextOrLiteral | OperandKind::Identifier(_) => {
            ["text", "literal"].into_iter().for_each(insert);
        }
        OperandKind::LiteralOrAddress => insert("literal"),
        OperandKind::DeclaredElement => insert("indexed"),
        OperandKind::OneOf(kinds) => {
            for kind in kinds {
                of_kind(*kind, variants);
            }
        }
        OperandKind::Number { .. } => insert("number"),
        // One way to write them, which the entry itself demands.
        OperandKind::BitPosition
        | OperandKind::Address(_)
        | OperandKind::Label
        | OperandKind::Mechanism { .. }
        | OperandKind::Procedure { .. }
        | OperandKind::NewName
        | OperandKind::NewBit
        | OperandKind::Constant
        | OperandKind::RealConstant
        | OperandKind::Text(_)
        | OperandKind::Declares(_)
        | OperandKind::Any => {}
    }
}

fn in_set(set: PrefixSet) -> impl Iterator<Item = Prefix> {
    Prefix::ALL.into_iter().filter(move |prefix| set.contains(*prefix))
}
