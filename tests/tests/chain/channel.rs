//! Inputs, outputs and connections as the configuration files say them (manual 10 and 27.5).

use technol_machine::{
    Analog, ChannelWiring, Connection, ControlData, Conversion, Mapping, Physical, Signal,
};

use crate::plc::Plc;

fn point(id: &str, physical: Physical, connected: bool, default: f64) -> Mapping {
    Mapping { id: id.as_bytes().to_vec(), physical, connected, default }
}

fn bit(name: &str, invert: bool) -> Physical {
    Physical::Bit { signal: name.parse::<Signal>().expect("a signal"), invert }
}

fn analog(channel: u8, scale: f64, offset: f64, min: f64, max: f64) -> Analog {
    Analog { channel, scale, offset, min, max }
}

fn connection(source: &str, destination: &str, conversion: Conversion) -> Connection {
    Connection { source: source.to_owned(), destination: destination.to_owned(), conversion }
}

/// A program that starts in front of this configuration.
fn plc(points: Vec<Mapping>, connections: Vec<Connection>, init: &str, main: &str) -> Plc {
    let mut plc = Plc::with_init(init, main);
    let wiring = ChannelWiring { points, connections };
    plc.control().set_data(ControlData { wiring, ..ControlData::default() });
    plc.restart_cold();
    plc
}

#[track_caller]
fn holds(plc: &Plc, values: &str) {
    assert_eq!(plc.differences(values), [""; 0]);
    assert_eq!(plc.fault(), None);
}

#[test]
fn mapped_bits_follow_and_drive_the_ports_of_the_configuration() {
    let points = vec![
        point("inLimX", bit("P2IN.2", false), true, 0.0),
        point("inRefX", bit("P2IN.3", true), true, 0.0),
        point("inOil", bit("P2IN.4", false), false, 1.0),
        point("outXEn", bit("P1OUT.0", true), true, 0.0),
        point("outOff", bit("P1OUT.1", false), false, 1.0),
    ];
    let init = "MAP_IN LIMX,'inLimX',1,FAST / MAP_IN REFX,'inRefX' / MAP_IN OIL,'inOil',0 / MAP_IN FREE,'inlimx',1 / \
                MAP_OUT XEN,'outXEn' / MAP_OUT OFF,'outOff'";
    let mut plc = plc(points, Vec::new(), init, "LDR I0 / WR XEN");
    // Case counts: `inlimx` is not in the configuration and keeps the default of its instruction.
    plc.run(1);
    holds(&plc, "LIMX=0 REFX=1 OIL=1 FREE=1 OFF=1");
    assert_eq!(plc.ports()[1], 0b01, "off, and inverted; what is not connected drives nothing");
    plc.input_ports()[1] = 0b1_1100;
    plc.set("I0=1");
    plc.run(1);
    holds(&plc, "LIMX=1 REFX=0 OIL=1 FREE=1");
    assert_eq!(plc.ports()[1], 0b00);
}

#[test]
fn outputs_of_one_bit_are_joined_before_they_are_inverted() {
    for (invert, lamp) in [(false, [0, 1, 1, 1]), (true, [1, 0, 0, 0])] {
        let both = |id| point(id, bit("P3OUT.5", invert), true, 0.0);
        let init = "MAP_OUT LEFT,'left' / MAP_OUT RIGHT,'right'";
        let main = "LDR I0 / WR LEFT / LDR I1 / WR RIGHT";
        let mut plc = plc(vec![both("left"), both("right")], Vec::new(), init, main);
        for (given, lamp) in (0..4).zip(lamp) {
            plc.set(&format!("IB={given}"));
            plc.run(1);
            assert_eq!(plc.ports()[3], lamp << 5, "{invert} {given}");
        }
    }
}

