//! Commands of the debug console.

use std::time::Duration;

use technol_image::debug_info::SymbolKind;
use technol_wire::message::Request as Ask;

use crate::errors::RequestError;

use super::phase::Phase;
use super::{Session, Timer};

/// A pressed key is let go after this time.
const KEY_PRESS: Duration = Duration::from_millis(200);

/// Usage and meaning.
pub(super) const COMMANDS: [(&str, &str); 12] = [
    ("fault NAME on|off", "switch a fault of the simulated machine"),
    ("press KEY", "press a key of the simulated operator panel for a moment"),
    ("hold KEY", "press a key and hold it down"),
    ("release KEY", "let a key go"),
    ("start MECHANISM", "activate a mechanism"),
    ("stop MECHANISM", "put a mechanism into rest"),
    ("plc start|stop|clear", "start, stop or clear the PLC"),
    ("force NAME VALUE", "hold a bit (0, 1) or byte (0 to 255) of a port at a value"),
    ("unforce NAME|all", "hold it no more"),
    ("forced", "what is forced"),
    ("help", "this list"),
    ("NAME = VALUE", "set a bit, a variable or a register"),
];

impl Session {
    /// Carries out a command; `None` when the line is none (but an expression).
    pub(super) fn command(&mut self, line: &str, order: Option<u8>) -> Result<Option<String>, RequestError> {
        if let Some((name, value)) = line.split_once('=') {
            let (value, _) = self.assign(order, name.trim(), value.trim(), false)?;
            return Ok(Some(format!("{} = {value}", name.trim())));
        }
        let (word, rest) = line.trim().split_once(char::is_whitespace).unwrap_or((line.trim(), ""));
        let rest = rest.trim();
        // A variable may be called like a command: without an argument it is meant.
        if rest.is_empty()
            && (!(word.eq_ignore_ascii_case("help") || word.eq_ignore_ascii_case("forced"))
                || self.is_symbol(word))
        {
            return Ok(None);
        }
        let said = match word.to_ascii_lowercase().as_str() {
            "help" => help(),
            "fault" => self.switch_fault(rest)?,
            "press" => self.press(rest)?,
            "hold" => self.key(rest, true, "held down")?,
            "release" => self.key(rest, false, "released")?,
            "start" | "stop" => self.switch_mechanism(rest, word.eq_ignore_ascii_case("start"))?,
            "plc" => self.plc(rest)?,
            "force" => {
                let (name, value) = rest.rsplit_once(char::is_whitespace).ok_or_else(|| usage(7))?;
                self.force_named(order, name.trim(), value)?
            }
            "unforce" if rest.eq_ignore_ascii_case("all") => self.unforce_all()?,
            "unforce" => self.unforce(order, rest)?,
            "forced" if rest.is_empty() => self.list_forced()?,
            _ => return Ok(None),
        };
        Ok(Some(said))
    }

    fn is_symbol(&self, name: &str) -> bool {
        self.debuggee().is_ok_and(|d| d.debug.symbols.iter().any(|s| s.name.eq_ignore_ascii_case(name)))
    }

    fn switch_fault(&mut self, rest: &str) -> Result<String, RequestError> {
        // Names may contain blanks: the switch is the last word.
        let (name, switch) = rest.rsplit_once(char::is_whitespace).unwrap_or((rest, ""));
        let on = match switch.to_ascii_lowercase().as_str() {
            "on" | "1" => true,
            "off" | "0" => false,
            _ => return Err(usage(0)),
        };
        let name = unquoted(name);
        let (target, _) = self.parts()?;
        target.ask(Ask::SetFault { name: name.clone(), on })?;
        Ok(format!("fault {name} is {}", if on { "on" } else { "off" }))
    }

    fn press(&mut self, name: &str) -> Result<String, RequestError> {
        let said = self.key(name, true, "pressed")?;
        self.start_timer(KEY_PRESS, Timer::ReleaseKey(unquoted(name)));
        Ok(said)
    }

    fn key(&mut self, name: &str, down: bool, what: &str) -> Result<String, RequestError> {
        let key = unquoted(name);
        let (target, _) = self.parts()?;
        target.ask(Ask::Press { key: key.clone(), down })?;
        Ok(format!("key {key} {what}"))
    }

    pub(super) fn release_key(&mut self, key: String) {
        if self.phase == Phase::Stopped {
            // The program has not seen the key yet: it is held until it goes on.
            self.start_timer(KEY_PRESS, Timer::ReleaseKey(key));
        } else if let Some(target) = &mut self.target {
            target.tell(Ask::Press { key, down: false });
        }
    }

    fn switch_mechanism(&mut self, name: &str, start: bool) -> Result<String, RequestError> {
        let debuggee = self.debuggee()?;
        let found = debuggee.debug.symbols.iter().find_map(|s| match s.kind {
            SymbolKind::Mechanism { sequence } if s.name.eq_ignore_ascii_case(name) => {
                Some((s.name.clone(), sequence))
            }
            _ => None,
        });
        let Some((name, sequence)) = found else {
            return Err(RequestError::Expression(format!("there is no mechanism `{name}`")));
        };
        self.set_mechanism(sequence, start)?;
        self.values_changed();
        Ok(format!("{name} {}", if start { "started" } else { "put into rest" }))
    }

    fn plc(&mut self, rest: &str) -> Result<String, RequestError> {
        let (request, said) = match rest.to_ascii_lowercase().as_str() {
            "start" => (Ask::Start { cold: false, stop_on_entry: false }, "PLC start ordered"),
            "stop" => (Ask::Stop, "PLC stop ordered"),
            "clear" => (Ask::Clear, "PLC clear ordered"),
            _ => return Err(usage(6)),
        };
        let (target, _) = self.parts()?;
        target.ask(request)?;
        Ok(said.into())
    }
}

fn unquoted(name: &str) -> String {
    name.trim().trim_matches(|c| matches!(c, '"' | '\'')).to_owned()
}

fn usage(command: usize) -> RequestError {
    let (usage, meaning) = COMMANDS[command];
    RequestError::Expression(format!("usage: {usage} — {meaning}"))
}

fn help() -> String {
    let mut text = COMMANDS.map(|(usage, meaning)| format!("{usage:<22} {meaning}")).join("\n");
    text.push_str("\nAnything else is an expression: KSMP, P1IN.3, WORD.TABLE+2, RLO, DR16");
    text
}
