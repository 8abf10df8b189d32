//! Which input and output ports a program uses, and what it calls their bits.
//!
//! A PLC program copies ports into declared bytes and bits (or back) before it works with them; those declared
//! names tell the user more than `P1IN.3`.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use technol_image::Program;
use technol_image::debug_info::{DebugInfo, Scope, SymbolKind};
use technol_image::op::{Addr, BitRef, Op, Place, Source, Width};
use technol_image::{Signal, system};

use crate::forcing::{MASKS, MASKS_LEN};

/// A port that the program uses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Port {
    pub(crate) addr: Addr,
    pub(crate) name: String,
    /// What the program calls its bits.
    pub(crate) bits: [Option<String>; 8],
}

/// Ports in ascending order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Ports {
    pub(crate) inputs: Vec<Port>,
    pub(crate) outputs: Vec<Port>,
    /// Declared bits that are copied from or to bits of ports.
    pub(crate) copies: Copies,
    /// The program names forcing masks, so it may force ports itself.
    pub(crate) forces: bool,
}

/// Byte and bit of declared data, and the bits of ports.
pub(crate) type Copies = BTreeMap<(Addr, u8), BTreeSet<(Addr, u8)>>;

impl Ports {
    /// A port's name.
    pub(crate) fn name(&self, port: Addr) -> String {
        self.port(port).map_or_else(|| port_name(port), |p| p.name.clone())
    }

    /// What the program calls a bit of a port.
    pub(crate) fn bit_name(&self, port: Addr, bit: u8) -> Option<&str> {
        self.port(port)?.bits.get(usize::from(bit))?.as_deref()
    }

    fn port(&self, addr: Addr) -> Option<&Port> {
        self.inputs.iter().chain(&self.outputs).find(|p| p.addr == addr)
    }
}

type Names = HashMap<(Addr, u8), String>;
type Bits = BTreeMap<Addr, [Option<String>; 8]>;

#[derive(Default)]
struct Found {
    bits: Bits,
    copies: Copies,
}

/// Collects the ports from code and symbols.
pub(crate) fn used(program: &Program, debug: &DebugInfo) -> Ports {
    let names = bit_names(debug);
    let mut found = Found::default();
    let mut forces = false;
    let masks = MASKS..MASKS + MASKS_LEN;
    for op in &program.code {
        for addr in touched(op) {
            forces |= masks.contains(&addr);
            if is_port(addr) {
                found.bits.entry(addr).or_default();
            }
        }
    }
    for (n, op) in program.code.iter().enumerate() {
        note_copy(op, program.code.get(n + 1), &names, &mut found);
    }
    let spelled: HashMap<Addr, &str> = debug
        .symbols
        .iter()
        .filter(|s| s.scope == Scope::System)
        .filter_map(|s| match s.kind {
            SymbolKind::Cell { addr, width: Width::Byte } if is_port(addr) => Some((addr, s.name.as_str())),
            _ => None,
        })
        .collect();
    let mut ports = Ports { copies: found.copies, forces, ..Ports::default() };
    for (addr, bits) in found.bits {
        let name = spelled.get(&addr).map_or_else(|| port_name(addr), |n| (*n).to_owned());
        let port = Port { addr, name, bits };
        if is_output(addr) { ports.outputs.push(port) } else { ports.inputs.push(port) }
    }
    ports
}

pub(crate) fn is_output(addr: Addr) -> bool {
    matches!(Signal::of_port_at(addr), Some(Signal::Output { .. }))
}

pub(crate) fn is_port(addr: Addr) -> bool {
    Signal::of_port_at(addr).is_some()
}

fn port_name(port: Addr) -> String {
    Signal::of_port_at(port).map(Signal::port_name).unwrap_or_default()
}

fn bit_names(debug: &DebugInfo) -> Names {
    let mut names = Names::new();
    for symbol in debug.symbols.iter().filter(|s| s.scope != Scope::System) {
        if let SymbolKind::Bit { addr, bit } = symbol.kind {
            names.entry((addr, bit)).or_insert_with(|| symbol.name.clone());
        }
    }
    names
}

