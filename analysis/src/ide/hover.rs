//! Help on what stands at a position.

use std::fmt::Write;

use super::cursor::{self, Cursor, Meaning};
use super::{configured, describe};
use crate::catalogue::{self, EntryKind, Language, page};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::location::{Position, Span};
use crate::semantics::declarations::What;
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::layout::PlacedKind;
use crate::syntax::{self, ast::Line};

/// Help on a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// Markdown.
    pub markdown: String,
    /// The word.
    pub span: Span,
}

/// For instructions, keywords and predefined symbols their page of the catalogue; for the project's own names the
/// line that declares them with its comment, what they are, and where they lie.
#[must_use]
pub fn hover(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    at: Position,
    language: Language,
) -> Option<Hover> {
    let cursor = Cursor::at(db, project, file, at)?;
    let named = configured::in_section(db, project, cursor.section, cursor.own, at.column);
    let named = named
        .and_then(|(subject, columns)| Some((configured::page(db, project, &subject, language)?, columns)));
    let own = of_word(&cursor, language);
    match (own, named) {
        (own, None) => own,
        // The message, then the constant that is its number.
        (Some(own), Some((page, _))) => {
            Some(Hover { markdown: format!("{page}\n---\n\n{}", own.markdown), ..own })
        }
        (None, Some((markdown, columns))) => Some(Hover { markdown, span: cursor.span(&columns) }),
    }
}

/// Help on the word at a position.
fn of_word(cursor: &Cursor<'_>, language: Language) -> Option<Hover> {
    let (db, project) = (cursor.db, cursor.project);
    let word = cursor.word()?;
    let markdown = match cursor.meaning(word)? {
        Meaning::Entry(entry) => page::markdown(entry, language),
        Meaning::Symbol(key) => symbol(db, project, &key, language)?,
        Meaning::Label(key) => label(cursor, &key, language)?,
        Meaning::Formal(key) => formal(cursor, &key, language)?,
        Meaning::File(path) => format!("`{path}`\n"),
    };
    Some(Hover { markdown, span: cursor.span(word.columns()) })
}

/// Help on a symbol of the project or of the system.
pub(super) fn symbol(db: &dyn Db, project: Project, key: &SymbolKey, language: Language) -> Option<String> {
    if key.scope == SymbolScope::System {
        return Some(page::symbol_markdown(catalogue::symbol(&key.name)?, language));
    }
    if key.scope == SymbolScope::Macro {
        return macros(db, project, key, language);
    }
    let known = cursor::symbol(db, project, key)?;
    let mut markdown = String::new();
    let declaration = declaration(db, project, key);
    if let Some(declaration) = &declaration {
        // Writing to a String never fails.
        let _ = write!(markdown, "```technol\n{}\n```\n", declaration.code);
    }
    markdown.push_str(&describe::kind(known, language));
    if let Some(address) = address(db, project, key) {
        let _ = write!(markdown, " · {address}");
    }
    if let Some(declaration) = &declaration {
        let _ = write!(markdown, " · `{}`:{}", declaration.file, declaration.line + 1);
        if !declaration.comment.is_empty() {
            let _ = write!(markdown, "\n\n{}", declaration.comment);
        }
    }
    markdown.push('\n');
    if let Some(entry) = catalogue::entry(&key.name).filter(|entry| entry.kind == EntryKind::EventProcedure) {
        let _ = write!(markdown, "\n---\n\n{}", page::markdown(entry, language));
    }
    Some(markdown)
}

/// Help on a macro: its header, its flags, the comment before it.
fn macros(db: &dyn Db, project: Project, key: &SymbolKey, language: Language) -> Option<String> {
    let table = database::macro_table(db, project);
    let section = *table.definitions(&key.name).first()?;
    let header = source_line(db, section, 0)?;
    let file = section.file(db);
    let line = *section.lines(db).first()?;
    let (kind, on, off) = match language {
        Language::En => ("user instruction", "takes break-points", "takes no break-points"),
        Language::Cs => ("uživatelská instrukce", "lze na ni dát breakpoint", "nelze na ni dát breakpoint"),
    };
    let flags = database::macro_definition(db, section).flags;
    let stop = if flags.break_points { on } else { off };
    let mut markdown = format!(
        "```technol\n{}\n```\n{kind} · {} · {stop} · `{}`:{}\n",
        header.code,
        flags.stack.word(),
        file.path(db),
        line + 1
    );
    let mut comments = comments_before(file.text(db), line);
    if !header.comment.is_empty() {
        comments.push(header.comment);
    }
    if !comments.is_empty() {
        let _ = write!(markdown, "\n{}\n", comments.join("\n"));
    }
    Some(markdown)
}

