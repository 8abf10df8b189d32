//! A host never shows a value that the target did not have, and catches up when the line lets it.

use technol_wire::Freshness;
use technol_wire::frame::kind;
use technol_wire::message::{Item, ItemKind, Mode, Request, Response, Subject, Subscription};

use super::world::{CYCLE, Faults, Random, SECOND, World};
use super::{bits_and_double_words, variables};

const LINES: [(&str, Faults); 5] = [
    ("losing", Faults { lost: 20, doubled: 0, damaged: 0 }),
    ("doubling", Faults { lost: 0, doubled: 40, damaged: 0 }),
    ("damaging", Faults { lost: 0, doubled: 0, damaged: 15 }),
    ("bad", Faults { lost: 30, doubled: 20, damaged: 20 }),
    ("all but cut", Faults { lost: 70, doubled: 0, damaged: 10 }),
];

/// A memory of bits and double words that lives in several ways.
fn live(world: &mut World, random: &mut Random) {
    match random.below(10) {
        0..4 => {}
        4..8 => {
            let at = random.below(world.plant.memory.len());
            world.plant.memory[at] = world.plant.memory[at].wrapping_add(1);
        }
        8 => world.plant.memory.iter_mut().for_each(|b| *b = random.next() as u8),
        _ => {
            let at = random.below(world.plant.memory.len());
            world.plant.memory[at] = random.next() as u8;
        }
    }
}

/// The values of bits and double words as they were.
fn expected(memory: &[u8], bits: usize, words: usize) -> Vec<u64> {
    let base = bits.div_ceil(8);
    let bit = |n: usize| u64::from(memory[n / 8] >> (n % 8) & 1);
    let word = |n: usize| {
        let at = base + n * 4;
        u64::from(u32::from_le_bytes(memory[at..at + 4].try_into().unwrap()))
    };
    (0..bits).map(bit).chain((0..words).map(word)).collect()
}

#[test]
fn no_value_is_shown_that_was_not_there_and_all_is_current_after_the_noise() {
    let (bits, words) = (13, 9);
    for (name, faults) in LINES {
        for seed in 0..8 {
            let subscription = variables(3, 1, bits_and_double_words(bits, words));
            let mut world = World::with(seed, 2 + words * 4, &[subscription]);
            let mut random = Random::new(u64::from(seed) + 77);
            world.damage(faults);
            world.run(15 * SECOND, |w| {
                live(w, &mut random);
                // Held now and then: the cycle stands, the number does not.
                if w.number % 100 < 20 {
                    w.cycle -= 1;
                }
            });
            world.damage(Faults::default());
            for (_, sample) in &world.samples {
                let (cycle, plant) = &world.history[&sample.number];
                let values = expected(&plant.memory, bits, words);
                assert_eq!(
                    (sample.cycle, &sample.values),
                    (*cycle, &values),
                    "{name} line, {seed}: {sample:?}"
                );
            }
            let numbers: Vec<_> = world.samples.iter().map(|(_, s)| s.number).collect();
            assert!(numbers.is_sorted(), "{name} line, {seed}");
            if world.host.is_lost() {
                continue; // that is told, and nothing is shown any more
            }
            // The next heartbeat, the question, the answer.
            world.run(SECOND * 12 / 10, |w| live(w, &mut random));
            world.run(3 * CYCLE, |_| {});
            let now = expected(&world.plant.memory, bits, words);
            assert_eq!(world.samples.last().unwrap().1.values, now, "{name} line, {seed}");
            assert_eq!(world.host.freshness(3), Some(Freshness::Current), "{name} line, {seed}");
        }
    }
}

#[test]
fn a_lost_change_is_known_of_soon() {
    for seed in 0..15 {
        let mut world = World::with(seed, 38, &[variables(0, 1, bits_and_double_words(13, 9))]);
        world.run(3 * SECOND, |_| {});
        world.to_host.faults.lost = 100;
        world.run(CYCLE, |w| w.plant.memory[0] = 1);
        world.to_host.faults.lost = 0;
        let at = world.now;
        world.run(SECOND, |_| {});
        let seen = world.samples.iter().find(|(_, s)| s.values[0] == 1).unwrap().0;
        assert!(seen - at < 200_000, "{} ms", (seen - at) / 1000);
    }
}

