//! `technol fmt`: converts source files to another encoding, and nothing else in them.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use technol_analysis::project::{Encoding, EncodingChoice, LoadedFile, decode, encode};
use technol_dap::Disk;

use crate::arguments::{EncodingName, FmtArguments};
use crate::exit::{self, Failure, Outcome};
use crate::out::say;

/// A file to convert.
struct Source {
    path: PathBuf,
    /// What the project says about it; `None` detects.
    declared: Option<Encoding>,
}

/// A file and what it becomes.
struct Conversion {
    path: PathBuf,
    from: Encoding,
    bytes: Vec<u8>,
}

/// Converts, or tells what would change. Nothing is written unless every file can be.
pub(crate) fn fmt(arguments: &FmtArguments) -> Outcome {
    let to = encoding(arguments.encoding);
    let from = arguments.from.map(encoding);
    let mut sources = Vec::new();
    let mut manifests = Vec::new();
    for path in &arguments.paths {
        if is_project(path) {
            let (files, manifest) = of_project(path)?;
            sources.extend(files);
            manifests.extend(manifest);
        } else {
            sources.push(Source { path: path.clone(), declared: None });
        }
    }
    let mut conversions = Vec::new();
    for source in &sources {
        conversions.extend(convert(source, from, to)?);
    }
    let mut renamed = Vec::new();
    for manifest in manifests.iter().filter(|manifest| manifest.wants(to)) {
        renamed.push((manifest, manifest.with(to)?));
    }
    let changed = conversions.len() + renamed.len();
    for conversion in &conversions {
        say!("{}: {} -> {}", conversion.path.display(), conversion.from.name(), to.name());
        if !arguments.check {
            replace(&conversion.path, &conversion.bytes)?;
        }
    }
    for (manifest, text) in &renamed {
        say!("{}: encoding = \"{}\"", manifest.path.display(), to.name());
        if !arguments.check {
            replace(&manifest.path, text.as_bytes())?;
        }
    }
    if changed == 0 {
        let count = sources.len();
        say!("{count} {} in {} already", if count == 1 { "file" } else { "files" }, to.name());
    }
    Ok(if arguments.check && changed > 0 { exit::ERRORS } else { exit::OK })
}

const fn encoding(name: EncodingName) -> Encoding {
    match name {
        EncodingName::Utf8 => Encoding::Utf8,
        EncodingName::Windows1250 => Encoding::Windows1250,
        EncodingName::Cp852 => Encoding::Cp852,
    }
}

fn is_project(path: &Path) -> bool {
    path.is_dir() || path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"))
}

/// The sources and configuration files of a project that lie in its folder, and its manifest when that names an encoding.
fn of_project(path: &Path) -> Result<(Vec<Source>, Option<Manifest>), Failure> {
    let loaded = technol_analysis::project::load(&path.to_string_lossy(), &Disk);
    let Some((manifest, text)) = &loaded.manifest_file else {
        return Err(Failure::usage(format!(
            "{}: there is no technol.toml; name a project folder or source files",
            path.display()
        )));
    };
    let declared = match loaded.manifest.encoding {
        EncodingChoice::Auto => None,
        EncodingChoice::Fixed(encoding) => Some(encoding),
    };
    let root = Path::new(&loaded.root);
    let inside = |path: &str| !(path.starts_with("../") || Path::new(path).is_absolute());
    let source = |file: &LoadedFile, declared| {
        inside(&file.path).then(|| Source { path: root.join(&file.path), declared })
    };
    let programs = loaded.files.iter().chain(&loaded.included).filter_map(|file| source(file, declared));
    // A configuration file says itself how it is written.
    let configuration = loaded.configuration.iter().filter_map(|file| source(file, None));
    let sources = programs.chain(configuration).collect();
    let manifest =
        declared.map(|encoding| Manifest { path: root.join(manifest), text: text.to_string(), encoding });
    Ok((sources, manifest))
}

/// What a file becomes; `None` when it is so already.
fn convert(source: &Source, from: Option<Encoding>, to: Encoding) -> Result<Option<Conversion>, Failure> {
    let path = &source.path;
    let bytes = fs::read(path)
        .map_err(|cause| Failure::usage(format!("{}: cannot be read: {cause}", path.display())))?;
    let read = decode(&bytes, from.or(source.declared));
    if let Some((at, why)) = read.problem {
        let line = bytes.iter().take(at).filter(|byte| **byte == b'\n').count() + 1;
        return Err(Failure::usage(format!(
            "{}:{line}: {why}; nothing was written; name the encoding it has with --from",
            path.display()
        )));
    }
    let text = if is_xml(path) { declare(&read.text, to) } else { read.text.clone() };
    let written = encode(&text, to).map_err(|missing| {
        let line = text.get(..missing.offset).map_or(0, |head| head.matches('\n').count()) + 1;
        Failure::usage(format!(
            "{}:{line}: {} has no character `{}`; nothing was written",
            path.display(),
            to.name(),
            missing.character
        ))
    })?;
    if written == bytes {
        return Ok(None);
    }
    Ok(Some(Conversion { path: path.clone(), from: read.encoding, bytes: written }))
}

