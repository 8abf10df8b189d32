//! Stations that pass by while a motor runs.

use alloc::format;
use alloc::vec::Vec;

use crate::compile::Compiler;
use crate::config;
use crate::drive::{Drive, World};
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
pub(crate) struct Turret {
    motor: Drive,
    reverse: Option<Drive>,
    code: Vec<InputBit>,
    strobe: Option<InputBit>,
    station_ms: u32,
    strobe_ms: u32,
    /// Milliseconds of a whole turn.
    turn: u64,
    initially: u64,
    /// Station `position / station_ms + 1` was passed last.
    position: u64,
}

impl Turret {
    pub(crate) fn compile(config: &config::Turret, compiler: &mut Compiler<'_>) -> Turret {
        let motor = compiler.drive("motor", &config.motor);
        let reverse = config.motor_reverse.as_ref().map(|names| compiler.drive("motor-reverse", names));
        let code: Vec<_> = config.code.iter().filter_map(|name| compiler.driven("code", name)).collect();
        let strobe = config.strobe.as_ref().and_then(|name| compiler.driven("strobe", name));
        if !(2..=99).contains(&config.stations) {
            compiler.error("stations", "must be 2 to 99");
        }
        if config.code.len() > 8 {
            compiler.error("code", "has more than 8 bits; two BCD digits are all there is");
        } else if !config.code.is_empty() && usize::from(highest_bit(config.stations)) > config.code.len() {
            let need = highest_bit(config.stations);
            compiler.error("code", format!("needs {need} bits for {} stations in BCD", config.stations));
        }
        if config.code.is_empty() && config.strobe.is_none() {
            compiler.error("", "needs `code` or `strobe`, else nothing can be seen of it");
        }
        if config.initially == 0 || config.initially > config.stations {
            compiler.error("initially", format!("must be 1 to {}", config.stations));
        }
        compiler.at_least("station-ms", config.station_ms, 2);
        let strobe_ms = config.strobe_ms.unwrap_or((config.station_ms / 4).max(1));
        if strobe_ms == 0 || strobe_ms >= config.station_ms.max(2) {
            compiler.error("strobe-ms", "must be at least 1 and less than `station-ms`");
        }
        let initially = u64::from(config.initially.saturating_sub(1)) * u64::from(config.station_ms);
        Turret {
            motor,
            reverse,
            code,
            strobe,
            station_ms: config.station_ms,
            strobe_ms,
            turn: u64::from(config.stations) * u64::from(config.station_ms),
            initially,
            position: initially,
        }
    }

    pub(crate) fn reset(&mut self) {
        self.position = self.initially;
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        let forward = self.motor.is_on(world.outputs);
        let backward = self.reverse.as_ref().is_some_and(|bit| bit.is_on(world.outputs));
        if moves && forward && !backward {
            self.position = (self.position + 1) % self.turn;
        } else if moves && backward && !forward {
            self.position = (self.position + self.turn - 1) % self.turn;
        }
        let station_ms = u64::from(self.station_ms);
        let code = bcd((self.position / station_ms) as u8 + 1);
        for (n, bit) in self.code.iter().enumerate() {
            bit.set(inputs, code >> n & 1 != 0);
        }
        if let Some(bit) = self.strobe {
            bit.set(inputs, self.position % station_ms < u64::from(self.strobe_ms));
        }
    }
}

/// Two BCD digits of a number below 100.
fn bcd(number: u8) -> u8 {
    ((number / 10) << 4) | (number % 10)
}

/// Bits needed to show every station up to `stations` in BCD.
fn highest_bit(stations: u8) -> u8 {
    let tens = (stations.min(99) / 10).checked_ilog2().map_or(0, |n| n as u8 + 1);
    if tens > 0 { 4 + tens } else { stations.checked_ilog2().map_or(0, |n| n as u8 + 1) }
}
