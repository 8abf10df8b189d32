//! Tokens of one line.

use super::ast::{Columns, SyntaxErrorKind};
use super::kind::SyntaxKind;

/// A token: kind and columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub(super) kind: SyntaxKind,
    pub(super) start: u32,
    pub(super) end: u32,
}

impl Token {
    pub(super) fn columns(self) -> Columns {
        self.start..self.end
    }
}

/// First problem of a line.
pub(super) type Problem = Option<(Columns, SyntaxErrorKind)>;

/// Cuts a line (without its end) into tokens that cover it completely.
pub(super) fn lex(line: &str, tokens: &mut Vec<Token>) -> Problem {
    tokens.clear();
    let mut lexer = Lexer { line, tokens, problem: None };
    lexer.run();
    lexer.problem
}

/// A blank inside a line. A byte order mark and the end-of-file character of DOS count as blanks.
pub(super) fn is_blank(c: char) -> bool {
    c == ' ' || c == '\t' || c.is_whitespace() || c == '\u{feff}' || c == '\u{1a}'
}

/// Length of the blanks at the start of `text`.
pub(super) fn blank_len(text: &str) -> usize {
    let plain = text.bytes().take_while(|b| matches!(b, b' ' | b'\t')).count();
    let rest = &text[plain..];
    match rest.as_bytes().first() {
        None | Some(b'!'..=b'~') => plain,
        _ => plain + rest.find(|c| !is_blank(c)).unwrap_or(rest.len()),
    }
}

/// Length of the name or number at the start of `text`, 0 when there is none. Letters outside ASCII belong to
/// it, so that one wrong letter is one error and the word stays a word.
pub(super) fn word_len(text: &str) -> usize {
    let ascii = text.bytes().take_while(|b| is_ascii_word(*b)).count();
    match text.as_bytes().get(ascii) {
        Some(b) if !b.is_ascii() => text.find(|c: char| !(is_word(c))).unwrap_or(text.len()),
        _ => ascii,
    }
}

fn is_word(c: char) -> bool {
    u8::try_from(c)
        .map_or_else(|_| c.is_alphanumeric(), |b| is_ascii_word(b) || (!b.is_ascii() && c.is_alphanumeric()))
}

fn is_ascii_word(b: u8) -> bool {
    b.is_ascii_alphanumeric() || matches!(b, b'_' | b'?' | b'@')
}

struct Lexer<'a> {
    line: &'a str,
    tokens: &'a mut Vec<Token>,
    problem: Problem,
}

