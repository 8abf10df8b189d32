//! Where every symbol lies in PLC memory.
//!
//! ```text
//! System   0000h …        interface cells; fixed by the image format and the catalogue
//! Global   8000h …        DATA of the files in execution order, then the activation bits of the sequences, packed
//!                         into bytes, then three WORDs for each sequence: continuation, wait, line
//! Local    after it       DATA_LOCAL of the files in execution order; automatic counters follow (added by `build`)
//! Hidden   after it       edge and counter states (added by `build`)
//! ```
//!
//! Cells are packed in order of declaration without gaps, so that `name+n` arithmetic over neighbouring cells
//! means what it meant in the assembler (manual 3.3, 3.5). The layout depends on declarations only: typing in the
//! code of a mechanism leaves it equal.

use std::sync::Arc;

use rustc_hash::FxHashMap;
use technol_image::op::{Addr, Width};
use technol_image::program::{InitialData, ModuleKind, SequenceKind};
use technol_image::system;

use crate::catalogue::{self, SystemKind};
use crate::semantics::declarations::{Declarations, What};
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::syntax::ast;
use crate::syntax::section::SectionKind;

/// Largest length of the global and of the local region in bytes.
pub const MAX_REGION: u32 = 0x0010_0000;
/// Largest number of mechanisms and block modules in a project.
pub const MAX_SEQUENCES: usize = u16::MAX as usize;

/// One section as the layout sees it.
#[derive(Clone, Copy, Debug)]
pub struct DataBlock<'a> {
    /// What it is: DATA_LOCAL goes to the local region, a mechanism or block module gets sequence cells.
    pub kind: SectionKind,
    /// Key of its name (mechanisms).
    pub name: &'a str,
    /// 0-based file it belongs to, in execution order; an included file belongs to the file that includes it.
    pub file: u8,
    /// What its lines declare.
    pub declarations: &'a Declarations,
}

impl DataBlock<'_> {
    /// Who owns the memory it declares.
    #[must_use]
    pub fn scope(&self) -> SymbolScope {
        if self.kind == SectionKind::DataLocal { SymbolScope::File(self.file) } else { SymbolScope::Global }
    }
}

/// A symbol in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed {
    /// First byte (for a bit: the byte that holds it).
    pub addr: Addr,
    /// Length in bytes (1 for a bit).
    pub len: u32,
    /// What lies there.
    pub kind: PlacedKind,
}

/// What lies at a symbol's address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlacedKind {
    /// A bit, 0..=7.
    Bit(u8),
    /// A cell of a declared type.
    Cell(Width),
    /// An area without type.
    Area,
    /// A text buffer: this many characters, then a zero.
    Text(u32),
    /// The activation bit of a sequence: index into [`Layout::sequences`].
    Sequence(u16),
}

/// Cells of a mechanism or block module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SequenceCells {
    /// What it is.
    pub kind: SequenceKind,
    /// Key of the mechanism's name, or the keyword that opens the module.
    pub name: Arc<str>,
    /// Byte of the activation bit.
    pub active_addr: Addr,
    /// Activation bit, 0..=7.
    pub active_bit: u8,
    /// WORD: continuation.
    pub resume_cell: Addr,
    /// WORD: resume point whose counter runs.
    pub wait_cell: Addr,
    /// WORD: `name_LINE`.
    pub line_cell: Addr,
}

/// Declared data do not fit into memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overflow {
    /// Index of the block, as given to [`Layout::compute`].
    pub block: usize,
    /// 0-based own line of the declaration that no longer fits; 0 when sequence cells do not fit.
    pub line: u32,
    /// What is too long, in words.
    pub message: String,
}

/// Addresses of all declared symbols.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    places: FxHashMap<SymbolKey, Placed>,
    /// Mechanisms and block modules in order of their sections; the index is the sequence number of the image.
    pub sequences: Vec<SequenceCells>,
    /// Texts that memory starts with.
    pub initial: Vec<InitialData>,
    /// Length of the global region.
    pub global_len: u32,
    /// Length of DATA_LOCAL of all files.
    pub local_len: u32,
    /// The first declaration that did not fit.
    pub overflow: Option<Overflow>,
}

