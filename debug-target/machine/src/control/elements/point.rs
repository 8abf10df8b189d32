//! A cell of the program that is bound to elements.

use alloc::vec::Vec;

use technol_image::op::Width;
use technol_image::service::Arg;
use technol_runtime::{Call, FaultKind, Rate};

use super::MAX_ELEMENTS;
use super::cell::Cell;
use super::mapping::Physical;
use super::value::{CellType, ElementValue};

/// Which instructions declare it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Group {
    /// MAP_*.
    Mapped,
    /// DEF_IN, DEF_OUT.
    Logical,
}

/// A cell, or an array of them.
#[derive(Clone, Debug)]
pub(super) struct Point {
    /// The call that declared it.
    pub(super) call: u16,
    pub(super) group: Group,
    pub(super) output: bool,
    pub(super) kind: CellType,
    pub(super) addr: usize,
    /// Bytes of one element, at least 1.
    pub(super) size: usize,
    /// Bytes of all.
    len: usize,
    /// When it is served; `None` on demand.
    pub(super) rate: Option<Rate>,
    /// Numbers of its elements.
    pub(super) elements: Vec<usize>,
    /// A bit of MAP_OUT: what it was when it was served last.
    pub(super) on: bool,
    /// Where the configuration leads it.
    pub(super) physical: Option<Physical>,
    /// A cell of the control itself, which no call declared; it is served whenever anything is.
    pub(super) fixed: bool,
    /// What 1 in a cell of the control is in the unit of the element.
    scale: f64,
}

impl Point {
    /// What a call declares, and its cells with the default in each; `None` when it declares nothing.
    pub(super) fn declared(
        call: &Call<'_>,
        group: Group,
        output: bool,
    ) -> Result<Option<(Point, Vec<u8>)>, FaultKind> {
        let Some((addr, len)) = call.area(0)? else { return Ok(None) };
        let bit = match call.arg(0) {
            Arg::Bit { bit, .. } => Some(bit.bit),
            _ => None,
        };
        let (kind, default, period) = match group {
            Group::Logical => {
                (call.keyword(2).and_then(|word| CellType::of(word, bit.unwrap_or(0))), 3, call.keyword(4))
            }
            Group::Mapped => (Some(bit.map_or(CellType::Real, CellType::Bit)), 2, call.keyword(3)),
        };
        let Some(kind) = kind else { return Ok(None) };
        let rate = match period {
            Some("ONDEMAND") => None,
            Some("FASTEST") => Some(Rate::Fastest),
            Some("FAST") => Some(Rate::Fast),
            _ => Some(Rate::Slow),
        };
        let size = kind.size(len as usize);
        if size == 0 || len as usize / size > MAX_ELEMENTS {
            return Ok(None);
        }
        let mut cells = call.bytes(addr, len)?.to_vec();
        let default = default_of(call, default, kind)?;
        for cell in cells.chunks_exact_mut(size) {
            kind.write(cell, &default);
        }
        let point = Point {
            call: call.index(),
            group,
            output,
            kind,
            addr: addr as usize,
            size,
            len: len as usize,
            rate,
            elements: Vec::new(),
            on: false,
            physical: None,
            fixed: false,
            scale: 1.0,
        };
        Ok(Some((point, cells)))
    }

    /// A cell of the control itself, bound to an element.
    pub(super) fn fixed(cell: Cell, output: bool, element: usize) -> Point {
        let Cell { addr, kind, scale } = cell;
        let (addr, size) = (addr as usize, kind.size(0));
        Point {
            call: u16::MAX,
            group: Group::Logical,
            output,
            kind,
            addr,
            size,
            len: size,
            rate: Some(Rate::Fast),
            elements: alloc::vec![element],
            on: false,
            physical: None,
            fixed: true,
            scale,
        }
    }

    /// The value of a cell of the control in the unit of its element.
    #[expect(clippy::float_cmp, reason = "only the unit of the cell itself is left as it is")]
    pub(super) fn in_its_unit(&self, value: ElementValue) -> ElementValue {
        match value.as_real() {
            Some(real) if self.scale != 1.0 => (real * self.scale).into(),
            _ => value,
        }
    }

    /// The other way round; `None` where there is nothing to convert.
    #[expect(clippy::float_cmp, reason = "only the unit of the cell itself is left as it is")]
    pub(super) fn in_its_cell(&self, value: &ElementValue) -> Option<ElementValue> {
        value.as_real().filter(|_| self.scale != 1.0).map(|real| (real / self.scale).into())
    }

    /// How many elements it has.
    pub(super) fn count(&self) -> usize {
        self.len / self.size
    }

    /// A bit of MAP_OUT or MAP_IN.
    pub(super) fn is_mapped_bit(&self) -> bool {
        self.group == Group::Mapped && matches!(self.kind, CellType::Bit(_))
    }

    /// It is served at this rate, `before` the modules or after them.
    pub(super) fn is_due(&self, rate: Rate, before: bool) -> bool {
        self.fixed || self.rate == Some(rate) && (self.group == Group::Logical || before != self.output)
    }
}

/// The default at operand `n`; without it zero, or an empty text.
fn default_of(call: &Call<'_>, n: usize, kind: CellType) -> Result<ElementValue, FaultKind> {
    if matches!(kind, CellType::Text | CellType::Block) {
        return Ok(ElementValue::Bytes(Vec::new()));
    }
    Ok(match call.arg(n) {
        Arg::Real(_) | Arg::Cell { width: Width::Real, .. } => call.real(n)?.unwrap_or(0.0).into(),
        _ => call.integer(n)?.unwrap_or(0).into(),
    })
}
