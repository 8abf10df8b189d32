//! The calendar clock of the control (manual 8.4.2).
#![allow(clippy::unwrap_used)] // tests

use technol_image::system;
use technol_machine::{MachineConfig, Plant, SimulatedControl};
use technol_runtime::{Control, Rate};

/// Cells of the clock after so many milliseconds: local time and date, UTC time and date, FILETIME.
fn after(control: &mut SimulatedControl, millis: u32) -> Vec<u8> {
    let mut memory = vec![0; system::LEN as usize];
    for millis in 0..u64::from(millis) {
        control.inputs(Rate::Fast, millis, &mut memory);
    }
    control.inputs(Rate::Slow, 0, &mut memory);
    memory[0x1357..0x136F].to_vec()
}

/// Minutes, hours, hundredths, seconds; year, day, month.
fn shown(time: [u8; 4], year: u16, day: u8, month: u8) -> Vec<u8> {
    let [low, high] = year.to_le_bytes();
    [time.as_slice(), &[low, high, day, month]].concat()
}

fn filetime(bytes: &[u8]) -> u64 {
    u64::from_le_bytes(bytes[16..].try_into().unwrap())
}

#[test]
fn it_goes_on_from_where_the_description_says() {
    let config: MachineConfig =
        toml::from_str("[control]\nclock = '2024-02-29 23:59:58'\nutc-offset-min = 60").unwrap();
    let mut control = SimulatedControl::of(&config);
    let cells = after(&mut control, 2250);
    assert_eq!(cells[..8], shown([0, 0, 25, 0], 2024, 1, 3));
    assert_eq!(cells[8..16], shown([0, 23, 25, 0], 2024, 29, 2));
    // 2024-02-29 23:00:00.25 UTC is 1709247600.25 s since 1970, and that is 11644473600 s since 1601.
    assert_eq!(filetime(&cells), (1_709_247_600 + 11_644_473_600) * 10_000_000 + 2_500_000);
}

#[test]
fn without_a_description_it_begins_with_2000_and_a_host_may_set_it() {
    let mut control = SimulatedControl::new();
    let cells = after(&mut control, 0);
    assert_eq!(
        (&cells[..8], &cells[8..16]),
        (&shown([0; 4], 2000, 1, 1)[..], &shown([0; 4], 2000, 1, 1)[..])
    );
    control.set_time(1_709_247_600_250);
    assert_eq!(after(&mut control, 0)[..8], shown([0, 23, 25, 0], 2024, 29, 2));
    for far in [i64::MIN, i64::MAX] {
        control.set_time(far);
        after(&mut control, 1);
    }
}

#[test]
fn a_time_that_is_none_is_told() {
    for (text, expected) in [
        (
            "clock = '2026-02-30 00:00:00'",
            "control.clock: `2026-02-30 00:00:00` is no time; write it as \"2026-03-01 06:30:00\"",
        ),
        ("utc-offset-min = 1441", "control.utc-offset-min: must be -1440 to 1440"),
    ] {
        let config: MachineConfig = toml::from_str(&format!("[control]\n{text}")).unwrap();
        let errors = Plant::compile(&config, &|name| name.parse().ok()).unwrap_err();
        assert_eq!(errors[0].to_string(), expected);
    }
}
