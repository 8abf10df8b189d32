//! Images, machine files that were made to do harm: the seeds with some changes each, in every run of the tests.
//! `cargo xtask fuzz` goes on from here with the same properties.

mod image;
mod link;
mod machine;
mod text;

use std::path::Path;

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
