//! Each element as a drawing: a character is a millisecond, `_` is off, `#` is on.
#![allow(clippy::unwrap_used)] // tests

use technol_machine::{
    BlockExtra, BlockMode, BlockStart, INPUT_PORTS, MachineConfig, OUTPUT_PORTS, Plant, PlantEvent, Signal,
};

fn plant(toml: &str) -> Plant {
    Plant::compile(&toml::from_str(toml).unwrap(), &|name| name.parse().ok()).unwrap()
}

/// Drives outputs as drawn and draws what the inputs did.
fn draw(plant: &mut Plant, drive: &[(&str, &str)], watch: &[&str]) -> Vec<String> {
    let mut inputs = [0; INPUT_PORTS];
    let mut drawn = vec![String::new(); watch.len()];
    for ms in 0..drive[0].1.len() {
        let mut outputs = [0; OUTPUT_PORTS];
        for (name, line) in drive {
            let Ok(Signal::Output { port, bit }) = name.parse() else { panic!("{name}") };
            outputs[usize::from(port)] |= u8::from(line.as_bytes()[ms] == b'#') << bit;
        }
        plant.step(&outputs, &mut inputs);
        for (name, line) in watch.iter().zip(&mut drawn) {
            let Ok(Signal::Input { port, bit }) = name.parse() else { panic!("{name}") };
            line.push(if inputs[usize::from(port)] >> bit & 1 != 0 { '#' } else { '_' });
        }
    }
    drawn
}

#[test]
fn a_contact_follows_its_output_after_the_delays() {
    let toml = "[[contact]]\noutput='P0OUT.0'\ninput='P1IN.3'\non-delay-ms=3\noff-delay-ms=2";
    let drive = "__######______##____";
    let input = "_____#####__________"; // the short pulse is over before the contact moves
    assert_eq!(draw(&mut plant(toml), &[("P0OUT.0", drive)], &["P1IN.3"]), [input]);
}

#[test]
fn a_normally_closed_contact_without_delay_is_the_opposite_of_its_output() {
    let toml = "[[contact]]\noutput='P0OUT.7'\ninput='P128IN.7'\ninvert=true";
    let drive = "__##__";
    let input = "##__##";
    assert_eq!(draw(&mut plant(toml), &[("P0OUT.7", drive)], &["P128IN.7"]), [input]);
}

#[test]
fn a_moving_element_reaches_its_ends_after_its_travel() {
    let toml = "[[limit]]\noutput-forward='P0OUT.0'\noutput-backward='P0OUT.1'\ntravel-ms=4\nreturn-ms=2\n\
                input-at-start='P1IN.0'\ninput-at-end='P1IN.1'";
    let forward__ = "__######__##__##__";
    let back_____ = "________#_##_#__##"; // both at once: it stands still
    let at_start_ = "##___________#__##";
    let at_end___ = "_____###__________";
    let drive = [("P0OUT.0", forward__), ("P0OUT.1", back_____)];
    assert_eq!(draw(&mut plant(toml), &drive, &["P1IN.0", "P1IN.1"]), [at_start_, at_end___]);
}

#[test]
fn without_a_second_output_a_spring_brings_it_back() {
    let toml = "[[limit]]\noutput-forward='P0OUT.0'\ntravel-ms=3\ninput-at-start='P1IN.0'\ninput-at-end='P1IN.1'\n\
                initially='end'";
    let forward__ = "####_________##___";
    let at_start_ = "______#######___##"; // two milliseconds forward take two back
    let at_end___ = "####______________";
    let drawn = draw(&mut plant(toml), &[("P0OUT.0", forward__)], &["P1IN.0", "P1IN.1"]);
    assert_eq!(drawn, [at_start_, at_end___]);
}

#[test]
fn an_encoder_pulses_and_counts_both_ways() {
    let toml = "[[encoder]]\noutput='P0OUT.0'\ninput='P5IN.0'\nperiod-ms=4\ndirection='P0OUT.1'\n\
                position=['P6IN','P7IN']";
    let mut plant = plant(toml);
    let turning = "__#########__##____";
    let pulses_ = "__##__##__####_____"; // it keeps its level where it stops
    assert_eq!(draw(&mut plant, &[("P0OUT.0", turning)], &["P5IN.0"]), [pulses_]);
    let mut inputs = [0; INPUT_PORTS];
    plant.step(&[0; OUTPUT_PORTS], &mut inputs);
    assert_eq!(inputs[5..7], [3, 0], "three pulses began");
    let mut outputs = [0; OUTPUT_PORTS];
    outputs[0] = 0b11;
    for _ in 0..17 {
        plant.step(&outputs, &mut inputs);
    }
    assert_eq!(inputs[5..7], [0xFF, 0xFF], "four back from three is one before zero");
}

