//! What drives an element: one output, or any of several.

use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};

use crate::signal::{OUTPUT_PORTS, OutputBit};

/// Names of outputs; the element is driven while any of them is on. Written as `"P0OUT.0"` or
/// `["P0OUT.0", "P0OUT.1"]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outputs(pub Vec<String>);

impl<'de> Deserialize<'de> for Outputs {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Names;
        impl<'de> Visitor<'de> for Names {
            type Value = Outputs;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of an output, such as \"P0OUT.0\", or a list of them")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<Outputs, E> {
                Ok(Outputs(vec![name.into()]))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Outputs, A::Error> {
                let mut names = Vec::new();
                while let Some(name) = list.next_element()? {
                    names.push(name);
                }
                Ok(Outputs(names))
            }
        }
        deserializer.deserialize_any(Names)
    }
}

/// The bits behind [`Outputs`].
#[derive(Clone, Debug)]
pub(crate) struct Drive(pub(crate) Vec<OutputBit>);

impl Drive {
    pub(crate) fn is_on(&self, outputs: &[u8; OUTPUT_PORTS]) -> bool {
        self.0.iter().any(|bit| bit.get(outputs))
    }
}
