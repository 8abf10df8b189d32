//! The debug information: lines, symbols and mechanisms of a linked program.

use rustc_hash::{FxHashMap, FxHashSet};
use technol_image::DebugInfo;
use technol_image::container::{content_hash, hash_bytes};
use technol_image::debug_info::{Line, Mechanism, Scope, SourceFile, State, Symbol, SymbolKind};
use technol_image::op::{Pc, Width};

use super::debug_regions::DebugRegions;
use super::input::{ProjectInput, SectionInput};
use super::link::{Linked, LinkedSequence};
use super::source_text::condition;
use crate::catalogue::{SystemKind, SystemSymbol};
use crate::semantics::declarations::{Declared, What};
use crate::semantics::hir::{SymbolKey, SymbolScope};
use crate::semantics::layout::{Layout, Placed, PlacedKind, line_key};
use crate::semantics::program::width;
use crate::syntax::section::SectionKind;

/// Debug information of `linked`.
pub(super) fn debug_info(input: &ProjectInput<'_>, layout: &Layout, linked: &Linked) -> DebugInfo {
    let files = input.files.iter().map(|file| SourceFile {
        path: file.path.to_owned(),
        hash: hash_bytes(file.text.as_bytes()),
        order: file.order,
    });
    let mut symbols = declared_symbols(input, layout, linked);
    symbols.extend(linked.used_system.iter().filter_map(|symbol| system_symbol(symbol)));
    let mechanisms = (0u16..).zip(&linked.sequences).filter_map(|(n, s)| mechanism(input, n, s));
    DebugInfo {
        program: content_hash(&linked.program),
        files: files.collect(),
        lines: lines(input, linked),
        symbols,
        mechanisms: mechanisms.collect(),
    }
}

/// A predefined symbol as the debugger sees it; `None` for one without memory and value.
#[must_use]
pub fn system_symbol(symbol: &SystemSymbol) -> Option<Symbol> {
    let kind = match symbol.kind {
        SystemKind::Bit { addr, bit } => SymbolKind::Bit { addr, bit },
        SystemKind::Cell { addr, prefix } => SymbolKind::Cell { addr, width: width(prefix) },
        SystemKind::Array { addr, element, len } => {
            SymbolKind::Area { addr, len: width(element).bytes() * len }
        }
        SystemKind::Area { addr, len } => SymbolKind::Area { addr, len },
        SystemKind::Constant(value) => SymbolKind::Constant { value },
        SystemKind::FormalBit { .. } | SystemKind::Member { .. } => return None,
    };
    Some(Symbol { name: symbol.name.to_owned(), scope: Scope::System, kind, declared: None })
}

fn lines(input: &ProjectInput<'_>, linked: &Linked) -> Vec<Line> {
    let regions: Vec<DebugRegions> = input.files.iter().map(|file| DebugRegions::of(file.text)).collect();
    // Calls of macros without D_ON take no break-point (manual 22.4).
    let refused: FxHashSet<(u16, u32)> = input
        .sections
        .iter()
        .flat_map(|section| section.calls.iter().map(move |call| (section, call)))
        .filter(|(_, (_, allowed))| !allowed)
        .map(|(section, (own, _))| (section.file, section.file_line(*own)))
        .collect();
    let lines = linked.lines.iter().map(|line| Line {
        pc: line.pc,
        file: line.file,
        line: line.line + 1,
        in_debug_region: input.debug_everywhere
            || !refused.contains(&(line.file, line.line))
                && regions.get(usize::from(line.file)).is_some_and(|r| r.contains(line.line)),
    });
    lines.collect()
}

fn declared_symbols(input: &ProjectInput<'_>, layout: &Layout, linked: &Linked) -> Vec<Symbol> {
    let labels = linked.labels.iter().map(|label| ((label.section, &*label.name), label.pc)).collect();
    let names = linked.program.procedures.iter().map(|procedure| procedure.name.as_str());
    let mut procedures = FxHashMap::default();
    for (number, name) in (0u16..).zip(names) {
        procedures.entry(name).or_insert(number);
    }
    let mut symbols = Vec::new();
    for (index, section) in input.sections.iter().enumerate() {
        let scope = match section.kind {
            SectionKind::DataLocal => SymbolScope::File(section.owner),
            _ => SymbolScope::Global,
        };
        let here = Declaration { layout, procedures: &procedures, labels: &labels, section, scope, index };
        for declared in &section.declarations.names {
            here.add(declared, &mut symbols);
        }
    }
    symbols
}

