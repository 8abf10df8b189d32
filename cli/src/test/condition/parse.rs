//! The grammar of conditions, with every name looked up.
//!
//! ```text
//! condition  = every { "||" every }
//! every      = clause { "&&" clause }
//! clause     = [ "!" ] operand [ ( "==" | "!=" | "<" | "<=" | ">" | ">=" ) operand ]
//! operand    = "MECH(" mechanism ")" | "MESSAGE(" number ")" | real | text | expression of the debugger
//! ```

use technol_analysis::expression::{ExpressionError, Target, resolve};

use super::{Clause, Comparison, Condition, Mistake, Names, Operand, Side, width};
use crate::test::state::Wanted;

/// Longer ones first, so that `<=` is not taken for `<`.
const COMPARISONS: [(&str, Comparison); 6] = [
    ("==", Comparison::Equal),
    ("!=", Comparison::Different),
    ("<=", Comparison::LessOrEqual),
    (">=", Comparison::GreaterOrEqual),
    ("<", Comparison::Less),
    (">", Comparison::Greater),
];

impl Condition {
    /// Reads a condition; every name is looked up.
    pub(in crate::test) fn parse(text: &str, names: &Names<'_>) -> Result<Condition, Mistake> {
        let mut any = Vec::new();
        for (at, every) in split(text, 0, "||") {
            let clauses = split(every, at, "&&").into_iter();
            any.push(clauses.map(|(at, clause)| Clause::parse(clause, at, names)).collect::<Result<_, _>>()?);
        }
        Ok(Condition { text: text.trim().to_owned(), any })
    }

    /// `name` compared with `text`, which may begin with a comparison: `5`, `>= 5`, `OTHER`.
    ///
    /// # Errors
    /// What is wrong, and whether with the name or with what it is compared with.
    pub(in crate::test) fn expectation(
        name: &str,
        text: &str,
        names: &Names<'_>,
    ) -> Result<Condition, (Side, Mistake)> {
        let left = Operand::parse(name, 0, names).map_err(|mistake| (Side::Name, mistake))?;
        // A text buffer is compared with the text as it is.
        if let Operand::Value(_, Target::Text { .. }) = left {
            let shown = format!("{name} == '{}'", text.replace('\'', "''"));
            let test = Some((Comparison::Equal, Operand::Text(text.to_owned())));
            return Ok(Condition { text: shown, any: vec![vec![Clause { negated: false, left, test }]] });
        }
        let value = text.trim();
        let compares = COMPARISONS.iter().any(|(sign, _)| value.starts_with(sign));
        let whole = if compares { format!("{name} {value}") } else { format!("{name} == {value}") };
        // The place is that of the value: what stands before it here is not in the file.
        let before = whole.len() - value.len();
        Condition::parse(&whole, names)
            .map_err(|mistake| (Side::Value, Mistake { at: mistake.at.saturating_sub(before), ..mistake }))
    }

    /// The mechanism is in a state.
    pub(in crate::test) fn state(
        mechanism: &str,
        state: &str,
        names: &Names<'_>,
    ) -> Result<Condition, Mistake> {
        let (name, sequence) = find_mechanism(mechanism, 0, names)?;
        let wanted = designate(&name, state, 0, names)?;
        let left = Operand::Mechanism(name.clone(), sequence);
        let test = Some((Comparison::Equal, Operand::State(wanted)));
        let clause = Clause { negated: false, left, test };
        Ok(Condition { text: format!("MECH({name}) == {}", state.trim()), any: vec![vec![clause]] })
    }
}

impl Clause {
    fn parse(text: &str, at: usize, names: &Names<'_>) -> Result<Clause, Mistake> {
        let (text, at) = trimmed(text, at);
        if text.is_empty() {
            return Err(Mistake {
                at,
                message: "a condition is missing here, for instance COUNT >= 5".to_owned(),
            });
        }
        check_parentheses(text, at)?;
        let (negated, text, at) = match text.strip_prefix('!') {
            Some(rest) => {
                let (rest, start) = trimmed(rest, at + 1);
                (true, rest, start)
            }
            None => (false, text, at),
        };
        let Some((place, sign, comparison)) = find_comparison(text, at)? else {
            let left = Operand::parse(text, at, names)?;
            left.check_alone(at)?;
            return Ok(Clause { negated, left, test: None });
        };
        let left = Operand::parse(&text[..place], at, names)?;
        let (right_text, right_at) = trimmed(&text[place + sign.len()..], at + place + sign.len());
        let right = match &left {
            Operand::Mechanism(name, _) => {
                Operand::State(designate(name, unquoted(right_text), right_at, names)?)
            }
            Operand::Value(_, Target::Text { .. }) if is_quoted(right_text) => {
                Operand::Text(unquoted(right_text).replace("''", "'"))
            }
            _ => Operand::parse(right_text, right_at, names)?,
        };
        let clause = Clause { negated, left, test: Some((comparison, right)) };
        clause.check().map_err(|message| Mistake { at: right_at, message })?;
        Ok(clause)
    }

