//! Reading and writing what the tree shows.

use dap::events::{Event, InvalidatedEventBody};
use dap::requests::{SetVariableArguments, VariablesArguments};
use dap::responses::{SetVariableResponse, VariablesResponse};
use dap::types::{InvalidatedAreas, ValueFormat, Variable, VariablesArgumentsFilter};

use technol_analysis::expression::{Assignment, RegisterChange, ValueError};
use technol_image::op::{Addr, Width};
use technol_wire::message::{MachineRegisters, Registers, Request as Ask, Response, SequenceState, feature};

use crate::errors::RequestError;
use crate::expression;
use crate::forcing;
use crate::mechanisms;
use crate::memory::{MemoryView, ReadPlan};
use crate::registers::{self, Register};
use crate::request::Request;
use crate::tree::{Detail, Node, Row, Shown};
use crate::values;

use super::{Answer, Session, body};

/// Bytes of an area shown on its own line.
const PREVIEW: u32 = 16;

/// What a set of rows needs to be shown.
#[derive(Default)]
struct Facts {
    memory: MemoryView,
    registers: Option<Registers>,
    machine: Option<MachineRegisters>,
    sequences: Vec<SequenceState>,
}

impl Session {
    pub(super) fn variables(&mut self, request: &Request) -> Answer {
        let arguments: VariablesArguments = request.parse()?;
        let node = self.node(arguments.variables_reference)?;
        let indexed = matches!(node, Node::Area(..));
        let wanted = match arguments.filter {
            Some(VariablesArgumentsFilter::Indexed) => indexed,
            Some(VariablesArgumentsFilter::Named) => !indexed,
            None => true,
        };
        let from = usize::try_from(arguments.start.unwrap_or(0)).unwrap_or(0);
        let count = arguments.count.and_then(|n| usize::try_from(n).ok()).filter(|n| *n > 0);
        let to = count.map_or(usize::MAX, |n| from.saturating_add(n));
        let rows = if wanted { self.rows(node, from, to)? } else { Vec::new() };
        let shown = self.show(&rows, wants_hex(arguments.format.as_ref()))?;
        let (_, debuggee) = self.parts()?;
        let can_be_forced: Vec<bool> =
            rows.iter().map(|row| forcing::is_on_port(&debuggee.ports, &row.shown)).collect();
        let variables = rows.into_iter().zip(shown).map(|(row, value)| Variable {
            type_field: Some(row.type_name()),
            indexed_variables: row.indexed().map(i64::from),
            variables_reference: row.children.map_or(0, |node| debuggee.tree.handle(node)),
            name: row.name,
            evaluate_name: row.expression,
            value,
            ..Variable::default()
        });
        let mut answer = body(&VariablesResponse { variables: variables.collect() })?;
        if self.client.menus {
            super::forcing::offer_menu(&mut answer, &can_be_forced);
        }
        Ok(answer)
    }

    fn node(&self, handle: i64) -> Result<Node, RequestError> {
        let stale = RequestError::Stale { what: "variable", id: handle };
        self.debuggee()?.tree.node(handle).ok_or(stale)
    }

    fn rows(&mut self, node: Node, from: usize, to: usize) -> Result<Vec<Row>, RequestError> {
        if node != Node::Stack {
            return Ok(self.debuggee()?.tree.children(node, from, to));
        }
        let depth = registers::stack(&self.registers()?).len();
        Ok((from.min(depth)..to.min(depth)).map(pushed_row).collect())
    }

    pub(super) fn set_variable(&mut self, request: &Request) -> Answer {
        let arguments: SetVariableArguments = request.parse()?;
        let node = self.node(arguments.variables_reference)?;
        let unknown = || RequestError::Expression(format!("there is no `{}` here", arguments.name));
        let row = self.debuggee()?.tree.child(node, &arguments.name).ok_or_else(unknown)?;
        let hex = wants_hex(arguments.format.as_ref());
        let value = self.set(&row.shown, &row.name, &arguments.value, hex)?;
        self.values_changed();
        body(&SetVariableResponse {
            value,
            type_field: Some(row.type_name()),
            variables_reference: None,
            named_variables: None,
            indexed_variables: None,
        })
    }

    /// Other views of the same memory have to be read again.
    pub(super) fn values_changed(&mut self) {
        if self.client.invalidated {
            self.after.push(Event::Invalidated(InvalidatedEventBody {
                areas: Some(vec![InvalidatedAreas::Variables]),
                thread_id: None,
                stack_frame_id: None,
            }));
        }
    }

    /// The values of rows, in as few round trips as possible.
    pub(super) fn show(&mut self, rows: &[Row], hex: bool) -> Result<Vec<String>, RequestError> {
        let facts = self.facts(rows)?;
        let debuggee = self.debuggee()?;
        Ok(rows
            .iter()
            .map(|row| match row.shown {
                Shown::Mechanism(n) | Shown::Detail(n, _) => {
                    let mechanism = debuggee.debug.mechanisms.iter().find(|m| m.sequence == n);
                    let now = facts.sequences.iter().find(|s| s.sequence == n);
                    match (mechanism, now, row.shown) {
                        (Some(m), Some(now), Shown::Detail(_, detail)) => detail_text(m, now, detail),
                        (Some(m), Some(now), _) => mechanisms::summary(m, now),
                        _ => "not on the target".into(),
                    }
                }
                ref shown => {
                    forcing::marked(&debuggee.ports, shown, &facts.memory, plain_text(shown, &facts, hex))
                }
            })
            .collect())
    }

