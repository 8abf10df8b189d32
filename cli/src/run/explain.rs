//! `technol run --explain-machine`: what machine.toml wires, in words, beside what the program uses.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value as Json, json};
use technol_image::debug_info::{Scope, SymbolKind};
use technol_image::op::{Addr, Op, Place, Source, Width};
use technol_image::{DebugInfo, Program};
use technol_machine::{ChannelWiring, MachineConfig, Signal, Wire, Wiring, wiring};

use crate::arguments::Format;
use crate::out::say;

/// Prints the machine in front of a configuration of the control.
pub(super) fn explain(
    machine: &MachineConfig,
    channel: &ChannelWiring,
    program: &Program,
    debug: &DebugInfo,
    format: Format,
) {
    let explanation =
        Explanation { machine, wiring: wiring(machine, channel), uses: Uses::of(program, debug) };
    match format {
        Format::Human => explanation.human(),
        Format::Json => say!("{}", explanation.json()),
    }
}

struct Explanation<'a> {
    machine: &'a MachineConfig,
    wiring: Wiring,
    uses: Uses,
}

impl Explanation<'_> {
    fn human(&self) {
        if !self.machine.machine.name.is_empty() {
            say!("{}", self.machine.machine.name);
        }
        let is_output = |wire: &&Wire| matches!(wire.signal, Signal::Output { .. });
        let (outputs, inputs): (Vec<_>, Vec<_>) = self.wiring.drives.iter().partition(is_output);
        self.wires("What the outputs drive", &outputs);
        self.wires("What drives the inputs", &self.wiring.driven.iter().collect::<Vec<_>>());
        self.wires("What inputs drive besides the program", &inputs);
        for (title, rows) in [
            ("Analogue inputs and outputs", &self.wiring.analog),
            ("Identifiers", &self.wiring.identifiers),
            ("Buses and licences", &self.wiring.buses),
            ("Keys", &self.wiring.keys),
            ("Faults", &self.wiring.faults),
        ] {
            section(title, rows.iter().cloned());
        }
        section("Blocks", self.wiring.blocks.iter().map(|block| (block.clone(), String::new())));
        let unconnected = self.unconnected();
        let rows = unconnected.iter().cloned();
        section("Used by the program, connected to nothing", rows);
    }

    fn wires(&self, title: &str, wires: &[&Wire]) {
        let rows = wires.iter().map(|wire| {
            let name = self.uses.name(wire.signal).filter(|_| !wire.whole);
            let place = wire.place.clone();
            let place = name.map_or_else(|| place.clone(), |name| format!("{place} {name}"));
            (place, format!("{}: {}", wire.element, wire.text))
        });
        section(title, rows);
    }

    /// Signals that the program uses and no element, key or block knows, with their names.
    fn unconnected(&self) -> Vec<(String, String)> {
        let wires = self.wiring.drives.iter().chain(&self.wiring.driven);
        let known: BTreeSet<(Signal, bool)> = wires.map(|wire| (wire.signal, wire.whole)).collect();
        let connected =
            |signal: Signal| known.contains(&(signal, false)) || known.contains(&(signal.with_bit(0), true));
        let bits = self.uses.bits.iter().filter(|(signal, _)| !connected(**signal));
        let bits = bits.map(|(signal, name)| (signal.to_string(), name.clone().unwrap_or_default()));
        let ports = self.uses.ports.iter().filter(|port| !(0..8).any(|bit| connected(port.with_bit(bit))));
        bits.chain(ports.map(|port| (port.port_name(), "the whole port".to_owned()))).collect()
    }

    fn json(&self) -> Json {
        let wires = |wires: &[Wire]| {
            let rows = wires.iter().map(|wire| {
                json!({
                    "signal": wire.place,
                    "name": self.uses.name(wire.signal).filter(|_| !wire.whole),
                    "element": wire.element,
                    "text": wire.text,
                })
            });
            rows.collect::<Vec<_>>()
        };
        let pairs = |pairs: &[(String, String)]| {
            pairs.iter().map(|(name, text)| json!({ "name": name, "text": text })).collect::<Vec<_>>()
        };
        json!({
            "drives": wires(&self.wiring.drives),
            "driven": wires(&self.wiring.driven),
            "analog": pairs(&self.wiring.analog),
            "identifiers": pairs(&self.wiring.identifiers),
            "buses": pairs(&self.wiring.buses),
            "keys": pairs(&self.wiring.keys),
            "faults": pairs(&self.wiring.faults),
            "blocks": self.wiring.blocks,
            "unconnected": self.unconnected().into_iter().map(|(signal, name)| {
                json!({ "signal": signal, "name": name })
            }).collect::<Vec<_>>(),
        })
    }
}

