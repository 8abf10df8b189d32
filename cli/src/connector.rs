//! Brings the debug adapter to its targets: in this process, over TCP, over a serial line.

use std::io;
use std::path::PathBuf;
use std::time::Duration;

use technol_dap::{ByteLink, Clock, Connector, Disk, TargetSpec};
use technol_target::{Address, Link, TargetHandle, TargetOptions};

/// Opens the links of technol-target for the adapter.
pub(crate) struct Targets {
    /// Where an embedded target keeps PLC_MEM_BACKUP; without it where the machine file says.
    pub(crate) backup: Option<PathBuf>,
}

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
            TargetSpec::Embedded { project, machine: file, clock } => {
                let machine = match file {
                    Some(path) => Some(technol_target::load_machine(path).map_err(|e| e.to_string())?),
                    None => None,
                };
                // A lone file has no configuration.
                let manifest = project.join("technol.toml");
                let loaded = manifest
                    .is_file()
                    .then(|| technol_analysis::project::load(&manifest.to_string_lossy(), &Disk));
                let (data, keep) = crate::control_data::control_data(
                    loaded.as_ref(),
                    machine.as_ref().zip(file.as_deref()),
                    self.backup.clone(),
                )?;
                let clock = match clock {
                    Clock::Real => technol_target::Clock::Real,
                    Clock::Virtual => technol_target::Clock::Virtual,
                };
                let options = TargetOptions { clock, machine, data, keep, ..TargetOptions::default() };
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
