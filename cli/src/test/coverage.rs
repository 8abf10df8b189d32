//! Which lines and which states of mechanisms the tests have reached.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technol_image::{DebugInfo, Program};

use super::execute::Verdict;
use super::state::Mechanisms;
use crate::paint::Paint;

/// What all tests together have executed.
pub(super) struct Coverage<'a> {
    debug: &'a DebugInfo,
    mechanisms: &'a Mechanisms,
    /// For each file (project path) its lines with code and how often they were executed.
    files: BTreeMap<&'a str, BTreeMap<u32, u64>>,
    /// Procedures and sequences: file, line, name, executions.
    functions: Vec<(&'a str, u32, &'a str, u64)>,
}

impl<'a> Coverage<'a> {
    /// Adds up what the tests have counted.
    pub(super) fn of(
        verdicts: &[Verdict],
        program: &'a Program,
        debug: &'a DebugInfo,
        mechanisms: &'a Mechanisms,
    ) -> Coverage<'a> {
        let mut counts = vec![0_u64; program.code.len()];
        for verdict in verdicts {
            for (sum, count) in counts.iter_mut().zip(verdict.counts.iter().flatten()) {
                *sum += u64::from(*count);
            }
        }
        let mut files: BTreeMap<&str, BTreeMap<u32, u64>> = BTreeMap::new();
        for line in &debug.lines {
            let Some(file) = debug.files.get(usize::from(line.file)) else { continue };
            let count = counts.get(line.pc as usize).copied().unwrap_or(0);
            let lines = files.entry(file.path.as_str()).or_default();
            // A line of a macro has code in several places.
            lines.entry(line.line).and_modify(|sum| *sum += count).or_insert(count);
        }
        let mut functions = Vec::new();
        let procedures = program.procedures.iter().map(|it| (it.start, it.start, it.name.as_str()));
        let sequences = debug.mechanisms.iter().filter_map(|mechanism| {
            let sequence = program.sequences.get(usize::from(mechanism.sequence))?;
            // Its MECH_BEGIN is executed in each cycle: it has run when what follows has.
            Some((sequence.start, sequence.start.saturating_add(1), mechanism.name.as_str()))
        });
        for (begin, body, name) in procedures.chain(sequences) {
            if let (Some((file, line)), Some((of, first))) = (debug.position(begin), debug.position(body)) {
                let count = files.get(of).and_then(|lines| lines.get(&first)).copied().unwrap_or(0);
                functions.push((file, line, name, count));
            }
        }
        functions.sort_unstable();
        Coverage { debug, mechanisms, files, functions }
    }

    /// The record for tools (lcov's tracefile). `shown` is a project path as tools find it.
    pub(super) fn lcov(&self, shown: &dyn Fn(&str) -> String) -> String {
        let mut out = String::new();
        for file in self.debug.files.iter().map(|file| file.path.as_str()) {
            let Some(lines) = self.files.get(file) else { continue };
            // Writing to a string does not fail.
            let _ = writeln!(out, "TN:\nSF:{}", shown(file));
            let functions: Vec<_> = self.functions.iter().filter(|(of, ..)| *of == file).collect();
            for (_, line, name, _) in &functions {
                let _ = writeln!(out, "FN:{line},{name}");
            }
            for (_, _, name, count) in &functions {
                let _ = writeln!(out, "FNDA:{count},{name}");
            }
            let hit = functions.iter().filter(|(.., count)| *count > 0).count();
            let _ = writeln!(out, "FNF:{}\nFNH:{hit}", functions.len());
            for (line, count) in lines {
                let _ = writeln!(out, "DA:{line},{count}");
            }
            let hit = lines.values().filter(|count| **count > 0).count();
            let _ = writeln!(out, "LF:{}\nLH:{hit}\nend_of_record", lines.len());
        }
        out
    }

    /// The same for people: lines by file, states by mechanism with those that were never reached.
    pub(super) fn table(&self, paint: Paint) -> String {
        let mut out = String::new();
        let all = self.files.values().flat_map(BTreeMap::values);
        let (hit, total) = hits(all.copied());
        let _ = writeln!(out, "{} {}", paint.bold("lines executed"), share(hit, total));
        let width = self.files.keys().map(|file| file.chars().count()).max().unwrap_or(0);
        for file in self.debug.files.iter().map(|file| file.path.as_str()) {
            let Some(lines) = self.files.get(file) else { continue };
            let (hit, total) = hits(lines.values().copied());
            let missing = ranges(lines);
            let missing =
                if missing.is_empty() { missing } else { paint.yellow(format!("  not: {missing}")) };
            let _ = writeln!(out, "  {file:<width$}  {}{missing}", share(hit, total));
        }
        let states =
            self.mechanisms.list.iter().flat_map(|m| m.states.iter().map(|s| self.count(&m.file, s.line)));
        let (hit, total) = hits(states);
        let _ = writeln!(out, "{} {}", paint.bold("states reached"), share(hit, total));
        let named = self.mechanisms.list.iter().filter(|m| !m.states.is_empty());
        let width = named.clone().map(|m| m.name.chars().count()).max().unwrap_or(0);
        for mechanism in named {
            let (hit, total) = hits(mechanism.states.iter().map(|s| self.count(&mechanism.file, s.line)));
            let _ = writeln!(out, "  {:<width$}  {}", mechanism.name, share(hit, total));
            for state in mechanism.states.iter().filter(|s| self.count(&mechanism.file, s.line) == 0) {
                let _ = writeln!(out, "    {} {}:{state}", paint.yellow("never"), mechanism.file);
            }
        }
        out
    }

    fn count(&self, file: &str, line: u32) -> u64 {
        self.files.get(file).and_then(|lines| lines.get(&line)).copied().unwrap_or(0)
    }
}

/// How many are above 0, and how many there are.
fn hits(counts: impl Iterator<Item = u64>) -> (usize, usize) {
    counts.fold((0, 0), |(hit, total), count| (hit + usize::from(count > 0), total + 1))
}

fn share(hit: usize, total: usize) -> String {
    let percent = if total == 0 { 100.0 } else { 100.0 * hit as f64 / total as f64 };
    format!("{hit} of {total} ({percent:.1} %)")
}

/// Lines that were not executed, as `3, 7-9`; those without code between two of them do not part them.
fn ranges(lines: &BTreeMap<u32, u64>) -> String {
    let mut ranges: Vec<(u32, u32)> = Vec::new();
    let mut open = false;
    for (line, count) in lines {
        match ranges.last_mut() {
            Some((_, last)) if *count == 0 && open => *last = *line,
            _ if *count == 0 => ranges.push((*line, *line)),
            _ => {}
        }
        open = *count == 0;
    }
    let text = |(first, last): &(u32, u32)| {
        if first == last { first.to_string() } else { format!("{first}-{last}") }
    };
    ranges.iter().map(text).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_were_not_executed_are_shown_as_ranges() {
        let lines = BTreeMap::from([(3, 0), (5, 1), (7, 0), (8, 0), (11, 0), (12, 4)]);
        assert_eq!(ranges(&lines), "3, 7-11");
        assert_eq!(ranges(&BTreeMap::from([(1, 2)])), "");
    }

    #[test]
    fn nothing_to_reach_is_all_reached() {
        assert_eq!(share(0, 0), "0 of 0 (100.0 %)");
        assert_eq!(share(1, 3), "1 of 3 (33.3 %)");
    }
}
