//! Control bits, states and commands of the EtherCAT master (manual 26.2.3, 26.3 and 26.4.3).

use super::Direction::{Both, CncToPlc, PlcToCnc};
use super::space::{Row, Shape};
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "flEcatStartCyclicOperation",
        Shape::Bit,
        PlcToCnc,
        "26.2.3",
        text(
            "Starts the cyclic exchange of data when EtherCATOPViaPLC is 1.",
            "Spustí cyklickou výměnu dat, je-li EtherCATOPViaPLC 1.",
        ),
    ),
    (
        "flEcatOperational",
        Shape::Bit,
        CncToPlc,
        "26.3",
        text("The master has reached OPERATIONAL.", "Master dosáhl stavu OPERATIONAL."),
    ),
    (
        "flEcatBootStrapReq",
        Shape::Bit,
        Both,
        "26.3",
        text(
            "Request to bring the master to BOOTSTRAP; the control clears it as confirmation.",
            "Žádost o přechod masteru do stavu BOOTSTRAP; systém ji na potvrzení vynuluje.",
        ),
    ),
    (
        "flEcatInitReq",
        Shape::Bit,
        Both,
        "26.3",
        text(
            "Request to bring the master to INIT; the control clears it as confirmation.",
            "Žádost o přechod masteru do stavu INIT; systém ji na potvrzení vynuluje.",
        ),
    ),
    (
        "flEcatPreOperationalReq",
        Shape::Bit,
        Both,
        "26.3",
        text(
            "Request to bring the master to PRE-OPERATIONAL; the control clears it as confirmation.",
            "Žádost o přechod masteru do stavu PRE-OPERATIONAL; systém ji na potvrzení vynuluje.",
        ),
    ),
    (
        "flEcatSafeOperationalReq",
        Shape::Bit,
        Both,
        "26.3",
        text(
            "Request to bring the master to SAFE-OPERATIONAL; the control clears it as confirmation.",
            "Žádost o přechod masteru do stavu SAFE-OPERATIONAL; systém ji na potvrzení vynuluje.",
        ),
    ),
    (
        "flEcatOperationalReq",
        Shape::Bit,
        Both,
        "26.3",
        text(
            "Request to bring the master to OPERATIONAL; the control clears it as confirmation.",
            "Žádost o přechod masteru do stavu OPERATIONAL; systém ji na potvrzení vynuluje.",
        ),
    ),
    (
        "ECAT_INIT",
        Shape::Constant(1),
        CncToPlc,
        "26.3",
        text("EtherCAT state INIT.", "Stav INIT sítě EtherCAT."),
    ),
    (
        "ECAT_PREOPERATIONAL",
        Shape::Constant(2),
        CncToPlc,
        "26.3",
        text("EtherCAT state PRE-OPERATIONAL.", "Stav PRE-OPERATIONAL sítě EtherCAT."),
    ),
    (
        "ECAT_BOOTSTRAP",
        Shape::Constant(3),
        CncToPlc,
        "26.3",
        text("EtherCAT state BOOTSTRAP.", "Stav BOOTSTRAP sítě EtherCAT."),
    ),
    (
        "ECAT_SAFEOPERATIONAL",
        Shape::Constant(4),
        CncToPlc,
        "26.3",
        text("EtherCAT state SAFE-OPERATIONAL.", "Stav SAFE-OPERATIONAL sítě EtherCAT."),
    ),
    (
        "ECAT_OPERATIONAL",
        Shape::Constant(8),
        CncToPlc,
        "26.3",
        text("EtherCAT state OPERATIONAL.", "Stav OPERATIONAL sítě EtherCAT."),
    ),
    (
        "ECATCMD_MASTER_INIT",
        Shape::Constant(1),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings the master to INIT.",
            "Příkaz pro ECAT_COMMAND: uvede master do stavu INIT.",
        ),
    ),
    (
        "ECATCMD_MASTER_PREOPERATIONAL",
        Shape::Constant(2),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings the master to PRE-OPERATIONAL.",
            "Příkaz pro ECAT_COMMAND: uvede master do stavu PRE-OPERATIONAL.",
        ),
    ),
    (
        "ECATCMD_MASTER_BOOTSTRAP",
        Shape::Constant(3),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings the master to BOOTSTRAP.",
            "Příkaz pro ECAT_COMMAND: uvede master do stavu BOOTSTRAP.",
        ),
    ),
    (
        "ECATCMD_MASTER_SAFEOPERATIONAL",
        Shape::Constant(4),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings the master to SAFE-OPERATIONAL.",
            "Příkaz pro ECAT_COMMAND: uvede master do stavu SAFE-OPERATIONAL.",
        ),
    ),
    (
        "ECATCMD_MASTER_OPERATIONAL",
        Shape::Constant(8),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings the master to OPERATIONAL.",
            "Příkaz pro ECAT_COMMAND: uvede master do stavu OPERATIONAL.",
        ),
    ),
    (
        "ECATCMD_SLAVE_INIT",
        Shape::Constant(11),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings one slave to INIT.",
            "Příkaz pro ECAT_COMMAND: uvede jeden slave do stavu INIT.",
        ),
    ),
    (
        "ECATCMD_SLAVE_PREOPERATIONAL",
        Shape::Constant(12),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings one slave to PRE-OPERATIONAL.",
            "Příkaz pro ECAT_COMMAND: uvede jeden slave do stavu PRE-OPERATIONAL.",
        ),
    ),
    (
        "ECATCMD_SLAVE_BOOTSTRAP",
        Shape::Constant(13),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings one slave to BOOTSTRAP.",
            "Příkaz pro ECAT_COMMAND: uvede jeden slave do stavu BOOTSTRAP.",
        ),
    ),
    (
        "ECATCMD_SLAVE_SAFEOPERATIONAL",
        Shape::Constant(14),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings one slave to SAFE-OPERATIONAL.",
            "Příkaz pro ECAT_COMMAND: uvede jeden slave do stavu SAFE-OPERATIONAL.",
        ),
    ),
    (
        "ECATCMD_SLAVE_OPERATIONAL",
        Shape::Constant(18),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: brings one slave to OPERATIONAL.",
            "Příkaz pro ECAT_COMMAND: uvede jeden slave do stavu OPERATIONAL.",
        ),
    ),
    (
        "ECATCMD_MASTER_STATE",
        Shape::Constant(20),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: asks for the state of the master.",
            "Příkaz pro ECAT_COMMAND: dotaz na stav masteru.",
        ),
    ),
    (
        "ECATCMD_SLAVE_STATE",
        Shape::Constant(21),
        PlcToCnc,
        "26.4.3",
        text(
            "Command of ECAT_COMMAND: asks for the state of one slave.",
            "Příkaz pro ECAT_COMMAND: dotaz na stav jednoho slave.",
        ),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{SystemKind, symbol};

    #[test]
    fn there_are_seven_bits_five_states_and_twelve_commands() {
        let count = |test: fn(&str) -> bool| ROWS.iter().filter(|row| test(row.0)).count();
        assert_eq!(count(|name| name.starts_with("flEcat")), 7);
        assert_eq!(count(|name| name.starts_with("ECAT_")), 5);
        assert_eq!(count(|name| name.starts_with("ECATCMD_")), 12);
        assert_eq!(ROWS.len(), 24);
    }

    #[test]
    fn a_command_for_a_slave_is_ten_more_than_its_state() {
        let value = |name: &str| match symbol(name).map(|symbol| symbol.kind) {
            Some(SystemKind::Constant(value)) => value,
            other => panic!("{name}: {other:?}"),
        };
        for (state, expected) in
            [("INIT", 1), ("PREOPERATIONAL", 2), ("BOOTSTRAP", 3), ("SAFEOPERATIONAL", 4), ("OPERATIONAL", 8)]
        {
            assert_eq!(value(&format!("ECAT_{state}")), expected);
            assert_eq!(value(&format!("ECATCMD_MASTER_{state}")), expected);
            assert_eq!(value(&format!("ECATCMD_SLAVE_{state}")), expected + 10);
        }
        assert_eq!((value("ECATCMD_MASTER_STATE"), value("ECATCMD_SLAVE_STATE")), (20, 21));
    }
}
