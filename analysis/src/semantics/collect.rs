//! Reads what the lines of a section declare.

use std::sync::Arc;

use super::constant::{ConstExpr, NotConstant};
use super::declarations::{
    Declarations, Declared, Exports, IncludeLine, LengthOf, MacroLine, Overlay, Storage, What,
};
use super::macros::definition::Flags;
use crate::catalogue::{self, SystemKind};
use crate::diagnostics::Finding;
use crate::diagnostics::rules::declarations as rules;
use crate::syntax::ParsedLines;
use crate::syntax::ast::{Columns, Expr, ExprKind, Line, Name, SIGNIFICANT};
use crate::syntax::section::SectionKind;

/// Largest length DS and STR take, in bytes.
pub(crate) const MAX_LENGTH: i64 = catalogue::MAX_LENGTH;

/// Declarations in the own lines of a section. `outer` are the sections around it.
pub(crate) fn collect(parsed: &ParsedLines, text: &str, kind: SectionKind) -> Declarations {
    let mut reader = Reader::new(kind, parsed.error_lines());
    if kind == SectionKind::Macro {
        if let Some(line) = parsed.lines.first() {
            reader.macro_name(0, line, What::Macro);
        }
        return reader.found;
    }
    for (number, (line, source)) in parsed.lines.iter().zip(crate::syntax::lines(text)).enumerate() {
        reader.line(number as u32, line, source.text);
    }
    reader.labels_of_code();
    reader.found
}

/// What others see of `declarations`.
pub(crate) fn exports(declarations: &Declarations) -> Exports {
    let mut exports = Exports::default();
    let mut place = vec![None; declarations.names.len()];
    for (index, declared) in declarations.names.iter().enumerate() {
        if declared.what != What::Label {
            place[index] = Some(exports.names.len() as u32);
            exports.indices.push(index as u32);
            exports.names.push((Arc::from(declared.name.key()), declared.what.clone()));
        }
    }
    exports.storage = declarations.storage.iter().map(|s| Some(s.len)).collect();
    for (storage, name, expr, counts) in &declarations.lengths {
        if let Ok(expr) = ConstExpr::read(expr) {
            exports.storage[*storage as usize] = None;
            let name = name.and_then(|name| place[name as usize]);
            exports.lengths.push((*storage, name, expr, *counts));
        }
    }
    for (name, expr) in &declarations.expressions {
        if let (Some(name), Ok(expr)) = (place[*name as usize], ConstExpr::read(expr)) {
            exports.expressions.push((name, expr));
        }
    }
    exports.includes = declarations.includes.iter().map(|i| (i.name.clone(), i.quoted)).collect();
    exports
}

/// A text as the control has it: texts of a PLC live in single bytes, which it shows in Windows-1250.
pub(crate) fn text_bytes(text: &str) -> Vec<u8> {
    encoding_rs::WINDOWS_1250.encode(text).0.into_owned()
}

/// The file name of a T_INCLUDE line; `None` for other lines and when the name is missing.
pub(crate) fn include_of(line: &Line, text: &str) -> Option<(Columns, String, bool)> {
    let operation = line.operation.as_ref().filter(|name| name.text.eq_ignore_ascii_case("T_INCLUDE"))?;
    let end = line.comment.as_ref().map_or(text.len(), |comment| comment.start as usize);
    let rest = text.get(operation.columns.end as usize..end)?;
    let trimmed = rest.trim();
    if trimmed.is_empty() {
        return None;
    }
    let start = operation.columns.end as usize + (rest.len() - rest.trim_start().len());
    let columns = start as u32..(start + trimmed.len()) as u32;
    match trimmed.strip_prefix('\'') {
        Some(inner) => Some((columns, inner.strip_suffix('\'').unwrap_or(inner).to_string(), true)),
        None => Some((columns, trimmed.to_string(), false)),
    }
}

/// Reads lines one after the other.
pub(super) struct Reader {
    kind: SectionKind,
    pub(super) found: Declarations,
    /// The STRUC whose ENDS is still to come.
    pub(super) structure: Option<super::structures::Open>,
    /// Labels that wait for the line they belong to.
    pub(super) pending: Vec<(u32, Name)>,
    /// Lines the parser complained about: their declarations are taken as unknown.
    errors: Vec<u32>,
}

