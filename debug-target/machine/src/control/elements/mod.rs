//! Inputs and outputs that a program names by identifiers: MAP_IN to MAP_AOUT (manual 10) and the logical elements of
//! DEF_IN, DEF_OUT and UPDATE_IN (manual 27).
//!
//! An identifier names one element, whichever of these instructions uses it. The world around sets the values of
//! inputs and reads those of outputs; an element may also be wired to a bit of a port, and an output linked to inputs.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use technol_image::service::Service;
use technol_runtime::{Call, FaultKind, Rate};

use crate::signal::Signal;

mod cell;
pub(crate) mod config;
mod link;
mod mapping;
mod name;
mod point;
mod realtime;
mod value;

use link::Link;
pub(super) use link::names_a_bit;
pub use mapping::{Analog, ChannelWiring, Connection, Mapping, Physical};
pub(crate) use name::normal as identifier;
use point::{Group, Point};
pub(super) use value::CellType;
pub use value::ElementValue;

/// Elements of each direction; more than any configuration has.
const MAX_ELEMENTS: usize = 100_000;
/// Characters of an identifier.
const MAX_NAME: usize = 255;
/// Bytes of a text or block.
const MAX_BYTES: usize = 65_536;
/// Links from outputs to inputs.
const MAX_LINKS: usize = 10_000;

/// Why an element cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementError {
    /// The identifier is empty, longer than 255 characters or not ASCII.
    BadName,
    /// There are too many elements or links.
    TooMany,
    /// A text or block of more than 65536 bytes.
    TooLong,
}

impl fmt::Display for ElementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ElementError::BadName => "an identifier has 1 to 255 ASCII characters",
            ElementError::TooMany => {
                "there are too many inputs, outputs or links that are named by identifiers"
            }
            ElementError::TooLong => "a text or block has at most 65536 bytes",
        })
    }
}

impl core::error::Error for ElementError {}

/// What a link does to the value (manual 27.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conversion {
    /// A bit is negated.
    pub invert: bool,
    /// A number is multiplied…
    pub scale: f64,
    /// …and this is added.
    pub offset: f64,
}

impl Default for Conversion {
    fn default() -> Conversion {
        Conversion { invert: false, scale: 1.0, offset: 0.0 }
    }
}

impl Conversion {
    fn apply(&self, value: &ElementValue) -> ElementValue {
        if self.invert {
            return (!value.is_on()).into();
        }
        match value.as_real() {
            Some(real) if *self != Conversion::default() => (real * self.scale + self.offset).into(),
            _ => value.clone(),
        }
    }
}

/// A bit of a port behind an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Wire {
    /// Address of its byte in PLC memory.
    addr: usize,
    mask: u8,
    invert: bool,
}

#[derive(Clone, Debug, Default)]
struct Element {
    /// An input: what was set or linked. An output: what left the program.
    value: Option<ElementValue>,
    /// An input: single bits that were linked to it, over the value; which, and what they are.
    bits: (u64, u64),
    wire: Option<Wire>,
    /// An output: it was served just now.
    served: bool,
    /// An output of a bus: it may change at any time.
    live: bool,
}

#[derive(Clone, Debug, Default)]
struct Table {
    numbers: BTreeMap<String, usize>,
    elements: Vec<Element>,
}

impl Table {
    /// The number of the element of this name, which is made when there is none.
    fn number(&mut self, name: &str) -> Result<usize, ElementError> {
        if let Some(number) = self.numbers.get(name) {
            return Ok(*number);
        }
        let number = self.elements.len();
        if number >= MAX_ELEMENTS {
            return Err(ElementError::TooMany);
        }
        self.elements.push(Element::default());
        self.numbers.insert(name.into(), number);
        Ok(number)
    }
}

/// All elements, and the cells of the program that are bound to them.
#[derive(Clone, Debug, Default)]
pub(super) struct Elements {
    inputs: Table,
    outputs: Table,
    links: Vec<Link>,
    points: Vec<Point>,
    wiring: ChannelWiring,
}

impl Elements {
    pub(super) fn set_input(&mut self, id: &str, value: ElementValue) -> Result<(), ElementError> {
        if matches!(&value, ElementValue::Bytes(bytes) if bytes.len() > MAX_BYTES) {
            return Err(ElementError::TooLong);
        }
        let number = self.inputs.number(&name::normal(id.as_bytes())?)?;
        self.inputs.elements[number].value = Some(value);
        Ok(())
    }

