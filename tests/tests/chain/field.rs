//! Drives, slaves and analogue values between the control and the machine (manual 10.5, 13.14, 13.18 and 26).

use crate::plc::Plc;

const SLAVES: &str = "\
[[ethercat]]
name = 'Coupler'
inputs = [{ name = 'Door', type = 'bit' }, { name = 'Bar', type = 'bit' }, { name = 'Level', type = 'word' }]
outputs = [{ name = 'Valve', type = 'bit' }, { name = 'Set', type = 'word' }]
[[ethercat]]
name = 'Axis 1'
drive = true
servo = 2
[[contact]]
output = 'ECAT.Coupler.Outputs.Valve'
input = 'ECAT.Coupler.Inputs.Bar'
on-delay-ms = 50
[[ramp]]
source = 'ECAT.Coupler.Outputs.Set'
high = 1000
rise-per-s = 1000
value = ['ECAT.Coupler.Inputs.Level']
[[key]]
name = 'door'
input = 'ECAT.Coupler.Inputs.Door'
[[link]]
source = 'PLC.Output.Valve'
destination = 'ECAT.Coupler.Outputs.Valve'
[[link]]
source = 'PLC.Output.Set'
destination = 'ECAT.Coupler.Outputs.Set'
[[link]]
source = 'ECAT.Coupler.Inputs.Door'
destination = 'PLC.Input.Door'
[[link]]
source = 'ECAT.Coupler.Inputs.Bar'
destination = 'PLC.Input.Bar'
[[link]]
source = 'ECAT.Coupler.Inputs.Level'
destination = 'PLC.Input.Level'
[[fault]]
name = 'no coupler'
slave = 'Coupler'
lost = true
[[fault]]
name = 'cable'
slave = 'Axis 1'
cut = true
[[fault]]
name = 'too hot'
slave = 'Axis 1'
error = 0x4310
";

const INIT: &str = "DEF_OUT VALVE,'Valve',TYPE_BIT / DEF_OUT SETPOINT,'Set',TYPE_WORD / DEF_IN DOOR,'Door',TYPE_BIT / \
                    DEF_IN BAR,'Bar',TYPE_BIT / DEF_IN LEVEL,'Level',TYPE_WORD";

#[track_caller]
fn holds(plc: &Plc, values: &str) {
    assert_eq!(plc.differences(values), [""; 0]);
    assert_eq!(plc.fault(), None);
}

#[test]
fn the_machine_is_wired_to_the_process_data_of_slaves() {
    let mut plc = Plc::on(Some(SLAVES), INIT, "LDR I0 / WR VALVE / LOD W1 / STO SETPOINT");
    plc.run(1);
    holds(&plc, "flEcatOperational=1 BAR=0 LEVEL=0 DOOR=0");
    plc.press("door", true);
    plc.set("I0=1 W1=100");
    plc.run(2);
    holds(&plc, "DOOR=1 BAR=0");
    plc.run(3);
    holds(&plc, "BAR=1");
    plc.run(4);
    holds(&plc, "LEVEL=100");
    // Without the slave the machine sees nothing of the outputs, and the program what was there last.
    plc.fault_of_machine("no coupler", true);
    plc.press("door", false);
    plc.run(5);
    holds(&plc, "flEcatOperational=0 DOOR=1 BAR=1 LEVEL=100");
    plc.fault_of_machine("no coupler", false);
    plc.run(3);
    holds(&plc, "flEcatOperational=1 DOOR=0 BAR=0");
}

#[test]
fn outputs_are_exchanged_in_operational_only_and_inputs_in_safe_operational_too() {
    let mut plc = Plc::on(Some(SLAVES), INIT, "LDR I0 / WR VALVE");
    plc.set("I0=1");
    plc.run(5);
    holds(&plc, "BAR=1");
    plc.set("flEcatSafeOperationalReq=1");
    plc.run(3);
    holds(&plc, "flEcatSafeOperationalReq=0 flEcatOperational=0 BAR=0");
    plc.set("flEcatPreOperationalReq=1");
    plc.run(2);
    plc.press("door", true);
    plc.run(2);
    holds(&plc, "flEcatPreOperationalReq=0 DOOR=0");
    plc.set("flEcatOperationalReq=1");
    plc.run(1);
    holds(&plc, "flEcatOperationalReq=1");
    plc.run(8);
    holds(&plc, "flEcatOperationalReq=0 flEcatOperational=1 DOOR=1 BAR=1");
    // A slave that nobody reaches holds the master up: the program has to give up.
    plc.fault_of_machine("cable", true);
    plc.set("flEcatInitReq=1");
    plc.run(50);
    holds(&plc, "flEcatInitReq=1 flEcatOperational=0");
}

