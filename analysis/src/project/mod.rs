//! The project: manifest, file set, include graph, encodings.
//!
//! Nothing here touches a disk: a [`FileReader`] does, and it belongs to the caller.

mod configuration;
mod encoding;
mod include;
mod load;
mod manifest;
mod path;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::diagnostics::{Diagnostic, Severity};

pub use encoding::{Decoded, Encoding, Unencodable, decode, encode};
pub use include::{IncludeTarget, include_names};
pub use load::{discover, load};
pub use manifest::{EncodingChoice, Manifest, ManifestError, Spanned, parse_manifest};

/// Name of the manifest.
pub const MANIFEST: &str = "technol.toml";
/// Most program files of a project, the main file included (manual 5.4).
pub const MAX_FILES: usize = 64;

/// Reads files for [`load`].
pub trait FileReader {
    /// The content of the file at a `/`-separated path: the root handed to [`load`] joined with a project path.
    ///
    /// # Errors
    /// Why it cannot be read, in words.
    fn read(&self, path: &str) -> Result<Vec<u8>, String>;

    /// Names of the files in the folder at a `/`-separated path (empty: the current one), in any order. A reader that
    /// cannot tell answers with none; then configuration files are found only where the manifest names them.
    fn list(&self, folder: &str) -> Vec<String> {
        let _ = folder;
        Vec::new()
    }
}

/// A project as read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadedProject {
    /// Folder that project paths are relative to; empty for the current one.
    pub root: String,
    /// Project path and text of the manifest; `None` for a lone file.
    pub manifest_file: Option<(String, Arc<str>)>,
    /// Its content, or the defaults.
    pub manifest: Manifest,
    /// Program files in order of execution.
    pub files: Vec<LoadedFile>,
    /// Included files in order of their first inclusion.
    pub included: Vec<LoadedFile>,
    /// Configuration files, in order of the manifest, else of their names.
    pub configuration: Vec<LoadedFile>,
    /// Where each T_INCLUDE leads: (path of the including file, spelled name).
    pub includes: BTreeMap<(String, String), IncludeTarget>,
    /// Mistakes in the manifest and in the set of files: project path, mistake.
    pub problems: Vec<(String, Diagnostic)>,
}

/// A file as read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadedFile {
    /// Project path.
    pub path: String,
    /// Content.
    pub text: Arc<str>,
    /// Encoding it was read with, to write it back.
    pub encoding: Encoding,
    /// 0-based place in the order of execution; `None` for an included file.
    pub order: Option<u8>,
}

/// What the analysis needs of the manifest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Name of the project.
    pub name: String,
    /// Every line takes break-points.
    pub debug_everywhere: bool,
    /// The manifest lists the configuration files: their order is that of the tables.
    pub configuration_listed: bool,
    /// Severities by code; `None` is off.
    pub lints: BTreeMap<&'static str, Option<Severity>>,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            name: String::new(),
            debug_everywhere: true,
            configuration_listed: false,
            lints: BTreeMap::new(),
        }
    }
}

impl LoadedProject {
    /// What the analysis needs of the manifest.
    #[must_use]
    pub fn settings(&self) -> Settings {
        Settings {
            name: self.manifest.name.clone(),
            debug_everywhere: self.manifest.debug_everywhere,
            configuration_listed: self.manifest.configuration.is_some(),
            lints: self.manifest.lints.clone(),
        }
    }
}
