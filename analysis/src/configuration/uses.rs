//! What a section of the program takes from configuration files.

use std::sync::Arc;

use crate::catalogue::{self, ConfigElement, Effect, Entry, OperandKind};
use crate::database::{self, Db, NameRef, Project, Section};
use crate::semantics::constant::ConstExpr;
use crate::semantics::hir::{Instruction, Operand, StatementKind};
use crate::semantics::program;
use crate::semantics::scope::SymbolKind;
use crate::syntax::ast::{Columns, Expr, ExprKind, Line};
use crate::syntax::section::SectionKind;

/// What a section refers to, in order of its lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionUses {
    /// Identifiers in apostrophes.
    pub identifiers: Vec<IdentifierUse>,
    /// Messages it reports.
    pub messages: Vec<MessageUse>,
    /// Values of tables it reads and writes.
    pub cells: Vec<TableUse>,
    /// Serial ports.
    pub ports: Vec<PortUse>,
    /// Numbers the procedure of commands compares with.
    pub codes: Vec<CodeUse>,
    /// Constants that go into DR, where a message without number is taken from.
    pub loaded: Vec<i64>,
    /// Kinds of elements that it names by a text known at run time only.
    pub dynamic: Vec<ConfigElement>,
    /// It is the procedure that takes commands.
    pub takes_commands: bool,
    /// It hands the command on, so that others may look at it.
    pub hands_on: bool,
    /// Every line was understood.
    pub complete: bool,
}

/// Where in a section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UsePlace {
    /// 0-based own line.
    pub line: u32,
    /// Columns in it.
    pub columns: Columns,
}

/// An identifier in apostrophes.
#[derive(Clone, Debug, PartialEq)]
pub struct IdentifierUse {
    /// What it names.
    pub element: ConfigElement,
    /// Instruction that names it.
    pub entry: &'static str,
    /// The identifier.
    pub text: Arc<str>,
    /// Where, with the apostrophes.
    pub place: UsePlace,
    /// A value for the case that the configuration lacks it.
    pub has_default: bool,
    /// Width in bytes of the cell that takes the value (CONST_GET, CNF_GET_INT), when it has one.
    pub width: Option<u32>,
    /// Index of the table (PLCT_COL_INDEX).
    pub table: Option<i64>,
    /// The third operand, upper case: type of a logical element.
    pub kind: Option<String>,
    /// The first operand of DEF_IN and DEF_OUT: key of the cell they declare.
    pub cell: Option<String>,
}

/// A message.
#[derive(Clone, Debug, PartialEq)]
pub struct MessageUse {
    /// Instruction that reports it.
    pub entry: &'static str,
    /// Its number; `None` when it is known at run time only.
    pub number: Option<i64>,
    /// The number is in a cell, not in DR.
    pub in_cell: bool,
    /// The number, or the instruction.
    pub place: UsePlace,
    /// How many of par1 to par3 are given, and the last of them.
    pub values: Option<ValueUse>,
    /// `set` of ESET.
    pub set: Option<(i64, Columns)>,
    /// `mode` of EDEF.
    pub mode: Option<(i64, Columns)>,
}

/// Values handed to a message.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueUse {
    /// Which of par1, par2, par3 are given.
    pub given: [bool; 3],
    /// Columns of the first to the last of them; the instruction when there is none.
    pub columns: Columns,
}

/// A value of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableUse {
    /// Instruction.
    pub entry: &'static str,
    /// Index of the table, and its columns; `None` when it is known at run time only.
    pub table: Option<(i64, Columns)>,
    /// Column, when the instruction has one that is known.
    pub column: Option<ColumnUse>,
    /// The line.
    pub line: u32,
    /// Columns of the instruction.
    pub operation: Columns,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnUse {
    /// By its number.
    Number(i64, Columns),
    /// By its name, which PLCT_COL_INDEX turned into the cell that stands here.
    Named(String, Columns),
}

