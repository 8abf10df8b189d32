//! What the PLC program takes from a `*.ChannelConfig`.

use technol_image::system::m_group;

use super::cross::logical;
use super::document::{Document, Element, Text};
use super::duplicates;
use super::places;
use super::problem::Problem;
use super::schema::ValueKind;
use super::validate;
use crate::catalogue::ConfigElement;
use crate::diagnostics::rules::configuration as rules;
use crate::location::Span;

/// The PLC's part of a channel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Channel {
    /// Inputs and outputs, binary and analogue.
    pub points: Vec<Point>,
    /// Parameters.
    pub parameters: Vec<Parameter>,
    /// Links between logical elements.
    pub connections: Vec<Connection>,
    /// Serial ports.
    pub ports: Vec<SerialPort>,
    /// M functions with a group of their own.
    pub m_functions: Vec<MFunction>,
    /// Spindles that are in use.
    pub spindles: Vec<Spindle>,
}

/// `Input`, `Output`, `AnalogInput`, `AnalogOutput`.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Which of the four.
    pub element: ConfigElement,
    /// Its identifier.
    pub id: Text,
    /// Physical port, or number of the analogue channel.
    pub port: i64,
    /// Bit of the port; 0 for analogue ones.
    pub bit: i64,
    /// The connection inverts.
    pub invert: bool,
    /// Value while it is not connected, as written.
    pub default: String,
    /// `Connected`; `None` when it is left out.
    pub connected: Option<bool>,
    /// Conversion of an analogue one.
    pub conversion: Conversion,
    /// Where its port or channel is given, or else its name.
    pub place: Span,
    /// Its name in the text.
    pub name: Span,
    /// Comment behind it.
    pub note: String,
}

/// `Scale`, `Offset` and limits; what is no number counts as left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conversion {
    /// Factor; 1 when it is left out.
    pub scale: f64,
    /// Shift; 0 when it is left out.
    pub offset: f64,
    /// Smallest value.
    pub min: Option<f64>,
    /// Largest value.
    pub max: Option<f64>,
}

/// `PlcParam`.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its identifier.
    pub id: Text,
    /// Its type; `None` when that is none.
    pub kind: Option<ParameterKind>,
    /// Its value.
    pub value: Text,
    /// Comment behind it.
    pub note: String,
}

/// Type of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterKind {
    /// Integer or logical value.
    Int,
    /// Real number.
    Real,
    /// Text.
    String,
    /// Bytes.
    Binary,
}

/// `Connection`.
#[derive(Clone, Debug, PartialEq)]
pub struct Connection {
    /// Logical output it begins at.
    pub source: Text,
    /// Logical input it ends at.
    pub destination: Text,
    /// Places of conversions that are given.
    pub invert: Option<Span>,
    /// Place of `Scale` or `Offset`.
    pub scale: Option<Span>,
    /// `Scale` and `Offset`.
    pub conversion: Conversion,
    /// `Connected`; `None` when it is left out.
    pub connected: Option<bool>,
    /// Its name.
    pub name: Span,
}

/// `ComChannel`.
#[derive(Clone, Debug, PartialEq)]
pub struct SerialPort {
    /// Its logical number.
    pub number: i64,
    /// `No`.
    pub place: Text,
    /// It is in use.
    pub active: bool,
}

/// `MFunc`.
#[derive(Clone, Debug, PartialEq)]
pub struct MFunction {
    /// Which.
    pub number: i64,
    /// Its group, 1 to 14.
    pub group: i64,
    /// `No`.
    pub place: Text,
}

/// `Spindle` with its gears.
#[derive(Clone, Debug, PartialEq)]
pub struct Spindle {
    /// 1 or 2.
    pub number: i64,
    /// Greatest speed in rev/min; 0: that of the highest gear.
    pub speed_limit: f64,
    /// Greatest speed of each gear in rev/min and the output that belongs to it, in the order of their numbers.
    pub gears: Vec<(f64, i64)>,
}

impl ParameterKind {
    /// As `Type` spells it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            ParameterKind::Int => "Int",
            ParameterKind::Real => "Real",
            ParameterKind::String => "String",
            ParameterKind::Binary => "Binary",
        }
    }

    fn of(text: &str) -> Option<ParameterKind> {
        let all = [ParameterKind::Int, ParameterKind::Real, ParameterKind::String, ParameterKind::Binary];
        all.into_iter().find(|kind| kind.name() == text)
    }
}

