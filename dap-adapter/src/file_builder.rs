//! Builds projects from files, and keeps the image beside them as `technol build` does.

use std::fs;
use std::path::{Path, PathBuf};

use technol_analysis::project::{EncodingChoice, FileReader, LoadedProject, discover, load};
use technol_analysis::{AnalysisHost, Change, Diagnostic, Severity};
use technol_image::Image;

use crate::arguments::Policy;
use crate::kept_image::KeptImage;
use crate::project::{BuildFailure, Builder, BuiltProject, Problem};

/// Builds projects on disk. The image goes to `out/NAME.tplc` in the project folder, with `out/NAME.stamp` beside
/// it that tells what it was built from.
#[derive(Clone, Copy, Debug, Default)]
pub struct FileBuilder;

/// Reads files from disk.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl FileReader for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        fs::read(path).map_err(|error| error.to_string())
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let folder = if folder.is_empty() { "." } else { folder };
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let files = entries.filter(|entry| entry.file_type().is_ok_and(|kind| !kind.is_dir()));
        // A name that is no Unicode cannot be a project path.
        files.filter_map(|entry| entry.file_name().into_string().ok()).collect()
    }
}

impl Builder for FileBuilder {
    fn build(&self, program: &Path, policy: Policy) -> Result<BuiltProject, BuildFailure> {
        let loaded = find(program)?;
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(loaded.clone()), texts: Vec::new() });
        let analysis = host.analysis();
        let root = PathBuf::from(&loaded.root);
        let kept = KeptImage::new(&root.join("out"), &loaded.manifest.name);
        if policy == Policy::Never {
            let missing = |reason| BuildFailure::NoImage { path: kept.path().to_owned(), reason };
            let image = kept.read().map_err(missing)?;
            let current = kept.is_current(&analysis);
            let stale = if current { "" } else { "; the sources have changed since it was built" };
            let summary = format!("{}: {}{stale}", loaded.manifest.name, kept.path().display());
            return Ok(project(&loaded, root, image, summary, Vec::new()));
        }
        let interrupted = |_| BuildFailure::NoProject {
            program: program.to_owned(),
            reason: "the build was interrupted; try again".into(),
        };
        let problem = |(file, diagnostic): &(String, Diagnostic)| locate(&root, file, diagnostic);
        let configuration_errors: Vec<Problem> =
            analysis.configuration_errors().map_err(interrupted)?.iter().map(problem).collect();
        let unchanged = policy == Policy::IfStale && kept.is_current(&analysis);
        if let Some(image) = unchanged.then(|| kept.read().ok()).flatten() {
            let summary = format!("{} is up to date", loaded.manifest.name);
            let project = project(&loaded, root, image, summary, Vec::new());
            return Ok(BuiltProject { configuration_errors, ..project });
        }
        let built = match analysis.build().map_err(interrupted)? {
            Ok(built) => built,
            Err(errors) if errors.is_empty() => {
                let reason = "it holds no program".into();
                return Err(BuildFailure::NoProject { program: program.to_owned(), reason });
            }
            Err(errors) => return Err(BuildFailure::Errors(errors.iter().map(problem).collect())),
        };
        let mut warnings = Vec::new();
        for (file, found) in analysis.all_diagnostics().map_err(interrupted)? {
            let found = found.iter().filter(|d| d.severity == Severity::Warning);
            warnings.extend(found.map(|d| locate(&root, &file, d)));
        }
        let summary = match kept.write(&built.image, &analysis) {
            Ok(()) => format!("{} is built", loaded.manifest.name),
            // It can be debugged all the same; only the next start will build again.
            Err(error) => {
                format!("{} is built, but not kept: {}: {error}", loaded.manifest.name, kept.path().display())
            }
        };
        let project = project(&loaded, root, built.image, summary, warnings);
        Ok(BuiltProject { configuration_errors, ..project })
    }
}

/// Reads the project at a folder, a manifest, or that a source file belongs to.
fn find(program: &Path) -> Result<LoadedProject, BuildFailure> {
    let no_project = |reason: String| BuildFailure::NoProject { program: program.to_owned(), reason };
    let absolute = std::path::absolute(program).map_err(|error| no_project(error.to_string()))?;
    let metadata = fs::metadata(&absolute).map_err(|error| no_project(error.to_string()))?;
    let text = absolute.to_string_lossy();
    let is_source = metadata.is_file()
        && absolute
            .extension()
            .is_some_and(|end| end.eq_ignore_ascii_case("plc") || end.eq_ignore_ascii_case("inc"));
    Ok(if is_source { load(&discover(&text, &Disk), &Disk) } else { load(&text, &Disk) })
}

fn project(
    loaded: &LoadedProject,
    root: PathBuf,
    image: Image,
    summary: String,
    warnings: Vec<Problem>,
) -> BuiltProject {
    let manifest = &loaded.manifest;
    BuiltProject {
        machine: manifest.machine.as_ref().map(|machine| root.join(&machine.text)),
        target: Some(manifest.target.clone()),
        break_everywhere: manifest.debug_everywhere,
        encoding: match manifest.encoding {
            EncodingChoice::Auto => None,
            EncodingChoice::Fixed(encoding) => Some(encoding),
        },
        root,
        image,
        summary,
        warnings,
        configuration_errors: Vec::new(),
    }
}

