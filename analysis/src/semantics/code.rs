//! The code of one section: walks its lines from top to bottom, looks up operations, checks their place, resolves
//! their operands and hands them to equations and control flow.

mod names;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::analysis::{Overrun, SectionAnalysis};
use super::equations::Equations;
use super::hir::{Body, Instruction, Operand, Statement, StatementKind, SymbolKey};
use super::macros;
use super::macros::expand::{Call, Expansion};
use super::reference::{Reference, ReferenceAccess, Referent};
use super::scope::{Symbol, SymbolKind};
use super::{devices, flow, lints, moves, operands, place, suggest};
use crate::catalogue::{self, Entry, EntryKind};
use crate::database::{self, Db, Project, Section};
use crate::diagnostics::rules::{memory, names as name_rules, operands as operand_rules, sequences};
use crate::diagnostics::{Finding, Rule, Severity};
use crate::syntax::ParsedLines;
use crate::syntax::ast::{Columns, ExprKind, Line, Name};
use crate::syntax::section::SectionKind;

/// Analyses a section.
pub(crate) fn analyse(db: &dyn Db, project: Project, section: Section<'_>) -> SectionAnalysis {
    let included = section.file(db).order(db).is_none();
    let kind = section.kind(db);
    if kind == SectionKind::Macro {
        return macros::body::check(db, project, section);
    }
    let expansion = database::expansion_of(db, project, section);
    let parsed = expansion.map_or_else(|| database::section_lines(db, section), |it| &it.parsed);
    let mut reader = CodeReader {
        db,
        project,
        section,
        parsed,
        expansion,
        calls: expansion.map_or(&[][..], |it| it.calls.as_slice()).iter().peekable(),
        open_calls: Vec::new(),
        place: place::Context::of(db, project, section, included),
        line: 0,
        clean: true,
        out: SectionAnalysis {
            body: Body { statements: Vec::new(), complete: true },
            ..SectionAnalysis::default()
        },
        labels: BTreeMap::new(),
        waiting: Vec::new(),
        equations: Equations::default(),
        loaded: moves::Loaded::default(),
        registers: lints::registers::Registers::default(),
        unreadable: false,
        too_large: false,
        misplaced: false,
        end: if section.closed(db) { (parsed.lines.len() as u32).saturating_sub(1) } else { u32::MAX },
    };
    reader.read();
    reader.finish()
}

/// State of the walk.
pub(super) struct CodeReader<'db> {
    pub(super) db: &'db dyn Db,
    pub(super) project: Project,
    pub(super) section: Section<'db>,
    pub(super) place: place::Context,
    /// The lines it walks: its own, with expansions of the macros it calls.
    pub(super) parsed: &'db ParsedLines,
    pub(super) expansion: Option<&'db Expansion<'db>>,
    /// Calls that are still to come.
    pub(super) calls: std::iter::Peekable<std::slice::Iter<'db, Call<'db>>>,
    /// Calls whose expansion the current line belongs to, outermost first, with the equations before them.
    pub(super) open_calls: Vec<(&'db Call<'db>, Equations)>,
    /// Current line; own lines and expansions count alike until [`macros::remap`] makes own lines of them.
    pub(super) line: u32,
    /// Nothing was reported on the current line.
    pub(super) clean: bool,
    pub(super) out: SectionAnalysis,
    /// Labels of the section: where they stand.
    labels: BTreeMap<Arc<str>, (u32, Columns)>,
    /// Labels that wait for their statement.
    waiting: Vec<Arc<str>>,
    pub(super) equations: Equations,
    loaded: moves::Loaded,
    registers: lints::registers::Registers,
    /// A line could not be read: what flows through the section is a guess.
    pub(super) unreadable: bool,
    /// A call was reported as too large.
    pub(super) too_large: bool,
    /// The line before was reported as misplaced.
    pub(super) misplaced: bool,
    /// Own line that closes the section.
    end: u32,
}

/// How much a walk has recorded, so that an attempt can be taken back.
pub(super) struct Mark {
    pub(super) findings: usize,
    pub(super) references: usize,
    pub(super) overruns: usize,
    pub(super) identifiers: usize,
    pub(super) clean: bool,
}

impl<'db> CodeReader<'db> {
    pub(super) fn mark(&self) -> Mark {
        Mark {
            findings: self.out.findings.len(),
            references: self.out.references.len(),
            overruns: self.out.overruns.len(),
            identifiers: self.out.identifiers.len(),
            clean: self.clean,
        }
    }

