//! What the analysis of one section gives.

use super::hir::{Body, SymbolKey};
pub use super::identifiers::{IdentifierText, IdentifierUse};
use super::reference::Reference;
use crate::diagnostics::Finding;
use crate::syntax::ast::Columns;

/// The code of one section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionAnalysis {
    /// Mistakes, in line order.
    pub findings: Vec<Finding>,
    /// Resolved statements.
    pub body: Body,
    /// Uses of names, in order of the text.
    pub references: Vec<Reference>,
    /// Accesses that end outside the declared memory of their symbol.
    pub overruns: Vec<Overrun>,
    /// Identifiers of the configuration in it, in order of the text.
    pub identifiers: Vec<IdentifierUse>,
    /// Records of two bytes that begin at the last byte of their symbol.
    pub records: Vec<Record>,
    /// Uses of devices that other sections must match.
    pub devices: Vec<DeviceUse>,
    /// Procedures it calls, with the place of the call.
    pub calls: Vec<(SymbolKey, u32, Columns)>,
}

/// An access that ends outside the declared memory of its symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overrun {
    /// 0-based own line.
    pub line: u32,
    /// Columns of the operand.
    pub columns: Columns,
    /// The symbol.
    pub symbol: SymbolKey,
    /// Byte offset of the access from the symbol.
    pub offset: i64,
    /// Its length in bytes.
    pub bytes: u32,
    /// Length declared for the symbol in bytes.
    pub declared: u32,
    /// Line and columns in the expansion of the section, when it stands in one.
    pub expanded: Option<(u32, Columns)>,
}

/// A record of two bytes (POS_MODE, POS_CONTROL) whose second byte is what is declared next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// 0-based own line.
    pub line: u32,
    /// Columns of the operand.
    pub columns: Columns,
    /// The symbol of its first byte.
    pub symbol: SymbolKey,
    /// The instruction that takes it.
    pub instruction: &'static str,
}

/// A use of a device.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceUse {
    /// 0-based own line.
    pub line: u32,
    /// Columns of the operation.
    pub columns: Columns,
    /// What it does.
    pub device: Device,
}

/// What an instruction does with a device. Axes are 1 to 16, 0 when not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, salsa::SalsaValue)]
pub enum Device {
    /// POS_INIT.
    Init {
        /// The axis.
        axis: u8,
        /// POS_INIT_X to POS_INIT_6.
        older: bool,
    },
    /// POS_RESET of an axis.
    Reset(u8),
    /// POS_MODE of an axis.
    Mode(u8),
    /// POS_CONTROL of an axis.
    Control(u8),
    /// ANALOG_PORT.
    Port,
    /// ANALOG to the port of ANALOG_PORT.
    Analog,
    /// AX_SPI.
    Spindle,
    /// A write to SIM_SPEED_PT.
    SimulatedSpeed,
}
