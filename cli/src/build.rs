//! `technol build`: image and listing, and nothing at all when nothing changed.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use technol_analysis::build::{Built, sources_hash};
use technol_image::container::encode_program;

use crate::arguments::BuildArguments;
use crate::check;
use crate::exit::{self, Failure, Outcome};
use crate::files::Project;
use crate::out::say;
use crate::paint::Paint;

/// Builds the project. Exit 1 when it has errors.
pub(crate) fn build(arguments: &BuildArguments) -> Outcome {
    let project = Project::open(&arguments.path)?;
    let out = arguments.out.clone().unwrap_or_else(|| project.folder().join("out"));
    let name = project.name();
    let outputs = Outputs::new(&out, &name);
    let stamp = stamp(&project);
    let complete = outputs.image.exists() && (!arguments.listing || outputs.listing.exists());
    let unchanged = std::fs::read_to_string(&outputs.stamp).is_ok_and(|old| old == stamp);
    if !arguments.force && complete && unchanged && is_image(&outputs.image) {
        say!("{name}: up to date ({})", outputs.image.display());
        return Ok(exit::OK);
    }
    let built = image(&project)?;
    std::fs::create_dir_all(&out)
        .map_err(|e| Failure::usage(format!("{}: {e}; name another folder with --out", out.display())))?;
    write(&outputs.image, &technol_image::encode(&built.image))?;
    if arguments.listing {
        let listing =
            project.analysis.listing(&built).map_err(|_| Failure::usage("the listing was interrupted"))?;
        write(&outputs.listing, listing.as_bytes())?;
    }
    write(&outputs.stamp, stamp.as_bytes())?;
    report(&built, &outputs, arguments.listing);
    Ok(exit::OK)
}

/// Where the results go.
struct Outputs {
    image: PathBuf,
    listing: PathBuf,
    /// What the image was built from.
    stamp: PathBuf,
}

impl Outputs {
    fn new(out: &Path, name: &str) -> Outputs {
        let file = |end: &str| out.join(format!("{name}.{end}"));
        Outputs { image: file("tplc"), listing: file("LS1"), stamp: file("stamp") }
    }
}

/// The image of a project, or its errors, printed.
pub(crate) fn image(project: &Project) -> Result<Built, Failure> {
    let built = project.analysis.build().map_err(|_| Failure::usage("the build was interrupted"))?;
    built.map_err(|problems| {
        let paint = Paint::stderr();
        for (file, diagnostic) in &problems {
            eprintln!("{}", check::human(project, file, diagnostic, paint));
        }
        let plural = if problems.len() == 1 { "" } else { "s" };
        Failure { code: exit::ERRORS, message: format!("not built: {} error{plural}", problems.len()) }
    })
}

/// Identifies everything the image depends on.
fn stamp(project: &Project) -> String {
    let loaded = &project.loaded;
    let files = loaded.files.iter().chain(&loaded.included);
    let files = files.map(|f| (f.path.as_str(), f.order, &*f.text));
    let hash = sources_hash(&loaded.manifest.name, loaded.manifest.debug_everywhere, files);
    format!("{}\n", hex(&hash))
}

/// Bytes as hexadecimal digits.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a string does not fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

fn is_image(path: &Path) -> bool {
    std::fs::read(path).is_ok_and(|bytes| technol_image::decode(&bytes).is_ok())
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    std::fs::write(path, bytes)
        .map_err(|e| Failure::usage(format!("{}: {e}; name another folder with --out", path.display())))
}

fn report(built: &Built, outputs: &Outputs, listing: bool) {
    let program = &built.image.program;
    let hash = hex(&built.hash[..4]);
    say!(
        "{}: {} operations, {} bytes to download, hash {hash}…",
        outputs.image.display(),
        program.code.len(),
        encode_program(program).len()
    );
    if listing {
        say!("{}", outputs.listing.display());
    }
}
