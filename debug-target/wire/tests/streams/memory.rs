//! A controller has no memory to spare in a cycle.

use allocation_counter::measure;
use technol_wire::Streams;
use technol_wire::message::{ItemKind, Mode, Subject, Subscription};

use super::world::Plant;
use super::{bits_and_double_words, item, variables};

#[test]
fn samples_are_taken_without_asking_for_memory() {
    let mut plant = Plant { memory: vec![0; 60], ..Plant::default() };
    let mut items = bits_and_double_words(16, 8);
    for (at, mode) in [(0, Mode::Edges), (17, Mode::Extremes), (18, Mode::OnChange)] {
        items[at].mode = mode;
    }
    items.push(item(50, ItemKind::Real));
    let mut streams = Streams::default();
    streams.subscribe(&variables(0, 2, items), 240, &plant).unwrap();
    let subject = Subject::Mechanisms((0..10).collect());
    streams.subscribe(&Subscription { id: 1, period: 1, subject }, 240, &plant).unwrap();
    let subject = Subject::Trace { pcs: (0..10).collect(), wide: true };
    streams.subscribe(&Subscription { id: 2, period: 1, subject }, 240, &plant).unwrap();
    for number in 0..100 {
        plant.memory[number as usize % 60] ^= 0x55;
        let used = measure(|| {
            streams.observe(&plant.memory);
            streams.sample(number, number, &plant);
        });
        assert_eq!(used.count_total, 0, "sample {number}");
    }
}
