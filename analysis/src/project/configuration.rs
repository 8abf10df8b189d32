//! Finds and reads the configuration files of a project.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::load::{Loader, problem, undecodable};
use super::manifest::Spanned;
use super::path::{folder, is_absolute, project_path, readable, slashes};
use super::{Encoding, LoadedFile};
use crate::configuration::{ConfigKind, decode};
use crate::diagnostics::rules::project as rules;
use crate::location::Span;

/// Most configuration files of a project; what is named beyond them is not read.
const MOST_FILES: usize = 1_000;

/// Reads what the manifest names, else what lies beside the program files.
pub(super) fn find(loader: &mut Loader<'_>) {
    match loader.project.manifest.configuration.clone() {
        Some(entries) => {
            for entry in entries {
                named(loader, &entry);
            }
        }
        None => beside(loader),
    }
}

fn named(loader: &mut Loader<'_>, entry: &Spanned) {
    let path = project_path(&loader.project.root, &slashes(&entry.text));
    if is_absolute(&path) || path.starts_with("../") {
        let message = format!("{} lies outside the project folder; move it into the folder", entry.text);
        loader.manifest_problem(&rules::OUTSIDE_FILE, entry, message);
        return;
    }
    if ConfigKind::of_path(&path).is_some() {
        if loader.project.configuration.iter().any(|file| file.path == path) {
            let message = format!("{} is listed twice; remove one entry", entry.text);
            loader.manifest_problem(&rules::DUPLICATE_FILE, entry, message);
        } else if let Err(why) = read(loader, &path) {
            let message = format!("{} cannot be read: {why}", entry.text);
            loader.manifest_problem(&rules::MISSING_FILE, entry, message);
        }
        return;
    }
    if !listed(loader, &path) {
        let known: Vec<&str> = ConfigKind::ALL.iter().map(|kind| kind.extensions()[0]).collect();
        let message =
            format!("{} is no folder with configuration files (*.{})", entry.text, known.join(", *."));
        loader.manifest_problem(&rules::MISSING_FILE, entry, message);
    }
}

fn beside(loader: &mut Loader<'_>) {
    let folders: BTreeSet<String> =
        loader.project.files.iter().map(|file| folder(&file.path).to_string()).collect();
    for folder in folders {
        listed(loader, &folder);
    }
}

/// Reads the configuration files of a folder in order of their names; returns whether it has some.
fn listed(loader: &mut Loader<'_>, folder: &str) -> bool {
    let place =
        if folder.is_empty() { loader.project.root.clone() } else { readable(&loader.project.root, folder) };
    let mut names: Vec<String> =
        loader.reader.list(&place).into_iter().filter(|name| ConfigKind::of_path(name).is_some()).collect();
    names.sort();
    for name in &names {
        let path = if folder.is_empty() { name.clone() } else { format!("{folder}/{name}") };
        if loader.project.configuration.iter().any(|file| file.path == path) {
            continue;
        }
        if let Err(why) = read(loader, &path) {
            let message = format!("{path} cannot be read: {why}");
            loader.project.problems.push((path, problem(&rules::MISSING_FILE, Span::default(), message)));
        }
    }
    !names.is_empty()
}

fn read(loader: &mut Loader<'_>, path: &str) -> Result<(), String> {
    if loader.project.configuration.len() >= MOST_FILES {
        return Err(format!("a project has at most {MOST_FILES} configuration files"));
    }
    let bytes = loader.reader.read(&readable(&loader.project.root, path))?;
    let decoded = decode(&bytes, loader.encoding());
    if let Some((at, why)) = decoded.problem {
        let span = undecodable(&decoded.text, at);
        let message = format!("{why}; state the file's encoding in its first line");
        loader.project.problems.push((path.to_string(), problem(&rules::UNDECODABLE, span, message)));
    }
    let encoding: Encoding = decoded.encoding;
    let file = LoadedFile { path: path.to_string(), text: Arc::from(decoded.text), encoding, order: None };
    loader.project.configuration.push(file);
    Ok(())
}
