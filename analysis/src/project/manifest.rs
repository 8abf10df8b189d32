//! `technol.toml`.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::{Encoding, MAX_FILES};
use crate::diagnostics::rules::project as rules;
use crate::diagnostics::{Rule, Severity, rule};

/// Content of a manifest; what is missing or wrong has its default.
#[derive(Clone, Debug, PartialEq)]
pub struct Manifest {
    /// `[project] name`; the folder's or file's name when absent.
    pub name: String,
    /// `[project] main`: the main file.
    pub main: Spanned,
    /// `[project] files`: further files in order of execution.
    pub files: Vec<Spanned>,
    /// `[project] include-dirs`: folders for T_INCLUDE, after the folder of the main file.
    pub include_dirs: Vec<Spanned>,
    /// `[project] system-dir`: folder for T_INCLUDE in apostrophes.
    pub system_dir: Option<Spanned>,
    /// `[project] configuration`: configuration files, or folders with some; `None`: those beside the program files.
    pub configuration: Option<Vec<Spanned>>,
    /// `[project] encoding`.
    pub encoding: EncodingChoice,
    /// `[machine] file`: the simulated machine.
    pub machine: Option<Spanned>,
    /// `[target] address`: `embedded`, `tcp:HOST:PORT` or `serial:DEVICE[@BAUD]`.
    pub target: String,
    /// `[debug] everywhere`: every line takes break-points.
    pub debug_everywhere: bool,
    /// `[lints]`: severities by code; `None` is off.
    pub lints: BTreeMap<&'static str, Option<Severity>>,
}

/// A text of the manifest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spanned {
    /// The text.
    pub text: String,
    /// Byte range in the manifest; empty for defaults.
    pub span: Range<usize>,
}

/// `encoding`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EncodingChoice {
    /// Found out for each file.
    #[default]
    Auto,
    /// This one.
    Fixed(Encoding),
}

/// A mistake in a manifest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ManifestError {
    /// Byte range in the manifest.
    pub range: Range<usize>,
    /// Rule it breaks.
    pub rule: &'static Rule,
    /// What is wrong and what to do.
    pub message: String,
}

impl Default for Manifest {
    fn default() -> Self {
        Manifest {
            name: String::new(),
            main: Spanned { text: "main.plc".to_string(), span: 0..0 },
            files: Vec::new(),
            include_dirs: Vec::new(),
            system_dir: None,
            configuration: None,
            encoding: EncodingChoice::Auto,
            machine: None,
            target: "embedded".to_string(),
            debug_everywhere: true,
            lints: BTreeMap::new(),
        }
    }
}

/// Reads a manifest. What can be read is; every mistake has its place.
#[must_use]
pub fn parse_manifest(text: &str) -> (Manifest, Vec<ManifestError>) {
    let (document, errors) = DeTable::parse_recoverable(text);
    let mut reader = Reader { manifest: Manifest::default(), errors: Vec::new() };
    for error in errors.iter().take(1) {
        let range = error.span().unwrap_or(0..0);
        reader.error(&rules::MANIFEST_SYNTAX, range, format!("no valid TOML: {}", error.message().trim()));
    }
    for (key, value) in document.get_ref() {
        let name = key.get_ref().as_ref();
        let DeValue::Table(table) = value.get_ref() else {
            let known = ["project", "machine", "target", "debug", "lints"].contains(&name);
            let message = if known {
                format!("{name} must be a table: [{name}]")
            } else {
                unknown_key(name, "", TABLES)
            };
            let rule = if known { &rules::WRONG_VALUE } else { &rules::UNKNOWN_KEY };
            reader.error(rule, if known { value.span() } else { key.span() }, message);
            continue;
        };
        for (key, value) in table {
            let entry = Entry {
                key: key.get_ref().as_ref(),
                key_span: key.span(),
                value: value.get_ref(),
                span: value.span(),
            };
            match name {
                "project" => reader.project(&entry),
                "machine" => reader.machine(&entry),
                "target" => reader.target(&entry),
                "debug" => reader.debug(&entry),
                "lints" => reader.lint(&entry),
                _ => {}
            }
        }
        if !TABLES.contains(&name) {
            reader.error(&rules::UNKNOWN_KEY, key.span(), unknown_key(name, "", TABLES));
        }
    }
    // Behind a syntax error keys land in the wrong tables: only the error itself is certain.
    if !errors.is_empty() {
        reader.errors.truncate(1);
    }
    reader.errors.sort_by_key(|error| error.range.start);
    (reader.manifest, reader.errors)
}

