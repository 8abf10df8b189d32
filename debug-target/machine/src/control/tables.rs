//! PLC tables (manual 17). Each instruction takes a cycle; its operands are read when it begins.

use alloc::vec::Vec;

use technol_image::service::Service;
use technol_runtime::{Call, FaultKind};

use super::data::{Column, Content, Table, Value, ValueKind};
use super::operand;
use super::transfer::Transfers;

/// What DR tells.
const NO_TABLE: i64 = 1;
const NO_LINE: i64 = 2;
const NO_COLUMN: i64 = 3;
const OTHER_TYPE: i64 = 4;

/// PlctItemChanged, PlctSellLineChanged.
const ITEM_CHANGED: i64 = 1;
const LINE_CHANGED: i64 = 2;

/// The state of tables besides their content, and the transfers.
#[derive(Clone, Debug, Default)]
pub(super) struct Tables {
    /// Of each table somebody looked at.
    views: Vec<View>,
    transfers: Transfers<Request>,
    /// Bytes of the longest text or block that the program writes.
    longest: usize,
}

/// What the operator does with a table.
#[derive(Clone, Copy, Debug, Default)]
struct View {
    selected: usize,
    item_changed: bool,
    line_changed: bool,
}

/// The operands of an instruction.
#[derive(Clone, Debug, Default)]
struct Request {
    table: usize,
    line: usize,
    column: usize,
    /// What is written.
    written: Written,
    /// A text or block that is written, or the identifier of a column.
    bytes: Vec<u8>,
}

/// What an instruction writes.
#[derive(Clone, Copy, Debug, Default)]
enum Written {
    #[default]
    Nothing,
    Int(i64),
    Real(f64),
    Text,
    Bytes,
}

/// What an instruction found.
enum Found<'a> {
    Nothing,
    Value(Content<'a>),
}

impl Tables {
    /// Makes room for an instruction on tables; `len`: bytes of its longest text or block.
    pub(super) fn prepare(&mut self, call: u16, service: Service, len: usize) {
        self.transfers.prepare(call, Request { bytes: Vec::with_capacity(len), ..Request::default() });
        if matches!(service, Service::PlctSetStr | Service::PlctSetBin) {
            self.longest = self.longest.max(len);
        }
    }

    /// A start of the PLC: transfers of the run before are forgotten, and all is laid out that the program may write.
    pub(super) fn start(&mut self, tables: &mut [Table]) {
        self.transfers.forget();
        if self.views.len() < tables.len() {
            self.views.resize(tables.len(), View::default());
        }
        if self.longest > 0 {
            for table in tables {
                table.reserve(self.longest);
            }
        }
    }

    /// The operator changes a value; false when there is no such place or it is of another type.
    pub(super) fn edit(&mut self, tables: &mut [Table], at: [usize; 3], value: Value) -> bool {
        let [table, line, column] = at;
        let done = tables.get_mut(table).is_some_and(|table| table.set(line, column, value));
        if done {
            view(&mut self.views, table).item_changed = true;
        }
        done
    }

    /// The operator selects a line; false when there is none.
    pub(super) fn select(&mut self, tables: &[Table], table: usize, line: usize) -> bool {
        let found = tables.get(table).is_some_and(|table| line < table.rows.len());
        if found {
            let view = view(&mut self.views, table);
            view.line_changed |= view.selected != line;
            view.selected = line;
        }
        found
    }

    /// An instruction: RLO 0 and DR 0 while it is under way, then RLO 1 and DR 0 or the number of an error.
    pub(super) fn execute(&mut self, tables: &mut [Table], call: &mut Call<'_>) -> Result<(), FaultKind> {
        if !self.transfers.is_under_way(call) {
            self.transfers.begin(call, |request| request.take(call))?;
        }
        call.set_dr(0);
        let ended = self.transfers.end(call);
        call.set_rlo(ended.is_some());
        let Some(request) = ended else { return Ok(()) };
        match carry_out(&mut self.views, tables, request, call.service()) {
            Ok(Found::Value(content)) => operand::store(call, target(call.service()), content)?,
            Ok(Found::Nothing) => {}
            Err(error) => call.set_dr(error),
        }
        Ok(())
    }
}

/// Whether it is an instruction of tables.
pub(super) fn is_table(service: Service) -> bool {
    matches!(
        service,
        Service::PlctColIndex
            | Service::PlctColId
            | Service::PlctColType
            | Service::PlctGetSelline
            | Service::PlctSetSelline
            | Service::PlctChanged
            | Service::PlctGetLinescount
            | Service::PlctGetInt
            | Service::PlctGetReal
            | Service::PlctGetStr
            | Service::PlctGetBin
            | Service::PlctSetInt
            | Service::PlctSetReal
            | Service::PlctSetStr
            | Service::PlctSetBin
    )
}

