//! The machine in words: what drives what.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use crate::analog;
use crate::compile::slave_bit;
use crate::config::{
    Block, Contact, Counter, Encoder, Fault, Key, Latch, Limit, MachineConfig, Ramp, Slide, Turret,
};
use crate::control::ChannelWiring;
use crate::control::elements::identifier;
use crate::control::ethercat::layout::{self, Line};
use crate::motion::Thousandths;
use crate::motion::config::Axis;
use crate::signal::{INPUT_PORTS, OUTPUT_PORTS, Signal};

mod buses;

/// What a signal does, or what is done to it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Wire {
    /// The bit; of a whole port bit 0.
    pub signal: Signal,
    /// The whole port, or all of a value of a slave.
    pub whole: bool,
    /// Its name: `P1IN.0`, `P8IN`, `ECAT.Valves.Outputs.Clamp`.
    pub place: String,
    /// The element, with its name.
    pub element: String,
    /// What happens there.
    pub text: String,
}

/// The machine in words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wiring {
    /// Signals that drive something, by signal.
    pub drives: Vec<Wire>,
    /// Inputs, and what drives them, by signal.
    pub driven: Vec<Wire>,
    /// Analogue inputs and outputs, and what is done with them.
    pub analog: Vec<(String, String)>,
    /// Identifiers of inputs and outputs, and links, and where they lead.
    pub identifiers: Vec<(String, String)>,
    /// What is connected to buses.
    pub buses: Vec<(String, String)>,
    /// Keys and what they do, in the order of the file.
    pub keys: Vec<(String, String)>,
    /// Faults and what they do, in the order of the file.
    pub faults: Vec<(String, String)>,
    /// Blocks of the part program, in the order of the file.
    pub blocks: Vec<String>,
}

/// Describes a machine that [`Plant::compile`](crate::Plant::compile) accepts, in front of a configuration of the control;
/// names that are wrong are left out.
#[must_use]
pub fn wiring(config: &MachineConfig, channel: &ChannelWiring) -> Wiring {
    let lines = layout::lines(&config.ethercat);
    let mut wiring = Describing { wiring: Wiring::default(), lines: &lines };
    config.contact.iter().for_each(|e| contact(e, &mut wiring.of("contact", &e.name)));
    config.limit.iter().for_each(|e| limit(e, &mut wiring.of("limit", &e.name)));
    config.encoder.iter().for_each(|e| encoder(e, &mut wiring.of("encoder", &e.name)));
    config.turret.iter().for_each(|e| turret(e, &mut wiring.of("turret", &e.name)));
    config.latch.iter().for_each(|e| latch(e, &mut wiring.of("latch", &e.name)));
    config.counter.iter().for_each(|e| counter(e, &mut wiring.of("counter", &e.name)));
    config.ramp.iter().for_each(|e| ramp(e, &mut wiring.of("ramp", &e.name)));
    config.slide.iter().for_each(|e| slide(e, &mut wiring.of("slide", &e.name)));
    config.axis.iter().for_each(|e| axis(e, &mut wiring.of("axis", &axis_name(e))));
    config.key.iter().for_each(|e| key(e, &mut wiring));
    let control = &config.control;
    for (signals, text) in [
        (&control.start, "starts again what was stopped"),
        (&control.stop, "stops the block"),
        (&control.emergency_stop, "stops the block, as an emergency stop"),
    ] {
        let names = signals.as_ref().map_or(&[][..], |signals| &signals.0);
        wiring.of("control", "").drives(names, text);
    }
    wiring.wiring.faults = config.fault.iter().map(fault).collect();
    for (n, block) in config.block.iter().enumerate() {
        if let Some(name) = &block.on {
            let text = format!("starts {}", block_name(n, block));
            wiring.of("block", "").drives(core::slice::from_ref(name), &text);
        }
        wiring.wiring.blocks.push(describe_block(n, block));
    }
    let mut wiring = wiring.wiring;
    wiring.drives.sort();
    wiring.driven.sort();
    wiring.identifiers = buses::identifiers(config, channel);
    wiring.buses = buses::buses(config, &lines);
    wiring
}

/// A description in progress.
struct Describing<'l> {
    wiring: Wiring,
    lines: &'l [Line],
}