    /// Comparisons that could never mean anything.
    fn check(&self) -> Result<(), String> {
        let Some((comparison, right)) = &self.test else { return Ok(()) };
        let equality = matches!(comparison, Comparison::Equal | Comparison::Different);
        match (&self.left, right) {
            (Operand::Message(_), _) | (_, Operand::Message(_) | Operand::Mechanism(..)) => {
                Err("MECH(…) stands on the left of == and !=, MESSAGE(…) stands alone".to_owned())
            }
            (Operand::Mechanism(..), _) if !equality => {
                Err("a mechanism is or is not in a state: use == or !=".to_owned())
            }
            (
                Operand::Value(_, Target::Text { .. }),
                Operand::Text(_) | Operand::Value(_, Target::Text { .. }),
            ) => {
                if equality {
                    Ok(())
                } else {
                    Err("texts are compared by == and != only".to_owned())
                }
            }
            (_, Operand::Text(_)) | (Operand::Text(_), _) => {
                Err("a text is compared with a text buffer (STR) only".to_owned())
            }
            (Operand::Value(name, Target::Text { .. }), _) => {
                Err(format!("{name} is a text: compare it with one between apostrophes, 'like this'"))
            }
            (Operand::Value(name, target), Operand::Value(_, Target::Constant(value))) if equality => {
                fits(name, *target, *value)
            }
            _ => Ok(()),
        }
    }
}

impl Operand {
    fn parse(text: &str, at: usize, names: &Names<'_>) -> Result<Operand, Mistake> {
        let (text, at) = trimmed(text, at);
        let wrong = |at, message: String| Err(Mistake { at, message });
        if let Some((inside, offset)) = call(text, "MECH") {
            let (name, sequence) = find_mechanism(inside, at + offset, names)?;
            return Ok(Operand::Mechanism(name, sequence));
        }
        if let Some((inside, offset)) = call(text, "MESSAGE") {
            return match inside.trim().parse() {
                Ok(number) => Ok(Operand::Message(number)),
                Err(_) => wrong(at + offset, format!("`{}` is not the number of a message", inside.trim())),
            };
        }
        match text.to_ascii_lowercase().as_str() {
            "" => return wrong(at, "a value is missing here".to_owned()),
            "true" => return Ok(Operand::Value(text.to_owned(), Target::Constant(1))),
            "false" => return Ok(Operand::Value(text.to_owned(), Target::Constant(0))),
            _ => {}
        }
        if text.contains('.') && text.trim_start_matches(['-', '+']).starts_with(|c: char| c.is_ascii_digit())
        {
            let real = text.parse().ok().filter(|value: &f64| value.is_finite());
            return match real {
                Some(value) => Ok(Operand::Real(value)),
                None => wrong(at, format!("`{text}` is not a number")),
            };
        }
        if is_quoted(text) && unquoted(text).chars().count() != 1 {
            return Ok(Operand::Text(unquoted(text).replace("''", "'")));
        }
        match resolve(names.debug, None, text) {
            Ok(target) => Ok(Operand::Value(text.to_owned(), target.in_memory(names.program))),
            Err(error) => {
                let column = match &error {
                    ExpressionError::Unexpected(column, _) => *column,
                    _ => 0,
                };
                wrong(at + column, error.to_string())
            }
        }
    }

    /// Whether it may be a condition without a comparison.
    fn check_alone(&self, at: usize) -> Result<(), Mistake> {
        let message = match self {
            Operand::Value(text, Target::Constant(_)) => {
                format!("`{text}` never changes; compare it with something, for instance COUNT >= {text}")
            }
            Operand::Value(text, Target::Text { .. }) => format!("compare the text: {text} == 'like this'"),
            Operand::Real(_) | Operand::Text(_) => "this never changes; compare it with something".to_owned(),
            _ => return Ok(()),
        };
        Err(Mistake { at, message })
    }
}

