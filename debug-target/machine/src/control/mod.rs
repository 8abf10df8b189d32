//! The simulated control around a program: it carries out what the runtime leaves to a
//! [`Control`](technol_runtime::Control). One file for each family of instructions.

use alloc::vec::Vec;

use technol_image::service::{Arg, Service, ServiceCall};
use technol_image::system::{self, devices};
use technol_runtime::{
    AxesOfBlock, BlockMotion, BlockSpindle, BlockWay, Call, Control, ControlCall, ControlMessage, FaultKind,
    Hold, Rate,
};

use crate::config::MachineConfig;
use crate::fault::BusFault;
use crate::motion::{BlockState, Cells, Motion};
use crate::signal::{BUS_INPUTS, BUS_OUTPUTS, OUTPUT_PORTS, Signal};

mod axes;
mod backup;
mod board;
mod can;
pub(crate) mod clock;
pub(crate) mod config;
mod configuration;
mod data;
mod edrv;
pub(crate) mod elements;
pub(crate) mod ethercat;
mod faults;
mod licence;
mod messages;
mod objects;
mod operand;
mod serial;
mod shared;
mod state_machine;
mod tables;
mod transfer;

use edrv::Edrv;
use elements::Elements;
pub use elements::{
    Analog, ChannelWiring, Connection, Conversion, ElementError, ElementValue, Mapping, Physical,
};
use messages::Messages;
use shared::SharedMemory;
use tables::Tables;

pub use board::{MessageBoard, MessageKind, MessageText, Shown};
pub use data::{Column, ControlData, SpindleGears, Table, Value, ValueKind};
pub use shared::Shared;

use can::{Drives, Units};
use clock::Clock;
use serial::Serial;

pub use can::{CAN_QUEUE, CanBus, CanDrive, CanPacket, CanUnit};
pub use ethercat::{EcatSlave, EcatState, EtherCat};
pub use licence::Licences;
pub use serial::{SERIAL_QUEUE, SerialPort};

/// Bytes of a text in a table, or of a block on a bus, for which room is made before the program runs; a longer one takes its memory when it comes.
const MAX_TEXT: usize = 1024;

/// The control. Deterministic; a clone is a snapshot.
#[derive(Clone, Debug, Default)]
pub struct SimulatedControl {
    data: ControlData,
    elements: Elements,
    messages: Messages,
    board: MessageBoard,
    motion: Motion,
    shared: SharedMemory,
    tables: Tables,
    /// PLC_MEM_BACKUP was saved so many times.
    saved: u64,
    serial: Serial,
    licences: Licences,
    can: CanBus,
    units: Units,
    drives: Drives,
    ethercat: EtherCat,
    edrv: Edrv,
    clock: Clock,
    /// What the machine drives the analogue inputs with.
    analog_inputs: Vec<(u8, f64)>,
    bus_faults: Vec<BusFault>,
}

impl SimulatedControl {
    /// A control as at power-on.
    #[must_use]
    pub fn new() -> SimulatedControl {
        SimulatedControl::default()
    }

    /// A control as at power-on with what a machine describes.
    #[must_use]
    pub fn of(machine: &MachineConfig) -> SimulatedControl {
        let mut control = SimulatedControl {
            elements: Elements::of(machine),
            motion: Motion::new(machine),
            clock: Clock::of(machine.control.clock.as_deref(), machine.control.utc_offset_min),
            ..SimulatedControl::default()
        };
        control.connect_buses(machine);
        control
    }

    /// Its calendar clock shows a time from now on: milliseconds since 1970, UTC. It goes on with PLC time.
    pub fn set_time(&mut self, unix_millis: i64) {
        self.clock.set(unix_millis);
    }

    /// A number that two controls share when they go on the same way from here.
    #[must_use]
    pub fn state_hash(&self) -> u64 {
        technol_runtime::StateHash::of_shown(self)
    }