impl Lexer<'_> {
    fn run(&mut self) {
        let mut at = 0;
        let mut words = 0;
        while at < self.line.len() {
            let rest = &self.line[at..];
            let (kind, len) = self.token(at, rest);
            self.tokens.push(Token { kind, start: at as u32, end: (at + len) as u32 });
            at += len;
            match kind {
                SyntaxKind::Name => {
                    words += 1;
                    if words == 1 && rest[..len].eq_ignore_ascii_case(T_INCLUDE) {
                        at = self.file_name(at);
                    }
                }
                SyntaxKind::Colon if words == 1 => words = 0,
                SyntaxKind::Whitespace | SyntaxKind::Unexpected => {}
                _ => words += 1,
            }
        }
    }

    fn token(&mut self, at: usize, rest: &str) -> (SyntaxKind, usize) {
        let first = rest.as_bytes()[0];
        let single = match first {
            b',' => SyntaxKind::Comma,
            b':' => SyntaxKind::Colon,
            b'.' => SyntaxKind::Dot,
            b'+' => SyntaxKind::Plus,
            b'-' => SyntaxKind::Minus,
            b'$' => SyntaxKind::Dollar,
            b'(' => SyntaxKind::LeftParen,
            b')' => SyntaxKind::RightParen,
            b'[' => SyntaxKind::LeftBracket,
            b']' => SyntaxKind::RightBracket,
            b' ' | b'\t' => return (SyntaxKind::Whitespace, blank_len(rest)),
            b';' => return (SyntaxKind::Comment, rest.len()),
            b'0'..=b'9' => return (SyntaxKind::Number, number_len(rest)),
            _ if is_ascii_word(first) => return (SyntaxKind::Name, self.name(at, rest)),
            _ => return self.unusual(at, rest),
        };
        (single, 1)
    }

    fn name(&mut self, at: usize, rest: &str) -> usize {
        let len = word_len(rest);
        let foreign = rest[..len].char_indices().find(|(_, c)| !c.is_ascii());
        if let Some((offset, c)) = foreign {
            self.report(at + offset, c.len_utf8(), SyntaxErrorKind::UnexpectedCharacter(c));
        }
        len
    }

    fn unusual(&mut self, at: usize, rest: &str) -> (SyntaxKind, usize) {
        let blank = blank_len(rest);
        if blank > 0 {
            return (SyntaxKind::Whitespace, blank);
        }
        let Some(c) = rest.chars().next() else { return (SyntaxKind::Whitespace, 0) };
        if let Some(family) = Quotes::of(c) {
            return self.text(at, rest, c, family);
        }
        if is_word(c) {
            return (SyntaxKind::Name, self.name(at, rest));
        }
        self.report(at, c.len_utf8(), SyntaxErrorKind::UnexpectedCharacter(c));
        (SyntaxKind::Unexpected, c.len_utf8())
    }

    fn text(&mut self, at: usize, rest: &str, open: char, family: Quotes) -> (SyntaxKind, usize) {
        let inner = &rest[open.len_utf8()..];
        let found = if open == '\'' {
            apostrophe(inner).or_else(|| inner.find(|c| c != '\'' && family.holds(c)))
        } else {
            inner.find(|c| family.holds(c))
        };
        let Some(len) = found else {
            let len = rest.trim_end_matches(is_blank).len();
            self.report(at, len, SyntaxErrorKind::UnclosedText);
            return (SyntaxKind::UnclosedText, len);
        };
        let close = inner[len..].chars().next().unwrap_or('\'');
        let len = open.len_utf8() + len + close.len_utf8();
        if let Some(wrong) = [open, close].into_iter().find(|c| *c != '\'') {
            self.report(at, len, SyntaxErrorKind::TypographicQuote(wrong));
        }
        (SyntaxKind::Text, len)
    }

    /// T_INCLUDE takes a file name without apostrophes up to the next blank.
    fn file_name(&mut self, at: usize) -> usize {
        let rest = &self.line[at..];
        let blank = blank_len(rest);
        let name = &rest[blank..];
        let len = name.find(|c| is_blank(c) || c == ';').unwrap_or(name.len());
        let quoted = name.chars().next().is_some_and(|c| c == ':' || Quotes::of(c).is_some());
        if len == 0 || blank == 0 || quoted {
            return at;
        }
        let start = (at + blank) as u32;
        self.tokens.push(Token { kind: SyntaxKind::Whitespace, start: at as u32, end: start });
        self.tokens.push(Token { kind: SyntaxKind::FileName, start, end: start + len as u32 });
        at + blank + len
    }

    fn report(&mut self, at: usize, len: usize, kind: SyntaxErrorKind) {
        if self.problem.is_none() {
            self.problem = Some((at as u32..(at + len) as u32, kind));
        }
    }
}

/// The operation whose operand is a bare file name.
pub(super) const T_INCLUDE: &str = "T_INCLUDE";

/// Quotes that close each other.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Quotes {
    Single,
    Double,
}

impl Quotes {
    fn of(c: char) -> Option<Self> {
        match c {
            '\'' | '`' | '´' | '‘' | '’' | '‚' | '‛' | '′' | '‹' | '›' => Some(Self::Single),
            '"' | '“' | '”' | '„' | '‟' | '″' | '«' | '»' => Some(Self::Double),
            _ => None,
        }
    }

    fn holds(self, c: char) -> bool {
        Quotes::of(c) == Some(self)
    }
}

/// Position of the closing apostrophe; a doubled one stands for itself.
fn apostrophe(inner: &str) -> Option<usize> {
    let bytes = inner.as_bytes();
    let mut at = 0;
    while let Some(found) = bytes[at..].iter().position(|b| *b == b'\'') {
        at += found;
        if bytes.get(at + 1) != Some(&b'\'') {
            return Some(at);
        }
        at += 2;
    }
    None
}

/// A word that starts with a digit; with a dot only when digits stand on both sides of it.
fn number_len(text: &str) -> usize {
    let len = word_len(text);
    let digits = text[..len].bytes().all(|b| b.is_ascii_digit());
    let fraction = &text[len..];
    let real = digits && fraction.starts_with('.') && fraction[1..].starts_with(|c: char| c.is_ascii_digit());
    if real { len + 1 + word_len(&fraction[1..]) } else { len }
}
