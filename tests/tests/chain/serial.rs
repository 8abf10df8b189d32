//! Serial ports (manual 23).

use technol_machine::SERIAL_QUEUE;

use crate::plc::Plc;

/// A program whose channel 1 is configured.
fn connected(lines: &str) -> Plc {
    let mut plc = Plc::of(lines);
    plc.control().serial_mut(1);
    plc
}

#[test]
fn characters_come_from_the_operand_or_from_the_low_byte_of_dr() {
    let lines =
        "LOD CNST.4142h / COM_SEND 1 / WR O0 / STO W2 / COM_SEND 1,B1 / WR O1 / COM_SEND 1,CNST.-1 / WR O2";
    let mut plc = connected(lines);
    plc.set("B1=43h OB=0FFh");
    plc.run(1);
    // 0 is success, DR stays.
    assert_eq!(plc.differences("OB=0F8h W2=4142h"), [""; 0]);
    assert_eq!(plc.control().serial_mut(1).take_sent(), [0x42, 0x43, 0xFF]);
    assert_eq!(plc.control().serial_mut(1).take_sent(), [0x42, 0x43, 0xFF][..0]);
}

#[test]
fn texts_go_by_their_count_and_not_by_their_end_mark() {
    let mut plc = connected("COM_SEND_STR 1,SHORT,4 / WR O0 / COM_SEND_STR 1,LONG+2,B1 / WR O1");
    plc.set("OB=3 B1=3");
    plc.run(1);
    assert_eq!(plc.differences("OB=0"), [""; 0]);
    assert_eq!(plc.control().serial_mut(1).take_sent(), *b"cde\0cde");
}

#[test]
fn values_and_counts_of_every_type() {
    let lines = "COM_SEND 1,BYTE.B1 / COM_SEND 1,68 / COM_SEND_STR 1,LONG,BYTE.B2 / COM_SEND_STR 1,SHORT,W1 / \
                 COM_SEND_STR 1,MIDDLE,WORD.W2 / COM_RECV 1,BYTE.AREA / WR O0";
    let mut plc = connected(lines);
    plc.set("B1=67 B2=3 W1=2 W2=1 DWRD.AREA=-1 OB=1");
    plc.control().serial_mut(1).feed(&[0x5A]);
    plc.run(1);
    assert_eq!(plc.differences("OB=0 DWRD.AREA=0FFFFFF5Ah"), [""; 0]);
    assert_eq!(plc.control().serial_mut(1).take_sent(), *b"CDabccda");
}

#[test]
fn a_count_in_a_byte_has_no_sign() {
    let mut plc = connected("LDR I0 / JL0 L9 / COM_SEND_STR 1,BIG,B1 / WR O0 / L9:");
    plc.control().serial_mut(1).set_baud(1_000_000);
    plc.set("B1=200 I0=1");
    plc.run(1);
    plc.set("I0=0");
    plc.run(1);
    assert_eq!(plc.differences("O0=0"), [""; 0]);
    assert_eq!(plc.control().serial_mut(1).take_sent().len(), 200);
}

#[test]
fn the_line_carries_as_many_characters_as_its_speed_allows() {
    let mut plc = connected("LDR I0 / JL0 L9 / COM_SEND_STR 1,BIG,100 / L9:");
    plc.set("I0=1");
    plc.run(1);
    plc.set("I0=0");
    plc.control().serial_mut(1).take_sent();
    plc.run(1);
    // 20 ms at 9600 bits a second are 192 bits.
    assert_eq!(plc.control().serial_mut(1).take_sent().len(), 19);
    plc.control().serial_mut(1).set_baud(0);
    plc.run(1);
    assert_eq!(plc.control().serial_mut(1).take_sent().len(), 0);
}

