//! The functions of `include/technol.h`, in its order. Each turns pointers into references and calls [`Plc`].
//!
//! What all of them require, and `technol.h` says: a handle comes from `technol_load`, is used by one thread at a
//! time and not after `technol_unload`; a pointer points to as many bytes as its length says.
#![allow(clippy::missing_safety_doc, reason = "said once, above and in technol.h")]

use alloc::boxed::Box;
use core::fmt::Write as _;
use core::{ptr, slice};

use technol_image::system;
use technol_runtime::{Block, BlockMode, Command, InputImage, OutputImage, PlcState, RuntimeEvent};

use crate::control::HostControl;
use crate::heap;
use crate::plc::Plc;

const _: () = assert!(system::IN_PORT_COUNT == 128 && system::OUT_PORT_COUNT == 96, "technol.h says so too");

/// `technol_event`.
#[repr(C)]
#[derive(Default)]
pub(crate) struct Event {
    kind: u32,
    /// Message: number; state: the new one; rejected block: why.
    number: u32,
    cycle: u64,
    sub_id: i64,
    parameters: [i64; 3],
    /// Bit 0: `sub_id`, bits 1 to 3: `parameters` are there.
    present: u8,
    /// Message shown (1) or removed (0).
    set: u8,
}

/// `technol_fault`.
#[repr(C)]
pub(crate) struct Fault {
    cycle: u64,
    pc: u32,
    file: u8,
    module: u8,
    /// -1: outside sequences.
    sequence: i32,
}

/// `technol_block`.
#[repr(C)]
pub(crate) struct CBlock {
    m: *const u8,
    m_len: usize,
    /// Negative: none.
    t: i64,
    s: i32,
    h: i32,
    motion_ms: u32,
    rapid: bool,
    mode: u8,
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_give_memory(memory: *mut u8, len: usize) -> bool {
    // SAFETY: as the header requires.
    unsafe { heap::give(memory, len) }
}

#[unsafe(no_mangle)]
extern "C" fn technol_memory_used() -> usize {
    heap::used()
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_load(
    image: *const u8,
    len: usize,
    message: *mut u8,
    message_len: usize,
) -> *mut Plc {
    // SAFETY: as the header requires.
    let bytes = unsafe { slice::from_raw_parts(image, len) };
    match Plc::load(bytes) {
        Ok(plc) => Box::into_raw(Box::new(plc)),
        Err(text) => {
            // SAFETY: as the header requires.
            let mut text_of = unsafe { Text::new(message, message_len) };
            // What does not fit is cut.
            let _ = text_of.write_str(&text);
            ptr::null_mut()
        }
    }
}

/// Room of the host for a text, which is cut to fit and ended by 0.
struct Text<'a> {
    room: &'a mut [u8],
    len: usize,
}

impl Text<'_> {
    /// # Safety
    /// `len` bytes are there, unless `text` is NULL.
    unsafe fn new<'a>(text: *mut u8, len: usize) -> Text<'a> {
        let room = if text.is_null() || len == 0 {
            &mut []
        } else {
            // SAFETY: as the caller promises.
            unsafe { slice::from_raw_parts_mut(text, len) }
        };
        if let Some(first) = room.first_mut() {
            *first = 0;
        }
        Text { room, len: 0 }
    }
}

impl core::fmt::Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        for byte in text.bytes().take(self.room.len().saturating_sub(self.len + 1)) {
            self.room[self.len] = byte;
            self.len += 1;
        }
        if let Some(end) = self.room.get_mut(self.len) {
            *end = 0;
        }
        Ok(())
    }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_unload(plc: *mut Plc) {
    if !plc.is_null() {
        // SAFETY: it was made by `technol_load` and is not used again.
        drop(unsafe { Box::from_raw(plc) });
    }
}

