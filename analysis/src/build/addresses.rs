//! Every name of a project with its address or number, as relocation asks for them.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use technol_image::op::Addr;
use technol_image::program::{Region, RegionKind};

use super::input::ProjectInput;
use super::section_code::Slot;
use crate::catalogue::{self, SystemSymbol};
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::layout::{Layout, PlacedKind, sequence_kind, system_addr};
use crate::syntax::section::SectionKind;

/// The address of a symbol.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resolved {
    /// First byte of the symbol.
    pub(super) base: Addr,
    /// Bit number, when only the layout knows it (activation bits).
    pub(super) bit: Option<u8>,
}

/// Names, addresses and numbers.
pub(super) struct Addresses<'a> {
    /// Addresses of declared symbols.
    pub(super) layout: &'a Layout,
    system: BTreeMap<&'static str, &'static SystemSymbol>,
    regions: Vec<Region>,
    procedures: FxHashMap<&'a str, u16>,
    /// By section.
    numbers: Vec<Option<u16>>,
    nested: FxHashMap<(u16, SectionKind, &'a str, u32), usize>,
}

impl<'a> Addresses<'a> {
    /// Collects all names of `input`. Sequences and procedures are numbered in order of their sections.
    pub(super) fn new(input: &'a ProjectInput<'a>, layout: &'a Layout, regions: &[Region]) -> Self {
        let mut addresses = Addresses {
            layout,
            system: BTreeMap::new(),
            regions: regions.to_vec(),
            procedures: FxHashMap::default(),
            numbers: Vec::with_capacity(input.sections.len()),
            nested: FxHashMap::default(),
        };
        let (mut sequences, mut procedures) = (0u16, 0u16);
        for (index, section) in input.sections.iter().enumerate() {
            addresses.add_system(section.code.map_or(&[], |code| &code.slots));
            let mut number = None;
            if sequence_kind(section.kind).is_some() {
                number = Some(sequences);
                sequences = sequences.saturating_add(1);
            }
            if section.kind == SectionKind::Procedure {
                addresses.procedures.entry(section.name).or_insert(procedures);
                number = Some(procedures);
                procedures = procedures.saturating_add(1);
            }
            addresses.numbers.push(number);
            if matches!(section.kind, SectionKind::Mechanism | SectionKind::Procedure) {
                addresses.nested.insert((section.file, section.kind, section.name, section.ordinal), index);
            }
        }
        addresses
    }

    fn add_system(&mut self, slots: &[Slot]) {
        for slot in slots {
            let Slot::Symbol { key, .. } = slot else { continue };
            if key.scope != SymbolScope::System || self.system.contains_key(&*key.name) {
                continue;
            }
            if let Some(symbol) = catalogue::symbol(&key.name) {
                self.system.insert(symbol.name, symbol);
            }
        }
    }

    /// The address of a symbol.
    pub(super) fn symbol(&self, key: &SymbolKey) -> Option<Resolved> {
        if key.scope == SymbolScope::System {
            let base = system_addr(&self.system.get(&*key.name)?.kind)?;
            return Some(Resolved { base, bit: None });
        }
        let placed = self.layout.place(key)?;
        let bit = match placed.kind {
            PlacedKind::Sequence(n) => Some(self.layout.sequences.get(usize::from(n))?.active_bit),
            _ => None,
        };
        Some(Resolved { base: placed.addr, bit })
    }

    /// The region that holds an address.
    pub(super) fn region(&self, addr: Addr) -> Option<Region> {
        self.regions.iter().copied().find(|r| addr >= r.start && addr - r.start < r.len)
    }

    /// A whole region.
    pub(super) fn whole(&self, kind: RegionKind) -> Option<Region> {
        self.regions.iter().copied().find(|r| r.kind == kind)
    }

    /// Number of the procedure of that name.
    pub(super) fn procedure(&self, key: &SymbolKey) -> Option<u16> {
        self.procedures.get(&*key.name).copied()
    }

    /// Number of the sequence of the mechanism of that name.
    pub(super) fn mechanism(&self, key: &SymbolKey) -> Option<u16> {
        match self.layout.place(key)?.kind {
            PlacedKind::Sequence(n) => Some(n),
            _ => None,
        }
    }

    /// Number of a section among the sequences or procedures.
    pub(super) fn number(&self, section: usize) -> Option<u16> {
        self.numbers.get(section).copied().flatten()
    }

    /// Section of a mechanism or procedure of a file.
    pub(super) fn nested(&self, file: u16, kind: SectionKind, name: &'a str, ordinal: u32) -> Option<usize> {
        self.nested.get(&(file, kind, name, ordinal)).copied()
    }

    /// The predefined symbols that occur, by name.
    pub(super) fn into_used_system(self) -> Vec<&'static SystemSymbol> {
        self.system.into_values().collect()
    }
}