#[test]
fn the_program_may_start_the_exchange() {
    let machine = format!("[ethercat-master]\nstart-by-program = true\n{SLAVES}");
    let mut plc = Plc::on(Some(&machine), INIT, "");
    plc.press("door", true);
    plc.run(10);
    holds(&plc, "flEcatOperational=0 DOOR=0");
    plc.set("flEcatStartCyclicOperation=1");
    plc.run(1);
    holds(&plc, "flEcatOperational=0");
    plc.run(5);
    holds(&plc, "flEcatOperational=1 DOOR=1");
    plc.restart_cold();
    plc.run(5);
    holds(&plc, "flEcatOperational=0");
}

/// Sets a request of the second servo loop and waits until the control has cleared it.
#[track_caller]
fn request(plc: &mut Plc, name: &str, expected: &str) {
    plc.set(&format!("{name}2=1"));
    plc.run(2);
    holds(plc, &format!("{name}2=0 {expected}"));
}

#[test]
fn a_drive_is_led_by_requests_and_told_by_its_words() {
    let mut plc = Plc::on(Some(SLAVES), INIT, "");
    // Without flEdrvOn there is nothing to enable.
    plc.set("flEdrvEnable2=1");
    plc.run(10);
    holds(&plc, "flEdrvEnable2=1 wEdrvDriveStatus2=50h bEdrvState2=0");
    plc.set("flEdrvEnable2=0");
    request(&mut plc, "flEdrvInit", "bEdrvState2=1 wEdrvDriveControl2=0");
    request(
        &mut plc,
        "flEdrvOn",
        "bEdrvState2=2 wEdrvDriveControl2=7 wEdrvDriveStatus2=33h flEdrvMoveDisReq2=1",
    );
    request(
        &mut plc,
        "flEdrvEnable",
        "bEdrvState2=3 wEdrvDriveControl2=0Fh wEdrvDriveStatus2=37h flEdrvMoveDisReq2=0",
    );
    request(&mut plc, "flEdrvDisable", "bEdrvState2=2 wEdrvDriveControl2=7 wEdrvDriveStatus2=33h");
    request(&mut plc, "flEdrvDone", "bEdrvState2=0 wEdrvDriveControl2=0 wEdrvDriveStatus2=50h");
}

#[test]
fn an_error_of_a_drive_stays_until_it_is_erased() {
    let mut plc = Plc::on(Some(SLAVES), INIT, "");
    for name in ["flEdrvInit", "flEdrvOn", "flEdrvEnable"] {
        request(&mut plc, name, "flEdrvError2=0");
    }
    plc.fault_of_machine("too hot", true);
    plc.run(1);
    holds(&plc, "flEdrvError2=1 flEdrvMoveDisReq2=1 wEdrvDriveStatus2=18h wEdrvDriveErrReg2=4310h");
    plc.set("flEdrvErase2=1");
    plc.run(5);
    holds(&plc, "flEdrvErase2=1 flEdrvError2=1");
    plc.fault_of_machine("too hot", false);
    plc.run(1);
    holds(&plc, "flEdrvErase2=0 flEdrvError2=0 wEdrvDriveErrReg2=0 wEdrvDriveStatus2=50h");
    request(&mut plc, "flEdrvOn", "bEdrvState2=2");
}

#[test]
fn without_its_cable_a_drive_does_not_follow() {
    let mut plc = Plc::on(Some(SLAVES), INIT, "");
    plc.fault_of_machine("cable", true);
    plc.set("flEdrvInit2=1");
    plc.run(20);
    holds(&plc, "flEdrvInit2=1 wEdrvDriveStatus2=0");
    plc.fault_of_machine("cable", false);
    plc.run(5);
    holds(&plc, "flEdrvInit2=0 wEdrvDriveStatus2=50h");
}

#[test]
fn a_simulated_drive_needs_no_slave() {
    let mut plc = Plc::of("");
    plc.set("flEdrvInit2=1");
    plc.run(5);
    holds(&plc, "flEdrvInit2=1");
    plc.set("flEdrvSimul2=1");
    plc.run(1);
    holds(&plc, "flEdrvInit2=0");
    request(&mut plc, "flEdrvOn", "bEdrvState2=2 wEdrvDriveStatus2=33h");
    request(&mut plc, "flEdrvEnable", "bEdrvState2=3 wEdrvDriveStatus2=37h");
}

