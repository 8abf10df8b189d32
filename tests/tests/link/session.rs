//! A debug session of an editor, over a cable that damages one bit in ten thousand and is cut for a second every
//! twenty: nothing that is shown is wrong, nothing is done twice, and it comes to its end.

use std::sync::Arc;
use std::time::Duration;

use serde_json::{Value, json};
use technol_dap::client::{Client, Mark};
use technol_dap::{FileBuilder, Surroundings};
use technol_link_model::{Cuts, Faults, LineOptions};
use technol_target::TargetOptions;
use technol_wire::frame::kind;

use crate::lathe::Lathe;
use crate::patient::{ask, step};
use crate::probe::SECOND;
use crate::world::Shared;

/// Executed in each cycle.
const PLACE: &str = "WR   ESTOP_SEEN";
/// Between two steps of a user, in virtual microseconds.
const THINKING: u64 = 200_000;
/// Numbers of requests.
const REGISTERS: Option<u8> = Some(10);
const CALL_STACK: Option<u8> = Some(15);

pub(crate) fn editor(shared: &Shared) -> Client {
    let surroundings = Surroundings { connector: Arc::new(shared.clone()), builder: Arc::new(FileBuilder) };
    let mut client = Client::in_process(&surroundings).expect("an adapter");
    client.set_patience(Duration::from_secs(60));
    client
}

pub(crate) fn lathe_machine(lathe: &Lathe) -> TargetOptions {
    let machine = technol_target::load_machine(std::path::Path::new(&lathe.path("machine.toml")));
    TargetOptions { machine: Some(machine.expect("the lathe has one")), ..TargetOptions::default() }
}

pub(crate) fn launch(lathe: &Lathe) -> Value {
    json!({
        "program": lathe.folder(), "target": "serial:modelled", "onLinkLost": "stayStopped", "reconnect": 60,
    })
}

#[test]
fn a_whole_session_on_a_bad_cable() {
    let lathe = Lathe::copy();
    let line = LineOptions {
        faults: Faults::bit_errors(1e-4),
        cuts: Some(Cuts { every_us: 20 * SECOND, len_us: SECOND }),
        ..LineOptions::default()
    };
    let shared = Shared::new(line, lathe_machine(&lathe));
    let mut editor = editor(&shared);
    let main = lathe.path("main.plc");
    let place = lathe.line("main.plc", PLACE);
    editor.start(launch(&lathe), &[(&main, &[place])]).expect("the program starts");
    let stopped = editor.event(Mark::START, "stopped").expect("the break-point");
    assert_eq!(stopped["reason"], "breakpoint");
    let mut thread = stopped["threadId"].as_i64().expect("a thread");
    let watches = json!({ "period": 100, "watches": [{ "expression": "CYCLES" }] });
    ask(&mut editor, "technol/subscribe", &watches);

    for n in 0..500 {
        thread = step(&mut editor, thread);
        shared.think(THINKING);
        if n % 20 == 0 {
            // What is shown is what is in the machine.
            let shown = ask(&mut editor, "evaluate", &json!({ "expression": "DR64", "context": "watch" }));
            let world = shared.world();
            let registers = world.core.simulation().expect("a program").runtime().registers();
            let shown = shown["result"].as_str().expect("a value");
            assert!(shown.starts_with(&registers.dr.to_string()), "{shown} is not {}", registers.dr);
        }
        if n % 30 == 0 {
            // Set, and read back: also when the first try got no answer.
            let value = n * 3 + 1;
            let set = json!({ "expression": "BX", "value": value.to_string() });
            ask(&mut editor, "setExpression", &set);
            let world = shared.world();
            let bx = world.core.simulation().expect("a program").runtime().registers().bx;
            assert_eq!(bx, value);
        }
    }
    let mark = editor.mark();
    ask(
        &mut editor,
        "setBreakpoints",
        &json!({ "source": { "path": main }, "breakpoints": [{ "line": place }] }),
    );
    ask(&mut editor, "continue", &json!({ "threadId": thread }));
    let again = editor.event_where(mark, "stopped", |b| b["reason"] == "breakpoint");
    again.expect("the break-point is still there");
    // So is the watch: it shows this stop, after all the cuts.
    shared.think(2 * SECOND);
    let shown = ask(&mut editor, "evaluate", &json!({ "expression": "CYCLES", "context": "watch" }));
    let shown = shown["result"].as_str().expect("a value").to_owned();
    let is_it = |b: &Value| b["watches"][0]["stale"] == false && b["watches"][0]["value"] == shown.as_str();
    editor.event_where(mark, "technol/watch", is_it).expect("the watch goes on");
    let world = shared.world();
    // It was really cut, and not in vain.
    assert!(world.now > 80 * SECOND && world.opened > 3, "{} s, {} links", world.now / SECOND, world.opened);
}