fn locate(root: &Path, file: &str, diagnostic: &Diagnostic) -> Problem {
    Problem {
        file: root.join(file),
        line: diagnostic.span.start.line + 1,
        column: diagnostic.span.start.column + 1,
        code: diagnostic.code.to_owned(),
        message: diagnostic.message.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tempfile::TempDir;

    /// The smallest project: all mandatory modules, nothing in them.
    const MINIMAL: &str = "\
DATA
LAMPS:  DFM L0,L1,,,,,,
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
MODULE_MAIN
        LDR L1
        WR  L0
MODULE_MAIN_END
MODULE_INIT
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
";

    fn folder(manifest: &str, source: &str) -> TempDir {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join("technol.toml"), manifest).unwrap();
        fs::write(folder.path().join("main.plc"), source).unwrap();
        folder
    }

    const MANIFEST: &str =
        "[project]\nname = \"tiny\"\n[machine]\nfile = \"m.toml\"\n[target]\naddress = \"tcp:plc:5000\"\n";

    #[test]
    fn a_project_is_built_once_and_then_up_to_date() {
        let folder = folder(MANIFEST, MINIMAL);
        let build = |policy| FileBuilder.build(folder.path(), policy);
        assert!(matches!(build(Policy::Never), Err(BuildFailure::NoImage { .. })));
        let first = build(Policy::IfStale).unwrap();
        assert_eq!(first.summary, "tiny is built");
        assert_eq!(first.machine, Some(first.root.join("m.toml")));
        assert_eq!(first.target.as_deref(), Some("tcp:plc:5000"));
        assert!(first.break_everywhere);
        let second = build(Policy::IfStale).unwrap();
        assert_eq!((second.summary.as_str(), &second.image), ("tiny is up to date", &first.image));
        assert_eq!(build(Policy::Always).unwrap().summary, "tiny is built");
        fs::write(folder.path().join("main.plc"), MINIMAL.replace("LDR L1", "LDR L0")).unwrap();
        assert!(
            build(Policy::Never).unwrap().summary.ends_with("the sources have changed since it was built")
        );
        let third = build(Policy::IfStale).unwrap();
        assert_eq!(third.summary, "tiny is built");
        assert_ne!(third.image.program, first.image.program);
    }

    #[test]
    fn errors_in_configuration_files_are_told_at_every_start_and_hinder_none() {
        let folder = folder(MANIFEST, MINIMAL);
        fs::write(folder.path().join("a.PlcErrors"), "<PlcErrors>\n").unwrap();
        for summary in ["tiny is built", "tiny is up to date"] {
            let built = FileBuilder.build(folder.path(), Policy::IfStale).unwrap();
            let told: Vec<_> = built.configuration_errors.iter().map(|it| it.code.as_str()).collect();
            assert_eq!((built.summary.as_str(), told), (summary, vec!["T0901"]));
        }
    }

    #[test]
    fn a_damaged_image_is_built_again_or_named() {
        let folder = folder(MANIFEST, MINIMAL);
        FileBuilder.build(folder.path(), Policy::IfStale).unwrap();
        let image = folder.path().join("out/tiny.tplc");
        let mut bytes = fs::read(&image).unwrap();
        bytes[20] ^= 1;
        fs::write(&image, bytes).unwrap();
        let error = FileBuilder.build(folder.path(), Policy::Never).unwrap_err().to_string();
        assert!(error.contains("the image is damaged (checksum)"), "{error}");
        assert_eq!(FileBuilder.build(folder.path(), Policy::IfStale).unwrap().summary, "tiny is built");
    }

    #[test]
    fn any_part_of_a_project_leads_to_it() {
        let folder = folder(MANIFEST, MINIMAL);
        for part in ["", "technol.toml", "main.plc"] {
            let built = FileBuilder.build(&folder.path().join(part), Policy::IfStale).unwrap();
            assert_eq!(built.image.program.name, "tiny", "{part}");
            assert_eq!(built.root, folder.path(), "{part}");
        }
    }

    #[test]
    fn errors_carry_their_places() {
        let folder = folder(MANIFEST, &MINIMAL.replace("WR  L0", "WR  L9"));
        let Err(BuildFailure::Errors(errors)) = FileBuilder.build(folder.path(), Policy::IfStale) else {
            panic!()
        };
        assert_eq!(errors.len(), 1, "{errors:?}");
        assert_eq!((errors[0].line, &errors[0].file), (12, &folder.path().join("main.plc")));
        assert!(errors[0].message.contains("L9"), "{errors:?}");
    }

    #[test]
    fn where_there_is_no_project_says_so() {
        let error = FileBuilder.build(Path::new("/no/such/folder"), Policy::IfStale).unwrap_err();
        assert!(matches!(error, BuildFailure::NoProject { .. }), "{error}");
        let empty = TempDir::new().unwrap();
        assert!(FileBuilder.build(empty.path(), Policy::IfStale).is_err());
    }
}
