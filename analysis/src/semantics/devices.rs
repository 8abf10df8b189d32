//! Instructions of tables, buses, axes and outputs: uses that can be built but hardly do what was meant.

use technol_image::program::ModuleKind;

use super::analysis::{Device, DeviceUse, Record};
use super::hir::{Body, Instruction, Operand, Statement, StatementKind, SymbolScope};
use super::lints::uses::Uses;
use crate::catalogue::{self, Effect, Entry, Equation};
use crate::diagnostics::rules::lints as rules;
use crate::diagnostics::{Finding, Rule};
use crate::syntax::ParsedLines;
use crate::syntax::ast::{Columns, Line};
use crate::syntax::section::SectionKind;

/// Commands of ECAT_COMMAND that bring a state: the constants and their values.
const STATE_COMMANDS: [(&str, i64); 2] = [("ECATCMD_MASTER_STATE", 20), ("ECATCMD_SLAVE_STATE", 21)];

/// The cell that simulates a spindle's speed, under both its names.
const SIMULATED_SPEED: [&str; 2] = ["OTACKY_VR", "SIM_SPEED_PT"];

/// What a section does with devices.
#[derive(Default)]
pub(super) struct Found {
    /// Mistakes that the section alone shows.
    pub(super) findings: Vec<Finding>,
    /// Two-byte records, judged where the declarations are known.
    pub(super) records: Vec<Record>,
    /// Uses that other sections must match.
    pub(super) uses: Vec<DeviceUse>,
}

/// Checks a section.
pub(super) fn check(body: &Body, lines: &[Line], kind: SectionKind) -> Found {
    let mut check = Check { body, lines, kind, open_loops: Vec::new(), found: Found::default() };
    for index in 0..body.statements.len() {
        if let Some(code) = instruction(&body.statements[index]) {
            check.one(index, code);
        }
    }
    check.found
}

fn instruction(statement: &Statement) -> Option<&Instruction> {
    match &statement.kind {
        StatementKind::Instruction(instruction) => Some(instruction),
        _ => None,
    }
}

/// An instruction that takes several cycles and gives RLO 0 until it has finished.
fn is_transfer(entry: &Entry) -> bool {
    entry.ex_type
        && entry.equation == Equation::Overwrite
        && (entry.name.starts_with("PLCT_") || entry.name.starts_with("ECAT_"))
}

/// Whether lines may do something with devices: they have such an instruction, name such a cell, or have a word that
/// may call a macro.
pub(crate) fn may_name(parsed: &ParsedLines, uses: &Uses) -> bool {
    let named = |key: &&str| uses.names.binary_search_by(|(name, _)| (**name).cmp(key)).is_ok();
    let device = |name: &str| name.starts_with("POS_") || name.starts_with("ANALOG") || name == "AX_SPI";
    SIMULATED_SPEED.iter().any(named)
        || parsed.lines.iter().any(|line| {
            let operation = line.operation.as_ref();
            operation.is_some_and(|it| catalogue::entry(&it.text).is_none_or(|entry| device(entry.name)))
        })
}

/// What other sections must match.
fn device(code: &Instruction) -> Option<Device> {
    let axis = |at: usize| match code.operands.get(at) {
        Some(Operand::Integer { value, .. }) => u8::try_from(*value).unwrap_or(0),
        _ => 0,
    };
    let simulated = |at: usize| match code.operands.get(at) {
        Some(Operand::Cell { address, .. }) if address.symbol.scope == SymbolScope::System => {
            SIMULATED_SPEED.contains(&&*address.symbol.name).then_some(Device::SimulatedSpeed)
        }
        _ => None,
    };
    let name = code.entry.name;
    match name {
        "STO" | "STO0" | "STO1" | "MOVE" | "MOVE1" => simulated(0),
        "POS_INIT" => Some(Device::Init { axis: axis(0), older: false }),
        "POS_RESET" => Some(Device::Reset(axis(0))),
        "POS_MODE" => Some(Device::Mode(axis(3))),
        "POS_CONTROL" => Some(Device::Control(axis(3))),
        "ANALOG_PORT" => Some(Device::Port),
        "ANALOG" if code.operands.len() < 2 => Some(Device::Analog),
        "AX_SPI" => Some(Device::Spindle),
        _ => {
            let (what, axis) = name.strip_prefix("POS_")?.split_once('_')?;
            let axis = ["X", "Y", "Z", "4", "5", "6"].iter().position(|letter| *letter == axis)? as u8 + 1;
            match what {
                "INIT" => Some(Device::Init { axis, older: true }),
                "RESET" => Some(Device::Reset(axis)),
                "MODE" => Some(Device::Mode(axis)),
                "CONTROL" => Some(Device::Control(axis)),
                _ => None,
            }
        }
    }
}

struct Check<'a> {
    body: &'a Body,
    lines: &'a [Line],
    kind: SectionKind,
    /// VAZBA_ bits that the section has cleared so far.
    open_loops: Vec<&'a str>,
    found: Found,
}

