//! A spindle: gears, output values, speeds (manual 8.1.2, 8.1.3, 8.1.20 and 12.5 to 12.9).

use alloc::format;
use alloc::vec::Vec;

use technol_image::op::BitRef;
use technol_image::system::{self, motion as place};
use technol_runtime::BlockSpindle;

use super::cells::Cells;
use super::config;
use super::output::FULL;
use super::units::{TICK, rounded, rounded_dword};
use crate::compile::Compiler;

/// Thousandths of a degree in a millisecond at one thousandth of a rev/min.
const PER_TICK: f64 = 0.006;
/// Share of the difference that the filtered speed makes up in a tick (this implementation).
const FILTER: f64 = 0.02;
/// Speed of the spindle that no description tells of, in rev/min.
const USUAL_SPEED: u32 = 3000;
/// Gears of a spindle.
const MOST_GEARS: usize = 32;
/// Gears that M41 to M44 select.
const M_GEARS: usize = 4;
/// Their group of M functions.
const GEAR_GROUP: u8 = 3;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gear {
    /// rev/min.
    pub(crate) max_speed: f64,
    pub(crate) max_output: f64,
}

/// The value of a constant cutting speed, and the greatest one that an override may make of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cut {
    pub(crate) value: f64,
    pub(crate) most: f64,
}

/// One spindle.
#[derive(Clone, Debug)]
pub(crate) struct Spindle {
    gears: Vec<Gear>,
    /// rev/min.
    speed_limit: f64,
    /// rev/min in a tick.
    change: f64,
    /// Indices of the output and of the axis.
    pub(crate) port: Option<usize>,
    pub(crate) axis: Option<usize>,
    encoder: bool,
    /// Index of the axis that a constant cutting speed looks at.
    pub(crate) cutting_axis: usize,
    /// rev/min with sign.
    pub(crate) actual: f64,
    average: f64,
}

/// What is wrong with one spindle.
pub(crate) fn check(spindle: &config::Spindle, earlier: &[config::Spindle], compiler: &mut Compiler<'_>) {
    if !(1..=2).contains(&spindle.number) {
        compiler.error("number", "must be 1 or 2");
    } else if earlier.iter().any(|other| other.number == spindle.number) {
        compiler.error("number", format!("spindle {} is described twice", spindle.number));
    }
    if spindle.gear.is_empty() || spindle.gear.len() > MOST_GEARS {
        compiler.error("gear", "needs 1 to 32 gears, each with `max-speed`");
    }
    if spindle.gear.iter().any(|gear| gear.max_speed == 0 || !(1..=0x7FFF).contains(&gear.max_output)) {
        compiler.error("gear", "`max-speed` must be at least 1 and `max-output` 1 to 32767");
    }
    compiler.at_least("acceleration", spindle.acceleration, 1);
    let numbers =
        [("port", spindle.port), ("axis", spindle.axis), ("cutting-axis", Some(spindle.cutting_axis))];
    for (key, number) in numbers {
        if number.is_some_and(|number| !(1..=16).contains(&number)) {
            compiler.error(key, "must be 1 to 16");
        }
    }
    if spindle.port.is_some() && spindle.axis.is_some() {
        compiler
            .error("port", "cannot be combined with `axis`; a rotary axis has the output of its own number");
    }
}

impl Spindle {
    pub(crate) fn new(config: &config::Spindle) -> Spindle {
        let of = |gear: &config::Gear| Gear {
            max_speed: f64::from(gear.max_speed),
            max_output: f64::from(gear.max_output.max(1)),
        };
        let mut gears: Vec<Gear> = config.gear.iter().map(of).collect();
        if gears.is_empty() {
            gears.push(Gear { max_speed: f64::from(USUAL_SPEED), max_output: f64::from(FULL) });
        }
        let highest = gears.iter().fold(0.0, |highest: f64, gear| highest.max(gear.max_speed));
        let limit = f64::from(config.speed_limit);
        Spindle {
            gears,
            speed_limit: if limit > 0.0 { limit } else { highest },
            change: f64::from(config.acceleration) * TICK,
            port: config.port.map(|number| usize::from(number.saturating_sub(1))),
            axis: config.axis.map(|number| usize::from(number.saturating_sub(1))),
            encoder: config.encoder,
            cutting_axis: usize::from(config.cutting_axis.saturating_sub(1)),
            actual: 0.0,
            average: 0.0,
        }
    }

    /// It has these gears from now on, where they can be.
    pub(crate) fn set_gears(&mut self, gears: &[config::Gear], limit: u32) {
        let fits = |gear: &&config::Gear| gear.max_speed > 0 && (1..=0x7FFF).contains(&gear.max_output);
        let usual = config::Spindle::default();
        let fitting: Vec<config::Gear> = gears.iter().filter(fits).take(MOST_GEARS).cloned().collect();
        let own = Spindle::new(&config::Spindle { gear: fitting, speed_limit: limit, ..usual });
        (self.gears, self.speed_limit) = (own.gears, own.speed_limit);
    }

    /// It stands, as at power-on.
    pub(crate) fn reset(&mut self) {
        (self.actual, self.average) = (0.0, 0.0);
    }

