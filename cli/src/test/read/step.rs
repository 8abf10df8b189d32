//! Reading a step.

use technol_analysis::expression::{Assignment, resolve};
use toml::de::{DeTable, DeValue};

use super::super::condition::{Condition, Mistake, Side};
use super::super::fields::{Entry, Node, Source, entries, get, names};
use super::super::scenario::{Action, Check, Step, Test, Time};
use super::block::block;
use super::{Reader, inside};
use crate::run::changes::input_port;

const STEP: &[&str] = &[
    "name",
    "start",
    "stop",
    "central-annulment",
    "acknowledge",
    "clear",
    "halt",
    "press",
    "release",
    "fault",
    "repair",
    "set",
    "block",
    "never",
    "always",
    "end",
    "wait",
    "until",
    "at-most",
    "at-least",
    "expect",
    "state",
    "message",
    "no-message",
    "screen",
    "listed",
    "not-listed",
    "plc-fault",
];
/// The longest time a step may take: an hour.
pub(super) const LONGEST: u64 = 3_600_000;
/// Length of a cycle in milliseconds.
const CYCLE: u64 = 20;

impl Reader<'_> {
    /// A step of a test whose earlier steps are there already.
    pub(super) fn step(
        &mut self,
        at: usize,
        table: &DeTable<'_>,
        test: &Test,
        source: &mut Source<'_>,
    ) -> Step {
        source.known(table, "a step", STEP);
        let mut step = Step { place: source.place(at), ..Step::default() };
        for entry in entries(table) {
            match entry.key {
                "name" => {
                    step.name = source.text(entry.node, "the name of a step").map(str::to_owned);
                }
                "end" => step.ends = ends(&entry, test, source),
                "expect" => step.checks.extend(self.expectations(entry.node, source)),
                "state" => step.checks.extend(self.states(entry.node, source)),
                "message" => {
                    let numbers = source.numbers(entry.node, "the number of a message", u64::from(u32::MAX));
                    step.checks.extend(numbers.into_iter().map(|number| Check::Message(number as u32)));
                }
                "no-message" => step.checks.extend(no_messages(entry.node, source)),
                "screen" | "listed" | "not-listed" => step.checks.extend(shown(&entry, source)),
                "plc-fault" => {
                    let text = source.text(entry.node, "`plc-fault` is a part of the fault's text: it");
                    step.checks.extend(text.map(|text| Check::PlcFault(text.to_owned())));
                }
                _ => self.actions(&entry, test.machine, &mut step.actions, source),
            }
        }
        step.guards = self.guards(table, source);
        step.time = self.time(table, source);
        step
    }

    /// What a key of a step does, if it does something.
    fn actions(
        &self,
        entry: &Entry<'_, '_>,
        machine: usize,
        actions: &mut Vec<Action>,
        source: &mut Source<'_>,
    ) {
        let node = entry.node;
        let machine = self.machines.get(machine);
        match entry.key {
            "start" => {
                let cold = one_of(node, "start", &[("cold", true), ("warm", false)], source);
                actions.extend(cold.map(|cold| Action::Start { cold }));
            }
            "stop" => {
                let off = one_of(node, "stop", &[("command", false), ("power-off", true)], source);
                actions.extend(off.map(|power_off| Action::Stop { power_off }));
            }
            "central-annulment" | "acknowledge" | "clear" | "halt" => {
                let action = match entry.key {
                    "acknowledge" => Action::Acknowledge,
                    "clear" => Action::Clear,
                    "halt" => Action::Halt,
                    _ => Action::CentralAnnulment,
                };
                match source.boolean(node, &format!("`{}`", entry.key)) {
                    Some(true) => actions.push(action),
                    Some(false) => source.error(node.span().start, "say true, or leave the key out"),
                    None => {}
                }
            }
            "press" | "release" => {
                for (span, name) in source.texts(node, "the name of a key") {
                    let down = entry.key == "press";
                    if known(name, "key", &machine.keys, span.start, source) {
                        actions.push(Action::Key { name: name.to_owned(), down });
                    }
                }
            }
            "fault" | "repair" => {
                for (span, name) in source.texts(node, "the name of a fault") {
                    let on = entry.key == "fault";
                    if known(name, "fault", &machine.faults, span.start, source) {
                        actions.push(Action::Fault { name: name.to_owned(), on });
                    }
                }
            }
            "set" => {
                if let Some(table) = source.table(node, "`set`") {
                    for (name, entry) in names(table) {
                        actions.extend(self.set(
                            &name,
                            &entry,
                            |port, mask| machine.drives(port, mask),
                            source,
                        ));
                    }
                }
            }
            "block" => {
                for (_, table) in source.tables(node, "a block") {
                    actions.push(Action::Block(Box::new(block(table, source))));
                }
            }
            _ => {}
        }
    }

    fn set(
        &self,
        name: &str,
        entry: &Entry<'_, '_>,
        drives: impl Fn(usize, u8) -> bool,
        source: &mut Source<'_>,
    ) -> Option<Action> {
        let value = source.value(entry.node)?;
        let target = match resolve(self.names.debug, None, name) {
            Ok(target) => target.in_memory(self.names.program),
            Err(error) => {
                source.error(entry.at, error.to_string());
                return None;
            }
        };
        let assignment =
            match target.assign(if value == "true" || value == "false" { bit(&value) } else { &value }) {
                Ok(assignment) => assignment,
                Err(error) => {
                    source.error(entry.node.span().start, format!("{name}: {error}"));
                    return None;
                }
            };
        if written(&assignment).any(|(addr, mask)| input_port(addr).is_some_and(|port| drives(port, mask))) {
            let message = format!(
                "the machine decides on {name} and would overwrite it; press a key, switch a fault, or say machine = \
                 \"none\""
            );
            source.error(entry.at, message);
            return None;
        }
        Some(Action::Set { name: name.to_owned(), target, text: format!("{name} = {value}"), assignment })
    }

    fn expectations(&self, node: &Node<'_>, source: &mut Source<'_>) -> Vec<Check> {
        let Some(table) = source.table(node, "`expect`") else { return Vec::new() };
        let mut checks = Vec::new();
        for (name, entry) in names(table) {
            let Some(value) = source.value(entry.node) else { continue };
            match Condition::expectation(&name, &value, &self.names) {
                Ok(condition) => checks.push(Check::Holds(condition)),
                Err((Side::Name, mistake)) => source.error(entry.at, mistake.message),
                Err((Side::Value, mistake)) => in_value(entry.node, &value, mistake, source),
            }
        }
        checks
    }

    fn states(&self, node: &Node<'_>, source: &mut Source<'_>) -> Vec<Check> {
        let Some(table) = source.table(node, "`state`") else { return Vec::new() };
        let mut checks = Vec::new();
        for entry in entries(table) {
            if self.names.mechanisms.find(entry.key).is_none() {
                source.error(entry.at, self.names.mechanisms.unknown(entry.key));
                continue;
            }
            let Some(value) = source.value(entry.node) else { continue };
            match Condition::state(entry.key, &value, &self.names) {
                Ok(condition) => checks.push(Check::Holds(condition)),
                Err(mistake) => in_value(entry.node, &value, mistake, source),
            }
        }
        checks
    }

    fn time(&self, table: &DeTable<'_>, source: &mut Source<'_>) -> Time {
        let until = get(table, "until").map(|node| (node, self.condition(node, "until", source)));
        let wait = get(table, "wait").map(|node| (node, duration(node, source)));
        let at_most = get(table, "at-most").map(|node| (node, duration(node, source)));
        let at_least = get(table, "at-least").map(|node| (node, duration(node, source)));
        match (until, wait) {
            (Some((node, _)), Some(_)) => {
                source.error(node.span().start, "`wait` and `until` are two steps");
                Time::None
            }
            (Some((node, condition)), None) => {
                let Some((most, at_most)) = at_most else {
                    source.error(node.span().start, "`until` needs `at-most`, the longest time it may take");
                    return Time::None;
                };
                let (Some(condition), Some(at_most)) = (condition, at_most) else { return Time::None };
                let at_least = at_least.and_then(|(_, ms)| ms).unwrap_or(0);
                if at_least > at_most {
                    source.error(most.span().start, "`at-most` is less than `at-least`");
                }
                Time::Until { condition, at_least, at_most }
            }
            (None, wait) => {
                for (node, key) in at_most
                    .iter()
                    .map(|(n, _)| (n, "at-most"))
                    .chain(at_least.iter().map(|(n, _)| (n, "at-least")))
                {
                    source.error(node.span().start, format!("`{key}` belongs to `until`"));
                }
                wait.and_then(|(_, ms)| ms).map_or(Time::None, |ms| Time::Wait { ms })
            }
        }
    }
}