impl<'a> Check<'a> {
    fn one(&mut self, index: usize, code: &'a Instruction) {
        match code.entry.name {
            "EX0" | "EX1" | "TEX0" | "TEX1" => self.jump_behind(index, code),
            "FL" => self.flag(code),
            "SPI_AX" if code.operands.len() == 4 => {
                let message = "the axis is left out, the one of the last AX_SPI is meant; name it";
                self.report(&rules::AXIS_LEFT_OUT, index, None, message.to_string());
            }
            "ANALOG_PORT" if matches!(code.operands.first(), Some(Operand::Cell { .. })) => {
                let message = "the port comes from a cell and is not checked; write its number";
                self.report(&rules::PORT_IN_A_CELL, index, Some(0), message.to_string());
            }
            "RAMP" => self.ramp(index),
            "ECAT_COMMAND" => self.command(index, code),
            "POS_MODE" | "POS_CONTROL" => self.record(index, code),
            name if name.starts_with("POS_MODE_") || name.starts_with("POS_CONTROL_") => {
                self.record(index, code);
            }
            name if name.starts_with("REGUL_") => self.regulator(index, name),
            _ => {}
        }
        if is_transfer(code.entry) {
            self.transfer(index, code);
        }
        self.buffer(index, code);
        if let Some(device) = device(code) {
            let (line, columns) = self.columns(index, None);
            self.found.uses.push(DeviceUse { line, columns, device });
        }
    }

    /// Columns of an operand, or of the operation. What a macro expands to has no operands of its own in the line.
    fn columns(&self, index: usize, operand: Option<usize>) -> (u32, Columns) {
        let statement = &self.body.statements[index];
        let line = self.lines.get(statement.line as usize);
        let operation = line.and_then(|line| line.operation.as_ref());
        let own = instruction(statement).is_some_and(|code| {
            operation.is_some_and(|operation| operation.text.eq_ignore_ascii_case(code.entry.name))
        });
        let operand = operand.filter(|_| own).and_then(|operand| line?.operands.get(operand));
        let columns = operand.map(|operand| operand.columns.clone());
        (statement.line, columns.or_else(|| operation.map(|name| name.columns.clone())).unwrap_or(0..0))
    }

    fn report(&mut self, rule: &'static Rule, index: usize, operand: Option<usize>, message: String) {
        let (line, columns) = self.columns(index, operand);
        self.found.findings.push(Finding::new(rule, line, columns, message));
    }

    /// A wait goes on with one value of RLO only: a jump behind it is decided.
    fn jump_behind(&mut self, index: usize, wait: &Instruction) {
        let Some(next) = self.body.statements.get(index + 1).filter(|next| next.labels.is_empty()) else {
            return;
        };
        let Some(jump) = instruction(next).map(|code| code.entry.name).filter(|name| name.starts_with("JL"))
        else {
            return;
        };
        let rlo = u8::from(wait.entry.name.ends_with('0'));
        let always = jump.ends_with('1') == (rlo == 1);
        let after_transfer =
            index.checked_sub(1).and_then(|before| instruction(&self.body.statements[before]));
        let remedy = match after_transfer {
            Some(code) if is_transfer(code.entry) => "; the error is in DR, test EQ CNST.0 first",
            _ => "",
        };
        let does = if always { "always jumps" } else { "never jumps" };
        let message = format!("{} goes on only with RLO {rlo}, so {jump} {does}{remedy}", wait.entry.name);
        self.report(&rules::JUMP_DECIDED_BY_WAIT, index + 1, None, message);
    }

    fn flag(&mut self, code: &'a Instruction) {
        if !matches!(code.operands.first(), Some(Operand::Integer { value: 0, .. })) {
            return;
        }
        for operand in &code.operands[1..] {
            if let Operand::Bit { address, .. } = operand
                && let Some(axis) = address.symbol.name.strip_prefix("VAZBA_")
            {
                self.open_loops.push(axis);
            }
        }
    }

    fn regulator(&mut self, index: usize, name: &str) {
        let axis = name.trim_start_matches("REGUL_");
        let runs = matches!(
            self.kind,
            SectionKind::Mechanism | SectionKind::Module(ModuleKind::Main | ModuleKind::Fast)
        );
        if runs && !self.open_loops.contains(&axis) {
            let message = format!(
                "nothing before this line opens the position loop of the axis; clear VAZBA_{axis} first"
            );
            self.report(&rules::REGULATOR_IN_CLOSED_LOOP, index, None, message);
        }
    }

    fn ramp(&mut self, index: usize) {
        let once = match self.kind {
            SectionKind::Module(kind) => {
                !matches!(kind, ModuleKind::Main | ModuleKind::Fast | ModuleKind::Input | ModuleKind::Cont)
            }
            _ => false,
        };
        if once {
            let message = "RAMP makes one step each time it runs; this module does not run in every cycle";
            self.report(&rules::RAMP_RUNS_ONCE, index, None, message.to_string());
        }
    }

