//! What is watched, as the client is told.

use std::time::{Duration, Instant};

use dap::events::{Event, InvalidatedEventBody, ThreadEventBody};
use dap::types::{InvalidatedAreas, ThreadEventReason};
use serde_json::{Value, json};

use technol_image::debug_info::Mechanism;
use technol_image::op::Width;
use technol_wire::message::{Item, TracedRegister};

use crate::forcing::{self, Forced, PortBits};
use crate::live::plan::CYCLE_MS;
use crate::live::{Line, Reading, Told};
use crate::mechanisms;
use crate::values;

use super::super::Session;
use super::super::phase::Phase;
use super::super::stack::thread_of_sequence;
use super::{LEAST_PAUSE, REDRAW, REFRESH, Watched, What};

impl Session {
    /// Events with values, for clients that asked for them.
    pub(super) fn tell_watches(&mut self) {
        let watching = &self.watching;
        if !watching.live.has_samples() {
            return; // nothing has come yet
        }
        let period = Duration::from_millis(u64::from(watching.period) * u64::from(CYCLE_MS));
        let is_due = |told: Option<Instant>, pause| told.is_none_or(|at| at.elapsed() >= pause);
        let values =
            watching.is_watching() && watching.untold && is_due(watching.told, LEAST_PAUSE.max(period));
        let lines =
            !watching.lines.is_empty() && watching.news.trace && is_due(watching.trace_told, LEAST_PAUSE);
        if values {
            let body = self.watch_body();
            self.out.custom("technol/watch", &body);
            self.watching.live.told();
            self.watching.untold = false;
            self.watching.told = Some(Instant::now());
        }
        if lines {
            let body = self.trace_body();
            self.out.custom("technol/trace", &body);
            self.watching.news.trace = false;
            self.watching.trace_told = Some(Instant::now());
        }
    }

    /// Mechanisms that were started and that came to rest, as far as a stream tells it.
    pub(super) fn tell_threads(&mut self) {
        let due = self.watching.threads_told.is_none_or(|at| at.elapsed() >= REDRAW);
        let Some(debuggee) = self.debuggee.as_ref().filter(|_| due && self.phase == Phase::Running) else {
            return;
        };
        let mut events = Vec::new();
        for mechanism in &debuggee.debug.mechanisms {
            let told = self.watching.live.mechanism(mechanism.sequence, true);
            let Some(told) = told.filter(|told| !told.stale) else { continue };
            let thread_id = thread_of_sequence(Some(mechanism.sequence));
            let reason = if told.value.active {
                self.threads_announced.insert(thread_id).then_some(ThreadEventReason::Started)
            } else {
                self.threads_announced.remove(&thread_id).then_some(ThreadEventReason::Exited)
            };
            events.extend(reason.map(|reason| Event::Thread(ThreadEventBody { reason, thread_id })));
        }
        if !events.is_empty() {
            self.watching.threads_told = Some(Instant::now());
            for event in &events {
                self.out.event(event);
            }
        }
    }

    /// Asks views of the client's own to look again, when what they show has changed.
    pub(super) fn redraw(&mut self) {
        let watching = &self.watching;
        let of_interest = !watching.interest.is_empty() || watching.mechanisms_looked_at.is_some();
        if !self.client.invalidated || self.phase != Phase::Running || !of_interest {
            return;
        }
        // Who looks for the first time sees what there is.
        let Some(redrawn) = watching.redrawn else {
            self.watching.redrawn = Some(Instant::now());
            return;
        };
        let changed = watching.news.variables || watching.news.mechanisms;
        if redrawn.elapsed() < if changed { REDRAW } else { REFRESH } {
            return;
        }
        self.watching.redrawn = Some(Instant::now());
        self.watching.news.variables = false;
        self.watching.news.mechanisms = false;
        // Never the threads: VS Code then forgets those of a program that runs, and cannot pause it any more.
        self.out.event(&Event::Invalidated(InvalidatedEventBody {
            areas: Some(vec![InvalidatedAreas::Variables]),
            thread_id: None,
            stack_frame_id: None,
        }));
    }

    fn watch_body(&self) -> Value {
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

    fn trace_body(&self) -> Value {
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
