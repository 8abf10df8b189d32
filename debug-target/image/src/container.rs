//! The image file: `TPLC`, format version, program, debug information, CRC-32C.
//!
//! ```text
//! 0   4  magic "TPLC"
//! 4   2  format version, little endian
//! 6   4  length of the encoded program, little endian
//! 10  4  length of the encoded debug information, little endian (0 = none)
//! 14  n  program, postcard
//!     m  debug information, postcard
//!     4  CRC-32C of all before it, little endian
//! ```

use alloc::vec::Vec;
use core::fmt;

use crc::{CRC_32_ISCSI, Crc};
use sha2::{Digest, Sha256};

use crate::debug_info::DebugInfo;
use crate::program::{ContentHash, Program};

/// First bytes of an image file.
pub const MAGIC: [u8; 4] = *b"TPLC";
/// Version of the format, of the operations and of the system layout.
pub const FORMAT_VERSION: u16 = 2;

const CRC32C: Crc<u32> = Crc::<u32>::new(&CRC_32_ISCSI);
const HEADER: usize = 14;

/// A program with its debug information (empty when it was stripped).
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Executable part.
    pub program: Program,
    /// Debug part; `None` when stripped.
    pub debug: Option<DebugInfo>,
}

/// Why bytes are not an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DecodeError {
    /// Shorter than its header says.
    Truncated,
    /// Does not start with `TPLC`.
    NotAnImage,
    /// Written by another version of the compiler.
    Version {
        /// Version found.
        found: u16,
    },
    /// The checksum does not fit: damaged on disk or in transfer.
    Checksum,
    /// The checksum fits but the content does not decode.
    Malformed,
    /// The debug information belongs to another program.
    ForeignDebugInfo,
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DecodeError::Truncated => write!(f, "the image is cut short; build it again"),
            DecodeError::NotAnImage => write!(f, "not a TECHNOL image (it does not start with `TPLC`)"),
            DecodeError::Version { found } => write!(
                f,
                "image format {found} cannot be read by this version, which needs format {FORMAT_VERSION}; build it again"
            ),
            DecodeError::Checksum => write!(f, "the image is damaged (checksum); build it again"),
            DecodeError::Malformed => write!(f, "the image content cannot be decoded; build it again"),
            DecodeError::ForeignDebugInfo => {
                write!(f, "the debug information belongs to another program; build it again")
            }
        }
    }
}

impl core::error::Error for DecodeError {}

/// Content hash of a program.
#[must_use]
pub fn content_hash(program: &Program) -> ContentHash {
    hash_bytes(&encode_program(program))
}

/// First 16 bytes of the SHA-256 of `bytes`.
#[must_use]
pub fn hash_bytes(bytes: &[u8]) -> ContentHash {
    let digest = Sha256::digest(bytes);
    let mut hash = [0; 16];
    hash.copy_from_slice(&digest[..16]);
    hash
}

/// The program alone, as downloaded to a target.
#[must_use]
pub fn encode_program(program: &Program) -> Vec<u8> {
    // Serialising plain data into a growing vector has no way to fail.
    postcard::to_allocvec(program).unwrap_or_default()
}

/// Reads a program as downloaded. The runtime still has to validate it.
pub fn decode_program(bytes: &[u8]) -> Result<Program, DecodeError> {
    match postcard::take_from_bytes(bytes) {
        Ok((program, [])) => Ok(program),
        _ => Err(DecodeError::Malformed),
    }
}

/// Bytes of an image file.
#[must_use]
pub fn encode(image: &Image) -> Vec<u8> {
    let program = encode_program(&image.program);
    let debug = image.debug.as_ref().and_then(|d| postcard::to_allocvec(d).ok()).unwrap_or_default();
    let mut out = Vec::with_capacity(HEADER + program.len() + debug.len() + 4);
    out.extend_from_slice(&MAGIC);
    out.extend_from_slice(&FORMAT_VERSION.to_le_bytes());
    out.extend_from_slice(&(program.len() as u32).to_le_bytes());
    out.extend_from_slice(&(debug.len() as u32).to_le_bytes());
    out.extend_from_slice(&program);
    out.extend_from_slice(&debug);
    let crc = CRC32C.checksum(&out);
    out.extend_from_slice(&crc.to_le_bytes());
    out
}

/// Reads an image file.
pub fn decode(bytes: &[u8]) -> Result<Image, DecodeError> {
    if bytes.len() < 4 || bytes[..4] != MAGIC {
        return Err(DecodeError::NotAnImage);
    }
    let word =
        |at: usize| -> Option<u32> { Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?)) };
    let version = bytes.get(4..6).map(|b| u16::from_le_bytes([b[0], b[1]])).ok_or(DecodeError::Truncated)?;
    if version != FORMAT_VERSION {
        return Err(DecodeError::Version { found: version });
    }
    let program_len = word(6).ok_or(DecodeError::Truncated)? as usize;
    let debug_len = word(10).ok_or(DecodeError::Truncated)? as usize;
    let body = HEADER
        .checked_add(program_len)
        .and_then(|n| n.checked_add(debug_len))
        .ok_or(DecodeError::Truncated)?;
    let crc = body.checked_add(4).filter(|end| *end <= bytes.len()).and_then(|_| word(body));
    let crc = crc.ok_or(DecodeError::Truncated)?;
    if bytes.len() != body + 4 || CRC32C.checksum(&bytes[..body]) != crc {
        return Err(DecodeError::Checksum);
    }
    let program_bytes = &bytes[HEADER..HEADER + program_len];
    let program = decode_program(program_bytes)?;
    let debug = if debug_len == 0 {
        None
    } else {
        let debug: DebugInfo =
            postcard::from_bytes(&bytes[HEADER + program_len..body]).map_err(|_| DecodeError::Malformed)?;
        if debug.program != hash_bytes(program_bytes) {
            return Err(DecodeError::ForeignDebugInfo);
        }
        Some(debug)
    };
    Ok(Image { program, debug })
}
