//! Recorded streams, in `vectors/streams.json`: `vectors/streams.py`, which shares no code with this implementation,
//! has to make the same samples of them.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};
use technol_wire::message::{
    Item, ItemKind, Mode, Request, Subject, Subscription, TracedLine, TracedRegister,
};
use technol_wire::{MechanismSample, Ran, TraceSample};

use super::variables;
use super::world::{Faults, Random, SECOND, World};

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

fn subscriptions() -> [(&'static str, Subscription); 4] {
    let item = |addr, kind, mode| Item { addr, kind, mode };
    let items = vec![
        item(0, ItemKind::Bit(7), Mode::Value),
        item(1, ItemKind::Bit(0), Mode::Edges),
        item(2, ItemKind::Signed(1), Mode::Extremes),
        item(3, ItemKind::Unsigned(2), Mode::OnChange),
        item(5, ItemKind::Unsigned(4), Mode::Value),
        item(9, ItemKind::Signed(8), Mode::Value),
        item(17, ItemKind::Real, Mode::Extremes),
    ];
    let trace = Subject::Trace { pcs: (0..9).collect(), wide: true };
    let registers = [TracedRegister::Dr32, TracedRegister::Real, TracedRegister::Dr64];
    let lines = (0..9).zip(registers.into_iter().cycle()).map(|(pc, register)| TracedLine { pc, register });
    let lines = lines.collect();
    [
        ("variables", variables(6, 2, items)),
        ("mechanisms", Subscription { id: 1, period: 5, subject: Subject::Mechanisms(vec![4, 0, 2]) }),
        ("trace", Subscription { id: 7, period: 1, subject: trace }),
        ("lines", Subscription { id: 0, period: 3, subject: Subject::Lines(lines) }),
    ]
}

fn live(world: &mut World, random: &mut Random) {
    if random.percent(50) {
        let at = random.below(world.plant.memory.len());
        world.plant.memory[at] = world.plant.memory[at].wrapping_add(random.below(3) as u8);
    }
    if random.percent(4) {
        world.plant.memory.iter_mut().for_each(|b| *b = random.next() as u8);
    }
    if random.percent(20) {
        let now = MechanismSample { active: random.percent(50), resume: 3, line: 41, entered: world.cycle };
        world.plant.mechanisms.insert(random.below(5) as u16, now);
    }
    let ran = if random.percent(80) { Ran::Now } else { Ran::Before };
    let dr = random.next() as i64 >> 40;
    let line = TraceSample { ran, rlo: random.percent(50), dr, dr_real: dr as f64 / 64.0 };
    world.plant.traced.insert(random.below(9) as u32, line);
    // Held now and then.
    if world.number % 80 < 10 {
        world.cycle -= 1;
    }
    let memory = world.plant.memory.clone();
    world.target.streams().observe(&memory);
}

/// A stream over a line that loses frames and brings others late.
fn recorded(name: &str, subscription: &Subscription, seed: u32) -> Value {
    let mut world = World::new(seed, 25);
    world.run(SECOND / 10, |_| {});
    world.host.request(Request::Subscribe(subscription.clone()));
    world.run(SECOND / 10, |_| {});
    world.to_host.faults = Faults { lost: 12, doubled: 8, damaged: 0 };
    let mut random = Random::new(u64::from(seed));
    world.run(6 * SECOND, |w| live(w, &mut random));
    assert!(!world.host.is_lost());
    assert!(!world.stale.is_empty(), "gaps are among them");
    let samples = world.samples.iter().map(|(_, s)| {
        json!({ "number": s.number, "cycle": s.cycle, "values": s.values, "window": s.window, "contiguous": s.contiguous })
    });
    let samples: Vec<Value> = samples.collect();
    let frames: Vec<String> = world.heard.iter().map(|f| hex(f)).collect();
    json!({ "name": name, "subscription": subscription, "frames": frames, "samples": samples })
}

#[test]
fn an_independent_decoder_makes_the_same_samples() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("vectors");
    let file = folder.join("streams.json");
    let vectors: Vec<Value> =
        subscriptions().iter().zip(5..).map(|((n, s), seed)| recorded(n, s, seed)).collect();
    let lines: Vec<String> = vectors.iter().map(Value::to_string).collect();
    let made = format!("[\n{}\n]\n", lines.join(",\n"));
    if std::env::var_os("TECHNOL_BLESS").is_some() {
        std::fs::write(&file, &made).unwrap();
    }
    let kept = std::fs::read_to_string(&file).unwrap_or_default().replace("\r\n", "\n");
    assert!(made == kept, "streams.json is of another implementation (TECHNOL_BLESS=1 writes it anew)");

    let script = folder.join("../tests/vectors/streams.py");
    let python = if cfg!(windows) { "python" } else { "python3" };
    let Ok(output) = Command::new(python).arg("-B").arg(&script).arg(&folder).output() else {
        eprintln!("SKIPPED: {python} is not installed, so nobody else has read the vectors");
        return;
    };
    let said = String::from_utf8_lossy(&output.stdout);
    let complained = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "streams.py disagrees:\n{said}{complained}");
    let count: usize = vectors.iter().map(|v| v["samples"].as_array().map_or(0, Vec::len)).sum();
    assert_eq!(said.trim(), format!("{count} samples agree"));
}
