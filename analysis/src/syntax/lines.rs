//! Lines of a text: the one place that knows where they end.

/// A line and its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SourceLine<'a> {
    /// The line without its end.
    pub text: &'a str,
    /// `\n`, `\r\n`, `\r`, or nothing at the end of the text.
    pub end: &'a str,
}

/// The lines of a text. Lines end with `\n`, `\r\n` or a lone `\r`, as editors count them; the end of the last
/// line does not open another one, so that an empty text has none.
pub fn lines(text: &str) -> impl Iterator<Item = SourceLine<'_>> {
    let mut rest = text;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let len = rest.bytes().position(|b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
        let (text, after) = rest.split_at(len);
        let end = if after.starts_with("\r\n") { 2 } else { after.len().min(1) };
        let (end, after) = after.split_at(end);
        rest = after;
        Some(SourceLine { text, end })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_end_ends_a_line() {
        let cut: Vec<_> = lines("a\nb\r\nc\rd\n\n\r\re").map(|l| (l.text, l.end)).collect();
        assert_eq!(
            cut,
            [
                ("a", "\n"),
                ("b", "\r\n"),
                ("c", "\r"),
                ("d", "\n"),
                ("", "\n"),
                ("", "\r"),
                ("", "\r"),
                ("e", "")
            ]
        );
    }

    #[test]
    fn the_last_end_opens_no_line() {
        assert_eq!(lines("").count(), 0);
        assert_eq!(lines("a").count(), 1);
        assert_eq!(lines("a\n").count(), 1);
        assert_eq!(lines("\n").count(), 1);
    }
}
