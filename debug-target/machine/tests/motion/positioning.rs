//! Positioning units: times, pauses, records.

use technol_image::system::motion as place;
use technol_machine::motion::Refused;

use crate::support::{Bench, CONTROL, STATUS, bit};

const POL: u8 = 3;

/// Travel in µm, speed in mm/min, slope in mm/s², a pause from one millisecond for a number of them.
type Move = (i32, i32, u16, Option<(u32, u32)>);

#[rustfmt::skip]
const MOVES: [Move; 50] = [
    (100_000, 1_000, 100, None),
    (10, 6_000, 100, None),
    (5_000, 6_000, 500, None),
    (333, 7_500, 5, None),
    (-2, 10, 500, None),
    (20_000, 24_000, 100, None),
    (1, 7_500, 1_000, None),
    (2, 10, 5_000, None),
    (1_000, 60_000, 20, None),
    (-25, 60_000, 5, None),
    (-20_000, 7_500, 5, None),
    (25, 24_000, 50, None),
    (100, 60, 5_000, Some((5, 40))),
    (20_000, 24_000, 50, None),
    (-2, 60_000, 100, None),
    (333, 24_000, 20, None),
    (20_000, 60_000, 100, None),
    (-2_500, 24_000, 1_000, None),
    (300_000, 12_000, 20_000, Some((15, 147))),
    (333, 250, 50, None),
    (-100, 12_000, 500, None),
    (123_456, 1_000, 20_000, Some((5, 40))),
    (-2, 7_500, 50, None),
    (1_000, 10, 5_000, Some((5, 500))),
    (300_000, 3_000, 500, Some((105, 600))),
    (-2_500, 12_000, 20, None),
    (-123_456, 1_000, 20_000, Some((5, 500))),
    (333, 60_000, 20, None),
    (2_500, 250, 250, Some((21, 56))),
    (123_456, 7_500, 1_000, Some((130, 262))),
    (2, 12_000, 1_000, None),
    (9_999, 60, 1_000, Some((6, 501))),
    (50_000, 250, 50, Some((88, 123))),
    (100, 1, 50, Some((5, 137))),
    (-1_000_000, 24_000, 1_000, Some((405, 537))),
    (1_000, 10, 2_500, Some((5, 500))),
    (1_000, 250, 20, None),
    (2_500, 10, 500, Some((5, 500))),
    (1, 1, 20_000, None),
    (-7, 10, 500, None),
    (20_000, 60, 250, Some((9, 141))),
    (2_500, 10, 50, Some((8, 43))),
    (2, 10, 100, None),
    (7, 60, 20_000, None),
    (333, 250, 500, None),
    (2, 10, 20, None),
    (333, 60, 5, None),
    (1, 10, 5_000, None),
    (-2, 60, 500, None),
    (-100, 1_000, 20_000, None),
];

/// Seconds that a move takes: full speed is reached or not.
fn seconds((length, feed, accel, pause): Move) -> f64 {
    let (s, v, a) = (f64::from(length.abs()) / 1000.0, f64::from(feed) / 60.0, f64::from(accel));
    let moving = if s >= v * v / a { s / v + v / a } else { 2.0 * (s / a).sqrt() };
    moving + pause.map_or(0.0, |(_, millis)| f64::from(millis) / 1000.0)
}

#[test]
fn every_move_takes_its_time_within_a_tick_and_ends_on_the_spot() {
    let mut bench = Bench::new("[[axis]]\nnumber=1\ndifference-limit=0");
    bench.init(1).unwrap();
    let mut target = 0.0;
    for row in MOVES {
        let (length, feed, accel, pause) = row;
        bench.mode(1, length, accel, 0).unwrap();
        let mut ticks = 0_u32;
        loop {
            let paused = pause.is_some_and(|(from, millis)| (from..from + millis).contains(&ticks));
            bench.control(1, feed, Some(!paused));
            if ticks > 0 && bench.is(bit(STATUS, POL)) {
                break;
            }
            bench.tick();
            ticks += 1;
            assert!(ticks < 60_000, "{row:?} does not end");
        }
        let error = f64::from(ticks) / 1000.0 - seconds(row);
        assert!(error.abs() <= 0.001 + 1e-9, "{row:?}: {ticks} ms, off by {error} s");
        target += f64::from(length);
        assert!((bench.position(1, 5) - target).abs() < 1e-4, "{row:?}");
        assert_eq!(
            bench.cells().byte(STATUS),
            0b1000 | u8::from(length < 0) << 1,
            "{row:?}: stands, and is there"
        );
    }
    assert!(MOVES.iter().filter(|row| row.3.is_some()).count() >= 10);
}