#[test]
fn a_cut_makes_values_stale_before_they_are_doubted() {
    let mut world = World::with(1, 1, &[variables(0, 1, bits_and_double_words(8, 0))]);
    world.run(3 * SECOND, |_| {});
    assert_eq!(world.host.freshness(0), Some(Freshness::Current));
    // Only streams are lost: answers to pings come through.
    world.target.streams().unsubscribe(0);
    world.run(3 * SECOND, |_| {});
    assert_eq!(world.host.freshness(0), Some(Freshness::Stale));
    assert_eq!(world.stale.len(), 1, "told once: {:?}", world.stale);
    // A target that forgot the stream is asked for it again.
    world.run(4 * SECOND, |w| w.plant.memory[0] = 5);
    assert_eq!(world.host.freshness(0), Some(Freshness::Current));
    assert_eq!(world.samples.last().unwrap().1.values, [1, 0, 1, 0, 0, 0, 0, 0]);
}

#[test]
fn a_stream_that_nobody_listens_to_ends() {
    let mut world = World::with(1, 1, &[variables(0, 1, bits_and_double_words(8, 0))]);
    world.run(2 * SECOND, |w| w.plant.memory[0] ^= 1);
    // The host is there, its pings say so, but it listens no more.
    world.to_target.dropped = kind::LISTENING;
    world.run(6 * SECOND, |w| w.plant.memory[0] ^= 1);
    assert!(!world.host.is_lost());
    let bytes = world.bytes();
    world.run(3 * SECOND, |w| w.plant.memory[0] ^= 1);
    assert_eq!(world.bytes(), bytes);
    assert_eq!(world.host.freshness(0), Some(Freshness::Stale));
    // One that listens again gets it back by itself.
    world.to_target.dropped = 0;
    world.run(6 * SECOND, |w| w.plant.memory[0] ^= 1);
    assert_eq!(world.host.freshness(0), Some(Freshness::Current));
    // Unsubscribed is the end at once.
    world.host.request(Request::Unsubscribe { id: 0 });
    world.run(SECOND / 10, |w| w.plant.memory[0] ^= 1);
    let bytes = world.bytes();
    world.run(2 * SECOND, |w| w.plant.memory[0] ^= 1);
    assert_eq!((world.bytes(), world.host.freshness(0)), (bytes, None));
}

#[test]
fn a_pulse_of_one_cycle_is_seen_however_slow_the_stream_and_however_bad_the_line() {
    let items = vec![Item { addr: 0, kind: ItemKind::Bit(0), mode: Mode::Edges }];
    for seed in 0..20 {
        let mut world = World::with(seed, 1, &[variables(0, 25, items.clone())]);
        world.damage(Faults { lost: 12, doubled: 10, damaged: 5 });
        let mut pulses = 0;
        world.run(10 * SECOND, |w| {
            if w.number % 37 == 0 {
                // High for less than the cycle: only whoever looks every millisecond sees it.
                let mut high = w.plant.clone();
                high.memory[0] = 1;
                w.target.streams().observe(&high.memory);
                w.target.streams().observe(&w.plant.memory);
                pulses += 1;
            }
        });
        world.damage(Faults::default());
        world.run(2 * SECOND, |_| {});
        assert!(!world.host.is_lost());
        assert_eq!(world.samples.last().unwrap().1.values, [0, pulses, pulses], "line {seed}");
    }
}

