//! Joins the code of all sections into one program.

use std::collections::BTreeSet;
use std::sync::Arc;

use technol_image::op::{Addr, Cond, Op, Pc};
use technol_image::program::{Module, ModuleKind, Procedure, Program, Region, RegionKind, Sequence};
use technol_image::system;

use super::addresses::Addresses;
use super::input::{BuildProblem, ProjectInput, SectionInput};
use super::power_on::with_power_on;
use super::relocate::Relocation;
use super::section_code::{NestedCode, ProblemKind};
use crate::catalogue::SystemSymbol;
use crate::semantics::layout::{Layout, MAX_REGION, sequence_kind};
use crate::syntax::section::SectionKind;

/// Sections nested deeper than module, mechanism are a mistake.
const MAX_DEPTH: u32 = 2;

/// A linked program with what the debug information needs besides.
pub(super) struct Linked {
    /// The program.
    pub(super) program: Program,
    /// Lines with code, ascending.
    pub(super) lines: Vec<LinkedLine>,
    /// Labels.
    pub(super) labels: Vec<LinkedLabel>,
    /// Sequences, by number: their sections.
    pub(super) sequences: Vec<LinkedSequence>,
    /// Predefined symbols that occur, by key.
    pub(super) used_system: Vec<&'static SystemSymbol>,
}

/// A line with code.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinkedLine {
    /// First operation.
    pub(super) pc: Pc,
    /// Index of the file.
    pub(super) file: u16,
    /// 0-based line.
    pub(super) line: u32,
}

/// A label of a section.
#[derive(Clone, Debug)]
pub(super) struct LinkedLabel {
    /// Section it belongs to.
    pub(super) section: usize,
    /// Key of its name.
    pub(super) name: Arc<str>,
    /// Operation it stands before.
    pub(super) pc: Pc,
}

/// The section of a sequence.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinkedSequence {
    /// Which.
    pub(super) section: usize,
    /// Module it stands in.
    pub(super) module: ModuleKind,
}

/// Links; the problems are sorted by file and line.
pub(super) fn link(input: &ProjectInput<'_>, layout: &Layout) -> Result<Linked, Vec<BuildProblem>> {
    let mut linker = Linker::new(input, layout);
    linker.link_modules();
    linker.finish()
}

struct Linker<'a> {
    input: &'a ProjectInput<'a>,
    addresses: Addresses<'a>,
    /// By section: first automatic counter and first hidden byte.
    bases: Vec<(Addr, Addr)>,
    program: Program,
    sequences: Vec<Option<(Sequence, LinkedSequence)>>,
    lines: Vec<LinkedLine>,
    labels: Vec<LinkedLabel>,
    problems: Vec<BuildProblem>,
}

/// A section and the way to it.
#[derive(Clone, Copy)]
struct Visit {
    section: usize,
    module: ModuleKind,
    depth: u32,
}

impl<'a> Linker<'a> {
    fn new(input: &'a ProjectInput<'a>, layout: &'a Layout) -> Self {
        let (mut counters, mut states) = (0u64, 0u64);
        let mut relative = Vec::with_capacity(input.sections.len());
        for section in &input.sections {
            relative.push((counters, states));
            counters += section.code.map_or(0, |code| u64::from(code.counters) * 2);
            states += section.code.map_or(0, |code| u64::from(code.states));
        }
        let counters_start = u64::from(layout.local_start()) + u64::from(layout.local_len);
        let hidden_start = counters_start + counters;
        let fit = |n: u64| u32::try_from(n).unwrap_or(u32::MAX);
        let base = |(counter, state): &(u64, u64)| (fit(counters_start + counter), fit(hidden_start + state));
        let bases = relative.iter().map(base).collect();
        let region = |kind, start, len| Region { kind, start, len };
        let regions = vec![
            region(RegionKind::System, 0, system::LEN),
            region(RegionKind::Global, system::LEN, layout.global_len),
            region(RegionKind::Local, layout.local_start(), fit(u64::from(layout.local_len) + counters)),
            region(RegionKind::Hidden, fit(hidden_start), fit(states)),
        ];
        let mut linker = Linker {
            input,
            addresses: Addresses::new(input, layout, &regions),
            bases,
            program: empty_program(input.name, regions, layout),
            sequences: vec![None; layout.sequences.len()],
            lines: Vec::new(),
            labels: Vec::new(),
            problems: Vec::new(),
        };
        linker.prepare();
        linker
    }

    /// Numbers the procedures and collects the problems of the sections.
    fn prepare(&mut self) {
        for section in &self.input.sections {
            for problem in section.code.map_or(&[][..], |code| &code.problems) {
                self.report(section, problem.line, problem.kind.clone());
            }
            if section.kind == SectionKind::Procedure {
                let name = section.name.to_string();
                self.program.procedures.push(Procedure { name, start: 0, end: 0 });
                if self.program.procedures.len() > usize::from(u16::MAX) {
                    self.report(section, 0, ProblemKind::TableFull("procedures", 65_535));
                }
            }
        }
    }

