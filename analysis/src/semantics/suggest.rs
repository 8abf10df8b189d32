//! "Did you mean": the nearest of known names.

/// The candidate nearest to `word`, if one is near enough to be a likely slip. Both are compared in upper case.
pub(crate) fn nearest<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_ascii_uppercase().into_bytes();
    let limit = match word.len() {
        0 | 1 => return None,
        2..=4 => 1,
        5..=8 => 2,
        _ => 3,
    };
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let bound = best.map_or(limit, |(distance, _)| distance.saturating_sub(1).min(limit));
        if candidate.len().abs_diff(word.len()) > bound {
            continue;
        }
        let distance = distance(&word, candidate.to_ascii_uppercase().as_bytes());
        let better = match best {
            None => distance <= limit,
            Some((before, name)) => distance < before || (distance == before && candidate < name),
        };
        if better {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, name)| name)
}

/// Number of inserted, deleted, replaced or swapped neighbouring characters.
fn distance(a: &[u8], b: &[u8]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let replaced = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
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
    }
}
