//! What is watched while the program runs: by the streams of the target, for the client's own views
//! (`invalidated`) and for those that ask for it (`technol/subscribe`, `technol/trace`).

mod telling;

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde::Deserialize;
use serde_json::{Value, json};

use technol_image::op::{Addr, Width};
use technol_wire::message::{
    Item, ItemKind, Mode, Request as Ask, SequenceState, Subscription, TracedLine as TracedStatement, feature,
};

use crate::errors::RequestError;
use crate::expression::Named;
use crate::forcing::{self, PortBits};
use crate::live::plan::{CYCLE_MS, Plan, Wishes, plan};
use crate::live::{Live, News};
use crate::request::Request;
use crate::target_link::Streamed;
use crate::traced::register_behind;
use crate::tree::Shown;

use super::phase::Phase;
use super::{Answer, Session};

/// What was looked at is followed for this long.
const INTEREST: Duration = Duration::from_secs(12);
/// A view that shows it is asked to look again at least this often, so that it stays of interest.
const REFRESH: Duration = Duration::from_secs(5);
/// Views are asked to look again at most this often.
const REDRAW: Duration = Duration::from_millis(250);
/// Least time between two events with values.
const LEAST_PAUSE: Duration = Duration::from_millis(100);
/// Changes of what is of interest come in swarms: they are collected for this long.
const GATHER: Duration = Duration::from_millis(100);
/// Most expressions and lines of a client.
const MOST: usize = 1000;

/// Something a client asked for by its expression.
struct Watched {
    expression: String,
    hex: bool,
    what: What,
}

enum What {
    Item {
        item: Item,
        width: Option<Width>,
        /// The port that it is, or is a copy of, and the masks that may force it.
        port: Option<(PortBits, [Item; 2])>,
    },
    Mechanism(u16),
    Constant(i64),
    Wrong(String),
}

/// A traced line of the source.
struct TracedSource {
    path: String,
    line: i64,
    /// Its statements, with what is shown of each.
    statements: Vec<TracedStatement>,
}

/// What is watched, and what has been told about it.
#[derive(Default)]
pub(super) struct Watching {
    pub(super) live: Live,
    /// As the client asked, so that it can be asked for again with another program.
    asked: Option<Value>,
    traced: Option<Value>,
    watches: Vec<Watched>,
    /// All mechanisms.
    mechanisms: bool,
    /// In cycles.
    period: u16,
    lines: Vec<TracedSource>,
    /// Cells and when they were last looked at.
    interest: BTreeMap<(Addr, u8), Instant>,
    mechanisms_looked_at: Option<Instant>,
    plan: Plan,
    replan: Option<Instant>,
    /// Not told yet to the client's own views, and to those that trace.
    news: News,
    /// Not told yet to those that watch.
    untold: bool,
    told: Option<Instant>,
    trace_told: Option<Instant>,
    redrawn: Option<Instant>,
    threads_told: Option<Instant>,
    /// The last thing said about the line.
    said: String,
}

#[derive(Deserialize)]
struct SubscribeArguments {
    #[serde(default)]
    watches: Vec<WatchArguments>,
    #[serde(default)]
    mechanisms: bool,
    /// Milliseconds.
    #[serde(default)]
    period: Option<u32>,
}

#[derive(Deserialize)]
struct WatchArguments {
    expression: String,
    #[serde(default)]
    mode: WatchMode,
    #[serde(default)]
    hex: bool,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum WatchMode {
    #[default]
    Value,
    Change,
    Extremes,
    Edges,
}

#[derive(Deserialize)]
struct TraceArguments {
    #[serde(default)]
    lines: Vec<LineArguments>,
}

#[derive(Deserialize)]
struct LineArguments {
    path: String,
    line: i64,
}

impl Watching {
    /// The program is another one: what the client asked for is looked up again.
    pub(super) fn restart(&mut self) -> (Option<Value>, Option<Value>) {
        let asked = (self.asked.take(), self.traced.take());
        *self = Watching::default();
        asked
    }

    /// The link is lost: nothing is known to be up to date.
    pub(super) fn lost(&mut self) {
        for subscription in &self.plan.subscriptions {
            self.live.stale(subscription.id);
        }
        self.untold = true;
        self.news.trace = true;
    }

    /// The target is there again, and has forgotten its streams: they are asked for again.
    pub(super) fn resume(&mut self) {
        for subscription in self.plan.subscriptions.drain(..) {
            self.live.close(subscription.id);
        }
        self.replan = Some(Instant::now());
    }

