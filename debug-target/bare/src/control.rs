//! The control of a host in C: `technol_control`, and what its functions may do with a call.

use core::ffi::c_void;
use core::{ptr, slice};

use technol_runtime::{Call, Control, FaultKind, Hold, Rate};

/// Answer of `service`: this host does not have the instruction.
const NOT_HERE: u32 = 1;

type Carry = Option<unsafe extern "C" fn(*mut c_void, *mut c_void) -> u32>;
type Copy = Option<unsafe extern "C" fn(*mut c_void, u32, u64, *mut u8, usize)>;

/// `technol_control`.
#[repr(C)]
#[derive(Clone)]
pub(crate) struct HostControl {
    context: *mut c_void,
    service: Carry,
    inputs: Copy,
    outputs: Copy,
    start: Option<unsafe extern "C" fn(*mut c_void, bool)>,
    hold: Option<unsafe extern "C" fn(*mut c_void, u32)>,
}

impl HostControl {
    /// The control of a host that has none.
    pub(crate) const NONE: HostControl = HostControl {
        context: ptr::null_mut(),
        service: None,
        inputs: None,
        outputs: None,
        start: None,
        hold: None,
    };
}

/// `technol_call`: an instruction while `service` runs, and the first fault that it met.
pub(crate) struct HostCall<'a, 'b> {
    call: &'a mut Call<'b>,
    fault: Option<FaultKind>,
}

impl HostCall<'_, '_> {
    /// The value, if there is one; an address outside memory faults the PLC after `service`.
    fn met<T>(&mut self, result: Result<Option<T>, FaultKind>) -> Option<T> {
        result.unwrap_or_else(|fault| {
            self.fault.get_or_insert(fault);
            None
        })
    }

    fn done(&mut self, result: Result<(), FaultKind>) -> bool {
        self.met(result.map(Some)).is_some()
    }
}

impl Control for HostControl {
    fn service(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let service = call.service();
        let Some(carry_out) = self.service else { return Err(FaultKind::NoService(service)) };
        let mut call = HostCall { call, fault: None };
        // SAFETY: as the header requires; the call lives as long as this.
        let answer = unsafe { carry_out(self.context, ptr::from_mut(&mut call).cast()) };
        match call.fault {
            Some(fault) => Err(fault),
            None if answer == NOT_HERE => Err(FaultKind::NoService(service)),
            None => Ok(()),
        }
    }

    fn inputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        if let Some(copy) = self.inputs {
            // SAFETY: as the header requires; the memory is ours alone and has this length.
            unsafe { copy(self.context, number_of(rate), millis, memory.as_mut_ptr(), memory.len()) };
        }
    }

    fn outputs(&mut self, rate: Rate, millis: u64, memory: &mut [u8]) {
        if let Some(copy) = self.outputs {
            // SAFETY: as in `inputs`.
            unsafe { copy(self.context, number_of(rate), millis, memory.as_mut_ptr(), memory.len()) };
        }
    }

    fn start(&mut self, cold: bool) {
        if let Some(start) = self.start {
            // SAFETY: as the header requires.
            unsafe { start(self.context, cold) };
        }
    }

    fn hold(&mut self, hold: Hold) {
        if let Some(tell) = self.hold {
            // SAFETY: as the header requires.
            unsafe { tell(self.context, hold as u32) };
        }
    }
}

/// Numbers of `technol_rate`.
fn number_of(rate: Rate) -> u32 {
    match rate {
        Rate::Slow => 0,
        Rate::Fast => 1,
        Rate::Fastest => 2,
    }
}

/// Text that stays where it is, with its length; nobody writes to it.
fn give(text: &[u8], bytes: &mut *const u8, len: &mut usize) -> bool {
    (*bytes, *len) = (text.as_ptr(), text.len());
    true
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_service(call: &HostCall<'_, '_>) -> u32 {
    call.call.service() as u32
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_place(call: &HostCall<'_, '_>) -> u32 {
    u32::from(call.call.index())
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_millis(call: &HostCall<'_, '_>) -> u64 {
    call.call.millis()
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_integer(call: &mut HostCall<'_, '_>, operand: usize, value: &mut i64) -> bool {
    let found = call.call.integer(operand);
    let Some(found) = call.met(found) else { return false };
    *value = found;
    true
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_real(call: &mut HostCall<'_, '_>, operand: usize, value: &mut f64) -> bool {
    let found = call.call.real(operand);
    let Some(found) = call.met(found) else { return false };
    *value = found;
    true
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_text(
    call: &mut HostCall<'_, '_>,
    operand: usize,
    text: &mut *const u8,
    len: &mut usize,
) -> bool {
    if let Some(word) = call.call.keyword(operand) {
        return give(word.as_bytes(), text, len);
    }
    match call.call.text(operand) {
        Ok(Some(found)) => give(found, text, len),
        Ok(None) => false,
        Err(fault) => call.met::<()>(Err(fault)).is_some(),
    }
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_area(
    call: &mut HostCall<'_, '_>,
    operand: usize,
    addr: &mut u32,
    len: &mut u32,
) -> bool {
    let found = call.call.area(operand);
    let Some(found) = call.met(found) else { return false };
    (*addr, *len) = found;
    true
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_call_read(
    call: &mut HostCall<'_, '_>,
    addr: u32,
    bytes: *mut u8,
    len: u32,
) -> bool {
    match call.call.bytes(addr, len) {
        Ok(cells) => {
            // SAFETY: `bytes` has `len` bytes and does not lie in the PLC's memory: see technol.h.
            unsafe { ptr::copy_nonoverlapping(cells.as_ptr(), bytes, cells.len()) };
            true
        }
        Err(fault) => call.done(Err(fault)),
    }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn technol_call_write(
    call: &mut HostCall<'_, '_>,
    addr: u32,
    bytes: *const u8,
    len: usize,
) -> bool {
    let bytes = if bytes.is_null() || len == 0 {
        &[]
    } else {
        // SAFETY: as the header requires.
        unsafe { slice::from_raw_parts(bytes, len) }
    };
    let written = call.call.write(addr, bytes);
    call.done(written)
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_store(call: &mut HostCall<'_, '_>, operand: usize, value: i64) -> bool {
    let stored = call.call.store(operand, value);
    call.done(stored)
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_rlo(call: &HostCall<'_, '_>) -> bool {
    call.call.rlo()
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_set_rlo(call: &mut HostCall<'_, '_>, value: bool) {
    call.call.set_rlo(value);
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_dr(call: &HostCall<'_, '_>) -> i64 {
    call.call.dr()
}

#[unsafe(no_mangle)]
extern "C" fn technol_call_set_dr(call: &mut HostCall<'_, '_>, value: i64) {
    call.call.set_dr(value);
}