fn is_xml(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    ["ChannelConfig", "PlcErrors", "PlcConstants", "PlcTDef", "PlcT", "KbdConfig", "xml"]
        .iter()
        .any(|known| known.eq_ignore_ascii_case(ending))
}

/// The text with the encoding its XML declaration should name.
fn declare(text: &str, to: Encoding) -> String {
    let Some(end) = text.find("?>").filter(|_| text.starts_with("<?xml")) else { return text.to_owned() };
    let (declaration, rest) = text.split_at(end);
    let Some(at) = declaration.find("encoding") else { return text.to_owned() };
    let (before, value) = declaration.split_at(at);
    let Some(open) = value.find(['"', '\'']) else { return text.to_owned() };
    let quote = &value[open..=open];
    let Some(len) = value[open + 1..].find(quote) else { return text.to_owned() };
    format!("{before}{}{quote}{}{}{rest}", &value[..open], to.name(), &value[open + 1 + len..])
}

/// A manifest that names the encoding of its sources.
struct Manifest {
    path: PathBuf,
    text: String,
    encoding: Encoding,
}

impl Manifest {
    fn wants(&self, to: Encoding) -> bool {
        self.encoding.name() != to.name()
    }

    /// The manifest's text with another encoding; all else stays byte for byte.
    fn with(&self, to: Encoding) -> Result<String, Failure> {
        let mut out = String::with_capacity(self.text.len());
        let mut replaced = false;
        for line in self.text.split_inclusive('\n') {
            let key = line.trim_start().strip_prefix("encoding").map(str::trim_start);
            let value = key.and_then(|rest| rest.strip_prefix('=')).map(str::trim_start);
            match value.and_then(quoted) {
                Some(value) if !replaced => {
                    let at = value.as_ptr() as usize - line.as_ptr() as usize;
                    out.push_str(&line[..at]);
                    out.push_str(to.name());
                    out.push_str(&line[at + value.len()..]);
                    replaced = true;
                }
                _ => out.push_str(line),
            }
        }
        if replaced {
            return Ok(out);
        }
        Err(Failure::usage(format!(
            "{}: its `encoding` could not be found on a line of its own; nothing was written; write \
             `encoding = \"{}\"` there",
            self.path.display(),
            self.encoding.name()
        )))
    }
}

/// What stands between the quotes a value begins with.
fn quoted(value: &str) -> Option<&str> {
    let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    value[1..].split(quote).next()
}

/// Writes a file so that either the old or the new content is there, whatever happens.
fn replace(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".technol-new");
    let beside = path.with_file_name(name);
    let write = || -> std::io::Result<()> {
        let mut file = fs::File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::set_permissions(&beside, fs::metadata(path)?.permissions())?;
        fs::rename(&beside, path)
    };
    write().map_err(|cause| {
        // The half-written copy is of no use to anyone.
        let _ = fs::remove_file(&beside);
        Failure::usage(format!("{}: cannot be written: {cause}", path.display()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_xml_declaration_names_the_new_encoding() {
        let text = "<?xml version=\"1.0\" encoding='windows-1250'?>\n<A b=\"encoding\"/>\n";
        assert_eq!(declare(text, Encoding::Utf8), text.replace("windows-1250", "utf-8"));
        for same in
            ["<A/>", "<?xml version=\"1.0\"?><A encoding=\"x\"/>", "<?xml encoding=", "<?xml encoding='x ?>"]
        {
            assert_eq!(declare(same, Encoding::Utf8), same);
        }
    }

    #[test]
    fn only_the_value_in_the_manifest_changes() {
        let manifest = |text: &str| Manifest {
            path: PathBuf::from("technol.toml"),
            text: text.to_owned(),
            encoding: Encoding::Cp852,
        };
        let text =
            "[project]\nname = \"encoding\"\n  encoding= 'cp852' # as on the machine\nmain = \"a.plc\"\n";
        let changed = manifest(text).with(Encoding::Utf8).expect("it is there");
        assert_eq!(changed, text.replace("cp852", "utf-8"));
        assert!(manifest("[project]\n").with(Encoding::Utf8).is_err());
    }
}
