//! Elements of the real-time program, `RTM.`: other names of cells of the interface (manual 27.4).

use technol_image::op::{Addr, BitRef};
use technol_image::system::motion::{self as place, AxisBits, SixBits};
use technol_image::system::{self, data};

use super::cell::{Cell, int};
use super::value::CellType;

/// Where an element lies.
#[derive(Clone, Copy)]
enum Place {
    /// A bit.
    Bit(BitRef),
    /// A bit for each of 16 axes.
    Axes(AxisBits),
    /// A bit for each of six axes.
    Six(SixBits),
    /// Bits in a row of bytes; so many.
    Mask(Addr, u32),
    /// Cells in a row: type, number, and what one of them is in the unit of the element.
    Cells(Addr, CellType, u32, f64),
}
use Place::{Axes, Bit, Cells, Mask, Six};

/// One cell.
const fn one(addr: Addr, kind: CellType) -> Place {
    Cells(addr, kind, 1, 1.0)
}

const BYTE: CellType = int(1, false);
const WORD: CellType = int(2, false);
const DWORD: CellType = int(4, true);
const QWORD: CellType = int(8, true);
/// Millimetres of 1/65536 µm, and of a µm.
const FRACTION: f64 = 1.0 / 65_536_000.0;
const MICRO: f64 = 1.0 / 1000.0;
/// Revolutions a minute of thousandths, and revolutions of thousandths of a degree.
const TURNS: f64 = 1.0 / 1000.0;
const ANGLE: f64 = 1.0 / 360_000.0;
/// Axes of the control.
const AXES: u32 = 16;
/// Bits in a BYTE of the first six axes.
const SIX: u32 = 6;

const fn beside(bit: BitRef, by: u8) -> BitRef {
    BitRef { addr: bit.addr, bit: bit.bit + by, indexed: false }
}

