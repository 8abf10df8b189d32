//! The `.LS1` listing: every source line with the address and the operations it became, then the symbol table.

use std::collections::{BTreeMap, HashSet};
use std::fmt::Write as _;

use technol_image::DebugInfo;
use technol_image::debug_info::{Scope, Symbol, SymbolKind};
use technol_image::op::{Op, Pc};
use technol_image::program::Program;

use super::debug_info::memory_of;
use super::disassembly::prefix;
use super::{Built, Disassembler};

/// Column of the source text.
const SOURCE: usize = 56;

/// The listing of a built project. `texts` are path and text of its files, in any order; a file without text is
/// listed without its source.
///
/// A line holds the line number, the address and one column of text: data lines have the address of their memory with an
/// `m`, code lines the number of their first operation, both hexadecimal.
#[must_use]
pub fn listing<'a>(built: &Built, texts: impl IntoIterator<Item = (&'a str, &'a str)>) -> String {
    let program = &built.image.program;
    let Some(debug) = &built.image.debug else { return String::new() };
    let texts: BTreeMap<&str, &str> = texts.into_iter().collect();
    let disassembler = Disassembler::new(program, Some(debug));
    let code = code_by_line(program, debug);
    let data = data_by_line(debug);
    let mut out = String::new();
    let _ = writeln!(out, "TECHNOL listing of {}, program {}", program.name, hex(&built.hash));
    for (file, source) in (0u16..).zip(&debug.files) {
        let order = source.order.map_or("included".to_owned(), |n| format!("file {}", u16::from(n) + 1));
        let _ = writeln!(out, "\n--- {} ({order})", source.path);
        let text = texts.get(source.path.as_str()).copied().unwrap_or_default();
        for (line, source) in (1u32..).zip(text.lines()) {
            let ops = code.get(&(file, line)).map(Vec::as_slice).unwrap_or_default();
            let memory = data.get(&(file, line)).copied();
            list_line(&mut out, line, ops, memory, source, &disassembler);
        }
    }
    symbol_table(&mut out, program, debug);
    out
}

fn list_line(
    out: &mut String,
    line: u32,
    ops: &[Pc],
    memory: Option<u32>,
    source: &str,
    disassembler: &Disassembler<'_>,
) {
    let source = source.trim_end();
    let mut row = match (ops.first(), memory) {
        (Some(pc), _) => format!("{line:>6}   {pc:04X}  {}", disassembler.at(*pc).unwrap_or_default()),
        (None, Some(addr)) => format!("{line:>6} m {addr:04X}"),
        (None, None) => format!("{line:>6}"),
    };
    if !source.is_empty() {
        let width = row.chars().count();
        row.extend(std::iter::repeat_n(' ', SOURCE.saturating_sub(width).max(1)));
        row.push_str(source);
    }
    out.push_str(&row);
    out.push('\n');
    for pc in ops.iter().skip(1) {
        let _ = writeln!(out, "{:>6}   {pc:04X}  {}", "", disassembler.at(*pc).unwrap_or_default());
    }
}

/// Operations of each line. Ends of modules and the jumps around procedures have no line.
fn code_by_line(program: &Program, debug: &DebugInfo) -> BTreeMap<(u16, u32), Vec<Pc>> {
    let mut code: BTreeMap<(u16, u32), Vec<Pc>> = BTreeMap::new();
    let end = program.code.len() as Pc;
    let procedures: HashSet<Pc> = program.procedures.iter().map(|p| p.start).collect();
    for (index, line) in debug.lines.iter().enumerate() {
        let next = debug.lines.get(index + 1).map_or(end, |l| l.pc);
        let ops = (line.pc..next).filter(|pc| {
            let op = program.code.get(*pc as usize);
            let around = procedures.contains(&(pc + 1)) && *pc != line.pc;
            !around && !matches!(op, Some(Op::ModuleEnd))
        });
        code.entry((line.file, line.line)).or_default().extend(ops);
    }
    code
}

fn data_by_line(debug: &DebugInfo) -> BTreeMap<(u16, u32), u32> {
    let mut data = BTreeMap::new();
    for symbol in &debug.symbols {
        let (Some(declared), Some((addr, _))) = (symbol.declared, memory_of(&symbol.kind)) else { continue };
        let first = data.entry(declared).or_insert(addr);
        *first = addr.min(*first);
    }
    data
}

fn symbol_table(out: &mut String, program: &Program, debug: &DebugInfo) {
    let mut symbols: Vec<&Symbol> = debug.symbols.iter().collect();
    symbols.sort_by_cached_key(|s| (s.name.to_ascii_uppercase(), s.declared));
    out.push_str("\n--- symbols\n");
    for symbol in symbols {
        let scope = match symbol.scope {
            Scope::Global => "global",
            Scope::File(_) => "local",
            Scope::System => "system",
        };
        let declared = symbol.declared.and_then(|(file, line)| {
            let file = debug.files.get(usize::from(file))?;
            Some(format!("{}:{line}", file.path))
        });
        let row = format!(
            "{:<32}{:<8}{:<22}{}",
            symbol.name,
            scope,
            describe(&symbol.kind, program),
            declared.unwrap_or_default()
        );
        out.push_str(row.trim_end());
        out.push('\n');
    }
}

fn describe(kind: &SymbolKind, program: &Program) -> String {
    match *kind {
        SymbolKind::Bit { addr, bit } => format!("{addr:04X}h.{bit}"),
        SymbolKind::Cell { addr, width } => format!("{addr:04X}h {}", prefix(width)),
        SymbolKind::Area { addr, len } => format!("{addr:04X}h area {len}"),
        SymbolKind::Text { addr, len } => format!("{addr:04X}h text {len}"),
        SymbolKind::Constant { value } => format!("= {value}"),
        SymbolKind::Mechanism { sequence } => match program.sequences.get(usize::from(sequence)) {
            Some(cells) => format!("{:04X}h.{} mechanism", cells.active_addr, cells.active_bit),
            None => "mechanism".to_owned(),
        },
        SymbolKind::Procedure { procedure } => match program.procedures.get(usize::from(procedure)) {
            Some(procedure) => format!("code {:04X}h procedure", procedure.start),
            None => "procedure".to_owned(),
        },
        SymbolKind::Label { pc } => format!("code {pc:04X}h"),
    }
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
