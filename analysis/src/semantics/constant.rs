//! Constant expressions: numbers, characters, names of constants, signs, sums, parentheses (manual 3.4).

use crate::catalogue;
use crate::catalogue::Prefix;
use crate::syntax::ast::{Columns, Expr, ExprKind, Number};

/// A constant expression without positions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ConstExpr {
    /// A number or character.
    Integer(i64),
    /// A name, by its key.
    Name(String),
    /// `-a`.
    Negated(Box<ConstExpr>),
    /// `a + b`, or `a - b` when `minus`.
    Sum {
        /// `-`, else `+`.
        minus: bool,
        /// Left.
        left: Box<ConstExpr>,
        /// Right.
        right: Box<ConstExpr>,
    },
}

/// Why an expression is no integer constant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotConstant {
    /// The parser reported it already.
    Reported,
    /// A number with a decimal point.
    Real(Columns),
    /// A text of more or less than one character, or a character above FFh.
    Text(Columns),
    /// Something that cannot stand in a constant.
    Form(Columns),
}

/// Why the value of an expression is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoValue {
    /// This name is no known constant.
    Name(String),
    /// The value does not fit 64 bits.
    Overflow,
}

impl ConstExpr {
    /// Reads an expression; `CNST.` before it is allowed and changes nothing.
    pub fn read(expr: &Expr) -> Result<ConstExpr, NotConstant> {
        let at = || expr.columns.clone();
        match &expr.kind {
            ExprKind::Number(Number::Integer(value)) => Ok(ConstExpr::Integer(*value)),
            ExprKind::Number(Number::Real(_)) => Err(NotConstant::Real(at())),
            ExprKind::Text(text) => {
                character(text).map(ConstExpr::Integer).ok_or_else(|| NotConstant::Text(at()))
            }
            ExprKind::Name(name) => Ok(ConstExpr::Name(name.key())),
            ExprKind::Sign { negative: true, operand } => {
                Ok(ConstExpr::Negated(Box::new(Self::read(operand)?)))
            }
            ExprKind::Sign { negative: false, operand } | ExprKind::Parens(operand) => Self::read(operand),
            ExprKind::Sum { minus, left, right } => Ok(ConstExpr::Sum {
                minus: *minus,
                left: Box::new(Self::read(left)?),
                right: Box::new(Self::read(right)?),
            }),
            ExprKind::Dot { left, right } => match &left.kind {
                ExprKind::Name(name)
                    if catalogue::prefix(&name.text).is_some_and(|p| p.prefix == Prefix::Cnst) =>
                {
                    Self::read(right)
                }
                _ => Err(NotConstant::Form(at())),
            },
            ExprKind::Error => Err(NotConstant::Reported),
            ExprKind::Missing | ExprKind::Dash | ExprKind::Dollar | ExprKind::Index { .. } => {
                Err(NotConstant::Form(at()))
            }
        }
    }

    /// The value, with the constants that `lookup` knows.
    pub fn value(&self, lookup: &mut dyn FnMut(&str) -> Option<i64>) -> Result<i64, NoValue> {
        match self {
            ConstExpr::Integer(value) => Ok(*value),
            ConstExpr::Name(name) => lookup(name).ok_or_else(|| NoValue::Name(name.clone())),
            ConstExpr::Negated(inner) => inner.value(lookup)?.checked_neg().ok_or(NoValue::Overflow),
            ConstExpr::Sum { minus, left, right } => {
                let (left, right) = (left.value(lookup)?, right.value(lookup)?);
                let sum = if *minus { left.checked_sub(right) } else { left.checked_add(right) };
                sum.ok_or(NoValue::Overflow)
            }
        }
    }

    /// Keys of the names in it.
    pub fn names<'a>(&'a self, found: &mut Vec<&'a str>) {
        match self {
            ConstExpr::Integer(_) => {}
            ConstExpr::Name(name) => found.push(name),
            ConstExpr::Negated(inner) => inner.names(found),
            ConstExpr::Sum { left, right, .. } => {
                left.names(found);
                right.names(found);
            }
        }
    }

    /// The value when no name is needed.
    #[must_use]
    pub fn literal(&self) -> Option<i64> {
        self.value(&mut |_| None).ok()
    }
}

impl NotConstant {
    /// Where and what to say; `None` when it is reported already.
    #[must_use]
    pub fn message(self) -> Option<(Columns, String)> {
        match self {
            NotConstant::Reported => None,
            NotConstant::Real(columns) => {
                Some((columns, "an integer is needed here, not a number with a decimal point".to_string()))
            }
            NotConstant::Text(columns) => {
                Some((columns, "a character constant is one character in apostrophes".to_string()))
            }
            NotConstant::Form(columns) => Some((
                columns,
                "a constant is needed here: a number, 'A', an EQUI name, or their sum".to_string(),
            )),
        }
    }
}

/// The value of a character constant.
#[must_use]
pub fn character(text: &str) -> Option<i64> {
    let mut chars = text.chars();
    let first = u32::from(chars.next()?);
    (chars.next().is_none() && first <= 0xFF).then_some(i64::from(first))
}
