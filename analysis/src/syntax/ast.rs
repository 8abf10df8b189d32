//! The typed syntax of a source line: plain data, positions relative to the line.
//!
//! A TECHNOL line is `[label:] [operation [operand {, operand}]] [;comment]` (manual 3.1). Nothing here is
//! resolved: `-BUN5.ALFA` is a sign before a dotted name, whatever it turns out to mean.

use std::ops::Range;

/// A column range in bytes, relative to the start of its line.
pub type Columns = Range<u32>;

/// A name as written.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Name {
    /// Spelling in the source.
    pub text: String,
    /// Where.
    pub columns: Columns,
}

impl Name {
    /// What identifies the name: upper case, the first 31 characters (manual 3.3).
    #[must_use]
    pub fn key(&self) -> String {
        key(&self.text)
    }

    /// Spelled like a hexadecimal number that lacks its leading digit: `F8h`. Such a word is a good name, so only
    /// one that is declared nowhere deserves the hint.
    #[must_use]
    pub fn looks_hexadecimal(&self) -> bool {
        let Some(digits) = self.text.strip_suffix(['h', 'H']) else { return false };
        !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_hexdigit())
    }
}

/// What identifies a name: upper case, the first 31 characters (manual 3.3).
#[must_use]
pub fn key(text: &str) -> String {
    // A T_LOCAL symbol of an expansion: what makes it unique stands behind the name and always counts.
    let (name, mark) = match text.find("@@").filter(|at| text.len() > SIGNIFICANT && *at > 0) {
        Some(at) => text.split_at(at),
        None => (text, ""),
    };
    name.chars().take(SIGNIFICANT).chain(mark.chars()).map(|c| c.to_ascii_uppercase()).collect()
}

/// Number of significant characters of a name.
pub const SIGNIFICANT: usize = 31;

/// Most operators and brackets in one operand; the bound keeps everything that walks an [`Expr`] shallow.
pub const MAX_OPERATORS: u32 = 64;

/// One source line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// `NAME:` before the operation.
    pub label: Option<Name>,
    /// Mnemonic or keyword.
    pub operation: Option<Name>,
    /// Operands; `A,,B` has three, the middle one [`ExprKind::Missing`].
    pub operands: Vec<Expr>,
    /// Comment with its semicolon.
    pub comment: Option<Columns>,
    /// Length of the line without its end, in bytes.
    pub len: u32,
}

/// An operand or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What.
    pub kind: ExprKind,
    /// Where.
    pub columns: Columns,
}

impl Expr {
    /// Every name in it, in order of the text.
    #[must_use]
    pub fn names(&self) -> Vec<&Name> {
        let mut found = Vec::new();
        self.collect_names(&mut found);
        found
    }

    fn collect_names<'a>(&'a self, found: &mut Vec<&'a Name>) {
        match &self.kind {
            ExprKind::Name(name) => found.push(name),
            ExprKind::Sign { operand: inner, .. } | ExprKind::Parens(inner) => inner.collect_names(found),
            ExprKind::Sum { left, right, .. } | ExprKind::Dot { left, right } => {
                left.collect_names(found);
                right.collect_names(found);
            }
            ExprKind::Index { base, index } => {
                base.collect_names(found);
                index.collect_names(found);
            }
            _ => {}
        }
    }
}

/// Forms of an operand.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// Nothing between two commas, or after the last one.
    Missing,
    /// A `-` that stands alone: "not given".
    Dash,
    /// `$`: the byte where the bit itself is declared.
    Dollar,
    /// A name, keyword or prefix.
    Name(Name),
    /// A number.
    Number(Number),
    /// `'…'` with doubled apostrophes undone.
    Text(String),
    /// A sign before an operand or number.
    Sign {
        /// `-`, else `+`.
        negative: bool,
        /// What it stands before.
        operand: Box<Expr>,
    },
    /// `a + b` or `a - b`.
    Sum {
        /// `-`, else `+`.
        minus: bool,
        /// Left.
        left: Box<Expr>,
        /// Right.
        right: Box<Expr>,
    },
    /// `( … )`.
    Parens(Box<Expr>),
    /// `base[index]`.
    Index {
        /// Before the bracket.
        base: Box<Expr>,
        /// Inside it.
        index: Box<Expr>,
    },
    /// `left.right`: a prefix and its operand, an address and its bit, or a structure member. Binds tighter
    /// than signs and sums: `-A.B+1` is `(-(A.B))+1`, `$+3.ALFA` is `$ + (3.ALFA)`, `CNST.-5` has a sign on the right.
    Dot {
        /// Before the dot.
        left: Box<Expr>,
        /// After it.
        right: Box<Expr>,
    },
    /// What could not be read; an error says why.
    Error,
}

/// A number as written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number {
    /// Decimal (`123`, `123d`), hexadecimal (`0F8h`), binary (`0001b`) or character (`'A'` after `CNST.` stays
    /// [`ExprKind::Text`]).
    Integer(i64),
    /// With a decimal point.
    Real(f64),
}

/// A mistake found by the lexer or parser.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// 0-based line in the parsed text.
    pub line: u32,
    /// Columns in it.
    pub columns: Columns,
    /// What is wrong.
    pub kind: SyntaxErrorKind,
}

/// Kinds of syntax errors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SyntaxErrorKind {
    /// A character that has no meaning here.
    UnexpectedCharacter(char),
    /// Another quote than the apostrophe; the columns are those of the whole text, quotes included.
    TypographicQuote(char),
    /// A text without its closing apostrophe.
    UnclosedText,
    /// A number that is malformed or does not fit into 64 bits with a sign.
    BadNumber,
    /// `(` or `[` without its partner, or the other way round.
    Unbalanced(char),
    /// An operand was expected after the operator or bracket the columns show.
    ExpectedOperand,
    /// Operands must be separated by commas.
    ExpectedComma,
    /// A label, a mnemonic or a comment was expected at the start of the line.
    ExpectedOperation,
    /// A declared name without its colon (`ALFA DS 1`); it is read as if the colon stood there.
    ExpectedColon,
    /// An operand with more than [`MAX_OPERATORS`] operators and brackets.
    TooComplex,
}
