//! Each predefined symbol with memory is moved by the model, as its direction demands, or stands in a list with the reason
//! why not (manual 8 to 27).
//!
//! A symbol that the control writes must change by itself in one of the [scenes]; one that it reads must change what
//! happens there when it has another value. Both are seen by running the scenes, so nothing here repeats how the
//! model does it. Constants, positions of bits and members of structures have no memory of their own.

#[path = "../common/frame.rs"]
mod frame;

mod elements;
mod exempt;
mod probe;
mod scene;
mod scenes;

use std::collections::BTreeMap;

use technol_analysis::catalogue::{Direction, SystemSymbol, block_members, symbols};

use exempt::{Exemption, Way};
use probe::{Bits, acts, bits_of, moved_by_itself};
use scene::Scene;

/// What has memory, with its bits.
fn with_memory() -> Vec<(&'static SystemSymbol, Bits)> {
    symbols().filter_map(|symbol| Some((symbol, bits_of(&symbol.kind)?))).collect()
}

fn is_written(symbol: &SystemSymbol) -> bool {
    symbol.direction != Direction::PlcToCnc
}

fn is_read(symbol: &SystemSymbol) -> bool {
    symbol.direction != Direction::CncToPlc
}

fn scene(name: &str) -> Scene {
    let mut all = scenes::all().into_iter();
    all.find(|scene| scene.name == name).unwrap_or_else(|| panic!("no scene is called {name}"))
}

/// The names, in lines of a report.
fn listed<'n>(names: impl IntoIterator<Item = &'n str>) -> String {
    names.into_iter().collect::<Vec<_>>().join(" ")
}

#[test]
fn what_the_control_writes_changes_by_itself() {
    let moved = moved_by_itself(&scenes::all());
    let exempt = Exemption::names(Way::Written);
    let (mut still, mut stale) = (Vec::new(), Vec::new());
    for (symbol, bits) in with_memory().iter().filter(|(symbol, _)| is_written(symbol)) {
        match (bits.meets(&moved), exempt.contains(symbol.spelling)) {
            (false, false) => still.push(symbol.spelling),
            (true, true) => stale.push(symbol.spelling),
            _ => {}
        }
    }
    assert!(still.is_empty(), "nothing writes: {}", listed(still));
    assert!(stale.is_empty(), "written now, take the exemption away: {}", listed(stale));
}

#[test]
fn what_the_control_reads_changes_what_it_does() {
    let exempt = Exemption::names(Way::Read);
    let mut dead = Vec::new();
    // Scenes are prepared once for all symbols that they show.
    let mut shown: BTreeMap<&str, Vec<(&SystemSymbol, Bits)>> = BTreeMap::new();
    for (symbol, bits) in with_memory().into_iter().filter(|(symbol, _)| is_read(symbol)) {
        if exempt.contains(symbol.spelling) {
            continue;
        }
        match scenes::of(symbol.spelling) {
            Some(name) => shown.entry(name).or_default().push((symbol, bits)),
            None => dead.push(format!("{} (in no scene)", symbol.spelling)),
        }
    }
    for (name, symbols) in shown {
        let scene = scene(name);
        let baseline = scene.run();
        dead.extend(
            symbols
                .iter()
                .filter(|(_, bits)| !acts(&scene, &baseline, bits))
                .map(|(symbol, _)| format!("{} ({name})", symbol.spelling)),
        );
    }
    assert!(dead.is_empty(), "nothing reads: {}", dead.join(", "));
}

#[test]
fn what_is_exempt_from_reading_is_not_read() {
    let exempt = Exemption::names(Way::Read);
    let all: Vec<(&SystemSymbol, Bits)> =
        with_memory().into_iter().filter(|(symbol, _)| exempt.contains(symbol.spelling)).collect();
    for scene in scenes::all() {
        let baseline = scene.run();
        let together = all.iter().fold(Bits::default(), |together, (_, bits)| together.with(bits));
        if !acts(&scene, &baseline, &together) {
            continue;
        }
        let stale = all.iter().filter(|(_, bits)| acts(&scene, &baseline, bits));
        let stale = listed(stale.map(|(symbol, _)| symbol.spelling));
        panic!("read now in the scene {}, take the exemption away: {stale}", scene.name);
    }
}

/// What a block of the model cannot have: there is no M group 0, nor are there ramps of its own.
const NOT_PROGRAMMED: [&str; 4] = ["M0", "FeedCriterial", "ParabAccel", "LinearAccel"];

#[test]
fn every_member_of_a_block_is_written() {
    let moved = moved_by_itself(&scenes::all()[..4]);
    let record = technol_image::system::BLOCK_RECORDS as usize;
    let still = block_members().filter(|member| {
        let bits = bits_of(&member.kind).expect("members have memory");
        bits.meets(&moved[record..]) == NOT_PROGRAMMED.contains(&member.spelling)
    });
    let still = listed(still.map(|member| member.spelling));
    assert!(still.is_empty(), "not written, or written now: {still}");
}

#[test]
fn exemptions_name_symbols_and_the_way_they_go() {
    let symbols = with_memory();
    for it in exempt::EXEMPT {
        assert!(!it.why.is_empty(), "{}", it.symbols);
        for pattern in it.symbols.split_whitespace() {
            let named = |(symbol, _): &&(&SystemSymbol, Bits)| exempt::fits(pattern, symbol.spelling);
            let named: Vec<_> = symbols.iter().filter(named).collect();
            assert!(!named.is_empty(), "{pattern} names nothing with memory");
            for (symbol, _) in named {
                let goes = match it.way {
                    Way::Written => is_written(symbol),
                    Way::Read => is_read(symbol),
                };
                assert!(goes, "{pattern}: {} is not {:?} anyway", symbol.spelling, it.way);
            }
        }
    }
}