    fn read(&mut self) {
        let parsed = self.parsed;
        let errors = parsed.error_lines();
        let mut children = self.section.children(self.db).iter().peekable();
        self.collect_labels(&parsed.lines);
        for (number, line) in parsed.lines.iter().enumerate() {
            self.line = number as u32;
            let own = self.own_line();
            while let Some((child, _)) = children.next_if(|(_, before)| *before <= own) {
                self.nested(*child);
            }
            self.leave_calls();
            self.clean = true;
            let broken = errors.binary_search(&self.line).is_ok();
            let local = self.in_local_data().then(|| self.place.in_local_data());
            let around = local.map(|local| std::mem::replace(&mut self.place, local));
            self.one(line, broken);
            if let Some(around) = around {
                self.place = around;
            }
        }
        self.line = parsed.lines.len() as u32;
        self.leave_calls();
        for (child, _) in children {
            self.nested(*child);
        }
    }

    /// Labels first: jumps lead forward too.
    fn collect_labels(&mut self, lines: &[Line]) {
        if !self.place.holds_code() {
            return;
        }
        for (number, line) in lines.iter().enumerate() {
            let Some(label) = &line.label else { continue };
            if self.is_local_data(number as u32)
                || line.operation.as_ref().is_some_and(|o| o.text.eq_ignore_ascii_case("STR"))
            {
                continue;
            }
            let key: Arc<str> = Arc::from(label.key());
            if let Some((first, columns)) = self.labels.get(&key) {
                let message = format!("the label {} stands here twice", label.text);
                let finding =
                    Finding::new(&name_rules::DUPLICATE_LABEL, number as u32, label.columns.clone(), message)
                        .beside(*first, columns.clone(), "the first one");
                self.out.findings.push(finding);
            } else {
                self.labels.insert(key, (number as u32, label.columns.clone()));
            }
        }
    }

    fn nested(&mut self, child: Section<'db>) {
        if matches!(child.kind(self.db), SectionKind::Mechanism | SectionKind::Procedure) {
            let kind = StatementKind::Nested {
                kind: child.kind(self.db),
                name: child.name(self.db).clone(),
                ordinal: child.ordinal(self.db),
            };
            self.push(kind);
        }
    }

    fn push(&mut self, kind: StatementKind) {
        let labels = std::mem::take(&mut self.waiting);
        self.out.body.statements.push(Statement { line: self.line, labels, kind });
    }

    fn one(&mut self, line: &Line, broken: bool) {
        if let Some(label) = line.label.as_ref().filter(|_| self.place.holds_code()) {
            let key: Arc<str> = Arc::from(label.key());
            self.refer(label.columns.clone(), Referent::Label(key.clone()), ReferenceAccess::Declare);
            self.waiting.push(key);
            self.loaded = moves::Loaded::default();
            self.registers = lints::registers::Registers::default();
        }
        if broken {
            self.clean = false;
            self.out.body.complete = false;
        }
        if let Some(call) = self.calls.next_if(|call| call.line == self.line) {
            self.call(call, line);
            return;
        }
        let Some(operation) = &line.operation else {
            self.unreadable |= broken;
            return;
        };
        let Some(entry) = self.entry(operation) else { return };
        if entry.kind == EntryKind::Structure {
            self.structure(entry, operation, line, broken);
            return;
        }
        if !self.placed(entry, operation) {
            self.out.body.complete = false;
            // In the wrong place or not, it ends the equation before it.
            self.equations.step(entry, !line.operands.is_empty(), self.line, &operation.columns);
            return;
        }
        if self.place.holds_code() {
            self.step(entry, operation, line, broken);
        } else {
            self.outside_code(entry, line, broken);
        }
    }

