//! Identifiers of elements (manual 27.4).

use alloc::string::String;
use core::fmt::Write as _;

use super::{ElementError, MAX_NAME};

/// An identifier in the one spelling that is compared: small letters, without the groups `CNC.`, `PLC.Input.` and
/// `PLC.Output.`, indexes without leading zeros, `[0]` left out.
pub(crate) fn normal(text: &[u8]) -> Result<String, ElementError> {
    let text = text.trim_ascii();
    if text.is_empty() || text.len() > MAX_NAME || !text.iter().all(|byte| matches!(byte, b' '..=b'~')) {
        return Err(ElementError::BadName);
    }
    let mut rest: String = text.iter().map(|byte| char::from(byte.to_ascii_lowercase())).collect();
    for group in ["cnc.", "plc.input.", "plc.output."] {
        if let Some(behind) = rest.strip_prefix(group) {
            rest = behind.into();
        }
    }
    let mut name = String::with_capacity(rest.len());
    let mut rest = rest.as_str();
    while let Some((before, behind)) = rest.split_once('[') {
        name.push_str(before);
        match behind.split_once(']').map(|(digits, after)| (digits.trim(), after)) {
            Some((digits, after)) if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) => {
                let digits = digits.trim_start_matches('0');
                if !digits.is_empty() {
                    // Writing to a text does not fail.
                    let _ = write!(name, "[{digits}]");
                }
                rest = after;
            }
            _ => {
                name.push('[');
                rest = behind;
            }
        }
    }
    name.push_str(rest);
    if name.is_empty() { Err(ElementError::BadName) } else { Ok(name) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_identifier_has_many_spellings() {
        for (text, name) in [
            ("inDoor", Ok("indoor")),
            (" PLC.Input.InDoor ", Ok("indoor")),
            ("CNC.PLC.OUTPUT.Lamp[0]", Ok("lamp")),
            ("Servo[08].Status[00]", Ok("servo[8].status")),
            ("a[010]", Ok("a[10]")),
            ("a[x][", Ok("a[x][")),
            ("PLC.Input.", Err(ElementError::BadName)),
            ("", Err(ElementError::BadName)),
            ("[0]", Err(ElementError::BadName)),
            ("dve\u{159}e", Err(ElementError::BadName)),
        ] {
            assert_eq!(normal(text.as_bytes()).as_deref(), name.as_ref().map(|name| *name), "{text}");
        }
        assert_eq!(normal(&[b'a'; MAX_NAME + 1]), Err(ElementError::BadName));
    }
}
