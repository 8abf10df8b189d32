//! Steps and files in one session, on a cable that damages one bit in ten thousand and is cut for a second every
//! twenty: each step is done once, each file arrives as it was, and none waits for the other.

use technol_image::container::hash_bytes;
use technol_link_model::{Cuts, Faults, LineOptions, Random};
use technol_target::{RemoteFolder, TargetOptions};
use technol_wire::message::{Event, FileAnswer, FileRequest, LostPolicy, Request, Response, Resume};

use crate::probe::{Probe, SECOND};
use crate::program::{ADD, DIVIDE, LOAD, STORE, counter};
use crate::world::World;

const STEPS: usize = 500;
/// Where the program stops, step by step, again and again.
const PLACES: [u32; 7] = [STORE, 4, 5, 6, DIVIDE, LOAD, ADD];
/// Between two steps of a user, in virtual microseconds.
const THINKING: u64 = 150_000;
/// Bytes of a file: some seconds of the line, or one frame.
const LENGTHS: [usize; 4] = [12_000, 200, 30_000, 5_000];
/// Bytes that are read back between two steps.
const PIECE: u16 = 1500;

/// How far a file has come.
enum Transfer {
    /// It is on its way to the target, or has to be announced (again).
    Put { announced: bool },
    /// It is stored, and so much of it has come back.
    Get(Vec<u8>),
}

struct Busy {
    world: World,
    probe: Probe,
    folder: tempfile::TempDir,
    sessions: u32,
    /// Place in [`PLACES`].
    at: usize,
    random: Random,
    file: Vec<u8>,
    transfer: Transfer,
    /// Files that went there and back.
    done: usize,
    /// Steps that were done while a file was on its way to the target.
    meanwhile: usize,
}

impl Busy {
    fn begin() -> Busy {
        let line = LineOptions {
            faults: Faults::bit_errors(1e-4),
            cuts: Some(Cuts { every_us: 20 * SECOND, len_us: SECOND }),
            ..LineOptions::default()
        };
        let folder = tempfile::tempdir().expect("a folder");
        let files = Some(RemoteFolder::new(folder.path()).expect("it is there"));
        let mut world = World::new(line, TargetOptions { files, ..TargetOptions::default() });
        let mut probe = Probe::connect(&mut world, 1);
        probe.tell(&mut world, Request::OnLinkLost(LostPolicy::StayStopped));
        probe.load(&mut world, &counter());
        probe.ask(&mut world, Request::SetBreakpoints { pcs: vec![STORE] });
        assert_eq!(probe.stopped(&mut world).pc, PLACES[0]);
        let mut random = Random::new(11);
        let file = random.bytes(LENGTHS[0]);
        let transfer = Transfer::Put { announced: false };
        Busy { world, probe, folder, sessions: 1, at: 0, random, file, transfer, done: 0, meanwhile: 0 }
    }

    /// The link is lost: the user opens another one and looks where things are. `stepping`: a step was asked for.
    fn reconnect(&mut self, stepping: bool) {
        while self.world.cable.to_host.is_cut(self.world.now) {
            let micros = SECOND / 10;
            self.world.receive(&mut [0; 4096], micros);
        }
        self.sessions += 1;
        assert!(self.sessions < 40, "it does not get further");
        self.probe = Probe::connect(&mut self.world, self.sessions);
        self.probe.tell(&mut self.world, Request::OnLinkLost(LostPolicy::StayStopped));
        let stop = self.probe.stopped(&mut self.world).pc;
        let next = (self.at + 1) % PLACES.len();
        if stepping && stop == PLACES[next] {
            self.at = next; // it was done, and the cut took the news
        } else {
            assert_eq!(stop, PLACES[self.at], "nothing but the step can have happened");
        }
        // What has arrived of a file is kept by the target; reading goes on where it was.
        if let Transfer::Put { announced } = &mut self.transfer {
            *announced = false;
        }
    }

    fn step(&mut self) {
        let before = (self.at, self.sessions);
        let request = Request::Resume(Resume::Over { sequence: None });
        match self.probe.try_ask(&mut self.world, request) {
            None => return self.reconnect(true),
            Some(answer) => assert_eq!(answer, Response::Done),
        }
        let is_stop = |event: &Event| matches!(event, Event::Stopped(_));
        if !self.probe.reaches(&mut self.world, |p| p.events.iter().any(is_stop)) {
            return self.reconnect(true);
        }
        self.at = (self.at + 1) % PLACES.len();
        assert_eq!(self.probe.stopped(&mut self.world).pc, PLACES[self.at], "after {before:?}");
        let on_its_way = matches!(self.transfer, Transfer::Put { announced: true });
        self.meanwhile += usize::from(on_its_way && !self.probe.downloaded);
    }

    /// Goes on with the file, as far as it goes without waiting for it.
    fn work_on_file(&mut self) {
        let path = format!("file{}", self.done);
        let hash = hash_bytes(&self.file);
        let len = self.file.len() as u32;
        let request = match &self.transfer {
            Transfer::Put { announced: false } => Request::Download { len, hash },
            Transfer::Put { announced: true } if !self.probe.downloaded => return,
            Transfer::Put { announced: true } => Request::Files(FileRequest::Store { path: path.clone() }),
            Transfer::Get(back) => {
                let offset = back.len() as u64;
                Request::Files(FileRequest::Read { path: path.clone(), offset, len: PIECE })
            }
        };
        let Some(answer) = self.probe.try_ask(&mut self.world, request) else {
            return self.reconnect(false);
        };
        match (&mut self.transfer, answer) {
            (Transfer::Put { announced }, Response::Done) if !*announced => {
                *announced = true;
                self.probe.downloaded = false;
                self.probe.host.download(self.file.clone());
            }
            (Transfer::Put { .. }, Response::Done) => {
                let stored = std::fs::read(self.folder.path().join(&path)).expect("it is stored");
                assert!(stored == self.file, "{path} is another one");
                self.transfer = Transfer::Get(Vec::new());
            }
            (Transfer::Get(back), Response::Files(FileAnswer::Bytes { bytes, size })) => {
                assert_eq!(size, u64::from(len));
                back.extend(bytes);
                if back.len() as u64 == size {
                    assert!(*back == self.file, "{path} comes back as another one");
                    self.done += 1;
                    self.file = self.random.bytes(LENGTHS[self.done % LENGTHS.len()]);
                    self.transfer = Transfer::Put { announced: false };
                }
            }
            (_, other) => panic!("{path}: {other:?}"),
        }
    }
}

#[test]
fn steps_and_files_share_a_bad_cable() {
    let mut busy = Busy::begin();
    let mut steps = 0;
    while steps < STEPS {
        let before = busy.at;
        busy.step();
        steps += usize::from(busy.at != before);
        busy.work_on_file();
        busy.probe.run(&mut busy.world, THINKING);
    }
    let Busy { world, sessions, done, meanwhile, .. } = &busy;
    // It was really cut, and not in vain.
    let seconds = world.now / SECOND;
    assert!(seconds > 80 && *sessions > 3, "{seconds} s, {sessions} sessions");
    assert!(*done >= 4 && *meanwhile >= 100, "{done} files, {meanwhile} steps beside them");
}
