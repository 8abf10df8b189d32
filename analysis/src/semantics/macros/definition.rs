//! A macro definition: header, T_LOCAL lines, body, flags of its end.

use crate::database::{self, Db, Section};
use crate::syntax::ast::{Columns, Expr, ExprKind, Line, Name};

/// What a macro is. Own lines of its section, nothing absolute.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MacroDefinition {
    /// Name in the header.
    pub name: Option<Name>,
    /// Formal parameters, in order.
    pub parameters: Vec<Name>,
    /// T_LOCAL symbols, each with its own line.
    pub locals: Vec<(u32, Name)>,
    /// Flags of END_T_MACRO.
    pub flags: Flags,
    /// Lines that an expansion consists of: no header, T_LOCAL, end, empty lines and comments.
    pub body: Vec<BodyLine>,
}

/// A line of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BodyLine {
    /// 0-based own line.
    pub line: u32,
    /// Its text up to the comment.
    pub text: String,
    /// Columns of its operation.
    pub operation: Option<Columns>,
    /// The parser complained about it.
    pub broken: bool,
}

/// What END_T_MACRO and APPEND_T_MACRO say about the calls of a macro (manual 22.4).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Flags {
    /// Relation to the stack of logic instructions.
    pub stack: StackFlag,
    /// `C_1`: operands may have brackets.
    pub brackets: bool,
    /// `D_ON`: a call takes break-points in DEBUG regions.
    pub break_points: bool,
}

/// Relation of a call to the stack of logic instructions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum StackFlag {
    /// None.
    #[default]
    Normal,
    /// Empties it.
    Begin,
    /// Ends the equation, as WR does.
    End,
    /// Saves RLO, as LDR does.
    Push,
    /// Takes a value back, as LO without operand does.
    Pop,
}

/// The words of the flags by their position in the list.
pub const FLAG_WORDS: [&[&str]; 3] =
    [&["T_NORMAL", "T_BEGIN", "T_END", "T_PUSH", "T_POP"], &["C_0", "C_1"], &["D_OFF", "D_ON"]];

/// A mistake in a list of flags.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FlagProblem {
    /// No flag.
    Unknown(Columns),
    /// A flag out of the order stack, conversion, debugging.
    Order(Columns),
    /// Two flags of one kind.
    Twice(Columns),
}

impl StackFlag {
    /// Its word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            StackFlag::Normal => "T_NORMAL",
            StackFlag::Begin => "T_BEGIN",
            StackFlag::End => "T_END",
            StackFlag::Push => "T_PUSH",
            StackFlag::Pop => "T_POP",
        }
    }
}

impl Flags {
    /// Reads a list of flags. A flag alone or out of order counts all the same: their words are distinct.
    #[must_use]
    pub fn read(operands: &[Expr]) -> (Flags, Vec<FlagProblem>) {
        let mut flags = Flags::default();
        let mut problems = Vec::new();
        let mut given = [false; 3];
        let mut last = 0;
        for operand in operands {
            let name = match &operand.kind {
                ExprKind::Missing => continue,
                ExprKind::Name(name) => name.text.to_ascii_uppercase(),
                _ => {
                    problems.push(FlagProblem::Unknown(operand.columns.clone()));
                    continue;
                }
            };
            let Some(position) = FLAG_WORDS.iter().position(|words| words.contains(&name.as_str())) else {
                problems.push(FlagProblem::Unknown(operand.columns.clone()));
                continue;
            };
            if std::mem::replace(&mut given[position], true) {
                problems.push(FlagProblem::Twice(operand.columns.clone()));
            } else if position < last {
                problems.push(FlagProblem::Order(operand.columns.clone()));
            }
            last = last.max(position);
            match name.as_str() {
                "T_BEGIN" => flags.stack = StackFlag::Begin,
                "T_END" => flags.stack = StackFlag::End,
                "T_PUSH" => flags.stack = StackFlag::Push,
                "T_POP" => flags.stack = StackFlag::Pop,
                "C_1" => flags.brackets = true,
                "D_ON" => flags.break_points = true,
                _ => {}
            }
        }
        (flags, problems)
    }
}

/// Reads the definition in a section.
pub(crate) fn read(db: &dyn Db, section: Section<'_>) -> MacroDefinition {
    let parsed = database::section_lines(db, section);
    let errors = parsed.error_lines();
    let last = if section.closed(db) { parsed.lines.len().saturating_sub(1) } else { parsed.lines.len() };
    let mut definition = MacroDefinition::default();
    if let Some(header) = parsed.lines.first() {
        let mut names = header.operands.iter().filter_map(name_of);
        definition.name = names.next();
        definition.parameters = names.collect();
    }
    if let Some(end) = parsed.lines.get(last).filter(|_| last > 0) {
        definition.flags = Flags::read(&end.operands).0;
    }
    let texts = crate::syntax::lines(section.text(db));
    for (number, (line, source)) in parsed.lines.iter().zip(texts).enumerate().take(last).skip(1) {
        if is(line, "T_LOCAL") {
            let names = line.operands.iter().filter_map(name_of);
            definition.locals.extend(names.map(|name| (number as u32, name)));
            continue;
        }
        let end = line.comment.as_ref().map_or(source.text.len(), |comment| comment.start as usize);
        let text = source.text.get(..end).unwrap_or_default().trim_end();
        if !text.trim().is_empty() {
            definition.body.push(BodyLine {
                line: number as u32,
                text: text.to_owned(),
                operation: line.operation.as_ref().map(|name| name.columns.clone()),
                broken: errors.binary_search(&(number as u32)).is_ok(),
            });
        }
    }
    definition
}

/// Whether a line's operation is this word.
pub(super) fn is(line: &Line, word: &str) -> bool {
    line.operation.as_ref().is_some_and(|operation| operation.text.eq_ignore_ascii_case(word))
}

fn name_of(expr: &Expr) -> Option<Name> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name.clone()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flags(text: &str) -> (Flags, usize) {
        let parsed = crate::syntax::parse_lines(text);
        let (flags, problems) = Flags::read(&parsed.lines[0].operands);
        (flags, problems.len())
    }

    #[test]
    fn flags_stand_in_their_order_and_may_be_left_out() {
        let all = Flags { stack: StackFlag::End, brackets: true, break_points: true };
        assert_eq!(flags("END_T_MACRO"), (Flags::default(), 0));
        assert_eq!(flags("END_T_MACRO T_END, C_1, D_ON"), (all, 0));
        assert_eq!(flags("END_T_MACRO d_on"), (Flags { break_points: true, ..Flags::default() }, 0));
        assert_eq!(flags("END_T_MACRO T_END,,D_ON").1, 0);
        assert_eq!(flags("END_T_MACRO D_ON, C_1, T_END"), (all, 2));
        assert_eq!(flags("END_T_MACRO T_END, T_POP").1, 1);
        assert_eq!(flags("END_T_MACRO T_STOP, 5").1, 2);
    }
}