impl Reader {
    /// A reader of lines in a section of a kind; `errors` are the lines the parser complained about.
    pub(super) fn new(kind: SectionKind, errors: Vec<u32>) -> Reader {
        Reader { kind, found: Declarations::default(), structure: None, pending: Vec::new(), errors }
    }

    pub(super) fn line(&mut self, number: u32, line: &Line, text: &str) {
        if let Some(label) = &line.label {
            self.pending.push((number, label.clone()));
        }
        let Some(operation) = &line.operation else { return };
        if self.structure.is_some() {
            super::structures::inside(self, number, operation);
        }
        match operation.text.to_ascii_uppercase().as_str() {
            "DFM" if self.holds_data() => self.dfm(number, line),
            "DS" if self.holds_data() => self.ds(number, line),
            "STR" => self.str(number, line),
            "EQUI" => self.equi(number, line),
            "STRUC" if self.holds_data() => super::structures::open(self, number, line),
            "ENDS" if self.holds_data() => super::structures::close(self, number, line),
            "DB" | "DW" | "DD" | "DQ" if self.holds_data() => super::structures::member(self, number, line),
            "MECH_BEGIN" if self.kind == SectionKind::Mechanism && number == 0 => {
                self.routine(line, What::Mechanism);
            }
            "PROC_BEGIN" if self.kind == SectionKind::Procedure && number == 0 => {
                self.routine(line, What::Procedure);
            }
            "APPEND_T_MACRO" => self.append(number, line),
            "CONTROL_T_MACRO" => {
                if let Some(Expr { kind: ExprKind::Name(mode), .. }) = line.operands.first() {
                    let pre = mode.text.eq_ignore_ascii_case("PRE");
                    self.found.macro_lines.push(MacroLine::Control { line: number, pre });
                }
            }
            "T_INCLUDE" => {
                if let Some((columns, name, quoted)) = include_of(line, text) {
                    self.found.macro_lines.push(MacroLine::Include { line: number, name: name.clone() });
                    self.found.includes.push(IncludeLine { line: number, columns, name, quoted });
                }
            }
            _ if self.holds_data() && self.kind != SectionKind::File => {
                // `X: DFN 1`: the misspelled line is reported; its name is not reported again where it is used.
                for (line, label) in std::mem::take(&mut self.pending) {
                    self.declare(label, line, What::Unknown);
                }
            }
            _ => {
                self.labels_of_code();
                if let Some(new) = catalogue::entry(&operation.text).and_then(catalogue::Entry::declares) {
                    super::new_cells::declare(self, number, line, new);
                }
            }
        }
    }

    fn holds_data(&self) -> bool {
        matches!(self.kind, SectionKind::Data | SectionKind::DataLocal | SectionKind::File)
    }

    pub(super) fn labels_of_code(&mut self) {
        super::structures::end(self);
        if matches!(self.kind, SectionKind::Data | SectionKind::DataLocal) {
            for (line, label) in std::mem::take(&mut self.pending) {
                let message = format!("{} names nothing: DFM, DS or STR must follow", label.text);
                self.report(&rules::BAD_DECLARATION, line, label.columns.clone(), message);
                self.declare(label, line, What::Unknown);
            }
            return;
        }
        for (line, name) in std::mem::take(&mut self.pending) {
            self.check_name(line, &name);
            self.found.names.push(Declared { name, line, what: What::Label });
        }
    }

    pub(super) fn broken(&self, number: u32) -> bool {
        self.errors.binary_search(&number).is_ok()
    }

    pub(super) fn report(
        &mut self,
        rule: &'static crate::diagnostics::Rule,
        line: u32,
        columns: Columns,
        message: String,
    ) {
        self.found.findings.push(Finding::new(rule, line, columns, message));
    }

    /// A constant expression; what is none is reported.
    pub(super) fn constant(&mut self, line: u32, expr: &Expr) -> Option<ConstExpr> {
        match ConstExpr::read(expr) {
            Ok(constant) => Some(constant),
            Err(why) => {
                if let Some((columns, message)) = why.message() {
                    self.report(&rules::NOT_CONSTANT, line, columns, message);
                }
                None
            }
        }
    }