    pub(super) fn output(&self, id: &str) -> Option<&ElementValue> {
        let number = self.outputs.numbers.get(&name::normal(id.as_bytes()).ok()?)?;
        self.outputs.elements[*number].value.as_ref()
    }

    pub(super) fn wire(&mut self, id: &str, to: Signal, invert: bool) -> Result<(), ElementError> {
        let name = name::normal(id.as_bytes())?;
        let table = match to {
            Signal::Input { .. } => &mut self.inputs,
            Signal::Output { .. } => &mut self.outputs,
        };
        let number = table.number(&name)?;
        table.elements[number].wire = Some(Wire::to(to, invert));
        Ok(())
    }

    /// The PLC starts: nothing is declared, no output has a value. The world around stays.
    pub(super) fn start(&mut self) {
        self.points.retain(|point| point.fixed);
        for output in &mut self.outputs.elements {
            output.value = None;
        }
    }

    /// MAP_IN, MAP_OUT, MAP_AIN, MAP_AOUT, DEF_IN, DEF_OUT.
    pub(super) fn declare(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let group = match call.service() {
            Service::DefIn | Service::DefOut => Group::Logical,
            _ => Group::Mapped,
        };
        let output = matches!(call.service(), Service::MapOut | Service::MapAout | Service::DefOut);
        let Some((mut point, mut cells)) = Point::declared(call, group, output)? else { return Ok(()) };
        // Executed again, the same line binds anew.
        self.points.retain(|known| known.call != point.call);
        // An identifier that a text buffer does not hold: the cell keeps its default.
        let bound = match call.text(1)?.map(name::normal) {
            Some(Ok(name)) => self.bind(&mut point, &name).is_ok(),
            _ => false,
        };
        let bit = point.is_mapped_bit();
        let mapping = call.text(1)?.and_then(|id| self.wiring.find(id, group, output, bit));
        match mapping {
            Some(mapping) if mapping.connected => point.physical = Some(mapping.physical),
            Some(mapping) => point.kind.write(&mut cells, &mapping.default.into()),
            None => {}
        }
        if bound && !point.output && point.rate.is_some() {
            for (cell, number) in cells.chunks_exact_mut(point.size).zip(&point.elements) {
                let element = &self.inputs.elements[*number];
                let physical = physical(element, point.physical, call.memory_mut());
                put(element, point.kind, cell, physical.as_ref());
            }
        }
        call.write(point.addr as u32, &cells)?;
        if bound {
            self.points.push(point);
        }
        Ok(())
    }

    fn bind(&mut self, point: &mut Point, name: &str) -> Result<(), ElementError> {
        let table = if point.output { &mut self.outputs } else { &mut self.inputs };
        for n in 0..point.count() {
            let number = if n == 0 { table.number(name)? } else { table.number(&format!("{name}[{n}]"))? };
            point.elements.push(number);
        }
        Ok(())
    }

    /// UPDATE_IN: the elements in the range of the operand, each from its source as that is now.
    pub(super) fn update(&mut self, call: &mut Call<'_>) -> Result<(), FaultKind> {
        let Some((addr, len)) = call.area(0)? else { return Ok(()) };
        let (addr, end) = (addr as usize, addr as usize + len as usize);
        let Elements { inputs, outputs, links, points, .. } = self;
        for point in points.iter().filter(|point| !point.output && !point.fixed) {
            for (n, number) in point.elements.iter().enumerate() {
                let at = point.addr + n * point.size;
                if at < addr || at + point.size > end {
                    continue;
                }
                for link in links.iter().filter(|link| link.destination == *number) {
                    pull(call, points, link.source, &mut outputs.elements)?;
                    link.follow(&outputs.elements, &mut inputs.elements);
                }
                let element = &inputs.elements[*number];
                let physical = physical(element, point.physical, call.memory_mut());
                call.bytes(at as u32, point.size as u32)?;
                if let Some(cell) = call.memory_mut().get_mut(at..at + point.size) {
                    put(element, point.kind, cell, physical.as_ref());
                }
            }
        }
        Ok(())
    }

    /// Serves what is due at a rate. Mapped inputs are copied before the modules and mapped outputs after them, links both
    /// times.
    pub(super) fn serve(&mut self, rate: Rate, before: bool, memory: &mut [u8]) {
        self.send(rate, before, memory);
        let Elements { inputs, outputs, links, .. } = self;
        for link in links.iter() {
            let source = &outputs.elements[link.source];
            if source.served || source.live {
                link.follow(&outputs.elements, &mut inputs.elements);
            }
        }
        self.fetch(rate, before, memory);
    }