/// The comment lines directly above a line, without their semicolons.
fn comments_before(text: &str, line: u32) -> Vec<String> {
    let above: Vec<&str> = syntax::lines(text).take(line as usize).map(|line| line.text.trim()).collect();
    let mut comments: Vec<String> = above
        .iter()
        .rev()
        .map_while(|line| line.strip_prefix(';'))
        .map(|comment| comment.trim_matches([';', '-', '=', '*', ' ', '\t']).to_owned())
        .filter(|comment| !comment.is_empty())
        .collect();
    comments.reverse();
    comments
}

/// Help on a parameter or T_LOCAL symbol: the line that declares it.
fn formal(cursor: &Cursor<'_>, key: &str, language: Language) -> Option<String> {
    let place =
        super::definition::formal(cursor.db, cursor.project, cursor.section, key).into_iter().next()?;
    let own = cursor.section.lines(cursor.db).binary_search(&place.span.start.line).ok()?;
    let line = source_line(cursor.db, cursor.section, own as u32)?;
    let definition = database::macro_definition(cursor.db, cursor.section);
    let parameter = definition.parameters.iter().any(|name| name.key() == *key);
    let kind = match (parameter, language) {
        (true, Language::En) => "parameter of the macro",
        (true, Language::Cs) => "parametr makra",
        (false, Language::En) => "symbol of the macro, of its own for each call",
        (false, Language::Cs) => "symbol makra, pro každé volání vlastní",
    };
    Some(format!("```technol\n{}\n```\n{kind}\n", line.code))
}

fn label(cursor: &Cursor<'_>, key: &str, language: Language) -> Option<String> {
    let names = &database::section_declarations(cursor.db, cursor.section).names;
    let declared = names.iter().find(|d| d.what == What::Label && d.name.key() == key)?;
    let line = source_line(cursor.db, cursor.section, declared.line)?;
    let kind = match language {
        Language::En => "label",
        Language::Cs => "návěští",
    };
    let place = *cursor.section.lines(cursor.db).get(declared.line as usize)? + 1;
    let file = cursor.section.file(cursor.db).path(cursor.db);
    let mut markdown = format!("```technol\n{}\n```\n{kind} · `{file}`:{place}\n", line.code);
    if !line.comment.is_empty() {
        let _ = write!(markdown, "\n{}\n", line.comment);
    }
    Some(markdown)
}

/// The line that declares a symbol.
struct Declaration {
    code: String,
    comment: String,
    file: String,
    /// 0-based, in the file.
    line: u32,
}

fn declaration(db: &dyn Db, project: Project, key: &SymbolKey) -> Option<Declaration> {
    let site = cursor::sites(db, project, key).first()?;
    let place = crate::diagnostics::file::site_location(db, project, *site)?;
    let line = place.span.start.line;
    let mut files = super::references::files(db, project);
    let file = files.find(|file| *file.path(db) == place.file)?;
    let owner = |section: &Section<'_>| {
        let own = section.lines(db).binary_search(&line).ok()?;
        source_line(db, *section, own as u32)
    };
    let source = database::sections(db, file).iter().find_map(owner)?;
    Some(Declaration { code: source.code, comment: source.comment, file: place.file, line })
}

struct CodeAndComment {
    code: String,
    comment: String,
}