/// Where a symbol is declared.
struct Declaration<'a> {
    layout: &'a Layout,
    procedures: &'a FxHashMap<&'a str, u16>,
    section: &'a SectionInput<'a>,
    /// Labels by section and key.
    labels: &'a FxHashMap<(usize, &'a str), Pc>,
    scope: SymbolScope,
    index: usize,
}

impl Declaration<'_> {
    fn add(&self, declared: &Declared, symbols: &mut Vec<Symbol>) {
        let key = declared.name.key();
        let line = self.section.file_line(declared.line) + 1;
        let place = Some((self.section.file, line));
        let scope = match (self.scope, &declared.what) {
            (_, What::Label) => Scope::File(self.section.owner),
            // A constant and a mechanism are known everywhere, wherever they are declared.
            (_, What::Constant(_) | What::Mechanism | What::Procedure) => Scope::Global,
            (SymbolScope::File(file), _) => Scope::File(file),
            _ => Scope::Global,
        };
        let kind = match declared.what {
            What::Constant(value) => value.map(|value| SymbolKind::Constant { value }),
            What::Procedure => {
                let number = self.procedures.get(key.as_str()).copied();
                number.map(|procedure| SymbolKind::Procedure { procedure })
            }
            What::Label => {
                let pc = self.labels.get(&(self.index, key.as_str())).copied();
                pc.map(|pc| SymbolKind::Label { pc })
            }
            _ => {
                self.layout.place(&SymbolKey { scope: self.scope, name: key.as_str().into() }).map(in_memory)
            }
        };
        let Some(kind) = kind else { return };
        let is_mechanism = matches!(kind, SymbolKind::Mechanism { .. });
        symbols.push(Symbol { name: declared.name.text.clone(), scope, kind, declared: place });
        if is_mechanism {
            let name = SymbolKey { scope: SymbolScope::Global, name: line_key(&key).into() };
            if let Some(placed) = self.layout.place(&name) {
                let name = format!("{}_LINE", declared.name.text);
                symbols.push(Symbol { name, scope, kind: in_memory(placed), declared: place });
            }
        }
    }
}

fn in_memory(placed: Placed) -> SymbolKind {
    let Placed { addr, len, kind } = placed;
    match kind {
        PlacedKind::Bit(bit) => SymbolKind::Bit { addr, bit },
        PlacedKind::Cell(width) => SymbolKind::Cell { addr, width },
        PlacedKind::Area => SymbolKind::Area { addr, len },
        PlacedKind::Text(len) => SymbolKind::Text { addr, len },
        PlacedKind::Sequence(sequence) => SymbolKind::Mechanism { sequence },
    }
}

fn mechanism(input: &ProjectInput<'_>, sequence: u16, linked: &LinkedSequence) -> Option<Mechanism> {
    let section = input.sections.get(linked.section)?;
    let name = if let SectionKind::Module(kind) = section.kind {
        kind.keyword().to_owned()
    } else {
        let declared = section.declarations.names.iter().find(|d| d.what == What::Mechanism);
        declared.map_or_else(|| section.name.to_string(), |d| d.name.text.clone())
    };
    let last = (section.lines.len() as u32).saturating_sub(1);
    Some(Mechanism {
        name,
        sequence,
        file: section.file,
        module: linked.module,
        lines: (section.file_line(0) + 1, section.file_line(last) + 1),
        states: states(section),
    })
}

fn states(section: &SectionInput<'_>) -> Vec<State> {
    let points = section.code.map_or(&[][..], |code| &code.points);
    let own: Vec<&str> = section.text.lines().collect();
    // The opening line is no condition.
    let mut from = 1;
    let mut states = Vec::with_capacity(points.len());
    for (point, at) in (1u16..).zip(points) {
        let to = (at.line as usize).min(own.len());
        let before = own.get(from.min(to)..to).unwrap_or_default();
        states.push(State {
            point,
            line: section.file_line(at.line) + 1,
            mnemonic: at.mnemonic.to_owned(),
            // EX, BEX and TIM do not look at RLO.
            condition: match at.mnemonic {
                "EX" | "BEX" | "TIM" => String::new(),
                _ => condition(before.iter().copied()),
            },
        });
        from = to + 1;
    }
    states
}

/// Length in bytes of what a symbol stands for in memory.
pub(super) fn memory_of(kind: &SymbolKind) -> Option<(u32, u32)> {
    match *kind {
        SymbolKind::Bit { addr, .. } => Some((addr, 1)),
        SymbolKind::Cell { addr, width } => Some((addr, Width::bytes(width))),
        SymbolKind::Area { addr, len } => Some((addr, len)),
        SymbolKind::Text { addr, len } => Some((addr, len + 1)),
        _ => None,
    }
}
