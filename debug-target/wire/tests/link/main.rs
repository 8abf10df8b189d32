//! Both ends of the protocol on a cable in virtual time.

mod million;
mod model;

use model::World;
use technol_link_model::{Faults, Random};
use technol_wire::message::{Event, Failure, Request, Response};
use technol_wire::{HostEvent, HostSession, LossReason};

const SECOND: u64 = 1_000_000;

/// Names and what goes wrong there; about one frame in ten suffers.
const CABLES: [(&str, Faults); 9] = [
    ("clean", CLEAN),
    ("losing", Faults { frame_lost: 0.12, ..CLEAN }),
    ("doubling", Faults { frame_doubled: 0.4, ..CLEAN }),
    ("reordering", Faults { frame_late: 0.4, ..CLEAN }),
    ("noisy", Faults { bit_error: 1e-4, lost: 2e-4, ..CLEAN }),
    ("inserting", Faults { inserted: 1e-3, ..CLEAN }),
    ("repeating", Faults { repeated: 1e-3, ..CLEAN }),
    ("bursting", Faults { burst: 5e-4, burst_len: 20, ..CLEAN }),
    ("all at once", ALL),
];

const CLEAN: Faults = Faults {
    bit_error: 0.0,
    lost: 0.0,
    inserted: 0.0,
    repeated: 0.0,
    burst: 0.0,
    burst_len: 0,
    frame_lost: 0.0,
    frame_doubled: 0.0,
    frame_late: 0.0,
};

const ALL: Faults = Faults {
    bit_error: 3e-5,
    lost: 1e-4,
    inserted: 1e-4,
    repeated: 1e-4,
    burst: 1e-4,
    burst_len: 12,
    frame_lost: 0.05,
    frame_doubled: 0.1,
    frame_late: 0.1,
};

fn bytes(len: usize, seed: u64) -> Vec<u8> {
    Random::new(seed).bytes(len)
}

#[test]
fn every_request_is_acted_on_once_and_in_order_whatever_the_cable_does() {
    for (name, faults) in CABLES {
        for session in 0..40 {
            let mut world = World::new(session, faults);
            world.connect();
            let requests: Vec<_> =
                (0..30_u32).map(|n| Request::Write { addr: n, bytes: bytes(n as usize * 20, 1) }).collect();
            let tickets: Vec<_> = requests.iter().map(|r| world.host.request(r.clone())).collect();
            let last = tickets[29];
            assert!(
                world.run(60 * SECOND, |w| w.response(last).is_some()),
                "{name} cable, session {session}: {:?}",
                world.seen.back()
            );
            assert_eq!(world.application.acted[1..], requests, "{name} cable, session {session}");
            for ticket in tickets {
                let answers = world.seen.iter();
                let answers =
                    answers.filter(|(_, e)| matches!(e, HostEvent::Response(t, _) if *t == ticket)).count();
                assert_eq!(answers, 1, "{name} cable, session {session}");
            }
        }
    }
}

#[test]
fn long_answers_arrive_whole() {
    for (name, faults) in CABLES {
        for session in 0..20 {
            let mut world = World::new(session, faults);
            world.connect();
            let ticket = world.host.request(Request::Read { pieces: vec![(0, 3000), (9, 1000)] });
            assert!(
                world.run(60 * SECOND, |w| w.response(ticket).is_some()),
                "{name} cable, session {session}"
            );
            let expected = Response::Memory { cycle: 0, bytes: vec![0xA5; 4000] };
            assert_eq!(world.response(ticket), Some(&expected), "{name} cable, session {session}");
        }
    }
}

