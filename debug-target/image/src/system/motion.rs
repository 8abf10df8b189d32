//! Places of the interface cells and bits that axes and spindles read and write (manual 8.1, 12, 15 and 20).
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

/// Bits of one kind, one an axis: the byte of axes X to 6, then the two bytes of axes 7 to 16.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AxisBits(pub Addr);

impl AxisBits {
    /// The bit of an axis, counted from 0 (X) to 15.
    #[must_use]
    pub const fn of(self, axis: u8) -> BitRef {
        if axis < 6 { bit(self.0, axis) } else { bit(self.0 + 1 + (axis as Addr - 6) / 8, (axis - 6) % 8) }
    }
}

/// Bits of one kind, one an axis, of the first six axes only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SixBits(pub Addr);

impl SixBits {
    /// The bit of an axis, counted from 0 (X) to 5.
    #[must_use]
    pub const fn of(self, axis: u8) -> BitRef {
        bit(self.0, axis)
    }
}

// Families of bits, one an axis; the symbol of the first axis stands for all.
places! { FAMILIES: AxisBits;
    /// MPXPI …: motion enable by the program.
    ENABLE: "MPXPI" = AxisBits(0x0400);
    /// MPXMAN …: motion enable for manual movement.
    ENABLE_MANUAL: "MPXMAN" = AxisBits(0x0403);
    /// PO_OSXPI …: motion requested.
    REQUESTED: "PO_OSXPI" = AxisBits(0x0407);
    /// SM_POXPI …: direction of motion, 1 negative.
    NEGATIVE: "SM_POXPI" = AxisBits(0x040a);
    /// VAZBA_X …: position loop closed.
    LOOP_CLOSED: "VAZBA_X" = AxisBits(0x040d);
    /// POLOHV_X …: on the way to the zero pulse.
    ORIENTING: "POLOHV_X" = AxisBits(0x0410);
    /// KRX …: reference switch.
    REFERENCE_SWITCH: "KRX" = AxisBits(0x0415);
    /// KRRX …: reversing reference switch.
    REVERSING_SWITCH: "KRRX" = AxisBits(0x0418);
    /// ZPRX …: slow-down switch of the reference run.
    SLOW_DOWN_SWITCH: "ZPRX" = AxisBits(0x041b);
    /// KHX0 …: limit switch in positive direction.
    LIMIT_PLUS: "KHX0" = AxisBits(0x041e);
    /// KHX1 …: limit switch in negative direction.
    LIMIT_MINUS: "KHX1" = AxisBits(0x0421);
    /// ZPX0 …: slow-down limit switch, first.
    SLOW_LIMIT_PLUS: "ZPX0" = AxisBits(0x0424);
    /// ZPX1 …: slow-down limit switch, second.
    SLOW_LIMIT_MINUS: "ZPX1" = AxisBits(0x0427);
}

places! { SIX_FAMILIES: SixBits;
    /// MPX …: resulting motion enable, six axes.
    ENABLED: "MPX" = SixBits(0x0406);
    /// EXM_X0 …: request of the program to jog in positive direction, six axes.
    EXTERNAL_PLUS: "EXM_X0" = SixBits(0x0413);
    /// EXM_X1 …: request of the program to jog in negative direction, six axes.
    EXTERNAL_MINUS: "EXM_X1" = SixBits(0x0414);
    /// MM_X0 …: jog requested in positive direction.
    JOG_PLUS: "MM_X0" = SixBits(0x3ae8);
    /// MM_X1 …: jog requested in negative direction.
    JOG_MINUS: "MM_X1" = SixBits(0x3ae9);
}