    fn send(&mut self, rate: Rate, before: bool, memory: &mut [u8]) {
        let elements = &mut self.outputs.elements;
        for element in elements.iter_mut() {
            element.served = false;
        }
        let mut bits = false;
        for point in self.points.iter_mut().filter(|point| point.output && point.is_due(rate, before)) {
            for (n, number) in point.elements.iter().enumerate() {
                let at = point.addr + n * point.size;
                let cell = memory.get(at..at + point.size);
                let Some(value) = cell.and_then(|cell| point.kind.read(cell)) else { continue };
                let value = point.in_its_unit(value);
                if point.is_mapped_bit() {
                    point.on = value.is_on();
                    bits = true;
                }
                elements[*number].value = Some(value);
                elements[*number].served = true;
            }
        }
        // Several bits may drive one output: it is on when any of them is.
        if bits {
            let mapped = self.points.iter().filter(|point| point.output && point.is_mapped_bit() && point.on);
            for number in mapped.flat_map(|point| &point.elements) {
                elements[*number].value = Some(true.into());
            }
        }
        for element in elements.iter().filter(|element| element.served) {
            if let (Some(wire), Some(value)) = (element.wire, &element.value) {
                wire.write(value.is_on(), memory);
            }
        }
        self.send_to_channel(rate, before, memory);
    }

    /// Outputs that the configuration of the channel leads to ports and analogue outputs. The machine's wiring of an
    /// identifier replaces that.
    fn send_to_channel(&self, rate: Rate, before: bool, memory: &mut [u8]) {
        let elements = &self.outputs.elements;
        let wired = |point: &Point| point.elements.iter().any(|number| elements[*number].wire.is_some());
        let mine = |point: &&Point| point.output && point.physical.is_some() && !wired(point);
        for point in self.points.iter().filter(|point| point.is_due(rate, before)).filter(mine) {
            let Some(physical) = point.physical else { continue };
            let Some(wire) = physical.wire() else {
                if let Some(value) = point.elements.first().and_then(|n| elements[*n].value.as_ref()) {
                    physical.write_volts(value, memory);
                }
                continue;
            };
            // A bit with several outputs is on when any of them is.
            let same = |other: &&Point| {
                other.physical.and_then(|it| it.wire()).is_some_and(|it| it.is_same_bit(&wire))
            };
            let on = self.points.iter().filter(mine).filter(same).any(|point| point.on);
            wire.write(on, memory);
        }
    }

    fn fetch(&self, rate: Rate, before: bool, memory: &mut [u8]) {
        for point in self.points.iter().filter(|point| !point.output && point.is_due(rate, before)) {
            for (n, number) in point.elements.iter().enumerate() {
                let element = &self.inputs.elements[*number];
                let physical = physical(element, point.physical, memory);
                let at = point.addr + n * point.size;
                if let Some(cell) = memory.get_mut(at..at + point.size) {
                    match element.value.as_ref().and_then(|value| point.in_its_cell(value)) {
                        Some(value) => point.kind.write(cell, &value),
                        None => put(element, point.kind, cell, physical.as_ref()),
                    }
                }
            }
        }
    }
}

/// The value of an input at its physical end, unless a value was set or linked.
fn physical(element: &Element, mapped: Option<Physical>, memory: &[u8]) -> Option<ElementValue> {
    match (&element.value, element.wire, mapped) {
        (Some(_), ..) => None,
        (None, Some(wire), _) => wire.read(memory),
        (None, None, mapped) => mapped?.read(memory),
    }
}

/// The value of an input into its cell; without a source the cell stays.
fn put(element: &Element, kind: CellType, cell: &mut [u8], physical: Option<&ElementValue>) {
    if let Some(value) = element.value.as_ref().or(physical) {
        kind.write(cell, value);
    }
    let (mask, bits) = element.bits;
    if mask != 0
        && let CellType::Int { .. } = kind
        && let Some(ElementValue::Int(now)) = kind.read(cell)
    {
        kind.write(cell, &ElementValue::Int(now & !i128::from(mask) | i128::from(bits)));
    }
}

/// Takes an output from its cell at once, whatever its period.
fn pull(call: &Call<'_>, points: &[Point], source: usize, outputs: &mut [Element]) -> Result<(), FaultKind> {
    for point in points.iter().filter(|point| point.output && point.group == Group::Logical) {
        if let Some(n) = point.elements.iter().position(|number| *number == source) {
            let cell = call.bytes((point.addr + n * point.size) as u32, point.size as u32)?;
            outputs[source].value = point.kind.read(cell);
        }
    }
    Ok(())
}
