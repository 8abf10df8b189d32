//! Operations as text, for the listing and for the debugger's disassembly view.
//!
//! An operation reads like the instruction it came from; what the source does not show (pushes, resume points,
//! hidden cells) stands behind it in braces.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technol_image::debug_info::{DebugInfo, SymbolKind};
use technol_image::op::{Addr, BitRef, Cond, DrTest, Op, Pc, Place, Source, Width};
use technol_image::program::{Message, Program, SequenceKind, Timed};
use technol_image::service::{Arg, ServiceCall};

use technol_image::system::BLOCK_WINDOW;

use super::debug_info::memory_of;
use super::{assembler, block_names};

/// Writes operations of one program with its names.
pub struct Disassembler<'a> {
    program: &'a Program,
    bits: BTreeMap<(Addr, u8), &'a str>,
    cells: BTreeMap<Addr, Cell<'a>>,
    sequences: BTreeMap<u16, &'a str>,
}

struct Cell<'a> {
    name: &'a str,
    len: u32,
    /// Declared type; a prefix is written when an access has another one.
    width: Option<Width>,
}

impl<'a> Disassembler<'a> {
    /// A disassembler; without debug information it writes addresses instead of names.
    #[must_use]
    pub fn new(program: &'a Program, debug: Option<&'a DebugInfo>) -> Self {
        let mut this = Disassembler {
            program,
            bits: BTreeMap::new(),
            cells: BTreeMap::new(),
            sequences: BTreeMap::new(),
        };
        for symbol in debug.iter().flat_map(|d| &d.symbols) {
            let name = symbol.name.as_str();
            match symbol.kind {
                SymbolKind::Bit { addr, bit } => {
                    this.bits.entry((addr, bit)).or_insert(name);
                }
                SymbolKind::Mechanism { sequence } => {
                    if let Some(cells) = program.sequences.get(usize::from(sequence)) {
                        this.bits.entry((cells.active_addr, cells.active_bit)).or_insert(name);
                    }
                }
                SymbolKind::Cell { addr, width } => {
                    this.cells.entry(addr).or_insert(Cell { name, len: width.bytes(), width: Some(width) });
                }
                SymbolKind::Area { .. } | SymbolKind::Text { .. } => {
                    if let Some((addr, len)) = memory_of(&symbol.kind) {
                        this.cells.entry(addr).or_insert(Cell { name, len, width: None });
                    }
                }
                _ => {}
            }
        }
        for mechanism in debug.iter().flat_map(|d| &d.mechanisms) {
            this.sequences.insert(mechanism.sequence, &mechanism.name);
        }
        this
    }

    /// The operation at `pc`; `None` past the end of the code.
    #[must_use]
    pub fn at(&self, pc: Pc) -> Option<String> {
        Some(self.op(self.program.code.get(pc as usize)?))
    }

    /// An operation as text.
    #[must_use]
    pub fn op(&self, op: &Op) -> String {
        match op {
            Op::Nop => "NOP".to_owned(),
            Op::Ldr { bit, neg, push } => {
                format!("LDR {}{}{}", sign(*neg), self.bit(bit), if *push { " {push}" } else { "" })
            }
            Op::Logic { op, bit, neg } => format!("{} {}{}", op.mnemonic(), sign(*neg), self.bit(bit)),
            Op::LogicPop(op) => format!("{} {{pop}}", op.mnemonic()),
            Op::Complement => "CA".to_owned(),
            Op::Edge { rising, bit, state } => {
                format!("EDGE_{} {} {{state {state:04X}h}}", if *rising { 'H' } else { 'L' }, self.bit(bit))
            }
            Op::Write(bit) => format!("WR {}", self.bit(bit)),
            Op::Flag { value, bit, cond } => {
                format!("FL{} {},{}", suffix(*cond), u8::from(*value), self.bit(bit))
            }
            Op::MoveBit { dst, src, neg, cond } => {
                format!("MOVR{} {},{}{}", suffix(*cond), self.bit(dst), sign(*neg), self.bit(src))
            }
            Op::Jump { target, cond } => format!("{} {target:04X}h", jump(*cond)),
            Op::AssemblerJump { condition, target } => {
                format!("{} {target:04X}h", assembler::jump(*condition))
            }
            Op::Raster { rate, end } => format!("{} {end:04X}h", rate.mnemonic()),
            Op::Timer { count, width } => format!("TM {}", self.place(*count, *width)),
            Op::Counter { op, count, width, state } => {
                format!("{} {} {{state {state:04X}h}}", op.mnemonic(), self.place(*count, *width))
            }
            Op::Copy { src, dst, len } => format!("MV {},{},{len}", self.area(*src), self.area(*dst)),
            Op::Clear { addr, len } => {
                let last = addr.saturating_add(len.saturating_sub(1));
                format!(
                    "CLEAR {} {{{addr:04X}h..{last:04X}h}}",
                    self.area(Place { addr: *addr, indexed: false })
                )
            }
            Op::Call(_)
            | Op::Return
            | Op::SeqBegin(_)
            | Op::SeqEnd(_)
            | Op::SeqInit(_)
            | Op::Ex { .. }
            | Op::ExIf { .. }
            | Op::Bex { .. }
            | Op::Timed(_)
            | Op::Message { .. }
            | Op::InitFinished(_)
            | Op::DoneFinished(_)
            | Op::ModuleEnd => self.structure(op),
            _ => self.register(op),
        }
    }