/// An own line of a section without the blanks around it, and its comment without the semicolon.
fn source_line(db: &dyn Db, section: Section<'_>, own: u32) -> Option<CodeAndComment> {
    let text = syntax::lines(section.text(db)).nth(own as usize)?.text;
    let line: &Line = database::section_lines(db, section).lines.get(own as usize)?;
    let (code, comment) = match &line.comment {
        Some(columns) => text.split_at(columns.start as usize),
        None => (text, ""),
    };
    let comment = comment.trim_start_matches([';', '-', '=', '*', ' ', '\t']).trim_end();
    Some(CodeAndComment { code: code.trim().to_owned(), comment: comment.to_owned() })
}

/// Where a symbol lies in PLC memory.
fn address(db: &dyn Db, project: Project, key: &SymbolKey) -> Option<String> {
    let layout = database::layout(db, project);
    let placed = layout.place(key)?;
    let addr = describe::hexadecimal(u64::from(placed.addr));
    let bit = match placed.kind {
        PlacedKind::Bit(bit) => Some(bit),
        PlacedKind::Sequence(index) => layout.sequences.get(usize::from(index)).map(|cells| cells.active_bit),
        PlacedKind::Cell(_) | PlacedKind::Area | PlacedKind::Text(_) => None,
    };
    Some(bit.map_or_else(|| addr.clone(), |bit| format!("{addr}.{bit}")))
}

#[cfg(test)]
mod tests {
    use super::super::fixture::fixture;
    use super::*;

    fn check(text: &str) -> String {
        let it = fixture(text);
        let found = it.analysis.hover(&it.file, it.at, Language::En).expect("not cancelled");
        let Some(hover) = found else { return "nothing".to_owned() };
        let location = crate::Location { file: it.file.clone(), span: hover.span };
        format!("{}\n{}", it.show(&location), hover.markdown)
    }

    #[test]
    fn a_word_of_the_language_shows_its_page() {
        let it = fixture("MODULE_MAIN\n L<CURSOR>dr X\nMODULE_MAIN_END\n");
        let hover = it.analysis.hover(&it.file, it.at, Language::Cs).expect("not cancelled").expect("help");
        let entry = catalogue::entry("LDR").expect("LDR is an instruction");
        assert_eq!(hover.markdown, page::markdown(entry, Language::Cs));
        assert_eq!(hover.span, Span::in_line(1, 1, 4));
    }

    #[test]
    fn a_prefix_and_a_keyword_show_their_page() {
        for (operand, name) in
            [("WO<CURSOR>RD.X", "WORD"), ("CNTS<CURSOR>.5", "CNST"), ("X[<CURSOR>BX]", "BX")]
        {
            let text = format!("DATA\nX: DS 4\nDATA_END\nMODULE_MAIN\n LOD {operand}\nMODULE_MAIN_END\n");
            let it = fixture(&text);
            let hover = it.analysis.hover(&it.file, it.at, Language::En).expect("not cancelled").expect(name);
            assert_eq!(hover.markdown, page::markdown(catalogue::entry(name).expect(name), Language::En));
        }
    }

    #[test]
    fn a_predefined_symbol_shows_its_page() {
        let it = fixture("MODULE_MAIN\n LOD P1<CURSOR>IN\nMODULE_MAIN_END\n");
        let hover = it.analysis.hover(&it.file, it.at, Language::En).expect("not cancelled").expect("help");
        let symbol = catalogue::symbol("P1IN").expect("a port");
        assert_eq!(hover.markdown, page::symbol_markdown(symbol, Language::En));
    }

