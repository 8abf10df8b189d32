//! What the tests load: written down, read back, and changed.

use std::cell::{Cell, OnceCell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;
use std::fs::{self, File};
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::io::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::{env, iter};

use technol_image::container::{Image, decode, encode};
use technol_image::op::Op;

use super::altered::{self, alterations};
use super::uses::{Uses, uses};

/// Lines, each with its program.
pub(super) type Places = BTreeSet<(String, BTreeSet<u32>)>;

/// What is known about a mutant, or about a use.
#[derive(Default)]
pub(super) struct Recorded {
    /// The programs that it changes, in all lines that have the use.
    pub(super) places: Places,
    /// The tests that load one of them, those with few lines in front.
    pub(super) tests: Vec<Meeting>,
}

/// A test that can meet a mutant.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Meeting {
    /// In the rows of a table: of these a run tries any number.
    pub(super) single: bool,
    /// Bytes of the programs that the test loads.
    size: usize,
    pub(super) test: String,
}

/// The folder that images and the programs of each test are written to.
pub(super) const FOLDER: &str = "TECHNOL_CHAIN_RECORD";
/// A file of `test=mutant` lines: what is changed for each test.
pub(super) const MUTANTS: &str = "TECHNOL_CHAIN_MUTANTS";
/// The file that rows of tables write the mutants to that they notice.
pub(super) const NOTICED: &str = "TECHNOL_CHAIN_NOTICED";
/// What a test that fails says when its program could not be loaded with the change.
pub(super) const NOT_LOADED: &str = "the mutant cannot be loaded";

/// The image of `source`: from the folder, or else what `build` makes, which is written there.
pub(crate) fn recorded(source: &str, build: impl FnOnce() -> Image) -> Image {
    let Some(folder) = env::var_os(FOLDER).map(PathBuf::from) else { return build() };
    let name = id(source);
    let path = folder.join(&name);
    if env::var_os(MUTANTS).is_some() {
        LOADED.with_borrow_mut(|loaded| loaded.clone_from(&name));
        let concerned =
            CURRENT.with_borrow(|mutant| mutant.as_ref().is_none_or(|it| it.programs.contains(&name)));
        if IN_ROWS.get() && !concerned {
            // Not a failure: this row says nothing about this mutant.
            resume_unwind(Box::new(NotConcerned));
        }
        return DECODED.with_borrow_mut(|decoded| match decoded {
            Some((of, image)) if *of == name => image.clone(),
            _ => {
                let image = decode(&fs::read(path).expect("recorded before")).expect("an image");
                *decoded = Some((name, image.clone()));
                image
            }
        });
    }
    let noted = folder.join(if IN_ROWS.get() { "rows" } else { "tests" }).join(test().replace("::", "-"));
    let image = build();
    fs::create_dir_all(&noted).expect("a folder");
    fs::write(&path, encode(&image)).expect("a file");
    fs::write(noted.join(name), source).expect("a file");
    image
}

/// What a source text is called in the folder.
fn id(text: &str) -> String {
    format!("{:016x}", hash(text))
}

pub(super) fn hash(text: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    hasher.finish()
}

/// The name of the running test.
fn test() -> String {
    std::thread::current().name().unwrap_or("main").to_owned()
}

/// What the running test is given instead of the programs it loads.
struct Mutant {
    name: String,
    /// Operations mean something else; otherwise the lines with a use do nothing.
    altered: bool,
    programs: BTreeSet<String>,
}

/// A row loads a program that the mutant does not concern.
struct NotConcerned;

thread_local! {
    /// What the running test meets.
    static ALL: OnceCell<Rc<[Rc<Mutant>]>> = const { OnceCell::new() };
    static CURRENT: RefCell<Option<Rc<Mutant>>> = const { RefCell::new(None) };
    static IN_ROWS: Cell<bool> = const { Cell::new(false) };
    /// What rows noticed so far.
    static SEEN: RefCell<BTreeSet<String>> = const { RefCell::new(BTreeSet::new()) };
    /// What was read last: a row reads the same again for each mutant.
    static DECODED: RefCell<Option<(String, Image)>> = const { RefCell::new(None) };
    /// The program loaded last.
    static LOADED: RefCell<String> = const { RefCell::new(String::new()) };
}