/// A serial port.
#[derive(Clone, Debug, PartialEq)]
pub struct PortUse {
    /// Its logical number.
    pub number: i64,
    /// Where.
    pub place: UsePlace,
}

/// A number that DR is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct CodeUse {
    /// The number.
    pub number: i64,
    /// Nothing before it in the procedure changes DR: it is the command that is compared.
    pub sure: bool,
    /// Where.
    pub place: UsePlace,
}

/// Collects what a section refers to.
pub(crate) fn collect(db: &dyn Db, project: Project, section: Section<'_>) -> SectionUses {
    let analysis = database::section_analysis(db, project, section);
    let commands = section.kind(db) == SectionKind::Procedure && &**section.name(db) == "_ON_CMD";
    let mut reader = Reader {
        db,
        project,
        section,
        lines: &database::section_lines(db, section).lines,
        named: None,
        command_in_dr: commands,
        out: SectionUses {
            takes_commands: commands,
            complete: analysis.body.complete,
            ..SectionUses::default()
        },
    };
    for statement in &analysis.body.statements {
        if !statement.labels.is_empty() {
            reader.named = None;
        }
        if let StatementKind::Instruction(instruction) = &statement.kind {
            reader.instruction(statement.line, instruction);
        }
    }
    reader.out
}

struct Reader<'db> {
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
    lines: &'db [Line],
    /// The last PLCT_COL_INDEX before: table, name, cell.
    named: Option<(Option<i64>, String, String)>,
    /// DR still holds the command.
    command_in_dr: bool,
    out: SectionUses,
}

/// One instruction with its source operands; a line that a macro made has none of its own.
#[derive(Clone, Copy)]
struct Step<'a> {
    entry: &'static catalogue::Entry,
    operands: &'a [Operand],
    source: &'a [Expr],
    line: u32,
    operation: &'a Columns,
}

const NOWHERE: Columns = 0..0;

