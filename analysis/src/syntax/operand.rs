//! Parser of operands: signs, sums, brackets, indexes and dots over the tokens of one line.
//!
//! ```text
//! operand = '-' | sum                          a '-' alone: not given
//! sum     = signed { ('+' | '-') signed }
//! signed  = { '+' | '-' } dotted
//! dotted  = indexed { '.' { '+' | '-' } indexed }
//! indexed = primary { '[' sum ']' }
//! primary = name | number | text | '$' | '(' sum ')'
//! ```
//! Every operator and bracket of an operand is counted; past [`MAX_OPERATORS`] the line is given up. That bounds
//! both the recursion here and the depth of the result.

use super::ast::{Columns, Expr, ExprKind, MAX_OPERATORS, Name, Number, SyntaxErrorKind};
use super::kind::SyntaxKind;
use super::lexer::{Problem, Token};

/// The tokens of a line and how far they are read.
pub(super) struct Cursor<'a> {
    pub(super) line: &'a str,
    pub(super) tokens: &'a [Token],
    pub(super) at: usize,
    pub(super) problem: Problem,
    /// Operators and brackets of the operand so far.
    operators: u32,
    /// Open brackets around the place.
    open: u32,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(line: &'a str, tokens: &'a [Token]) -> Self {
        Cursor { line, tokens, at: 0, problem: None, operators: 0, open: 0 }
    }

    /// The next token that is neither blank nor comment.
    pub(super) fn peek(&mut self) -> Option<Token> {
        while let Some(token) = self.tokens.get(self.at) {
            match token.kind {
                SyntaxKind::Whitespace => self.at += 1,
                SyntaxKind::Comment => return None,
                _ => return Some(*token),
            }
        }
        None
    }

    pub(super) fn peek_kind(&mut self) -> Option<SyntaxKind> {
        self.peek().map(|t| t.kind)
    }

    /// Steps over the token that [`Self::peek`] showed.
    pub(super) fn bump(&mut self) {
        self.at += 1;
    }

    pub(super) fn spelling(&self, token: Token) -> &'a str {
        &self.line[token.start as usize..token.end as usize]
    }

    /// Keeps the first problem of the line; what follows from it is noise.
    pub(super) fn report(&mut self, columns: Columns, kind: SyntaxErrorKind) {
        if self.problem.is_none() {
            self.problem = Some((columns, kind));
        }
    }

    pub(super) fn first_char(&self, token: Token) -> char {
        self.spelling(token).chars().next().unwrap_or(' ')
    }

    pub(super) fn name(&self, token: Token) -> Name {
        Name { text: self.spelling(token).to_owned(), columns: token.columns() }
    }

    /// Counts an operator. `false`: too many, and the rest of the line is skipped.
    fn count(&mut self, operator: Token) -> bool {
        self.operators += 1;
        if self.operators <= MAX_OPERATORS {
            return true;
        }
        self.report(operator.columns(), SyntaxErrorKind::TooComplex);
        self.at = self.tokens.iter().position(|t| t.kind == SyntaxKind::Comment).unwrap_or(self.tokens.len());
        false
    }
}

/// Parses one operand; `first` is the token that stands there. Reads at least that token.
pub(super) fn operand(cursor: &mut Cursor<'_>, first: Token) -> Expr {
    cursor.operators = 0;
    cursor.open = 0;
    if first.kind == SyntaxKind::Minus {
        let before = cursor.at;
        cursor.bump();
        if matches!(cursor.peek_kind(), None | Some(SyntaxKind::Comma)) {
            return Expr { kind: ExprKind::Dash, columns: first.columns() };
        }
        cursor.at = before;
    }
    sum(cursor, first)
}

/// `after` is what an operand must follow: the operator, or the place itself.
fn sum(cursor: &mut Cursor<'_>, after: Token) -> Expr {
    let mut left = signed(cursor, after);
    while let Some(operator) = cursor.peek() {
        let minus = match operator.kind {
            SyntaxKind::Plus => false,
            SyntaxKind::Minus => true,
            _ => break,
        };
        if !cursor.count(operator) {
            break;
        }
        cursor.bump();
        let right = signed(cursor, operator);
        let columns = left.columns.start..right.columns.end;
        left = Expr { kind: ExprKind::Sum { minus, left: Box::new(left), right: Box::new(right) }, columns };
    }
    left
}

fn signed(cursor: &mut Cursor<'_>, after: Token) -> Expr {
    sign(cursor, after, dotted)
}

/// `{ '+' | '-' } inner`
fn sign(cursor: &mut Cursor<'_>, after: Token, inner: fn(&mut Cursor<'_>, Token) -> Expr) -> Expr {
    let Some(sign_token) = cursor.peek() else { return inner(cursor, after) };
    let negative = match sign_token.kind {
        SyntaxKind::Plus => false,
        SyntaxKind::Minus => true,
        _ => return inner(cursor, after),
    };
    if !cursor.count(sign_token) {
        return error(sign_token.columns());
    }
    cursor.bump();
    let operand = sign(cursor, sign_token, inner);
    let columns = sign_token.start..operand.columns.end;
    Expr { kind: ExprKind::Sign { negative, operand: Box::new(operand) }, columns }
}

fn dotted(cursor: &mut Cursor<'_>, after: Token) -> Expr {
    let mut left = indexed(cursor, after);
    while let Some(dot) = cursor.peek().filter(|t| t.kind == SyntaxKind::Dot) {
        if !cursor.count(dot) {
            break;
        }
        cursor.bump();
        let right = sign(cursor, dot, indexed);
        let columns = left.columns.start..right.columns.end;
        left = Expr { kind: ExprKind::Dot { left: Box::new(left), right: Box::new(right) }, columns };
    }
    left
}

