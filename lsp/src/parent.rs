//! Watches the process that started us: when it is gone, so is the reason to run.

use std::thread;
use std::time::Duration;

/// How often the parent is looked at.
const PERIOD: Duration = Duration::from_millis(500);

/// Calls `gone` once process `id` no longer lives, from a thread of its own.
///
/// Where the system offers no safe way to ask (anything but Unix), nothing is watched: there the end of our
/// standard input tells the same.
pub(crate) fn watch(id: u32, gone: impl FnOnce() + Send + 'static) {
    let watcher = move || {
        while lives(id) {
            thread::sleep(PERIOD);
        }
        gone();
    };
    if cfg!(unix) {
        // Without a thread for it the input's end remains.
        let _ = thread::Builder::new().name("parent".into()).spawn(watcher);
    }
}

#[cfg(unix)]
fn lives(id: u32) -> bool {
    let Some(pid) = i32::try_from(id).ok().and_then(rustix::process::Pid::from_raw) else { return true };
    // Only "no such process" counts: a process we may not signal is alive.
    rustix::process::test_kill_process(pid) != Err(rustix::io::Errno::SRCH)
}

#[cfg(not(unix))]
fn lives(_: u32) -> bool {
    true
}

#[cfg(all(test, unix))]
mod tests {
    use std::process::{Command, Stdio};
    use std::sync::mpsc;

    use super::*;

    #[test]
    fn the_end_of_the_watched_process_is_told() {
        let mut child = Command::new("sleep").arg("60").stdin(Stdio::null()).spawn().unwrap();
        let (sender, receiver) = mpsc::channel();
        watch(child.id(), move || sender.send(()).unwrap());
        assert!(receiver.recv_timeout(PERIOD * 2).is_err(), "told too early");
        child.kill().unwrap();
        child.wait().unwrap();
        receiver.recv_timeout(Duration::from_secs(10)).unwrap();
    }
}