#[test]
fn the_status_of_a_can_drive_follows_its_command() {
    let machine = "[[can-drive]]\naxis = 2\n\
                   [[fault]]\nname = 'trip'\ncan-drive = 2\nerror = 1\n\
                   [[fault]]\nname = 'no drive'\ncan-drive = 2\nlost = true\n\
                   [[fault]]\nname = 'cable'\ncan = 1\ncut = true";
    let mut plc = Plc::on(Some(machine), "", "");
    let command = "WORD.(CAN_DRIVE_CMD+2)";
    let follows = |plc: &mut Plc, given: u16, status: &str| {
        plc.set(&format!("{command}={given}"));
        plc.run(1);
        holds(plc, &format!("WORD.(CAN_DRIVE_STAT+2)={status}"));
    };
    follows(&mut plc, 0, "23h");
    follows(&mut plc, 1, "27h");
    // The brake wins over the release.
    follows(&mut plc, 3, "60h");
    follows(&mut plc, 1, "27h");
    plc.fault_of_machine("trip", true);
    follows(&mut plc, 1, "28h");
    plc.fault_of_machine("trip", false);
    follows(&mut plc, 1, "28h");
    follows(&mut plc, 0, "23h");
    for fault in ["no drive", "cable"] {
        plc.fault_of_machine(fault, true);
        follows(&mut plc, 1, "0");
        plc.fault_of_machine(fault, false);
        follows(&mut plc, 1, "27h");
    }
    holds(&plc, "WORD.CAN_DRIVE_STAT=0");
}

#[test]
fn analogue_values_go_to_the_machine_and_come_back() {
    let machine = "[[ramp]]\nsource = 'ANALOG_OUTPUT_PHYSICAL[1]'\nsource-per-volt = 6\nhigh = 60\nrise-per-s = 100\n\
                   value = 'ANALOG_INPUT_PHYSICAL[2]'\nvalue-per-volt = 20\n\
                   [[ramp]]\nsource = 'ANALOG_PORT[3]'\nsource-per-volt = 100\nhigh = 1000\nrise-per-s = 10000\n\
                   value = ['P8IN', 'P9IN']";
    let mut plc =
        Plc::on(Some(machine), "ANALOG_PORT 3", "LOD CNST.16384 / ANALOG / LDR I0 / JL0 PAST / PAST:");
    plc.set("REAL.ANALOG_OUTPUT_PHYSICAL+8=5.0");
    // 30 of 60 after 0.3 s; 20 for a volt.
    plc.run(16);
    holds(
        &plc,
        "REAL.ANALOG_INPUT_PHYSICAL+16=1.5 REAL.ANALOG_INPUT_PHYSICAL+8=0.0 BYTE.P8IN=0F4h BYTE.P9IN=1",
    );
    plc.set("REAL.ANALOG_OUTPUT_PHYSICAL+8=99.0");
    plc.run(20);
    holds(&plc, "REAL.ANALOG_INPUT_PHYSICAL+16=3.0");
}

#[test]
fn a_unit_tells_of_short_circuits_and_may_keep_silent_about_them() {
    let machine = "[[can-unit]]\ncan = 2\ngroup = 1\nboard = 2\n\
                   [[fault]]\nname = 'short'\noutput = 'P4OUT.1'\nshorted = true\nactive = true";
    let lines = "LOD OB / STO P4OUT / CAN_SYSIO_READ 2,1,2,SHORT_OUT1 / STO B1 / LDR I0 / JL0 PAST / LOD CNST.2 / \
                 CAN_SYSIO_WRITE 2,1,2,CONTROL / PAST:";
    let mut plc = Plc::on(Some(machine), "", lines);
    plc.run(2);
    holds(&plc, "B1=0 BYTE.ERRLI_P4OUT=0");
    plc.set("OB=3");
    plc.run(3);
    holds(&plc, "B1=2 BYTE.ERRLI_P4OUT=2");
    assert_eq!(plc.ports()[4], 1);
    plc.set("I0=1 BYTE.ERRLI_P4OUT=0");
    plc.run(2);
    plc.set("BYTE.ERRLI_P4OUT=0");
    plc.run(2);
    holds(&plc, "B1=2 BYTE.ERRLI_P4OUT=0");
}

#[test]
fn the_mailbox_reads_the_present_words_of_a_drive() {
    let mailbox = |index: &str| {
        format!("MECH_BEGIN M / ECAT_COE_READ 0,1,{index},0,D2,D1 / EX0 / STO W2 / FL 1,O0 / MECH_END M")
    };
    for (index, len, found) in [("6041h", 2, "33h"), ("603Fh", 2, "0"), ("6064h", 4, "0")] {
        let mut plc = Plc::on(Some(SLAVES), INIT, &mailbox(index));
        request(&mut plc, "flEdrvInit", "bEdrvState2=1");
        request(&mut plc, "flEdrvOn", "bEdrvState2=2");
        plc.set("M=1 D1=4 W2=9");
        plc.run(5);
        holds(&plc, &format!("O0=1 W2=0 D1={len} D2={found}"));
    }
}
