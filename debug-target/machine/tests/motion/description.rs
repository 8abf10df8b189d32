//! What `machine.toml` may say about axes and spindles.

use technol_machine::motion::Thousandths;
use technol_machine::{INPUT_PORTS, MachineConfig, Motion, OUTPUT_PORTS, Plant};

fn errors(toml: &str) -> Vec<String> {
    let config: MachineConfig = toml::from_str(toml).unwrap();
    let errors = Plant::compile(&config, &|name| name.parse().ok()).unwrap_err();
    errors.iter().map(ToString::to_string).collect()
}

#[test]
fn everything_that_is_wrong_with_axes_and_spindles_is_named_with_its_place() {
    let toml = "[[contact]]\noutput='P0OUT.0'\ninput='P1IN.0'\n\
        [[axis]]\nnumber=0\nfeed=0\ngain=1001\ngains=[0]\nlimit-minus=5\nlimit-plus=4.5\nref-method=2\nservos=[1,17]\n\
        [[axis]]\nnumber=2\nref-method=10\nref-switch='none'\nlimit-zone=-1\n\
        switch=[{input='P1IN.0',from=1},{input='P1IN.1'},{input='P0OUT.0',to=1},{input='P1IN.2',from=2,to=1,servo=3}]\n\
        [[axis]]\nnumber=2\n\
        [[spindle]]\nnumber=3\nacceleration=0\nport=17\naxis=4\n\
        [[spindle]]\ngear=[{max-speed=100}]\n\
        [[spindle]]\ngear=[{max-speed=0},{max-speed=9,max-output=40000}]\n";
    let expected = [
        "axis[0].number: must be 1 (X) to 16",
        "axis[0].feed: 0.000 must be greater than 0",
        "axis[0].gain: must be 1 to 1000; the loop has a tick of 1 ms",
        "axis[0].gains: needs at most 4 numbers from 1 to 1000",
        "axis[0].limit-minus: 5.000 must be less than `limit-plus`, 4.500",
        "axis[0].ref-method: must be 1, 5 or 9 to 15",
        "axis[0].servos: needs at most 4 numbers from 1 to 16",
        "axis[1].limit-zone: must not be negative",
        "axis[1].ref-switch: method 10 needs the reference switch",
        "axis[1].switch: P1IN.0 is driven by contact[0].input already; an input has one source",
        "axis[1].switch: `P1IN.1` needs `from`, `to` or both",
        "axis[1].switch: `P0OUT.0` is an output; an input of the PLC is needed, such as P1IN.0",
        "axis[1].switch: `P1IN.2`: `from` (2.000) must not be greater than `to` (1.000)",
        "axis[1].switch: `P1IN.2`: servo loop 3 does not belong to this axis",
        "axis[2].number: axis 2 is described twice",
        "spindle[0].number: must be 1 or 2",
        "spindle[0].gear: needs 1 to 32 gears, each with `max-speed`",
        "spindle[0].acceleration: must be at least 1",
        "spindle[0].port: must be 1 to 16",
        "spindle[0].port: cannot be combined with `axis`; a rotary axis has the output of its own number",
        "spindle[2].number: spindle 1 is described twice",
        "spindle[2].gear: `max-speed` must be at least 1 and `max-output` 1 to 32767",
    ];
    assert_eq!(errors(toml), expected);
}

#[test]
fn unknown_keys_and_wrong_values_are_errors_that_say_what_would_be_right() {
    for (toml, message) in [
        ("[[axis]]\nnumber=1\nspeed=3", "unknown field `speed`"),
        ("[[axis]]\nnumber=1\nswitch=[{input='P1IN.0',at=3}]", "unknown field `at`"),
        ("[[spindle]]\ngear=[{max=3}]", "unknown field `max`"),
        ("[[axis]]\nfeed='fast'", "expected a number from -1000000000 to 1000000000, such as 12.5"),
        ("[[axis]]\nfeed=1e12", "expected a number from -1000000000 to 1000000000, such as 12.5"),
        ("[[axis]]\nfeed=nan", "expected a number from -1000000000 to 1000000000, such as 12.5"),
        ("[[axis]]\nref-switch='high'", "unknown variant `high`, expected one of `none`, `edge`, `level`"),
    ] {
        let error = toml::from_str::<MachineConfig>(toml).unwrap_err();
        assert!(error.message().contains(message), "{toml}: {error}");
    }
}

#[test]
fn numbers_are_kept_to_the_thousandth() {
    let config: MachineConfig = toml::from_str("[[axis]]\nstart=-0.125\nfeed=12\npulse-at=1.0005").unwrap();
    let axis = &config.axis[0];
    assert_eq!(
        [axis.start, axis.feed, axis.pulse_at],
        [Thousandths(-125), Thousandths(12_000), Thousandths(1001)]
    );
    assert_eq!(axis.start.to_string(), "-0.125");
}

#[test]
fn switches_follow_the_position_of_their_axis() {
    let toml = "[[axis]]\nnumber=1\nstart=1\n\
                switch=[{input='P1IN.0',from=1,to=2},{input='P1IN.1',to=1.5},{input='P1IN.2',from=1.2,invert=true}]\n\
                [[fault]]\nname='stuck'\ninput='P1IN.1'\nstuck=true\n";
    let config: MachineConfig = toml::from_str(toml).unwrap();
    let mut plant = Plant::compile(&config, &|name| name.parse().ok()).unwrap();
    let mut motion = Motion::new(&config);
    let mut memory = vec![0; technol_image::system::LEN as usize];
    let mut cells = technol_machine::Cells::new(&mut memory);
    cells.set_axes(technol_image::system::motion::ENABLE, 1);
    cells.set_axes(technol_image::system::motion::LOOP_CLOSED, 1);
    cells.set_word(technol_image::system::motion::FEED_MULTIPLIER, 1000);
    let mut inputs = [0; INPUT_PORTS];
    let mut look = |plant: &mut Plant, motion: &Motion| {
        plant.place_axes(motion);
        plant.step(&[0; OUTPUT_PORTS], &mut inputs);
        inputs[0]
    };
    assert_eq!(look(&mut plant, &motion), 0b111);
    let block = technol_machine::motion::BlockMove::at_feed(&[(1, 1500.0)], 600.0);
    motion.begin_block(&mut cells, &block).unwrap();
    motion.release_block();
    (0..500).for_each(|_| motion.tick_ms(&mut cells));
    assert_eq!(look(&mut plant, &motion), 0b000, "at 2.5 mm");
    plant.set_fault("stuck", true).unwrap();
    assert_eq!(look(&mut plant, &motion), 0b010);
}
