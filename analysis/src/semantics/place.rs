//! Where an instruction may stand.

use technol_image::program::ModuleKind;

use crate::catalogue::{Entry, EntryKind, Place};
use crate::database::{self, Db, Project, Section};
use crate::diagnostics::Rule;
use crate::diagnostics::rules::{project as project_rules, sequences, structure};
use crate::syntax::section::SectionKind;

/// The place of the lines of a section.
#[derive(Debug)]
pub(crate) struct Context {
    kind: SectionKind,
    outer: Vec<SectionKind>,
    /// The section belongs to an included file.
    included: bool,
    /// File whose local names are visible.
    pub(super) file: Option<u8>,
}

type Refusal = (&'static Rule, String);

impl Context {
    pub(crate) fn of(db: &dyn Db, project: Project, section: Section<'_>, included: bool) -> Context {
        let own = section.kind(db);
        // Only an included file depends on who includes it.
        let (kind, file) = if included {
            database::inclusion(db, project, section).map_or((own, None), |(kind, file)| (kind, Some(file)))
        } else {
            (own, section.file(db).order(db))
        };
        Context { kind, outer: section.outer(db).clone(), included, file }
    }

    /// The place of DATA_LOCAL in an expansion here.
    pub(super) fn in_local_data(&self) -> Context {
        let mut outer = self.outer.clone();
        if self.kind != SectionKind::File {
            outer.push(self.kind);
        }
        Context { kind: SectionKind::DataLocal, outer, included: self.included, file: self.file }
    }

    /// Code stands here, with labels of its own.
    pub(super) fn holds_code(&self) -> bool {
        !self.included
            && matches!(self.kind, SectionKind::Module(_) | SectionKind::Mechanism | SectionKind::Procedure)
    }

    pub(super) fn is_file(&self) -> bool {
        self.kind == SectionKind::File
    }

    fn is_data(&self) -> bool {
        matches!(self.kind, SectionKind::Data | SectionKind::DataLocal)
    }

    /// Why an instruction may not stand here.
    pub(crate) fn refuses(&self, entry: &Entry) -> Option<Refusal> {
        if entry.ex_type || entry.place == Place::Sequence {
            return self.refuses_wait(entry);
        }
        let fits = match entry.place {
            Place::Anywhere => true,
            Place::Code | Place::Sequence => self.holds_code(),
            Place::Data => self.is_data(),
            Place::DataOrFileLevel => self.is_data() || self.is_file(),
            Place::AnyModule => self.holds_code() || self.is_data(),
            Place::FileLevel => self.is_file(),
            Place::FileLevelOrModule => !self.included,
            Place::Main => self.inside(ModuleKind::Main),
            Place::MechanismHost => self.inside(ModuleKind::Main) || self.inside(ModuleKind::Fast),
            Place::Init => self.inside(ModuleKind::Init),
            Place::InitOrProcedure => {
                self.inside(ModuleKind::Init) || (self.holds_code() && self.kind == SectionKind::Procedure)
            }
        };
        if fits {
            return None;
        }
        if self.included && entry.kind != EntryKind::Declaration {
            let message =
                format!("an included file may not hold code; move {} into a program file", entry.name);
            return Some((&project_rules::INCLUDED_CODE, message));
        }
        if self.included {
            let message = format!("{} may stand in an included file only when DATA includes it", entry.name);
            return Some((&project_rules::INCLUDED_CODE, message));
        }
        let message = match entry.place {
            Place::Data | Place::DataOrFileLevel => {
                format!("{} belongs into DATA or DATA_LOCAL", entry.name)
            }
            Place::Init => format!("{} belongs into MODULE_INIT", entry.name),
            Place::InitOrProcedure => {
                format!("{} belongs into MODULE_INIT or a procedure called from it", entry.name)
            }
            Place::Main => format!("{} belongs into MODULE_MAIN", entry.name),
            Place::MechanismHost => format!("{} belongs into MODULE_MAIN or MODULE_FAST", entry.name),
            Place::FileLevel => format!("{} stands between modules", entry.name),
            _ if self.is_data() => format!("{} is code; it belongs into a module, not into data", entry.name),
            _ => format!("{} is code; it belongs into a module", entry.name),
        };
        Some((&structure::WRONG_PLACE, message))
    }

    fn refuses_wait(&self, entry: &Entry) -> Option<Refusal> {
        if self.included {
            let message =
                format!("an included file may not hold code; move {} into a program file", entry.name);
            return Some((&project_rules::INCLUDED_CODE, message));
        }
        let message = match self.kind {
            SectionKind::Mechanism | SectionKind::Module(ModuleKind::BlockInit | ModuleKind::BlockDone) => {
                return None;
            }
            SectionKind::Module(kind) => format!(
                "{} may not stand directly in {}; put it into a mechanism",
                entry.name,
                kind.keyword()
            ),
            SectionKind::Procedure => {
                format!("{} may not stand in a procedure; put it into a mechanism", entry.name)
            }
            _ => format!("{} belongs into a mechanism", entry.name),
        };
        Some((&sequences::WAIT_OUTSIDE_SEQUENCE, message))
    }

    /// Why a section may not begin here.
    pub(super) fn refuses_section(&self, entry: &Entry) -> Option<Refusal> {
        let inner = self.outer.last();
        if self.included && !matches!(self.kind, SectionKind::Macro | SectionKind::File) {
            let message =
                format!("an included file may not hold {}; move it into a program file", entry.name);
            return Some((&project_rules::INCLUDED_CODE, message));
        }
        let module = |kind: ModuleKind| inner == Some(&SectionKind::Module(kind));
        let message = match self.kind {
            SectionKind::Mechanism if module(ModuleKind::Main) || module(ModuleKind::Fast) => return None,
            SectionKind::Mechanism => "a mechanism belongs into MODULE_MAIN or MODULE_FAST",
            SectionKind::Procedure if module(ModuleKind::Main) => return None,
            SectionKind::Procedure => "a procedure belongs into MODULE_MAIN",
            _ => return None,
        };
        Some((&structure::WRONG_PLACE, message.to_string()))
    }

    fn inside(&self, module: ModuleKind) -> bool {
        self.kind == SectionKind::Module(module)
            || (self.kind != SectionKind::DataLocal && self.outer.contains(&SectionKind::Module(module)))
    }
}
