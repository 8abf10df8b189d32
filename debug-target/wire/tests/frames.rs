//! Frames against damage, and the target against whatever a peer may say.
#![allow(clippy::unwrap_used)] // tests

use proptest::prelude::*;
use technol_wire::frame::{self, kind};
use technol_wire::message::{Event, Failure, KNOWN_REQUESTS, Limits, PROTOCOL_VERSION, Request, Response};
use technol_wire::{Frame, FrameDecoder, HostEvent, HostSession, LossReason, TargetInput, TargetSession};

const LIMITS: Limits = Limits { max_payload: 240, max_read: 4096, max_breakpoints: 256, window: 8 };

fn decode_all(bytes: &[u8], max_payload: usize) -> Vec<Frame> {
    let mut decoder = FrameDecoder::new(max_payload);
    bytes.iter().filter_map(|b| decoder.push(*b)).filter_map(Result::ok).collect()
}

proptest! {
    #[test]
    fn a_frame_comes_back_as_it_went(
        kind: u8, seq: u8, payload in prop::collection::vec(prop_oneof![Just(0), any::<u8>()], 0..700),
    ) {
        let mut bytes = vec![1, 2, 3, 0];
        frame::encode(kind, seq, &payload, &mut bytes);
        prop_assert!(bytes.len() <= 4 + frame::encoded_len(payload.len()));
        prop_assert_eq!(decode_all(&bytes, 700), [Frame { kind, seq, payload }]);
    }

    #[test]
    fn any_bytes_are_survived(bytes in prop::collection::vec(prop_oneof![Just(0_u8), any::<u8>()], 0..2000)) {
        prop_assert!(decode_all(&bytes, 240).is_empty());
        HostSession::new(1).receive(0, &bytes);
        TargetSession::new(LIMITS).receive(0, &bytes);
    }

    /// Whole frames with any content, in an open session.
    #[test]
    fn any_frames_are_survived(
        frames in prop::collection::vec((0_u8..7, any::<bool>(), any::<u8>(), prop::collection::vec(any::<u8>(), 0..40)), 0..60),
    ) {
        let mut host = HostSession::new(0);
        let mut target = TargetSession::new(LIMITS);
        let mut bytes = Vec::new();
        for (kind, from_target, seq, payload) in frames {
            frame::encode(kind | if from_target { 0x80 } else { 0 }, seq % 8, &payload, &mut bytes);
        }
        let hello = host.transmit();
        target.receive(0, &hello);
        target.receive(1, &bytes);
        host.receive(1, &bytes);
        for now in 0..20 {
            while let Some(input) = target.next() {
                if let TargetInput::Request { seq, .. } = input {
                    target.respond(seq, &Response::Done);
                }
            }
            while host.next().is_some() {}
            host.poll(now * 100_000);
            target.poll(now * 100_000);
            let _ = (host.transmit(), target.transmit());
        }
    }
}

#[test]
fn no_damaged_frame_is_ever_accepted() {
    // One to four bits flipped, a byte lost, doubled or exchanged: 400,000 times.
    let mut random = 0x1234_5678_9ABC_DEF1_u64;
    let mut next = || {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        random as usize
    };
    for round in 0..400_000 {
        let payload: Vec<u8> = (0..next() % 60).map(|_| (next() % 5 * 60) as u8).collect();
        let mut good = Vec::new();
        frame::encode(kind::REQUEST, round as u8, &payload, &mut good);
        let mut bad = good.clone();
        let at = next() % bad.len();
        match round % 4 {
            0 | 1 => {
                for _ in 0..=next() % 4 {
                    let at = next() % bad.len();
                    bad[at] ^= 1 << (next() % 8);
                }
            }
            2 => _ = bad.remove(at),
            _ => bad.insert(at, next() as u8),
        }
        bad.push(0);
        let original = Frame { kind: kind::REQUEST, seq: round as u8, payload };
        // Damage may cancel out, or hit only the delimiter: then it is the same frame, not a false one.
        for frame in decode_all(&bad, 240) {
            assert_eq!(frame, original, "{good:02x?} became {bad:02x?}");
        }
    }
}