    /// The client has views of its own that show values while the program runs.
    pub(super) fn has_views(&self) -> bool {
        self.asked.is_some()
    }

    fn is_watching(&self) -> bool {
        !self.watches.is_empty() || self.mechanisms
    }

    fn replan_soon(&mut self) {
        self.replan.get_or_insert(Instant::now() + GATHER);
    }
}

impl Session {
    /// `technol/subscribe`: replaces what the client watches.
    pub(super) fn subscribe(&mut self, request: &Request) -> Answer {
        let arguments: SubscribeArguments = request.parse()?;
        let watches: Vec<Watched> = arguments.watches.iter().take(MOST).map(|w| self.watched(w)).collect();
        let watching = &mut self.watching;
        watching.asked = Some(request.arguments.clone());
        watching.watches = watches;
        watching.mechanisms = arguments.mechanisms;
        let cycles = arguments.period.unwrap_or(100).div_ceil(CYCLE_MS).clamp(1, u32::from(u16::MAX));
        watching.period = cycles as u16;
        watching.untold = true;
        self.forcing.look_again();
        let note = self.replan();
        let watches = self.watching.watches.iter().map(|w| {
            let error = if let What::Wrong(why) = &w.what { Some(why) } else { None };
            json!({ "expression": w.expression, "error": error })
        });
        let watches: Vec<Value> = watches.collect();
        let period = u32::from(self.watching.plan.period) * CYCLE_MS;
        Ok(json!({ "watches": watches, "period": period, "note": note }))
    }

    /// `technol/trace`: replaces the traced lines.
    pub(super) fn trace(&mut self, request: &Request) -> Answer {
        let arguments: TraceArguments = request.parse()?;
        let debuggee = self.debuggee()?;
        let (mut lines, mut answers) = (Vec::new(), Vec::new());
        for asked in arguments.lines.iter().take(MOST) {
            let line = self.line_in(asked.line);
            let file = debuggee.map.file(&asked.path);
            let of_line = debuggee.debug.lines.iter().filter(|l| Some(l.file) == file && l.line == line);
            let mut pcs: Vec<u32> = of_line.map(|l| l.pc).collect();
            pcs.retain(|pc| debuggee.program.statements.contains(pc));
            let error = match file {
                None => Some("the file is not part of the program"),
                Some(_) if pcs.is_empty() => Some("there is no instruction on this line"),
                Some(_) => None,
            };
            answers.push(json!({ "path": asked.path, "line": asked.line, "error": error }));
            if error.is_none() {
                let statement =
                    |pc: &u32| TracedStatement { pc: *pc, register: register_behind(&debuggee.program, *pc) };
                let statements = pcs.iter().map(statement).collect();
                lines.push(TracedSource { path: asked.path.clone(), line: asked.line, statements });
            }
        }
        self.watching.traced = Some(request.arguments.clone());
        self.watching.lines = lines;
        self.watching.news.trace = true;
        let note = self.replan();
        let period = u32::from(self.watching.plan.trace_period) * CYCLE_MS;
        Ok(json!({ "lines": answers, "period": period, "note": note }))
    }

    fn watched(&self, asked: &WatchArguments) -> Watched {
        let what = match self.named(None, &asked.expression) {
            Ok(Named::Constant(value)) => What::Constant(value),
            Ok(Named::Thing(Shown::Mechanism(sequence) | Shown::Detail(sequence, _))) => {
                What::Mechanism(sequence)
            }
            Ok(Named::Thing(shown @ Shown::Bit { addr, bit })) => What::Item {
                item: item(addr, ItemKind::Bit(bit), asked.mode),
                width: None,
                port: self.watched_port(&shown),
            },
            Ok(Named::Thing(shown @ Shown::Cell { addr, width })) => What::Item {
                item: item(addr, kind(width, asked.mode), asked.mode),
                width: Some(width),
                port: self.watched_port(&shown),
            },
            Ok(Named::Thing(Shown::Register(_) | Shown::Machine(_) | Shown::Pushed(_))) => {
                What::Wrong("a register changes with each line; trace a line to see it".into())
            }
            Ok(Named::Thing(Shown::Text { .. } | Shown::Area { .. })) => {
                What::Wrong("only bits, cells and mechanisms are watched while the program runs".into())
            }
            Err(error) => What::Wrong(error.to_string()),
        };
        Watched { expression: asked.expression.clone(), hex: asked.hex, what }
    }