    fn facts(&mut self, rows: &[Row]) -> Result<Facts, RequestError> {
        let mut plan = ReadPlan::default();
        let mut known = Vec::new();
        let (mut registers, mut machine, mut sequences) = (false, false, false);
        for row in rows {
            match row.shown {
                Shown::Bit { addr, .. } => self.want(addr, 1, &mut plan, &mut known),
                Shown::Cell { addr, width } => self.want(addr, width.bytes(), &mut plan, &mut known),
                Shown::Text { addr, len } => plan.want(addr, len),
                Shown::Area { addr, len } => plan.want(addr, len.min(PREVIEW)),
                Shown::Register(_) | Shown::Pushed(_) => registers = true,
                Shown::Machine(_) => machine = true,
                Shown::Mechanism(_) | Shown::Detail(..) => sequences = true,
            }
        }
        let ports = &self.debuggee()?.ports;
        let masks = |row: &Row| Some(forcing::forcible(ports, &row.shown)?.1);
        let masks: Vec<(Addr, Addr)> = rows.iter().filter_map(masks).collect();
        for (low, high) in masks {
            self.want(low, 1, &mut plan, &mut known);
            self.want(high, 1, &mut plan, &mut known);
        }
        let mut memory = self.read(plan)?;
        for (addr, len, number) in known {
            memory.know(addr, len, number);
        }
        Ok(Facts {
            memory,
            registers: if registers { Some(self.registers()?) } else { None },
            machine: if machine { self.machine_registers()? } else { None },
            sequences: if sequences { self.sequences()? } else { Vec::new() },
        })
    }

    /// What a stream tells need not be read.
    fn want(&mut self, addr: Addr, len: u32, plan: &mut ReadPlan, known: &mut Vec<(Addr, u32, u64)>) {
        match self.glance(addr, len) {
            Some(number) => known.push((addr, len, number)),
            None => plan.want(addr, len),
        }
    }

    pub(super) fn read(&mut self, plan: ReadPlan) -> Result<MemoryView, RequestError> {
        let (target, _) = self.parts()?;
        let mut view = MemoryView::default();
        for pieces in plan.requests(target.limits().max_read) {
            let Response::Memory { bytes, .. } = target.ask(Ask::Read { pieces: pieces.clone() })? else {
                return Err(RequestError::Refused("it did not send the memory it was asked for".into()));
            };
            if !view.add(&pieces, &bytes) {
                return Err(RequestError::Refused("it sent less memory than it was asked for".into()));
            }
        }
        Ok(view)
    }

    /// The registers of the stop, or of the last cycle.
    pub(super) fn registers(&mut self) -> Result<Registers, RequestError> {
        let (target, debuggee) = self.parts()?;
        if let Some(stop) = &debuggee.stop {
            return Ok(stop.stopped.registers);
        }
        match target.ask(Ask::Registers)? {
            Response::Registers(registers) => Ok(registers),
            _ => Err(RequestError::Refused("it did not tell the registers".into())),
        }
    }

    /// The registers of the 80386; none from a target that does not tell them.
    fn machine_registers(&mut self) -> Result<Option<MachineRegisters>, RequestError> {
        let (target, _) = self.parts()?;
        if target.features() & feature::MACHINE_REGISTERS == 0 {
            return Ok(None);
        }
        match target.ask(Ask::MachineRegisters)? {
            Response::MachineRegisters(registers) => Ok(Some(registers)),
            _ => Err(RequestError::Refused("it did not tell the registers of the 80386".into())),
        }
    }

    /// Sets something and answers what it shows then.
    pub(super) fn set(
        &mut self,
        shown: &Shown,
        name: &str,
        text: &str,
        hex: bool,
    ) -> Result<String, RequestError> {
        let text = values::typed(text);
        let read_only = |reason| Err(RequestError::ReadOnly { name: name.to_owned(), reason });
        match *shown {
            Shown::Mechanism(n) | Shown::Detail(n, Detail::Active) => {
                return self.switch(n, shown, name, text);
            }
            Shown::Detail(..) => {
                return read_only("it follows from the state; start or stop the mechanism instead");
            }
            Shown::Pushed(_) | Shown::Register(Register::Stack) => {
                return read_only("the equation would not balance");
            }
            Shown::Machine(_) => {
                return read_only("it belongs to instructions of the 80386; set RLO, DR or BX instead");
            }
            Shown::Area { .. } => return read_only("it is an area; set its bytes one by one"),
            Shown::Bit { .. } | Shown::Cell { .. } | Shown::Text { .. } | Shown::Register(_) => {}
        }
        let wrong = |reason: ValueError| RequestError::Value(format!("`{name}`: {reason}"));
        let target = expression::target(shown).ok_or_else(|| wrong(ValueError::ReadOnly))?;
        let mut facts = Facts::default();
        match target.assign(text).map_err(wrong)? {
            Assignment::Bit { addr, bit, value } => {
                let mask = 1_u8 << (bit & 7);
                let value = if value { mask } else { 0 };
                self.write(Ask::WriteBits { addr, mask, value })?;
                facts.memory.add(&[(addr, 1)], &[value]);
            }
            Assignment::Memory { addr, bytes } => {
                facts.memory.add(&[(addr, bytes.len() as u16)], &bytes);
                self.write(Ask::Write { addr, bytes })?;
            }
            Assignment::Registers(change) => facts.registers = Some(self.change_registers(change)?),
        }
        Ok(plain_text(shown, &facts, hex))
    }

