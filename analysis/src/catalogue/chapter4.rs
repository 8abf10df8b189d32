//! Chapter 4: mechanisms and the instructions that hold a sequence.

use super::entry::{Effect, Entry, OperandKind, Place, Prefix, PrefixSet, TimeUnit};
use super::pattern::{INSTRUCTION, STRUCTURE, VALUES, WAITING, form, operand, source, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "MECH_BEGIN",
        chapter: "4.2",
        forms: &[form("MECH_BEGIN mech")],
        operands: &[operand(
            "mech",
            OperandKind::Mechanism { declares: true },
            "Name of the mechanism and of its activation bit",
            "Jméno mechanizmu a jeho aktivačního bitu",
        )],
        place: Place::MechanismHost,
        reads: &[Effect::Memory],
        summary: text(
            "Begins a mechanism, a sequence that runs while its activation bit is 1.",
            "Začátek mechanizmu, tedy sekvence, která běží, dokud je její aktivační bit 1.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MECH_END",
        chapter: "4.2",
        forms: &[form("MECH_END mech")],
        operands: &[operand(
            "mech",
            OperandKind::Mechanism { declares: false },
            "The name given at MECH_BEGIN",
            "Jméno uvedené u MECH_BEGIN",
        )],
        place: Place::MechanismHost,
        writes: &[Effect::Memory],
        summary: text(
            "Ends a mechanism; reaching it clears the activation bit.",
            "Konec mechanizmu; jeho dosažení vynuluje aktivační bit.",
        ),
        ..STRUCTURE
    },
    Entry {
        name: "MECH_INIT",
        chapter: "4.2",
        forms: &[form("MECH_INIT mech")],
        operands: &[operand(
            "mech",
            OperandKind::Mechanism { declares: false },
            "Mechanism of any file",
            "Mechanizmus z kteréhokoli souboru",
        )],
        writes: &[Effect::Memory],
        summary: text(
            "Puts a mechanism at rest and back to its beginning.",
            "Uvede mechanizmus do klidu a vrátí ho na začátek.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "EX",
        forms: &[form("EX")],
        summary: text("Holds the sequence for one cycle.", "Pozastaví sekvenci na jeden cyklus."),
        ..WAITING
    },
    Entry {
        name: "EX0",
        forms: &[form("EX0")],
        reads: &[Effect::Rlo],
        summary: text("Holds the sequence while RLO is 0.", "Drží sekvenci, dokud je RLO 0."),
        ..WAITING
    },
    Entry {
        name: "EX1",
        forms: &[form("EX1")],
        reads: &[Effect::Rlo],
        summary: text("Holds the sequence while RLO is 1.", "Drží sekvenci, dokud je RLO 1."),
        ..WAITING
    },
    Entry {
        name: "BEX",
        forms: &[form("BEX")],
        summary: text(
            "Marks where a following wait evaluates its condition again, without holding the sequence.",
            "Označí místo, od kterého následující čekání znovu vyhodnocuje podmínku; sekvenci nedrží.",
        ),
        ..WAITING
    },
    Entry {
        name: "TEX0",
        forms: &[
            form("TEX0 count, time, error [,code]"),
            form("TEX0 [TYPE.]count, time, error [,code]"),
            form("TEX0 TYPE.(count+n), (time+m), error [,code]"),
            form("TEX0 -, time, error [,code]"),
            form("TEX0 NIL, time, error [,code]"),
        ],
        operands: &[
            operand(
                "count",
                OperandKind::AutoCounter,
                "BYTE or WORD counter; `-` or NIL makes an automatic one",
                "Čítač typu BYTE nebo WORD; `-` nebo NIL vytvoří automatický",
            )
            .or_dash(),
            operand(
                "time",
                OperandKind::Time,
                "Longest wait in cycles: number, EQUI constant, or BYTE or WORD cell",
                "Nejdelší čekání v cyklech: číslo, konstanta EQUI nebo buňka BYTE či WORD",
            ),
            operand(
                "error",
                OperandKind::Label,
                "Label to continue at when the time runs out",
                "Návěští, na kterém se pokračuje po vypršení času",
            ),
            operand(
                "code",
                source(PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Cnst, Prefix::Dwrd]), VALUES),
                "Value left in DR at that jump, usually the number of a message",
                "Hodnota, která při tomto skoku zůstane v DR, obvykle číslo hlášení",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory, Effect::Dr64],
        time_unit: Some(TimeUnit::Cycle),
        summary: text(
            "Holds the sequence while RLO is 0, at most for a given time.",
            "Drží sekvenci, dokud je RLO 0, nejvýše však zadanou dobu.",
        ),
        ..WAITING
    },
    Entry {
        name: "TEX1",
        forms: &[
            form("TEX1 count, time, error [,code]"),
            form("TEX1 [TYPE.]count, time, error [,code]"),
            form("TEX1 TYPE.(count+n), (time+m), error [,code]"),
            form("TEX1 -, time, error [,code]"),
            form("TEX1 NIL, time, error [,code]"),
        ],
        operands: &[
            operand(
                "count",
                OperandKind::AutoCounter,
                "BYTE or WORD counter; `-` or NIL makes an automatic one",
                "Čítač typu BYTE nebo WORD; `-` nebo NIL vytvoří automatický",
            )
            .or_dash(),
            operand(
                "time",
                OperandKind::Time,
                "Longest wait in cycles: number, EQUI constant, or BYTE or WORD cell",
                "Nejdelší čekání v cyklech: číslo, konstanta EQUI nebo buňka BYTE či WORD",
            ),
            operand(
                "error",
                OperandKind::Label,
                "Label to continue at when the time runs out",
                "Návěští, na kterém se pokračuje po vypršení času",
            ),
            operand(
                "code",
                source(PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Cnst, Prefix::Dwrd]), VALUES),
                "Value left in DR at that jump, usually the number of a message",
                "Hodnota, která při tomto skoku zůstane v DR, obvykle číslo hlášení",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory, Effect::Dr64],
        time_unit: Some(TimeUnit::Cycle),
        summary: text(
            "Holds the sequence while RLO is 1, at most for a given time.",
            "Drží sekvenci, dokud je RLO 1, nejvýše však zadanou dobu.",
        ),
        ..WAITING
    },
    Entry {
        name: "TIM",
        forms: &[
            form("TIM count, time"),
            form("TIM [TYPE.]count, time"),
            form("TIM TYPE.(count+n), (time+m)"),
            form("TIM -, time"),
            form("TIM NIL, time"),
        ],
        operands: &[
            operand(
                "count",
                OperandKind::AutoCounter,
                "BYTE or WORD counter; `-` or NIL makes an automatic one",
                "Čítač typu BYTE nebo WORD; `-` nebo NIL vytvoří automatický",
            )
            .or_dash(),
            operand(
                "time",
                OperandKind::Time,
                "Delay in cycles: number, EQUI constant, or BYTE or WORD cell",
                "Prodleva v cyklech: číslo, konstanta EQUI nebo buňka BYTE či WORD",
            ),
        ],
        reads: &[Effect::Memory],
        time_unit: Some(TimeUnit::Cycle),
        summary: text("Holds the sequence for a given time.", "Pozastaví sekvenci na zadanou dobu."),
        ..WAITING
    },
];