#[test]
fn events_arrive_once_and_in_order_whatever_the_cable_does() {
    for (name, faults) in CABLES {
        for session in 0..40 {
            let mut world = World::new(session, faults);
            world.connect();
            let sent: Vec<_> = (0..40).map(|n| Event::Log("x".repeat(n * 17))).collect();
            for event in &sent {
                world.target.event(event);
            }
            let count = |w: &World| w.seen.iter().filter(|(_, e)| matches!(e, HostEvent::Event(_))).count();
            assert!(world.run(60 * SECOND, |w| count(w) >= 40), "{name} cable, session {session}");
            world.run(world.now + SECOND, |_| false);
            let seen: Vec<_> = world
                .seen
                .iter()
                .filter_map(|(_, e)| if let HostEvent::Event(e) = e { Some(e.clone()) } else { None })
                .collect();
            assert_eq!(seen, sent, "{name} cable, session {session}");
        }
    }
}

#[test]
fn a_download_arrives_byte_for_byte_while_requests_are_answered() {
    for (name, faults) in CABLES {
        for session in 0..10 {
            let program = bytes(20_000, u64::from(session));
            let mut world = World::new(session, faults);
            world.connect();
            world.host.request(Request::Download { len: program.len() as u32, hash: [0; 16] });
            world.host.download(program.clone());
            let status = world.host.request(Request::Status);
            let done = |w: &World| w.seen.iter().any(|(_, e)| *e == HostEvent::DownloadDone);
            assert!(world.run(120 * SECOND, done), "{name} cable, session {session}");
            assert!(world.target.download_complete(), "{name} cable, session {session}");
            assert!(world.application.download == program, "{name} cable, session {session}");
            assert!(world.response(status).is_some());
            let progress = world.seen.iter().filter_map(|(_, e)| match e {
                HostEvent::DownloadProgress { done, total: 20_000 } => Some(*done),
                _ => None,
            });
            let progress: Vec<_> = progress.collect();
            assert!(progress.is_sorted() && progress.last() == Some(&20_000), "{progress:?}");
        }
    }
}

#[test]
fn a_download_uses_the_cable_fully() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    let begin = world.now;
    let program = bytes(50_000, 3);
    world.host.request(Request::Download { len: 50_000, hash: [0; 16] });
    world.host.download(program);
    assert!(world.run(60 * SECOND, |w| w.seen.iter().any(|(_, e)| *e == HostEvent::DownloadDone)));
    let least = 50_000 * 868 / 10;
    let took = world.now - begin;
    assert!(took < least * 110 / 100, "{took} µs for {least} µs worth of bytes");
}

#[test]
fn an_event_does_not_wait_for_a_download() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    world.host.request(Request::Download { len: 50_000, hash: [0; 16] });
    world.host.download(bytes(50_000, 3));
    world.run(world.now + SECOND, |_| false);
    world.target.event(&Event::Resumed);
    let sent = world.now;
    assert!(world.run(10 * SECOND, |w| w.seen.iter().any(|(_, e)| *e == HostEvent::Event(Event::Resumed))));
    assert!(world.now - sent < 10_000, "{} µs", world.now - sent);
}

#[test]
fn a_cut_cable_is_noticed_within_a_second_at_both_ends() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    world.run(3 * SECOND, |_| false);
    assert!(!world.host.is_lost(), "an idle link is no dead link");
    world.cable.set_cut(true);
    world.run(4 * SECOND, |_| false);
    let lost = world.seen.iter().find(|(_, e)| *e == HostEvent::LinkLost(LossReason::Silent));
    assert!(lost.is_some_and(|(at, _)| *at <= 4 * SECOND), "{:?}", world.seen);
    assert!(world.application.host_lost_at.is_some_and(|at| at <= 4 * SECOND));
}

#[test]
fn a_target_that_is_not_there_is_noticed_within_a_second() {
    let mut host = HostSession::new(1);
    let mut now = 0;
    while let Some(next) = host.poll(now) {
        let _ = host.transmit();
        now = next.max(now + 1);
    }
    assert!(now <= SECOND, "{now}");
    assert_eq!(host.next(), Some(HostEvent::LinkLost(LossReason::Silent)));
    assert_eq!(host.next(), None);
}