/// Which kind of sequence a section is, if it is one.
#[must_use]
pub const fn sequence_kind(kind: SectionKind) -> Option<SequenceKind> {
    match kind {
        SectionKind::Mechanism => Some(SequenceKind::Mechanism),
        SectionKind::Module(ModuleKind::BlockInit) => Some(SequenceKind::BlockInit),
        SectionKind::Module(ModuleKind::BlockDone) => Some(SequenceKind::BlockDone),
        _ => None,
    }
}

/// Key of the cell that holds the line of a mechanism's state.
#[must_use]
pub fn line_key(mechanism: &str) -> String {
    ast::key(&format!("{mechanism}_LINE"))
}

impl Layout {
    /// Lays out `blocks`, given in execution order of their files and in source order within a file.
    #[must_use]
    pub fn compute(blocks: &[DataBlock<'_>]) -> Layout {
        let mut layout = Layout::default();
        let data_len = layout.measure(blocks);
        let count = blocks.iter().filter(|b| sequence_kind(b.kind).is_some()).count();
        let mut next = Cursors { global: system::LEN, local: system::LEN + layout.global_len };
        if layout.overflow.is_some() {
            return layout;
        }
        layout.place_sequences(blocks, system::LEN + data_len, count);
        for block in blocks {
            layout.place_block(block, &mut next);
        }
        for block in blocks {
            layout.place_overlays(block);
        }
        layout
    }

    /// Address of a declared symbol, of a mechanism's activation bit or of its `name_LINE` cell.
    #[must_use]
    pub fn place(&self, key: &SymbolKey) -> Option<Placed> {
        self.places.get(key).copied()
    }

    /// First byte of the local region.
    #[must_use]
    pub fn local_start(&self) -> Addr {
        system::LEN + self.global_len
    }

    /// Sets the lengths of both regions; returns the length of the declared global data.
    fn measure(&mut self, blocks: &[DataBlock<'_>]) -> u32 {
        let (mut global, mut local) = (0u64, 0u64);
        for (index, block) in blocks.iter().enumerate() {
            let (total, region) = match block.kind {
                SectionKind::DataLocal => (&mut local, "local"),
                _ => (&mut global, "global"),
            };
            for (storage, piece) in block.declarations.storage.iter().enumerate() {
                *total += u64::from(piece.len);
                if *total > u64::from(MAX_REGION) && self.overflow.is_none() {
                    let message = format!(
                        "the {region} data are longer than {MAX_REGION} bytes, which is all there is"
                    );
                    let line = line_of_storage(block.declarations, storage);
                    self.overflow = Some(Overflow { block: index, line, message });
                }
            }
        }
        let sequences: Vec<usize> =
            (0..blocks.len()).filter(|i| sequence_kind(blocks[*i].kind).is_some()).collect();
        let cells = sequences.len().div_ceil(8) as u64 + sequences.len() as u64 * 6;
        if self.overflow.is_none() {
            if let Some(block) = sequences.get(MAX_SEQUENCES) {
                let message = format!("a project has at most {MAX_SEQUENCES} mechanisms");
                self.overflow = Some(Overflow { block: *block, line: 0, message });
            } else if global + cells > u64::from(MAX_REGION) {
                let block = sequences.last().copied().unwrap_or_default();
                let message = format!(
                    "the cells of the mechanisms do not fit into the {MAX_REGION} bytes of global data"
                );
                self.overflow = Some(Overflow { block, line: 0, message });
            }
        }
        self.global_len = clamp(global + cells);
        self.local_len = clamp(local);
        clamp(global)
    }

    fn place_sequences(&mut self, blocks: &[DataBlock<'_>], start: Addr, count: usize) {
        let words = start + count.div_ceil(8) as u32;
        for block in blocks {
            let Some(kind) = sequence_kind(block.kind) else { continue };
            let n = self.sequences.len() as u32;
            let cell = words + n * 6;
            let name: Arc<str> = match block.kind {
                SectionKind::Module(module) => module.keyword().into(),
                _ => block.name.into(),
            };
            let cells = SequenceCells {
                kind,
                name: Arc::clone(&name),
                active_addr: start + n / 8,
                active_bit: (n % 8) as u8,
                resume_cell: cell,
                wait_cell: cell + 2,
                line_cell: cell + 4,
            };
            if kind == SequenceKind::Mechanism {
                let line = SymbolKey { scope: SymbolScope::Global, name: line_key(&name).into() };
                let placed = Placed { addr: cells.line_cell, len: 2, kind: PlacedKind::Cell(Width::Word) };
                self.places.entry(line).or_insert(placed);
                let placed = Placed { addr: cells.active_addr, len: 1, kind: PlacedKind::Sequence(n as u16) };
                self.places.entry(SymbolKey { scope: SymbolScope::Global, name }).or_insert(placed);
            }
            self.sequences.push(cells);
        }
    }

    fn place_block(&mut self, block: &DataBlock<'_>, next: &mut Cursors) {
        let scope = block.scope();
        let cursor = if block.kind == SectionKind::DataLocal { &mut next.local } else { &mut next.global };
        let mut starts = Vec::with_capacity(block.declarations.storage.len());
        for piece in &block.declarations.storage {
            starts.push(*cursor);
            if let Some(bytes) = &piece.initial {
                let mut bytes = bytes.clone();
                bytes.truncate(piece.len as usize);
                self.initial.push(InitialData { addr: *cursor, bytes });
            }
            *cursor += piece.len;
        }
        for declared in &block.declarations.names {
            let at = |storage: u32| {
                let addr = *starts.get(storage as usize)?;
                Some((addr, block.declarations.storage.get(storage as usize)?.len))
            };
            let placed = match declared.what {
                What::Bit { storage, bit } => {
                    at(storage).map(|(addr, _)| Placed { addr, len: 1, kind: PlacedKind::Bit(bit) })
                }
                What::Cell { storage } => {
                    at(storage).map(|(addr, len)| Placed { addr, len, kind: cell_kind(len) })
                }
                What::Area { storage } | What::Typed { storage, array: true, .. } => {
                    at(storage).map(|(addr, len)| Placed { addr, len, kind: PlacedKind::Area })
                }
                What::Typed { storage, element, array: false } => {
                    at(storage).map(|(addr, len)| Placed { addr, len, kind: PlacedKind::Cell(element) })
                }
                What::Text { storage: Some(storage), len: characters, .. } => {
                    at(storage).map(|(addr, len)| Placed { addr, len, kind: PlacedKind::Text(characters) })
                }
                _ => None,
            };
            if let Some(placed) = placed {
                self.places.entry(SymbolKey { scope, name: declared.name.key().into() }).or_insert(placed);
            }
        }
    }

    fn place_overlays(&mut self, block: &DataBlock<'_>) {
        for declared in &block.declarations.names {
            let What::Text { storage: None, over: Some(over), len } = &declared.what else { continue };
            let base = named_addr(&self.places, block.file, &over.symbol);
            let addr = base.and_then(|base| Addr::try_from(i64::from(base).checked_add(over.offset)?).ok());
            if let Some(addr) = addr {
                let placed = Placed { addr, len: len.saturating_add(1), kind: PlacedKind::Text(*len) };
                let key = SymbolKey { scope: block.scope(), name: declared.name.key().into() };
                self.places.entry(key).or_insert(placed);
            }
        }
    }
}

/// A symbol as an overlay names it: local to the file, else global, else predefined.
fn named_addr(places: &FxHashMap<SymbolKey, Placed>, file: u8, name: &str) -> Option<Addr> {
    let find = |scope| places.get(&SymbolKey { scope, name: name.into() }).map(|p| p.addr);
    find(SymbolScope::File(file))
        .or_else(|| find(SymbolScope::Global))
        .or_else(|| system_addr(&catalogue::symbol(name)?.kind))
}

/// First byte of a predefined symbol; `None` for one without memory.
#[must_use]
pub const fn system_addr(kind: &SystemKind) -> Option<Addr> {
    match *kind {
        SystemKind::Bit { addr, .. }
        | SystemKind::Cell { addr, .. }
        | SystemKind::Array { addr, .. }
        | SystemKind::Area { addr, .. } => Some(addr),
        SystemKind::FormalBit { .. } | SystemKind::Member { .. } | SystemKind::Constant(_) => None,
    }
}

/// Next free byte of the regions.
struct Cursors {
    global: Addr,
    local: Addr,
}

fn cell_kind(len: u32) -> PlacedKind {
    match len {
        1 => PlacedKind::Cell(Width::Byte),
        2 => PlacedKind::Cell(Width::Word),
        4 => PlacedKind::Cell(Width::DWord),
        _ => PlacedKind::Area,
    }
}

fn clamp(len: u64) -> u32 {
    u32::try_from(len).unwrap_or(u32::MAX).min(MAX_REGION)
}

fn line_of_storage(declarations: &Declarations, wanted: usize) -> u32 {
    let of = |what: &What| match what {
        What::Bit { storage, .. }
        | What::Cell { storage }
        | What::Area { storage }
        | What::Typed { storage, .. } => Some(*storage as usize),
        What::Text { storage, .. } => storage.map(|s| s as usize),
        _ => None,
    };
    declarations.names.iter().find(|d| of(&d.what) == Some(wanted)).map_or(0, |d| d.line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::semantics::declarations::{Declared, Overlay, Storage};
    use crate::syntax::ast::Name;

    fn named(name: &str, line: u32, what: What) -> Declared {
        Declared { name: Name { text: name.into(), columns: 0..name.len() as u32 }, line, what }
    }

    fn data(lens: &[u32], names: Vec<Declared>) -> Declarations {
        let storage = lens.iter().map(|len| Storage { len: *len, initial: None }).collect();
        Declarations { storage, names, ..Declarations::default() }
    }

    fn mechanism(name: &str) -> Declarations {
        data(&[], vec![named(name, 0, What::Mechanism)])
    }

    fn block<'a>(
        kind: SectionKind,
        name: &'a str,
        file: u8,
        declarations: &'a Declarations,
    ) -> DataBlock<'a> {
        DataBlock { kind, name, file, declarations }
    }

    fn global(name: &str) -> SymbolKey {
        SymbolKey { scope: SymbolScope::Global, name: name.into() }
    }

    #[test]
    fn data_of_files_follow_each_other_without_gaps() {
        let first = data(
            &[1, 4, 30],
            vec![
                named("Alfa", 1, What::Cell { storage: 0 }),
                named("BETA", 2, What::Cell { storage: 1 }),
                named("GAMA", 3, What::Area { storage: 2 }),
            ],
        );
        let second = data(
            &[1, 2],
            vec![
                named("PAM", 1, What::Cell { storage: 0 }),
                named("ON", 1, What::Bit { storage: 0, bit: 5 }),
                named("CNT", 2, What::Cell { storage: 1 }),
            ],
        );
        let blocks = [block(SectionKind::Data, "", 0, &first), block(SectionKind::Data, "", 1, &second)];
        let layout = Layout::compute(&blocks);
        let place = |name| layout.place(&global(name)).map(|p| (p.addr, p.len, p.kind));
        assert_eq!(place("ALFA"), Some((0x8000, 1, PlacedKind::Cell(Width::Byte))));
        assert_eq!(place("BETA"), Some((0x8001, 4, PlacedKind::Cell(Width::DWord))));
        assert_eq!(place("GAMA"), Some((0x8005, 30, PlacedKind::Area)));
        assert_eq!(place("PAM"), Some((0x8023, 1, PlacedKind::Cell(Width::Byte))));
        assert_eq!(place("ON"), Some((0x8023, 1, PlacedKind::Bit(5))));
        assert_eq!(place("CNT"), Some((0x8024, 2, PlacedKind::Cell(Width::Word))));
        assert_eq!((layout.global_len, layout.local_len), (0x26, 0));
    }

    #[test]
    fn local_data_start_after_the_cells_of_the_sequences() {
        let cells = data(&[3], vec![]);
        let local = data(&[2], vec![named("TMP", 1, What::Cell { storage: 0 })]);
        let mechs: Vec<Declarations> = (0..9).map(|n| mechanism(&format!("M{n}"))).collect();
        let names: Vec<String> = (0..9).map(|n| format!("M{n}")).collect();
        let mut blocks =
            vec![block(SectionKind::Data, "", 0, &cells), block(SectionKind::DataLocal, "", 1, &local)];
        blocks.extend(mechs.iter().zip(&names).map(|(d, n)| block(SectionKind::Mechanism, n, 0, d)));
        let layout = Layout::compute(&blocks);
        assert_eq!(layout.global_len, 3 + 2 + 9 * 6);
        let eighth = &layout.sequences[8];
        assert_eq!((eighth.active_addr, eighth.active_bit), (0x8004, 0));
        assert_eq!((eighth.resume_cell, eighth.wait_cell, eighth.line_cell), (0x8035, 0x8037, 0x8039));
        assert_eq!(layout.place(&global("M8_LINE")).map(|p| p.addr), Some(0x8039));
        let key = SymbolKey { scope: SymbolScope::File(1), name: "TMP".into() };
        assert_eq!(layout.place(&key).map(|p| p.addr), Some(0x803B));
        assert_eq!(layout.local_start(), 0x803B);
    }

    #[test]
    fn block_modules_have_cells_but_no_symbol() {
        let none = Declarations::default();
        let layout = Layout::compute(&[block(SectionKind::Module(ModuleKind::BlockInit), "", 0, &none)]);
        assert_eq!(layout.sequences.len(), 1);
        assert_eq!(&*layout.sequences[0].name, "MODULE_BLOCK_INIT");
        assert_eq!(layout.place(&global("MODULE_BLOCK_INIT")), None);
    }

    #[test]
    fn a_declaration_past_the_end_of_memory_is_named() {
        let big = data(
            &[MAX_REGION, 1],
            vec![named("A", 1, What::Area { storage: 0 }), named("B", 2, What::Cell { storage: 1 })],
        );
        let overflow = Layout::compute(&[block(SectionKind::Data, "", 0, &big)]).overflow.unwrap();
        assert_eq!((overflow.block, overflow.line), (0, 2));
        let huge = data(&[u32::MAX, u32::MAX], vec![]);
        assert!(Layout::compute(&[block(SectionKind::DataLocal, "", 0, &huge)]).overflow.is_some());
    }

    #[test]
    fn texts_are_initial_memory_and_may_lie_over_other_symbols() {
        let over = |symbol: &str, offset| Some(Overlay { symbol: symbol.into(), offset, later: Vec::new() });
        let mut text = data(
            &[4],
            vec![
                named("TX", 1, What::Text { storage: Some(0), over: None, len: 3 }),
                named("TAIL", 2, What::Text { storage: None, over: over("TX", 1), len: 2 }),
                named("FAR", 3, What::Text { storage: None, over: over("P0OUT", 16), len: 2 }),
                named("LOST", 4, What::Text { storage: None, over: over("NOBODY", 0), len: 2 }),
            ],
        );
        text.storage[0].initial = Some(b"ABC".to_vec());
        let layout = Layout::compute(&[block(SectionKind::Data, "", 0, &text)]);
        assert_eq!(layout.initial, vec![InitialData { addr: 0x8000, bytes: b"ABC".to_vec() }]);
        let place = |name| layout.place(&global(name)).map(|p| (p.addr, p.len));
        assert_eq!(place("TX"), Some((0x8000, 4)));
        assert_eq!(place("TAIL"), Some((0x8001, 3)));
        assert_eq!(place("FAR"), Some((system::OUT_PORTS + 16, 3)));
        assert_eq!(place("LOST"), None);
    }
}
