//! Manual jog and independent shift: what chapter 20.2 adds to 8.1.11.

use super::Direction::{Both, CncToPlc, PlcToCnc};
use super::space::{AxisBits, BYTE, Row, Shape, WORD};
use crate::catalogue::entry::Prefix;
use crate::catalogue::pattern::text;

/// Axes that manual jog knows.
const AXES: u32 = 6;

/// In the order of their addresses.
pub(super) const FAMILIES: &[AxisBits] = &[
    AxisBits {
        before: "MM_",
        after: "0",
        axes: AXES,
        cells: (Some("AX_AUTMAN"), None),
        direction: CncToPlc,
        chapter: "20.2.2",
        default: None,
        summary: text("Jog requested in positive direction", "Žádaný ruční pohyb v kladném směru"),
    },
    AxisBits {
        before: "MM_",
        after: "1",
        axes: AXES,
        cells: (None, None),
        direction: CncToPlc,
        chapter: "20.2.2",
        default: None,
        summary: text("Jog requested in negative direction", "Žádaný ruční pohyb v záporném směru"),
    },
];

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "REQ_ESHIFT",
        Shape::Bit,
        Both,
        "20.2.1",
        text("The mode of independent shift is selected.", "Je zvolen režim nezávislého posouvání dráhy."),
    ),
    (
        "ACT_ESHIFT",
        Shape::Bit,
        Both,
        "20.2.1",
        text(
            "Independent shift is active; the handwheel moves the axis.",
            "Nezávislé posouvání je aktivní; osou pohybuje kolečko.",
        ),
    ),
    (
        "G95_AUTMAN",
        Shape::Bit,
        PlcToCnc,
        "20.2.4",
        text(
            "1: feeds of manual jog are in µm per revolution; rapid traverse does not change.",
            "Hodnota 1: posuvy ručních pojezdů jsou v µm na otáčku; rychloposuv se nemění.",
        ),
    ),
    (
        "AUTMAN_SEL",
        BYTE,
        PlcToCnc,
        "20.2.4",
        text(
            "Byte with requests of the program to begin and end manual jog.",
            "Slabika s žádostmi programu o zahájení a ukončení ručních pojezdů.",
        ),
    ),
    (
        "AUTMAN_SELECT",
        Shape::BitOf(0),
        Both,
        "20.2.4",
        text(
            "Edge that begins manual jog; the control clears the bit.",
            "Hrana zahájí ruční pojezdy; bit nuluje systém.",
        ),
    ),
    (
        "AUTMAN_CANCEL",
        Shape::BitOf(1),
        Both,
        "20.2.4",
        text(
            "Edge that ends manual jog; the control clears the bit.",
            "Hrana ukončí ruční pojezdy; bit nuluje systém.",
        ),
    ),
    (
        "AUTMAN_KNOB1_DIS",
        Shape::BitOf(2),
        PlcToCnc,
        "20.2.4",
        text("1 disables the keys of wheel panel 1.", "Hodnota 1 zakáže tlačítka panelu s kolečkem 1."),
    ),
    (
        "AUTMAN_KNOB2_DIS",
        Shape::BitOf(3),
        PlcToCnc,
        "20.2.4",
        text("1 disables the keys of wheel panel 2.", "Hodnota 1 zakáže tlačítka panelu s kolečkem 2."),
    ),
    (
        "AUTMAN_SEL2",
        BYTE,
        PlcToCnc,
        "20.2.4",
        text(
            "Byte with requests of the program on the preselection of axes.",
            "Slabika s žádostmi programu k předvolbě os.",
        ),
    ),
    (
        "AUTMAN_WHEEL_DIS",
        Shape::BitOf(0),
        PlcToCnc,
        "20.2.4",
        text(
            "1: jog commands do not preselect the axis for the handwheel.",
            "Hodnota 1: povely pohybu nepředvolí osu pro kolečko.",
        ),
    ),
    (
        "AUTMAN_KNOB_TOGGLE",
        Shape::BitOf(1),
        PlcToCnc,
        "20.2.4",
        text(
            "1: the command of preselection switches it on and off by turns.",
            "Hodnota 1: povel předvolby ji střídavě zapíná a vypíná.",
        ),
    ),
    ("KNOB_STEP", WORD, Both, "20.2.4", text("Step of the handwheel in µm.", "Krok kolečka v µm.")),
    (
        "SHIFT_ENABLE",
        BYTE,
        PlcToCnc,
        "20.2.4",
        text("Enables the independent shift, a bit an axis.", "Povolení nezávislého posouvání, bit na osu."),
    ),
    (
        "SHIFT_CONTROL",
        BYTE,
        CncToPlc,
        "20.3.2",
        text(
            "Axes being shifted, a bit an axis; valid while ACT_ESHIFT is 1.",
            "Právě posouvané osy, bit na osu; platí při ACT_ESHIFT rovném 1.",
        ),
    ),
    (
        "SHIFT_X",
        Shape::Array(Prefix::Dwrd, AXES),
        CncToPlc,
        "20.2.2",
        text(
            "Independent shift of the axes in 1/8 µm; X is element 0.",
            "Nezávislé posunutí os v 1/8 µm; X je prvek 0.",
        ),
    ),
    (
        "SHIFT_Y",
        Shape::Within(4, Prefix::Dwrd),
        CncToPlc,
        "20.2.2",
        text("Independent shift of axis Y in 1/8 µm.", "Nezávislé posunutí osy Y v 1/8 µm."),
    ),
    (
        "SHIFT_Z",
        Shape::Within(8, Prefix::Dwrd),
        CncToPlc,
        "20.2.2",
        text("Independent shift of axis Z in 1/8 µm.", "Nezávislé posunutí osy Z v 1/8 µm."),
    ),
    (
        "SHIFT_4",
        Shape::Within(12, Prefix::Dwrd),
        CncToPlc,
        "20.2.2",
        text("Independent shift of axis 4 in 1/8 µm.", "Nezávislé posunutí osy 4 v 1/8 µm."),
    ),
    (
        "SHIFT_5",
        Shape::Within(16, Prefix::Dwrd),
        CncToPlc,
        "20.2.2",
        text("Independent shift of axis 5 in 1/8 µm.", "Nezávislé posunutí osy 5 v 1/8 µm."),
    ),
    (
        "SHIFT_6",
        Shape::Within(20, Prefix::Dwrd),
        CncToPlc,
        "20.2.2",
        text("Independent shift of axis 6 in 1/8 µm.", "Nezávislé posunutí osy 6 v 1/8 µm."),
    ),
];
