//! Drives on CAN-BUS and EtherCAT, servo loops, the measuring unit (manual 13.14, 13.18, 13.19 and 18.2.3).

use super::Direction::{self, Both, CncToPlc, PlcToCnc};
use super::space::{BYTE, DWORD, Numbered, REAL, Row, Shape, WORD};
use crate::catalogue::entry::{Bilingual, Prefix};
use crate::catalogue::pattern::text;

/// Axes and servo loops of the control.
const LOOPS: u32 = 16;
/// CAN-BUS units of group 1.
const UNITS: u32 = 32;
/// Length of a CAN packet in bytes.
const PACKET: u32 = 12;
/// Cells of the configuration that the real-time program keeps.
const MACHINE_CONSTANTS: u32 = 800;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "CAN_DRIVE_STAT",
        Shape::Array(Prefix::Word, LOOPS),
        CncToPlc,
        "13.14.3",
        text(
            "Status word of the CAN drive of each axis; the next axis lies 2 bytes further.",
            "Stavové slovo pohonu CAN každé osy; další osa leží o 2 bajty dál.",
        ),
    ),
    (
        "CAN_DRIVE_MSTAT",
        Shape::Array(Prefix::Word, LOOPS),
        CncToPlc,
        "13.14.3",
        text(
            "Manufacturer's status word of the CAN drive of each axis.",
            "Rozšířené stavové slovo výrobce pohonu CAN každé osy.",
        ),
    ),
    (
        "CAN_MDRIVE_STAT",
        Shape::Alias,
        CncToPlc,
        "18.2.3",
        text("Other name of CAN_DRIVE_MSTAT.", "Jiné jméno pole CAN_DRIVE_MSTAT."),
    ),
    (
        "CAN_DRIVE_CMD",
        Shape::Array(Prefix::Word, LOOPS),
        PlcToCnc,
        "13.14.3",
        text("Command word to the CAN drive of each axis.", "Povelové slovo pro pohon CAN každé osy."),
    ),
    (
        "TCANMSGS",
        Shape::Constant(PACKET as i64),
        Both,
        "13.14.4",
        text(
            "Structure (CAN packet); the name stands for its length, 12 bytes (this implementation).",
            "Struktura (paket CAN); jméno znamená její délku, 12 bajtů (tato implementace).",
        ),
    ),
    (
        "CAN_AX_SEND_PACKET",
        Shape::Area(PACKET),
        PlcToCnc,
        "13.14.4",
        text(
            "Packet (TCANMSGS) that CAN_AX_SEND sends to a drive; the program fills CAN_DATA.",
            "Paket (TCANMSGS), který CAN_AX_SEND vyšle pohonu; program plní CAN_DATA.",
        ),
    ),
    (
        "CAN_AX_RECV_PACKET",
        Shape::Area(PACKET),
        CncToPlc,
        "13.14.4",
        text("Packet (TCANMSGS) with the answer of the drive.", "Paket (TCANMSGS) s odpovědí pohonu."),
    ),
    (
        "CAN_AX_BUSY",
        BYTE,
        Both,
        "13.14.4",
        text(
            "0FFh from CAN_AX_SEND until the drive has answered; the control clears it.",
            "Hodnota 0FFh od CAN_AX_SEND do odpovědi pohonu; nuluje ji systém.",
        ),
    ),
    (
        "EDRV_INIT",
        Shape::Constant(1),
        CncToPlc,
        "13.18.2",
        text(
            "Value of bEdrvState: initialised (this implementation: 1).",
            "Hodnota bEdrvState: inicializováno (tato implementace: 1).",
        ),
    ),
    (
        "EDRV_ON",
        Shape::Constant(2),
        CncToPlc,
        "13.18.2",
        text(
            "Value of bEdrvState: switched on (this implementation: 2).",
            "Hodnota bEdrvState: zapnuto (tato implementace: 2).",
        ),
    ),
    (
        "EDRV_ENABLE",
        Shape::Constant(3),
        CncToPlc,
        "13.18.2",
        text(
            "Value of bEdrvState: operation enabled (this implementation: 3).",
            "Hodnota bEdrvState: provoz povolen (tato implementace: 3).",
        ),
    ),
    (
        "EDRV_DONE",
        Shape::Constant(0),
        CncToPlc,
        "27.4",
        text(
            "Value of bEdrvState: not in operation (this implementation: 0).",
            "Hodnota bEdrvState: mimo provoz (tato implementace: 0).",
        ),
    ),
    (
        "ServoReqPosition",
        Shape::Array(Prefix::Dwrd, LOOPS),
        CncToPlc,
        "13.18.2",
        text(
            "Requested position of each servo loop in µm, with sign.",
            "Žádaná poloha každé servosmyčky v µm, se znaménkem.",
        ),
    ),
    (
        "ServoPosition",
        Shape::Array(Prefix::Dwrd, LOOPS),
        CncToPlc,
        "13.18.2",
        text(
            "Measured position of each servo loop in µm, with sign.",
            "Odměřená poloha každé servosmyčky v µm, se znaménkem.",
        ),
    ),
    (
        "SERVO_POSITION",
        Shape::Array(Prefix::Dwrd, LOOPS),
        CncToPlc,
        "13.18.2",
        text(
            "Measured position of each servo loop in increments of the drive, with sign.",
            "Odměřená poloha každé servosmyčky v inkrementech pohonu, se znaménkem.",
        ),
    ),
    (
        "SU_IRC0",
        Shape::Array(Prefix::Word, LOOPS),
        CncToPlc,
        "18.2.3",
        text("Counters of the measuring unit SU05.", "Čítače jednotky odměřování SU05."),
    ),
    (
        "SU_REF0",
        Shape::Array(Prefix::Word, LOOPS),
        CncToPlc,
        "18.2.3",
        text(
            "Reference buffers of the measuring unit SU05.",
            "Referenční registry jednotky odměřování SU05.",
        ),
    ),
    (
        "SU_OUT_PLC",
        Shape::Array(Prefix::Real, LOOPS),
        PlcToCnc,
        "18.2.3",
        text(
            "Voltages of the program for the analogue outputs of SU05; 1.0 is 10 V.",
            "Napětí od programu pro analogové výstupy SU05; 1.0 je 10 V.",
        ),
    ),
    (
        "SU_CHECK_ODM",
        Shape::Array(Prefix::Dwrd, LOOPS),
        CncToPlc,
        "18.2.3",
        text("Check counters of the measuring.", "Kontrolní čítače odměřování."),
    ),
    (
        "SU_CHECK_NI",
        Shape::Array(Prefix::Dwrd, LOOPS),
        CncToPlc,
        "18.2.3",
        text("Counters of zero-pulse zones.", "Čítače zón nulového pulzu."),
    ),
    (
        "SU_CHECK_NI_ABS",
        Shape::Array(Prefix::Dwrd, LOOPS),
        CncToPlc,
        "18.2.3",
        text("Absolute positions at the zero pulse.", "Absolutní polohy v nulovém pulzu."),
    ),
    (
        "KLA_TPDO_LOST",
        BYTE,
        CncToPlc,
        "18.3.3",
        text("Counter of packets lost from the panel.", "Čítač ztracených paketů panelu."),
    ),
    (
        "INOUT_TPDO_LOST",
        Shape::Array(Prefix::Byte, UNITS),
        CncToPlc,
        "18.3.3",
        text(
            "Counters of packets lost from the INOUT08 units, a byte each.",
            "Čítače ztracených paketů jednotek INOUT08, po jednom bajtu.",
        ),
    ),
    (
        "BUKON00",
        Shape::Array(Prefix::Dwrd, MACHINE_CONSTANTS),
        CncToPlc,
        "18.2.3",
        text(
            "Configuration of the real-time program: machine constants from number 0.",
            "Konfigurace programu reálného času: strojní konstanty od čísla 0.",
        ),
    ),
    (
        "BUKON10",
        Shape::Within(4 * 10, Prefix::Word),
        CncToPlc,
        "19.2",
        text(
            "Machine constant 10 in BCD: rapid feed (this implementation: in BUKON00).",
            "Strojní konstanta 10 v BCD: rychloposuv (tato implementace: v poli BUKON00).",
        ),
    ),
    (
        "BUKON180",
        Shape::Within(4 * 180, Prefix::Word),
        CncToPlc,
        "19.2",
        text(
            "Machine constant 180 in BCD: acceleration (this implementation: in BUKON00).",
            "Strojní konstanta 180 v BCD: zrychlení (tato implementace: v poli BUKON00).",
        ),
    ),
    (
        "BUKON181",
        Shape::Within(4 * 181, Prefix::Word),
        CncToPlc,
        "19.2",
        text(
            "Machine constant 181 in BCD: approach feed (this implementation: in BUKON00).",
            "Strojní konstanta 181 v BCD: dojížděcí posuv (tato implementace: v poli BUKON00).",
        ),
    ),
];

