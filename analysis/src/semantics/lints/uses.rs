//! What the lines of a section do with names, without asking what the names stand for: the summary that the lints of the
//! whole project read. It holds no positions, so that it stays equal while code moves.
//!
//! It rather says too much than too little: what is not understood counts as read and written.

use std::borrow::Cow;
use std::sync::Arc;

use rustc_hash::FxHashMap;
use technol_image::program::ModuleKind;

use crate::catalogue::{self, Access, Entry, EntryKind, OperandKind};
use crate::syntax::ParsedLines;
use crate::syntax::ast::{Columns, Expr, ExprKind, Line, Number, SIGNIFICANT, key};
use crate::syntax::section::SectionKind;

/// What is done with a name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Use(u8);

impl Use {
    /// Its value is read.
    pub const READ: Use = Use(1);
    /// It is written.
    pub const WRITE: Use = Use(2);
    /// It is written with something else than a constant 0.
    pub const SET: Use = Use(4);
    /// It is named without being read or written: a bit position, the mechanism of MECH_INIT.
    pub const NAMED: Use = Use(8);
    /// The access may reach the sixteen bytes from eight before its own first one.
    pub const WIDE: Use = Use(16);
    /// The access may reach everything declared before and after it.
    pub const ANYWHERE: Use = Use(32);
    /// WR and MOVR: written in every pass, whatever others wrote.
    pub const COIL: Use = Use(64);
    /// A section waits for its value 1, with nothing else in the condition.
    pub const AWAITED: Use = Use(128);
    /// It is used in any way.
    pub const USED: Use = Use(1 | 2 | 4 | 8);
    /// Everything that can be done.
    const ALL: Use = Use(1 | 2 | 4 | 8 | 32);

    /// Whether it holds one of these.
    #[must_use]
    pub const fn any(self, what: Use) -> bool {
        self.0 & what.0 != 0
    }

    /// Both together.
    #[must_use]
    pub const fn and(self, other: Use) -> Use {
        Use(self.0 | other.0)
    }
}

/// The summary of a section.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Uses {
    /// Keys of the names with what is done with them, ascending.
    pub names: Vec<(Arc<str>, Use)>,
    /// The section takes part in each cycle, so that what it writes with WR holds until the next writer.
    pub cyclic: bool,
}

/// The summary of a section's lines.
pub(crate) fn uses(parsed: &ParsedLines, text: &str, kind: SectionKind) -> Uses {
    let mut reader = Reader { names: FxHashMap::default(), loaded: None };
    let errors = parsed.error_lines();
    for (number, (line, source)) in parsed.lines.iter().zip(crate::syntax::lines(text)).enumerate() {
        let broken = errors.binary_search(&(number as u32)).is_ok();
        let operation = line.operation.as_ref().map(|name| name.text.as_str());
        if operation.is_some_and(|name| name.eq_ignore_ascii_case("END_T_MACRO")) {
            continue;
        }
        if broken || kind == SectionKind::Macro && number > 0 {
            reader.words(source.text);
        } else {
            reader.line(line);
        }
    }
    let cyclic =
        matches!(kind, SectionKind::Mechanism | SectionKind::Module(ModuleKind::Main | ModuleKind::Input));
    let mut names: Vec<(Arc<str>, Use)> = reader.names.into_iter().collect();
    names.sort_unstable_by(|(a, _), (b, _)| a.cmp(b));
    Uses { names, cyclic }
}

/// Own lines where a name is written by WR or MOVR, or awaited: the place of a finding about it.
pub(super) fn place_of(lines: &[Line], name: &str, what: Use) -> Option<(u32, Columns)> {
    let mut loaded = false;
    for (number, line) in lines.iter().enumerate() {
        let Some(operation) = line.operation.as_ref().map(|name| name.text.to_ascii_uppercase()) else {
            continue;
        };
        let plain = line.operands.iter().find(|expr| plain(expr).is_some_and(|own| own == name));
        if what == Use::AWAITED {
            if loaded && operation == "EX0" {
                let columns = line.operation.as_ref().map_or(0..0, |name| name.columns.clone());
                return Some((number as u32, columns));
            }
            loaded = operation == "LDR" && plain.is_some();
        } else if matches!(operation.as_str(), "WR" | "MOVR")
            && let Some(expr) = plain
        {
            return Some((number as u32, expr.columns.clone()));
        }
    }
    None
}

