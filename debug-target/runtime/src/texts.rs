//! Instructions on texts and byte strings (manual 3.18). They need no control.

use technol_image::op::{Addr, Width};
use technol_image::service::Service;

use crate::control::Call;
use crate::fault::FaultKind;
use crate::registers::mask;

/// Carries out a text instruction; `None` when it is none.
pub(crate) fn execute(call: &mut Call<'_>) -> Option<Result<(), FaultKind>> {
    Some(match call.service() {
        Service::StrCpy => copy(call, true),
        Service::StrAdd => append(call),
        Service::BinStr => digits(call, false),
        Service::BcdStr => digits(call, true),
        Service::StrCmp => compare(call, true),
        Service::MemCpy => copy(call, false),
        Service::MemCmp => compare(call, false),
        _ => return None,
    })
}

/// Characters that operand 2 asks for; a negative number asks for none.
fn count(call: &Call<'_>) -> Result<Option<usize>, FaultKind> {
    Ok(call.integer(2)?.map(|count| usize::try_from(count).unwrap_or(0)))
}

/// STRCPY and MEMCPY. A text keeps a byte for its end mark: that is written when the source ends or fills the target, and
/// not when `num` characters were copied, so that the target gets no shorter.
fn copy(call: &mut Call<'_>, text: bool) -> Result<(), FaultKind> {
    let Some((addr, len)) = call.area(0)? else { return Ok(()) };
    let wanted = count(call)?;
    let room = if text { (len as usize).saturating_sub(1) } else { len as usize };
    let source = if text { call.text(1)?.unwrap_or_default() } else { call.content(1)? };
    let asked = wanted.unwrap_or(usize::MAX).min(room);
    let taken = source.len().min(asked);
    let ended = source.len() <= asked && wanted.is_none_or(|wanted| source.len() < wanted);
    let marked = text && len > 0 && (ended || taken == room && wanted.is_none());
    put(call, addr, taken, marked)
}

/// So many bytes of operand 1, and an end mark behind them. The end mark comes last: the source may lie inside the target.
fn put(call: &mut Call<'_>, addr: Addr, taken: usize, marked: bool) -> Result<(), FaultKind> {
    call.bytes(addr, taken as u32 + u32::from(marked))?;
    call.copy(addr, 1, taken)?;
    if marked { call.write(addr + taken as Addr, &[0]) } else { Ok(()) }
}

/// STRADD: behind the text that is there, cut at the end of the target.
fn append(call: &mut Call<'_>) -> Result<(), FaultKind> {
    let Some((addr, len)) = call.area(0)? else { return Ok(()) };
    let room = (len as usize).saturating_sub(1);
    let used = call.text(0)?.map_or(0, <[u8]>::len).min(room);
    let taken = call.text(1)?.map_or(0, <[u8]>::len).min(room - used);
    put(call, addr + used as Addr, taken, len > 0)
}

/// STRCMP and MEMCMP: RLO tells equality. Without `num` a text is compared with its end mark, bytes to the length of the second
/// operand.
fn compare(call: &mut Call<'_>, text: bool) -> Result<(), FaultKind> {
    let wanted = count(call)?;
    let equal = if text {
        let (a, b) = (call.text(0)?.unwrap_or_default(), call.text(1)?.unwrap_or_default());
        match wanted {
            Some(wanted) => a[..a.len().min(wanted)] == b[..b.len().min(wanted)],
            None => a == b,
        }
    } else {
        let (a, b) = (call.content(0)?, call.content(1)?);
        let len = wanted.unwrap_or(b.len());
        a.get(..len).is_some_and(|a| Some(a) == b.get(..len))
    };
    call.set_rlo(equal);
    Ok(())
}

/// BINSTR and BCDSTR: the number in DR as so many digits as the target has characters, with leading zeros; of a longer
/// number the low digits. A BCD digit above 9 is a fault.
fn digits(call: &mut Call<'_>, bcd: bool) -> Result<(), FaultKind> {
    let width = if call.keyword(1) == Some("DWRD") { Width::DWord } else { Width::Word };
    let Some((addr, len)) = call.area(0)? else { return Ok(()) };
    let mut number = (call.dr() & mask(width)).cast_unsigned();
    let base = if bcd { 16 } else { 10 };
    let count = (len as usize).saturating_sub(1);
    call.bytes(addr, len)?;
    // All digits are looked at before one is written.
    let bad = (0..count.min(8)).any(|n| (number >> (4 * n)) & 15 > 9);
    if bcd && bad {
        return Err(FaultKind::BcdRange);
    }
    for n in (0..count).rev() {
        call.write(addr + n as Addr, &[b'0' + (number % base) as u8])?;
        number /= base;
    }
    if len > 0 { call.write(addr + count as Addr, &[0]) } else { Ok(()) }
}
