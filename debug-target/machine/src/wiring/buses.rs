//! Identifiers, buses and the hardware key in words.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use crate::config::{Input, Link, MachineConfig, Output, Slave, Value};
use crate::control::ethercat::layout::Line;
use crate::control::{ChannelWiring, Connection, Physical};

/// Identifiers and where they lead: of the machine first, then of the configuration of the control.
pub(super) fn identifiers(config: &MachineConfig, channel: &ChannelWiring) -> Vec<(String, String)> {
    let mut rows: Vec<_> = config.input.iter().map(input).collect();
    rows.extend(config.output.iter().map(output));
    rows.extend(config.link.iter().map(link));
    for point in &channel.points {
        let id = String::from_utf8_lossy(&point.id);
        let (what, place) = match point.physical {
            Physical::Bit { signal, invert } => {
                let what = if matches!(signal, crate::Signal::Input { .. }) { "input" } else { "output" };
                (what, format!("{signal}{}", inverted(invert)))
            }
            Physical::AnalogInput(it) => ("input", format!("ANALOG_INPUT_PHYSICAL[{}]", it.channel)),
            Physical::AnalogOutput(it) => ("output", format!("ANALOG_OUTPUT_PHYSICAL[{}]", it.channel)),
        };
        let place = if point.connected { place } else { format!("not connected, {}", point.default) };
        rows.push((format!("{what} {id}"), format!("{place}, by the configuration")));
    }
    for Connection { source, destination, conversion } in &channel.connections {
        let way = conversion_text(conversion.invert, conversion.scale, conversion.offset);
        rows.push((format!("link {source}"), format!("to {destination}{way}, by the configuration")));
    }
    rows
}

fn inverted(invert: bool) -> &'static str {
    if invert { ", inverted" } else { "" }
}

fn input(it: &Input) -> (String, String) {
    let text = match (&it.port, &it.value) {
        (Some(port), _) => format!("{port}{}", inverted(it.invert)),
        (_, Some(Value::Bit(value))) => format!("always {}", u8::from(*value)),
        (_, Some(Value::Int(value))) => format!("always {value}"),
        (_, Some(Value::Real(value))) => format!("always {}", value.0),
        (_, Some(Value::Text(value))) => format!("always \"{value}\""),
        (None, None) => String::new(),
    };
    (format!("input {}", it.id), text)
}

fn output(it: &Output) -> (String, String) {
    (format!("output {}", it.id), format!("{}{}", it.port, inverted(it.invert)))
}

fn link(it: &Link) -> (String, String) {
    let number = |number: Option<crate::config::Number>, usual| number.map_or(usual, |number| number.0);
    let way = conversion_text(it.invert, number(it.scale, 1.0), number(it.offset, 0.0));
    (format!("link {}", it.source), format!("to {}{way}", it.destination))
}

#[expect(clippy::float_cmp, reason = "only the numbers of no conversion are left out")]
fn conversion_text(invert: bool, scale: f64, offset: f64) -> String {
    let mut text = String::from(inverted(invert));
    if scale != 1.0 {
        text = format!("{text}, times {scale}");
    }
    if offset != 0.0 {
        text = format!("{text}, plus {offset}");
    }
    text
}

/// What is connected to the buses, and the hardware key.
pub(super) fn buses(config: &MachineConfig, lines: &[Line]) -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let licences = &config.licences;
    if licences.key || !licences.features.is_empty() {
        let numbers: Vec<String> = licences.features.iter().map(ToString::to_string).collect();
        let held =
            if numbers.is_empty() { "no licence".into() } else { format!("licences {}", numbers.join(", ")) };
        let key = if licences.key { "" } else { ", but it is not plugged in" };
        rows.push(("hardware key".into(), format!("{held}{key}")));
    }
    for port in &config.serial {
        rows.push((format!("serial {}", port.channel), format!("{} bit/s", port.baud.unwrap_or(9600))));
    }
    for unit in &config.can_unit {
        let kind = match unit.group {
            1 => "INOUT08",
            2 => "KLA50",
            _ => "hand panel",
        };
        rows.push((format!("can-unit {}/{}/{}", unit.can, unit.group, unit.board), kind.into()));
    }
    for drive in &config.can_drive {
        let node = drive.node.unwrap_or(drive.axis);
        let text = format!("CAN drive, NODE-ID {node}{}", some(drive.object.len(), "object"));
        rows.push((format!("can-drive {}", drive.axis), text));
    }
    if config.ethercat_master.start_by_program {
        rows.push(("ethercat".into(), "started by flEcatStartCyclicOperation".into()));
    }
    rows.extend(config.ethercat.iter().enumerate().map(|(n, it)| slave(n, it, lines)));
    rows
}

fn slave(n: usize, it: &Slave, lines: &[Line]) -> (String, String) {
    let kind = match (it.drive, it.servo) {
        (true, Some(servo)) => format!("drive of servo loop {servo}"),
        (true, None) => "drive".into(),
        _ => "slave".into(),
    };
    let mut text =
        format!("{kind}{}{}", some(it.object.len(), "object"), some(it.register.len(), "register"));
    for (output, verb) in [(false, "gives"), (true, "takes")] {
        let own = lines.iter().filter(|line| line.slave == n && line.output == output);
        let names: Vec<&str> = own.filter_map(|line| line.name.rsplit('.').next()).collect();
        if !names.is_empty() {
            text = format!("{text}; {verb} {}", names.join(", "));
        }
    }
    let name = if it.name.is_empty() { String::new() } else { format!(" \"{}\"", it.name) };
    (format!("ethercat {n}{name}"), text)
}

fn some(count: usize, what: &str) -> String {
    match count {
        0 => String::new(),
        1 => format!(", 1 {what}"),
        _ => format!(", {count} {what}s"),
    }
}
