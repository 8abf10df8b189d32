//! What the tests load: written down, read back, and changed by leaving out lines.

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};

use technol_analysis::catalogue::{EntryKind, entry};
use technol_image::container::{Image, decode, encode};
use technol_image::op::Op;

use super::uses::{Uses, uses};

/// Lines, each with its program.
pub(super) type Places = BTreeSet<(String, BTreeSet<u32>)>;

/// What is known about a use.
pub(super) struct Recorded {
    /// All lines that have it.
    pub(super) places: Places,
    /// The tests that load a program with such a line.
    pub(super) tests: Vec<String>,
}

/// The folder that images and the programs of each test are written to.
pub(super) const FOLDER: &str = "TECHNOL_CHAIN_RECORD";
/// `test=use` lines: what each test leaves out.
pub(super) const WITHOUT: &str = "TECHNOL_CHAIN_WITHOUT";
/// Where a test leaves its name when its program cannot be loaded without the lines.
pub(super) const NOT_LOADED: &str = "not-loaded";

/// The image of `source`: from the folder, or else what `build` makes, which is written there.
pub(crate) fn recorded(source: &str, build: impl FnOnce() -> Image) -> Image {
    let Some(folder) = env::var_os(FOLDER).map(PathBuf::from) else { return build() };
    let mut hasher = DefaultHasher::new();
    source.hash(&mut hasher);
    let name = format!("{:016x}", hasher.finish());
    let path = folder.join(&name);
    let noted = folder.join("tests").join(file_name(&test()));
    if env::var_os(WITHOUT).is_some() {
        return decode(&fs::read(path).expect("recorded before")).expect("an image");
    }
    let image = build();
    fs::create_dir_all(&noted).expect("a folder");
    fs::write(&path, encode(&image)).expect("a file");
    fs::write(noted.join(name), source).expect("a file");
    image
}

/// The name of the running test.
fn test() -> String {
    std::thread::current().name().unwrap_or("main").to_owned()
}

/// The file that stands for a test.
pub(super) fn file_name(test: &str) -> String {
    test.replace("::", "-")
}

/// The use that the running test leaves out.
fn without() -> Option<String> {
    let test = test();
    let all = env::var(WITHOUT).ok()?;
    all.lines()
        .filter_map(|line| line.split_once('='))
        .find(|(of, _)| *of == test)
        .map(|(_, using)| using.to_owned())
}

/// Whether it matters what these lines do: always, but for a test that leaves out an instruction which they lack.
pub(crate) fn concerns(lines: &str) -> bool {
    let Some(using) = without() else { return true };
    let word = using.split(' ').next().unwrap_or_default();
    let is_instruction = entry(word).is_some_and(|entry| entry.kind == EntryKind::Instruction);
    !is_instruction || lines.contains(word)
}

/// Lets the lines with the use that is asked for do nothing.
pub(crate) fn left_out(source: &str, image: &mut Image) {
    let Some(using) = without() else { return };
    let debug = image.debug.as_ref().expect("it was built with it");
    let uses = uses(source, debug);
    let Some(lines) = uses.get(&using) else { return };
    let ends = debug.lines.iter().skip(1).map(|line| line.pc).chain([image.program.code.len() as u32]);
    for (line, end) in debug.lines.iter().zip(ends) {
        if line.file != 0 || !lines.contains(&line.line) {
            continue;
        }
        for op in &mut image.program.code[line.pc as usize..end as usize] {
            // What holds the program together stays.
            if !matches!(op, Op::SeqBegin(_) | Op::SeqEnd(_) | Op::Return | Op::ModuleEnd) {
                *op = Op::Nop;
            }
        }
    }
}

/// What was loaded. That a program cannot be loaded without its lines is noted, as it says nothing about them.
pub(crate) fn loaded<T, E: std::fmt::Display>(result: Result<T, E>) -> T {
    result.unwrap_or_else(|error| {
        if let (Some(folder), Some(_)) = (env::var_os(FOLDER), without()) {
            let noted = Path::new(&folder).join(NOT_LOADED);
            fs::create_dir_all(&noted).expect("a folder");
            fs::write(noted.join(file_name(&test())), error.to_string()).expect("a file");
        }
        panic!("{error}")
    })
}

/// For each use where it is, and the tests that have it, those with few lines in front.
pub(super) fn recorded_uses(folder: &Path) -> BTreeMap<String, Recorded> {
    let mut recorded: BTreeMap<String, (Places, BTreeSet<(usize, String)>)> = BTreeMap::new();
    let mut known: BTreeMap<String, Uses> = BTreeMap::new();
    for test in entries(&folder.join("tests")) {
        let programs = entries(&test);
        let name = test_name(&test);
        let size = programs.iter().map(|program| fs::metadata(program).expect("a file").len() as usize).sum();
        for program in programs {
            let id = name_of(&program);
            let uses = known.entry(id.clone()).or_insert_with(|| uses_of(folder, &program));
            for (using, lines) in uses {
                let (places, tests) = recorded.entry(using.clone()).or_default();
                places.insert((id.clone(), lines.clone()));
                tests.insert((size, name.clone()));
            }
        }
    }
    let names = |tests: BTreeSet<(usize, String)>| tests.into_iter().map(|(_, test)| test).collect();
    recorded
        .into_iter()
        .map(|(using, (places, tests))| (using, Recorded { places, tests: names(tests) }))
        .collect()
}

fn uses_of(folder: &Path, program: &Path) -> Uses {
    let source = fs::read_to_string(program).expect("a source text");
    let image = fs::read(folder.join(name_of(program))).expect("an image");
    let image = decode(&image).expect("an image");
    let debug = image.debug.expect("debug information");
    let with_code: BTreeSet<u32> =
        debug.lines.iter().filter(|line| line.file == 0).map(|line| line.line).collect();
    let mut uses = uses(&source, &debug);
    for lines in uses.values_mut() {
        lines.retain(|line| with_code.contains(line));
    }
    uses.retain(|_, lines| !lines.is_empty());
    uses
}

/// The test that a file stands for.
fn test_name(path: &Path) -> String {
    name_of(path).replace('-', "::")
}

fn name_of(path: &Path) -> String {
    path.file_name().expect("a name").to_string_lossy().into_owned()
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    entries
}
