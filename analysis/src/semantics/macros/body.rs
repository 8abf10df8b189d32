//! What can be said about a definition without a call: header, T_LOCAL, the words of the body, flags.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::TMAC;
use super::definition::{Flags, MacroDefinition, StackFlag, is};
use super::table::is_instruction;
use crate::catalogue::{self, Access, Entry, EntryKind, OperandKind};
use crate::database::{self, Db, NameRef, Project, Section};
use crate::diagnostics::rules::{declarations, macros as rules, operands, structure};
use crate::diagnostics::{Finding, Rule};
use crate::semantics::analysis::SectionAnalysis;
use crate::semantics::calls::flag_finding;
use crate::semantics::equations::Equations;
use crate::semantics::operands::access;
use crate::semantics::place;
use crate::semantics::reference::{Reference, ReferenceAccess, Referent};
use crate::semantics::suggest;
use crate::syntax::ast::{Columns, Expr, ExprKind, Line, Name, SIGNIFICANT};

/// Checks a definition and finds the names in it.
pub(crate) fn check(db: &dyn Db, project: Project, section: Section<'_>) -> SectionAnalysis {
    let lines = &database::section_lines(db, section).lines;
    let errors = database::section_lines(db, section).error_lines();
    let included = section.file(db).order(db).is_none();
    let definition = database::macro_definition(db, section);
    let mut body = BodyReader {
        db,
        project,
        definition,
        file: place::Context::of(db, project, section, included).file,
        line: 0,
        local_data: None,
        global_data: None,
        code_seen: false,
        formals: BTreeMap::new(),
        defined: Vec::new(),
        out: SectionAnalysis::default(),
    };
    if let Some(header) = lines.first() {
        body.header(header);
    }
    let last = if section.closed(db) { lines.len().saturating_sub(1) } else { lines.len() };
    for (number, line) in lines.iter().enumerate().take(last).skip(1) {
        body.line = number as u32;
        body.one(line, errors.binary_search(&body.line).is_ok());
    }
    body.line = last as u32;
    if let Some(end) = lines.get(last).filter(|_| last > 0) {
        body.end(end);
    }
    body.finish(section, lines)
}

struct BodyReader<'db> {
    db: &'db dyn Db,
    project: Project,
    definition: &'db MacroDefinition,
    /// File whose local names the references mean.
    file: Option<u8>,
    line: u32,
    /// Line of the open DATA_LOCAL.
    local_data: Option<(u32, Columns)>,
    /// The finding about an open DATA.
    global_data: Option<usize>,
    /// Something other than T_LOCAL stood before.
    code_seen: bool,
    /// Keys of parameters and T_LOCAL symbols: where they are declared.
    formals: BTreeMap<String, (u32, Columns)>,
    /// Labels, data and bits that the body defines.
    defined: Vec<(u32, Name)>,
    out: SectionAnalysis,
}

