//! What an expert would remark: code that cannot be reached, names nobody uses, waits that never end.
//!
//! [`sections`](section) looks at the code of one section and is part of its analysis. The lints of the whole project read
//! [`uses`], small summaries of the sections without positions, joined by file: [`project`] asks them about each name a file
//! declares, so that typing in one section runs nothing of another one.

mod memory;
mod motion;
mod overlays;
mod reach;
mod timeout;

pub mod project;
pub mod registers;
pub mod uses;

use std::collections::BTreeMap;
use std::sync::Arc;

use super::hir::Body;
use crate::diagnostics::Finding;
use crate::syntax::ast::{Columns, Line};
use crate::syntax::section::SectionKind;

/// A section as its lints see it.
pub(super) struct Code<'a> {
    pub(super) kind: SectionKind,
    pub(super) body: &'a Body,
    pub(super) lines: &'a [Line],
    pub(super) labels: &'a BTreeMap<Arc<str>, (u32, Columns)>,
}

/// The lints of a section all of whose lines are understood.
pub(super) fn section(code: &Code<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    reach::check(code, &mut findings);
    motion::waits(code, &mut findings);
    timeout::without_path(code, &mut findings);
    findings
}

/// Columns of the operation of an own line.
fn operation(code: &Code<'_>, line: u32) -> Columns {
    let line = code.lines.get(line as usize);
    line.and_then(|line| line.operation.as_ref()).map_or(0..0, |name| name.columns.clone())
}
