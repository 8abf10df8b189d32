//! `[[input]]`, `[[output]]` and `[[link]]` of `machine.toml`.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use serde::Deserialize;

use super::link::is_missing;
use super::{Conversion, ElementError, ElementValue, Elements, name};
use crate::MachineConfig;
use crate::compile::Compiler;
use crate::signal::Signal;

/// An input that the program names by an identifier: wired to a bit of a port, or of a fixed value.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Input {
    /// Its identifier.
    pub id: String,
    /// The bit of an input port…
    pub port: Option<String>,
    /// …which is negated.
    #[serde(default)]
    pub invert: bool,
    /// Its value instead.
    pub value: Option<Value>,
}

/// An output that the program names by an identifier, wired to a bit of a port.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Output {
    /// Its identifier.
    pub id: String,
    /// The bit of an output port.
    pub port: String,
    /// The bit is 1 while the output is 0.
    #[serde(default)]
    pub invert: bool,
}

/// A link from an output of the program to an input of it.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Link {
    /// Identifier of the output.
    pub source: String,
    /// Identifier of the input.
    pub destination: String,
    /// A bit is negated.
    #[serde(default)]
    pub invert: bool,
    /// A number is multiplied by this; 1 unless given.
    pub scale: Option<Number>,
    /// This is added to a number; 0 unless given.
    pub offset: Option<Number>,
}

/// A number. Two of them are equal when their bits are.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(transparent)]
pub struct Number(pub f64);

impl PartialEq for Number {
    fn eq(&self, other: &Number) -> bool {
        self.0.to_bits() == other.0.to_bits()
    }
}

impl Eq for Number {}

/// The value of an input.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// A bit.
    Bit(bool),
    /// An integer.
    Int(i64),
    /// A real.
    Real(Number),
    /// A text.
    Text(String),
}

impl From<&Value> for ElementValue {
    fn from(value: &Value) -> ElementValue {
        match value {
            Value::Bit(value) => (*value).into(),
            Value::Int(value) => (*value).into(),
            Value::Real(value) => value.0.into(),
            Value::Text(text) => text.as_bytes().into(),
        }
    }
}

/// Reports what is wrong in these tables.
pub(crate) fn check(config: &MachineConfig, compiler: &mut Compiler<'_>) {
    let mut known = Vec::new();
    for (n, input) in config.input.iter().enumerate() {
        compiler.enter("input", Some(n));
        unique(compiler, "id", &input.id, &mut known);
        match (&input.port, &input.value) {
            (Some(port), None) => {
                if compiler.input("port", port).is_some() && port.parse::<Signal>().is_err() {
                    compiler
                        .error("port", format!("`{port}` is no port; join it to the input by `[[link]]`"));
                }
            }
            (None, Some(Value::Text(text))) if !text.is_ascii() => {
                compiler.error("value", "a text must be ASCII");
            }
            (None, Some(_)) if input.invert => compiler.error("invert", "belongs to `port`"),
            (None, Some(_)) => {}
            _ => compiler.error("", "needs either `port` or `value`"),
        }
    }
    known.clear();
    for (n, output) in config.output.iter().enumerate() {
        compiler.enter("output", Some(n));
        unique(compiler, "id", &output.id, &mut known);
        if compiler.output("port", &output.port).is_some() && output.port.parse::<Signal>().is_err() {
            compiler
                .error("port", format!("`{}` is no port; join the output to it by `[[link]]`", output.port));
        }
    }
    known.clear();
    for (n, link) in config.link.iter().enumerate() {
        compiler.enter("link", Some(n));
        unique(compiler, "destination", &link.destination, &mut known);
        if let Err(error) = name::normal(link.source.as_bytes()) {
            compiler.error("source", format!("{error}"));
        }
        for (key, id) in [("source", &link.source), ("destination", &link.destination)] {
            if is_missing(id) {
                compiler.error(key, format!("`{id}` is an element that the simulated control does not have"));
            }
        }
        for (key, number) in [("scale", link.scale), ("offset", link.offset)] {
            match number {
                Some(Number(number)) if !number.is_finite() => compiler.error(key, "must be a finite number"),
                Some(_) if link.invert => compiler.error(key, "does not go with `invert`, which makes a bit"),
                _ => {}
            }
        }
    }
}

fn unique(compiler: &mut Compiler<'_>, key: &'static str, id: &str, known: &mut Vec<String>) {
    match name::normal(id.as_bytes()) {
        Ok(name) if known.contains(&name) => {
            compiler.error(key, format!("`{id}` is described twice"));
        }
        Ok(name) => known.push(name),
        Err(error) => compiler.error(key, format!("{error}")),
    }
}

impl Elements {
    /// The elements of a machine whose description was checked.
    pub(in crate::control) fn of(machine: &MachineConfig) -> Elements {
        let mut elements = Elements::default();
        // What would be an error here was reported when the machine was compiled.
        let _ = elements.take(machine);
        elements
    }

    fn take(&mut self, machine: &MachineConfig) -> Result<(), ElementError> {
        for input in &machine.input {
            if let Some(value) = &input.value {
                self.set_input(&input.id, value.into())?;
            } else if let Some(Ok(port)) = input.port.as_deref().map(str::parse::<Signal>) {
                self.wire(&input.id, port, input.invert)?;
            }
        }
        for output in &machine.output {
            if let Ok(port) = output.port.parse::<Signal>() {
                self.wire(&output.id, port, output.invert)?;
            }
        }
        for link in &machine.link {
            let usual = Conversion::default();
            let conversion = Conversion {
                invert: link.invert,
                scale: link.scale.map_or(usual.scale, |number| number.0),
                offset: link.offset.map_or(usual.offset, |number| number.0),
            };
            self.connect(&link.source, &link.destination, conversion)?;
        }
        Ok(())
    }
}
