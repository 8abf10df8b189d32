//! Bytes on the line, counted with everything that streams put on it: delimiters, checksums, heartbeats.

use technol_wire::message::{Event, ItemKind, Mode, Request, Subject, Subscription};
use technol_wire::{HostEvent, MechanismSample, Ran, TraceSample};

use super::world::{CYCLE, LINE, Random, SECOND, World};
use super::{bits_and_double_words, item, variables};

/// Bytes from the target in the next cycle, in which `change` happens; that cycle is heard of at the end.
fn bytes_of(world: &mut World, change: impl Fn(&mut World)) -> usize {
    let before = (world.bytes(), world.samples.len());
    world.run(CYCLE, |w| change(w));
    assert_eq!(world.samples.len(), before.1 + 1, "one sample");
    world.bytes() - before.0
}

fn set_word(world: &mut World, at: usize, value: u32) {
    world.plant.memory[at..at + 4].copy_from_slice(&value.to_le_bytes());
}

fn word(world: &World, at: usize) -> u32 {
    u32::from_le_bytes(world.plant.memory[at..at + 4].try_into().unwrap())
}

/// Just behind a sample that no ping, heartbeat or confirmation falls into.
fn settled(world: &mut World) {
    world.run(3 * SECOND, |_| {});
    loop {
        let before = world.samples.len();
        world.run(CYCLE, |w| w.plant.memory[0] ^= 1);
        if world.samples.len() > before {
            return;
        }
    }
}

#[test]
fn twenty_items_cost_28_bytes_in_full() {
    let items = bits_and_double_words(16, 4);
    for seed in 0..20 {
        let mut world = World::with(1, 18, &[variables(0, 1, items.clone())]);
        settled(&mut world);
        let mut random = Random::new(seed);
        let memory: Vec<u8> = (0..18).map(|_| random.next() as u8).collect();
        let bytes = bytes_of(&mut world, |w| w.plant.memory.clone_from(&memory));
        assert!(bytes <= 28, "{bytes} bytes for {memory:02x?}");
        // So few that the values told are those of the whole sample.
        assert_eq!(world.samples.last().unwrap().1.values.len(), 20);
    }
}

#[test]
fn three_changed_items_of_twenty_cost_16_bytes() {
    let items = bits_and_double_words(16, 4);
    type Change = fn(&mut World);
    let changes: [(&str, Change); 6] = [
        ("three bits", |w| w.plant.memory[0] ^= 0b1001_0010),
        ("three bits far apart", |w| {
            w.plant.memory[0] ^= 1;
            w.plant.memory[1] ^= 0x81;
        }),
        ("two bits and a position", |w| {
            w.plant.memory[0] ^= 0x82;
            let new = word(w, 6).wrapping_add(3000);
            set_word(w, 6, new);
        }),
        ("two bits and a fast position", |w| {
            w.plant.memory[1] ^= 0x14;
            let new = word(w, 14).wrapping_sub(500_000);
            set_word(w, 14, new);
        }),
        ("three counters", |w| {
            for at in [2, 6, 14] {
                let new = word(w, at).wrapping_add(7);
                set_word(w, at, new);
            }
        }),
        ("a bit and two positions", |w| {
            w.plant.memory[1] ^= 1;
            for at in [2, 10] {
                let new = word(w, at).wrapping_add(100);
                set_word(w, at, new);
            }
        }),
    ];
    for (name, change) in changes {
        let mut world = World::with(1, 18, &[variables(0, 1, items.clone())]);
        world.run(CYCLE, |w| w.plant.memory = (0..18_u8).map(|n| n.wrapping_mul(37)).collect());
        settled(&mut world);
        let bytes = bytes_of(&mut world, change);
        assert!(bytes <= 16, "{name}: {bytes} bytes");
    }
}

#[test]
fn nothing_is_sent_while_nothing_changes_but_a_heartbeat() {
    let mut world = World::with(1, 18, &[variables(0, 1, bits_and_double_words(16, 4))]);
    world.run(5 * SECOND, |_| {});
    let (bytes, samples) = (world.bytes(), world.samples.len());
    world.run(10 * SECOND, |_| {});
    assert_eq!(world.samples.len() - samples, 10, "one heartbeat a second");
    let heartbeats = world.bytes() - bytes;
    assert!(heartbeats <= 10 * 13, "{heartbeats} bytes");
    assert!(world.stale.is_empty(), "quiet is not stale: {:?}", world.stale);
}

/// 100 bits and 50 double words each cycle, of which 5 % change: any of them, each time others.
#[test]
fn a_hundred_bits_and_fifty_double_words_take_an_eighth_of_the_line() {
    let items = bits_and_double_words(100, 50);
    let mut world = World::with(1, 213, &[variables(0, 1, items)]);
    settled(&mut world);
    let mut random = Random::new(5);
    let before = world.bytes();
    let seconds = 20;
    world.run(seconds * SECOND, |w| {
        for _ in 0..5 {
            let bit = random.below(100);
            w.plant.memory[bit / 8] ^= 1 << (bit % 8);
        }
        for n in 0..3 {
            // 2.5 of 50.
            if n < 2 || random.percent(50) {
                let at = 13 + random.below(50) * 4;
                let new = word(w, at).wrapping_add(random.next() as u32 % 65_536).wrapping_sub(32_768);
                set_word(w, at, new);
            }
        }
    });
    let share = (world.bytes() - before) * 100 / (LINE * seconds as usize);
    assert!(share <= 12, "{share} %");
    assert!(world.stale.is_empty());
}

