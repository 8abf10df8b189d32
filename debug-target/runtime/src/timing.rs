//! DFTM rasters, TM and the counting functions (manual 3.8).

use technol_image::op::{Addr, Count, Place, Raster, Width};

use crate::decimal::{from_bcd, to_bcd};
use crate::fault::FaultKind;
use crate::memory::Memory;
use crate::registers::{Registers, mask};

/// The raster ticks now: whole intervals since the start of the PLC, the start itself is none.
pub(crate) fn ticks(rate: Raster, millis: u64) -> bool {
    let interval = match rate {
        Raster::Tenth => 100,
        Raster::Second => 1_000,
        Raster::TenSeconds => 10_000,
        Raster::HundredSeconds => 100_000,
    };
    millis > 0 && millis.is_multiple_of(interval)
}

/// TM: RLO after DR passes with RLO = 1 without a break; compared unsigned at the counter's width.
pub(crate) fn timer(
    memory: &mut Memory,
    regs: &mut Registers,
    count: Place,
    width: Width,
) -> Result<(), FaultKind> {
    let at = memory.resolve(count.addr, count.indexed, regs.bx, width.bytes())?;
    if !regs.rlo {
        memory.write_at(at, width, 0);
        return Ok(());
    }
    let now = memory.read_at(at, width) & mask(width);
    regs.rlo = now >= regs.dr & mask(width);
    if !regs.rlo {
        memory.write_at(at, width, now + 1);
    }
    Ok(())
}

/// CU, CD, CUBCD: counts on a 0 to 1 change of RLO, then RLO := counter = preset in DR, DR := counter.
pub(crate) fn counter(
    memory: &mut Memory,
    regs: &mut Registers,
    op: Count,
    count: Place,
    width: Width,
    state: Addr,
) -> Result<(), FaultKind> {
    let at = memory.resolve(count.addr, count.indexed, regs.bx, width.bytes())?;
    let now = memory.read_at(at, width) & mask(width);
    let stepped = match op {
        Count::Up => now + 1,
        Count::Down => now - 1,
        Count::UpBcd => {
            let value = from_bcd(now as u32).ok_or(FaultKind::BcdRange)?;
            let modulus = if width == Width::Byte { 100 } else { 10_000 };
            i64::from(to_bcd((value + 1) % modulus))
        }
    };
    let before = memory.byte(state);
    if regs.rlo && before & 1 == 0 {
        memory.write_at(at, width, stepped);
    }
    memory.set_byte(state, u8::from(regs.rlo));
    let content = memory.read_at(at, width);
    regs.rlo = (content ^ regs.dr) & mask(width) == 0;
    regs.dr = content;
    Ok(())
}
