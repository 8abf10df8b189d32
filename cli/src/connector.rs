//! Brings the debug adapter to its targets: in this process, over TCP, over a serial line.

use std::io;
use std::time::Duration;

use technol_dap::{ByteLink, Clock, Connector, TargetSpec};
use technol_target::{Address, Link, TargetHandle, TargetOptions};

/// Opens the links of technol-target for the adapter.
pub(crate) struct Targets;

/// A link, and the embedded target at its other end when there is one.
struct Wire {
    link: Box<dyn Link>,
    /// Ends the embedded target together with the link.
    _target: Option<TargetHandle>,
}

impl ByteLink for Wire {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.link.send(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.link.receive(buffer, timeout)
    }
}

impl Connector for Targets {
    fn connect(&self, target: &TargetSpec) -> Result<Box<dyn ByteLink>, String> {
        match target {
            TargetSpec::Embedded { machine, clock } => {
                let machine = match machine {
                    Some(path) => Some(technol_target::load_machine(path).map_err(|e| e.to_string())?),
                    None => None,
                };
                let clock = match clock {
                    Clock::Real => technol_target::Clock::Real,
                    Clock::Virtual => technol_target::Clock::Virtual,
                };
                let options = TargetOptions { clock, machine, ..TargetOptions::default() };
                let (link, handle) = technol_target::spawn_embedded(options).map_err(|e| e.to_string())?;
                Ok(Box::new(Wire { link: Box::new(link), _target: Some(handle) }))
            }
            TargetSpec::Address(text) => {
                let address: Address = text.parse().map_err(|e| format!("{e}"))?;
                let link = technol_target::connect(&address).map_err(|e| e.to_string())?;
                Ok(Box::new(Wire { link, _target: None }))
            }
        }
    }
}
