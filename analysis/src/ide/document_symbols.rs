//! Outline of a file: modules with their mechanisms and procedures, data with what they declare.

use super::SymbolTag;
use crate::database::{self, Db, Section, SourceFile};
use crate::location::{Position, Span};
use crate::semantics::declarations::{Declared, What};
use crate::syntax::section::SectionKind;

/// An entry of the outline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DocumentSymbol {
    /// Name as written.
    pub name: String,
    /// A few words more, or nothing.
    pub detail: String,
    /// What it is.
    pub kind: SymbolTag,
    /// All of it.
    pub span: Span,
    /// Its name.
    pub selection: Span,
    /// What stands in it.
    pub children: Vec<DocumentSymbol>,
}

/// The outline of a file, in order of the text.
#[must_use]
pub fn document_symbols(db: &dyn Db, file: SourceFile) -> Vec<DocumentSymbol> {
    database::sections(db, file).first().map_or_else(Vec::new, |root| contents(db, *root))
}

/// Declarations and nested sections of a section.
fn contents(db: &dyn Db, section: Section<'_>) -> Vec<DocumentSymbol> {
    let mut found = declared(db, section);
    found.extend(section.children(db).iter().filter_map(|(child, _)| outline(db, *child)));
    found.sort_by_key(|symbol| symbol.span.start);
    found
}

fn outline(db: &dyn Db, section: Section<'_>) -> Option<DocumentSymbol> {
    let lines = section.lines(db);
    let first = database::section_lines(db, section).lines.first()?;
    let operation = first.operation.as_ref()?;
    let (kind, selection) = match section.kind(db) {
        SectionKind::File => return None,
        SectionKind::Data | SectionKind::DataLocal => (SymbolTag::Data, operation),
        SectionKind::Module(_) => (SymbolTag::Module, operation),
        named => {
            let name =
                database::section_declarations(db, section).names.first().filter(|d| d.what != What::Label);
            let kind = match named {
                SectionKind::Mechanism => SymbolTag::Mechanism,
                SectionKind::Procedure => SymbolTag::Procedure,
                _ => SymbolTag::Macro,
            };
            (kind, name.map_or(operation, |declared| &declared.name))
        }
    };
    let children = contents(db, section);
    let start = Position { line: *lines.first()?, column: 0 };
    let last_own = lines.len() - 1;
    let last =
        Position { line: lines[last_own], column: database::section_lines(db, section).lines[last_own].len };
    let end = children.iter().map(|child| child.span.end).fold(last, Position::max);
    Some(DocumentSymbol {
        name: selection.text.clone(),
        detail: String::new(),
        kind,
        span: Span { start, end },
        selection: Span::in_line(start.line, selection.columns.start, selection.columns.end),
        children,
    })
}

/// What the own lines of a section declare; the bits of a named byte stand in it.
fn declared(db: &dyn Db, section: Section<'_>) -> Vec<DocumentSymbol> {
    let mut found: Vec<DocumentSymbol> = Vec::new();
    // Where in `found` the cell of a piece of storage stands.
    let mut cell: Option<(u32, usize)> = None;
    for name in &database::section_declarations(db, section).names {
        if matches!(name.what, What::Label | What::Mechanism | What::Procedure) {
            continue;
        }
        if matches!(name.what, What::Macro) && section.kind(db) == SectionKind::Macro {
            continue;
        }
        let Some(symbol) = entry(db, section, name) else { continue };
        match name.what {
            What::Bit { storage, .. } if cell.is_some_and(|(of, _)| of == storage) => {
                if let Some(parent) = cell.and_then(|(_, at)| found.get_mut(at)) {
                    parent.span.end = parent.span.end.max(symbol.span.end);
                    parent.children.push(symbol);
                }
            }
            What::Cell { storage } => {
                cell = Some((storage, found.len()));
                found.push(symbol);
            }
            _ => found.push(symbol),
        }
    }
    found
}

