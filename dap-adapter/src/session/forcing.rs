//! Forcing of ports. What is forced stands in the masks of PLC memory, whoever wrote it; the session remembers what it
//! forced itself, so that a restart, a download and a lost link do not end it, and the end of the session does.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde::Deserialize;
use serde_json::{Value, json};

use technol_analysis::expression::{Assignment, Target};
use technol_image::op::{Addr, Width};
use technol_wire::message::{Request as Ask, Resume, StopReason};

use crate::connection::TargetSpec;
use crate::errors::RequestError;
use crate::expression::Named;
use crate::forcing::{self, Forced, MASKS, MASKS_LEN, PortBits};
use crate::memory::ReadPlan;
use crate::ports::{Ports, is_output};
use crate::request::Request;

use super::phase::Phase;
use super::{Answer, Session, Timer};

/// A program that was started stops at its entry within this time.
const ENTRY: Duration = Duration::from_secs(3);
/// After a stop the client asks for what it shows; the masks are looked at after that.
const LATER: Duration = Duration::from_millis(250);
/// Bits that are named one by one.
const NAMED: usize = 16;

/// Menus of VS Code are offered by this word.
const MENU: &str = "technolPortBit";

/// What the session forces.
#[derive(Default)]
pub(super) struct Forcing {
    /// Port and bit. Without a value: the order to force it has failed, and may have been carried out in part.
    ours: BTreeMap<(Addr, u8), Option<bool>>,
    /// Bits that were forced, by whomever, when the masks were last looked at.
    seen: usize,
    /// Views of the client do not know what is forced now.
    untold: bool,
    /// What they were told last.
    told: Vec<Forced>,
}

impl Forcing {
    /// Something has to be done at a start and at the end.
    pub(super) fn is_active(&self) -> bool {
        !self.ours.is_empty()
    }

    /// What is forced may have changed.
    pub(super) fn look_again(&mut self) {
        self.untold = true;
    }

    pub(super) fn forget(&mut self) {
        *self = Forcing::default();
    }

