//! The CAN bus (manual 9.4, 9.5) and packets to CAN drives (13.14). A packet lies in PACKET.

use technol_machine::{CAN_QUEUE, CanPacket};

use technol_runtime::{Resume, StopReason};

use crate::coverage::with_mutants;
use crate::plc::{Plc, first_line};

#[test]
fn packets_are_sent_as_they_are_and_dr_tells_that_they_are_queued() {
    let mut plc = Plc::of("LDR I0 / CAN_SEND 2,PACKET / STO D1 / WR O0");
    plc.set("I0=1 D1=-1 QWRD.PACKET=4433221103000123h DWRD.(PACKET+8)=0");
    plc.run(1);
    // RLO stays.
    assert_eq!(plc.differences("D1=0 O0=1"), [""; 0]);
    plc.run(1);
    let sent = plc.control().can_mut().take_sent(2);
    assert_eq!(
        sent[0],
        CanPacket { id: 0x123, remote: false, len: 3, data: [0x11, 0x22, 0x33, 0x44, 0, 0, 0, 0] }
    );
    assert_eq!(plc.control().can_mut().take_sent(1), []);
}

#[test]
fn a_length_above_eight_is_eight_and_a_remote_flag_is_any_number() {
    let mut plc = Plc::of("CAN_SEND 1,PACKET");
    plc.set("QWRD.PACKET=000000000C40FFFFh");
    plc.run(2);
    let sent = plc.control().can_mut().take_sent(1);
    assert_eq!((sent[0].id, sent[0].remote, sent[0].len), (0x7FF, true, 8));
}

