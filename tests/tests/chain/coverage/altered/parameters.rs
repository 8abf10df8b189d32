//! Other parameters of calls, of TEX and TIM, of messages.

use technol_analysis::catalogue::entry::Access;
use technol_analysis::catalogue::{self, OperandKind};
use technol_image::op::{Op, Source, Width};
use technol_image::program::{Message, Program, Timed};
use technol_image::service::{Arg, Service, ServiceCall};

use super::operations::{behind, beside};
use super::{Change, Changes};

pub(super) fn others(program: &Program, op: &Op) -> Changes {
    match *op {
        Op::Timed(n) => timed(&program.timed[usize::from(n)])
            .into_iter()
            .map(|(what, timed)| (what.to_owned(), Change::Timed(timed)))
            .collect(),
        Op::Message { index, .. } => message(&program.messages[usize::from(index)])
            .into_iter()
            .map(|(what, message)| (what, Change::Message(message)))
            .collect(),
        Op::Service(n) => service(&program.services[usize::from(n)])
            .into_iter()
            .map(|(what, call)| (what, Change::Call(call)))
            .collect(),
        _ => Vec::new(),
    }
}

fn timed(timed: &Timed) -> Vec<(&'static str, Timed)> {
    let mut others = vec![
        ("the next line", Timed { line: timed.line + 1, ..*timed }),
        ("a longer time", Timed { time: more(timed.time, 1), ..*timed }),
        ("a shorter time", Timed { time: more(timed.time, -1), ..*timed }),
        ("a counter a byte further", Timed { count: behind(timed.count), ..*timed }),
        ("a counter of another width", Timed { width: other_counter(timed.width), ..*timed }),
    ];
    if let Some(wait_when) = timed.wait_when {
        others.push(("the other value", Timed { wait_when: Some(!wait_when), ..*timed }));
        others.push(("TIM", Timed { wait_when: None, error: None, ..*timed }));
        others.push(("another label", Timed { error: timed.error.map(|pc| pc + 1), ..*timed }));
    }
    if let Some((source, width)) = timed.code {
        others.push(("another code", Timed { code: Some((more(source, 1), width)), ..*timed }));
        others.push(("no code", Timed { code: None, ..*timed }));
    }
    others
}

fn other_counter(width: Width) -> Width {
    if width == Width::Byte { Width::Word } else { Width::Byte }
}

fn more(source: Source, by: i64) -> Source {
    match source {
        Source::Int(n) => Source::Int(n.wrapping_add(by)),
        Source::Mem(place) => Source::Mem(behind(place)),
        Source::Real(r) => Source::Real(r + 1.0),
    }
}

fn message(message: &Message) -> Vec<(String, Message)> {
    let mut others = vec![("the other way".to_owned(), Message { set: !message.set, ..*message })];
    let mut value =
        |name: &str, value: Option<(Source, Width)>, make: &dyn Fn(Option<(Source, Width)>) -> Message| {
            let Some((source, width)) = value else { return };
            others.push((format!("another {name}"), make(Some((more(source, 1), width)))));
            others.push((format!("no {name}"), make(None)));
            for other in [Width::Byte, Width::Word, Width::DWord] {
                if other != width && matches!(source, Source::Mem(_)) {
                    others.push((format!("{name} {width:?} as {other:?}"), make(Some((source, other)))));
                }
            }
        };
    value("number", message.number, &|number| Message { number, ..*message });
    value("supplement", message.sub_id, &|sub_id| Message { sub_id, ..*message });
    for n in 0..3 {
        value(&format!("parameter {n}"), message.parameters[n], &|it| {
            let mut parameters = message.parameters;
            parameters[n] = it;
            Message { parameters, ..*message }
        });
    }
    others
}

fn service(call: &ServiceCall) -> Vec<(String, ServiceCall)> {
    let mut others = Vec::new();
    if call.push {
        others.push(("no push".to_owned(), ServiceCall { push: false, ..call.clone() }));
    }
    for sibling in siblings(call.service) {
        others.push((sibling.name().to_owned(), ServiceCall { service: sibling, ..call.clone() }));
    }
    let operands = catalogue::entry(call.service.name()).map_or(&[][..], |entry| entry.operands);
    for (n, arg) in call.args.iter().enumerate() {
        let spec = operands.get(n);
        let name = spec.map_or_else(|| format!("operand {n}"), |spec| spec.name.to_owned());
        for (what, other) in of_arg(arg, spec.map(|spec| spec.kind)) {
            if matches!(arg, Arg::Area { .. }) && what != FURTHER && has_own_length(call.service) {
                continue;
            }
            let mut args = call.args.clone();
            args[n] = other;
            others.push((format!("{name} {what}"), ServiceCall { args, ..call.clone() }));
        }
        if spec.is_some_and(|spec| spec.optional) && n + 1 == call.args.len() {
            let args = call.args[..n].to_vec();
            others.push((format!("{name} left out"), ServiceCall { args, ..call.clone() }));
        }
    }
    others
}

/// The instructions before and behind it, if they belong together.
fn siblings(service: Service) -> Vec<Service> {
    let at = Service::ALL.iter().position(|it| *it == service).unwrap_or_default();
    let family = |service: Service| service.name().get(..4).unwrap_or_default();
    let beside = [at.checked_sub(1), Some(at + 1)];
    let beside = beside.into_iter().flatten().filter_map(|at| Service::ALL.get(at).copied());
    // A synonym is the same.
    let synonym =
        |it: Service| [service, it].iter().all(|it| matches!(it, Service::CanRecvEnd | Service::CanRecvDel));
    beside.filter(|it| family(*it) == family(service) && !synonym(*it)).collect()
}