/// Milliseconds: `500`, `"500 ms"`, `"2 s"`, `"5 cycles"`.
fn duration(node: &Node<'_>, source: &mut Source<'_>) -> Option<u64> {
    const FORMS: &str =
        "a time is a number of milliseconds, or a text such as \"2 s\" or \"5 cycles\"; at most an hour";
    let ms = match node.get_ref() {
        DeValue::String(text) => {
            let text = text.trim();
            let digits = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
            let number = text[..digits].parse::<u64>().ok();
            let unit = match text[digits..].trim() {
                "" | "ms" => Some(1),
                "s" => Some(1000),
                "cycle" | "cycles" => Some(CYCLE),
                _ => None,
            };
            number.zip(unit).and_then(|(number, unit)| number.checked_mul(unit))
        }
        _ => super::super::fields::integer(node).and_then(|value| u64::try_from(value).ok()),
    };
    let ms = ms.filter(|ms| *ms <= LONGEST);
    if ms.is_none() {
        source.error(node.span().start, FORMS);
    }
    ms
}

fn no_messages(node: &Node<'_>, source: &mut Source<'_>) -> Vec<Check> {
    if let DeValue::Boolean(true) = node.get_ref() {
        return vec![Check::NoMessages];
    }
    let numbers = source.numbers(node, "`no-message` is true, or a number: it", u64::from(u32::MAX));
    numbers.into_iter().map(|number| Check::NoMessage(number as u32)).collect()
}

