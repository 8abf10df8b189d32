//! What is wrong with a description of buses is told, all at once.
#![allow(clippy::unwrap_used)] // tests

use technol_machine::{MachineConfig, Plant};

#[test]
fn numbers_out_of_range_are_told_with_their_place() {
    let config: MachineConfig = toml::from_str(
        "licences = { features = [0, 10] }
         can-unit = [{ can = 3, group = 0, board = 33 }, { can = 1, group = 3, board = 32 }]
         can-drive = [{ axis = 1 }, { axis = 17, node = 128 }]",
    )
    .unwrap();
    let errors = Plant::compile(&config, &|name| name.parse().ok()).unwrap_err();
    let errors: Vec<String> = errors.iter().map(ToString::to_string).collect();
    assert_eq!(
        errors,
        [
            "licences.features: 10 is not between 0 and 9",
            "can-unit[0].can: 3 is not between 1 and 2",
            "can-unit[0].group: 0 is not between 1 and 3",
            "can-unit[0].board: 33 is not between 1 and 32",
            "can-drive[1].axis: 17 is not between 1 and 16",
            "can-drive[1].node: 128 is not between 1 and 127",
        ]
    );
}

/// Mistakes of a description, each with its path.
fn mistakes(toml: &str) -> Vec<String> {
    let config: MachineConfig = toml::from_str(toml).unwrap();
    let errors = Plant::compile(&config, &|name| name.parse().ok()).err().unwrap_or_default();
    errors.iter().map(ToString::to_string).collect()
}

#[test]
fn what_is_described_twice_is_told_at_its_second_place() {
    for (toml, expected) in [
        (
            "serial = [{ channel = 1 }, { channel = 2 }, { channel = 1 }]",
            "serial[2].channel: serial[0] describes the same; leave one of them",
        ),
        (
            "can-unit = [{ can = 2, group = 1, board = 3 }, { can = 2, group = 1, board = 3 }]",
            "can-unit[1].board: can-unit[0] describes the same; leave one of them",
        ),
        ("can-unit = [{ can = 2, group = 1, board = 3 }, { can = 2, group = 2, board = 3 }]", ""),
        (
            "can-drive = [{ axis = 4 }, { axis = 4, node = 2 }]",
            "can-drive[1].axis: can-drive[0] describes the same; leave one of them",
        ),
        (
            "can-drive = [{ axis = 4, object = [{ index = 0x6060, type = 'byte' }, { index = 0x6060, type = 'word' }] }]",
            "can-drive[0].object: the object 6060h:0 is described twice",
        ),
        (
            "ethercat = [{ register = [{ idn = 51, type = 'word' }, { drive = 1, idn = 51, type = 'word' }, { idn = 51, type = 'word' }] }]",
            "ethercat[0].register: the register 51 of drive 0 is described twice",
        ),
        (
            "ramp = [{ output = 'P0OUT.0', high = 9, rise-per-s = 1, value = 'ANALOG_INPUT_PHYSICAL[2]' }, \
                     { output = 'P0OUT.0', high = 9, rise-per-s = 1, value = 'analog_input_physical[2]' }]",
            "ramp[1].value: ANALOG_INPUT_PHYSICAL[2] is driven by ramp[0].value already; an input has one source",
        ),
        ("axis = [{ number = 2 }, { number = 2 }]", "axis[1].number: axis 2 is described twice"),
    ] {
        assert_eq!(mistakes(toml).join("\n"), expected, "{toml}");
    }
}