fn indexed(cursor: &mut Cursor<'_>, after: Token) -> Expr {
    let mut base = primary(cursor, after);
    while let Some(open) = cursor.peek().filter(|t| t.kind == SyntaxKind::LeftBracket) {
        if !cursor.count(open) {
            break;
        }
        let (index, end) = bracketed(cursor, open);
        let columns = base.columns.start..end;
        base = Expr { kind: ExprKind::Index { base: Box::new(base), index: Box::new(index) }, columns };
    }
    base
}

fn primary(cursor: &mut Cursor<'_>, after: Token) -> Expr {
    let Some(token) = cursor.peek() else { return missing(cursor, after) };
    let kind = match token.kind {
        SyntaxKind::Name => ExprKind::Name(cursor.name(token)),
        SyntaxKind::Number => number(cursor, token),
        SyntaxKind::Text | SyntaxKind::UnclosedText => {
            ExprKind::Text(text(cursor.spelling(token), token.kind))
        }
        SyntaxKind::FileName => ExprKind::Text(cursor.spelling(token).to_owned()),
        SyntaxKind::Dollar => ExprKind::Dollar,
        SyntaxKind::Unexpected => ExprKind::Error,
        SyntaxKind::LeftParen => {
            if !cursor.count(token) {
                return error(token.columns());
            }
            let (inner, end) = bracketed(cursor, token);
            return Expr { kind: ExprKind::Parens(Box::new(inner)), columns: token.start..end };
        }
        SyntaxKind::RightParen | SyntaxKind::RightBracket if cursor.open == 0 => {
            cursor.report(token.columns(), SyntaxErrorKind::Unbalanced(cursor.first_char(token)));
            ExprKind::Error
        }
        SyntaxKind::Colon => {
            cursor.report(token.columns(), SyntaxErrorKind::UnexpectedCharacter(':'));
            ExprKind::Error
        }
        _ => return missing(cursor, after),
    };
    cursor.bump();
    Expr { kind, columns: token.columns() }
}

/// `( sum )` or `[ sum ]`: what stands inside, and where the closing bracket ends.
fn bracketed(cursor: &mut Cursor<'_>, open: Token) -> (Expr, u32) {
    cursor.bump();
    cursor.open += 1;
    let inner = sum(cursor, open);
    cursor.open -= 1;
    let closing =
        if open.kind == SyntaxKind::LeftParen { SyntaxKind::RightParen } else { SyntaxKind::RightBracket };
    let mut end = inner.columns.end.max(open.end);
    while let Some(token) = cursor.peek() {
        match token.kind {
            SyntaxKind::Comma => break,
            SyntaxKind::RightParen | SyntaxKind::RightBracket => {
                if token.kind != closing {
                    cursor.report(open.columns(), SyntaxErrorKind::Unbalanced(cursor.first_char(open)));
                }
                cursor.bump();
                return (inner, token.end);
            }
            SyntaxKind::Unexpected => {}
            _ => {
                let c = cursor.first_char(token);
                cursor.report(token.columns(), SyntaxErrorKind::UnexpectedCharacter(c));
            }
        }
        cursor.bump();
        end = token.end;
    }
    cursor.report(open.columns(), SyntaxErrorKind::Unbalanced(cursor.first_char(open)));
    (inner, end)
}

/// Nothing where an operand should be: an empty [`ExprKind::Error`] behind `after`.
fn missing(cursor: &mut Cursor<'_>, after: Token) -> Expr {
    cursor.report(after.columns(), SyntaxErrorKind::ExpectedOperand);
    // A place that opens the operand itself (`.5`, `[1]`) leaves the gap before it.
    let before = cursor.tokens.get(cursor.at).is_some_and(|t| t.start == after.start);
    let at = if before { after.start } else { after.end };
    error(at..at)
}

fn error(columns: Columns) -> Expr {
    Expr { kind: ExprKind::Error, columns }
}

/// The content of a text literal.
fn text(spelling: &str, kind: SyntaxKind) -> String {
    let mut chars = spelling.chars();
    let apostrophes = chars.next() == Some('\'');
    if kind == SyntaxKind::Text {
        chars.next_back();
    }
    if apostrophes { chars.as_str().replace("''", "'") } else { chars.as_str().to_owned() }
}

fn number(cursor: &mut Cursor<'_>, token: Token) -> ExprKind {
    let value = number_value(cursor.spelling(token));
    if value.is_none() {
        cursor.report(token.columns(), SyntaxErrorKind::BadNumber);
    }
    value.map_or(ExprKind::Error, ExprKind::Number)
}

/// Value of a number: `123`, `123d`, `0F8h`, `0001b`, `1.8`.
fn number_value(spelling: &str) -> Option<Number> {
    if spelling.contains('.') {
        let plain = spelling.bytes().all(|b| b.is_ascii_digit() || b == b'.');
        return if plain { spelling.parse().ok().map(Number::Real) } else { None };
    }
    let (radix, digits) = match spelling.as_bytes().last()? {
        b'h' | b'H' => (16, &spelling[..spelling.len() - 1]),
        b'b' | b'B' => (2, &spelling[..spelling.len() - 1]),
        b'd' | b'D' => (10, &spelling[..spelling.len() - 1]),
        _ => (10, spelling),
    };
    i64::from_str_radix(digits, radix).ok().map(Number::Integer)
}