/// Byte addresses an operation works on.
fn touched(op: &Op) -> Vec<Addr> {
    let place = |p: &Place, width: Width| (p.addr..p.addr.saturating_add(width.bytes())).collect::<Vec<_>>();
    match op {
        Op::Ldr { bit, .. }
        | Op::Logic { bit, .. }
        | Op::Edge { bit, .. }
        | Op::Write(bit)
        | Op::Flag { bit, .. } => {
            vec![bit.addr]
        }
        Op::MoveBit { dst, src, .. } => vec![dst.addr, src.addr],
        Op::Load { src: Source::Mem(p), width, .. }
        | Op::Arith { src: Source::Mem(p), width, .. }
        | Op::Compare { src: Source::Mem(p), width, .. }
        | Op::Store { dst: p, width, .. } => place(p, *width),
        Op::Move { dst, src, width, .. } => [place(dst, *width), place(src, *width)].concat(),
        Op::Copy { src, dst, len } => {
            let len = (*len).min(system::IN_PORT_COUNT);
            (src.addr..src.addr.saturating_add(len)).chain(dst.addr..dst.addr.saturating_add(len)).collect()
        }
        _ => Vec::new(),
    }
}

/// Recognises copies between a port and declared data: one bit, or whole bytes.
fn note_copy(op: &Op, next: Option<&Op>, names: &Names, found: &mut Found) {
    match (op, next) {
        (Op::Ldr { bit, neg: false, .. }, Some(Op::Write(dst))) => note_bit(*bit, *dst, names, found),
        (Op::MoveBit { dst, src, neg: false, .. }, _) => note_bit(*src, *dst, names, found),
        (
            Op::Load { src: Source::Mem(src), width, neg: false },
            Some(Op::Store { dst, width: stored, .. }),
        ) if width == stored => {
            note_bytes(*src, *dst, width.bytes(), names, found);
        }
        (Op::Move { dst, src, width, .. }, _) => note_bytes(*src, *dst, width.bytes(), names, found),
        (Op::Copy { src, dst, len }, _) => {
            note_bytes(*src, *dst, (*len).min(system::IN_PORT_COUNT), names, found);
        }
        _ => {}
    }
}

fn note_bit(src: BitRef, dst: BitRef, names: &Names, found: &mut Found) {
    for (port, other) in [(src, dst), (dst, src)] {
        if is_port(port.addr) && !is_port(other.addr) && !(port.indexed || other.indexed) {
            let (at, copy) = ((port.addr, port.bit & 7), (other.addr, other.bit & 7));
            found.copies.entry(copy).or_default().insert(at);
            if let (Some(bits), Some(name)) = (found.bits.get_mut(&port.addr), names.get(&copy)) {
                bits[usize::from(at.1)].get_or_insert_with(|| name.clone());
            }
        }
    }
}

fn note_bytes(src: Place, dst: Place, len: u32, names: &Names, found: &mut Found) {
    for byte in 0..len {
        for bit in 0..8 {
            let at = |p: Place| BitRef { addr: p.addr.saturating_add(byte), bit, indexed: p.indexed };
            note_bit(at(src), at(dst), names, found);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn ports_carry_the_names_of_what_they_are_copied_to() {
        let sample = sample::image();
        let debug = sample.debug.as_ref().unwrap();
        let ports = used(&sample.program, debug);
        let name = |port: &Port, bit: usize| port.bits[bit].clone();
        assert_eq!(ports.inputs.len(), 1);
        assert_eq!(ports.inputs[0].name, "P1IN");
        assert_eq!(name(&ports.inputs[0], 0), Some("KSMP".into()));
        assert_eq!(name(&ports.inputs[0], 1), Some("KSMM".into()));
        assert_eq!(name(&ports.inputs[0], 2), None);
        assert_eq!(ports.outputs.len(), 1);
        assert_eq!(ports.outputs[0].name, "P0OUT");
        assert_eq!(name(&ports.outputs[0], 4), Some("SMP".into()));
    }
}
