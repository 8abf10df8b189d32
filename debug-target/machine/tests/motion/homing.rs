//! Reference runs and the positioning of spindles: the order of the bits, and where the zero comes to lie.

use technol_image::op::BitRef;
use technol_image::system::{self, motion as place};
use technol_machine::motion::{Hold, SpiAx};

use crate::support::{Bench, bit};

/// What a reference run of axis 1 shows, with its switches on port 3 and how long it may take.
fn run(toml: &str, millis: u32, step: u32) -> (String, Bench) {
    let mut bench = Bench::new(toml)
        .wire("P3IN.0", place::REFERENCE_SWITCH.of(0))
        .wire("P3IN.1", place::REVERSING_SWITCH.of(0))
        .wire("P3IN.2", place::SLOW_DOWN_SWITCH.of(0))
        .wire("P3IN.3", place::SERVO_SWITCH)
        .wire("P3IN.4", bit(place::SERVO_SWITCH.addr, 3));
    let watch = [
        ("HOMING_START_REQ", bit(place::HOMING_START_REQ, 0)),
        ("REFPI", system::REFPI),
        ("PO_OSXPI", place::REQUESTED.of(0)),
        ("SM_POXPI", place::NEGATIVE.of(0)),
        ("ZPRX", place::SLOW_DOWN_SWITCH.of(0)),
        ("KRRX", place::REVERSING_SWITCH.of(0)),
        ("KRX", place::REFERENCE_SWITCH.of(0)),
        ("REF_SERV_1", place::SERVO_SWITCH),
        ("REF_SERV_4", bit(place::SERVO_SWITCH.addr, 3)),
        ("HOMING", bit(place::HOMING, 0)),
        ("SLS_REFER", bit(place::SLS_REFER, 0)),
    ];
    let used: Vec<(&str, BitRef)> = watch
        .into_iter()
        .filter(|(name, _)| match *name {
            "ZPRX" => toml.contains("P3IN.2"),
            "KRRX" => toml.contains("P3IN.1"),
            "KRX" => toml.contains("P3IN.0"),
            "REF_SERV_1" | "REF_SERV_4" => toml.contains("P3IN.4"),
            _ => true,
        })
        .collect();
    let drawn = bench.draw(millis, step, &used, |bench, ms| {
        if ms == 40 {
            bench.set(bit(place::HOMING, 0), true); // the old one
            bench.set(bit(place::HOMING_START_REQ, 0), true);
        }
    });
    (drawn, bench)
}

/// The coordinate that the place 0 of the machine has got, µm.
fn zero(bench: &mut Bench) -> f64 {
    bench.position(1, 5) - bench.motion.place(1, None).unwrap()
}

const FAST: &str = "[[axis]]\nnumber=1\nref-speed=6000\nref-speed-low=1200\nacceleration-rapid=1000\n";