#[test]
fn process_data_must_have_a_name_a_place_and_a_meaning() {
    let bits = "{ name = 'A', type = 'bit' }, { name = 'B', type = 'bit' }";
    for (toml, expected) in [
        (format!("ethercat = [{{ name = 'X', inputs = [{bits}] }}]"), ""),
        (
            format!("ethercat = [{{ inputs = [{bits}] }}]"),
            "ethercat[0].name: is needed: inputs, outputs and drives are named by it",
        ),
        (
            "ethercat = [{ name = 'X' }, { name = 'x' }]".to_owned(),
            "ethercat[1].name: `x` is used twice; names must differ",
        ),
        (
            "ethercat = [{ name = 'X', outputs = [{ name = 'A', type = 'bit' }, { name = 'a', type = 'word' }] }]".to_owned(),
            "ethercat[0].outputs: `ECAT.X.Outputs.a` is there twice",
        ),
        (
            "ethercat = [{ name = 'X', drive = true, outputs = [] }]".to_owned(),
            "ethercat[0].outputs: a drive needs its control word: one with `object = 0x6040`",
        ),
        ("ethercat = [{ name = 'X', servo = 3 }]".to_owned(), "ethercat[0].servo: belongs to a drive; add `drive = true`"),
        (
            "ethercat = [{ name = 'X', drive = true, servo = 16 }]".to_owned(),
            "ethercat[0].servo: 16 is not between 0 and 15",
        ),
        (
            "ethercat = [{ name = 'X', drive = true, servo = 1 }, { name = 'Y', drive = true, servo = 1 }]".to_owned(),
            "ethercat[1].servo: the servo loop 1 has a drive already",
        ),
        (
            format!(
                "ethercat = [{{ name = 'X', inputs = [{}] }}]",
                (0..17).map(|n| format!("{{ name = 'Q{n}', type = 'qword' }}")).collect::<Vec<_>>().join(", ")
            ),
            "ethercat[0].inputs: all slaves together have more than 128 bytes of inputs",
        ),
        (
            format!("ethercat = [{{ name = 'X', inputs = [{bits}] }}]\nkey = [{{ name = 'k', input = 'ECAT.X.Inputs.C' }}]"),
            "key[0].input: no slave of `[[ethercat]]` has `ECAT.X.Inputs.C`",
        ),
        (
            "ethercat = [{ name = 'X', inputs = [{ name = 'W', type = 'word' }] }]\nkey = [{ name = 'k', input = 'ECAT.X.Inputs.W' }]".to_owned(),
            "key[0].input: `ECAT.X.Inputs.W` is more than a bit; choose one by `.Bit[n]` at its end",
        ),
        (
            "ethercat = [{ name = 'X', inputs = [{ name = 'W', type = 'word' }] }]\n\
             key = [{ name = 'k', input = 'ECAT.X.Inputs.W.Bit[15]' }, { name = 'l', input = 'ecat.x.inputs.w.bit[15]' }]".to_owned(),
            "key[1].input: byte 1.7 from the bus is driven by key[0].input already; an input has one source",
        ),
        (
            "ethercat = [{ name = 'X', inputs = [{ name = 'W', type = 'word' }] }]\n\
             input = [{ id = 'a', port = 'ECAT.X.Inputs.W.Bit[0]' }]".to_owned(),
            "input[0].port: `ECAT.X.Inputs.W.Bit[0]` is no port; join it to the input by `[[link]]`",
        ),
    ] {
        assert_eq!(mistakes(&toml).join("\n"), expected, "{toml}");
    }
}

#[test]
fn faults_on_buses_name_what_is_there() {
    let machine = "ethercat = [{ name = 'X' }, { name = 'D', drive = true }]\ncan-drive = [{ axis = 2 }]\n";
    for (fault, expected) in [
        ("slave = 'X', lost = true", ""),
        ("slave = 'D', cut = true", ""),
        ("slave = 'D', error = 0x4310", ""),
        ("can-drive = 2, error = 1", ""),
        ("can = 2, cut = true", ""),
        ("slave = 'Z', lost = true", "fault[0].slave: no slave of `[[ethercat]]` is called `Z`"),
        ("slave = 'X', error = 1", "fault[0].error: belongs to a drive; the slave has no `drive = true`"),
        ("can-drive = 3, lost = true", "fault[0].can-drive: no `[[can-drive]]` is that of axis 3"),
        ("can = 3, cut = true", "fault[0].can: 3 is not between 1 and 2"),
    ] {
        let toml = format!("{machine}fault = [{{ name = 'f', {fault} }}]");
        assert_eq!(mistakes(&toml).join("\n"), expected, "{fault}");
    }
    for fault in [
        "slave = 'X'",
        "slave = 'X', lost = true, cut = true",
        "can = 2, lost = true",
        "slave = 'X', jammed = true",
        "lost = true",
    ] {
        let found = mistakes(&format!("{machine}fault = [{{ name = 'f', {fault} }}]"));
        assert!(found[0].starts_with("fault[0]: needs one of: "), "{fault}: {found:?}");
    }
}