    #[test]
    fn a_cell_shows_its_declaration_type_address_and_comment() {
        insta::assert_snapshot!(check(
            "DATA\nFIRST: DS 1\nSpeed:  DS 2   ;--- rev/min ---\nDATA_END\n\
             MODULE_MAIN\n LOD WORD.spe<CURSOR>ed\nMODULE_MAIN_END\n"
        ), @"
        main.plc:6 LOD WORD.«speed»

        ```technol
        Speed:  DS 2
        ```
        WORD cell · 8001h · `main.plc`:3

        rev/min ---
        ");
    }

    #[test]
    fn a_bit_shows_its_byte() {
        insta::assert_snapshot!(check(
            "//- main.plc\nMODULE_MAIN\n LDR -IN_R<CURSOR>UN\nMODULE_MAIN_END\n\
             //- data.plc\nDATA\nINPUTS: DFM ,,IN_RUN,IN_STOP\nDATA_END\n"
        ), @"
        main.plc:2 LDR -«IN_RUN»

        ```technol
        INPUTS: DFM ,,IN_RUN,IN_STOP
        ```
        bit d2 · 8000h.2 · `data.plc`:2
        ");
    }

    #[test]
    fn a_constant_shows_its_value() {
        insta::assert_snapshot!(check(
            "EQUI LIMIT,1000 ;steps\nEQUI TWICE,LIMIT+LIMIT\nMODULE_MAIN\n LOD CNST.TW<CURSOR>ICE\nMODULE_MAIN_END\n"
        ), @"
        main.plc:4 LOD CNST.«TWICE»

        ```technol
        EQUI TWICE,LIMIT+LIMIT
        ```
        constant 2000 (7D0h) · `main.plc`:2
        ");
    }

    #[test]
    fn a_mechanism_and_its_line_show_where_it_begins() {
        let text = |operand: &str| {
            format!(
                "MODULE_MAIN\n LOD {operand}\n MECH_BEGIN Clamp ;close the chuck\n EX\n MECH_END Clamp\nMODULE_MAIN_END\n"
            )
        };
        insta::assert_snapshot!(check(&text("CLAMP_L<CURSOR>INE")), @"
        main.plc:2 LOD «CLAMP_LINE»

        ```technol
        MECH_BEGIN Clamp
        ```
        WORD cell: source line where the mechanism stands, 0 when it is not active · 8005h · `main.plc`:3

        close the chuck
        ");
        insta::assert_snapshot!(check(&text("<CURSOR>CLAMP")), @"
        main.plc:2 LOD «CLAMP»

        ```technol
        MECH_BEGIN Clamp
        ```
        mechanism · 8000h.0 · `main.plc`:3

        close the chuck
        ");
    }

    #[test]
    fn a_text_and_an_area_show_their_length() {
        insta::assert_snapshot!(check("DATA\nNOTE: STR 15,'<CURSOR>on'\nDATA_END\n"), @"nothing");
        insta::assert_snapshot!(check("DATA\nNO<CURSOR>TE: STR 15,'on'\nDATA_END\n"), @"
        main.plc:2 «NOTE»: STR 15,'on'

        ```technol
        NOTE: STR 15,'on'
        ```
        text, 15 characters · 8000h · `main.plc`:2
        ");
        insta::assert_snapshot!(check("DATA\nTAB<CURSOR>LE: DS 30\nDATA_END\n"), @"
        main.plc:2 «TABLE»: DS 30

        ```technol
        TABLE: DS 30
        ```
        area, 30 bytes · 8000h · `main.plc`:2
        ");
    }

    #[test]
    fn a_label_shows_its_line() {
        insta::assert_snapshot!(check(
            "MODULE_MAIN\n JUM EN<CURSOR>D\nEnd: LDR X ;all done\nMODULE_MAIN_END\n"
        ), @"
        main.plc:2 JUM «END»

        ```technol
        End: LDR X
        ```
        label · `main.plc`:3

        all done
        ");
    }

    #[test]
    fn blanks_comments_and_unknown_names_show_nothing() {
        for text in [
            "MODULE_MAIN\n<CURSOR> LDR X\n",
            "MODULE_MAIN\n LDR X ;LD<CURSOR>R\n",
            "MODULE_MAIN\n LDR NOBO<CURSOR>DY\n",
            "MODULE_MAIN\n LDR X\n<CURSOR>",
            "<CURSOR>",
        ] {
            assert_eq!(check(text), "nothing", "{text}");
        }
    }

    #[test]
    fn a_broken_line_still_knows_its_names() {
        insta::assert_snapshot!(check(
            "DATA\nX: DS 1\nDATA_END\nMODULE_MAIN\n LOD X<CURSOR> )\nMODULE_MAIN_END\n"
        ), @"
        main.plc:5 LOD «X» )

        ```technol
        X: DS 1
        ```
        BYTE cell · 8000h · `main.plc`:2
        ");
    }
}
