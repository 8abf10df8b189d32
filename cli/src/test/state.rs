//! States of mechanisms, as a scenario names them and a report shows them.

use std::fmt::Write as _;

use technol_image::debug_info::SymbolKind;
use technol_image::{DebugInfo, Program};
use technol_runtime::SequenceState;

/// All mechanisms of a program and the two block modules.
#[derive(Debug, Default)]
pub(super) struct Mechanisms {
    pub(super) list: Vec<Mechanism>,
}

/// A mechanism.
#[derive(Debug)]
pub(super) struct Mechanism {
    pub(super) name: String,
    pub(super) sequence: u16,
    /// Project path.
    pub(super) file: String,
    pub(super) states: Vec<State>,
}

/// A state: an EX-type instruction.
#[derive(Debug)]
pub(super) struct State {
    point: u16,
    /// 1-based.
    pub(super) line: u32,
    /// The instruction, without comment.
    pub(super) instruction: String,
    /// What it waits for.
    pub(super) condition: String,
    /// The last label before it, or the mechanism's own name.
    label: String,
}

/// The state a scenario asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// Not active.
    Idle,
    /// Active, wherever it is.
    Active,
    /// Waiting at this EX-type instruction.
    Point(u16),
}

impl Wanted {
    pub(super) fn holds(self, state: &SequenceState) -> bool {
        match self {
            Wanted::Idle => !state.active,
            Wanted::Active => state.active,
            Wanted::Point(point) => state.active && state.waiting == Some(point),
        }
    }
}

impl Mechanisms {
    /// Those of a program; `source` gives the text of a project file.
    pub(super) fn new<'s>(
        program: &Program,
        debug: &DebugInfo,
        source: &dyn Fn(&str) -> Option<&'s str>,
    ) -> Mechanisms {
        let list = debug.mechanisms.iter().map(|mechanism| {
            let file = debug.files.get(usize::from(mechanism.file)).map_or("?", |f| f.path.as_str());
            let lines: Vec<&str> = source(file).map(|text| text.lines().collect()).unwrap_or_default();
            let sequence = program.sequences.get(usize::from(mechanism.sequence));
            let states = mechanism.states.iter().map(|state| {
                let after = sequence.and_then(|s| s.resume.get(usize::from(state.point).checked_sub(1)?));
                let range = sequence.zip(after).map(|(sequence, after)| sequence.start..*after);
                let text =
                    lines.get((state.line as usize).wrapping_sub(1)).copied().unwrap_or(&state.mnemonic);
                let text = text.split(';').next().unwrap_or_default();
                State {
                    point: state.point,
                    line: state.line,
                    instruction: text.split_whitespace().collect::<Vec<_>>().join(" "),
                    condition: state.condition.clone(),
                    label: range
                        .and_then(|range| last_label(debug, range))
                        .unwrap_or_else(|| mechanism.name.clone()),
                }
            });
            Mechanism {
                name: mechanism.name.clone(),
                sequence: mechanism.sequence,
                file: file.to_owned(),
                states: states.collect(),
            }
        });
        Mechanisms { list: list.collect() }
    }

    pub(super) fn find(&self, name: &str) -> Option<&Mechanism> {
        self.list.iter().find(|m| m.name.eq_ignore_ascii_case(name.trim()))
    }

    /// What to say about a name that no mechanism has.
    pub(super) fn unknown(&self, name: &str) -> String {
        let names: Vec<&str> = self.list.iter().map(|m| m.name.as_str()).collect();
        let names = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
        format!("{name} is not a mechanism; there is: {names}")
    }

    /// What a mechanism does: `is idle`, `waits at turret.plc:63 TEX0 … (LDR T_UNCLAMPED)`.
    pub(super) fn describe(&self, state: &SequenceState) -> String {
        if !state.active {
            return "is idle".to_owned();
        }
        let mechanism = self.list.iter().find(|m| m.sequence == state.sequence);
        let at = state.waiting.and_then(|point| {
            let mechanism = mechanism?;
            let at = mechanism.states.iter().find(|s| s.point == point)?;
            Some((mechanism, at))
        });
        match at {
            Some((mechanism, at)) => format!("waits at {}:{at}", mechanism.file),
            None => "is active".to_owned(),
        }
    }
}

impl std::fmt::Display for State {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.line, self.instruction)?;
        if !self.condition.is_empty() {
            write!(f, " ({})", self.condition)?;
        }
        Ok(())
    }
}

impl Mechanism {
    /// The state that a text names: `idle`, `active`, or words and a line number that fit exactly one state.
    pub(super) fn designate(&self, text: &str) -> Result<Wanted, String> {
        match text.trim().to_ascii_lowercase().as_str() {
            "idle" => return Ok(Wanted::Idle),
            "active" => return Ok(Wanted::Active),
            _ => {}
        }
        let asked = words(text);
        let fitting: Vec<&State> =
            self.states.iter().filter(|state| !asked.is_empty() && state.is_called(&asked)).collect();
        match fitting.as_slice() {
            [state] => Ok(Wanted::Point(state.point)),
            [] => Err(format!(
                "`{}` is no state of {}; say idle, active, or a line, a label or words of one of:{}",
                text.trim(),
                self.name,
                listed(self.states.iter())
            )),
            several => Err(format!(
                "`{}` fits several states of {}; add a word, the label before it or the line:{}",
                text.trim(),
                self.name,
                listed(several.iter().copied())
            )),
        }
    }
}

impl State {
    /// Every word is its line, its label, or stands in its instruction or condition.
    fn is_called(&self, asked: &[String]) -> bool {
        let mut own = words(&self.instruction);
        own.extend(words(&self.condition));
        own.push(self.label.to_ascii_uppercase());
        own.push(self.line.to_string());
        asked.iter().all(|word| own.contains(word))
    }
}

fn words(text: &str) -> Vec<String> {
    let parts = text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '?' | '@')));
    parts.filter(|word| !word.is_empty()).map(str::to_ascii_uppercase).collect()
}

fn listed<'a>(states: impl Iterator<Item = &'a State>) -> String {
    states.fold(String::new(), |mut list, state| {
        // Writing to a string does not fail.
        let _ = write!(list, "\n    {}: {state}", state.label);
        list
    })
}

fn last_label(debug: &DebugInfo, range: std::ops::Range<u32>) -> Option<String> {
    let labels = debug.symbols.iter().filter_map(|symbol| match symbol.kind {
        SymbolKind::Label { pc } if range.contains(&pc) => Some((pc, &symbol.name)),
        _ => None,
    });
    labels.max_by_key(|(pc, _)| *pc).map(|(_, name)| name.clone())
}