places! { CELLS: Addr;
    /// B_POL: DWORD per axis (6), 1/8 µm.
    POSITION_OLD: "B_POL" = 0x042a;
    /// B_INK: DWORD per axis (6), 1/8 µm.
    INCREMENT_OLD: "B_INK" = 0x0442;
    /// B_POL_EX: QWORD per axis, 1/65536 µm.
    POSITION: "B_POL_EX" = 0x045a;
    /// POSITION_POS1_EX: QWORD per axis; POS2 to POS5 follow.
    POSITION_POS1: "POSITION_POS1_EX" = 0x055a;
    /// DIFCIT_X: DWORD per axis, µm.
    DIFFERENCE: "DIFCIT_X" = 0x07da;
    /// BZH09: WORD, per mille.
    OVERRIDE_FEED: "BZH09" = 0x081d;
    /// FEED_OVR_MULTIPLIER: WORD, per mille.
    FEED_MULTIPLIER: "FEED_OVR_MULTIPLIER" = 0x081f;
    /// LIMIT_FEED: DWORD, 1/65536 mm/s.
    LIMIT_FEED: "LIMIT_FEED" = 0x0822;
    /// LIMIT_FEED_G00: DWORD, 1/65536 mm/s.
    LIMIT_FEED_RAPID: "LIMIT_FEED_G00" = 0x0826;
    /// HOMING: WORD, a bit an axis: reference is valid.
    HOMING: "HOMING" = 0x082a;
    /// HOMING_REQ: WORD, a bit an axis: set the zero point.
    HOMING_REQ: "HOMING_REQ" = 0x082c;
    /// REFPOINT_DIST: QWORD per axis, 1/65536 µm.
    REFPOINT_DIST: "REFPOINT_DIST" = 0x082e;
    /// HOMING_START_REQ: WORD, a bit an axis: make a reference run.
    HOMING_START_REQ: "HOMING_START_REQ" = 0x08ae;
    /// SLS_REFER: WORD, a bit an axis: software limits on.
    SLS_REFER: "SLS_REFER" = 0x08b1;
    /// NLCAXISENABLE: WORD, a bit an axis: non-linear corrections on.
    NLC_AXIS_ENABLE: "NLCAXISENABLE" = 0x08b3;
    /// DWAXNCACCELERATION: DWORD per axis, 1/65536 µm/ms².
    ACCELERATION: "DWAXNCACCELERATION" = 0x08bc;
    /// DWAXNCACCELERATIONRT: DWORD per axis, 1/65536 µm/ms².
    ACCELERATION_RAPID: "DWAXNCACCELERATIONRT" = 0x08fc;
    /// DWAXNCACCELERATIONEMERGENCY: DWORD per axis, 1/65536 µm/ms².
    ACCELERATION_EMERGENCY: "DWAXNCACCELERATIONEMERGENCY" = 0x093c;
    /// DWAXNCFEED: DWORD per axis, 1/65536 µm/ms.
    FEED: "DWAXNCFEED" = 0x0bbc;
    /// DWAXNCFEEDRT: DWORD per axis, 1/65536 µm/ms.
    FEED_RAPID: "DWAXNCFEEDRT" = 0x0bfc;
    /// SERVOREQPOSITION: DWORD per servo loop, µm.
    SERVO_REQUESTED: "SERVOREQPOSITION" = 0x3b63;
    /// SERVOPOSITION: DWORD per servo loop, µm.
    SERVO_MEASURED: "SERVOPOSITION" = 0x3ba3;
    /// SERVO_POSITION: DWORD per servo loop, increments.
    SERVO_INCREMENTS: "SERVO_POSITION" = 0x3be3;
    /// PB_HOMING_AXIS: WORD, a bit an axis: the program shall reference it.
    HOMING_AXES: "PB_HOMING_AXIS" = 0x4a73;
    /// SLS_LIMIT_PLUS: BYTE, a bit an axis.
    SOFT_LIMIT_PLUS: "SLS_LIMIT_PLUS" = 0x4a75;
    /// SLS_LIMIT_MINUS: BYTE, a bit an axis.
    SOFT_LIMIT_MINUS: "SLS_LIMIT_MINUS" = 0x4a76;
    /// SLS_DRAG_PLUS: BYTE, a bit an axis.
    SOFT_SLOW_PLUS: "SLS_DRAG_PLUS" = 0x4a77;
    /// SLS_DRAG_MINUS: BYTE, a bit an axis.
    SOFT_SLOW_MINUS: "SLS_DRAG_MINUS" = 0x4a78;
    /// PRF: BYTE, feed override of the panel.
    FEED_PERCENT: "PRF" = 0x4a79;
    /// BZH13: BYTE, number of a real-time error.
    ERROR_NUMBER: "BZH13" = 0x1353;
    /// POS_SPACE_PLC: BYTE, 0 to 6.
    JOG_SPACE: "POS_SPACE_PLC" = 0x081a;
    /// POS_SPACE_MMM: BYTE, 0 to 6.
    PANEL_SPACE: "POS_SPACE_MMM" = 0x081b;
    /// KNOB_STEP: WORD, µm.
    WHEEL_STEP: "KNOB_STEP" = 0x4a47;
    /// SHIFT_ENABLE: BYTE, a bit an axis.
    OFFSET_ALLOWED: "SHIFT_ENABLE" = 0x4a49;
    /// SHIFT_CONTROL: BYTE, a bit an axis.
    OFFSET_AXIS: "SHIFT_CONTROL" = 0x4a4a;
    /// SHIFT_X: DWORD per axis (6), 1/8 µm.
    OFFSET: "SHIFT_X" = 0x4a4b;
    /// EXT_FEED_AUTMAN: WORD, mm/min.
    EXTERNAL_FEED: "EXT_FEED_AUTMAN" = 0x0c89;
    /// EXT_FEED_G00_AUTMAN: WORD, mm/min.
    EXTERNAL_FEED_RAPID: "EXT_FEED_G00_AUTMAN" = 0x0c8b;
    /// VYSOVERS: WORD, 0 to 7FFFh.
    SPINDLE_VOLTAGE: "VYSOVERS" = 0x0c49;
    /// REQ_SPEED_PM: DWORD, 1/1000 rev/min.
    REQUESTED_PM: "REQ_SPEED_PM" = 0x0c4b;
    /// REQ_SPEED_PT: DWORD, 1/1000 ° per millisecond.
    REQUESTED_PT: "REQ_SPEED_PT" = 0x0c4f;
    /// ACT_SPEED_PM: DWORD, 1/1000 rev/min.
    ACTUAL_PM: "ACT_SPEED_PM" = 0x0c53;
    /// ACT_SPEED_PT: DWORD, 1/1000 ° per millisecond.
    ACTUAL_PT: "ACT_SPEED_PT" = 0x0c57;
    /// ACT_SPEED2_PM: DWORD, 1/1000 rev/min.
    ACTUAL_2_PM: "ACT_SPEED2_PM" = 0x0c5b;
    /// ACT_SPEED2_PT: DWORD, 1/1000 ° per millisecond.
    ACTUAL_2_PT: "ACT_SPEED2_PT" = 0x0c5f;
    /// AVG_SPEED_PM: DWORD, 1/1000 rev/min.
    AVERAGE_PM: "AVG_SPEED_PM" = 0x0c63;
    /// AVG_SPEED_PT: DWORD, 1/1000 ° per millisecond.
    AVERAGE_PT: "AVG_SPEED_PT" = 0x0c67;
    /// AVG_SPEED2_PM: DWORD, 1/1000 rev/min.
    AVERAGE_2_PM: "AVG_SPEED2_PM" = 0x0c6b;
    /// AVG_SPEED2_PT: DWORD, 1/1000 ° per millisecond.
    AVERAGE_2_PT: "AVG_SPEED2_PT" = 0x0c6f;
    /// SIM_SPEED_PT: DWORD, 1/1000 ° per millisecond.
    SIMULATED_PT: "SIM_SPEED_PT" = 0x0c73;
    /// SPINDLE_GEAR_ACT_1: WORD, 1 to 32.
    GEAR: "SPINDLE_GEAR_ACT_1" = 0x0c7b;
    /// SPEED_OVR_EXT: WORD, per mille.
    OVERRIDE_SPEED: "SPEED_OVR_EXT" = 0x0c7e;
    /// SPEED_OVR_MULTIPLIER: WORD, per mille.
    SPEED_MULTIPLIER: "SPEED_OVR_MULTIPLIER" = 0x0c80;
    /// AKRR_ACT_V: DWORD, mm/min. Eight more in force follow: greatest speed, correction of the radius and of the cutting
    /// speed, radius, greatest speed and range of the gear, speed and output that were computed.
    CUTTING_SPEED_ACT: "AKRR_ACT_V" = 0x3aa4;
    /// AKRR_V: DWORD, mm/min.
    CUTTING_SPEED: "AKRR_V" = 0x3ac8;
    /// AKRR_SMAX: DWORD, 1/1000 rev/min.
    CUTTING_LIMIT: "AKRR_SMAX" = 0x3acc;
    /// AKRR_DIST: DWORD, 1/8 µm.
    CUTTING_DISTANCE: "AKRR_DIST" = 0x3ad0;
    /// AKRR_VCORR: DWORD, mm/min.
    CUTTING_CORRECTION: "AKRR_VCORR" = 0x3ad4;
    /// AKRR_P: DWORD, 1/1000 rev/min.
    CUTTING_GEAR_SPEED: "AKRR_P" = 0x3ad8;
    /// AKRR_U: DWORD, 0 to 7FFFh.
    CUTTING_RANGE: "AKRR_U" = 0x3adc;
    /// AKRR_R: DWORD, 1/8 µm.
    CUTTING_RADIUS: "AKRR_R" = 0x3ae0;
    /// RSPINDLE_OUTPUT_1: REAL, 1.0 is 10 V.
    OUTPUT_PROGRAMMED: "RSPINDLE_OUTPUT_1" = 0x4a63;
    /// RSPINDLE_PRS_OUTPUT_1: REAL, 1.0 is 10 V.
    OUTPUT_CORRECTED: "RSPINDLE_PRS_OUTPUT_1" = 0x4a6b;
}

