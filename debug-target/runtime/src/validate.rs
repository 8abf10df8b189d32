//! Checks of a program before it is loaded: after them no operation can reach outside memory or code.

use alloc::vec::Vec;

use technol_image::Program;
use technol_image::assembler::{Function, Operand, Register};
use technol_image::op::{Addr, Arith, BitRef, DrTest, Op, Pc, Place, STACK_DEPTH, Source, Width};
use technol_image::program::{Message, RegionKind, SequenceKind, Timed};
use technol_image::service::{Arg, ServiceCall};
use technol_image::system;

use crate::code::{ends_flow, sequence_table};
use crate::context::NO_SEQUENCE;
use crate::load_error::{LoadError, LoadItem};

/// More PLC memory than any program needs; keeps a damaged length from asking for gigabytes.
const MAX_MEMORY: u32 = 16 << 20;
/// Files of a project (manual 5.4).
const MAX_FILES: u8 = 64;
/// Stands for "no sequence" in tables, so the last number cannot be used.
const MAX_SEQUENCES: usize = u16::MAX as usize;

type Checked = Result<(), LoadError>;
type Reason = Result<(), &'static str>;

/// Checks everything.
pub(crate) fn validate(program: &Program) -> Checked {
    regions(program)?;
    tables(program)?;
    let check = Checker { sequence_at: sequence_table(program), ..Checker::new(program) };
    for (pc, op) in program.code.iter().enumerate() {
        check.op(pc as Pc, op).map_err(|reason| LoadError::new(LoadItem::Op(pc as Pc), reason))?;
    }
    for (n, timed) in program.timed.iter().enumerate() {
        check.timed(timed).map_err(|reason| LoadError::new(LoadItem::Timed(n), reason))?;
    }
    for (n, message) in program.messages.iter().enumerate() {
        check.message(message).map_err(|reason| LoadError::new(LoadItem::Message(n), reason))?;
    }
    for (n, call) in program.services.iter().enumerate() {
        check.service(call).map_err(|reason| LoadError::new(LoadItem::Service(n), reason))?;
    }
    for (n, data) in program.initial.iter().enumerate() {
        check.range(data.addr, data.bytes.len()).map_err(|r| LoadError::new(LoadItem::Initial(n), r))?;
    }
    Ok(())
}

fn regions(program: &Program) -> Checked {
    let mut end = 0;
    for (n, region) in program.regions.iter().enumerate() {
        let item = LoadItem::Region(n);
        if region.start < end {
            return Err(LoadError::new(item, "regions overlap or are not ascending"));
        }
        end = match region.start.checked_add(region.len) {
            Some(end) if end <= MAX_MEMORY => end,
            _ => return Err(LoadError::new(item, "more than 16 MiB of PLC memory")),
        };
    }
    match program.region(RegionKind::System) {
        Some(system) if system.start == 0 && system.len >= system::SUPERVISOR_END => Ok(()),
        _ => Err(LoadError::new(LoadItem::Program, "the system region is missing, moved or too short")),
    }
}

/// Modules, procedures, sequences and statements: indices into code.
fn tables(program: &Program) -> Checked {
    let len = program.code.len();
    if len > u32::MAX as usize / 2 {
        return Err(LoadError::new(LoadItem::Program, "too many operations"));
    }
    if program.code.last().is_some_and(|op| !ends_flow(op)) {
        return Err(LoadError::new(LoadItem::Program, "the last operation runs off the end of the code"));
    }
    for (n, module) in program.modules.iter().enumerate() {
        let item = LoadItem::Module(n);
        if !is_body(program, module.start, module.end, |op| matches!(op, Op::ModuleEnd)) {
            return Err(LoadError::new(item, "not a piece of code that ends with a module end"));
        }
        if module.file >= MAX_FILES {
            return Err(LoadError::new(item, "file number above 63"));
        }
    }
    for (n, procedure) in program.procedures.iter().enumerate() {
        if !is_body(program, procedure.start, procedure.end, |op| matches!(op, Op::Return)) {
            return Err(LoadError::new(
                LoadItem::Procedure(n),
                "not a piece of code that ends with a return",
            ));
        }
    }
    let mut before = None;
    for (n, pc) in program.statements.iter().enumerate() {
        if *pc as usize >= len || before.is_some_and(|before| before >= *pc) {
            return Err(LoadError::new(LoadItem::Statement(n), "outside the code or not ascending"));
        }
        before = Some(*pc);
    }
    if program.init_finished.iter().chain(&program.done_finished).any(|file| *file >= MAX_FILES) {
        return Err(LoadError::new(LoadItem::Program, "a file number is above 63"));
    }
    sequences(program)
}

