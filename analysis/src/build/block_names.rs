//! Names of the members of prepared blocks for listings: `BLK[1].T`.

use technol_image::op::Addr;
use technol_image::system::{BLOCK_RECORD_COUNT, BLOCK_RECORDS, block_record};

use crate::catalogue::{self, SystemKind};

/// The member of a prepared block that a bit is; `None` for other bits.
pub(super) fn bit(addr: Addr, bit: u8) -> Option<String> {
    let (number, offset) = place(addr)?;
    let is_it =
        |kind: &SystemKind| matches!(*kind, SystemKind::Bit { addr, bit: b } if (addr, b) == (offset, bit));
    let member = catalogue::block_members().find(|member| is_it(&member.kind))?;
    Some(format!("BLK[{number}].{}", member.spelling))
}

/// The member that begins at an address: which block, and its name.
pub(super) fn cell(addr: Addr) -> Option<(u32, String)> {
    let (number, offset) = place(addr)?;
    catalogue::block_members().find_map(|member| {
        let (start, len) = member.kind.bytes()?;
        let inside = offset.checked_sub(start).filter(|n| *n < len)?;
        let name = match member.kind {
            SystemKind::Array { element, .. } => {
                format!("{}[{}]", member.spelling, inside / element.bytes())
            }
            _ => member.spelling.to_owned(),
        };
        Some((number, name))
    })
}

/// Number of the block and offset in its record.
fn place(addr: Addr) -> Option<(u32, u32)> {
    let offset = addr.checked_sub(BLOCK_RECORDS)?;
    let number = offset / block_record::LEN;
    (number < BLOCK_RECORD_COUNT).then_some((number, offset % block_record::LEN))
}
