//! `technol target` before any debugger is there, and how it ends.

#[cfg(unix)]
use std::io::{BufRead as _, BufReader};
#[cfg(unix)]
use std::process::{Command, Stdio};
#[cfg(unix)]
use std::time::{Duration, Instant};

#[cfg(unix)]
use crate::binary::technol;
#[cfg(unix)]
use crate::frame::program;

use crate::lathe::Lathe;
use crate::ran::{Folder, run};

const LISTEN: [&str; 2] = ["--listen", "tcp:127.0.0.1:0"];

#[test]
fn images_that_cannot_be_loaded_are_refused_with_a_remedy() {
    let lathe = Lathe::copy();
    run(&["build", &lathe.path("")]).ok();
    let image = std::fs::read(lathe.path("out/lathe.tplc")).expect("the image");
    let mut flipped = image.clone();
    flipped[image.len() / 2] ^= 1;
    let mut newer = image.clone();
    newer[4] = 0xEE;
    let folder = Folder::with(&[
        ("foreign.tplc", b"\x7FELF and so on, longer than any header"),
        ("empty.tplc", b""),
        ("short.tplc", &image[..image.len() / 2]),
        ("flipped.tplc", &flipped),
        ("newer.tplc", &newer),
        ("source.plc", b"MODULE_MAIN\n"),
    ]);
    for name in
        ["foreign.tplc", "empty.tplc", "short.tplc", "flipped.tplc", "newer.tplc", "source.plc", "none.tplc"]
    {
        let path = folder.path(name);
        let ran = run(&["target", &path, LISTEN[0], LISTEN[1]]);
        ran.failed(2, &[&path, "technol build"]);
        assert_eq!(ran.out, "", "{name}: it does not listen");
    }
}

#[test]
fn an_image_with_wild_addresses_is_refused_with_its_operation() {
    use technol_image::{Op, Width};
    let lathe = Lathe::copy();
    run(&["build", &lathe.path("")]).ok();
    let file = lathe.path("out/lathe.tplc");
    let mut image = technol_image::decode(&std::fs::read(&file).expect("the image")).expect("it is right");
    let code = &mut image.program.code;
    let at = code.iter().position(|op| matches!(op, Op::Load { .. })).expect("a load");
    let far = technol_image::Place { addr: u32::MAX, indexed: false };
    code[at] = Op::Load { src: technol_image::Source::Mem(far), width: Width::Word, neg: false };
    image.debug = None;
    // Sealed again: the checksum is right.
    std::fs::write(&file, technol_image::encode(&image)).expect("written");
    let said = format!("operation {at}");
    run(&["target", &file, LISTEN[0], LISTEN[1]]).failed(2, &[&said, "outside PLC memory", "build"]);
}

#[test]
fn places_that_cannot_be_served_are_refused_with_a_remedy() {
    run(&["target"]).failed(2, &["--listen"]);
    run(&["target", "--listen", "tcp:127.0.0.1:0", "--serial", "/dev/x"]).failed(2, &["--serial"]);
    run(&["target", "--listen", "127.0.0.1:5700"]).failed(2, &["tcp:HOST:PORT"]);
    run(&["target", "--listen", "serial:/dev/x"]).failed(2, &["tcp:HOST:PORT"]);
    run(&["target", "--serial", "/dev/no-such-line"]).failed(2, &["/dev/no-such-line", "cable"]);
    run(&["target", LISTEN[0], LISTEN[1], "--machine", "no-machine.toml"]).failed(2, &["no-machine.toml"]);
    run(&["target", LISTEN[0], LISTEN[1], "--start"]).failed(2, &["IMAGE"]);
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = format!("tcp:{}", taken.local_addr().expect("its number"));
    run(&["target", "--listen", &address]).failed(2, &[&address]);
    run(&["dap", "--listen", &address]).failed(2, &[&address, "another port"]);
}

/// A program that counts its ends in MODULE_DONE, and its starts.
#[cfg(unix)]
fn counting() -> Folder {
    let source = program(
        "COUNT: DS 2",
        " LOD CNST.1\n STO COUNT",
        " LOD WORD.PLC_MEM_BACKUP\n INR\n STO WORD.PLC_MEM_BACKUP",
    );
    let done =
        "MODULE_DONE\n LOD CNST.77\n STO BYTE.(PLC_MEM_BACKUP+2)\n ESET 5\nMODULE_DONE_END\nMODULE_INPUT\n";
    Folder::with(&[("main.plc", source.replacen("MODULE_INPUT\n", done, 1).as_bytes())])
}

#[cfg(unix)]
#[test]
fn a_signal_ends_the_program_in_order_and_what_is_kept_is_saved() {
    let folder = counting();
    let image = folder.path("main.tplc");
    run(&["build", &folder.path("main.plc"), "--out", &folder.path("")]).ok();
    let (memory, log) = (folder.path("memory.bin"), folder.path("events.log"));
    for (start, signal) in [(1_u8, "TERM"), (2, "INT")] {
        let mut target = Command::new(technol())
            .args(["target", &image, "--start", "--backup", &memory, "--log", &log])
            .args(LISTEN)
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let mut said = BufReader::new(target.stdout.take().expect("its output"));
        let mut line = String::new();
        said.read_line(&mut line).expect("it says something");
        assert!(line.starts_with("listening at tcp:"), "{line}");
        let deadline = Instant::now() + Duration::from_secs(60);
        let running = || {
            std::fs::read_to_string(&log)
                .is_ok_and(|log| log.matches("PLC Running").count() == usize::from(start))
        };
        while !running() {
            assert!(Instant::now() < deadline, "the program does not start");
            std::thread::sleep(Duration::from_millis(5));
        }
        let kill = Command::new("kill").args(["-s", signal, &target.id().to_string()]).status();
        assert!(kill.expect("a signal").success());
        let status = target.wait().expect("it ends");
        assert_eq!(status.code(), Some(0), "SIG{signal} is a regular end");
        let kept = std::fs::read(&memory).expect("the memory");
        assert_eq!(kept[..4], [start, 0, 77, 0], "MODULE_INIT and MODULE_DONE were executed");
    }
    let log = std::fs::read_to_string(&log).expect("the log");
    for part in ["Z 0:00:00.020 PLC Starting", " Err PLC00005\n", " PLC Stopped\n"] {
        assert_eq!(log.matches(part).count(), 2, "`{part}` in:\n{log}");
    }
    run(&["target", LISTEN[0], LISTEN[1], "--log", &folder.path("no/folder/x.log")])
        .failed(2, &["event log"]);
}
