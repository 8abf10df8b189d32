//! Replays what the fuzzer found, and a few mutations of every seed. `cargo xtask fuzz` looks for more.

mod fuzzing;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use fuzzing::input::Input;
use fuzzing::mutation::Mutator;
use fuzzing::{properties, seeds};

/// Checks inputs on all cores and names those for which something does not hold.
fn check(inputs: &[(String, Vec<u8>)]) {
    let next = AtomicUsize::new(0);
    let failed = Mutex::new(Vec::new());
    let work = || {
        while let Some((name, bytes)) = inputs.get(next.fetch_add(1, Ordering::Relaxed)) {
            if catch_unwind(AssertUnwindSafe(|| properties::check(bytes))).is_err() {
                failed.lock().expect("nothing panics under the lock").push(name.as_str());
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, Into::into) {
            scope.spawn(work);
        }
    });
    let failed = failed.into_inner().expect("nothing panics under the lock");
    assert!(failed.is_empty(), "the panics above come from {failed:?}");
}

#[test]
fn everything_the_fuzzer_found_holds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    let mut paths: Vec<PathBuf> = std::fs::read_dir(&folder)
        .expect("the corpus")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    assert!(paths.len() >= 50, "only {} files in {}", paths.len(), folder.display());
    let inputs: Vec<_> = paths
        .iter()
        .map(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            (name, std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display())))
        })
        .collect();
    check(&inputs);
}

#[test]
fn mutations_of_fixtures_and_examples_hold() {
    let seeds = seeds::all();
    let mutator = Mutator::new(seeds.clone());
    let inputs: Vec<_> = seeds
        .iter()
        .enumerate()
        .step_by(3)
        .map(|(number, seed)| (format!("seed {number}"), mutator.mutate(seed, 4096, number as u64)))
        .collect();
    check(&inputs);
}

#[test]
fn the_same_seed_gives_the_same_mutation_within_its_length() {
    let mutator = Mutator::new(seeds::all());
    let text = b"DATA\nX: DS 1\nDATA_END\n";
    let mutations: Vec<_> = (0..200).map(|seed| mutator.mutate(text, 300, seed)).collect();
    assert!(mutations.iter().all(|mutation| mutation.len() <= 300));
    assert_eq!(mutations, (0..200).map(|seed| mutator.mutate(text, 300, seed)).collect::<Vec<_>>());
    let changed = mutations.iter().filter(|mutation| *mutation != text).count();
    assert!(changed > 150, "{changed} of 200 differ from the text");
}

#[test]
fn an_input_is_a_project_and_an_edit() {
    let input = Input::of(b";edit 1 20 5000\nSTOP\n;=== technol.toml\n\xFF\n;=== b.plc\n");
    let files: Vec<_> = input.files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice())).collect();
    assert_eq!(files, [("b.plc", &b""[..]), ("main.plc", b"STOP\n"), ("technol.toml", b"\xFF\n")]);
    assert_eq!((input.edit.file, input.edit.from, input.edit.to), (1, 20, 1000));
    assert_eq!(input.root(), "");
    assert_eq!(Input::of(b"STOP").root(), "main.plc");
}