#[test]
fn extremes_reach_over_all_time_and_a_gap_in_them_is_told() {
    let items = vec![Item { addr: 0, kind: ItemKind::Unsigned(1), mode: Mode::Extremes }];
    for seed in 0..20 {
        let mut world = World::with(seed, 1, &[variables(0, 5, items.clone())]);
        world.damage(Faults { lost: 15, doubled: 10, damaged: 0 });
        let mut random = Random::new(u64::from(seed));
        world.run(10 * SECOND, |w| {
            w.plant.memory[0] = if random.percent(20) { random.next() as u8 } else { 100 };
            let memory = w.plant.memory.clone();
            w.target.streams().observe(&memory);
        });
        let mut gaps = 0;
        for pair in world.samples.windows(2) {
            let (before, sample) = (&pair[0].1, &pair[1].1);
            assert_eq!(sample.contiguous, sample.number - sample.window == before.number);
            gaps += usize::from(!sample.contiguous);
            // The window's own numbers, with the value that the one before left behind.
            let from = sample.number - sample.window;
            let seen = world.history.range(from..=sample.number).map(|(_, (_, p))| u64::from(p.memory[0]));
            let seen: Vec<u64> = seen.collect();
            let (least, greatest) = (*seen.iter().min().unwrap(), *seen.iter().max().unwrap());
            assert_eq!(sample.values, [*seen.last().unwrap(), least, greatest], "line {seed}: {sample:?}");
        }
        assert!(gaps > 0, "line {seed}");
    }
}

#[test]
fn a_stream_of_another_shape_does_not_take_frames_of_the_one_before() {
    let mut world = World::with(4, 40, &[variables(0, 1, bits_and_double_words(8, 9))]);
    let mut random = Random::new(4);
    for round in 0..30 {
        let words = 1 + random.below(8);
        world.damage(LINES[0].1);
        world.samples.clear();
        let subscription = variables(0, 1, bits_and_double_words(8, words));
        let ticket = world.host.request(Request::Subscribe(subscription));
        world.run(SECOND * 2, |w| live(w, &mut random));
        assert_eq!(world.response(ticket), Some(&Response::Done), "round {round}");
        assert!(!world.samples.is_empty(), "round {round}");
        for (_, sample) in &world.samples {
            let values = expected(&world.history[&sample.number].1.memory, 8, words);
            assert_eq!(sample.values, values, "round {round}");
        }
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    use technol_wire::message::Failure;
    let mut world = World::with(1, 1000, &[]);
    for (subscription, failure) in [
        (variables(0, 1, bits_and_double_words(0, 58)), Failure::TooLarge),
        (variables(8, 1, vec![]), Failure::OutOfRange),
        (variables(0, 0, vec![]), Failure::OutOfRange),
        (variables(0, 1, bits_and_double_words(8000, 1)), Failure::TooLarge),
        (
            variables(0, 1, vec![Item { addr: 997, kind: ItemKind::Signed(4), mode: Mode::Value }]),
            Failure::OutOfRange,
        ),
        (
            Subscription {
                id: 0,
                period: 1,
                subject: Subject::Trace { pcs: (0..60).collect(), wide: false },
            },
            Failure::TooLarge,
        ),
    ] {
        let ticket = world.host.request(Request::Subscribe(subscription.clone()));
        world.run(SECOND, |_| {});
        assert_eq!(world.response(ticket), Some(&Response::Failed(failure)), "{subscription:?}");
        assert_eq!(world.host.freshness(0), None);
    }
}

#[test]
fn in_virtual_time_samples_are_apart_and_true() {
    let mut world = World::new(9, 38);
    world.run(SECOND / 10, |_| {});
    world.target.streams().set_uneven(true);
    world.host.request(Request::Subscribe(variables(0, 1, bits_and_double_words(13, 9))));
    world.run(SECOND / 10, |_| {});
    world.damage(Faults { lost: 30, doubled: 0, damaged: 10 });
    let mut random = Random::new(1);
    world.run(20 * SECOND, |w| {
        for _ in 0..random.below(5000) {
            w.number += 1;
            w.cycle += 1;
        }
        live(w, &mut random);
    });
    assert!(world.samples.len() > 50);
    for (_, sample) in &world.samples {
        let (cycle, plant) = &world.history[&sample.number];
        assert_eq!((sample.cycle, &sample.values), (*cycle, &expected(&plant.memory, 13, 9)));
    }
}
