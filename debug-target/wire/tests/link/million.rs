//! Very many frames under each kind of fault. As many as `TECHNOL_FRAMES` says for each; `cargo xtask bench` asks for
//! a million in a release build.

use technol_link_model::{Cable, Cuts, Fault, Faults, LineOptions, Random};
use technol_wire::frame::{self, Frame, FrameDecoder};
use technol_wire::message::{Event, Request, Response};
use technol_wire::{HostEvent, LossReason};

use crate::model::World;
use crate::{CABLES, SECOND};

fn frames_asked_for() -> u64 {
    let asked = std::env::var("TECHNOL_FRAMES").ok().map(|n| n.parse().expect("TECHNOL_FRAMES is a number"));
    asked.unwrap_or(1_500)
}

fn any_frame(random: &mut Random) -> Frame {
    // Many short ones and some long ones, as on a real link.
    let longest = [4, 12, 40, 240][random.below(4)];
    let len = random.below(longest + 1);
    let mut payload = random.bytes(len);
    // Zeros are what the stuffing is about.
    for byte in &mut payload {
        if random.below(4) == 0 {
            *byte = 0;
        }
    }
    Frame { kind: random.below(256) as u8, seq: random.below(256) as u8, payload }
}

fn encoded(frames: &[Frame]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for frame in frames {
        frame::encode(frame.kind, frame.seq, &frame.payload, &mut bytes);
    }
    bytes
}

fn accepted(bytes: &[u8]) -> Vec<Frame> {
    let mut decoder = FrameDecoder::new(240);
    bytes.iter().filter_map(|b| decoder.push(*b)).filter_map(Result::ok).collect()
}

/// How many of the frames sent are missing; panics when one came that was not sent.
fn missing(sent: &[Frame], accepted: &[Frame], what: &str) -> usize {
    let mut rest = sent.iter();
    for frame in accepted {
        assert!(rest.any(|s| s == frame), "{what}: {frame:?} was never sent (there)");
    }
    sent.len() - accepted.len()
}

#[test]
fn one_fault_costs_two_frames_at_most_and_makes_none_up() {
    const TOGETHER: u64 = 10;
    for fault in Fault::KINDS {
        let mut random = Random::new(1);
        for _ in 0..frames_asked_for().div_ceil(TOGETHER) {
            let sent: Vec<_> = (0..TOGETHER).map(|_| any_frame(&mut random)).collect();
            let mut bytes = encoded(&sent);
            let at = random.below(bytes.len());
            fault.strike(&mut bytes, at, &mut random);
            let lost = missing(&sent, &accepted(&bytes), &format!("{fault:?}"));
            // The very last delimiter has no frame behind it that would end the last frame.
            assert!(lost <= 2, "{fault:?} at {at} cost {lost} frames of {sent:?}");
        }
    }
}

#[test]
fn nothing_is_taken_for_a_frame_that_was_not_sent() {
    let none = Faults::default();
    // Every second frame or so is hit, most of them more than once.
    let kinds = [
        Faults { bit_error: 3e-3, ..none },
        Faults { lost: 2e-2, ..none },
        Faults { inserted: 2e-2, ..none },
        Faults { repeated: 2e-2, ..none },
        Faults { burst: 5e-3, burst_len: 20, ..none },
        Faults {
            bit_error: 1e-3,
            lost: 5e-3,
            inserted: 5e-3,
            repeated: 5e-3,
            burst: 1e-3,
            burst_len: 9,
            ..none
        },
    ];
    for faults in kinds {
        let mut cable = Cable::new(LineOptions { faults, ..LineOptions::default() }, 5);
        let mut random = Random::new(2);
        let (mut sent_in_all, mut lost) = (0, 0);
        while sent_in_all < frames_asked_for() {
            let sent: Vec<_> = (0..200).map(|_| any_frame(&mut random)).collect();
            cable.to_host.send(0, &encoded(&sent));
            let arrived = cable.to_host.arrived(u64::MAX);
            lost += missing(&sent, &accepted(&arrived), &format!("{faults:?}"));
            sent_in_all += 200;
        }
        let share = lost as f64 / sent_in_all as f64;
        assert!((0.2..0.98).contains(&share), "{faults:?} should hit about half of the frames, not {share}");
    }
}