#[test]
fn analogue_values_are_shifted_scaled_and_limited() {
    let points = vec![
        point("PlasmaVoltage", Physical::AnalogInput(analog(2, 20.0, 0.5, 20.0, 150.0)), true, 120.0),
        point("Gap", Physical::AnalogInput(analog(3, 1.0, 0.0, 0.0, 9.0)), false, 4.5),
        point("CutFlow", Physical::AnalogOutput(analog(1, 0.25, 1.0, 0.0, 60.0)), true, 30.0),
    ];
    let init = "MAP_AIN VOLTAGE,'PlasmaVoltage' / MAP_AIN GAP,'Gap',1.0 / MAP_AOUT FLOW,'CutFlow'";
    let mut plc = plc(points, Vec::new(), init, "LOD REAL.R1 / STO REAL.FLOW");
    holds(&plc, "GAP=4.5 BYTE.ANALOG_CONNECTED+1=2 BYTE.ANALOG_CONNECTED+2=1 BYTE.ANALOG_CONNECTED+3=0");
    // (volts + 0.5) · 20, held within 20 and 150; the value held within 0 and 60, · 0.25 + 1.
    for (volts, voltage, flow, out) in
        [("4.5", "100.0", "8.0", "3.0"), ("0.0", "20.0", "-5.0", "1.0"), ("9.0", "150.0", "100.0", "16.0")]
    {
        plc.set(&format!("REAL.ANALOG_INPUT_PHYSICAL+16={volts} REAL.R1={flow}"));
        plc.run(1);
        holds(&plc, &format!("VOLTAGE={voltage} GAP=4.5 REAL.ANALOG_OUTPUT_PHYSICAL+8={out}"));
    }
}

#[test]
fn what_is_set_by_name_or_wired_by_the_machine_replaces_the_configuration() {
    let points =
        vec![point("Door", bit("P2IN.0", false), true, 0.0), point("Lamp", bit("P2OUT.0", false), true, 0.0)];
    let init = "MAP_IN DOOR,'Door' / MAP_OUT LAMP,'Lamp'";
    let mut plc = plc(points, Vec::new(), init, "LDR DOOR / WR LAMP");
    plc.control().wire("Lamp", "P4OUT.1".parse().expect("a signal"), false).expect("a name");
    plc.control().set_input("Door", true).expect("a name");
    plc.run(1);
    holds(&plc, "DOOR=1");
    assert_eq!((plc.ports()[2], plc.ports()[4]), (0, 2));
}

#[test]
fn connections_lead_single_bits_and_bytes_of_units() {
    let plain = Conversion::default();
    let connections = vec![
        connection("PLC.Output.flOut1", "PLC.Input.flIn1", Conversion { invert: true, ..plain }),
        connection("PLC.Output.flOut1", "CAN[1].INOUT08.OP0.Bit[7]", plain),
        connection("PLC.Output.flOut1", "PLC.Input.Bun1.Bit[2]", plain),
        connection("PLC.Output.Sum.Bit[9]", "PLC.Input.Bun1.Bit[31]", plain),
        connection("CNC.PLC.Output.Sum", "PLC.Input.Half", Conversion { scale: 0.5, offset: 1.0, ..plain }),
        connection("CAN[1].INOUT08[2].IP1", "PLC.Input.Keys", plain),
        connection("CAN[1].INOUT08[2].IP1.Bit[0]", "PLC.Input.Key", plain),
    ];
    let init = "DEF_OUT FLOUT,'flOut1',TYPE_BIT / DEF_IN FLIN,'flIn1',TYPE_BIT / DEF_IN BUN,'Bun1',TYPE_DWORD,222 / \
                DEF_OUT SUM,'Sum',TYPE_INT_16 / DEF_IN HALF,'Half',TYPE_REAL / DEF_IN KEYS,'Keys',TYPE_UNS_8 / \
                DEF_IN KEY,'Key',TYPE_BIT";
    let main = "LDR I0 / WR FLOUT / LOD W1 / STO SUM";
    let mut plc = plc(Vec::new(), connections, init, main);
    // 222 is 11011110b: what is not linked stays as it is.
    plc.set("W1=512");
    plc.input_ports()[9] = 0x81;
    plc.run(2);
    holds(&plc, "FLIN=1 BUN=800000DAh HALF=257.0 KEYS=81h KEY=1");
    assert_eq!(plc.ports()[0], 0);
    plc.set("I0=1 W1=-2");
    plc.input_ports()[9] = 0x80;
    plc.run(2);
    holds(&plc, "FLIN=0 BUN=800000DEh HALF=0.0 KEYS=80h KEY=0");
    assert_eq!(plc.ports()[0], 0x80);
    plc.set("I0=0 W1=0");
    plc.run(2);
    holds(&plc, "FLIN=1 BUN=0DAh HALF=1.0");
    assert_eq!(plc.ports()[0], 0);
}