struct Reader {
    names: FxHashMap<Arc<str>, Use>,
    /// The line before loads this bit alone.
    loaded: Option<Arc<str>>,
}

impl Reader {
    fn add(&mut self, name: &str, what: Use) {
        // Most names are written as they are known: no need to make a new one.
        let known =
            name.len() <= SIGNIFICANT && !name.bytes().any(|b| b.is_ascii_lowercase() || !b.is_ascii());
        let key = if known { Cow::Borrowed(name) } else { Cow::Owned(key(name)) };
        match self.names.get_mut(key.as_ref()) {
            Some(before) => *before = before.and(what),
            None => {
                self.names.insert(Arc::from(key.as_ref()), what);
            }
        }
    }

    /// A text that is not understood: each of its words may be a name.
    fn words(&mut self, text: &str) {
        self.loaded = None;
        let text = text.split(';').next().unwrap_or_default();
        let word = |c: char| !(c.is_alphanumeric() || matches!(c, '_' | '?' | '@'));
        for name in text.split(word).filter(|name| !name.is_empty()) {
            self.add(name, Use::ALL);
        }
    }

    fn line(&mut self, line: &Line) {
        let Some(operation) = &line.operation else {
            if line.label.is_some() {
                self.loaded = None;
            }
            return;
        };
        let loaded = self.loaded.take().filter(|_| line.label.is_none());
        let Some(entry) = catalogue::entry(&operation.text) else {
            self.add(&operation.text, Use::READ);
            line.operands.iter().for_each(|expr| self.all(expr));
            return;
        };
        match entry.name {
            "LDR" => {
                self.loaded = line.operands.first().and_then(plain).map(Arc::from);
            }
            "EX0" => {
                if let Some(name) = loaded {
                    self.add(&name, Use::AWAITED);
                }
            }
            _ => {}
        }
        match entry.name {
            "EQUI" => line.operands.iter().skip(1).for_each(|expr| self.every(expr, Use::READ)),
            "DS" => line.operands.iter().for_each(|expr| self.every(expr, Use::READ)),
            "DFM" | "DEF_T_MACRO" | "T_INCLUDE" | "T_LOCAL" => {}
            "STR" => {
                line.operands.iter().take(1).for_each(|expr| self.every(expr, Use::READ));
                line.operands.iter().skip(1).for_each(|expr| self.all(expr));
            }
            "CLEAR" => line.operands.iter().for_each(|expr| self.every(expr, Use::NAMED)),
            _ if entry.kind == EntryKind::Structure => {}
            _ => self.operands(entry, line),
        }
    }

    fn operands(&mut self, entry: &Entry, line: &Line) {
        let zero = matches!(entry.name, "FL" | "FL1")
            && line
                .operands
                .first()
                .is_some_and(|expr| matches!(&expr.kind, ExprKind::Number(n) if is_zero(*n)));
        let mut specs = entry.operands.iter();
        let mut spec = specs.next();
        for expr in &line.operands {
            let Some(now) = spec else {
                self.all(expr);
                continue;
            };
            self.operand(entry, now.kind, expr, zero);
            if !now.repeatable {
                spec = specs.next();
            }
        }
    }

