//! Chapter 19: the positioning unit, with the axis as operand.

use super::entry::{Access, Effect, Entry, OperandKind, OperandSpec};
use super::pattern::{
    AXIS, DWORD_CELL, INSTRUCTION, MESSAGE_VALUE, SOURCE_BIT, WORD_CELL, example, form, operand, source, text,
};

/// The control record of POS_MODE.
pub(super) const CONTROL: OperandSpec = operand(
    "control",
    OperandKind::Address(Access::ReadWrite),
    "First of the two bytes of the control record, two DFM one behind the other",
    "První ze dvou bajtů řídicího záznamu, dvě DFM za sebou",
);
/// The travel of POS_MODE.
pub(super) const LENGTH: OperandSpec = operand(
    "length",
    DWORD_CELL,
    "DWORD cell: travel from the present position in µm, the sign is the direction",
    "Buňka DWORD: dráha z aktuální polohy v µm, znaménko určuje směr",
);
/// The ramp of POS_MODE.
pub(super) const ACCEL: OperandSpec = operand(
    "accel",
    WORD_CELL,
    "WORD cell: slope of both ramps in mm/s²",
    "Buňka WORD: strmost obou ramp v mm/s²",
);
/// The status record of POS_CONTROL.
pub(super) const STATUS: OperandSpec = operand(
    "status",
    OperandKind::Address(Access::Write),
    "First of the two bytes of the status record, two DFM one behind the other",
    "První ze dvou bajtů stavového záznamu, dvě DFM za sebou",
);
/// The speed of POS_CONTROL.
pub(super) const FEED: OperandSpec = operand(
    "feed",
    source(MESSAGE_VALUE, MESSAGE_VALUE),
    "DWORD cell or constant: speed, whole mm/min in the upper WORD",
    "Buňka DWORD nebo konstanta: rychlost, celé mm/min v horním WORD",
);
/// The motion enable of POS_CONTROL.
pub(super) const ENABLE: OperandSpec = operand(
    "mp",
    SOURCE_BIT,
    "Bit: 1 allows the motion, 0 stops it by the ramp; without it POS_CNT_MP stays",
    "Bit: 1 pohyb povolí, 0 ho po rampě zastaví; bez něj se POS_CNT_MP nemění",
)
.or_dash();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "POS_INIT",
        chapter: "19.3",
        forms: &[form("POS_INIT axis"), form("POS_INIT axis, space")],
        operands: &[
            AXIS,
            operand(
                "space",
                OperandKind::Number { min: 0, max: 6 },
                "Space of transformations, 0 (interpolation) to 6 (machine); 5 when left out",
                "Prostor transformací 0 (interpolace) až 6 (stroj); bez zadání 5",
            )
            .or_nothing(),
        ],
        writes: &[Effect::Memory],
        summary: text("Takes an axis for the PLC program.", "Převezme osu do řízení PLC programu."),
        description: text(
            "From now on the interpolator of the NC cannot move the axis; the axis and its servo loop obey \
             the program only, until POS_RESET. The axis must be in position coupling and not in use by \
             the NC. POS_CNT_RESET is pulsed and POS_STV_DISP becomes 1. A motion that was running stops by \
             its ramp (this implementation) and cannot go on; a new POS_MODE is needed.\n\n\
             `space` says where the axis moves: 0 behind interpolation, 1 behind the transformation of the \
             program, 2 of the workpiece, 3 behind length compensation, 4 and 5 behind the shifts 1 and 2, \
             6 at the real position of the machine. Left out it is 5 (this implementation). The program \
             may hold at most 6 axes at once, of any numbers (this implementation). RLO and DR stay (this \
             implementation).",
            "Od této chvíle nemůže osou jezdit interpolátor NC; osa i její servosmyčka poslouchají jen \
             program, a to až do POS_RESET. Osa musí být v polohové vazbě a NC ji nesmí používat. Na \
             POS_CNT_RESET se vygeneruje pulz a POS_STV_DISP se nastaví na 1. Probíhající pohyb se zastaví \
             po své rampě (tato implementace) a nelze v něm pokračovat; je třeba nové POS_MODE.\n\n\
             `space` určuje, kde se osa pohybuje: 0 za interpolací, 1 za programovou transformací, 2 za \
             transformací polotovaru, 3 za délkovou korekcí, 4 a 5 za posunutím 1 a 2, 6 ve skutečné poloze \
             stroje. Bez zadání je to 5 (tato implementace). Program smí současně držet nejvýše 6 os \
             libovolných čísel (tato implementace). RLO ani DR se nemění (tato implementace).",
        ),
        errors: text(
            "POS_STV_ERR becomes 1 in the status record when the axis cannot be taken; the record is filled \
             by POS_CONTROL only.",
            "Nelze-li osu převzít, je ve stavovém záznamu POS_STV_ERR 1; záznam plní jen POS_CONTROL.",
        ),
        examples: &[example(
            concat!(
                "        POS_INIT 4\n",
                "        LOD  CNST.25000\n",
                "        STO  TRAVEL\n",
                "        POS_MODE CNT1,TRAVEL,RAMP_X,4"
            ),
            "Takes axis 4 and prepares a motion by 25 mm.",
            "Převezme 4. osu a připraví pohyb o 25 mm.",
        )],
        related: &["POS_MODE", "POS_CONTROL", "POS_RESET"],
        ..INSTRUCTION
    },
    Entry {
        name: "POS_RESET",
        chapter: "19.3",
        forms: &[form("POS_RESET axis")],
        operands: &[AXIS],
        writes: &[Effect::Memory],
        summary: text("Gives an axis back to the NC.", "Vrátí osu do řízení NC."),
        description: text(
            "Ends the work of the program with the axis: POS_CNT_RESET is pulsed, POS_STV_DISP becomes 0, \
             the axis and its servo loop belong to the NC again. Wait until the axis stands (POS_STV_JEDE \
             0); during a motion it first stops by its ramp (this implementation). The status record of \
             the program shows the change only after another POS_CONTROL. RLO and DR stay (this \
             implementation).",
            "Ukončí práci programu s osou: na POS_CNT_RESET se vygeneruje pulz, POS_STV_DISP se vynuluje a \
             osa i servosmyčka patří opět NC. Počkejte, až osa stojí (POS_STV_JEDE je 0); za pohybu se \
             nejprve zastaví po své rampě (tato implementace). Stavový záznam programu změnu ukáže až po \
             dalším POS_CONTROL. RLO ani DR se nemění (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        POS_CONTROL STAT1,SPEED,GO,4\n",
                "        LDR  X_DONE\n",
                "        EX0\n",
                "        POS_RESET 4"
            ),
            "Gives axis 4 back once it has reached its target; X_DONE is bit 3 of STAT1.",
            "Vrátí 4. osu, jakmile dojela do cíle; X_DONE je bit 3 bajtu STAT1.",
        )],
        related: &["POS_INIT", "POS_CONTROL", "EX0"],
        ..INSTRUCTION
    },
    Entry {
        name: "POS_MODE",
        chapter: "19.3",
        forms: &[form("POS_MODE control, length, accel, axis")],
        operands: &[CONTROL, LENGTH, ACCEL, AXIS],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of an axis: length and ramp.",
            "Připraví pohyb osy: délku dráhy a rampu.",
        ),
        description: text(
            "Programs the unit of an axis taken by POS_INIT and sets the demanded speed to zero: nothing \
             moves before POS_CONTROL gives a speed and enables the motion. Travel and ramp are taken over \
             when the instruction runs (this implementation). The travel is relative to the position at \
             that moment (this implementation); to run until stopped, give more than the axis can do.\n\n\
             The second byte of the control record has POS_CNT_MP (bit 0, motion enable), POS_CNT_RESET \
             (1), POS_CNT_INIC (2) and POS_CNT_CONT (3); the instructions write them, MP may also be \
             written by the program (this implementation). RLO and DR stay (this implementation).",
            "Naprogramuje jednotku osy převzaté instrukcí POS_INIT a požadovanou rychlost vynuluje: osa se \
             nepohne, dokud POS_CONTROL nezadá rychlost a nepovolí pohyb. Dráha a rampa se převezmou při \
             provedení instrukce (tato implementace). Dráha se počítá od polohy v této chvíli (tato \
             implementace); má-li osa jet až do zastavení, zadejte víc, než může ujet.\n\n\
             Druhý bajt řídicího záznamu obsahuje POS_CNT_MP (bit 0, povolení pohybu), POS_CNT_RESET (1), \
             POS_CNT_INIC (2) a POS_CNT_CONT (3); zapisují je instrukce, MP smí zapsat i program (tato \
             implementace). RLO ani DR se nemění (tato implementace).",
        ),
        errors: text(
            "Without POS_INIT nothing is programmed and POS_STV_ERR becomes 1 (this implementation). \
             POS_STV_PROG tells success.",
            "Bez POS_INIT se nic nenaprogramuje a POS_STV_ERR se nastaví na 1 (tato implementace). Úspěch \
             ohlásí POS_STV_PROG.",
        ),
        examples: &[example(
            concat!(
                "        LOD  DISTANCE\n",
                "        STO  TRAVEL\n",
                "        POS_MODE CNT1,TRAVEL,RAMP_X,1\n",
                "        FL   1,X_MP\n",
                "        EX"
            ),
            "The record is CNT1 with another DFM behind it, whose bit 0 is X_MP.",
            "Záznamem je CNT1 a za ním další DFM, jejíž bit 0 je X_MP.",
        )],
        related: &["POS_INIT", "POS_CONTROL", "POS_RESET", "DFM"],
        ..INSTRUCTION
    },
    Entry {
        name: "POS_CONTROL",
        chapter: "19.3",
        forms: &[
            form("POS_CONTROL status, feed, mp, axis"),
            form("POS_CONTROL status, feed, -, axis"),
            form("POS_CONTROL status, feed, NIL, axis"),
        ],
        operands: &[STATUS, FEED, ENABLE, AXIS],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to an axis and reads its status.",
            "Předá ose rychlost a povolení pohybu a přečte její stav.",
        ),
        description: text(
            "Everything happens only when the instruction runs: execute it in every cycle while the axis \
             moves, usually between EX and the EX0 that waits for the target. The speed may change during \
             the motion, the axis follows by its ramp. Its unit is 1/65536 mm/min, so whole mm/min are \
             written to the upper WORD of the cell; a negative speed counts as positive (this \
             implementation). `mp` 0 pauses the motion, 1 continues it; `-`, NIL or an empty place leave \
             POS_CNT_MP.\n\n\
             Status, first byte: POS_STV_JEDE (bit 0) moving, POS_STV_SMER (1) negative direction, \
             POS_STV_POL (3) target reached. Second byte: POS_STV_DISP (0) taken by the program, \
             POS_STV_PROG (1) programmed, POS_STV_ERR (2) error. It may also be used just to watch them. \
             RLO and DR stay (this implementation).",
            "Vše se děje jen při provedení instrukce: provádějte ji v každém cyklu po dobu pohybu, obvykle \
             mezi EX a EX0, které čeká na cíl. Rychlost se smí za pohybu měnit, osa ji sleduje po rampě. \
             Její jednotkou je 1/65536 mm/min, celé mm/min se tedy zapisují do horního WORD buňky; záporná \
             rychlost platí jako kladná (tato implementace). `mp` 0 pohyb přeruší, 1 v něm pokračuje; `-`, \
             NIL nebo prázdné místo POS_CNT_MP nemění.\n\n\
             Stav, první bajt: POS_STV_JEDE (bit 0) osa jede, POS_STV_SMER (1) záporný směr, POS_STV_POL \
             (3) cíl dosažen. Druhý bajt: POS_STV_DISP (0) osu drží program, POS_STV_PROG (1) \
             naprogramováno, POS_STV_ERR (2) chyba. Instrukce se hodí i k pouhému sledování. RLO ani DR se \
             nemění (tato implementace).",
        ),
        errors: text(
            "POS_STV_ERR in the status record. A motion that never ends shows only in POS_STV_POL: wait with \
             TEX0.",
            "POS_STV_ERR ve stavovém záznamu. Pohyb, který neskončí, se pozná jen podle POS_STV_POL: čekejte \
             pomocí TEX0.",
        ),
        examples: &[example(
            concat!(
                "        EX\n",
                "        LOD  CNST.0\n",
                "        STO  SPEED\n",
                "        LOD  FEED_X\n",
                "        STO  WORD.(SPEED+2)\n",
                "        POS_CONTROL STAT1,SPEED,X_MP,1\n",
                "        LDR  X_DONE\n",
                "        EX0\n",
                "        POS_RESET 1"
            ),
            "Axis 1 follows FEED_X in mm/min until the target; then the NC gets it back.",
            "Osa 1 až do cíle sleduje FEED_X v mm/min; pak ji dostane zpět NC.",
        )],
        related: &["POS_MODE", "POS_INIT", "POS_RESET", "TEX0"],
        ..INSTRUCTION
    },
];
