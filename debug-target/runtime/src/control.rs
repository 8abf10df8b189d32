//! The control around the program: what a port to a machine provides.
//!
//! The runtime computes; everything else a program can ask for (mapped inputs, tables, buses, axes …) it asks of a
//! [`Control`]. The simulated one is in `technol-machine`.

use technol_image::op::{Addr, Place, Width};
use technol_image::service::{Arg, Service};

use crate::fault::FaultKind;
use crate::memory::Memory;
use crate::prepared::BLOCK_AXES;
use crate::registers::{Registers, mask, sign_extend};

/// How often something is copied between the program and the control.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Rate {
    /// Each 20 ms, around the modules of the cycle.
    Slow,
    /// Each millisecond, around MODULE_FAST.
    Fast,
    /// Each pass of MODULE_FASTEST.
    Fastest,
}

/// A message that the control reports by itself (EDEF, manual 14.3). `_ON_ESET` is not called for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ControlMessage {
    /// Number of the call that set it up, see [`Call::index`].
    pub call: u16,
    /// Its number.
    pub number: u32,
    /// Supplementary number.
    pub sub_id: Option<i64>,
    /// Shown (true) or removed (false).
    pub set: bool,
    /// Values for its text.
    pub parameters: [Option<i64>; 3],
}

/// A procedure that the control calls (CAN_RECV_REQ, manual 9.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ControlCall {
    /// Its number, as an operand told it: see [`Call::procedure`]. One that the program does not have is not called.
    pub procedure: u16,
    /// DR at its start.
    pub dr: i64,
}

/// What holds the axes that the control moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Hold {
    /// Nothing: they go on.
    #[default]
    Go,
    /// STOP.
    Stop,
    /// Emergency stop: by the steepest ramps.
    Emergency,
}

/// What a block says about the spindle. PB11 and PB12, and the gear of M40, are the control's to write.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BlockSpindle {
    /// A speed that the block programs, in rev/min.
    pub programmed: Option<f64>,
    /// The speed in force, in rev/min: that of this block, or of one before it.
    pub speed: f64,
    /// M40 is in force: the gear follows the speed.
    pub automatic_gear: bool,
    /// This block programs M40.
    pub gear_programmed: bool,
    /// Constant cutting speed (G96) in mm/min; `None`: the speed counts (G97).
    pub cutting_speed: Option<f64>,
    /// Largest speed at constant cutting speed in rev/min; 0: that of the gear.
    pub speed_limit: f64,
}

/// Where a block moves its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockMotion<'a> {
    /// Targets of the NC axes, X first: absolute, in mm.
    pub targets: &'a [Option<f64>; BLOCK_AXES],
    /// Feed in mm/min; with `per_revolution` in mm/rev.
    pub feed: f64,
    /// G95.
    pub per_revolution: bool,
    /// Rapid traverse.
    pub rapid: bool,
}

/// What the control answers when a block asks for its axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AxesOfBlock {
    /// It has no axes: the block takes the time it says ([`Block::motion_ms`](crate::Block::motion_ms)).
    None,
    /// An axis is not free. It is asked again in the next cycle.
    Busy,
    /// They wait for the release.
    Taken,
}

/// How the axes of a block stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlockWay {
    /// On their way, or held.
    Moving,
    /// At their targets, within the tolerance.
    Arrived,
    /// The control had to give the movement up; only central annulment ends the block.
    Lost,
}

/// The control around a program. Every method is called from [`Runtime::tick_with`](crate::Runtime::tick_with), on its thread;
/// nothing may wait.
pub trait Control {
    /// Carries out an instruction. What it says of RLO and DR goes into the registers of the call.
    ///
    /// # Errors
    /// A fault that stops the PLC: an operand that reaches outside memory, or an instruction this control does not
    /// have ([`FaultKind::NoService`]).
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind>;

