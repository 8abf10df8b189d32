//! Latches, counters, ramps and slides as drawings: a character is a millisecond, `_` is off, `#` is on.
#![allow(clippy::unwrap_used)] // tests

use technol_machine::{INPUT_PORTS, MachineConfig, OUTPUT_PORTS, Plant, PlantEvent, Signal};

fn plant(toml: &str) -> Plant {
    Plant::compile(&toml::from_str(toml).unwrap(), &|name| name.parse().ok()).unwrap()
}

/// A machine, and the inputs as they are now.
struct Bench {
    plant: Plant,
    inputs: [u8; INPUT_PORTS],
}

impl Bench {
    fn of(toml: &str) -> Bench {
        Bench { plant: plant(toml), inputs: [0; INPUT_PORTS] }
    }

    /// Drives outputs and inputs as drawn and draws what the watched inputs did.
    fn draw(&mut self, drive: &[(&str, &str)], watch: &[&str]) -> Vec<String> {
        let mut drawn = vec![String::new(); watch.len()];
        for ms in 0..drive[0].1.len() {
            let mut outputs = [0; OUTPUT_PORTS];
            for (name, line) in drive {
                let on = line.as_bytes()[ms] == b'#';
                match name.parse().unwrap() {
                    Signal::Output { port, bit } => outputs[usize::from(port)] |= u8::from(on) << bit,
                    Signal::Input { port, bit } => {
                        let byte = &mut self.inputs[usize::from(port)];
                        *byte = *byte & !(1 << bit) | u8::from(on) << bit;
                    }
                }
            }
            self.plant.step(&outputs, &mut self.inputs);
            for (name, line) in watch.iter().zip(&mut drawn) {
                let Ok(Signal::Input { port, bit }) = name.parse() else { panic!("{name}") };
                line.push(if self.inputs[usize::from(port)] >> bit & 1 != 0 { '#' } else { '_' });
            }
        }
        drawn
    }

    /// A number in these bytes of the inputs.
    fn number(&self, ports: std::ops::Range<usize>) -> u32 {
        self.inputs[ports].iter().rev().fold(0, |number, byte| number << 8 | u32::from(*byte))
    }
}

fn errors(toml: &str) -> Vec<String> {
    let config: MachineConfig = toml::from_str(toml).unwrap();
    let errors = Plant::compile(&config, &|name| name.parse().ok()).unwrap_err();
    errors.iter().map(ToString::to_string).collect()
}

#[test]
fn a_latch_holds_itself_until_it_is_reset() {
    let toml = "[[latch]]\nset='P0OUT.0'\nreset=['P0OUT.1','P9IN.0']\ninput='P1IN.0'\n\
                [[latch]]\nset='P0OUT.0'\nreset='P0OUT.1'\ninput='P1IN.1'\ninvert=true\ninitially=true";
    let set____ = "__#______#__##___";
    let reset__ = "_____#_______#___"; // both at once: reset
    let by_hand = "___________#_____";
    let latch__ = "__###____##_#____";
    let inverse = "_____####____####"; // set at first
    let drive = [("P0OUT.0", set____), ("P0OUT.1", reset__), ("P9IN.0", by_hand)];
    assert_eq!(Bench::of(toml).draw(&drive, &["P1IN.0", "P1IN.1"]), [latch__, inverse]);
}

#[test]
fn an_input_that_another_element_drives_counts_a_millisecond_later() {
    let toml = "[[latch]]\nset='P1IN.1'\nreset='P0OUT.7'\ninput='P1IN.0'\n\
                [[contact]]\noutput='P0OUT.0'\ninput='P1IN.1'";
    let output_ = "__#___";
    let contact = "__#___";
    let latch__ = "___###";
    assert_eq!(Bench::of(toml).draw(&[("P0OUT.0", output_)], &["P1IN.1", "P1IN.0"]), [contact, latch__]);
}

