//! What the control has on its disk: configuration parameters, constants, tables, backed-up memory.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use super::elements::ChannelWiring;

/// Data of the control. Texts are in the code page of the control. Identifiers are distinguished by case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ControlData {
    /// `PlcParam` elements by identifier (manual 16.1).
    pub parameters: BTreeMap<Vec<u8>, Value>,
    /// Constants by identifier, numbered ones with their number (manual 16.2).
    pub constants: BTreeMap<Vec<u8>, i64>,
    /// PLC tables in order of their numbers (manual 17).
    pub tables: Vec<Table>,
    /// PLC_MEM_BACKUP as it was saved last; missing bytes are 0 (manual 18.1).
    pub backup: Vec<u8>,
    /// Where identifiers of inputs and outputs lead (manual 10 and 27.5).
    pub wiring: ChannelWiring,
}

/// A value of one of the four types.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Integer.
    Int(i64),
    /// Real number.
    Real(f64),
    /// Text without end mark.
    Text(Vec<u8>),
    /// Bytes.
    Bytes(Vec<u8>),
}

/// Type of a [`Value`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueKind {
    /// Integer.
    Int,
    /// Real number.
    Real,
    /// Text.
    Text,
    /// Bytes.
    Bytes,
}

/// A PLC table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Columns from 0.
    pub columns: Vec<Column>,
    /// Rows from 0; a row that is too short, or holds a value of another type, reads as 0 or empty there.
    pub rows: Vec<Vec<Value>>,
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its identifier.
    pub id: Vec<u8>,
    /// Type of its values.
    pub kind: ValueKind,
}

impl Value {
    /// Its type.
    #[must_use]
    pub fn kind(&self) -> ValueKind {
        match self {
            Value::Int(_) => ValueKind::Int,
            Value::Real(_) => ValueKind::Real,
            Value::Text(_) => ValueKind::Text,
            Value::Bytes(_) => ValueKind::Bytes,
        }
    }
}

impl ValueKind {
    /// 0 or nothing.
    #[must_use]
    pub fn empty(self) -> Value {
        match self {
            ValueKind::Int => Value::Int(0),
            ValueKind::Real => Value::Real(0.0),
            ValueKind::Text => Value::Text(Vec::new()),
            ValueKind::Bytes => Value::Bytes(Vec::new()),
        }
    }
}

impl Table {
    /// A value; `None` outside the table.
    #[must_use]
    pub fn value(&self, row: usize, column: usize) -> Option<Value> {
        let kind = self.columns.get(column)?.kind;
        let value = self.rows.get(row)?.get(column).filter(|value| value.kind() == kind);
        Some(value.cloned().unwrap_or_else(|| kind.empty()))
    }

    /// Replaces a value; false, and nothing happens, outside the table and when the type is not that of the column.
    pub fn set(&mut self, row: usize, column: usize, value: Value) -> bool {
        if self.columns.get(column).is_none_or(|column| column.kind != value.kind()) {
            return false;
        }
        let Some(values) = self.rows.get_mut(row) else { return false };
        for column in self.columns.iter().take(column + 1).skip(values.len()) {
            values.push(column.kind.empty());
        }
        let changed = values.get_mut(column).map(|place| *place = value);
        changed.is_some()
    }
}
