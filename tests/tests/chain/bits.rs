//! Bit logic and jumps (manual 3.5 to 3.9).

use crate::coverage::with_mutants;
use crate::plc::{Plc, check};

#[test]
fn equations() {
    check(&[
        ("IB=1", "LDR I0 / WR O0", "RLO=1 OB=1"),
        ("IB=1", "LDR -I0 / WR O0", "RLO=0 OB=0"),
        ("IB=0", "LDR -I0 / WR O0", "RLO=1 OB=1"),
        // Of `adr.bit` only the position of the bit counts.
        ("IB=2", "LDR IB.I1 / WR OB.I3", "OB=8"),
        ("OB=4", "LDR OB.I2 / WR O0", "OB=5"),
        ("OB=1", "LDR $+1.I0 / WR O7", "OB=81h"),
        ("W1=0100h", "LDR (W1+1).I0 / WR O7", "OB=80h"),
        ("IB=3", "LDR I0 / LA I1 / WR O0", "OB=1"),
        ("IB=1", "LDR I0 / LA I1 / WR O0", "OB=0"),
        ("IB=1", "LDR I0 / LA -I1 / WR O0", "OB=1"),
        ("IB=0", "LDR I0 / LA -I1 / WR O0", "OB=0"),
        ("IB=2", "LDR I0 / LO I1 / WR O7", "OB=80h"),
        ("IB=1", "LDR I0 / LO I1 / WR O7", "OB=80h"),
        ("IB=3", "LDR I0 / LO I1 / WR O7", "OB=80h"),
        ("IB=1", "LDR I0 / LO -I1 / WR O7", "OB=80h"),
        ("IB=2", "LDR I0 / LO -I1 / WR O7", "OB=0"),
        ("IB=3", "LDR I0 / LO -I1 / WR O7", "OB=80h"),
        ("IB=0", "LDR I0 / LO I1 / WR O7", "OB=0"),
        ("IB=0", "LDR I0 / LO -I1 / WR O7", "OB=80h"),
        ("IB=3", "LDR I0 / LX I1 / WR O0", "OB=0"),
        ("IB=1", "LDR I0 / LX I1 / WR O0", "OB=1"),
        ("IB=3", "LDR I0 / LX -I1 / WR O0", "OB=1"),
        ("IB=3", "LDR I0 / LA -I1 / WR O0", "OB=0"),
        ("IB=1", "LDR I0 / LA IB.I1 / WR O0", "OB=0"),
        ("IB=2", "LDR I0 / LO IB.I1 / WR O0", "OB=1"),
        ("IB=3", "LDR I0 / LX IB.I1 / WR O0", "OB=0"),
        ("IB=1", "LDR I0 / LX -I1 / WR O0", "OB=0"),
        ("IB=1", "LDR I0 / CA / WR O0", "OB=0 RLO=0"),
        ("IB=0", "LDR I0 / CA / WR O0", "OB=1 RLO=1"),
    ]);
}

#[test]
fn the_equation_stack() {
    check(&[
        ("IB=0Ch", "LDR I0 / LA I1 / LDR I2 / LA I3 / LO / WR O0", "OB=1"),
        ("IB=03h", "LDR I0 / LA I1 / LDR I2 / LA I3 / LO / WR O0", "OB=1"),
        ("IB=06h", "LDR I0 / LA I1 / LDR I2 / LA I3 / LO / WR O0", "OB=0"),
        ("IB=0Fh", "LDR I0 / LA I1 / LDR -I2 / LO I4 / LA / WR O0", "OB=0"),
        ("IB=1Fh", "LDR I0 / LA I1 / LDR -I2 / LO I4 / LA / WR O0", "OB=1"),
        ("IB=0Fh", "LDR I0 / LA I1 / LDR I2 / LA I3 / LO / WR O0", "OB=1"),
        ("IB=02h", "LDR I0 / LDR I1 / LA / WR O0", "OB=0"),
        ("IB=01h", "LDR I0 / LDR -I2 / LA / WR O0", "OB=1"),
        ("IB=05h", "LDR I0 / LDR -I2 / LA / WR O0", "OB=0"),
        ("IB=09h", "LDR I0 / LDR -I2 / LA / WR O0", "OB=1"),
        ("IB=01h", "LDR I0 / LDR I1 / LX / WR O0", "OB=1"),
        ("IB=03h", "LDR I0 / LDR I1 / LX / WR O0", "OB=0"),
        // Three open brackets are closed from the inside: I0 or (I1 and (I2 xor I3)).
        ("IB=06h", "LDR I0 / LDR I1 / LDR I2 / LX I3 / LA / LO / WR O0", "OB=1"),
        ("IB=0Eh", "LDR I0 / LDR I1 / LDR I2 / LX I3 / LA / LO / WR O0", "OB=0"),
        // Eight are as many as fit.
        (
            "IB=0FFh",
            "LDR I0 / LDR I1 / LDR I2 / LDR I3 / LDR I4 / LDR I5 / LDR I6 / LDR I7 / LDR I0 / \
             LA / LA / LA / LA / LA / LA / LA / LA / WR O0",
            "OB=1",
        ),
    ]);
}