#[test]
fn a_counter_is_on_from_its_last_pulse_until_it_is_reset() {
    let toml = "[[counter]]\npulses='P0OUT.0'\ncount=2\ninput='P1IN.0'\nreset='P0OUT.1'\nvalue=['P2IN']";
    let pulses_ = "_#_##_#_______#_#_";
    let reset__ = "_________#____#___"; // a pulse while it is reset does not count
    let reached = "___######_________";
    let mut bench = Bench::of(toml);
    assert_eq!(bench.draw(&[("P0OUT.0", pulses_), ("P0OUT.1", reset__)], &["P1IN.0"]), [reached]);
    assert_eq!(bench.number(1..2), 1);
}

#[test]
fn without_a_reset_the_counter_begins_anew() {
    let toml = "[[counter]]\npulses='P0OUT.0'\ncount=3\ninput='P1IN.0'";
    let pulses_ = "#_#_#_#_#_#_#_#_#_"; // on at the start: no pulse
    let reached = "______##____##____";
    assert_eq!(Bench::of(toml).draw(&[("P0OUT.0", pulses_)], &["P1IN.0"]), [reached]);
}

#[test]
fn a_ramp_follows_its_output_at_its_speeds() {
    // 1000 a second is 1 in a millisecond.
    let toml = "[[ramp]]\noutput='P0OUT.0'\nlow=10\nhigh=15\nrise-per-s=1000\nfall-per-s=2000.0\nvalue=['P2IN','P3IN']\n\
                thresholds=[{at=12,input='P1IN.0'},{at=15,hysteresis=3,input='P1IN.1',invert=true}]";
    let heating = "__######_____###__";
    // 10 10 11 12 13 14 15 15 13 11 10 10 10 11 12 13 11 10
    let from_12 = "___######_____##__";
    let not_15_ = "######___#########"; // off from 15 on, on again below 12
    let mut bench = Bench::of(toml);
    assert_eq!(bench.draw(&[("P0OUT.0", heating)], &["P1IN.0", "P1IN.1"]), [from_12, not_15_]);
    assert_eq!(bench.number(1..3), 10);
}

#[test]
fn a_ramp_follows_the_number_in_its_ports_within_its_range() {
    let toml = "[[ramp]]\nsource=['P4OUT','P5OUT']\nhigh=1000\nrise-per-s=500\nfall-per-s=0.5\nvalue=['P2IN','P3IN']\ninitially=1";
    let mut bench = Bench::of(toml);
    let mut outputs = [0; OUTPUT_PORTS];
    outputs[5] = 0x03;
    let run = |bench: &mut Bench, outputs: &[u8; OUTPUT_PORTS], ms: u32| {
        for _ in 0..ms {
            bench.plant.step(outputs, &mut bench.inputs);
        }
        bench.number(1..3)
    };
    assert_eq!(run(&mut bench, &outputs, 10), 6);
    assert_eq!(run(&mut bench, &outputs, 3000), 768, "the target");
    outputs[5] = 0xFF;
    assert_eq!(run(&mut bench, &outputs, 3000), 1000, "no further than `high`");
    outputs[5] = 0;
    assert_eq!(run(&mut bench, &outputs, 2000), 999, "half a unit a second");
    bench.plant.start(true);
    assert_eq!(run(&mut bench, &[0; OUTPUT_PORTS], 1), 0, "0.9995 shows as 0");
}