    /// With M40 in force the lowest gear that reaches the speed is chosen, when the block programs either of them; a
    /// programmed speed becomes PB11 and PB12.
    pub(crate) fn program(&self, cells: &mut Cells<'_>, block: &BlockSpindle) {
        let limited = |speed: f64| speed.clamp(0.0, self.speed_limit);
        let says = block.programmed.is_some() || block.gear_programmed;
        if block.automatic_gear && says && block.speed > 0.0 {
            self.choose_gear(cells, limited(block.speed));
        }
        // The gears of this block count, whichever chose them.
        follow_m_gears(cells);
        let Some(speed) = block.programmed else { return };
        let gear = self.gear(cells, true);
        let output = (limited(speed) / gear.max_speed * gear.max_output).min(gear.max_output);
        cells.set_word(system::PB00 + 11, rounded(output) as u16);
        cells.set_bit(system::ZMSSPI, true);
    }

    /// The lowest gear that reaches the speed, else the highest; a change is told as one of M41 to M44.
    fn choose_gear(&self, cells: &mut Cells<'_>, speed: f64) {
        let usable = &self.gears[..self.gears.len().min(M_GEARS)];
        let chosen = usable.iter().position(|gear| gear.max_speed >= speed).unwrap_or(usable.len() - 1);
        let first = system::M41PI;
        let before = cells.byte(first.addr);
        let now = before & !(0b1111 << first.bit) | 1 << (usize::from(first.bit) + chosen);
        if now != before {
            cells.set_byte(first.addr, now);
            cells.set_bit(BitRef { bit: system::ZMM1PI.bit + GEAR_GROUP - 1, ..system::ZMM1PI }, true);
        }
    }

    /// One tick; `value` is that of its output. `first`: spindle 1, which has the cells of the programmed speed.
    pub(crate) fn tick(
        &mut self,
        cells: &mut Cells<'_>,
        first: bool,
        value: i16,
        percent: u8,
        cutting: Option<Cut>,
    ) {
        if first {
            follow_m_gears(cells);
            self.tell_programmed(cells, percent, cutting);
        }
        let gear = self.gear(cells, first);
        let wanted = f64::from(value) / gear.max_output * gear.max_speed;
        self.actual += (wanted - self.actual).clamp(-self.change, self.change);
        let speed = if self.encoder {
            self.actual.abs() * 1000.0
        } else {
            f64::from(cells.dword(place::SIMULATED_PT)) / PER_TICK
        };
        self.average += (speed - self.average) * FILTER;
        if (speed - self.average).abs() < 1.0 {
            self.average = speed;
        }
        let (actual, average) = if first {
            ([place::ACTUAL_PM, place::ACTUAL_PT], [place::AVERAGE_PM, place::AVERAGE_PT])
        } else {
            ([place::ACTUAL_2_PM, place::ACTUAL_2_PT], [place::AVERAGE_2_PM, place::AVERAGE_2_PT])
        };
        for ([per_minute, per_tick], speed) in [(actual, speed), (average, self.average)] {
            cells.set_dword(per_minute, rounded_dword(speed));
            cells.set_dword(per_tick, rounded_dword(speed * PER_TICK));
        }
    }

    /// The override reaches the spindle except while a thread is cut.
    fn tell_programmed(&self, cells: &mut Cells<'_>, percent: u8, cutting: Option<Cut>) {
        let gear = self.gear(cells, true);
        let programmed = f64::from(cells.word(system::PB00 + 11));
        let base = if cells.bit(place::SPEED_FROM_PROGRAM) {
            f64::from(cells.word(place::OVERRIDE_SPEED)) / 1000.0
        } else {
            f64::from(percent) / 100.0
        };
        let factor = base * f64::from(cells.word(place::SPEED_MULTIPLIER)) / 1000.0;
        let factor = if cells.bit(system::G33PI) { 1.0 } else { factor };
        let (wanted, most) = cutting.map_or((programmed, gear.max_output), |cut| (cut.value, cut.most));
        let corrected = (wanted * factor).min(most.min(gear.max_output));
        let whole = rounded(corrected);
        cells.set_word(place::SPINDLE_VOLTAGE, whole as u16);
        let speed = whole as f64 / gear.max_output * gear.max_speed * 1000.0;
        cells.set_dword(place::REQUESTED_PM, rounded_dword(speed));
        cells.set_dword(place::REQUESTED_PT, rounded_dword(speed * PER_TICK));
        cells.set_real(place::OUTPUT_PROGRAMMED, programmed / f64::from(FULL));
        cells.set_real(place::OUTPUT_CORRECTED, corrected / f64::from(FULL));
    }

    /// The gear in force; only spindle 1 has a cell for it, others are in their first.
    pub(crate) fn gear(&self, cells: &Cells<'_>, first: bool) -> Gear {
        let number = if first { usize::from(cells.word(place::GEAR)) } else { 1 };
        self.gears[number.clamp(1, self.gears.len()) - 1]
    }
}

/// The control writes the gear of M41 to M44, unless the program has taken that over.
fn follow_m_gears(cells: &mut Cells<'_>) {
    if cells.bit(place::GEAR_FROM_PROGRAM) && cells.bit(place::GEAR_BY_HAND) {
        return;
    }
    let gears = cells.byte(system::M41PI.addr) >> system::M41PI.bit & 0b1111;
    if gears != 0 {
        cells.set_word(place::GEAR, gears.trailing_zeros() as u16 + 1);
    }
}
