//! Macros that call themselves, directly or through others.

use std::collections::VecDeque;

use rustc_hash::{FxHashMap, FxHashSet};

use super::table::{Event, is_instruction};
use crate::database::{self, Db, Project, Section};
use crate::syntax::ast::{Columns, key};

/// A line of a body that closes a circle.
#[derive(Clone, Debug, PartialEq, Eq, salsa::SalsaValue)]
pub struct MacroCircle<'db> {
    /// The definition it stands in.
    pub section: Section<'db>,
    /// 0-based own line.
    pub line: u32,
    /// Columns of the word that calls.
    pub columns: Columns,
    /// The circle in words.
    pub circle: String,
}

/// One line for each circle.
pub(crate) fn find(db: &dyn Db, project: Project) -> Vec<MacroCircle<'_>> {
    let table = database::macro_table(db, project);
    let definitions: Vec<Section<'_>> = table
        .events
        .iter()
        .filter_map(|event| match event {
            Event::Define(section) => Some(*section),
            _ => None,
        })
        .collect();
    let mut edges: FxHashMap<Section<'_>, Vec<(Section<'_>, u32, Columns)>> = FxHashMap::default();
    for section in &definitions {
        for line in &database::macro_definition(db, *section).body {
            let Some(columns) = &line.operation else { continue };
            let word = line.text.get(columns.start as usize..columns.end as usize).unwrap_or_default();
            // In the body of a macro that overloads an instruction its word means the instruction.
            if is_instruction(word) {
                continue;
            }
            for target in table.definitions(&key(word)) {
                edges.entry(*section).or_default().push((target, line.line, columns.clone()));
            }
        }
    }
    trim(&mut edges);
    let mut found = Vec::new();
    let mut covered = FxHashSet::default();
    for start in &definitions {
        for (target, line, columns) in edges.get(start).into_iter().flatten() {
            if covered.contains(start) {
                break;
            }
            let Some(way) = way(&edges, *target, *start) else { continue };
            if !way.iter().any(|section| covered.contains(section)) {
                let names: Vec<&str> =
                    std::iter::once(start).chain(&way).map(|section| &**section.name(db)).collect();
                found.push(MacroCircle {
                    section: *start,
                    line: *line,
                    columns: columns.clone(),
                    circle: names.join(" → "),
                });
            }
            covered.extend(way);
        }
    }
    found
}

/// Drops definitions from which no circle can be reached: all of them, in a program without circles.
fn trim<'db>(edges: &mut FxHashMap<Section<'db>, Vec<(Section<'db>, u32, Columns)>>) {
    let mut callers: FxHashMap<Section<'db>, Vec<Section<'db>>> = FxHashMap::default();
    let mut open: FxHashMap<Section<'db>, usize> = FxHashMap::default();
    for (from, targets) in edges.iter() {
        open.insert(*from, targets.len());
        for (target, ..) in targets {
            callers.entry(*target).or_default().push(*from);
        }
    }
    let mut ends: Vec<Section<'db>> =
        callers.keys().filter(|target| !open.contains_key(target)).copied().collect();
    while let Some(end) = ends.pop() {
        edges.remove(&end);
        for caller in callers.remove(&end).into_iter().flatten() {
            if let Some(left) = open.get_mut(&caller) {
                *left -= 1;
                if *left == 0 {
                    ends.push(caller);
                }
            }
        }
    }
}

/// The shortest way from one definition to another, both included.
fn way<'db>(
    edges: &FxHashMap<Section<'db>, Vec<(Section<'db>, u32, Columns)>>,
    from: Section<'db>,
    to: Section<'db>,
) -> Option<Vec<Section<'db>>> {
    let mut before: FxHashMap<Section<'db>, Option<Section<'db>>> = FxHashMap::default();
    before.insert(from, None);
    let mut queue = VecDeque::from([from]);
    while let Some(at) = queue.pop_front() {
        if at == to {
            let mut way = vec![at];
            let mut step = at;
            while let Some(Some(previous)) = before.get(&step) {
                way.push(*previous);
                step = *previous;
            }
            way.reverse();
            return Some(way);
        }
        for (next, ..) in edges.get(&at).into_iter().flatten() {
            if !before.contains_key(next) {
                before.insert(*next, Some(at));
                queue.push_back(*next);
            }
        }
    }
    None
}
