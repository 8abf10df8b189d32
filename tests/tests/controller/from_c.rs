//! The C library does what the Rust runtime does.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command as Process;

use technol_machine::{Plant, PlantEvent};
use technol_runtime::{Block, BlockMode, Command, PlcState, Runtime, RuntimeEvent};

use crate::bare;
use crate::lathe;

const CYCLES: u64 = 700;

/// What went in, for `replay.c`, and what came out.
#[derive(Default)]
struct Recording {
    tape: Vec<u8>,
    printed: String,
}

impl Recording {
    fn block(&mut self, block: &Block) {
        self.tape.push(b'B');
        self.tape.push(block.m.len() as u8);
        self.tape.extend_from_slice(&block.m);
        let or_none = |value: Option<u32>| value.map_or(-1, |v| v as i32);
        for value in [or_none(block.t), or_none(block.s.map(u32::from)), or_none(block.h.map(u32::from))] {
            self.tape.extend_from_slice(&value.to_le_bytes());
        }
        self.tape.extend_from_slice(&block.motion_ms.to_le_bytes());
        let mode = match block.mode {
            BlockMode::Auto => 0,
            BlockMode::CentralAnnulment => 1,
            BlockMode::Reference => 2,
            BlockMode::Other => 3,
        };
        self.tape.extend_from_slice(&[u8::from(block.rapid), mode]);
    }

    fn event(&mut self, event: &RuntimeEvent) {
        let (kind, number, cycle) = match event {
            RuntimeEvent::Message { number, cycle, .. } => (1, *number, *cycle),
            RuntimeEvent::StateChanged(state) => (3, state_number(*state), 0),
            RuntimeEvent::BlockStarted { cycle } => (5, 0, *cycle),
            RuntimeEvent::BlockFinished { cycle } => (6, 0, *cycle),
            RuntimeEvent::BlockAborted { cycle } => (7, 0, *cycle),
            other => panic!("the lathe runs without {other:?}"),
        };
        writeln!(self.printed, "event {kind} {number} {cycle}").expect("a string takes all");
    }

    fn tick(&mut self, plc: &mut Runtime, inputs: &[u8; 128]) {
        self.tape.push(b'T');
        self.tape.extend_from_slice(inputs);
        let mut events = Vec::new();
        plc.tick(inputs, &mut events);
        for event in &events {
            self.event(event);
        }
        write!(self.printed, "{} ", state_number(plc.state())).expect("a string takes all");
        for byte in plc.outputs() {
            write!(self.printed, "{byte:02x}").expect("a string takes all");
        }
        self.printed.push('\n');
    }
}

fn state_number(state: PlcState) -> u32 {
    match state {
        PlcState::Stopped => 0,
        PlcState::Starting => 1,
        PlcState::Running => 2,
        PlcState::Stopping => 3,
        PlcState::Halted => 4,
        PlcState::Faulted => 5,
    }
}

/// The lathe and its machine through the part program and the first faults.
fn recording() -> Recording {
    let mut recording = Recording::default();
    let mut plc = Runtime::new(lathe::image().program.clone()).expect("the lathe can be loaded");
    let config = lathe::machine();
    let mut plant = Plant::compile(&config, &|name| name.parse().ok()).expect("the lathe's machine");
    let mut inputs = [0; 128];
    recording.tape.push(b'S');
    plc.command(Command::StartPlc { cold: true });
    recording.tick(&mut plc, &inputs);
    while plc.millis() < CYCLES * 20 {
        if plc.millis() == 8_000 {
            plant.set_fault("ccw-contactor-dead", true).expect("the lathe has this fault");
        }
        plant.step(plc.outputs(), &mut inputs);
        while let Some(event) = plant.next_event() {
            let PlantEvent::StartBlock(start) = event else { continue };
            // What `technol_block` does not have is not recorded.
            let block = Block { prepared: None, ..start };
            recording.block(&block);
            plc.command(Command::StartBlock(block));
        }
        recording.tick(&mut plc, &inputs);
    }
    writeln!(recording.printed, "hash {:016x}", plc.state_hash()).expect("a string takes all");
    recording
}

/// Standard output, then standard error, of `replay`.
fn replayed(replay: &Path, image: &[u8], tape: &[u8]) -> (String, String) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (image_file, tape_file) = (folder.path().join("image"), folder.path().join("tape"));
    std::fs::write(&image_file, image).expect("the image is written");
    std::fs::write(&tape_file, tape).expect("the tape is written");
    let output = Process::new(replay).args([image_file, tape_file]).output().expect("replay runs");
    let text = |bytes| String::from_utf8(bytes).expect("it prints ASCII");
    (text(output.stdout), text(output.stderr))
}

