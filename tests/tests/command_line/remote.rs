//! `technol files`, `technol link` and `technol devices` with a target in another process.

use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};

use crate::binary::technol;
use crate::ran::{Folder, run, run_in};

/// A target at a port of its own; ended with this.
struct Served {
    target: Child,
    address: String,
}

impl Served {
    fn start(arguments: &[&str]) -> Served {
        let mut target = Command::new(technol())
            .args(["target", "--listen", "tcp:127.0.0.1:0"])
            .args(arguments)
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let mut said = BufReader::new(target.stdout.take().expect("its output"));
        let mut line = String::new();
        said.read_line(&mut line).expect("it says something");
        let address =
            line.trim().strip_prefix("listening at ").unwrap_or_else(|| panic!("{line}")).to_owned();
        // Somebody has to read what it says further.
        std::thread::spawn(move || said.lines().map_while(Result::ok).for_each(drop));
        Served { target, address }
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.target.kill();
        self.target.wait().expect("a child");
    }
}

#[test]
fn files_at_a_target_are_worked_with_from_here() {
    let there = Folder::with(&[("kept.txt", b"kept")]);
    let table = vec![7; 70_000];
    let here = Folder::with(&[("table.PlcT", &table)]);
    let served = Served::start(&["--files", &there.path("")]);
    let files = |words: &[&str]| {
        let mut arguments = vec!["files"];
        arguments.extend(words);
        arguments.extend(["--target", served.address.as_str()]);
        run_in(std::path::Path::new(&here.path("")), &arguments)
    };
    assert_eq!(files(&["ls"]).ok(), "           4  kept.txt\n");
    files(&["mkdir", "tables"]).ok();
    files(&["put", "table.PlcT", "tables/"]).ok();
    assert_eq!(files(&["ls", "tables"]).ok(), "       70000  table.PlcT\n");
    files(&["cp", "tables/table.PlcT", "copy"]).ok();
    files(&["mv", "kept.txt", "moved.txt"]).ok();
    files(&["get", "copy"]).ok();
    assert_eq!(std::fs::read(here.path("copy")).expect("it was fetched"), table);
    files(&["rm", "copy"]).ok();
    assert_eq!(files(&["ls"]).ok(), "           4  moved.txt\n              tables/\n");
    files(&["get", "../here"]).failed(2, &["leads out of the folder"]);
    files(&["get", "copy"]).failed(2, &["`copy` does not exist"]);
    files(&["rm", "tables"]).failed(2, &["`tables` cannot be deleted"]);
    assert_eq!(std::fs::read(there.path("moved.txt")).expect("it was moved"), b"kept");
}

#[test]
fn a_target_without_a_folder_offers_no_files() {
    let served = Served::start(&[]);
    run(&["files", "ls", "--target", &served.address]).failed(2, &["technol target --files DIR"]);
    let folder = Folder::with(&[]);
    let missing = folder.path("no");
    run(&["target", "--listen", "tcp:127.0.0.1:0", "--files", &missing])
        .failed(2, &["cannot offer the folder"]);
}

#[test]
fn a_link_is_tested_and_what_was_said_can_be_read() {
    let folder = Folder::with(&[]);
    let record = folder.path("link.log");
    let served = Served::start(&["--record", &record]);
    let said = run(&["link", "test", "--target", &served.address, "--seconds", "1"]).ok();
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].starts_with("round trip ") && lines[1].starts_with("throughput "), "{said}");
    assert!(lines[2].contains(" 0 of ") && lines[3] == "fit", "{said}");
    let log = run(&["link", "log", &record]).ok();
    for part in ["host    request ", ": Hello { version: 1, ", "target  response ", "Goodbye { stop: false }"]
    {
        assert!(log.contains(part), "`{part}` in:\n{}", &log[..log.len().min(2000)]);
    }
    run(&["link", "log", &folder.path("no.log")]).failed(2, &["no.log"]);
}

#[test]
fn a_target_for_others_needs_a_token_and_the_devices_are_listed() {
    run(&["target", "--listen", "tcp:0.0.0.0:0"]).failed(2, &["--token-file FILE"]);
    let folder = Folder::with(&[("token", b"a long secret token\n"), ("short", b"short")]);
    let (token, short) = (folder.path("token"), folder.path("short"));
    run(&["target", "--listen", "tcp:127.0.0.1:0", "--token-file", &short]).failed(2, &["at least 12"]);
    let served = Served::start(&["--token-file", &token, "--files", &folder.path("")]);
    let without = ["files", "ls", "--target", &served.address];
    run(&without).failed(2, &["the target asks for a token"]);
    let with = ["files", "ls", "--target", &served.address, "--token-file", &token];
    assert!(run(&with).ok().contains("token"));

    let json = run(&["devices", "--format", "json"]).json();
    assert!(json.is_array());
    run(&["devices"]).ok();
}