impl BodyReader<'_> {
    fn report(&mut self, rule: &'static Rule, columns: Columns, message: impl Into<String>) {
        self.out.findings.push(Finding::new(rule, self.line, columns, message));
    }

    fn refer(&mut self, columns: Columns, referent: Referent, access: ReferenceAccess) {
        self.out.references.push(Reference { line: self.line, columns, referent, access });
    }

    fn header(&mut self, line: &Line) {
        let operation = line.operation.as_ref().map_or(0..0, |name| name.columns.clone());
        let Some(first) = line.operands.first() else {
            self.report(
                &operands::OPERAND_COUNT,
                operation,
                "the name is missing: DEF_T_MACRO name [par1, par2, …]",
            );
            return;
        };
        for (index, operand) in line.operands.iter().enumerate() {
            match &operand.kind {
                ExprKind::Name(name) if index > 0 => self.formal(name),
                ExprKind::Name(name) => {
                    if name.text.chars().count() > SIGNIFICANT {
                        let message =
                            format!("only the first {SIGNIFICANT} characters of {} count", name.text);
                        self.report(&declarations::LONG_NAME, name.columns.clone(), message);
                    }
                }
                ExprKind::Error => {}
                _ => {
                    let message = "names are needed here, separated by commas and without brackets: \
                                   DEF_T_MACRO NAME PAR1, PAR2";
                    let columns = operand.columns.clone();
                    self.report(&operands::OPERAND_KIND, columns, message);
                }
            }
        }
        if let ExprKind::Name(name) = &first.kind
            && is_instruction(&name.text)
            && !database::macros_before(self.db, self.project)
        {
            let message = format!(
                "{} stays the instruction; only CONTROL_T_MACRO PRE lets a macro replace it",
                name.text
            );
            self.report(&rules::MACRO_HIDDEN, name.columns.clone(), message);
        }
    }

    fn formal(&mut self, name: &Name) {
        let own = name.key();
        if let Some((line, columns)) = self.formals.get(&own).cloned() {
            let message = format!("{} is a parameter or T_LOCAL symbol of this macro already", name.text);
            let finding = Finding::new(&rules::DUPLICATE_PARAMETER, self.line, name.columns.clone(), message)
                .beside(line, columns, "the first one");
            self.out.findings.push(finding);
            return;
        }
        self.refer(name.columns.clone(), Referent::Formal(Arc::from(own.as_str())), ReferenceAccess::Declare);
        self.formals.insert(own, (self.line, name.columns.clone()));
    }

    fn one(&mut self, line: &Line, broken: bool) {
        if let Some(label) = &line.label {
            self.define(label);
        }
        let Some(operation) = &line.operation else {
            self.code_seen |= line.label.is_some();
            return;
        };
        if is(line, "T_LOCAL") {
            self.t_local(line, operation);
            return;
        }
        self.code_seen = true;
        match catalogue::entry(&operation.text).filter(|_| is_instruction(&operation.text)) {
            None => self.call(operation, line),
            Some(entry) if entry.kind == EntryKind::Structure || is_directive(entry) => {
                self.structure(entry, operation);
            }
            Some(entry) => {
                self.declaration(entry, operation, line, broken);
                for (index, operand) in line.operands.iter().enumerate() {
                    self.operand(Some(entry), index, operand);
                }
            }
        }
    }

    fn t_local(&mut self, line: &Line, operation: &Name) {
        if self.code_seen {
            let message = "T_LOCAL must stand directly behind DEF_T_MACRO, before the body";
            self.report(&rules::T_LOCAL_PLACE, operation.columns.clone(), message);
        }
        if line.operands.is_empty() {
            let message = "a symbol is missing: T_LOCAL symbol1 [, symbol2 …]";
            self.report(&operands::OPERAND_COUNT, operation.columns.clone(), message);
        }
        for operand in &line.operands {
            match &operand.kind {
                ExprKind::Name(name) => self.formal(name),
                ExprKind::Missing | ExprKind::Error => {}
                _ => {
                    self.report(
                        &operands::OPERAND_KIND,
                        operand.columns.clone(),
                        "a name of a label, cell or bit is needed here",
                    );
                }
            }
        }
    }

    /// A word that is no instruction: a macro, or a mistake.
    fn call(&mut self, operation: &Name, line: &Line) {
        let name = NameRef::new(self.db, Arc::from(operation.key()), None);
        if database::macro_somewhere(self.db, self.project, name) {
            let key = crate::semantics::hir::SymbolKey {
                scope: crate::semantics::hir::SymbolScope::Macro,
                name: Arc::from(operation.key()),
            };
            self.refer(operation.columns.clone(), Referent::Symbol(key), ReferenceAccess::Call);
            for (index, operand) in line.operands.iter().enumerate() {
                self.operand(None, index, operand);
            }
            return;
        }
        let names = catalogue::entries().filter(|entry| is_instruction(entry.name)).map(|entry| entry.name);
        self.out.findings.push(suggest::unknown_instruction(self.line, operation, names));
    }

    /// Words that open or close something, and directives that belong outside of macros.
    fn structure(&mut self, entry: &'static Entry, operation: &Name) {
        let columns = operation.columns.clone();
        match entry.name {
            "DATA_LOCAL" if self.local_data.is_some() => {
                self.report(&structure::NESTED_BLOCK, columns, "DATA_LOCAL is open already; close it first");
            }
            "DATA_LOCAL" => self.local_data = Some((self.line, columns)),
            "DATA_LOCAL_END" => {
                if self.local_data.take().is_none() {
                    let message = "DATA_LOCAL_END closes nothing; DATA_LOCAL is missing before it";
                    self.report(&structure::UNEXPECTED_END, columns, message);
                }
            }
            "DATA" => {
                let message = "data of a macro are local: write DATA_LOCAL … DATA_LOCAL_END";
                let finding = Finding::new(&rules::MACRO_DATA, self.line, columns.clone(), message).replace(
                    "write DATA_LOCAL … DATA_LOCAL_END",
                    columns,
                    "DATA_LOCAL",
                );
                // What stands between them is meant as data.
                self.local_data = Some((self.line, 0..0));
                self.global_data = Some(self.out.findings.len());
                self.out.findings.push(finding);
            }
            "DATA_END" => {
                self.local_data = None;
                let opened = self.global_data.take().and_then(|at| self.out.findings.get_mut(at));
                if let Some((_, edits)) = opened.and_then(|finding| finding.fix.as_mut()) {
                    // One mistake: the same fix corrects both lines.
                    edits.push((self.line, columns, "DATA_LOCAL_END".to_owned()));
                } else {
                    let message = "data of a macro are local: write DATA_LOCAL_END";
                    let finding = Finding::new(&rules::MACRO_DATA, self.line, columns.clone(), message);
                    self.out.findings.push(finding.replace(
                        "write DATA_LOCAL_END",
                        columns,
                        "DATA_LOCAL_END",
                    ));
                }
            }
            name => {
                let message = format!("{name} may not stand in a macro; move it out of the definition");
                self.report(&rules::MACRO_STRUCTURE, columns, message);
            }
        }
    }

    fn declaration(&mut self, entry: &'static Entry, operation: &Name, line: &Line, broken: bool) {
        if !matches!(entry.name, "DS" | "DFM" | "STR") {
            return;
        }
        if self.local_data.is_none() {
            let message =
                format!("{} of a macro belongs into DATA_LOCAL … DATA_LOCAL_END in its body", entry.name);
            self.report(&rules::MACRO_DATA, operation.columns.clone(), message);
        }
        if entry.name != "DFM" {
            return;
        }
        for operand in &line.operands {
            if let ExprKind::Name(name) = &operand.kind {
                self.define(name);
            }
        }
        let named = line.operands.iter().filter(|o| !matches!(o.kind, ExprKind::Missing)).count();
        if named < 8 && !broken {
            let message = format!("DFM in a macro must name all eight bits, {named} are named");
            self.report(&rules::MACRO_BITS, operation.columns.clone(), message);
        }
    }

    fn define(&mut self, name: &Name) {
        let own = name.key();
        if self.formals.contains_key(&own) {
            self.refer(name.columns.clone(), Referent::Formal(Arc::from(own)), ReferenceAccess::Declare);
        }
        self.defined.push((self.line, name.clone()));
    }

    /// Parameters behind TMAC., and other names.
    fn operand(&mut self, entry: Option<&'static Entry>, index: usize, operand: &Expr) {
        let names = operand.names();
        let covered = names.iter().position(|name| name.text.eq_ignore_ascii_case(TMAC));
        let bare = entry.is_none_or(Entry::is_assembler);
        let is_parameter =
            |name: &Name| self.definition.parameters.iter().any(|parameter| parameter.key() == name.key());
        if let Some(at) = covered
            && !names.iter().any(|name| is_parameter(name))
        {
            let wrong = names.iter().skip(at + 1).find(|name| catalogue::prefix(&name.text).is_none());
            self.unknown_parameter(wrong.copied().unwrap_or(names[at]));
        }
        let access = entry.map_or(ReferenceAccess::Read, |entry| operand_access(entry, index));
        let mut unprefixed = None;
        for name in names {
            let own = name.key();
            if name.text.eq_ignore_ascii_case(TMAC) {
                continue;
            }
            if self.formals.contains_key(&own) {
                let parameter = self.definition.parameters.iter().any(|parameter| parameter.key() == own);
                if parameter && !bare && covered.is_none() {
                    unprefixed = unprefixed.or(Some(name));
                    continue;
                }
                self.refer(name.columns.clone(), Referent::Formal(Arc::from(own)), access);
                continue;
            }
            let known = NameRef::new(self.db, Arc::from(own), self.file);
            if let Some(symbol) = database::lookup(self.db, self.project, known) {
                let referent = Referent::Symbol(symbol.key.clone());
                self.refer(name.columns.clone(), referent, access);
            }
        }
        if let Some(name) = unprefixed {
            let known = NameRef::new(self.db, Arc::from(name.key()), self.file);
            let exists = database::lookup(self.db, self.project, known).is_some();
            self.prefix_missing(name, operand, exists);
        }
    }

    fn unknown_parameter(&mut self, name: &Name) {
        let header = self.definition.name.as_ref().map_or("this macro", |name| name.text.as_str());
        let parameters = self.definition.parameters.iter().map(|parameter| parameter.text.as_str());
        let near = suggest::nearest(&name.text, parameters);
        let message = match near {
            Some(near) => format!("{} is no parameter of {header}; did you mean {near}?", name.text),
            None => format!("{} is no parameter of {header}; TMAC. stands before parameters only", name.text),
        };
        let mut finding = Finding::new(&rules::UNKNOWN_PARAMETER, self.line, name.columns.clone(), message);
        if let Some(near) = near {
            finding = finding.replace(format!("write {near}"), name.columns.clone(), near);
        }
        self.out.findings.push(finding);
    }

    fn prefix_missing(&mut self, name: &Name, operand: &Expr, exists: bool) {
        let mut first = operand;
        while let ExprKind::Sign { operand, .. } = &first.kind {
            first = operand;
        }
        let start = first.columns.start;
        let (rule, message) = if exists {
            let message = format!("this is the {0} of the project, not the parameter TMAC.{0}", name.text);
            (&rules::PARAMETER_BYPASSED, message)
        } else {
            let message = format!("{0} is a parameter: an instruction takes it as TMAC.{0}", name.text);
            (&rules::MISSING_TMAC, message)
        };
        let finding = Finding::new(rule, self.line, name.columns.clone(), message).replace(
            "write TMAC. before the operand",
            start..start,
            "TMAC.",
        );
        self.out.findings.push(finding);
    }

    fn end(&mut self, line: &Line) {
        for problem in Flags::read(&line.operands).1 {
            self.out.findings.push(flag_finding(&problem, self.line));
        }
        if let Some((opened, columns)) = self.local_data.take().filter(|(_, columns)| !columns.is_empty()) {
            let message = "DATA_LOCAL is never closed; DATA_LOCAL_END is missing";
            self.out.findings.push(Finding::new(&structure::UNCLOSED_BLOCK, opened, columns, message));
        }
    }

    fn finish(mut self, section: Section<'_>, lines: &[Line]) -> SectionAnalysis {
        self.locals();
        for circle in database::macro_circles(self.db, self.project).iter().filter(|c| c.section == section) {
            self.line = circle.line;
            let message = format!("macros call each other in a circle: {}", circle.circle);
            self.report(&rules::MACRO_RECURSION, circle.columns.clone(), message);
        }
        // The flags stand in the line that ends the definition.
        let mismatch = section.closed(self.db).then(|| stack_mismatch(self.definition, lines)).flatten();
        if let Some((columns, message)) = mismatch {
            self.line = lines.len() as u32 - 1;
            self.report(&rules::MACRO_FLAG_MISMATCH, columns, message);
        }
        self.out.findings.sort_by_key(|finding| (finding.line, finding.columns.start));
        self.out.references.sort_by_key(|reference| reference.line);
        self.out
    }

    /// Symbols without T_LOCAL, and T_LOCAL without symbols.
    fn locals(&mut self) {
        let header = self.definition.name.as_ref().map_or("the macro", |name| name.text.as_str()).to_owned();
        for (line, name) in std::mem::take(&mut self.defined) {
            if !self.formals.contains_key(&name.key()) {
                let message = format!(
                    "{} is not in T_LOCAL: it would be declared again by every call of {header}",
                    name.text
                );
                self.line = line;
                self.report(&rules::MISSING_T_LOCAL, name.columns, message);
            }
        }
        let defined: Vec<String> = self
            .out
            .references
            .iter()
            .filter(|r| r.access == ReferenceAccess::Declare)
            .filter_map(|r| match &r.referent {
                // The T_LOCAL line itself is one as well.
                Referent::Formal(own) => Some(own.to_string()),
                _ => None,
            })
            .collect();
        for (line, name) in &self.definition.locals {
            let own = name.key();
            if defined.iter().filter(|other| **other == own).count() < 2 {
                let message = format!("the body defines no {}; remove it from T_LOCAL", name.text);
                self.line = *line;
                self.report(&rules::UNUSED_T_LOCAL, name.columns.clone(), message);
            }
        }
    }
}

