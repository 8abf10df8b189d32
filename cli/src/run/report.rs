//! What a run prints: values, registers, messages, the fault.

use serde_json::{Map, Value as Json, json};
use technol_analysis::configuration::control_text;
use technol_analysis::expression::{Target, Value};
use technol_image::{DebugInfo, Program};
use technol_machine::Shown;
use technol_runtime::{Fault, RuntimeEvent};
use technol_target::Simulation;

use super::changes::{resolve, values};
use crate::arguments::Format;
use crate::exit::Failure;
use crate::out::say;
use crate::paint::Paint;

/// The names to print and what they stand for.
pub(super) struct Wanted {
    names: Vec<(String, Target)>,
}

impl Wanted {
    /// Resolves `--print`.
    pub(super) fn parse(names: &[String], debug: &DebugInfo, program: &Program) -> Result<Wanted, Failure> {
        let names = names.iter().map(|name| name.trim()).filter(|name| !name.is_empty());
        let resolved = names.map(|name| match resolve(debug, program, name) {
            Ok(target) => Ok((name.to_owned(), target)),
            Err(why) => Err(Failure::usage(format!("--print {name}: {why}"))),
        });
        Ok(Wanted { names: resolved.collect::<Result<_, _>>()? })
    }
}

/// An ESET message with its place.
pub(super) struct Message<'a> {
    cycle: u64,
    number: u32,
    sub_id: Option<i64>,
    set: bool,
    parameters: Vec<Option<i64>>,
    place: Option<(&'a str, u32)>,
}

impl<'a> Message<'a> {
    /// The message of an event, if it is one.
    pub(super) fn of(event: &RuntimeEvent, debug: &'a DebugInfo) -> Option<Message<'a>> {
        let RuntimeEvent::Message { cycle, number, sub_id, set, parameters, pc } = event else { return None };
        let mut parameters = parameters.to_vec();
        while parameters.last() == Some(&None) {
            parameters.pop();
        }
        let place = debug.position(*pc);
        Some(Message { cycle: *cycle, number: *number, sub_id: *sub_id, set: *set, parameters, place })
    }

    fn json(&self) -> Json {
        json!({
            "cycle": self.cycle,
            "number": self.number,
            "subId": self.sub_id,
            "set": self.set,
            "parameters": self.parameters,
            "file": self.place.map(|p| p.0),
            "line": self.place.map(|p| p.1),
        })
    }
}

/// A run at its end.
pub(super) struct Run<'a> {
    pub(super) cycles: u64,
    pub(super) simulation: &'a Simulation,
    pub(super) debug: &'a DebugInfo,
    pub(super) events: &'a [RuntimeEvent],
}

