//! Axes, spindles and analogue outputs (manual 12, 13.1 and 19).

use crate::coverage::with_mutants;
use crate::plc::{Plc, check};

/// What holds after so many cycles of these lines.
#[track_caller]
fn after(cycles: u32, init: &str, main: &str, given: &str, then: &str) {
    with_mutants(|| {
        let mut plc = Plc::with_init(init, main);
        plc.set(given);
        plc.run(cycles);
        assert_eq!(plc.fault(), None, "{init}: {main}");
        assert_eq!(plc.differences(then), [""; 0], "{init}: {main}, {cycles} cycles");
    });
}

// 10 mm at 6000 mm/min by 1000 mm/s²: 200 ms. The control record is B1 and B2, the status record IB and OB.
const TRAVEL: &str = "LOD CNST.10000 / STO D1 / LOD CNST.1000 / STO W1";
const FULL: &str = "D2=17700000h";

#[test]
fn a_positioning_unit_carries_an_axis_to_its_target() {
    let init = format!("{TRAVEL} / POS_INIT 2 / POS_MODE B1,D1,W1,2");
    let main = "POS_CONTROL IB,D2,-,2";
    // Held and programmed, but not enabled.
    after(3, &init, main, FULL, "IB=0 OB=3 B2=8 PO_OSYPI=1");
    let enabled = "D2=17700000h B2=1";
    after(8, &init, main, enabled, "IB=1 OB=3");
    after(5, &init, main, enabled, "IB=1 OB=3 QWRD.POSITION_POS5_EX=0 PO_OSYPI=1 SM_POYPI=0");
    after(13, &init, main, enabled, "IB=8 OB=3 B2=1 QWRD.(POSITION_POS5_EX+8)=27100000h PO_OSYPI=0");
    // The space of transformations decides where it shows.
    let interpolated = init.replace("POS_INIT 2", "POS_INIT 2,0");
    after(13, &init, main, enabled, "QWRD.(B_POL_EX+8)=0");
    after(13, &interpolated, main, enabled, "QWRD.(B_POL_EX+8)=27100000h DWRD.(B_POL+4)=80000");
    // The enable of the instruction goes into the record.
    after(13, &init, "POS_CONTROL W2,D2,I7,2", FULL, "W2=300h B2=8");
    after(13, &init, "POS_CONTROL W2,D2,I7,2", "D2=17700000h I7=1", "W2=308h B2=1");
    let prefixed = init.replace("B1,D1,W1", "B1,DWRD.D1,WORD.W1");
    for control in ["W2,CNST.17700000h,AREA.I7,2", "W2,DWRD.D2,AREA.I7,2"] {
        let main = format!("POS_CONTROL {control}");
        after(13, &prefixed, &main, "D2=17700000h", "W2=300h B2=8");
        after(13, &prefixed, &main, "D2=17700000h AREA.I7=1", "W2=308h B2=1");
    }
    // A constant 0 as speed only reads the status.
    after(13, &init, "POS_CONTROL IB,0,NIL,2", enabled, "IB=0 OB=3");
}

#[test]
fn the_older_instructions_do_the_same() {
    for (axis, index) in [("X", 0), ("Y", 1), ("Z", 2), ("4", 3), ("5", 4), ("6", 5)] {
        for (feed, enable) in [("CNST.17700000h", ",AREA.I7"), ("DWRD.D2", ",-"), ("393216000", "")] {
            let init = format!("{TRAVEL} / POS_INIT_{axis} / POS_MODE_{axis} B1,DWRD.D1,WORD.W1,WORD.W2");
            let main = format!("POS_CONTROL_{axis} Q1,{feed}{enable}");
            let there = format!("WORD.Q1=308h QWRD.(POSITION_POS5_EX+{})=27100000h", 8 * index);
            after(13, &init, &main, "D2=17700000h B2=1 AREA.I7=1", &there);
        }
        let init = format!("{TRAVEL} / POS_INIT_{axis} / POS_MODE_{axis} B1,D1,W1,W2");
        let main = format!("POS_CONTROL_{axis} Q1,D2,I7");
        let given = "D2=17700000h I7=1";
        let there = format!("WORD.Q1=308h QWRD.(POSITION_POS5_EX+{})=27100000h", 8 * index);
        after(13, &init, &main, given, &there);
        // The approach at 60 mm/min, 1 mm/s, takes a tenth of a second more.
        let approach = format!("LOD CNST.60 / STO W2 / {init}");
        after(12, &approach, &main, given, "WORD.Q1=301h");
        after(24, &approach, &main, given, "WORD.Q1=308h");
        // As quick as the way before it slows nothing down.
        after(13, &format!("LOD CNST.6000 / STO W2 / {init}"), &main, given, "WORD.Q1=308h");
        // 100 mm.
        let far = init.replace("LOD CNST.10000 ", "LOD CNST.100000 ");
        after(50, &far, &main, given, "WORD.Q1=301h");
        after(58, &far, &main, given, "WORD.Q1=308h");
        let reset = format!("POS_CONTROL_{axis} IB,D2 / POS_RESET_{axis}");
        after(3, &init, &reset, FULL, "IB=0 OB=0");
    }
}

