//! The values of all EQUI constants of the project.

use std::collections::BTreeSet;
use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::constant::ConstExpr;
use super::declarations::What;
use super::exports::AllExports;
use super::program::Part;
use crate::catalogue::SystemKind;

/// EQUI constants of the project.
#[derive(Default)]
pub(super) struct Constants {
    /// Value by key; `None` when it cannot be computed.
    pub(super) values: FxHashMap<Arc<str>, Option<i64>>,
    /// Names with different values.
    pub(super) conflicts: BTreeSet<Arc<str>>,
    /// Names at which a circle was found.
    pub(super) circular: BTreeSet<Arc<str>>,
}

impl Constants {
    pub(super) fn resolve(exports: &AllExports<'_>, parts: &[Part<'_>]) -> Constants {
        let mut open: FxHashMap<Arc<str>, Vec<&ConstExpr>> = FxHashMap::default();
        let mut known = Constants::default();
        for part in parts {
            let names = exports
                .of(part)
                .flat_map(|(_, exports, _)| exports.names.iter().enumerate().map(move |it| (exports, it)));
            for (exports, (index, (name, what))) in names {
                if let What::Constant(value) = what {
                    match (value, exports.expressions.iter().find(|(i, _)| *i == index as u32)) {
                        (Some(value), _) => known.add(name, Some(*value)),
                        (None, Some((_, expr))) => open.entry(name.clone()).or_default().push(expr),
                        (None, None) => known.add(name, None),
                    }
                }
            }
        }
        let names: BTreeSet<Arc<str>> = open.keys().cloned().collect();
        let mut busy = BTreeSet::new();
        for name in names {
            known.compute(&name, &open, &mut busy);
        }
        known
    }

    fn add(&mut self, name: &Arc<str>, value: Option<i64>) {
        match self.values.get(name) {
            Some(before) if *before != value => {
                self.conflicts.insert(name.clone());
            }
            Some(_) => {}
            None => {
                self.values.insert(name.clone(), value);
            }
        }
    }

    fn compute(
        &mut self,
        name: &Arc<str>,
        open: &FxHashMap<Arc<str>, Vec<&ConstExpr>>,
        busy: &mut BTreeSet<Arc<str>>,
    ) {
        let Some(exprs) = open.get(name) else { return };
        // A chain so long that following it would exhaust the stack counts as a circle.
        if busy.len() > 200 || !busy.insert(name.clone()) {
            self.circular.insert(name.clone());
            return;
        }
        for expr in exprs {
            let mut needed = Vec::new();
            expr.names(&mut needed);
            for other in needed {
                let other: Arc<str> = Arc::from(other);
                if !self.values.contains_key(&other) {
                    self.compute(&other, open, busy);
                }
            }
            let value = self.value(expr).filter(|v| (-0x8000_0000..=0xFFFF_FFFF).contains(v));
            self.add(name, value);
        }
        busy.remove(name);
    }

    pub(super) fn value(&self, expr: &ConstExpr) -> Option<i64> {
        expr.value(&mut |name| self.values.get(name).copied().flatten().or_else(|| system_constant(name)))
            .ok()
    }
}

/// The value of a predefined constant.
fn system_constant(name: &str) -> Option<i64> {
    match crate::catalogue::symbol(name)?.kind {
        SystemKind::Constant(value) => Some(value),
        _ => None,
    }
}