    /// The masks are watched along: a value that is forced is never shown as if it were sensed.
    fn watched_port(&self, shown: &Shown) -> Option<(PortBits, [Item; 2])> {
        let (bits, (low, high)) = forcing::forcible(&self.debuggee.as_ref()?.ports, shown)?;
        let mask = |addr| item(addr, ItemKind::Unsigned(1), WatchMode::Change);
        Some((bits, [mask(low), mask(high)]))
    }

    /// Somebody looks at a cell while the program runs: its value, if a stream tells it. It is followed from now on.
    pub(super) fn glance(&mut self, addr: Addr, bytes: u32) -> Option<u64> {
        let bytes = u8::try_from(bytes).ok().filter(|n| matches!(n, 1 | 2 | 4 | 8))?;
        if self.phase != Phase::Running {
            return None;
        }
        if self.watching.interest.insert((addr, bytes), Instant::now()).is_none() {
            self.watching.replan_soon();
        }
        self.watching.live.cell(addr, bytes)
    }

    /// The same for the mechanisms.
    pub(super) fn glance_at_mechanisms(&mut self) -> Option<Vec<SequenceState>> {
        if self.phase != Phase::Running {
            return None;
        }
        if self.watching.mechanisms_looked_at.replace(Instant::now()).is_none() {
            self.watching.replan_soon();
        }
        let debuggee = self.debuggee.as_ref()?;
        let state = |m: &technol_image::debug_info::Mechanism| {
            let told = self.watching.live.mechanism(m.sequence, true)?;
            (!told.stale).then_some(told.value)
        };
        debuggee.debug.mechanisms.iter().map(state).collect()
    }

    /// Takes what the streams told, keeps the subscriptions up to date, and tells the client.
    pub(super) fn watch(&mut self) {
        let Some(target) = &mut self.target else {
            // The link is lost: what is shown is marked.
            self.tell_watches();
            return;
        };
        for streamed in target.take_streamed() {
            let news = match streamed {
                Streamed::Sample(sample) => self.watching.live.take(sample),
                Streamed::Stale(id) => self.watching.live.stale(id),
            };
            let all = &mut self.watching.news;
            all.variables |= news.variables;
            all.mechanisms |= news.mechanisms;
            all.trace |= news.trace;
            self.watching.untold |= news.variables || news.mechanisms;
        }
        self.lose_interest();
        self.tell_changed_forces();
        if self.watching.replan.is_some_and(|at| Instant::now() >= at) {
            self.replan();
        }
        self.tell_threads();
        self.tell_watches();
        self.redraw();
    }

    /// What nobody has looked at for a while is not followed any more.
    fn lose_interest(&mut self) {
        if self.phase != Phase::Running {
            return; // nobody needs streams to look at a program that is held
        }
        let watching = &mut self.watching;
        let before = watching.interest.len();
        watching.interest.retain(|_, at| at.elapsed() < INTEREST);
        let mechanisms = watching.mechanisms_looked_at.take_if(|at| at.elapsed() >= INTEREST);
        if watching.interest.len() < before || mechanisms.is_some() {
            watching.replan_soon();
        }
    }

    fn wishes(&self) -> Wishes {
        let watching = &self.watching;
        let mut wishes = Wishes { period: watching.period.max(1), ..Wishes::default() };
        for watched in &watching.watches {
            match &watched.what {
                What::Item { item, port, .. } => {
                    let masks = port.iter().flat_map(|(_, masks)| masks);
                    for item in std::iter::once(item).chain(masks) {
                        if !wishes.watches.contains(item) {
                            wishes.watches.push(*item);
                        }
                    }
                }
                What::Mechanism(sequence) if !wishes.mechanisms.contains(sequence) => {
                    wishes.mechanisms.push(*sequence);
                }
                _ => {}
            }
        }
        if (watching.mechanisms || watching.mechanisms_looked_at.is_some())
            && let Some(debuggee) = &self.debuggee
        {
            wishes.mechanisms = debuggee.debug.mechanisms.iter().map(|m| m.sequence).collect();
        }
        wishes.trace = watching.lines.iter().flat_map(|l| l.statements.iter().copied()).collect();
        wishes.trace.sort_unstable_by_key(|line| line.pc);
        wishes.trace.dedup();
        let looked_at = watching.interest.keys().map(|(addr, bytes)| Item {
            addr: *addr,
            kind: ItemKind::Unsigned(*bytes),
            mode: Mode::Value,
        });
        wishes.interest = looked_at.collect();
        wishes
    }

