//! Source files of the program.

use std::path::Path;

use dap::responses::{LoadedSourcesResponse, SourceResponse};
use dap::types::Source;

use technol_analysis::project::decode;

use crate::errors::RequestError;
use crate::request::Request;

use super::{Answer, Session, body};

/// How a file is named to the client.
pub(super) fn source(path: &Path) -> Source {
    Source {
        name: path.file_name().map(|n| n.to_string_lossy().into_owned()),
        path: Some(path.to_string_lossy().into_owned()),
        ..Source::default()
    }
}

impl Session {
    pub(super) fn loaded_sources(&mut self, _request: &Request) -> Answer {
        let debuggee = self.debuggee()?;
        let count = u16::try_from(debuggee.debug.files.len()).unwrap_or(u16::MAX);
        let sources = (0..count).filter_map(|n| debuggee.map.path(n)).map(source).collect();
        body(&LoadedSourcesResponse { sources })
    }

    /// The text of a file. All sources are files, so a client rarely asks.
    pub(super) fn source(&mut self, request: &Request) -> Answer {
        let debuggee = self.debuggee()?;
        let Some(path) = request.arguments["source"]["path"].as_str() else {
            return Err(RequestError::Source("sources are named by `source.path` here".into()));
        };
        let Some(path) = debuggee.map.file(path).and_then(|file| debuggee.map.path(file)) else {
            return Err(RequestError::Source(format!("{path} does not belong to the program")));
        };
        let bytes = std::fs::read(path)
            .map_err(|error| RequestError::Source(format!("{} cannot be read: {error}", path.display())))?;
        let content = decode(&bytes, debuggee.project.encoding).text;
        body(&SourceResponse { content, mime_type: None })
    }
}
