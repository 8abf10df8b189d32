//! Links from outputs to inputs (manual 27.5).

use super::mapping::ChannelWiring;
use super::point::Point;
use super::{Conversion, Element, ElementError, ElementValue, Elements, MAX_LINKS, cell, name};

/// A link between two elements, or single bits of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub(super) source: usize,
    source_bit: Option<u8>,
    pub(super) destination: usize,
    bit: Option<u8>,
    conversion: Conversion,
    /// Of the configuration files, not of the machine or host.
    configured: bool,
}

impl Link {
    /// The source's value to the destination, when it has one.
    pub(super) fn follow(&self, outputs: &[Element], inputs: &mut [Element]) {
        let Some(value) = &outputs[self.source].value else { return };
        let value = match self.source_bit {
            Some(bit) => self.conversion.apply(&bit_of(value, bit).into()),
            None => self.conversion.apply(value),
        };
        let destination = &mut inputs[self.destination];
        let Some(bit) = self.bit else {
            destination.value = Some(value);
            return;
        };
        let mask = 1 << bit;
        destination.bits.0 |= mask;
        destination.bits.1 = destination.bits.1 & !mask | u64::from(value.is_on()) << bit;
    }
}

fn bit_of(value: &ElementValue, bit: u8) -> bool {
    match value {
        ElementValue::Int(value) => value >> bit & 1 != 0,
        ElementValue::Real(value) => *value as i128 >> bit & 1 != 0,
        ElementValue::Bytes(_) => false,
    }
}

/// An element of the control that the simulated one does not have: a link to it would carry nothing.
pub(super) fn is_missing(text: &str) -> bool {
    let name = name::normal(text.as_bytes()).unwrap_or_default();
    cell::is_of_control(&name) && cell::find(split(&name).0).is_none()
}

/// A normal identifier that ends as one bit of a number does.
pub(in crate::control) fn names_a_bit(name: &str) -> bool {
    split(name).1.is_some()
}

/// An identifier without the `.bit[n]` at its end, and n.
fn split(name: &str) -> (&str, Option<u8>) {
    let Some((base, last)) = name.rsplit_once(".bit") else { return (name, None) };
    let digits = last.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    let bit = if last.is_empty() { Some(0) } else { digits.and_then(|digits| digits.parse().ok()) };
    match bit {
        Some(bit) if bit < 64 && !base.is_empty() => (base, Some(bit)),
        _ => (name, None),
    }
}

impl Elements {
    pub(in crate::control) fn connect(
        &mut self,
        source: &str,
        destination: &str,
        conversion: Conversion,
    ) -> Result<(), ElementError> {
        let link = self.link(source, destination, conversion)?;
        // An input has one source.
        self.links.retain(|it| (it.destination, it.bit) != (link.destination, link.bit));
        self.links.push(link);
        Ok(())
    }

    /// Takes what the configuration files say instead of what they said before. Links that the machine or the host made to
    /// the same input stay.
    pub(in crate::control) fn configure(&mut self, wiring: ChannelWiring) -> Result<(), ElementError> {
        self.links.retain(|link| !link.configured);
        for it in &wiring.connections {
            let link = self.link(&it.source, &it.destination, it.conversion)?;
            if self.links.iter().all(|it| (it.destination, it.bit) != (link.destination, link.bit)) {
                self.links.push(Link { configured: true, ..link });
            }
        }
        self.wiring = wiring;
        Ok(())
    }

    /// What the configuration files say.
    pub(in crate::control) fn wiring(&self) -> &ChannelWiring {
        &self.wiring
    }

    fn link(
        &mut self,
        source: &str,
        destination: &str,
        conversion: Conversion,
    ) -> Result<Link, ElementError> {
        if self.links.len() >= MAX_LINKS {
            return Err(ElementError::TooMany);
        }
        let (source, source_bit) = self.end(source, true)?;
        let (destination, bit) = self.end(destination, false)?;
        Ok(Link { source, source_bit, destination, bit, conversion, configured: false })
    }

    /// The element that an end of a link names; one of the control itself is bound to its cell.
    fn end(&mut self, text: &str, output: bool) -> Result<(usize, Option<u8>), ElementError> {
        let whole = name::normal(text.as_bytes())?;
        let (name, bit) = split(&whole);
        let table = if output { &mut self.outputs } else { &mut self.inputs };
        let number = table.number(name)?;
        if let Some(cell) = cell::find(name) {
            let bound = |it: &Point| it.fixed && it.output == output && it.elements == [number];
            if !self.points.iter().any(bound) {
                self.points.push(Point::fixed(cell, output, number));
            }
        }
        Ok((number, bit))
    }

    /// An output that a bus gives, by its identifier.
    pub(in crate::control) fn bus_output(&mut self, id: &str) -> Result<usize, ElementError> {
        let number = self.outputs.number(&name::normal(id.as_bytes())?)?;
        self.outputs.elements[number].live = true;
        Ok(number)
    }

    /// An input that a bus takes, by its identifier.
    pub(in crate::control) fn bus_input(&mut self, id: &str) -> Result<usize, ElementError> {
        self.inputs.number(&name::normal(id.as_bytes())?)
    }

    /// The bytes of an output of a bus.
    pub(in crate::control) fn set_bus_output(&mut self, number: usize, kind: super::CellType, bytes: &[u8]) {
        if let (Some(element), Some(value)) = (self.outputs.elements.get_mut(number), kind.read(bytes)) {
            element.value = Some(value);
        }
    }

    /// The bytes that an input of a bus gets.
    pub(in crate::control) fn bus_input_bytes(&self, number: usize, kind: super::CellType, bytes: &mut [u8]) {
        if let Some(element) = self.inputs.elements.get(number) {
            super::put(element, kind, bytes, None);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::split;

    #[test]
    fn a_bit_may_stand_behind_a_name() {
        for (name, expected) in [
            ("bun", ("bun", None)),
            ("bun.bit[7]", ("bun", Some(7))),
            ("bun.bit", ("bun", Some(0))),
            ("bun[3].bit[12]", ("bun[3]", Some(12))),
            ("bun.bit[64]", ("bun.bit[64]", None)),
            ("bun.bits", ("bun.bits", None)),
            ("a.bit[2].c", ("a.bit[2].c", None)),
        ] {
            assert_eq!(split(name), expected);
        }
    }
}