/// 40 lines: most run in each cycle, some RLO flip, some DR move.
#[test]
fn a_trace_of_forty_lines_each_cycle_takes_a_seventh_of_the_line() {
    let pcs: Vec<u32> = (0..40).map(|n| 100 + n * 3).collect();
    let subject = Subject::Trace { pcs: pcs.clone(), wide: false };
    let mut world = World::new(1, 1);
    for pc in &pcs {
        world.plant.traced.insert(*pc, TraceSample { ran: Ran::Now, ..TraceSample::default() });
    }
    world.run(SECOND / 10, |_| {});
    world.host.request(Request::Subscribe(Subscription { id: 2, period: 1, subject }));
    world.run(SECOND, |_| {});
    let mut random = Random::new(3);
    let before = (world.bytes(), world.samples.len());
    let seconds = 20;
    world.run(seconds * SECOND, |w| {
        for _ in 0..5 {
            let pc = pcs[random.below(40)];
            let line = w.plant.traced.get_mut(&pc).unwrap();
            line.rlo = !line.rlo;
        }
        for n in 0..4 {
            let line = w.plant.traced.get_mut(&pcs[n * 9]).unwrap();
            line.dr = (line.dr + random.next() as i64 % 1000) & 0xFFFF;
        }
        let line = w.plant.traced.get_mut(&pcs[random.below(40)]).unwrap();
        line.ran = if line.ran == Ran::Now { Ran::Before } else { Ran::Now };
    });
    let share = (world.bytes() - before.0) * 100 / (LINE * seconds as usize);
    assert!(share <= 15, "{share} %");
    assert_eq!(world.samples.len() - before.1, 50 * seconds as usize, "one each cycle");
}

#[test]
fn mechanisms_that_wait_cost_nothing() {
    let sequences: Vec<u16> = (0..12).collect();
    let mut world = World::new(1, 1);
    for n in &sequences {
        let now = MechanismSample { active: true, resume: *n + 1, line: 100 + n, entered: 69_000 };
        world.plant.mechanisms.insert(*n, now);
    }
    world.run(SECOND / 10, |_| {});
    world.host.request(Request::Subscribe(Subscription {
        id: 1,
        period: 1,
        subject: Subject::Mechanisms(sequences),
    }));
    world.run(5 * SECOND, |_| {});
    let samples = world.samples.len();
    world.run(5 * SECOND, |_| {});
    assert_eq!(world.samples.len() - samples, 5, "heartbeats");
    // One goes on to its next state.
    settled_mechanism(&mut world);
}

fn settled_mechanism(world: &mut World) {
    let before = world.bytes();
    let cycle = world.cycle + 1;
    world.run(CYCLE, |w| {
        let now = MechanismSample { active: true, resume: 9, line: 131, entered: cycle };
        w.plant.mechanisms.insert(7, now);
    });
    let bytes = world.bytes() - before;
    assert!(bytes <= 18, "{bytes} bytes");
    assert_eq!(world.samples.last().unwrap().1.values[28..32], [1, 9, 131, u64::from(cycle)]);
}

#[test]
fn an_event_does_not_wait_for_streams_and_streams_keep_to_their_share() {
    let items: Vec<_> = (0..50).map(|n| item(n * 4, ItemKind::Unsigned(4))).collect();
    let subscriptions: Vec<_> = (0..4).map(|id| variables(id, 1, items.clone())).collect();
    let mut world = World::with(1, 200, &subscriptions);
    let rate = LINE as u32 * 6 / 10;
    world.target.streams().set_rate(Some(rate));
    world.driver = 8;
    let mut random = Random::new(8);
    // Four times 210 bytes a cycle would be four times the line.
    let mut noise = |w: &mut World| w.plant.memory.iter_mut().for_each(|b| *b = random.next() as u8);
    let before = world.bytes();
    world.run(10 * SECOND, &mut noise);
    let used = world.bytes() - before;
    assert!(used <= LINE * 62 / 10, "{used} bytes in 10 s");
    assert!(used >= LINE * 55 / 10, "{used} bytes in 10 s");
    for id in 0..4 {
        let own = world.samples.iter().filter(|(_, s)| s.id == id).count();
        assert!(own > 50, "stream {id} had {own} samples");
    }
    let answered = world.host.request(Request::Status);
    let asked = world.now;
    world.target.event(&Event::Resumed);
    world.run(SECOND / 10, &mut noise);
    let at = world.events.iter().find(|(_, e)| *e == HostEvent::Event(Event::Resumed)).unwrap().0;
    // One frame of 228 bytes may be on the line.
    assert!(at - asked <= 25_000, "{} µs", at - asked);
    let at = world.responses.iter().find(|(_, t, _)| *t == answered).unwrap().0;
    assert!(at - asked <= 30_000, "{} µs", at - asked);
}

#[test]
fn a_change_makes_a_sample_due_where_that_is_asked_for() {
    let mut items = vec![item(0, ItemKind::Bit(0)), item(1, ItemKind::Unsigned(2))];
    items[0].mode = Mode::OnChange;
    let mut world = World::with(1, 3, &[variables(0, 50, items)]);
    world.run(SECOND * 21 / 20, |_| {});
    let before = world.samples.len();
    let at = world.number;
    world.run(CYCLE, |w| w.plant.memory[1] = 7);
    world.run(3 * CYCLE, |_| {});
    assert_eq!(world.samples.len(), before, "the word waits for its period");
    world.run(CYCLE, |w| w.plant.memory[0] = 1);
    let sample = &world.samples.last().unwrap().1;
    assert_eq!((sample.number, &sample.values[..]), (at + 5, &[1, 7][..]));
}
