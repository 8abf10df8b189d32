//! Spindles: output values, gears, speeds, and who drives which output.

use technol_image::system::{self, motion as place};
use technol_machine::Cells;
use technol_machine::motion::{Analog, BlockMove, Refused, Role, SpiAx};
use technol_runtime::BlockSpindle;

use crate::support::{Bench, bit};

const LATHE: &str = "[[spindle]]\nnumber=1\nport=5\nacceleration=2000\n\
                     gear=[{max-speed=400,max-output=26869},{max-speed=800,max-output=26869},{max-speed=2400}]\n";

fn near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value}, not {expected}");
}

fn program(bench: &mut Bench, speed: u32, automatic_gear: bool) {
    let speed = f64::from(speed);
    let block = BlockSpindle { programmed: Some(speed), speed, automatic_gear, ..BlockSpindle::default() };
    bench.motion.program_spindle(&mut Cells::new(&mut bench.memory), &block);
}

/// M41 to M44 by number, and nothing else in the group.
fn gear(bench: &mut Bench, number: u8) {
    let at = system::M41PI;
    let others = bench.cells().byte(at.addr) & !(0b1111 << at.bit);
    bench.cells().set_byte(at.addr, others | 1 << (at.bit + number - 1));
}

#[test]
fn the_output_is_the_share_of_the_greatest_speed_of_the_gear() {
    let mut bench = Bench::new(LATHE);
    gear(&mut bench, 2);
    bench.tick();
    program(&mut bench, 630, false);
    bench.tick();
    assert_eq!(bench.cells().word(system::PB00 + 11), 0x52A7, "630 of 800 rev/min at 8.2 V");
    assert_eq!((bench.cells().byte(system::PB00 + 11), bench.cells().byte(system::PB00 + 12)), (0xA7, 0x52));
    assert_eq!(bench.cells().word(place::SPINDLE_VOLTAGE), 0x52A7);
    assert_eq!(bench.cells().word(place::GEAR), 2);
    let speed = bench.cells().dword(place::REQUESTED_PM);
    assert!((speed - 630_000).abs() < 20, "{speed}");
    assert_eq!(bench.cells().dword(place::REQUESTED_PT), 3780);
}

#[test]
fn the_override_reaches_everything_but_the_programmed_value() {
    let mut bench = Bench::new(LATHE);
    gear(&mut bench, 3);
    bench.tick();
    program(&mut bench, 1200, false);
    bench.motion.set_overrides(100, 50);
    bench.tick();
    let words =
        |bench: &mut Bench| [system::PB00 + 11, place::SPINDLE_VOLTAGE].map(|at| bench.cells().word(at));
    assert_eq!(words(&mut bench), [16_384, 8192]);
    bench.cells().set_word(place::SPEED_MULTIPLIER, 500);
    bench.tick();
    assert_eq!(words(&mut bench)[1], 4096);
    bench.set(place::SPEED_FROM_PROGRAM, true);
    bench.cells().set_word(place::OVERRIDE_SPEED, 3000);
    bench.tick();
    assert_eq!(words(&mut bench)[1], 24_576);
    bench.set(system::G33PI, true);
    bench.tick();
    assert_eq!(words(&mut bench)[1], 16_384, "not while a thread is cut");
}

#[test]
fn m40_chooses_the_lowest_gear_that_reaches_the_speed() {
    let mut bench = Bench::new(LATHE);
    for (speed, expected) in [(1, 1), (400, 1), (401, 2), (800, 2), (2000, 3), (9999, 3)] {
        program(&mut bench, speed, true);
        bench.tick();
        assert_eq!(bench.cells().word(place::GEAR), expected, "{speed}");
        let gears = bench.cells().byte(system::M41PI.addr) >> system::M41PI.bit & 0b1111;
        assert_eq!(gears, 1 << (expected - 1), "{speed}");
    }
    assert_eq!(bench.cells().word(system::PB00 + 11), 0x7FFF, "cut to the greatest speed");
}

/// M40, speed; gear bits and whether they changed, spindle value.
type GearRow = (Option<u8>, Option<f64>, u8, bool, u16);

