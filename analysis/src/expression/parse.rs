//! The grammar of expressions. Nothing is looked up here.

use technol_image::op::Width;

use super::ExpressionError;

/// An expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Expression {
    /// A number, character or `CNST.n`.
    Constant(i64),
    /// A lone name.
    Name(String),
    /// A cell with prefix or offset.
    Cell { prefix: Option<Prefix>, address: Address },
    /// `adr.bit`.
    Bit { address: Address, bit: Bit },
    /// `$+n.bit`.
    SameByte { offset: i64, bit: String },
}

/// A name with what is added to it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Address {
    pub(super) name: String,
    /// Sum of the numbers.
    pub(super) offset: i64,
    /// Names of constants; `true` when subtracted.
    pub(super) constants: Vec<(bool, String)>,
}

/// The right side of `adr.bit`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Bit {
    Number(u8),
    Name(String),
}

/// A type prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Prefix {
    pub(super) width: Width,
    /// HIGH. reads the byte after the address.
    pub(super) offset: i64,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Token {
    Name(String),
    Number(i64),
    /// `. + - ( ) $`
    Sign(char),
}

/// A reader of expressions.
pub(super) struct Parser {
    /// Tokens with their columns.
    tokens: Vec<(usize, Token)>,
    next: usize,
}

impl Parser {
    /// Reads the whole text.
    pub(super) fn parse(text: &str) -> Result<Expression, ExpressionError> {
        let mut parser = Parser { tokens: tokens(text)?, next: 0 };
        if parser.tokens.is_empty() {
            return Err(ExpressionError::Empty);
        }
        let expression = parser.expression()?;
        if parser.next < parser.tokens.len() {
            return Err(parser.unexpected());
        }
        Ok(expression)
    }

    fn expression(&mut self) -> Result<Expression, ExpressionError> {
        if self.take('$') {
            return self.same_byte();
        }
        if let Some(value) = self.constant() {
            return Ok(Expression::Constant(value));
        }
        let parenthesised = self.peek_is('(');
        let mut address = self.address()?;
        if !self.take('.') {
            let before = address.clone();
            self.offsets(&mut address)?;
            let lone =
                !parenthesised && before == address && address.offset == 0 && address.constants.is_empty();
            return Ok(if lone {
                Expression::Name(address.name)
            } else {
                Expression::Cell { prefix: None, address }
            });
        }
        let prefix = if parenthesised { None } else { prefix(&address.name) };
        if prefix.is_some() {
            let mut typed = self.address()?;
            self.offsets(&mut typed)?;
            return Ok(Expression::Cell { prefix, address: typed });
        }
        if address.name.eq_ignore_ascii_case("CNST") {
            let negative = self.take('-');
            return match self.token() {
                Some(Token::Number(value)) => {
                    Ok(Expression::Constant(if negative { value.wrapping_neg() } else { value }))
                }
                Some(Token::Name(name)) if !negative => Ok(Expression::Name(name)),
                _ => Err(self.unexpected_before()),
            };
        }
        let bit = match self.token() {
            Some(Token::Name(name)) => Bit::Name(name),
            Some(Token::Number(number @ 0..=7)) => Bit::Number(number as u8),
            Some(Token::Number(number)) => return Err(ExpressionError::NotABit(number.to_string())),
            _ => return Err(self.unexpected_before()),
        };
        Ok(Expression::Bit { address, bit })
    }

    fn same_byte(&mut self) -> Result<Expression, ExpressionError> {
        let mut offset = 0;
        if self.peek_is('+') || self.peek_is('-') {
            let minus = self.take('-') || !self.take('+');
            let Some(Token::Number(value)) = self.token() else { return Err(self.unexpected_before()) };
            offset = if minus { value.wrapping_neg() } else { value };
        }
        if !self.take('.') {
            return Err(self.unexpected());
        }
        match self.token() {
            Some(Token::Name(bit)) => Ok(Expression::SameByte { offset, bit }),
            _ => Err(self.unexpected_before()),
        }
    }

    /// A number, with sign, and nothing after it.
    fn constant(&mut self) -> Option<i64> {
        let value = match self.tokens.as_slice() {
            [(_, Token::Number(value))] => *value,
            [(_, Token::Sign('-')), (_, Token::Number(value))] => value.wrapping_neg(),
            _ => return None,
        };
        self.next = self.tokens.len();
        Some(value)
    }

    /// `name` or `(name+n)`.
    fn address(&mut self) -> Result<Address, ExpressionError> {
        let parenthesised = self.take('(');
        let Some(Token::Name(name)) = self.token() else { return Err(self.unexpected_before()) };
        let mut address = Address { name, offset: 0, constants: Vec::new() };
        if parenthesised {
            self.offsets(&mut address)?;
            if !self.take(')') {
                return Err(self.unexpected());
            }
        }
        Ok(address)
    }

