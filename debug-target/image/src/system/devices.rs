//! Places of analogue channels, of the EtherCAT master and of drives on buses (manual 10.5, 13.14.3, 13.18.2 and 26.3).
//!
//! The catalogue of system symbols allocates them; a test there holds [`CELLS`] and [`BITS`] equal to it.

use super::bit;
use crate::op::{Addr, BitRef};

macro_rules! places {
    ($table:ident: $kind:ty; $($(#[$doc:meta])* $name:ident: $symbol:literal = $place:expr;)*) => {
        $($(#[$doc])* pub const $name: $kind = $place;)*
        /// Symbols of the catalogue and the places they have here.
        pub const $table: &[(&str, $kind)] = &[$(($symbol, $name)),*];
    };
}

/// Channels of each of the two arrays of analogue values.
pub const ANALOG_CHANNELS: u8 = 100;
/// EtherCAT drives: servo loops 0 to 15.
pub const DRIVES: u8 = 16;

// Arrays, of which the first element is named.
places! { CELLS: Addr;
    /// ANALOG_INPUT_PHYSICAL: 100 reals, volts.
    ANALOG_INPUT: "ANALOG_INPUT_PHYSICAL" = 0x0C99;
    /// ANALOG_OUTPUT_PHYSICAL: 100 reals, volts.
    ANALOG_OUTPUT: "ANALOG_OUTPUT_PHYSICAL" = 0x0FB9;
    /// ANALOG_CONNECTED: 100 bytes.
    ANALOG_CONNECTED: "ANALOG_CONNECTED" = 0x12D9;
    /// CAN_DRIVE_STAT: 16 words.
    CAN_STATUS: "CAN_DRIVE_STAT" = 0x3AEA;
    /// CAN_DRIVE_CMD: 16 words.
    CAN_COMMAND: "CAN_DRIVE_CMD" = 0x3B2A;
    /// SERVO_POSITION: 16 double words.
    SERVO_POSITION: "SERVO_POSITION" = 0x3BE3;
    /// wEdrvDriveStatus0 …: words.
    EDRV_STATUS: "wEdrvDriveStatus0" = 0x4A7C;
    /// dwEdrvDrivePos0 …: double words.
    EDRV_POSITION: "dwEdrvDrivePos0" = 0x4A9C;
    /// wEdrvDriveErrReg0 …: words.
    EDRV_ERROR_CODE: "wEdrvDriveErrReg0" = 0x4ADC;
    /// wEdrvDriveControl0 …: words.
    EDRV_CONTROL: "wEdrvDriveControl0" = 0x4AFC;
    /// dwEdrvDrivePosReq0 …: double words.
    EDRV_TARGET: "dwEdrvDrivePosReq0" = 0x4B1C;
    /// dwEdrvDriveVeloReq0 …: double words.
    EDRV_SPEED: "dwEdrvDriveVeloReq0" = 0x4B5C;
    /// bEdrvState0 …: bytes.
    EDRV_STATE: "bEdrvState0" = 0x4B9C;
    /// rEdrvScaleSpeed0 …: reals.
    EDRV_SCALE: "rEdrvScaleSpeed0" = 0x4BBC;
}

// Single bits, and the first of 16 in two bytes each.
places! { BITS: BitRef;
    /// flEcatStartCyclicOperation: request to start the cyclic exchange.
    ECAT_START: "flEcatStartCyclicOperation" = bit(0x3AA3, 0);
    /// flEcatOperational: the master has reached OPERATIONAL.
    ECAT_OPERATIONAL: "flEcatOperational" = bit(0x3AA3, 1);
    /// flEcatBootStrapReq: request of BOOTSTRAP.
    ECAT_BOOTSTRAP_REQ: "flEcatBootStrapReq" = bit(0x3AA3, 2);
    /// flEcatInitReq: request of INIT.
    ECAT_INIT_REQ: "flEcatInitReq" = bit(0x3AA3, 3);
    /// flEcatPreOperationalReq: request of PRE-OPERATIONAL.
    ECAT_PREOP_REQ: "flEcatPreOperationalReq" = bit(0x3AA3, 4);
    /// flEcatSafeOperationalReq: request of SAFE-OPERATIONAL.
    ECAT_SAFEOP_REQ: "flEcatSafeOperationalReq" = bit(0x3AA3, 5);
    /// flEcatOperationalReq: request of OPERATIONAL.
    ECAT_OP_REQ: "flEcatOperationalReq" = bit(0x3AA3, 6);
    /// flEdrvMoveDisReq0 …: no motion, please.
    EDRV_HOLD: "flEdrvMoveDisReq0" = bit(0x4BAC, 0);
    /// flEdrvError0 …: error.
    EDRV_ERROR: "flEdrvError0" = bit(0x4BAE, 0);
    /// flEdrvInit0 …: request to initialise.
    EDRV_INIT: "flEdrvInit0" = bit(0x4BB0, 0);
    /// flEdrvOn0 …: request to switch on.
    EDRV_ON: "flEdrvOn0" = bit(0x4BB2, 0);
    /// flEdrvEnable0 …: request to enable.
    EDRV_ENABLE: "flEdrvEnable0" = bit(0x4BB4, 0);
    /// flEdrvDisable0 …: request to disable.
    EDRV_DISABLE: "flEdrvDisable0" = bit(0x4BB6, 0);
    /// flEdrvDone0 …: request to end.
    EDRV_DONE: "flEdrvDone0" = bit(0x4BB8, 0);
    /// flEdrvErase0 …: request to erase errors.
    EDRV_ERASE: "flEdrvErase0" = bit(0x4BBA, 0);
    /// flEdrvSimul0 …: simulated by the control itself.
    EDRV_SIMULATED: "flEdrvSimul0" = bit(0x4C3C, 0);
}
