//! What drives an element: one output or signal, or any of several.

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};

use crate::analog::Volts;
use crate::signal::{InputImage, OutputBit, OutputImage, Signal};

/// Names of outputs; the element is driven while any of them is on. Written as `"P0OUT.0"` or
/// `["P0OUT.0", "P0OUT.1"]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outputs(pub Vec<String>);

impl<'de> Deserialize<'de> for Outputs {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Names("output, such as \"P0OUT.0\"")).map(Outputs)
    }
}

/// Names of inputs and outputs; any of them counts. Written as `"P1IN.0"` or `["P1IN.0", "P0OUT.1"]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signals(pub Vec<String>);

impl<'de> Deserialize<'de> for Signals {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Names("input or output, such as \"P1IN.0\"")).map(Signals)
    }
}

/// One name or a list of them.
pub(crate) fn names<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<String>, D::Error> {
    deserializer.deserialize_any(Names("port, such as \"P8IN\""))
}

/// Reads one name or a list of them; tells of what kind.
struct Names(&'static str);

impl<'de> Visitor<'de> for Names {
    type Value = Vec<String>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the name of an {}, or a list of them", self.0)
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Vec<String>, E> {
        Ok(vec![name.into()])
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<String>, A::Error> {
        let mut names = Vec::new();
        while let Some(name) = list.next_element()? {
            names.push(name);
        }
        Ok(names)
    }
}

/// The bits behind [`Outputs`].
#[derive(Clone, Debug)]
pub(crate) struct Drive(pub(crate) Vec<OutputBit>);

impl Drive {
    pub(crate) fn is_on(&self, outputs: &OutputImage) -> bool {
        self.0.iter().any(|bit| bit.get(outputs))
    }
}

/// The bits behind [`Signals`].
#[derive(Clone, Debug)]
pub(crate) struct Watch(pub(crate) Vec<Signal>);

impl Watch {
    pub(crate) fn is_on(&self, world: World<'_>) -> bool {
        self.0.iter().any(|signal| world.is_on(*signal))
    }
}

/// What elements see in a millisecond: the outputs, and the inputs as the PLC saw them in the one before. So the order
/// of the elements does not count.
#[derive(Clone, Copy)]
pub(crate) struct World<'a> {
    pub(crate) outputs: &'a OutputImage,
    pub(crate) before: &'a InputImage,
    pub(crate) volts: &'a Volts,
}

impl World<'_> {
    pub(crate) fn is_on(self, signal: Signal) -> bool {
        let (byte, bit) = match signal {
            Signal::Input { port, bit } => (self.before[usize::from(port)], bit),
            Signal::Output { port, bit } => (self.outputs[usize::from(port)], bit),
        };
        byte >> bit & 1 != 0
    }
}