    pub(super) fn declare(&mut self, name: Name, line: u32, what: What) -> u32 {
        self.check_name(line, &name);
        self.check_system(line, &name, &what);
        self.found.names.push(Declared { name, line, what });
        self.found.names.len() as u32 - 1
    }

    fn check_name(&mut self, line: u32, name: &Name) {
        if name.text.chars().count() > SIGNIFICANT {
            let message = format!("only the first {SIGNIFICANT} characters of {} count", name.text);
            self.report(&rules::LONG_NAME, line, name.columns.clone(), message);
        }
        if is_reserved(&name.text) {
            let message = format!("{} is also an instruction or keyword; rename it", name.text);
            self.report(&rules::NAME_LIKE_INSTRUCTION, line, name.columns.clone(), message);
        }
    }

    /// Memory under the name of a predefined cell. Bit positions and members have no memory that could be hidden.
    fn check_system(&mut self, line: u32, name: &Name, what: &What) {
        let memory =
            matches!(what, What::Bit { .. } | What::Cell { .. } | What::Area { .. } | What::Text { .. });
        let Some(system) = catalogue::symbol(&name.text).filter(|_| memory) else { return };
        if !matches!(system.kind, SystemKind::FormalBit { .. } | SystemKind::Member { .. }) {
            let message = format!("{} is also a predefined name of the control; rename it", name.text);
            self.report(&rules::HIDES_SYSTEM_SYMBOL, line, name.columns.clone(), message);
        }
    }

    pub(super) fn storage(&mut self, len: u32, initial: Option<Vec<u8>>) -> u32 {
        self.found.storage.push(Storage { len, initial });
        self.found.storage.len() as u32 - 1
    }

    fn dfm(&mut self, number: u32, line: &Line) {
        let storage = self.storage(1, None);
        for (at, label) in std::mem::take(&mut self.pending) {
            self.declare(label, at, What::Cell { storage });
        }
        for (bit, operand) in line.operands.iter().enumerate() {
            match &operand.kind {
                ExprKind::Name(name) if bit < 8 => {
                    self.declare(name.clone(), number, What::Bit { storage, bit: bit as u8 });
                }
                ExprKind::Name(name) => {
                    self.declare(name.clone(), number, What::Unknown);
                }
                ExprKind::Missing | ExprKind::Error => {}
                _ if self.broken(number) => {}
                _ => {
                    let message = "a bit name is needed here; leave the place empty for a bit without a name";
                    self.report(
                        &rules::BAD_DECLARATION,
                        number,
                        operand.columns.clone(),
                        message.to_string(),
                    );
                }
            }
        }
        if let (Some(ninth), Some(last)) = (line.operands.get(8), line.operands.last())
            && line.operands[8..].iter().any(|o| o.kind != ExprKind::Missing)
        {
            let message = format!(
                "DFM declares 8 bits, {} are given; put the rest into another DFM",
                line.operands.len()
            );
            self.report(&rules::TOO_MANY_BITS, number, ninth.columns.start..last.columns.end, message);
        }
    }

    fn ds(&mut self, number: u32, line: &Line) {
        let operation = line.operation.as_ref().map_or(0..0, |name| name.columns.clone());
        let labels = std::mem::take(&mut self.pending);
        if labels.is_empty() && !self.broken(number) {
            let message = "this memory has no name; write NAME: before DS".to_string();
            self.report(&rules::MISSING_NAME, number, operation, message);
        }
        let length = self.length(number, line, "DS n");
        let storage = self.storage(length.known(), None);
        let what = match length {
            Length::Known(1 | 2 | 4) => What::Cell { storage },
            Length::Known(_) | Length::Later(_) => What::Area { storage },
            Length::Wrong => What::Unknown,
        };
        let mut first = None;
        for (at, label) in labels {
            let index = self.declare(label, at, what.clone());
            first = first.or(Some(index));
        }
        if let Length::Later(expr) = length {
            self.found.lengths.push((storage, first, expr, LengthOf::Bytes));
        }
    }

