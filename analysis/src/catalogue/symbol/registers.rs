//! Positions in status and command registers of drives and positioning units (manual 13.14.3, 13.18.1 and 19.2).
//! They have no cell of their own: `(CAN_DRIVE_STAT+2).CAN_AX_ENBLD` is the bit of the second axis.

use super::Direction::{self, Both, CncToPlc, PlcToCnc};
use super::space::symbol;
use super::{SystemKind, SystemSymbol, generated};
use crate::catalogue::entry::Bilingual;
use crate::catalogue::pattern::text;

/// Positions in one byte.
struct Register {
    /// Which byte.
    place: Bilingual,
    direction: Direction,
    chapter: &'static str,
    /// Number, name, meaning.
    bits: &'static [(u8, &'static str, Bilingual)],
}

const REGISTERS: &[Register] = &[
    Register {
        place: text(
            "Position in CAN_DRIVE_STAT (Kollmorgen, Berger-Lahr)",
            "Pozice v CAN_DRIVE_STAT (Kollmorgen, Berger-Lahr)",
        ),
        direction: CncToPlc,
        chapter: "13.14.3",
        bits: &[
            (0, "CAN_AX_READY", text("ready to be switched on", "pohon připraven k zapnutí")),
            (1, "CAN_AX_ON", text("switched on", "pohon zapnut")),
            (2, "CAN_AX_ENBLD", text("operation enabled", "pohon uvolněn")),
            (3, "CAN_AX_FAULT", text("fault of the drive", "porucha pohonu")),
            (4, "CAN_AX_VOLTAGE", text("voltage is disabled", "napětí odpojeno")),
            (5, "CAN_AX_QSTOP", text("0 while the quick stop acts", "hodnota 0 při rychlém zastavení")),
            (6, "CAN_AX_BRKD", text("switching on is blocked, braked", "zapnutí blokováno, zabrzděno")),
            (7, "CAN_AX_WARN", text("warning", "výstraha")),
        ],
    },
    Register {
        place: text(
            "Position in the first byte of CAN_DRIVE_MSTAT (Kollmorgen, Berger-Lahr)",
            "Pozice v první slabice CAN_DRIVE_MSTAT (Kollmorgen, Berger-Lahr)",
        ),
        direction: CncToPlc,
        chapter: "13.14.3",
        bits: &[
            (0, "CAN_WRN_I2T", text("I²t threshold exceeded", "překročen práh I²t")),
            (1, "CAN_WRN_BALLAST", text("ballast at full power", "brzdný odpor na plném výkonu")),
            (2, "CAN_WRN_FOLLOW", text("following error too large", "příliš velká polohová odchylka")),
            (3, "CAN_WRN_RESP", text("response monitoring acts", "zasáhla kontrola odezvy")),
            (4, "CAN_WRN_POWER", text("a supply phase is missing", "chybí fáze napájení")),
            (
                5,
                "CAN_WRN_LIMIT1",
                text("software limit switch 1 acts", "aktivní softwarový koncový spínač 1"),
            ),
            (
                6,
                "CAN_WRN_LIMIT2",
                text("software limit switch 2 acts", "aktivní softwarový koncový spínač 2"),
            ),
            (7, "CAN_WRN_MOTION", text("a faulty motion task was started", "spuštěna chybná pohybová úloha")),
        ],
    },
    Register {
        place: text(
            "Position in the second byte (+1) of CAN_DRIVE_MSTAT (Kollmorgen, Berger-Lahr)",
            "Pozice v druhé slabice (+1) CAN_DRIVE_MSTAT (Kollmorgen, Berger-Lahr)",
        ),
        direction: CncToPlc,
        chapter: "13.14.3",
        bits: &[
            (
                0,
                "CAN_WRN_MOTREF",
                text("motion task started without a reference", "pohybová úloha spuštěna bez reference"),
            ),
            (1, "CAN_WRN_PSTOP", text("PSTOP acts", "aktivní PSTOP")),
            (2, "CAN_WRN_NSTOP", text("NSTOP acts", "aktivní NSTOP")),
            (3, "CAN_WRN_DEF", text("default motor data were loaded", "načtena výchozí data motoru")),
            (
                4,
                "CAN_WRN_BOARD",
                text("the expansion card does not work", "rozšiřující karta nepracuje správně"),
            ),
            (5, "CAN_WRN_PHASE", text("motor phase", "fáze motoru")),
            (6, "CAN_WRN_VCT", text("wrong VCT entry selected", "zvolena chybná položka VCT")),
        ],
    },
    Register {
        place: text(
            "Position in CAN_DRIVE_CMD (Kollmorgen, Berger-Lahr)",
            "Pozice v CAN_DRIVE_CMD (Kollmorgen, Berger-Lahr)",
        ),
        direction: PlcToCnc,
        chapter: "13.14.3",
        bits: &[
            (
                0,
                "CAN_AX_EN",
                text(
                    "enable the drive; acts while CAN_AX_BRK is 0",
                    "uvolnění pohonu; působí, jen když je CAN_AX_BRK 0",
                ),
            ),
            (1, "CAN_AX_BRK", text("brake the drive; cancels the enable", "zabrzdění pohonu; ruší uvolnění")),
        ],
    },
    Register {
        place: text("Position in CAN_DRIVE_STAT (Unidrive)", "Pozice v CAN_DRIVE_STAT (Unidrive)"),
        direction: CncToPlc,
        chapter: "13.14.3",
        bits: &[
            (0, "CAN_UAX_HEALTY", text("drive without fault (10.01)", "pohon bez poruchy (10.01)")),
            (1, "CAN_UAX_RUN", text("drive runs (10.02)", "pohon běží (10.02)")),
            (2, "CAN_UAX_ZERO", text("zero speed (10.03)", "nulové otáčky (10.03)")),
            (
                3,
                "CAN_UAX_RUNBEL",
                text("at or below minimum speed (10.04)", "na minimálních otáčkách nebo pod nimi (10.04)"),
            ),
            (4, "CAN_UAX_BELOW", text("below the set speed (10.05)", "pod zadanými otáčkami (10.05)")),
            (5, "CAN_UAX_AT", text("at the set speed (10.06)", "na zadaných otáčkách (10.06)")),
            (6, "CAN_UAX_ABOVE", text("above the set speed (10.07)", "nad zadanými otáčkami (10.07)")),
            (7, "CAN_UAX_LOAD", text("load reached (10.08)", "dosaženo zatížení (10.08)")),
        ],
    },
    Register {
        place: text(
            "Position in the first byte of CAN_DRIVE_CMD (Unidrive)",
            "Pozice v první slabice CAN_DRIVE_CMD (Unidrive)",
        ),
        direction: PlcToCnc,
        chapter: "13.14.3",
        bits: &[
            (
                0,
                "CAN_UAX_EN",
                text(
                    "enable the drive (6.15); masked by CAN_UAX_M0",
                    "uvolnění pohonu (6.15); maskuje CAN_UAX_M0",
                ),
            ),
            (
                1,
                "CAN_UAX_SEQ0",
                text("sequencing bit 0, brake (6.30)", "sekvenční bit 0, povel brzdy (6.30)"),
            ),
            (2, "CAN_UAX_SEQ1", text("sequencing bit 1 (6.31)", "sekvenční bit 1 (6.31)")),
            (3, "CAN_UAX_SEQ2", text("sequencing bit 2 (6.32)", "sekvenční bit 2 (6.32)")),
            (4, "CAN_UAX_TRIP", text("trips the drive (tr52)", "vyvolá poruchu pohonu (tr52)")),
            (5, "CAN_UAX_SET0", text("parameter 1.45", "parametr 1.45")),
            (6, "CAN_UAX_SET1", text("parameter 1.46", "parametr 1.46")),
            (7, "CAN_UAX_APP1", text("application bit (18.31)", "aplikační bit (18.31)")),
        ],
    },
    Register {
        place: text(
            "Position in the second byte (+1) of CAN_DRIVE_CMD (Unidrive)",
            "Pozice v druhé slabice (+1) CAN_DRIVE_CMD (Unidrive)",
        ),
        direction: PlcToCnc,
        chapter: "13.14.3",
        bits: &[
            (0, "CAN_UAX_APP2", text("application bit (18.32)", "aplikační bit (18.32)")),
            (1, "CAN_UAX_M0", text("mask of bit 0 (6.15)", "maska bitu 0 (6.15)")),
            (2, "CAN_UAX_M1", text("mask of bit 1 (6.30)", "maska bitu 1 (6.30)")),
            (3, "CAN_UAX_M2", text("mask of bit 2 (6.31)", "maska bitu 2 (6.31)")),
            (4, "CAN_UAX_M3", text("mask of bit 3 (6.32)", "maska bitu 3 (6.32)")),
            (5, "CAN_UAX_APP3", text("application bit (18.33)", "aplikační bit (18.33)")),
            (6, "CAN_UAX_M5", text("mask of bit 5 (1.45)", "maska bitu 5 (1.45)")),
            (7, "CAN_UAX_M6", text("mask of bit 6 (1.46)", "maska bitu 6 (1.46)")),
        ],
    },
    Register {
        place: text("Position in the CoE control word (6040h)", "Pozice v řídicím slově CoE (6040h)"),
        direction: Both,
        chapter: "13.18.1",
        bits: &[
            (0, "CoE_CNT_ON", text("switch on", "zapnutí")),
            (1, "CoE_CNT_VOLT", text("enable voltage", "povolení napětí")),
            (2, "CoE_CNT_QSTOP", text("quick stop", "rychlé zastavení")),
            (3, "CoE_CNT_ENABLE", text("enable operation", "povolení provozu")),
            (4, "CoE_CNT_M0", text("first bit of the operating mode", "první bit pracovního režimu")),
            (5, "CoE_CNT_M1", text("second bit of the operating mode", "druhý bit pracovního režimu")),
            (6, "CoE_CNT_M2", text("third bit of the operating mode", "třetí bit pracovního režimu")),
            (7, "CoE_CNT_FAULT", text("fault reset", "nulování poruchy")),
        ],
    },
    Register {
        place: text("Position in the CoE status word (6041h)", "Pozice ve stavovém slově CoE (6041h)"),
        direction: CncToPlc,
        chapter: "13.18.1",
        bits: &[
            (0, "CoE_STAT_RDY", text("ready to be switched on", "připraveno k zapnutí")),
            (1, "CoE_STAT_ON", text("switched on", "zapnuto")),
            (2, "CoE_STAT_ENABLE", text("operation enabled", "provoz povolen")),
            (3, "CoE_STAT_FAULT", text("fault", "porucha")),
            (4, "CoE_STAT_VOLT", text("voltage enabled", "napětí povoleno")),
            (5, "CoE_STAT_QSTOP", text("quick stop", "rychlé zastavení")),
            (6, "CoE_STAT_DIS", text("switching on is blocked", "zapnutí blokováno")),
            (7, "CoE_STAT_WARN", text("warning", "výstraha")),
        ],
    },
    Register {
        place: text(
            "Position in the first status byte of a positioning unit",
            "Pozice v první stavové slabice polohovací jednotky",
        ),
        direction: CncToPlc,
        chapter: "19.2",
        bits: &[
            (0, "POS_STV_JEDE", text("the axis moves", "osa je v pohybu")),
            (1, "POS_STV_SMER", text("direction, 1 negative", "směr pohybu, 1 záporný")),
            (2, "POS_STV_REF", text("reference reached", "reference dosažena")),
            (3, "POS_STV_POL", text("requested position reached", "žádaná poloha dosažena")),
        ],
    },
    Register {
        place: text(
            "Position in the second status byte of a positioning unit",
            "Pozice v druhé stavové slabice polohovací jednotky",
        ),
        direction: CncToPlc,
        chapter: "19.2",
        bits: &[
            (
                0,
                "POS_STV_DISP",
                text(
                    "the unit is taken, from POS_INIT to POS_RESET",
                    "jednotka je přidělena, od POS_INIT do POS_RESET",
                ),
            ),
            (1, "POS_STV_PROG", text("a motion is programmed", "pohyb je naprogramován")),
            (2, "POS_STV_ERR", text("error of the unit", "chyba jednotky")),
        ],
    },
    Register {
        place: text(
            "Position in the first control byte of a positioning unit",
            "Pozice v první řídicí slabice polohovací jednotky",
        ),
        direction: Both,
        chapter: "19.2",
        bits: &[
            (
                0,
                "POS_CNT_G90",
                text("absolute programming, without effect", "absolutní programování, bez účinku"),
            ),
            (1, "POS_CNT_REF", text("reference, without effect", "reference, bez účinku")),
            (2, "POS_CNT_PSEU", text("pseudo-reference, without effect", "pseudoreference, bez účinku")),
            (
                3,
                "POS_CNT_NULRF",
                text("clearing the reference, without effect", "nulování reference, bez účinku"),
            ),
        ],
    },
    Register {
        place: text(
            "Position in the second control byte of a positioning unit",
            "Pozice v druhé řídicí slabice polohovací jednotky",
        ),
        direction: Both,
        chapter: "19.2",
        bits: &[
            (
                0,
                "POS_CNT_MP",
                text("motion is allowed; 0 stops with a ramp", "pohyb povolen; 0 zastaví po rampě"),
            ),
            (1, "POS_CNT_RESET", text("reset of the unit", "nulování jednotky")),
            (2, "POS_CNT_INIC", text("starts the motion", "start pohybu")),
            (3, "POS_CNT_CONT", text("lets the motion go on", "pokračování pohybu")),
        ],
    },
];