impl Describing<'_> {
    fn of(&mut self, kind: &str, name: &str) -> Element<'_> {
        let name = if name.is_empty() { kind.to_string() } else { format!("{kind} \"{name}\"") };
        Element { name, lines: self.lines, wiring: &mut self.wiring }
    }
}

/// Adds the wires of one element.
struct Element<'a> {
    name: String,
    lines: &'a [Line],
    wiring: &'a mut Wiring,
}

impl Element<'_> {
    fn wire(&self, name: &str, text: &str) -> Option<Wire> {
        let bit = name.parse().ok().or_else(|| slave_bit(self.lines, name)).map(|signal| (signal, false));
        let whole = || Signal::of_port_named(name).or_else(|| self.value(name)).map(|port| (port, true));
        let (signal, whole) = bit.or_else(whole)?;
        let place = if is_port(signal) { shown(signal, whole) } else { name.trim().into() };
        Some(Wire { signal, whole, place, element: self.name.clone(), text: text.into() })
    }

    /// A value of a slave: its first bit.
    fn value(&self, name: &str) -> Option<Signal> {
        let id = identifier(name.as_bytes()).ok()?;
        let line = self.lines.iter().find(|line| line.id == id)?;
        let port = |first: usize| u8::try_from(first + line.first).ok();
        Some(if line.output {
            Signal::Output { port: port(OUTPUT_PORTS)?, bit: 0 }
        } else {
            Signal::Input { port: port(INPUT_PORTS)?, bit: 0 }
        })
    }

    fn drives(&mut self, names: &[String], text: &str) {
        let wires: Vec<_> = names.iter().filter_map(|name| self.wire(name, text)).collect();
        self.wiring.drives.extend(wires);
    }

    fn driven(&mut self, name: &str, text: &str) {
        let wire = self.wire(name, text);
        self.wiring.driven.extend(wire);
    }

    fn number(&mut self, ports: &[String], what: &str) {
        for (n, port) in ports.iter().enumerate() {
            let place = if ports.len() == 1 { String::new() } else { format!(", byte {n}") };
            self.driven(port, &format!("{what} in binary{place}"));
        }
    }
}

/// It is a bit of a port, not of a slave.
fn is_port(signal: Signal) -> bool {
    match signal {
        Signal::Input { port, .. } => usize::from(port) < INPUT_PORTS,
        Signal::Output { port, .. } => usize::from(port) < OUTPUT_PORTS,
    }
}

/// A bit or a whole port as text.
fn shown(signal: Signal, whole: bool) -> String {
    if whole { signal.port_name() } else { signal.to_string() }
}

fn any(names: &[String]) -> String {
    names.join(" or ")
}

/// A number without the zeros at its end.
fn decimal(number: Thousandths) -> String {
    let text = number.to_string();
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

const fn level(on: bool) -> &'static str {
    if on { "on" } else { "off" }
}

fn contact(e: &Contact, to: &mut Element<'_>) {
    let (on, off) = (level(!e.invert), level(e.invert));
    let (on_ms, off_ms) = (e.on_delay_ms, e.off_delay_ms);
    to.drives(&e.output.0, &format!("{} {on} after {on_ms} ms, {off} after {off_ms} ms", e.input));
    let text =
        format!("{on} {on_ms} ms after {} goes on, {off} {off_ms} ms after it goes off", any(&e.output.0));
    to.driven(&e.input, &text);
}

fn limit(e: &Limit, to: &mut Element<'_>) {
    let there = e.travel_ms;
    let back = e.return_ms.unwrap_or(there);
    let reaches =
        |input: &Option<String>| input.as_ref().map_or(String::new(), |name| format!(": then {name}"));
    let end = reaches(&e.input_at_end);
    let start = reaches(&e.input_at_start);
    let spring = if e.output_backward.is_none() {
        format!("; off: a spring brings it back in {back} ms{start}")
    } else {
        String::new()
    };
    to.drives(&e.output_forward.0, &format!("moves it to the end in {there} ms{end}{spring}"));
    let backward = e.output_backward.as_ref().map_or(&[][..], |names| &names.0);
    to.drives(backward, &format!("moves it to the start in {back} ms{start}"));
    let by = if backward.is_empty() { "a spring".to_string() } else { any(backward) };
    if let Some(name) = &e.input_at_start {
        to.driven(name, &format!("on at the start, where {by} brings it in {back} ms"));
    }
    if let Some(name) = &e.input_at_end {
        to.driven(
            name,
            &format!("on at the end, where {} brings it in {there} ms", any(&e.output_forward.0)),
        );
    }
}

