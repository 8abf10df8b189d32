//! A hash over everything a build depends on: equal hashes mean that a build would change nothing.

use technol_image::container::{FORMAT_VERSION, hash_bytes};
use technol_image::program::ContentHash;

/// Hash of compiler version, image format, project settings that reach the image, and all texts.
///
/// `files` are path, place in execution order (`None` for included files) and text, in the order of the project.
#[must_use]
pub fn sources_hash<'a>(
    name: &str,
    debug_everywhere: bool,
    files: impl IntoIterator<Item = (&'a str, Option<u8>, &'a str)>,
) -> ContentHash {
    let mut bytes = Vec::new();
    // Lengths keep `("ab","c")` and `("a","bc")` apart.
    let mut field = |content: &[u8]| {
        bytes.extend_from_slice(&(content.len() as u64).to_le_bytes());
        bytes.extend_from_slice(content);
    };
    field(env!("CARGO_PKG_VERSION").as_bytes());
    field(&FORMAT_VERSION.to_le_bytes());
    field(name.as_bytes());
    field(&[u8::from(debug_everywhere)]);
    for (path, order, text) in files {
        field(path.as_bytes());
        field(&order.map_or(0, |n| u16::from(n) + 1).to_le_bytes());
        field(text.as_bytes());
    }
    hash_bytes(&bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_reaches_the_image_changes_the_hash() {
        let files = [("main.plc", Some(0), "DATA"), ("c.inc", None, "EQUI A,1")];
        let base = sources_hash("p", true, files);
        assert_eq!(base, sources_hash("p", true, files));
        let mut others = vec![
            sources_hash("q", true, files),
            sources_hash("p", false, files),
            sources_hash("p", true, files.into_iter().rev()),
            sources_hash("p", true, [("main.plc", Some(0), "DATAE"), ("c.inc", None, "QUI A,1")]),
            sources_hash("p", true, [("main.plc", Some(0), "DATA"), ("c.inc", Some(0), "EQUI A,1")]),
        ];
        others.sort_unstable();
        others.dedup();
        assert_eq!(others.len(), 5);
        assert!(!others.contains(&base));
    }
}
