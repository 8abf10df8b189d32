//! Encodings of source files: UTF-8, Windows-1250, CP852.
//!
//! Detection: a byte order mark decides; else valid UTF-8 is UTF-8 (plain ASCII too); else the file is
//! Windows-1250 or CP852, whichever reads more of its bytes from 80h up as letters with Czech diacritics, a small
//! letter counting twice. A draw is Windows-1250.

use std::borrow::Cow;

use encoding_rs::WINDOWS_1250;
use oem_cp::code_table::{DECODING_TABLE_CP852, ENCODING_TABLE_CP852};

/// Encoding of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8 without byte order mark.
    #[default]
    Utf8,
    /// UTF-8 with byte order mark.
    Utf8Mark,
    /// Windows-1250.
    Windows1250,
    /// CP852, DOS Latin 2.
    Cp852,
}

impl Encoding {
    /// As `technol.toml` spells it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Encoding::Utf8 | Encoding::Utf8Mark => "utf-8",
            Encoding::Windows1250 => "windows-1250",
            Encoding::Cp852 => "cp852",
        }
    }
}

/// A decoded file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// Text; undecodable bytes are U+FFFD.
    pub text: String,
    /// Encoding it was read with.
    pub encoding: Encoding,
    /// Offset of the first undecodable byte, and why.
    pub problem: Option<(usize, &'static str)>,
}

/// A character that the encoding does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unencodable {
    /// The character.
    pub character: char,
    /// Its byte offset in the text.
    pub offset: usize,
}

const MARK: &[u8] = b"\xEF\xBB\xBF";

/// Decodes a file. `declared` is what the project says; `None` detects.
#[must_use]
pub fn decode(bytes: &[u8], declared: Option<Encoding>) -> Decoded {
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        let text = String::from_utf8_lossy(bytes).into_owned();
        return Decoded {
            text,
            encoding: Encoding::Utf8,
            problem: Some((0, "the file is UTF-16; save it as UTF-8")),
        };
    }
    match declared {
        None => match std::str::from_utf8(bytes) {
            Ok(_) => decode(bytes, Some(Encoding::Utf8)),
            Err(_) if bytes.starts_with(MARK) => decode(bytes, Some(Encoding::Utf8)),
            Err(_) => decode(bytes, Some(guess(bytes))),
        },
        Some(Encoding::Utf8 | Encoding::Utf8Mark) => {
            let (body, encoding) = match bytes.strip_prefix(MARK) {
                Some(body) => (body, Encoding::Utf8Mark),
                None => (bytes, Encoding::Utf8),
            };
            let problem = std::str::from_utf8(body)
                .err()
                .map(|error| (error.valid_up_to() + bytes.len() - body.len(), "this byte is no UTF-8"));
            Decoded { text: String::from_utf8_lossy(body).into_owned(), encoding, problem }
        }
        Some(Encoding::Windows1250) => {
            // The five bytes without a character would become invisible controls.
            let undefined = |byte: &u8| matches!(byte, 0x81 | 0x83 | 0x88 | 0x90 | 0x98);
            let problem =
                bytes.iter().position(undefined).map(|at| (at, "this byte is no Windows-1250 character"));
            let text = WINDOWS_1250.decode_without_bom_handling(bytes).0;
            let text = if problem.is_some() {
                Cow::Owned(text.replace(|c: char| ('\u{80}'..='\u{9F}').contains(&c), "\u{FFFD}"))
            } else {
                text
            };
            Decoded { text: text.into_owned(), encoding: Encoding::Windows1250, problem }
        }
        Some(Encoding::Cp852) => {
            let text = oem_cp::decode_string_complete_table(bytes, &DECODING_TABLE_CP852);
            Decoded { text, encoding: Encoding::Cp852, problem: None }
        }
    }
}

/// Encodes a text.
///
/// # Errors
/// The first character that the encoding does not have.
pub fn encode(text: &str, encoding: Encoding) -> Result<Vec<u8>, Unencodable> {
    match encoding {
        Encoding::Utf8 => Ok(text.as_bytes().to_vec()),
        Encoding::Utf8Mark => Ok([MARK, text.as_bytes()].concat()),
        Encoding::Windows1250 => by_character(text, |c| {
            let mut buffer = [0; 4];
            let (bytes, _, lost) = WINDOWS_1250.encode(c.encode_utf8(&mut buffer));
            if lost { None } else { bytes.first().copied() }
        }),
        Encoding::Cp852 => by_character(text, |c| {
            if c.is_ascii() { Some(c as u8) } else { ENCODING_TABLE_CP852.get(&c).copied() }
        }),
    }
}

fn by_character(text: &str, byte_of: impl Fn(char) -> Option<u8>) -> Result<Vec<u8>, Unencodable> {
    text.char_indices()
        .map(|(offset, character)| byte_of(character).ok_or(Unencodable { character, offset }))
        .collect()
}

const SMALL: &str = "áéíóúýčďěňřšťůž";
const CAPITAL: &str = "ÁÉÍÓÚÝČĎĚŇŘŠŤŮŽ";

fn guess(bytes: &[u8]) -> Encoding {
    let score = |encoding: Encoding| -> usize {
        let small = encode(SMALL, encoding).unwrap_or_default();
        let capital = encode(CAPITAL, encoding).unwrap_or_default();
        let weight = |byte: &u8| if small.contains(byte) { 2 } else { usize::from(capital.contains(byte)) };
        bytes.iter().filter(|byte| **byte >= 0x80).map(weight).sum()
    };
    if score(Encoding::Cp852) > score(Encoding::Windows1250) {
        Encoding::Cp852
    } else {
        Encoding::Windows1250
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CZECH: &str = "; příliš žluťoučký kůň úpěl ďábelské ódy\r\nLDR VŘETENO ;ŠKODA\r\n";

    #[test]
    fn each_encoding_is_recognised_and_written_back_byte_for_byte() {
        for encoding in [Encoding::Utf8, Encoding::Utf8Mark, Encoding::Windows1250, Encoding::Cp852] {
            let bytes = encode(CZECH, encoding).expect("Czech fits all of them");
            let read = decode(&bytes, None);
            assert_eq!((read.text.as_str(), read.encoding, read.problem), (CZECH, encoding, None));
        }
    }

    #[test]
    fn plain_ascii_is_utf8() {
        assert_eq!(decode(b"LDR A\n", None).encoding, Encoding::Utf8);
        assert_eq!(decode(b"", None).text, "");
    }

    #[test]
    fn a_declared_encoding_that_does_not_fit_is_reported_at_its_byte() {
        assert_eq!(decode(b"AB\xE8", Some(Encoding::Utf8)).problem, Some((2, "this byte is no UTF-8")));
        let read = decode(b"A\x81", Some(Encoding::Windows1250));
        assert_eq!((read.text.as_str(), read.problem.map(|p| p.0)), ("A\u{FFFD}", Some(1)));
        assert!(decode(b"\xFF\xFEA\0", None).problem.is_some());
    }

    #[test]
    fn characters_an_encoding_lacks_are_named() {
        let missing = Unencodable { character: '漢', offset: 2 };
        assert_eq!(encode("A;漢", Encoding::Windows1250), Err(missing));
        assert_eq!(encode("A;漢", Encoding::Cp852), Err(missing));
    }
}