#[test]
fn what_cannot_be_is_told_in_the_status_record_alone() {
    // Without POS_INIT; without a ramp; a seventh axis; an open loop.
    after(2, "", "POS_MODE B1,D1,W1,1 / POS_CONTROL IB,D2,-,1", "", "IB=0 OB=4");
    after(2, "POS_INIT 1", "POS_MODE B1,D1,W2,1 / POS_CONTROL IB,D2,-,1", "", "IB=0 OB=5");
    let six = "POS_INIT 1 / POS_INIT 2 / POS_INIT 3 / POS_INIT 4 / POS_INIT 5 / POS_INIT 16";
    after(2, six, "POS_INIT 7 / POS_CONTROL IB,D2,-,7", "", "OB=4");
    after(2, "", "POS_INIT 1 / POS_CONTROL IB,D2,-,1", "VAZBA_X=0", "OB=4");
    after(2, six, "POS_RESET 16 / POS_INIT 7 / POS_CONTROL IB,D2,-,7", "", "OB=1");
    after(2, six, "POS_RESET 2 / POS_CONTROL IB,D2,-,1", "", "OB=1");
}

#[test]
fn positioning_leaves_the_registers() {
    let lines =
        "LOD CNST.77 / LDR I0 / POS_INIT 1 / POS_MODE B1,D1,W1,1 / POS_CONTROL D2,D1,-,1 / POS_RESET 1";
    check(&[("I0=1", lines, "RLO=1 DR=77"), ("I0=0", lines, "RLO=0 DR=77")]);
}

#[test]
fn a_ramp_follows_dr() {
    check(&[
        ("W1=100", "LOD CNST.1000 / RAMP W1,30", "W1=130 DR=130"),
        ("W1=100", "LOD CNST.-1000 / RAMP W1,30", "W1=70 DR=70"),
        ("W1=100", "LOD CNST.110 / RAMP W1,30", "W1=110 DR=110"),
        ("W1=100", "LOD CNST.110 / RAMP W1,W2", "W1=100 DR=100"), // a step of 0 holds
        ("W1=100 W2=-4", "LOD CNST.0 / RAMP W1,W2", "W1=96 DR=96"),
        ("B1=-100", "LOD CNST.-128 / RAMP B1,20", "B1=-120 DR=-120"),
        ("B1=-100", "LOD CNST.-128 / RAMP BYTE.B1,CNST.20", "B1=-120 DR=-120"),
        ("W1=100 B2=30", "LOD CNST.1000 / RAMP WORD.W1,B2", "W1=130 DR=130"),
        ("W1=100 B2=30", "LOD CNST.1000 / RAMP W1,BYTE.B2", "W1=130 DR=130"),
        ("W1=100 W2=400", "LOD CNST.1000 / RAMP W1,WORD.W2", "W1=500 DR=500"),
        ("D1=70000 D2=60000", "LOD CNST.0 / RAMP DWRD.D1,D2", "D1=10000 DR=10000"),
        ("D1=70000 D2=60000", "LOD CNST.0 / RAMP D1,DWRD.D2", "D1=10000 DR=10000"),
        ("D1=70000", "LOD CNST.0 / RAMP D1,60000", "D1=10000 DR=10000"),
        ("I0=1", "LDR I0 / LOD CNST.5 / RAMP W1,1", "RLO=1 W1=1 WORD.W2=0"),
    ]);
}

/// Outputs 1 to 6 after two cycles of these lines.
#[track_caller]
fn outputs(init: &str, main: &str, given: &str, expected: [i16; 6]) {
    with_mutants(|| {
        let mut plc = Plc::with_init(init, main);
        plc.set(given);
        plc.run(2);
        assert_eq!(plc.fault(), None, "{init}: {main}");
        assert_eq!(plc.analog()[..6], expected, "{init}: {main}");
    });
}

