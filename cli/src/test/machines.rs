//! The machines that tests run against.

use std::path::{Path, PathBuf};

use technol_machine::{INPUT_PORTS, MachineConfig, OUTPUT_PORTS, Plant};
use technol_target::{MachineFileError, parse_machine};

use super::watch::Look;

/// A machine and what tests may name of it.
#[derive(Debug, Default)]
pub(super) struct Machine {
    pub(super) config: Option<MachineConfig>,
    pub(super) keys: Vec<String>,
    pub(super) faults: Vec<String>,
    /// Input bits that the machine decides on.
    driven: Vec<u8>,
    /// It could not be read: nobody knows what keys and faults it has.
    pub(super) unknown: bool,
}

/// Why there is no machine.
#[derive(Debug)]
pub(super) enum Unusable {
    /// Its file cannot be read.
    Missing(String),
    /// What is wrong in it.
    Wrong(Vec<MachineFileError>),
}

/// Every machine once, however many tests use it.
#[derive(Debug, Default)]
pub(super) struct Machines {
    list: Vec<(Choice, Machine)>,
    looked: Look,
}

/// Which machine, and whether its part program runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Choice {
    pub(super) file: Option<PathBuf>,
    pub(super) part_program: bool,
}

impl Machines {
    /// The number of a machine, read unless it is known already.
    ///
    /// # Errors
    /// It cannot be used; told once, then it is one of which nothing is known.
    pub(super) fn number(&mut self, choice: &Choice) -> Result<usize, Unusable> {
        if let Some(known) = self.list.iter().position(|(known, _)| known == choice) {
            return Ok(known);
        }
        let machine = match &choice.file {
            Some(file) => {
                self.looked.add(file.clone());
                match Machine::read(file, choice.part_program) {
                    Ok(machine) => machine,
                    Err(error) => {
                        let unknown = Machine { unknown: true, ..Machine::default() };
                        self.list.push((choice.clone(), unknown));
                        return Err(error);
                    }
                }
            }
            None => Machine::default(),
        };
        self.list.push((choice.clone(), machine));
        Ok(self.list.len() - 1)
    }

    /// A machine as it would be read from a file.
    #[cfg(any(test, feature = "fuzzing"))]
    pub(super) fn add(&mut self, file: &Path, config: &MachineConfig) {
        for part_program in [true, false] {
            let choice = Choice { file: Some(file.to_owned()), part_program };
            self.list.push((choice, Machine::of(config.clone())));
        }
    }

    pub(super) fn get(&self, number: usize) -> &Machine {
        &self.list[number].1
    }

    /// The files that were read, as they were before.
    pub(super) fn looked(&self) -> &Look {
        &self.looked
    }
}

impl Machine {
    fn read(file: &Path, part_program: bool) -> Result<Machine, Unusable> {
        let text = std::fs::read_to_string(file).map_err(|error| {
            let file = file.display();
            Unusable::Missing(match error.kind() {
                std::io::ErrorKind::NotFound => format!("there is no machine file {file}"),
                _ => format!("the machine file {file} cannot be read: {error}"),
            })
        })?;
        let mut config = parse_machine(file, &text).map_err(Unusable::Wrong)?;
        if !part_program {
            config.block.clear();
        }
        Ok(Machine::of(config))
    }

    /// The machine of a description that was checked.
    fn of(config: MachineConfig) -> Machine {
        let plant = Plant::compile(&config, &|name| name.parse().ok()).unwrap_or_default();
        Machine {
            keys: plant.keys().map(|(name, _)| name.to_owned()).collect(),
            faults: plant.faults().map(|(name, _)| name.to_owned()).collect(),
            driven: driven(&plant),
            config: Some(config),
            unknown: false,
        }
    }

    /// Whether the machine itself decides on a bit of an input port; port 0 is P1IN.
    pub(super) fn drives(&self, port: usize, mask: u8) -> bool {
        self.driven.get(port).is_some_and(|bits| bits & mask != 0)
    }
}

/// The bits that come out the same whatever they were before.
fn driven(plant: &Plant) -> Vec<u8> {
    let step = |before: u8| {
        let mut inputs = [before; INPUT_PORTS];
        plant.clone().step(&[0; OUTPUT_PORTS], &mut inputs);
        inputs
    };
    step(0).iter().zip(step(0xFF)).map(|(off, on)| !(off ^ on)).collect()
}