/// One symbol for every servo loop, numbered from 0.
const fn loops(
    before: &'static str,
    shape: Shape,
    direction: Direction,
    en: &'static str,
    cs: &'static str,
) -> Numbered {
    let summary: Bilingual = text(en, cs);
    Numbered { before, after: "", first: 0, count: LOOPS, shape, direction, chapter: "13.18.2", summary }
}

/// The EtherCAT drives and encoders.
pub(super) const FAMILIES: &[Numbered] = &[
    loops(
        "wEdrvDriveStatus",
        WORD,
        Both,
        "Status word (6041h) of EtherCAT drive",
        "Stavové slovo (6041h) pohonu EtherCAT",
    ),
    loops(
        "dwEdrvDrivePos",
        DWORD,
        Both,
        "Actual position (6064h) in increments of EtherCAT drive",
        "Skutečná poloha (6064h) v inkrementech pohonu EtherCAT",
    ),
    loops(
        "wEdrvDriveErrReg",
        WORD,
        Both,
        "Error register (603Fh) of EtherCAT drive",
        "Chybový registr (603Fh) pohonu EtherCAT",
    ),
    loops(
        "wEdrvDriveControl",
        WORD,
        CncToPlc,
        "Control word (6040h) for EtherCAT drive",
        "Řídicí slovo (6040h) pro pohon EtherCAT",
    ),
    loops(
        "dwEdrvDrivePosReq",
        DWORD,
        CncToPlc,
        "Requested position (607Ah) in increments for EtherCAT drive",
        "Žádaná poloha (607Ah) v inkrementech pro pohon EtherCAT",
    ),
    loops(
        "dwEdrvDriveVeloReq",
        DWORD,
        CncToPlc,
        "Requested speed (60FFh) for EtherCAT drive",
        "Žádaná rychlost (60FFh) pro pohon EtherCAT",
    ),
    loops(
        "bEdrvState",
        BYTE,
        CncToPlc,
        "State (EDRV_INIT, EDRV_ON, EDRV_ENABLE) of EtherCAT drive",
        "Stav (EDRV_INIT, EDRV_ON, EDRV_ENABLE) pohonu EtherCAT",
    ),
    loops(
        "flEdrvMoveDisReq",
        Shape::Bit,
        CncToPlc,
        "Request to block the motion by EtherCAT drive",
        "Žádost o blokování pohybu od pohonu EtherCAT",
    ),
    loops("flEdrvError", Shape::Bit, CncToPlc, "Error of EtherCAT drive", "Chyba pohonu EtherCAT"),
    loops(
        "flEdrvInit",
        Shape::Bit,
        Both,
        "Request, cleared when done, to initialise EtherCAT drive",
        "Žádost, po splnění vynulovaná, o inicializaci pohonu EtherCAT",
    ),
    loops(
        "flEdrvOn",
        Shape::Bit,
        Both,
        "Request, cleared when done, to switch on EtherCAT drive",
        "Žádost, po splnění vynulovaná, o zapnutí pohonu EtherCAT",
    ),
    loops(
        "flEdrvEnable",
        Shape::Bit,
        Both,
        "Request, cleared when done, to enable EtherCAT drive",
        "Žádost, po splnění vynulovaná, o uvolnění pohonu EtherCAT",
    ),
    loops(
        "flEdrvDisable",
        Shape::Bit,
        Both,
        "Request, cleared when done, to disable EtherCAT drive",
        "Žádost, po splnění vynulovaná, o zablokování pohonu EtherCAT",
    ),
    loops(
        "flEdrvDone",
        Shape::Bit,
        Both,
        "Request, cleared when done, to end the operation of EtherCAT drive",
        "Žádost, po splnění vynulovaná, o ukončení provozu pohonu EtherCAT",
    ),
    loops(
        "flEdrvErase",
        Shape::Bit,
        Both,
        "Request, cleared when done, to erase the errors of EtherCAT drive",
        "Žádost, po splnění vynulovaná, o smazání chyb pohonu EtherCAT",
    ),
    loops(
        "rEdrvScaleSpeed",
        REAL,
        PlcToCnc,
        "Scale of the requested speed of EtherCAT drive",
        "Měřítko žádané rychlosti pohonu EtherCAT",
    ),
    loops("flEdrvSimul", Shape::Bit, Both, "Simulation of EtherCAT drive", "Simulace pohonu EtherCAT"),
    loops(
        "dwEdrvEncCounterValue",
        DWORD,
        Both,
        "Counter in increments of external EtherCAT encoder",
        "Čítač v inkrementech externího snímače EtherCAT",
    ),
    loops(
        "dwEdrvEncLatchValue",
        DWORD,
        Both,
        "Counter latched at the zero pulse of external EtherCAT encoder",
        "Čítač zachycený v nulovém pulzu externího snímače EtherCAT",
    ),
    loops(
        "flEdrvEncLatchValid",
        Shape::Bit,
        Both,
        "The latched value is valid in external EtherCAT encoder",
        "Platná zachycená hodnota externího snímače EtherCAT",
    ),
    loops(
        "flEdrvEncLatchEn",
        Shape::Bit,
        CncToPlc,
        "Enable of latching in external EtherCAT encoder",
        "Povolení zachycení externího snímače EtherCAT",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{SystemKind, symbol};

    #[test]
    fn every_family_has_sixteen_loops_one_behind_the_other() {
        assert_eq!(FAMILIES.len(), 21);
        for family in FAMILIES {
            let place = |number: u32| match symbol(&format!("{}{number}", family.before)).map(|s| s.kind) {
                Some(SystemKind::Cell { addr, prefix }) => u64::from(addr) * 8 / u64::from(prefix.bytes()),
                Some(SystemKind::Bit { addr, bit }) => u64::from(addr) * 8 + u64::from(bit),
                other => panic!("{}{number}: {other:?}", family.before),
            };
            let step = place(1) - place(0);
            for number in 1..LOOPS {
                assert_eq!(place(number), place(0) + u64::from(number) * step, "{}{number}", family.before);
            }
            assert!(symbol(&format!("{}16", family.before)).is_none());
        }
    }

    #[test]
    fn a_machine_constant_is_an_element_of_the_configuration() {
        let Some(SystemKind::Array { addr, len: 800, .. }) = symbol("BUKON00").map(|s| s.kind) else {
            panic!("BUKON00 is no array of 800 elements");
        };
        let expected = SystemKind::Cell { addr: addr + 720, prefix: Prefix::Word };
        assert_eq!(symbol("BUKON180").map(|s| s.kind), Some(expected));
    }
}
