//! DEBUG regions of a file (manual 5.5): off at its start, textual, up to its end.

/// Lines at which DEBUG is switched, ascending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct DebugRegions {
    switches: Vec<(u32, bool)>,
}

impl DebugRegions {
    /// Finds the DEBUG lines of a text.
    pub(super) fn of(text: &str) -> Self {
        let lines = (0u32..).zip(text.lines());
        DebugRegions { switches: lines.filter_map(|(number, line)| Some((number, switch(line)?))).collect() }
    }

    /// Whether a 0-based line lies in a region.
    pub(super) fn contains(&self, line: u32) -> bool {
        let before = self.switches.partition_point(|(at, _)| *at <= line);
        before.checked_sub(1).and_then(|n| self.switches.get(n)).is_some_and(|(_, on)| *on)
    }
}

fn switch(line: &str) -> Option<bool> {
    // Quick way out: almost no line has the word.
    if !line.as_bytes().windows(5).any(|w| w.eq_ignore_ascii_case(b"DEBUG")) {
        return None;
    }
    let code = super::source_text::without_comment(line);
    let code = code.split_once(':').map_or(code, |(_, rest)| rest);
    let mut words = code.split_whitespace();
    if !words.next()?.eq_ignore_ascii_case("DEBUG") {
        return None;
    }
    Some(!words.next().is_some_and(|word| word.eq_ignore_ascii_case("OFF")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_between_debug_and_debug_off_are_inside() {
        let text = "LDR A\n debug\nLDR B\nX: DEBUG OFF ;end\nLDR C\nDEBUG ON\nLDR D";
        let regions = DebugRegions::of(text);
        let inside: Vec<u32> = (0..7).filter(|line| regions.contains(*line)).collect();
        assert_eq!(inside, [1, 2, 5, 6]);
    }

    #[test]
    fn the_word_in_a_comment_or_a_name_switches_nothing() {
        assert_eq!(DebugRegions::of("; DEBUG ON\nLDR DEBUG_BIT\nWR A ;debug"), DebugRegions::default());
    }
}
