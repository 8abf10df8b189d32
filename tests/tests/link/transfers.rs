//! Files and downloads on a bad cable.

use technol_image::container::hash_bytes;
use technol_link_model::{Cuts, Faults, LineOptions, Random};
use technol_target::{RemoteFolder, TargetOptions};
use technol_wire::message::{FileAnswer, FileRequest, Request, Response};

use crate::probe::{Probe, SECOND};
use crate::world::World;

fn folder() -> (tempfile::TempDir, TargetOptions) {
    let folder = tempfile::tempdir().expect("a folder");
    let files = Some(RemoteFolder::new(folder.path()).expect("it is there"));
    (folder, TargetOptions { files, ..TargetOptions::default() })
}

#[test]
fn files_arrive_byte_for_byte_at_one_wrong_bit_in_ten_thousand() {
    let (folder, options) = folder();
    let line = LineOptions { faults: Faults::bit_errors(1e-4), ..LineOptions::default() };
    let mut world = World::new(line, options);
    let mut probe = Probe::connect(&mut world, 1);
    let mut random = Random::new(3);
    for len in [0, 1, 239, 5_000] {
        let bytes = random.bytes(len);
        let path = format!("file{len}");
        let announced = Request::Download { len: len as u32, hash: hash_bytes(&bytes) };
        probe.tell(&mut world, announced);
        probe.downloaded = false;
        probe.host.download(bytes.clone());
        probe.until(&mut world, "end of the file", |p| p.downloaded);
        probe.tell(&mut world, Request::Files(FileRequest::Store { path: path.clone() }));
        assert_eq!(std::fs::read(folder.path().join(&path)).expect("it is there"), bytes, "{path}");

        let mut back = Vec::new();
        loop {
            let offset = back.len() as u64;
            let request = FileRequest::Read { path: path.clone(), offset, len: 2048 };
            match probe.ask(&mut world, Request::Files(request)) {
                Response::Files(FileAnswer::Bytes { bytes, size }) => {
                    assert_eq!(size, len as u64);
                    back.extend(bytes);
                    if back.len() as u64 >= size {
                        break;
                    }
                }
                other => panic!("{other:?}"),
            }
        }
        assert_eq!(back, bytes, "{path}");
    }
    probe.tell(&mut world, Request::Files(FileRequest::Delete { path: "file0".into() }));
    let copy = FileRequest::Copy { from: "file239".into(), to: "copy".into() };
    probe.tell(&mut world, Request::Files(copy));
    let names = std::fs::read_dir(folder.path()).expect("the folder").count();
    assert_eq!(names, 4);
}

#[test]
fn a_file_that_did_not_arrive_whole_is_not_stored() {
    let (folder, options) = folder();
    let mut world = World::new(LineOptions::default(), options);
    let mut probe = Probe::connect(&mut world, 1);
    probe.tell(&mut world, Request::Download { len: 10, hash: hash_bytes(b"0123456789") });
    let store = Request::Files(FileRequest::Store { path: "new".into() });
    let answer = probe.ask(&mut world, store.clone());
    assert_eq!(answer, Response::Failed(technol_wire::message::Failure::Incomplete));
    probe.tell(&mut world, Request::Download { len: 10, hash: hash_bytes(b"0123456789") });
    probe.host.download(b"0123456780".to_vec());
    probe.until(&mut world, "end of the file", |p| p.downloaded);
    let answer = probe.ask(&mut world, store);
    assert_eq!(answer, Response::Failed(technol_wire::message::Failure::Incomplete));
    assert!(!folder.path().join("new").exists());
}

#[test]
fn a_download_over_many_cuts_sends_little_twice() {
    // Cut for a second out of every four: each time the session is lost.
    let cuts = Some(Cuts { every_us: 4 * SECOND, len_us: 1_200_000 });
    let mut world = World::new(LineOptions { cuts, ..LineOptions::default() }, TargetOptions::default());
    let bytes = Random::new(4).bytes(100_000);
    let hash = hash_bytes(&bytes);
    let mut sessions = 0;
    loop {
        sessions += 1;
        assert!(sessions < 12, "it does not get further");
        // A host tries again until somebody answers.
        while world.cable.to_host.is_cut(world.now) {
            let until = world.now + 100_000;
            world.receive(&mut [0; 4096], until - world.now);
        }
        let mut probe = Probe::connect(&mut world, sessions);
        let ticket = probe.host.request(Request::Download { len: 100_000, hash });
        probe.host.download(bytes.clone());
        while probe.lost.is_none() && !probe.downloaded {
            let until = world.now + SECOND;
            probe.pump(&mut world, until);
        }
        let _ = ticket;
        if probe.downloaded {
            let answer = probe.ask(&mut world, Request::Commit);
            assert!(format!("{answer:?}").contains("BadProgram"), "it arrived whole: {answer:?}");
            break;
        }
    }
    assert!(sessions >= 3);
    let sent = world.cable.to_target.bytes;
    assert!(sent < 135_000, "{sent} bytes for 100000 in {sessions} sessions");
}