fn entry(db: &dyn Db, section: Section<'_>, declared: &Declared) -> Option<DocumentSymbol> {
    let line = *section.lines(db).get(declared.line as usize)?;
    let own = database::section_lines(db, section).lines.get(declared.line as usize)?;
    let columns = &declared.name.columns;
    // A name before a colon stands for its whole line, a bit only for itself.
    let whole = own.label.as_ref().is_some_and(|label| label.columns == *columns);
    let end = if whole { own.len } else { columns.end };
    Some(DocumentSymbol {
        name: declared.name.text.clone(),
        detail: detail(declared),
        kind: SymbolTag::of(&declared.what)?,
        span: Span::in_line(line, columns.start, end),
        selection: Span::in_line(line, columns.start, columns.end),
        children: Vec::new(),
    })
}

fn detail(declared: &Declared) -> String {
    match &declared.what {
        What::Bit { bit, .. } => format!("d{bit}"),
        What::Text { len, .. } => len.to_string(),
        What::Constant(Some(value)) => value.to_string(),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use super::super::fixture::fixture;
    use super::*;

    fn check(text: &str) -> String {
        let it = fixture(text);
        let mut out = String::new();
        for symbol in it.analysis.document_symbols(&it.file).expect("not cancelled") {
            write(&symbol, 0, &mut out);
        }
        out
    }

    fn write(symbol: &DocumentSymbol, depth: usize, out: &mut String) {
        let Span { start, end } = symbol.span;
        assert!(start <= symbol.selection.start && symbol.selection.end <= end, "{symbol:?}");
        let lines = format!("{}:{}-{}:{}", start.line + 1, start.column, end.line + 1, end.column);
        let indent = "  ".repeat(depth);
        writeln!(out, "{indent}{:?} {} {} [{lines}]", symbol.kind, symbol.name, symbol.detail)
            .expect("a String");
        for child in &symbol.children {
            assert!(start <= child.span.start && child.span.end <= end, "{child:?} in {symbol:?}");
            write(child, depth + 1, out);
        }
    }

    #[test]
    fn sections_nest_and_bits_stand_in_their_byte() {
        insta::assert_snapshot!(check("\
EQUI LIMIT,10
DEF_T_MACRO Swap A,B
END_T_MACRO
DATA
 COUNT: DS 2
 STATE: DFM RUN,,FAULT
        DFM LOOSE
 TABLE: DS 30
 NOTE: STR 9,'on'
 ALONE:
        DFM BEHIND
DATA_END
MODULE_MAIN
L: LDR RUN
 MECH_BEGIN Clamp
  DATA_LOCAL
   INNER: DS 1
  DATA_LOCAL_END
 MECH_END Clamp
 PROC_BEGIN Count1
 PROC_END Count1
MODULE_MAIN_END
"), @"
        Constant LIMIT 10 [1:5-1:10]
        Macro Swap  [2:0-3:11]
        Data DATA  [4:0-12:8]
          Cell COUNT  [5:1-5:12]
          Cell STATE  [6:1-6:22]
            Bit RUN d0 [6:12-6:15]
            Bit FAULT d2 [6:17-6:22]
          Bit LOOSE d0 [7:12-7:17]
          Area TABLE  [8:1-8:13]
          Text NOTE 9 [9:1-9:17]
          Cell ALONE  [10:1-11:18]
            Bit BEHIND d0 [11:12-11:18]
        Module MODULE_MAIN  [13:0-22:15]
          Mechanism Clamp  [15:0-19:15]
            Data DATA_LOCAL  [16:0-18:16]
              Cell INNER  [17:3-17:14]
          Procedure Count1  [20:0-21:16]
        ");
    }

    #[test]
    fn sections_without_a_name_or_an_end_are_listed() {
        insta::assert_snapshot!(check("MODULE_MAIN\n MECH_BEGIN\n  EX\n MECH_BEGIN B\n  EX"), @"
        Module MODULE_MAIN  [1:0-5:4]
          Mechanism MECH_BEGIN  [2:0-3:4]
          Mechanism B  [4:0-5:4]
        ");
    }

    #[test]
    fn an_empty_file_has_no_outline() {
        assert_eq!(check("\n"), "");
    }
}
