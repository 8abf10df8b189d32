//! What is watched, as the client is told.

use serde_json::{Value, json};

use technol_image::debug_info::Mechanism;
use technol_image::op::Width;
use technol_wire::message::{Item, TracedRegister};

use crate::forcing::{self, Forced, PortBits};
use crate::live::{Line, Reading, Told};
use crate::mechanisms;
use crate::values;

use super::super::Session;
use super::super::phase::Phase;
use super::{Watched, What};

impl Session {
    pub(super) fn watch_body(&self) -> Value {
        let watching = &self.watching;
        let watches: Vec<Value> = watching.watches.iter().map(|w| self.shown_watch(w)).collect();
        let mechanisms = watching.mechanisms.then(|| self.shown_mechanisms());
        json!({ "watches": watches, "mechanisms": mechanisms })
    }

    fn shown_watch(&self, watched: &Watched) -> Value {
        let mut shown = json!({ "expression": watched.expression });
        match &watched.what {
            What::Wrong(why) => shown["error"] = json!(why),
            What::Constant(value) => shown["value"] = json!(value.to_string()),
            What::Mechanism(sequence) => {
                let told = self.watching.live.mechanism(*sequence, self.phase == Phase::Running);
                let mechanism = self.mechanism(*sequence);
                let text = told.zip(mechanism).map(|(t, m)| told_as(&t, mechanisms::summary(m, &t.value)));
                put(&mut shown, text);
            }
            What::Item { item, width, port } => {
                let text = |raw: u64| match width {
                    Some(width) => values::cell(raw, *width, watched.hex),
                    None => values::bit(raw == 1),
                };
                let told = self.watching.live.item(*item);
                let forced = port.as_ref().map(|(bits, masks)| self.forced_of_watch(*bits, masks));
                let whole = width.is_some();
                let value = |t: Told<Reading>| {
                    forcing::with_mark(text(t.value.value), whole, forced.as_deref().unwrap_or_default())
                };
                put(&mut shown, told.map(|t| told_as(&t, value(t))));
                if let (Some((bits, _)), false) = (port, whole) {
                    shown["port"] = json!(self.port_name(*bits));
                    let value = forced.as_ref().and_then(|f| f.first()).map(|f| u8::from(f.value));
                    shown["forced"] = json!(value);
                }
                if let Some(Told { value: Reading { extremes, edges, .. }, .. }) = told {
                    shown["least"] = json!(extremes.map(|(least, _)| text(least)));
                    shown["greatest"] = json!(extremes.map(|(_, greatest)| text(greatest)));
                    shown["rises"] = json!(edges.map(|(rises, _)| rises));
                    shown["falls"] = json!(edges.map(|(_, falls)| falls));
                }
            }
        }
        shown
    }

    fn forced_of_watch(&self, bits: PortBits, masks: &[Item; 2]) -> Vec<Forced> {
        let [low, high] = masks.map(|mask| self.watching.live.item(mask).map_or(0, |t| t.value.value as u8));
        forcing::forced_of(bits, low, high)
    }

    fn mechanism(&self, sequence: u16) -> Option<&Mechanism> {
        self.debuggee.as_ref()?.debug.mechanisms.iter().find(|m| m.sequence == sequence)
    }

    fn shown_mechanisms(&self) -> Vec<Value> {
        let Some(debuggee) = &self.debuggee else { return Vec::new() };
        let running = self.phase == Phase::Running;
        let shown = debuggee.debug.mechanisms.iter().map(|mechanism| {
            let told = self.watching.live.mechanism(mechanism.sequence, running);
            let path = debuggee.map.path(mechanism.file).map(|p| p.to_string_lossy().into_owned());
            let mut shown = json!({ "name": mechanism.name, "path": path });
            if let Some(told) = &told {
                shown["active"] = json!(told.value.active);
                shown["line"] = json!(self.line_out(mechanisms::line(mechanism, &told.value)));
            }
            put(&mut shown, told.map(|t| told_as(&t, mechanisms::summary(mechanism, &t.value))));
            shown
        });
        shown.collect()
    }

    pub(super) fn trace_body(&self) -> Value {
        let live = &self.watching.live;
        let lines = self.watching.lines.iter().map(|line| {
            let mut shown = json!({ "path": line.path, "line": line.line });
            let told: Vec<_> = line.statements.iter().filter_map(|s| live.line(s.pc)).collect();
            // The last statement of the line that ran says how the line ended.
            let ran = |now: bool| told.iter().rev().find(move |t| t.value.is_some_and(|l| l.ran || !now));
            if let Some(last) = ran(true).or_else(|| ran(false)).or(told.last()) {
                shown["ran"] = json!(last.value.is_some_and(|line| line.ran));
                let text = last.value.map_or_else(
                    || "has not run".to_owned(),
                    |line| format!("RLO {}  {}", u8::from(line.rlo), data_register(&line)),
                );
                put(&mut shown, Some(told_as(last, text)));
            }
            shown
        });
        json!({ "lines": lines.collect::<Vec<_>>() })
    }
}

/// The data register behind a line, by the name that the program has for it.
fn data_register(line: &Line) -> String {
    match line.register {
        TracedRegister::Dr32 => format!("DR {}", values::register(line.data, Width::DWord, false)),
        TracedRegister::Dr64 => format!("DR64 {}", values::register(line.data, Width::QWord, false)),
        TracedRegister::Real => format!("DR_REAL {}", values::real(f64::from_bits(line.data))),
    }
}

/// A value with its mark: one that may have changed since ends in a question mark.
fn put(shown: &mut Value, text: Option<Told<String>>) {
    shown["value"] = match &text {
        None => json!("…"),
        Some(Told { value, stale: false, .. }) => json!(value),
        Some(Told { value, .. }) => json!(format!("{value} ?")),
    };
    shown["stale"] = json!(text.as_ref().is_none_or(|t| t.stale));
    shown["cycle"] = json!(text.map(|t| t.cycle));
}

fn told_as<T>(told: &Told<T>, text: String) -> Told<String> {
    Told { value: text, stale: told.stale, cycle: told.cycle }
}