/// Whether a constant can be the value of this target.
fn fits(name: &str, target: Target, value: i64) -> Result<(), String> {
    if let Target::Bit { .. } = target {
        return if (0..=1).contains(&value) { Ok(()) } else { Err(format!("{name} is a bit, 0 or 1")) };
    }
    let Some(width) = width(target).filter(|width| width.bits() < 64) else { return Ok(()) };
    let (low, high) = (-1_i64 << (width.bits() - 1), (1_i64 << width.bits()) - 1);
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(format!("{name} has {} bits and is never {value}: {low} to {high}", width.bits()))
}

fn find_mechanism(name: &str, at: usize, names: &Names<'_>) -> Result<(String, u16), Mistake> {
    let (name, at) = trimmed(name, at);
    match names.mechanisms.find(name) {
        Some(mechanism) => Ok((mechanism.name.clone(), mechanism.sequence)),
        None => Err(Mistake { at, message: names.mechanisms.unknown(name) }),
    }
}

fn designate(mechanism: &str, state: &str, at: usize, names: &Names<'_>) -> Result<Wanted, Mistake> {
    let found = names.mechanisms.find(mechanism);
    found.map_or(Ok(Wanted::Idle), |m| m.designate(state)).map_err(|message| Mistake { at, message })
}

/// Parts of a text between separators that stand outside of apostrophes, with their places.
fn split<'a>(text: &'a str, at: usize, separator: &str) -> Vec<(usize, &'a str)> {
    let mut parts = Vec::new();
    let mut start = 0;
    let mut from = 0;
    while let Some(found) = find_outside(text, from, |rest| rest.starts_with(separator)) {
        parts.push((at + start, &text[start..found]));
        start = found + separator.len();
        from = start;
    }
    parts.push((at + start, &text[start..]));
    parts
}

/// First byte from `from` on, outside of apostrophes, at which the rest of the text is as wanted.
fn find_outside(text: &str, from: usize, wanted: impl Fn(&str) -> bool) -> Option<usize> {
    let mut quoted = false;
    for (at, c) in text.char_indices().skip_while(|(at, _)| *at < from) {
        match c {
            '\'' => quoted = !quoted,
            _ if !quoted && wanted(&text[at..]) => return Some(at),
            _ => {}
        }
    }
    None
}

fn find_comparison(text: &str, at: usize) -> Result<Option<(usize, &'static str, Comparison)>, Mistake> {
    let Some(place) = find_outside(text, 0, |rest| rest.starts_with(['=', '!', '<', '>', '&', '|'])) else {
        return Ok(None);
    };
    let rest = &text[place..];
    if let Some((sign, comparison)) = COMPARISONS.iter().find(|(sign, _)| rest.starts_with(sign)) {
        return Ok(Some((place, sign, *comparison)));
    }
    let sign = &rest[..1];
    let message = match sign {
        "=" => "`=` compares nothing; write ==".to_owned(),
        "!" => "`!` stands before a name, or in !=".to_owned(),
        _ => format!("`{sign}` is not known here; write {sign}{sign}"),
    };
    Err(Mistake { at: at + place, message })
}

/// Parentheses belong to addresses and to MECH and MESSAGE: they do not group conditions.
fn check_parentheses(text: &str, at: usize) -> Result<(), Mistake> {
    let mut depth = 0_i64;
    let mut quoted = false;
    for c in text.chars() {
        match c {
            '\'' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth -= 1,
            _ => {}
        }
        if depth < 0 {
            break;
        }
    }
    if depth == 0 {
        return Ok(());
    }
    let message = "parentheses do not match; they do not group conditions either: `&&` is stronger than `||`";
    Err(Mistake { at, message: message.to_owned() })
}

/// The inside of `WORD(…)` and where it starts.
fn call<'a>(text: &'a str, word: &str) -> Option<(&'a str, usize)> {
    let head = text.get(..word.len())?;
    let rest = text.get(word.len()..)?;
    if !head.eq_ignore_ascii_case(word) {
        return None;
    }
    let inside = rest.trim_start().strip_prefix('(')?.strip_suffix(')')?;
    Some((inside, text.len() - 1 - inside.len()))
}

fn trimmed(text: &str, at: usize) -> (&str, usize) {
    let start = text.trim_start();
    (start.trim_end(), at + text.len() - start.len())
}

fn is_quoted(text: &str) -> bool {
    text.len() >= 2 && text.starts_with('\'') && text.ends_with('\'')
}

fn unquoted(text: &str) -> &str {
    if is_quoted(text) { &text[1..text.len() - 1] } else { text }
}
