//! What the whole program takes from configuration files, without places.

use std::collections::{BTreeMap, BTreeSet};

use super::logical;
use crate::catalogue::ConfigElement;
use crate::configuration::uses::{IdentifierUse, MessageUse};
use crate::database::{self, Db, Project};

/// What the program takes from configuration files.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProjectUses {
    /// Every line of every section was understood.
    pub complete: bool,
    /// Identifiers in apostrophes.
    pub identifiers: BTreeSet<(ConfigElement, String)>,
    /// Kinds of elements named by texts that are known at run time only.
    pub dynamic: BTreeSet<ConfigElement>,
    /// Logical elements by their normal identifier, with their type where it is written.
    pub logical: BTreeMap<(ConfigElement, String), Option<String>>,
    /// Their cells by the normal key: a connection may name the cell instead of the identifier.
    pub cells: BTreeMap<(ConfigElement, String), Option<String>>,
    /// Spellings of the logical elements.
    pub spelled: BTreeMap<ConfigElement, BTreeSet<String>>,
    /// Messages that are, or may be, reported.
    pub messages: BTreeSet<i64>,
    /// Messages that ESET shows by a number that is written there.
    pub shown: BTreeSet<i64>,
    /// Messages that ESET removes, or that EDEF takes care of.
    pub removed: BTreeSet<i64>,
    /// A message is reported by a number that is known at run time only.
    pub messages_from_dr: bool,
    /// That number stands in a cell.
    pub messages_from_cells: bool,
    /// Numbers that the procedure of commands compares with.
    pub codes: BTreeSet<i64>,
    /// There is a procedure of commands.
    pub takes_commands: bool,
    /// It hands commands on.
    pub hands_on: bool,
}

/// Collects the uses of all sections.
pub(crate) fn project_uses(db: &dyn Db, project: Project) -> ProjectUses {
    let mut all = ProjectUses { complete: true, ..ProjectUses::default() };
    let mut loaded: BTreeSet<i64> = BTreeSet::new();
    for file in project.files(db).iter().chain(project.included(db)) {
        for section in database::sections(db, *file) {
            let uses = database::section_identifiers(db, project, *section);
            all.complete &= uses.complete;
            all.takes_commands |= uses.takes_commands;
            all.hands_on |= uses.hands_on;
            all.dynamic.extend(&uses.dynamic);
            all.codes.extend(uses.codes.iter().map(|code| code.number));
            loaded.extend(&uses.loaded);
            for it in &uses.identifiers {
                if matches!(it.element, ConfigElement::LogicalInput | ConfigElement::LogicalOutput) {
                    all.logical(it);
                } else {
                    all.identifiers.insert((it.element, it.text.to_string()));
                }
            }
            for it in &uses.messages {
                all.message(it);
            }
        }
    }
    if all.messages_from_dr {
        all.messages.extend(loaded);
    }
    all
}

impl ProjectUses {
    /// A form that no connection can meet is reported where it stands; here it counts as what was meant.
    fn logical(&mut self, it: &IdentifierUse) {
        let end = logical::end(&it.text);
        let name = if end.group.element().is_some() { end.name } else { &*it.text };
        let normal = logical::normal(name);
        let base = logical::without_index(&normal).map_or(normal.clone(), str::to_string);
        self.logical.insert((it.element, base), it.kind.clone());
        if let Some(cell) = &it.cell {
            self.cells.insert((it.element, logical::normal(cell)), it.kind.clone());
        }
        self.spelled.entry(it.element).or_default().insert(name.to_string());
    }

    fn message(&mut self, it: &MessageUse) {
        let Some(number) = it.number else {
            self.messages_from_dr = true;
            self.messages_from_cells |= it.in_cell;
            return;
        };
        self.messages.insert(number);
        match (it.entry, &it.set) {
            ("ESET" | "ESET1", Some((0, _))) | ("EDEF", _) => _ = self.removed.insert(number),
            ("ESET" | "ESET1", _) => _ = self.shown.insert(number),
            _ => {}
        }
    }
}
