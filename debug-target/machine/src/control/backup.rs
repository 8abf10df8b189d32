//! Memory that is kept while the power is off (manual 18.1): loaded at power-on, saved on REQ_BACKUP_MEM and at the end.

use alloc::vec::Vec;

use technol_image::system::data::{PLC_MEM_BACKUP, PLC_MEM_BACKUP_LEN, REQ_BACKUP_MEM};

const START: usize = PLC_MEM_BACKUP as usize;
const END: usize = START + PLC_MEM_BACKUP_LEN as usize;

/// Puts what was saved into memory; what was not saved stays.
pub(super) fn load(backup: &[u8], memory: &mut [u8]) {
    if let Some(area) = memory.get_mut(START..END) {
        for (place, byte) in area.iter_mut().zip(backup) {
            *place = *byte;
        }
    }
}

/// Makes room for the whole area, so that saving it needs no memory.
pub(super) fn make_room(backup: &mut Vec<u8>) {
    backup.reserve_exact((END - START).saturating_sub(backup.len()));
}

/// Copies the memory.
pub(super) fn save(backup: &mut Vec<u8>, memory: &[u8]) {
    if let Some(area) = memory.get(START..END) {
        backup.clear();
        backup.extend_from_slice(area);
    }
}

/// Whether the program asks to save; the request is taken back.
pub(super) fn take_request(memory: &mut [u8]) -> bool {
    let mask = 1 << REQ_BACKUP_MEM.bit;
    memory.get_mut(REQ_BACKUP_MEM.addr as usize).is_some_and(|byte| {
        let asked = *byte & mask != 0;
        *byte &= !mask;
        asked
    })
}
