//! Speeds and gears of the spindles (manual 8.1.2, 8.1.3 and 8.1.20).

use super::Direction::{Both, CncToPlc, PlcToCnc};
use super::space::{DWORD, Row, Shape, WORD};
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "VYSOVERS",
        WORD,
        CncToPlc,
        "8.1.2",
        text(
            "Output voltage of the spindle, 0 to 7FFFh, after the override.",
            "Výstupní napětí vřetene 0 až 7FFFh po korekci.",
        ),
    ),
    (
        "REQ_SPEED_PM",
        DWORD,
        CncToPlc,
        "8.1.2",
        text("Requested speed of the spindle, 1/1000 rev/min.", "Požadované otáčky vřetene v 1/1000 ot/min."),
    ),
    (
        "REQ_SPEED_PT",
        DWORD,
        CncToPlc,
        "8.1.2",
        text(
            "Requested speed of the spindle, 1/1000 ° per tick.",
            "Požadované otáčky vřetene v 1/1000 ° za takt.",
        ),
    ),
    (
        "ACT_SPEED_PM",
        DWORD,
        CncToPlc,
        "8.1.2",
        text("Actual speed of spindle 1, 1/1000 rev/min.", "Skutečné otáčky vřetene 1 v 1/1000 ot/min."),
    ),
    (
        "ACT_SPEED_PT",
        DWORD,
        CncToPlc,
        "8.1.2",
        text(
            "Actual speed of spindle 1, 1/1000 ° per tick.",
            "Skutečné otáčky vřetene 1 v 1/1000 ° za takt.",
        ),
    ),
    (
        "ACT_SPEED2_PM",
        DWORD,
        CncToPlc,
        "8.1.2",
        text("Actual speed of spindle 2, 1/1000 rev/min.", "Skutečné otáčky vřetene 2 v 1/1000 ot/min."),
    ),
    (
        "ACT_SPEED2_PT",
        DWORD,
        CncToPlc,
        "8.1.2",
        text(
            "Actual speed of spindle 2, 1/1000 ° per tick.",
            "Skutečné otáčky vřetene 2 v 1/1000 ° za takt.",
        ),
    ),
    (
        "AVG_SPEED_PM",
        DWORD,
        CncToPlc,
        "8.1.2",
        text(
            "Filtered actual speed of spindle 1, 1/1000 rev/min.",
            "Filtrované skutečné otáčky vřetene 1 v 1/1000 ot/min.",
        ),
    ),
    (
        "AVG_SPEED_PT",
        DWORD,
        CncToPlc,
        "8.1.2",
        text(
            "Filtered actual speed of spindle 1, 1/1000 ° per tick.",
            "Filtrované skutečné otáčky vřetene 1 v 1/1000 ° za takt.",
        ),
    ),
    (
        "AVG_SPEED2_PM",
        DWORD,
        CncToPlc,
        "8.1.2",
        text(
            "Filtered actual speed of spindle 2, 1/1000 rev/min.",
            "Filtrované skutečné otáčky vřetene 2 v 1/1000 ot/min.",
        ),
    ),
    (
        "AVG_SPEED2_PT",
        DWORD,
        CncToPlc,
        "8.1.2",
        text(
            "Filtered actual speed of spindle 2, 1/1000 ° per tick.",
            "Filtrované skutečné otáčky vřetene 2 v 1/1000 ° za takt.",
        ),
    ),
    (
        "SIM_SPEED_PT",
        DWORD,
        PlcToCnc,
        "8.1.2",
        text(
            "Speed to take when the spindle is simulated, 1/1000 ° per tick.",
            "Otáčky při simulaci vřetene v 1/1000 ° za takt.",
        ),
    ),
    (
        "OTACKY_VR",
        Shape::Alias,
        PlcToCnc,
        "8.1.2",
        text("Older name of SIM_SPEED_PT.", "Starší jméno buňky SIM_SPEED_PT."),
    ),
    (
        "REQW_SPEED2_PM",
        DWORD,
        PlcToCnc,
        "8.1.2",
        text("Requested speed of spindle 2 for the screen.", "Požadované otáčky vřetene 2 pro obrazovku."),
    ),
    (
        "SPINDLE_GEAR_ACT_1",
        WORD,
        Both,
        "8.1.3",
        text("Actual gear of spindle 1, 1 to 32.", "Skutečný převodový stupeň vřetene 1, 1 až 32."),
    ),
    (
        "REQ_EXT_SPINDLE_GEAR",
        Shape::Bit,
        PlcToCnc,
        "8.1.3",
        text("The program controls the gear.", "Převodový stupeň řídí program."),
    ),
    (
        "REQ_MAN_SPINDLE_GEAR",
        Shape::Bit,
        PlcToCnc,
        "8.1.3",
        text("The gear is set by hand.", "Převodový stupeň se nastavuje ručně."),
    ),
    (
        "SPEED_OVR",
        Shape::Bit,
        PlcToCnc,
        "8.1.20",
        text(
            "1 takes the spindle override from SPEED_OVR_EXT instead of the potentiometer.",
            "Hodnota 1 bere korekci otáček z SPEED_OVR_EXT místo z potenciometru.",
        ),
    ),
    (
        "SPEED_OVR_EXT",
        WORD,
        PlcToCnc,
        "8.1.20",
        text("Spindle override in per mille.", "Korekce otáček v promile."),
    ),
    (
        "SPEED_OVR_MULTIPLIER",
        WORD,
        PlcToCnc,
        "8.1.20",
        text("Further multiplier of the spindle speed in per mille.", "Další násobitel otáček v promile."),
    ),
];
