//! Conditions of a scenario: comparisons of what the program holds, `SP_RUNS && SP_SPEED >= 5`.

mod parse;

use technol_analysis::expression::{Register, RegisterValues, Target, Value};
use technol_image::op::Width;
use technol_image::{DebugInfo, Program};
use technol_runtime::Runtime;

use super::messages::Messages;
use super::state::{Mechanisms, Wanted};
use crate::run::changes::values;

/// What names in a condition may stand for.
pub(super) struct Names<'a> {
    pub(super) program: &'a Program,
    pub(super) debug: &'a DebugInfo,
    pub(super) mechanisms: &'a Mechanisms,
}

/// What a condition is held against.
pub(super) struct Look<'a> {
    pub(super) runtime: &'a Runtime,
    pub(super) messages: &'a Messages,
    pub(super) mechanisms: &'a Mechanisms,
}

/// Something that is true or not at each moment.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Condition {
    /// As written.
    pub(super) text: String,
    /// One of these, of which each all.
    any: Vec<Vec<Clause>>,
}

/// What is wrong with a condition: byte of its text, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Mistake {
    pub(super) at: usize,
    pub(super) message: String,
}

/// The two sides of an expectation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Name,
    Value,
}

#[derive(Clone, Debug, PartialEq)]
struct Clause {
    negated: bool,
    left: Operand,
    test: Option<(Comparison, Operand)>,
}

