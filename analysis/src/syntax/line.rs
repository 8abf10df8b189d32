//! Parser of a line: `[label:] [operation [operand {, operand}]] [;comment]` (manual 3.1).

use super::ast::{Expr, ExprKind, Line, SyntaxError, SyntaxErrorKind};
use super::kind::SyntaxKind;
use super::lexer::{Problem, Token, lex};
use super::lines::lines;
use super::operand::{Cursor, operand};

/// The lines of a section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParsedLines {
    /// One entry per line.
    pub lines: Vec<Line>,
    /// At most one per line, ascending.
    pub errors: Vec<SyntaxError>,
}

/// Parses the own lines of a section, or any other text.
#[must_use]
pub fn parse_lines(text: &str) -> ParsedLines {
    let mut tokens = Vec::new();
    let mut parsed = ParsedLines::default();
    for (number, source) in lines(text).enumerate() {
        let (line, problem) = parse_line(source.text, &mut tokens);
        parsed.lines.push(line);
        if let Some((columns, kind)) = problem {
            parsed.errors.push(SyntaxError { line: number as u32, columns, kind });
        }
    }
    parsed
}

/// Parses a line without its end; leaves its tokens in `tokens`.
pub(super) fn parse_line(text: &str, tokens: &mut Vec<Token>) -> (Line, Problem) {
    let lexical = lex(text, tokens);
    let mut cursor = Cursor::new(text, tokens);
    let line = line(&mut cursor);
    (line, first(lexical, cursor.problem))
}

/// The problem that stands first; a bad character comes before what it leads to.
fn first(lexical: Problem, grammar: Problem) -> Problem {
    match (lexical, grammar) {
        (Some(a), Some(b)) => Some(if b.0.start < a.0.start { b } else { a }),
        (a, b) => a.or(b),
    }
}

fn line(cursor: &mut Cursor<'_>) -> Line {
    let mut line = Line { len: cursor.line.len() as u32, ..Line::default() };
    if let Some(comment) = cursor.tokens.last().filter(|t| t.kind == SyntaxKind::Comment) {
        line.comment = Some(comment.columns());
    }
    let mut word = first_word(cursor);
    if let Some(name) = word {
        let colon = cursor.peek_kind() == Some(SyntaxKind::Colon);
        let structure = !colon && declares_structure(cursor);
        if colon || structure || declares_without_colon(cursor) {
            if colon {
                cursor.bump();
            } else if !structure {
                cursor.report(name.columns(), SyntaxErrorKind::ExpectedColon);
            }
            line.label = Some(cursor.name(name));
            word = first_word(cursor);
        }
    }
    match (word, cursor.peek()) {
        (Some(operation), _) => {
            line.operation = Some(cursor.name(operation));
            line.operands = operands(cursor, operation);
        }
        (None, Some(token)) => cursor.report(token.columns(), SyntaxErrorKind::ExpectedOperation),
        (None, None) => {}
    }
    line
}

/// Steps over bad characters, which are reported already, and takes the word behind them.
fn first_word(cursor: &mut Cursor<'_>) -> Option<Token> {
    while let Some(token) = cursor.peek() {
        match token.kind {
            SyntaxKind::Unexpected => cursor.bump(),
            SyntaxKind::Name => {
                cursor.bump();
                return Some(token);
            }
            _ => return None,
        }
    }
    None
}

/// `ALFA DS 1`: the next word declares data and its operand follows without a comma.
fn declares_without_colon(cursor: &mut Cursor<'_>) -> bool {
    let Some(word) = cursor.peek() else { return false };
    let declares = ["DFM", "DS", "STR"].iter().any(|d| cursor.spelling(word).eq_ignore_ascii_case(d));
    let behind = cursor.tokens[cursor.at + 1..].iter().find(|t| t.kind != SyntaxKind::Whitespace);
    declares && behind.is_some_and(|t| matches!(t.kind, SyntaxKind::Name | SyntaxKind::Number))
}

/// `NAME STRUC`, `NAME ENDS`, `MEMBER DB ?`: the assembler's structures, whose names have no colon.
fn declares_structure(cursor: &mut Cursor<'_>) -> bool {
    let Some(word) = cursor.peek().filter(|token| token.kind == SyntaxKind::Name) else { return false };
    let is = |words: &[&str]| words.iter().any(|w| cursor.spelling(word).eq_ignore_ascii_case(w));
    let (encloses, member) = (is(&["STRUC", "ENDS"]), is(CELLS));
    let behind = cursor.tokens[cursor.at + 1..].iter().find(|t| t.kind != SyntaxKind::Whitespace);
    let alone = behind.is_none_or(|t| t.kind == SyntaxKind::Comment);
    (encloses && alone)
        || (member
            && !alone
            && behind.is_some_and(|t| !matches!(t.kind, SyntaxKind::Comma | SyntaxKind::Dot)))
}

/// Words of the assembler that declare a member of a structure.
const CELLS: &[&str] = &["DB", "DW", "DD", "DQ"];

fn operands(cursor: &mut Cursor<'_>, operation: Token) -> Vec<Expr> {
    let mut operands = Vec::new();
    if cursor.peek().is_none() {
        return operands;
    }
    let macro_head = cursor.spelling(operation).eq_ignore_ascii_case("DEF_T_MACRO");
    let mut place = None;
    loop {
        let token = cursor.peek();
        if let Some(first) = token.filter(|t| t.kind != SyntaxKind::Comma) {
            operands.push(operand(cursor, first));
        } else {
            let at = place.unwrap_or_else(|| token.map_or(operation.end, |t| t.start));
            operands.push(Expr { kind: ExprKind::Missing, columns: at..at });
        }
        let blank_separates = (macro_head && operands.len() == 1) || separates(operands.last());
        match separator(cursor, blank_separates) {
            Separator::End => return operands,
            Separator::Comma(end) => place = Some(end),
            Separator::Nothing => place = None,
        }
    }
}

enum Separator {
    /// A comma that ends at this column.
    Comma(u32),
    /// The next operand follows without one.
    Nothing,
    /// The line ends.
    End,
}

fn separator(cursor: &mut Cursor<'_>, blank_separates: bool) -> Separator {
    while let Some(token) = cursor.peek() {
        match token.kind {
            SyntaxKind::Comma => {
                cursor.bump();
                return Separator::Comma(token.end);
            }
            SyntaxKind::RightParen | SyntaxKind::RightBracket => {
                cursor.report(token.columns(), SyntaxErrorKind::Unbalanced(cursor.first_char(token)));
            }
            SyntaxKind::Colon => cursor.report(token.columns(), SyntaxErrorKind::UnexpectedCharacter(':')),
            SyntaxKind::Unexpected => {}
            _ => {
                if !blank_separates && !is_dup(cursor, token) {
                    cursor.report(token.columns(), SyntaxErrorKind::ExpectedComma);
                }
                return Separator::Nothing;
            }
        }
        cursor.bump();
    }
    Separator::End
}

/// Words of the assembler that take their operand without a comma: `MEMBER DB ?`, `DW 2 DUP (0)`.
fn separates(operand: Option<&Expr>) -> bool {
    let Some(Expr { kind: ExprKind::Name(name), .. }) = operand else { return false };
    CELLS.iter().chain(&["DUP"]).any(|word| name.text.eq_ignore_ascii_case(word))
}

fn is_dup(cursor: &Cursor<'_>, token: Token) -> bool {
    cursor.spelling(token).eq_ignore_ascii_case("DUP")
}