    fn report(&mut self, section: &SectionInput<'_>, own: u32, kind: ProblemKind) {
        self.problems.push(BuildProblem { file: section.file, line: section.file_line(own), kind });
    }

    fn link_modules(&mut self) {
        let input = self.input;
        for (index, section) in input.sections.iter().enumerate() {
            let SectionKind::Module(kind) = section.kind else { continue };
            let start = self.pc();
            self.link_section(Visit { section: index, module: kind, depth: 0 });
            let end = self.pc();
            self.program.modules.push(Module { kind, file: section.owner, start, end });
        }
        for (index, section) in input.sections.iter().enumerate() {
            if !self.is_linked(section.kind, index) {
                self.report(section, 0, ProblemKind::Misplaced(section.name.to_string()));
            }
        }
    }

    /// False for a mechanism, block module or procedure that has no code yet.
    fn is_linked(&self, kind: SectionKind, section: usize) -> bool {
        let Some(number) = self.addresses.number(section).map(usize::from) else { return true };
        match kind {
            SectionKind::Procedure => self.program.procedures.get(number).is_some_and(|p| p.end > p.start),
            _ => self.sequences.get(number).is_some_and(Option::is_some),
        }
    }

    fn pc(&self) -> Pc {
        self.program.code.len() as Pc
    }

    /// Appends the code of a section and of those nested in it.
    fn link_section(&mut self, visit: Visit) {
        let input = self.input;
        let Some(section) = input.sections.get(visit.section) else { return };
        let Some(code) = section.code else { return };
        let mut pcs: Vec<Pc> = Vec::with_capacity(code.ops.len() + 1);
        let mut nested = code.nested.iter().peekable();
        let mut lines = code.lines.iter().peekable();
        for (index, op) in code.ops.iter().enumerate() {
            pcs.push(self.pc());
            if let Some(child) = nested.next_if(|n| n.op as usize == index) {
                self.link_nested(visit, section.file, child);
                continue;
            }
            if let Some(line) = lines.next_if(|l| l.op as usize == index) {
                let (pc, line) = (self.pc(), section.file_line(line.line));
                self.program.statements.push(pc);
                self.lines.push(LinkedLine { pc, file: section.file, line });
            }
            self.program.code.push(*op);
        }
        pcs.push(self.pc());
        self.relocate(visit, section, &pcs);
        for (name, op) in &code.labels {
            let pc = pcs.get(*op as usize).copied().unwrap_or_else(|| self.pc());
            self.labels.push(LinkedLabel { section: visit.section, name: Arc::clone(name), pc });
        }
        self.add_sequence(visit, section, &pcs);
        if code.init_finished && !self.program.init_finished.contains(&section.owner) {
            self.program.init_finished.push(section.owner);
        }
        if code.done_finished && !self.program.done_finished.contains(&section.owner) {
            self.program.done_finished.push(section.owner);
        }
    }

    fn link_nested(&mut self, parent: Visit, file: u16, child: &'a NestedCode) {
        // Whatever is not reached from a module is reported in the end.
        let found = self.addresses.nested(file, child.kind, &child.name, child.ordinal);
        let Some(index) = found.filter(|_| parent.depth + 1 < MAX_DEPTH) else { return };
        let visit = Visit { section: index, depth: parent.depth + 1, ..parent };
        if child.kind != SectionKind::Procedure {
            self.link_section(visit);
            return;
        }
        // The normal flow passes over a procedure.
        let skip = self.program.code.len();
        self.program.code.push(Op::Jump { target: 0, cond: Cond::Always });
        let start = self.pc();
        self.link_section(visit);
        let end = self.pc();
        if let Some(Op::Jump { target, .. }) = self.program.code.get_mut(skip) {
            *target = end;
        }
        let number = self.addresses.number(index).map(usize::from);
        if let Some(procedure) = number.and_then(|n| self.program.procedures.get_mut(n)) {
            (procedure.start, procedure.end) = (start, end);
        }
    }

