//! What of the catalogue the lines of a source text use.

use std::collections::{BTreeMap, BTreeSet};

use technol_analysis::catalogue::{self, Entry, EntryKind};
use technol_analysis::syntax::ast::{Expr, ExprKind, Line, Number, key};
use technol_analysis::syntax::parse_lines;
use technol_image::DebugInfo;
use technol_image::debug_info::SymbolKind;
use technol_image::op::Width;

/// Uses of a source text: for each the 1-based lines with it. A use is `MNEMONIC`, `MNEMONIC operand: variant`, or the
/// name of a section or declaration that the line depends on.
pub(super) type Uses = BTreeMap<String, BTreeSet<u32>>;

/// A section that is open: the words that stand for it.
struct Open {
    closer: String,
    words: Vec<String>,
}

/// The uses of `source`, whose symbols `debug` knows.
pub(super) fn uses(source: &str, debug: &DebugInfo) -> Uses {
    let lines = parse_lines(source).lines;
    let declared = declarations(&lines);
    let mut uses = Uses::new();
    let mut open: Vec<Open> = Vec::new();
    let macros = macros(source, &lines, &declared);
    for (number, line) in (1_u32..).zip(&lines) {
        let Some(operation) = &line.operation else { continue };
        // A call has the code of the body.
        for word in macros.get(&operation.key()).into_iter().flatten() {
            uses.entry(word.clone()).or_default().insert(number);
        }
        let Some(entry) = catalogue::entry(&operation.text) else { continue };
        if open.last().is_some_and(|section| section.closer == entry.name) {
            open.pop();
            continue;
        }
        if let Some(closer) = closer(entry) {
            open.push(Open { words: words_of_section(entry, &closer, line), closer });
            continue;
        }
        if entry.name == "T_LOCAL"
            && let Some(section) = open.last_mut()
        {
            section.words.push(entry.name.to_owned());
        }
        let mut found: BTreeSet<String> = open.iter().flat_map(|section| section.words.clone()).collect();
        found.insert(entry.name.to_owned());
        for operand in &line.operands {
            depends_on(operand, &declared, &mut found);
        }
        found.extend(variants_of_line(entry, line, debug));
        for word in found {
            uses.entry(word).or_default().insert(number);
        }
    }
    uses
}

/// User instructions with the words of their definitions.
fn macros(
    source: &str,
    lines: &[Line],
    declared: &BTreeMap<String, Vec<String>>,
) -> BTreeMap<String, BTreeSet<String>> {
    let mut macros: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut defined = String::new();
    for (line, text) in lines.iter().zip(source.lines()) {
        let Some(entry) = line.operation.as_ref().and_then(|name| catalogue::entry(&name.text)) else {
            continue;
        };
        let words = || text.split([' ', ',']).filter(|word| !word.is_empty()).map(key).skip(1);
        match entry.name {
            "DEF_T_MACRO" => defined = words().next().unwrap_or_default(),
            "APPEND_T_MACRO" => {
                let names: Vec<String> = words().take(2).collect();
                let [name, alias] = &names[..] else { continue };
                let mut meant = macros.get(alias).cloned().unwrap_or_default();
                meant.insert(entry.name.to_owned());
                macros.insert(name.clone(), meant);
                continue;
            }
            _ if defined.is_empty() => continue,
            _ => {}
        }
        let found = macros.entry(defined.clone()).or_default();
        found.insert(entry.name.to_owned());
        line.operands.iter().for_each(|operand| depends_on(operand, declared, found));
        if entry.name == "END_T_MACRO" {
            defined.clear();
        }
    }
    macros
}