#[test]
fn an_editor_hears_of_a_cut_within_a_second_and_finds_its_stop_again() {
    let lathe = Lathe::copy();
    let shared = Shared::new(LineOptions::default(), lathe_machine(&lathe));
    let mut editor = editor(&shared);
    let main = lathe.path("main.plc");
    let place = lathe.line("main.plc", PLACE);
    editor.start(launch(&lathe), &[(&main, &[place])]).expect("the program starts");
    editor.event(Mark::START, "stopped").expect("the break-point");

    let mark = editor.mark();
    let cut_at = {
        let mut world = shared.world();
        world.cable.set_cut(true);
        world.now
    };
    let lost = editor.event_where(mark, "output", |b| b["category"] == "important").expect("it is told");
    let text = lost["output"].as_str().expect("a text");
    assert!(text.starts_with("the link to the target is lost") && text.contains("stays so"), "{text}");
    // No time passes without a link, but for the tries to open one.
    let heard_at = shared.world().now;
    assert!(heard_at - cut_at <= SECOND + 200_000, "{} µs", heard_at - cut_at);
    let refused = editor.request("stackTrace", json!({ "threadId": 1 }));
    drop(refused); // the stack came along with the stop, so it may be there

    shared.world().cable.set_cut(false);
    let back = |b: &Value| b["output"].as_str().is_some_and(|t| t.contains("is back"));
    editor.event_where(mark, "output", back).expect("the link is back");
    let stopped = editor.event(mark, "stopped").expect("the stop is told again");
    let thread = stopped["threadId"].as_i64().expect("a thread");
    let mark = editor.mark();
    ask(&mut editor, "continue", &json!({ "threadId": thread }));
    let next = editor.event(mark, "stopped").expect("the break-point is armed again");
    assert_eq!(next["reason"], "breakpoint");
}

#[test]
fn a_stop_is_shown_without_any_further_question() {
    let lathe = Lathe::copy();
    let shared = Shared::new(LineOptions::default(), lathe_machine(&lathe));
    let mut editor = editor(&shared);
    let main = lathe.path("main.plc");
    let place = lathe.line("main.plc", PLACE);
    editor.start(launch(&lathe), &[(&main, &[place])]).expect("the program starts");
    let stopped = editor.event(Mark::START, "stopped").expect("the break-point");
    let mut thread = stopped["threadId"].as_i64().expect("a thread");
    for _ in 0..10 {
        let from = shared.world().passed.len();
        thread = step(&mut editor, thread);
        let frame = editor.top_frame(thread).expect("a frame");
        let registers = editor.scope(&frame, "Registers").expect("the registers");
        assert!(!registers.is_empty());
        let world = shared.world();
        let passed = &world.passed[from..];
        let asked: Vec<_> = passed.iter().filter(|f| f.from_host && f.kind == kind::REQUEST).collect();
        // The mechanisms may be asked for, to tell their threads; stack and registers came along.
        assert!(asked.iter().all(|f| ![REGISTERS, CALL_STACK].contains(&f.what)), "{passed:?}");
        let stop = passed.iter().find(|f| !f.from_host && f.kind == kind::EVENT).expect("the stop");
        assert!(stop.at - asked[0].at <= 6_000, "{} µs", stop.at - asked[0].at);
    }
}

#[test]
fn watches_of_a_running_program_go_on_after_a_cut_and_are_stale_meanwhile() {
    let lathe = Lathe::copy();
    let shared = Shared::new(LineOptions::default(), lathe_machine(&lathe));
    let mut editor = editor(&shared);
    editor.start(launch(&lathe), &[]).expect("the program starts");
    let watches = json!({ "period": 100, "watches": [{ "expression": "CYCLES" }] });
    editor.request("technol/subscribe", watches).expect("a subscription");
    let fresh = |b: &Value| b["watches"][0]["stale"] == false;
    let first = editor.event_where(Mark::START, "technol/watch", fresh).expect("values");
    let cycle = |b: &Value| b["watches"][0]["cycle"].as_u64().unwrap_or(0);

    let mark = editor.mark();
    shared.world().cable.set_cut(true);
    let lost = |b: &Value| b["output"].as_str().is_some_and(|t| t.contains("link to the target is lost"));
    editor.event_where(mark, "output", lost).expect("it is told");
    let stale = |b: &Value| b["watches"][0]["stale"] == true;
    editor.event_where(mark, "technol/watch", stale).expect("what is shown is marked");
    shared.world().cable.set_cut(false);
    let back = |b: &Value| b["output"].as_str().is_some_and(|t| t.contains("is back"));
    editor.event_where(mark, "output", back).expect("the link is back");
    let mark = editor.mark();
    let later = editor
        .event_where(mark, "technol/watch", |b| fresh(b) && cycle(b) > cycle(&first) + 40)
        .expect("values again");
    let value = later["watches"][0]["value"].as_str().expect("a value");
    let count: u64 = value.split(' ').next().and_then(|n| n.parse().ok()).expect("a number");
    assert!(count.abs_diff(cycle(&later)) < 10, "value and cycle belong together: {later}");
}
