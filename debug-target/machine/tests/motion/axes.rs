//! Axes: manual movement, limits, overrides, blocks.

use technol_image::system::motion as place;
use technol_machine::motion::{BlockMove, BlockState, Direction, Hold, Refused};

use crate::support::Bench;

/// Manual movement of the program in positive direction of axis 1 with this feed, mm/min.
fn jog(bench: &mut Bench, feed: u16) {
    bench.set(place::JOG_REQ, true);
    bench.set(place::EXTERNAL_JOG, true);
    bench.set(place::EXTERNAL_FEED_REQ, true);
    bench.cells().set_word(place::EXTERNAL_FEED, feed);
    bench.set(place::EXTERNAL_PLUS.of(0), true);
}

fn near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value}, not {expected}");
}

#[test]
fn manual_movement_answers_and_moves_as_long_as_it_is_asked_for() {
    let mut bench = Bench::new("");
    let watch = [
        ("AUTMAN_REQ", place::JOG_REQ),
        ("ACK_AUTMAN", place::JOG_ACTIVE),
        ("EXM_X0", place::EXTERNAL_PLUS.of(0)),
        ("EXM_X1", place::EXTERNAL_MINUS.of(0)),
        ("MPXPI", place::ENABLE.of(0)),
        ("MM_X0", place::JOG_PLUS.of(0)),
        ("MM_X1", place::JOG_MINUS.of(0)),
        ("PO_OSXPI", place::REQUESTED.of(0)),
        ("SM_POXPI", place::NEGATIVE.of(0)),
    ];
    bench.cells().set_word(place::EXTERNAL_FEED, 600); // 10 mm/s, 20 ms of ramp
    bench.set(place::EXTERNAL_JOG, true);
    bench.set(place::EXTERNAL_FEED_REQ, true);
    let drawn = bench.draw(400, 10, &watch, |bench, ms| match ms {
        20 => bench.set(place::EXTERNAL_PLUS.of(0), true), // not active yet
        50 => bench.set(place::JOG_REQ, true),
        100 => bench.set(place::EXTERNAL_PLUS.of(0), false),
        150 => {
            bench.set(place::ENABLE.of(0), false);
            bench.set(place::EXTERNAL_MINUS.of(0), true);
        }
        200 => bench.set(place::ENABLE.of(0), true),
        250 => bench.set(place::EXTERNAL_PLUS.of(0), true), // both: neither
        300 => bench.set(place::EXTERNAL_PLUS.of(0), false),
        340 => bench.set(place::JOG_REQ, false),
        _ => {}
    });
    insta::assert_snapshot!(drawn, @r"
    AUTMAN_REQ _____#############################______
    ACK_AUTMAN _____#############################______
    EXM_X0     __########_______________#####__________
    EXM_X1     _______________#########################
    MPXPI      ###############_____####################
    MM_X0      _____#####______________________________
    MM_X1      _______________##########_____####______
    PO_OSXPI   _____######____###########____#####_____
    SM_POXPI   _______________#########################
    ");
    // Forward 50 ms, back 50 and 40 ms, all at 10 mm/s: a ramp up and a ramp down make one way at full speed.
    near(bench.position(1, 0), 500.0 - 500.0 - 400.0, 25.0);
}

#[test]
fn edges_begin_and_end_manual_movement_and_are_cleared() {
    let mut bench = Bench::new("");
    bench.set(place::JOG_ALLOWED, false);
    bench.set(place::JOG_BEGIN, true);
    bench.tick();
    assert!(!bench.is(place::JOG_BEGIN) && !bench.is(place::JOG_ACTIVE), "not allowed, but taken");
    bench.set(place::JOG_ALLOWED, true);
    bench.set(place::JOG_BEGIN, true);
    bench.run(2);
    assert!(!bench.is(place::JOG_BEGIN) && bench.is(place::JOG_ACTIVE) && bench.is(place::JOG_FROM_PANEL));
    bench.set(place::JOG_END, true);
    bench.tick();
    assert!(!bench.is(place::JOG_END) && !bench.is(place::JOG_ACTIVE));
    bench.set(place::JOG_REQ, true);
    bench.tick();
    bench.set(place::JOG_END, true);
    bench.run(5);
    assert!(!bench.is(place::JOG_ACTIVE), "the request must fall first");
    bench.set(place::JOG_REQ, false);
    bench.tick();
    bench.set(place::JOG_REQ, true);
    bench.tick();
    assert!(bench.is(place::JOG_ACTIVE));
}

#[test]
fn the_feed_of_manual_movement_comes_from_where_it_shall() {
    // µm in a second at full speed.
    let speed = |prepare: &dyn Fn(&mut Bench)| {
        let mut bench = Bench::new("[[axis]]\nnumber=1\nfeed=1200\nfeed-rapid=6000\nacceleration=5000");
        bench.set(place::JOG_REQ, true);
        bench.set(place::EXTERNAL_JOG, true);
        bench.set(place::EXTERNAL_PLUS.of(0), true);
        prepare(&mut bench);
        bench.run(200);
        let before = bench.position(1, 0);
        bench.run(1000);
        (bench.position(1, 0) - before) / 1000.0
    };
    near(speed(&|_| {}), 20.0, 0.001);
    near(speed(&|b| b.motion.set_overrides(50, 100)), 10.0, 0.001);
    near(speed(&|b| b.cells().set_word(place::FEED_MULTIPLIER, 500)), 10.0, 0.001);
    let by_program = |b: &mut Bench| {
        b.set(place::FEED_FROM_PROGRAM, true);
        b.cells().set_word(place::OVERRIDE_FEED, 1500);
    };
    near(speed(&|b| by_program(b)), 30.0, 0.001);
    near(speed(&|b| jog(b, 300)), 5.0, 0.001);
    near(speed(&|b| jog(b, 60_000)), 100.0, 0.001); // no faster than rapid traverse
    let rapid = |b: &mut Bench| b.set(place::EXTERNAL_RAPID, true);
    near(speed(&rapid), 100.0, 0.001);
    let own_rapid = |b: &mut Bench| {
        rapid(b);
        b.set(place::EXTERNAL_RAPID_FEED_REQ, true);
        b.cells().set_word(place::EXTERNAL_FEED_RAPID, 3000);
    };
    near(speed(&own_rapid), 50.0, 0.001);
    let limited = |b: &mut Bench| {
        b.set(place::LIMIT_FEED_REQ, true);
        b.cells().set_dword(place::LIMIT_FEED, 7 << 16); // upper word in mm/s
    };
    near(speed(&limited), 7.0, 0.001);
    let limited_rapid = |b: &mut Bench| {
        rapid(b);
        b.set(place::LIMIT_FEED_RAPID_REQ, true);
        b.cells().set_dword(place::LIMIT_FEED_RAPID, 9 << 16);
    };
    near(speed(&limited_rapid), 9.0, 0.001);
    near(speed(&|b| b.set(place::JOG_PER_REVOLUTION, true)), 0.0, 0.001); // the spindle stands
    near(speed(&|b| b.set(place::EXTERNAL_SELECT, true)), 0.0, 0.001); // only preselected
    near(speed(&|b| b.set(place::SLOW_LIMIT_MINUS.of(0), true)), 500.0 / 60.0, 0.001);
}

#[test]
fn keys_of_the_panel_jog_when_the_program_does_not() {
    let mut bench = Bench::new("");
    bench.set(place::JOG_BEGIN, true);
    bench.motion.jog_key(2, Some(Direction::Minus)).unwrap();
    bench.motion.jog_rapid(true);
    bench.run(100);
    assert!(bench.is(place::JOG_MINUS.of(1)) && bench.is(place::JOG_RAPID));
    assert!(bench.position(2, 0) < -1000.0);
    bench.set(place::EXTERNAL_JOG, true);
    bench.run(500);
    assert!(!bench.is(place::JOG_MINUS.of(1)) && !bench.is(place::JOG_RAPID));
    let stopped = bench.position(2, 0);
    bench.run(10);
    assert_eq!(bench.position(2, 0), stopped);
}

#[test]
fn the_bits_that_enable_manual_movement_are_a_matter_of_the_description() {
    let mut bench = Bench::new("[[axis]]\nnumber=1\njog-enable='manual'");
    jog(&mut bench, 600);
    bench.run(100);
    assert_eq!(bench.position(1, 0), 0.0);
    bench.set(place::ENABLE_MANUAL.of(0), true);
    bench.run(100);
    assert!(bench.position(1, 0) > 500.0);
}

#[test]
fn a_limit_switch_lets_manual_movement_only_back() {
    let mut bench = Bench::new("");
    jog(&mut bench, 6000);
    bench.run(300);
    bench.set(place::LIMIT_PLUS.of(0), true);
    bench.tick();
    assert!(bench.is(place::LIMIT_SWITCH) && !bench.is(place::ENABLED.of(0)));
    bench.run(200);
    let stopped = bench.position(1, 0);
    bench.run(50);
    assert_eq!(bench.position(1, 0), stopped);
    bench.set(place::EXTERNAL_PLUS.of(0), false);
    bench.set(place::EXTERNAL_MINUS.of(0), true);
    bench.run(100);
    assert!(bench.position(1, 0) < stopped - 100.0);
}

#[test]
fn software_limits_count_once_the_reference_is_valid() {
    let toml = "[[axis]]\nnumber=1\nlimit-plus=10\nlimit-minus=-5\nlimit-zone=2\nfeed-slow=60";
    let mut bench = Bench::new(toml);
    jog(&mut bench, 3000);
    bench.cells().set_word(place::SLS_REFER, 1);
    bench.run(300);
    assert!(bench.position(1, 0) > 11_000.0, "no reference, no limit");
    bench.set(place::EXTERNAL_PLUS.of(0), false);
    bench.set(place::EXTERNAL_MINUS.of(0), true);
    bench.run(250);
    bench.cells().set_word(place::HOMING, 1);
    bench.set(place::EXTERNAL_MINUS.of(0), false);
    bench.set(place::EXTERNAL_PLUS.of(0), true);
    let byte = |bench: &mut Bench, at| bench.cells().byte(at);
    bench.run(3000);
    near(bench.position(1, 0), 10_000.0, 0.001);
    assert_eq!((byte(&mut bench, place::SOFT_LIMIT_PLUS), byte(&mut bench, place::SOFT_SLOW_PLUS)), (1, 1));
    assert!(bench.is(place::SOFT_LIMIT) && !bench.is(place::ENABLED.of(0)));
    bench.set(place::EXTERNAL_PLUS.of(0), false);
    bench.set(place::EXTERNAL_MINUS.of(0), true);
    bench.run(150);
    assert_eq!(byte(&mut bench, place::SOFT_LIMIT_PLUS), 0);
    assert!(bench.position(1, 0) < 6000.0, "out of the zone at full speed");
    bench.run(3000);
    near(bench.position(1, 0), -5000.0, 0.001);
    assert_eq!((byte(&mut bench, place::SOFT_LIMIT_MINUS), byte(&mut bench, place::SOFT_SLOW_MINUS)), (1, 1));
}

#[test]
fn the_difference_counter_is_speed_over_gain() {
    let mut bench = Bench::new("[[axis]]\nnumber=1\ngain=50\ndifference-limit=0");
    jog(&mut bench, 6000); // 100 mm/s
    bench.run(600);
    // Read behind the loop: the way of the last tick has been made up by a share of gain · 1 ms.
    near(f64::from(bench.cells().dword(place::DIFFERENCE)), 100_000.0 / 50.0 - 100.0, 1.0);
    assert!(!bench.motion.in_position());
    bench.set(place::EXTERNAL_PLUS.of(0), false);
    bench.run(600);
    assert_eq!(bench.cells().dword(place::DIFFERENCE), 0);
    assert!(bench.motion.in_position());
}

#[test]
fn a_regulator_set_has_a_gain_of_its_own() {
    let mut bench = Bench::new("[[axis]]\nnumber=1\ngain=100\ngains=[100,50]\ndifference-limit=0");
    jog(&mut bench, 6000);
    let mut error = |set| {
        bench.motion.regul(1, set).unwrap();
        bench.run(600);
        bench.cells().dword(place::DIFFERENCE)
    };
    assert_eq!([1, 2, 3].map(&mut error), [900, 1900, 900], "speed / gain, less the way of the last tick");
    assert_eq!(bench.motion.regul(1, 0), Err(Refused::NoSuchSet));
    assert_eq!(bench.motion.regul(1, 5), Err(Refused::NoSuchSet));
}

#[test]
fn all_cells_of_a_position_agree() {
    let mut bench = Bench::new("[[axis]]\nnumber=2\nincrements=5000\nstart=3");
    bench.begin(&BlockMove::at_feed(&[(2, -1250.0)], 600.0)).unwrap();
    bench.run(400);
    let at = 4;
    assert_eq!(bench.cells().dword(place::POSITION_OLD + at), -10_000);
    assert_eq!(bench.cells().dword(place::INCREMENT_OLD + at), 0);
    assert_eq!(bench.cells().qword(place::POSITION + 8), -1250 << 16);
    for space in 1..=5 {
        assert_eq!(bench.position(2, space), -1250.0);
    }
    assert_eq!(bench.cells().dword(place::SERVO_REQUESTED + at), -1250);
    assert_eq!(bench.cells().dword(place::SERVO_MEASURED + at), -1250);
    assert_eq!(bench.cells().dword(place::SERVO_INCREMENTS + at), (3000 - 1250) * 5, "of the machine");
    assert_eq!(bench.motion.place(2, None), Some(1750.0));
    // 500 mm/s² and 2000 mm/min in 1/65536 µm and ms.
    assert_eq!(bench.cells().dword(place::ACCELERATION), 32_768);
    assert_eq!(bench.cells().dword(place::FEED), 2_184_533);
}

#[test]
fn a_block_moves_its_axes_on_a_straight_line_and_waits_while_it_is_held() {
    let mut bench = Bench::new("");
    let block = BlockMove::at_feed(&[(1, 30_000.0), (3, -40_000.0)], 6000.0);
    bench.motion.hold(Hold::Stop);
    bench.begin(&block).unwrap();
    assert_eq!(bench.begin(&block), Err(Refused::Busy));
    assert_eq!(bench.init(1), Err(Refused::Busy));
    let watch = [
        ("MPZPI", place::ENABLE.of(2)),
        ("PO_OSXPI", place::REQUESTED.of(0)),
        ("PO_OSYPI", place::REQUESTED.of(1)),
        ("PO_OSZPI", place::REQUESTED.of(2)),
        ("SM_POZPI", place::NEGATIVE.of(2)),
        ("MPZ", place::ENABLED.of(2)),
    ];
    let mut off_line: f64 = 0.0;
    let drawn = bench.draw(1600, 25, &watch, |bench, ms| {
        match ms {
            100 => bench.motion.hold(Hold::Go),
            400 => bench.set(place::ENABLE.of(2), false),
            800 => bench.set(place::ENABLE.of(2), true),
            _ => {}
        }
        off_line = off_line.max((bench.position(1, 0) * 4.0 + bench.position(3, 0) * 3.0).abs());
    });
    insta::assert_snapshot!(drawn, @r"
    MPZPI    ################________________################################
    PO_OSXPI ##############################################__________________
    PO_OSYPI ________________________________________________________________
    PO_OSZPI ##############################################__________________
    SM_POZPI ################################################################
    MPZ      ################________________################################
    ");
    assert!(off_line < 0.01, "{off_line}");
    assert_eq!((bench.position(1, 0), bench.position(3, 0)), (30_000.0, -40_000.0));
    assert_eq!(bench.motion.block(), BlockState::Done);
}

#[test]
fn an_axis_moved_during_a_stop_must_come_back_before_the_block_goes_on() {
    let mut bench = Bench::new("");
    bench.begin(&BlockMove::at_feed(&[(1, 20_000.0)], 600.0)).unwrap();
    bench.run(500);
    bench.motion.hold(Hold::Stop);
    bench.run(100);
    let stop = bench.position(1, 0);
    assert!(bench.is(place::AT_STOP_POINT));
    jog(&mut bench, 60);
    bench.run(400);
    assert!(!bench.is(place::AT_STOP_POINT));
    bench.set(place::EXTERNAL_PLUS.of(0), false);
    bench.run(50);
    bench.motion.hold(Hold::Go);
    bench.run(200);
    assert!(bench.position(1, 0) > stop + 300.0, "it waits where it was left");
    bench.motion.hold(Hold::Stop);
    bench.set(place::EXTERNAL_MINUS.of(0), true);
    for _ in 0..1000 {
        bench.tick();
        if bench.is(place::AT_STOP_POINT) {
            break;
        }
    }
    bench.set(place::EXTERNAL_MINUS.of(0), false);
    bench.run(50);
    assert!(bench.is(place::AT_STOP_POINT));
    bench.motion.hold(Hold::Go);
    bench.run(3000);
    assert_eq!(bench.position(1, 0), 20_000.0);
}

#[test]
fn an_emergency_stop_is_steeper_than_a_stop() {
    let way = |hold| {
        let mut bench = Bench::new("[[axis]]\nnumber=1\nacceleration=500\nacceleration-emergency=5000");
        let block = BlockMove::at_feed(&[(1, 100_000.0)], 6000.0);
        bench.begin(&block).unwrap();
        bench.run(500);
        let before = bench.position(1, 0);
        bench.motion.hold(hold);
        bench.run(500);
        bench.position(1, 0) - before
    };
    near(way(Hold::Stop), 10_000.0, 100.0); // v²/2a
    near(way(Hold::Emergency), 1000.0, 100.0);
}

#[test]
fn an_emergency_stop_holds_manual_movement_and_a_stop_does_not() {
    let mut bench = Bench::new("");
    jog(&mut bench, 6000);
    bench.run(300);
    bench.motion.hold(Hold::Stop);
    bench.run(100);
    let before = bench.position(1, 0);
    bench.motion.hold(Hold::Emergency);
    bench.run(200);
    let stopped = bench.position(1, 0);
    near(stopped - before, 2500.0, 100.0);
    bench.run(200);
    assert_eq!(bench.position(1, 0), stopped);
}

#[test]
fn a_restart_stops_everything_and_a_cold_one_forgets_the_positions() {
    let mut bench = Bench::new("");
    bench.begin(&BlockMove::at_feed(&[(1, 20_000.0)], 600.0)).unwrap();
    bench.run(500);
    let there = bench.position(1, 0);
    bench.motion.start(false);
    bench.run(500);
    near(bench.position(1, 0), there, 0.001);
    assert_eq!(bench.motion.block(), BlockState::None);
    bench.motion.start(true);
    bench.tick();
    assert_eq!(bench.position(1, 0), 0.0);
}

#[test]
fn the_handwheel_moves_the_preselected_axis_by_its_steps() {
    let mut bench = Bench::new("");
    bench.cells().set_word(place::WHEEL_STEP, 100);
    bench.motion.select_key(2).unwrap();
    bench.motion.turn_wheel(3);
    bench.run(100);
    assert_eq!(bench.position(2, 0), 0.0, "manual movement is not active");
    bench.set(place::JOG_BEGIN, true);
    bench.tick();
    bench.motion.turn_wheel(30);
    bench.run(20);
    assert!(bench.is(place::REQUESTED.of(1)));
    bench.motion.turn_wheel(-5); // on the way
    bench.run(500);
    assert_eq!(bench.position(2, 0), 2500.0);
    assert!(!bench.is(place::REQUESTED.of(1)));
    // The program preselects axis 1, which does not move by that.
    bench.set(place::EXTERNAL_JOG, true);
    bench.set(place::EXTERNAL_SELECT, true);
    bench.set(place::EXTERNAL_PLUS.of(0), true);
    bench.run(10);
    assert!(bench.is(place::JOG_SELECTING) && bench.is(place::JOG_PLUS.of(0)));
    bench.set(place::EXTERNAL_SELECT, false);
    bench.set(place::EXTERNAL_PLUS.of(0), false);
    bench.motion.turn_wheel(1);
    bench.run(100);
    assert_eq!((bench.position(1, 0), bench.position(2, 0)), (100.0, 2500.0));
    // The key of an axis that is preselected switches it off when the program wants that.
    bench.set(place::WHEEL_TOGGLE, true);
    bench.motion.select_key(1).unwrap();
    bench.tick();
    bench.motion.turn_wheel(1);
    bench.run(100);
    assert_eq!(bench.position(1, 0), 100.0);
}

#[test]
fn a_jog_key_preselects_its_axis_unless_the_program_forbids_it() {
    for (forbidden, expected) in [(false, 50.0), (true, 0.0)] {
        let mut bench = Bench::new("");
        bench.cells().set_word(place::WHEEL_STEP, 50);
        bench.set(place::NO_WHEEL, forbidden);
        bench.set(place::JOG_BEGIN, true);
        bench.motion.jog_key(1, Some(Direction::Plus)).unwrap();
        bench.run(100);
        bench.motion.jog_key(1, None).unwrap();
        bench.run(200);
        let before = bench.position(1, 0);
        bench.motion.turn_wheel(1);
        bench.run(200);
        near(bench.position(1, 0) - before, expected, 0.001);
    }
}

#[test]
fn the_hash_of_the_state_tells_what_moves() {
    let mut bench = Bench::new("");
    bench.run(5);
    let rest = bench.motion.state_hash();
    bench.run(5);
    assert_eq!(bench.motion.state_hash(), rest);
    jog(&mut bench, 60);
    bench.tick();
    assert_ne!(bench.motion.state_hash(), rest);
}

#[test]
fn the_independent_shift_goes_beside_the_path_and_back_with_its_mode() {
    let mut bench = Bench::new("");
    bench.cells().set_word(place::WHEEL_STEP, 100);
    bench.cells().set_byte(place::OFFSET_ALLOWED, 0x3F);
    bench.set(place::OFFSET_MODE, true);
    bench.set(place::OFFSET_ACTIVE, true);
    bench.motion.select_key(1).unwrap();
    bench.begin(&BlockMove::at_feed(&[(1, 20_000.0)], 1200.0)).unwrap();
    bench.run(200);
    assert_eq!(bench.cells().byte(place::OFFSET_AXIS), 1);
    bench.motion.turn_wheel(-7);
    bench.run(2000);
    assert_eq!(
        (bench.position(1, 0), bench.position(1, 4)),
        (20_000.0, 20_000.0),
        "the program does not notice"
    );
    near(bench.position(1, 5), 19_300.0, 0.001);
    assert_eq!(bench.cells().dword(place::OFFSET), -5600);
    assert_eq!(bench.cells().dword(place::SERVO_MEASURED), 19_300);
    bench.set(place::OFFSET_ACTIVE, false);
    bench.motion.turn_wheel(-7);
    bench.run(200);
    near(bench.position(1, 5), 19_300.0, 0.001);
    assert_eq!(bench.cells().byte(place::OFFSET_AXIS), 0);
    bench.set(place::OFFSET_MODE, false);
    bench.tick();
    assert!(bench.is(place::REQUESTED.of(0)));
    bench.run(500);
    near(bench.position(1, 5), 20_000.0, 0.001);
    assert_eq!(bench.cells().dword(place::OFFSET), 0);
    // An axis that must not be shifted is not.
    bench.set(place::OFFSET_MODE, true);
    bench.set(place::OFFSET_ACTIVE, true);
    bench.cells().set_byte(place::OFFSET_ALLOWED, 0x3E);
    bench.motion.turn_wheel(5);
    bench.run(200);
    near(bench.position(1, 5), 20_000.0, 0.001);
}

#[test]
fn keys_of_the_panel_do_what_they_say() {
    use technol_machine::motion::PanelKey;
    let mut bench = Bench::new("[[axis]]\nnumber=2\nfeed=600");
    bench.set(place::JOG_BEGIN, true);
    let press = |bench: &mut Bench, key, down| bench.motion.panel_key(key, down).unwrap();
    press(&mut bench, PanelKey::Jog(-2), true);
    bench.run(200);
    let slow = bench.position(2, 0);
    assert!((-2000.0..-1500.0).contains(&slow), "10 mm/s: {slow}");
    press(&mut bench, PanelKey::FeedPercent(0), true);
    press(&mut bench, PanelKey::FeedPercent(0), false);
    bench.run(100);
    let stopped = bench.position(2, 0);
    bench.run(100);
    assert_eq!(bench.position(2, 0), stopped, "the potentiometer stays where it is");
    press(&mut bench, PanelKey::FeedPercent(100), true);
    press(&mut bench, PanelKey::JogRapid, true);
    bench.run(500);
    assert!(bench.is(place::JOG_RAPID) && bench.position(2, 0) < stopped - 10_000.0);
    press(&mut bench, PanelKey::JogRapid, false);
    press(&mut bench, PanelKey::Jog(-2), false);
    bench.run(500);
    let before = bench.position(1, 0);
    bench.cells().set_word(place::WHEEL_STEP, 100);
    press(&mut bench, PanelKey::SelectAxis(1), true);
    bench.run(1);
    press(&mut bench, PanelKey::Wheel(5), true);
    press(&mut bench, PanelKey::Wheel(5), false);
    bench.run(500);
    assert_eq!(bench.position(1, 0) - before, 500.0);
    bench.set(place::JOG_END, true);
    press(&mut bench, PanelKey::HomeGroup, true);
    bench.run(1);
    assert!(bench.is(place::HOMING_GROUP));
    assert_eq!(bench.motion.panel_key(PanelKey::Home(17), true), Ok(()), "asked for, and not found");
    assert_eq!(bench.motion.panel_key(PanelKey::Jog(17), true), Err(Refused::NoSuchAxis));
}
