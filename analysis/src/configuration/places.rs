//! Physical ends of inputs and outputs: ports that there are not, and two elements on one bit (manual 9.3 and 10.2).

use std::collections::HashMap;

use technol_image::{Signal, system};

use super::channel::Point;
use super::problem::Problem;
use crate::catalogue::ConfigElement;
use crate::diagnostics::rules::configuration as rules;

/// Ports P1IN to P128IN, counted from 0.
const INPUT_PORTS: i64 = system::IN_PORT_COUNT as i64;
/// Ports P0OUT to P95OUT.
const OUTPUT_PORTS: i64 = system::OUT_PORT_COUNT as i64;
/// Bits of a port.
const BITS: i64 = 8;
/// Analogue channels of each direction.
const CHANNELS: i64 = 100;

/// Where a point leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// A bit of a port.
    Bit(Signal),
    /// An analogue input, below 100.
    AnalogInput(u8),
    /// An analogue output, below 100.
    AnalogOutput(u8),
}

/// Where a point leads; `None` when there is no such port, bit or channel.
#[must_use]
pub fn place(point: &Point) -> Option<Place> {
    let below = |value: i64, end: i64| u8::try_from(value).ok().filter(|value| i64::from(*value) < end);
    let (port, bit) = (point.port, below(point.bit, BITS));
    match point.element {
        ConfigElement::Input => {
            Some(Place::Bit(Signal::Input { port: below(port, INPUT_PORTS)?, bit: bit? }))
        }
        ConfigElement::Output => {
            Some(Place::Bit(Signal::Output { port: below(port, OUTPUT_PORTS)?, bit: bit? }))
        }
        ConfigElement::AnalogInput => Some(Place::AnalogInput(below(port, CHANNELS)?)),
        ConfigElement::AnalogOutput => Some(Place::AnalogOutput(below(port, CHANNELS)?)),
        _ => None,
    }
}

/// Reports ports that there are not, outputs of one bit of which only some are inverted, and analogue outputs with
/// two sources.
pub(super) fn check(points: &[Point], problems: &mut Vec<Problem>) {
    let mut first: HashMap<Place, &Point> = HashMap::new();
    for point in points {
        missing(point, problems);
        let Some(place) = place(point).filter(|_| point.connected == Some(true)) else { continue };
        let Some(before) = first.get(&place) else {
            first.insert(place, point);
            continue;
        };
        let (own, other) = (&point.id.text, &before.id.text);
        let message = match place {
            Place::Bit(output @ Signal::Output { .. }) if before.invert != point.invert => format!(
                "{own} and {other} both drive {output}, and only one of them is inverted; outputs that share \
                 a bit need the same Invert"
            ),
            Place::AnalogOutput(channel) => {
                format!("{own} and {other} both drive the analogue output {channel}; it can have one source")
            }
            _ => continue,
        };
        let problem = Problem::new(&rules::WRONG_CONFIGURATION_VALUE, point.place, message);
        problems.push(problem.beside(before.place, "the first one"));
    }
}

/// A port that the attribute may have, but that the control does not.
fn missing(point: &Point, problems: &mut Vec<Problem>) {
    let port = point.port;
    let message = match point.element {
        ConfigElement::Input if port == INPUT_PORTS => {
            format!(
                "Port=\"{port}\" of an input would be P{}IN; the last one is Port=\"127\", P128IN",
                port + 1
            )
        }
        ConfigElement::Output if (OUTPUT_PORTS..=INPUT_PORTS).contains(&port) => {
            format!("Port=\"{port}\" of an output would be P{port}OUT; the last one is P95OUT")
        }
        // Anything else out of range was reported with the attribute.
        _ => return,
    };
    problems.push(Problem::new(&rules::WRONG_CONFIGURATION_VALUE, point.place, message));
}