#[test]
fn a_slide_passes_its_switches() {
    // 1000 mm/s is 1 mm in a millisecond.
    let toml = "[[slide]]\nforward='P0OUT.0'\nbackward='P0OUT.1'\nrapid='P0OUT.2'\nspeed-mm-s=1000\nrapid-mm-s=3000\nstroke-mm=10\n\
                switches=[{at=0,width=0.5,input='P1IN.0'},{at=4,width=2,input='P1IN.1'},{at=10,width=1,input='P1IN.2',invert=true}]\n\
                position=['P2IN','P3IN']";
    let forward = "__########____####_______";
    let back___ = "_____________#__#___#####"; // both at once: it stands
    let rapid__ = "______________##_____####";
    // Position after each millisecond: 0 0 1 2 3 4 5 6 7 8 8 8 8 7 10 10 10 10 10 10 9 6 3 0 0
    let start__ = "##_____________________##";
    let middle_ = "_____###_____________#___";
    let not_end = "##############______#####";
    let mut bench = Bench::of(toml);
    let drive = [("P0OUT.0", forward), ("P0OUT.1", back___), ("P0OUT.2", rapid__)];
    assert_eq!(bench.draw(&drive, &["P1IN.0", "P1IN.1", "P1IN.2"]), [start__, middle_, not_end]);
    assert_eq!(bench.number(1..3), 0);
    bench.draw(&[("P0OUT.0", "#######")], &[]);
    assert_eq!(bench.number(1..3), 700, "hundredths of a millimetre");
}

#[test]
fn a_slow_slide_moves_by_thousandths() {
    let toml = "[[slide]]\nforward='P0OUT.0'\nbackward='P0OUT.1'\nspeed-mm-s=0.25\nstroke-mm=2.5\ninitially-mm=1.5\n\
                position=['P2IN','P3IN']";
    let mut bench = Bench::of(toml);
    let mut outputs = [0; OUTPUT_PORTS];
    outputs[0] = 1;
    for _ in 0..1000 {
        bench.plant.step(&outputs, &mut bench.inputs);
    }
    assert_eq!(bench.number(1..3), 175);
    for _ in 0..9000 {
        bench.plant.step(&outputs, &mut bench.inputs);
    }
    assert_eq!(bench.number(1..3), 250, "its end");
}

#[test]
fn faults_act_on_elements_by_their_names() {
    let toml = "[[contact]]\nname='pump'\noutput='P0OUT.0'\ninput='P1IN.0'\non-delay-ms=2\n\
                [[limit]]\nname='door'\noutput-forward='P0OUT.0'\ntravel-ms=2\ninput-at-end='P1IN.1'\n\
                [[latch]]\nname='relay'\nset='P0OUT.0'\nreset='P0OUT.1'\ninput='P1IN.2'\n\
                [[fault]]\nname='welded'\nelement='pump'\nstuck=true\n\
                [[fault]]\nname='open'\nelement='relay'\nstuck=false\n\
                [[fault]]\nname='slow pump'\nelement='pump'\nslow=3\n\
                [[fault]]\nname='slow door'\nelement='door'\nslow=2\n\
                [[fault]]\nname='jammed'\nelement='door'\njammed=true\n\
                [[fault]]\nname='wire'\ninput='P1IN.2'\nbroken=true";
    let drive = [("P0OUT.0", "_########____")];
    let watch = ["P1IN.0", "P1IN.1", "P1IN.2"];
    let with = |faults: &[&str]| {
        let mut bench = Bench::of(toml);
        for fault in faults {
            bench.plant.set_fault(fault, true).unwrap();
        }
        bench.draw(&drive, &watch)
    };
    assert_eq!(with(&[]), ["___######____", "__#######____", "_############"]);
    assert_eq!(with(&["welded"])[0], "#############");
    assert_eq!(with(&["open"])[2], "_____________");
    assert_eq!(with(&["wire"])[2], "_____________");
    assert_eq!(with(&["jammed"])[1], "_____________");
    assert_eq!(with(&["slow door", "jammed"])[1], "_____________");
    assert_eq!(with(&["slow pump"])[0], "________###__", "moves in every third millisecond");
    assert_eq!(with(&["slow door"])[1], "___######____");
}

#[test]
fn a_contact_goes_on_as_it_is_when_its_fault_ends() {
    let toml = "[[contact]]\nname='pump'\noutput='P0OUT.0'\ninput='P1IN.0'\noff-delay-ms=2\n\
                [[fault]]\nname='welded'\nelement='pump'\nstuck=true\nactive=true";
    let mut bench = Bench::of(toml);
    assert_eq!(bench.draw(&[("P0OUT.0", "___")], &["P1IN.0"]), ["###"]);
    bench.plant.set_fault("welded", false).unwrap();
    assert_eq!(bench.draw(&[("P0OUT.0", "____")], &["P1IN.0"]), ["##__"]);
}

