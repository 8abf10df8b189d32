//! Builds small programs for tests and drives them in virtual time.
#![allow(dead_code, reason = "shared by the tests and the benchmark, each of which uses a part")]

use technol_image::Program;
use technol_image::op::{Addr, BitRef, Cond, Logic, Op, Pc, Place, Source, Width};
use technol_image::program::{
    Message, Module, ModuleKind, Procedure, Region, RegionKind, Sequence, SequenceKind, Timed,
};
use technol_image::system;
use technol_runtime::{Command, InputImage, PlcState, Runtime, RuntimeEvent, TickOutcome};

/// Global data of test programs.
pub(crate) const GLOBAL: Addr = system::LEN;
/// Cells of sequences, taken from here on.
pub(crate) const SEQUENCE_CELLS: Addr = GLOBAL + 0x200;
/// Local data.
pub(crate) const LOCAL: Addr = GLOBAL + 0x400;
/// Hidden states.
pub(crate) const HIDDEN: Addr = GLOBAL + 0x500;
/// End of memory.
pub(crate) const END: Addr = GLOBAL + 0x600;

pub(crate) const fn bit(addr: Addr, bit: u8) -> BitRef {
    BitRef { addr, bit, indexed: false }
}

pub(crate) const fn cell(addr: Addr) -> Place {
    Place { addr, indexed: false }
}

pub(crate) const fn indexed(addr: Addr) -> Place {
    Place { addr, indexed: true }
}

pub(crate) const fn mem(addr: Addr) -> Source {
    Source::Mem(cell(addr))
}

pub(crate) const fn ldr(bit: BitRef) -> Op {
    Op::Ldr { bit, neg: false, push: false }
}

pub(crate) const fn la(bit: BitRef) -> Op {
    Op::Logic { op: Logic::And, bit, neg: false }
}

pub(crate) const fn set(bit: BitRef, value: bool) -> Op {
    Op::Flag { value, bit, cond: Cond::Always }
}

pub(crate) const fn lod(value: i64) -> Op {
    Op::Load { src: Source::Int(value), width: Width::DWord, neg: false }
}

pub(crate) const fn sto(addr: Addr, width: Width) -> Op {
    Op::Store { dst: cell(addr), width, cond: Cond::Always }
}

/// Adds 1 to a WORD cell: how often execution came by. Leaves the counter in DR.
pub(crate) fn count(addr: Addr) -> [Op; 3] {
    use technol_image::op::Unary;
    [
        Op::Load { src: mem(addr), width: Width::Word, neg: false },
        Op::Unary { op: Unary::Increment, width: Width::Word },
        sto(addr, Width::Word),
    ]
}

/// A place in code that is not known yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Label(usize);

/// Writes programs operation by operation; each operation is a statement of its own.
pub(crate) struct Builder {
    program: Program,
    labels: Vec<Option<Pc>>,
    jumps: Vec<(Pc, Label)>,
    timed_errors: Vec<(usize, Label)>,
    procedures: Vec<(String, Vec<Op>)>,
    open: Option<u16>,
    next_cell: Addr,
}

impl Builder {
    pub(crate) fn new() -> Builder {
        let region = |kind, start, end| Region { kind, start, len: end - start };
        let program = Program {
            name: "test".into(),
            regions: vec![
                region(RegionKind::System, 0, GLOBAL),
                region(RegionKind::Global, GLOBAL, LOCAL),
                region(RegionKind::Local, LOCAL, HIDDEN),
                region(RegionKind::Hidden, HIDDEN, END),
            ],
            code: vec![],
            statements: vec![],
            modules: vec![],
            sequences: vec![],
            timed: vec![],
            messages: vec![],
            services: Vec::new(),
            procedures: vec![],
            initial: vec![],
            init_finished: vec![],
            done_finished: vec![],
        };
        Builder {
            program,
            labels: vec![],
            jumps: vec![],
            timed_errors: vec![],
            procedures: vec![],
            open: None,
            next_cell: SEQUENCE_CELLS,
        }
    }

    pub(crate) fn here(&self) -> Pc {
        self.program.code.len() as Pc
    }

    /// Appends an operation and returns its place.
    pub(crate) fn op(&mut self, op: Op) -> Pc {
        let pc = self.here();
        self.program.statements.push(pc);
        self.program.code.push(op);
        pc
    }

    pub(crate) fn ops(&mut self, ops: impl IntoIterator<Item = Op>) {
        for op in ops {
            self.op(op);
        }
    }