#[test]
fn the_automatic_gear_follows_the_programmed_speed() {
    let mut bench = Bench::new(
        "[[spindle]]\nnumber=1\ngear=[{max-speed=100},{max-speed=400},{max-speed=800,max-output=26869}]",
    );
    let rows: [GearRow; 7] = [
        (Some(40), None, 0, false, 0), // no speed yet
        (None, Some(100.0), 1, true, 0x7FFF),
        (None, Some(50.0), 1, false, 0x4000),
        (None, Some(630.0), 4, true, 21_159),
        (None, Some(2000.0), 4, false, 26_869),
        (Some(42), Some(200.0), 2, false, 0x4000), // what the supervisor writes of M42 is a change of its own
        (None, Some(90.0), 2, false, 7373),        // M42 stays
    ];
    let (mut automatic_gear, mut speed) = (false, 0.0);
    let changed = bit(system::ZMM1PI.addr, 2);
    for (m, programmed, gears, changes, value) in rows {
        if let Some(m) = m {
            automatic_gear = m == 40;
            if m != 40 {
                gear(&mut bench, m - 40);
            }
        }
        speed = programmed.unwrap_or(speed);
        bench.set(changed, false);
        bench.set(system::ZMSSPI, false);
        let gear_programmed = m == Some(40);
        let block =
            BlockSpindle { programmed, speed, automatic_gear, gear_programmed, ..BlockSpindle::default() };
        bench.motion.program_spindle(&mut Cells::new(&mut bench.memory), &block);
        let row = format!("{m:?} {programmed:?}");
        assert_eq!(bench.cells().byte(system::M41PI.addr) >> system::M41PI.bit & 0xF, gears, "{row}");
        assert_eq!(bench.is(changed), changes, "{row}");
        assert_eq!(bench.cells().word(system::PB00 + 11), value, "{row}");
        assert_eq!(bench.is(system::ZMSSPI), programmed.is_some(), "{row}");
        bench.tick();
    }
}

#[test]
fn a_constant_cutting_speed_follows_the_axis() {
    let toml = "[[axis]]\nnumber=2\nacceleration=5000\n[[spindle]]\nnumber=1\ncutting-axis=2\ngear=[{max-speed=2000}]";
    let mut bench = Bench::new(toml);
    let act = |bench: &mut Bench| {
        [0, 1, 4, 5, 6, 7, 8].map(|nth| bench.cells().dword(place::CUTTING_SPEED_ACT + 4 * nth))
    };
    let word = |bench: &mut Bench| bench.cells().word(place::SPINDLE_VOLTAGE);
    bench.begin(&BlockMove::at_feed(&[(2, 25_000.0)], 12_000.0)).unwrap();
    bench.run(1000);
    let on = BlockSpindle { cutting_speed: Some(90_000.0), speed_limit: 1000.0, ..BlockSpindle::default() };
    bench.motion.program_spindle(&mut Cells::new(&mut bench.memory), &on);
    bench.tick();
    // 90 m/min at 25 mm is 572.958 rev/min, of 2000 rev/min at 32767.
    assert_eq!(act(&mut bench), [90_000, 1_000_000, 200_000, 2_000_000, 0x7FFF, 572_958, 9387]);
    assert_eq!(word(&mut bench), 9387);
    bench.motion.set_overrides(100, 50);
    bench.tick();
    assert_eq!((act(&mut bench)[6], word(&mut bench)), (9387, 4694), "the override comes behind it");
    bench.motion.set_overrides(100, 200);
    bench.tick();
    assert_eq!(word(&mut bench), 0x4000, "and leads no further than the limit");
    bench.motion.set_overrides(100, 100);
    // Towards the middle it turns faster, up to the limit: at 14.324 mm.
    bench.begin(&BlockMove::at_feed(&[(2, -20_000.0)], 6000.0)).unwrap();
    let mut before = 0;
    for _ in 0..400 {
        bench.tick();
        let [.., turns, _] = act(&mut bench);
        let radius = bench.position(2, 0) / 1000.0;
        let expected = (90_000.0 / (core::f64::consts::TAU * radius)).min(1000.0) * 1000.0;
        near(f64::from(turns), expected, 1.0 + expected * 1e-5);
        assert!(turns >= before);
        before = turns;
    }
    assert_eq!(before, 1_000_000);
    let off = BlockSpindle::default();
    bench.motion.program_spindle(&mut Cells::new(&mut bench.memory), &off);
    bench.tick();
    assert_eq!((act(&mut bench), word(&mut bench)), ([0; 7], 0), "the programmed value counts again");
}