/// Directives that belong outside of macros.
fn is_directive(entry: &Entry) -> bool {
    entry.name.ends_with("_T_MACRO") || entry.name == "T_INCLUDE" || entry.name == "DEBUG"
}

/// What an instruction does with the names of an operand.
fn operand_access(entry: &Entry, index: usize) -> ReferenceAccess {
    let repeated = || entry.operands.last().filter(|spec| spec.repeatable);
    let Some(spec) = entry.operands.get(index).or_else(repeated) else { return ReferenceAccess::Read };
    match spec.kind {
        OperandKind::Bit { access: it, .. } | OperandKind::Data { access: it, .. } => access(it),
        OperandKind::Address(it) | OperandKind::Text(it) => access(it),
        OperandKind::AutoCounter => access(Access::ReadWrite),
        OperandKind::Label => ReferenceAccess::Jump,
        OperandKind::Mechanism { .. } | OperandKind::Procedure { .. } => ReferenceAccess::Call,
        _ => ReferenceAccess::Read,
    }
}

/// Where the flags say something else about the stack than the instructions of the body do. Bodies with 80386
/// instructions and calls of other macros are believed.
fn stack_mismatch(definition: &MacroDefinition, lines: &[Line]) -> Option<(Columns, String)> {
    let flag = definition.flags.stack;
    let mut equations = Equations::default();
    if flag == StackFlag::Pop {
        for _ in 0..2 {
            equations.push_one();
        }
    }
    for body in &definition.body {
        let line = lines.get(body.line as usize)?;
        let Some(operation) = &line.operation else { continue };
        let entry = catalogue::entry(&operation.text).filter(|_| !body.broken)?;
        if entry.is_assembler() || entry.place == catalogue::Place::Data {
            continue;
        }
        equations.step(entry, !line.operands.is_empty(), body.line, &operation.columns);
    }
    if definition.body.iter().any(|body| {
        let line = lines.get(body.line as usize).and_then(|line| line.operation.as_ref());
        line.and_then(|name| catalogue::entry(&name.text)).is_some_and(Entry::is_assembler)
    }) {
        return None;
    }
    let word = flag.word();
    let message = match (flag, equations.left()) {
        (StackFlag::Push | StackFlag::Pop, (true, 0)) => return None,
        (StackFlag::Normal | StackFlag::Begin | StackFlag::End, (false, 0)) => return None,
        (StackFlag::Push, (false, 0)) => {
            "T_PUSH says that a call begins an equation, as LDR does, but the body leaves none open".to_owned()
        }
        (StackFlag::Pop, _) => {
            "T_POP says that a call takes one value from the stack and goes on with it, but the body does not: LA, \
             LO or LX without operand is missing"
                .to_owned()
        }
        (_, (true, 0)) => {
            format!("the body leaves an equation open, but {word} denies it; close it, or write T_PUSH")
        }
        (_, (_, left)) => format!("the body leaves {left} values on the stack; take them back with LA, LO or LX"),
    };
    let end = lines.last()?;
    let columns = end.operands.first().map(|operand| operand.columns.clone());
    let columns = columns.or_else(|| end.operation.as_ref().map(|name| name.columns.clone()));
    Some((columns.unwrap_or(0..end.len), message))
}
