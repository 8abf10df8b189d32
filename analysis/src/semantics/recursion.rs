//! Procedures that call each other in a circle.

use std::collections::{BTreeMap, BTreeSet};

use super::hir::{SymbolKey, SymbolScope};
use crate::database::{self, Db, Project, Section};
use crate::syntax::section::SectionKind;

/// A PROC_CALL that closes a circle.
#[derive(Clone, Debug, PartialEq, Eq, salsa::SalsaValue)]
pub struct RecursiveCall<'db> {
    /// The procedure it stands in.
    pub section: Section<'db>,
    /// 0-based own line.
    pub line: u32,
    /// Columns of the called name.
    pub columns: std::ops::Range<u32>,
    /// The circle in words.
    pub circle: String,
}

/// One call for each circle of procedures.
pub(crate) fn recursive_calls<'db>(db: &'db dyn Db, project: Project) -> Vec<RecursiveCall<'db>> {
    let mut calls: BTreeMap<SymbolKey, Vec<RecursiveCall<'db>>> = BTreeMap::new();
    let mut edges: BTreeMap<SymbolKey, Vec<SymbolKey>> = BTreeMap::new();
    for part in &database::parts(db, project).parts {
        if part.kind != SectionKind::Procedure {
            continue;
        }
        let own = SymbolKey { scope: SymbolScope::Global, name: part.section.name(db).clone() };
        for (called, line, columns) in &database::section_analysis(db, project, part.section).calls {
            edges.entry(own.clone()).or_default().push(called.clone());
            let call = RecursiveCall {
                section: part.section,
                line: *line,
                columns: columns.clone(),
                circle: String::new(),
            };
            calls.entry(own.clone()).or_default().push(call);
        }
    }
    let mut found = Vec::new();
    let mut covered: BTreeSet<SymbolKey> = BTreeSet::new();
    let circling = circling(&edges);
    for (start, targets) in edges.iter().filter(|(start, _)| circling.contains(start)) {
        for (index, target) in targets.iter().enumerate() {
            // Both would be in the circle.
            if covered.contains(start) || covered.contains(target) || !circling.contains(target) {
                continue;
            }
            let Some(circle) = path(&edges, target, start) else { continue };
            if !circle.iter().any(|key| covered.contains(key)) {
                let mut call = calls[start][index].clone();
                let names: Vec<&str> = std::iter::once(start).chain(&circle).map(|key| &*key.name).collect();
                call.circle = names.join(" → ");
                found.push(call);
            }
            covered.extend(circle);
        }
    }
    found
}

/// Procedures that may be in a circle: without those that call nothing, or that nobody calls, once such ones are left out. Most
/// programs have none, and the search below costs a walk through all calls for each of them.
fn circling(edges: &BTreeMap<SymbolKey, Vec<SymbolKey>>) -> BTreeSet<&SymbolKey> {
    let mut back: BTreeMap<&SymbolKey, Vec<&SymbolKey>> = BTreeMap::new();
    let mut forth: BTreeMap<&SymbolKey, Vec<&SymbolKey>> = BTreeMap::new();
    for (start, target) in edges.iter().flat_map(|(start, targets)| targets.iter().map(move |it| (start, it)))
    {
        forth.entry(start).or_default().push(target);
        back.entry(target).or_default().push(start);
    }
    let mut left: BTreeSet<&SymbolKey> = forth.keys().chain(back.keys()).copied().collect();
    for (out, into) in [(&forth, &back), (&back, &forth)] {
        let count =
            |key: &&SymbolKey| out.get(key).map_or(0, |it| it.iter().filter(|it| left.contains(*it)).count());
        let mut counts: BTreeMap<&SymbolKey, usize> = left.iter().map(|key| (*key, count(key))).collect();
        let mut ends: Vec<&SymbolKey> =
            counts.iter().filter(|(_, n)| **n == 0).map(|(key, _)| *key).collect();
        while let Some(end) = ends.pop() {
            left.remove(end);
            for other in into.get(end).into_iter().flatten() {
                if let Some(count) = counts.get_mut(other) {
                    *count -= 1;
                    if *count == 0 {
                        ends.push(other);
                    }
                }
            }
        }
    }
    left
}

/// The shortest way from one procedure to another, both included.
fn path(
    edges: &BTreeMap<SymbolKey, Vec<SymbolKey>>,
    from: &SymbolKey,
    to: &SymbolKey,
) -> Option<Vec<SymbolKey>> {
    let mut before: BTreeMap<&SymbolKey, Option<&SymbolKey>> = BTreeMap::from([(from, None)]);
    let mut queue = std::collections::VecDeque::from([from]);
    while let Some(at) = queue.pop_front() {
        if at == to {
            let mut way = vec![at.clone()];
            let mut step = at;
            while let Some(Some(previous)) = before.get(step) {
                way.push((*previous).clone());
                step = previous;
            }
            way.reverse();
            return Some(way);
        }
        for next in edges.get(at).into_iter().flatten() {
            before.entry(next).or_insert_with(|| {
                queue.push_back(next);
                Some(at)
            });
        }
    }
    None
}