const TABLES: &[&str] = &["project", "machine", "target", "debug", "lints"];
const PROJECT: &[&str] =
    &["name", "main", "files", "include-dirs", "system-dir", "configuration", "encoding"];

fn unknown_key(key: &str, table: &str, known: &[&str]) -> String {
    let near = crate::semantics::suggest::nearest(key, known.iter().copied());
    let here = if table.is_empty() { String::new() } else { format!(" in [{table}]") };
    match near {
        Some(near) => format!("{key} means nothing{here}; did you mean {near}?"),
        None => format!("{key} means nothing{here}; known are {}", known.join(", ")),
    }
}

struct Entry<'a> {
    key: &'a str,
    key_span: Range<usize>,
    value: &'a DeValue<'a>,
    span: Range<usize>,
}

struct Reader {
    manifest: Manifest,
    errors: Vec<ManifestError>,
}

impl Reader {
    fn error(&mut self, rule: &'static Rule, range: Range<usize>, message: String) {
        self.errors.push(ManifestError { range, rule, message });
    }

    fn project(&mut self, entry: &Entry<'_>) {
        match entry.key {
            "name" => {
                if let Some(name) = self.text(entry) {
                    self.manifest.name = name.text;
                }
            }
            "main" => {
                if let Some(main) = self.text(entry) {
                    self.manifest.main = main;
                }
            }
            "files" => {
                let files = self.texts(entry);
                if let Some(first) = files.get(MAX_FILES - 1) {
                    let message = format!(
                        "{} further files are listed, a program has at most {}",
                        files.len(),
                        MAX_FILES - 1
                    );
                    self.error(&rules::TOO_MANY_FILES, first.span.clone(), message);
                }
                self.manifest.files = files;
                self.manifest.files.truncate(MAX_FILES - 1);
            }
            "include-dirs" => self.manifest.include_dirs = self.texts(entry),
            "system-dir" => self.manifest.system_dir = self.text(entry),
            "configuration" => self.manifest.configuration = Some(self.texts(entry)),
            "encoding" => self.encoding(entry),
            other => {
                self.error(
                    &rules::UNKNOWN_KEY,
                    entry.key_span.clone(),
                    unknown_key(other, "project", PROJECT),
                );
            }
        }
    }

    fn encoding(&mut self, entry: &Entry<'_>) {
        let Some(name) = self.text(entry) else { return };
        self.manifest.encoding = match name.text.to_ascii_lowercase().as_str() {
            "auto" => EncodingChoice::Auto,
            "utf-8" => EncodingChoice::Fixed(Encoding::Utf8),
            "windows-1250" => EncodingChoice::Fixed(Encoding::Windows1250),
            "cp852" => EncodingChoice::Fixed(Encoding::Cp852),
            _ => {
                let message = format!(
                    "{} is no encoding known here; use auto, utf-8, windows-1250 or cp852",
                    name.text
                );
                self.error(&rules::WRONG_VALUE, name.span, message);
                return;
            }
        };
    }

    fn machine(&mut self, entry: &Entry<'_>) {
        if entry.key == "file" {
            self.manifest.machine = self.text(entry);
        } else {
            self.error(
                &rules::UNKNOWN_KEY,
                entry.key_span.clone(),
                unknown_key(entry.key, "machine", &["file"]),
            );
        }
    }