impl Reader<'_> {
    fn instruction(&mut self, line: u32, instruction: &Instruction) {
        let entry = instruction.entry;
        let own = self.lines.get(line as usize);
        let operation = own.and_then(|own| own.operation.as_ref());
        let written = operation
            .is_some_and(|name| catalogue::entry(&name.text).is_some_and(|known| known.name == entry.name));
        let step = Step {
            entry,
            operands: &instruction.operands,
            source: own.filter(|_| written).map_or(&[], |own| own.operands.as_slice()),
            line,
            operation: operation.map_or(&NOWHERE, |name| &name.columns),
        };
        self.identifiers(step);
        match entry.name {
            "ESET" | "ESET1" => self.message(step, 0, Some(2), None, 3),
            "EDEF" => self.message(step, 2, None, Some(4), 5),
            "TEX0" | "TEX1" => self.timeout(step),
            "LOD" => self.out.loaded.extend(self.number(step, 0)),
            "EQ" if self.out.takes_commands => self.code(step),
            "STO" | "STO0" | "STO1" | "PROC_CALL" if self.out.takes_commands => self.out.hands_on = true,
            "COM_SEND" | "COM_SEND_STR" | "COM_RECV" | "COM_CONTROL" => self.port(step),
            name if name.starts_with("PLCT_") => self.table(step),
            _ => {}
        }
        self.command_in_dr &= !entry.writes.iter().any(|it| matches!(it, Effect::Dr | Effect::Dr64));
    }

    fn place(step: Step<'_>, index: usize) -> UsePlace {
        let columns = step.source.get(index).map_or(step.operation, |expr| &expr.columns);
        UsePlace { line: step.line, columns: columns.clone() }
    }

    /// The value of a constant operand.
    fn number(&self, step: Step<'_>, index: usize) -> Option<i64> {
        match step.operands.get(index) {
            Some(Operand::Integer { value, .. }) => return Some(*value),
            Some(Operand::Cell { .. } | Operand::Bit { .. } | Operand::Area { .. }) => return None,
            _ => {}
        }
        // Operands that the catalogue does not judge are not resolved.
        let constant = ConstExpr::read(step.source.get(index)?).ok()?;
        constant.value(&mut |name| program::constant(self.db, self.project, self.section, name)).ok()
    }

    /// Something stands at this place.
    fn given(step: Step<'_>, index: usize) -> bool {
        match step.source.get(index) {
            Some(expr) => !matches!(expr.kind, ExprKind::Missing | ExprKind::Dash | ExprKind::Error),
            None => step.operands.get(index).is_some_and(|operand| *operand != Operand::Skipped),
        }
    }

    fn identifiers(&mut self, step: Step<'_>) {
        for (index, spec) in step.entry.operands.iter().enumerate() {
            if let Some(element) = identifier(spec.kind) {
                self.identifier(step, index, element);
            }
        }
    }

    fn identifier(&mut self, step: Step<'_>, index: usize, element: ConfigElement) {
        let text = match (step.source.get(index).map(|expr| &expr.kind), step.operands.get(index)) {
            (Some(ExprKind::Text(text)), _) => Arc::from(text.as_str()),
            (None, Some(Operand::Text(text))) => text.clone(),
            _ => {
                if Self::given(step, index) {
                    self.out.dynamic.push(element);
                }
                return;
            }
        };
        let name = step.entry.name;
        let width = matches!(name, "CONST_GET" | "CNF_GET_INT").then(|| self.width(step)).flatten();
        let third = match step.source.get(2).map(|expr| &expr.kind) {
            Some(ExprKind::Name(name)) => Some(name.key()),
            _ => None,
        };
        let table = if element == ConfigElement::Column { self.number(step, 0) } else { None };
        if name == "PLCT_COL_INDEX"
            && let Some(ExprKind::Name(cell)) = step.source.get(2).map(|expr| &expr.kind)
        {
            self.named = Some((table, text.to_string(), cell.key()));
        }
        let cell = match step.source.first().map(|expr| &expr.kind).filter(|_| name.starts_with("DEF_")) {
            Some(ExprKind::Name(cell)) => Some(cell.key()),
            Some(ExprKind::Index { base, .. }) => match &base.kind {
                ExprKind::Name(cell) => Some(cell.key()),
                _ => None,
            },
            _ => None,
        };
        self.out.identifiers.push(IdentifierUse {
            element,
            entry: name,
            text,
            place: Self::place(step, index),
            has_default: name.starts_with("DEF_") || Self::given(step, 2),
            width,
            table,
            kind: third,
            cell,
        });
    }

    /// Width of the cell that is the first operand.
    fn width(&self, step: Step<'_>) -> Option<u32> {
        if let Some(Operand::Cell { width, .. }) = step.operands.first() {
            return Some(width.bytes());
        }
        let ExprKind::Name(name) = &step.source.first()?.kind else { return None };
        let file = self.section.file(self.db).order(self.db);
        let name = NameRef::new(self.db, Arc::from(name.key()), file);
        match database::lookup(self.db, self.project, name).as_ref()?.kind {
            SymbolKind::Cell(width) => Some(width.bytes()),
            _ => None,
        }
    }

    fn message(
        &mut self,
        step: Step<'_>,
        error: usize,
        set: Option<usize>,
        mode: Option<usize>,
        first: usize,
    ) {
        let number = if Self::given(step, error) { self.number(step, error) } else { None };
        let one = |index: Option<usize>| {
            let index = index?;
            Some((self.number(step, index)?, Self::place(step, index).columns))
        };
        let given = [first, first + 1, first + 2].map(|index| Self::given(step, index));
        let parts = (first..first + 3).filter_map(|index| step.source.get(index));
        let columns = parts.fold(None::<Columns>, |all, expr| {
            Some(all.map_or(expr.columns.start, |all| all.start)..expr.columns.end)
        });
        let place = if number.is_some() {
            Self::place(step, error)
        } else {
            UsePlace { line: step.line, columns: step.operation.clone() }
        };
        let values = ValueUse { given, columns: columns.unwrap_or_else(|| place.columns.clone()) };
        let (set, mode) = (one(set), one(mode));
        let in_cell = number.is_none() && Self::given(step, error);
        let (entry, values) = (step.entry.name, Some(values));
        self.out.messages.push(MessageUse { entry, number, in_cell, place, values, set, mode });
    }

    /// The number that TEX leaves in DR when the time is over.
    fn timeout(&mut self, step: Step<'_>) {
        if let Some(number) = self.number(step, 3).filter(|_| Self::given(step, 3)) {
            let place = Self::place(step, 3);
            let entry = step.entry.name;
            let number = Some(number);
            let (in_cell, values) = (false, None);
            self.out.messages.push(MessageUse {
                entry,
                number,
                in_cell,
                place,
                values,
                set: None,
                mode: None,
            });
        }
    }

    fn code(&mut self, step: Step<'_>) {
        if let Some(number) = self.number(step, 0) {
            let sure = self.command_in_dr;
            self.out.codes.push(CodeUse { number, sure, place: Self::place(step, 0) });
        }
    }

    fn port(&mut self, step: Step<'_>) {
        if let Some(number) = self.number(step, 0) {
            self.out.ports.push(PortUse { number, place: Self::place(step, 0) });
        }
    }

    fn table(&mut self, step: Step<'_>) {
        let table = self.number(step, 0).map(|table| (table, Self::place(step, 0).columns));
        let index = match step.entry.name {
            "PLCT_COL_TYPE" => Some(1),
            name if name.starts_with("PLCT_GET_") || name.starts_with("PLCT_SET_") => {
                (!name.ends_with("SELLINE") && !name.ends_with("LINESCOUNT")).then_some(2)
            }
            _ => None,
        };
        let column = index.and_then(|index| {
            let columns = Self::place(step, index).columns;
            if let Some(number) = self.number(step, index) {
                return Some(ColumnUse::Number(number, columns));
            }
            let ExprKind::Name(cell) = &step.source.get(index)?.kind else { return None };
            let (known, name, into) = self.named.as_ref()?;
            let same = *into == cell.key() && *known == table.as_ref().map(|(table, _)| *table);
            same.then(|| ColumnUse::Named(name.clone(), columns))
        });
        let (entry, line, operation) = (step.entry.name, step.line, step.operation.clone());
        self.out.cells.push(TableUse { entry, table, column, line, operation });
    }
}