    /// Axes and spindles.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Axes and spindles, for what the operator does with them.
    pub fn motion_mut(&mut self) -> &mut Motion {
        &mut self.motion
    }

    /// Sets an input that the program names by an identifier (MAP_IN, MAP_AIN, DEF_IN): `inDoor`, also as
    /// `PLC.Input.inDoor`, in any case; `Pos[2]` is an element of an array. The cells that are bound to it follow at their period, also
    /// those that are declared later. A wired input no longer follows its port.
    ///
    /// # Errors
    /// The identifier is not one, or there are too many.
    pub fn set_input(&mut self, id: &str, value: impl Into<ElementValue>) -> Result<(), ElementError> {
        self.elements.set_input(id, value.into())
    }

    /// The output of this identifier (MAP_OUT, MAP_AOUT, DEF_OUT) as it last left the program; `None` when it never did
    /// since the start of the PLC.
    #[must_use]
    pub fn output(&self, id: &str) -> Option<&ElementValue> {
        self.elements.output(id)
    }

    /// Wires the element of an identifier to a bit of a port: an input to an input port, an output to an output port. What
    /// is wired to a port that is not a fast one changes in each 20 ms only.
    ///
    /// # Errors
    /// The identifier is not one, or there are too many.
    pub fn wire(&mut self, id: &str, to: Signal, invert: bool) -> Result<(), ElementError> {
        self.elements.wire(id, to, invert)
    }

    /// Links an output of the program to an input of it (manual 27.5). An input has one source: a link to it replaces an earlier one.
    ///
    /// # Errors
    /// An identifier is not one, or there are too many.
    pub fn connect(
        &mut self,
        source: &str,
        destination: &str,
        conversion: Conversion,
    ) -> Result<(), ElementError> {
        self.elements.connect(source, destination, conversion)
    }

    /// What it has on its disk; tables and backed-up memory change while programs run.
    #[must_use]
    pub fn data(&self) -> &ControlData {
        &self.data
    }

    /// Replaces what it has on its disk. Inputs and outputs of the configuration count from the next start of the PLC, its
    /// connections at once.
    pub fn set_data(&mut self, data: ControlData) {
        // An identifier that is none connects nothing; who reads the files reports it.
        let _ = self.elements.configure(data.wiring.clone());
        for SpindleGears { spindle, speed_limit, gears } in &data.gears {
            self.motion.set_gears(*spindle, gears, *speed_limit);
        }
        self.data = data;
        backup::make_room(&mut self.data.backup);
    }

    /// Makes room for all that a program may have under way at once, so that its cycles need no memory. Without it the first
    /// execution of a line does.
    pub fn prepare(&mut self, services: &[ServiceCall]) {
        backup::make_room(&mut self.data.backup);
        for (call, it) in (0..).zip(services) {
            let bytes = it.args.iter().map(|arg| match arg {
                Arg::Text(bytes) => bytes.len(),
                Arg::Area { len, .. } => *len as usize,
                _ => 8,
            });
            let longest = bytes.max().unwrap_or(0).min(MAX_TEXT);
            match it.service {
                Service::SaRead | Service::SaWrite => self.shared.prepare(call),
                Service::EcatCommand
                | Service::EcatCoeRead
                | Service::EcatCoeWrite
                | Service::EcatSoeRead
                | Service::EcatSoeWrite => self.ethercat.prepare(call, longest),
                other if tables::is_table(other) => self.tables.prepare(call, other, longest),
                _ => {}
            }
        }
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

    /// The messages that the operator sees.
    #[must_use]
    pub fn board(&self) -> &MessageBoard {
        &self.board
    }

    /// A message of the program, of ESET or EDEF, reaches the operator: shown (`set`) or removed.
    pub fn report(&mut self, message: Shown, set: bool) {
        self.board.report(self.data.message(message.number), message, set);
    }

    /// The operator confirms the transient message on the screen.
    pub fn acknowledge(&mut self) -> Option<Shown> {
        self.board.acknowledge()
    }

    /// A logical channel of serial ports; it is configured from the first time on.
    pub fn serial_mut(&mut self, channel: u8) -> &mut SerialPort {
        self.serial.port(channel)
    }

    /// A logical channel of serial ports, if it is configured.
    #[must_use]
    pub fn serial(&self, channel: u8) -> Option<&SerialPort> {
        self.serial.configured(channel)
    }

    /// The hardware key and its licences.
    pub fn licences_mut(&mut self) -> &mut Licences {
        &mut self.licences
    }

    /// The CAN channels that the program shares.
    pub fn can_mut(&mut self) -> &mut CanBus {
        &mut self.can
    }

    /// A unit of the control on the CAN bus: channel (1, 2), group (1 to 3), number in the group (1 to 32). It is present from
    /// the first time on.
    pub fn can_unit_mut(&mut self, can: u8, group: u8, board: u8) -> &mut CanUnit {
        self.units.unit(can, group, board)
    }

    /// The CAN drive of an axis (1 to 16); it is there from the first time on.
    pub fn can_drive_mut(&mut self, axis: u8) -> &mut CanDrive {
        self.drives.drive(axis)
    }

    /// The EtherCAT master.
    pub fn ethercat_mut(&mut self) -> &mut EtherCat {
        &mut self.ethercat
    }
}

impl SimulatedControl {
    /// What the control gives the slaves of its buses.
    pub(crate) fn bus_outputs(&self) -> &[u8; BUS_OUTPUTS] {
        self.ethercat.outputs()
    }