    fn target(&mut self, entry: &Entry<'_>) {
        if entry.key != "address" {
            self.error(
                &rules::UNKNOWN_KEY,
                entry.key_span.clone(),
                unknown_key(entry.key, "target", &["address"]),
            );
            return;
        }
        let Some(address) = self.text(entry) else { return };
        if is_address(&address.text) {
            self.manifest.target = address.text;
        } else {
            let message =
                format!("{} is no target; use embedded, tcp:HOST:PORT or serial:DEVICE[@BAUD]", address.text);
            self.error(&rules::WRONG_VALUE, address.span, message);
        }
    }

    fn debug(&mut self, entry: &Entry<'_>) {
        match (entry.key, entry.value) {
            ("everywhere", DeValue::Boolean(value)) => self.manifest.debug_everywhere = *value,
            ("everywhere", _) => {
                self.error(
                    &rules::WRONG_VALUE,
                    entry.span.clone(),
                    "everywhere must be true or false".to_string(),
                );
            }
            (other, _) => {
                let message = unknown_key(other, "debug", &["everywhere"]);
                self.error(&rules::UNKNOWN_KEY, entry.key_span.clone(), message);
            }
        }
    }

    fn lint(&mut self, entry: &Entry<'_>) {
        let Some(found) = rule(entry.key) else {
            let message = format!("{} is no code of a rule; codes look like T0202", entry.key);
            self.error(&rules::UNKNOWN_LINT, entry.key_span.clone(), message);
            return;
        };
        let Some(level) = self.text(entry) else { return };
        let severity = match level.text.as_str() {
            "off" => None,
            "hint" => Some(Severity::Hint),
            "warning" => Some(Severity::Warning),
            "error" => Some(Severity::Error),
            other => {
                let message = format!("{other} is no severity; use off, hint, warning or error");
                self.error(&rules::WRONG_VALUE, level.span, message);
                return;
            }
        };
        if found.fixed && severity != Some(Severity::Error) {
            let message =
                format!("{} is an error that no program can be built with; it stays one", found.code);
            self.error(&rules::UNKNOWN_LINT, level.span, message);
            return;
        }
        self.manifest.lints.insert(found.code, severity);
    }

    fn text(&mut self, entry: &Entry<'_>) -> Option<Spanned> {
        match entry.value {
            DeValue::String(text) if !text.is_empty() => {
                Some(Spanned { text: text.to_string(), span: entry.span.clone() })
            }
            _ => {
                let message = format!("{} must be a text in double quotes", entry.key);
                self.error(&rules::WRONG_VALUE, entry.span.clone(), message);
                None
            }
        }
    }

    fn texts(&mut self, entry: &Entry<'_>) -> Vec<Spanned> {
        let DeValue::Array(items) = entry.value else {
            let message = format!("{} must be a list of texts: [\"a\", \"b\"]", entry.key);
            self.error(&rules::WRONG_VALUE, entry.span.clone(), message);
            return Vec::new();
        };
        let mut texts = Vec::new();
        for item in items {
            let entry = Entry {
                key: entry.key,
                key_span: entry.key_span.clone(),
                value: item.get_ref(),
                span: item.span(),
            };
            texts.extend(self.text(&entry));
        }
        texts
    }
}

