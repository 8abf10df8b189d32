//! Images, machine files that were made to do harm: the seeds with some changes each, in every run of the tests.
//! `cargo xtask fuzz` goes on from here with the same properties.

mod depth;
mod image;
mod link;
mod machine;
mod text;

use std::collections::BTreeSet;
use std::path::Path;

use technol_image::{Op, Service};

/// Numbers that look random and are the same each time.
struct Numbers(u64);

impl Iterator for Numbers {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        Some((self.0 >> 56) as u8)
    }
}

/// Inputs that a fuzzer kept; each once broke something, or reached what no other did.
fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(target);
    let files = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut paths: Vec<_> = files.map(|file| file.expect("an entry").path()).collect();
    paths.sort();
    assert!(!paths.is_empty(), "{}", folder.display());
    paths.into_iter().map(|path| std::fs::read(path).expect("a file of the corpus")).collect()
}

#[test]
fn real_programs_run_unchanged() {
    for base in 0..image::bases() {
        assert!(image::check(&[base as u8]), "program {base}");
        assert!(image::check(&image::file_of(base)), "file of program {base}");
    }
}

/// A variant of an enumeration by its number in files.
fn variant(op: &Op) -> u8 {
    postcard::to_allocvec(op).expect("plain data")[0]
}

#[test]
fn the_seeds_of_images_execute_every_operation_and_every_service() {
    let (mut ops, mut services) = (BTreeSet::new(), BTreeSet::new());
    for base in 0..image::bases() {
        let executed = image::executed(base);
        ops.extend(executed.iter().map(variant));
        services.extend(executed.iter().filter_map(|op| image::service(base, op)));
    }
    let missing: Vec<_> = Service::ALL.iter().filter(|it| !services.contains(it)).collect();
    assert!(missing.is_empty(), "{missing:?}");
    // Zeros are a right operand of everything. From 128 on a number takes two bytes.
    let every = (0..128).filter_map(|n| {
        let bytes: Vec<u8> = [n].into_iter().chain([0; 60]).collect();
        postcard::take_from_bytes::<Op>(&bytes).ok().map(|(op, _)| op)
    });
    let missing: Vec<_> = every.filter(|op| !ops.contains(&variant(op))).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn images_with_changed_tables_are_refused_or_run_without_panic() {
    let (mut loaded, mut refused) = (0, 0);
    for seed in 0..150_u64 {
        let base = (seed % image::bases() as u64) as u8;
        let changes = [1, 2, 8][seed as usize / 3 % 3];
        let mut numbers = Numbers(seed);
        let input = [base, changes].into_iter().chain(numbers.by_ref().take(6 * usize::from(changes) + 24));
        if image::check(&input.collect::<Vec<_>>()) { loaded += 1 } else { refused += 1 }
    }
    assert!(loaded > 20 && refused > 20, "{loaded} loaded, {refused} refused");
}

#[test]
fn damaged_files_are_refused_or_run_without_panic() {
    for base in 0..image::bases() {
        let file = image::file_of(base);
        for seed in 0..40 {
            let mut numbers = Numbers(seed);
            let mut damaged = file.clone();
            let mut at = || {
                let bytes: Vec<u8> = numbers.by_ref().take(4).collect();
                (usize::from(bytes[0]) << 16 | usize::from(bytes[1]) << 8 | usize::from(bytes[2]), bytes[3])
            };
            let (place, value) = at();
            let place = 1 + place % (file.len() - 1);
            if seed % 4 == 0 {
                damaged.truncate(place);
            } else {
                damaged[place] = value;
            }
            let same = damaged == file;
            assert_eq!(image::check(&damaged), same, "every damage is noticed");
        }
    }
}

#[test]
fn the_seeds_of_machine_files_are_right_and_have_every_key() {
    let seeds = machine::seeds();
    for seed in &seeds {
        let _ = machine::check(seed);
    }
    // Those of the book are pieces, which need not stand alone.
    let whole = machine::EVERY_KEY;
    for seed in whole {
        let errors = technol_target::parse_machine(Path::new("machine.toml"), seed).err();
        assert_eq!(errors, None);
    }
    let mut missing = Vec::new();
    for table in machine::keys("") {
        let keys = machine::keys(&format!("[[{table}]]"));
        let sections: Vec<&str> = whole.iter().flat_map(|seed| tables(seed, &table)).collect();
        let has = |key: &str| {
            let begins = |line: &str| line.strip_prefix(key).is_some_and(|rest| rest.starts_with(" ="));
            sections.iter().any(|section| section.lines().any(begins))
        };
        missing.extend(keys.iter().filter(|key| !has(key)).map(|key| format!("{table}.{key}")));
    }
    assert_eq!(missing, [""; 0]);
}

/// The text of the tables of this name.
fn tables<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
    let heads = [format!("[[{name}]]"), format!("[{name}]")];
    let section = |text: &'a str| {
        let (head, rest) = text.split_once('\n')?;
        heads.iter().any(|it| it == head).then(|| rest.split("\n[").next().unwrap_or(rest))
    };
    text.match_indices('[')
        .filter(|(at, _)| *at == 0 || text[..*at].ends_with('\n'))
        .filter_map(|(at, _)| section(&text[at..]))
        .collect()
}

#[test]
fn machine_files_with_changed_words_are_refused_or_run_without_panic() {
    let seeds = machine::seeds();
    let (mut right, mut wrong) = (0, 0);
    for seed in 0..300 {
        let text = text::mutate(&seeds[seed as usize % seeds.len()], &seeds, seed);
        if machine::check(&text) { right += 1 } else { wrong += 1 }
    }
    assert!(right > 20 && wrong > 20, "{right} right, {wrong} wrong");
}

#[test]
fn everything_the_fuzzer_kept_holds() {
    for input in corpus("image") {
        image::check(&input);
    }
    for input in corpus("machine") {
        machine::check(&String::from_utf8_lossy(&input));
    }
}

#[test]
fn any_bytes_on_a_line_are_survived_by_both_ends() {
    for input in corpus("link_frames").into_iter().chain(corpus("link_messages")).chain(corpus("link_target"))
    {
        link::frames(&input);
        link::messages(&input);
        link::target(&input);
    }
    let mut numbers = Numbers(11);
    for n in 0..400 {
        let len = usize::from(numbers.next().unwrap_or_default());
        // Small numbers are what lengths and variants are made of.
        let input: Vec<u8> =
            numbers.by_ref().take(len).map(|b| if n % 2 == 0 { b } else { b % 32 }).collect();
        link::frames(&input);
        link::messages(&input);
        link::target(&input);
    }
}