fn is_body(program: &Program, start: Pc, end: Pc, is_last: impl Fn(&Op) -> bool) -> bool {
    program.code.get(start as usize..end as usize).and_then(<[Op]>::last).is_some_and(is_last)
}

fn sequences(program: &Program) -> Checked {
    if program.sequences.len() > MAX_SEQUENCES {
        return Err(LoadError::new(LoadItem::Program, "too many mechanisms"));
    }
    let check = Checker::new(program);
    for (n, sequence) in program.sequences.iter().enumerate() {
        let fail = |reason| Err(LoadError::new(LoadItem::Sequence(n), reason));
        let number = n as u16;
        let (start, end) = (sequence.start, sequence.end);
        let op = |pc: Pc| program.code.get(pc as usize);
        if start >= end || op(start) != Some(&Op::SeqBegin(number)) || op(end) != Some(&Op::SeqEnd(number)) {
            return fail("does not lie between its begin and its end");
        }
        let activation = BitRef { addr: sequence.active_addr, bit: sequence.active_bit, indexed: false };
        let cells = [sequence.resume_cell, sequence.wait_cell, sequence.line_cell];
        if check.bit(activation).is_err() || cells.iter().any(|cell| check.range(*cell, 2).is_err()) {
            return fail("a cell lies outside PLC memory");
        }
        if sequence.resume.len() > usize::from(u16::MAX)
            || sequence.resume.iter().any(|pc| *pc <= start || *pc > end)
        {
            return fail("a continuation lies outside the sequence");
        }
    }
    let mut places: Vec<_> = program.sequences.iter().map(|s| (s.start, s.end)).collect();
    places.sort_unstable();
    if places.windows(2).any(|pair| pair[1].0 <= pair[0].1) {
        return Err(LoadError::new(LoadItem::Program, "two sequences overlap"));
    }
    let count = |kind| program.sequences.iter().filter(|s| s.kind == kind).count();
    if count(SequenceKind::BlockInit) > 1 || count(SequenceKind::BlockDone) > 1 {
        return Err(LoadError::new(LoadItem::Program, "two sequences for the same block module"));
    }
    Ok(())
}

struct Checker<'a> {
    program: &'a Program,
    memory: usize,
    /// Empty while the sequences themselves are being checked.
    sequence_at: Vec<u16>,
}

