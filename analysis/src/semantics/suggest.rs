//! "Did you mean": the nearest of known names.

use std::sync::Arc;

use super::scope::Scope;
use crate::diagnostics::Finding;
use crate::diagnostics::rules::syntax;
use crate::syntax::ast::Name;

/// The candidate nearest to `word`, if one is near enough to be a likely slip. Both are compared in upper case.
pub(crate) fn nearest<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let mut search = Search::new(word)?;
    for candidate in candidates {
        search.offer(candidate, Letters::of(candidate));
    }
    search.best.map(|(_, name)| name)
}

/// The report of a word that is no instruction; `known` are those it may be meant for.
pub(super) fn unknown_instruction<'a>(
    line: u32,
    operation: &Name,
    known: impl Iterator<Item = &'a str>,
) -> Finding {
    let near = nearest(&operation.text, known);
    let message = match near {
        Some(near) => format!("{} is no instruction; did you mean {near}?", operation.text),
        None => format!("{} is neither an instruction nor a macro of this project", operation.text),
    };
    let finding = Finding::new(&syntax::UNKNOWN_INSTRUCTION, line, operation.columns.clone(), message);
    match near {
        Some(near) => finding.replace(format!("write {near}"), operation.columns.clone(), near),
        None => finding,
    }
}

/// Names of a project, laid out so that looking at all of them takes no time to speak of.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Spellings {
    /// Global names.
    globals: Group,
    /// Local names of each file.
    locals: Vec<Group>,
}

/// Letters beside each other, names beside each other: a search reads few of the names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Group {
    letters: Vec<Letters>,
    names: Vec<Arc<str>>,
}

impl Spellings {
    pub(crate) fn of(scope: &Scope) -> Spellings {
        let locals = scope.locals.iter().map(|table| Group::of(table.keys())).collect();
        Spellings { globals: Group::of(scope.globals.keys()), locals }
    }

    /// The name nearest to `word` among those that a file sees. Names of macros' own are not offered.
    pub(crate) fn nearest(&self, word: &str, file: Option<u8>) -> Option<&str> {
        let mut search = Search::new(word)?;
        let local = file.and_then(|file| self.locals.get(usize::from(file)));
        for group in local.into_iter().chain([&self.globals]) {
            for (letters, name) in group.letters.iter().zip(&group.names) {
                search.offer(name, *letters);
            }
        }
        search.best.map(|(_, name)| name)
    }
}

impl Group {
    fn of<'a>(names: impl Iterator<Item = &'a Arc<str>>) -> Group {
        let names: Vec<Arc<str>> = names.filter(|name| !name.contains("@@")).cloned().collect();
        Group { letters: names.iter().map(|name| Letters::of(name)).collect(), names }
    }
}

/// Length of a word, and which characters it has, in upper case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Letters {
    set: u64,
    len: u32,
}

impl Letters {
    fn of(word: &str) -> Letters {
        let set = word.bytes().fold(0, |set, byte| set | 1 << (byte.to_ascii_uppercase() & 63));
        Letters { set, len: u32::try_from(word.len()).unwrap_or(u32::MAX) }
    }

    /// A number that the distance of the two words is not below.
    fn at_least(self, other: Letters) -> usize {
        let missing = (self.set & !other.set).count_ones().max((other.set & !self.set).count_ones());
        self.len.abs_diff(other.len).max(missing) as usize
    }
}

struct Search<'a> {
    word: Vec<u8>,
    letters: Letters,
    limit: usize,
    best: Option<(usize, &'a str)>,
}

impl<'a> Search<'a> {
    fn new(word: &str) -> Option<Search<'a>> {
        let limit = match word.len() {
            0 | 1 => return None,
            2..=4 => 1,
            5..=8 => 2,
            _ => 3,
        };
        let letters = Letters::of(word);
        Some(Search { word: word.to_ascii_uppercase().into_bytes(), letters, limit, best: None })
    }

    fn offer(&mut self, candidate: &'a str, letters: Letters) {
        let bound = self.best.map_or(self.limit, |(distance, _)| distance);
        if self.letters.at_least(letters) > bound {
            return;
        }
        let Some(distance) = distance(&self.word, candidate.as_bytes(), bound) else { return };
        // Of two that are equally near the one with the same first letter, then the first in the alphabet.
        let rank = |distance: usize, name: &'a str| {
            let first = name.bytes().next().map(|byte| byte.to_ascii_uppercase());
            (distance, first != self.word.first().copied(), name)
        };
        let better = self.best.is_none_or(|(before, name)| rank(distance, candidate) < rank(before, name));
        if better && distance <= self.limit {
            self.best = Some((distance, candidate));
        }
    }
}

/// Longest word that is compared: names are significant to half of it.
const LONGEST: usize = 63;

/// Number of inserted, deleted, replaced or swapped neighbouring characters; `None` when it is above `bound`. `b` is
/// compared in upper case.
fn distance(a: &[u8], b: &[u8], bound: usize) -> Option<usize> {
    if a.len().max(b.len()) > LONGEST {
        return None;
    }
    // Three rows of the usual table. No number is above LONGEST, so bytes hold them.
    let mut before = [0_u8; LONGEST + 1];
    let mut last = [0_u8; LONGEST + 1];
    for (cell, count) in last.iter_mut().zip(0..=b.len() as u8) {
        *cell = count;
    }
    for i in 1..=a.len() {
        let mut row = [0_u8; LONGEST + 1];
        row[0] = i as u8;
        let mut least = row[0];
        for j in 1..=b.len() {
            let other = b[j - 1].to_ascii_uppercase();
            let replaced = last[j - 1] + u8::from(a[i - 1] != other);
            row[j] = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2].to_ascii_uppercase() && a[i - 2] == other {
                row[j] = row[j].min(before[j - 2] + 1);
            }
            least = least.min(row[j]);
        }
        // A swap looks two rows back, but then the row between them is at most one above.
        if usize::from(least) > bound + 1 {
            return None;
        }
        before = std::mem::replace(&mut last, row);
    }
    let found = usize::from(last[b.len()]);
    (found <= bound).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_offered_and_far_ones_are_not() {
        let names = ["SPINDLE_ON", "SPINDLE_OFF", "CHUCK", "LDR"];
        let near = |word| nearest(word, names.iter().copied());
        assert_eq!(near("SPINDEL_ON"), Some("SPINDLE_ON"));
        assert_eq!(near("chuk"), Some("CHUCK"));
        assert_eq!(near("LRD"), Some("LDR"));
        assert_eq!(near("COOLANT"), None);
        assert_eq!(near("X"), None);
        assert_eq!(nearest("WRR", ["RR", "WRX", "WR"].into_iter()), Some("WR"));
    }

    #[test]
    fn leaving_names_out_by_their_letters_changes_no_answer() {
        let words =
            ["A", "AB", "ABBA", "BABA", "ABCD", "DCBA", "ACBD", "MOTOR_1", "MOTOR_2", "MOTR_1", "XMOTOR_1Y"];
        for a in words {
            for b in words {
                let least = Letters::of(a).at_least(Letters::of(b));
                let exact = distance(a.as_bytes(), b.as_bytes(), LONGEST).expect("short words");
                assert!(least <= exact, "{a} {b}");
                for bound in 0..=LONGEST {
                    let found = distance(a.as_bytes(), b.as_bytes(), bound);
                    assert_eq!(found, (exact <= bound).then_some(exact), "{a} {b} {bound}");
                }
            }
        }
    }
}
