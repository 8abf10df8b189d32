//! Blocks of the part program: how long they take, what holds them, what they wait for.

use technol_image::system::motion as place;
use technol_machine::motion::{BlockMove, BlockState, Hold, Refused};

use crate::support::Bench;

/// Axes 1 and 3 with an acceleration of 500 mm/s² (1000 in rapid traverse at 100 mm/s).
const MACHINE: &str = "[[axis]]\nnumber=1\nfeed-rapid=6000\n[[axis]]\nnumber=3\nfeed-rapid=6000\n";

/// Milliseconds for a way in mm at a speed in mm/s by a ramp in mm/s².
fn expected(way: f64, speed: f64, ramp: f64) -> f64 {
    let seconds =
        if way * ramp > speed * speed { way / speed + speed / ramp } else { 2.0 * (way / ramp).sqrt() };
    seconds * 1000.0
}

/// Milliseconds until the block is done; `each` is called before each of them.
fn duration(block: &BlockMove, mut each: impl FnMut(&mut Bench, u32)) -> f64 {
    let mut bench = Bench::new(MACHINE);
    bench.begin(block).unwrap();
    let ticks = (0..60_000).find(|ms| {
        each(&mut bench, *ms);
        bench.tick();
        bench.motion.block() == BlockState::Done
    });
    for (number, way) in (1..).zip(block.travel) {
        assert!((bench.position(number, 0) - way).abs() < 0.001, "axis {number} is at its target");
    }
    f64::from(ticks.expect("it ends") + 1)
}

#[track_caller]
fn takes(block: &BlockMove, millis: f64, each: impl FnMut(&mut Bench, u32)) {
    let found = duration(block, each);
    assert!((found - millis).abs() <= 1.01, "{found} ms, not {millis}, for {block:?}");
}

#[test]
fn a_block_takes_its_way_by_its_speed_and_its_ramps() {
    for feed in [300.0, 600.0, 1200.0, 3000.0, 5400.0] {
        for way in [0.02, 0.5, 3.0, 12.5, 40.0] {
            for sign in [1.0, -1.0] {
                let block = BlockMove::at_feed(&[(1, sign * way * 1000.0)], feed);
                takes(&block, expected(way, feed / 60.0, 500.0), |_, _| {});
            }
        }
    }
    for way in [1.0, 10.0, 25.0, 140.0] {
        takes(&BlockMove::rapid(&[(1, way * 1000.0)]), expected(way, 100.0, 1000.0), |_, _| {});
    }
}

#[test]
fn on_a_straight_line_the_slowest_axis_counts() {
    // 50 mm on a 3-4-5 triangle: no axis accelerates by more than 500 mm/s², so the path does by 625.
    let block = BlockMove::at_feed(&[(1, 30_000.0), (3, -40_000.0)], 3000.0);
    takes(&block, expected(50.0, 50.0, 625.0), |_, _| {});
    // In rapid traverse axis 3 goes at 100 mm/s, the path at 125.
    let block = BlockMove { rapid: true, ..block };
    takes(&block, expected(50.0, 125.0, 1250.0), |_, _| {});
}

#[test]
fn a_hold_costs_the_time_it_lasts() {
    // 20 mm/s by 500 mm/s² stands after 40 ms; stopping and starting again cost half a ramp each, as long as it moves slower.
    let block = BlockMove::at_feed(&[(1, 30_000.0)], 1200.0);
    let free = expected(30.0, 20.0, 500.0);
    takes(&block, free + 400.0, |bench, ms| match ms {
        300 => bench.motion.hold(Hold::Stop),
        700 => bench.motion.hold(Hold::Go),
        _ => {}
    });
    takes(&block, free + 300.0, |bench, ms| match ms {
        300 => bench.set(place::ENABLE.of(0), false),
        600 => bench.set(place::ENABLE.of(0), true),
        _ => {}
    });
    // Emergency ramps stop in 10 ms, so that 15 ms less of the way are made while stopping.
    takes(&block, free + 415.0, |bench, ms| match ms {
        300 => bench.motion.hold(Hold::Emergency),
        700 => bench.motion.hold(Hold::Go),
        _ => {}
    });
}

#[test]
fn the_override_counts_while_it_lasts() {
    // Half speed for 1000 ms leaves 10 mm less behind, which cost 500 ms; the change itself is as quick as a ramp.
    let block = BlockMove::at_feed(&[(1, 40_000.0)], 1200.0);
    takes(&block, expected(40.0, 20.0, 500.0) + 500.0, |bench, ms| match ms {
        300 => bench.motion.set_overrides(50, 100),
        1300 => bench.motion.set_overrides(100, 100),
        _ => {}
    });
}