fn encoder(e: &Encoder, to: &mut Element<'_>) {
    to.drives(&e.output.0, &format!("turns it: a pulse every {} ms", e.period_ms));
    to.drives(e.direction.as_ref().map_or(&[][..], |names| &names.0), "makes it count down");
    if let Some(name) = &e.input {
        to.driven(name, &format!("a pulse every {} ms while {} is on", e.period_ms, any(&e.output.0)));
    }
    to.number(&e.position, "its count");
}

fn turret(e: &Turret, to: &mut Element<'_>) {
    let each = format!("station, {} ms each, {} stations", e.station_ms, e.stations);
    to.drives(&e.motor.0, &format!("turns it to the next {each}"));
    to.drives(
        e.motor_reverse.as_ref().map_or(&[][..], |names| &names.0),
        &format!("turns it to the last {each}"),
    );
    for (bit, name) in e.code.iter().enumerate() {
        to.driven(name, &format!("its station in BCD, bit {bit}"));
    }
    if let Some(name) = &e.strobe {
        let ms = e.strobe_ms.unwrap_or((e.station_ms / 4).max(1));
        to.driven(name, &format!("on for {ms} ms while a station is in place"));
    }
}

fn latch(e: &Latch, to: &mut Element<'_>) {
    to.drives(&e.set.0, &format!("sets it: {} {}", e.input, level(!e.invert)));
    to.drives(&e.reset.0, &format!("resets it: {} {}", e.input, level(e.invert)));
    let text = format!("{} from {} until {}", level(!e.invert), any(&e.set.0), any(&e.reset.0));
    to.driven(&e.input, &text);
}

fn counter(e: &Counter, to: &mut Element<'_>) {
    let reached = e.input.as_ref().map_or(String::new(), |name| format!(", then {name}"));
    to.drives(&e.pulses.0, &format!("is counted up to {}{reached}", e.count));
    to.drives(e.reset.as_ref().map_or(&[][..], |names| &names.0), "resets it");
    if let Some(name) = &e.input {
        let until = e.reset.as_ref().map_or("the next".to_string(), |names| any(&names.0));
        to.driven(name, &format!("on from pulse {} of {} until {until}", e.count, any(&e.pulses.0)));
    }
    to.number(&e.value, "its count");
}

fn ramp(e: &Ramp, to: &mut Element<'_>) {
    let rise = decimal(e.rise_per_s);
    let fall = decimal(e.fall_per_s.unwrap_or(e.rise_per_s));
    if let Some(names) = &e.output {
        let text = format!("raises it to {} at {rise}/s; off: it falls to {} at {fall}/s", e.high, e.low);
        to.drives(&names.0, &text);
    }
    for port in &e.source {
        let text = format!("is its target; it rises at {rise}/s and falls at {fall}/s");
        if analog::is_meant(port) {
            let measure = per_volt(e.source_per_volt);
            to.wiring.analog.push((port.clone(), format!("{}: {text}{measure}", to.name)));
        }
        to.drives(core::slice::from_ref(port), &text);
    }
    if let [input] = e.value.as_slice()
        && analog::is_meant(input)
    {
        let text = format!("{}: its value{}", to.name, per_volt(e.value_per_volt));
        to.wiring.analog.push((input.clone(), text));
    }
    for threshold in &e.thresholds {
        let (on, off) = (level(!threshold.invert), level(threshold.invert));
        let below = i64::from(threshold.at) - i64::from(threshold.hysteresis);
        to.driven(&threshold.input, &format!("{on} from {}, {off} below {below}", threshold.at));
    }
    to.number(&e.value, "its value");
}

fn per_volt(units: Option<Thousandths>) -> String {
    units.map(|units| format!(", {} for a volt", decimal(units))).unwrap_or_default()
}