#[test]
fn a_turret_shows_its_station_in_bcd_and_strobes() {
    let toml = "[[turret]]\nstations=12\nmotor='P0OUT.0'\nmotor-reverse='P0OUT.1'\nstation-ms=4\ninitially=8\n\
                code=['P3IN.0','P3IN.1','P3IN.2','P3IN.3','P3IN.4']\nstrobe='P3IN.7'\nstrobe-ms=2";
    let mut plant = plant(toml);
    let motor__ = "_########";
    let strobe_ = "##__##__#";
    assert_eq!(draw(&mut plant, &[("P0OUT.0", motor__)], &["P3IN.7"]), [strobe_]);
    let mut inputs = [0; INPUT_PORTS];
    let mut outputs = [0; OUTPUT_PORTS];
    let mut seen = Vec::new();
    outputs[0] = 0b01;
    for _ in 0..24 {
        plant.step(&outputs, &mut inputs);
        let code = inputs[2] & 0x1F;
        if inputs[2] & 0x80 != 0 && seen.last() != Some(&code) {
            seen.push(code);
        }
    }
    assert_eq!(seen, [0x10, 0x11, 0x12, 0x01, 0x02, 0x03, 0x04]);
    outputs[0] = 0b10;
    for _ in 0..8 {
        plant.step(&outputs, &mut inputs);
    }
    assert_eq!(inputs[2] & 0x1F, 0x02, "two stations back");
}

#[test]
fn the_station_after_the_last_is_the_first() {
    let toml = "[[turret]]\nstations=11\nmotor='P0OUT.0'\nstation-ms=2\ninitially=9\nstrobe-ms=1\n\
                code=['P3IN.0','P3IN.1','P3IN.2','P3IN.3','P3IN.4']";
    let drawn = draw(
        &mut plant(toml),
        &[("P0OUT.0", "_######")],
        &["P3IN.4", "P3IN.3", "P3IN.2", "P3IN.1", "P3IN.0"],
    );
    //                  9 9 10 10 11 11 1
    assert_eq!(drawn, ["__####_", "##_____", "_______", "_______", "##__###"].map(String::from));
}

#[test]
fn keys_and_faults_are_switched_by_name() {
    let toml = "[[key]]\nname='start'\ninput='P2IN.0'\n[[key]]\nname='stop'\ninput='P2IN.1'\ninvert=true\n\
                [[contact]]\noutput='P0OUT.0'\ninput='P1IN.0'\n\
                [[fault]]\nname='stuck'\ninput='P1IN.0'\nstuck=true\n\
                [[fault]]\nname='broken'\noutput='P0OUT.0'\nbroken=true\nactive=true";
    let mut plant = plant(toml);
    let look = |plant: &mut Plant| draw(plant, &[("P0OUT.0", "#")], &["P2IN.0", "P2IN.1", "P1IN.0"]).concat();
    assert_eq!(look(&mut plant), "_#_", "the output is broken from the start");
    plant.set_fault("broken", false).unwrap();
    assert_eq!(look(&mut plant), "_##");
    plant.press("start", true).unwrap();
    plant.press("stop", true).unwrap();
    plant.set_fault("broken", true).unwrap();
    plant.set_fault("stuck", true).unwrap();
    assert_eq!(look(&mut plant), "#_#");
    plant.start(true);
    assert_eq!(plant.faults().collect::<Vec<_>>(), [("stuck", true), ("broken", true)]);
    assert_eq!(plant.keys().collect::<Vec<_>>(), [("start", true), ("stop", true)]);
    let unknown = plant.press("halt", true).unwrap_err();
    assert_eq!(unknown.to_string(), "`halt` is not known; there is start, stop");
}