/// Names without `RTM.` and index, in small letters.
const ELEMENTS: &[(&str, Place)] = &[
    ("axis.reqshift", Bit(place::OFFSET_MODE)),
    ("axis.actshift", Bit(place::OFFSET_ACTIVE)),
    ("axis.shiftenable_ax", Mask(place::OFFSET_ALLOWED, SIX)),
    ("axis.knobstep", one(place::WHEEL_STEP, WORD)),
    ("axis.pos0_ax", Cells(place::POSITION, QWORD, AXES, FRACTION)),
    ("axis.pos1_ax", Cells(place::POSITION_POS1, QWORD, AXES, FRACTION)),
    ("axis.pos2_ax", Cells(place::POSITION_POS1 + 128, QWORD, AXES, FRACTION)),
    ("axis.pos3_ax", Cells(place::POSITION_POS1 + 256, QWORD, AXES, FRACTION)),
    ("axis.pos4_ax", Cells(place::POSITION_POS1 + 384, QWORD, AXES, FRACTION)),
    ("axis.pos5_ax", Cells(place::POSITION_POS1 + 512, QWORD, AXES, FRACTION)),
    ("servo.servoposition", Cells(place::SERVO_MEASURED, DWORD, AXES, MICRO)),
    ("servo.servoposition_s", Cells(place::SERVO_MEASURED, DWORD, AXES, 1.0)),
    ("servo.servoposition_inc", Cells(place::SERVO_INCREMENTS, DWORD, AXES, 1.0)),
    ("servo.servoreqposition", Cells(place::SERVO_REQUESTED, DWORD, AXES, MICRO)),
    ("servo.servoreqposition_s", Cells(place::SERVO_REQUESTED, DWORD, AXES, 1.0)),
    ("spindle.spindle1output", one(place::OUTPUT_PROGRAMMED, CellType::Real)),
    ("spindle.spindle1prsoutput", one(place::OUTPUT_CORRECTED, CellType::Real)),
    ("spindle.reqspeedpm", Cells(place::REQUESTED_PM, DWORD, 1, TURNS)),
    ("spindle.reqspeedpt", Cells(place::REQUESTED_PT, DWORD, 1, ANGLE)),
    ("spindle.actspeedpm", Cells(place::ACTUAL_PM, DWORD, 1, TURNS)),
    ("spindle.actspeedpt", Cells(place::ACTUAL_PT, DWORD, 1, ANGLE)),
    ("spindle.actspeed2pm", Cells(place::ACTUAL_2_PM, DWORD, 1, TURNS)),
    ("spindle.actspeed2pt", Cells(place::ACTUAL_2_PT, DWORD, 1, ANGLE)),
    ("spindle.actavgspeedpm", Cells(place::AVERAGE_PM, DWORD, 1, TURNS)),
    ("spindle.actavgspeedpt", Cells(place::AVERAGE_PT, DWORD, 1, ANGLE)),
    ("spindle.actavgspeed2pm", Cells(place::AVERAGE_2_PM, DWORD, 1, TURNS)),
    ("spindle.actavgspeed2pt", Cells(place::AVERAGE_2_PT, DWORD, 1, ANGLE)),
    ("spindle.spindlegearact1", one(place::GEAR, WORD)),
    ("man.ackman", Bit(place::JOG_ACTIVE)),
    ("man.inposstop", Bit(place::AT_STOP_POINT)),
    ("man.manenable", Bit(place::JOG_ALLOWED)),
    ("man.mancontrolnc", Bit(place::JOG_FROM_PANEL)),
    ("man.mancontrolselect", Bit(place::JOG_SELECTING)),
    ("man.mancontrolrt", Bit(place::JOG_RAPID)),
    ("man.manmoveplus_ax", Six(place::JOG_PLUS)),
    ("man.manmoveminus_ax", Six(place::JOG_MINUS)),
    ("man.shift_ax", Mask(place::OFFSET_AXIS, SIX)),
    ("man.extmanmoveplus_ax", Six(place::EXTERNAL_PLUS)),
    ("man.extmanmoveminus_ax", Six(place::EXTERNAL_MINUS)),
    ("man.reqextmanrt", Bit(place::EXTERNAL_RAPID)),
    ("man.reqextmanselect", Bit(place::EXTERNAL_SELECT)),
    ("man.reqextman", Bit(place::EXTERNAL_JOG)),
    ("man.reqextfeedman", Bit(place::EXTERNAL_FEED_REQ)),
    ("man.extfeedman", one(place::EXTERNAL_FEED, WORD)),
    ("man.extfeedrtman", one(place::EXTERNAL_FEED_RAPID, WORD)),
    ("man.reqg95man", Bit(place::JOG_PER_REVOLUTION)),
    ("control.mpplc_ax", Axes(place::ENABLE)),
    ("control.inref_ax", Mask(place::HOMING, AXES)),
    ("control.mpman_ax", Axes(place::ENABLE_MANUAL)),
    ("control.mp_ax", Six(place::ENABLED)),
    ("control.move_ax", Axes(place::REQUESTED)),
    ("control.direct_ax", Axes(place::NEGATIVE)),
    ("control.coupling_s", Axes(place::LOOP_CLOSED)),
    ("control.homing_ax", Axes(place::ORIENTING)),
    ("control.startdisable", Bit(system::START_DISABLE)),
    ("control.blockinprogress", Bit(system::PO_F)),
    ("control.posreached", Bit(system::PO_POL)),
    ("control.stopack", Bit(system::PO_STOP)),
    ("control.inpos", Bit(system::INPOS)),
    ("control.extfeedovr", Bit(place::FEED_FROM_PROGRAM)),
    ("control.extspeedovr", Bit(place::SPEED_FROM_PROGRAM)),
    ("control.delay", Bit(system::PRODLEVA)),
    ("control.limplus_ax", Axes(place::LIMIT_PLUS)),
    ("control.limminus_ax", Axes(place::LIMIT_MINUS)),
    ("control.draglimplus_ax", Axes(place::SLOW_LIMIT_PLUS)),
    ("control.draglimminus_ax", Axes(place::SLOW_LIMIT_MINUS)),
    ("control.modeaut", Bit(system::AUTPI)),
    ("control.moderefer", Bit(system::REFPI)),
    ("control.modecanul", Bit(system::CAPI)),
    ("control.thread", Bit(system::G33PI)),
    ("control.rapidtraverse", Bit(system::G00PI)),
    ("control.swlimplus_ax", Mask(place::SOFT_LIMIT_PLUS, SIX)),
    ("control.swlimminus_ax", Mask(place::SOFT_LIMIT_MINUS, SIX)),
    ("control.swdragplus_ax", Mask(place::SOFT_SLOW_PLUS, SIX)),
    ("control.swdragminus_ax", Mask(place::SOFT_SLOW_MINUS, SIX)),
    ("control.swrefenable_ax", Mask(place::SLS_REFER, AXES)),
    ("control.homingpoint_ax", Axes(place::REFERENCE_SWITCH)),
    ("control.draghoming_ax", Axes(place::SLOW_DOWN_SWITCH)),
    ("control.homingrevers_ax", Axes(place::REVERSING_SWITCH)),
    ("control.m00", Bit(system::M00_PID)),
    ("control.m01", Bit(system::M01_PID)),
    ("control.m02", Bit(system::M02_PID)),
    ("control.m30", Bit(system::M30_PID)),
    ("control.m03", Bit(system::M03PI)),
    ("control.m04", Bit(system::M04PI)),
    ("control.m19", Bit(system::M19PI)),
    ("control.m41", Bit(system::M41PI)),
    ("control.m42", Bit(beside(system::M41PI, 1))),
    ("control.m43", Bit(beside(system::M41PI, 2))),
    ("control.m44", Bit(beside(system::M41PI, 3))),
    ("control.m07", Bit(system::M07PI)),
    ("control.m08", Bit(system::M08PI)),
    ("control.m50", Bit(system::M50PI)),
    ("control.m51", Bit(system::M51PI)),
    ("control.m10", Bit(system::M10PID)),
    ("control.m11", Bit(system::M11PID)),
    ("control.m06", Bit(system::M06PID)),
    ("control.m60", Bit(system::M60PI)),
    ("control.sf_run", Bit(system::SF_RUN)),
    ("control.sf_blockinprogr", Bit(system::SF_BLOCKINPROGR)),
    ("control.sf_blockfinished", Bit(system::SF_BLOCKFINISHED)),
    ("control.sf_stop", Bit(system::SF_STOP)),
    ("control.sf_notinpos", Bit(system::SF_NOTINPOS)),
    ("control.sf_delayinprogr", Bit(system::SF_DELAYINPROGR)),
    ("control.sf_condstopmode", Bit(system::SF_CONDSTOPMODE)),
    ("control.sf_ls", Bit(place::LIMIT_SWITCH)),
    ("control.sf_sls", Bit(place::SOFT_LIMIT)),
    ("control.sf_backward", Bit(system::SF_BACKWARD)),
    ("control.sf_stopposchanged", Bit(place::STOP_POINT_LEFT)),
    ("control.blockrestart", Bit(system::BLOCK_RESTART)),
    ("control.feedovrval", one(place::OVERRIDE_FEED, WORD)),
    ("control.feedovrmultiplier", one(place::FEED_MULTIPLIER, WORD)),
    ("control.speedovrval", one(place::OVERRIDE_SPEED, WORD)),
    ("control.speedovrmultiplier", one(place::SPEED_MULTIPLIER, WORD)),
    ("control.plcmembackup", Cells(data::PLC_MEM_BACKUP, BYTE, data::PLC_MEM_BACKUP_LEN, 1.0)),
];