    /// Before the modules of a rate: inputs go into memory. The port bytes have been copied. [`Rate::Fast`] is called in every
    /// millisecond of PLC time.
    fn inputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        let _ = (rate, millis, memory);
    }

    /// After the modules of a rate: outputs leave memory. The port bytes will be copied.
    fn outputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        let _ = (rate, millis, memory);
    }

    /// Between MODULE_CYCLICOPERATION, if the program has one, and MODULE_FAST: links of 1 ms are served once more.
    fn fast_links(&mut self, millis: u64, memory: &mut [u8]) {
        let _ = (millis, memory);
    }

    /// The next message the control reports by itself; asked after the outputs of each cycle until there is none.
    fn next_message(&mut self) -> Option<ControlMessage> {
        None
    }

    /// The next procedure to call at the start of a cycle, behind its inputs and before MODULE_INPUT; asked until there is none,
    /// at most 256 times. What the procedure works on goes into memory here.
    fn next_call(&mut self, memory: &mut [u8]) -> Option<ControlCall> {
        let _ = memory;
        None
    }

    /// The PLC starts: what the program declared before is forgotten. `cold`: everything is as at power-on.
    fn start(&mut self, cold: bool) {
        let _ = cold;
    }

    /// A block was taken over; its functions are in the block cells. The control writes the spindle value and chooses the gear.
    fn block_spindle(&mut self, spindle: &BlockSpindle, memory: &mut [u8]) {
        let _ = (spindle, memory);
    }

    /// A block with targets was taken over: the control takes the axes and tells the program which ones; they wait.
    fn take_axes(&mut self, motion: &BlockMotion<'_>, memory: &mut [u8]) -> AxesOfBlock {
        let _ = (motion, memory);
        AxesOfBlock::None
    }

    /// The preparatory functions are through: the axes that were taken may move.
    fn release_axes(&mut self) {}

    /// How the axes that were taken stand. Asked in each cycle after their release.
    fn block_way(&self) -> BlockWay {
        BlockWay::Arrived
    }

    /// Milliseconds until the axes that were taken reach their targets, as far as can be told now.
    fn block_time_left(&self) -> u32 {
        0
    }

    /// No axis moves or has a position error above its tolerance: INPOS. Asked in each millisecond.
    fn in_position(&self) -> bool {
        true
    }

    /// STOP or emergency stop, or the start after it; it concerns whatever the control moves by itself.
    fn hold(&mut self, hold: Hold) {
        let _ = hold;
    }

    /// Something waits for a start since [`hold`](Control::hold).
    fn is_held(&self) -> bool {
        false
    }

    /// The block was broken off, or the PLC ends: its axes stop, and nothing is held any more.
    fn end_block(&mut self, memory: &mut [u8]) {
        let _ = memory;
    }

    /// After a cold start has cleared memory and before MODULE_INIT: what is kept while the power is off comes back.
    fn power_on(&mut self, memory: &mut [u8]) {
        let _ = memory;
    }
}

/// No control: programs that only compute.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoControl;

impl Control for NoControl {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        Err(FaultKind::NoService(call.service()))
    }
}

/// An instruction on its way to the control: its operands, memory and registers.
pub struct Call<'a> {
    pub(crate) service: Service,
    pub(crate) args: &'a [Arg],
    pub(crate) index: u16,
    pub(crate) millis: u64,
    pub(crate) memory: &'a mut Memory,
    pub(crate) regs: &'a mut Registers,
}