/// What is done to the address of an area.
const FURTHER: &str = "area a byte further";

/// It works on as many bytes as it says itself, however long the area is: records of two bytes, or another operand.
fn has_own_length(service: Service) -> bool {
    service.name().starts_with("POS_") || service == Service::SaRead
}

fn of_arg(arg: &Arg, kind: Option<OperandKind>) -> Vec<(String, Arg)> {
    let spec = kind.map(Spec::of).unwrap_or_default();
    match arg {
        Arg::Int(n) => {
            // One of many is not seen in a speed.
            if *n > 100_000 {
                return vec![("number less".to_owned(), Arg::Int(n / 4))];
            }
            let step = (n.unsigned_abs() / 64).max(1) as i64;
            vec![
                ("number more".to_owned(), Arg::Int(n.wrapping_add(step))),
                ("number less".to_owned(), Arg::Int(n.wrapping_sub(step))),
            ]
        }
        Arg::Real(r) => vec![("real number more".to_owned(), Arg::Real(r + 1.0))],
        Arg::Text(text) => {
            let mut other = text.clone();
            match other.last_mut() {
                Some(last) => *last ^= 1,
                None => other.push(b'x'),
            }
            vec![("another text".to_owned(), Arg::Text(other))]
        }
        Arg::Keyword(word) => next_keyword(kind, word)
            .map(|other| (format!("{word} as {other}"), Arg::Keyword(other)))
            .into_iter()
            .collect(),
        Arg::Cell { place, width, neg } => {
            let (place, width, neg) = (*place, *width, *neg);
            let further = Arg::Cell { place: behind(place), width, neg };
            let mut others = vec![(format!("{width:?} a byte further"), further)];
            if spec.negatable {
                others.push((format!("{width:?} of the other sign"), Arg::Cell { place, width, neg: !neg }));
            }
            for other in spec.other_widths(width) {
                others.push((format!("{width:?} as {other:?}"), Arg::Cell { place, width: other, neg }));
            }
            others
        }
        Arg::Bit { bit, neg } => {
            let mut others = vec![("next bit".to_owned(), Arg::Bit { bit: beside(*bit), neg: *neg })];
            if spec.negatable {
                others.push(("bit of the other value".to_owned(), Arg::Bit { bit: *bit, neg: !neg }));
            }
            others
        }
        Arg::Area { place, len } => {
            let further = Arg::Area { place: behind(*place), len: len.saturating_sub(1) };
            let mut others = vec![(FURTHER.to_owned(), further)];
            if spec.written && !spec.declares {
                let resized = |len| Arg::Area { place: *place, len };
                others.push(("area shorter".to_owned(), resized(len.saturating_sub(1))));
                others.push(("area longer".to_owned(), resized(len + 1)));
            }
            others
        }
        Arg::Missing | Arg::Procedure(_) => Vec::new(),
    }
}

/// What the catalogue says about an operand.
#[derive(Clone, Copy, Default)]
struct Spec {
    negatable: bool,
    written: bool,
    /// Its width is that of the type that another operand names.
    declares: bool,
}

impl Spec {
    fn of(kind: OperandKind) -> Spec {
        let written = |access| access != Access::Read;
        match kind {
            OperandKind::Bit { access, negatable, .. } | OperandKind::Data { access, negatable, .. } => {
                Spec { negatable, written: written(access), declares: false }
            }
            OperandKind::Address(access) | OperandKind::Text(access) => {
                Spec { written: written(access), ..Spec::default() }
            }
            OperandKind::Declares(_) | OperandKind::DeclaredElement => {
                Spec { written: true, declares: true, ..Spec::default() }
            }
            OperandKind::OneOf(kinds) => kinds.first().copied().map(Spec::of).unwrap_or_default(),
            _ => Spec::default(),
        }
    }

    /// Narrower, and wider where it writes. A real is eight bytes like a QWORD.
    fn other_widths(self, width: Width) -> Vec<Width> {
        let (narrower, wider) = match width {
            Width::Byte => (None, Some(Width::Word)),
            Width::Word => (Some(Width::Byte), Some(Width::DWord)),
            Width::DWord => (Some(Width::Word), Some(Width::QWord)),
            Width::QWord | Width::Real => (None, None),
        };
        let found = narrower.into_iter().chain(wider.filter(|_| self.written));
        found.filter(|_| !self.declares).collect()
    }
}

/// The next keyword of the catalogue that means something else.
fn next_keyword(kind: Option<OperandKind>, word: &str) -> Option<String> {
    let Some(OperandKind::Keyword(words) | OperandKind::KeywordOrNumber(words, ..)) = kind else {
        return None;
    };
    let at = words.iter().position(|it| it.eq_ignore_ascii_case(word))?;
    let mut behind = words[at + 1..].iter().chain(&words[..at]);
    behind.find(|it| type_of(it) != type_of(word)).map(|it| it.to_ascii_uppercase())
}

/// Types of cells have several names; signs make no difference to bytes that are copied.
fn type_of(word: &str) -> String {
    let word = word.to_ascii_uppercase().replace('_', "");
    let Some(word) = word.strip_prefix("TYPE") else { return word };
    let bits = match word {
        "BYTE" => "8",
        "WORD" => "16",
        "DWORD" => "32",
        "QWORD" => "64",
        word => word.trim_start_matches("INT").trim_start_matches("UNS"),
    };
    bits.to_owned()
}
