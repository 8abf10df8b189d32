//! Chapter 3.11: time blocks, timers and counters.

use super::entry::{Effect, Entry, Equation, OperandKind, TimeUnit};
use super::pattern::{COUNTER, INSTRUCTION, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DFTM01",
        chapter: "3.11",
        forms: &[form("DFTM01 end")],
        operands: &[operand(
            "end",
            OperandKind::Label,
            "Label that ends the block",
            "Návěští, kterým blok končí",
        )],
        summary: text(
            "Opens a block that runs only once in 0.1 s.",
            "Otevře blok, který se provádí jen jednou za 0,1 s.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "DFTM1",
        chapter: "3.11",
        forms: &[form("DFTM1 end")],
        operands: &[operand(
            "end",
            OperandKind::Label,
            "Label that ends the block",
            "Návěští, kterým blok končí",
        )],
        summary: text(
            "Opens a block that runs only once in 1 s.",
            "Otevře blok, který se provádí jen jednou za 1 s.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "DFTM10",
        chapter: "3.11",
        forms: &[form("DFTM10 end")],
        operands: &[operand(
            "end",
            OperandKind::Label,
            "Label that ends the block",
            "Návěští, kterým blok končí",
        )],
        summary: text(
            "Opens a block that runs only once in 10 s.",
            "Otevře blok, který se provádí jen jednou za 10 s.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "DFTM100",
        chapter: "3.11",
        forms: &[form("DFTM100 end")],
        operands: &[operand(
            "end",
            OperandKind::Label,
            "Label that ends the block",
            "Návěští, kterým blok končí",
        )],
        summary: text(
            "Opens a block that runs only once in 100 s.",
            "Otevře blok, který se provádí jen jednou za 100 s.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "TM",
        chapter: "3.11",
        forms: &[form("TM count"), form("TM [TYPE.]count"), form("TM TYPE.(count+n)"), form("TM -")],
        operands: &[operand(
            "count",
            OperandKind::AutoCounter,
            "BYTE or WORD counter; `-` makes an automatic one",
            "Čítač typu BYTE nebo WORD; `-` vytvoří automatický",
        )
        .or_dash()],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        time_unit: Some(TimeUnit::Raster),
        summary: text(
            "On-delay timer: RLO becomes 1 after it has been 1 for DR passes of the time block.",
            "Časovač se zpožděním: RLO bude 1, až když trvá 1 po dobu DR průchodů časovým blokem.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "CU",
        chapter: "3.11",
        forms: &[form("CU count")],
        operands: &[operand("count", COUNTER, "BYTE or WORD counter", "Čítač typu BYTE nebo WORD")],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Counts rising edges of RLO up and compares the count with DR.",
            "Čítá náběžné hrany RLO nahoru a porovná stav čítače s DR.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "CD",
        chapter: "3.11",
        forms: &[form("CD count")],
        operands: &[operand("count", COUNTER, "BYTE or WORD counter", "Čítač typu BYTE nebo WORD")],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Counts rising edges of RLO down and compares the count with DR.",
            "Čítá náběžné hrany RLO dolů a porovná stav čítače s DR.",
        ),
        ..INSTRUCTION
    },
    Entry {
        name: "CUBCD",
        chapter: "3.11",
        forms: &[form("CUBCD count")],
        operands: &[operand("count", COUNTER, "BYTE or WORD counter", "Čítač typu BYTE nebo WORD")],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Counts rising edges of RLO up in BCD and compares the count with DR.",
            "Čítá náběžné hrany RLO nahoru v kódu BCD a porovná stav čítače s DR.",
        ),
        ..INSTRUCTION
    },
];