    fn str(&mut self, number: u32, line: &Line) {
        let operation = line.operation.as_ref().map_or(0..0, |name| name.columns.clone());
        let labels = std::mem::take(&mut self.pending);
        if labels.is_empty() && !self.broken(number) {
            let message = "STR needs a name: NAME: STR n".to_string();
            self.report(&rules::BAD_DECLARATION, number, operation, message);
        }
        let length = self.length(number, line, "STR n [, 'text' | address]");
        let (initial, over, wrong) = self.str_content(number, line, &length);
        let len = length.known();
        let storage = over.is_none().then(|| self.storage(len.saturating_add(1), initial));
        let what = match length {
            Length::Wrong => What::Unknown,
            _ if wrong => What::Unknown,
            _ => What::Text { storage, over, len },
        };
        let mut first = None;
        for (at, label) in labels {
            let index = self.declare(label, at, what.clone());
            first = first.or(Some(index));
        }
        if let (Length::Later(expr), Some(storage)) = (length, storage) {
            self.found.lengths.push((storage, first, expr, LengthOf::Characters));
        }
    }

    fn str_content(
        &mut self,
        number: u32,
        line: &Line,
        length: &Length,
    ) -> (Option<Vec<u8>>, Option<Overlay>, bool) {
        let Some(content) = line.operands.get(1) else { return (None, None, false) };
        if let ExprKind::Text(text) = &content.kind {
            let count = text.chars().count();
            if let Length::Known(len) = length
                && count > *len as usize
            {
                let message = format!("the text has {count} characters, the buffer {len}");
                self.report(&rules::TEXT_TOO_LONG, number, content.columns.clone(), message);
            }
            let bytes = text_bytes(text);
            return (Some(bytes), None, false);
        }
        match overlay(content) {
            Some(over) => (None, Some(over), false),
            None if self.broken(number) || content.kind == ExprKind::Missing => (None, None, true),
            None => {
                let message = "a text in apostrophes or an address name+n is needed here".to_string();
                self.report(&rules::BAD_DECLARATION, number, content.columns.clone(), message);
                (None, None, true)
            }
        }
    }

    fn length(&mut self, number: u32, line: &Line, form: &str) -> Length {
        let operation = line.operation.as_ref().map_or(0..0, |name| name.columns.clone());
        let Some(operand) = line.operands.first().filter(|o| o.kind != ExprKind::Missing) else {
            if !self.broken(number) {
                self.report(&rules::BAD_LENGTH, number, operation, format!("the length is missing: {form}"));
            }
            return Length::Wrong;
        };
        let expr = match ConstExpr::read(operand) {
            Ok(expr) => expr,
            Err(NotConstant::Reported) => return Length::Wrong,
            Err(_) if self.broken(number) => return Length::Wrong,
            Err(_) => {
                let message = format!("the length must be a constant: {form}");
                self.report(&rules::BAD_LENGTH, number, operand.columns.clone(), message);
                return Length::Wrong;
            }
        };
        match expr.literal() {
            Some(len @ 1..=MAX_LENGTH) => Length::Known(len as u32),
            Some(len) => {
                let message = format!("the length {len} is not within 1 and {MAX_LENGTH}");
                self.report(&rules::BAD_LENGTH, number, operand.columns.clone(), message);
                Length::Wrong
            }
            None => Length::Later(operand.clone()),
        }
    }

