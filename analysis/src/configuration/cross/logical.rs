//! Identifiers of logical elements (manual 27.3).

use crate::catalogue::ConfigElement;

/// One end of a connection.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct End<'a> {
    /// What it belongs to.
    pub(crate) group: Group,
    /// The name behind the group, as written.
    pub(crate) name: &'a str,
}

/// Groups of logical elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    /// `PLC.Input.`: DEF_IN.
    PlcInput,
    /// `PLC.Output.`: DEF_OUT.
    PlcOutput,
    /// `CAN[n].` with an input of a unit.
    UnitInput,
    /// `CAN[n].` with an output of a unit.
    UnitOutput,
    /// `ECAT.`, with the direction the process image gives it.
    EtherCat(Option<Direction>),
    /// `RTM.`: of the real-time program.
    Rtm,
    /// `VKeyboard.`: the virtual keyboard.
    Keyboard,
    /// `CAN[n].` with something else.
    Unit,
    /// None of these.
    Unknown,
}

/// Whether a signal can come from an element or go to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    /// It gives a signal: a logical output.
    Source,
    /// It takes one: a logical input.
    Destination,
}

impl Group {
    /// What the element may be; `None` when it may be either.
    pub(crate) const fn direction(self) -> Option<Direction> {
        match self {
            Group::PlcOutput | Group::UnitInput => Some(Direction::Source),
            Group::PlcInput | Group::UnitOutput | Group::Keyboard => Some(Direction::Destination),
            Group::EtherCat(direction) => direction,
            Group::Rtm | Group::Unit | Group::Unknown => None,
        }
    }

    /// The elements of the program it holds.
    pub(crate) const fn element(self) -> Option<ConfigElement> {
        match self {
            Group::PlcInput => Some(ConfigElement::LogicalInput),
            Group::PlcOutput => Some(ConfigElement::LogicalOutput),
            _ => None,
        }
    }
}

/// Splits the identifier of a connection into group and name.
pub(crate) fn end(text: &str) -> End<'_> {
    let text = text.trim();
    let text = behind(text, "CNC.").unwrap_or(text);
    let groups = [
        ("PLC.Input.", Group::PlcInput),
        ("PLC.Output.", Group::PlcOutput),
        ("RTM.", Group::Rtm),
        ("VKeyboard.", Group::Keyboard),
        ("ECAT.", Group::EtherCat(None)),
    ];
    for (prefix, group) in groups {
        if let Some(name) = behind(text, prefix) {
            let group =
                if group == Group::EtherCat(None) { Group::EtherCat(image_direction(name)) } else { group };
            return End { group, name };
        }
    }
    let unit = behind(text, "CAN[").and_then(|rest| rest.split_once("]."));
    match unit {
        Some((number, name)) if !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()) => {
            End { group: unit_group(name), name }
        }
        _ => End { group: Group::Unknown, name: text },
    }
}

/// The rest behind a prefix in any case.
fn behind<'a>(text: &'a str, prefix: &str) -> Option<&'a str> {
    let head = text.get(..prefix.len())?;
    head.eq_ignore_ascii_case(prefix).then(|| &text[prefix.len()..])
}

fn image_direction(name: &str) -> Option<Direction> {
    let name = name.to_ascii_lowercase();
    match (name.contains(".inputs."), name.contains(".outputs.")) {
        (true, false) => Some(Direction::Source),
        (false, true) => Some(Direction::Destination),
        _ => None,
    }
}

fn unit_group(name: &str) -> Group {
    let port = name.split('.').nth(1).unwrap_or_default();
    match (behind(port, "IP"), behind(port, "OP")) {
        (Some(_), _) => Group::UnitInput,
        (_, Some(_)) => Group::UnitOutput,
        _ => Group::Unit,
    }
}

/// An identifier in the form in which two are compared: upper case, without indexes 0, and without leading zeros.
pub(crate) fn normal(text: &str) -> String {
    let mut normal = String::new();
    let mut rest = text.trim();
    while let Some(open) = rest.find('[') {
        let (head, tail) = rest.split_at(open);
        normal.push_str(head);
        let close = tail.find(']');
        let index = close.map(|close| &tail[1..close]).filter(|i| i.bytes().all(|b| b.is_ascii_digit()));
        if let (Some(close), Some(index)) = (close, index) {
            let digits = index.trim_start_matches('0');
            if !digits.is_empty() {
                normal.push('[');
                normal.push_str(digits);
                normal.push(']');
            }
            rest = &tail[close + 1..];
        } else {
            normal.push('[');
            rest = &tail[1..];
        }
    }
    normal.push_str(rest);
    normal.to_ascii_uppercase()
}

/// Names under which the program may have declared what a connection means: as it is, without an index at its end,
/// each also without `.Bit[n]`.
pub(crate) fn candidates(name: &str) -> Vec<String> {
    let whole = normal(name);
    let mut all = vec![whole.clone()];
    if let Some(at) = whole.rfind(".BIT").filter(|_| is_bit_of_number(name)) {
        all.push(whole[..at].to_string());
    }
    for index in 0..all.len() {
        if let Some(base) = without_index(&all[index]) {
            all.push(base.to_string());
        }
    }
    all
}

/// A normal identifier without the index at its end.
pub(crate) fn without_index(normal: &str) -> Option<&str> {
    let inner = normal.strip_suffix(']')?;
    let open = inner.rfind('[')?;
    inner[open + 1..].bytes().all(|b| b.is_ascii_digit()).then(|| &normal[..open])
}

/// Whether a name means one bit of a number.
pub(crate) fn is_bit_of_number(name: &str) -> bool {
    let normal = normal(name);
    let base = without_index(&normal).unwrap_or(&normal);
    base.rsplit_once('.').is_some_and(|(_, member)| member == "BIT")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_indexes_leading_zeros_and_case_make_no_difference() {
        assert_eq!(normal("BunIn[00].Prvek[05]"), "BUNIN.PRVEK[5]");
        assert_eq!(normal("a[0]"), normal("A"));
        assert_eq!(normal("a[x]"), "A[X]");
        assert_eq!(normal("[[["), "[[[");
    }

    #[test]
    fn a_connection_may_add_an_index_and_a_bit() {
        assert_eq!(candidates("Bun[3].Bit[7]"), ["BUN[3].BIT[7]", "BUN[3]", "BUN[3].BIT", "BUN"]);
        assert_eq!(candidates("Bun"), ["BUN"]);
        assert!(is_bit_of_number("a.Bit[2]") && is_bit_of_number("a.bit[0]") && !is_bit_of_number("a.Bits"));
    }

    #[test]
    fn groups_tell_the_direction() {
        let direction = |text| end(text).group.direction();
        assert_eq!(direction("CNC.plc.output.x"), Some(Direction::Source));
        assert_eq!(direction("PLC.Input.x"), Some(Direction::Destination));
        assert_eq!(direction("CAN[1].INOUT08[2].OP1.Bit[2]"), Some(Direction::Destination));
        assert_eq!(direction("CAN[1].INOUT08.IP0"), Some(Direction::Source));
        assert_eq!(direction("ECAT.Drive 0.Inputs.Status word"), Some(Direction::Source));
        assert_eq!(direction("ECAT.Drive 0.Outputs.Control word"), Some(Direction::Destination));
        assert_eq!(direction("RTM.Axis[2].Pos0_Ax"), None);
        assert_eq!(end("PLC.Inputs.x").group, Group::Unknown);
        assert_eq!(end("CAN[x].A").group, Group::Unknown);
    }
}
