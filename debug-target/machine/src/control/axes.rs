//! Axes, positioning units, spindles and analogue outputs at the request of the program (manual 12, 13.1 and 19).

use technol_image::service::Service;
use technol_runtime::{AxesOfBlock, BlockMotion, Call, FaultKind};

use crate::motion::{Analog, BlockMove, Cells, Motion, PosControl, PosMode, Refused, Role, SpiAx};

/// The space of POS_INIT when it names none.
const USUAL_SPACE: u8 = 5;

/// Carries out an instruction of this family; `false` when it is none. RLO and DR stay, except that RAMP leaves its value
/// in DR. What the control refuses the program finds in its status record, or sees that nothing happens.
pub(super) fn service(motion: &mut Motion, call: &mut Call<'_>) -> Result<bool, FaultKind> {
    use Service as S;
    let _: Result<(), Refused> = match call.service() {
        S::PosInit | S::PosInitX | S::PosInitY | S::PosInitZ | S::PosInit4 | S::PosInit5 | S::PosInit6 => {
            let axis = axis(call, 0)?;
            let space = match older(call.service()) {
                None => byte(call, 1)?.unwrap_or(USUAL_SPACE),
                Some(_) => USUAL_SPACE,
            };
            motion.pos_init(&mut Cells::new(call.memory_mut()), axis, space)
        }
        S::PosReset
        | S::PosResetX
        | S::PosResetY
        | S::PosResetZ
        | S::PosReset4
        | S::PosReset5
        | S::PosReset6 => {
            let axis = axis(call, 0)?;
            motion.pos_reset(&mut Cells::new(call.memory_mut()), axis)
        }
        S::PosMode | S::PosModeX | S::PosModeY | S::PosModeZ | S::PosMode4 | S::PosMode5 | S::PosMode6 => {
            let axis = axis(call, 3)?;
            let approach = if older(call.service()).is_some() { call.integer(3)? } else { None };
            let mode = PosMode {
                control: call.area(0)?.map_or(0, |(addr, _)| addr),
                length: call.integer(1)?.unwrap_or(0) as i32,
                accel: call.integer(2)?.unwrap_or(0) as u16,
                approach: approach.unwrap_or(0) as u16,
            };
            motion.pos_mode(&mut Cells::new(call.memory_mut()), axis, mode)
        }
        S::PosControl
        | S::PosControlX
        | S::PosControlY
        | S::PosControlZ
        | S::PosControl4
        | S::PosControl5
        | S::PosControl6 => {
            let axis = axis(call, 3)?;
            let control = PosControl {
                status: call.area(0)?.map_or(0, |(addr, _)| addr),
                feed: call.integer(1)?.unwrap_or(0) as i32,
                mp: call.integer(2)?.map(|bit| bit != 0),
            };
            motion.pos_control(&mut Cells::new(call.memory_mut()), axis, control)
        }
        S::RegulX | S::RegulY | S::RegulZ | S::Regul4 | S::Regul5 | S::Regul6 => {
            let axis = axis(call, 1)?;
            motion.regul(axis, byte(call, 0)?.unwrap_or(0))
        }
        S::AnalogPort => motion.analog_port(byte(call, 0)?.unwrap_or(0)),
        S::Analog => analog(motion, call)?,
        S::AnalogSpi => motion.analog_spi(output(call, 0)?, axis(call, 1)?),
        S::AxSpi => {
            let (axis, role) = (axis(call, 0)?, role(call)?);
            motion.ax_spi(&mut Cells::new(call.memory_mut()), axis, role)
        }
        S::SpiMain => motion.spi_main(axis(call, 0)?),
        S::SpiAx => {
            let operands = SpiAx {
                feed1: call.integer(0)?.map(|feed| feed as i16),
                feed2: call.integer(1)?.map(|feed| feed as i16),
                angle: call.integer(2)?.map(|angle| angle as i32),
                accel: call.integer(3)?.map(|accel| accel as u16),
                axis: byte(call, 4)?,
            };
            motion.spi_ax(&mut Cells::new(call.memory_mut()), operands)
        }
        S::Ramp => {
            ramp(call)?;
            Ok(())
        }
        _ => return Ok(false),
    };
    Ok(true)
}

