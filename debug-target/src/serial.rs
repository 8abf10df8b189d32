//! A link over a serial line (also one that is only pretended, such as a pseudo terminal).

use std::io::{self, ErrorKind, Read, Write};
use std::time::Duration;

use serialport::{ClearBuffer, DataBits, FlowControl, Parity, SerialPort, StopBits};

use crate::address::Address;
use crate::connect::{ConnectError, open_serial};
use crate::devices::{Device, Usb, devices};
use crate::link::Link;

/// A line that takes nothing for this long is gone.
const SEND_TIMEOUT: Duration = Duration::from_secs(2);
/// Start bit, eight data bits, stop bit.
const BITS_PER_BYTE: u32 = 10;

/// An open serial line: 8 data bits, no parity, 1 stop bit.
pub struct SerialLink {
    port: Box<dyn SerialPort>,
    baud: u32,
}

impl SerialLink {
    /// Opens a device, exclusively, with or without RTS/CTS flow control. What it has received before is thrown away.
    /// Its adapter is told to hand over bytes at once where the system lets that be told.
    pub fn open(device: &str, baud: u32, flow: bool) -> Result<SerialLink, serialport::Error> {
        let mut port = open_port(device, baud, SEND_TIMEOUT)?;
        if flow {
            port.set_flow_control(FlowControl::Hardware)?;
        }
        // Without the permission for it the line works all the same; `technol devices` tells about it.
        let _ = crate::devices::make_quick(device);
        Ok(SerialLink { port, baud })
    }
}

/// Opens a device exclusively: 8 data bits, no parity, 1 stop bit, no flow control. What it has received before is thrown away.
pub(crate) fn open_port(
    device: &str,
    baud: u32,
    timeout: Duration,
) -> Result<Box<dyn SerialPort>, serialport::Error> {
    let port = serialport::new(device, baud)
        .data_bits(DataBits::Eight)
        .parity(Parity::None)
        .stop_bits(StopBits::One)
        .flow_control(FlowControl::None)
        .timeout(timeout)
        .open()?;
    port.clear(ClearBuffer::All)?;
    Ok(port)
}

impl Link for SerialLink {
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.port.set_timeout(SEND_TIMEOUT)?;
        self.port.write_all(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        if timeout.is_zero() && self.port.bytes_to_read()? == 0 {
            return Ok(0);
        }
        self.port.set_timeout(timeout.max(Duration::from_millis(1)))?;
        match self.port.read(buffer) {
            // A device that was pulled out reads as ended.
            Ok(0) => Err(io::Error::new(ErrorKind::UnexpectedEof, "the serial device is gone")),
            Ok(count) => Ok(count),
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted) => Ok(0),
            Err(error) => Err(error),
        }
    }

    fn bytes_per_second(&self) -> Option<u32> {
        Some((self.baud / BITS_PER_BYTE).max(1))
    }

    fn outlives_host(&self) -> bool {
        true
    }
}

/// A serial line that may be unplugged and plugged in again, under whatever name the system then gives it.
#[derive(Clone, Debug)]
pub struct SerialPlace {
    device: String,
    baud: u32,
    flow: bool,
    /// The adapter that was found there.
    adapter: Option<Usb>,
}

impl SerialPlace {
    /// A device: its name, or the adapter as `usb:VID:PID:SERIAL`.
    #[must_use]
    pub fn new(device: &str, baud: u32, flow: bool) -> SerialPlace {
        SerialPlace { device: device.to_owned(), baud, flow, adapter: None }
    }

    /// As it was asked for.
    #[must_use]
    pub fn address(&self) -> Address {
        Address::Serial { device: self.device.clone(), baud: self.baud, flow: self.flow }
    }

    /// Opens it: the adapter that was there before, wherever it is now, else the device of that name.
    ///
    /// # Errors
    /// It is not there, or cannot be used.
    pub fn open(&mut self) -> Result<SerialLink, ConnectError> {
        let there = devices();
        let name = self.find(&there)?.to_owned();
        let link = open_serial(&name, self.baud, self.flow)?;
        self.adapter = there.into_iter().find(|d| d.port == name).and_then(|d| d.usb);
        Ok(link)
    }

    /// The name to open among the devices that are there.
    fn find<'a>(&'a self, there: &'a [Device]) -> Result<&'a str, ConnectError> {
        let is_ours = |device: &&Device| {
            device.usb.as_ref().is_some_and(|usb| match &self.adapter {
                // Two adapters of one make without a number of their own cannot be told apart.
                Some(adapter) => usb.serial.is_some() && usb.is_same(adapter),
                None => usb.is_named(&self.device),
            })
        };
        if let Some(found) = there.iter().find(is_ours) {
            return Ok(&found.port);
        }
        if Usb::is_name(&self.device) {
            return Err(ConnectError::NoDevice {
                device: self.device.clone(),
                available: crate::connect::available(there),
            });
        }
        Ok(&self.device)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn usb(port: &str, serial: Option<&str>) -> Device {
        let usb =
            Usb { vid: 0x0403, pid: 0x6001, serial: serial.map(str::to_owned), maker: None, product: None };
        Device { port: port.to_owned(), usb: Some(usb), latency_ms: None }
    }

    #[test]
    fn an_adapter_is_found_again_under_another_name() {
        let mut place = SerialPlace::new("/dev/ttyUSB0", 115_200, false);
        let before = [usb("/dev/ttyUSB0", Some("A1")), usb("/dev/ttyUSB1", Some("B2"))];
        assert_eq!(place.find(&before).ok(), Some("/dev/ttyUSB0"));
        place.adapter = before[0].usb.clone();
        let after = [usb("/dev/ttyUSB0", Some("B2")), usb("/dev/ttyUSB3", Some("A1"))];
        assert_eq!(place.find(&after).ok(), Some("/dev/ttyUSB3"), "its number counts, not the name");
        assert_eq!(place.find(&after[..1]).ok(), Some("/dev/ttyUSB0"), "not there: the name is tried");
        place.adapter = usb("", None).usb;
        let twins = [usb("/dev/ttyUSB5", None), usb("/dev/ttyUSB0", None)];
        assert_eq!(
            place.find(&twins).ok(),
            Some("/dev/ttyUSB0"),
            "without a number the name is all there is"
        );
    }

    #[test]
    fn an_adapter_can_be_asked_for_by_its_identity() {
        let there = [usb("/dev/ttyUSB0", Some("B2")), usb("/dev/ttyUSB3", Some("A1"))];
        let place = |name: &str| SerialPlace::new(name, 115_200, false);
        assert_eq!(place("usb:0403:6001:A1").find(&there).ok(), Some("/dev/ttyUSB3"));
        assert_eq!(place("usb:0403:6001").find(&there).ok(), Some("/dev/ttyUSB0"), "any of that make");
        let error = place("usb:0403:6001:C3").find(&there).unwrap_err().to_string();
        assert!(
            error.contains("there is no serial device `usb:0403:6001:C3`; there is /dev/ttyUSB0"),
            "{error}"
        );
    }
}
