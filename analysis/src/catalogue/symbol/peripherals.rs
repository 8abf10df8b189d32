//! Errors of peripheral units, analogue channels and the wheel panels (manual 8.4.3, 9.3 to 9.5 and 10.5).

use super::Direction::{Both, CncToPlc, PlcToCnc};
use super::space::{BYTE, Row, Shape};
use crate::catalogue::entry::Prefix;
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "CAN_IO_ERROR_CODE",
        BYTE,
        CncToPlc,
        "9.3",
        text(
            "Error register of the INOUT08 unit in error; 0 means none.",
            "Chybový registr jednotky INOUT08 v poruše; 0 znamená žádnou.",
        ),
    ),
    (
        "CAN_IO_ERROR_NUM",
        BYTE,
        CncToPlc,
        "9.3",
        text("Number of the INOUT08 unit in error.", "Číslo jednotky INOUT08 v poruše."),
    ),
    (
        "CAN_IO_TIMEOUT_CODE",
        BYTE,
        CncToPlc,
        "9.3",
        text("1: a INOUT08 unit does not answer.", "Hodnota 1: jednotka INOUT08 neodpovídá."),
    ),
    (
        "CAN_IO_TIMEOUT_NUM",
        BYTE,
        CncToPlc,
        "9.3",
        text("Number of the INOUT08 unit that does not answer.", "Číslo jednotky INOUT08, která neodpovídá."),
    ),
    (
        "CAN_MAT_ERROR_CODE",
        BYTE,
        CncToPlc,
        "9.3",
        text(
            "Error register of the KLA50 unit in error; 0 means none.",
            "Chybový registr jednotky KLA50 v poruše; 0 znamená žádnou.",
        ),
    ),
    (
        "CAN_MAT_ERROR_NUM",
        BYTE,
        CncToPlc,
        "9.3",
        text("Number of the KLA50 unit in error.", "Číslo jednotky KLA50 v poruše."),
    ),
    (
        "CAN_MAT_TIMEOUT_CODE",
        BYTE,
        CncToPlc,
        "9.3",
        text("1: a KLA50 unit does not answer.", "Hodnota 1: jednotka KLA50 neodpovídá."),
    ),
    (
        "CAN_MAT_TIMEOUT_NUM",
        BYTE,
        CncToPlc,
        "9.3",
        text("Number of the KLA50 unit that does not answer.", "Číslo jednotky KLA50, která neodpovídá."),
    ),
    (
        "CAN_TOC_ERROR_CODE",
        BYTE,
        CncToPlc,
        "9.3",
        text(
            "Error register of the wheel panel unit in error; 0 means none.",
            "Chybový registr jednotky panel s kolečkem v poruše; 0 znamená žádnou.",
        ),
    ),
    (
        "CAN_TOC_ERROR_NUM",
        BYTE,
        CncToPlc,
        "9.3",
        text("Number of the wheel panel unit in error.", "Číslo jednotky panel s kolečkem v poruše."),
    ),
    (
        "CAN_TOC_TIMEOUT_CODE",
        BYTE,
        CncToPlc,
        "9.3",
        text("1: a wheel panel unit does not answer.", "Hodnota 1: jednotka panel s kolečkem neodpovídá."),
    ),
    (
        "CAN_TOC_TIMEOUT_NUM",
        BYTE,
        CncToPlc,
        "9.3",
        text(
            "Number of the wheel panel unit that does not answer.",
            "Číslo jednotky panel s kolečkem, která neodpovídá.",
        ),
    ),
    (
        "ERR_IO8_ERROR",
        Shape::Formal(0),
        CncToPlc,
        "9.3",
        text(
            "Position in the error register of a unit: any error.",
            "Pozice v chybovém registru jednotky: jakákoli chyba.",
        ),
    ),
    (
        "ERR_IO8_SHORT",
        Shape::Formal(1),
        CncToPlc,
        "9.3",
        text(
            "Position in the error register of a unit: short circuit of an output.",
            "Pozice v chybovém registru jednotky: zkrat výstupu.",
        ),
    ),
    (
        "ERR_IO8_LOW_SUPPLY",
        Shape::Formal(2),
        CncToPlc,
        "9.3",
        text(
            "Position in the error register of a unit: low supply voltage.",
            "Pozice v chybovém registru jednotky: nízké napájecí napětí.",
        ),
    ),
    (
        "ERR_IO8_TEMP_OVER",
        Shape::Formal(3),
        CncToPlc,
        "9.3",
        text(
            "Position in the error register of a unit: over-temperature.",
            "Pozice v chybovém registru jednotky: přehřátí.",
        ),
    ),
    (
        "ERR_IO8_COMM",
        Shape::Formal(4),
        CncToPlc,
        "9.3",
        text(
            "Position in the error register of a unit: communication error.",
            "Pozice v chybovém registru jednotky: chyba komunikace.",
        ),
    ),
    (
        "ERR_IO8_INPUT",
        Shape::Formal(7),
        CncToPlc,
        "9.3",
        text(
            "Position in the error register of a unit: error of an input.",
            "Pozice v chybovém registru jednotky: chyba vstupu.",
        ),
    ),
    (
        "IO_ER_HLI_ACT",
        Shape::Formal(0),
        CncToPlc,
        "9.5",
        text(
            "Position in ERR_STAT of a unit: an error is present.",
            "Pozice v ERR_STAT jednotky: chyba trvá.",
        ),
    ),
    (
        "IO_ER_TM_ACT",
        Shape::Formal(1),
        CncToPlc,
        "9.5",
        text(
            "Position in ERR_STAT of a unit: a time-out is present.",
            "Pozice v ERR_STAT jednotky: výpadek odezvy trvá.",
        ),
    ),
    (
        "IO_ER_HLI",
        Shape::Formal(2),
        CncToPlc,
        "9.5",
        text(
            "Position in ERR_STAT of a unit: an error has happened.",
            "Pozice v ERR_STAT jednotky: nastala chyba.",
        ),
    ),
    (
        "IO_ER_TMOUT",
        Shape::Formal(3),
        CncToPlc,
        "9.5",
        text(
            "Position in ERR_STAT of a unit: a time-out has happened.",
            "Pozice v ERR_STAT jednotky: nastal výpadek odezvy.",
        ),
    ),
    (
        "IO_ER_NULL",
        Shape::Formal(4),
        CncToPlc,
        "9.5",
        text(
            "Position in ERR_STAT of a unit: request to clear all units.",
            "Pozice v ERR_STAT jednotky: žádost o nulování všech jednotek.",
        ),
    ),
    (
        "IO_DIS_ERR",
        Shape::Formal(0),
        PlcToCnc,
        "9.3",
        text(
            "Position in CONTROL of a unit: no messages of output errors.",
            "Pozice v CONTROL jednotky: bez hlášení chyb výstupů.",
        ),
    ),
    (
        "IO_DIS_ERPIS",
        Shape::Formal(1),
        PlcToCnc,
        "9.3",
        text(
            "Position in CONTROL of a unit: no report of output errors to the program.",
            "Pozice v CONTROL jednotky: bez předávání chyb výstupů programu.",
        ),
    ),
    (
        "IO_DIS_TMOUT",
        Shape::Formal(2),
        PlcToCnc,
        "9.3",
        text(
            "Position in CONTROL of a unit: no supervision of the answer.",
            "Pozice v CONTROL jednotky: bez hlídání odezvy.",
        ),
    ),
    (
        "IO_DIS_NULL",
        Shape::Formal(6),
        PlcToCnc,
        "9.3",
        text(
            "Position in CONTROL of a unit: other units are not cleared on an error.",
            "Pozice v CONTROL jednotky: při chybě se ostatní jednotky nenulují.",
        ),
    ),
    (
        "CAN_ERR_OK",
        Shape::Constant(0),
        CncToPlc,
        "9.4",
        text("Result of CAN_SEND and CAN_RECV: done.", "Výsledek CAN_SEND a CAN_RECV: v pořádku."),
    ),
    (
        "CAN_ERR_XMTFULL",
        Shape::Constant(1),
        CncToPlc,
        "9.4",
        text(
            "Result of CAN_SEND and CAN_RECV: the transmit queue is full.",
            "Výsledek CAN_SEND a CAN_RECV: vysílací fronta je plná.",
        ),
    ),
    (
        "CAN_ERR_RCVEMPTY",
        Shape::Constant(2),
        CncToPlc,
        "9.4",
        text(
            "Result of CAN_SEND and CAN_RECV: no packet has come.",
            "Výsledek CAN_SEND a CAN_RECV: nepřišel žádný paket.",
        ),
    ),
    (
        "ANALOG_INPUT_PHYSICAL",
        Shape::Array(Prefix::Real, 100),
        CncToPlc,
        "10.5",
        text("Voltages of the physical analogue inputs.", "Napětí fyzických analogových vstupů ve voltech."),
    ),
    (
        "ANALOG_OUTPUT_PHYSICAL",
        Shape::Array(Prefix::Real, 100),
        Both,
        "10.5",
        text(
            "Voltages of the physical analogue outputs.",
            "Napětí fyzických analogových výstupů ve voltech.",
        ),
    ),
    (
        "ANALOG_CONNECTED",
        Shape::Array(Prefix::Byte, 100),
        CncToPlc,
        "10.5",
        text("Which physical analogue channels are mapped.", "Které fyzické analogové kanály jsou mapované."),
    ),
    (
        "AIN_CONNECTED",
        Shape::Formal(0),
        CncToPlc,
        "10.5",
        text(
            "Position in ANALOG_CONNECTED (this implementation's): the input is mapped.",
            "Pozice v ANALOG_CONNECTED (tato implementace): vstup je mapován.",
        ),
    ),
    (
        "AOUT_CONNECTED",
        Shape::Formal(1),
        CncToPlc,
        "10.5",
        text(
            "Position in ANALOG_CONNECTED (this implementation's): the output is mapped.",
            "Pozice v ANALOG_CONNECTED (tato implementace): výstup je mapován.",
        ),
    ),
    (
        "PTLTOC_P1",
        BYTE,
        CncToPlc,
        "8.4.3",
        text("Keys of wheel panel 1, first byte.", "Tlačítka panelu s kolečkem 1, první slabika."),
    ),
    (
        "PTLTOC_P1_2",
        BYTE,
        CncToPlc,
        "8.4.3",
        text("Keys of wheel panel 1, second byte.", "Tlačítka panelu s kolečkem 1, druhá slabika."),
    ),
    (
        "PTLTOC_P2",
        BYTE,
        CncToPlc,
        "8.4.3",
        text("Keys of wheel panel 2, first byte.", "Tlačítka panelu s kolečkem 2, první slabika."),
    ),
    (
        "PTLTOC_P2_2",
        BYTE,
        CncToPlc,
        "8.4.3",
        text("Keys of wheel panel 2, second byte.", "Tlačítka panelu s kolečkem 2, druhá slabika."),
    ),
    (
        "DISPTOC1",
        Shape::Area(8),
        PlcToCnc,
        "8.4.3",
        text(
            "Display of wheel panel 1: row, column, four characters, size, inversion.",
            "Displej panelu s kolečkem 1: řádek, sloupec, čtyři znaky, velikost, inverze.",
        ),
    ),
    (
        "BUSY_DISPTOC1",
        Shape::Bit,
        PlcToCnc,
        "8.4.3",
        text("1 while DISPTOC1 is not yet valid.", "Hodnota 1, dokud DISPTOC1 ještě neplatí."),
    ),
    (
        "DISPTOC2",
        Shape::Area(8),
        PlcToCnc,
        "8.4.3",
        text(
            "Display of wheel panel 2: row, column, four characters, size, inversion.",
            "Displej panelu s kolečkem 2: řádek, sloupec, čtyři znaky, velikost, inverze.",
        ),
    ),
    (
        "BUSY_DISPTOC2",
        Shape::Bit,
        PlcToCnc,
        "8.4.3",
        text("1 while DISPTOC2 is not yet valid.", "Hodnota 1, dokud DISPTOC2 ještě neplatí."),
    ),
];
