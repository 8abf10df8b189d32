//! Projects written in one text, for tests.
//!
//! `//- path` starts a file, `<CURSOR>` marks the position. Without a `technol.toml` of its own the project has
//! the `.plc` files in order of the text; a text without `//-` is `main.plc`.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::project::{FileReader, load};
use crate::{Analysis, AnalysisHost, Change, Location, Position};

const MARK: &str = "<CURSOR>";

/// A loaded project and the marked position.
pub(super) struct Fixture {
    pub(super) analysis: Analysis,
    pub(super) file: String,
    pub(super) at: Position,
    files: BTreeMap<String, String>,
}

struct Memory<'a>(&'a BTreeMap<String, String>);

impl FileReader for Memory<'_> {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let found = self.0.get(path.trim_start_matches('/'));
        found.map(|text| text.clone().into_bytes()).ok_or_else(|| format!("{path} is not in the fixture"))
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let folder = folder.trim_matches('/');
        let inside = |path: &String| {
            let (at, name) = path.rsplit_once('/').unwrap_or(("", path));
            (at == folder).then(|| name.to_owned())
        };
        self.0.keys().filter_map(inside).collect()
    }
}

/// Loads a fixture.
pub(super) fn fixture(text: &str) -> Fixture {
    let mut files = BTreeMap::new();
    let mut order = Vec::new();
    let mut path = "main.plc";
    for line in text.split_inclusive('\n') {
        if let Some(name) = line.strip_prefix("//- ") {
            path = name.trim();
        } else {
            if !files.contains_key(path) {
                order.push(path);
            }
            files.entry(path.to_owned()).or_insert_with(String::new).push_str(line);
        }
    }
    let mut marked = (order[0].to_owned(), Position::default());
    for (path, text) in &mut files {
        if let Some(offset) = text.find(MARK) {
            marked = (path.clone(), Position::of_byte(text, offset));
            *text = text.replacen(MARK, "", 1);
            assert!(!text.contains(MARK), "one cursor is enough");
        }
    }
    files.entry("technol.toml".to_owned()).or_insert_with(|| manifest(&order));
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load("/", &Memory(&files))), texts: Vec::new() });
    Fixture { analysis: host.analysis(), file: marked.0, at: marked.1, files }
}

fn manifest(order: &[&str]) -> String {
    let mut programs =
        order.iter().filter(|path| path.rsplit_once('.').is_some_and(|(_, ending)| ending == "plc"));
    let mut text = String::from("[project]\nname = \"fixture\"\n");
    let main = programs.next().expect("a program file");
    let rest: Vec<_> = programs.collect();
    writeln!(text, "main = {main:?}\nfiles = {rest:?}").expect("a String takes it");
    text
}

impl Fixture {
    /// A location as `path:line  the line with «the span» marked`.
    pub(super) fn show(&self, location: &Location) -> String {
        let line = location.span.start.line as usize;
        let text = self.files[&location.file].lines().nth(line).unwrap_or_default();
        let (start, end) = (location.span.start.column as usize, location.span.end.column as usize);
        let marked = format!("{}«{}»{}", &text[..start], &text[start..end], &text[end..]);
        format!("{}:{} {}\n", location.file, line + 1, marked.trim())
    }
}
