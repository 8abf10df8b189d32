//! What the control has on its disk: configuration parameters, constants, tables, backed-up memory.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use crate::motion::config::Gear;

use super::board::MessageText;
use super::elements::ChannelWiring;

/// Data of the control. Texts are in the code page of the control. Identifiers are distinguished by case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ControlData {
    /// `PlcParam` elements by identifier (manual 16.1).
    pub parameters: BTreeMap<Vec<u8>, Value>,
    /// Constants by identifier, numbered ones with their number (manual 16.2).
    pub constants: BTreeMap<Vec<u8>, i64>,
    /// Texts and properties of messages by number (manual 14.4).
    pub messages: BTreeMap<u32, MessageText>,
    /// PLC tables in order of their numbers (manual 17).
    pub tables: Vec<Table>,
    /// PLC_MEM_BACKUP as it was saved last; missing bytes are 0 (manual 18.1).
    pub backup: Vec<u8>,
    /// Where identifiers of inputs and outputs lead (manual 10 and 27.5).
    pub wiring: ChannelWiring,
    /// M functions and their groups (`MFunctions`, manual 8.3.5); those that cannot be are left out.
    pub m_groups: Vec<(u8, u8)>,
    /// Gears of spindles (`Spindle`, manual 12); what is out of range is left out.
    pub gears: Vec<SpindleGears>,
}

/// Gears of a spindle.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SpindleGears {
    /// 1 or 2.
    pub spindle: u8,
    /// Greatest programmed speed in rev/min; 0: that of the fastest gear.
    pub speed_limit: u32,
    /// The lowest first.
    pub gears: Vec<Gear>,
}

impl ControlData {
    /// What is known of a message.
    #[must_use]
    pub fn message(&self, number: u32) -> Option<&MessageText> {
        self.messages.get(&number)
    }
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

/// A value that lies somewhere else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Content<'a> {
    Int(i64),
    Real(f64),
    Text(&'a [u8]),
    Bytes(&'a [u8]),
}

impl Content<'_> {
    fn kind(self) -> ValueKind {
        match self {
            Content::Int(_) => ValueKind::Int,
            Content::Real(_) => ValueKind::Real,
            Content::Text(_) => ValueKind::Text,
            Content::Bytes(_) => ValueKind::Bytes,
        }
    }

    fn to_value(self) -> Value {
        match self {
            Content::Int(value) => Value::Int(value),
            Content::Real(value) => Value::Real(value),
            Content::Text(text) => Value::Text(text.to_vec()),
            Content::Bytes(bytes) => Value::Bytes(bytes.to_vec()),
        }
    }
}

impl Value {
    /// The value itself.
    pub(super) fn content(&self) -> Content<'_> {
        match self {
            Value::Int(value) => Content::Int(*value),
            Value::Real(value) => Content::Real(*value),
            Value::Text(text) => Content::Text(text),
            Value::Bytes(bytes) => Content::Bytes(bytes),
        }
    }

    /// Takes another value, in the memory of this one if it is of its type.
    fn assign(&mut self, content: Content<'_>) {
        match (&mut *self, content) {
            (Value::Text(own), Content::Text(bytes)) | (Value::Bytes(own), Content::Bytes(bytes)) => {
                own.clear();
                own.extend_from_slice(bytes);
            }
            (own, content) => *own = content.to_value(),
        }
    }

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

    fn empty_content(self) -> Content<'static> {
        match self {
            ValueKind::Int => Content::Int(0),
            ValueKind::Real => Content::Real(0.0),
            ValueKind::Text => Content::Text(&[]),
            ValueKind::Bytes => Content::Bytes(&[]),
        }
    }
}

impl Table {
    /// A value; `None` outside the table.
    #[must_use]
    pub fn value(&self, row: usize, column: usize) -> Option<Value> {
        self.content(row, column).map(Content::to_value)
    }

    /// The same where it lies.
    pub(super) fn content(&self, row: usize, column: usize) -> Option<Content<'_>> {
        let kind = self.columns.get(column)?.kind;
        let value = self.rows.get(row)?.get(column).filter(|value| value.kind() == kind);
        Some(value.map_or(kind.empty_content(), Value::content))
    }

    /// Replaces a value; false, and nothing happens, outside the table and when the type is not that of the column.
    #[allow(clippy::needless_pass_by_value)] // a value is given away, whether or not its memory is used
    pub fn set(&mut self, row: usize, column: usize, value: Value) -> bool {
        self.put(row, column, value.content())
    }

    pub(super) fn put(&mut self, row: usize, column: usize, content: Content<'_>) -> bool {
        if self.columns.get(column).is_none_or(|column| column.kind != content.kind()) {
            return false;
        }
        let Some(values) = self.rows.get_mut(row) else { return false };
        for column in self.columns.iter().take(column + 1).skip(values.len()) {
            values.push(column.kind.empty());
        }
        let changed = values.get_mut(column).map(|place| place.assign(content));
        changed.is_some()
    }

    /// Makes room for texts and blocks of so many bytes in all its cells, so that writing one needs no memory.
    pub(super) fn reserve(&mut self, len: usize) {
        for row in &mut self.rows {
            row.reserve_exact(self.columns.len().saturating_sub(row.len()));
            for value in row {
                if let Value::Text(own) | Value::Bytes(own) = value {
                    own.reserve_exact(len.saturating_sub(own.len()));
                }
            }
        }
    }
}
