//! Serial ports of the program on a real line.

use std::io::{Read, Write};
use std::thread;
use std::time::{Duration, Instant};

use technol_image::Program;
use technol_image::op::{Arith, Cond, Op, Source, Width};
use technol_image::service::{Arg, Service, ServiceCall};
use technol_machine::MachineConfig;
use technol_machine::config::Serial;
use technol_target::{Clock, TargetCore, TargetOptions};

use crate::places::serial::terminal;
use crate::program::counter;

/// Sends back each character of channel 7, the next one of the alphabet.
fn echo() -> Program {
    let call = |service| ServiceCall { service, args: vec![Arg::Int(7)], push: false };
    let mut program = counter();
    program.services = vec![call(Service::ComRecv), call(Service::ComSend)];
    program.code[1] = Op::Service(0);
    program.code[2] = Op::Jump { target: 8, cond: Cond::IfRlo };
    program.code[3] = Op::Arith { op: Arith::Add, src: Source::Int(1), width: Width::Byte };
    program.code[4] = Op::Service(1);
    program.code[5] = Op::Jump { target: 8, cond: Cond::Always };
    program
}

#[test]
fn a_program_talks_over_a_serial_device() {
    let (mut other, _device, name) = terminal();
    let mut machine = MachineConfig::default();
    machine.serial.push(Serial { channel: 7, baud: Some(19_200), port: Some(name) });
    let options = TargetOptions {
        clock: Clock::Real,
        machine: Some(machine),
        program: Some(echo()),
        start: true,
        ..TargetOptions::default()
    };
    let mut core = TargetCore::new(options).unwrap();
    let deadline = Instant::now() + Duration::from_secs(20);
    let (mut sent, mut said) = (false, Vec::new());
    while said != b"IBM" {
        let now = Instant::now();
        assert!(now < deadline, "{said:?}");
        core.advance(now, false);
        // The device was thrown empty when it was opened.
        let failed = core.simulation().unwrap().control().serial(7).unwrap().is_failed();
        if !sent && !failed {
            other.write_all(b"HAL").unwrap();
            sent = true;
        }
        let mut buffer = [0; 64];
        // Nothing there is an error of a terminal that does not wait.
        let count = other.read(&mut buffer).unwrap_or(0);
        said.extend_from_slice(&buffer[..count]);
        thread::sleep(Duration::from_millis(2));
    }
    assert!(sent);
}

#[test]
fn a_device_that_is_not_there_is_a_broken_line() {
    let mut machine = MachineConfig::default();
    machine.serial.push(Serial { channel: 7, baud: None, port: Some("/dev/no-such-line".to_owned()) });
    let options = TargetOptions {
        clock: Clock::Real,
        machine: Some(machine),
        program: Some(echo()),
        start: true,
        ..TargetOptions::default()
    };
    let mut core = TargetCore::new(options).unwrap();
    core.advance(Instant::now(), false);
    assert!(core.simulation().unwrap().control().serial(7).unwrap().is_failed());
    let start = Instant::now();
    drop(core);
    assert!(start.elapsed() < Duration::from_secs(5), "it does not wait for the device");
}
