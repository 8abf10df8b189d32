//! `technol target`: a runtime target that a debugger connects to.

use std::io::Write as _;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::TERM_SIGNALS;
use signal_hook::flag;

use technol_target::{
    Address, Clock, Link, Notice, Recording, RemoteFolder, SerialPlace, TargetCore, TargetOptions,
};

use crate::arguments::{ClockName, TargetArguments};
use crate::exit::{self, Failure, Outcome};
use crate::files::Project;

/// Serves debuggers until the process is ended. Ended by a signal it is switched off as a control would be: MODULE_DONE, then
/// what is kept is saved.
pub(crate) fn target(arguments: &TargetArguments) -> Outcome {
    let program = match &arguments.image {
        Some(path) => Some(read_image(path)?.program),
        None => None,
    };
    let machine = match &arguments.machine {
        Some(path) => Some(technol_target::load_machine(path).map_err(|e| Failure::usage(e.to_string()))?),
        None => None,
    };
    let project = arguments.configuration.as_deref().map(Project::open).transpose()?;
    if let Some(project) = &project {
        crate::build::configuration_errors(project)?;
    }
    let (data, keep) = crate::control_data::control_data(
        project.as_ref().map(|project| &*project.loaded),
        machine.as_ref().zip(arguments.machine.as_deref()),
        arguments.backup.clone(),
    )
    .map_err(Failure::usage)?;
    let clock = match arguments.clock {
        ClockName::Real => Clock::Real,
        ClockName::Virtual => Clock::Virtual,
    };
    let log = crate::control_data::event_log(arguments.log.as_deref(), clock == Clock::Real)?;
    let files = arguments.files.as_deref().map(RemoteFolder::new).transpose();
    let files = files.map_err(|e| Failure::usage(e.to_string()))?;
    let start = arguments.start;
    let options = TargetOptions { clock, machine, data, keep, log, program, start, files };
    let recording = arguments.record.as_deref().map(Recording::create).transpose();
    let recording = recording.map_err(|e| Failure::usage(e.to_string()))?;
    let mut record = |link: Box<dyn Link>| -> Box<dyn Link> {
        match &recording {
            Some(recording) => Box::new(recording.of(link, true)),
            None => link,
        }
    };
    let mut core = TargetCore::new(options).map_err(|e| Failure::usage(e.to_string()))?;
    let shutdown = ended_by_signal()?;
    let mut tell = |notice: Notice| {
        let mut out = std::io::stdout().lock();
        // Whoever started the target may have closed its output.
        let _ = writeln!(out, "{notice}").and_then(|()| out.flush());
    };
    let ended = match (&arguments.serial, &arguments.listen) {
        (Some(serial), _) => {
            let place = serial_device(serial)?;
            technol_target::serve_serial(place, &mut record, &mut core, &shutdown, &mut tell)
        }
        (None, listen) => {
            let (host, port) = crate::dap::tcp_address(listen.as_deref().unwrap_or_default())?;
            let address = Address::Tcp { host: host.clone(), port };
            let token = crate::remote::token(arguments.token_file.as_deref(), Some(&address))?;
            technol_target::listen_tcp(
                &host,
                port,
                token.as_ref(),
                &mut record,
                &mut core,
                &shutdown,
                &mut tell,
            )
        }
    };
    ended.map_err(|e| Failure::usage(e.to_string()))?;
    core.shut_down().map_err(Failure::usage)?;
    Ok(exit::OK)
}

/// A flag that Ctrl-C and the signal that ends a process set; the second time they end it at once.
fn ended_by_signal() -> Result<Arc<AtomicBool>, Failure> {
    let ended = Arc::new(AtomicBool::new(false));
    for signal in TERM_SIGNALS {
        // In this order: a flag that is set already makes the first of them end the process.
        flag::register_conditional_shutdown(*signal, 128 + signal, Arc::clone(&ended))
            .and_then(|_| flag::register(*signal, Arc::clone(&ended)))
            .map_err(|e| Failure::usage(format!("cannot wait for signals: {e}")))?;
    }
    Ok(ended)
}

/// Reads an image file.
pub(crate) fn read_image(path: &Path) -> Result<technol_image::Image, Failure> {
    let bytes = std::fs::read(path)
        .map_err(|e| Failure::usage(format!("{}: {e}; `technol build` writes images", path.display())))?;
    technol_image::decode(&bytes)
        .map_err(|e| Failure::usage(format!("{}: {e} (`technol build` writes images)", path.display())))
}

/// `DEVICE[@BAUD][,rtscts]`, with or without `serial:`.
fn serial_device(text: &str) -> Result<SerialPlace, Failure> {
    let address = format!("serial:{}", text.strip_prefix("serial:").unwrap_or(text));
    match address.parse::<Address>() {
        Ok(Address::Serial { device, baud, flow }) => Ok(SerialPlace::new(&device, baud, flow)),
        Ok(_) => Err(Failure::usage(format!("`{text}` is not a serial device"))),
        Err(error) => Err(Failure::usage(error.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_serial_device_may_name_its_baud_rate() {
        let read =
            |text: &str| serial_device(text).map(|place| place.address().to_string()).map_err(|e| e.message);
        assert_eq!(read("/dev/ttyUSB0").unwrap(), "serial:/dev/ttyUSB0@115200");
        assert_eq!(read("COM3@9600,rtscts").unwrap(), "serial:COM3@9600,rtscts");
        assert_eq!(read("serial:/dev/ttyS1@57600").unwrap(), "serial:/dev/ttyS1@57600");
        assert!(read("/dev/ttyS1@fast").unwrap_err().contains("serial"));
    }
}