#[derive(Clone, Debug, PartialEq)]
enum Operand {
    /// As written, and what it is.
    Value(String, Target),
    Real(f64),
    Text(String),
    /// Name and number of the sequence.
    Mechanism(String, u16),
    State(Wanted),
    Message(u32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Comparison {
    Equal,
    Different,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

impl Condition {
    pub(super) fn holds(&self, look: &Look<'_>) -> bool {
        self.any.iter().any(|every| every.iter().all(|clause| clause.holds(look)))
    }

    /// The names in it that have a value, as written.
    pub(super) fn values(&self) -> impl Iterator<Item = (&str, Target)> {
        self.operands().filter_map(|operand| match operand {
            Operand::Value(_, Target::Constant(_)) => None,
            Operand::Value(text, target) => Some((text.as_str(), *target)),
            _ => None,
        })
    }

    /// What everything in it is at present: `COUNT is 3, LAMP is 0`.
    pub(super) fn explain(&self, look: &Look<'_>) -> String {
        let mut parts: Vec<String> = Vec::new();
        for operand in self.operands() {
            let part = operand.explain(look).filter(|part| !parts.contains(part));
            parts.extend(part);
        }
        parts.join(", ")
    }

    fn operands(&self) -> impl Iterator<Item = &Operand> {
        let clauses = self.any.iter().flatten();
        clauses.flat_map(|clause| {
            std::iter::once(&clause.left).chain(clause.test.iter().map(|(_, right)| right))
        })
    }
}

impl Clause {
    fn holds(&self, look: &Look<'_>) -> bool {
        let holds = match &self.test {
            None => self.left.is_true(look),
            Some((comparison, Operand::State(wanted))) => {
                let state = match &self.left {
                    Operand::Mechanism(_, sequence) => look.runtime.sequences().nth(usize::from(*sequence)),
                    _ => None,
                };
                let equal = state.is_some_and(|state| wanted.holds(&state));
                equal == (*comparison == Comparison::Equal)
            }
            Some((comparison, right)) => {
                let signed = self.left.is_negative() || right.is_negative();
                compare(*comparison, self.left.value(look, signed), right.value(look, signed))
            }
        };
        holds != self.negated
    }
}

impl Operand {
    fn is_negative(&self) -> bool {
        matches!(self, Operand::Value(_, Target::Constant(value)) if *value < 0)
    }

    fn is_true(&self, look: &Look<'_>) -> bool {
        match self {
            Operand::Message(number) => look.messages.is_open(*number),
            Operand::Mechanism(_, sequence) => {
                look.runtime.sequences().nth(usize::from(*sequence)).is_some_and(|state| state.active)
            }
            _ => match self.value(look, false) {
                Some(Comparable::Whole(value)) => value != 0,
                Some(Comparable::Real(value)) => value != 0.0,
                _ => false,
            },
        }
    }

    fn value(&self, look: &Look<'_>, signed: bool) -> Option<Comparable> {
        match self {
            Operand::Real(value) => Some(Comparable::Real(*value)),
            Operand::Text(text) => Some(Comparable::Text(text.clone())),
            Operand::Value(_, target) => {
                let value = read(*target, look.runtime)?;
                Some(Comparable::of(value, if signed { width(*target) } else { None }))
            }
            _ => None,
        }
    }

    fn explain(&self, look: &Look<'_>) -> Option<String> {
        match self {
            Operand::Value(_, Target::Constant(_))
            | Operand::Real(_)
            | Operand::Text(_)
            | Operand::State(_) => None,
            Operand::Value(text, target) => Some(format!(
                "{text} is {}",
                read(*target, look.runtime).map_or("outside of memory".to_owned(), shown)
            )),
            Operand::Mechanism(name, sequence) => {
                let state = look.runtime.sequences().nth(usize::from(*sequence))?;
                Some(format!("{name} {}", look.mechanisms.describe(&state)))
            }
            Operand::Message(number) => {
                let shown =
                    if look.messages.is_open(*number) { "has been shown" } else { "has not been shown" };
                Some(format!("message {number} {shown}"))
            }
        }
    }
}

/// A value that can be compared with another.
enum Comparable {
    Whole(i128),
    Real(f64),
    Text(String),
}

impl Comparable {
    /// With a width it is a signed number of that width.
    fn of(value: Value, signed: Option<Width>) -> Comparable {
        match (value, signed) {
            (Value::Bit(value), _) => Comparable::Whole(i128::from(value)),
            (Value::Unsigned(value), Some(width)) => {
                let unused = 64 - width.bits();
                Comparable::Whole(i128::from((value << unused) as i64 >> unused))
            }
            (Value::Unsigned(value), None) => Comparable::Whole(i128::from(value)),
            (Value::Signed(value), _) => Comparable::Whole(i128::from(value)),
            (Value::Real(value), _) => Comparable::Real(value),
            (Value::Text(text), _) => Comparable::Text(text),
        }
    }
}

fn compare(comparison: Comparison, left: Option<Comparable>, right: Option<Comparable>) -> bool {
    use std::cmp::Ordering;
    let (Some(left), Some(right)) = (left, right) else { return false };
    let ordering = match (left, right) {
        (Comparable::Whole(a), Comparable::Whole(b)) => Some(a.cmp(&b)),
        (Comparable::Real(a), Comparable::Real(b)) => a.partial_cmp(&b),
        (Comparable::Real(a), Comparable::Whole(b)) => a.partial_cmp(&(b as f64)),
        (Comparable::Whole(a), Comparable::Real(b)) => (a as f64).partial_cmp(&b),
        (Comparable::Text(a), Comparable::Text(b)) => Some(a.cmp(&b)),
        _ => None,
    };
    match comparison {
        Comparison::Equal => ordering == Some(Ordering::Equal),
        Comparison::Different => ordering != Some(Ordering::Equal),
        Comparison::Less => ordering == Some(Ordering::Less),
        Comparison::LessOrEqual => matches!(ordering, Some(Ordering::Less | Ordering::Equal)),
        Comparison::Greater => ordering == Some(Ordering::Greater),
        Comparison::GreaterOrEqual => matches!(ordering, Some(Ordering::Greater | Ordering::Equal)),
    }
}

/// The value of a target at present.
pub(super) fn read(target: Target, runtime: &Runtime) -> Option<Value> {
    let registers: RegisterValues = values(&runtime.registers());
    target.read(runtime.memory(), &registers)
}

/// A value as a PLC programmer writes it: bits are 0 and 1.
pub(super) fn shown(value: Value) -> String {
    match value {
        Value::Bit(value) => u8::from(value).to_string(),
        other => other.to_string(),
    }
}

fn width(target: Target) -> Option<Width> {
    match target {
        Target::Cell { width: Width::Real, .. } => None,
        Target::Cell { width, .. } | Target::Register(Register::DrPart(width)) => Some(width),
        _ => None,
    }
}