#[unsafe(no_mangle)]
extern "C" fn technol_set_control(plc: &mut Plc, control: Option<&HostControl>) {
    plc.control = control.cloned().unwrap_or(HostControl::NONE);
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_set_fast_ports(
    plc: &mut Plc,
    inputs: *const u8,
    inputs_len: usize,
    outputs: *const u8,
    outputs_len: usize,
) -> bool {
    // SAFETY: as the header requires.
    let (inputs, outputs) = unsafe { (list(inputs, inputs_len), list(outputs, outputs_len)) };
    plc.runtime.set_fast_ports(inputs, outputs).is_ok()
}

#[unsafe(no_mangle)]
extern "C" fn technol_start(plc: &mut Plc, cold: bool) {
    plc.runtime.command(Command::StartPlc { cold });
}

#[unsafe(no_mangle)]
extern "C" fn technol_stop(plc: &mut Plc, power_off: bool) {
    plc.runtime.command(Command::StopPlc { power_off });
}

#[unsafe(no_mangle)]
extern "C" fn technol_halt(plc: &mut Plc) {
    plc.runtime.command(Command::Halt);
}

#[unsafe(no_mangle)]
extern "C" fn technol_start_block(plc: &mut Plc, block: &CBlock) {
    plc.runtime.command(Command::StartBlock(Block {
        // SAFETY: as the header requires.
        m: unsafe { list(block.m, block.m_len) }.into(),
        // A number that does not fit becomes one that is refused.
        t: (block.t >= 0).then(|| u32::try_from(block.t).unwrap_or(u32::MAX)),
        s: (block.s >= 0).then(|| u16::try_from(block.s).unwrap_or(u16::MAX)),
        h: (block.h >= 0).then(|| u8::try_from(block.h).unwrap_or(u8::MAX)),
        motion_ms: block.motion_ms,
        rapid: block.rapid,
        mode: match block.mode {
            0 => BlockMode::Auto,
            1 => BlockMode::CentralAnnulment,
            2 => BlockMode::Reference,
            _ => BlockMode::Other,
        },
        prepared: None,
    }));
}

#[unsafe(no_mangle)]
extern "C" fn technol_continue_block(plc: &mut Plc) {
    plc.runtime.command(Command::ContinueBlock);
}

#[unsafe(no_mangle)]
extern "C" fn technol_abort_block(plc: &mut Plc) {
    plc.runtime.command(Command::AbortBlock);
}

#[unsafe(no_mangle)]
extern "C" fn technol_tick(plc: &mut Plc, inputs: &InputImage, outputs: &mut OutputImage) {
    let (_, driven) = plc.tick(inputs);
    *outputs = *driven;
}

#[unsafe(no_mangle)]
extern "C" fn technol_state(plc: &Plc) -> u32 {
    number_of(plc.runtime.state())
}

#[unsafe(no_mangle)]
extern "C" fn technol_millis(plc: &Plc) -> u64 {
    plc.runtime.millis()
}

#[unsafe(no_mangle)]
extern "C" fn technol_state_hash(plc: &Plc) -> u64 {
    plc.runtime.state_hash()
}

#[unsafe(no_mangle)]
extern "C" fn technol_faulted(plc: &Plc, fault: &mut Fault) -> bool {
    let Some(found) = plc.runtime.fault() else { return false };
    *fault = Fault {
        cycle: found.cycle,
        pc: found.pc,
        file: found.file,
        module: found.module as u8,
        sequence: found.sequence.map_or(-1, i32::from),
    };
    true
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_fault_text(plc: &Plc, text: *mut u8, len: usize) {
    // SAFETY: as the header requires.
    let mut text = unsafe { Text::new(text, len) };
    if let Some(fault) = plc.runtime.fault() {
        // What does not fit is cut.
        let _ = write!(text, "{fault}");
    }
}

#[unsafe(no_mangle)]
extern "C" fn technol_next_event(plc: &mut Plc, event: &mut Event) -> bool {
    let Some(next) = plc.next_event() else { return false };
    *event = translated(&next);
    true
}

#[unsafe(no_mangle)]
extern "C" fn technol_lost_events(plc: &mut Plc) -> u32 {
    plc.lost_events()
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_read(plc: &Plc, addr: u32, bytes: *mut u8, len: usize) -> bool {
    let start = addr as usize;
    let Some(cells) = start.checked_add(len).and_then(|end| plc.runtime.memory().get(start..end)) else {
        return false;
    };
    // SAFETY: `bytes` has `len` bytes and does not lie in the PLC's memory, which C has no pointer to.
    unsafe { ptr::copy_nonoverlapping(cells.as_ptr(), bytes, len) };
    true
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_write(plc: &mut Plc, addr: u32, bytes: *const u8, len: usize) -> bool {
    // SAFETY: as the header requires.
    let bytes = unsafe { list(bytes, len) };
    plc.runtime.write_memory(addr, bytes).is_ok()
}

/// A list of C, whose pointer may be NULL when it is empty.
///
/// # Safety
/// `len` bytes are there.
unsafe fn list<'a>(bytes: *const u8, len: usize) -> &'a [u8] {
    if bytes.is_null() || len == 0 {
        return &[];
    }
    // SAFETY: as the caller promises.
    unsafe { slice::from_raw_parts(bytes, len) }
}

/// Numbers of `technol_plc_state`.
fn number_of(state: PlcState) -> u32 {
    match state {
        PlcState::Stopped => 0,
        PlcState::Starting => 1,
        PlcState::Running => 2,
        PlcState::Stopping => 3,
        PlcState::Halted => 4,
        PlcState::Faulted => 5,
    }
}

/// Kinds of `technol_event_kind`.
fn translated(event: &RuntimeEvent) -> Event {
    let other = |kind, cycle| Event { kind, cycle, ..Event::default() };
    match event {
        RuntimeEvent::Message { cycle, number, sub_id, set, parameters, .. } => {
            let there = parameters.iter().enumerate().filter(|(_, p)| p.is_some());
            let present = there.fold(u8::from(sub_id.is_some()), |bits, (n, _)| bits | 2 << n);
            Event {
                kind: 1,
                number: *number,
                cycle: *cycle,
                sub_id: sub_id.unwrap_or(0),
                parameters: parameters.map(|p| p.unwrap_or(0)),
                present,
                set: u8::from(*set),
            }
        }
        RuntimeEvent::Overrun { cycle, .. } => other(2, *cycle),
        RuntimeEvent::StateChanged(state) => Event { number: number_of(*state), ..other(3, 0) },
        RuntimeEvent::Fault(fault) => other(4, fault.cycle),
        RuntimeEvent::BlockStarted { cycle } => other(5, *cycle),
        RuntimeEvent::BlockFinished { cycle } => other(6, *cycle),
        RuntimeEvent::BlockAborted { cycle } => other(7, *cycle),
        RuntimeEvent::BlockRejected(why) => Event { number: *why as u32, ..other(8, 0) },
    }
}