/// A target with an open session, and a way to talk to it frame by frame.
struct Bench {
    target: TargetSession,
    seq: u8,
}

impl Bench {
    fn new() -> Self {
        Bench { target: TargetSession::new(LIMITS), seq: 0 }
    }

    fn hello() -> Response {
        let status = technol_wire::message::Status {
            plc: technol_wire::message::PlcState::Empty,
            held: false,
            cycle: 0,
            program: None,
        };
        Response::Hello { version: PROTOCOL_VERSION, limits: LIMITS, boot: 0, status, features: 0 }
    }

    fn open() -> Self {
        let mut bench = Bench::new();
        let hello = Request::Hello { version: PROTOCOL_VERSION, session: 1 };
        assert_eq!(bench.say(&postcard::to_allocvec(&hello).unwrap()), []);
        assert!(matches!(bench.target.next(), Some(TargetInput::Request { .. })));
        let answer = Bench::hello();
        bench.target.respond(0, &answer);
        assert_eq!(bench.answers(), [answer]);
        bench.seq = 1;
        bench
    }

    fn say(&mut self, message: &[u8]) -> Vec<Response> {
        let mut payload = vec![0x80];
        payload.extend_from_slice(message);
        let mut bytes = Vec::new();
        frame::encode(kind::REQUEST, self.seq, &payload, &mut bytes);
        self.target.receive(0, &bytes);
        self.answers()
    }

    fn answers(&mut self) -> Vec<Response> {
        let frames = decode_all(&self.target.transmit(), 240);
        frames.iter().map(|f| postcard::from_bytes(&f.payload[1..]).unwrap()).collect()
    }
}

#[test]
fn requests_that_make_no_sense_are_answered() {
    let unknown = [KNOWN_REQUESTS as u8, 1, 2, 3];
    let cut_short = [2_u8]; // Download without its fields
    let too_long = [1_u8, 0]; // Status with something behind it
    let table: [(&[u8], Failure); 4] = [
        (&unknown, Failure::Unsupported),
        (&cut_short, Failure::Malformed),
        (&too_long, Failure::Malformed),
        (&[], Failure::Malformed),
    ];
    let mut bench = Bench::open();
    for (message, failure) in table {
        assert_eq!(bench.say(message), [Response::Failed(failure.clone())]);
        assert_eq!(bench.say(message), [Response::Failed(failure)], "the same again when repeated");
        assert_eq!(bench.target.next(), None);
        bench.seq += 1;
    }
}

#[test]
fn a_request_before_hello_and_another_version_are_refused() {
    let mut bench = Bench::new();
    let status = postcard::to_allocvec(&Request::Status).unwrap();
    assert_eq!(bench.say(&status), [Response::Failed(Failure::NoSession)]);
    let hello = Request::Hello { version: PROTOCOL_VERSION + 1, session: 3 };
    let hello = postcard::to_allocvec(&hello).unwrap();
    assert_eq!(bench.say(&hello), [Response::Failed(Failure::Version)]);
    assert_eq!(bench.target.next(), None);
    assert!(!bench.target.is_open());
}

#[test]
fn the_last_four_answers_are_given_again_and_older_requests_are_ignored() {
    let mut bench = Bench::open();
    let status = postcard::to_allocvec(&Request::Status).unwrap();
    for seq in 1..=5 {
        bench.seq = seq;
        assert_eq!(bench.say(&status), []);
        assert_eq!(bench.say(&status), [], "no second time while it is worked on");
        assert_eq!(bench.target.next(), Some(TargetInput::Request { seq, request: Request::Status }));
        assert_eq!(bench.target.next(), None);
        bench.target.respond(seq, &Response::Failed(Failure::NotFound(seq.to_string())));
        assert_eq!(bench.answers().len(), 1);
    }
    for seq in 0..=5_u8 {
        bench.seq = seq;
        let expected =
            if seq < 2 { vec![] } else { vec![Response::Failed(Failure::NotFound(seq.to_string()))] };
        assert_eq!(bench.say(&status), expected, "{seq}");
        assert_eq!(bench.target.next(), None);
    }
}

