//! Identifiers and numbers that stand more than once in a file.

use std::collections::HashMap;
use std::hash::Hash;

use super::document::Text;
use super::problem::Problem;
use crate::diagnostics::rules::configuration as rules;

/// Reports each repeated key at its second place, with the first one beside it.
pub(super) fn find<'a, K: Eq + Hash>(
    places: impl Iterator<Item = (K, &'a Text)>,
    what: &str,
    problems: &mut Vec<Problem>,
) {
    let mut first = HashMap::new();
    for (key, place) in places {
        match first.get(&key) {
            Some(before) => {
                let message = format!("the {what} {} stands here twice", place.text);
                let problem = Problem::new(&rules::DUPLICATE_IDENTIFIER, place.span, message);
                problems.push(problem.beside(*before, "the first one"));
            }
            None => _ = first.insert(key, place.span),
        }
    }
}