#[test]
fn a_shorted_output_is_told_and_reaches_nothing() {
    let toml = "[[contact]]\noutput='P0OUT.3'\ninput='P1IN.0'\n\
                [[fault]]\nname='short'\noutput='P0OUT.3'\nshorted=true";
    let mut bench = Bench::of(toml);
    assert_eq!(bench.plant.shorted(), None);
    bench.plant.set_fault("short", true).unwrap();
    assert_eq!(bench.plant.shorted().unwrap()[0], 0b1000);
    assert_eq!(bench.draw(&[("P0OUT.3", "#")], &["P1IN.0"]), ["_"]);
    bench.plant.set_fault("short", false).unwrap();
    assert_eq!(bench.plant.shorted(), None);
}

#[test]
fn keys_tell_their_commands_and_the_control_has_keys_of_its_own() {
    let toml = "[control]\nstart='P2IN.0'\nstop=['P2IN.1','P0OUT.1']\nemergency-stop='P2IN.2'\n\
                [[key]]\nname='light'\ncommand=12\n\
                [[key]]\nname='go'\ninput='P2IN.0'\ncommand=-1";
    let mut bench = Bench::of(toml);
    let command = |code, pressed| PlantEvent::Command { code, pressed };
    let mut step = |plant: &mut Plant, outputs: u8| {
        let mut image = [0; OUTPUT_PORTS];
        image[0] = outputs;
        plant.step(&image, &mut bench.inputs);
        core::iter::from_fn(|| plant.next_event()).collect::<Vec<_>>()
    };
    let plant = &mut bench.plant;
    assert_eq!(step(plant, 0), []);
    plant.press("light", true).unwrap();
    plant.press("go", true).unwrap();
    assert_eq!(step(plant, 0), [command(12, true), command(-1, true), PlantEvent::Start]);
    assert_eq!(step(plant, 2), [PlantEvent::Stop { emergency: false }]);
    plant.press("light", false).unwrap();
    assert_eq!(step(plant, 2), [command(12, false)]);
}

