//! Chapter 19: the older instructions of the positioning unit, one set per axis.

use super::chapter19::{ACCEL, CONTROL, ENABLE, FEED, LENGTH, STATUS};
use super::entry::{Effect, Entry, Example, Form, OperandSpec};
use super::pattern::{INSTRUCTION, WORD_CELL, operand, text};

const APPROACH: OperandSpec = operand(
    "approach",
    WORD_CELL,
    "WORD cell: speed of the final approach in mm/min, 0 none",
    "Buňka WORD: dojížděcí posuv v mm/min, 0 žádný",
);

/// POS_INIT_x of one axis: its letter or digit, its number.
macro_rules! init {
    ($axis:literal, $number:literal) => {
        Entry {
            name: concat!("POS_INIT_", $axis),
            chapter: "19.3",
            forms: &[Form { syntax: concat!("POS_INIT_", $axis) }],
            writes: &[Effect::Memory],
            summary: text(
                concat!("Takes axis ", $number, " for the PLC program."),
                concat!("Převezme ", $number, ". osu do řízení PLC programu."),
            ),
            description: text(
                concat!(
                    "Older form of `POS_INIT ", $number, "`: the NC can no longer move the axis, POS_STV_DISP \
                     becomes 1, a running motion stops and needs a new POS_MODE_", $axis, ". The space of \
                     transformations is 5 (this implementation). Used as the last line of a motion it does \
                     not give the axis back; that does POS_RESET_", $axis, ". RLO and DR stay (this \
                     implementation)."
                ),
                concat!(
                    "Starší tvar instrukce `POS_INIT ", $number, "`: NC už osou pohybovat nemůže, POS_STV_DISP \
                     se nastaví na 1, probíhající pohyb se zastaví a je třeba nové POS_MODE_", $axis, ". \
                     Prostor transformací je 5 (tato implementace). Na konci pohybu osu nevrátí; to udělá \
                     POS_RESET_", $axis, ". RLO ani DR se nemění (tato implementace)."
                ),
            ),
            errors: text(
                "POS_STV_ERR becomes 1 in the status record when the axis cannot be taken; the record is \
                 filled by POS_CONTROL only.",
                "Nelze-li osu převzít, je ve stavovém záznamu POS_STV_ERR 1; záznam plní jen POS_CONTROL.",
            ),
            examples: &[Example {
                code: concat!(
                    "        POS_INIT_", $axis, "\n",
                    "        POS_MODE_", $axis, " CNT1,TRAVEL,SLOPE,APPROACH"
                ),
                note: text(
                    "Takes the axis and prepares its motion.",
                    "Převezme osu a připraví její pohyb.",
                ),
            }],
            related: &[
                "POS_INIT",
                concat!("POS_MODE_", $axis),
                concat!("POS_CONTROL_", $axis),
                concat!("POS_RESET_", $axis),
            ],
            ..INSTRUCTION
        }
    };
}

/// POS_RESET_x of one axis.
macro_rules! reset {
    ($axis:literal, $number:literal) => {
        Entry {
            name: concat!("POS_RESET_", $axis),
            chapter: "19.3",
            forms: &[Form { syntax: concat!("POS_RESET_", $axis) }],
            writes: &[Effect::Memory],
            summary: text(
                concat!("Gives axis ", $number, " back to the NC."),
                concat!("Vrátí ", $number, ". osu do řízení NC."),
            ),
            description: text(
                concat!(
                    "Older form of `POS_RESET ", $number, "`: POS_STV_DISP becomes 0 and the axis belongs to \
                     the NC again. A motion that still runs stops by its ramp first (this implementation). \
                     RLO and DR stay (this implementation)."
                ),
                concat!(
                    "Starší tvar instrukce `POS_RESET ", $number, "`: POS_STV_DISP se vynuluje a osa patří opět \
                     NC. Pohyb, který ještě trvá, se nejprve zastaví po rampě (tato implementace). RLO ani DR \
                     se nemění (tato implementace)."
                ),
            ),
            examples: &[Example {
                code: concat!(
                    "        POS_CONTROL_", $axis, " STAT1,SPEED,GO\n",
                    "        LDR  IS_THERE\n",
                    "        EX0\n",
                    "        POS_RESET_", $axis
                ),
                note: text(
                    "Gives the axis back once it has reached its target; IS_THERE is bit 3 of STAT1.",
                    "Vrátí osu, jakmile dojela do cíle; IS_THERE je bit 3 bajtu STAT1.",
                ),
            }],
            related: &["POS_RESET", concat!("POS_INIT_", $axis), concat!("POS_CONTROL_", $axis)],
            ..INSTRUCTION
        }
    };
}