fn mutants() -> Rc<[Rc<Mutant>]> {
    ALL.with(|all| {
        let all = all.get_or_init(read_mutants);
        if let ([only], false) = (&**all, IN_ROWS.get()) {
            CURRENT.set(Some(Rc::clone(only)));
        }
        Rc::clone(all)
    })
}

fn read_mutants() -> Rc<[Rc<Mutant>]> {
    let (Some(all), Some(folder)) = (env::var_os(MUTANTS), env::var_os(FOLDER)) else { return Rc::new([]) };
    let (test, folder) = (test(), PathBuf::from(folder).join("mutants"));
    let all = fs::read_to_string(all).expect("a file");
    let mine = all.lines().filter_map(|line| line.split_once('=')).filter(|(of, _)| *of == test);
    mine.map(|(_, name)| {
        let described = fs::read_to_string(folder.join(id(name))).expect("a mutant");
        let mut lines = described.lines().map(str::to_owned);
        let altered = lines.next().as_deref() == Some("altered");
        Rc::new(Mutant { name: name.to_owned(), altered, programs: lines.collect() })
    })
    .collect()
}

/// Tries the rows of a table, each for itself: what is wrong with each. Where mutants are tried, each row that concerns
/// one of them is tried with it, until one notices it.
pub(crate) fn wrong_rows<R: Debug>(rows: &[R], wrong: impl Fn(&R) -> Vec<String>) -> Vec<String> {
    let mutants = mutants();
    if mutants.is_empty() {
        IN_ROWS.set(true);
        let found = rows.iter().map(|row| (row, wrong(row))).filter(|(_, found)| !found.is_empty());
        let found = found.map(|(row, found)| format!("{row:?}: {}", found.join(", "))).collect();
        IN_ROWS.set(false);
        return found;
    }
    let mut open: Vec<Rc<Mutant>> =
        SEEN.with_borrow(|seen| mutants.iter().filter(|it| !seen.contains(&it.name)).cloned().collect());
    let all = open.clone();
    let before = CURRENT.take();
    for row in rows {
        let mut program = None;
        open.retain(|mutant| {
            if program.as_ref().is_some_and(|program| !mutant.programs.contains(program)) {
                return true;
            }
            CURRENT.set(Some(Rc::clone(mutant)));
            IN_ROWS.set(true);
            let found = catch_unwind(AssertUnwindSafe(|| wrong(row)));
            IN_ROWS.set(false);
            program = Some(LOADED.with_borrow(String::clone));
            match found {
                Ok(found) => found.is_empty(),
                Err(panic) if panic.is::<NotConcerned>() => true,
                Err(panic) => panic.downcast_ref::<String>().is_some_and(|it| it.starts_with(NOT_LOADED)),
            }
        });
    }
    CURRENT.set(before);
    let open: BTreeSet<&str> = open.iter().map(|mutant| &*mutant.name).collect();
    let noticed = all.iter().filter(|it| !open.contains(&*it.name)).map(|it| it.name.clone());
    let noticed: BTreeSet<String> = noticed.collect();
    let file = env::var_os(NOTICED).expect("where to write to");
    let mut file = File::options().create(true).append(true).open(file).expect("a file");
    // In one piece: other tests write to it, too.
    let lines: String = noticed.iter().flat_map(|name| [name, "\n"]).collect();
    file.write_all(lines.as_bytes()).expect("a file");
    SEEN.with_borrow_mut(|seen| seen.extend(noticed));
    Vec::new()
}

/// Runs a part of a test that loads one program and panics when something is wrong. Of such parts a run tries any number of
/// mutants.
#[track_caller]
pub(crate) fn with_mutants(part: impl Fn()) {
    wrong_rows(&[()], |()| {
        part();
        Vec::new()
    });
}