fn slide(e: &Slide, to: &mut Element<'_>) {
    let speed = format!("{} mm/s, stroke {} mm", decimal(e.speed_mm_s), decimal(e.stroke_mm));
    to.drives(&e.forward.0, &format!("moves it forward at {speed}"));
    to.drives(&e.backward.0, &format!("moves it backward at {speed}"));
    if let (Some(names), Some(rapid)) = (&e.rapid, e.rapid_mm_s) {
        to.drives(&names.0, &format!("moves it at {} mm/s instead", decimal(rapid)));
    }
    for switch in &e.switches {
        let to_mm = decimal(Thousandths(switch.at.0 + switch.width.0));
        let text = format!("{} from {} mm to {to_mm} mm", level(!switch.invert), decimal(switch.at));
        to.driven(&switch.input, &text);
    }
    to.number(&e.position, "its position in 0.01 mm");
}

fn axis_name(e: &Axis) -> String {
    if e.name.is_empty() { e.number.to_string() } else { e.name.clone() }
}

fn axis(e: &Axis, to: &mut Element<'_>) {
    for switch in &e.switch {
        let from = switch.from.map(|mm| format!(" from {} mm", decimal(mm))).unwrap_or_default();
        let until = switch.to.map(|mm| format!(" up to {} mm", decimal(mm))).unwrap_or_default();
        to.driven(&switch.input, &format!("{}{from}{until}", level(!switch.invert)));
    }
}

fn key(e: &Key, wiring: &mut Describing<'_>) {
    let mut does = Vec::new();
    if let Some(input) = &e.input {
        does.push(format!("{input} {} while pressed", level(!e.invert)));
        wiring.of("key", &e.name).driven(input, &format!("{} while pressed", level(!e.invert)));
    }
    if let Some(command) = e.command {
        does.push(format!("tells _ON_CMD {command}"));
    }
    does.extend(e.panel.map(crate::motion::PanelKey::describe));
    wiring.wiring.keys.push((e.name.clone(), does.join(", ")));
}

fn fault(e: &Fault) -> (String, String) {
    let mut text = match (&e.input, &e.output, &e.element) {
        (Some(input), ..) => match e.stuck {
            Some(value) => format!("{input} stays {}", level(value)),
            None => format!("the wire of {input} is broken: it stays off"),
        },
        (_, Some(output), _) if e.shorted == Some(true) => format!("{output} has a short circuit"),
        (_, Some(output), _) => format!("{output} does not reach the machine"),
        (_, _, Some(element)) => match (e.stuck, e.slow) {
            (Some(value), _) => format!("\"{element}\" stays {}", level(value)),
            (_, Some(times)) => format!("\"{element}\" takes {times} times as long"),
            _ => format!("\"{element}\" does not move"),
        },
        _ => on_bus(e),
    };
    if e.active {
        text.push_str(", from the start");
    }
    (e.name.clone(), text)
}

fn on_bus(e: &Fault) -> String {
    let who = match (&e.slave, e.can_drive, e.can) {
        (Some(slave), ..) => format!("\"{slave}\""),
        (_, Some(axis), _) => format!("the CAN drive of axis {axis}"),
        (_, _, Some(can)) => format!("CAN channel {can}"),
        _ => return String::new(),
    };
    match (e.error, e.cut == Some(true), e.slave.is_some()) {
        (Some(code), ..) => format!("{who} is in error {code:04X}h"),
        (None, true, true) => format!("the cable is cut in front of {who}"),
        (None, true, false) => format!("the cable of {who} is cut"),
        (None, false, _) => format!("nobody reaches {who}"),
    }
}

fn block_name(n: usize, block: &Block) -> String {
    if block.name.is_empty() { format!("block {}", n + 1) } else { format!("\"{}\"", block.name) }
}

fn describe_block(n: usize, block: &Block) -> String {
    let when = match (block.at_cycle, &block.on) {
        (Some(cycle), _) => format!("in cycle {cycle}"),
        (_, Some(signal)) => format!("when {signal} goes on"),
        _ => "after the block before it".to_string(),
    };
    let targets = || {
        let each = block.axes.iter().map(|(axis, target)| format!("axis {} to {target} mm", axis + 1));
        each.collect::<Vec<_>>().join(", ")
    };
    let motion = match (&block.axes[..], block.motion_ms, block.rapid, block.feed) {
        ([], 0, ..) => String::new(),
        ([], millis, ..) => format!(", moves for {millis} ms"),
        (_, _, true, _) => format!(", rapid traverse: {}", targets()),
        (_, _, _, Some(feed)) => format!(", feed {feed}: {}", targets()),
        _ => format!(", {}", targets()),
    };
    format!("{} {when}{motion}", block_name(n, block))
}