/// Does what an instruction asks for, or tells the number of an error.
fn carry_out<'a>(
    views: &mut Vec<View>,
    tables: &'a mut [Table],
    request: &'a Request,
    service: Service,
) -> Result<Found<'a>, i64> {
    let Request { line, column, ref bytes, .. } = *request;
    let table = tables.get_mut(request.table).ok_or(NO_TABLE)?;
    let number = |n: usize| Found::Value(Content::Int(n as i64));
    Ok(match service {
        Service::PlctColIndex => {
            number(table.columns.iter().position(|column| column.id == *bytes).ok_or(NO_COLUMN)?)
        }
        Service::PlctColId => Found::Value(Content::Text(&table.columns.get(column).ok_or(NO_COLUMN)?.id)),
        Service::PlctColType => number(type_number(table.columns.get(column).ok_or(NO_COLUMN)?)),
        Service::PlctGetLinescount => number(table.rows.len()),
        Service::PlctGetSelline => {
            let selected = view(views, request.table).selected;
            number(Some(selected).filter(|line| *line < table.rows.len()).ok_or(NO_LINE)?)
        }
        Service::PlctSetSelline => {
            if line >= table.rows.len() {
                return Err(NO_LINE);
            }
            view(views, request.table).selected = line;
            Found::Nothing
        }
        Service::PlctChanged => Found::Value(Content::Int(view(views, request.table).take_change())),
        _ => {
            let kind = table.columns.get(column).ok_or(NO_COLUMN)?.kind;
            if table.content(line, column).is_none() {
                return Err(NO_LINE);
            }
            if kind != cell_kind(service) {
                return Err(OTHER_TYPE);
            }
            match request.written() {
                Some(content) => {
                    table.put(line, column, content);
                    Found::Nothing
                }
                None => table.content(line, column).map_or(Found::Nothing, Found::Value),
            }
        }
    })
}

fn view(views: &mut Vec<View>, table: usize) -> &mut View {
    if views.len() <= table {
        views.resize(table + 1, View::default());
    }
    &mut views[table]
}

impl View {
    /// What the operator has changed since the last question, the item first.
    fn take_change(&mut self) -> i64 {
        if core::mem::take(&mut self.item_changed) {
            ITEM_CHANGED
        } else if core::mem::take(&mut self.line_changed) {
            LINE_CHANGED
        } else {
            0
        }
    }
}

impl Request {
    /// Takes the operands.
    fn take(&mut self, call: &Call<'_>) -> Result<(), FaultKind> {
        // A negative number leads nowhere, as one that is too large.
        let number = |n: usize| Ok(usize::try_from(unsigned(call, n)?).unwrap_or(usize::MAX));
        (self.table, self.line, self.column, self.written) = (number(0)?, 0, 0, Written::Nothing);
        self.bytes.clear();
        match call.service() {
            Service::PlctColIndex => self.bytes.extend_from_slice(call.text(1)?.unwrap_or_default()),
            Service::PlctColId => {
                self.column = usize::try_from(operand::integer(call, 1)?).unwrap_or(usize::MAX);
            }
            Service::PlctColType => self.column = number(1)?,
            Service::PlctSetSelline => self.line = number(1)?,
            Service::PlctGetSelline | Service::PlctChanged | Service::PlctGetLinescount => {}
            _ => {
                (self.line, self.column) = (number(1)?, number(2)?);
                self.take_value(call)?;
            }
        }
        Ok(())
    }

    /// What a PLCT_SET_ of a value writes.
    fn take_value(&mut self, call: &Call<'_>) -> Result<(), FaultKind> {
        self.written = match call.service() {
            Service::PlctSetInt => Written::Int(i64::from(operand::integer(call, 3)? as i32)),
            Service::PlctSetReal => Written::Real(operand::real(call, 3)?),
            Service::PlctSetStr => {
                self.bytes.extend_from_slice(call.text(3)?.unwrap_or_default());
                Written::Text
            }
            Service::PlctSetBin => {
                self.bytes.extend_from_slice(call.content(3)?);
                Written::Bytes
            }
            _ => Written::Nothing,
        };
        Ok(())
    }

    fn written(&self) -> Option<Content<'_>> {
        Some(match self.written {
            Written::Nothing => return None,
            Written::Int(value) => Content::Int(value),
            Written::Real(value) => Content::Real(value),
            Written::Text => Content::Text(&self.bytes),
            Written::Bytes => Content::Bytes(&self.bytes),
        })
    }
}

/// A table, line or column: cells are read without sign.
fn unsigned(call: &Call<'_>, n: usize) -> Result<i64, FaultKind> {
    let value = call.integer(n)?.unwrap_or(0);
    Ok(match call.arg(n) {
        technol_image::service::Arg::Cell { width, neg: false, .. } if width.bits() < 64 => {
            value & ((1 << width.bits()) - 1)
        }
        _ => value,
    })
}

/// Type of the column an instruction needs.
fn cell_kind(service: Service) -> ValueKind {
    match service {
        Service::PlctGetReal | Service::PlctSetReal => ValueKind::Real,
        Service::PlctGetStr | Service::PlctSetStr => ValueKind::Text,
        Service::PlctGetBin | Service::PlctSetBin => ValueKind::Bytes,
        _ => ValueKind::Int,
    }
}

/// PlcTabType_…
fn type_number(column: &Column) -> usize {
    match column.kind {
        ValueKind::Int => 1,
        ValueKind::Real => 2,
        ValueKind::Text => 3,
        ValueKind::Bytes => 4,
    }
}

/// Which operand gets the result.
fn target(service: Service) -> usize {
    match service {
        Service::PlctColIndex | Service::PlctColType => 2,
        Service::PlctGetInt | Service::PlctGetReal | Service::PlctGetStr | Service::PlctGetBin => 3,
        _ => 1,
    }
}
