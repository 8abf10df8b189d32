//! Where a name is used, and how.

use std::collections::BTreeMap;

use super::cursor::{Cursor, Meaning};
use super::{configured, cursor, definition};
use crate::database::{self, Db, Project, Section, SourceFile};
use crate::location::{Location, Position};
use crate::semantics::reference::{ReferenceAccess, Referent};

/// A use of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Where.
    pub location: Location,
    /// What is done with it.
    pub access: ReferenceAccess,
}

/// Uses of what stands at a position, in order of files and text.
#[must_use]
pub fn references(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    at: Position,
    include_declaration: bool,
) -> Vec<Reference> {
    let Some(here) = Cursor::at(db, project, file, at) else { return Vec::new() };
    let mut found = BTreeMap::new();
    // A constant used as the number of a message: its own uses are asked for. A bare number or text has no other.
    if let Some((subject, _)) = configured::in_section(db, project, here.section, here.own, at.column)
        && here.word().is_none()
    {
        found = configured::places(db, project, &[subject]);
    }
    match here.word().and_then(|word| here.meaning(word)) {
        Some(Meaning::Symbol(key)) => {
            let referent = Referent::Symbol(key.clone());
            for section in sections(db, project) {
                uses(db, project, section, &referent, &mut found);
            }
            declare(definition::symbol(db, project, &key), &mut found);
        }
        Some(Meaning::Label(key)) => {
            uses(db, project, here.section, &Referent::Label(key.clone()), &mut found);
            declare(definition::label(db, here.section, &key), &mut found);
        }
        Some(Meaning::Formal(key)) => {
            uses(db, project, here.section, &Referent::Formal(key), &mut found);
        }
        Some(Meaning::File(_) | Meaning::Entry(_)) | None => {}
    }
    in_order(db, project, found, include_declaration)
}

/// Places as a list: program files in order of execution, included ones, then the others.
pub(super) fn in_order(
    db: &dyn Db,
    project: Project,
    mut found: BTreeMap<Location, ReferenceAccess>,
    include_declaration: bool,
) -> Vec<Reference> {
    found.retain(|_, access| include_declaration || *access != ReferenceAccess::Declare);
    let order = file_order(db, project);
    let mut list: Vec<_> =
        found.into_iter().map(|(location, access)| Reference { location, access }).collect();
    list.sort_by_key(|r| order.get(r.location.file.as_str()).copied().unwrap_or(usize::MAX));
    list
}

fn uses(
    db: &dyn Db,
    project: Project,
    section: Section<'_>,
    referent: &Referent,
    found: &mut BTreeMap<Location, ReferenceAccess>,
) {
    for reference in &database::section_analysis(db, project, section).references {
        if reference.referent == *referent
            && let Some(location) = cursor::location(db, section, reference.line, &reference.columns)
        {
            found.entry(location).or_insert(reference.access);
        }
    }
}

/// A declaration is one, whatever the analysis of its line says about it.
fn declare(locations: Vec<Location>, found: &mut BTreeMap<Location, ReferenceAccess>) {
    found.extend(locations.into_iter().map(|location| (location, ReferenceAccess::Declare)));
}

fn sections(db: &dyn Db, project: Project) -> impl Iterator<Item = Section<'_>> {
    files(db, project).flat_map(move |file| database::sections(db, file).iter().copied())
}

/// All texts: program files in order of execution, then included ones.
pub(super) fn files(db: &dyn Db, project: Project) -> impl Iterator<Item = SourceFile> {
    project.files(db).iter().chain(project.included(db)).copied()
}

fn file_order(db: &dyn Db, project: Project) -> BTreeMap<&str, usize> {
    files(db, project).enumerate().map(|(order, file)| (file.path(db).as_str(), order)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::fixture::fixture;
    use super::Reference;

    fn check(text: &str, include_declaration: bool) -> String {
        let it = fixture(text);
        let found = it.analysis.references(&it.file, it.at, include_declaration).expect("not cancelled");
        let show = |r: &Reference| format!("{:?} {}", r.access, it.show(&r.location));
        found.iter().map(show).collect()
    }

    const TWO_FILES: &str = "\
//- main.plc
DATA
COUNT: DS 1
STATE: DFM RUN,FAULT
DATA_END
MODULE_MAIN
 LDR R<CURSOR>UN
 LA -FAULT
 WR FAULT
 LOD COUNT
 INR
 STO COUNT
MODULE_MAIN_END
//- a.plc
DATA
DATA_END
MODULE_MAIN
 FL 1,run,FAULT
 LDR COUNT.RUN
MODULE_MAIN_END
";

    #[test]
    fn reads_and_writes_across_files() {
        insta::assert_snapshot!(check(TWO_FILES, true), @"
        Declare main.plc:3 STATE: DFM «RUN»,FAULT
        Read main.plc:6 LDR «RUN»
        Write a.plc:4 FL 1,«run»,FAULT
        Read a.plc:5 LDR COUNT.«RUN»
        ");
    }

    #[test]
    fn the_declaration_is_left_out_on_request() {
        insta::assert_snapshot!(check(&TWO_FILES.replace("<CURSOR>", "").replacen("COUNT", "<CURSOR>COUNT", 1), false), @"
        Read main.plc:9 LOD «COUNT»
        Write main.plc:11 STO «COUNT»
        Read a.plc:5 LDR «COUNT».RUN
        ");
    }

    #[test]
    fn a_mechanism() {
        insta::assert_snapshot!(check("\
MODULE_MAIN
 MECH_INIT CLAMP
 FL 1,CLAMP
 MECH_BEGIN Cl<CURSOR>amp
 EX
 MECH_END clamp
MODULE_MAIN_END
", true), @"
        Call main.plc:2 MECH_INIT «CLAMP»
        Write main.plc:3 FL 1,«CLAMP»
        Declare main.plc:4 MECH_BEGIN «Clamp»
        Call main.plc:6 MECH_END «clamp»
        ");
    }

    #[test]
    fn a_label_stays_in_its_section() {
        insta::assert_snapshot!(check("\
MODULE_MAIN
 JUM NEXT
NEXT<CURSOR>: LDR X
 MECH_BEGIN M
 JUM NEXT
NEXT: EX
 MECH_END M
MODULE_MAIN_END
", true), @"
        Jump main.plc:2 JUM «NEXT»
        Declare main.plc:3 «NEXT»: LDR X
        ");
    }

    #[test]
    fn predefined_symbols_have_uses_too() {
        insta::assert_snapshot!(check("MODULE_MAIN\n LOD P1<CURSOR>IN\n STO P0OUT\nMODULE_MAIN_END\n", true), @"Read main.plc:2 LOD «P1IN»");
    }
}
