//! Names of the whole project that match a query.

use super::{SymbolTag, cursor, references};
use crate::database::{self, Db, Project, Section};
use crate::location::Location;
use crate::semantics::declarations::What;
use crate::syntax::section::SectionKind;

/// A declared name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorkspaceSymbol {
    /// Name as written.
    pub name: String,
    /// What it is.
    pub kind: SymbolTag,
    /// Module, mechanism or file it stands in.
    pub container: String,
    /// Where its name stands.
    pub location: Location,
}

/// Most names an answer lists; who asks for more types another letter.
const MOST: usize = 500;

/// Declared names that hold the letters of `query` in this order, in any case; best first: the name itself, names
/// that begin with it, names that contain it, others. An empty query lists all, up to a limit.
#[must_use]
pub fn workspace_symbols(db: &dyn Db, project: Project, query: &str) -> Vec<WorkspaceSymbol> {
    let query = query.to_ascii_uppercase();
    let mut found = Vec::new();
    for file in references::files(db, project) {
        for section in database::sections(db, file) {
            for declared in &database::section_declarations(db, *section).names {
                let Some(rank) = rank(&declared.name.text.to_ascii_uppercase(), &query) else { continue };
                let Some(kind) = SymbolTag::of(&declared.what) else { continue };
                found.push((rank, *section, declared, kind));
            }
        }
    }
    found.sort_by(|a, b| (a.0, &a.2.name.text).cmp(&(b.0, &b.2.name.text)));
    let symbol =
        |(_, section, declared, kind): (_, Section<'_>, &crate::semantics::declarations::Declared, _)| {
            Some(WorkspaceSymbol {
                name: declared.name.text.clone(),
                kind,
                container: container(db, section, &declared.what),
                location: cursor::location(db, section, declared.line, &declared.name.columns)?,
            })
        };
    found.into_iter().filter_map(symbol).take(MOST).collect()
}

/// How well a name fits, 0 best; `None` when it does not.
pub(super) fn rank(name: &str, query: &str) -> Option<u8> {
    if name == query {
        return Some(0);
    }
    if name.starts_with(query) {
        return Some(1);
    }
    if name.contains(query) {
        return Some(2);
    }
    let mut letters = name.chars();
    query.chars().all(|wanted| letters.any(|letter| letter == wanted)).then_some(3)
}

fn container(db: &dyn Db, section: Section<'_>, what: &What) -> String {
    let own = match section.kind(db) {
        // The section is the declared thing itself: what stands around it counts.
        SectionKind::Mechanism | SectionKind::Procedure | SectionKind::Macro
            if matches!(what, What::Mechanism | What::Procedure | What::Macro) =>
        {
            section.outer(db).last().map(|kind| keyword(*kind))
        }
        SectionKind::Mechanism | SectionKind::Procedure | SectionKind::Macro => {
            Some(section.name(db).to_string())
        }
        SectionKind::File => None,
        kind => Some(keyword(kind)),
    };
    own.unwrap_or_else(|| section.file(db).path(db).clone())
}

/// The word that opens sections of a kind.
fn keyword(kind: SectionKind) -> String {
    match kind {
        SectionKind::File => "",
        SectionKind::Data => "DATA",
        SectionKind::DataLocal => "DATA_LOCAL",
        SectionKind::Module(kind) => kind.keyword(),
        SectionKind::Mechanism => "MECH_BEGIN",
        SectionKind::Procedure => "PROC_BEGIN",
        SectionKind::Macro => "DEF_T_MACRO",
    }
    .to_owned()
}

#[cfg(test)]
mod tests {
    use super::super::fixture::fixture;
    use super::*;

    const PROJECT: &str = "\
//- main.plc
T_INCLUDE limits.inc
DATA
SPINDLE_ON: DFM START,SPIN
DATA_END
MODULE_MAIN
L_SPIN: LDR START
MODULE_MAIN_END
//- spindle.plc
DATA
DATA_END
MODULE_MAIN
 MECH_BEGIN Spin_Up
 EX
 DATA_LOCAL
  spare: DS 1
 DATA_LOCAL_END
 MECH_END Spin_Up
MODULE_MAIN_END
//- limits.inc
EQUI MAX_SPIN,4000
";

    fn check(query: &str) -> String {
        let it = fixture(PROJECT);
        let found = it.analysis.workspace_symbols(query).expect("not cancelled");
        let show = |s: &WorkspaceSymbol| {
            format!("{:?} {} in {}: {}", s.kind, s.name, s.container, it.show(&s.location))
        };
        found.iter().map(show).collect()
    }

    #[test]
    fn names_that_contain_the_letters_best_first() {
        insta::assert_snapshot!(check("spin"), @"
        Bit SPIN in DATA: main.plc:3 SPINDLE_ON: DFM START,«SPIN»
        Cell SPINDLE_ON in DATA: main.plc:3 «SPINDLE_ON»: DFM START,SPIN
        Mechanism Spin_Up in MODULE_MAIN: spindle.plc:4 MECH_BEGIN «Spin_Up»
        Constant MAX_SPIN in limits.inc: limits.inc:1 EQUI «MAX_SPIN»,4000
        ");
    }

    #[test]
    fn letters_may_have_others_between_them() {
        insta::assert_snapshot!(check("sU"), @"Mechanism Spin_Up in MODULE_MAIN: spindle.plc:4 MECH_BEGIN «Spin_Up»");
    }

    #[test]
    fn nothing_matches_a_stranger() {
        assert_eq!(check("zzz"), "");
    }

    #[test]
    fn names_rank_by_how_well_they_match() {
        let ranks = ["AB", "ABC", "XAB", "AXB", "BA"].map(|name| rank(name, "AB"));
        assert_eq!(ranks, [Some(0), Some(1), Some(2), Some(3), None]);
    }
}
