//! Exit codes that scripts rely on, and the failure that ends a command.

use std::fmt;

/// Everything went well.
pub(crate) const OK: u8 = 0;
/// The program has errors.
pub(crate) const ERRORS: u8 = 1;
/// Wrong usage, or a file or device that cannot be used.
pub(crate) const USAGE: u8 = 2;
/// The PLC program failed while running.
pub(crate) const FAULT: u8 = 3;

/// Why a command ended early.
#[derive(Debug)]
pub(crate) struct Failure {
    /// Exit code.
    pub(crate) code: u8,
    /// What, where, what to do.
    pub(crate) message: String,
}

impl Failure {
    /// Wrong usage or I/O.
    pub(crate) fn usage(message: impl Into<String>) -> Failure {
        Failure { code: USAGE, message: message.into() }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// A command's outcome: its exit code.
pub(crate) type Outcome = Result<u8, Failure>;