fn is_address(text: &str) -> bool {
    if text == "embedded" {
        return true;
    }
    if let Some(rest) = text.strip_prefix("tcp:") {
        return rest
            .rsplit_once(':')
            .is_some_and(|(host, port)| !host.is_empty() && port.parse::<u16>().is_ok());
    }
    let Some(rest) = text.strip_prefix("serial:") else { return false };
    match rest.rsplit_once('@') {
        Some((device, baud)) => !device.is_empty() && baud.parse::<u32>().is_ok_and(|baud| baud > 0),
        None => !rest.is_empty(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn errors(text: &str) -> Vec<(&'static str, String)> {
        let (_, errors) = parse_manifest(text);
        errors.into_iter().map(|e| (e.rule.code, text[e.range].to_string())).collect()
    }

    #[test]
    fn every_key_is_read() {
        let text = r#"
            [project]
            name = "lathe"
            main = "src/main.plc"
            files = ["a.plc", "b.plc"]
            include-dirs = ["lib"]
            system-dir = "system"
            configuration = ["config/Channel0.ChannelConfig"]
            encoding = "cp852"
            [machine]
            file = "machine.toml"
            [target]
            address = "serial:/dev/ttyS0@115200"
            [debug]
            everywhere = false
            [lints]
            T0202 = "off"
            T0504 = "error"
        "#;
        let (manifest, errors) = parse_manifest(text);
        assert_eq!(errors, []);
        assert_eq!((manifest.name.as_str(), manifest.main.text.as_str()), ("lathe", "src/main.plc"));
        assert_eq!(manifest.files.iter().map(|f| f.text.as_str()).collect::<Vec<_>>(), ["a.plc", "b.plc"]);
        assert_eq!(&text[manifest.files[1].span.clone()], "\"b.plc\"");
        assert_eq!(manifest.include_dirs[0].text, "lib");
        assert_eq!(manifest.system_dir.as_ref().map(|d| d.text.as_str()), Some("system"));
        let configuration = manifest.configuration.iter().flatten().map(|file| file.text.as_str());
        assert_eq!(configuration.collect::<Vec<_>>(), ["config/Channel0.ChannelConfig"]);
        assert_eq!(manifest.encoding, EncodingChoice::Fixed(Encoding::Cp852));
        assert_eq!(manifest.machine.as_ref().map(|m| m.text.as_str()), Some("machine.toml"));
        assert_eq!(
            (manifest.target.as_str(), manifest.debug_everywhere),
            ("serial:/dev/ttyS0@115200", false)
        );
        assert_eq!(manifest.lints.get("T0202"), Some(&None));
        assert_eq!(manifest.lints.get("T0504"), Some(&Some(Severity::Error)));
    }

    #[test]
    fn each_mistake_has_its_code_and_place() {
        assert_eq!(errors("[project]\nmian = \"a\""), [("T0002", "mian".to_string())]);
        assert_eq!(errors("[projekt]\nmain = \"a\""), [("T0002", "projekt".to_string())]);
        assert_eq!(errors("colour = 1"), [("T0002", "colour".to_string())]);
        assert_eq!(errors("[project]\nfiles = \"a\""), [("T0003", "\"a\"".to_string())]);
        assert_eq!(errors("[project]\nfiles = [1]"), [("T0003", "1".to_string())]);
        assert_eq!(errors("[project]\nencoding = \"latin2\""), [("T0003", "\"latin2\"".to_string())]);
        assert_eq!(errors("[target]\naddress = \"tcp:host\""), [("T0003", "\"tcp:host\"".to_string())]);
        assert_eq!(errors("[debug]\neverywhere = 1"), [("T0003", "1".to_string())]);
        assert_eq!(errors("[lints]\nT9999 = \"off\""), [("T0008", "T9999".to_string())]);
        assert_eq!(errors("[lints]\nT0301 = \"off\""), [("T0008", "\"off\"".to_string())]);
        assert_eq!(errors("[lints]\nT0202 = \"loud\""), [("T0003", "\"loud\"".to_string())]);
        assert_eq!(errors("project = 1"), [("T0003", "1".to_string())]);
        assert_eq!(errors("[project\nname = \"a\"").iter().map(|e| e.0).collect::<Vec<_>>(), ["T0001"]);
    }

    #[test]
    fn the_64th_further_file_is_one_too_many() {
        let list = |n: usize| {
            let names: Vec<_> = (0..n).map(|i| format!("\"f{i}.plc\"")).collect();
            format!("[project]\nfiles = [{}]", names.join(", "))
        };
        assert_eq!(errors(&list(63)), []);
        assert_eq!(errors(&list(64)), [("T0005", "\"f63.plc\"".to_string())]);
    }
}