#[test]
fn a_full_queue_takes_all_of_a_text_or_nothing() {
    let lines = "COM_SEND_STR 1,BIG,250 / WR O0 / COM_SEND_STR 1,LONG,7 / WR O1 / COM_CONTROL 1,STATE / STO W1 / \
                 COM_SEND_STR 1,LONG,6 / WR O2 / COM_SEND 1,B1 / WR O3";
    let mut plc = connected(lines);
    plc.control().serial_mut(1).set_baud(0);
    plc.set("OB=0");
    plc.run(1);
    assert_eq!(plc.differences("OB=1010b W1=4"), [""; 0]);
    plc.control().serial_mut(1).set_baud(1_000_000);
    plc.set("OB=0");
    // What was queued leaves unchanged and in order, 6 letters behind the 250.
    plc.run(1);
    let sent = plc.control().serial_mut(1).take_sent();
    assert_eq!(sent[250..SERIAL_QUEUE], *b"abcdef");
}

#[test]
fn one_execution_takes_one_character() {
    let mut plc = connected("LOD FIVE / COM_RECV 1 / WR O0 / STO W1 / COM_RECV 1,B1 / WR O1 / STO W2");
    plc.control().serial_mut(1).feed(&[0xFE, 0x41, 0x42]);
    plc.set("W1=-1 OB=3");
    plc.run(1);
    // DR has zeros above the character; with a cell DR stays.
    assert_eq!(plc.differences("OB=0 W1=0FEh B1=41h W2=0FEh"), [""; 0]);
    plc.set("B1=9");
    plc.run(1);
    assert_eq!(plc.differences("O0=0 O1=1 W1=42h B1=9"), [""; 0]);
    plc.run(1);
    // An empty queue leaves DR as it was.
    assert_eq!(plc.differences("OB=3 W1=5 W2=5 B1=9"), [""; 0]);
}

#[test]
fn the_state_tells_what_went_wrong() {
    let lines = "LDR I0 / JL0 L8 / COM_CONTROL 1,CLEAR / L8: / COM_CONTROL 1,RECEIVED / STO W1 / COM_CONTROL 1,STATE / \
                 STO B1 / COM_CONTROL 2,STATE / STO B2 / COM_SEND 2,B1 / WR O0 / COM_RECV 2,B1 / WR O1";
    let mut plc = connected(lines);
    plc.control().serial_mut(1).feed(&[7; 5]);
    plc.run(1);
    // Channel 2 is not configured.
    assert_eq!(plc.differences("W1=5 B1=0 B2=2 OB=3"), [""; 0]);
    plc.control().serial_mut(1).feed(&[7; SERIAL_QUEUE]);
    plc.run(1);
    assert_eq!(plc.differences(&format!("W1={SERIAL_QUEUE} B1=8")), [""; 0]);
    plc.set("I0=1");
    plc.control().serial_mut(1).set_failed(true);
    plc.run(1);
    plc.control().serial_mut(1).feed(&[7]);
    plc.run(1);
    assert_eq!(plc.differences("W1=0 B1=1"), [""; 0]);
}

#[test]
fn a_broken_line_takes_nothing() {
    let mut plc = connected("COM_SEND 1,B1 / WR O0");
    plc.control().serial_mut(1).set_failed(true);
    plc.run(2);
    assert_eq!(plc.differences("O0=1"), [""; 0]);
    plc.control().serial_mut(1).set_failed(false);
    plc.set("B1=5");
    plc.run(1);
    assert_eq!(plc.differences("O0=0"), [""; 0]);
    assert_eq!(plc.control().serial_mut(1).take_sent(), [5]);
}

#[test]
fn a_start_empties_the_queues() {
    let mut plc = connected("COM_CONTROL 1,RECEIVED / STO W1");
    plc.control().serial_mut(1).feed(&[1, 2]);
    plc.run(1);
    assert_eq!(plc.differences("W1=2"), [""; 0]);
    plc.restart();
    plc.run(1);
    assert_eq!(plc.differences("W1=0"), [""; 0]);
}

#[test]
fn a_count_above_the_queue_is_refused_and_one_of_nothing_is_done() {
    let mut plc = connected(
        "COM_SEND_STR 1,BIG,W1 / WR O0 / COM_SEND_STR 1,LONG,W2 / WR O1 / COM_CONTROL 1,STATE / STO B1",
    );
    plc.set("OB=2 W1=258 W2=0");
    plc.run(2);
    assert_eq!(plc.differences("OB=1 B1=4"), [""; 0]);
    assert_eq!(plc.control().serial_mut(1).take_sent(), [0_u8; 0]);
}
