//! A driven axis without a position loop, with switches along its way.

use alloc::vec::Vec;

use crate::compile::Compiler;
use crate::config;
use crate::drive::{Drive, World};
use crate::motion::Thousandths;
use crate::signal::{InputBit, InputImage};

#[derive(Clone, Debug)]
struct Switch {
    from: i64,
    to: i64,
    input: InputBit,
    invert: bool,
}

/// Positions are millionths of a millimetre: a thousandth of a millimetre per second is one per millisecond.
#[derive(Clone, Debug)]
pub(crate) struct Slide {
    forward: Drive,
    backward: Drive,
    rapid: Option<Drive>,
    speed: i64,
    rapid_speed: i64,
    stroke: i64,
    initially: i64,
    now: i64,
    switches: Vec<Switch>,
    position: Vec<u8>,
}

/// Of a thousandth of a millimetre.
const UNIT: i64 = 1000;
/// What `position` counts: hundredths of a millimetre.
const SHOWN: i64 = 10 * UNIT;

impl Slide {
    pub(crate) fn compile(config: &config::Slide, compiler: &mut Compiler<'_>) -> Slide {
        let forward = compiler.drive("forward", &config.forward);
        let backward = compiler.drive("backward", &config.backward);
        let rapid = config.rapid.as_ref().map(|names| compiler.drive("rapid", names));
        if config.rapid.is_some() != config.rapid_mm_s.is_some() {
            compiler.error("rapid-mm-s", "`rapid` and `rapid-mm-s` belong together");
        }
        let above_zero = [
            ("speed-mm-s", config.speed_mm_s),
            ("rapid-mm-s", config.rapid_mm_s.unwrap_or(Thousandths(1))),
            ("stroke-mm", config.stroke_mm),
        ];
        for (key, value) in above_zero {
            if value.0 <= 0 {
                compiler.error(key, "must be above 0");
            }
        }
        let on_the_way = Thousandths(0)..=config.stroke_mm;
        if !on_the_way.contains(&config.initially_mm) {
            compiler.error("initially-mm", "must lie on the way, from 0 to `stroke-mm`");
        }
        let mut switches = Vec::new();
        for switch in &config.switches {
            if !on_the_way.contains(&switch.at) || switch.width.0 < 0 {
                compiler.error(
                    "switches",
                    "`at` must lie on the way, from 0 to `stroke-mm`, `width` not be negative",
                );
            }
            let input = compiler.driven("switches", &switch.input);
            let (from, to) = (switch.at.0 * UNIT, (switch.at.0 + switch.width.0) * UNIT);
            switches.extend(input.map(|input| Switch { from, to, input, invert: switch.invert }));
        }
        let highest = (config.stroke_mm.0 * UNIT / SHOWN).unsigned_abs();
        let position = compiler.driven_ports("position", &config.position, 4, highest);
        if config.switches.is_empty() && config.position.is_empty() {
            compiler.error("", "needs `switches` or `position`, else nothing can be seen of it");
        }
        let now = config.initially_mm.0 * UNIT;
        Slide {
            forward,
            backward,
            rapid,
            speed: config.speed_mm_s.0,
            rapid_speed: config.rapid_mm_s.unwrap_or_default().0,
            stroke: config.stroke_mm.0 * UNIT,
            initially: now,
            now,
            switches,
            position,
        }
    }

    pub(crate) fn reset(&mut self) {
        self.now = self.initially;
    }

    pub(crate) fn step(&mut self, world: World<'_>, moves: bool, inputs: &mut InputImage) {
        let forward = self.forward.is_on(world.outputs);
        // Driven both ways at once it stands still.
        if moves && forward != self.backward.is_on(world.outputs) {
            let rapid = self.rapid.as_ref().is_some_and(|rapid| rapid.is_on(world.outputs));
            let speed = if rapid { self.rapid_speed } else { self.speed };
            self.now = (self.now + if forward { speed } else { -speed }).clamp(0, self.stroke);
        }
        for switch in &self.switches {
            let on = (switch.from..=switch.to).contains(&self.now);
            switch.input.set(inputs, on != switch.invert);
        }
        for (port, byte) in self.position.iter().zip((self.now / SHOWN).to_le_bytes()) {
            inputs[usize::from(*port)] = byte;
        }
    }
}
