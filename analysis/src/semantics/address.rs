//! The shape of an operand, before names are looked up: sign, prefix, terms of the address, bit.

use crate::catalogue::{self, Prefix};
use crate::syntax::ast::{Columns, Expr, ExprKind, Name, Number};

/// An operand taken apart: `[-][BLK[n].][PREFIX.]term{+term}{.member}[.bit]`.
#[derive(Debug, Default)]
pub(super) struct Shape<'a> {
    /// Sign before everything: negative, where.
    pub(super) sign: Option<(bool, Columns)>,
    /// Type prefix.
    pub(super) prefix: Option<PrefixUse>,
    /// What is added up.
    pub(super) terms: Vec<Term<'a>>,
    /// Names behind dots: members of structures, and a bit as the last one.
    pub(super) behind: Vec<Behind<'a>>,
    /// `BLK[n].` before everything: which of the prepared blocks.
    pub(super) block: Option<BlockIndex<'a>>,
}

/// A name behind a dot.
#[derive(Debug)]
pub(super) struct Behind<'a> {
    pub(super) name: &'a Name,
    /// `name[n]`.
    pub(super) index: Option<&'a Expr>,
    pub(super) columns: Columns,
}

/// `BLK[n].` in the text.
#[derive(Debug)]
pub(super) struct BlockIndex<'a> {
    /// In the brackets; `None` when they are missing.
    pub(super) index: Option<&'a Expr>,
    pub(super) columns: Columns,
}

/// The word before the brackets of a prepared block.
const BLOCK: &str = "BLK";

/// A prefix in the text.
#[derive(Clone, Debug)]
pub(super) struct PrefixUse {
    pub(super) prefix: Prefix,
    /// Written `CNTS`.
    pub(super) misspelled: bool,
    pub(super) columns: Columns,
}

/// A term of a sum.
#[derive(Debug)]
pub(super) struct Term<'a> {
    /// It is subtracted.
    pub(super) minus: bool,
    pub(super) kind: TermKind<'a>,
    pub(super) columns: Columns,
}