impl<'a> Checker<'a> {
    fn new(program: &'a Program) -> Checker<'a> {
        Checker { program, memory: program.memory_len() as usize, sequence_at: Vec::new() }
    }

    fn op(&self, pc: Pc, op: &Op) -> Reason {
        match *op {
            Op::Nop
            | Op::LogicPop(_)
            | Op::Complement
            | Op::IncrementBcd
            | Op::IndexFromDr
            | Op::Return
            | Op::ModuleEnd
            | Op::Unary { .. } => Ok(()),
            Op::Ldr { bit, .. } | Op::Logic { bit, .. } | Op::Write(bit) | Op::Flag { bit, .. } => {
                self.bit(bit)
            }
            Op::Edge { bit, state, .. } => self.bit(bit).and(self.range(state, 1)),
            Op::MoveBit { dst, src, .. } => self.bit(dst).and(self.bit(src)),
            Op::Assembler { function, width, to, from } => self.assembler(function, width, to, from),
            Op::AssemblerJump { target, .. } | Op::Jump { target, .. } | Op::Raster { end: target, .. } => {
                self.target(target)
            }
            Op::Load { src, width, .. } | Op::Compare { src, width, .. } => self.source(src, width),
            Op::Store { dst, width, .. } => self.place(dst, width.bytes()),
            Op::Move { dst, src, width, .. } => {
                self.place(dst, width.bytes()).and(self.place(src, width.bytes()))
            }
            Op::Arith { op, src, width } => arithmetic_width(op, width).and(self.source(src, width)),
            Op::BcdToBin(width) | Op::BinToBcd(width) => {
                require(matches!(width, Width::Word | Width::DWord), "BIN and BCD take 16 or 32 bits")
            }
            Op::Shift { count, width, .. } => integer_width(width).and(match count {
                Source::Mem(place) => self.place(place, 1),
                Source::Int(_) => Ok(()),
                Source::Real(_) => Err("a real constant as a number of bits"),
            }),
            Op::DrToRlo(DrTest::Bit(bit)) => require(bit < 32, "bit number above 31"),
            Op::DrToRlo(DrTest::NonZero(width)) | Op::RloToDr(width) | Op::IntToReal(width) => {
                integer_width(width)
            }
            Op::Timer { count, width } => counter_width(width).and(self.place(count, width.bytes())),
            Op::Counter { count, width, state, .. } => {
                counter_width(width).and(self.place(count, width.bytes())).and(self.range(state, 1))
            }
            Op::Copy { src, dst, len } => self.place(src, len).and(self.place(dst, len)),
            Op::Clear { addr, len } => self.range(addr, len as usize),
            Op::Call(n) => require(usize::from(n) < self.program.procedures.len(), "unknown procedure"),
            Op::SeqBegin(n) => self.sequence_at(n, pc, |s| s.start),
            Op::SeqEnd(n) => self.sequence_at(n, pc, |s| s.end),
            Op::SeqInit(n) => require(usize::from(n) < self.program.sequences.len(), "unknown sequence"),
            Op::Ex { point, .. } | Op::ExIf { point, .. } | Op::Bex { point, .. } => self.point(pc, point),
            Op::Timed(n) => match self.program.timed.get(usize::from(n)) {
                Some(timed) => self.point(pc, timed.point),
                None => Err("unknown TEX/TIM parameters"),
            },
            Op::Message { index, .. } => {
                require(usize::from(index) < self.program.messages.len(), "unknown message parameters")
            }
            Op::Service(n) => {
                require(usize::from(n) < self.program.services.len(), "unknown parameters of a call")
            }
            Op::InitFinished(file) | Op::DoneFinished(file) => {
                require(file < MAX_FILES, "file number above 63")
            }
            Op::SelectBlock { offset, len } => {
                let inside = u32::from(offset) + u32::from(len) <= system::block_record::LEN;
                require(inside && (1..=8).contains(&len), "outside the record of a block")
            }
        }
    }

    fn timed(&self, timed: &Timed) -> Reason {
        counter_width(timed.width)?;
        self.place(timed.count, timed.width.bytes())?;
        self.source(timed.time, timed.width)?;
        if let Some(target) = timed.error {
            self.target(target)?;
        }
        require(
            timed.error.is_some() == timed.wait_when.is_some(),
            "TEX needs an error label, TIM has none",
        )?;
        timed.code.map_or(Ok(()), |(source, width)| self.integer_source(source, width))
    }

    fn message(&self, message: &Message) -> Reason {
        let values = message.parameters.iter().chain([&message.number, &message.sub_id]);
        for (source, width) in values.copied().flatten() {
            self.integer_source(source, width)?;
        }
        Ok(())
    }

    fn service(&self, call: &ServiceCall) -> Reason {
        for arg in &call.args {
            match *arg {
                Arg::Cell { place, width, .. } => self.place(place, width.bytes())?,
                Arg::Bit { bit, .. } => self.bit(bit)?,
                Arg::Area { place, len } => self.place(place, len)?,
                Arg::Procedure(n) => {
                    require(usize::from(n) < self.program.procedures.len(), "unknown procedure")?;
                }
                Arg::Missing | Arg::Int(_) | Arg::Real(_) | Arg::Text(_) | Arg::Keyword(_) => {}
            }
        }
        Ok(())
    }

    fn assembler(&self, function: Function, width: Width, to: Operand, from: Operand) -> Reason {
        let narrow = matches!(width, Width::Byte | Width::Word | Width::DWord);
        require(narrow, "an 80386 instruction wider than 32 bits")?;
        require(!matches!(to, Operand::Number(_)), "an 80386 instruction writes to a number")?;
        let fits = match (function, from) {
            (Function::ShiftLeft | Function::ShiftRight, from) => {
                matches!(from, Operand::Number(_)) || from == Operand::Register(Register::CL)
            }
            (Function::Increment | Function::Decrement, from) => from == Operand::Number(1),
            (_, Operand::Register(register)) => register.width() == width,
            (_, Operand::Cell(_)) => matches!(to, Operand::Register(_)),
            (_, Operand::Number(_)) => true,
        };
        require(fits, "operands that this 80386 instruction does not take")?;
        if let Operand::Register(register) = to {
            require(register.width() == width, "a register of another width")?;
        }
        for operand in [to, from] {
            if let Operand::Cell(place) = operand {
                self.place(place, width.bytes())?;
            }
        }
        Ok(())
    }

    fn bit(&self, bit: BitRef) -> Reason {
        require(bit.bit < 8, "bit number above 7")?;
        if bit.indexed { Ok(()) } else { self.range(bit.addr, 1) }
    }

    /// An indexed place is checked at run time; its length must fit memory all the same.
    fn place(&self, place: Place, len: u32) -> Reason {
        self.range(if place.indexed { 0 } else { place.addr }, len as usize)
    }

    fn range(&self, addr: Addr, len: usize) -> Reason {
        let inside = (addr as usize).checked_add(len).is_some_and(|end| end <= self.memory);
        require(inside, "an address lies outside PLC memory")
    }

    fn source(&self, source: Source, width: Width) -> Reason {
        match source {
            Source::Mem(place) => self.place(place, width.bytes()),
            Source::Int(_) => require(width != Width::Real, "an integer constant as a real operand"),
            Source::Real(_) => require(width == Width::Real, "a real constant as an integer operand"),
        }
    }

    fn integer_source(&self, source: Source, width: Width) -> Reason {
        integer_width(width).and(self.source(source, width))
    }

    fn target(&self, target: Pc) -> Reason {
        require((target as usize) < self.program.code.len(), "a jump leaves the code")
    }

    fn sequence_at(
        &self,
        number: u16,
        pc: Pc,
        place: impl Fn(&technol_image::program::Sequence) -> Pc,
    ) -> Reason {
        let sequence = self.program.sequences.get(usize::from(number));
        require(sequence.is_some_and(|s| place(s) == pc), "begin or end of another sequence")
    }

    fn point(&self, pc: Pc, point: u16) -> Reason {
        let number = self.sequence_at.get(pc as usize).copied().unwrap_or(NO_SEQUENCE);
        let sequence = self.program.sequences.get(usize::from(number));
        let sequence = sequence.ok_or("an EX-type instruction outside a mechanism or block module")?;
        let known = point > 0 && usize::from(point) <= sequence.resume.len();
        require(known, "an EX-type instruction without a continuation")
    }
}

fn require(condition: bool, reason: &'static str) -> Reason {
    if condition { Ok(()) } else { Err(reason) }
}

fn integer_width(width: Width) -> Reason {
    require(width != Width::Real, "an integer operation at real width")
}

fn counter_width(width: Width) -> Reason {
    require(matches!(width, Width::Byte | Width::Word), "a counter is 8 or 16 bits wide")
}

fn arithmetic_width(op: Arith, width: Width) -> Reason {
    match op {
        Arith::Add | Arith::Sub => Ok(()),
        Arith::Mul | Arith::Div => require(width != Width::QWord, "MULB and DIVB take no QWRD operand"),
        Arith::Or | Arith::And | Arith::Xor => integer_width(width),
    }
}

const _: () = assert!(STACK_DEPTH == 8, "the equation stack is kept in the bits of one byte");