/// POS_MODE_x of one axis.
macro_rules! mode {
    ($axis:literal, $number:literal) => {
        Entry {
            name: concat!("POS_MODE_", $axis),
            chapter: "19.3",
            forms: &[Form { syntax: concat!("POS_MODE_", $axis, " control, length, accel, approach") }],
            operands: &[CONTROL, LENGTH, ACCEL, APPROACH],
            reads: &[Effect::Memory],
            writes: &[Effect::Memory],
            summary: text(
                concat!("Prepares a motion of axis ", $number, ": length, ramp and final approach."),
                concat!("Připraví pohyb ", $number, ". osy: délku dráhy, rampu a dojezd."),
            ),
            description: text(
                concat!(
                    "Older form of `POS_MODE` for axis ", $number, ". Before the target the axis slows down by \
                     the ramp to `approach` and creeps onto it; with 0 it stops by the ramp alone (this \
                     implementation). Travel and ramp are taken over when the instruction runs, the travel \
                     counts from the position at that moment (this implementation). The demanded speed \
                     becomes zero: the motion begins with POS_CONTROL_", $axis, ". RLO and DR stay (this \
                     implementation)."
                ),
                concat!(
                    "Starší tvar instrukce `POS_MODE` pro ", $number, ". osu. Před cílem osa po rampě zpomalí \
                     na `approach` a touto rychlostí do něj dojede; s 0 zastaví jen po rampě (tato \
                     implementace). Dráha a rampa se převezmou při provedení instrukce, dráha se počítá od \
                     polohy v této chvíli (tato implementace). Požadovaná rychlost se vynuluje: pohyb začne \
                     až s POS_CONTROL_", $axis, ". RLO ani DR se nemění (tato implementace)."
                ),
            ),
            errors: text(
                "POS_STV_PROG in the status record tells success, POS_STV_ERR an error.",
                "Úspěch ohlásí POS_STV_PROG ve stavovém záznamu, chybu POS_STV_ERR.",
            ),
            examples: &[Example {
                code: concat!(
                    "        POS_MODE_", $axis, " CNT1,TRAVEL,SLOPE,APPROACH\n",
                    "        EX\n",
                    "        POS_CONTROL_", $axis, " STAT1,SPEED,GO\n",
                    "        LDR  PROGRAMMED\n",
                    "        TEX0 -,25,FAULT,ERR_UNIT"
                ),
                note: text(
                    "The unit must report POS_STV_PROG, here PROGRAMMED, within half a second.",
                    "Jednotka musí do půl sekundy ohlásit POS_STV_PROG, zde PROGRAMMED.",
                ),
            }],
            related: &["POS_MODE", concat!("POS_INIT_", $axis), concat!("POS_CONTROL_", $axis)],
            ..INSTRUCTION
        }
    };
}

/// POS_CONTROL_x of one axis.
macro_rules! control {
    ($axis:literal, $number:literal) => {
        Entry {
            name: concat!("POS_CONTROL_", $axis),
            chapter: "19.3",
            forms: &[
                Form { syntax: concat!("POS_CONTROL_", $axis, " status, feed") },
                Form { syntax: concat!("POS_CONTROL_", $axis, " status, feed, mp") },
            ],
            operands: &[STATUS, FEED, ENABLE.or_nothing()],
            reads: &[Effect::Memory],
            writes: &[Effect::Memory],
            summary: text(
                concat!("Hands speed and motion enable to axis ", $number, " and reads its status."),
                concat!("Předá ", $number, ". ose rychlost a povolení pohybu a přečte její stav."),
            ),
            description: text(
                concat!(
                    "Older form of `POS_CONTROL` for axis ", $number, ", with the same records and units. \
                     Execute it in every cycle while the axis moves; the status is copied only then. Without \
                     `mp` POS_CNT_MP stays; with a zero constant as speed the instruction only reads the \
                     status. RLO and DR stay (this implementation)."
                ),
                concat!(
                    "Starší tvar instrukce `POS_CONTROL` pro ", $number, ". osu, se stejnými záznamy a \
                     jednotkami. Provádějte ji v každém cyklu po dobu pohybu; stav se kopíruje jen tehdy. Bez \
                     `mp` se POS_CNT_MP nemění; s nulovou konstantou místo rychlosti instrukce jen přečte \
                     stav. RLO ani DR se nemění (tato implementace)."
                ),
            ),
            errors: text(
                "POS_STV_ERR in the status record. A motion that never ends shows only in POS_STV_POL: wait \
                 with TEX0.",
                "POS_STV_ERR ve stavovém záznamu. Pohyb, který neskončí, se pozná jen podle POS_STV_POL: \
                 čekejte pomocí TEX0.",
            ),
            examples: &[Example {
                code: concat!(
                    "        EX\n",
                    "        LOD  PACE\n",
                    "        STO  SPEED\n",
                    "        POS_CONTROL_", $axis, " STAT1,SPEED,GO\n",
                    "        LDR  IS_THERE\n",
                    "        TEX0 -,1000,FAULT,ERR_MOTION\n",
                    "        POS_RESET_", $axis
                ),
                note: text(
                    "Moves at most 20 s, at the speed that PACE has in each cycle.",
                    "Jede nejvýše 20 s rychlostí, jakou má v každém cyklu PACE.",
                ),
            }],
            related: &["POS_CONTROL", concat!("POS_MODE_", $axis), concat!("POS_RESET_", $axis), "TEX0"],
            ..INSTRUCTION
        }
    };
}

/// The entries, axis by axis.
pub(super) static ENTRIES: &[Entry] = &[
    init!("X", "1"),
    reset!("X", "1"),
    mode!("X", "1"),
    control!("X", "1"),
    init!("Y", "2"),
    reset!("Y", "2"),
    mode!("Y", "2"),
    control!("Y", "2"),
    init!("Z", "3"),
    reset!("Z", "3"),
    mode!("Z", "3"),
    control!("Z", "3"),
    init!("4", "4"),
    reset!("4", "4"),
    mode!("4", "4"),
    control!("4", "4"),
    init!("5", "5"),
    reset!("5", "5"),
    mode!("5", "5"),
    control!("5", "5"),
    init!("6", "6"),
    reset!("6", "6"),
    mode!("6", "6"),
    control!("6", "6"),
];