#[test]
fn method_9_slows_down_then_sees_the_switch_then_takes_the_next_pulse() {
    let toml = format!(
        "{FAST}slow-down-switch=true\npulse-at=3\nmachine-null-point=200\nafter-ref='relative'\npos-after-ref=-12\n\
         switch=[{{input='P3IN.2',from=40,to=80}},{{input='P3IN.0',from=60,to=90}}]"
    );
    let (drawn, mut bench) = run(&toml, 2000, 25);
    insta::assert_snapshot!(drawn, @r"
    HOMING_START_REQ _##################################################################_____________
    REFPI            _##################################################################_____________
    PO_OSXPI         _##################################################################_____________
    SM_POXPI         __________________________________________________________######################
    ZPRX             ____________________############################################################
    KRX              ____________________________________________________##########__________________
    HOMING           ___________________________________________________________________#############
    SLS_REFER        ___________________________________________________________________#############
    ");
    assert!((zero(&mut bench) - (200_000.0 - 63_000.0)).abs() < 0.01, "the pulse at 63 mm is 200 mm");
    assert_eq!(bench.position(1, 0), 188_000.0, "12 mm back from the mark");
}

#[test]
fn method_9_turns_back_on_the_reversing_switch() {
    let toml = format!(
        "{FAST}start=50\nafter-ref='absolute'\npos-after-ref=5\n\
         switch=[{{input='P3IN.1',from=90}},{{input='P3IN.0',to=31}}]"
    );
    let (drawn, mut bench) = run(&toml, 2600, 40);
    insta::assert_snapshot!(drawn, @r"
    HOMING_START_REQ _###########################################_____________________
    REFPI            _###########################################_____________________
    PO_OSXPI         _###########################################_____________________
    SM_POXPI         _______________#########################_________________________
    KRRX             ____________######_______________________________________________
    KRX              _________________________________################################
    HOMING           ____________________________________________#####################
    SLS_REFER        ____________________________________________#####################
    ");
    assert!(
        (zero(&mut bench) + 20_000.0).abs() < 0.01,
        "negative direction: the pulse at 20 mm: {}",
        zero(&mut bench)
    );
    assert_eq!(bench.position(1, 0), 5000.0);
}

#[test]
fn an_edge_of_the_switch_is_waited_for_and_a_level_is_not() {
    for (test, pulse) in [("edge", 90.0), ("level", 10.0), ("none", 10.0)] {
        let toml = format!(
            "{FAST}ref-switch='{test}'\nswitch=[{{input='P3IN.0',to=20}},{{input='P3IN.5',from=80}}]"
        );
        let mut bench = Bench::new(&toml)
            .wire("P3IN.0", place::REFERENCE_SWITCH.of(0))
            .wire("P3IN.5", place::REFERENCE_SWITCH.of(1));
        bench.run(20);
        bench.set(bit(place::HOMING_START_REQ, 0), true);
        for _ in 0..4000 {
            bench.tick();
            // The second switch stands for the first on the far side.
            if bench.is(place::REFERENCE_SWITCH.of(1)) {
                bench.set(place::REFERENCE_SWITCH.of(0), true);
            }
        }
        let found = -zero(&mut bench) / 1000.0;
        assert!(bench.is(bit(place::HOMING, 0)), "{test}");
        assert!((found - pulse).abs() < 0.01, "{test}: {found}");
    }
}

#[test]
fn method_10_turns_back_on_the_switch_and_takes_its_end() {
    let toml = format!(
        "{FAST}ref-method=10\ninvert-ref-direction=true\nmachine-null-point=-7\nafter-ref='relative'\npos-after-ref=20\n\
         switch=[{{input='P3IN.0',to=-50}}]"
    );
    let (drawn, mut bench) = run(&toml, 2000, 25);
    insta::assert_snapshot!(drawn, @r"
    HOMING_START_REQ _####################################################___________________________
    REFPI            _####################################################___________________________
    PO_OSXPI         _####################################################___________________________
    SM_POXPI         _###########################____________________________________________________
    KRX              ________________________################________________________________________
    HOMING           _____________________________________________________###########################
    SLS_REFER        _____________________________________________________###########################
    ");
    // The switch goes off at -50 mm; the program looks every 20 ms, in which the axis goes 0.4 mm.
    let mark = -7000.0 - zero(&mut bench);
    assert!((-50_000.0..=-49_500.0).contains(&mark), "{mark}");
    assert!((bench.position(1, 0) - 13_000.0).abs() < 0.01);
}

#[test]
fn method_11_takes_the_switch_as_it_comes() {
    let toml = format!(
        "{FAST}ref-method=11\nslow-down-switch=true\n\
         switch=[{{input='P3IN.2',from=30,to=45}},{{input='P3IN.0',from=50}}]"
    );
    let (drawn, mut bench) = run(&toml, 1400, 25);
    insta::assert_snapshot!(drawn, @r"
    HOMING_START_REQ _###############################################________
    REFPI            _###############################################________
    PO_OSXPI         _###############################################________
    SM_POXPI         ________________________________________________________
    ZPRX             ________________######################__________________
    KRX              ________________________________________________########
    HOMING           ________________________________________________########
    SLS_REFER        ________________________________________________########
    ");
    let mark = -zero(&mut bench);
    assert!((50_000.0..=50_500.0).contains(&mark), "{mark}");
}

/// Two servo loops with switches 8 mm apart. Each stands in the end where its own switch went off, and both count as
/// being at the same position.
fn level(method: u8) -> String {
    let toml = format!(
        "{FAST}ref-method={method}\nservos=[1,4]\n\
         switch=[{{input='P3IN.3',from=50,servo=1}},{{input='P3IN.4',from=58,servo=4}}]"
    );
    let (drawn, mut bench) = run(&toml, 2000, 25);
    let [one, four] = [1, 4].map(|servo| bench.motion.place(1, Some(servo)).unwrap());
    assert!((four - one - 8000.0).abs() < 500.0, "{method}: {one} {four}");
    let measured = [0, 12].map(|at| bench.cells().dword(place::SERVO_MEASURED + at));
    assert_eq!(measured[0], measured[1], "{method}");
    drawn
}

#[test]
fn method_12_levels_the_servo_loops_of_an_axis_on_the_way_back() {
    insta::assert_snapshot!(level(12), @r"
    HOMING_START_REQ _###########################################################____________________
    REFPI            _###########################################################____________________
    PO_OSXPI         _###########################################################____________________
    SM_POXPI         _______________________________#################################################
    REF_SERV_1       ________________________####################################____________________
    REF_SERV_4       ___________________________#################____________________________________
    HOMING           ____________________________________________________________####################
    SLS_REFER        ____________________________________________________________####################
    ");
}

#[test]
fn method_15_lets_each_servo_loop_wait_on_its_switch() {
    insta::assert_snapshot!(level(15), @r"
    HOMING_START_REQ _###########################################____________________________________
    REFPI            _###########################################____________________________________
    PO_OSXPI         _###########################################____________________________________
    SM_POXPI         _______________________________#################################################
    REF_SERV_1       ________________________####################____________________________________
    REF_SERV_4       ___________________________#################____________________________________
    HOMING           ____________________________________________####################################
    SLS_REFER        ____________________________________________####################################
    ");
}

#[test]
fn methods_13_and_14_need_no_movement() {
    let mut bench = Bench::new(
        "[[axis]]\nnumber=1\nstart=30\nref-method=13\nmachine-null-point=5\n\
         [[axis]]\nnumber=2\nstart=30\nref-method=14\nmachine-null-point=5\n\
         [[axis]]\nnumber=3\nstart=30\nref-method=14\ninvert-ref-direction=true\n",
    );
    bench.cells().set_word(place::HOMING_START_REQ, 0b111);
    bench.run(3);
    assert_eq!(bench.cells().word(place::HOMING), 0b111);
    assert_eq!(bench.cells().word(place::HOMING_START_REQ), 0);
    assert_eq!([1, 2, 3].map(|axis| bench.position(axis, 5)), [5000.0, 35_000.0, -30_000.0]);
    assert_eq!([1, 2, 3].map(|axis| bench.motion.place(axis, None).unwrap()), [30_000.0; 3]);
}

#[test]
fn method_5_knows_its_place_after_two_pulses() {
    let mut bench =
        Bench::new(&format!("{FAST}ref-method=5\nstart=42\nmachine-null-point=1\nref-switch='none'"));
    bench.cells().set_word(place::HOMING_START_REQ, 1);
    bench.run(1000);
    assert_eq!(bench.cells().word(place::HOMING), 1);
    let place = bench.motion.place(1, None).unwrap();
    assert!((60_000.0..70_000.0).contains(&place), "two pulses, and the ramp: {place}");
    assert!((zero(&mut bench) - 1000.0).abs() < 0.01);
}

#[test]
fn a_reference_by_the_program_is_asked_for_and_sets_the_zero_on_request() {
    let mut bench = Bench::new("[[axis]]\nnumber=3\nref-method=1\nmachine-null-point=10\nstart=4");
    bench.motion.home(&mut technol_machine::Cells::new(&mut bench.memory), 3).unwrap();
    assert!(bench.is(place::HOMING_SINGLE) && bench.is(place::HOMING_PLC));
    assert_eq!(bench.cells().word(place::HOMING_AXES), 0b100);
    bench.cells().set_qword(place::REFPOINT_DIST + 16, 250 << 16);
    bench.cells().set_word(place::HOMING_REQ, 0b100);
    bench.tick();
    assert_eq!(bench.cells().word(place::HOMING_REQ), 0, "taken");
    for space in 0..=5 {
        assert_eq!(bench.position(3, space), 10_250.0);
    }
    assert_eq!(bench.cells().word(place::HOMING), 0, "the program says when the reference is valid");
    // The control itself cannot make it.
    bench.cells().set_word(place::HOMING_START_REQ, 0b100);
    bench.run(50);
    assert_eq!((bench.cells().word(place::HOMING_START_REQ), bench.cells().word(place::HOMING)), (0, 0));
    assert!(!bench.is(system::REFPI));
}

#[test]
fn references_through_the_program_only_ask() {
    let mut bench =
        Bench::new("[[axis]]\nnumber=1\nref-via-plc=true\nref-method=13\n[[axis]]\nnumber=2\nref-method=13");
    let mut memory = bench.memory.clone();
    let mut cells = technol_machine::Cells::new(&mut memory);
    bench.motion.home(&mut cells, 1).unwrap();
    assert!(cells.bit(place::HOMING_SINGLE) && !cells.bit(place::HOMING_PLC));
    bench.motion.home(&mut cells, 2).unwrap();
    bench.motion.home_by_program(&mut cells, 0b101);
    assert!(cells.bit(place::HOMING_PLC) && cells.word(place::HOMING_AXES) == 0b101);
    bench.motion.home_group(&mut cells);
    assert!(cells.bit(place::HOMING_GROUP));
    bench.memory = memory;
    bench.run(3);
    assert_eq!(bench.cells().word(place::HOMING), 0b10, "only axis 2 is made by the control");
}

#[test]
fn a_pseudo_reference_is_zero_here_without_software_limits() {
    let mut bench = Bench::new("");
    bench.cells().set_word(place::SLS_REFER, 0b11);
    bench.cells().set_word(place::NLC_AXIS_ENABLE, 0b11);
    bench.motion.pseudo_reference(&mut technol_machine::Cells::new(&mut bench.memory), 1).unwrap();
    bench.tick();
    let words = [place::HOMING, place::SLS_REFER, place::NLC_AXIS_ENABLE].map(|at| bench.cells().word(at));
    assert_eq!(words, [0b01, 0b10, 0b10]);
    bench.motion.simulate_reference(&mut technol_machine::Cells::new(&mut bench.memory), 1, false).unwrap();
    assert_eq!(bench.cells().word(place::HOMING), 0);
}

#[test]
fn a_run_waits_for_its_enable_and_for_an_axis_that_the_program_holds() {
    let mut bench = Bench::new(&format!("{FAST}ref-switch='none'"));
    bench.init(1).unwrap();
    bench.cells().set_word(place::HOMING_START_REQ, 1);
    bench.run(100);
    assert!(!bench.is(system::REFPI));
    bench.reset(1);
    bench.set(place::ENABLE.of(0), false);
    bench.run(100);
    assert!(bench.is(system::REFPI) && bench.is(place::REQUESTED.of(0)));
    assert_eq!(bench.motion.place(1, None), Some(0.0));
    bench.set(place::ENABLE.of(0), true);
    bench.motion.set_overrides(50, 100); // counts in the run
    bench.run(3000);
    assert_eq!(bench.cells().word(place::HOMING), 1);
}

#[test]
fn central_annulment_ends_a_run_without_reference() {
    let mut bench = Bench::new(FAST);
    bench.cells().set_word(place::HOMING_START_REQ, 1);
    bench.run(100);
    bench.motion.annul(&mut technol_machine::Cells::new(&mut bench.memory));
    bench.run(300);
    assert!(!bench.is(system::REFPI) && !bench.is(place::REQUESTED.of(0)));
    assert_eq!((bench.cells().word(place::HOMING_START_REQ), bench.cells().word(place::HOMING)), (0, 0));
}

const SPINDLE: &str = "[[axis]]\nnumber=4\npulse-distance=90\nacceleration=1000\nref-switch='none'\n\
                       ref-speed-low=3600\nmachine-null-point=1\n\
                       [[spindle]]\nnumber=1\naxis=4\ngear=[{max-speed=1000}]\n";

#[test]
fn a_spindle_goes_over_its_zero_pulse_stops_and_turns_by_the_angle() {
    let mut bench = Bench::new(SPINDLE);
    let watch = [
        ("VAZBA_4", place::LOOP_CLOSED.of(3)),
        ("POLOHV_4", place::ORIENTING.of(3)),
        ("PO_OS4PI", place::REQUESTED.of(3)),
        ("SM_PO4PI", place::NEGATIVE.of(3)),
        ("HOMING.B3", bit(place::HOMING, 3)),
    ];
    let drawn = bench.draw(1600, 25, &watch, |bench, ms| {
        let mut cells = technol_machine::Cells::new(&mut bench.memory);
        match ms {
            50 => bench.motion.ax_spi(&mut cells, 4, None).unwrap(),
            75 => bench.motion.analog_spi(0x7FFF / 50, 4).unwrap(), // 20 rev/min
            500 => {
                let angle = Some(-9000); // counts from the pulse, behind which it stops
                let operands = SpiAx { angle, ..SpiAx::default() };
                bench.motion.spi_ax(&mut cells, operands).unwrap();
            }
            _ => {}
        }
    });
    insta::assert_snapshot!(drawn, @r"
    VAZBA_4   ##__________________############################################
    POLOHV_4  ____________________#####################################_______
    PO_OS4PI  ____________________#####################################_______
    SM_PO4PI  ________________________________________________################
    HOMING.B3 _________________________________________________________#######
    ");
    assert_eq!(bench.position(4, 0), 1000.0 - 9000.0);
}

#[test]
fn the_positioning_of_a_spindle_ends_early_for_four_reasons() {
    let reasons: [fn(&mut Bench); 4] = [
        |b| b.set(place::ORIENTING.of(3), false),
        |b| b.motion.hold(Hold::Stop),
        |b| b.set(place::ENABLE.of(3), false),
        |b| b.set(place::LIMIT_MINUS.of(3), true),
    ];
    for reason in reasons {
        let mut bench = Bench::new(SPINDLE);
        let operands = SpiAx { axis: Some(4), ..SpiAx::default() };
        bench.motion.spi_ax(&mut technol_machine::Cells::new(&mut bench.memory), operands).unwrap();
        bench.run(100);
        assert!(bench.is(place::ORIENTING.of(3)) && bench.is(place::REQUESTED.of(3)));
        reason(&mut bench);
        bench.run(100);
        assert!(!bench.is(place::ORIENTING.of(3)) && !bench.is(place::REQUESTED.of(3)));
        assert_eq!(bench.cells().word(place::HOMING), 0, "no reference");
        assert!(bench.is(place::LOOP_CLOSED.of(3)), "it stays an axis");
    }
}