    pub(crate) fn label(&mut self) -> Label {
        self.labels.push(None);
        Label(self.labels.len() - 1)
    }

    pub(crate) fn place(&mut self, label: Label) {
        self.labels[label.0] = Some(self.here());
    }

    pub(crate) fn jump(&mut self, target: Label, cond: Cond) -> Pc {
        let pc = self.op(Op::Jump { target: 0, cond });
        self.jumps.push((pc, target));
        pc
    }

    pub(crate) fn raster(&mut self, rate: technol_image::op::Raster, end: Label) {
        let pc = self.op(Op::Raster { rate, end: 0 });
        self.jumps.push((pc, end));
    }

    pub(crate) fn module<R>(&mut self, kind: ModuleKind, file: u8, body: impl FnOnce(&mut Builder) -> R) {
        let start = self.here();
        body(self);
        self.op(Op::ModuleEnd);
        let end = self.here();
        self.program.modules.push(Module { kind, file, start, end });
    }

    pub(crate) fn main<R>(mut self, body: impl FnOnce(&mut Builder) -> R) -> Builder {
        self.module(ModuleKind::Main, 0, body);
        self
    }

    /// The module as a sequence of its own.
    pub(crate) fn block_module<R>(&mut self, kind: ModuleKind, body: impl FnOnce(&mut Builder) -> R) {
        let sequence = match kind {
            ModuleKind::BlockInit => SequenceKind::BlockInit,
            _ => SequenceKind::BlockDone,
        };
        self.module(kind, 0, |b| {
            b.sequence(sequence, body);
        });
    }

    pub(crate) fn mechanism<R>(&mut self, body: impl FnOnce(&mut Builder) -> R) -> u16 {
        self.sequence(SequenceKind::Mechanism, body)
    }

    /// Number that the next sequence will have.
    pub(crate) fn next_sequence(&self) -> u16 {
        self.program.sequences.len() as u16
    }

    fn sequence<R>(&mut self, kind: SequenceKind, body: impl FnOnce(&mut Builder) -> R) -> u16 {
        let number = self.next_sequence();
        let cells = self.next_cell;
        self.next_cell += 8;
        let start = self.op(Op::SeqBegin(number));
        self.program.sequences.push(Sequence {
            kind,
            active_addr: cells,
            active_bit: 0,
            resume_cell: cells + 2,
            wait_cell: cells + 4,
            line_cell: cells + 6,
            start,
            end: 0,
            line: 1,
            resume: vec![],
        });
        self.open = Some(number);
        body(self);
        self.open = None;
        let end = self.op(Op::SeqEnd(number));
        self.program.sequences[number as usize].end = end;
        number
    }

    /// Number and source line (ten times the number) of the next EX-type instruction.
    fn point(&mut self) -> (u16, u16) {
        let next = self.here() + 1;
        let open = self.open.expect("EX-type instructions stand in a sequence");
        let resume = &mut self.program.sequences[open as usize].resume;
        resume.push(next);
        let point = resume.len() as u16;
        (point, point * 10)
    }

    pub(crate) fn ex(&mut self) -> Pc {
        let (point, line) = self.point();
        self.op(Op::Ex { point, line })
    }

    /// EX1 (`wait_when` true) or EX0.
    pub(crate) fn ex_if(&mut self, wait_when: bool) -> Pc {
        let (point, line) = self.point();
        self.op(Op::ExIf { wait_when, point, line })
    }

    pub(crate) fn bex(&mut self) -> Pc {
        let (point, line) = self.point();
        self.op(Op::Bex { point, line })
    }

    pub(crate) fn tex(
        &mut self,
        wait_when: bool,
        counter: Addr,
        time: Source,
        error: Label,
        code: Option<i64>,
    ) -> Pc {
        self.timed(Some(wait_when), counter, time, Some(error), code)
    }

    pub(crate) fn tim(&mut self, counter: Addr, time: Source) -> Pc {
        self.timed(None, counter, time, None, None)
    }

    fn timed(
        &mut self,
        wait_when: Option<bool>,
        counter: Addr,
        time: Source,
        error: Option<Label>,
        code: Option<i64>,
    ) -> Pc {
        let (point, line) = self.point();
        let index = self.program.timed.len();
        self.program.timed.push(Timed {
            wait_when,
            count: cell(counter),
            width: Width::Word,
            time,
            error: error.map(|_| 0),
            code: code.map(|code| (Source::Int(code), Width::DWord)),
            point,
            line,
        });
        if let Some(label) = error {
            self.timed_errors.push((index, label));
        }
        self.op(Op::Timed(index as u16))
    }