places! { BITS: BitRef;
    /// FEED_OVR: the feed override comes from the program.
    FEED_FROM_PROGRAM: "FEED_OVR" = bit(0x081c, 0);
    /// LIMIT_FEED_REQ: LIMIT_FEED counts.
    LIMIT_FEED_REQ: "LIMIT_FEED_REQ" = bit(0x0821, 0);
    /// LIMIT_FEED_G00_REQ: LIMIT_FEED_G00 counts.
    LIMIT_FEED_RAPID_REQ: "LIMIT_FEED_G00_REQ" = bit(0x0821, 1);
    /// HOMING_SINGLE: reference of one axis asked for.
    HOMING_SINGLE: "HOMING_SINGLE" = bit(0x08b0, 0);
    /// HOMING_PLC: the program shall make a reference.
    HOMING_PLC: "HOMING_PLC" = bit(0x08b0, 1);
    /// HOMING_GROUP: the program shall make a group reference.
    HOMING_GROUP: "HOMING_GROUP" = bit(0x08b0, 2);
    /// SF_LS: a limit switch is active.
    LIMIT_SWITCH: "SF_LS" = bit(0x1355, 5);
    /// SF_SLS: a software limit is reached.
    SOFT_LIMIT: "SF_SLS" = bit(0x1355, 6);
    /// ACK_AUTMAN: manual movement is active.
    JOG_ACTIVE: "ACK_AUTMAN" = bit(0x0c82, 0);
    /// AUTMAN_REQ: request for manual movement.
    JOG_REQ: "AUTMAN_REQ" = bit(0x0c82, 1);
    /// AUTMAN_CONT_NC: the panel controls manual movement.
    JOG_FROM_PANEL: "AUTMAN_CONT_NC" = bit(0x0c83, 0);
    /// AUTMAN_CONT_SELECT: an axis is being preselected.
    JOG_SELECTING: "AUTMAN_CONT_SELECT" = bit(0x0c85, 0);
    /// AUTMAN_CONT_G00: rapid manual movement from the panel.
    JOG_RAPID: "AUTMAN_CONT_G00" = bit(0x0c85, 1);
    /// INPOS_STOP: the machine stands where it last stopped.
    AT_STOP_POINT: "INPOS_STOP" = bit(0x0c86, 0);
    /// REQ_EXT_CONT_AUTMAN: the program controls manual movement.
    EXTERNAL_JOG: "REQ_EXT_CONT_AUTMAN" = bit(0x0c86, 1);
    /// REQ_EXT_FEED_AUTMAN: EXT_FEED_AUTMAN counts.
    EXTERNAL_FEED_REQ: "REQ_EXT_FEED_AUTMAN" = bit(0x0c86, 2);
    /// REQ_EXT_G00_AUTMAN: the program wants rapid manual movement.
    EXTERNAL_RAPID: "REQ_EXT_G00_AUTMAN" = bit(0x0c87, 0);
    /// REQ_EXT_SELECT_AUTMAN: the program preselects an axis.
    EXTERNAL_SELECT: "REQ_EXT_SELECT_AUTMAN" = bit(0x0c87, 1);
    /// EN_AUTMAN: manual movement is allowed.
    JOG_ALLOWED: "EN_AUTMAN" = bit(0x0c88, 0);
    /// REQ_EXT_FEED_G00_AUTMAN: EXT_FEED_G00_AUTMAN counts.
    EXTERNAL_RAPID_FEED_REQ: "REQ_EXT_FEED_G00_AUTMAN" = bit(0x0c88, 1);
    /// G95_AUTMAN: feeds of manual movement are µm a revolution.
    JOG_PER_REVOLUTION: "G95_AUTMAN" = bit(0x4a44, 2);
    /// AUTMAN_SELECT: edge that begins manual movement.
    JOG_BEGIN: "AUTMAN_SELECT" = bit(0x4a45, 0);
    /// AUTMAN_CANCEL: edge that ends manual movement.
    JOG_END: "AUTMAN_CANCEL" = bit(0x4a45, 1);
    /// REQ_ESHIFT: the independent shift is selected.
    OFFSET_MODE: "REQ_ESHIFT" = bit(0x4a44, 0);
    /// ACT_ESHIFT: the handwheel shifts the axis.
    OFFSET_ACTIVE: "ACT_ESHIFT" = bit(0x4a44, 1);
    /// AUTMAN_WHEEL_DIS: jog keys do not preselect an axis for the handwheel.
    NO_WHEEL: "AUTMAN_WHEEL_DIS" = bit(0x4a46, 0);
    /// AUTMAN_KNOB_TOGGLE: a key of preselection switches it on and off by turns.
    WHEEL_TOGGLE: "AUTMAN_KNOB_TOGGLE" = bit(0x4a46, 1);
    /// REF_SERV_1: reference switch of servo loop 1; the others follow bit by bit.
    SERVO_SWITCH: "REF_SERV_1" = bit(0x4cc2, 0);
    /// REQ_EXT_SPINDLE_GEAR: the program controls the gear.
    GEAR_FROM_PROGRAM: "REQ_EXT_SPINDLE_GEAR" = bit(0x0c7d, 0);
    /// REQ_MAN_SPINDLE_GEAR: the gear is set by hand.
    GEAR_BY_HAND: "REQ_MAN_SPINDLE_GEAR" = bit(0x0c7d, 1);
    /// EXT_AKRR_V: AKRR_V counts.
    CUTTING_SPEED_GIVEN: "EXT_AKRR_V" = bit(0x3ae4, 0);
    /// EXT_AKRR_SMAX: AKRR_SMAX counts.
    CUTTING_LIMIT_GIVEN: "EXT_AKRR_SMAX" = bit(0x3ae4, 1);
    /// EXT_AKRR_DIST: AKRR_DIST counts.
    CUTTING_DISTANCE_GIVEN: "EXT_AKRR_DIST" = bit(0x3ae4, 2);
    /// EXT_AKRR_VCORR: AKRR_VCORR counts.
    CUTTING_CORRECTION_GIVEN: "EXT_AKRR_VCORR" = bit(0x3ae4, 3);
    /// EXT_AKRR_REQ: the program switches the constant cutting speed on.
    CUTTING_REQ: "EXT_AKRR_REQ" = bit(0x3ae4, 4);
    /// EXT_AKRR_SUPORT: without corrections and shifts.
    CUTTING_FROM_SLIDE: "EXT_AKRR_SUPORT" = bit(0x3ae4, 5);
    /// EXT_AKRR_P: AKRR_P counts.
    CUTTING_GEAR_GIVEN: "EXT_AKRR_P" = bit(0x3ae4, 6);
    /// EXT_AKRR_U: AKRR_U counts.
    CUTTING_RANGE_GIVEN: "EXT_AKRR_U" = bit(0x3ae4, 7);
    /// EXT_AKRR_R: AKRR_R counts.
    CUTTING_RADIUS_GIVEN: "EXT_AKRR_R" = bit(0x3ae5, 0);
    /// SF_STOPPOSCHANGED: moved by hand during a stop.
    STOP_POINT_LEFT: "SF_STOPPOSCHANGED" = bit(0x1356, 0);
    /// SPEED_OVR: the spindle override comes from the program.
    SPEED_FROM_PROGRAM: "SPEED_OVR" = bit(0x0c7d, 2);
}