    /// Subscribes to what is wanted now. Answers what the user should know about it, and says it if it is new.
    fn replan(&mut self) -> Option<String> {
        self.watching.replan = None;
        let mut wishes = self.wishes();
        let target = self.target.as_mut()?;
        wishes.any_register = target.features() & feature::TRACED_REGISTERS != 0;
        let mut missing = None;
        if target.features() & feature::STREAMS == 0 {
            let nothing =
                Wishes { any_register: wishes.any_register, period: wishes.period, ..Wishes::default() };
            let wanted = wishes != nothing;
            missing = wanted
                .then(|| "the target does not tell values while the program runs; update it".to_owned());
            wishes = Wishes::default();
        }
        let line = target.bytes_per_second();
        let plan = plan(&wishes, target.limits().max_payload, line);
        let mut refused = None;
        for subscription in &plan.subscriptions {
            let same = self.watching.plan.subscriptions.iter().any(|old| old == subscription);
            if !same && let Err(error) = begin(target, &mut self.watching.live, subscription) {
                refused = Some(error);
            }
        }
        for old in &self.watching.plan.subscriptions {
            if plan.subscriptions.iter().all(|s| s.id != old.id) {
                self.watching.live.close(old.id);
                target.tell(Ask::Unsubscribe { id: old.id });
            }
        }
        let note = refused.map(|e| format!("watching while the program runs is not possible: {e}"));
        let note = missing.or(note).or_else(|| shortage(&plan, &wishes, line));
        self.watching.plan = plan;
        if let Some(note) = &note
            && *note != self.watching.said
        {
            self.say(note);
            self.watching.said.clone_from(note);
        }
        note
    }

    /// The program has been loaded anew: the client's watches are looked up in it.
    pub(super) fn watch_again(&mut self) {
        let (asked, traced) = self.watching.restart();
        let request = |command: &str, arguments| Request { seq: 0, command: command.into(), arguments };
        // What is wrong with them is told in the event.
        if let Some(arguments) = asked {
            let _ = self.subscribe(&request("technol/subscribe", arguments));
        }
        if let Some(arguments) = traced {
            let _ = self.trace(&request("technol/trace", arguments));
        }
    }
}

fn begin(
    target: &mut crate::target_link::TargetLink,
    live: &mut Live,
    subscription: &Subscription,
) -> Result<(), RequestError> {
    live.close(subscription.id);
    target.ask(Ask::Subscribe(subscription.clone()))?;
    live.open(subscription.clone());
    Ok(())
}

/// What a slow line or a small target does not allow.
fn shortage(plan: &Plan, wishes: &Wishes, line: Option<u32>) -> Option<String> {
    let ms = |cycles: u16| u32::from(cycles) * CYCLE_MS;
    if plan.left_out > 0 {
        return Some(format!(
            "{} of the things watched find no room on the link; watch fewer at a time",
            plan.left_out
        ));
    }
    let rate = line?;
    if !wishes.watches.is_empty() && plan.period > wishes.period {
        let (holds, asked) = (ms(plan.period), ms(wishes.period));
        return Some(format!(
            "the line carries {rate} bytes a second: what is watched comes every {holds} ms, not every {asked} ms; \
             watch less, or use a faster line"
        ));
    }
    (!wishes.trace.is_empty() && plan.trace_period > 1).then(|| {
        format!(
            "the line carries {rate} bytes a second: the trace comes every {} ms, not each cycle; trace fewer lines",
            ms(plan.trace_period)
        )
    })
}

fn item(addr: Addr, kind: ItemKind, mode: WatchMode) -> Item {
    let mode = match mode {
        WatchMode::Value => Mode::Value,
        WatchMode::Change => Mode::OnChange,
        WatchMode::Extremes => Mode::Extremes,
        WatchMode::Edges => Mode::Edges,
    };
    Item { addr, kind, mode }
}

/// What is greater and what is less is a matter of the sign, as in the language's comparisons.
fn kind(width: Width, mode: WatchMode) -> ItemKind {
    let bytes = width.bytes() as u8;
    match (width, mode) {
        (Width::Real, _) => ItemKind::Real,
        (_, WatchMode::Extremes | WatchMode::Edges) => ItemKind::Signed(bytes),
        _ => ItemKind::Unsigned(bytes),
    }
}