#[test]
fn analogue_values_go_to_the_port_or_to_the_spindle() {
    outputs("", "LOD CNST.100 / ANALOG", "", [0; 6]);
    outputs("ANALOG_PORT 5", "LOD CNST.100 / ANALOG", "", [0, 0, 0, 0, 100, 0]);
    outputs("ANALOG_PORT 5", "ANALOG W1", "W1=-7", [0, 0, 0, 0, -7, 0]);
    outputs("ANALOG_PORT 5", "ANALOG W1", "W1=300", [0, 0, 0, 0, 300, 0]);
    outputs("", "ANALOG_PORT W1 / ANALOG 8", "W1=102h", [0; 6]);
    // A port that does not exist leaves the one before.
    outputs("ANALOG_PORT 5", "ANALOG_PORT B1 / ANALOG 8", "B1=17", [0, 0, 0, 0, 8, 0]);
    outputs("AX_SPI 4", "ANALOG_SPI W1,4", "W1=300", [0, 0, 0, 300, 0, 0]);
    outputs("ANALOG_PORT 6", "ANALOG 8000h", "", [0, 0, 0, 0, 0, -0x7FFF]);
    let spindles = "AX_SPI 4,MAIN / AX_SPI 5,ASSIST";
    outputs(spindles, "ANALOG W1,4 / ANALOG W2,5", "W1=1 W2=2", [0, 0, 0, 1, 2, 0]);
    outputs(spindles, "ANALOG 3,4,2 / ANALOG 4,4,1", "", [0, 0, 0, 4, 3, 0]);
    outputs(spindles, "SPI_MAIN 5 / ANALOG 3,4,2 / ANALOG 4,4,1", "", [0, 0, 0, 3, 4, 0]);
    for letter in ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"] {
        outputs(spindles, &format!("ANALOG 9,{letter}"), "", [0, 0, 0, 0, 9, 0]);
    }
    outputs(
        "",
        "ANALOG_PORT B1 / ANALOG 8 / ANALOG_PORT W1 / ANALOG WORD.W2",
        "B1=3 W1=2 W2=-6",
        [0, -6, 8, 0, 0, 0],
    );
    outputs(spindles, "LOD CNST.6 / ANALOG -,4 / ANALOG NIL,5,2", "", [0, 0, 0, 6, 6, 0]);
    outputs(spindles, "ANALOG_SPI W1,4 / ANALOG_SPI WORD.W2,5", "W1=11 W2=-12", [0, 0, 0, 11, -12, 0]);
    outputs(spindles, "ANALOG_SPI 7,5 / ANALOG_SPI 40000,4", "", [0, 0, 0, -25_536, 7, 0]);
    // SET leaves the roles.
    for set in ["SET", "S", "3", "5"] {
        let init = format!("AX_SPI 4,ASSIST / AX_SPI 5,MAIN / AX_SPI 6,{set}");
        outputs(&init, "ANALOG 1,4,1 / ANALOG 2,4,2 / ANALOG 3,6", "", [0, 0, 0, 2, 1, 3]);
    }
    outputs("AX_SPI 4", "ANALOG 1,4 / AX_SPI 4,OFF", "", [0; 6]);
    outputs(spindles, "LOD CNST.6 / ANALOG_SPI -,4 / ANALOG_SPI 7,3", "", [0, 0, 0, 6, 0, 0]);
    outputs("AX_SPI 4", "ANALOG 1,4 / AX_SPI 4,0", "", [0; 6]);
    outputs("AX_SPI 4", "ANALOG 5,4,1", "", [0, 0, 0, 5, 0, 0]);
}

#[test]
fn a_spindle_becomes_an_axis_again_at_its_zero_pulse() {
    after(2, "AX_SPI 4", "", "", "VAZBA_4=0 POLOHV_4=0");
    // 10000 mm/min down to the pulse would be the run of an axis; a spindle goes at RefSpeedLow, 50 ° a minute.
    let init = "AX_SPI 4 / SPI_AX -,-,-,-,4";
    after(2, init, "", "KR4=0", "VAZBA_4=1 POLOHV_4=1 PO_OS4PI=1");
    after(2, init, "FL 0,POLOHV_4", "", "POLOHV_4=0 PO_OS4PI=0 WORD.HOMING=0");
    after(2, "AX_SPI 4", "SPI_AX 1000,-1000,500,100", "", "POLOHV_4=1 SM_PO4PI=0");
    after(2, "", "SPI_AX -1000,-,-,-,4", "", "POLOHV_4=1 SM_PO4PI=1");
    for operands in ["W1,W1,D1,W2", "WORD.W1,WORD.W1,DWRD.D1,WORD.W2", "W1,1,CNST.500,100"] {
        let lines = format!("SPI_AX {operands},4");
        after(2, "AX_SPI 4", &lines, "W1=-1000 W2=100 D1=500", "POLOHV_4=1 SM_PO4PI=1");
        after(2, "AX_SPI 4", &lines, "W1=1000 W2=100 D1=500", "POLOHV_4=1 SM_PO4PI=0");
    }
}