/// What closes the section that this word opens.
fn closer(entry: &Entry) -> Option<String> {
    if !matches!(entry.kind, EntryKind::Structure | EntryKind::Directive | EntryKind::Declaration) {
        return None;
    }
    let closer = match entry.name {
        "MECH_BEGIN" => "MECH_END".to_owned(),
        "PROC_BEGIN" => "PROC_END".to_owned(),
        "DEF_T_MACRO" => "END_T_MACRO".to_owned(),
        "STRUC" => "ENDS".to_owned(),
        name => format!("{name}_END"),
    };
    catalogue::entry(&closer).map(|_| closer)
}

fn words_of_section(entry: &Entry, closer: &str, line: &Line) -> Vec<String> {
    let mut words = vec![entry.name.to_owned(), closer.to_owned()];
    for operand in &line.operands {
        if let ExprKind::Name(name) = &operand.kind
            && let Some(event) = catalogue::entry(&name.text)
            && event.kind == EntryKind::EventProcedure
        {
            words.push(event.name.to_owned());
        }
    }
    words
}

/// Names with the words that declare them.
fn declarations(lines: &[Line]) -> BTreeMap<String, Vec<String>> {
    let mut declared: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut sections: Vec<Open> = Vec::new();
    for line in lines {
        let Some(entry) = line.operation.as_ref().and_then(|name| catalogue::entry(&name.text)) else {
            continue;
        };
        if sections.last().is_some_and(|section| section.closer == entry.name) {
            sections.pop();
            continue;
        }
        let mut words: Vec<String> = sections.iter().flat_map(|section| section.words.clone()).collect();
        words.push(entry.name.to_owned());
        if let Some(closer) = closer(entry) {
            sections.push(Open { words: words_of_section(entry, &closer, line), closer });
        }
        if entry.kind != EntryKind::Declaration && entry.name != "STRUC" {
            continue;
        }
        let names = line.operands.iter().filter_map(|operand| match &operand.kind {
            ExprKind::Name(name) if matches!(entry.name, "DFM" | "EQUI") => Some(name),
            _ => None,
        });
        for name in line.label.iter().chain(names) {
            declared.entry(name.key()).or_default().extend(words.iter().cloned());
        }
    }
    declared
}

/// Declarations and keywords that an operand depends on.
fn depends_on(expr: &Expr, declared: &BTreeMap<String, Vec<String>>, found: &mut BTreeSet<String>) {
    match &expr.kind {
        ExprKind::Name(name) => {
            found.extend(declared.get(&name.key()).into_iter().flatten().cloned());
            if let Some(entry) = catalogue::entry(&name.text)
                && matches!(entry.kind, EntryKind::Keyword | EntryKind::TypePrefix | EntryKind::Directive)
            {
                found.insert(entry.name.to_owned());
            }
            // REAL is an instruction and a prefix.
            if let Some(spelling) = catalogue::prefix(&name.text) {
                found.insert(spelling.prefix.name().to_owned());
            }
        }
        ExprKind::Sign { operand, .. } | ExprKind::Parens(operand) => depends_on(operand, declared, found),
        ExprKind::Sum { left, right, .. } | ExprKind::Dot { left, right } => {
            depends_on(left, declared, found);
            depends_on(right, declared, found);
        }
        ExprKind::Index { base, index } => {
            depends_on(base, declared, found);
            depends_on(index, declared, found);
        }
        ExprKind::Missing
        | ExprKind::Dash
        | ExprKind::Dollar
        | ExprKind::Number(_)
        | ExprKind::Text(_)
        | ExprKind::Error => {}
    }
}

/// `MNEMONIC operand: variant` for each operand of the line.
fn variants_of_line(entry: &Entry, line: &Line, debug: &DebugInfo) -> Vec<String> {
    let mut found = Vec::new();
    let count = line.operands.len();
    let last = entry.operands.len().saturating_sub(1);
    for (at, operand) in line.operands.iter().enumerate() {
        let Some(spec) = entry.operands.get(at.min(last)) else { continue };
        let mut variants = BTreeSet::new();
        describe(operand, debug, &mut variants);
        if at > last {
            variants.insert("repeated".to_owned());
        }
        found.extend(variants.into_iter().map(|variant| format!("{} {}: {variant}", entry.name, spec.name)));
    }
    for spec in entry.operands.iter().skip(count) {
        found.push(format!("{} {}: left out", entry.name, spec.name));
    }
    found
}