/// Does to the program of `source` what the running test asks for.
pub(crate) fn mutated(source: &str, image: &mut Image) {
    mutants();
    let Some(mutant) = CURRENT.with_borrow(Option::clone) else { return };
    if !mutant.programs.contains(&id(source)) {
        return;
    }
    if mutant.altered {
        altered::alter(image, &mutant.name);
    } else {
        left_out(source, image, &mutant.name);
    }
}

/// Lets the lines with the use do nothing.
fn left_out(source: &str, image: &mut Image, using: &str) {
    let debug = image.debug.as_ref().expect("it was built with it");
    let uses = uses(source, debug);
    let Some(lines) = uses.get(using) else { return };
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

/// What was loaded. That a mutant cannot be loaded says nothing about the test.
pub(crate) fn loaded<T, E: std::fmt::Display>(result: Result<T, E>) -> T {
    result.unwrap_or_else(|error| {
        let mutant = CURRENT.with_borrow(Option::is_some);
        panic!("{}: {error}", if mutant { NOT_LOADED } else { "not loaded" })
    })
}

/// For each use where it is, and the tests that have it.
pub(super) fn recorded_uses(folder: &Path) -> BTreeMap<String, Recorded> {
    recorded_mutants(folder, "without", |program| {
        let source = fs::read_to_string(program).expect("a source text");
        let debug = image_of(folder, program).debug.expect("debug information");
        let with_code: BTreeSet<u32> =
            debug.lines.iter().filter(|line| line.file == 0).map(|line| line.line).collect();
        let mut uses: Uses = uses(&source, &debug);
        for lines in uses.values_mut() {
            lines.retain(|line| with_code.contains(line));
        }
        uses.retain(|_, lines| !lines.is_empty());
        uses
    })
}

/// For each alteration the programs that have a place for it, and the tests that load them.
pub(super) fn recorded_alterations(folder: &Path) -> BTreeMap<String, Recorded> {
    recorded_mutants(folder, "altered", |program| {
        let found = alterations(&image_of(folder, program).program);
        found.into_iter().map(|alteration| (alteration, BTreeSet::new())).collect()
    })
}

/// What `mutants_of` finds in the programs, all together. What a test run has to know about a mutant is written into
/// the folder.
fn recorded_mutants(
    folder: &Path,
    kind: &str,
    mutants_of: impl Fn(&Path) -> Uses,
) -> BTreeMap<String, Recorded> {
    let mut recorded: BTreeMap<String, (Recorded, BTreeSet<Meeting>)> = BTreeMap::new();
    let mut known: BTreeMap<String, Uses> = BTreeMap::new();
    for (meeting, program) in programs(folder) {
        let id = name_of(&program);
        for (mutant, lines) in known.entry(id.clone()).or_insert_with(|| mutants_of(&program)) {
            let (recorded, tests) = recorded.entry(mutant.clone()).or_default();
            recorded.places.insert((id.clone(), lines.clone()));
            tests.insert(meeting.clone());
        }
    }
    let mutants = folder.join("mutants");
    fs::create_dir_all(&mutants).expect("a folder");
    let mut result = BTreeMap::new();
    for (name, (mut recorded, tests)) in recorded {
        let programs = recorded.places.iter().map(|(id, _)| &**id);
        let described: Vec<&str> = iter::once(kind).chain(programs).collect();
        fs::write(mutants.join(id(&name)), described.join("\n")).expect("a file");
        recorded.tests = tests.into_iter().collect();
        result.insert(name, recorded);
    }
    result
}

/// All programs that tests load.
fn programs(folder: &Path) -> Vec<(Meeting, PathBuf)> {
    let mut found = Vec::new();
    for (kind, single) in [("rows", false), ("tests", true)] {
        for test in entries(&folder.join(kind)) {
            let programs = entries(&test);
            let size = programs.iter().map(|it| fs::metadata(it).expect("a file").len() as usize).sum();
            let meeting = Meeting { single, size, test: name_of(&test).replace('-', "::") };
            found.extend(programs.into_iter().map(|program| (meeting.clone(), program)));
        }
    }
    found
}

fn image_of(folder: &Path, program: &Path) -> Image {
    let image = fs::read(folder.join(name_of(program))).expect("an image");
    decode(&image).expect("an image")
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
