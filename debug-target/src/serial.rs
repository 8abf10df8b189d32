//! A link over a serial line (also one that is only pretended, such as a pseudo terminal).

use std::io::{self, ErrorKind, Read, Write};
use std::time::Duration;

use serialport::{ClearBuffer, DataBits, FlowControl, Parity, SerialPort, StopBits};

use crate::link::Link;

/// A line that takes nothing for this long is gone.
const SEND_TIMEOUT: Duration = Duration::from_secs(2);
/// Start bit, eight data bits, stop bit.
const BITS_PER_BYTE: u32 = 10;

/// An open serial line: 8 data bits, no parity, 1 stop bit, no flow control.
pub struct SerialLink {
    port: Box<dyn SerialPort>,
    baud: u32,
}

impl SerialLink {
    /// Opens a device, exclusively. What it has received before is thrown away.
    pub fn open(device: &str, baud: u32) -> Result<SerialLink, serialport::Error> {
        Ok(SerialLink { port: open_port(device, baud, SEND_TIMEOUT)?, baud })
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
