//! The serial devices of this computer: their names, what is plugged in there, and how quick it is.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serialport::SerialPortType;

/// A serial device.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Device {
    /// Name to open it by.
    pub port: String,
    /// The USB adapter it is, if it is one.
    pub usb: Option<Usb>,
    /// How long the adapter collects bytes before it hands them over, in milliseconds, where the system tells.
    pub latency_ms: Option<u32>,
}

/// A USB adapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Usb {
    /// Vendor.
    pub vid: u16,
    /// Product.
    pub pid: u16,
    /// The number of this very adapter, if it has one.
    pub serial: Option<String>,
    /// Name of the maker.
    pub maker: Option<String>,
    /// Name of the product.
    pub product: Option<String>,
}

impl Usb {
    /// The text names an adapter, and not a device.
    pub(crate) fn is_name(text: &str) -> bool {
        text.starts_with("usb:")
    }

    /// `usb:VID:PID` or `usb:VID:PID:SERIAL`, hexadecimal, in any case, names this one.
    pub(crate) fn is_named(&self, text: &str) -> bool {
        let whole = self.to_string();
        let make = format!("usb:{:04x}:{:04x}", self.vid, self.pid);
        text.eq_ignore_ascii_case(&whole) || text.eq_ignore_ascii_case(&make)
    }

    /// The same adapter.
    pub(crate) fn is_same(&self, other: &Usb) -> bool {
        (self.vid, self.pid, &self.serial) == (other.vid, other.pid, &other.serial)
    }
}

impl fmt::Display for Usb {
    /// What it can be asked for by, wherever it is plugged in.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "usb:{:04x}:{:04x}", self.vid, self.pid)?;
        self.serial.as_ref().map_or(Ok(()), |serial| write!(f, ":{serial}"))
    }
}

/// All serial devices, by name. None where the system does not tell.
#[must_use]
pub fn devices() -> Vec<Device> {
    let mut devices: Vec<Device> =
        serialport::available_ports().unwrap_or_default().into_iter().map(described).collect();
    devices.sort_by(|a, b| a.port.cmp(&b.port));
    devices
}

fn described(port: serialport::SerialPortInfo) -> Device {
    let usb = match port.port_type {
        SerialPortType::UsbPort(usb) => Some(Usb {
            vid: usb.vid,
            pid: usb.pid,
            serial: usb.serial_number.filter(|s| !s.is_empty()),
            maker: usb.manufacturer,
            product: usb.product,
        }),
        _ => None,
    };
    let timer = latency_file(Path::new(SYSFS), &port.port_name);
    Device { latency_ms: timer.and_then(|file| read_latency(&file)), port: port.port_name, usb }
}

/// Where Linux keeps the settings of USB serial adapters.
const SYSFS: &str = "/sys/bus/usb-serial/devices";

/// The file with the latency timer of a device, when it has one (FTDI on Linux).
fn latency_file(sysfs: &Path, port: &str) -> Option<PathBuf> {
    let name = Path::new(port).file_name()?;
    let file = sysfs.join(name).join("latency_timer");
    file.is_file().then_some(file)
}

fn read_latency(file: &Path) -> Option<u32> {
    fs::read_to_string(file).ok()?.trim().parse().ok()
}

/// Sets the latency timer to its least where there is one; tells what it is then.
pub(crate) fn make_quick(port: &str) -> io::Result<Option<u32>> {
    make_quick_in(Path::new(SYSFS), port)
}

fn make_quick_in(sysfs: &Path, port: &str) -> io::Result<Option<u32>> {
    let Some(file) = latency_file(sysfs, port) else { return Ok(None) };
    if read_latency(&file).is_none_or(|ms| ms > 1) {
        fs::write(&file, "1")?;
    }
    Ok(read_latency(&file))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // tests
mod tests {
    use super::*;

    #[test]
    fn an_adapter_that_collects_bytes_is_made_quick() {
        let sysfs = tempfile::tempdir().unwrap();
        let file = sysfs.path().join("ttyUSB0").join("latency_timer");
        fs::create_dir(file.parent().unwrap()).unwrap();
        fs::write(&file, "16\n").unwrap();
        assert_eq!(make_quick_in(sysfs.path(), "/dev/ttyUSB0").unwrap(), Some(1));
        assert_eq!(fs::read_to_string(&file).unwrap(), "1");
        assert_eq!(make_quick_in(sysfs.path(), "/dev/ttyS0").unwrap(), None, "it has no such timer");
        assert_eq!(make_quick_in(sysfs.path(), "COM3").unwrap(), None);
    }

    #[test]
    fn an_adapter_has_a_name_of_its_own() {
        let usb = |serial: Option<&str>| Usb {
            vid: 0x0403,
            pid: 0x6001,
            serial: serial.map(str::to_owned),
            maker: None,
            product: None,
        };
        assert_eq!(usb(Some("A50285BI")).to_string(), "usb:0403:6001:A50285BI");
        assert_eq!(usb(None).to_string(), "usb:0403:6001");
        assert!(usb(Some("A5")).is_named("usb:0403:6001") && usb(Some("A5")).is_named("USB:0403:6001:a5"));
        assert!(!usb(Some("A5")).is_named("usb:0403:6001:A6") && !usb(None).is_named("usb:0403:6001:A5"));
        assert!(usb(Some("A5")).is_same(&usb(Some("A5"))) && !usb(Some("A5")).is_same(&usb(Some("A6"))));
    }
}
