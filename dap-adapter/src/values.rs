//! Values as text. What is typed is read by `technol_analysis::expression`, as everywhere in this project.

use technol_image::op::Width;

/// What the language calls a width.
pub(crate) fn type_name(width: Width) -> &'static str {
    match width {
        Width::Byte => "BYTE",
        Width::Word => "WORD",
        Width::DWord => "DWRD",
        Width::QWord => "QWRD",
        Width::Real => "REAL",
    }
}

/// A bit.
pub(crate) fn bit(value: bool) -> String {
    value.to_string()
}

/// The hexadecimal form of the language: all digits of the width, a leading 0 before a letter.
pub(crate) fn hex(raw: u64, width: Width) -> String {
    let digits = format!("{:0n$X}", raw & mask(width), n = width.bytes() as usize * 2);
    if digits.starts_with(|c: char| c.is_ascii_alphabetic()) {
        format!("0{digits}h")
    } else {
        format!("{digits}h")
    }
}

/// A cell: `300 (012Ch)`; with what a signed reading gives where that differs: `255 (0FFh, -1)`.
pub(crate) fn cell(raw: u64, width: Width, only_hex: bool) -> String {
    let raw = raw & mask(width);
    if width == Width::Real {
        return real(f64::from_bits(raw));
    }
    let hex = hex(raw, width);
    if only_hex {
        return hex;
    }
    match signed(raw, width) {
        negative if negative < 0 => format!("{raw} ({hex}, {negative})"),
        _ => format!("{raw} ({hex})"),
    }
}

/// A register part: signed, as the language computes with it.
pub(crate) fn register(raw: u64, width: Width, only_hex: bool) -> String {
    let hex = hex(raw, width);
    if only_hex { hex } else { format!("{} ({hex})", signed(raw, width)) }
}

/// A real number; always with a point, so that it is recognised as one.
pub(crate) fn real(value: f64) -> String {
    format!("{value:?}")
}

/// A zero-terminated text.
pub(crate) fn text(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|b| *b == 0).unwrap_or(bytes.len());
    let shown: String =
        bytes[..end].iter().map(|b| if b.is_ascii_control() { '·' } else { char::from(*b) }).collect();
    format!("'{}'", shown.replace('\'', "''"))
}

/// Sign-extends.
pub(crate) fn signed(raw: u64, width: Width) -> i64 {
    let unused = 64 - width.bits();
    ((raw << unused) as i64) >> unused
}

fn mask(width: Width) -> u64 {
    u64::MAX >> (64 - width.bits())
}

/// What a user typed: values are often edited as they are shown, so `300 (012Ch)` is taken back as 300.
pub(crate) fn typed(text: &str) -> &str {
    let text = text.trim();
    match text.split_once(" (") {
        Some((value, shown)) if shown.ends_with(')') && !text.starts_with('\'') => value,
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_shown_decimal_with_hexadecimal() {
        for (raw, width, shown) in [
            (300, Width::Word, "300 (012Ch)"),
            (255, Width::Byte, "255 (0FFh, -1)"),
            (5, Width::Byte, "5 (05h)"),
            (0x8000_0000, Width::DWord, "2147483648 (80000000h, -2147483648)"),
            (u64::MAX, Width::QWord, "18446744073709551615 (0FFFFFFFFFFFFFFFFh, -1)"),
            (2.5_f64.to_bits(), Width::Real, "2.5"),
            (3_f64.to_bits(), Width::Real, "3.0"),
        ] {
            assert_eq!(cell(raw, width, false), shown);
        }
        assert_eq!(cell(0xABCD, Width::Word, true), "0ABCDh");
        assert_eq!(register(0xFFFF, Width::Word, false), "-1 (0FFFFh)");
        assert_eq!(text(b"it's\x01\0rest"), "'it''s·'");
    }

    #[test]
    fn what_is_shown_can_be_typed_back() {
        for (text, value) in [
            (" 300 (012Ch) ", "300"),
            ("255 (0FFh, -1)", "255"),
            ("-1", "-1"),
            ("'a (b)'", "'a (b)'"),
            ("(TABLE+1)", "(TABLE+1)"),
        ] {
            assert_eq!(typed(text), value);
        }
    }
}
