//! The target, the debugger or the cable goes, in each phase: the other side notices within a second, the machine does
//! what was agreed, and everything goes on afterwards.

use technol_image::container::{content_hash, hash_bytes};
use technol_link_model::LineOptions;
use technol_target::TargetOptions;
use technol_wire::LossReason;
use technol_wire::message::{LostPolicy, PlcState, Request};

use crate::probe::{Probe, SECOND};
use crate::program::{STORE, counter};
use crate::world::World;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Idle,
    Running,
    Stopped,
    Downloading,
}

const PHASES: [Phase; 4] = [Phase::Idle, Phase::Running, Phase::Stopped, Phase::Downloading];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Victim {
    Target,
    Host,
    Cable,
}

/// What is downloaded in that phase: long enough for three seconds.
fn long() -> Vec<u8> {
    (0..33_000_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 9) as u8).collect()
}

fn announce(probe: &mut Probe, world: &mut World) {
    probe.tell(world, Request::Download { len: long().len() as u32, hash: hash_bytes(&long()) });
    probe.downloaded = false;
    probe.host.download(long());
}

fn brought_to(phase: Phase, policy: LostPolicy) -> (World, Probe) {
    let mut world = World::new(LineOptions::default(), TargetOptions::default());
    let mut probe = Probe::connect(&mut world, 1);
    probe.tell(&mut world, Request::OnLinkLost(policy));
    if phase != Phase::Idle {
        probe.load(&mut world, &counter());
    }
    match phase {
        Phase::Idle => {}
        Phase::Running => probe.run(&mut world, SECOND / 2),
        Phase::Stopped => {
            probe.ask(&mut world, Request::SetBreakpoints { pcs: vec![STORE] });
            probe.stopped(&mut world);
        }
        Phase::Downloading => {
            announce(&mut probe, &mut world);
            probe.run(&mut world, 2 * SECOND);
            assert!(!probe.downloaded);
        }
    }
    (world, probe)
}

fn happens(victim: Victim, phase: Phase, policy: LostPolicy) {
    let what = format!("{victim:?} {phase:?} {policy:?}");
    let (mut world, mut probe) = brought_to(phase, policy);
    let before = world.core.status();
    let at = world.now;
    match victim {
        Victim::Target => world.power = false,
        Victim::Cable => world.cable.set_cut(true),
        Victim::Host => {}
    }
    if victim == Victim::Host {
        // It says nothing any more; what it has handed over to its serial port still goes out.
        let until = at + SECOND + world.cable.to_target.backlog(at) * 87;
        while world.now < until {
            world.receive(&mut [0; 4096], until - world.now);
        }
    } else {
        probe.run(&mut world, SECOND);
        let lost = probe.lost.unwrap_or_else(|| panic!("{what}: the host has not noticed"));
        assert!(lost.0 - at <= SECOND && lost.1 == LossReason::Silent, "{what}: {lost:?} after {at}");
    }

    if victim == Victim::Target {
        world.restart(LineOptions::default(), TargetOptions::default());
    } else {
        // A second after the last word: the machine has done what was agreed.
        let status = world.core.status();
        let held = phase == Phase::Stopped && policy == LostPolicy::StayStopped;
        assert_eq!(status.held, held, "{what}");
        if phase == Phase::Stopped && policy == LostPolicy::StopPlc {
            assert!(matches!(status.plc, PlcState::Stopping | PlcState::Stopped), "{what}: {status:?}");
        } else {
            assert_eq!(status.plc, before.plc, "{what}");
        }
    }
    world.cable.set_cut(false);
    goes_on(&mut world, victim, phase, policy, &what);
}

/// Another session, after it.
fn goes_on(world: &mut World, victim: Victim, phase: Phase, policy: LostPolicy, what: &str) {
    let mut probe = Probe::connect(world, 2);
    let status = probe.status(world);
    let keeps_program = victim != Victim::Target && phase != Phase::Idle;
    assert_eq!(status.program, keeps_program.then(|| content_hash(&counter())), "{what}");
    if victim != Victim::Target && phase == Phase::Stopped && policy == LostPolicy::StayStopped {
        assert_eq!(probe.stopped(world).pc, STORE, "{what}: it is told where the program is held");
        probe.tell(world, Request::Resume(technol_wire::message::Resume::Into));
        assert_eq!(probe.stopped(world).pc, STORE + 1, "{what}");
    }
    if phase == Phase::Downloading {
        let before = world.cable.to_target.bytes;
        announce(&mut probe, world);
        probe.until(world, "end of the download", |p| p.downloaded);
        let sent = world.cable.to_target.bytes - before;
        if victim == Victim::Target {
            assert!(sent > 33_000, "{what}: {sent}");
        } else {
            assert!(sent < 18_000, "{what}: half of it was there already, and {sent} bytes were sent");
        }
        let answer = probe.ask(world, Request::Commit);
        assert!(format!("{answer:?}").contains("BadProgram"), "{what}: it arrived whole: {answer:?}");
    }
    probe.load(world, &counter());
    probe.run(world, SECOND);
    assert_eq!(probe.status(world).plc, PlcState::Running, "{what}");
}

#[test]
fn a_target_that_dies() {
    for phase in PHASES {
        happens(Victim::Target, phase, LostPolicy::RunOn);
    }
}

#[test]
fn a_debugger_that_dies() {
    for policy in [LostPolicy::RunOn, LostPolicy::StayStopped, LostPolicy::StopPlc] {
        for phase in PHASES {
            happens(Victim::Host, phase, policy);
        }
    }
}

#[test]
fn a_cable_that_is_cut() {
    for policy in [LostPolicy::RunOn, LostPolicy::StayStopped, LostPolicy::StopPlc] {
        for phase in PHASES {
            happens(Victim::Cable, phase, policy);
        }
    }
}
