//! What the streams of a recording told: values with their names.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technol_image::debug_info::{DebugInfo, Scope, SymbolKind};
use technol_image::op::Width;
use technol_wire::message::{Item, ItemKind, Mode, Request, Response, Subject, Subscription, TracedRegister};
use technol_wire::{Layout, SampleDecoder, Taken};

/// Low bits of a sample's number say nothing after so long a silence, in microseconds.
const FORGOTTEN: u64 = 5_000_000;
/// Values that are told of one sample.
const MOST: usize = 40;

/// The streams of a recording, as its requests begin and end them.
pub(crate) struct RecordedStreams<'a> {
    names: Names<'a>,
    /// Asked for, by the number of the request.
    asked: BTreeMap<u8, Subscription>,
    open: BTreeMap<u8, Open>,
}

struct Open {
    subscription: Subscription,
    decoder: SampleDecoder,
    last: Option<Vec<u64>>,
    heard: u64,
}

impl<'a> RecordedStreams<'a> {
    /// `debug`: of the program that runs, for its names.
    pub(crate) fn new(debug: Option<&'a DebugInfo>) -> Self {
        RecordedStreams { names: Names { debug }, asked: BTreeMap::new(), open: BTreeMap::new() }
    }

    pub(crate) fn request(&mut self, seq: u8, request: &Request) {
        match request {
            Request::Hello { .. } => {
                self.asked.clear();
                self.open.clear();
            }
            Request::Subscribe(subscription) => {
                self.open.remove(&subscription.id);
                self.asked.insert(seq, subscription.clone());
            }
            Request::Unsubscribe { id } => drop(self.open.remove(id)),
            _ => {}
        }
    }

    pub(crate) fn response(&mut self, seq: u8, response: &Response) {
        let Some(subscription) = self.asked.remove(&seq) else { return };
        if let (Response::Done, Ok(layout)) = (response, Layout::of(&subscription)) {
            let decoder = SampleDecoder::new(subscription.id, layout);
            let open = Open { subscription, decoder, last: None, heard: 0 };
            self.open.insert(open.subscription.id, open);
        }
    }

    /// The values of a sample that were other ones before; `None` when the recording does not tell what the stream is
    /// about.
    pub(crate) fn sample(&mut self, micros: u64, seq: u8, payload: &[u8]) -> Option<String> {
        let open = self.open.get_mut(&(payload.first()? >> 5))?;
        if micros > open.heard.saturating_add(FORGOTTEN) {
            open.decoder.forget();
        }
        open.heard = micros;
        let sample = match open.decoder.take(seq, payload) {
            Taken::Sample { sample, .. } => sample,
            Taken::Old => return Some("late, or told already".into()),
            Taken::Gap => return Some("not understood without the frames that are missing".into()),
        };
        let mut told = self.names.told(&open.subscription.subject, &sample.values, open.last.as_deref());
        open.last = Some(sample.values);
        if told.is_empty() {
            return Some("all as before".into());
        }
        let more = told.len().saturating_sub(MOST);
        told.truncate(MOST);
        let mut text = told.join(", ");
        if more > 0 {
            let _ = write!(text, " and {more} more");
        }
        Some(text)
    }
}

/// Names from the debug information, if there is any.
struct Names<'a> {
    debug: Option<&'a DebugInfo>,
}

