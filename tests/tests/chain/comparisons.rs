//! Comparisons (manual 3.14): with sign, at the width of the operand.

use crate::plc::{Row, check};

/// DR is 5 at the widths 8, 16, 32 and 64; the operands are 4, 5, 6 and -1.
#[track_caller]
fn at_every_width(relation: &str, results: [bool; 4]) {
    let mut rows: Vec<Row> = Vec::new();
    for (operand, result) in ["4", "5", "6", "-1"].into_iter().zip(results) {
        let cells = ["B1", "W1", "D1", "QWRD.Q1", "BYTE.AREA", "WORD.AREA", "DWRD.AREA", "HIGH.W1"]
            .map(|cell| (format!("{cell}={operand}"), cell.to_owned()));
        let number = (String::new(), operand.to_owned());
        let real = (format!("REAL.R1={operand}.0"), "REAL.R1".to_owned());
        let constant = (String::new(), format!("CNST.{operand}"));
        let real_constant = (String::new(), format!("CNST.{operand}.0"));
        for (given, compared) in cells.into_iter().chain([number, real, constant, real_constant]) {
            let lines = format!("LOD CNST.5.0 / {relation} {compared} / WR O0");
            let then = format!("OB={} DR64=5 DR_REAL=5.0", u8::from(result));
            rows.push((leak(given), leak(lines), leak(then)));
        }
    }
    check(&rows);
}

#[test]
fn equal_at_every_width() {
    at_every_width("EQ", [false, true, false, false]);
}

#[test]
fn less_at_every_width() {
    at_every_width("LT", [false, false, true, false]);
}

#[test]
fn greater_at_every_width() {
    at_every_width("GT", [true, false, false, true]);
}

#[test]
fn less_or_equal_at_every_width() {
    at_every_width("LE", [false, true, true, false]);
}

#[test]
fn greater_or_equal_at_every_width() {
    at_every_width("GE", [true, true, false, true]);
}

