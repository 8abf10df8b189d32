//! From the meaning of one section to its operations.

use std::collections::HashMap;
use std::sync::Arc;

use technol_image::op::{Cond, DrTest, Op, Source, Width};
use technol_image::program::{Message, Timed};
use technol_image::service::{Service, ServiceCall};

use super::mnemonic::{Form, form};
use super::operands::{block_selection, keyword_width};
use super::section_code::{ClearRange, LineProblem, NestedCode, ProblemKind, ResumePoint, SectionCode};
use crate::catalogue::EntryKind;
use crate::semantics::hir::{Body, Instruction, Operand, StatementKind};
use crate::semantics::layout::sequence_kind;
use crate::syntax::section::SectionKind;

/// Translates the code of a section of `kind` with `own_lines` lines. Depends on nothing else.
#[must_use]
pub fn lower(kind: SectionKind, own_lines: u32, body: &Body) -> SectionCode {
    let code = SectionCode { ops: Vec::with_capacity(body.statements.len() + 2), ..SectionCode::default() };
    let in_sequence = sequence_kind(kind).is_some();
    let mut lowering = Lowering { code, labels: HashMap::new(), jumps: Vec::new(), line: 0, in_sequence };
    if !body.complete {
        lowering.problem(ProblemKind::Incomplete);
        return lowering.code;
    }
    let last = own_lines.saturating_sub(1);
    lowering.open(kind);
    for statement in &body.statements {
        lowering.line = statement.line;
        let here = lowering.code.ops.len() as u32;
        for label in &statement.labels {
            lowering.labels.insert(Arc::clone(label), here);
            lowering.code.labels.push((Arc::clone(label), here));
        }
        match &statement.kind {
            StatementKind::Instruction(instruction) => lowering.instruction(instruction),
            StatementKind::Nested { kind, name, ordinal } => {
                let nested = NestedCode { op: here, kind: *kind, name: Arc::clone(name), ordinal: *ordinal };
                lowering.code.nested.push(nested);
                lowering.code.ops.push(Op::Nop);
            }
            StatementKind::Empty => {}
        }
    }
    lowering.line = last;
    lowering.close(kind);
    lowering.bind_jumps();
    lowering.code
}

/// Where a label's operation number goes.
enum Jump {
    /// Into an operation.
    Op(u32),
    /// Into the error exit of a TEX.
    Timed(usize),
}

/// What CAN_AX_SEND works on, with lengths in bytes (manual 13.14).
const DRIVE_CELLS: [(&str, u32); 3] =
    [("CAN_AX_SEND_PACKET", 12), ("CAN_AX_RECV_PACKET", 12), ("CAN_AX_BUSY", 1)];

struct Lowering {
    code: SectionCode,
    labels: HashMap<Arc<str>, u32>,
    jumps: Vec<(Jump, Arc<str>, u32)>,
    line: u32,
    /// A mechanism or block module: it can wait.
    in_sequence: bool,
}

impl Lowering {
    fn problem(&mut self, kind: ProblemKind) {
        self.code.problems.push(LineProblem { line: self.line, kind });
    }

    fn emit(&mut self, op: Op) {
        self.code.push_line(self.line);
        self.code.ops.push(op);
    }

    fn open(&mut self, kind: SectionKind) {
        if sequence_kind(kind).is_some() {
            self.emit(Op::SeqBegin(0));
        }
    }

    fn close(&mut self, kind: SectionKind) {
        if sequence_kind(kind).is_some() {
            self.emit(Op::SeqEnd(0));
        }
        match kind {
            SectionKind::Procedure => self.emit(Op::Return),
            // No statement: a program does not stop between its modules.
            SectionKind::Module(_) => self.code.ops.push(Op::ModuleEnd),
            _ => {}
        }
    }

