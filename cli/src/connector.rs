//! Brings the debug adapter to its targets: in this process, over TCP, over a serial line.

use std::collections::HashMap;
use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use technol_dap::{ByteLink, Clock, Connector, Disk, TargetSpec};
use technol_target::{Address, Link, Recording, TargetHandle, TargetOptions};

/// Opens the links of technol-target for the adapter.
pub(crate) struct Targets {
    recording: Option<Recording>,
    /// Ways to targets, by address and file of the token: they find a serial adapter again.
    ways: Mutex<HashMap<(String, Option<PathBuf>), technol_target::Connector>>,
    /// Where an embedded target keeps PLC_MEM_BACKUP; without it where the machine file says.
    backup: Option<PathBuf>,
}

impl Targets {
    pub(crate) fn new(recording: Option<Recording>, backup: Option<PathBuf>) -> Targets {
        Targets { recording, ways: Mutex::default(), backup }
    }

    fn reach(&self, text: &str, token_file: Option<&PathBuf>) -> Result<Box<dyn Link>, String> {
        let key = (text.to_owned(), token_file.cloned());
        let known = self.ways.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
        let mut way = if let Some(way) = known {
            way
        } else {
            let address: Address = text.parse().map_err(|e| format!("{e}"))?;
            let file = token_file.map(PathBuf::as_path);
            let token = crate::remote::token(file, Some(&address)).map_err(|e| e.message)?;
            technol_target::Connector::new(address, token)
        };
        let link = way.connect().map_err(|e| e.to_string())?;
        self.ways.lock().unwrap_or_else(PoisonError::into_inner).insert(key, way);
        Ok(match &self.recording {
            Some(recording) => Box::new(recording.of(link, false)),
            None => link,
        })
    }
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

    fn bytes_per_second(&self) -> Option<u32> {
        self.link.bytes_per_second()
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
            TargetSpec::Address { address, token_file } => {
                let link = self.reach(address, token_file.as_ref())?;
                Ok(Box::new(Wire { link, _target: None }))
            }
        }
    }
}