    fn register(&self, op: &Op) -> String {
        match op {
            Op::Load { src, width, neg } => format!("LOD {}{}", sign(*neg), self.source(src, *width)),
            Op::Store { dst, width, cond } => format!("STO{} {}", suffix(*cond), self.place(*dst, *width)),
            Op::Move { dst, src, width, cond } => {
                format!("MOVE{} {},{}", suffix(*cond), self.place(*dst, *width), self.place(*src, *width))
            }
            Op::Arith { op, src, width } => format!("{} {}", op.mnemonic(), self.source(src, *width)),
            Op::Compare { op, src, width, if_rlo } => {
                format!("{}{} {}", op.mnemonic(), if *if_rlo { "1" } else { "" }, self.source(src, *width))
            }
            Op::Unary { op, width } => format!("{}{}", op.mnemonic(), width_keyword(*width)),
            Op::IncrementBcd => "INRBCD".to_owned(),
            Op::BcdToBin(width) => format!("BIN{}", width_keyword(*width)),
            Op::BinToBcd(width) => format!("BCD{}", width_keyword(*width)),
            Op::Shift { left, count, width } => {
                let keyword = width_keyword(*width);
                let comma = if keyword.is_empty() { "" } else { "," };
                let count = self.source(count, Width::Byte);
                format!("{} {count}{comma}{}", if *left { "RL" } else { "RR" }, keyword.trim_start())
            }
            Op::DrToRlo(DrTest::NonZero(width)) => format!("CONDR{}", width_keyword(*width)),
            Op::DrToRlo(DrTest::Bit(bit)) => format!("CONDR {bit}"),
            Op::RloToDr(width) => format!("CONRD{}", width_keyword(*width)),
            Op::IntToReal(width) => format!("REAL{}", width_keyword(*width)),
            Op::IndexFromDr => "MOV BX,CX".to_owned(),
            Op::SelectBlock { offset, len } => format!("{{BLK[BX]: {len} bytes at {offset}}}"),
            Op::Assembler { function, width, to, from } => {
                let cell = |place| self.place(place, *width);
                assembler::text(*function, *to, *from, cell)
            }
            other => format!("{other:?}"),
        }
    }

    fn structure(&self, op: &Op) -> String {
        match op {
            Op::Call(n) => {
                let name = self.program.procedures.get(usize::from(*n)).map_or("?", |p| p.name.as_str());
                format!("PROC_CALL {name}")
            }
            Op::Return => "PROC_END".to_owned(),
            Op::SeqBegin(n) => self.sequence_line(*n, "MECH_BEGIN ", ""),
            Op::SeqEnd(n) => self.sequence_line(*n, "MECH_END ", "_END"),
            Op::SeqInit(n) => format!("MECH_INIT {}", self.sequence(*n)),
            Op::Ex { point, .. } => format!("EX {{{point}}}"),
            Op::ExIf { wait_when, point, .. } => format!("EX{} {{{point}}}", u8::from(*wait_when)),
            Op::Bex { point, .. } => format!("BEX {{{point}}}"),
            Op::Timed(n) => {
                self.program.timed.get(usize::from(*n)).map_or("TEX ?".to_owned(), |t| self.timed(t))
            }
            Op::Message { index, cond } => {
                let message = self.program.messages.get(usize::from(*index));
                let parameters = message.map_or(" ?".to_owned(), |m| self.message(m));
                format!("ESET{}{parameters}", suffix(*cond))
            }
            Op::Service(index) => {
                self.program.services.get(usize::from(*index)).map_or("?".to_owned(), |call| self.call(call))
            }
            Op::InitFinished(_) => "MODULE_INIT_FINISHED".to_owned(),
            Op::DoneFinished(_) => "MODULE_DONE_FINISHED".to_owned(),
            Op::ModuleEnd => "{module end}".to_owned(),
            other => format!("{other:?}"),
        }
    }

    fn timed(&self, timed: &Timed) -> String {
        let mnemonic = match timed.wait_when {
            None => "TIM",
            Some(false) => "TEX0",
            Some(true) => "TEX1",
        };
        let mut text = format!(
            "{mnemonic} {},{}",
            self.place(timed.count, timed.width),
            self.source(&timed.time, timed.width)
        );
        if let Some(error) = timed.error {
            let _ = write!(text, ",{error:04X}h");
        }
        if let Some((code, width)) = &timed.code {
            let _ = write!(text, ",{}", self.source(code, *width));
        }
        let _ = write!(text, " {{{}}}", timed.point);
        text
    }

