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
use technol_image::system;
use technol_runtime::{Call, FaultKind, Rate};

use crate::signal::Signal;

pub(crate) mod config;
mod name;
mod point;
mod value;

use point::{Group, Point};
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
    wire: Option<Wire>,
    /// An output: it was served just now.
    served: bool,
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

#[derive(Clone, Copy, Debug)]
struct Link {
    source: usize,
    destination: usize,
    conversion: Conversion,
}

/// All elements, and the cells of the program that are bound to them.
#[derive(Clone, Debug, Default)]
pub(super) struct Elements {
    inputs: Table,
    outputs: Table,
    links: Vec<Link>,
    points: Vec<Point>,
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
        let (table, first, port, bit) = match to {
            Signal::Input { port, bit } => (&mut self.inputs, system::IN_PORTS, port, bit),
            Signal::Output { port, bit } => (&mut self.outputs, system::OUT_PORTS, port, bit),
        };
        let number = table.number(&name)?;
        let addr = first as usize + usize::from(port);
        table.elements[number].wire = Some(Wire { addr, mask: 1 << bit, invert });
        Ok(())
    }

    pub(super) fn connect(
        &mut self,
        source: &str,
        destination: &str,
        conversion: Conversion,
    ) -> Result<(), ElementError> {
        if self.links.len() >= MAX_LINKS {
            return Err(ElementError::TooMany);
        }
        let source = self.outputs.number(&name::normal(source.as_bytes())?)?;
        let destination = self.inputs.number(&name::normal(destination.as_bytes())?)?;
        // An input has one source.
        self.links.retain(|link| link.destination != destination);
        self.links.push(Link { source, destination, conversion });
        Ok(())
    }

    /// The PLC starts: nothing is declared, no output has a value. The world around stays.
    pub(super) fn start(&mut self) {
        self.points.clear();
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
        if bound && !point.output && point.rate.is_some() {
            for (cell, number) in cells.chunks_exact_mut(point.size).zip(&point.elements) {
                let element = &self.inputs.elements[*number];
                let port =
                    element.wire.and_then(|wire| call.bytes(wire.addr as u32, 1).ok()?.first().copied());
                put(element, &point, cell, port);
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
        let Elements { inputs, outputs, links, points } = self;
        for point in points.iter().filter(|point| !point.output) {
            for (n, number) in point.elements.iter().enumerate() {
                let at = point.addr + n * point.size;
                if at < addr || at + point.size > end {
                    continue;
                }
                if let Some(link) = links.iter().find(|link| link.destination == *number) {
                    pull(call, points, link.source, &mut outputs.elements)?;
                    follow(link, &outputs.elements, &mut inputs.elements);
                }
                let element = &inputs.elements[*number];
                let port = match element.wire {
                    Some(wire) => call.bytes(wire.addr as u32, 1)?.first().copied(),
                    None => None,
                };
                call.bytes(at as u32, point.size as u32)?;
                if let Some(cell) = call.memory_mut().get_mut(at..at + point.size) {
                    put(element, point, cell, port);
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
        for link in links.iter().filter(|link| outputs.elements[link.source].served) {
            follow(link, &outputs.elements, &mut inputs.elements);
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
            let (Some(wire), Some(value)) = (element.wire, &element.value) else { continue };
            if let Some(port) = memory.get_mut(wire.addr) {
                let on = value.is_on() != wire.invert;
                *port = if on { *port | wire.mask } else { *port & !wire.mask };
            }
        }
    }

    fn fetch(&self, rate: Rate, before: bool, memory: &mut [u8]) {
        for point in self.points.iter().filter(|point| !point.output && point.is_due(rate, before)) {
            for (n, number) in point.elements.iter().enumerate() {
                let element = &self.inputs.elements[*number];
                let port = element.wire.and_then(|wire| memory.get(wire.addr).copied());
                let at = point.addr + n * point.size;
                if let Some(cell) = memory.get_mut(at..at + point.size) {
                    put(element, point, cell, port);
                }
            }
        }
    }
}

/// The value of an input into its cell; without a source the cell stays.
fn put(element: &Element, point: &Point, cell: &mut [u8], port: Option<u8>) {
    if let Some(value) = &element.value {
        point.kind.write(cell, value);
    } else if let (Some(wire), Some(port)) = (element.wire, port) {
        point.kind.write(cell, &((port & wire.mask != 0) != wire.invert).into());
    }
}

fn follow(link: &Link, outputs: &[Element], inputs: &mut [Element]) {
    if let Some(value) = &outputs[link.source].value {
        inputs[link.destination].value = Some(link.conversion.apply(value));
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