    pub(super) fn write(&mut self, request: Ask) -> Result<(), RequestError> {
        let (target, _) = self.parts()?;
        let result = target.ask(request).map(|_| ());
        self.watching.live.written();
        result
    }

    fn change_registers(&mut self, change: RegisterChange) -> Result<Registers, RequestError> {
        let (target, debuggee) = self.parts()?;
        let Some(stop) = &mut debuggee.stop else {
            return Err(RequestError::NotStopped { command: "setting a register".into() });
        };
        let new = registers::changed(&stop.stopped.registers, change);
        target.ask(Ask::SetRegisters(new))?;
        stop.stopped.registers = new;
        Ok(new)
    }

    /// Starts a mechanism or puts it into rest: `start`, `stop`, or a bit.
    fn switch(
        &mut self,
        sequence: u16,
        shown: &Shown,
        name: &str,
        text: &str,
    ) -> Result<String, RequestError> {
        let active = match text.to_ascii_lowercase().as_str() {
            "start" | "1" | "true" => true,
            "stop" | "0" | "false" => false,
            _ => {
                return Err(RequestError::Value(format!(
                    "`{name}`: a mechanism takes 1 (start) or 0 (stop)"
                )));
            }
        };
        self.set_mechanism(sequence, active)?;
        Ok(match shown {
            Shown::Mechanism(_) => if active { "started" } else { "at rest" }.to_owned(),
            _ => values::bit(active),
        })
    }

    pub(super) fn set_mechanism(&mut self, sequence: u16, active: bool) -> Result<(), RequestError> {
        let (target, debuggee) = self.parts()?;
        target.ask(Ask::SetSequence { sequence, active })?;
        if let Some(stop) = &mut debuggee.stop {
            stop.sequences = None;
        }
        self.watching.live.written();
        Ok(())
    }
}

/// The client shows numbers in hexadecimal.
pub(super) fn wants_hex(format: Option<&ValueFormat>) -> bool {
    format.is_some_and(|f| f.hex == Some(true))
}

fn pushed_row(n: usize) -> Row {
    let name = if n == 0 { "top".into() } else { format!("top - {n}") };
    Row { name, expression: None, shown: Shown::Pushed(n), children: None }
}

fn plain_text(shown: &Shown, facts: &Facts, hex: bool) -> String {
    let number = |addr: Addr, width: Width| facts.memory.number(addr, width.bytes());
    match *shown {
        Shown::Bit { addr, bit } => values::bit(number(addr, Width::Byte) >> bit & 1 == 1),
        Shown::Cell { addr, width } => values::cell(number(addr, width), width, hex),
        Shown::Text { addr, len } => values::text(facts.memory.bytes(addr, len)),
        Shown::Area { addr, len } => {
            let bytes = facts.memory.bytes(addr, len.min(PREVIEW));
            let shown: Vec<String> = bytes.iter().map(|b| format!("{b:02X}")).collect();
            let more = if len > PREVIEW { " …" } else { "" };
            format!("{len} bytes: {}{more}", shown.join(" "))
        }
        Shown::Register(register) => facts.registers.map_or_else(String::new, |r| register.show(&r, hex)),
        Shown::Machine(register) => {
            facts.machine.map_or_else(|| "this target does not tell it".into(), |r| register.show(r, hex))
        }
        Shown::Pushed(n) => {
            let pushed = facts.registers.map(|r| registers::stack(&r)).unwrap_or_default();
            pushed.get(n).map_or_else(String::new, |b| values::bit(*b))
        }
        Shown::Mechanism(_) | Shown::Detail(..) => String::new(),
    }
}

fn detail_text(
    mechanism: &technol_image::debug_info::Mechanism,
    now: &SequenceState,
    detail: Detail,
) -> String {
    let state = mechanisms::state(mechanism, now);
    match detail {
        Detail::Active => values::bit(now.active),
        Detail::Line => mechanisms::line(mechanism, now).to_string(),
        Detail::State => state.map_or_else(|| "at its start".into(), |s| s.mnemonic.clone()),
        Detail::Condition => state.map_or_else(String::new, |s| s.condition.clone()),
        Detail::Time => mechanisms::duration(mechanisms::millis(mechanism, now)),
    }
}