    fn instruction(&mut self, instruction: &Instruction) {
        let entry = instruction.entry;
        let Some(form) =
            form(entry.name).filter(|_| entry.executable || entry.kind != EntryKind::Instruction)
        else {
            if entry.kind == EntryKind::Instruction {
                self.problem(ProblemKind::NotExecutable(entry.name.to_owned()));
            }
            return;
        };
        if let Some(selection) = instruction.operands.first().and_then(block_selection) {
            self.emit(selection);
        }
        let operands = Operands { name: entry.name, list: &instruction.operands };
        // An instruction of several cycles acts as if BEX stood before it: the EX0 behind it comes back to it alone.
        if entry.ex_type && matches!(form, Form::Service(_)) && self.in_sequence {
            match self.point(entry.name) {
                Ok(point) => self.emit(Op::Bex { point, line: 0 }),
                Err(problem) => return self.problem(problem),
            }
        }
        if let Err(problem) = self.translate(form, instruction.push, &operands) {
            self.problem(problem);
        }
    }

    fn translate(&mut self, form: Form, push: bool, operands: &Operands<'_>) -> Result<(), ProblemKind> {
        match form {
            Form::NoCode => {}
            Form::Nop => self.emit(Op::Nop),
            Form::Ldr
            | Form::Logic(_)
            | Form::Edge { .. }
            | Form::Write
            | Form::Flag(_)
            | Form::MoveBit(_) => return self.bits(form, push, operands),
            Form::Complement => self.emit(Op::Complement),
            Form::Jump(cond) => {
                self.jump(operands.label(0)?);
                self.emit(Op::Jump { target: 0, cond });
            }
            Form::Raster(rate) => {
                self.jump(operands.label(0)?);
                self.emit(Op::Raster { rate, end: 0 });
            }
            Form::Load
            | Form::Store(_)
            | Form::Move(_)
            | Form::Arith(_)
            | Form::Compare { .. }
            | Form::Timer
            | Form::Count(_)
            | Form::Copy
            | Form::Clear => return self.data(form, operands),
            Form::Unary(_)
            | Form::IncrementBcd
            | Form::BcdToBin
            | Form::BinToBcd
            | Form::Shift { .. }
            | Form::DrToRlo
            | Form::RloToDr
            | Form::IntToReal => return self.register(form, operands),
            Form::Assembler(function) => {
                let op = self.code.assembler(function, operands.name, operands.list)?;
                self.emit(op);
            }
            Form::AssemblerJump(condition) => {
                self.jump(operands.label(0)?);
                self.emit(Op::AssemblerJump { condition, target: 0 });
            }
            Form::Call | Form::SeqInit => {
                let Some(Operand::Procedure(key) | Operand::Mechanism(key)) = operands.get(0) else {
                    return Err(operands.problem(0));
                };
                let index = self.code.name(key);
                let index = table_index("procedures and mechanisms", index)?;
                self.emit(if form == Form::Call { Op::Call(index) } else { Op::SeqInit(index) });
            }
            Form::Ex | Form::ExIf { .. } | Form::Bex | Form::Timed(_) => {
                return self.sequential(form, operands);
            }
            Form::Message(cond) => return self.message(cond, operands),
            Form::Service(service) => return self.service(service, push, operands),
            Form::InitFinished => {
                self.code.init_finished = true;
                self.emit(Op::InitFinished(0));
            }
            Form::DoneFinished => {
                self.code.done_finished = true;
                self.emit(Op::DoneFinished(0));
            }
        }
        Ok(())
    }