#[derive(Debug)]
pub(super) enum TermKind<'a> {
    Name(&'a Name),
    /// `name[index]`.
    Indexed(&'a Name, &'a Expr),
    Integer(i64),
    Real(f64),
    Text(&'a str),
    Dollar,
}

/// Why an operand has no such shape.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Misshape {
    /// The parser reported it.
    Reported,
    /// This, here.
    Form(Columns, &'static str),
}

impl<'a> Shape<'a> {
    /// Takes an operand apart.
    pub(super) fn of(expr: &'a Expr) -> Result<Shape<'a>, Misshape> {
        let mut shape = Shape::default();
        shape.take(expr, false, false)?;
        Ok(shape)
    }

    fn take(&mut self, expr: &'a Expr, minus: bool, inside: bool) -> Result<(), Misshape> {
        let at = || expr.columns.clone();
        match &expr.kind {
            ExprKind::Error => Err(Misshape::Reported),
            ExprKind::Missing | ExprKind::Dash => Err(Misshape::Form(at(), "an operand is needed here")),
            ExprKind::Sign { negative, operand } => {
                let outermost = self.terms.is_empty() && self.prefix.is_none() && !inside;
                if !outermost {
                    return self.take(operand, minus != *negative, inside);
                }
                if self.sign.is_some() {
                    return Err(Misshape::Form(at(), "two signs follow each other"));
                }
                self.sign = Some((*negative, expr.columns.start..operand.columns.start));
                self.take(operand, minus, inside)
            }
            ExprKind::Sum { minus: subtract, left, right } => {
                self.take(left, minus, inside)?;
                self.take(right, minus != *subtract, inside)
            }
            ExprKind::Parens(inner) => self.take(inner, minus, true),
            ExprKind::Dot { left, right } => self.dot(expr, left, right, minus, inside),
            ExprKind::Index { base, index } => match &base.kind {
                ExprKind::Name(name) => {
                    self.term(expr, minus, TermKind::Indexed(name, index));
                    Ok(())
                }
                _ => Err(Misshape::Form(at(), "only a name can be indexed")),
            },
            ExprKind::Name(name) => {
                self.term(expr, minus, TermKind::Name(name));
                Ok(())
            }
            ExprKind::Number(Number::Integer(value)) => {
                self.term(expr, minus, TermKind::Integer(*value));
                Ok(())
            }
            ExprKind::Number(Number::Real(value)) => {
                self.term(expr, minus, TermKind::Real(*value));
                Ok(())
            }
            ExprKind::Text(text) => {
                self.term(expr, minus, TermKind::Text(text));
                Ok(())
            }
            ExprKind::Dollar => {
                self.term(expr, minus, TermKind::Dollar);
                Ok(())
            }
        }
    }

    fn dot(
        &mut self,
        expr: &'a Expr,
        left: &'a Expr,
        right: &'a Expr,
        minus: bool,
        inside: bool,
    ) -> Result<(), Misshape> {
        if self.take_prefix(left)? {
            return self.take(right, minus, inside);
        }
        if let Some(block) = block_index(left).filter(|_| self.terms.is_empty() && self.block.is_none()) {
            self.block = Some(block);
            return self.take_in_block(expr, right, minus, inside);
        }
        self.take(left, minus, inside)?;
        if self.block.is_some() && self.terms.is_empty() {
            return self.take_in_block(expr, right, minus, inside);
        }
        let (name, index) = match &right.kind {
            ExprKind::Name(name) => (name, None),
            ExprKind::Index { base, index } => match &base.kind {
                ExprKind::Name(name) => (name, Some(&**index)),
                _ => return Err(Misshape::Form(right.columns.clone(), "only a name can be indexed")),
            },
            ExprKind::Error => return Err(Misshape::Reported),
            _ => {
                let message = "a bit or a member of a structure is needed behind the dot";
                return Err(Misshape::Form(right.columns.clone(), message));
            }
        };
        self.behind.push(Behind { name, index, columns: right.columns.clone() });
        Ok(())
    }

    /// Whether it is a type prefix, which is then taken.
    fn take_prefix(&mut self, expr: &Expr) -> Result<bool, Misshape> {
        let ExprKind::Name(name) = &expr.kind else { return Ok(false) };
        let Some(spelling) = catalogue::prefix(&name.text) else { return Ok(false) };
        let columns = name.columns.clone();
        if self.prefix.is_some() || !self.terms.is_empty() {
            return Err(Misshape::Form(columns, "a type prefix stands once, before the operand"));
        }
        self.prefix = Some(PrefixUse { prefix: spelling.prefix, misspelled: spelling.misspelled, columns });
        Ok(true)
    }

    /// What stands behind `BLK[n].`: a prefix or the member itself.
    fn take_in_block(
        &mut self,
        expr: &'a Expr,
        right: &'a Expr,
        minus: bool,
        inside: bool,
    ) -> Result<(), Misshape> {
        if self.take_prefix(right)? {
            return Ok(());
        }
        match &right.kind {
            ExprKind::Name(_) | ExprKind::Index { .. } => self.take(right, minus, inside),
            ExprKind::Error => Err(Misshape::Reported),
            _ => Err(Misshape::Form(expr.columns.clone(), "a member of the block is needed behind the dot")),
        }
    }

    fn term(&mut self, expr: &Expr, minus: bool, kind: TermKind<'a>) {
        self.terms.push(Term { minus, kind, columns: expr.columns.clone() });
    }

    /// Whether a `-` stands before everything.
    pub(super) fn negated(&self) -> bool {
        self.sign.as_ref().is_some_and(|(negative, _)| *negative)
    }

    /// The operand is one name and nothing else.
    pub(super) fn plain_name(&self) -> Option<&'a Name> {
        match self.terms.as_slice() {
            [Term { minus: false, kind: TermKind::Name(name), .. }]
                if self.prefix.is_none() && self.behind.is_empty() && self.block.is_none() =>
            {
                Some(name)
            }
            _ => None,
        }
    }
}

/// `BLK[n]` or `BLK` before a dot.
fn block_index(expr: &Expr) -> Option<BlockIndex<'_>> {
    let (base, index) = match &expr.kind {
        ExprKind::Index { base, index } => (&**base, Some(&**index)),
        _ => (expr, None),
    };
    match &base.kind {
        ExprKind::Name(name) if name.text.eq_ignore_ascii_case(BLOCK) => {
            Some(BlockIndex { index, columns: expr.columns.clone() })
        }
        _ => None,
    }
}

/// The expression without a type prefix before it.
pub(super) fn without_prefix(expr: &Expr) -> Expr {
    let kind = match &expr.kind {
        ExprKind::Dot { left, right } if is_prefix(left) => return (**right).clone(),
        ExprKind::Sign { negative, operand } => {
            ExprKind::Sign { negative: *negative, operand: Box::new(without_prefix(operand)) }
        }
        ExprKind::Sum { minus, left, right } => {
            ExprKind::Sum { minus: *minus, left: Box::new(without_prefix(left)), right: right.clone() }
        }
        other => other.clone(),
    };
    Expr { kind, columns: expr.columns.clone() }
}

fn is_prefix(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Name(name) if catalogue::prefix(&name.text).is_some())
}