    /// What the slaves give.
    pub(crate) fn set_bus_inputs(&mut self, inputs: &[u8; BUS_INPUTS]) {
        self.ethercat.set_inputs(inputs);
    }

    /// Voltages of analogue inputs by channel.
    pub(crate) fn set_analog_inputs(&mut self, inputs: &[(u8, f64)]) {
        self.analog_inputs.clear();
        self.analog_inputs.extend_from_slice(inputs);
    }

    /// Short circuits that the program is told of, of those there are: units tell of outputs that are on, and IO_DIS_ERPIS
    /// keeps them silent (manual 9.3).
    #[must_use]
    pub fn reported(&mut self, shorted: &[u8; OUTPUT_PORTS], memory: &[u8]) -> [u8; OUTPUT_PORTS] {
        let mut reported = *shorted;
        let outputs = memory.get(system::OUT_PORTS as usize..).unwrap_or_default();
        self.units.tell_shorted(&mut reported, outputs);
        reported
    }

    /// A millisecond of analogue inputs and drives.
    fn devices(&mut self, memory: &mut [u8]) {
        for (channel, volts) in &self.analog_inputs {
            let at = devices::ANALOG_INPUT as usize + 8 * usize::from(*channel);
            if let Some(cell) = memory.get_mut(at..at + 8) {
                cell.copy_from_slice(&volts.to_le_bytes());
            }
        }
        self.ethercat.exchange(&mut self.elements);
        self.edrv.tick(memory);
        self.drives.follow(memory);
    }
}

impl Control for SimulatedControl {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        match call.service() {
            Service::MapIn
            | Service::MapOut
            | Service::MapAin
            | Service::MapAout
            | Service::DefIn
            | Service::DefOut => self.elements.declare(call),
            Service::UpdateIn => self.elements.update(call),
            Service::Edef => self.messages.watch(call),
            Service::CnfGetInt
            | Service::CnfGetReal
            | Service::CnfGetStr
            | Service::CnfGetBin
            | Service::CnfGetBit => configuration::parameter(&self.data, call),
            Service::ConstGet => configuration::constant(&self.data, call),
            Service::ShareVar | Service::ShareBit => self.shared.share(call),
            Service::SaRead | Service::SaWrite => self.shared.exchange(call),
            Service::ComSend | Service::ComSendStr | Service::ComRecv | Service::ComControl => {
                self.serial.execute(call)
            }
            Service::LdrLic => {
                self.licences.load(call);
                Ok(())
            }
            Service::CanSend
            | Service::CanRecv
            | Service::CanRecvReq
            | Service::CanRecvEnd
            | Service::CanRecvDel => self.can.execute(call),
            Service::CanSysioRead | Service::CanSysioWrite => self.units.execute(call),
            Service::CanAxSend => self.drives.send(call),
            Service::EcatCommand
            | Service::EcatCoeRead
            | Service::EcatCoeWrite
            | Service::EcatSoeRead
            | Service::EcatSoeWrite => self.ethercat.execute(call),
            other if tables::is_table(other) => self.tables.execute(&mut self.data.tables, call),
            other => {
                let known = axes::service(&mut self.motion, call)?;
                if known { Ok(()) } else { Err(FaultKind::NoService(other)) }
            }
        }
    }

