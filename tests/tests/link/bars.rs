//! How fast things are at 115200 baud. Virtual time and numbers of bytes: they do not depend on the machine.

use technol_link_model::LineOptions;
use technol_target::TargetOptions;
use technol_wire::frame::kind;
use technol_wire::message::{Request, Resume};

use crate::probe::{Probe, SECOND};
use crate::program::{STORE, counter};
use crate::world::World;

fn stopped_at_a_break_point() -> (World, Probe) {
    let mut world = World::new(LineOptions::default(), TargetOptions::default());
    let mut probe = Probe::connect(&mut world, 1);
    probe.load(&mut world, &counter());
    probe.run(&mut world, SECOND);
    probe.ask(&mut world, Request::SetBreakpoints { pcs: vec![STORE] });
    probe.stopped(&mut world);
    (world, probe)
}

#[test]
fn a_stop_is_there_within_four_milliseconds() {
    let (world, _) = stopped_at_a_break_point();
    let sent = world.sent.iter().find(|f| f.kind == kind::EVENT && f.at > SECOND).expect("the event");
    let arrived = world.passed.iter().find(|f| f.kind == kind::EVENT && f.at > sent.at).expect("it arrives");
    assert!(arrived.at - sent.at <= 4_000, "{} µs", arrived.at - sent.at);
}

#[test]
fn a_step_with_its_registers_takes_six_milliseconds_at_most() {
    let (mut world, mut probe) = stopped_at_a_break_point();
    let mut cycle = world.core.status().cycle;
    for _ in 0..20 {
        probe.run(&mut world, SECOND / 3);
        let began = world.now;
        probe.host.request(Request::Resume(Resume::Into));
        let stopped = probe.stopped(&mut world);
        // Behind the last statement of a cycle the program waits for the next cycle.
        let waits = if stopped.cycle == cycle { 0 } else { 20_000 };
        cycle = stopped.cycle;
        assert!(world.now - began <= 6_000 + waits, "{} µs", world.now - began);
        assert_eq!(stopped.frames[0].pc, stopped.pc);
        assert!(stopped.registers.dr >= 0, "the registers came along");
    }
}

#[test]
fn a_program_of_seventeen_kilobytes_is_there_within_one_point_seven_seconds() {
    let mut world = World::new(LineOptions::default(), TargetOptions::default());
    let mut probe = Probe::connect(&mut world, 1);
    let bytes: Vec<u8> = (0..16_800_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 11) as u8).collect();
    let (began, before) = (world.now, world.cable.to_target.bytes);
    let hash = technol_image::container::hash_bytes(&bytes);
    probe.tell(&mut world, Request::Download { len: 16_800, hash });
    probe.host.download(bytes);
    probe.until(&mut world, "end of the download", |p| p.downloaded);
    // It arrived whole, so the target gets as far as looking into it.
    let answer = probe.ask(&mut world, Request::Commit);
    assert!(format!("{answer:?}").contains("BadProgram"), "{answer:?}");
    let (took, sent) = (world.now - began, world.cable.to_target.bytes - before);
    assert!(took <= 1_700_000, "{took} µs");
    assert!(sent <= 18_500, "{sent} bytes");
}