impl Run<'_> {
    pub(super) fn print(&self, wanted: &Wanted, format: Format) {
        match format {
            Format::Json => say!("{}", self.json(wanted)),
            Format::Human => self.human(wanted),
        }
    }

    fn value(&self, target: Target) -> Option<Value> {
        let runtime = self.simulation.runtime();
        target.read(runtime.memory(), &values(&runtime.registers()))
    }

    fn json(&self, wanted: &Wanted) -> Json {
        let runtime = self.simulation.runtime();
        let registers = runtime.registers();
        let mut values = Map::new();
        for (name, target) in &wanted.names {
            values.insert(name.clone(), self.value(*target).map_or(Json::Null, |v| json_value(&v)));
        }
        let messages: Vec<Json> = super::messages(self.events, self.debug).map(|m| m.json()).collect();
        json!({
            "cycles": self.cycles,
            "values": values,
            "registers": {
                "RLO": registers.rlo,
                "DR": registers.dr,
                "DR_REAL": real(registers.dr_real),
            },
            "messages": messages,
            "screen": self.screen(),
            "fault": runtime.fault().map(|fault| self.fault_json(fault)),
        })
    }

    /// What the operator sees at the end: messages to be confirmed, the list of persistent ones.
    fn screen(&self) -> Json {
        let board = self.simulation.control().board();
        let told = |shown: &Shown| {
            json!({
                "number": shown.number,
                "subId": shown.sub_id,
                "cycle": shown.cycle,
                "text": self.text(shown),
            })
        };
        json!({
            "transient": board.transient().map(told).collect::<Vec<_>>(),
            "persistent": board.persistent().map(told).collect::<Vec<_>>(),
        })
    }

    fn text(&self, shown: &Shown) -> String {
        let text = control_text(&shown.text(self.simulation.control().data()));
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    fn human_screen(&self, paint: Paint) {
        let board = self.simulation.control().board();
        let line = |what: &str, shown: &Shown| {
            let sub_id = shown.sub_id.map_or_else(String::new, |id| format!(".{id}"));
            let number = paint.yellow(format!("PLC{:05}{sub_id}", shown.number));
            say!("{}", format!("  {what:<12}  {number}  {}", self.text(shown)).trim_end());
        };
        board.transient().for_each(|shown| line("to confirm", shown));
        board.persistent().for_each(|shown| line("listed", shown));
    }

    fn mechanism(&self, fault: &Fault) -> Option<&str> {
        let sequence = fault.sequence?;
        self.debug.mechanisms.iter().find(|m| m.sequence == sequence).map(|m| m.name.as_str())
    }

    fn fault_json(&self, fault: &Fault) -> Json {
        let place = self.debug.position(fault.pc);
        json!({
            "message": fault.kind.to_string(),
            "file": place.map(|p| p.0),
            "line": place.map(|p| p.1),
            "module": fault.module.keyword(),
            "mechanism": self.mechanism(fault),
            "cycle": fault.cycle,
        })
    }

    fn human(&self, wanted: &Wanted) {
        let paint = Paint::stdout();
        let runtime = self.simulation.runtime();
        let cycles = crate::check::count(self.cycles, "cycle");
        say!("{cycles} ({:.2} s), PLC {:?}", self.cycles as f64 * 0.02, runtime.state());
        for message in super::messages(self.events, self.debug) {
            let (file, line) = message.place.unwrap_or(("?", 0));
            let removed = if message.set { "" } else { " removed" };
            say!(
                "  cycle {:>6}  {}{removed}  {}",
                message.cycle,
                paint.yellow(format!("PLC{:05}", message.number)),
                paint.dim(format!("{file}:{line}"))
            );
        }
        self.human_screen(paint);
        let width = wanted.names.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
        for (name, target) in &wanted.names {
            let value = self.value(*target).map_or_else(|| "no value".to_owned(), |v| v.to_string());
            say!("  {name:<width$}  {}", paint.cyan(value));
        }
        let registers = runtime.registers();
        say!(
            "  RLO {}  DR {} ({:#x})  DR_REAL {:?}",
            u8::from(registers.rlo),
            registers.dr,
            registers.dr,
            registers.dr_real
        );
        if let Some(fault) = runtime.fault() {
            let (file, line) = self.debug.position(fault.pc).unwrap_or(("?", 0));
            let within = self.mechanism(fault).unwrap_or_else(|| fault.module.keyword());
            say!(
                "{}: {} at {file}:{line} in {within}, cycle {}",
                paint.red("PLC fault"),
                fault.kind,
                fault.cycle
            );
        }
    }
}

fn json_value(value: &Value) -> Json {
    match value {
        Value::Bit(value) => json!(value),
        Value::Unsigned(value) => json!(value),
        Value::Signed(value) => json!(value),
        Value::Real(value) => real(*value),
        Value::Text(text) => json!(text),
    }
}

/// JSON has no infinities: they become strings.
fn real(value: f64) -> Json {
    if value.is_finite() { json!(value) } else { json!(value.to_string()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_keep_their_json_type() {
        assert_eq!(json_value(&Value::Bit(true)), json!(true));
        assert_eq!(json_value(&Value::Unsigned(255)), json!(255));
        assert_eq!(json_value(&Value::Signed(-1)), json!(-1));
        assert_eq!(json_value(&Value::Real(2.5)), json!(2.5));
        assert_eq!(json_value(&Value::Real(f64::INFINITY)), json!("inf"));
        assert_eq!(json_value(&Value::Text("AB".into())), json!("AB"));
    }
}