/// Rows are written as literals; these are few.
fn leak(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

#[test]
fn only_the_part_of_dr_at_the_width_counts() {
    const Q: &str = "QWRD.Q1=1122334455667788h B1=88h W1=7788h D1=55667788h QWRD.Q2=55667788h";
    check(&[
        (Q, "LOD QWRD.Q1 / EQ B1 / WR O0", "OB=1"),
        (Q, "LOD QWRD.Q1 / EQ W1 / WR O0", "OB=1"),
        (Q, "LOD QWRD.Q1 / EQ D1 / WR O0", "OB=1"),
        (Q, "LOD QWRD.Q1 / EQ CNST.55667788h / WR O0", "OB=1"),
        (Q, "LOD QWRD.Q1 / EQ QWRD.Q2 / WR O0", "OB=0"),
        (Q, "LOD QWRD.Q1 / EQ BYTE.(W1+1) / WR O0", "OB=0"),
        ("B1=0FFh", "LOD B1 / EQ BYTE.255 / WR O0", "OB=1"),
        ("B1=0FFh", "LOD B1 / EQ CNST.255 / WR O0", "OB=0"),
        ("B1=0FFh", "LOD B1 / EQ CNST.-1 / WR O0", "OB=1"),
        ("W1=8000h", "LOD CNST.5 / LT W1 / WR O0", "OB=0"),
        ("W1=8000h", "LOD W1 / LT CNST.5 / WR O0", "OB=1"),
        ("W1=0500h", "LOD CNST.5 / EQ HIGH.W1 / WR O0", "OB=1"),
        ("W1=1234h", "LOD W1 / EQ BYTE.34h / WR O0 / EQ BYTE.33h / WR O1 / EQ BYTE.35h / WR O2", "OB=1"),
    ]);
    // What is less in its upper part is more in its lower.
    for (relation, less) in [("EQ", "0"), ("LT", "0"), ("GT", "1"), ("LE", "0"), ("GE", "1")] {
        let given = "QWRD.Q1=1122334455667788h W1=7699h D1=55657799h QWRD.Q2=1122334355667799h REAL.R1=1.0";
        let rows: Vec<Row> = ["W1", "D1", "QWRD.Q2", "CNST.55657799h"]
            .into_iter()
            .map(|operand| {
                let lines = format!("LOD QWRD.Q1 / {relation} {operand} / WR O0");
                (given, leak(lines), leak(format!("OB={less}")))
            })
            .collect();
        check(&rows);
        // DR64 is negative, DR32 is not.
        let lines = format!("LOD QWRD.Q1 / {relation} CNST.55657799h / WR O0");
        check(&[("QWRD.Q1=0F122334455667788h", leak(lines), leak(format!("OB={less}")))]);
    }
    const EQUAL_BELOW: &str = "QWRD.Q1=1122334455667788h W1=7688h D1=54667788h QWRD.Q2=1122334355667788h";
    check(&[
        (EQUAL_BELOW, "LOD QWRD.Q1 / EQ W1 / WR O0", "OB=0"),
        (EQUAL_BELOW, "LOD QWRD.Q1 / EQ D1 / WR O0", "OB=0"),
        ("", "LOD CNST.5.125 / GT CNST.5.0 / WR O0 / LE CNST.5.0 / WR O1", "OB=1"),
        ("", "LOD CNST.5.125 / GE CNST.5.0 / WR O0 / LT CNST.5.0 / WR O1", "OB=1"),
    ]);
}

#[test]
fn chained_comparisons_only_clear() {
    // The first of a pair of cells is what the low part of Q1 is, the second differs in its last byte.
    const HALF: &str = "QWRD.Q1=1122334455667788h QWRD.Q2=1022334455667788h D1=55667788h D2=54667788h W1=7788h W2=8888h \
                        B1=88h B2=87h REAL.R1=0.5 REAL.R2=0.25";
    check(&[
        ("IB=1 W1=5", "LDR I0 / LOD W1 / EQ1 CNST.5 / WR O0", "OB=1"),
        ("IB=1 W1=6", "LDR I0 / LOD W1 / EQ1 CNST.5 / WR O0", "OB=0"),
        ("IB=0 W1=5", "LDR I0 / LOD W1 / EQ1 CNST.5 / WR O0", "OB=0"),
        ("IB=1 W1=5 B1=7", "LDR I0 / LOD W1 / EQ1 CNST.5 / LOD B1 / EQ1 BYTE.7 / WR O0", "OB=1"),
        ("IB=1 W1=4 B1=7", "LDR I0 / LOD W1 / EQ1 CNST.5 / LOD B1 / EQ1 BYTE.7 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 B1 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 B2 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 BYTE.AREA / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 W1 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 W2 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 WORD.W1 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 WORD.W2 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 D1 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 D2 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 DWRD.D1 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 DWRD.D2 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 HIGH.W2 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 HIGH.W1 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 QWRD.Q1 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD QWRD.Q1 / EQ1 QWRD.Q2 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD REAL.R1 / EQ1 REAL.R1 / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD REAL.R1 / EQ1 REAL.R2 / WR O0", "OB=0"),
        (HALF, "LDR -I0 / LOD CNST.5 / EQ1 FIVE / WR O0", "OB=1"),
        (HALF, "LDR -I0 / LOD CNST.5 / EQ1 6 / WR O0", "OB=0"),
        ("IB=1 REAL.R1=0.5", "LDR I0 / LOD REAL.R1 / EQ1 CNST.0.5 / WR O0", "OB=1"),
        ("REAL.R1=0.5", "LDR I0 / LOD REAL.R1 / EQ1 CNST.0.5 / WR O0", "OB=0"),
        ("IB=1 REAL.R1=0.5", "LDR I0 / LOD REAL.R1 / EQ1 CNST.0.25 / WR O0", "OB=0"),
        ("IB=1 REAL.R1=0.5", "LDR I0 / LOD REAL.R1 / EQ1 CNST.0.75 / WR O0", "OB=0"),
        ("IB=1 REAL.R1=0.5 REAL.R2=0.75", "LDR I0 / LOD REAL.R1 / EQ1 REAL.R2 / WR O0", "OB=0"),
        // What is equal does not help when RLO is 0.
        (HALF, "LDR I0 / LOD QWRD.Q1 / EQ1 B1 / WR O0", "OB=0"),
        (HALF, "LDR I0 / LOD QWRD.Q1 / EQ1 W1 / WR O0", "OB=0"),
        (HALF, "LDR I0 / LOD QWRD.Q1 / EQ1 D1 / WR O0", "OB=0"),
        (HALF, "LDR I0 / LOD QWRD.Q1 / EQ1 QWRD.Q1 / WR O0", "OB=0"),
        (HALF, "LDR I0 / LOD REAL.R1 / EQ1 REAL.R1 / WR O0", "OB=0"),
        // More than what is in DR.
        ("IB=1 D1=55667789h", "LDR I0 / LOD CNST.55667788h / EQ1 D1 / WR O0", "OB=0"),
        ("IB=1 W1=7789h", "LDR I0 / LOD CNST.7788h / EQ1 W1 / WR O0", "OB=0"),
        ("IB=1 B1=12h", "LDR I0 / LOD CNST.11h / EQ1 B1 / WR O0", "OB=0"),
        ("IB=1 QWRD.Q1=100000001h QWRD.Q2=100000002h", "LDR I0 / LOD QWRD.Q1 / EQ1 QWRD.Q2 / WR O0", "OB=0"),
        // DR32 counts against a number, DR8 against one of 8 bits.
        ("IB=1 QWRD.Q1=1122334400000005h", "LDR I0 / LOD QWRD.Q1 / EQ1 FIVE / WR O0", "OB=1"),
        ("IB=1 D1=10005h", "LDR I0 / LOD D1 / EQ1 FIVE / WR O0", "OB=0"),
        ("IB=1 W1=107h", "LDR I0 / LOD W1 / EQ1 BYTE.7 / WR O0", "OB=1"),
        ("IB=1 W1=107h", "LDR I0 / LOD W1 / EQ1 BYTE.6 / WR O0", "OB=0"),
        ("IB=1 W1=107h", "LDR I0 / LOD W1 / EQ1 BYTE.8 / WR O0", "OB=0"),
        ("W1=107h", "LDR I0 / LOD W1 / EQ1 BYTE.7 / WR O0", "OB=0"),
    ]);
}