#[test]
fn the_number_of_known_requests_is_up_to_date() {
    assert_eq!(u32::from(postcard::to_allocvec(&Request::MachineRegisters).unwrap()[0]), KNOWN_REQUESTS - 1);
}

/// What a host of this version hears from a target whose answer to Hello is `bytes`.
fn greeted(bytes: &[u8]) -> (HostSession, Option<HostEvent>) {
    let mut host = HostSession::new(7);
    host.poll(0);
    let hello = decode_all(&host.transmit(), 240);
    let mut payload = vec![0x80];
    payload.extend_from_slice(bytes);
    let mut line = Vec::new();
    frame::encode(kind::RESPONSE, hello[0].seq, &payload, &mut line);
    host.receive(0, &line);
    let heard = host.next();
    (host, heard)
}

#[test]
fn an_answer_to_hello_that_is_shorter_or_longer_is_understood() {
    let status = technol_wire::message::Status {
        plc: technol_wire::message::PlcState::Empty,
        held: false,
        cycle: 9,
        program: None,
    };
    let hello =
        |features| Response::Hello { version: PROTOCOL_VERSION, limits: LIMITS, boot: 5, status, features };
    let now = postcard::to_allocvec(&hello(3)).unwrap();

    let (_, heard) = greeted(&now[..now.len() - 1]);
    assert_eq!(
        heard,
        Some(HostEvent::Response(technol_wire::Ticket(0), hello(0))),
        "before there were features"
    );
    let mut later = now.clone();
    later.extend_from_slice(b"what a later version tells besides");
    let (host, heard) = greeted(&later);
    assert_eq!(heard, Some(HostEvent::Response(technol_wire::Ticket(0), hello(3))));
    assert_eq!(host.features(), 3);
}

#[test]
fn answers_and_events_of_a_later_version_are_passed_over() {
    let mut host = greeted(&postcard::to_allocvec(&Bench::hello()).unwrap()).0;
    let ticket = host.request(Request::Status);
    host.poll(1);
    let seq = decode_all(&host.transmit(), 240)[0].seq;
    let mut line = Vec::new();
    frame::encode(kind::RESPONSE, seq, &[0x80, 120, 1, 2, 3], &mut line);
    frame::encode(kind::EVENT, 0, &[0x80, 120, 9, 9], &mut line);
    let known = postcard::to_allocvec(&Event::Resumed).unwrap();
    frame::encode(kind::EVENT, 1, &[0x80, known[0]], &mut line);
    frame::encode(0xEE, 1, &[1, 2, 3], &mut line);
    host.receive(2, &line);
    assert_eq!(host.next(), Some(HostEvent::Response(ticket, Response::Failed(Failure::Unsupported))));
    assert_eq!(host.next(), Some(HostEvent::Event(Event::Resumed)));
    assert_eq!(host.next(), None);
    host.poll(3);
    let said = decode_all(&host.transmit(), 240);
    assert_eq!((said[0].kind, said[0].seq), (kind::EVENT_ACK, 1), "the unknown one is acknowledged too");
}

#[test]
fn a_target_that_wants_a_token_is_not_taken_for_a_silent_one() {
    let mut host = HostSession::new(7);
    let mut line = Vec::new();
    frame::encode(kind::CHALLENGE, 0, &[7; 16], &mut line);
    host.receive(0, &line);
    assert_eq!(host.next(), Some(HostEvent::LinkLost(LossReason::TokenNeeded)));
}
