//! An image on disk and the stamp beside it that tells what it was built from: what makes a second build do nothing.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use technol_analysis::Analysis;
use technol_image::{Image, decode, encode};

/// `NAME.tplc` and `NAME.stamp` in a folder, and the listing `NAME.LS1` when one was asked for.
#[derive(Clone, Debug)]
pub struct KeptImage {
    image: PathBuf,
    stamp: PathBuf,
    listing: PathBuf,
}

impl KeptImage {
    /// The image of a project in its output folder; nothing has to be there yet.
    #[must_use]
    pub fn new(folder: &Path, name: &str) -> Self {
        let file = |end: &str| folder.join(format!("{name}.{end}"));
        KeptImage { image: file("tplc"), stamp: file("stamp"), listing: file("LS1") }
    }

    /// Path of the image.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.image
    }

    /// Path of the listing.
    #[must_use]
    pub fn listing(&self) -> &Path {
        &self.listing
    }

    /// The image was built from these sources and settings.
    #[must_use]
    pub fn is_current(&self, analysis: &Analysis) -> bool {
        let kept = fs::read_to_string(&self.stamp).ok();
        kept.is_some_and(|text| Some(text.trim()) == stamp(analysis).as_deref())
    }

    /// The image, if it can be debugged with; the error says why not.
    pub fn read(&self) -> Result<Image, String> {
        let bytes = fs::read(&self.image).map_err(|error| error.to_string())?;
        let image = decode(&bytes).map_err(|error| error.to_string())?;
        if image.debug.is_none() {
            return Err("it has no debug information".into());
        }
        Ok(image)
    }

    /// Replaces the image. The stamp goes first and comes back last: it never vouches for another image. A listing
    /// of the image before goes too.
    pub fn write(&self, image: &Image, analysis: &Analysis) -> io::Result<()> {
        if let Some(folder) = self.image.parent() {
            fs::create_dir_all(folder)?;
        }
        for old in [&self.stamp, &self.listing] {
            match fs::remove_file(old) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
        }
        let unfinished = self.image.with_extension("tplc.new");
        fs::write(&unfinished, encode(image))?;
        fs::rename(&unfinished, &self.image)?;
        stamp(analysis).map_or(Ok(()), |stamp| fs::write(&self.stamp, format!("{stamp}\n")))
    }
}

/// Identifies everything an image depends on.
fn stamp(analysis: &Analysis) -> Option<String> {
    let hash = analysis.sources_hash().ok()?;
    Some(hash.iter().map(|byte| format!("{byte:02x}")).collect::<Vec<_>>().concat())
}