#[test]
fn a_full_queue_refuses_a_packet() {
    let mut plc = Plc::of("CAN_SEND 2,PACKET / STO D1 / CAN_SEND 1,PACKET / STO D2");
    plc.control().can_mut().set_blocked(2, true);
    plc.run(CAN_QUEUE as u32);
    assert_eq!(plc.differences("D1=0 D2=0"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("D1=1 D2=0"), [""; 0]);
    assert_eq!(plc.control().can_mut().take_sent(2), []);
    plc.control().can_mut().set_blocked(2, false);
    plc.run(1);
    assert_eq!(plc.differences("D1=0"), [""; 0]);
}

#[test]
fn packets_are_received_in_order_and_an_empty_queue_leaves_everything_but_dr() {
    let mut plc = Plc::of("LDR I0 / CAN_RECV 2,PACKET / STO D1 / WR O0");
    plc.set("I0=1");
    plc.control().can_mut().feed(2, CanPacket::new(0x181, &[1, 2]));
    plc.control().can_mut().feed(1, CanPacket::new(0x300, &[9]));
    plc.control().can_mut().feed(2, CanPacket { remote: true, ..CanPacket::new(0x182, &[3]) });
    plc.run(1);
    assert_eq!(plc.differences("D1=0 QWRD.PACKET=0000020102000181h O0=1"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("D1=0 QWRD.PACKET=0000000301010182h"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("D1=2 QWRD.PACKET=0000000301010182h"), [""; 0]);
}

#[test]
fn more_packets_than_the_queue_holds_are_lost() {
    let mut plc = Plc::of("CAN_RECV 1,PACKET / EQ CNST.0 / JL0 L9 / LOD W1 / INR / STO W1 / L9:");
    for n in 0..CAN_QUEUE as u16 + 3 {
        plc.control().can_mut().feed(1, CanPacket::new(n, &[]));
    }
    assert_eq!(plc.control().can_mut().lost(), 3);
    plc.run(CAN_QUEUE as u32 + 5);
    assert_eq!(plc.differences(&format!("W1={CAN_QUEUE} WORD.PACKET={}", CAN_QUEUE - 1)), [""; 0]);
}

/// Counts packets in W1, sums their first data bytes in W2, keeps the channel in D1.
const ANSWER: &str = "LOD W1 / STO W1 / PROC_BEGIN ANSWER / STO D1 / LOD W1 / INR / STO W1 / LOD BYTE.(PACKET+4) / AD W2 / \
                      STO W2 / PROC_END ANSWER";

fn listening(request: &str) -> Plc {
    Plc::with_init(&format!("{request} / STO D2 / WR O0"), ANSWER)
}

#[test]
fn a_procedure_is_called_for_each_packet_in_the_range() {
    let mut plc = listening("CAN_RECV_REQ 2,580h,-,21h,24h,ANSWER,PACKET");
    assert_eq!(plc.differences("O0=1 D2=1"), [""; 0]);
    for (n, id) in [0x5A1, 0x5A4, 0x5A0, 0x5A5, 0x521, 0x621, 0x5A2].into_iter().enumerate() {
        plc.control().can_mut().feed(2, CanPacket::new(id, &[1 << n]));
    }
    // Another channel.
    plc.control().can_mut().feed(1, CanPacket::new(0x5A1, &[0x80]));
    plc.run(1);
    // 5A1h, 5A4h and 5A2h, the last of them stays in PACKET.
    assert_eq!(plc.differences("W1=3 W2=67 D1=2 WORD.PACKET=5A2h"), [""; 0]);
    plc.run(1);
    assert_eq!(plc.differences("W1=3"), [""; 0]);
}

#[test]
fn a_range_of_objects_and_a_single_node() {
    let mut plc = listening("CAN_RECV_REQ 1,180h,280h,5,-,ANSWER,PACKET");
    for id in [0x185, 0x205, 0x285, 0x105, 0x305, 0x204, 0x206] {
        plc.control().can_mut().feed(1, CanPacket::new(id, &[]));
    }
    plc.run(1);
    assert_eq!(plc.differences("W1=3 D1=1 WORD.PACKET=285h"), [""; 0]);
}

#[test]
fn the_procedures_run_before_the_cycle_and_only_from_its_start() {
    let mut plc = Plc::with_init(
        "CAN_RECV_REQ 2,580h,-,1,-,P,PACKET",
        "LOD W1 / STO W2 / PROC_BEGIN P / LOD FIVE / STO W1 / PROC_END P",
    );
    plc.run(1);
    assert_eq!(plc.differences("W2=0"), [""; 0]);
    plc.control().can_mut().feed(2, CanPacket::new(0x581, &[]));
    plc.run(1);
    // The procedure stands behind in the text, and was executed before.
    assert_eq!(plc.differences("W1=5 W2=5"), [""; 0]);
}

/// Three packets that are answered, in a cycle that is held at each stop and goes on `how`; the lines it was held at.
fn answered_in_steps(plc: &mut Plc, how: Resume) -> Vec<usize> {
    for (n, id) in [0x5A1, 0x5A4, 0x5A2].into_iter().enumerate() {
        plc.control().can_mut().feed(2, CanPacket::new(id, &[1 << n]));
    }
    let mut lines = Vec::new();
    let end = plc.runtime().millis() + 20;
    while plc.runtime().millis() < end {
        plc.tick(1);
        if let Some(stop) = plc.runtime().stopped() {
            lines.extend(plc.line_of(stop.pc));
            assert!(lines.len() < 100, "it never ends: {lines:?}");
            plc.runtime().resume(how);
        }
    }
    assert_eq!(plc.differences("W1=3 W2=7 D1=2 WORD.PACKET=5A2h"), [""; 0], "{how:?}");
    lines
}

#[test]
fn a_call_back_is_held_at_break_points_and_stepped_through() {
    let request = "CAN_RECV_REQ 2,580h,-,21h,24h,ANSWER,PACKET";
    let first = first_line() + 2; // INIT has two more lines, but it stands behind
    let body: Vec<usize> = (first + 1..=first + 7).collect();
    let mut held = listening(request);
    let pc = held.pc_of(body[0]).expect("a line with code");
    assert!(held.runtime().set_breakpoints(&[pc]).iter().all(Result::is_ok));
    assert_eq!(answered_in_steps(&mut held, Resume::Continue), [body[0]; 3]);
    // Into each of the three calls, line by line, to its end.
    let mut stepped = listening(request);
    stepped.runtime().pause();
    let lines = answered_in_steps(&mut stepped, Resume::StepInto);
    for line in &body {
        assert_eq!(lines.iter().filter(|it| *it == line).count(), 3, "{line} in {lines:?}");
    }
    for how in [Resume::StepOver { sequence: None }, Resume::StepOut] {
        let mut stepped = listening(request);
        stepped.runtime().set_breakpoints(&[pc]).iter().for_each(|set| assert!(set.is_ok()));
        let lines = answered_in_steps(&mut stepped, how);
        assert_eq!(lines.iter().filter(|it| **it == body[0]).count(), 3, "{how:?}: {lines:?}");
    }
}

#[test]
fn a_call_back_that_is_held_shows_who_called_it() {
    let mut plc = listening("CAN_RECV_REQ 2,580h,-,21h,24h,ANSWER,PACKET");
    let line = first_line() + 5; // INR
    let pc = plc.pc_of(line).expect("a line with code");
    assert!(plc.runtime().set_breakpoints(&[pc]).iter().all(Result::is_ok));
    plc.control().can_mut().feed(2, CanPacket::new(0x5A1, &[9]));
    plc.tick(5);
    let stop = plc.runtime().stopped().expect("it is held");
    assert_eq!((stop.reason, plc.line_of(stop.pc)), (StopReason::Breakpoint, Some(line)));
    // The packet is there, the channel in D1, nothing is counted yet.
    assert_eq!(plc.differences("WORD.PACKET=5A1h D1=2 W1=0 DR=0"), [""; 0]);
    let lines: Vec<_> = plc.runtime().call_stack().iter().map(|frame| frame.pc).collect();
    assert_eq!(lines.first(), Some(&pc));
    // What is written now is what it goes on with.
    plc.set("W2=100");
    plc.runtime().resume(Resume::Continue);
    plc.run(1);
    assert_eq!(plc.differences("W1=1 W2=109"), [""; 0]);
}

#[test]
fn a_cancelled_request_calls_nothing() {
    for name in ["CAN_RECV_END", "CAN_RECV_DEL", "CAN_RECV_END DWRD.", "CAN_RECV_DEL DWRD."] {
        let name = if name.ends_with('.') { name.to_owned() } else { format!("{name} ") };
        let init = "CAN_RECV_REQ 2,580h,-,1,-,ANSWER,PACKET / STO D2";
        let mut plc = Plc::with_init(init, &format!("LDR I0 / JL0 L8 / {name}D2 / WR O0 / L8: / {ANSWER}"));
        plc.control().can_mut().feed(2, CanPacket::new(0x581, &[]));
        plc.set("I0=1 O0=0");
        plc.run(1);
        assert_eq!(plc.differences("W1=1 O0=1"), [""; 0], "{name}");
        plc.control().can_mut().feed(2, CanPacket::new(0x581, &[]));
        plc.run(1);
        // The second time there is no such request.
        assert_eq!(plc.differences("W1=1 O0=0"), [""; 0], "{name}");
    }
}

#[test]
fn requests_end_with_the_program_and_an_inactive_channel_refuses_them() {
    let mut plc = listening("CAN_RECV_REQ 2,580h,-,1,-,ANSWER,PACKET");
    plc.control().can_mut().set_active(2, false);
    plc.restart();
    assert_eq!(plc.differences("O0=0"), [""; 0]);
    plc.control().can_mut().set_active(2, true);
    plc.control().can_mut().feed(2, CanPacket::new(0x581, &[]));
    plc.run(1);
    assert_eq!(plc.differences("W1=0"), [""; 0]);
}

#[test]
fn members_of_units_have_their_widths_and_rlo_0_is_success() {
    let read = "CAN_SYSIO_READ 2,1,3,ANL0 / WR O0 / STO D1 / CAN_SYSIO_READ 2,1,3,VENDORID / WR O1 / STO QWRD.Q1 / \
                LOD FIVE / CAN_SYSIO_READ 2,1,4,ANL0 / WR O2 / STO D2";
    let mut plc = Plc::of(read);
    let unit = plc.control().can_unit_mut(2, 1, 3);
    assert!(unit.set("anl0", 0x1FE) && unit.set("VENDORID", 0xFFFF_FFFF) && !unit.set("ANL8", 1));
    plc.set("OB=0");
    plc.run(2);
    // Without sign into the whole DR; of a unit that is not there DR stays.
    assert_eq!(plc.differences("OB=100b D1=0FEh QWRD.Q1=0FFFFFFFFh D2=5"), [""; 0]);
}

/// Members of a unit with their lengths in bytes.
const MEMBERS: [(&str, u32); 45] = [
    ("MODE", 1),
    ("OUT0", 1),
    ("OUT1", 1),
    ("OUT2", 1),
    ("CONTROL", 1),
    ("SEND_REQ", 1),
    ("SHORT_SEND_REQ", 1),
    ("SHORT_OUT0", 1),
    ("SHORT_OUT1", 1),
    ("SHORT_OUT2", 1),
    ("SIZE", 2),
    ("PRESENT", 1),
    ("VENDORID", 4),
    ("DEVICENAME", 4),
    ("HWVERSION", 4),
    ("SWVERSION", 4),
    ("IN0", 1),
    ("IN1", 1),
    ("IN2", 1),
    ("IN3", 1),
    ("ANL0", 1),
    ("ANL1", 1),
    ("ANL2", 1),
    ("ANL3", 1),
    ("ANL4", 1),
    ("ANL5", 1),
    ("ANL6", 1),
    ("ANL7", 1),
    ("ERROR", 1),
    ("ERR_CODE", 1),
    ("ERR_STAT", 1),
    ("COUNT", 2),
    ("RESP_COUNT", 1),
    ("RPDO_COUNT", 2),
    ("TPDO_COUNT", 2),
    ("PXIN", 2),
    ("PXOUT", 2),
    ("IRC0", 2),
    ("IRC1", 2),
    ("MODE_ACT", 1),
    ("MODE_FAZE", 1),
    ("TL0", 1),
    ("TL1", 1),
    ("TL2", 1),
    ("TL3", 1),
];

#[test]
fn every_member_is_read_and_written_at_its_width() {
    let steps = |step: &dyn Fn(usize, &str) -> String| -> String {
        (0..).zip(MEMBERS).map(|(n, (member, _))| step(4 * n, member)).collect::<Vec<_>>().join(" / ")
    };
    let check = |plc: &Plc, written: &dyn Fn(u32, &str) -> u32| {
        for (n, (member, bytes)) in (0..).zip(MEMBERS) {
            let value = written(n, member) & u32::MAX >> (32 - 8 * bytes);
            assert_eq!(plc.differences(&format!("DWRD.(BIG+{})={value} O1=0", 4 * n)), [""; 0], "{member}");
        }
    };
    let reads =
        steps(&|at, member| format!("CAN_SYSIO_READ 1,2,32,{member} / LO O1 / WR O1 / STO DWRD.(BIG+{at})"));
    with_mutants(|| {
        let mut read = Plc::of(&reads);
        let unit = read.control().can_unit_mut(1, 2, 32);
        // A value of its own for each; but MODE_ACT follows MODE.
        let value = |n: u32| 0x9CAD_BECF_u32.wrapping_sub(n * 0x0101_0101);
        for (n, (member, _)) in (0..).zip(MEMBERS) {
            assert!(unit.set(member, value(n)), "{member}");
        }
        read.run(2);
        let mode = MEMBERS.iter().position(|(member, _)| *member == "MODE").expect("a member") as u32;
        check(&read, &|n, member| value(if member == "MODE_ACT" { mode } else { n }));
    });
    let writes = steps(&|at, member| {
        format!(
            "LOD CNST.12345678h / CAN_SYSIO_WRITE 1,2,32,{member} / LO O1 / WR O1 / LOD CNST.-1 / CAN_SYSIO_READ 1,2,32,{member} / \
             STO DWRD.(BIG+{at})"
        )
    });
    with_mutants(|| {
        let mut written = Plc::of(&writes);
        written.control().can_unit_mut(1, 2, 32);
        written.run(1);
        check(&written, &|_, _| 0x1234_5678);
    });
}

#[test]
fn what_the_control_fills_is_true_again_in_the_next_cycle() {
    let lines = "LOD CNST.101h / CAN_SYSIO_WRITE 2,1,4,MODE / WR O0 / CAN_SYSIO_WRITE 2,1,4,IN0 / STO W1 / \
                 CAN_SYSIO_READ 2,1,4,IN0 / STO W2 / CAN_SYSIO_WRITE 2,2,4,MODE / WR O1";
    let mut plc = Plc::of(lines);
    plc.control().can_unit_mut(2, 1, 4).set("IN0", 0x70);
    plc.set("OB=1");
    plc.run(1);
    // A byte of DR, which stays.
    assert_eq!(plc.differences("O0=0 O1=1 W1=101h W2=1"), [""; 0]);
    let seen = |plc: &mut Plc, name| plc.control().can_unit_mut(2, 1, 4).get(name);
    assert_eq!((seen(&mut plc, "MODE"), seen(&mut plc, "MODE_ACT")), (Some(1), Some(0)));
    let mut idle = Plc::of("CAN_SYSIO_READ 2,1,4,IN0 / STO W2");
    idle.control().can_unit_mut(2, 1, 4).set("IN0", 0x70);
    idle.run(2);
    assert_eq!(idle.differences("W2=70h"), [""; 0]);
    plc.run(1);
    assert_eq!(seen(&mut plc, "MODE_ACT"), Some(1));
}

/// Sends the request in Q1 to the drive of axis 2 once when I0 rises, copies answer and busy byte.
const SEND: &str = "EDGE_H I0 / JL0 L8 / LOD QWRD.Q1 / STO QWRD.CAN_AX_SEND_PACKET.CAN_DATA / LDR I1 / LOD FIVE / CAN_AX_SEND 2 / \
                    STO D1 / WR O0 / L8: / LOD CAN_AX_BUSY / STO W1 / LOD QWRD.CAN_AX_RECV_PACKET / STO QWRD.Q2 / \
                    LOD DWRD.CAN_AX_RECV_PACKET.CAN_DATA_4 / STO D2 / LOD DWRD.CAN_AX_SEND_PACKET / STO DWRD.AREA";

fn ask(plc: &mut Plc, request: &str) {
    plc.set("I0=0");
    plc.run(1);
    plc.set(&format!("I0=1 I1=1 QWRD.Q1={request}"));
    plc.run(1);
    assert_eq!(plc.differences("W1=-1 D1=5 O0=1 DWRD.AREA=08000602h"), [""; 0], "{request}");
    plc.run(1);
}

#[test]
fn a_drive_answers_a_packet_and_clears_the_busy_byte() {
    let mut plc = Plc::of(SEND);
    let drive = plc.control().can_drive_mut(2);
    drive.set_object(0x6060, 0, &[1], false);
    drive.set_object(0x6041, 0, &[0x37, 0x82], true);
    // 2Fh: write one byte.
    ask(&mut plc, "000000060060602Fh");
    assert_eq!(plc.differences("W1=0 QWRD.Q2=0060606008000582h D2=0"), [""; 0]);
    assert_eq!(plc.control().can_drive_mut(2).object(0x6060, 0), Some(&[6][..]));
    // 40h: read; 4Bh: two bytes come.
    ask(&mut plc, "0000000000604140h");
    assert_eq!(plc.differences("W1=0 QWRD.Q2=0060414B08000582h D2=8237h"), [""; 0]);
    // Refusals: read only, too long, no such object, no such subindex.
    for (request, code) in [
        ("000000010060412Bh", "06010002h"),
        ("000000060060602Bh", "06070012h"),
        ("0000000000607040h", "06020000h"),
        ("0000000001606040h", "06090011h"),
    ] {
        ask(&mut plc, request);
        assert_eq!(plc.differences(&format!("W1=0 BYTE.Q2=82h D2={code}")), [""; 0], "{request}");
    }
}

#[test]
fn a_silent_drive_leaves_the_busy_byte() {
    let mut plc = Plc::of(SEND);
    plc.run(1);
    plc.set("I0=1 I1=1 QWRD.Q1=40h");
    plc.run(20);
    assert_eq!(plc.differences("W1=-1 QWRD.Q2=0"), [""; 0]);
    // As soon as it answers, a packet sent again is answered.
    plc.control().can_drive_mut(2).set_silent(true);
    ask(&mut plc, "0000000000604140h");
    assert_eq!(plc.differences("W1=-1"), [""; 0]);
    plc.control().can_drive_mut(2).set_silent(false);
    ask(&mut plc, "0000000000604140h");
    assert_eq!(plc.differences("W1=0"), [""; 0]);
}

/// CAN_IO_ERROR_CODE, CAN_IO_ERROR_NUM, CAN_IO_TIMEOUT_CODE, CAN_IO_TIMEOUT_NUM.
fn errors(plc: &Plc, code: u8, number: u8, timeout: u8, silent: u8) {
    let values = format!(
        "CAN_IO_ERROR_CODE={code} CAN_IO_ERROR_NUM={number} CAN_IO_TIMEOUT_CODE={timeout} CAN_IO_TIMEOUT_NUM={silent}"
    );
    assert_eq!(plc.differences(&values), [""; 0]);
}

#[test]
fn errors_of_units_are_told_with_their_number() {
    let machine = "can-unit = [{ can = 2, group = 1, board = 1 }, { can = 2, group = 1, board = 3 }]\n\
                   fault = [{ name = 'cut', can = 2, cut = true }, { name = 'short', output = 'P7OUT.2', shorted = true }]";
    let mut plc = Plc::before(
        machine,
        "LDR CAN_IO_ERROR_CODE.ERR_IO8_SHORT / WR O0 / LDR I0 / WR O1 / LOD OB / STO P7OUT / CAN_SYSIO_READ 2,1,3,ERR_CODE / STO B2 / \
         LOD CNST.4 / LDR I1 / JL0 L / CAN_SYSIO_WRITE 2,1,3,CONTROL / L:",
    );
    plc.run(2);
    errors(&plc, 0, 0, 0, 0);
    plc.control().can_unit_mut(2, 1, 3).set("ERROR", 0x10);
    plc.run(2);
    errors(&plc, 0x11, 3, 0, 0);
    plc.control().can_unit_mut(2, 1, 3).set("ERROR", 0);
    plc.run(2);
    errors(&plc, 0, 0, 0, 0);
    assert_eq!(plc.differences("B2=11h"), [""; 0], "the last error is kept");
    plc.fault_of_machine("cut", true);
    plc.run(2);
    errors(&plc, 0, 0, 1, 1);
    plc.fault_of_machine("cut", false);
    plc.run(2);
    errors(&plc, 0, 0, 0, 0);
}

#[test]
fn the_control_reports_errors_of_its_buses_by_itself() {
    let machine = "can-drive = [{ axis = 2 }, { axis = 3 }]\n\
                   fault = [{ name = 'cut', can = 2, cut = true }, { name = 'lost', can-drive = 2, lost = true }, \
                   { name = 'hot', can-drive = 3, error = 0x4310 }]";
    let mut plc = Plc::before(
        machine,
        "LDR I0 / JL0 L / FL 0,I0 / CAN_AX_SEND 2 / L: / LDR I1 / JL0 M / FL 0,I1 / CAN_AX_SEND 3 / M:",
    );
    plc.run(1);
    let mut told = Vec::new();
    for (fault, given) in [("cut", ""), ("lost", "I0=1"), ("hot", ""), ("", "I1=1")] {
        if !fault.is_empty() {
            plc.fault_of_machine(fault, true);
        }
        plc.set(given);
        plc.events(3).into_iter().for_each(|event| {
            if let technol_runtime::RuntimeEvent::Message { number, set, parameters, pc, .. } = event {
                told.push((number, set, parameters, plc.line_of(pc)));
            }
        });
    }
    let expected = [
        (4204, true, [Some(2), None, None], None),
        (4208, true, [Some(2), None, None], None),
        (4217, true, [Some(3), Some(1), Some(0x4310)], None),
        (4209, true, [Some(3), None, None], None),
    ];
    assert_eq!(told, expected);
    let on_screen = plc.control().board().transient().next().map(|message| message.number);
    assert_eq!(on_screen, Some(4204), "the first is to be confirmed");
    let shown = plc.control().board().transient().nth(2).copied().expect("three messages");
    let text = shown.text(plc.control().data());
    assert_eq!(String::from_utf8_lossy(&text), "CAN drive 3 reports an error, register 1, code 4310");
}

#[test]
fn a_packet_is_cut_at_the_end_of_its_place() {
    // A text of three characters has four bytes.
    let mut plc = Plc::of("CAN_RECV 2,SHORT / STO D1");
    plc.control().can_mut().feed(2, CanPacket::new(0x181, &[0x55; 8]));
    plc.run(1);
    assert_eq!(plc.differences("D1=0 DWRD.SHORT=08000181h BYTE.BEHIND=77h"), [""; 0]);
    let mut plc = Plc::with_init(
        "CAN_RECV_REQ 2,580h,-,1,-,P,SHORT",
        "LOD FIVE / PROC_BEGIN P / LOD FIVE / STO W1 / PROC_END P",
    );
    plc.control().can_mut().feed(2, CanPacket::new(0x581, &[0x55; 8]));
    plc.run(1);
    assert_eq!(plc.differences("W1=5 DWRD.SHORT=08000581h BYTE.BEHIND=77h"), [""; 0]);
}

#[test]
fn a_handle_has_32_bits() {
    for end in ["CAN_RECV_END", "CAN_RECV_DEL"] {
        let lines =
            format!("LDR I0 / JL0 L9 / {end} D1 / WR O0 / L9: / PROC_BEGIN P / LOD FIVE / PROC_END P");
        let mut plc = Plc::with_init("CAN_RECV_REQ 2,580h,-,1,-,P,PACKET / STO D1 / WR O1", &lines);
        assert_eq!(plc.differences("O1=1 D1=1"), [""; 0]);
        plc.set("I0=1 D1=10001h O0=1");
        plc.run(1);
        assert_eq!(plc.differences("O0=0"), [""; 0], "{end}");
        plc.set("D1=1");
        plc.run(1);
        assert_eq!(plc.differences("O0=1"), [""; 0], "{end}");
        plc.run(1);
        assert_eq!(plc.differences("O0=0"), [""; 0], "{end}: it is known no more");
    }
}
