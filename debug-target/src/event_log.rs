//! The event log: a file with the messages, faults and states of the PLC, one a line.

use std::fmt::Write as _;
use std::fs::{self, OpenOptions};
use std::io::{self, Write as _};
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

use technol_machine::{MessageKind, Shown};
use technol_runtime::{RateKind, RuntimeEvent};

use crate::simulation::Simulation;

/// A file that has grown beyond this becomes `FILE.old`, in place of the one before.
const LONGEST: u64 = 4 << 20;

/// Text for bytes in the code page of the control.
pub type Decode = fn(&[u8]) -> String;

/// Appends to a file what happens. Errors, important warnings and events are logged, and messages that no file defines; other
/// messages are not (manual 14.2).
#[derive(Clone, Debug)]
pub struct EventLog {
    path: PathBuf,
    decode: Decode,
    /// Lines begin with the time of day.
    dated: bool,
    /// The file does not work; it is tried again, but told once.
    failed: bool,
}

impl EventLog {
    /// A log in this file, which is made when it is not there. `dated`: each line begins with the time (UTC), for a target that
    /// runs in real time.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn new(path: PathBuf, decode: Decode, dated: bool) -> Result<EventLog, String> {
        let log = EventLog { path, decode, dated, failed: false };
        match log.append("") {
            Ok(()) => Ok(log),
            Err(error) => Err(log.told(&error)),
        }
    }

    /// Logs what has happened.
    ///
    /// # Errors
    /// The file cannot be written; told once until it works again.
    pub fn write(&mut self, simulation: &Simulation, events: &[RuntimeEvent]) -> Result<(), String> {
        let mut text = String::new();
        for line in events.iter().filter_map(|event| self.line(simulation, event)) {
            let millis = simulation.runtime().millis();
            if self.dated {
                text += &date(SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_secs());
                text.push(' ');
            }
            let (seconds, rest) = (millis / 1000, millis % 1000);
            let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
            // Writing to a text does not fail.
            let _ = writeln!(text, "{hours}:{minutes:02}:{seconds:02}.{rest:03} {line}");
        }
        if text.is_empty() {
            return Ok(());
        }
        match self.append(&text) {
            Ok(()) => {
                self.failed = false;
                Ok(())
            }
            Err(_) if self.failed => Ok(()),
            Err(error) => {
                self.failed = true;
                Err(self.told(&error))
            }
        }
    }

    fn append(&self, text: &str) -> io::Result<()> {
        if fs::metadata(&self.path).is_ok_and(|file| file.len() > LONGEST) {
            let mut old = self.path.clone().into_os_string();
            old.push(".old");
            fs::rename(&self.path, old)?;
        }
        OpenOptions::new().create(true).append(true).open(&self.path)?.write_all(text.as_bytes())
    }

    fn told(&self, error: &io::Error) -> String {
        format!("cannot write the event log {}: {error}", self.path.display())
    }

    fn line(&self, simulation: &Simulation, event: &RuntimeEvent) -> Option<String> {
        Some(match event {
            RuntimeEvent::Message { cycle, number, sub_id, set, parameters, .. } => {
                let shown =
                    Shown { number: *number, sub_id: *sub_id, parameters: *parameters, cycle: *cycle };
                self.message(simulation, &shown, *set)?
            }
            RuntimeEvent::Fault(fault) => format!("fault: {fault}"),
            RuntimeEvent::StateChanged(state) => format!("PLC {state:?}"),
            RuntimeEvent::Overrun { cycle, rate, .. } => {
                format!(
                    "overrun of {} in cycle {cycle}",
                    if *rate == RateKind::Fast { "1 ms" } else { "20 ms" }
                )
            }
            RuntimeEvent::BlockRejected(why) => format!("a part-program block was not started: {why}"),
            RuntimeEvent::BlockStarted { .. }
            | RuntimeEvent::BlockFinished { .. }
            | RuntimeEvent::BlockAborted { .. } => return None,
        })
    }

    fn message(&self, simulation: &Simulation, shown: &Shown, set: bool) -> Option<String> {
        let data = simulation.control().data();
        let known = data.message(shown.number);
        let kind = known.map_or(MessageKind::Err, |known| known.kind);
        if !kind.is_logged() {
            return None;
        }
        let mut line = format!("{} PLC{:05}", kind.name(), shown.number);
        if let Some(sub_id) = shown.sub_id {
            let _ = write!(line, ".{sub_id}");
        }
        if !set {
            return Some(line + " removed");
        }
        // A text is one line here, whatever it is on the screen.
        let text = (self.decode)(&shown.text(data)).split_whitespace().collect::<Vec<_>>().join(" ");
        if !text.is_empty() {
            line = format!("{line} {text}");
        }
        let values: Vec<String> = shown.parameters.iter().flatten().map(ToString::to_string).collect();
        if !values.is_empty() {
            let _ = write!(line, " ({})", values.join(", "));
        }
        Some(line)
    }
}

/// `2026-11-23T16:10:05Z` from seconds since 1970.
fn date(seconds: u64) -> String {
    let (days, rest) = (seconds / 86_400, seconds % 86_400);
    // Years begin in March, so that the leap day is the last one; an era is 400 of them.
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = era * 400 + year_of_era + u64::from(month <= 2);
    let (hour, minute, second) = (rest / 3600, rest / 60 % 60, rest % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_of_the_calendar() {
        for (seconds, text) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_251_199, "2024-02-29T23:59:59Z"),
            (1_709_251_200, "2024-03-01T00:00:00Z"),
            (4_107_542_399, "2100-02-28T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
            (1_795_450_205, "2026-11-23T16:10:05Z"),
        ] {
            assert_eq!(date(seconds), text);
        }
    }

    #[test]
    fn a_file_that_cannot_be_written_is_refused_with_its_name() {
        let error = EventLog::new("no/such/folder/x.log".into(), |_| String::new(), false).unwrap_err();
        assert!(error.contains("no/such/folder/x.log"), "{error}");
    }
}
