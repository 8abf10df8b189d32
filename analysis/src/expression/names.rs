//! Names of an expression.

use technol_image::DebugInfo;
use technol_image::debug_info::{Scope, Symbol, SymbolKind};
use technol_image::op::{Addr, Width};

use super::ExpressionError;
use crate::build::debug_info::system_symbol;
use crate::catalogue::{self, SystemKind};
use crate::syntax::ast::SIGNIFICANT;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    Bit {
        addr: Addr,
        bit: u8,
    },
    Cell {
        addr: Addr,
        width: Width,
    },
    Text {
        addr: Addr,
        len: u32,
    },
    Area {
        addr: Addr,
    },
    Constant(i64),
    Mechanism(u16),
    /// A bit number without a byte.
    BitPosition(u8),
    /// A procedure or label.
    Code(&'static str),
}

/// The names of a program as one file sees them.
pub(super) struct Names<'a> {
    pub(super) debug: &'a DebugInfo,
    pub(super) file: Option<u8>,
}

impl Names<'_> {
    /// Looks a name up.
    pub(super) fn find(&self, name: &str) -> Result<Found, ExpressionError> {
        let mut best: Option<(u8, &Symbol)> = None;
        let mut elsewhere = Vec::new();
        for symbol in self.debug.symbols.iter().filter(|symbol| same(&symbol.name, name)) {
            let rank = match symbol.scope {
                // Labels never hide data.
                _ if matches!(symbol.kind, SymbolKind::Label { .. }) => 4,
                Scope::File(file) if Some(file) == self.file => 0,
                Scope::Global => 1,
                Scope::System => 2,
                Scope::File(file) => {
                    elsewhere.push(file);
                    3
                }
            };
            if best.is_none_or(|(found, _)| rank < found) {
                best = Some((rank, symbol));
            }
        }
        match best {
            Some((3, _)) if elsewhere.len() > 1 => {
                let choices = elsewhere.iter().filter_map(|order| {
                    let file = self.debug.files.iter().find(|f| f.order == Some(*order))?;
                    Some(format!("{}:{name}", file.path))
                });
                Err(ExpressionError::Ambiguous(name.to_owned(), choices.collect()))
            }
            Some((rank, symbol)) if rank < 4 => Ok(found(&symbol.kind)),
            label => match predefined(name) {
                Some(found) => Ok(found),
                None => label.map(|(_, s)| found(&s.kind)).ok_or_else(|| {
                    let near = super::nearest(self.debug, name).map(str::to_owned);
                    ExpressionError::Unknown(name.to_owned(), near)
                }),
            },
        }
    }
}

/// A predefined symbol that the program itself does not use.
fn predefined(name: &str) -> Option<Found> {
    let symbol = catalogue::symbol(name)?;
    if let SystemKind::FormalBit { bit } = symbol.kind {
        return Some(Found::BitPosition(bit));
    }
    system_symbol(symbol).map(|symbol| found(&symbol.kind))
}

fn found(kind: &SymbolKind) -> Found {
    match *kind {
        SymbolKind::Bit { addr, bit } => Found::Bit { addr, bit },
        SymbolKind::Cell { addr, width } => Found::Cell { addr, width },
        SymbolKind::Area { addr, .. } => Found::Area { addr },
        SymbolKind::Text { addr, len } => Found::Text { addr, len },
        SymbolKind::Constant { value } => Found::Constant(value),
        SymbolKind::Mechanism { sequence } => Found::Mechanism(sequence),
        SymbolKind::Procedure { .. } => Found::Code("a procedure"),
        SymbolKind::Label { .. } => Found::Code("a label"),
    }
}

/// Whether two spellings are one name (manual 3.3).
fn same(a: &str, b: &str) -> bool {
    let mut a = a.chars().take(SIGNIFICANT);
    let mut b = b.chars().take(SIGNIFICANT);
    loop {
        match (a.next(), b.next()) {
            (None, None) => return true,
            (Some(x), Some(y)) if x.eq_ignore_ascii_case(&y) => {}
            _ => return false,
        }
    }
}

/// Execution order of a file by its path or by its last component.
pub(super) fn file_order(debug: &DebugInfo, name: &str) -> Result<u8, ExpressionError> {
    let by_path = debug.files.iter().find(|file| file.path == name);
    let last = |path: &str| path.rsplit('/').next().is_some_and(|last| last == name);
    let found = by_path.or_else(|| debug.files.iter().find(|file| last(&file.path)));
    found.and_then(|file| file.order).ok_or_else(|| ExpressionError::File(name.to_owned()))
}
