//! Where a name is declared.

use super::configured;
use super::cursor::{self, Cursor, Meaning};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::location::{Location, Position, Span};
use crate::semantics::declarations::What;
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::reference::{ReferenceAccess, Referent};

/// Declarations of what stands at a position: of a symbol (of its mechanism, for `name_LINE`), of a label, or the
/// beginning of an included file; of an identifier or message the place in the configuration files. Empty for the words of the language and for predefined symbols.
#[must_use]
pub fn definition(db: &dyn Db, project: Project, file: SourceFile, at: Position) -> Vec<Location> {
    let Some(cursor) = Cursor::at(db, project, file, at) else { return Vec::new() };
    let mut found = of_word(&cursor);
    if let Some((subject, columns)) =
        configured::in_section(db, project, cursor.section, cursor.own, at.column)
    {
        let here = Location { file: file.path(db).clone(), span: cursor.span(&columns) };
        found.extend(configured::definition(db, project, &[subject], &here));
    }
    found
}

fn of_word(cursor: &Cursor<'_>) -> Vec<Location> {
    let (db, project) = (cursor.db, cursor.project);
    match cursor.word().and_then(|word| cursor.meaning(word)) {
        Some(Meaning::Symbol(key)) => symbol(db, project, &key),
        Some(Meaning::Label(key)) => label(db, cursor.section, &key),
        Some(Meaning::Formal(key)) => formal(db, project, cursor.section, &key),
        Some(Meaning::File(path)) => vec![Location { file: path, span: Span::default() }],
        Some(Meaning::Entry(_)) | None => Vec::new(),
    }
}

/// Where a symbol is declared.
pub(super) fn symbol(db: &dyn Db, project: Project, key: &SymbolKey) -> Vec<Location> {
    let sites = cursor::sites(db, project, key).iter();
    let mut found: Vec<Location> = Vec::new();
    for location in sites.filter_map(|site| crate::diagnostics::file::site_location(db, project, *site)) {
        // Each call of a macro declares its symbols at the same line.
        if !found.contains(&location) {
            found.push(location);
        }
    }
    if key.scope == SymbolScope::Macro {
        // A word of APPEND_T_MACRO leads to its macro as well.
        let table = database::macro_table(db, project);
        for section in table.definitions(&key.name) {
            let header = database::macro_definition(db, section).name.as_ref();
            let place = header.and_then(|name| cursor::location(db, section, 0, &name.columns));
            if let Some(place) = place.filter(|place| !found.contains(place)) {
                found.insert(0, place);
            }
        }
    }
    found
}

/// Where a parameter or T_LOCAL symbol of a macro is declared: in the header or T_LOCAL, and for data in the body.
pub(super) fn formal(db: &dyn Db, project: Project, section: Section<'_>, key: &str) -> Vec<Location> {
    let references = &database::section_analysis(db, project, section).references;
    let declared = references.iter().filter(|r| {
        r.access == ReferenceAccess::Declare && matches!(&r.referent, Referent::Formal(own) if **own == *key)
    });
    let first = declared.min_by_key(|r| (r.line, r.columns.start));
    first.and_then(|r| cursor::location(db, section, r.line, &r.columns)).into_iter().collect()
}

