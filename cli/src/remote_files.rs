//! `technol files`: files at a target.

use std::path::Path;

use technol_target::replace;
use technol_wire::message::{Entry, FileAnswer, FileRequest, Request, Response, feature};

use crate::arguments::{FilesArguments, FilesCommand};
use crate::exit::{self, Failure, Outcome};
use crate::out::say;
use crate::remote::Remote;

/// Lists, gets, puts, copies, moves and deletes.
pub(crate) fn files(arguments: &FilesArguments) -> Outcome {
    let mut remote = Remote::connect(&arguments.target, arguments.token_file.as_deref())?;
    if !remote.can(feature::FILES) {
        return Err(Failure::usage(
            "the target offers no files; start it with `technol target --files DIR …`",
        ));
    }
    match &arguments.command {
        FilesCommand::Ls { path } => list(&mut remote, path)?,
        FilesCommand::Get { from, to } => get(&mut remote, from, to.as_deref())?,
        FilesCommand::Put { from, to } => put(&mut remote, from, to.as_deref())?,
        FilesCommand::Cp { from, to } => {
            done(&mut remote, FileRequest::Copy { from: from.clone(), to: to.clone() })?;
        }
        FilesCommand::Mv { from, to } => {
            done(&mut remote, FileRequest::Move { from: from.clone(), to: to.clone() })?;
        }
        FilesCommand::Rm { path } => done(&mut remote, FileRequest::Delete { path: path.clone() })?,
        FilesCommand::Mkdir { path } => done(&mut remote, FileRequest::MakeFolder { path: path.clone() })?,
    }
    Ok(exit::OK)
}

fn done(remote: &mut Remote, request: FileRequest) -> Result<(), Failure> {
    remote.ask(Request::Files(request)).map(|_| ())
}

fn list(remote: &mut Remote, path: &str) -> Result<(), Failure> {
    let mut from = 0;
    loop {
        let request = FileRequest::List { path: path.to_owned(), from };
        let Response::Files(FileAnswer::Entries { entries, more }) = remote.ask(Request::Files(request))?
        else {
            return Err(unexpected());
        };
        from += entries.len() as u32;
        for entry in &entries {
            say!("{}", line(entry));
        }
        if !more || entries.is_empty() {
            return Ok(());
        }
    }
}

/// Size and name; a folder has a `/` behind its name.
fn line(entry: &Entry) -> String {
    if entry.folder {
        format!("{:>12}  {}/", "", entry.name)
    } else {
        format!("{:>12}  {}", entry.size, entry.name)
    }
}

fn get(remote: &mut Remote, from: &str, to: Option<&Path>) -> Result<(), Failure> {
    let name = from.rsplit('/').next().unwrap_or(from);
    let to = to.map_or_else(
        || Path::new(name).to_path_buf(),
        |to| if to.is_dir() { to.join(name) } else { to.into() },
    );
    let Response::Files(FileAnswer::Sum { size, hash }) =
        remote.ask(Request::Files(FileRequest::Sum { path: from.to_owned() }))?
    else {
        return Err(unexpected());
    };
    let mut bytes = Vec::new();
    while (bytes.len() as u64) < size {
        let offset = bytes.len() as u64;
        let request = FileRequest::Read { path: from.to_owned(), offset, len: remote.most() };
        let Response::Files(FileAnswer::Bytes { bytes: piece, .. }) = remote.ask(Request::Files(request))?
        else {
            return Err(unexpected());
        };
        if piece.is_empty() {
            break; // it has become shorter, which the sum will tell
        }
        bytes.extend(piece);
    }
    if technol_image::container::hash_bytes(&bytes) != hash {
        return Err(Failure::usage(format!("`{from}` changed while it was read; try again")));
    }
    replace(&to, &bytes).map_err(|e| Failure::usage(format!("{}: {e}", to.display())))
}

fn put(remote: &mut Remote, from: &Path, to: Option<&str>) -> Result<(), Failure> {
    let bytes = std::fs::read(from).map_err(|e| Failure::usage(format!("{}: {e}", from.display())))?;
    let name = from.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let path = match to {
        None => name,
        Some(folder) if folder.ends_with('/') => format!("{folder}{name}"),
        Some(path) => path.to_owned(),
    };
    let len = u32::try_from(bytes.len()).map_err(|_| {
        Failure::usage(format!("{}: a file of more than 4 GB cannot be sent", from.display()))
    })?;
    let hash = technol_image::container::hash_bytes(&bytes);
    remote.ask(Request::Download { len, hash })?;
    remote.download(bytes)?;
    done(remote, FileRequest::Store { path })
}

fn unexpected() -> Failure {
    Failure::usage("the target gave an answer that does not fit the question; it is of another version")
}
