//! A control on the bench: memory of a PLC and the axes behind it.

use technol_image::op::{Addr, BitRef};
use technol_image::system::{self, motion as place};
use technol_machine::motion::{BlockMove, PosControl, PosMode, Refused};
use technol_machine::{Cells, INPUT_PORTS, MachineConfig, Motion, OUTPUT_PORTS, Plant, Signal};

/// Cells of the program.
pub(crate) const CONTROL: Addr = system::LEN;
pub(crate) const STATUS: Addr = system::LEN + 2;

pub(crate) struct Bench {
    pub(crate) memory: Vec<u8>,
    pub(crate) motion: Motion,
    plant: Plant,
    pub(crate) inputs: [u8; INPUT_PORTS],
    /// Inputs that the program copies into bits of the interface, once a cycle.
    wires: Vec<(usize, u8, BitRef)>,
    millis: u32,
}

/// A bit of a cell.
pub(crate) fn bit(addr: Addr, bit: u8) -> BitRef {
    BitRef { addr, bit, indexed: false }
}

impl Bench {
    /// A control with this machine; its memory is as at power-on.
    pub(crate) fn new(toml: &str) -> Bench {
        let config: MachineConfig = toml::from_str(toml).unwrap();
        let plant = Plant::compile(&config, &|name| name.parse().ok()).unwrap();
        let mut bench = Bench {
            memory: vec![0; system::LEN as usize + 64],
            motion: Motion::new(&config),
            plant,
            inputs: [0; INPUT_PORTS],
            wires: Vec::new(),
            millis: 0,
        };
        let mut cells = Cells::new(&mut bench.memory);
        cells.set_axes(place::ENABLE, 0xFFFF);
        cells.set_axes(place::LOOP_CLOSED, 0xFFFF);
        cells.set_word(place::FEED_MULTIPLIER, 1000);
        cells.set_word(place::SPEED_MULTIPLIER, 1000);
        cells.set_bit(place::JOG_ALLOWED, true);
        bench
    }

    pub(crate) fn cells(&mut self) -> Cells<'_> {
        Cells::new(&mut self.memory)
    }

    pub(crate) fn is(&mut self, place: BitRef) -> bool {
        self.cells().bit(place)
    }

    pub(crate) fn set(&mut self, place: BitRef, value: bool) {
        self.cells().set_bit(place, value);
    }

    pub(crate) fn tick(&mut self) {
        let mut cells = Cells::new(&mut self.memory);
        if self.millis.is_multiple_of(20) {
            for &(port, bit, place) in &self.wires {
                cells.set_bit(place, self.inputs[port] >> bit & 1 != 0);
            }
        }
        self.motion.tick_ms(&mut cells);
        self.plant.place_axes(&self.motion);
        self.plant.step(&[0; OUTPUT_PORTS], &mut self.inputs);
        self.millis += 1;
    }

    /// The program copies an input into a bit.
    pub(crate) fn wire(mut self, input: &str, place: BitRef) -> Bench {
        let Ok(Signal::Input { port, bit }) = input.parse() else { panic!("{input}") };
        self.wires.push((usize::from(port), bit, place));
        self
    }

    pub(crate) fn run(&mut self, millis: u32) {
        for _ in 0..millis {
            self.tick();
        }
    }

    /// A block without preparatory functions.
    pub(crate) fn begin(&mut self, block: &BlockMove) -> Result<(), Refused> {
        self.motion.begin_block(&mut Cells::new(&mut self.memory), block)?;
        self.motion.release_block();
        Ok(())
    }

    pub(crate) fn init(&mut self, axis: u8) -> Result<(), Refused> {
        self.motion.pos_init(&mut Cells::new(&mut self.memory), axis, 5)
    }

    pub(crate) fn reset(&mut self, axis: u8) {
        self.motion.pos_reset(&mut Cells::new(&mut self.memory), axis).unwrap();
    }

    pub(crate) fn mode(&mut self, axis: u8, length: i32, accel: u16, approach: u16) -> Result<(), Refused> {
        let mode = PosMode { control: CONTROL, length, accel, approach };
        self.motion.pos_mode(&mut Cells::new(&mut self.memory), axis, mode)
    }

    /// POS_CONTROL with a feed in mm/min.
    pub(crate) fn control(&mut self, axis: u8, feed: i32, mp: Option<bool>) {
        let control = PosControl { status: STATUS, feed: feed << 16, mp };
        self.motion.pos_control(&mut Cells::new(&mut self.memory), axis, control).unwrap();
    }

    /// Position of an axis in a space, µm.
    pub(crate) fn position(&mut self, axis: u8, space: u32) -> f64 {
        let nth = 8 * (Addr::from(axis) - 1);
        let at = if space == 0 { place::POSITION } else { place::POSITION_POS1 + 128 * (space - 1) };
        self.cells().qword(at + nth) as f64 / 65_536.0
    }

    /// Draws bits, a character for `step` milliseconds; `drive` is called before each millisecond.
    pub(crate) fn draw(
        &mut self,
        millis: u32,
        step: u32,
        watch: &[(&str, BitRef)],
        mut drive: impl FnMut(&mut Bench, u32),
    ) -> String {
        let width = watch.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        let mut lines: Vec<String> = watch.iter().map(|(name, _)| format!("{name:width$} ")).collect();
        for ms in 0..millis {
            drive(self, ms);
            self.tick();
            if ms % step == step - 1 {
                for ((_, place), line) in watch.iter().zip(&mut lines) {
                    line.push(if self.is(*place) { '#' } else { '_' });
                }
            }
        }
        lines.join("\n")
    }
}