impl Call<'_> {
    /// Which instruction.
    pub fn service(&self) -> Service {
        self.service
    }

    /// Number of this place in the program: two executions of one line have the same. Instructions that take several
    /// cycles know their transfer by it.
    pub fn index(&self) -> u16 {
        self.index
    }

    /// Milliseconds of PLC time.
    pub fn millis(&self) -> u64 {
        self.millis
    }

    /// Operand `n` as the program has it; [`Arg::Missing`] when it is left out.
    pub fn arg(&self, n: usize) -> &Arg {
        self.args.get(n).unwrap_or(&Arg::Missing)
    }

    /// Operand `n` is given.
    pub fn is_given(&self, n: usize) -> bool {
        *self.arg(n) != Arg::Missing
    }

    /// The keyword at operand `n`, upper case.
    pub fn keyword(&self, n: usize) -> Option<&str> {
        match self.arg(n) {
            Arg::Keyword(word) => Some(word),
            _ => None,
        }
    }

    /// Number of the procedure at operand `n`.
    pub fn procedure(&self, n: usize) -> Option<u16> {
        match self.arg(n) {
            Arg::Procedure(number) => Some(*number),
            _ => None,
        }
    }

    /// Integer value of operand `n`: a constant, a cell (sign-extended), a bit (0 or 1); a real is rounded toward zero.
    ///
    /// # Errors
    /// BX leads outside memory.
    pub fn integer(&self, n: usize) -> Result<Option<i64>, FaultKind> {
        match self.real_operand(n)? {
            Some(value) => Ok(Some(value as i64)),
            None => self.integer_operand(n),
        }
    }

    /// Value of operand `n` without sign: a cell zero-extended, other operands as [`integer`](Call::integer).
    ///
    /// # Errors
    /// BX leads outside memory.
    pub fn unsigned(&self, n: usize) -> Result<Option<i64>, FaultKind> {
        let value = self.integer(n)?;
        Ok(match self.arg(n) {
            Arg::Cell { width, .. } if *width != Width::Real => value.map(|value| value & mask(*width)),
            _ => value,
        })
    }

    /// Real value of operand `n`; an integer is converted.
    ///
    /// # Errors
    /// BX leads outside memory.
    pub fn real(&self, n: usize) -> Result<Option<f64>, FaultKind> {
        match self.real_operand(n)? {
            Some(value) => Ok(Some(value)),
            None => Ok(self.integer_operand(n)?.map(|value| value as f64)),
        }
    }

    /// A real constant or cell.
    fn real_operand(&self, n: usize) -> Result<Option<f64>, FaultKind> {
        match self.arg(n) {
            Arg::Real(value) => Ok(Some(*value)),
            Arg::Cell { place, width: Width::Real, neg } => {
                let bits = self.memory.read(*place, Width::Real, self.regs.bx)?;
                let value = f64::from_bits(bits.cast_unsigned());
                Ok(Some(if *neg { -value } else { value }))
            }
            _ => Ok(None),
        }
    }

    /// An operand that is no real.
    fn integer_operand(&self, n: usize) -> Result<Option<i64>, FaultKind> {
        Ok(match self.arg(n) {
            Arg::Int(value) => Some(*value),
            Arg::Cell { place, width, neg } => {
                let value = self.memory.read(*place, *width, self.regs.bx)?;
                Some(if *neg { sign_extend(*width, value.wrapping_neg()) } else { value })
            }
            Arg::Bit { bit, neg } => Some(i64::from(self.memory.bit(*bit, self.regs.bx)? != *neg)),
            _ => None,
        })
    }

    /// Address of operand `n` in memory, and how many bytes may be used there: those of the cell, those up to the end of the
    /// declared variable, one for a bit.
    ///
    /// # Errors
    /// BX leads outside memory.
    pub fn area(&self, n: usize) -> Result<Option<(Addr, u32)>, FaultKind> {
        let (place, len) = match self.arg(n) {
            Arg::Cell { place, width, .. } => (*place, width.bytes()),
            Arg::Area { place, len } => (*place, *len),
            Arg::Bit { bit, .. } => (Place { addr: bit.addr, indexed: bit.indexed }, 1),
            _ => return Ok(None),
        };
        if !place.indexed {
            return Ok(Some((place.addr, len)));
        }
        let at = self.memory.resolve(place.addr, true, self.regs.bx, 0)? as Addr;
        Ok(Some((at, place.addr.saturating_add(len).saturating_sub(at))))
    }

    /// The text at operand `n`: a literal, or the bytes of a text buffer up to its end mark.
    ///
    /// # Errors
    /// BX leads outside memory.
    pub fn text(&self, n: usize) -> Result<Option<&[u8]>, FaultKind> {
        if let Arg::Text(bytes) = self.arg(n) {
            return Ok(Some(bytes));
        }
        let Some((addr, len)) = self.area(n)? else { return Ok(None) };
        let bytes = self.bytes(addr, len)?;
        let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
        Ok(Some(&bytes[..end]))
    }

    /// The memory of the PLC, for what lies at fixed places of it: the interface cells.
    pub fn memory_mut(&mut self) -> &mut [u8] {
        self.memory.bytes_mut()
    }

    /// All bytes of operand `n`: those of a literal, of a cell, up to the end of an area; none of other operands.
    ///
    /// # Errors
    /// BX leads outside memory.
    pub fn content(&self, n: usize) -> Result<&[u8], FaultKind> {
        match self.area(n)? {
            Some((addr, len)) => self.bytes(addr, len),
            None => Ok(self.text(n)?.unwrap_or_default()),
        }
    }

    /// Bytes of memory.
    ///
    /// # Errors
    /// They do not all lie in memory.
    pub fn bytes(&self, addr: Addr, len: u32) -> Result<&[u8], FaultKind> {
        let start = addr as usize;
        let end = start.checked_add(len as usize);
        let found = end.and_then(|end| self.memory.bytes().get(start..end));
        found.ok_or(FaultKind::BadAddress { addr: i64::from(addr), len })
    }

    /// Writes bytes into memory.
    ///
    /// # Errors
    /// They do not all lie in memory; then nothing is written.
    pub fn write(&mut self, addr: Addr, bytes: &[u8]) -> Result<(), FaultKind> {
        let len = u32::try_from(bytes.len()).unwrap_or(u32::MAX);
        self.memory.poke(addr, bytes).map_err(|_| FaultKind::BadAddress { addr: i64::from(addr), len })
    }

    /// Writes an integer to the cell or bit at operand `n`; other operands take nothing. A real cell gets the number.
    ///
    /// # Errors
    /// BX leads outside memory.
    pub fn store(&mut self, n: usize, value: i64) -> Result<(), FaultKind> {
        let bx = self.regs.bx;
        match self.args.get(n) {
            Some(Arg::Cell { place, width: Width::Real, .. }) => {
                self.memory.write(*place, Width::Real, bx, (value as f64).to_bits().cast_signed())
            }
            Some(Arg::Cell { place, width, .. }) => self.memory.write(*place, *width, bx, value),
            Some(Arg::Bit { bit, .. }) => self.memory.set_bit(*bit, bx, value != 0),
            _ => Ok(()),
        }
    }

    /// Writes a text and its end mark into the buffer at operand `n`; what does not fit is cut.
    ///
    /// # Errors
    /// BX leads outside memory; then nothing is written.
    pub fn store_text(&mut self, n: usize, text: &[u8]) -> Result<(), FaultKind> {
        let Some((addr, len)) = self.area(n)? else { return Ok(()) };
        let Some(room) = len.checked_sub(1) else { return Ok(()) };
        let text = &text[..text.len().min(room as usize)];
        self.bytes(addr, text.len() as u32 + 1)?;
        self.write(addr, text)?;
        self.write(addr + text.len() as Addr, &[0])
    }

    /// Copies the first `len` bytes of operand `from`, a text, memory or the bytes of a literal, to an address, also where the two
    /// overlap. Of an operand that is shorter so many as it has.
    ///
    /// # Errors
    /// They do not all lie in memory; then nothing is written.
    pub fn copy(&mut self, addr: Addr, from: usize, len: usize) -> Result<(), FaultKind> {
        let args = self.args;
        if let Some(Arg::Text(bytes)) = args.get(from) {
            return self.write(addr, &bytes[..bytes.len().min(len)]);
        }
        let Some((source, room)) = self.area(from)? else { return Ok(()) };
        let len = len.min(room as usize);
        self.bytes(source, len as u32)?;
        self.bytes(addr, len as u32)?;
        self.memory.copy(source as usize, addr as usize, len);
        Ok(())
    }

    /// RLO.
    pub fn rlo(&self) -> bool {
        self.regs.rlo
    }

    /// Sets RLO.
    pub fn set_rlo(&mut self, value: bool) {
        self.regs.rlo = value;
    }

    /// DR64.
    pub fn dr(&self) -> i64 {
        self.regs.dr
    }

    /// Sets DR64.
    pub fn set_dr(&mut self, value: i64) {
        self.regs.dr = value;
    }

    /// DR_REAL.
    pub fn dr_real(&self) -> f64 {
        self.regs.dr_real
    }
}
