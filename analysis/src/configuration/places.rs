//! Physical ends of inputs and outputs: ports that there are not, and two elements on one bit (manual 9.3 and 10.2).

use std::collections::HashMap;

use super::channel::Point;
use super::problem::Problem;
use crate::catalogue::ConfigElement;
use crate::diagnostics::rules::configuration as rules;

/// Ports P1IN to P128IN, counted from 0.
const INPUT_PORTS: i64 = 128;
/// Ports P0OUT to P95OUT.
const OUTPUT_PORTS: i64 = 96;
/// Bits of a port.
const BITS: i64 = 8;
/// Analogue channels of each direction.
const CHANNELS: i64 = 100;

/// Where a point leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// A bit of an input port; port 0 is P1IN.
    Input {
        /// The port, below 128.
        port: u8,
        /// The bit, below 8.
        bit: u8,
    },
    /// A bit of an output port; port 0 is P0OUT.
    Output {
        /// The port, below 96.
        port: u8,
        /// The bit, below 8.
        bit: u8,
    },
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
        ConfigElement::Input => Some(Place::Input { port: below(port, INPUT_PORTS)?, bit: bit? }),
        ConfigElement::Output => Some(Place::Output { port: below(port, OUTPUT_PORTS)?, bit: bit? }),
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
            Place::Output { port, bit } if before.invert != point.invert => format!(
                "{own} and {other} both drive P{port}OUT.{bit}, and only one of them is inverted; outputs that share \
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
