//! Texts of scenario files that were made to do harm: any text, and changes of scenarios that are right.

use std::cell::RefCell;

use super::fixture::Fixture;
use super::scenario::{Test, Time};
use super::{junit, report};
use crate::paint::Paint;

#[path = "../../../tests/tests/hostile/text.rs"]
mod text;

/// Milliseconds that a step waits at most, and what else keeps a file short: a test may wait for years, and that is no hang.
const MILLIS: u64 = 400;
const TESTS: usize = 4;
const STEPS: usize = 12;

/// Scenarios with every key, for the program of [`Fixture`].
const SEEDS: &[&str] = &[
    "machine = 'none'\nnever = ['GO && DONE && LAMP', 'COUNT > 100']\nalways = { small = 'SMALL < 9' }\n\n[[test]]\nname = 'all'\n\n\
     [[test.step]]\nname = 'go'\nset = { GO = 1, COUNT = -5, SMALL = '0Fh', TEXT = 'mill', P2IN.3 = true }\nuntil = 'LAMP || COUNT == -4'\n\
     at-least = 20\nat-most = '10 cycles'\n\n[[test.step]]\nwait = '1 s'\nend = 'small'\nexpect = { COUNT = '>= -5', LAMP = 1 }\n\
     state = { WORK = 'TEX0' }\nno-message = 77\n\n[[test.step]]\nwait = '8 cycles'\nmessage = 77\nno-message = true\n",
    "[[test]]\nname = 'machine'\npart-program = true\nstep = [\n { press = 'start', fault = ['stuck'], wait = 60 },\n \
     { release = ['start'], repair = 'stuck', start = 'warm', wait = '2 cycles' },\n { block = { m = [3, 8], s = 1200, t = 4, h = 1, \
     motion-ms = 50, rapid = true }, wait = 100, plc-fault = 'division' },\n]\n[[test]]\nname = 'stop'\nstep = [\n { stop = 'power-off', \
     wait = 40 },\n { start = 'cold', wait = 40 },\n { clear = true, halt = true, central-annulment = true, wait = 40 },\n]\n",
    "[[test]]\nname = 'conditions'\nstep = [\n { until = 'MECH(WORK) == idle && !GO || LAMP', at-most = 200 },\n \
     { expect = { TEXT = 'lathe', COUNT = '<= 5' }, always = 'MESSAGE(77) || COUNT <= 0FFh' },\n { set = { SMALL = 3 }, \
     until = \"SMALL == 3 && TEXT != 'x'\", at-most = '1 s', screen = false, listed = 7, not-listed = [77] },\n]\n",
    "part-program = false\n\n[[test]]\nname = 'blocks'\nmachine = 'machine.toml'\nstep = [\n { set = { GO = 1 }, wait = '9 cycles', screen = 77 },\n \
     { acknowledge = true, screen = false, message = [77], state = { WORK = 'idle' } },\n { block = [{ m = [3, 40], speed = 500, feed = 3000.5, \
     feed-max = 8000, axes = [[0, 1.5], [2, -3]], length-mm = 2.5, dwell = 0.1, scale = 1, integers = [1, -25], reals = [0.5], mode = 'other', \
     flags = ['rev-feed', 'thread'] }, { cutting-speed = 120, speed-limit = 2000, flags = 'const-cut-speed', s = 7, h = 5, t = 1234 }], \
     wait = 300 },\n]\n",
];

/// The scenarios that changes begin from.
#[must_use]
pub fn seeds() -> Vec<String> {
    SEEDS.iter().map(|text| (*text).to_owned()).collect()
}

/// Reads a scenario file; runs what is right, and tells what came of it. Answers whether it was right.
///
/// # Panics
/// A property does not hold: a mistake without a place in the text, or one of the panics that are looked for.
pub fn check(text: &str) -> bool {
    thread_local!(static FIXTURE: RefCell<Fixture> = RefCell::new(Fixture::new()));
    FIXTURE.with_borrow_mut(|fixture| {
        let tests = match fixture.read(text) {
            Ok(tests) => tests,
            Err(errors) => {
                assert!(!errors.is_empty());
                let lines = text.split('\n').count() as u32;
                for error in errors {
                    assert!((1..=lines).contains(&error.place.line) && error.place.column > 0, "{error}");
                }
                return false;
            }
        };
        for mut test in tests.into_iter().take(TESTS) {
            shorten(&mut test);
            let verdict = fixture.run(&test);
            if let Some(failure) = &verdict.failure {
                assert!(!report::failure(&test, failure, Paint::none()).is_empty());
            }
            let _ = junit::document("hostile", &[(&test, &verdict)]);
        }
        true
    })
}

fn shorten(test: &mut Test) {
    test.steps.truncate(STEPS);
    for step in &mut test.steps {
        match &mut step.time {
            Time::None => {}
            Time::Wait { ms } => *ms = (*ms).min(MILLIS),
            Time::Until { at_least, at_most, .. } => {
                *at_most = (*at_most).min(MILLIS);
                *at_least = (*at_least).min(*at_most);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::read;
    use super::*;

    #[test]
    fn the_seeds_are_right() {
        let wrong: Vec<String> = seeds()
            .iter()
            .filter_map(|text| Fixture::new().read(text).err())
            .flat_map(|errors| errors.into_iter().map(|e| e.to_string()))
            .collect();
        assert_eq!(wrong, [""; 0]);
    }

    #[test]
    fn the_seeds_have_every_key() {
        let seeds = seeds().concat();
        let words: Vec<&str> = seeds.split(|c: char| !(c.is_alphanumeric() || c == '-')).collect();
        let keys = read::keys();
        let missing: Vec<_> = keys.iter().filter(|key| !words.contains(key)).collect();
        assert!(keys.len() > 40 && missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn scenarios_with_changed_words_are_refused_or_run_without_panic() {
        let seeds = seeds();
        let (mut right, mut wrong) = (0, 0);
        for seed in 0..600 {
            let text = text::mutate(&seeds[seed as usize % seeds.len()], &seeds, seed);
            if check(&text) { right += 1 } else { wrong += 1 }
        }
        assert!(right > 20 && wrong > 20, "{right} right, {wrong} wrong");
    }

    #[test]
    fn everything_the_fuzzer_kept_holds() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus/scenario");
        let files = std::fs::read_dir(&folder).expect("the corpus");
        let mut paths: Vec<_> = files.map(|file| file.expect("an entry").path()).collect();
        paths.sort();
        assert!(!paths.is_empty());
        for path in paths {
            check(&String::from_utf8_lossy(&std::fs::read(path).expect("a file of the corpus")));
        }
    }
}
