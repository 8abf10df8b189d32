//! Places of the memory that is kept while the power is off (manual 18.1).
//!
//! The catalogue of system symbols allocates them; a test there holds them equal to it.

use super::bit;
use crate::op::{Addr, BitRef};

/// PLC_MEM_BACKUP.
pub const PLC_MEM_BACKUP: Addr = 0x1370;
/// Length of PLC_MEM_BACKUP in bytes.
pub const PLC_MEM_BACKUP_LEN: u32 = 10_000;
/// REQ_BACKUP_MEM: 1 saves PLC_MEM_BACKUP.
pub const REQ_BACKUP_MEM: BitRef = bit(0x136F, 0);