#[test]
fn a_feed_per_revolution_waits_for_the_spindle() {
    let spindle = "[[spindle]]\nnumber=1\nport=5\nacceleration=60000\ngear=[{max-speed=1200}]\n";
    let mut bench = Bench::new(&format!("{MACHINE}{spindle}"));
    let block = BlockMove { per_revolution: true, ..BlockMove::at_feed(&[(1, 10_000.0)], 0.5) };
    bench.begin(&block).unwrap();
    bench.run(500);
    assert_eq!(bench.position(1, 0), 0.0, "the spindle stands");
    bench.motion.analog_port(5).unwrap();
    bench.motion.analog(0x7FFF, technol_machine::motion::Analog::Port).unwrap(); // 20 rev/s: 10 mm/s
    bench.run(200);
    let before = bench.position(1, 0);
    bench.run(500);
    assert!((bench.position(1, 0) - before - 5000.0).abs() < 0.01);
}

#[test]
fn a_block_requests_its_axes_at_once_and_moves_when_it_is_released() {
    let mut bench = Bench::new(MACHINE);
    let block = BlockMove::at_feed(&[(1, 500.0), (3, -2000.0)], 600.0);
    bench.motion.begin_block(&mut technol_machine::Cells::new(&mut bench.memory), &block).unwrap();
    let told =
        |bench: &mut Bench| (bench.cells().axes(place::REQUESTED), bench.cells().axes(place::NEGATIVE));
    assert_eq!(told(&mut bench), (0b101, 0b100), "before any tick");
    bench.run(200);
    assert_eq!((told(&mut bench), bench.position(3, 0)), ((0b101, 0b100), 0.0));
    bench.motion.release_block();
    bench.run(400);
    assert_eq!((told(&mut bench).0, bench.position(3, 0)), (0, -2000.0));
    assert!(bench.motion.arrived());
}

#[test]
fn a_block_waits_for_axes_that_others_move() {
    let mut bench = Bench::new(MACHINE);
    let block = BlockMove::at_feed(&[(1, 500.0)], 600.0);
    bench.init(1).unwrap();
    assert_eq!(bench.begin(&block), Err(Refused::Busy), "the program has it");
    bench.begin(&BlockMove::at_feed(&[(3, 500.0)], 600.0)).unwrap();
    bench.run(300);
    bench.reset(1);
    bench.tick();
    bench.begin(&block).unwrap();
    bench.run(20);
    bench.motion.annul(&mut technol_machine::Cells::new(&mut bench.memory));
    assert_eq!(bench.begin(&block), Err(Refused::Busy), "it still runs out");
    bench.run(50);
    bench.begin(&block).unwrap();
}

#[test]
fn a_hold_that_nobody_waits_for_ends_by_itself() {
    let mut bench = Bench::new(MACHINE);
    bench.motion.hold(Hold::Stop);
    bench.tick();
    bench.begin(&BlockMove::at_feed(&[(1, 500.0)], 600.0)).unwrap();
    assert!(!bench.motion.is_held());
    bench.motion.hold(Hold::Stop);
    bench.run(100);
    assert!(bench.motion.is_held());
    bench.motion.annul(&mut technol_machine::Cells::new(&mut bench.memory));
    assert!(!bench.motion.is_held());
}

#[test]
fn a_block_stops_at_a_software_limit_by_its_ramp_and_stays() {
    let mut bench = Bench::new("[[axis]]\nnumber=1\nlimit-plus=20\nlimit-minus=-5\n");
    bench.cells().set_word(place::HOMING, 1);
    bench.cells().set_word(place::SLS_REFER, 1);
    bench.begin(&BlockMove::at_feed(&[(1, 30_000.0), (3, 40_000.0)], 3000.0)).unwrap();
    bench.run(5000);
    // 20 of 30 mm, and so 26.667 of 40 mm.
    assert!((bench.position(1, 0) - 20_000.0).abs() < 1.0, "{}", bench.position(1, 0));
    assert!((bench.position(3, 0) - 26_666.7).abs() < 2.0, "{}", bench.position(3, 0));
    assert_eq!(bench.motion.block(), BlockState::Moving);
    assert!(bench.is(place::SOFT_LIMIT) && !bench.is(place::LIMIT_SWITCH));
    assert_eq!(bench.cells().byte(place::SOFT_LIMIT_PLUS), 1);
    bench.motion.annul(&mut technol_machine::Cells::new(&mut bench.memory));
    bench.begin(&BlockMove::at_feed(&[(1, -10_000.0)], 3000.0)).unwrap();
    bench.run(1000);
    assert!((bench.position(1, 0) - 10_000.0).abs() < 1.0);
    assert!(!bench.is(place::SOFT_LIMIT));
}
