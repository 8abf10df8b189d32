//! Programs that are not built, and why.

use std::fmt::Write as _;

use crate::{project, refused, shown, source};

fn refusal(data: &str, main: &str) -> String {
    shown(&refused(&project(&[("main.plc", &source(data, main))])))
}

#[test]
fn errors_of_the_check_come_first() {
    let text = refusal("", "LDR NOWHERE\nWR NOWHERE\nSTRCPY X,'A'\n");
    assert!(text.contains("main.plc:4:5 ") && text.contains("NOWHERE"), "{text}");
    assert!(!text.contains("T0801"), "{text}");
}

#[test]
fn an_instruction_the_target_cannot_run_is_named_at_its_place() {
    let text = refusal("W: DS 2\n", "NOP\n   IDIV BX ;divide\n");
    assert_eq!(text, "main.plc:6:4 T0801 not executable on this target yet: IDIV");
}

#[test]
fn what_the_target_has_not_of_the_80386_is_named() {
    for (line, named) in [
        ("ADC ECX,1", "ADC"),
        ("PUSH EAX", "PUSH"),
        ("MOV SI,CX", "MOV with the register SI"),
        ("CMP CX,BP", "CMP with the register BP"),
        ("INC ESP", "INC with the register ESP"),
        ("MOV AX,ES", "MOV with the register ES"),
        ("INC QWRD.Q", "INC with 64 bits"),
        ("SHL QWRD.Q,1", "SHL with 64 bits"),
    ] {
        let text = refusal("Q: DS 8\n", &format!("{line}\n"));
        let errors: Vec<&str> = text.lines().filter(|line| line.contains("T0801")).collect();
        assert_eq!(
            errors,
            [format!("main.plc:5:1 T0801 not executable on this target yet: {named}")],
            "{line}: {text}"
        );
    }
}

#[test]
fn an_operand_of_the_80386_has_no_sign() {
    let text = refusal("W: DS 2\n", "MOV CX,-W\n");
    assert!(text.contains("a register, a cell or a number is needed here"), "{text}");
}

#[test]
fn clear_does_not_go_backwards() {
    let text = refusal("A: DS 1\nB: DS 2\n", "CLEAR A,B\nCLEAR B,A\n");
    assert!(text.starts_with("main.plc:7:1 T0803 CLEAR needs two variables of one data area"), "{text}");
    assert_eq!(text.lines().count(), 1, "{text}");
}

#[test]
fn a_counter_must_be_able_to_reach_its_time() {
    let main = "MECH_BEGIN M\nTIM C,300\nTIM C,255\nTIM W,C\nMECH_END M\n";
    let text = refusal("C: DS 1\nW: DS 2\n", main);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 2, "{text}");
    assert!(lines[0].starts_with("main.plc:7:7 T1146 ") && lines[0].contains("never reaches 300"), "{text}");
    assert!(lines[1].starts_with("main.plc:9:7 T0412 ") && lines[1].contains("one type"), "{text}");
}

#[test]
fn more_data_than_memory_holds() {
    let text = refusal("A: DS 0FFFFFh\nB: DS 2\n", "");
    assert!(text.starts_with("main.plc:3:1 T0802 the global data are longer than 1048576 bytes"), "{text}");
}

#[test]
fn more_messages_than_a_table_holds() {
    let mut main = String::new();
    for _ in 0..40_000 {
        main.push_str("ESET 1\n");
    }
    // Two sections with fewer than 65536 each, together more.
    let second = format!("DATA\nDATA_END\nMODULE_MAIN\n{main}MODULE_MAIN_END\n");
    let mut manifest = String::from("[project]\nname = \"many\"\nmain = \"main.plc\"\n");
    let _ = writeln!(manifest, "files = [\"second.plc\"]");
    let first = source("", &main);
    let files = [("technol.toml", manifest.as_str()), ("main.plc", &first), ("second.plc", &second)];
    let text = shown(&refused(&project(&files)));
    assert!(
        text.starts_with("second.plc:25540:1 T0802 too many messages"),
        "{}",
        &text[..200.min(text.len())]
    );
}