    fn command(&mut self, index: usize, code: &Instruction) {
        let state = code.operands.get(2).is_some_and(|operand| match operand {
            Operand::Integer { value, .. } => STATE_COMMANDS.iter().any(|(_, number)| number == value),
            Operand::Keyword(word) => STATE_COMMANDS.iter().any(|(name, _)| name == word),
            _ => false,
        });
        let given = |at: usize| code.operands.get(at).is_some_and(|operand| *operand != Operand::Skipped);
        if state && !given(3) {
            let message = "this command brings a state: name a cell for it and a DWORD cell for the length";
            self.report(&rules::STATE_WITHOUT_TARGET, index, Some(2), message.to_string());
        } else if given(3) && !given(4) {
            let message = "a target needs its length behind it, in a DWORD cell";
            self.report(&rules::STATE_WITHOUT_TARGET, index, Some(3), message.to_string());
        }
    }

    /// The first operand names two bytes.
    fn record(&mut self, index: usize, code: &Instruction) {
        let Some(Operand::Area { address, len }) = code.operands.first() else { return };
        let last = address.offset == i64::from(*len) - 1;
        if last && !address.indexed && address.symbol.scope != SymbolScope::System {
            let (line, columns) = self.columns(index, Some(0));
            let symbol = address.symbol.clone();
            self.found.records.push(Record { line, columns, symbol, instruction: code.entry.name });
        }
    }

    fn transfer(&mut self, index: usize, code: &Instruction) {
        let name = code.entry.name;
        let wait = match self.body.statements.get(index + 1).map(|next| &next.kind) {
            Some(StatementKind::Instruction(wait)) => Some(wait.entry),
            Some(StatementKind::Nested { .. }) => return,
            Some(StatementKind::Empty) | None => None,
        };
        match wait {
            Some(Entry { name: "EX0" | "TEX0", .. }) => self.error_test(index, name),
            Some(Entry { name: wait @ ("EX1" | "TEX1"), .. }) => {
                let message = format!(
                    "{name} gives RLO 0 until it has finished, and {wait} goes on with RLO 0; use EX0"
                );
                self.report(&rules::RESULT_NOT_AWAITED, index + 1, None, message);
            }
            Some(wait) if wait.reads.contains(&Effect::Rlo) => {}
            _ => {
                let message =
                    format!("{name} takes several cycles, but nothing waits for it; put EX0 behind it");
                self.report(&rules::RESULT_NOT_AWAITED, index, None, message);
            }
        }
    }

    /// Whether the lines behind the wait at `index + 1` look at DR.
    fn error_test(&mut self, index: usize, name: &str) {
        let holds = |effects: &[Effect]| {
            effects.iter().any(|effect| matches!(effect, Effect::Dr | Effect::Dr64 | Effect::DrReal))
        };
        for statement in self.body.statements.iter().skip(index + 2) {
            let code = match &statement.kind {
                StatementKind::Instruction(code) if statement.labels.is_empty() => code,
                StatementKind::Empty => break,
                // What stands at a label, in a macro or behind a nested section may come from elsewhere.
                _ => return,
            };
            let leaves = code.operands.iter().any(|o| matches!(o, Operand::Label(_) | Operand::Procedure(_)));
            if holds(code.entry.reads) || leaves || (code.entry.ex_type && !is_transfer(code.entry)) {
                return;
            }
            if holds(code.entry.writes) {
                break;
            }
        }
        let message =
            format!("whether {name} succeeded is in DR, and nothing tests it; put EQ CNST.0 behind the wait");
        self.report(&rules::ERROR_NOT_TESTED, index, None, message);
    }

    fn buffer(&mut self, index: usize, code: &Instruction) {
        let (operand, needed) = match code.entry.name {
            "PLCT_GET_REAL" | "PLCT_SET_REAL" => (3, 8),
            "CAN_SEND" | "CAN_RECV" => (1, 12),
            "CAN_RECV_REQ" => (6, 12),
            "COM_SEND_STR" => match code.operands.get(2) {
                Some(Operand::Integer { value, .. }) => (1, *value),
                _ => return,
            },
            "SA_READ" | "SA_WRITE" => match code.operands.get(2) {
                Some(Operand::Integer { value, .. }) => (3, *value),
                _ => return,
            },
            "SHARE_VAR" => match code.operands.get(3) {
                Some(Operand::Integer { value, .. }) => (0, *value),
                _ => return,
            },
            _ => return,
        };
        let Some(Operand::Area { address, len }) = code.operands.get(operand) else { return };
        let rest = i64::from(*len) - address.offset;
        if !address.indexed && address.offset >= 0 && rest < needed {
            let message = format!(
                "{} needs {needed} bytes, but {} has {} from here to its end",
                code.entry.name,
                address.symbol.name,
                rest.max(0)
            );
            self.report(&rules::BUFFER_TOO_SHORT, index, Some(operand), message);
        }
    }
}