    pub(crate) fn message(&mut self, message: Message, cond: Cond) -> Pc {
        let index = self.program.messages.len() as u16;
        self.program.messages.push(message);
        self.op(Op::Message { index, cond })
    }

    /// Adds a procedure behind the modules; its number is the order of these calls.
    pub(crate) fn procedure(&mut self, name: &str, body: impl IntoIterator<Item = Op>) -> u16 {
        self.procedures.push((name.into(), body.into_iter().collect()));
        self.procedures.len() as u16 - 1
    }

    pub(crate) fn edit(&mut self, change: impl FnOnce(&mut Program)) {
        change(&mut self.program);
    }

    pub(crate) fn build(mut self) -> Program {
        for (name, body) in core::mem::take(&mut self.procedures) {
            let start = self.here();
            self.ops(body);
            self.op(Op::Return);
            let end = self.here();
            self.program.procedures.push(Procedure { name, start, end });
        }
        let place = |label: Label| self.labels[label.0].expect("label placed");
        for (pc, label) in &self.jumps {
            match &mut self.program.code[*pc as usize] {
                Op::Jump { target, .. } | Op::Raster { end: target, .. } => *target = place(*label),
                other => panic!("{other:?} is no jump"),
            }
        }
        for (index, label) in &self.timed_errors {
            self.program.timed[*index].error = Some(place(*label));
        }
        self.program
    }

    pub(crate) fn load(self) -> Bench {
        Bench::new(self.build())
    }
}

/// A runtime on the bench: virtual time, inputs, and everything it reported.
#[derive(Clone)]
pub(crate) struct Bench {
    pub(crate) plc: Runtime,
    pub(crate) inputs: InputImage,
    pub(crate) events: Vec<RuntimeEvent>,
}

impl Bench {
    pub(crate) fn new(program: Program) -> Bench {
        let plc = Runtime::new(program).expect("test program is valid");
        Bench { plc, inputs: [0; 128], events: vec![] }
    }

    /// Starts cold and runs MODULE_INIT; the next tick is millisecond 0.
    pub(crate) fn started(mut self) -> Bench {
        self.command(Command::StartPlc { cold: true });
        self.tick();
        self
    }

    pub(crate) fn command(&mut self, command: Command) {
        self.plc.command(command);
    }

    pub(crate) fn tick(&mut self) -> TickOutcome {
        self.plc.tick(&self.inputs, &mut self.events)
    }

    /// Ticks until the outcome is `Stopped`; panics when that takes more than `limit` ticks.
    pub(crate) fn run_to_stop(&mut self, limit: u32) {
        for _ in 0..limit {
            if self.tick() == TickOutcome::Stopped {
                return;
            }
        }
        panic!("not stopped after {limit} ticks");
    }

    pub(crate) fn millis(&mut self, n: u64) {
        for _ in 0..n {
            assert_eq!(self.tick(), TickOutcome::Done, "{:?}", self.plc.fault());
        }
    }

    /// Runs `n` cycles, up to just before the next one.
    pub(crate) fn cycles(&mut self, n: u64) {
        self.millis(n * 20);
    }

    pub(crate) fn byte(&self, addr: Addr) -> u8 {
        self.plc.memory()[addr as usize]
    }

    pub(crate) fn word(&self, addr: Addr) -> u16 {
        let at = addr as usize;
        u16::from_le_bytes([self.plc.memory()[at], self.plc.memory()[at + 1]])
    }

    pub(crate) fn bit(&self, bit: BitRef) -> bool {
        self.byte(bit.addr) >> bit.bit & 1 != 0
    }

    pub(crate) fn set(&mut self, bit: BitRef, value: bool) {
        self.plc.write_bit(bit.addr, bit.bit, value).expect("bit in memory");
    }

    pub(crate) fn activation(&self, sequence: u16) -> BitRef {
        let sequence = &self.plc.program().sequences[sequence as usize];
        bit(sequence.active_addr, sequence.active_bit)
    }

    pub(crate) fn activate(&mut self, sequence: u16) {
        self.set(self.activation(sequence), true);
    }

    pub(crate) fn sequence(&self, sequence: u16) -> technol_runtime::SequenceState {
        self.plc.sequences().nth(sequence as usize).expect("sequence exists")
    }

    pub(crate) fn state(&self) -> PlcState {
        self.plc.state()
    }
}