/// Commands, events and a download over one session, until all is done or the link is lost.
fn session(seed: u32, line: LineOptions, what: &str) -> u64 {
    let mut random = Random::new(u64::from(seed));
    let mut world = World::on(seed, line);
    let _ = world.host.hello();
    let commands: Vec<_> = (0..30)
        .map(|n| {
            let len = random.below(300);
            Request::Write { addr: n, bytes: random.bytes(len) }
        })
        .collect();
    let tickets: Vec<_> = commands.iter().map(|c| world.host.request(c.clone())).collect();
    let program = random.bytes(4000);
    let download = world.host.request(Request::Download { len: 4000, hash: [0; 16] });
    world.host.download(program.clone());
    let last = world.host.request(Request::Status);
    let lost = |w: &World| w.host.is_lost();
    let open = |w: &World| w.target.is_open();
    world.run(60 * SECOND, |w| lost(w) || open(w));
    let events: Vec<_> = (0..10).map(|n| Event::Log(n.to_string())).collect();
    for event in &events {
        world.target.event(event);
    }
    let has_all = |w: &World| {
        let is_event = |e: &&(u64, HostEvent)| matches!(e.1, HostEvent::Event(_));
        w.response(last).is_some()
            && w.seen.iter().any(|(_, e)| *e == HostEvent::DownloadDone)
            && w.seen.iter().filter(is_event).count() >= events.len()
    };
    let done = world.run(600 * SECOND, |w| lost(w) || has_all(w));
    assert!(done, "{what}, session {seed}: neither done nor lost");

    // What was acted on, in order, each once; everything that was answered is among it.
    let acted: Vec<_> =
        world.application.acted.iter().filter(|r| matches!(r, Request::Write { .. })).collect();
    assert!(acted.len() <= commands.len(), "{what}, session {seed}");
    assert!(
        acted.iter().zip(&commands).all(|(a, c)| *a == c),
        "{what}, session {seed}: out of order or twice"
    );
    for (at, ticket) in tickets.iter().enumerate() {
        match world.response(*ticket) {
            Some(response) => {
                assert!(*response == Response::Done && at < acted.len(), "{what}, session {seed}");
            }
            None => assert!(world.host.is_lost(), "{what}, session {seed}: a command without an answer"),
        }
    }
    let heard: Vec<_> = world
        .seen
        .iter()
        .filter_map(|(_, e)| if let HostEvent::Event(e) = e { Some(e.clone()) } else { None })
        .collect();
    assert!(events.starts_with(&heard), "{what}, session {seed}: {heard:?}");
    if world.seen.iter().any(|(_, e)| *e == HostEvent::DownloadDone) {
        assert_eq!(world.response(download), Some(&Response::Done));
        assert!(world.application.download == program, "{what}, session {seed}: another program arrived");
    }
    world.cable.to_host.frames + world.cable.to_target.frames
}

#[test]
fn commands_act_once_or_are_reported_failed_and_downloads_arrive_as_they_were() {
    for (name, faults) in CABLES {
        let (mut frames, mut seed) = (0, 0);
        while frames < frames_asked_for() {
            frames += session(seed, LineOptions { faults, ..LineOptions::default() }, name);
            seed += 1;
        }
    }
}

#[test]
fn the_same_on_a_cable_that_is_cut_again_and_again() {
    for (every_us, len_us) in [(2 * SECOND, 400_000), (3 * SECOND, 1_200_000)] {
        let cuts = Some(Cuts { every_us, len_us });
        let faults = Faults::bit_errors(3e-5);
        let (mut frames, mut seed) = (0, 0);
        while frames < frames_asked_for() {
            frames += session(seed, LineOptions { faults, cuts, ..LineOptions::default() }, "cut");
            seed += 1;
        }
    }
}

#[test]
fn the_host_says_so_when_the_target_has_given_it_up() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    // Only the way there is cut: the target hears nothing and ends the session; the host hears events until then.
    world.cable.to_target.cut = true;
    for n in 0..100 {
        world.target.event(&Event::Log(n.to_string()));
        let until = world.now + 20_000;
        world.run(until, |w| w.application.host_lost_at.is_some());
    }
    assert!(world.application.host_lost_at.is_some());
    world.cable.to_target.cut = false;
    world.host.request(Request::Status);
    let began = world.now;
    assert!(world.run(began + 2 * SECOND, |w| w.host.is_lost()), "{:?}", world.seen.back());
    assert!(world.now - began < SECOND);
    let last = world.seen.back().map(|(_, e)| e.clone());
    assert_eq!(last, Some(HostEvent::LinkLost(LossReason::Forgotten)));
}
