//! Auxiliary manual jog (manual 8.1.11).

use super::Direction::{Both, CncToPlc, PlcToCnc};
use super::space::{BYTE, Row, Shape, WORD};
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "BZH00",
        BYTE,
        Both,
        "8.1.11",
        text(
            "Byte of the feedback block with the state of manual jog.",
            "Slabika zpětnovazebního bloku se stavem ručních pojezdů.",
        ),
    ),
    (
        "ACK_AUTMAN",
        Shape::BitOf(0),
        CncToPlc,
        "8.1.11",
        text("Manual jog is active.", "Ruční pojezdy jsou aktivní."),
    ),
    (
        "AUTMAN_REQ",
        Shape::BitOf(1),
        PlcToCnc,
        "8.1.11",
        text(
            "Request for manual jog; stays 1 as long as it shall be active.",
            "Žádost o ruční pojezdy; trvá 1 po celou dobu jejich aktivity.",
        ),
    ),
    (
        "MAN_NC",
        BYTE,
        CncToPlc,
        "8.1.11",
        text("Byte with the source of manual jog.", "Slabika se zdrojem ručních pojezdů."),
    ),
    (
        "AUTMAN_CONT_NC",
        Shape::BitOf(0),
        CncToPlc,
        "8.1.11",
        text("Manual jog is controlled from the panel.", "Ruční pojezdy se řídí z panelu."),
    ),
    (
        "CONT_AUTMAN2",
        BYTE,
        CncToPlc,
        "8.1.11",
        text("Byte with the source of manual jog, second.", "Druhá slabika se zdrojem ručních pojezdů."),
    ),
    (
        "AUTMAN_CONT_TOC",
        Shape::BitOf(0),
        CncToPlc,
        "8.1.11",
        text("Manual jog is controlled from the wheel panel.", "Ruční pojezdy se řídí z panelu s kolečkem."),
    ),
    (
        "CONT_AUTMAN",
        BYTE,
        CncToPlc,
        "8.1.11",
        text("Byte with the state of manual jog.", "Slabika se stavem ručních pojezdů."),
    ),
    (
        "AUTMAN_CONT_SELECT",
        Shape::BitOf(0),
        CncToPlc,
        "8.1.11",
        text("The axis is being preselected.", "Probíhá předvolba osy."),
    ),
    (
        "AUTMAN_CONT_G00",
        Shape::BitOf(1),
        CncToPlc,
        "8.1.11",
        text("Rapid traverse is requested.", "Je požadován rychloposuv."),
    ),
    (
        "EXT_CONT_AUTMAN3",
        BYTE,
        Both,
        "8.1.11",
        text(
            "Byte with requests of the program for manual jog.",
            "Slabika s žádostmi programu o ruční pojezdy.",
        ),
    ),
    (
        "INPOS_STOP",
        Shape::BitOf(0),
        CncToPlc,
        "8.1.11",
        text("The machine stands where it last stopped.", "Stroj stojí v poloze posledního stopu."),
    ),
    (
        "REQ_EXT_CONT_AUTMAN",
        Shape::BitOf(1),
        PlcToCnc,
        "8.1.11",
        text(
            "The program controls the motion; EXM_x0 and EXM_x1 count.",
            "Pohyb řídí program; platí EXM_x0 a EXM_x1.",
        ),
    ),
    (
        "REQ_EXT_FEED_AUTMAN",
        Shape::BitOf(2),
        PlcToCnc,
        "8.1.11",
        text(
            "The program gives the feed; EXT_FEED_AUTMAN counts.",
            "Posuv zadává program; platí EXT_FEED_AUTMAN.",
        ),
    ),
    (
        "EXT_CONT_AUTMAN",
        BYTE,
        PlcToCnc,
        "8.1.11",
        text(
            "Byte with requests of the program for manual jog, first.",
            "První slabika s žádostmi programu o ruční pojezdy.",
        ),
    ),
    (
        "REQ_EXT_G00_AUTMAN",
        Shape::BitOf(0),
        PlcToCnc,
        "8.1.11",
        text("The program requests rapid traverse.", "Program žádá rychloposuv."),
    ),
    (
        "REQ_EXT_SELECT_AUTMAN",
        Shape::BitOf(1),
        PlcToCnc,
        "8.1.11",
        text("The program requests the preselection of an axis.", "Program žádá předvolbu osy."),
    ),
    (
        "EN_AUTMAN",
        Shape::Bit,
        PlcToCnc,
        "8.1.11",
        text("The program allows manual jog.", "Program povoluje ruční pojezdy."),
    ),
    (
        "REQ_EXT_FEED_G00_AUTMAN",
        Shape::Bit,
        PlcToCnc,
        "8.1.11",
        text(
            "The program gives the rapid feed; EXT_FEED_G00_AUTMAN counts.",
            "Rychloposuv zadává program; platí EXT_FEED_G00_AUTMAN.",
        ),
    ),
    (
        "EXT_FEED_AUTMAN",
        WORD,
        PlcToCnc,
        "8.1.11",
        text("Feed of manual jog in mm/min.", "Posuv ručních pojezdů v mm/min."),
    ),
    (
        "EXT_FEED_G00_AUTMAN",
        WORD,
        PlcToCnc,
        "8.1.11",
        text("Rapid feed of manual jog in mm/min.", "Rychloposuv ručních pojezdů v mm/min."),
    ),
];