    fn message(&self, message: &Message) -> String {
        let value =
            |v: &Option<(Source, Width)>| v.as_ref().map_or("-".to_owned(), |(s, w)| self.source(s, *w));
        let mut parts = vec![value(&message.number), value(&message.sub_id)];
        parts.push(if message.set { "-".to_owned() } else { "0".to_owned() });
        parts.extend(message.parameters.iter().map(value));
        while parts.last().is_some_and(|p| p == "-") {
            parts.pop();
        }
        if parts.is_empty() { String::new() } else { format!(" {}", parts.join(",")) }
    }

    fn call(&self, call: &ServiceCall) -> String {
        let arg = |arg: &Arg| match arg {
            Arg::Missing => "-".to_owned(),
            Arg::Int(value) => value.to_string(),
            Arg::Real(value) => format!("{value:?}"),
            Arg::Text(bytes) => format!("'{}'", bytes.escape_ascii()),
            Arg::Keyword(word) => word.clone(),
            Arg::Cell { place, width, neg } => format!("{}{}", sign(*neg), self.place(*place, *width)),
            Arg::Bit { bit, neg } => format!("{}{}", sign(*neg), self.bit(bit)),
            Arg::Area { place, .. } => self.area(*place),
            Arg::Procedure(n) => {
                self.program.procedures.get(usize::from(*n)).map_or("?", |p| p.name.as_str()).to_owned()
            }
        };
        let args: Vec<String> = call.args.iter().map(arg).collect();
        format!("{} {}", call.service.name(), args.join(",")).trim_end().to_owned()
    }

    fn sequence(&self, n: u16) -> String {
        self.sequences.get(&n).map_or_else(|| format!("{{{n}}}"), |name| (*name).to_owned())
    }

    fn sequence_line(&self, n: u16, mechanism: &str, module: &str) -> String {
        let sequence = self.program.sequences.get(usize::from(n));
        match sequence.map(|s| s.kind) {
            Some(SequenceKind::BlockInit | SequenceKind::BlockDone) => {
                format!("{}{module}", self.sequence(n))
            }
            _ => format!("{mechanism}{}", self.sequence(n)),
        }
    }

    /// A bit as text.
    #[must_use]
    pub fn bit(&self, bit: &BitRef) -> String {
        match self.bits.get(&(bit.addr, bit.bit)) {
            Some(name) if !bit.indexed => (*name).to_owned(),
            _ if bit.addr == BLOCK_WINDOW => format!("{{BLK[BX]}}.{}", bit.bit),
            _ => {
                if let Some(name) = block_names::bit(bit.addr, bit.bit) {
                    return name;
                }
                let place = Place { addr: bit.addr, indexed: bit.indexed };
                format!("{}.{}", self.area(place), bit.bit)
            }
        }
    }

    fn source(&self, source: &Source, width: Width) -> String {
        match source {
            Source::Mem(place) => self.place(*place, width),
            Source::Int(value) => value.to_string(),
            Source::Real(value) => format!("{value:?}"),
        }
    }

    /// A cell as text, with a prefix when its declared type is another one.
    fn place(&self, place: Place, width: Width) -> String {
        if place.addr == BLOCK_WINDOW {
            return format!("{{BLK[BX]}}.{}", prefix(width));
        }
        if let Some((number, name)) = block_names::cell(place.addr) {
            return format!("BLK[{number}].{}.{name}", prefix(width));
        }
        let declared = self.cells.get(&place.addr).and_then(|cell| cell.width);
        let name = self.area(place);
        if declared == Some(width) { name } else { format!("{}.{name}", prefix(width)) }
    }

    /// An address as text: a name, a name and an offset, or a number.
    fn area(&self, place: Place) -> String {
        let index = if place.indexed { "[BX]" } else { "" };
        let nearest = self.cells.range(..=place.addr).next_back();
        match nearest {
            Some((start, cell)) if *start == place.addr => format!("{}{index}", cell.name),
            Some((start, cell)) if place.addr - start < cell.len => {
                format!("({}{index}+{})", cell.name, place.addr - start)
            }
            _ => format!("{:04X}h{index}", place.addr),
        }
    }
}

fn sign(negative: bool) -> &'static str {
    if negative { "-" } else { "" }
}

fn suffix(cond: Cond) -> &'static str {
    match cond {
        Cond::Always => "",
        Cond::IfRlo => "1",
        Cond::IfNotRlo => "0",
    }
}

fn jump(cond: Cond) -> &'static str {
    match cond {
        Cond::Always => "JUM",
        Cond::IfRlo => "JL1",
        Cond::IfNotRlo => "JL0",
    }
}

/// The prefix that names a type.
pub(super) fn prefix(width: Width) -> &'static str {
    match width {
        Width::Byte => "BYTE",
        Width::Word => "WORD",
        Width::DWord => "DWRD",
        Width::QWord => "QWRD",
        Width::Real => "REAL",
    }
}

/// Keyword operand of instructions that work on 16 bits without one.
fn width_keyword(width: Width) -> &'static str {
    match width {
        Width::Byte => " BYTE",
        Width::Word => "",
        Width::DWord => " DWRD",
        Width::QWord => " QWRD",
        Width::Real => " REAL",
    }
}