#[test]
fn settings_of_the_control() {
    let toml = "[control]\nconditional-stop=true\n[[m-function]]\nnumber=91\ngroup=10";
    let plant = plant(toml);
    let control = plant.control();
    assert_eq!(control.m_groups, [(91, 10)]);
    assert!(control.conditional_stop);
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    let toml = "[control]\nstart=[]\n\
        [[latch]]\nset='P0OUT.0'\nreset='X'\ninput='P1IN.0'\n\
        [[counter]]\npulses='P0OUT.0'\ncount=0\n\
        [[counter]]\npulses='P0OUT.0'\ncount=300\nvalue=['P2IN']\ninput='P1IN.0'\n\
        [[ramp]]\nhigh=0\nrise-per-s=0\ninitially=5\n\
        [[ramp]]\noutput='P0OUT.0'\nhigh=9\nrise-per-s=1\nfall-per-s=-1\nthresholds=[{at=10,input='P0OUT.1'}]\n\
        [[ramp]]\nsource=['P5IN']\nhigh=70000\nrise-per-s=1\nvalue=['P3IN','P4IN']\n\
        [[slide]]\nforward='P0OUT.0'\nbackward='P0OUT.1'\nspeed-mm-s=0\nrapid-mm-s=-1\nstroke-mm=10\ninitially-mm=11\n\
        switches=[{at=12,input='P1IN.3'}]\n\
        [[slide]]\nname='door'\nforward='P0OUT.0'\nbackward='P0OUT.1'\nspeed-mm-s=1\nstroke-mm=1\n\
        [[m-function]]\nnumber=100\ngroup=15\n[[m-function]]\nnumber=100\ngroup=1\n[[m-function]]\nnumber=3\ngroup=4\n\
        [[key]]\nname='a'\n\
        [[fault]]\nname='1'\nelement='gate'\njammed=true\n\
        [[fault]]\nname='2'\nelement='door'\nstuck=true\n\
        [[fault]]\nname='3'\nelement='door'\nslow=1\n\
        [[fault]]\nname='4'\nelement='door'\nslow=2\njammed=true\n\
        [[block]]\nat-cycle=1\nintegers=[1,2,3,4,5,6]\naxes=[[16,1.0]]";
    let expected = [
        "latch[0].reset: `X` is not a bit of a port; use P1IN.0 to P128IN.7 or P0OUT.0 to P95OUT.7",
        "counter[0].count: must be at least 1",
        "counter[0]: needs `input` or `value`, else nothing can be seen of it",
        "counter[1].input: P1IN.0 is driven by latch[0].input already; an input has one source",
        "counter[1].value: has too few ports for 300",
        "ramp[0]: needs either `output` or `source`",
        "ramp[0].high: must be above `low`",
        "ramp[0].rise-per-s: must be above 0",
        "ramp[0].fall-per-s: must be above 0",
        "ramp[0].initially: must lie between `low` and `high`",
        "ramp[0]: needs `thresholds` or `value`, else nothing can be seen of it",
        "ramp[1].fall-per-s: must be above 0",
        "ramp[1].thresholds: `at` must lie between `low` and `high`",
        "ramp[1].thresholds: `P0OUT.1` is an output; an input of the PLC is needed, such as P1IN.0",
        "ramp[2].source: `P5IN` is not an output port; use P0OUT to P95OUT",
        "ramp[2].value: has too few ports for 70000",
        "slide[0].rapid-mm-s: `rapid` and `rapid-mm-s` belong together",
        "slide[0].speed-mm-s: must be above 0",
        "slide[0].rapid-mm-s: must be above 0",
        "slide[0].initially-mm: must lie on the way, from 0 to `stroke-mm`",
        "slide[0].switches: `at` must lie on the way, from 0 to `stroke-mm`, `width` not be negative",
        "slide[1]: needs `switches` or `position`, else nothing can be seen of it",
        "key[0]: needs `input`, `command` or `panel`, else it does nothing",
        "fault[0].element: no element is called `gate`; there is `door`",
        "fault[1].stuck: only a contact or a latch can be stuck; use `jammed = true`",
        "fault[2].slow: must be 2 to 1000: how many times as long everything takes",
        "fault[3]: needs one of: `input` with `stuck = true` or `false` or with `broken = true`; `output` with \
         `broken = true` or `shorted = true`; `element` with `stuck`, `jammed = true` or `slow`; `slave` \
         with `lost = true`, `cut = true` or `error`; `can-drive` with `lost = true` or `error`; `can` with `cut = true`",
        "block[0].integers: a block has five parameters of each kind",
        "block[0].axes: NC axes go from 0 to 15",
        "block[0].axes: needs `feed`, here or in a block before it, or `rapid = true`",
        "control.start: names no signal",
        "m-function[0].number: M functions go from 0 to 99",
        "m-function[0].group: must be 1 to 14",
        "m-function[1].number: M functions go from 0 to 99",
        "m-function[1].number: has a group already",
        "m-function[2].group: M03 belongs to group 2",
    ];
    assert_eq!(errors(toml), expected);
}

#[test]
fn unknown_keys_are_errors_that_name_them() {
    for table in ["latch", "counter", "ramp", "slide", "control", "m-function", "fault", "block", "key"] {
        let brackets = if table == "control" { ("[", "]") } else { ("[[", "]]") };
        let error = toml::from_str::<MachineConfig>(&format!("{}{table}{}\nshoe=3", brackets.0, brackets.1))
            .unwrap_err();
        assert!(error.message().contains("unknown field `shoe`"), "{table}: {error}");
    }
}