/// Where a label of a section stands.
pub(super) fn label(db: &dyn Db, section: Section<'_>, key: &str) -> Vec<Location> {
    let names = database::section_declarations(db, section).names.iter();
    names
        .filter(|declared| declared.what == What::Label && declared.name.key() == key)
        .filter_map(|declared| cursor::location(db, section, declared.line, &declared.name.columns))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::fixture::fixture;

    fn check(text: &str) -> String {
        let it = fixture(text);
        let found = it.analysis.definition(&it.file, it.at).expect("not cancelled");
        found.iter().map(|location| it.show(location)).collect()
    }

    #[test]
    fn a_bit_of_another_file() {
        insta::assert_snapshot!(check("\
//- main.plc
DATA
DATA_END
MODULE_MAIN
 LDR -PORT.in_<CURSOR>run
MODULE_MAIN_END
//- spindle.plc
DATA
PORT: DFM ,In_Run
DATA_END
"), @"spindle.plc:2 PORT: DFM ,«In_Run»");
    }

    #[test]
    fn a_local_name_hides_nothing_of_other_files() {
        let text = |first: &str, second: &str| {
            format!(
                "//- main.plc\nDATA\nDATA_END\nDATA_LOCAL\nX: DS 1\nDATA_LOCAL_END\nMODULE_MAIN\n LOD {first}\nMODULE_MAIN_END\n\
                 //- other.plc\nDATA\nDATA_END\nDATA_LOCAL\nX: DS 2\nDATA_LOCAL_END\nMODULE_MAIN\n LOD {second}\nMODULE_MAIN_END\n"
            )
        };
        insta::assert_snapshot!(check(&text("X<CURSOR>", "X")), @"main.plc:4 «X»: DS 1");
        insta::assert_snapshot!(check(&text("X", "X<CURSOR>")), @"other.plc:4 «X»: DS 2");
    }

    #[test]
    fn mechanisms_procedures_and_constants() {
        let text = |operation: &str| {
            format!(
                "EQUI LIMIT,5\nMODULE_MAIN\n {operation}\n MECH_BEGIN CLAMP\n EX\n MECH_END CLAMP\n\
                 PROC_BEGIN COUNT\nPROC_END COUNT\nMODULE_MAIN_END\n"
            )
        };
        insta::assert_snapshot!(check(&text("MECH_INIT CL<CURSOR>AMP")), @"main.plc:4 MECH_BEGIN «CLAMP»");
        insta::assert_snapshot!(check(&text("LOD CLAMP_<CURSOR>LINE")), @"main.plc:4 MECH_BEGIN «CLAMP»");
        insta::assert_snapshot!(check(&text("PROC_CALL CO<CURSOR>UNT")), @"main.plc:7 PROC_BEGIN «COUNT»");
        insta::assert_snapshot!(check(&text("LOD CNST.LIM<CURSOR>IT")), @"main.plc:1 EQUI «LIMIT»,5");
    }

    #[test]
    fn a_label_of_the_same_section() {
        insta::assert_snapshot!(check("\
MODULE_MAIN
 JL0 NE<CURSOR>XT
NEXT: LDR X
 MECH_BEGIN M
NEXT: EX
 MECH_END M
MODULE_MAIN_END
"), @"main.plc:3 «NEXT»: LDR X");
    }

    #[test]
    fn an_included_file_and_what_it_declares() {
        let text = |file: &str, name: &str| {
            format!(
                "//- main.plc\nT_INCLUDE lib\\{file}.inc\nDATA\nDATA_END\nMODULE_MAIN\n LOD CNST.{name}\nMODULE_MAIN_END\n\
                 //- lib/limits.inc\nEQUI TOP,5\n"
            )
        };
        insta::assert_snapshot!(check(&text("lim<CURSOR>its", "TOP")), @"lib/limits.inc:1 «»EQUI TOP,5");
        insta::assert_snapshot!(check(&text("limits", "T<CURSOR>OP")), @"lib/limits.inc:1 EQUI «TOP»,5");
    }

    #[test]
    fn a_name_declared_twice_has_both_places() {
        insta::assert_snapshot!(check("DATA\nX: DS 1\nX: DS 2\nDATA_END\nMODULE_MAIN\n LOD X<CURSOR>\nMODULE_MAIN_END\n"), @"
        main.plc:2 «X»: DS 1
        main.plc:3 «X»: DS 2
        ");
    }

    #[test]
    fn words_of_the_language_have_none() {
        assert_eq!(check("MODULE_MAIN\n LD<CURSOR>R P1IN\nMODULE_MAIN_END\n"), "");
        assert_eq!(check("MODULE_MAIN\n LOD P1<CURSOR>IN\nMODULE_MAIN_END\n"), "");
    }

    #[test]
    fn the_line_cell_of_a_mechanism_with_a_long_name() {
        // 29 letters and `_LINE`, of which 31 count.
        insta::assert_snapshot!(check("\
MODULE_MAIN
 LOD ABCDEFGHIJKLMNOPQRSTUVWXYZABC_L<CURSOR>INE
 MECH_BEGIN ABCDEFGHIJKLMNOPQRSTUVWXYZABC
 EX
 MECH_END ABCDEFGHIJKLMNOPQRSTUVWXYZABC
MODULE_MAIN_END
"), @"main.plc:3 MECH_BEGIN «ABCDEFGHIJKLMNOPQRSTUVWXYZABC»");
    }
}