/// Name of an element in the file.
#[must_use]
pub const fn element_name(element: ConfigElement) -> &'static str {
    match element {
        ConfigElement::Input => "Input",
        ConfigElement::Output => "Output",
        ConfigElement::AnalogInput => "AnalogInput",
        ConfigElement::AnalogOutput => "AnalogOutput",
        ConfigElement::LogicalInput | ConfigElement::LogicalOutput => "Connection",
        ConfigElement::Parameter => "PlcParam",
        ConfigElement::Constant => "Constant",
        ConfigElement::Table => "PLCTableDef",
        ConfigElement::Column => "Col",
        ConfigElement::Shared => "shared name",
    }
}

/// Reads the elements; what is wrong with one alone was reported before.
pub(super) fn read(document: &Document, problems: &mut Vec<Problem>) -> Channel {
    let mut channel = Channel::default();
    for element in &document.elements {
        let parent = document.parent(element).map(|it| it.name.text.as_str());
        match (element.name.text.as_str(), parent) {
            ("Input", Some("Plc")) => channel.points.extend(point(ConfigElement::Input, element)),
            ("Output", Some("Plc")) => channel.points.extend(point(ConfigElement::Output, element)),
            ("AnalogInput", Some("Plc")) => channel.points.extend(point(ConfigElement::AnalogInput, element)),
            ("AnalogOutput", Some("Plc")) => {
                channel.points.extend(point(ConfigElement::AnalogOutput, element));
            }
            ("PlcParam", Some("Plc")) => channel.parameters.extend(parameter(element, problems)),
            ("Connection", Some("Connections")) => channel.connections.extend(connection(element)),
            ("ComChannel", _) => channel.ports.extend(port(element)),
            ("MFunc" | "MFuncs", Some("MFunctions")) => {
                channel.m_functions.extend(m_function(element, problems));
            }
            _ => {}
        }
    }
    channel
        .spindles
        .extend(document.named("Spindle").filter_map(|(n, element)| spindle(document, n, element)));
    for element in document.elements.iter().filter(|it| it.name.text.starts_with("Analog")) {
        limits(element, problems);
    }
    for kind in
        [ConfigElement::Input, ConfigElement::Output, ConfigElement::AnalogInput, ConfigElement::AnalogOutput]
    {
        let own = channel.points.iter().filter(|it| it.element == kind);
        duplicates::find(own.map(|it| (it.id.text.as_str(), &it.id)), "identifier", problems);
    }
    let parameters = channel.parameters.iter().map(|it| (it.id.text.as_str(), &it.id));
    duplicates::find(parameters, "identifier", problems);
    duplicates::find(channel.ports.iter().map(|it| (it.number, &it.place)), "number", problems);
    let connected = channel.connections.iter().filter(|it| it.connected == Some(true));
    let destinations = connected.map(|it| (logical::normal(&it.destination.text), &it.destination));
    duplicates::find(destinations, "destination", problems);
    places::check(&channel.points, problems);
    duplicates::find(channel.m_functions.iter().map(|it| (it.number, &it.place)), "number", problems);
    channel
}

fn point(kind: ConfigElement, element: &Element) -> Option<Point> {
    let number = |name: &str| element.attribute(name).and_then(Text::integer).unwrap_or(0);
    let analog = matches!(kind, ConfigElement::AnalogInput | ConfigElement::AnalogOutput);
    Some(Point {
        element: kind,
        id: identifier(element, "ID")?,
        port: number(if analog { "PhysNo" } else { "Port" }),
        bit: number("Bit"),
        invert: number("Invert") == 1,
        default: element.attribute("Default").map(|it| it.text.clone()).unwrap_or_default(),
        connected: element.attribute("Connected").map(|it| it.integer() == Some(1)),
        conversion: conversion(element),
        place: element
            .attribute(if analog { "PhysNo" } else { "Port" })
            .map_or(element.name.span, |it| it.span),
        name: element.name.span,
        note: element.note.clone(),
    })
}

fn conversion(element: &Element) -> Conversion {
    let number = |name: &str| {
        let number = element.attribute(name)?.text.trim().parse::<f64>().ok()?;
        number.is_finite().then_some(number)
    };
    Conversion {
        scale: number("Scale").unwrap_or(1.0),
        offset: number("Offset").unwrap_or(0.0),
        min: number("MinVal"),
        max: number("MaxVal"),
    }
}

/// An attribute that is there and not empty.
pub(super) fn identifier(element: &Element, name: &str) -> Option<Text> {
    element.attribute(name).filter(|it| !it.text.is_empty()).cloned()
}

