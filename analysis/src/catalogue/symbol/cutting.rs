//! Constant cutting speed under the program's control and non-linear corrections (manual 23.1.3 and 23.2).

use super::Direction::{CncToPlc, PlcToCnc};
use super::space::{BYTE, DWORD, Row, Shape, WORD};
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "AKRR_ACT_V",
        DWORD,
        CncToPlc,
        "23.1.3",
        text("Constant cutting speed in force, mm/min.", "Platná konstantní řezná rychlost v mm/min."),
    ),
    (
        "AKRR_ACT_SMAX",
        DWORD,
        CncToPlc,
        "23.1.3",
        text("Greatest spindle speed in force, 1/1000 rev/min.", "Platné maximální otáčky v 1/1000 ot/min."),
    ),
    (
        "AKRR_ACT_DIST",
        DWORD,
        CncToPlc,
        "23.1.3",
        text("Correction of the radius in force, 1/8 µm.", "Platná korekce poloměru v 1/8 µm."),
    ),
    (
        "AKRR_ACT_VCORR",
        DWORD,
        CncToPlc,
        "23.1.3",
        text("Correction of the cutting speed in force, mm/min.", "Platná korekce řezné rychlosti v mm/min."),
    ),
    ("AKRR_ACT_R", DWORD, CncToPlc, "23.1.3", text("Radius in force, 1/8 µm.", "Platný poloměr v 1/8 µm.")),
    (
        "AKRR_ACT_P",
        DWORD,
        CncToPlc,
        "23.1.3",
        text(
            "Greatest speed of the gear in force, 1/1000 rev/min.",
            "Platné maximální otáčky převodového stupně v 1/1000 ot/min.",
        ),
    ),
    (
        "AKRR_ACT_U",
        DWORD,
        CncToPlc,
        "23.1.3",
        text(
            "Voltage range of the gear in force, 0 to 7FFFh.",
            "Platný rozsah napětí převodového stupně, 0 až 7FFFh.",
        ),
    ),
    (
        "AKRR_ACT_S",
        DWORD,
        CncToPlc,
        "23.1.3",
        text(
            "Spindle speed computed for the cutting speed, 1/1000 rev/min.",
            "Otáčky vypočtené pro řeznou rychlost v 1/1000 ot/min.",
        ),
    ),
    (
        "AKRR_ACT_OUT",
        DWORD,
        CncToPlc,
        "23.1.3",
        text(
            "Voltage computed for the cutting speed, 0 to 7FFFh.",
            "Napětí vypočtené pro řeznou rychlost, 0 až 7FFFh.",
        ),
    ),
    (
        "AKRR_V",
        DWORD,
        PlcToCnc,
        "23.1.3",
        text(
            "Cutting speed from the program, mm/min; valid with EXT_AKRR_V.",
            "Řezná rychlost z programu v mm/min; platí s EXT_AKRR_V.",
        ),
    ),
    (
        "AKRR_SMAX",
        DWORD,
        PlcToCnc,
        "23.1.3",
        text(
            "Greatest spindle speed from the program, 1/1000 rev/min; valid with EXT_AKRR_SMAX.",
            "Maximální otáčky z programu v 1/1000 ot/min; platí s EXT_AKRR_SMAX.",
        ),
    ),
    (
        "AKRR_DIST",
        DWORD,
        PlcToCnc,
        "23.1.3",
        text(
            "Correction of the radius from the program, 1/8 µm; valid with EXT_AKRR_DIST.",
            "Korekce poloměru z programu v 1/8 µm; platí s EXT_AKRR_DIST.",
        ),
    ),
    (
        "AKRR_VCORR",
        DWORD,
        PlcToCnc,
        "23.1.3",
        text(
            "Correction of the cutting speed from the program, mm/min; valid with EXT_AKRR_VCORR.",
            "Korekce řezné rychlosti z programu v mm/min; platí s EXT_AKRR_VCORR.",
        ),
    ),
    (
        "AKRR_P",
        DWORD,
        PlcToCnc,
        "23.1.3",
        text(
            "Greatest speed of the gear from the program, 1/1000 rev/min; valid with EXT_AKRR_P.",
            "Maximální otáčky převodového stupně z programu v 1/1000 ot/min; platí s EXT_AKRR_P.",
        ),
    ),
    (
        "AKRR_U",
        DWORD,
        PlcToCnc,
        "23.1.3",
        text(
            "Voltage range of the gear from the program, 0 to 7FFFh; valid with EXT_AKRR_U.",
            "Rozsah napětí převodového stupně z programu, 0 až 7FFFh; platí s EXT_AKRR_U.",
        ),
    ),
    (
        "AKRR_R",
        DWORD,
        PlcToCnc,
        "23.1.3",
        text(
            "Radius from the program, 1/8 µm; valid with EXT_AKRR_R.",
            "Poloměr z programu v 1/8 µm; platí s EXT_AKRR_R.",
        ),
    ),
    (
        "AKRR_CNTR",
        BYTE,
        PlcToCnc,
        "23.1.3",
        text(
            "Control byte of the constant cutting speed with the bits EXT_AKRR_.",
            "Řídicí bajt konstantní řezné rychlosti s bity EXT_AKRR_.",
        ),
    ),
    (
        "EXT_AKRR_V",
        Shape::BitOf(0),
        PlcToCnc,
        "23.1.3",
        text(
            "Cutting speed: 0 from the NC program, 1 from AKRR_V.",
            "Řezná rychlost: 0 z NC programu, 1 z AKRR_V.",
        ),
    ),
    (
        "EXT_AKRR_SMAX",
        Shape::BitOf(1),
        PlcToCnc,
        "23.1.3",
        text(
            "Greatest spindle speed: 0 from the NC program, 1 from AKRR_SMAX.",
            "Maximální otáčky: 0 z NC programu, 1 z AKRR_SMAX.",
        ),
    ),
    (
        "EXT_AKRR_DIST",
        Shape::BitOf(2),
        PlcToCnc,
        "23.1.3",
        text(
            "Correction of the radius: 0 none, 1 from AKRR_DIST.",
            "Korekce poloměru: 0 žádná, 1 z AKRR_DIST.",
        ),
    ),
    (
        "EXT_AKRR_VCORR",
        Shape::BitOf(3),
        PlcToCnc,
        "23.1.3",
        text(
            "Correction of the cutting speed: 0 none, 1 from AKRR_VCORR.",
            "Korekce řezné rychlosti: 0 žádná, 1 z AKRR_VCORR.",
        ),
    ),
    (
        "EXT_AKRR_REQ",
        Shape::BitOf(4),
        PlcToCnc,
        "23.1.3",
        text(
            "Constant cutting speed: 0 switched by the NC program (G96, G97), 1 by the PLC program.",
            "Konstantní řezná rychlost: 0 řadí ji NC program (G96, G97), 1 PLC program.",
        ),
    ),
    (
        "EXT_AKRR_SUPORT",
        Shape::BitOf(5),
        PlcToCnc,
        "23.1.3",
        text(
            "Computation: 0 for the tip of the tool, 1 without tool corrections and offsets.",
            "Výpočet: 0 na špičku nástroje, 1 bez korekcí nástroje a posunutí.",
        ),
    ),
    (
        "EXT_AKRR_P",
        Shape::BitOf(6),
        PlcToCnc,
        "23.1.3",
        text(
            "Greatest speed of the gear: 0 from the ChannelConfig, 1 from AKRR_P.",
            "Maximální otáčky převodového stupně: 0 z ChannelConfigu, 1 z AKRR_P.",
        ),
    ),
    (
        "EXT_AKRR_U",
        Shape::BitOf(7),
        PlcToCnc,
        "23.1.3",
        text(
            "Voltage range of the gear: 0 from the ChannelConfig, 1 from AKRR_U.",
            "Rozsah napětí převodového stupně: 0 z ChannelConfigu, 1 z AKRR_U.",
        ),
    ),
    (
        "EXT_AKRR_R",
        Shape::Bit,
        PlcToCnc,
        "23.1.3",
        text(
            "Radius: 0 from the control, 1 from AKRR_R; bit 0 of the byte behind AKRR_CNTR (this implementation).",
            "Poloměr: 0 ze systému, 1 z AKRR_R; bit 0 bajtu za AKRR_CNTR (tato implementace).",
        ),
    ),
    (
        "NlcSysServoEnable",
        WORD,
        CncToPlc,
        "23.2",
        text(
            "Non-linear corrections enabled by the control, one bit a servo loop (this implementation).",
            "Nelineární korekce povolené systémem, jeden bit na servosmyčku (tato implementace).",
        ),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::entry::Prefix;
    use crate::catalogue::{SystemKind, symbol};

    #[test]
    fn there_are_nine_states_seven_inputs_and_nine_control_bits() {
        let count = |test: fn(&str) -> bool| ROWS.iter().filter(|row| test(row.0)).count();
        assert_eq!(count(|name| name.starts_with("AKRR_ACT_")), 9);
        assert_eq!(count(|name| name.starts_with("AKRR_") && !name.starts_with("AKRR_ACT_")), 7 + 1);
        assert_eq!(count(|name| name.starts_with("EXT_AKRR_")), 9);
    }

    #[test]
    fn the_ninth_control_bit_lies_behind_the_control_byte() {
        let kind = |name: &str| symbol(name).map(|symbol| symbol.kind);
        let Some(SystemKind::Cell { addr, prefix: Prefix::Byte }) = kind("AKRR_CNTR") else {
            panic!("{:?}", kind("AKRR_CNTR"));
        };
        assert_eq!(kind("EXT_AKRR_V"), Some(SystemKind::Bit { addr, bit: 0 }));
        assert_eq!(kind("EXT_AKRR_U"), Some(SystemKind::Bit { addr, bit: 7 }));
        assert_eq!(kind("EXT_AKRR_R"), Some(SystemKind::Bit { addr: addr + 1, bit: 0 }));
    }

    #[test]
    fn the_other_name_of_the_axis_enable_is_the_same_cell() {
        let kind = |name: &str| symbol(name).map(|symbol| symbol.kind);
        assert_eq!(kind("NELKOR_FLAG"), kind("NlcAxisEnable"));
        assert!(kind("NELKOR_FLAG").is_some());
    }
}
