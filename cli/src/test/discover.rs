//! Which project, and which scenario files.

use std::fs;
use std::path::{Path, PathBuf};

use crate::exit::Failure;

/// How names of scenario files end.
const ENDING: &str = ".test.toml";
/// Folder of a project that is searched beside the project folder itself.
const TESTS: &str = "tests";

/// What a path on the command line stands for.
pub(super) struct Found {
    /// To be opened as a project.
    pub(super) project: PathBuf,
    /// A single scenario file.
    pub(super) only: Option<PathBuf>,
}

/// Finds the project of a path: of a scenario file the nearest folder above that is one.
pub(super) fn project_of(path: &Path) -> Result<Found, Failure> {
    if !is_scenario(path) {
        return Ok(Found { project: path.to_owned(), only: None });
    }
    if !path.is_file() {
        return Err(Failure::usage(format!("{}: no such file", path.display())));
    }
    let only = Some(path.to_owned());
    let beside = path.file_name().and_then(|name| name.to_str()).and_then(|name| name.strip_suffix(ENDING));
    let beside = beside.map(|stem| path.with_file_name(format!("{stem}.plc")));
    // What stands above a relative path is known to the file system only.
    let whole = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let above = whole.ancestors().skip(1).position(|folder| folder.join("technol.toml").is_file());
    if let Some(levels) = above {
        let near =
            path.ancestors().skip(1).nth(levels).filter(|folder| folder.join("technol.toml").is_file());
        let project = near.or_else(|| whole.ancestors().skip(1).nth(levels)).unwrap_or(path);
        let project = if project.as_os_str().is_empty() { Path::new(".") } else { project };
        return Ok(Found { project: project.to_owned(), only });
    }
    match beside.filter(|program| program.is_file()) {
        Some(project) => Ok(Found { project, only }),
        None => Err(Failure::usage(format!(
            "{}: there is no technol.toml above it and no program of the same name beside it",
            path.display()
        ))),
    }
}

/// Scenario files of a project, by name: in its folder and in `tests`. A lone program `x.plc` has only `x.test.toml`.
pub(super) fn scenarios(folder: &Path, lone: Option<&str>) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for place in [folder.to_owned(), folder.join(TESTS)] {
        // A relative project folder may be the current one, which has no name.
        let read = if place.as_os_str().is_empty() { Path::new(".") } else { place.as_path() };
        // No such folder: no files.
        let Ok(entries) = fs::read_dir(read) else { continue };
        let mut here: Vec<PathBuf> = entries
            .filter_map(|entry| Some(entry.ok()?.file_name()))
            .filter(|name| is_scenario(Path::new(name)))
            .filter(|name| lone.is_none_or(|stem| name.to_str() == Some(&format!("{stem}{ENDING}"))))
            .map(|name| place.join(name))
            .filter(|path| path.is_file())
            .collect();
        here.sort();
        found.extend(here);
    }
    found
}

/// Name of a scenario file without its ending.
pub(super) fn stem(file: &str) -> &str {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.strip_suffix(ENDING).unwrap_or(name)
}

fn is_scenario(path: &Path) -> bool {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    name.ends_with(ENDING)
}
