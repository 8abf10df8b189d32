//! What the names in a line stand for; unknown ones are reported with the nearest that is known.

use std::sync::Arc;

use super::CodeReader;
use crate::catalogue;
use crate::database::{self, Db, NameRef, Project};
use crate::diagnostics::Finding;
use crate::diagnostics::rules::{lints as lint_rules, names};
use crate::semantics::declarations::What;
use crate::semantics::hir::SymbolScope;
use crate::semantics::reference::{ReferenceAccess, Referent};
use crate::semantics::scope::{Symbol, SymbolKind};
use crate::semantics::suggest;
use crate::syntax::ast::Name;
use crate::syntax::section::SectionKind;

impl<'db> CodeReader<'db> {
    /// The symbol a name stands for here, without a report.
    pub(in crate::semantics) fn symbol(&self, name: &str) -> Option<&'db Symbol> {
        let key = Arc::from(crate::syntax::ast::key(name));
        let name = NameRef::new(self.db, key, self.place.file);
        database::lookup(self.db, self.project, name).as_ref()
    }

    /// The symbol a name stands for; reports unknown names, and says nothing about those declared with a mistake.
    pub(in crate::semantics) fn resolve(&mut self, name: &Name, access: ReferenceAccess) -> Option<Symbol> {
        if let Some(symbol) = self.symbol(&name.text) {
            let symbol = symbol.clone();
            self.refer(name.columns.clone(), Referent::Symbol(symbol.key.clone()), access);
            self.read_only(name, &symbol, access);
            if symbol.kind == SymbolKind::Unknown {
                self.clean = false;
                return None;
            }
            Some(symbol)
        } else {
            self.unknown(name);
            None
        }
    }

    /// A write to a cell that only the control writes.
    fn read_only(&mut self, name: &Name, symbol: &Symbol, access: ReferenceAccess) {
        let writes = matches!(access, ReferenceAccess::Write | ReferenceAccess::ReadWrite);
        if !writes || symbol.key.scope != SymbolScope::System {
            return;
        }
        let system = catalogue::symbol(&symbol.key.name);
        if system.is_some_and(|system| system.direction == catalogue::Direction::CncToPlc) {
            let message = format!("the control writes {}, the program only reads it", name.text);
            self.report(&lint_rules::READ_ONLY_CELL, name.columns.clone(), message);
        }
    }

    fn unknown(&mut self, name: &Name) {
        if self.parameter_without_prefix(name) {
            // Reported where the macro is defined.
            self.clean = false;
            return;
        }
        let near = self.nearest_symbol(name);
        let message = match &near {
            Some(near) => format!("{} is not declared; did you mean {near}?", name.text),
            None => format!("{} is not declared; declare it with DFM, DS or EQUI", name.text),
        };
        let mut finding = Finding::new(&names::UNKNOWN_SYMBOL, self.line, name.columns.clone(), message);
        if let Some(near) = near {
            finding = finding.replace(format!("write {near}"), name.columns.clone(), near.as_str());
        }
        self.push_finding(finding);
    }

    fn nearest_symbol(&self, name: &Name) -> Option<String> {
        let near = database::spellings(self.db, self.project).nearest(&name.text, self.place.file);
        let near = near.or_else(|| suggest::nearest(&name.text, catalogue::symbols().map(|s| s.name)));
        near.map(|near| declared_spelling(self.db, self.project, self.place.file, near))
    }

    /// Whether a label of that key stands in the section.
    pub(in crate::semantics) fn label(&mut self, name: &Name) -> Option<Arc<str>> {
        let key: Arc<str> = Arc::from(name.key());
        if self.labels.contains_key(&key) {
            self.refer(name.columns.clone(), Referent::Label(key.clone()), ReferenceAccess::Jump);
            return Some(key);
        }
        let near = suggest::nearest(&name.text, self.labels.keys().map(|key| &**key));
        let elsewhere = self.section_with_label(&key);
        let message = match (&elsewhere, near) {
            (Some(place), _) => {
                format!("the label {} stands in {place}; a jump does not leave its section", name.text)
            }
            (None, Some(near)) => {
                format!("there is no label {} in this section; did you mean {near}?", name.text)
            }
            (None, None) => format!("there is no label {} in this module, mechanism or procedure", name.text),
        };
        let near = near.filter(|_| elsewhere.is_none());
        let mut finding = Finding::new(&names::UNKNOWN_LABEL, self.line, name.columns.clone(), message);
        if let Some(near) = near {
            finding = finding.replace(format!("write {near}"), name.columns.clone(), near);
        }
        self.push_finding(finding);
        None
    }

    /// The other section of this file where a label stands.
    fn section_with_label(&self, key: &str) -> Option<String> {
        let sections = database::sections(self.db, self.section.file(self.db));
        let other = sections.iter().filter(|other| **other != self.section).find(|other| {
            let names = &database::section_declarations(self.db, **other).names;
            names.iter().any(|declared| declared.what == What::Label && declared.name.key() == key)
        })?;
        Some(match other.kind(self.db) {
            SectionKind::Module(kind) => kind.keyword().to_string(),
            SectionKind::Mechanism => format!("the mechanism {}", other.name(self.db)),
            SectionKind::Procedure => format!("the procedure {}", other.name(self.db)),
            _ => "another section".to_string(),
        })
    }
}

/// A key in the spelling of its declaration.
fn declared_spelling(db: &dyn Db, project: Project, file: Option<u8>, key: &str) -> String {
    let name = NameRef::new(db, Arc::from(key), file);
    let spelling = database::lookup(db, project, name).as_ref().and_then(|symbol| {
        let site = database::sites(db, project).get(&symbol.key)?.first()?;
        Some(database::declared(db, project, *site)?.name.text.clone())
    });
    spelling.unwrap_or_else(|| key.to_string())
}