    /// Bits of each port: to be held at 1, at 0, and let go.
    fn by_port(&self) -> BTreeMap<Addr, (u8, u8, u8)> {
        let mut ports: BTreeMap<Addr, (u8, u8, u8)> = BTreeMap::new();
        for ((port, bit), value) in &self.ours {
            let (ones, zeros, gone) = ports.entry(*port).or_default();
            *match value {
                Some(true) => ones,
                Some(false) => zeros,
                None => gone,
            } |= 1 << bit;
        }
        ports
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct ForceArguments {
    name: String,
    frame_id: Option<i64>,
}

impl Session {
    /// `technol/force`: holds a bit or byte of a port at a value, or with `null` no more.
    pub(super) fn force(&mut self, request: &Request) -> Answer {
        let arguments: ForceArguments = request.parse()?;
        let value = match request.arguments.get("value") {
            Some(Value::Null) => None,
            Some(Value::Bool(value)) => Some(u8::from(*value).to_string()),
            Some(Value::Number(value)) => Some(value.to_string()),
            Some(Value::String(value)) => Some(value.clone()),
            _ => {
                return Err(RequestError::Arguments {
                    command: request.command.clone(),
                    reason: "`value` must be a number, or null to end forcing".into(),
                });
            }
        };
        let order = self.order_of_frame(request, arguments.frame_id)?;
        let message = match value {
            Some(value) => self.force_named(order, &arguments.name, &value)?,
            None => self.unforce(order, &arguments.name)?,
        };
        self.say(&message);
        Ok(json!({ "message": message }))
    }

    /// `technol/forced`: what is forced.
    pub(super) fn forced(&mut self, _request: &Request) -> Answer {
        let forced = self.look_at_masks()?;
        Ok(json!({ "forced": self.list_of(&forced) }))
    }

    fn list_of(&self, forced: &[Forced]) -> Vec<Value> {
        let unnamed = Ports::default();
        let ports = self.debuggee.as_ref().map_or(&unnamed, |d| &d.ports);
        let bits = forced.iter().map(|f| {
            json!({
                "name": format!("{}.{}", ports.name(f.port), f.bit),
                "symbol": ports.bit_name(f.port, f.bit),
                "value": u8::from(f.value),
                "own": self.is_ours(*f),
                "both": f.both,
            })
        });
        bits.collect()
    }

    /// Event `technol/forced`, for clients with views of their own: all that is forced, when it is no longer what they
    /// were told.
    pub(super) fn tell_changed_forces(&mut self) {
        let possible = matches!(self.phase, Phase::Running | Phase::Stopped);
        if !self.forcing.untold || !possible || !self.watching.has_views() {
            return;
        }
        // A link that is lost tells so itself; when it is back, the masks are looked at again.
        let looked = self.look_at_masks();
        self.forcing.untold = false;
        let Ok(forced) = looked else { return };
        if forced != self.forcing.told {
            let body = json!({ "forced": self.list_of(&forced) });
            self.out.custom("technol/forced", &body);
            self.forcing.told = forced;
        }
    }

    /// Holds what has this name at a value.
    pub(super) fn force_named(
        &mut self,
        order: Option<u8>,
        name: &str,
        value: &str,
    ) -> Result<String, RequestError> {
        let bits = self.port_bits(order, name)?;
        let wrong = |why: String| RequestError::Value(format!("`{name}`: {why}"));
        let target = if bits.mask == 0xFF {
            Target::Cell { addr: bits.port, width: Width::Byte }
        } else {
            Target::Bit { addr: bits.port, bit: bits.mask.trailing_zeros() as u8 }
        };
        let value = match target.assign(value).map_err(|e| wrong(e.to_string()))? {
            Assignment::Bit { value, .. } => {
                if value {
                    bits.mask
                } else {
                    0
                }
            }
            Assignment::Memory { bytes, .. } => bytes.first().copied().unwrap_or(0),
            Assignment::Registers(_) => return Err(wrong("it is no port".into())),
        };
        // From here on it may be forced, whether an answer comes or not.
        for bit in bits.numbers() {
            self.forcing.ours.entry((bits.port, bit)).or_insert(None);
        }
        self.write_masks(bits.port, value & bits.mask, !value & bits.mask, 0)?;
        for bit in bits.numbers() {
            self.forcing.ours.insert((bits.port, bit), Some(value >> bit & 1 == 1));
        }
        self.values_changed();
        self.forcing.look_again();
        let label = self.label(bits);
        let shown = if bits.mask == 0xFF { value.to_string() } else { u8::from(value != 0).to_string() };
        Ok(format!("{label} is forced to {shown}"))
    }

    /// Lets go what has this name, whoever forced it.
    pub(super) fn unforce(&mut self, order: Option<u8>, name: &str) -> Result<String, RequestError> {
        let bits = self.port_bits(order, name)?;
        let label = self.label(bits);
        let was = self.look_at_masks()?;
        let was = was.iter().any(|f| f.port == bits.port && bits.mask >> f.bit & 1 == 1);
        self.write_masks(bits.port, 0, 0, bits.mask)?;
        for bit in bits.numbers() {
            self.forcing.ours.remove(&(bits.port, bit));
        }
        self.forcing.look_again();
        self.values_changed();
        Ok(if was { format!("{label} is not forced any more") } else { format!("{label} was not forced") })
    }

    /// Lets go all that is forced.
    pub(super) fn unforce_all(&mut self) -> Result<String, RequestError> {
        let forced = self.look_at_masks()?;
        let mut ports: BTreeMap<Addr, u8> = BTreeMap::new();
        let ours = self.forcing.ours.keys().copied();
        for (port, bit) in forced.iter().map(|f| (f.port, f.bit)).chain(ours) {
            *ports.entry(port).or_default() |= 1 << bit;
        }
        for (port, bits) in ports {
            self.write_masks(port, 0, 0, bits)?;
            self.forcing.ours.retain(|(ours, _), _| *ours != port);
        }
        self.forcing.seen = 0;
        self.forcing.look_again();
        self.values_changed();
        Ok(match forced.len() {
            0 => "nothing was forced".into(),
            n => format!("{} not forced any more", bits_are(n)),
        })
    }

    /// What is forced, line by line.
    pub(super) fn list_forced(&mut self) -> Result<String, RequestError> {
        let forced = self.look_at_masks()?;
        let mut lines: Vec<String> = forced
            .iter()
            .map(|f| {
                let label = self.label(PortBits { port: f.port, mask: 1 << f.bit });
                let both = if f.both { " (both masks are set: 0 wins)" } else { "" };
                let whose = if self.is_ours(*f) { "" } else { ", not by this session" };
                format!("{label} = {}{both}{whose}", u8::from(f.value))
            })
            .collect();
        for ((port, bit), value) in &self.forcing.ours {
            let there = forced.iter().any(|f| (f.port, f.bit, Some(f.value)) == (*port, *bit, *value));
            if let (false, Some(value)) = (there, value) {
                let label = self.label(PortBits { port: *port, mask: 1 << bit });
                let value = u8::from(*value);
                lines.push(format!("{label} was forced to {value}, and somebody else has changed that"));
            }
        }
        Ok(if lines.is_empty() { "nothing is forced".into() } else { lines.join("\n") })
    }

    fn is_ours(&self, forced: Forced) -> bool {
        self.forcing.ours.get(&(forced.port, forced.bit)) == Some(&Some(forced.value))
    }

    /// The bits of a port that a name stands for.
    fn port_bits(&self, order: Option<u8>, name: &str) -> Result<PortBits, RequestError> {
        let name = name.trim();
        let wrong = |why: &str| RequestError::Expression(format!("`{name}` {why}"));
        let Named::Thing(shown) = self.named(order, name)? else {
            return Err(wrong("is a constant: only ports can be forced"));
        };
        forcing::behind(&self.debuggee()?.ports, &shown).map_err(|why| wrong(&why))
    }

    /// `P1IN.3`, or the port.
    pub(super) fn port_name(&self, bits: PortBits) -> String {
        let unnamed = Ports::default();
        let ports = self.debuggee.as_ref().map_or(&unnamed, |d| &d.ports);
        let port = ports.name(bits.port);
        if bits.mask == 0xFF { port } else { format!("{port}.{}", bits.mask.trailing_zeros()) }
    }

    /// `P1IN.3 (DOOR)`, or the port.
    fn label(&self, bits: PortBits) -> String {
        let unnamed = Ports::default();
        let ports = self.debuggee.as_ref().map_or(&unnamed, |d| &d.ports);
        let port = ports.name(bits.port);
        if bits.mask == 0xFF {
            return port;
        }
        let bit = bits.mask.trailing_zeros() as u8;
        let name = ports.bit_name(bits.port, bit).map(|n| format!(" ({n})")).unwrap_or_default();
        format!("{port}.{bit}{name}")
    }

    fn look_at_masks(&mut self) -> Result<Vec<Forced>, RequestError> {
        let mut plan = ReadPlan::default();
        plan.want(MASKS, MASKS_LEN);
        let forced = forcing::forced(self.read(plan)?.bytes(MASKS, MASKS_LEN));
        self.forcing.seen = forced.len();
        self.forcing.untold |= forced != self.forcing.told;
        Ok(forced)
    }

    /// Writes the masks of a port so that a bit goes from one forced value to the other, or to what is sensed, at
    /// once: what is forced to 0 and 1 is 0.
    fn write_masks(&mut self, port: Addr, ones: u8, zeros: u8, gone: u8) -> Result<(), RequestError> {
        let Some((low, high)) = forcing::masks(port) else { return Ok(()) };
        let (set, cleared) = (Some(ones).filter(|m| *m != 0), Some(zeros | gone).filter(|m| *m != 0));
        if let Some(mask) = set {
            self.write(Ask::WriteBits { addr: high, mask, value: mask })?;
        }
        let lows = |mask, value| Ask::WriteBits { addr: low, mask, value };
        if ones | zeros != 0 {
            self.write(lows(ones | zeros, zeros))?;
        }
        if let Some(mask) = cleared {
            self.write(Ask::WriteBits { addr: high, mask, value: 0 })?;
        }
        if gone == 0 { Ok(()) } else { self.write(lows(gone, 0)) }
    }

    /// Writes what the session forces, and takes back what has failed. `sensed`: the program has copied its inputs
    /// already, so they are corrected.
    fn write_ours(&mut self, sensed: bool) -> Result<(), RequestError> {
        for (port, (ones, zeros, gone)) in self.forcing.by_port() {
            self.write_masks(port, ones, zeros, gone)?;
            if sensed && !is_output(port) && ones | zeros != 0 {
                self.write(Ask::WriteBits { addr: port, mask: ones | zeros, value: ones })?;
            }
        }
        self.forcing.ours.retain(|_, value| value.is_some());
        self.forcing.look_again();
        Ok(())
    }

    /// The target is there again, and may have been started anew meanwhile.
    pub(super) fn force_again(&mut self) -> Result<(), RequestError> {
        self.write_ours(false)
    }

    /// The program has just been started, with an order to stop at its entry, and its memory is new: it goes on only when
    /// everything is forced again.
    pub(super) fn force_at_start(&mut self, stop_on_entry: bool) -> Result<(), RequestError> {
        let deadline = Instant::now() + ENTRY;
        let held = loop {
            let (target, _) = self.parts()?;
            let held = if stop_on_entry { target.has_stop() } else { target.take_entry() };
            if held || target.lost().is_some() || Instant::now() >= deadline {
                break held;
            }
            target.pump(Duration::from_millis(10));
        };
        self.write_ours(true)?;
        if held && !stop_on_entry {
            let (target, _) = self.parts()?;
            target.ask(Ask::Resume(Resume::Continue))?;
        }
        Ok(())
    }

    /// Tells how many bits are forced, by whomever.
    pub(super) fn tell_forced(&mut self) -> Result<(), RequestError> {
        let forced = self.look_at_masks()?;
        if !forced.is_empty() {
            self.say(&format!("{} forced; `forced` lists them", bits_are(forced.len())));
        }
        Ok(())
    }

    /// The program has stopped: somebody looks, and should know.
    pub(super) fn tell_forced_soon(&mut self, reason: StopReason) {
        let forces = self.debuggee.as_ref().is_some_and(|d| d.ports.forces);
        let worth_it = forces || self.forcing.is_active() || self.forcing.seen > 0;
        let waiting = self.timers.iter().any(|(_, timer)| *timer == Timer::Forced);
        if worth_it && !waiting && reason != StopReason::Step {
            self.start_timer(LATER, Timer::Forced);
        }
    }

    pub(super) fn tell_forced_at_stop(&mut self) {
        if self.phase == Phase::Stopped {
            // A link that is lost tells so itself.
            let _ = self.tell_forced();
        }
    }

    /// The session ends: nobody looks after what it forced.
    pub(super) fn let_forces_go(&mut self) {
        if !self.forcing.is_active() {
            return;
        }
        let reachable = self.target.as_ref().is_some_and(|t| t.lost().is_none()) && self.debuggee.is_some();
        if !reachable {
            self.leave_forces_behind();
            return;
        }
        let list = self.ours_by_name();
        if self.link_arguments.keep_forced {
            self.forcing.forget();
            self.important(&format!("still forced, as `keepForced` says: {list}"));
            return;
        }
        self.forcing.ours.values_mut().for_each(|value| *value = None);
        if self.write_ours(false).is_ok() {
            self.forcing.forget();
            self.important(&format!("not forced any more: {list}"));
        } else {
            self.leave_forces_behind();
        }
    }

    /// The session ends without its target.
    pub(super) fn leave_forces_behind(&mut self) {
        // An embedded target is gone with all that was forced in it.
        if self.forcing.is_active() && matches!(self.spec, Some(TargetSpec::Address { .. })) {
            let list = self.ours_by_name();
            self.important(&format!(
                "the target cannot be reached, so it may still force: {list}; `unforce all` in another session ends that"
            ));
        }
        self.forcing.forget();
    }

    fn ours_by_name(&self) -> String {
        let ours = self.forcing.ours.keys();
        let named = ours.take(NAMED).map(|(port, bit)| self.label(PortBits { port: *port, mask: 1 << bit }));
        let list = named.collect::<Vec<_>>().join(", ");
        match self.forcing.ours.len().checked_sub(NAMED) {
            Some(more) if more > 0 => format!("{list} and {more} more"),
            _ => list,
        }
    }
}

/// Lets the menus of VS Code know which rows can be forced.
pub(super) fn offer_menu(answer: &mut Value, can_be_forced: &[bool]) {
    let rows = answer.get_mut("variables").and_then(Value::as_array_mut).into_iter().flatten();
    for (row, _) in rows.zip(can_be_forced).filter(|(_, can)| **can) {
        row["__vscodeVariableMenuContext"] = json!(MENU);
    }
}

fn bits_are(n: usize) -> String {
    if n == 1 { "1 bit is".into() } else { format!("{n} bits are") }
}
