//! The way to a target. The adapter knows no ports and no targets: whoever starts it hands in a [`Connector`].

use std::io;
use std::path::PathBuf;
use std::time::Duration;

/// Where the program runs, as asked for by `launch` and `attach`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TargetSpec {
    /// A target inside this process.
    Embedded {
        /// Folder of the project, absolute: its configuration files are those of the control.
        project: PathBuf,
        /// The simulated machine (`machine.toml`), absolute; `None`: no machine.
        machine: Option<PathBuf>,
        /// Which time it runs in.
        clock: Clock,
    },
    /// A target somewhere else.
    Address {
        /// `tcp:HOST:PORT` or `serial:DEVICE[@BAUD]`, as written by the user.
        address: String,
        /// File with the token that lets in at a target on the network.
        token_file: Option<PathBuf>,
    },
}

/// Time of the embedded target.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Clock {
    /// A cycle takes 20 ms.
    #[default]
    Real,
    /// Cycles run as fast as they can.
    Virtual,
}

/// A byte stream to a target.
pub trait ByteLink: Send {
    /// Sends all bytes; blocks at most as long as the line takes. An error means that the link is gone.
    fn send(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// Receives some bytes; 0 when none came within `timeout`. An error means that the link is gone.
    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize>;
    /// The time of a link that has its own, as a simulated cable in virtual time; `None`: the clock of the computer.
    fn time(&self) -> Option<Duration> {
        None
    }
    /// Bytes the line carries in a second, if that bounds what can be watched over it.
    fn bytes_per_second(&self) -> Option<u32> {
        None
    }
}

/// Opens links.
pub trait Connector: Send + Sync {
    /// Opens a link, within a few seconds. The error says what was tried, why it failed and what to do; it is shown
    /// to the user as it is.
    fn connect(&self, target: &TargetSpec) -> Result<Box<dyn ByteLink>, String>;
}