/// How an operand is written.
fn describe(expr: &Expr, debug: &DebugInfo, found: &mut BTreeSet<String>) {
    let mut insert = |variant: &str| {
        found.insert(variant.to_owned());
    };
    match &expr.kind {
        ExprKind::Missing | ExprKind::Dash => insert("-"),
        ExprKind::Number(Number::Integer(n)) => {
            insert("number");
            insert(&format!("={n}"));
        }
        ExprKind::Number(Number::Real(_)) => insert("real number"),
        ExprKind::Text(_) => insert("literal"),
        ExprKind::Name(name) => {
            insert(&key(&name.text));
            insert(kind_of(&name.key(), debug));
        }
        ExprKind::Sign { negative, operand } => {
            if *negative && !matches!(operand.kind, ExprKind::Number(_)) {
                insert("negated");
            }
            describe(operand, debug, found);
        }
        ExprKind::Sum { left, right, .. } if left.kind == ExprKind::Dollar => describe(right, debug, found),
        ExprKind::Sum { left, .. } => describe(left, debug, found),
        ExprKind::Parens(inside) => describe(inside, debug, found),
        ExprKind::Index { base, .. } => {
            insert("indexed");
            describe(base, debug, found);
        }
        ExprKind::Dot { left, right } => match &left.kind {
            ExprKind::Name(name) if catalogue::prefix(&name.text).is_some() => {
                insert(&format!("{}.", key(&name.text)));
            }
            _ if contains_block(left) => {}
            _ => {
                insert("adr.bit");
                if let ExprKind::Dot { right, .. } = &right.kind {
                    describe(right, debug, found);
                }
            }
        },
        ExprKind::Dollar | ExprKind::Error => {}
    }
}

/// `BLK[n].…`
fn contains_block(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Name(name) => name.key() == "BLK",
        ExprKind::Index { base, .. } => contains_block(base),
        ExprKind::Dot { left, .. } => contains_block(left),
        _ => false,
    }
}

fn kind_of(name: &str, debug: &DebugInfo) -> &'static str {
    match debug.symbols.iter().find(|symbol| key(&symbol.name) == name).map(|symbol| &symbol.kind) {
        Some(SymbolKind::Bit { .. }) => "bit",
        Some(SymbolKind::Cell { width, .. }) => match width {
            Width::Byte => "BYTE cell",
            Width::Word => "WORD cell",
            Width::DWord => "DWORD cell",
            Width::QWord => "QWORD cell",
            Width::Real => "REAL cell",
        },
        Some(SymbolKind::Area { .. }) => "area",
        Some(SymbolKind::Text { .. }) => "text",
        Some(SymbolKind::Constant { .. }) => "number",
        Some(SymbolKind::Mechanism { .. }) => "mechanism",
        Some(SymbolKind::Procedure { .. }) => "procedure",
        Some(SymbolKind::Label { .. }) => "label",
        None => "name",
    }
}

#[test]
fn a_line_uses_what_it_is_made_of_and_a_comment_nothing() {
    let source = "DATA\nC: DS 2\nDATA_END\nMECH_BEGIN M\n AD BYTE.C ; STO C\n; LOD C\nMECH_END M\n CA";
    let found = uses(source, &DebugInfo::default());
    let of = |line: u32| -> Vec<&str> {
        found.iter().filter(|(_, lines)| lines.contains(&line)).map(|(using, _)| using.as_str()).collect()
    };
    assert_eq!(of(5), ["AD", "AD val: BYTE.", "BYTE", "DATA", "DATA_END", "DS", "MECH_BEGIN", "MECH_END"]);
    assert_eq!((of(6), of(8)), (vec![], vec!["CA"]));
}
