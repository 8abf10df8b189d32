//! Standard output that may be a pipe somebody closed (`technol explain LDR | head`).

use std::fmt::Arguments;
use std::io::Write as _;

/// Writes a line. When nobody reads any more the process ends as a well-behaved filter does.
pub(crate) fn line(text: Arguments<'_>) {
    let mut out = std::io::stdout().lock();
    if writeln!(out, "{text}").and_then(|()| out.flush()).is_err() {
        std::process::exit(i32::from(crate::exit::OK));
    }
}

/// `println!` for output that may be piped.
macro_rules! say {
    ($($argument:tt)*) => { $crate::out::line(format_args!($($argument)*)) };
}
pub(crate) use say;
