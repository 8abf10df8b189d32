//! What the lines before left in DR and DR_REAL, as far as the text tells, and instructions that do not fit it.

use technol_image::op::Width;

use crate::catalogue::{Effect, Entry};
use crate::diagnostics::Rule;
use crate::diagnostics::rules::lints as rules;
use crate::semantics::hir::Operand;

/// What is known between two lines. A label makes everything unknown.
#[derive(Debug, Default)]
pub(crate) struct Registers {
    /// DR holds this constant.
    constant: Option<i64>,
    /// DR holds a cell of this width, extended with its sign.
    cell: Option<Width>,
    /// An integer instruction that changed DR after DR_REAL was last valid.
    integer: Option<&'static str>,
}

impl Registers {
    /// An instruction; gives what does not fit.
    pub(crate) fn step(
        &mut self,
        entry: &'static Entry,
        operands: &[Operand],
    ) -> Option<(&'static Rule, String)> {
        let found = self.comparison(entry, operands).or_else(|| self.limit(entry, operands)).or_else(|| {
            let digits = self.bcd(entry, operands);
            digits.or_else(|| self.real(entry, operands))
        });
        self.follow(entry, operands);
        found
    }

    fn comparison(&self, entry: &Entry, operands: &[Operand]) -> Option<(&'static Rule, String)> {
        if !matches!(entry.name, "EQ" | "EQ1" | "LT" | "GT" | "LE" | "GE") {
            return None;
        }
        let [Operand::Integer { value, width: Width::DWord }] = operands else { return None };
        let (range, name) = match self.cell? {
            Width::Byte => (-0x80..=0x7F, "BYTE"),
            Width::Word => (-0x8000..=0x7FFF, "WORD"),
            _ => return None,
        };
        // Values that the cell could hold without a sign have a rule of their own for EQ.
        let unsigned = *range.end() * 2 + 1;
        let known = entry.name.starts_with("EQ") && (0..=unsigned).contains(value);
        if range.contains(value) || known {
            return None;
        }
        let (low, high) = (range.start(), range.end());
        let message = format!(
            "DR holds a {name} cell with its sign, {low} to {high}: comparing it with {value} always gives the same result"
        );
        Some((&rules::ALWAYS_THE_SAME, message))
    }

    fn limit(&self, entry: &Entry, operands: &[Operand]) -> Option<(&'static Rule, String)> {
        let [Operand::Cell { width, .. }] = operands else { return None };
        let most = match width {
            Width::Byte => 0xFF,
            Width::Word => 0xFFFF,
            _ => return None,
        };
        let value = self.constant.filter(|value| entry.name == "TM" && *value > most)?;
        let message = format!("this counter counts to {most} and never reaches {value}");
        Some((&rules::TIMER_NEVER_ENDS, message))
    }

    fn bcd(&self, entry: &Entry, operands: &[Operand]) -> Option<(&'static Rule, String)> {
        let value = self.constant?;
        let double = operands.contains(&Operand::Keyword("DWRD"));
        let digits = if double { 8 } else { 4 };
        match entry.name {
            "BCD" if !(0..10_i64.pow(digits)).contains(&value) => {
                let message = format!("{value} has no {digits} decimal digits");
                Some((&rules::BCD_RANGE, message))
            }
            "BIN" if (0..digits).any(|digit| (value >> (4 * digit)) & 0xF > 9) => {
                let message = format!("{value:X}h has digits above 9");
                Some((&rules::BCD_RANGE, message))
            }
            _ => None,
        }
    }

    fn real(&self, entry: &Entry, operands: &[Operand]) -> Option<(&'static Rule, String)> {
        let computes = matches!(
            entry.name,
            "AD" | "SU"
                | "MULB"
                | "DIVB"
                | "INR"
                | "DCR"
                | "INV"
                | "ABS"
                | "STO"
                | "STO0"
                | "STO1"
                | "EQ"
                | "EQ1"
                | "LT"
                | "GT"
                | "LE"
                | "GE"
        );
        let by = self.integer.filter(|_| computes && is_real(operands))?;
        let message =
            format!("{by} before it works with integers and leaves DR_REAL as it was; put REAL between them");
        Some((&rules::STALE_REAL, message))
    }

    fn follow(&mut self, entry: &'static Entry, operands: &[Operand]) {
        let wrote = |effect: Effect| entry.writes.contains(&effect);
        if entry.ex_type || matches!(entry.name, "PROC_CALL" | "JUM") {
            *self = Registers::default();
            return;
        }
        if !(wrote(Effect::Dr) || wrote(Effect::Dr64) || wrote(Effect::DrReal)) {
            return;
        }
        let integer = match entry.name {
            "REAL" => None,
            _ if is_real(operands) => None,
            "LOD" | "AD" | "SU" | "MULB" | "DIVB" | "INR" | "DCR" | "INV" | "ABS" | "ORB" | "ANDB"
            | "XORB" => Some(entry.name),
            _ => None,
        };
        *self = match (entry.name, operands) {
            ("LOD", [Operand::Integer { value, .. }]) => {
                Registers { constant: Some(*value), cell: None, integer }
            }
            ("LOD", [Operand::Cell { width, negated: false, .. }]) => {
                Registers { constant: None, cell: Some(*width), integer }
            }
            _ => Registers { constant: None, cell: None, integer },
        };
    }
}

fn is_real(operands: &[Operand]) -> bool {
    operands.iter().any(|operand| {
        // `BLK[n].REAL.member`: the member decides.
        let operand = if let Operand::Block { member, .. } = operand { member.as_ref() } else { operand };
        matches!(
            operand,
            Operand::Real(_) | Operand::Keyword("REAL") | Operand::Cell { width: Width::Real, .. }
        )
    })
}