    fn relocate(&mut self, visit: Visit, section: &SectionInput<'_>, pcs: &[Pc]) {
        let Some(code) = section.code else { return };
        let bases = self.bases.get(visit.section).copied().unwrap_or_default();
        let (timed, messages) = (self.program.timed.len(), self.program.messages.len());
        let services = self.program.services.len();
        self.program.services.extend_from_slice(&code.services);
        self.program.timed.extend_from_slice(&code.timed);
        self.program.messages.extend_from_slice(&code.messages);
        let mut relocation = Relocation {
            code,
            addresses: &self.addresses,
            pcs,
            counters: bases.0,
            states: bases.1,
            timed,
            messages,
            services,
            sequence: self.addresses.number(visit.section).unwrap_or_default(),
            file: section.owner,
            line: 0,
        };
        let mut problems = Vec::new();
        let mut lines = code.lines.iter().peekable();
        let mut nested = code.nested.iter().peekable();
        let mut own_line = 0;
        for (index, pc) in pcs.iter().enumerate().take(code.ops.len()) {
            while let Some(line) = lines.next_if(|l| l.op as usize <= index) {
                own_line = line.line;
                relocation.line = u16::try_from(section.file_line(own_line) + 1).unwrap_or(u16::MAX);
            }
            if nested.next_if(|n| n.op as usize == index).is_some() {
                continue;
            }
            let Some(op) = self.program.code.get_mut(*pc as usize) else { continue };
            let parameters = *op;
            let mut result = relocation.op(op);
            match parameters {
                Op::Timed(n) => {
                    if let Some(parameters) = self.program.timed.get_mut(timed + usize::from(n)) {
                        result = result.and(relocation.timed(parameters));
                    }
                }
                Op::Message { index, .. } => {
                    if let Some(parameters) = self.program.messages.get_mut(messages + usize::from(index)) {
                        result = result.and(relocation.message(parameters));
                    }
                }
                Op::Service(index) => {
                    if let Some(parameters) = self.program.services.get_mut(services + usize::from(index)) {
                        result = result.and(relocation.service(parameters));
                    }
                }
                _ => {}
            }
            if let Err(kind) = result {
                problems.push((own_line, kind));
            }
        }
        for (line, kind) in problems {
            self.report(section, line, kind);
        }
    }

    fn add_sequence(&mut self, visit: Visit, section: &SectionInput<'_>, pcs: &[Pc]) {
        if sequence_kind(section.kind).is_none() {
            return;
        }
        let Some(number) = self.addresses.number(visit.section) else { return };
        let Some(cells) = self.addresses.layout.sequences.get(usize::from(number)) else { return };
        let after = |op: u32| pcs.get(op as usize + 1).copied().unwrap_or_default();
        // A mechanism ends with its SeqEnd, a block module with SeqEnd and ModuleEnd.
        let tail = if section.kind == SectionKind::Mechanism { 2 } else { 3 };
        let sequence = Sequence {
            kind: cells.kind,
            active_addr: cells.active_addr,
            active_bit: cells.active_bit,
            resume_cell: cells.resume_cell,
            wait_cell: cells.wait_cell,
            line_cell: cells.line_cell,
            start: pcs.first().copied().unwrap_or_default(),
            end: pcs.len().checked_sub(tail).and_then(|n| pcs.get(n)).copied().unwrap_or_default(),
            line: u16::try_from(section.file_line(0) + 1).unwrap_or(u16::MAX),
            resume: section.code.iter().flat_map(|code| &code.points).map(|point| after(point.op)).collect(),
        };
        let linked = LinkedSequence { section: visit.section, module: visit.module };
        if let Some(place) = self.sequences.get_mut(usize::from(number)) {
            *place = Some((sequence, linked));
        }
    }

    fn finish(mut self) -> Result<Linked, Vec<BuildProblem>> {
        let limit = u64::from(MAX_REGION);
        let too_long = |kind| self.program.region(kind).is_some_and(|r| u64::from(r.len) > limit);
        if too_long(RegionKind::Local) || too_long(RegionKind::Hidden) {
            let message = format!("the automatic counters and edge states need more than {limit} bytes");
            self.problems.push(BuildProblem { file: 0, line: 0, kind: ProblemKind::Memory(message) });
        }
        if !self.problems.is_empty() {
            self.problems.sort_by_key(|p| (p.file, p.line));
            self.problems.dedup();
            // A full table is reported where it overflows, not for all that follows.
            let mut full = BTreeSet::new();
            self.problems.retain(|p| match p.kind {
                ProblemKind::TableFull(what, _) => full.insert(what),
                _ => true,
            });
            return Err(self.problems);
        }
        let mut linked_sequences = Vec::with_capacity(self.sequences.len());
        for (sequence, linked) in self.sequences.into_iter().flatten() {
            self.program.sequences.push(sequence);
            linked_sequences.push(linked);
        }
        self.program.init_finished.sort_unstable();
        self.program.done_finished.sort_unstable();
        let used_system = self.addresses.into_used_system();
        Ok(Linked {
            program: self.program,
            lines: self.lines,
            labels: self.labels,
            sequences: linked_sequences,
            used_system,
        })
    }
}

fn empty_program(name: &str, regions: Vec<Region>, layout: &Layout) -> Program {
    let initial = with_power_on(&layout.initial);
    Program { initial, ..Program::without_code(name.to_owned(), regions) }
}