#[test]
fn blocks_start_in_their_cycle_or_on_a_rising_edge() {
    let toml = "[[key]]\nname='go'\ninput='P2IN.1'\n\
                [[block]]\nat-cycle=2\nm=[3]\ns=1200\nmotion-ms=400\n[[block]]\nm=[5]\nmode='reference'\n\
                [[block]]\non='P2IN.1'\nt=7\n";
    let mut plant = plant(toml);
    let mut inputs = [0; INPUT_PORTS];
    let mut seen = Vec::new();
    for ms in 0..200_u32 {
        match ms {
            60 | 100 => plant.press("go", true).unwrap(),
            80 => plant.press("go", false).unwrap(),
            _ => {}
        }
        plant.step(&[0; OUTPUT_PORTS], &mut inputs);
        while let Some(event) = plant.next_event() {
            let PlantEvent::StartBlock(block) = event else { panic!("{event:?}") };
            seen.push((ms, block));
        }
    }
    let block = |m: &[u8], mode| BlockStart { m: m.to_vec(), mode, ..BlockStart::default() };
    let place = |first, last| BlockExtra { first, last, ..BlockExtra::default() };
    let first = BlockStart {
        s: Some(1200),
        motion_ms: 400,
        extra: place(true, false),
        ..block(&[3], BlockMode::Auto)
    };
    let second = BlockStart { extra: place(false, true), ..block(&[5], BlockMode::Reference) };
    let tool = BlockStart { t: Some(7), extra: place(true, true), ..block(&[], BlockMode::Auto) };
    let [first, second, tool] = [first, second, tool].map(|it| it.block());
    assert_eq!(seen, [(40, first.clone()), (40, second), (60, tool.clone()), (100, tool)]);
    plant.start(false);
    let again = (0..60).find_map(|_| {
        plant.step(&[0; OUTPUT_PORTS], &mut inputs);
        plant.next_event()
    });
    assert_eq!(again, Some(PlantEvent::StartBlock(first)), "at-cycle counts from the start of the PLC");
}

#[test]
fn a_signal_that_is_on_at_the_start_starts_no_block() {
    let mut plant = plant("[[block]]\non='P9IN.0'");
    let mut inputs = [0xFF; INPUT_PORTS];
    plant.step(&[0; OUTPUT_PORTS], &mut inputs);
    assert_eq!(plant.next_event(), None);
}

#[test]
fn a_cold_start_puts_every_element_where_it_was_at_first() {
    let toml = "[[contact]]\noutput='P0OUT.0'\ninput='P1IN.0'\noff-delay-ms=9\n\
                [[limit]]\noutput-forward='P0OUT.0'\noutput-backward='P0OUT.1'\ntravel-ms=2\ninput-at-end='P1IN.1'";
    let mut plant = plant(toml);
    assert_eq!(draw(&mut plant, &[("P0OUT.0", "###")], &["P1IN.0", "P1IN.1"]), ["###", "_##"]);
    plant.start(false);
    assert_eq!(draw(&mut plant, &[("P0OUT.0", "_")], &["P1IN.0", "P1IN.1"]), ["#", "#"]);
    plant.start(true);
    assert_eq!(draw(&mut plant, &[("P0OUT.0", "_")], &["P1IN.0", "P1IN.1"]), ["_", "_"]);
}

#[test]
fn bits_that_no_element_drives_stay_as_they_are() {
    let mut plant = plant("[[contact]]\noutput='P0OUT.0'\ninput='P1IN.0'");
    let mut inputs = [0xFF; INPUT_PORTS];
    plant.step(&[0; OUTPUT_PORTS], &mut inputs);
    assert_eq!(inputs[0], 0xFE);
    assert_eq!(inputs[1..], [0xFF; INPUT_PORTS - 1]);
}