#[test]
fn a_noisy_idle_cable_is_not_taken_for_dead() {
    for session in 0..10 {
        let mut world = World::new(session, Faults { frame_lost: 0.2, ..CLEAN });
        world.connect();
        world.run(30 * SECOND, |_| false);
        assert!(!world.host.is_lost(), "session {session}");
        assert_eq!(world.application.host_lost_at, None, "session {session}");
    }
}

#[test]
fn an_idle_link_costs_less_than_two_percent_of_the_cable() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    let before = (world.cable.to_target.bytes, world.cable.to_host.bytes);
    world.run(world.now + 10 * SECOND, |_| false);
    let per_second =
        ((world.cable.to_target.bytes - before.0) / 10, (world.cable.to_host.bytes - before.1) / 10);
    assert!(per_second.0 < 230 && per_second.1 < 230, "{per_second:?}");
}

#[test]
fn a_second_host_gets_a_fresh_session() {
    let mut world = World::new(5, Faults::default());
    world.connect();
    for _ in 0..3 {
        world.host.request(Request::Status);
    }
    world.run(SECOND, |_| false);
    world.target.event(&Event::Log("for the first host".into()));

    // The same first request number as the old session, which the target has already answered.
    world.host = HostSession::new(5 + 256);
    world.seen.clear();
    world.connect();
    let ticket = world.host.request(Request::Status);
    assert!(world.run(world.now + SECOND, |w| w.response(ticket).is_some()));
    world.target.event(&Event::Resumed);
    world.run(world.now + SECOND, |_| false);
    let events: Vec<_> = world.seen.iter().filter(|(_, e)| matches!(e, HostEvent::Event(_))).collect();
    assert!(matches!(events[..], [(_, HostEvent::Event(Event::Resumed))]), "{events:?}");
}

#[test]
fn a_refused_download_is_not_sent() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    let len = model::MOST_DOWNLOAD + 1;
    let ticket = world.host.request(Request::Download { len, hash: [0; 16] });
    world.host.download(vec![1; len as usize]);
    world.run(world.now + SECOND, |_| false);
    assert_eq!(world.response(ticket), Some(&Response::Failed(Failure::TooLarge)));
    assert!(world.cable.to_target.bytes < 1000, "{}", world.cable.to_target.bytes);
    assert!(!world.seen.iter().any(|(_, e)| matches!(e, HostEvent::DownloadDone)));
}

#[test]
fn a_request_that_is_longer_than_any_message_is_refused_at_this_end() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    let ticket = world.host.request(Request::Write { addr: 0, bytes: vec![0; 40_000] });
    world.run(world.now + SECOND, |w| w.response(ticket).is_some());
    assert_eq!(world.response(ticket), Some(&Response::Failed(Failure::TooLarge)));
    assert!(!world.application.acted.iter().any(|r| matches!(r, Request::Write { .. })));
}

#[test]
fn too_many_messages_are_counted_and_the_loss_is_told() {
    let mut world = World::new(1, Faults::default());
    world.connect();
    let message =
        |n| Event::Message { cycle: 0, number: n, sub_id: None, set: true, parameters: vec![], pc: 0 };
    for n in 0..1000 {
        world.target.event(&message(n));
    }
    world.target.event(&Event::Resumed);
    world.run(world.now + 3 * SECOND, |_| false);
    world.target.event(&message(9999));
    world.run(world.now + SECOND, |_| false);
    let events: Vec<_> = world
        .seen
        .iter()
        .filter_map(|(_, e)| if let HostEvent::Event(e) = e { Some(e.clone()) } else { None })
        .collect();
    assert!(events.contains(&Event::Resumed), "a change of state is never dropped");
    let dropped =
        1000 - events.iter().filter(|e| matches!(e, Event::Message { number: 0..1000, .. })).count();
    assert!(dropped > 0);
    assert!(
        events.contains(&Event::Log(format!("{dropped} messages were lost: the link is too slow for them"))),
        "{dropped} {:?}",
        events.last()
    );
    assert_eq!(events.last(), Some(&message(9999)));
}