/// What the text at an operand of an instruction names in the configuration.
pub(crate) fn element_at(entry: &Entry, index: usize) -> Option<ConfigElement> {
    entry.operands.get(index).and_then(|spec| identifier(spec.kind))
}

/// What an operand names in the configuration.
pub(crate) fn identifier(kind: OperandKind) -> Option<ConfigElement> {
    match kind {
        OperandKind::Identifier(element) => Some(element),
        OperandKind::OneOf(kinds) => kinds.iter().find_map(|kind| identifier(*kind)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The catalogue alone says which operands name configuration: one that it forgets would be judged no more.
    #[test]
    fn the_catalogue_says_what_the_second_operand_names() {
        for (names, element) in [
            ("MAP_IN", ConfigElement::Input),
            ("MAP_OUT", ConfigElement::Output),
            ("MAP_AIN", ConfigElement::AnalogInput),
            ("MAP_AOUT", ConfigElement::AnalogOutput),
            ("DEF_IN", ConfigElement::LogicalInput),
            ("DEF_OUT", ConfigElement::LogicalOutput),
            ("CNF_GET_INT CNF_GET_REAL CNF_GET_STR CNF_GET_BIN CNF_GET_BIT", ConfigElement::Parameter),
            ("CONST_GET", ConfigElement::Constant),
            ("PLCT_COL_INDEX", ConfigElement::Column),
        ] {
            for name in names.split(' ') {
                let entry = catalogue::entry(name).expect(name);
                assert_eq!(element_at(entry, 1), Some(element), "{name}");
            }
        }
    }
}
