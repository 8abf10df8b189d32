//! Streams: what they cost on the line, and that they never show what was not.
#![allow(clippy::unwrap_used)] // tests

mod bars;
mod memory;
mod truth;
mod vectors;
mod world;

use technol_wire::message::{Item, ItemKind, Mode, Subject, Subscription};

fn item(addr: usize, kind: ItemKind) -> Item {
    Item { addr: addr as u32, kind, mode: Mode::Value }
}

/// So many bits, eight in a byte, and double words behind them.
fn bits_and_double_words(bits: usize, words: usize) -> Vec<Item> {
    let bit = |n: usize| item(n / 8, ItemKind::Bit((n % 8) as u8));
    let base = bits.div_ceil(8);
    (0..bits).map(bit).chain((0..words).map(|n| item(base + n * 4, ItemKind::Unsigned(4)))).collect()
}

fn variables(id: u8, period: u16, items: Vec<Item>) -> Subscription {
    Subscription { id, period, subject: Subject::Variables(items) }
}
