//! Values as text, both ways.

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
    if digits.starts_with(|c: char| c.is_ascii_alphabetic()) { format!("0{digits}h") } else { format!("{digits}h") }
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
    let shown: String = bytes[..end].iter().map(|b| if b.is_ascii_control() { '·' } else { char::from(*b) }).collect();
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

/// Reads a bit: `1`, `0`, `true`, `false`.
pub(crate) fn parse_bit(text: &str) -> Result<bool, String> {
    match text.trim().to_ascii_lowercase().as_str() {
        "1" | "true" => Ok(true),
        "0" | "false" => Ok(false),
        other => Err(format!("`{other}` is no bit; write 0 or 1")),
    }
}

/// Reads a number for a cell of that width: its bytes, little-endian in the low part.
pub(crate) fn parse_cell(text: &str, width: Width) -> Result<u64, String> {
    let text = text.trim();
    if width == Width::Real {
        let value = text.parse::<f64>().ok().or_else(|| integer(text).map(|n| n as f64));
        return value.map(f64::to_bits).ok_or_else(|| format!("`{text}` is no number"));
    }
    let value = integer(text).ok_or_else(|| {
        format!("`{text}` is no number; write decimal, hexadecimal (0FFh), binary (101b) or a character ('A')")
    })?;
    let (low, high) = (-(1_i128 << (width.bits() - 1)), (1_i128 << width.bits()) - 1);
    if value < low || value > high {
        return Err(format!("{text} does not fit into {}: {low} to {high}", type_name(width)));
    }
    Ok(value as u64 & mask(width))
}

/// Reads a text, with or without apostrophes, for a buffer of `len` characters: its bytes and a zero.
pub(crate) fn parse_text(text: &str, len: u32) -> Result<Vec<u8>, String> {
    let text = text.trim();
    let inner = text.strip_prefix('\'').and_then(|t| t.strip_suffix('\'')).map(|t| t.replace("''", "'"));
    let chars = inner.unwrap_or_else(|| text.to_owned());
    let mut bytes = Vec::new();
    for c in chars.chars() {
        bytes.push(u8::try_from(u32::from(c)).map_err(|_| format!("`{c}` is not available on the control"))?);
    }
    if bytes.len() > len as usize {
        return Err(format!("{} characters do not fit into {len}", bytes.len()));
    }
    bytes.push(0);
    Ok(bytes)
}

/// The language's integers, and `0x…` of other languages. What a value shows (`300 (012Ch)`) is taken back as well.
fn integer(text: &str) -> Option<i128> {
    let text = text.split_once(" (").map_or(text, |(first, _)| first);
    if text.eq_ignore_ascii_case("true") || text.eq_ignore_ascii_case("false") {
        return Some(i128::from(text.eq_ignore_ascii_case("true")));
    }
    if let Some(inner) = text.strip_prefix('\'').and_then(|t| t.strip_suffix('\'')) {
        let mut chars = inner.chars();
        return chars.next().filter(|c| (*c as u32) < 256 && chars.next().is_none()).map(|c| i128::from(c as u32));
    }
    let (negative, digits) = match text.as_bytes().first()? {
        b'-' => (true, &text[1..]),
        b'+' => (false, &text[1..]),
        _ => (false, text),
    };
    let digits = digits.trim_start().to_ascii_lowercase();
    if !digits.starts_with(|c: char| c.is_ascii_digit()) || digits.len() > 80 {
        return None;
    }
    let (digits, radix) = if let Some(hex) = digits.strip_prefix("0x").or_else(|| digits.strip_suffix('h')) {
        (hex, 16)
    } else if let Some(binary) = digits.strip_suffix('b') {
        (binary, 2)
    } else {
        (digits.strip_suffix('d').unwrap_or(&digits), 10)
    };
    let value = i128::from(u64::from_str_radix(digits, radix).ok()?);
    Some(if negative { -value } else { value })
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
    fn values_are_read_as_the_language_writes_them() {
        for (text, width, raw) in [
            ("300", Width::Word, 300),
            ("-1", Width::Word, 0xFFFF),
            ("0FFh", Width::Byte, 0xFF),
            ("0xff", Width::Byte, 0xFF),
            ("101b", Width::Byte, 5),
            ("12d", Width::Byte, 12),
            ("'A'", Width::Byte, 65),
            ("300 (012Ch)", Width::Word, 300),
            ("true", Width::Byte, 1),
            ("18446744073709551615", Width::QWord, u64::MAX),
            ("2.5", Width::Real, 2.5_f64.to_bits()),
            ("10h", Width::Real, 16_f64.to_bits()),
        ] {
            assert_eq!(parse_cell(text, width), Ok(raw), "{text}");
        }
    }

    #[test]
    fn wrong_values_say_what_would_be_right() {
        for (text, width, message) in [
            ("256", Width::Byte, "256 does not fit into BYTE: -128 to 255"),
            ("-129", Width::Byte, "-129 does not fit into BYTE: -128 to 255"),
            (
                "FFh",
                Width::Byte,
                "`FFh` is no number; write decimal, hexadecimal (0FFh), binary (101b) or a character ('A')",
            ),
            ("x", Width::Real, "`x` is no number"),
        ] {
            assert_eq!(parse_cell(text, width), Err(message.to_owned()));
        }
        assert_eq!(parse_bit("2"), Err("`2` is no bit; write 0 or 1".into()));
        assert_eq!(parse_bit(" TRUE "), Ok(true));
    }

    #[test]
    fn texts_fit_their_buffer() {
        assert_eq!(parse_text("'it''s'", 8), Ok(b"it's\0".to_vec()));
        assert_eq!(parse_text("ok", 2), Ok(b"ok\0".to_vec()));
        assert_eq!(parse_text("'abc'", 2), Err("3 characters do not fit into 2".into()));
        assert_eq!(parse_text("€", 8), Err("`€` is not available on the control".into()));
    }

    #[test]
    fn what_is_shown_can_be_typed_back() {
        for raw in [0, 1, 127, 128, 255] {
            assert_eq!(parse_cell(&cell(raw, Width::Byte, false), Width::Byte), Ok(raw));
            assert_eq!(parse_cell(&cell(raw, Width::Byte, true), Width::Byte), Ok(raw));
        }
    }
}