impl Names<'_> {
    /// What differs from the values before, item by item.
    fn told(&self, subject: &Subject, values: &[u64], before: Option<&[u64]>) -> Vec<String> {
        let mut told = Vec::new();
        let mut at = 0;
        let mut tell = |count: usize, text: &dyn Fn(&[u64]) -> String| {
            let range = at..at + count;
            at += count;
            let Some(now) = values.get(range.clone()) else { return };
            if before.and_then(|b| b.get(range)) != Some(now) {
                told.push(text(now));
            }
        };
        match subject {
            Subject::Variables(items) => {
                for item in items {
                    let count = if matches!(item.mode, Mode::Extremes | Mode::Edges) { 3 } else { 1 };
                    tell(count, &|now| format!("{} = {}", self.item(*item), item_text(*item, now)));
                }
            }
            Subject::Mechanisms(sequences) => {
                for sequence in sequences {
                    tell(4, &|now| format!("{} {}", self.sequence(*sequence), mechanism_text(now)));
                }
            }
            Subject::Trace { pcs, wide } => {
                let register = if *wide { TracedRegister::Dr64 } else { TracedRegister::Dr32 };
                for pc in pcs {
                    tell(4, &|now| format!("{}: {}", self.line(*pc), line_text(register, now)));
                }
            }
            Subject::Lines(lines) => {
                for line in lines {
                    tell(4, &|now| format!("{}: {}", self.line(line.pc), line_text(line.register, now)));
                }
            }
        }
        told
    }

    /// The name of a cell or bit; without one its address.
    fn item(&self, item: Item) -> String {
        let fits = |kind: &SymbolKind| match (item.kind, kind) {
            (ItemKind::Bit(n), SymbolKind::Bit { addr, bit }) => (*addr, *bit) == (item.addr, n),
            (ItemKind::Real, SymbolKind::Cell { addr, width: Width::Real }) => *addr == item.addr,
            (ItemKind::Unsigned(n) | ItemKind::Signed(n), SymbolKind::Cell { addr, width }) => {
                *addr == item.addr && width.bytes() == u32::from(n) && *width != Width::Real
            }
            _ => false,
        };
        let symbols = self.debug.iter().flat_map(|debug| &debug.symbols).filter(|s| fits(&s.kind));
        // What the project declares says more than what is predefined.
        let found = symbols.min_by_key(|s| s.scope == Scope::System);
        found.map_or_else(
            || match item.kind {
                ItemKind::Bit(n) => format!("bit {}.{n}", item.addr),
                ItemKind::Real => format!("REAL {}", item.addr),
                ItemKind::Unsigned(n) | ItemKind::Signed(n) => format!("{} {}", type_name(n), item.addr),
            },
            |symbol| symbol.name.clone(),
        )
    }

    fn sequence(&self, sequence: u16) -> String {
        let mut all = self.debug.iter().flat_map(|debug| &debug.mechanisms);
        let found = all.find(|m| m.sequence == sequence);
        found.map_or_else(|| format!("sequence {sequence}"), |m| m.name.clone())
    }

    fn line(&self, pc: u32) -> String {
        let found = self.debug.and_then(|debug| {
            let line = debug.lines.iter().find(|line| line.pc == pc)?;
            let file = debug.files.get(usize::from(line.file))?;
            Some(format!("{}:{}", file.path, line.line))
        });
        found.unwrap_or_else(|| format!("operation {pc}"))
    }
}

fn type_name(bytes: u8) -> &'static str {
    match bytes {
        1 => "BYTE",
        2 => "WORD",
        4 => "DWRD",
        _ => "QWRD",
    }
}

fn item_text(item: Item, now: &[u64]) -> String {
    let text = |raw: u64| match item.kind {
        ItemKind::Bit(_) | ItemKind::Unsigned(_) => raw.to_string(),
        ItemKind::Signed(bytes) => {
            let unused = 64_u32.saturating_sub(u32::from(bytes) * 8).min(63);
            (((raw << unused) as i64) >> unused).to_string()
        }
        ItemKind::Real => format!("{:?}", f64::from_bits(raw)),
    };
    match (item.mode, now) {
        (Mode::Extremes, [value, least, greatest]) => {
            format!("{} ({} … {})", text(*value), text(*least), text(*greatest))
        }
        (Mode::Edges, [value, rises, falls]) => format!("{} (↑{rises} ↓{falls})", text(*value)),
        (_, [value, ..]) => text(*value),
        (_, []) => String::new(),
    }
}

fn mechanism_text(now: &[u64]) -> String {
    match now {
        [1, _, line, entered] => format!("in line {line} since cycle {entered}"),
        _ => "at rest".into(),
    }
}

fn line_text(register: TracedRegister, now: &[u64]) -> String {
    let [known, ran, rlo, data] = *now else { return String::new() };
    if known == 0 {
        return "has not run".into();
    }
    let data = match register {
        TracedRegister::Dr32 => format!("DR {}", data as u32 as i32),
        TracedRegister::Dr64 => format!("DR64 {}", data as i64),
        TracedRegister::Real => format!("DR_REAL {:?}", f64::from_bits(data)),
    };
    let when = if ran == 1 { "" } else { ", earlier" };
    format!("RLO {rlo} {data}{when}")
}
