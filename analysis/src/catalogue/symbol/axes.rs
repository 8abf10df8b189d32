//! One bit an axis: motion enable, requests, couplings, switches (manual 8.1).

use super::Direction::{Both, CncToPlc, PlcToCnc};
use super::space::AxisBits;
use crate::catalogue::pattern::text;

/// Axes of the control.
const AXES: u32 = 16;
/// Axes of the older interface.
const OLD_AXES: u32 = 6;

const NO_CELLS: (Option<&str>, Option<&str>) = (None, None);

/// In the order of their addresses.
pub(super) const FAMILIES: &[AxisBits] = &[
    AxisBits {
        before: "MP",
        after: "PI",
        axes: AXES,
        cells: (Some("BZH08PI"), Some("BZH08PI2")),
        direction: PlcToCnc,
        chapter: "8.1.4",
        summary: text("Motion enable by the program", "Povolení pohybu od programu"),
    },
    AxisBits {
        before: "MP",
        after: "MAN",
        axes: AXES,
        cells: (Some("BZH08MAN"), Some("BZH08MAN2")),
        direction: PlcToCnc,
        chapter: "8.1.5",
        summary: text("Motion enable for manual jog", "Povolení pohybu pro ruční pojezdy"),
    },
    AxisBits {
        before: "MP",
        after: "",
        axes: OLD_AXES,
        cells: NO_CELLS,
        direction: CncToPlc,
        chapter: "8.1.6",
        summary: text("Resulting motion enable", "Výsledné povolení pohybu"),
    },
    AxisBits {
        before: "PO_OS",
        after: "PI",
        axes: AXES,
        cells: (Some("PB20PI"), Some("PB20PI2")),
        direction: CncToPlc,
        chapter: "8.1.7",
        summary: text("Motion requested", "Požadavek na pohyb"),
    },
    AxisBits {
        before: "SM_PO",
        after: "PI",
        axes: AXES,
        cells: (Some("PB20PIS"), None),
        direction: CncToPlc,
        chapter: "8.1.8",
        summary: text("Direction of motion, 1 negative", "Směr pohybu, 1 záporný"),
    },
    AxisBits {
        before: "VAZBA_",
        after: "",
        axes: AXES,
        cells: (Some("VAZBAPI"), Some("VAZBAPI2")),
        direction: PlcToCnc,
        chapter: "8.1.9",
        summary: text("Position loop closed", "Uzavřená polohová vazba"),
    },
    AxisBits {
        before: "POLOHV_",
        after: "",
        axes: AXES,
        cells: (Some("POLOHV"), Some("POLOHVPI2")),
        direction: Both,
        chapter: "8.1.10",
        summary: text("Positioning to the zero pulse", "Polohování na nulový pulz"),
    },
    AxisBits {
        before: "EXM_",
        after: "0",
        axes: OLD_AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.11",
        summary: text("Request for jog in positive direction", "Žádost o ruční pohyb v kladném směru"),
    },
    AxisBits {
        before: "EXM_",
        after: "1",
        axes: OLD_AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.11",
        summary: text("Request for jog in negative direction", "Žádost o ruční pohyb v záporném směru"),
    },
    AxisBits {
        before: "KR",
        after: "",
        axes: AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.23",
        summary: text("Reference switch", "Referenční spínač"),
    },
    AxisBits {
        before: "KRR",
        after: "",
        axes: AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.23",
        summary: text("Reversing reference switch", "Reverzační referenční spínač"),
    },
    AxisBits {
        before: "ZPR",
        after: "",
        axes: AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.23",
        summary: text("Slow-down switch of the reference run", "Zpomalovací spínač reference"),
    },
    AxisBits {
        before: "KH",
        after: "0",
        axes: AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.24",
        summary: text("Limit switch in positive direction", "Koncový spínač v kladném směru"),
    },
    AxisBits {
        before: "KH",
        after: "1",
        axes: AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.24",
        summary: text("Limit switch in negative direction", "Koncový spínač v záporném směru"),
    },
    AxisBits {
        before: "ZP",
        after: "0",
        axes: AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.24",
        summary: text("Slow-down limit switch, first", "První zpomalovací koncový spínač"),
    },
    AxisBits {
        before: "ZP",
        after: "1",
        axes: AXES,
        cells: NO_CELLS,
        direction: PlcToCnc,
        chapter: "8.1.24",
        summary: text("Slow-down limit switch, second", "Druhý zpomalovací koncový spínač"),
    },
];