#[test]
fn a_check_changes_nothing() {
    check(&[("IB=1", "LOD FIVE / LDR I0 / WR O0 / CHECK / WR O1 / STO B1", "OB=3 B1=5 RLO=1")]);
}

#[test]
fn writing_bits() {
    check(&[
        ("IB=1", "LDR I0 / WR O0,O2,OB.I5", "OB=25h"),
        ("IB=0 OB=0FFh", "LDR I0 / WR O0,O2,OB.I5", "OB=0DAh"),
        ("", "FL 1,O1,O3", "OB=0Ah"),
        ("OB=0FFh", "FL 0,O1,$.O3", "OB=0F5h"),
        ("IB=0", "LDR I0 / FL1 1,O4,O5", "OB=0"),
        ("IB=1", "LDR I0 / FL1 1,O4,O5", "OB=30h RLO=1"),
        ("IB=1 OB=0FFh", "LDR I0 / FL1 0,O4 / FL1 0,O5", "OB=0CFh"),
        ("IB=2", "LDR I0 / MOVR O1,I1 / LO I1 / WR O0", "OB=3"),
        ("IB=0 OB=2", "MOVR O1,I1", "OB=0"),
        ("IB=3", "LDR I0 / MOVR O1,I1", "OB=2"),
        ("OB=8", "MOVR OB.I0,OB.I3", "OB=9"),
        ("IB=1 OB=8", "LDR I0 / MOVR1 OB.I0,OB.I3", "OB=9"),
        ("IB=0 OB=8", "LDR I0 / MOVR1 OB.I0,OB.I3", "OB=8"),
        ("IB=2", "LDR I0 / MOVR1 O1,I1", "OB=0"),
        ("IB=3", "LDR I0 / MOVR1 O1,I1", "OB=2"),
    ]);
}

#[test]
fn jumps() {
    check(&[
        ("IB=1", "LDR I0 / JL1 L / FL 1,O0 / L: / FL 1,O1", "OB=2"),
        ("IB=0", "LDR I0 / JL1 L / FL 1,O0 / L: / FL 1,O1", "OB=3"),
        ("IB=1", "LDR I0 / JL0 L / FL 1,O0 / L: / FL 1,O1", "OB=3"),
        ("IB=0", "LDR I0 / JL0 L / FL 1,O0 / L: / FL 1,O1", "OB=2"),
        ("", "JUM L / FL 1,O0 / L: / FL 1,O1", "OB=2"),
        // Backwards: five times round.
        ("", "AGAIN: / LOD W1 / INR / STO W1 / LOD W1 / LT CNST.5 / JL1 AGAIN", "W1=5"),
        ("", "PROC_CALL P / PROC_CALL P / PROC_BEGIN P / LOD W1 / AD CNST.7 / STO W1 / PROC_END P", "W1=14"),
    ]);
}

#[test]
fn edges_fire_once_and_never_at_the_start() {
    let count = |edge: &str| format!("LDR -O7 / WR O7 / {edge} O7 / JL0 L / LOD W1 / INR / STO W1 / L:");
    // O7 is 1, 0, 1, 0, 1 in the cycles 0 to 4.
    for (edge, counts) in [("EDGE_H", [0, 0, 1, 1, 2]), ("EDGE_L", [0, 1, 1, 2, 2])] {
        let mut plc = Plc::of(&count(edge));
        for (cycle, n) in counts.iter().enumerate() {
            plc.run(1);
            assert_eq!(plc.differences(&format!("W1={n}")), [""; 0], "{edge}, cycle {cycle}");
        }
    }
}

#[test]
fn an_edge_is_a_change_and_not_a_level() {
    for (edge, counts) in [("EDGE_H", [0, 0, 0, 1, 1, 1]), ("EDGE_L", [0, 1, 1, 1, 1, 2])] {
        with_mutants(|| {
            let mut plc = Plc::of(&format!("{edge} I0 / JL0 L / LOD W1 / INR / STO W1 / L:"));
            for (level, count) in [1, 0, 0, 1, 1, 0].into_iter().zip(counts) {
                plc.set(&format!("I0={level}"));
                plc.run(1);
                assert_eq!(plc.differences(&format!("W1={count}")), [""; 0], "{edge}");
            }
        });
    }
}

#[test]
fn a_procedure_gives_its_registers_back() {
    check(&[(
        "",
        "LDR I7 / LOD CNST.1.5 / PROC_CALL P / PROC_BEGIN P / LOD CNST.-4.5 / LOD CNST.123456789 / LDR -I7 / PROC_END P",
        "RLO=1 DR64=123456789 DR_REAL=-4.5",
    )]);
    check(&[("", "LDR -I7 / PROC_CALL P / PROC_BEGIN P / LDR I7 / PROC_END P", "RLO=0")]);
}
