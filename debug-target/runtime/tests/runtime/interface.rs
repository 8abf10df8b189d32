//! Keys with commands, and outputs with a short circuit (manual 3.17, 9.3).

use technol_image::op::{Cond, Op, Width};
use technol_image::program::ModuleKind;
use technol_image::system::{OUT_FORCE_HIGH, OUT_PORTS, OUT_SHORTED};
use technol_runtime::Command;

use crate::support::{Bench, Builder, GLOBAL as A, bit, cell, count, lod, sto};

/// `_ON_CMD` keeps RLO at A.0 and DR at A+4, and counts its calls at A+8; MODULE_MAIN leaves other things in both.
fn with_commands() -> Bench {
    let mut b = Builder::new();
    b.module(ModuleKind::Main, 0, |b| {
        b.ops(count(A + 10));
        b.op(lod(99));
    });
    let keep = [Op::Write(bit(A, 0)), sto(A + 4, Width::DWord)];
    b.procedure("_ON_CMD", keep.into_iter().chain(count(A + 8)));
    b.load().started()
}

#[test]
fn a_key_calls_on_cmd_when_it_is_pressed_and_when_it_is_released() {
    let mut bench = with_commands();
    bench.cycles(1);
    assert_eq!(bench.word(A + 8), 0);
    for (code, pressed, low) in [(7, true, 7), (7, false, 7), (-1, true, 0xFFFF)] {
        bench.command(Command::PlcCommand { code, pressed });
        bench.cycles(1);
        assert_eq!((bench.bit(bit(A, 0)), bench.word(A + 4)), (pressed, low));
    }
    bench.cycles(2);
    assert_eq!(bench.word(A + 8), 3);
    for n in 0..20 {
        bench.command(Command::PlcCommand { code: n, pressed: true });
    }
    bench.cycles(1);
    assert_eq!((bench.word(A + 8), bench.word(A + 4)), (19, 15), "16 wait, more are lost");
    bench.command(Command::StartPlc { cold: false });
    bench.command(Command::PlcCommand { code: 1, pressed: true });
    bench.command(Command::StartPlc { cold: false });
    bench.millis(30);
    assert_eq!(bench.word(A + 8), 19, "a start forgets what waits");
}

#[test]
fn without_a_procedure_a_command_does_nothing() {
    let mut bench = Builder::new().main(|b| b.ops(count(A))).load().started();
    bench.command(Command::PlcCommand { code: 7, pressed: true });
    bench.cycles(2);
    assert_eq!(bench.word(A), 2);
}

/// MODULE_MAIN drives P3OUT as A says.
fn with_output() -> Bench {
    let b = Builder::new().main(|b| {
        let (src, dst) = (cell(A), cell(OUT_PORTS + 3));
        b.op(Op::Move { dst, src, width: Width::Byte, cond: Cond::Always });
    });
    b.load().started()
}

#[test]
fn a_shorted_output_is_switched_off_until_the_program_confirms() {
    let mut bench = with_output();
    let drive = |bench: &mut Bench, value: u8| {
        bench.plc.write_memory(A, &[value]).unwrap();
        bench.cycles(1);
        (bench.plc.outputs()[3], bench.byte(OUT_SHORTED + 3))
    };
    let mut shorted = [0; 96];
    shorted[3] = 0b10;
    bench.plc.set_shorted(&shorted);
    assert_eq!(drive(&mut bench, 0b01), (0b01, 0), "an output that is off has no short circuit");
    assert_eq!(drive(&mut bench, 0b11), (0b01, 0b10));
    assert_eq!(bench.byte(OUT_PORTS + 3), 0b11, "the port keeps what the program wants");
    bench.plc.set_shorted(&[0; 96]);
    assert_eq!(drive(&mut bench, 0b11), (0b01, 0b10), "stays until it is confirmed");
    bench.plc.write_memory(OUT_SHORTED + 3, &[0]).unwrap();
    assert_eq!(drive(&mut bench, 0b11), (0b11, 0));
    bench.plc.set_shorted(&shorted);
    bench.plc.write_memory(OUT_SHORTED + 3, &[0]).unwrap();
    assert_eq!(drive(&mut bench, 0b11), (0b01, 0b10), "a short that is still there comes back");
    bench.plc.write_memory(OUT_FORCE_HIGH + 3, &[0b10]).unwrap();
    bench.plc.write_memory(OUT_SHORTED + 3, &[0]).unwrap();
    assert_eq!(drive(&mut bench, 0), (0, 0b10), "forcing does not help");
}

#[test]
fn a_bit_that_the_program_sets_itself_switches_the_output_off() {
    let mut bench = with_output();
    bench.plc.write_memory(OUT_SHORTED + 3, &[0b01]).unwrap();
    bench.plc.write_memory(A, &[0b11]).unwrap();
    bench.cycles(1);
    assert_eq!(bench.plc.outputs()[3], 0b10);
}