/// What the operator sees: `screen`, `listed` and `not-listed`.
fn shown(entry: &Entry<'_, '_>, source: &mut Source<'_>) -> Vec<Check> {
    match (entry.key, entry.node.get_ref()) {
        ("screen", DeValue::Boolean(false)) => return vec![Check::Screen(None)],
        ("not-listed", DeValue::Boolean(true)) => return vec![Check::NothingListed],
        _ => {}
    }
    let what = match entry.key {
        "screen" => "`screen` is false, or the number of a message: it",
        "listed" => "the number of a message",
        _ => "`not-listed` is true, or a number: it",
    };
    let numbers = source.numbers(entry.node, what, u64::from(u32::MAX));
    let check = |number: u64| match entry.key {
        "screen" => Check::Screen(Some(number as u32)),
        key => Check::Listed { number: number as u32, listed: key == "listed" },
    };
    numbers.into_iter().map(check).collect()
}

/// Names of guards that end; each must have begun.
fn ends(entry: &Entry<'_, '_>, test: &Test, source: &mut Source<'_>) -> Vec<String> {
    let begun = test.guards.iter().chain(test.steps.iter().flat_map(|step| &step.guards));
    let begun: Vec<String> = begun.filter_map(|guard| guard.name.clone()).collect();
    let mut ends = Vec::new();
    for (span, name) in source.texts(entry.node, "the name of a `never` or `always`") {
        if begun.iter().any(|known| known == name) {
            ends.push(name.to_owned());
        } else {
            let list = listed(&begun);
            source.error(
                span.start,
                format!("no `never` or `always` called {name} has begun; there is: {list}"),
            );
        }
    }
    ends
}

pub(super) fn one_of<T: Copy>(
    node: &Node<'_>,
    key: &str,
    words: &[(&str, T)],
    source: &mut Source<'_>,
) -> Option<T> {
    let text = source.text(node, &format!("`{key}`"))?;
    let found = words.iter().find(|(word, _)| *word == text).map(|(_, value)| *value);
    if found.is_none() {
        let words: Vec<String> = words.iter().map(|(word, _)| format!("\"{word}\"")).collect();
        source.error(node.span().start, format!("`{key}` is {}", words.join(" or ")));
    }
    found
}

fn known(name: &str, what: &str, names: &[String], at: usize, source: &mut Source<'_>) -> bool {
    let known = names.iter().any(|known| known == name);
    if !known {
        source.error(at, format!("the machine has no {what} `{name}`; it has: {}", listed(names)));
    }
    known
}

fn listed(names: &[String]) -> String {
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

fn in_value(node: &Node<'_>, value: &str, mistake: Mistake, source: &mut Source<'_>) {
    let at = match node.get_ref() {
        DeValue::String(_) => inside(node, value, mistake.at, source.text),
        _ => node.span().start,
    };
    source.error(at, mistake.message);
}

/// `true` and `false` of TOML are values of a byte cell too.
fn bit(value: &str) -> &'static str {
    if value == "true" { "1" } else { "0" }
}

/// Bytes and masks of memory that an assignment changes.
fn written(assignment: &Assignment) -> Box<dyn Iterator<Item = (u32, u8)> + '_> {
    match assignment {
        Assignment::Bit { addr, bit, .. } => Box::new(std::iter::once((*addr, 1 << bit))),
        Assignment::Memory { addr, bytes } => Box::new((*addr..).zip(bytes.iter().map(|_| 0xFF))),
        Assignment::Registers(_) => Box::new(std::iter::empty()),
    }
}
