//! `technol build`: image and listing, and nothing at all when nothing changed.

use std::fmt::Write as _;

use technol_analysis::Built;
use technol_dap::KeptImage;
use technol_image::container::encode_program;

use crate::arguments::BuildArguments;
use crate::check;
use crate::exit::{self, Failure, Outcome};
use crate::files::Project;
use crate::out::say;
use crate::paint::Paint;

/// Builds the project. Exit 1 when it has errors; those of configuration files are shown and hinder nothing.
pub(crate) fn build(arguments: &BuildArguments) -> Outcome {
    let project = Project::open(&arguments.path)?;
    configuration_errors(&project)?;
    let out = arguments.out.clone().unwrap_or_else(|| project.folder().join("out"));
    let name = project.name();
    let kept = KeptImage::new(&out, &name);
    let complete = kept.read().is_ok() && (!arguments.listing || kept.listing().exists());
    if !arguments.force && complete && kept.is_current(&project.analysis) {
        say!("{name}: up to date ({})", kept.path().display());
        return Ok(exit::OK);
    }
    let built = image(&project)?;
    let unusable = |e| Failure::usage(format!("{}: {e}; name another folder with --out", out.display()));
    kept.write(&built.image, &project.analysis).map_err(unusable)?;
    if arguments.listing {
        let listing =
            project.analysis.listing(&built).map_err(|_| Failure::usage("the listing was interrupted"))?;
        std::fs::write(kept.listing(), listing).map_err(unusable)?;
    }
    report(&built, &kept, arguments.listing);
    Ok(exit::OK)
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

/// Prints what is wrong in configuration files: the image is made without them, but the control needs them.
pub(crate) fn configuration_errors(project: &Project) -> Result<(), Failure> {
    let interrupted = |_| Failure::usage("the build was interrupted");
    let paint = Paint::stderr();
    for (file, diagnostic) in project.analysis.configuration_errors().map_err(interrupted)? {
        eprintln!("{}", check::human(project, &file, &diagnostic, paint));
    }
    Ok(())
}

/// Bytes as hexadecimal digits.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a string does not fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

fn report(built: &Built, kept: &KeptImage, listing: bool) {
    let program = &built.image.program;
    let hash = hex(&built.hash[..4]);
    say!(
        "{}: {} operations, {} bytes to download, hash {hash}…",
        kept.path().display(),
        program.code.len(),
        encode_program(program).len()
    );
    if listing {
        say!("{}", kept.listing().display());
    }
}