/// A title and rows in two columns; nothing without rows.
fn section(title: &str, rows: impl Iterator<Item = (String, String)>) {
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return;
    }
    say!("");
    say!("{title}");
    let width = rows.iter().map(|(left, _)| left.chars().count()).max().unwrap_or(0);
    for (left, right) in rows {
        if right.is_empty() {
            say!("  {left}");
        } else {
            say!("  {left:width$}  {right}");
        }
    }
}

/// Port bits that a program uses.
struct Uses {
    /// Bits, with the name that the program has for them.
    bits: BTreeMap<Signal, Option<String>>,
    /// Ports (their bit 0) that are used as a whole, without names for their bits.
    ports: BTreeSet<Signal>,
}

impl Uses {
    fn of(program: &Program, debug: &DebugInfo) -> Uses {
        let mut names: BTreeMap<Addr, Vec<(u8, &str)>> = BTreeMap::new();
        for symbol in &debug.symbols {
            if let SymbolKind::Bit { addr, bit } = symbol.kind
                && symbol.scope != Scope::System
            {
                names.entry(addr).or_default().push((bit, &symbol.name));
            }
        }
        let mut uses = Uses { bits: BTreeMap::new(), ports: BTreeSet::new() };
        let mut copies: BTreeMap<Signal, BTreeSet<Addr>> = BTreeMap::new();
        for (pc, op) in program.code.iter().enumerate() {
            for (addr, bit) in bits(op) {
                if let Some(port) = Signal::of_port_at(addr) {
                    uses.bits.entry(port.with_bit(bit)).or_insert(None);
                }
            }
            for port in bytes(op)
                .into_iter()
                .flatten()
                .flat_map(|(addr, len)| addr..addr + len)
                .filter_map(Signal::of_port_at)
            {
                uses.ports.insert(port);
            }
            for (from, to, len) in copied(&program.code, pc) {
                for byte in 0..len {
                    let (from, to) = (from + byte, to + byte);
                    for (addr, other) in [(from, to), (to, from)] {
                        if let Some(port) = Signal::of_port_at(addr) {
                            copies.entry(port).or_default().insert(other);
                        }
                    }
                }
            }
        }
        // The bits of a byte that a port is copied from or to are the bits of the port.
        for (port, cells) in copies {
            for (bit, name) in cells.iter().filter_map(|cell| names.get(cell)).flatten() {
                uses.ports.remove(&port);
                uses.bits.entry(port.with_bit(*bit)).or_default().get_or_insert_with(|| (*name).to_owned());
            }
        }
        uses
    }

    fn name(&self, signal: Signal) -> Option<&str> {
        self.bits.get(&signal)?.as_deref()
    }
}

/// Bits that an operation names.
fn bits(op: &Op) -> Vec<(Addr, u8)> {
    let refs: &[_] = match op {
        Op::Ldr { bit, .. }
        | Op::Logic { bit, .. }
        | Op::Write(bit)
        | Op::Flag { bit, .. }
        | Op::Edge { bit, .. } => &[*bit],
        Op::MoveBit { dst, src, .. } => &[*dst, *src],
        _ => &[],
    };
    refs.iter().map(|bit| (bit.addr, bit.bit)).collect()
}

/// Cells that an operation names: first byte and length.
fn bytes(op: &Op) -> [Option<(Addr, u32)>; 2] {
    let cell = |place: &Place, len: u32| Some((place.addr, len));
    let source = |source: &Source, width: &Width| match source {
        Source::Mem(place) => cell(place, width.bytes()),
        _ => None,
    };
    match op {
        Op::Load { src, width, .. } | Op::Arith { src, width, .. } | Op::Compare { src, width, .. } => {
            [source(src, width), None]
        }
        Op::Store { dst, width, .. } => [cell(dst, width.bytes()), None],
        Op::Move { dst, src, width, .. } => [cell(dst, width.bytes()), cell(src, width.bytes())],
        Op::Copy { src, dst, len } => [cell(src, *len), cell(dst, *len)],
        _ => [None, None],
    }
}

/// What the operation at `pc` copies: from, to, length. A load with the stores behind it is a copy.
fn copied(code: &[Op], pc: usize) -> Vec<(Addr, Addr, u32)> {
    match code[pc] {
        Op::Load { src: Source::Mem(src), width, neg: false } => {
            let stores = code[pc + 1..].iter().map_while(|op| match op {
                Op::Store { dst, width: stored, .. } => {
                    Some((src.addr, dst.addr, width.bytes().min(stored.bytes())))
                }
                _ => None,
            });
            stores.collect()
        }
        Op::Move { dst, src, width, .. } => vec![(src.addr, dst.addr, width.bytes())],
        Op::Copy { src, dst, len } => vec![(src.addr, dst.addr, len)],
        _ => Vec::new(),
    }
}