/// The cell of an element by its normal identifier, without `rtm.`.
pub(super) fn find(name: &str) -> Option<Cell> {
    let (name, index) = without_index(name)?;
    let (_, place) = ELEMENTS.iter().find(|(known, _)| *known == name)?;
    let nth = u32::try_from(index).ok()?;
    let bit = |bit: BitRef| Cell { addr: bit.addr, kind: CellType::Bit(bit.bit), scale: 1.0 };
    let axis = |count: u32| u8::try_from(nth).ok().filter(|_| nth < count);
    match *place {
        Bit(place) => (nth == 0).then(|| bit(place)),
        Axes(family) => axis(AXES).map(|axis| bit(family.of(axis))),
        Six(family) => axis(SIX).map(|axis| bit(family.of(axis))),
        Mask(first, count) => {
            axis(count).map(|axis| bit(BitRef { addr: first + nth / 8, bit: axis % 8, indexed: false }))
        }
        Cells(first, kind, count, scale) => {
            (nth < count).then(|| Cell { addr: first + nth * kind.size(0) as Addr, kind, scale })
        }
    }
}

/// The identifier without its one index, and that; 0 without one.
fn without_index(name: &str) -> Option<(alloc::string::String, usize)> {
    let Some((before, rest)) = name.split_once('[') else { return Some((name.into(), 0)) };
    let (digits, behind) = rest.split_once(']')?;
    Some((alloc::format!("{before}{behind}"), digits.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_stands_behind_the_group_or_behind_the_name() {
        let bit = |place: BitRef| Some(Cell { addr: place.addr, kind: CellType::Bit(place.bit), scale: 1.0 });
        for (name, cell) in [
            ("control.m44", bit(beside(system::M41PI, 3))),
            ("control.move_ax", bit(place::REQUESTED.of(0))),
            ("control.move_ax[15]", bit(place::REQUESTED.of(15))),
            ("control.move_ax[16]", None),
            ("control.mp_ax[6]", None),
            ("control.inref_ax[9]", bit(BitRef { addr: place::HOMING + 1, bit: 1, indexed: false })),
            ("control.m44[1]", None),
            ("axis[2].pos1_ax", Some(Cell { addr: place::POSITION_POS1 + 16, kind: QWORD, scale: FRACTION })),
            ("axis[2", None),
            ("control.nothing", None),
        ] {
            assert_eq!(find(name), cell, "{name}");
        }
    }
}
