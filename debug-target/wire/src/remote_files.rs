//! Messages about files at the target: requests and answers of the control class. The bytes of a file that is put
//! there travel as a download.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::message::ContentHash;

/// Something about a file or folder. Paths are relative to the folder that the target offers, with `/` between
/// names; an empty path is that folder itself.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FileRequest {
    /// Entries of a folder, by name, from the `from`-th on; answered with [`FileAnswer::Entries`].
    List {
        /// The folder.
        path: String,
        /// How many are known already.
        from: u32,
    },
    /// A piece of a file; answered with [`FileAnswer::Bytes`].
    Read {
        /// The file.
        path: String,
        /// Where the piece begins.
        offset: u64,
        /// Most bytes of it; the answer may bring fewer, and brings none only at the end.
        len: u16,
    },
    /// Length and hash of a file; answered with [`FileAnswer::Sum`].
    Sum {
        /// The file.
        path: String,
    },
    /// What was announced with `Download` and has arrived becomes this file, in place of an old one.
    Store {
        /// The file.
        path: String,
    },
    /// Copies a file to a place where nothing is.
    Copy {
        /// The file.
        from: String,
        /// The new one.
        to: String,
    },
    /// Moves a file or folder to a place where nothing is.
    Move {
        /// What.
        from: String,
        /// Where to.
        to: String,
    },
    /// Deletes a file or an empty folder.
    Delete {
        /// What.
        path: String,
    },
    /// Makes a folder.
    MakeFolder {
        /// The folder.
        path: String,
    },
}

/// Answer to a [`FileRequest`] that asks for something; the others are answered with `Done`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FileAnswer {
    /// To [`FileRequest::List`].
    Entries {
        /// Some entries, in order.
        entries: Vec<Entry>,
        /// There are more behind them.
        more: bool,
    },
    /// To [`FileRequest::Read`].
    Bytes {
        /// The piece.
        bytes: Vec<u8>,
        /// Length of the whole file.
        size: u64,
    },
    /// To [`FileRequest::Sum`].
    Sum {
        /// Length of the file.
        size: u64,
        /// First 16 bytes of its SHA-256.
        hash: ContentHash,
    },
}

/// One entry of a folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Entry {
    /// Its name, without the folder.
    pub name: String,
    /// A folder, else a file.
    pub folder: bool,
    /// Bytes; 0 for a folder.
    pub size: u64,
    /// Last change, in seconds since 1970; 0 when not known.
    pub modified: u64,
}