pub(super) fn list(symbols: &mut Vec<SystemSymbol>) {
    for register in REGISTERS {
        let Register { place, direction, chapter, bits } = register;
        symbols.extend(bits.iter().map(|&(bit, name, meaning)| {
            let summary = Bilingual {
                en: generated(format!("{}: {}.", place.en, meaning.en)),
                cs: generated(format!("{}: {}.", place.cs, meaning.cs)),
            };
            symbol(name, SystemKind::FormalBit { bit }, *direction, chapter, summary)
        }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_register_names_each_of_its_bits_once() {
        for register in REGISTERS {
            for (index, (bit, name, _)) in register.bits.iter().enumerate() {
                assert_eq!(usize::from(*bit), index, "{name}");
            }
        }
    }

    #[test]
    fn positions_have_the_numbers_of_the_manual() {
        for (name, bit) in [
            ("CAN_AX_ENBLD", 2),
            ("CAN_WRN_MOTREF", 0),
            ("CAN_UAX_M6", 7),
            ("COE_STAT_DIS", 6),
            ("POS_STV_POL", 3),
            ("POS_CNT_CONT", 3),
        ] {
            let kind = crate::catalogue::symbol(name).map(|symbol| symbol.kind);
            assert_eq!(kind, Some(SystemKind::FormalBit { bit }), "{name}");
        }
    }
}