#[test]
fn everything_that_is_wrong_is_named_with_its_place() {
    let toml = "[io]\nfast-inputs=['P5IN','P0OUT']\nfast-outputs=['P99OUT']\nfastest-period-us=300\n\
        [[contact]]\noutput='P1IN.0'\ninput='P1IN.0'\n\
        [[contact]]\noutput='MOTOR'\ninput='P0OUT.0'\n\
        [[contact]]\noutput='P0OUT.1'\ninput='P1IN.0'\n\
        [[limit]]\noutput-forward='P0OUT.0'\ntravel-ms=0\n\
        [[encoder]]\noutput='P0OUT.0'\nperiod-ms=1\nposition=['P1IN']\n\
        [[turret]]\nstations=12\nmotor='P0OUT.0'\nstation-ms=100\nstrobe-ms=100\ninitially=13\n\
        code=['P3IN.0','P3IN.1','P3IN.2','P3IN.3']\n\
        [[key]]\nname='a'\ninput='P4IN.0'\n[[key]]\nname='a'\ninput='P4IN.1'\n\
        [[fault]]\nname=''\ninput='P1IN.0'\n\
        [[fault]]\nname='x'\noutput='P0OUT.0'\nbroken=false\n\
        [[block]]\nm=[100]\n[[block]]\nat-cycle=1\non='P1IN.0'\n[[block]]\non='X'";
    let config: MachineConfig = toml::from_str(toml).unwrap();
    let errors = Plant::compile(&config, &|name| name.parse().ok()).unwrap_err();
    let errors: Vec<_> = errors.iter().map(ToString::to_string).collect();
    let expected = [
        "contact[0].output: `P1IN.0` is an input; an output of the PLC is needed, such as P0OUT.0",
        "contact[1].output: `MOTOR` is not a bit of a port; use P1IN.0 to P128IN.7 or P0OUT.0 to P95OUT.7",
        "contact[1].input: `P0OUT.0` is an output; an input of the PLC is needed, such as P1IN.0",
        "contact[2].input: P1IN.0 is driven by contact[0].input already; an input has one source",
        "limit[0]: needs `input-at-start` or `input-at-end`, else nothing can be seen of it",
        "limit[0].travel-ms: must be at least 1",
        "encoder[0].position: P1IN.0 is driven by contact[0].input already; an input has one source",
        "encoder[0].period-ms: must be at least 2",
        "turret[0].code: needs 5 bits for 12 stations in BCD",
        "turret[0].initially: must be 1 to 12",
        "turret[0].strobe-ms: must be at least 1 and less than `station-ms`",
        "key[1].name: `a` is used twice; names must differ",
        "fault[0].name: must not be empty; it is how this is switched",
        "fault[0]: needs one of: `input` with `stuck = true` or `false` or with `broken = true`; `output` with `broken = true` or `shorted = true`; `element` with `stuck`, `jammed = true` or `slow`; `slave` \
         with `lost = true`, `cut = true` or `error`; `can-drive` with `lost = true` or `error`; `can` with `cut = true`",
        "fault[1]: needs one of: `input` with `stuck = true` or `false` or with `broken = true`; `output` with `broken = true` or `shorted = true`; `element` with `stuck`, `jammed = true` or `slow`; `slave` \
         with `lost = true`, `cut = true` or `error`; `can-drive` with `lost = true` or `error`; `can` with `cut = true`",
        "block[0].m: M functions go from 0 to 99",
        "block[0]: the first block needs `at-cycle` or `on`",
        "block[1].on: cannot be combined with `at-cycle`",
        "block[2].on: `X` is not a bit of a port; use P1IN.0 to P128IN.7 or P0OUT.0 to P95OUT.7",
        "io.fast-inputs: `P0OUT` is not an input port; use P1IN to P128IN",
        "io.fast-outputs: `P99OUT` is not an output port; use P0OUT to P95OUT",
        "io.fastest-period-us: 300 µs is no period of MODULE_FASTEST; use 100, 200, 250, 500 or 1000",
    ];
    assert_eq!(errors, expected);
}

#[test]
fn an_unknown_key_is_an_error_that_names_it() {
    let error = toml::from_str::<MachineConfig>("[[contact]]\noutput='P0OUT.0'\ninput='P1IN.0'\ndelay=3")
        .unwrap_err();
    assert!(error.message().contains("unknown field `delay`"), "{error}");
}

#[test]
fn several_outputs_may_drive_one_element() {
    let toml = "[[contact]]\noutput=['P0OUT.0','P0OUT.1']\ninput='P1IN.0'";
    let clockwise = "_##___#_";
    let counter__ = "____###_";
    let input____ = "_##_###_";
    let drive = [("P0OUT.0", clockwise), ("P0OUT.1", counter__)];
    assert_eq!(draw(&mut plant(toml), &drive, &["P1IN.0"]), [input____]);
}
