//! State of the control, its clock and the backed-up memory (manual 8.1.18 to 8.1.22, 8.3.6, 8.4.2, 8.4.5 and 8.4.7).

use super::Direction::{Both, CncToPlc};
use super::space::{BYTE, Numbered, Row, Shape};
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "BZH13",
        BYTE,
        CncToPlc,
        "8.1.18",
        text("Number of a real-time error; 0 means none.", "Číslo chyby reálného času; 0 znamená žádnou."),
    ),
    (
        "PRODLEVA",
        Shape::Bit,
        Both,
        "8.1.21",
        text("Lamp DWELL; lit while G04 is programmed.", "Signálka PRODLEVA; svítí při programovaném G04."),
    ),
    (
        "BLOCK_IDLE",
        Shape::Constant(0),
        CncToPlc,
        "8.1.22",
        text("Value of STATUS_RESTART: at rest.", "Hodnota STATUS_RESTART: klid."),
    ),
    (
        "BLOCK_INIT",
        Shape::Constant(1),
        CncToPlc,
        "8.1.22",
        text("Value of STATUS_RESTART: preparatory functions.", "Hodnota STATUS_RESTART: přípravné funkce."),
    ),
    (
        "BLOCK_MOVE",
        Shape::Constant(2),
        CncToPlc,
        "8.1.22",
        text("Value of STATUS_RESTART: motion.", "Hodnota STATUS_RESTART: pohyb."),
    ),
    (
        "BLOCK_DELAY",
        Shape::Constant(3),
        CncToPlc,
        "8.1.22",
        text("Value of STATUS_RESTART: dwell.", "Hodnota STATUS_RESTART: prodleva."),
    ),
    (
        "BLOCK_DONE",
        Shape::Constant(4),
        CncToPlc,
        "8.1.22",
        text("Value of STATUS_RESTART: closing functions.", "Hodnota STATUS_RESTART: závěrečné funkce."),
    ),
    ("SF_RUN", Shape::Bit, CncToPlc, "8.3.6", text("The control runs.", "Systém běží.")),
    (
        "SF_BLOCKINPROGR",
        Shape::Bit,
        CncToPlc,
        "8.3.6",
        text("A block is in progress.", "Blok je rozpracován."),
    ),
    ("SF_BLOCKFINISHED", Shape::Bit, CncToPlc, "8.3.6", text("The block has finished.", "Blok skončil.")),
    ("SF_STOP", Shape::Bit, CncToPlc, "8.3.6", text("The control has stopped.", "Systém je zastaven.")),
    (
        "SF_NOTINPOS",
        Shape::Bit,
        CncToPlc,
        "8.3.6",
        text("The position is not reached yet.", "Poloha ještě není dosažena."),
    ),
    (
        "SF_DELAYINPROGR",
        Shape::Bit,
        CncToPlc,
        "8.3.6",
        text("A dwell (G04) runs.", "Probíhá prodleva (G04)."),
    ),
    ("SF_INDICATIONMODE", Shape::Bit, CncToPlc, "8.3.6", text("Indication mode.", "Režim indikace.")),
    (
        "SF_SIMULATIONMODE",
        Shape::Bit,
        CncToPlc,
        "8.3.6",
        text("Simulation without the machine.", "Simulace bez stroje."),
    ),
    ("SF_HIGHSPEEDMODE", Shape::Bit, CncToPlc, "8.3.6", text("High-speed mode.", "Vysokorychlostní režim.")),
    (
        "SF_CONDSTOPMODE",
        Shape::Bit,
        CncToPlc,
        "8.3.6",
        text("Conditional stop is active.", "Podmíněný stop je aktivní."),
    ),
    ("SF_MANUALMODE", Shape::Bit, CncToPlc, "8.3.6", text("Manual jog.", "Ruční pojezdy.")),
    ("SF_BLOCKBYBLOCK", Shape::Bit, CncToPlc, "8.3.6", text("Block by block.", "Režim blok po bloku.")),
    ("SF_LS", Shape::Bit, CncToPlc, "8.3.6", text("A limit switch is active.", "Aktivní koncový spínač.")),
    (
        "SF_SLS",
        Shape::Bit,
        CncToPlc,
        "8.3.6",
        text("A software limit switch is active.", "Aktivní softwarový koncový spínač."),
    ),
    ("SF_BACKWARD", Shape::Bit, CncToPlc, "8.3.6", text("Backward run.", "Couvání.")),
    (
        "SF_STOPPOSCHANGED",
        Shape::Bit,
        CncToPlc,
        "8.3.6",
        text("The axes were jogged during a stop.", "Během stopu se ručně pojíždělo."),
    ),
    (
        "SYST_TIME_INFO",
        Shape::Area(4),
        CncToPlc,
        "8.4.2",
        text(
            "Local time: minutes, hours, hundredths, seconds, a byte each.",
            "Místní čas: minuty, hodiny, setiny, sekundy, po jednom bajtu.",
        ),
    ),
    (
        "SYST_DATE_INFO",
        Shape::Area(4),
        CncToPlc,
        "8.4.2",
        text("Local date: year (WORD), day, month.", "Místní datum: rok (WORD), den, měsíc."),
    ),
    (
        "UTC_TIME_INFO",
        Shape::Area(4),
        CncToPlc,
        "8.4.2",
        text(
            "UTC time: minutes, hours, hundredths, seconds, a byte each.",
            "Čas UTC: minuty, hodiny, setiny, sekundy, po jednom bajtu.",
        ),
    ),
    (
        "UTC_DATE_INFO",
        Shape::Area(4),
        CncToPlc,
        "8.4.2",
        text("UTC date: year (WORD), day, month.", "Datum UTC: rok (WORD), den, měsíc."),
    ),
    (
        "FILETIME_INFO",
        Shape::Area(8),
        CncToPlc,
        "8.4.2",
        text("UTC time as a 64-bit FILETIME.", "Čas UTC jako 64bitový FILETIME."),
    ),
    (
        "REQ_BACKUP_MEM",
        Shape::Bit,
        Both,
        "8.4.5",
        text(
            "1 saves PLC_MEM_BACKUP now; the control clears it.",
            "Hodnota 1 uloží PLC_MEM_BACKUP; systém ji vynuluje.",
        ),
    ),
    (
        "HwKeyConnected",
        Shape::Constant(0),
        CncToPlc,
        "8.4.7",
        text(
            "LDR_LIC: the hardware key is connected (this implementation: 0).",
            "LDR_LIC: hardwarový klíč je připojen (tato implementace: 0).",
        ),
    ),
    (
        "PLC_MEM_BACKUP",
        Shape::Area(10_000),
        Both,
        "8.4.5",
        text(
            "Memory kept while the power is off, 10000 bytes.",
            "Paměť zálohovaná při vypnutí, 10000 bajtů.",
        ),
    ),
];

/// Licences of the program; the numbers are this implementation's.
pub(super) const LICENCES: Numbered = Numbered {
    before: "FeaturePlc",
    after: "",
    first: 0,
    count: 10,
    shape: Shape::Constant(1),
    direction: CncToPlc,
    chapter: "8.4.7",
    summary: text(
        "LDR_LIC (value chosen by this implementation): licence of PLC feature",
        "LDR_LIC (hodnotu volí tato implementace): licence funkce PLC",
    ),
};