    fn equi(&mut self, number: u32, line: &Line) {
        let operation = line.operation.as_ref().map_or(0..0, |name| name.columns.clone());
        let (name, value) = match line.operands.as_slice() {
            [Expr { kind: ExprKind::Name(name), .. }, value, ..] => (name, value),
            [Expr { kind: ExprKind::Name(name), .. }] => {
                if !self.broken(number) {
                    let message = format!("the value is missing: EQUI {}, value", name.text);
                    self.report(&rules::BAD_DECLARATION, number, operation, message);
                }
                self.declare(name.clone(), number, What::Unknown);
                return;
            }
            _ => {
                if !self.broken(number) {
                    let columns = line.operands.first().map_or(operation, |first| first.columns.clone());
                    self.report(
                        &rules::BAD_DECLARATION,
                        number,
                        columns,
                        "write EQUI name, value".to_string(),
                    );
                }
                return;
            }
        };
        let expr = match ConstExpr::read(value) {
            Ok(expr) => expr,
            Err(why) => {
                if let Some((columns, message)) = why.message().filter(|_| !self.broken(number)) {
                    self.report(&rules::NOT_CONSTANT, number, columns, message);
                }
                self.declare(name.clone(), number, What::Unknown);
                return;
            }
        };
        let mut used = Vec::new();
        expr.names(&mut used);
        if used.is_empty() {
            if let Some(value) = expr.literal().filter(|v| (-0x8000_0000..=0xFFFF_FFFF).contains(v)) {
                self.declare(name.clone(), number, What::Constant(Some(value)));
            } else {
                let message = "the value does not fit 32 bits".to_string();
                let rule = &crate::diagnostics::rules::operands::CONSTANT_TOO_LARGE;
                self.report(rule, number, value.columns.clone(), message);
                self.declare(name.clone(), number, What::Unknown);
            }
        } else {
            let index = self.declare(name.clone(), number, What::Constant(None));
            self.found.expressions.push((index, value.clone()));
        }
    }

    fn routine(&mut self, line: &Line, what: What) {
        if let Some(Expr { kind: ExprKind::Name(name), .. }) = line.operands.first() {
            self.declare(name.clone(), 0, what);
        }
    }

    fn append(&mut self, number: u32, line: &Line) {
        let [Expr { kind: ExprKind::Name(word), .. }, Expr { kind: ExprKind::Name(target), .. }, flags @ ..] =
            line.operands.as_slice()
        else {
            return;
        };
        self.found.macro_lines.push(MacroLine::Append {
            line: number,
            word: Arc::from(word.key()),
            target: Arc::from(target.key()),
            flags: Flags::read(flags).0,
        });
        self.macro_name(number, line, What::MacroWord);
    }

    fn macro_name(&mut self, number: u32, line: &Line, what: What) {
        let Some(mut expr) = line.operands.first() else { return };
        if let ExprKind::Index { base, .. } = &expr.kind {
            expr = base;
        }
        if let ExprKind::Name(name) = &expr.kind {
            let name = name.clone();
            self.found.names.push(Declared { name, line: number, what });
        }
    }
}

enum Length {
    Known(u32),
    /// Needs constants of other sections.
    Later(Expr),
    Wrong,
}

impl Length {
    fn known(&self) -> u32 {
        if let Length::Known(len) = self { *len } else { 0 }
    }
}

/// `name`, `name+n`, `name-n`, `name.MEMBER`.
fn overlay(expr: &Expr) -> Option<Overlay> {
    match &expr.kind {
        ExprKind::Name(name) => Some(Overlay { symbol: name.key(), offset: 0, later: Vec::new() }),
        ExprKind::Parens(inner) => overlay(inner),
        ExprKind::Dot { left, right } => match &right.kind {
            ExprKind::Name(member) => {
                let mut base = overlay(left)?;
                base.later.push(ConstExpr::Name(member.key()));
                Some(base)
            }
            _ => None,
        },
        ExprKind::Sum { minus, left, right } => {
            let mut base = overlay(left)?;
            let step = ConstExpr::read(right).ok()?;
            match step.literal() {
                Some(step) if *minus => base.offset = base.offset.checked_sub(step)?,
                Some(step) => base.offset = base.offset.checked_add(step)?,
                None if *minus => base.later.push(ConstExpr::Negated(Box::new(step))),
                None => base.later.push(step),
            }
            Some(base)
        }
        _ => None,
    }
}

fn is_reserved(name: &str) -> bool {
    // 80386 instructions known by name only are no obstacle: LOOP, TEST and OUT are good names.
    let taken = |entry: &catalogue::Entry| {
        entry.kind != catalogue::EntryKind::EventProcedure && !entry.is_known_only() && !entry.is_contextual()
    };
    catalogue::entry(name).is_some_and(taken)
        || catalogue::prefix(name).is_some()
        || catalogue::is_keyword(name)
}

impl ParsedLines {
    /// Lines with a syntax error, ascending.
    #[must_use]
    pub fn error_lines(&self) -> Vec<u32> {
        self.errors.iter().map(|error| error.line).collect()
    }
}