    fn operand(&mut self, entry: &Entry, kind: OperandKind, expr: &Expr, zero: bool) {
        match kind {
            OperandKind::Bit { access, .. } => {
                let coil = matches!(entry.name, "WR" | "MOVR") && access != Access::Read;
                let mut what = accessed(access, zero);
                if coil {
                    what = what.and(Use::COIL);
                }
                self.bit(expr, what);
            }
            OperandKind::Data { access, .. } => self.data(expr, accessed(access, false)),
            OperandKind::AutoCounter => self.data(expr, accessed(Access::ReadWrite, false)),
            OperandKind::Time | OperandKind::Value(_) => self.data(expr, Use::READ),
            OperandKind::Number { .. } | OperandKind::Constant | OperandKind::KeywordOrNumber(..) => {
                self.every(expr, Use::READ);
            }
            OperandKind::Address(access) | OperandKind::Text(access) => {
                self.every(expr, accessed(access, false).and(Use::ANYWHERE));
            }
            OperandKind::Procedure { declares: false } => self.every(expr, Use::READ),
            OperandKind::Mechanism { declares: false } => self.every(expr, Use::NAMED),
            OperandKind::Label
            | OperandKind::Keyword(_)
            | OperandKind::NewName
            | OperandKind::NewBit
            | OperandKind::Mechanism { declares: true }
            | OperandKind::Procedure { declares: true } => {}
            _ => self.all(expr),
        }
    }

    /// `bit`, `ADR.bit`, `$+n.bit`.
    fn bit(&mut self, expr: &Expr, what: Use) {
        if let Some(name) = plain(expr) {
            self.add(&name, what);
            return;
        }
        // The name behind the dot is a position; before it stands the byte, or `$` for the byte of that bit.
        self.every(expr, Use::NAMED.and(what).and(reach(expr)));
    }

    /// A cell, with a prefix or an offset.
    fn data(&mut self, expr: &Expr, what: Use) {
        match &expr.kind {
            ExprKind::Name(name) => self.add(&name.text, what),
            ExprKind::Sign { operand, .. } if matches!(operand.kind, ExprKind::Name(_)) => {
                self.data(operand, what);
            }
            _ => self.every(expr, what.and(reach(expr))),
        }
    }

    fn all(&mut self, expr: &Expr) {
        self.every(expr, Use::ALL);
    }

    /// Every name of an operand. Operands are shallow: the parser bounds them.
    fn every(&mut self, expr: &Expr, what: Use) {
        match &expr.kind {
            ExprKind::Name(name) => self.add(&name.text, what),
            ExprKind::Sign { operand, .. } | ExprKind::Parens(operand) => self.every(operand, what),
            ExprKind::Sum { left, right, .. } | ExprKind::Dot { left, right } => {
                self.every(left, what);
                self.every(right, what);
            }
            ExprKind::Index { base, index } => {
                self.every(base, what);
                self.every(index, what);
            }
            _ => {}
        }
    }
}

const fn accessed(access: Access, zero: bool) -> Use {
    let written = if zero { Use::WRITE } else { Use::WRITE.and(Use::SET) };
    match access {
        Access::Read => Use::READ,
        Access::Write => written,
        Access::ReadWrite => written.and(Use::READ),
    }
}

/// The key of an operand that is one name, with or without `+` before it.
fn plain(expr: &Expr) -> Option<String> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name.key()),
        _ => None,
    }
}

/// How far an access with a prefix or an offset may reach.
fn reach(expr: &Expr) -> Use {
    if is_far(expr) { Use::ANYWHERE } else { Use::WIDE }
}

/// It has an index or an offset that is no small number.
fn is_far(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Index { .. } => true,
        ExprKind::Number(number) => !matches!(number, Number::Integer(0..=8)),
        ExprKind::Sign { operand, .. } | ExprKind::Parens(operand) => is_far(operand),
        ExprKind::Sum { left, right, .. } => is_far(left) || is_far(right) || !is_number(right),
        ExprKind::Dot { left, right } => is_far(left) || is_far(right),
        _ => false,
    }
}

/// A number, or `n.BIT` behind the plus of `$+n.BIT`.
fn is_number(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number(_) => true,
        ExprKind::Dot { left, .. } => matches!(left.kind, ExprKind::Number(_)),
        _ => false,
    }
}

fn is_zero(number: Number) -> bool {
    matches!(number, Number::Integer(0))
}