#[test]
fn the_program_may_give_every_number_of_the_constant_cutting_speed() {
    let mut bench = Bench::new("[[spindle]]\nnumber=1\ngear=[{max-speed=2000}]");
    bench.set(place::CUTTING_REQ, true);
    let mut give = |bit, at, value| {
        bench.set(bit, true);
        bench.cells().set_dword(at, value);
        bench.tick();
        bench.cells().dword(place::CUTTING_SPEED_ACT + 28)
    };
    let speeds = [
        give(place::CUTTING_RADIUS_GIVEN, place::CUTTING_RADIUS, 20_000 * 8), // no speed yet
        give(place::CUTTING_SPEED_GIVEN, place::CUTTING_SPEED, 60_000),
        give(place::CUTTING_DISTANCE_GIVEN, place::CUTTING_DISTANCE, -10_000 * 8),
        give(place::CUTTING_CORRECTION_GIVEN, place::CUTTING_CORRECTION, -6000),
        give(place::CUTTING_LIMIT_GIVEN, place::CUTTING_LIMIT, 800_000),
        give(place::CUTTING_GEAR_GIVEN, place::CUTTING_GEAR_SPEED, 500_000),
        give(place::CUTTING_RANGE_GIVEN, place::CUTTING_RANGE, 10_000),
    ];
    // v / 2πr: 60 m/min at 20 and at 10 mm, 54 m/min at 10 mm; then the limits.
    assert_eq!(speeds, [0, 477_465, 954_930, 859_437, 800_000, 500_000, 500_000]);
    assert_eq!(bench.cells().word(place::SPINDLE_VOLTAGE), 10_000);
}

#[test]
fn the_program_may_keep_the_gear_to_itself() {
    let mut bench = Bench::new(LATHE);
    bench.set(place::GEAR_FROM_PROGRAM, true);
    bench.set(place::GEAR_BY_HAND, true);
    bench.cells().set_word(place::GEAR, 3);
    gear(&mut bench, 1);
    bench.tick();
    assert_eq!(bench.cells().word(place::GEAR), 3);
    bench.set(place::GEAR_BY_HAND, false);
    bench.tick();
    assert_eq!(bench.cells().word(place::GEAR), 1);
}

#[test]
fn the_motor_follows_its_output_by_its_ramp() {
    let mut bench = Bench::new(LATHE);
    gear(&mut bench, 3);
    bench.motion.analog_port(5).unwrap();
    bench.motion.analog(0x4000, Analog::Port).unwrap(); // 1200 rev/min, 2000 a second
    bench.run(300);
    let actual = bench.cells().dword(place::ACTUAL_PM);
    assert!((actual - 600_000).abs() < 1000, "{actual}");
    bench.run(310);
    let actual = bench.cells().dword(place::ACTUAL_PM);
    assert!((actual - 1_200_037).abs() < 10, "{actual}");
    assert!((bench.cells().dword(place::ACTUAL_PT) - 7200).abs() <= 1);
    assert!(bench.cells().dword(place::AVERAGE_PM) < actual, "it lags");
    bench.run(2000);
    assert_eq!(bench.cells().dword(place::AVERAGE_PM), actual);
    bench.motion.analog(-0x4000, Analog::Port).unwrap();
    bench.run(2000);
    assert!(bench.motion.spindle_speed(1) < -1199.0);
    assert_eq!(bench.cells().dword(place::ACTUAL_PM), actual, "a speed has no sign");
}

#[test]
fn a_spindle_without_encoder_shows_what_the_program_says() {
    let mut bench = Bench::new("[[spindle]]\nnumber=1\nencoder=false\ngear=[{max-speed=1000}]");
    bench.cells().set_dword(place::SIMULATED_PT, 6000);
    bench.tick();
    assert_eq!(bench.cells().dword(place::ACTUAL_PM), 1_000_000);
    assert_eq!(bench.cells().dword(place::ACTUAL_PT), 6000);
}

#[test]
fn values_are_cut_to_full_voltage_and_go_where_they_belong() {
    let mut bench = Bench::new("");
    assert_eq!(bench.motion.analog(1, Analog::Port), Err(Refused::NoOutput));
    bench.motion.analog_port(16).unwrap();
    bench.motion.analog(-0x8000, Analog::Port).unwrap();
    assert_eq!(bench.motion.outputs()[15], -0x7FFF);
    assert_eq!(bench.motion.analog_port(17), Err(Refused::NoSuchAxis));
    assert_eq!(bench.motion.analog_spi(5, 4), Err(Refused::NoOutput), "an axis");
    let mut memory = bench.memory.clone();
    let mut cells = Cells::new(&mut memory);
    let motion = &mut bench.motion;
    motion.ax_spi(&mut cells, 4, Some(Role::Main)).unwrap();
    motion.ax_spi(&mut cells, 5, Some(Role::Assist)).unwrap();
    assert!(!cells.bit(place::LOOP_CLOSED.of(3)) && !cells.bit(place::LOOP_CLOSED.of(4)));
    let seen = |motion: &technol_machine::Motion| (motion.outputs()[3], motion.outputs()[4]);
    motion.analog(100, Analog::Main).unwrap();
    motion.analog(200, Analog::Assist).unwrap();
    assert_eq!(seen(motion), (100, 200));
    // The roles are exchanged; the number of an axis stays its number.
    motion.ax_spi(&mut cells, 4, Some(Role::Assist)).unwrap();
    motion.ax_spi(&mut cells, 5, Some(Role::Main)).unwrap();
    motion.analog(300, Analog::Main).unwrap();
    motion.analog_spi(400, 4).unwrap();
    assert_eq!(seen(motion), (400, 300));
    motion.spi_main(4).unwrap();
    motion.analog(1, Analog::Main).unwrap();
    motion.analog(2, Analog::Assist).unwrap();
    assert_eq!(seen(motion), (1, 2));
    motion.analog(7, Analog::Axis(Some(4))).unwrap();
    motion.analog(8, Analog::Axis(None)).unwrap();
    assert_eq!(seen(motion), (7, 8), "a letter means the axis of the last AX_SPI");
    motion.analog(9, Analog::Axis(Some(1))).unwrap();
    assert_eq!(seen(motion), (7, 9), "axis 1 is no spindle");
    motion.ax_spi(&mut cells, 5, Some(Role::Off)).unwrap();
    assert_eq!(seen(motion), (7, 0));
    assert_eq!(motion.analog(3, Analog::Assist), Err(Refused::NoOutput));
}