    fn bits(&mut self, form: Form, push: bool, operands: &Operands<'_>) -> Result<(), ProblemKind> {
        let code = &mut self.code;
        match form {
            Form::Ldr => {
                let (bit, neg) = code.bit(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                self.emit(Op::Ldr { bit, neg, push });
            }
            Form::Logic(op) if matches!(operands.get(0), None | Some(Operand::Skipped)) => {
                self.emit(Op::LogicPop(op));
            }
            Form::Logic(op) => {
                let (bit, neg) = code.bit(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                self.emit(Op::Logic { op, bit, neg });
            }
            Form::Edge { rising } => {
                let bit = code.plain_bit(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                let state = code.state();
                self.emit(Op::Edge { rising, bit, state });
            }
            Form::Write => {
                for n in 0..operands.list.len() {
                    let bit = self.code.plain_bit(operands.get(n)).ok_or_else(|| operands.problem(n))?;
                    self.emit(Op::Write(bit));
                }
            }
            Form::Flag(cond) => {
                let value = match operands.get(0) {
                    Some(Operand::Integer { value: 0, .. }) => false,
                    Some(Operand::Integer { value: 1, .. }) => true,
                    _ => return Err(operands.problem(0)),
                };
                for n in 1..operands.list.len() {
                    let bit = self.code.plain_bit(operands.get(n)).ok_or_else(|| operands.problem(n))?;
                    self.emit(Op::Flag { value, bit, cond });
                }
            }
            Form::MoveBit(cond) => {
                let dst = code.plain_bit(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                let (src, neg) = code.bit(operands.get(1)).ok_or_else(|| operands.problem(1))?;
                self.emit(Op::MoveBit { dst, src, neg, cond });
            }
            _ => {}
        }
        Ok(())
    }

    fn data(&mut self, form: Form, operands: &Operands<'_>) -> Result<(), ProblemKind> {
        let code = &mut self.code;
        let op = match form {
            Form::Load => {
                let (src, width, neg) = code.value(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                Op::Load { src, width, neg }
            }
            Form::Store(cond) => {
                let (dst, width) = code.plain_cell(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                Op::Store { dst, width, cond }
            }
            Form::Move(cond) => {
                let (dst, width) = code.plain_cell(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                let source = code.plain_cell(operands.get(1)).filter(|(_, other)| *other == width);
                let (src, _) = source.ok_or_else(|| operands.problem(1))?;
                Op::Move { dst, src, width, cond }
            }
            Form::Arith(op) => {
                let (src, width) = code.plain_value(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                Op::Arith { op, src, width }
            }
            Form::Compare { op, if_rlo } => {
                let (src, width) = code.plain_value(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                Op::Compare { op, src, width, if_rlo }
            }
            Form::Timer => {
                let counter = code.counter_or_automatic(operands.get(0));
                let (count, width) = counter.ok_or_else(|| operands.problem(0))?;
                Op::Timer { count, width: counter_width(width).ok_or_else(|| operands.problem(0))? }
            }
            Form::Count(op) => {
                let (count, width) = code.plain_cell(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                let width = counter_width(Some(width)).ok_or_else(|| operands.problem(0))?;
                Op::Counter { op, count, width, state: code.state() }
            }
            Form::Copy => {
                let (src, ..) = code.area(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                let (dst, ..) = code.area(operands.get(1)).ok_or_else(|| operands.problem(1))?;
                let Some(Operand::Integer { value, .. }) = operands.get(2) else {
                    return Err(operands.problem(2));
                };
                Op::Copy { src, dst, len: u32::try_from(*value).map_err(|_| operands.problem(2))? }
            }
            _ => Op::Clear { addr: self.clear(operands)?, len: 0 },
        };
        self.emit(op);
        Ok(())
    }

    /// The number of a new CLEAR range.
    fn clear(&mut self, operands: &Operands<'_>) -> Result<u32, ProblemKind> {
        let range = match operands.get(0) {
            Some(Operand::Keyword(region)) if matches!(operands.get(1), Some(Operand::Keyword("ALL"))) => {
                match *region {
                    "GLOBAL" => ClearRange::Global,
                    "INTERNAL" => ClearRange::Internal,
                    _ => return Err(operands.problem(0)),
                }
            }
            first => {
                let (begin, ..) = self.code.area(first).ok_or_else(|| operands.problem(0))?;
                let (end, offset, len) =
                    self.code.area(operands.get(1)).ok_or_else(|| operands.problem(1))?;
                if begin.indexed || end.indexed {
                    return Err(ProblemKind::Clear);
                }
                // A whole variable is cleared with its last byte; with an offset the byte at that address is the last.
                ClearRange::Span {
                    begin: begin.addr,
                    end: end.addr,
                    tail: if offset == 0 { len.max(1) } else { 1 },
                }
            }
        };
        self.code.clears.push(range);
        Ok((self.code.clears.len() - 1) as u32)
    }

    fn register(&mut self, form: Form, operands: &Operands<'_>) -> Result<(), ProblemKind> {
        let width = |n: usize| keyword_width(operands.get(n), Width::Word).ok_or_else(|| operands.problem(n));
        let op = match form {
            Form::Unary(op) => Op::Unary { op, width: width(0)? },
            Form::BcdToBin => Op::BcdToBin(width(0)?),
            Form::BinToBcd => Op::BinToBcd(width(0)?),
            Form::RloToDr => Op::RloToDr(width(0)?),
            Form::IntToReal => Op::IntToReal(width(0)?),
            Form::Shift { left } => {
                let (count, kind) =
                    self.code.plain_value(operands.get(0)).ok_or_else(|| operands.problem(0))?;
                if matches!(count, Source::Real(_))
                    || (matches!(count, Source::Mem(_)) && kind != Width::Byte)
                {
                    return Err(operands.problem(0));
                }
                Op::Shift { left, count, width: width(1)? }
            }
            Form::DrToRlo => match operands.get(0) {
                Some(Operand::Integer { value, .. }) => match u8::try_from(*value) {
                    Ok(bit @ 0..=31) => Op::DrToRlo(DrTest::Bit(bit)),
                    _ => return Err(operands.problem(0)),
                },
                _ => Op::DrToRlo(DrTest::NonZero(width(0)?)),
            },
            _ => Op::IncrementBcd,
        };
        self.emit(op);
        Ok(())
    }

    /// The number of the next resume point; its operation is the next one.
    fn point(&mut self, mnemonic: &'static str) -> Result<u16, ProblemKind> {
        let op = self.code.ops.len() as u32;
        let number = table_index("EX-type instructions in a sequence", self.code.points.len() + 1)?;
        self.code.points.push(ResumePoint { op, line: self.line, mnemonic });
        Ok(number)
    }

    fn sequential(&mut self, form: Form, operands: &Operands<'_>) -> Result<(), ProblemKind> {
        let line = 0;
        let op = match form {
            Form::Ex => Op::Ex { point: self.point(operands.name)?, line },
            Form::ExIf { wait_when } => Op::ExIf { wait_when, point: self.point(operands.name)?, line },
            Form::Timed(wait_when) => Op::Timed(self.timed(wait_when, operands)?),
            _ => Op::Bex { point: self.point(operands.name)?, line },
        };
        self.emit(op);
        Ok(())
    }

    fn timed(&mut self, wait_when: Option<bool>, operands: &Operands<'_>) -> Result<u16, ProblemKind> {
        let counter = self.code.counter_or_automatic(operands.get(0));
        let (count, counter) = counter.ok_or_else(|| operands.problem(0))?;
        let time = self.code.plain_value(operands.get(1)).ok_or_else(|| operands.problem(1))?;
        let (time, width) = match time {
            (Source::Int(limit), _) => {
                let width = counter_width(counter).ok_or_else(|| operands.problem(0))?;
                if limit < 0 || limit >= 1 << width.bits() {
                    return Err(ProblemKind::TimeTooLong(limit));
                }
                (Source::Int(limit), width)
            }
            // An automatic counter takes the type of the time.
            (cell, of_time) => {
                // A cell of another length is one that the counter's prefix covers.
                let covered = counter.filter(|_| !matches!(of_time, Width::Byte | Width::Word));
                let width =
                    counter_width(Some(covered.unwrap_or(of_time))).ok_or_else(|| operands.problem(1))?;
                if counter.is_some_and(|of_counter| of_counter != width) {
                    return Err(ProblemKind::MixedWidths(operands.name));
                }
                (cell, width)
            }
        };
        let index = table_index("TEX and TIM instructions", self.code.timed.len())?;
        let error = match wait_when {
            Some(_) => {
                let label = Arc::clone(operands.label(2)?);
                self.jumps.push((Jump::Timed(usize::from(index)), label, self.line));
                Some(0)
            }
            None => None,
        };
        let code = match operands.get(3) {
            None | Some(Operand::Skipped) => None,
            value => Some(self.code.plain_value(value).ok_or_else(|| operands.problem(3))?),
        };
        let point = self.point(operands.name)?;
        self.code.timed.push(Timed { wait_when, count, width, time, error, code, point, line: 0 });
        Ok(index)
    }

    fn message(&mut self, cond: Cond, operands: &Operands<'_>) -> Result<(), ProblemKind> {
        let mut value = |n: usize| match operands.get(n) {
            None | Some(Operand::Skipped) => Ok(None),
            given => self.code.plain_value(given).map(Some).ok_or_else(|| operands.problem(n)),
        };
        let (number, sub_id) = (value(0)?, value(1)?);
        let parameters = [value(3)?, value(4)?, value(5)?];
        let set = match operands.get(2) {
            None | Some(Operand::Skipped | Operand::Integer { value: 1, .. }) => true,
            Some(Operand::Integer { value: 0, .. }) => false,
            Some(_) => return Err(operands.problem(2)),
        };
        let index = table_index("messages", self.code.messages.len())?;
        self.code.messages.push(Message { number, sub_id, set, parameters });
        self.emit(Op::Message { index, cond });
        Ok(())
    }

    fn service(&mut self, service: Service, push: bool, operands: &Operands<'_>) -> Result<(), ProblemKind> {
        let mut args = Vec::with_capacity(operands.list.len());
        for n in 0..operands.list.len() {
            args.push(self.code.arg(operands.get(n)).ok_or_else(|| operands.problem(n))?);
        }
        if service == Service::CanAxSend {
            args.extend(DRIVE_CELLS.map(|(name, len)| self.code.predefined(name, len)));
        }
        let index = table_index("instructions of the control", self.code.services.len())?;
        self.code.services.push(ServiceCall { service, args, push });
        self.emit(Op::Service(index));
        Ok(())
    }

    /// The next operation jumps to `label`.
    fn jump(&mut self, label: &Arc<str>) {
        let op = self.code.ops.len() as u32;
        self.jumps.push((Jump::Op(op), Arc::clone(label), self.line));
    }

    fn bind_jumps(&mut self) {
        for (jump, label, line) in std::mem::take(&mut self.jumps) {
            let Some(&found) = self.labels.get(&label) else {
                let kind = ProblemKind::Label(label.to_string());
                self.code.problems.push(LineProblem { line, kind });
                continue;
            };
            match jump {
                Jump::Op(op) => {
                    let op = self.code.ops.get_mut(op as usize);
                    if let Some(
                        Op::Jump { target, .. }
                        | Op::AssemblerJump { target, .. }
                        | Op::Raster { end: target, .. },
                    ) = op
                    {
                        *target = found;
                    }
                }
                Jump::Timed(index) => {
                    if let Some(timed) = self.code.timed.get_mut(index) {
                        timed.error = Some(found);
                    }
                }
            }
        }
    }
}

/// Operands of one instruction.
struct Operands<'a> {
    name: &'static str,
    list: &'a [Operand],
}

impl Operands<'_> {
    fn get(&self, n: usize) -> Option<&Operand> {
        self.list.get(n)
    }

    fn problem(&self, n: usize) -> ProblemKind {
        ProblemKind::Operand(n + 1, self.name)
    }

    fn label(&self, n: usize) -> Result<&Arc<str>, ProblemKind> {
        match self.get(n) {
            Some(Operand::Label(label)) => Ok(label),
            _ => Err(self.problem(n)),
        }
    }
}

/// Width of a counter; WORD for an automatic one, and `None` for a width that cannot count.
fn counter_width(width: Option<Width>) -> Option<Width> {
    match width {
        None => Some(Width::Word),
        Some(width @ (Width::Byte | Width::Word)) => Some(width),
        Some(_) => None,
    }
}

fn table_index(what: &'static str, index: usize) -> Result<u16, ProblemKind> {
    u16::try_from(index).map_err(|_| ProblemKind::TableFull(what, usize::from(u16::MAX)))
}