/// An axis that passes its zero pulse at 0.1 °.
const PULSE: &str = "[[axis]]\nnumber = 4\nref-switch = 'none'\npulse-at = 0.1\npulse-distance = 360";

/// A spindle on axis 4, whose zero pulse is 0.1 ° away: until when, after this SPI_AX, it is on its way.
#[track_caller]
fn on_its_way(given: &str, operands: &str, millis: u32) {
    with_mutants(|| {
        let lines = format!("EDGE_H I7 / JL0 L / SPI_AX {operands},4 / L:");
        let mut plc = Plc::on(Some(PULSE), "AX_SPI 4", &lines);
        plc.run(1);
        plc.set(&format!("{given} I7=1"));
        plc.tick(millis - 5);
        assert_eq!(plc.differences("POLOHV_4=1"), [""; 0], "{operands}");
        plc.tick(15);
        assert_eq!(plc.differences("POLOHV_4=0"), [""; 0], "{operands}");
    });
}

#[test]
fn each_operand_of_the_way_to_the_zero_pulse_counts() {
    // 6000/1000 ° a minute are 0.1 °/s: 1 s to the pulse; 0.05 ° more at 0.05 °/s: 1 s. Slow ramps of 0.001 m/s² (1 °/s²): 0.05 s
    // more to the pulse, 0.1 s to stand, and of the 0.05 ° only 0.045 are left, 0.9 s and a ramp of 0.05 s.
    on_its_way("W1=6000 W2=3000 D1=50 WORD.AREA=1", "W1,W2,D1,WORD.AREA", 2100);
    on_its_way("", "6000,3000,50,1", 2100);
    on_its_way("", "6000,3000,0,1", 1150);
    // The angle has 32 bits: these are 65.586 °.
    with_mutants(|| {
        let lines = "EDGE_H I7 / JL0 L / SPI_AX W1,W2,D1,-,4 / L:";
        let mut plc = Plc::on(Some(PULSE), "AX_SPI 4", lines);
        plc.run(1);
        plc.set("W1=6000 W2=3000 D1=65586 I7=1");
        plc.tick(4000);
        assert_eq!(plc.differences("POLOHV_4=1"), [""; 0]);
    });
    // Quick ramps take no time.
    on_its_way("W1=6000 W2=3000 D1=50 WORD.AREA=257", "W1,W2,D1,WORD.AREA", 2000);
}

#[test]
fn a_regulator_set_has_a_gain_of_its_own() {
    for (axis, number) in [("X", 1), ("Y", 2), ("Z", 3), ("4", 4), ("5", 5), ("6", 6)] {
        let machine =
            format!("[[axis]]\nnumber = {number}\ngain = 100\ngains = [100, 50, 25]\ndifference-limit = 0");
        let main = format!(
            "LDR I0 / JL0 L / REGUL_{axis} 2 / L: / LDR I1 / JL0 M / REGUL_{axis} 3 / M: / POS_CONTROL IB,D2,O7,{number}"
        );
        let init = format!(
            "LOD CNST.1000000 / STO D1 / LOD CNST.1000 / STO W1 / POS_INIT {number} / POS_MODE B1,D1,W1,{number}"
        );
        let mut plc = Plc::on(Some(&machine), &init, &main.replace("CONTROL IB", "CONTROL W2"));
        // 6000 mm/min is 100 mm/s: in µm the error is the speed divided by the gain, less the way of the last ms.
        let cell = format!("DWRD.(DIFCIT_X+{})", 4 * (number - 1));
        plc.set("D2=17700000h O7=1");
        for (given, expected) in [("", 900), ("I0=1", 1900), ("I0=0 I1=1", 3900)] {
            plc.set(given);
            plc.run(50);
            assert_eq!(plc.differences(&format!("{cell}={expected}")), [""; 0], "{axis}, {given}");
        }
    }
}