#[test]
fn a_c_program_drives_the_lathe_as_the_rust_runtime_does() {
    let Some(replay) = bare::replay() else { return };
    let recording = recording();
    let moved = recording.printed.lines().collect::<std::collections::BTreeSet<_>>().len();
    assert!(moved > 20, "{moved} different lines: the lathe did something");
    let image = technol_image::encode(lathe::image());
    let (printed, memory) = replayed(replay, &image, &recording.tape);
    let difference = recording.printed.lines().zip(printed.lines()).position(|(ours, theirs)| ours != theirs);
    assert_eq!(difference, None, "line of the output that differs");
    assert_eq!(printed.lines().count(), recording.printed.lines().count());

    // loaded N most N left N
    println!("memory of the C library with the lathe: {memory}");
    let numbers: Vec<usize> = memory.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let [loaded, most, left] = numbers[..] else { panic!("{memory}") };
    assert!(most < loaded + 2_048 && most < 1 << 20, "ticks take no memory: {memory}");
    assert_eq!(left, 0, "all of it comes back");
}

/// A program of these lines in MODULE_MAIN.
pub(crate) fn lines(main: &str) -> Vec<u8> {
    let source = format!(
        "DATA\nO: DFM LIC,KNOWN,UNKNOWN,,,,,\nDELAY: DS 2\nPACKET: STR 12\nDATA_END\nMODULE_MAIN\n{main}\nMODULE_MAIN_END\n\
         MODULE_INPUT\nMODULE_INPUT_END\nMODULE_BLOCK_INIT\nMODULE_BLOCK_INIT_END\nMODULE_BLOCK_DONE\n\
         MODULE_BLOCK_DONE_END\nMODULE_INIT\n MODULE_INIT_FINISHED\nMODULE_INIT_END\nMODULE_CLEAR\nMODULE_CLEAR_END\n\
         MODULE_HALT\nMODULE_HALT_END\nSTOP\n"
    );
    struct Lone(String);
    impl technol_analysis::project::FileReader for Lone {
        fn read(&self, path: &str) -> Result<Vec<u8>, String> {
            if path == "plc.plc" { Ok(self.0.clone().into_bytes()) } else { Err("no such file".to_owned()) }
        }
    }
    let program = crate::families::build("plc.plc", &Lone(source));
    technol_image::encode(&technol_image::Image { program, debug: None })
}

fn controlled(control: &Path, image: &[u8]) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("image");
    std::fs::write(&file, image).expect("the image is written");
    let output = Process::new(control).arg(file).arg("45").output().expect("control runs");
    String::from_utf8(output.stdout).expect("it prints ASCII")
}

#[test]
fn a_control_in_c_carries_out_what_the_program_asks_for() {
    let Some(control) = bare::control() else { return };
    let image = lines(
        " LDR_LIC FeaturePlc0\n WR LIC\n CNF_GET_INT DELAY,'Delay'\n WR KNOWN\n CNF_GET_INT DELAY,'Other'\n WR UNKNOWN\n\
         \x20LOD CNST.123h\n STO WORD.PACKET\n LOD CNST.2\n STO BYTE.(PACKET+3)\n LOD DELAY\n STO BYTE.(PACKET+4)\n\
         \x20CAN_SEND 2,PACKET\n LOD O\n STO P0OUT\n LOD DELAY\n STO P1OUT",
    );
    insta::assert_snapshot!(controlled(control, &image), @r"
    started cold
    0 ms: CAN 2 sends 23 01 00 02 07 00 00 00 00 00 00 00
    20 ms: CAN 2 sends 23 01 00 02 07 00 00 00 00 00 00 00
    40 ms: CAN 2 sends 23 01 00 02 07 00 00 00 00 00 00 00
    P0OUT 03, P1OUT 07, 0 stops
    fault: none
    ");
}

#[test]
fn what_a_control_in_c_does_not_have_faults_the_plc_by_name() {
    let Some(control) = bare::control() else { return };
    let image = lines(" ANALOG DELAY,3\n LOD CNST.5\n STO P0OUT");
    insta::assert_snapshot!(controlled(control, &image), @r"
    started cold
    P0OUT 00, P1OUT 00, 0 stops
    fault: the control of this target does not carry out ANALOG in MODULE_MAIN of file 1, operation 0, cycle 0
    ");
    // Another one, whose index leads outside memory.
    let image = lines(" LOD CNST.-1\n MOV BX,CX\n CAN_SEND 2,PACKET[BX]");
    insta::assert_snapshot!(controlled(control, &image), @r"
    started cold
    P0OUT 00, P1OUT 00, 0 stops
    fault: indexed access of 0 bytes at address 98306 is outside PLC memory in MODULE_MAIN of file 1, operation 2, cycle 0
    ");
}

#[test]
fn the_header_numbers_the_instructions_as_images_do() {
    let header = bare::header();
    for (number, service) in technol_image::Service::ALL.iter().enumerate() {
        let line = format!(" TECHNOL_{} = {number},", service.name());
        assert!(header.contains(&line), "{line}");
    }
}

#[test]
fn a_damaged_image_is_refused_in_words() {
    let Some(replay) = bare::replay() else { return };
    let mut image = technol_image::encode(lathe::image());
    let middle = image.len() / 2;
    image[middle] ^= 1;
    let (printed, _) = replayed(replay, &image, b"");
    assert_eq!(printed, "refused: the image is damaged (checksum); build it again\n");
    let (printed, _) = replayed(replay, b"TPLC", b"");
    assert_eq!(printed, "refused: the image is cut short; build it again\n");
}
