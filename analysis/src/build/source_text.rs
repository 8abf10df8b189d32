//! Source text as shown beside code: conditions of states and listing lines.

/// Longest condition in characters.
const CONDITION: usize = 80;
const SEPARATOR: &str = " / ";

/// A line up to its comment; a semicolon between apostrophes is none (manual 3.1, 3.18).
pub(super) fn without_comment(line: &str) -> &str {
    let mut quoted = false;
    for (at, byte) in line.bytes().enumerate() {
        match byte {
            b'\'' => quoted = !quoted,
            b';' if !quoted => return &line[..at],
            _ => {}
        }
    }
    line
}

/// The operation of a line without label and comment, single spaces; empty when there is none.
fn operation(line: &str) -> String {
    let code = without_comment(line).trim();
    let code = match code.split_once(':') {
        Some((label, rest)) if label.chars().all(|c| c.is_alphanumeric() || "_?@".contains(c)) => rest,
        _ => code,
    };
    code.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What a state waits for: its lines, joined; when they are too long the last ones, which lie next to the wait.
pub(super) fn condition<'a>(lines: impl DoubleEndedIterator<Item = &'a str>) -> String {
    let mut shown: Vec<String> = Vec::new();
    let mut length = 0;
    let mut complete = true;
    for line in lines.rev().map(operation).filter(|line| !line.is_empty()) {
        length += line.chars().count() + SEPARATOR.len();
        shown.push(line);
        if length > CONDITION + SEPARATOR.len() {
            complete = false;
            break;
        }
    }
    shown.reverse();
    if complete {
        return shown.join(SEPARATOR);
    }
    // Room for the mark of what is left out.
    let fits =
        |shown: &[String]| 1 + shown.iter().map(|l| l.chars().count() + SEPARATOR.len()).sum::<usize>();
    while shown.len() > 1 && fits(&shown) > CONDITION {
        shown.remove(0);
    }
    let text = shown.join(SEPARATOR);
    if fits(&shown) <= CONDITION {
        format!("…{SEPARATOR}{text}")
    } else {
        text.chars().take(CONDITION - 1).chain(['…']).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_condition_is_its_lines_without_comments_and_labels() {
        let lines = ["  FL   1,PUMP ; start", "", "WAIT:", "again: LDR FLOW", "LOD CNST.';'"];
        assert_eq!(condition(lines.into_iter()), "FL 1,PUMP / LDR FLOW / LOD CNST.';'");
        assert_eq!(condition([].into_iter()), "");
    }

    #[test]
    fn a_long_condition_keeps_the_lines_next_to_the_wait() {
        let lines: Vec<String> = (0..20).map(|n| format!("LA CONTACT_{n:02}")).collect();
        let shown = condition(lines.iter().map(String::as_str));
        assert_eq!(shown, "… / LA CONTACT_16 / LA CONTACT_17 / LA CONTACT_18 / LA CONTACT_19");
        let long = "STRCPY A,'".to_owned() + &"ž".repeat(200) + "'";
        let shown = condition([long.as_str()].into_iter());
        assert!(shown.ends_with("ž…") && shown.chars().count() == 80, "{shown}");
        let exact = ["LDR A".repeat(8), "B".repeat(37)];
        assert_eq!(condition(exact.iter().map(String::as_str)).chars().count(), 80);
    }
}