/// A block of the part program asks for the axes it moves.
pub(super) fn take(motion: &mut Motion, block: &BlockMotion<'_>, memory: &mut [u8]) -> AxesOfBlock {
    let mut way = BlockMove {
        feed: block.feed,
        per_revolution: block.per_revolution,
        rapid: block.rapid,
        ..BlockMove::default()
    };
    for ((number, target), travel) in (1..).zip(block.targets).zip(&mut way.travel) {
        *travel = target.map_or(0.0, |target| motion.way_to(number, target));
    }
    match motion.begin_block(&mut Cells::new(memory), &way) {
        Ok(()) => AxesOfBlock::Taken,
        Err(_) => AxesOfBlock::Busy,
    }
}

/// The axis that an older instruction has in its name.
fn older(service: Service) -> Option<u8> {
    use Service as S;
    Some(match service {
        S::PosInitX | S::PosResetX | S::PosModeX | S::PosControlX | S::RegulX => 1,
        S::PosInitY | S::PosResetY | S::PosModeY | S::PosControlY | S::RegulY => 2,
        S::PosInitZ | S::PosResetZ | S::PosModeZ | S::PosControlZ | S::RegulZ => 3,
        S::PosInit4 | S::PosReset4 | S::PosMode4 | S::PosControl4 | S::Regul4 => 4,
        S::PosInit5 | S::PosReset5 | S::PosMode5 | S::PosControl5 | S::Regul5 => 5,
        S::PosInit6 | S::PosReset6 | S::PosMode6 | S::PosControl6 | S::Regul6 => 6,
        _ => return None,
    })
}

/// The axis in the name, or else at operand `n`; 0, which is no axis, when it is neither.
fn axis(call: &Call<'_>, n: usize) -> Result<u8, FaultKind> {
    match older(call.service()) {
        Some(axis) => Ok(axis),
        None => Ok(byte(call, n)?.unwrap_or(0)),
    }
}

/// A small number; one that does not fit is 255, which names nothing.
fn byte(call: &Call<'_>, n: usize) -> Result<Option<u8>, FaultKind> {
    Ok(call.integer(n)?.map(|value| u8::try_from(value).unwrap_or(u8::MAX)))
}

/// A value for an output: an operand of 16 bits, or DR16.
fn output(call: &Call<'_>, n: usize) -> Result<i32, FaultKind> {
    Ok(i32::from(call.integer(n)?.unwrap_or(call.dr()) as i16))
}

fn analog(motion: &mut Motion, call: &Call<'_>) -> Result<Result<(), Refused>, FaultKind> {
    let value = output(call, 0)?;
    let to = match (byte(call, 2)?, call.is_given(1)) {
        (Some(1), _) => Analog::Main,
        (Some(2), _) => Analog::Assist,
        // A letter only helps the reader.
        (_, true) => Analog::Axis(byte(call, 1)?),
        (_, false) => Analog::Port,
    };
    Ok(motion.analog(value, to))
}

fn role(call: &Call<'_>) -> Result<Option<Role>, FaultKind> {
    let number = match call.keyword(1) {
        Some("OFF") => Some(0),
        Some("MAIN") => Some(1),
        Some("ASSIST") => Some(2),
        Some(_) => Some(3),
        None => call.integer(1)?,
    };
    Ok(number.map(|number| match number {
        0 => Role::Off,
        1 => Role::Main,
        2 => Role::Assist,
        _ => Role::Set,
    }))
}

/// RAMP: the cell follows DR by at most the given step.
fn ramp(call: &mut Call<'_>) -> Result<(), FaultKind> {
    let (Some(value), Some(step)) = (call.integer(0)?, call.integer(1)?) else { return Ok(()) };
    let step = step.saturating_abs();
    let way = call.dr().saturating_sub(value).clamp(-step, step);
    call.store(0, value.saturating_add(way))?;
    let value = call.integer(0)?.unwrap_or(value);
    call.set_dr(value);
    Ok(())
}