fn parameter(element: &Element, problems: &mut Vec<Problem>) -> Option<Parameter> {
    let kind = element.attribute("Type").and_then(|it| ParameterKind::of(&it.text));
    let value = match kind {
        Some(ParameterKind::Int) => ValueKind::Integer(i64::MIN, i64::MAX),
        Some(ParameterKind::Real) => ValueKind::Real(f64::MIN, f64::MAX),
        _ => ValueKind::Any,
    };
    problems.extend(validate::wrong("the value", value, &element.content));
    let (value, note) = (element.content.clone(), element.note.clone());
    Some(Parameter { id: identifier(element, "ID")?, kind, value, note })
}

fn connection(element: &Element) -> Option<Connection> {
    let given = |name: &str, nothing: &[f64]| {
        let value = element.attribute(name)?;
        let number = value.text.trim().parse::<f64>().ok()?;
        (!nothing.contains(&number)).then_some(value.span)
    };
    Some(Connection {
        source: identifier(element, "Source")?,
        destination: identifier(element, "Destination")?,
        invert: given("Invert", &[0.0]),
        scale: given("Scale", &[1.0]).or_else(|| given("Offset", &[0.0])),
        conversion: conversion(element),
        connected: element.attribute("Connected").map(|it| it.integer() == Some(1)),
        name: element.name.span,
    })
}

fn port(element: &Element) -> Option<SerialPort> {
    let place = identifier(element, "No")?;
    let active = element.attribute("Active").and_then(Text::integer) == Some(1);
    Some(SerialPort { number: place.integer()?, place, active })
}

/// A spindle with gears; `GearCount` says how many of them are in use.
fn spindle(document: &Document, index: usize, element: &Element) -> Option<Spindle> {
    let real = |element: &Element, name: &str| {
        let number = element.attribute(name)?.text.trim().parse::<f64>().ok()?;
        number.is_finite().then_some(number)
    };
    let count = element.attribute("GearCount").and_then(Text::integer)?;
    let gear = |it: &Element| {
        let output = it.attribute("MaxOutput").and_then(Text::integer).unwrap_or(0x7FFF);
        Some((it.attribute("No").and_then(Text::integer)?, (real(it, "MaxSpeed")?, output)))
    };
    let own = document.children(index).filter(|(_, it)| it.name.text == "Gear");
    let mut gears: Vec<(i64, (f64, i64))> = own.filter_map(|(_, it)| gear(it)).collect();
    gears.sort_by_key(|(number, _)| *number);
    let gears: Vec<(f64, i64)> =
        gears.into_iter().map(|(_, gear)| gear).take(usize::try_from(count).unwrap_or(0)).collect();
    (!gears.is_empty()).then(|| Spindle {
        number: element.attribute("No").map_or(Some(1), Text::integer).unwrap_or(1),
        speed_limit: real(element, "SpeedLimit").unwrap_or(0.0),
        gears,
    })
}

/// One that has a fixed group cannot be moved out of it (8.3.5); what is wrong with one number alone was reported before.
fn m_function(element: &Element, problems: &mut Vec<Problem>) -> Option<MFunction> {
    let place = identifier(element, "No")?;
    let number = place.integer()?;
    let group = element.attribute("GroupNo");
    let fixed = u8::try_from(number).ok().and_then(m_group).map(i64::from);
    let (Some(text), Some(own)) = (group, fixed) else {
        let group = group.map_or(Some(fixed.unwrap_or(14)), Text::integer)?;
        return Some(MFunction { number, group, place });
    };
    let group = text.integer()?;
    if group != own {
        let message = format!("M{number:02} belongs to group {own} and cannot be moved to group {group}");
        problems.push(Problem::new(&rules::WRONG_CONFIGURATION_VALUE, text.span, message));
        return None;
    }
    Some(MFunction { number, group, place })
}

/// `MinVal` above `MaxVal`: nothing would pass.
fn limits(element: &Element, problems: &mut Vec<Problem>) {
    let number = |name: &str| element.attribute(name)?.text.trim().parse::<f64>().ok();
    if let (Some(min), Some(max), Some(place)) =
        (number("MinVal"), number("MaxVal"), element.attribute("MinVal"))
        && min > max
    {
        let message = format!("MinVal {min} is above MaxVal {max}: every value becomes one of them");
        problems.push(Problem::new(&rules::WRONG_CONFIGURATION_VALUE, place.span, message));
    }
}
