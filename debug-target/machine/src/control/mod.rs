//! The simulated control around a program: it carries out what the runtime leaves to a
//! [`Control`](technol_runtime::Control). One file for each family of instructions.

use technol_image::service::Service;
use technol_runtime::{Call, Control, ControlMessage, FaultKind, Rate};

mod backup;
mod configuration;
mod data;
mod messages;
mod operand;
mod shared;
mod tables;
mod transfer;

use messages::Messages;
use shared::SharedMemory;
use tables::Tables;

pub use data::{Column, ControlData, Table, Value, ValueKind};
pub use shared::Shared;

/// The control. Deterministic; a clone is a snapshot.
#[derive(Clone, Debug, Default)]
pub struct SimulatedControl {
    data: ControlData,
    messages: Messages,
    shared: SharedMemory,
    tables: Tables,
    /// PLC_MEM_BACKUP was saved so many times.
    saved: u64,
}

impl SimulatedControl {
    /// A control as at power-on.
    #[must_use]
    pub fn new() -> SimulatedControl {
        SimulatedControl::default()
    }

    /// What it has on its disk; tables and backed-up memory change while programs run.
    #[must_use]
    pub fn data(&self) -> &ControlData {
        &self.data
    }

    /// Replaces what it has on its disk.
    pub fn set_data(&mut self, data: ControlData) {
        self.data = data;
    }

    /// What the program published by SHARE_VAR and SHARE_BIT.
    #[must_use]
    pub fn shared(&self) -> &[Shared] {
        self.shared.names()
    }

    /// Shared area 0 or 1, as screens read and write it.
    pub fn shared_area_mut(&mut self, area: usize) -> Option<&mut [u8]> {
        self.shared.area_mut(area)
    }

    /// The operator changes a value of a table; false when there is no such place or it is of another type.
    pub fn edit_table(&mut self, table: usize, row: usize, column: usize, value: Value) -> bool {
        self.tables.edit(&mut self.data.tables, [table, row, column], value)
    }

    /// The operator selects a row of a table; false when there is none.
    pub fn select_row(&mut self, table: usize, row: usize) -> bool {
        self.tables.select(&self.data.tables, table, row)
    }

    /// Saves PLC_MEM_BACKUP, as at a regular end.
    pub fn save_backup(&mut self, memory: &[u8]) {
        backup::save(&mut self.data.backup, memory);
        self.saved += 1;
    }

    /// How many times PLC_MEM_BACKUP was saved.
    #[must_use]
    pub fn times_saved(&self) -> u64 {
        self.saved
    }
}

impl Control for SimulatedControl {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        match call.service() {
            Service::Edef => self.messages.watch(call),
            Service::CnfGetInt
            | Service::CnfGetReal
            | Service::CnfGetStr
            | Service::CnfGetBin
            | Service::CnfGetBit => configuration::parameter(&self.data, call),
            Service::ConstGet => configuration::constant(&self.data, call),
            Service::ShareVar | Service::ShareBit => self.shared.share(call),
            Service::SaRead | Service::SaWrite => self.shared.exchange(call),
            other if other.name().starts_with("PLCT_") => self.tables.execute(&mut self.data.tables, call),
            other => Err(FaultKind::NoService(other)),
        }
    }

    fn outputs(&mut self, rate: Rate, _millis: u64, memory: &mut [u8]) {
        if rate == Rate::Slow {
            self.messages.look(memory);
            if backup::take_request(memory) {
                self.save_backup(memory);
            }
        }
    }

    fn next_message(&mut self) -> Option<ControlMessage> {
        self.messages.next()
    }

    fn start(&mut self, cold: bool) {
        self.messages = Messages::default();
        self.shared.start(cold);
        self.tables.start();
    }

    fn power_on(&mut self, memory: &mut [u8]) {
        backup::load(&self.data.backup, memory);
    }
}