#[test]
fn the_first_axis_that_becomes_a_spindle_is_the_main_one() {
    let mut bench = Bench::new("");
    let mut cells = Cells::new(&mut bench.memory);
    bench.motion.ax_spi(&mut cells, 6, None).unwrap();
    bench.motion.ax_spi(&mut cells, 5, None).unwrap();
    bench.motion.analog(11, Analog::Main).unwrap();
    assert_eq!(bench.motion.outputs()[5], 11);
    assert_eq!(bench.init(6), Err(Refused::Busy), "a spindle is no axis");
}

#[test]
fn an_independent_shift_waits_while_its_axis_is_a_spindle_and_is_not_requested() {
    let mut bench = Bench::new("[[axis]]\nnumber=2\nref-switch=\"none\"");
    bench.cells().set_word(place::WHEEL_STEP, 100);
    bench.cells().set_byte(place::OFFSET_ALLOWED, 0x3F);
    bench.set(place::OFFSET_MODE, true);
    bench.set(place::OFFSET_ACTIVE, true);
    bench.motion.select_key(2).unwrap();
    bench.motion.turn_wheel(-1);
    bench.run(500);
    assert_eq!(bench.cells().dword(place::OFFSET + 4), -800, "-100 µm in eighths");
    bench.motion.ax_spi(&mut Cells::new(&mut bench.memory), 2, None).unwrap();
    bench.set(place::OFFSET_MODE, false);
    bench.run(500);
    assert!(!bench.is(place::REQUESTED.of(1)), "nothing of a spindle is shifted");
    assert_eq!(bench.cells().dword(place::OFFSET + 4), -800);
    let back = SpiAx { feed1: None, feed2: None, angle: None, accel: Some(2000), axis: Some(2) };
    bench.motion.spi_ax(&mut Cells::new(&mut bench.memory), back).unwrap();
    bench.tick();
    assert!(bench.is(place::REQUESTED.of(1)), "an axis again, it goes back");
    bench.run(3000);
    assert_eq!(bench.cells().dword(place::OFFSET + 4), 0);
    assert!(!bench.is(place::REQUESTED.of(1)));
}

#[test]
fn a_rotary_axis_turns_with_its_output_and_feeds_follow_it() {
    let toml = "[[axis]]\nnumber=1\nacceleration=5000\nfeed=100\n\
                [[spindle]]\nnumber=1\naxis=4\nacceleration=60000\ngear=[{max-speed=600}]";
    let mut bench = Bench::new(toml);
    bench.motion.ax_spi(&mut Cells::new(&mut bench.memory), 4, None).unwrap();
    bench.motion.analog_spi(0x7FFF, 4).unwrap(); // 10 rev/s
    bench.run(100);
    let before = bench.position(4, 0);
    bench.run(100);
    assert!((bench.position(4, 0) - before - 360_000.0).abs() < 0.1, "one turn in 1/1000 °");
    assert!(!bench.is(place::REQUESTED.of(3)), "no motion of the control");
    // Manual movement with 100 µm a revolution: 1 mm/s.
    bench.set(place::JOG_PER_REVOLUTION, true);
    bench.set(place::JOG_BEGIN, true);
    bench.motion.jog_key(1, Some(technol_machine::motion::Direction::Plus)).unwrap();
    bench.run(100);
    let before = bench.position(1, 0);
    bench.run(1000);
    assert!((bench.position(1, 0) - before - 1000.0).abs() < 0.1);
}
