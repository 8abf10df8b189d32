//! Patterns that match a word in any case where the `(?i)` flag is not to be had.

/// `ab_1` becomes `[Aa][Bb]_1`.
pub(super) fn any_case(word: &str) -> String {
    let letter = |c: char| {
        if c.is_ascii_alphabetic() {
            format!("[{}{}]", c.to_ascii_uppercase(), c.to_ascii_lowercase())
        } else {
            c.to_string()
        }
    };
    word.chars().map(letter).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_get_both_cases_and_the_rest_stays() {
        assert_eq!(any_case("Ab_1"), "[Aa][Bb]_1");
    }
}
