//! Homing by the program, outputs of the spindle as reals, software limit switches, names of older programs
//! (manual 12.9, 15.3, 19.2 and 27.4).

use super::Direction::{CncToPlc, PlcToCnc};
use super::space::{BYTE, Numbered, REAL, Row, Shape, WORD};
use crate::catalogue::pattern::text;

/// Servo loops of the control.
const LOOPS: u32 = 16;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "rSPINDLE_OUTPUT_1",
        REAL,
        CncToPlc,
        "12.9",
        text(
            "Programmed output of spindle 1 before the override; 1.0 is 10 V.",
            "Programovaný výstup vřetene 1 před korekcí; 1.0 je 10 V.",
        ),
    ),
    (
        "rSPINDLE_PRS_OUTPUT_1",
        REAL,
        CncToPlc,
        "12.9",
        text(
            "Output of spindle 1 after the override; 1.0 is 10 V.",
            "Výstup vřetene 1 po korekci; 1.0 je 10 V.",
        ),
    ),
    (
        "PB_HOMING_AXIS",
        WORD,
        CncToPlc,
        "15.3",
        text(
            "Axes that the program shall reference, a bit an axis.",
            "Osy, které má zreferovat program, bit na osu.",
        ),
    ),
    (
        "SLS_LIMIT_PLUS",
        BYTE,
        CncToPlc,
        "27.4",
        text(
            "Software limit switches in positive direction, a bit an axis.",
            "Softwarové koncové spínače v kladném směru, bit na osu.",
        ),
    ),
    (
        "SLS_LIMIT_MINUS",
        BYTE,
        CncToPlc,
        "27.4",
        text(
            "Software limit switches in negative direction, a bit an axis.",
            "Softwarové koncové spínače v záporném směru, bit na osu.",
        ),
    ),
    (
        "SLS_DRAG_PLUS",
        BYTE,
        CncToPlc,
        "27.4",
        text(
            "Software slow-down switches in positive direction, a bit an axis.",
            "Softwarové zpomalovací spínače v kladném směru, bit na osu.",
        ),
    ),
    (
        "SLS_DRAG_MINUS",
        BYTE,
        CncToPlc,
        "27.4",
        text(
            "Software slow-down switches in negative direction, a bit an axis.",
            "Softwarové zpomalovací spínače v záporném směru, bit na osu.",
        ),
    ),
    ("PRF", BYTE, CncToPlc, "19.2", text("Feed override in per cent.", "Korekce posuvu v procentech.")),
    (
        "STARTC",
        Shape::Bit,
        CncToPlc,
        "19.2",
        text(
            "Start signal that older programs test together with CAPI.",
            "Signál startu, který starší programy testují spolu s CAPI.",
        ),
    ),
    (
        "BZH11",
        BYTE,
        PlcToCnc,
        "19.2",
        text("Number of an error that the program reports.", "Číslo chyby, kterou hlásí program."),
    ),
];

/// Switches of servo loops, numbered from 1.
pub(super) const FAMILIES: &[Numbered] = &[Numbered {
    before: "REF_SERV_",
    after: "",
    first: 1,
    count: LOOPS,
    shape: Shape::Bit,
    direction: PlcToCnc,
    chapter: "15.3",
    summary: text("Reference switch of servo loop", "Referenční spínač servosmyčky"),
}];