#[test]
fn the_records_follow_a_motion_in_the_documented_order() {
    let mut bench = Bench::new("");
    let watch = [
        ("DISP", bit(STATUS + 1, 0)),
        ("PROG", bit(STATUS + 1, 1)),
        ("ERR", bit(STATUS + 1, 2)),
        ("MP", bit(CONTROL + 1, 0)),
        ("RESET", bit(CONTROL + 1, 1)),
        ("INIC", bit(CONTROL + 1, 2)),
        ("CONT", bit(CONTROL + 1, 3)),
        ("JEDE", bit(STATUS, 0)),
        ("SMER", bit(STATUS, 1)),
        ("POL", bit(STATUS, POL)),
        ("PO_OSZPI", place::REQUESTED.of(2)),
        ("SM_POZPI", place::NEGATIVE.of(2)),
    ];
    let drawn = bench.draw(440, 10, &watch, |bench, ms| {
        match ms {
            20 => bench.init(3).unwrap(),
            40 => bench.mode(3, -6000, 1000, 0).unwrap(),
            380 => bench.reset(3),
            _ => {}
        }
        // The program runs every 20 ms. 60 mm/s, up and down in 60 ms each; a pause from 120 to 240.
        if ms % 20 == 0 {
            bench.control(3, if ms >= 60 { 3600 } else { 0 }, Some(!(120..240).contains(&ms)));
        }
    });
    insta::assert_snapshot!(drawn, @r"
    DISP     __####################################______
    PROG     ______################################______
    ERR      ____________________________________________
    MP       ____########____________####################
    RESET    ______________________________________#_____
    INIC     ____________________________________________
    CONT     ____#############################___________
    JEDE     ________##########________########__________
    SMER     ____########################################
    POL      __________________________________####______
    PO_OSZPI ____#############################___________
    SM_POZPI ______######################################
    ");
}

#[test]
fn the_program_holds_at_most_six_axes() {
    let mut bench = Bench::new("");
    for axis in [1, 2, 3, 9, 10, 16] {
        assert_eq!(bench.init(axis), Ok(()));
    }
    assert_eq!(bench.init(4), Err(Refused::TooMany));
    bench.control(4, 0, None);
    assert_eq!(bench.cells().byte(STATUS + 1), 0b100, "not at its disposal, and an error");
    assert_eq!(bench.init(9), Ok(()), "an axis may be taken again");
    bench.reset(9);
    assert_eq!(bench.init(4), Ok(()));
    bench.control(4, 0, None);
    assert_eq!(bench.cells().byte(STATUS + 1), 0b001);
    assert_eq!(bench.init(17), Err(Refused::NoSuchAxis));
}

#[test]
fn an_axis_with_an_open_loop_is_not_taken() {
    let mut bench = Bench::new("");
    bench.set(place::LOOP_CLOSED.of(1), false);
    assert_eq!(bench.init(2), Err(Refused::LoopOpen));
    bench.control(2, 0, None);
    assert!(bench.is(bit(STATUS + 1, 2)));
}

#[test]
fn without_init_or_without_a_ramp_nothing_is_programmed() {
    let mut bench = Bench::new("");
    assert_eq!(bench.mode(1, 1000, 100, 0), Err(Refused::NotHeld));
    bench.control(1, 0, None);
    assert_eq!(bench.cells().byte(STATUS + 1), 0b100);
    bench.init(1).unwrap();
    assert_eq!(bench.mode(1, 1000, 0, 0), Err(Refused::NoRamp));
    bench.run(50);
    bench.control(1, 6000, Some(true));
    assert_eq!(bench.cells().byte(STATUS + 1), 0b101);
    bench.run(50);
    assert_eq!(bench.position(1, 5), 0.0);
}

#[test]
fn init_stops_a_motion_by_its_ramp_for_good() {
    let mut bench = Bench::new("");
    bench.init(1).unwrap();
    bench.mode(1, 100_000, 1000, 0).unwrap();
    bench.control(1, 6000, Some(true));
    bench.run(200); // 100 ms up to 100 mm/s: 5 mm, then 10 mm
    assert!((bench.position(1, 5) - 15_000.0).abs() < 100.0);
    bench.init(1).unwrap();
    bench.run(300);
    bench.control(1, 6000, Some(true));
    bench.run(300);
    let stopped = bench.position(1, 5);
    assert!((stopped - 20_000.0).abs() < 200.0, "5 mm of ramp: {stopped}");
    assert_eq!(bench.cells().byte(STATUS + 1), 0b001, "held, not programmed");
    // The travel of a new motion counts from here.
    bench.mode(1, -1000, 1000, 0).unwrap();
    bench.control(1, 6000, Some(true));
    bench.run(300);
    assert!((bench.position(1, 5) - (stopped - 1000.0)).abs() < 1e-3);
}

#[test]
fn reset_during_a_motion_stops_by_the_ramp_and_gives_the_axis_back() {
    let mut bench = Bench::new("");
    bench.init(1).unwrap();
    bench.mode(1, 100_000, 1000, 0).unwrap();
    bench.control(1, 6000, Some(true));
    bench.run(200);
    bench.reset(1);
    bench.control(1, 6000, Some(true));
    assert_eq!((bench.cells().byte(STATUS), bench.cells().byte(STATUS + 1)), (0, 0));
    bench.run(99);
    assert!(bench.is(place::REQUESTED.of(0)), "still on its ramp");
    bench.run(20);
    assert!(!bench.is(place::REQUESTED.of(0)));
    assert!((bench.position(1, 5) - 20_000.0).abs() < 200.0);
}

#[test]
fn the_program_may_write_the_motion_enable_itself() {
    let mut bench = Bench::new("");
    bench.init(2).unwrap();
    bench.mode(2, 1000, 1000, 0).unwrap();
    bench.control(2, 6000, None);
    bench.run(100);
    assert_eq!(bench.position(2, 5), 0.0, "not enabled");
    bench.set(bit(CONTROL + 1, 0), true);
    bench.run(100);
    assert_eq!(bench.position(2, 5), 1000.0);
}

#[test]
fn a_travel_of_zero_is_reached_at_once_and_stays_programmed() {
    let mut bench = Bench::new("");
    bench.init(1).unwrap();
    bench.mode(1, 0, 100, 0).unwrap();
    bench.tick();
    bench.control(1, 0, None);
    assert_eq!((bench.cells().byte(STATUS), bench.cells().byte(STATUS + 1)), (0b1000, 0b011));
}

#[test]
fn a_unit_moves_its_space_and_those_behind_it() {
    let mut bench = Bench::new("");
    bench.init(1).unwrap();
    bench.mode(1, 1000, 1000, 0).unwrap();
    bench.control(1, 6000, Some(true));
    bench.run(200);
    let mut seen = |space| bench.position(1, space);
    assert_eq!([0, 1, 2, 3, 4, 5].map(&mut seen), [0.0, 0.0, 0.0, 0.0, 0.0, 1000.0]);
    assert_eq!(bench.cells().dword(place::SERVO_MEASURED), 1000);
}

#[test]
fn the_older_form_creeps_onto_the_target() {
    let mut bench = Bench::new("");
    bench.init(4).unwrap();
    bench.mode(4, 20_000, 500, 60).unwrap(); // 1 mm/s at the end
    bench.control(4, 6000, Some(true));
    let (mut before, mut creeping) = (0.0, 0);
    for _ in 0..1000 {
        bench.tick();
        let now = bench.position(4, 5);
        creeping += u32::from(now > 19_000.0 && (0.9..=1.01).contains(&(now - before)));
        before = now;
    }
    assert_eq!(before, 20_000.0);
    assert!((100..=104).contains(&creeping), "a tenth of a second: {creeping}");
}

#[test]
fn a_limit_switch_stops_a_unit_and_lets_it_go_on() {
    let mut bench = Bench::new("[[axis]]\nnumber=1\nacceleration-emergency=10000");
    bench.init(1).unwrap();
    bench.mode(1, 50_000, 1000, 0).unwrap();
    bench.control(1, 6000, Some(true));
    bench.run(300);
    let before = bench.position(1, 5);
    bench.set(place::LIMIT_PLUS.of(0), true);
    bench.run(50);
    let stopped = bench.position(1, 5);
    assert!(stopped - before < 700.0, "a short ramp: {}", stopped - before);
    bench.run(50);
    assert_eq!(bench.position(1, 5), stopped);
    bench.set(place::LIMIT_PLUS.of(0), false);
    bench.run(1000);
    assert_eq!(bench.position(1, 5), 50_000.0);
}

#[test]
fn an_open_loop_during_a_motion_ends_in_a_position_error() {
    let mut bench = Bench::new("");
    bench.init(1).unwrap();
    bench.mode(1, 50_000, 1000, 0).unwrap();
    bench.control(1, 6000, Some(true));
    bench.cells().set_word(place::HOMING, 0b11);
    bench.run(100);
    bench.set(place::LOOP_CLOSED.of(0), false);
    bench.run(100);
    assert_ne!(bench.cells().byte(place::ERROR_NUMBER), 0);
    assert_eq!(bench.cells().word(place::HOMING), 0b10, "the reference is gone");
    assert_eq!(bench.cells().dword(place::DIFFERENCE), 0, "the counter is cleared");
    bench.control(1, 6000, Some(true));
    assert_eq!(bench.cells().byte(STATUS + 1), 0b101, "held, with an error, programmed no more");
}
