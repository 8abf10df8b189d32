//! PLC tables (manual 17). Each instruction takes a cycle; its operands are read when it begins.

use alloc::vec::Vec;

use technol_image::service::Service;
use technol_runtime::{Call, FaultKind};

use super::data::{Column, Table, Value, ValueKind};
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
}

/// What the operator does with a table.
#[derive(Clone, Copy, Debug, Default)]
struct View {
    selected: usize,
    item_changed: bool,
    line_changed: bool,
}

/// The operands of an instruction.
#[derive(Clone, Debug)]
struct Request {
    table: usize,
    line: usize,
    column: usize,
    /// What is written.
    value: Option<Value>,
    /// Identifier of a column.
    id: Vec<u8>,
}

impl Tables {
    /// Transfers of the run before are forgotten.
    pub(super) fn start(&mut self) {
        self.transfers = Transfers::default();
    }

    /// The operator changes a value; false when there is no such place or it is of another type.
    pub(super) fn edit(&mut self, tables: &mut [Table], at: [usize; 3], value: Value) -> bool {
        let [table, line, column] = at;
        let done = tables.get_mut(table).is_some_and(|table| table.set(line, column, value));
        if done {
            self.view(table).item_changed = true;
        }
        done
    }

    /// The operator selects a line; false when there is none.
    pub(super) fn select(&mut self, tables: &[Table], table: usize, line: usize) -> bool {
        let found = tables.get(table).is_some_and(|table| line < table.rows.len());
        if found {
            let view = self.view(table);
            view.line_changed |= view.selected != line;
            view.selected = line;
        }
        found
    }

    /// An instruction: RLO 0 and DR 0 while it is under way, then RLO 1 and DR 0 or the number of an error.
    pub(super) fn execute(&mut self, tables: &mut [Table], call: &mut Call<'_>) -> Result<(), FaultKind> {
        if !self.transfers.is_under_way(call) {
            self.transfers.begin(call, Request::of(call)?);
        }
        let ended = self.transfers.end(call);
        let result = ended.map(|request| self.carry_out(tables, &request, call.service()));
        call.set_rlo(result.is_some());
        match result {
            Some(Err(error)) => call.set_dr(error),
            Some(Ok(Some(value))) => {
                call.set_dr(0);
                operand::store(call, target(call.service()), &value)?;
            }
            Some(Ok(None)) | None => call.set_dr(0),
        }
        Ok(())
    }

    /// The value for the target, when the instruction has one.
    fn carry_out(
        &mut self,
        tables: &mut [Table],
        request: &Request,
        service: Service,
    ) -> Result<Option<Value>, i64> {
        let Request { line, column, ref id, .. } = *request;
        let table = tables.get_mut(request.table).ok_or(NO_TABLE)?;
        let of_column = |column: usize| table.columns.get(column).ok_or(NO_COLUMN);
        let number = |n: usize| Some(Value::Int(n as i64));
        Ok(match service {
            Service::PlctColIndex => {
                number(table.columns.iter().position(|column| column.id == *id).ok_or(NO_COLUMN)?)
            }
            Service::PlctColId => Some(Value::Text(of_column(column)?.id.clone())),
            Service::PlctColType => number(type_number(of_column(column)?)),
            Service::PlctGetLinescount => number(table.rows.len()),
            Service::PlctGetSelline => {
                let selected = self.view(request.table).selected;
                number(Some(selected).filter(|line| *line < table.rows.len()).ok_or(NO_LINE)?)
            }
            Service::PlctSetSelline => {
                if line >= table.rows.len() {
                    return Err(NO_LINE);
                }
                self.view(request.table).selected = line;
                None
            }
            Service::PlctChanged => Some(Value::Int(self.view(request.table).take_change())),
            _ => {
                let kind = of_column(column)?.kind;
                let found = table.value(line, column).ok_or(NO_LINE)?;
                if kind != cell_kind(service) {
                    return Err(OTHER_TYPE);
                }
                match &request.value {
                    Some(value) => {
                        table.set(line, column, value.clone());
                        None
                    }
                    None => Some(found),
                }
            }
        })
    }

    fn view(&mut self, table: usize) -> &mut View {
        if self.views.len() <= table {
            self.views.resize(table + 1, View::default());
        }
        &mut self.views[table]
    }
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
    fn of(call: &Call<'_>) -> Result<Request, FaultKind> {
        // A negative number leads nowhere, as one that is too large.
        let number = |n: usize| Ok(usize::try_from(unsigned(call, n)?).unwrap_or(usize::MAX));
        let nothing = Request { table: number(0)?, line: 0, column: 0, value: None, id: Vec::new() };
        Ok(match call.service() {
            Service::PlctColIndex => Request { id: call.text(1)?.unwrap_or_default().to_vec(), ..nothing },
            Service::PlctColId => {
                let index = operand::integer(call, 1)?;
                Request { column: usize::try_from(index).unwrap_or(usize::MAX), ..nothing }
            }
            Service::PlctColType => Request { column: number(1)?, ..nothing },
            Service::PlctSetSelline => Request { line: number(1)?, ..nothing },
            Service::PlctGetSelline | Service::PlctChanged | Service::PlctGetLinescount => nothing,
            _ => Request { line: number(1)?, column: number(2)?, value: written(call)?, ..nothing },
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

/// What a PLCT_SET_ of a value writes.
fn written(call: &Call<'_>) -> Result<Option<Value>, FaultKind> {
    Ok(Some(match call.service() {
        Service::PlctSetInt => Value::Int(i64::from(operand::integer(call, 3)? as i32)),
        Service::PlctSetReal => Value::Real(operand::real(call, 3)?),
        Service::PlctSetStr => Value::Text(call.text(3)?.unwrap_or_default().to_vec()),
        Service::PlctSetBin => Value::Bytes(call.content(3)?.to_vec()),
        _ => return Ok(None),
    }))
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