    /// The catalogue's entry; reports words that are neither instruction nor macro.
    fn entry(&mut self, operation: &Name) -> Option<&'static Entry> {
        let operates = |entry: &&Entry| {
            !matches!(entry.kind, EntryKind::TypePrefix | EntryKind::Keyword | EntryKind::EventProcedure)
        };
        let known = catalogue::entry(&operation.text).filter(operates);
        if known.is_some() {
            return known;
        }
        self.unreadable = true;
        if self.in_expansion() {
            // Reported where the macro is defined.
            return None;
        }
        self.misplaced = true;
        let names = catalogue::entries().filter(operates).map(|entry| entry.name);
        self.push_finding(suggest::unknown_instruction(self.line, operation, names));
        None
    }

    /// Opening and closing lines.
    fn structure(&mut self, entry: &'static Entry, operation: &Name, line: &Line, broken: bool) {
        let own = self.line == 0 || self.line == self.end;
        if self.place.is_file() || !own {
            // STOP, and closing lines without a section: the structure of the file looks at them.
            return;
        }
        if self.line == 0 {
            self.opening_place(entry, operation);
        }
        let declared = matches!(self.section.kind(self.db), SectionKind::Mechanism | SectionKind::Procedure);
        if declared && !broken {
            self.named_line(entry, operation, line);
        } else if let Some(extra) = line.operands.first().filter(|_| !broken) {
            let message = format!("{} takes no operand", entry.name);
            self.report(&operand_rules::OPERAND_COUNT, extra.columns.clone(), message);
        }
    }

    /// MECH_BEGIN, MECH_END, PROC_BEGIN, PROC_END.
    fn named_line(&mut self, entry: &'static Entry, operation: &Name, line: &Line) {
        match line.operands.as_slice() {
            [] => {
                let message = format!("the name is missing: {}", form(entry));
                self.report(&operand_rules::OPERAND_COUNT, operation.columns.clone(), message);
            }
            [one] => {
                if let ExprKind::Name(name) = &one.kind {
                    if let Some(symbol) = self.symbol(&name.text).cloned() {
                        let access =
                            if self.line == 0 { ReferenceAccess::Declare } else { ReferenceAccess::Call };
                        self.refer(name.columns.clone(), Referent::Symbol(symbol.key), access);
                    }
                } else {
                    let message = format!("a name is needed here: {}", form(entry));
                    self.report(&operand_rules::OPERAND_KIND, one.columns.clone(), message);
                }
            }
            [_, more, ..] => {
                let message = format!("one name is enough: {}", form(entry));
                self.report(&operand_rules::OPERAND_COUNT, more.columns.clone(), message);
            }
        }
    }

    /// Declarations, EQUI and directives outside of code; what they declare is checked elsewhere.
    fn outside_code(&mut self, entry: &'static Entry, line: &Line, broken: bool) {
        self.misplaced = false;
        if broken {
            return;
        }
        match entry.name {
            "EQUI" | "DS" | "STR" | "DFM" | "DB" | "DW" | "DD" | "DQ" => {
                operands::declaration(self, entry, line);
            }
            "APPEND_T_MACRO" => self.append(line),
            "T_LOCAL" => self.t_local(line),
            "STRUC" | "ENDS" => {
                operands::resolve(self, entry, line);
            }
            _ => {
                if entry.kind == EntryKind::Directive {
                    operands::resolve(self, entry, line);
                }
            }
        }
    }

    fn step(&mut self, entry: &'static Entry, operation: &Name, line: &Line, broken: bool) {
        let has_operand = !line.operands.is_empty();
        let push = self.equations.step(entry, has_operand, self.line, &operation.columns);
        if matches!(entry.name, "JUM" | "PROC_CALL") && self.equations.left().0 {
            let message =
                format!("{} does not close the equation that is open here; close it before", entry.name);
            self.report(&memory::JUMP_WITH_OPEN_EQUATION, operation.columns.clone(), message);
        }
        if entry.name == "CHECK" {
            self.equations.check(false);
        }
        if broken {
            return;
        }
        if entry.kind == EntryKind::Declaration {
            operands::declaration(self, entry, line);
            return;
        }
        if entry.name == "APPEND_T_MACRO" {
            self.append(line);
            return;
        }
        if entry.name == "T_LOCAL" {
            self.t_local(line);
            return;
        }
        let resolved = operands::resolve(self, entry, line);
        if self.clean {
            let found = [self.loaded.step(entry, &resolved), self.registers.step(entry, &resolved)];
            for (rule, message) in found.into_iter().flatten() {
                let columns =
                    line.operands.first().map_or(&operation.columns, |operand| &operand.columns).clone();
                self.report(rule, columns, message);
            }
            self.calls(&resolved, line);
            self.push(StatementKind::Instruction(Instruction { entry, operands: resolved, push }));
        } else {
            self.out.body.complete = false;
            // Control flow must still see that it waits, jumps or ends a loop.
            self.push(StatementKind::Instruction(Instruction { entry, operands: resolved, push }));
        }
    }

    fn calls(&mut self, resolved: &[Operand], line: &Line) {
        for (operand, expr) in resolved.iter().zip(&line.operands) {
            if let Operand::Procedure(key) = operand {
                self.out.calls.push((key.clone(), self.line, expr.columns.clone()));
            }
        }
        // The control calls _ON_ESET from each ESET.
        let name = line
            .operation
            .as_ref()
            .filter(|name| ["ESET", "ESET1"].iter().any(|eset| name.text.eq_ignore_ascii_case(eset)));
        if let Some(name) = name.filter(|_| self.section.kind(self.db) == SectionKind::Procedure)
            && let Some(Symbol { key, kind: SymbolKind::Procedure }) = self.symbol("_ON_ESET")
        {
            self.out.calls.push((key.clone(), self.line, name.columns.clone()));
        }
    }

    /// Whether the operation may stand here; reports the first of neighbouring ones that may not.
    fn placed(&mut self, entry: &'static Entry, operation: &Name) -> bool {
        let Some((rule, message)) = self.place.refuses(entry) else {
            self.misplaced = false;
            return true;
        };
        if !std::mem::replace(&mut self.misplaced, true) {
            self.report(rule, operation.columns.clone(), message);
        }
        // A wait in the wrong place is an isolated slip, not a run of code in the wrong place.
        if rule == &sequences::WAIT_OUTSIDE_SEQUENCE {
            self.misplaced = false;
        }
        false
    }

    fn opening_place(&mut self, entry: &'static Entry, operation: &Name) {
        if let Some((rule, message)) = self.place.refuses_section(entry) {
            self.report(rule, operation.columns.clone(), message);
        }
    }

    fn finish(mut self) -> SectionAnalysis {
        if !self.waiting.is_empty() {
            self.push(StatementKind::Empty);
        }
        if self.place.holds_code() {
            self.equations.check(self.section.kind(self.db) == SectionKind::Procedure);
            if self.unreadable {
                self.equations.unreadable();
            }
            let equations = std::mem::take(&mut self.equations);
            self.out.findings.extend(equations.finish());
            let labels = std::mem::take(&mut self.labels);
            let found = flow::check(&self.out.body, &self.parsed.lines, &labels, self.unreadable);
            self.out.findings.extend(found);
            let lines = &self.parsed.lines;
            if !self.unreadable && self.out.body.complete {
                let kind = self.section.kind(self.db);
                let code = lints::Code { kind, body: &self.out.body, lines, labels: &labels };
                self.out.findings.extend(lints::section(&code));
            }
            let devices = devices::check(&self.out.body, lines, self.section.kind(self.db));
            // What an instruction with a mistake means is not known.
            let wrong: BTreeSet<u32> =
                self.out.findings.iter().filter(|f| f.blocks()).map(|f| f.line).collect();
            self.out.findings.extend(devices.findings.into_iter().filter(|f| !wrong.contains(&f.line)));
            self.out.records = devices.records;
            self.out.devices = devices.uses;
        }
        let blocked = self.out.findings.iter().any(Finding::blocks);
        self.out.body.complete &= !blocked && !self.unreadable && self.section.closed(self.db);
        if let Some(expansion) = self.expansion {
            self.out = macros::remap::analysis(expansion, self.out);
        }
        self.out.findings.sort_by_key(|f| (f.line, f.columns.start));
        self.out
    }

    pub(super) fn refer(&mut self, columns: Columns, referent: Referent, access: ReferenceAccess) {
        self.out.references.push(Reference { line: self.line, columns, referent, access });
    }

    pub(super) fn report(&mut self, rule: &'static Rule, columns: Columns, message: impl Into<String>) {
        self.push_finding(Finding::new(rule, self.line, columns, message));
    }

    /// Reports that a symbol is something else than needed.
    pub(super) fn report_symbol(
        &mut self,
        rule: &'static Rule,
        columns: Columns,
        message: String,
        key: &SymbolKey,
    ) {
        self.push_finding(Finding::new(rule, self.line, columns, message).declared_at(key));
    }

    pub(super) fn push_finding(&mut self, finding: Finding) {
        if finding.rule.severity == Severity::Error {
            self.clean = false;
        }
        self.out.findings.push(finding);
    }

    pub(super) fn overrun(&mut self, columns: Columns, symbol: &Symbol, offset: i64, bytes: u32) {
        let Some(declared) = symbol.bytes() else { return };
        if offset < 0 || offset.saturating_add(i64::from(bytes)) > i64::from(declared) {
            let line = self.line;
            self.out.overruns.push(Overrun {
                line,
                columns,
                symbol: symbol.key.clone(),
                offset,
                bytes,
                declared,
                expanded: None,
            });
        }
    }
}

/// The first way to write an instruction.
pub(super) fn form(entry: &Entry) -> &'static str {
    entry.forms.first().map_or(entry.name, |form| form.syntax)
}