    fn inputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        if rate == Rate::Fast {
            self.motion.tick_ms(&mut Cells::new(memory));
            self.devices(memory);
            self.clock.tick();
        }
        if rate == Rate::Slow {
            self.clock.tell(&mut Cells::new(memory));
        }
        self.elements.serve(rate, true, memory);
        // The buses run in PLC time, which stands while the debugger holds the program.
        if rate != Rate::Fast {
            return;
        }
        self.serial.tick();
        self.can.tick();
        self.drives.tick();
        if millis.is_multiple_of(20) {
            self.units.cycle(memory);
            self.drives.inputs(memory, &mut self.messages);
            self.ethercat.cycle();
            self.ethercat.requests(memory);
        }
    }

    fn outputs(&mut self, rate: Rate, _millis: u64, memory: &mut [u8]) {
        self.elements.serve(rate, false, memory);
        if rate == Rate::Slow {
            self.messages.look(memory);
            if backup::take_request(memory) {
                self.save_backup(memory);
            }
        }
    }

    fn fast_links(&mut self, _millis: u64, memory: &mut [u8]) {
        self.elements.serve(Rate::Fast, true, memory);
    }

    fn next_message(&mut self) -> Option<ControlMessage> {
        self.messages.next()
    }

    fn next_call(&mut self, memory: &mut [u8]) -> Option<ControlCall> {
        self.can.next_call(memory)
    }

    fn block_spindle(&mut self, spindle: &BlockSpindle, memory: &mut [u8]) {
        self.motion.program_spindle(&mut Cells::new(memory), spindle);
    }

    fn take_axes(&mut self, motion: &BlockMotion<'_>, memory: &mut [u8]) -> AxesOfBlock {
        axes::take(&mut self.motion, motion, memory)
    }

    fn release_axes(&mut self) {
        self.motion.release_block();
    }

    fn block_way(&self) -> BlockWay {
        match self.motion.block() {
            BlockState::None => BlockWay::Lost,
            BlockState::Done if self.motion.arrived() => BlockWay::Arrived,
            BlockState::Moving | BlockState::Done => BlockWay::Moving,
        }
    }

    fn block_time_left(&self) -> u32 {
        self.motion.block_time_left()
    }

    fn in_position(&self) -> bool {
        self.motion.in_position() && !self.motion.moves()
    }

    fn hold(&mut self, hold: Hold) {
        self.motion.hold(hold);
    }

    fn is_held(&self) -> bool {
        self.motion.is_held()
    }

    fn end_block(&mut self, memory: &mut [u8]) {
        self.motion.annul(&mut Cells::new(memory));
    }

    fn start(&mut self, cold: bool) {
        self.motion.start(cold);
        self.elements.start();
        self.messages.start();
        self.board.start(cold);
        self.shared.start(cold);
        self.tables.start(&mut self.data.tables);
        self.serial.start();
        self.can.start();
        self.drives.start(cold);
        self.ethercat.start(cold);
        self.edrv.start(cold);
    }

    fn power_on(&mut self, memory: &mut [u8]) {
        backup::load(&self.data.backup, memory);
        self.elements.wiring().mark_analog(memory);
    }
}