    /// `+n`, `-n`, `+NAME` …
    fn offsets(&mut self, address: &mut Address) -> Result<(), ExpressionError> {
        while self.peek_is('+') || self.peek_is('-') {
            let minus = self.take('-') || !self.take('+');
            match self.token() {
                Some(Token::Number(value)) => {
                    let value = if minus { value.wrapping_neg() } else { value };
                    address.offset = address.offset.checked_add(value).ok_or(ExpressionError::Address)?;
                }
                Some(Token::Name(name)) => address.constants.push((minus, name)),
                _ => return Err(self.unexpected_before()),
            }
        }
        Ok(())
    }

    fn token(&mut self) -> Option<Token> {
        let token = self.tokens.get(self.next).map(|(_, token)| token.clone());
        self.next += 1;
        token
    }

    fn peek_is(&self, sign: char) -> bool {
        matches!(self.tokens.get(self.next), Some((_, Token::Sign(found))) if *found == sign)
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.peek_is(sign);
        self.next += usize::from(found);
        found
    }

    fn unexpected(&self) -> ExpressionError {
        match self.tokens.get(self.next) {
            Some((column, token)) => {
                let text = match token {
                    Token::Name(name) => name.clone(),
                    Token::Number(value) => value.to_string(),
                    Token::Sign(sign) => sign.to_string(),
                };
                ExpressionError::Unexpected(*column, text)
            }
            None => ExpressionError::Unexpected(0, String::new()),
        }
    }

    /// The token taken last is not the one that was needed.
    fn unexpected_before(&mut self) -> ExpressionError {
        self.next = self.next.saturating_sub(1);
        self.unexpected()
    }
}

/// The type prefix of that name.
pub(super) fn prefix(name: &str) -> Option<Prefix> {
    let (width, offset) = match name.to_ascii_uppercase().as_str() {
        "BYTE" => (Width::Byte, 0),
        "HIGH" => (Width::Byte, 1),
        "WORD" => (Width::Word, 0),
        "DWRD" => (Width::DWord, 0),
        "QWRD" => (Width::QWord, 0),
        "REAL" => (Width::Real, 0),
        _ => return None,
    };
    Some(Prefix { width, offset })
}

fn is_name_start(c: char) -> bool {
    c.is_alphabetic() || matches!(c, '_' | '?' | '@')
}

fn tokens(text: &str) -> Result<Vec<(usize, Token)>, ExpressionError> {
    let mut tokens = Vec::new();
    let mut chars = text.char_indices().peekable();
    while let Some((column, c)) = chars.next() {
        let mut word = c.to_string();
        let mut take_word = |word: &mut String| {
            while let Some((_, c)) = chars.next_if(|(_, c)| is_name_start(*c) || c.is_ascii_digit()) {
                word.push(c);
            }
        };
        let token = match c {
            c if c.is_whitespace() => continue,
            '.' | '+' | '-' | '(' | ')' | '$' => Token::Sign(c),
            '\'' => match (chars.next(), chars.next()) {
                (Some((_, c)), Some((_, '\''))) if (c as u32) < 256 => Token::Number(i64::from(c as u32)),
                _ => return Err(ExpressionError::Unexpected(column, text[column..].to_owned())),
            },
            c if c.is_ascii_digit() => {
                take_word(&mut word);
                Token::Number(number(&word).ok_or(ExpressionError::Number(word))?)
            }
            c if is_name_start(c) => {
                take_word(&mut word);
                Token::Name(word)
            }
            other => return Err(ExpressionError::Unexpected(column, other.to_string())),
        };
        tokens.push((column, token));
    }
    Ok(tokens)
}

/// A number without sign: `248`, `248d`, `0F8h`, `0xF8`, `0101b`; at most 64 bits.
pub(super) fn number(text: &str) -> Option<i64> {
    let text = text.to_ascii_lowercase();
    let (digits, radix) = if let Some(hex) = text.strip_prefix("0x") {
        (hex, 16)
    } else if let Some(hex) = text.strip_suffix('h') {
        (hex, 16)
    } else if let Some(binary) = text.strip_suffix('b') {
        (binary, 2)
    } else {
        (text.strip_suffix('d').unwrap_or(&text), 10)
    };
    // `from_str_radix` would take a sign.
    if !digits.starts_with(|c: char| c.is_ascii_hexdigit()) {
        return None;
    }
    i64::from_str_radix(digits, radix)
        .ok()
        .or_else(|| u64::from_str_radix(digits, radix).ok().map(|n| n as i64))
}
