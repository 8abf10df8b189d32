//! Chapter 3.8: jumps.

use super::entry::{Effect, Entry, Equation, OperandKind};
use super::pattern::{INSTRUCTION, example, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "JUM",
        chapter: "3.8",
        forms: &[form("JUM label")],
        operands: &[operand(
            "label",
            OperandKind::Label,
            "Label to continue at",
            "Návěští, na kterém se pokračuje",
        )],
        summary: text("Jumps unconditionally.", "Nepodmíněný skok."),
        description: text(
            "Continues at the label, before or after the jump. The label must lie in the same module, \
             mechanism or procedure (this implementation). RLO, DR and the stack stay. JUM does not \
             close an equation; a warning tells when one is open.\n\n\
             In a mechanism a jump backwards may close an endless loop; every such loop must pass an \
             instruction that holds the sequence (EX, EX0, EX1, TEX0, TEX1, TIM). An endless loop \
             elsewhere is stopped by the watchdog as a run-time fault (this implementation).",
            "Pokračuje na návěští, které může ležet před skokem i za ním. Návěští musí být v témže \
             modulu, mechanismu nebo proceduře (tato implementace). RLO, DR ani zásobník se nemění. JUM \
             rovnici neuzavírá; na rozpracovanou upozorní varování.\n\n\
             V mechanismu smí skok zpět uzavřít nekonečnou smyčku; každá taková smyčka musí procházet \
             instrukcí, která sekvenci drží (EX, EX0, EX1, TEX0, TEX1, TIM). Nekonečnou smyčku jinde \
             zastaví hlídací obvod chybou za běhu (tato implementace).",
        ),
        examples: &[example(
            concat!("        JUM  DONE\n", "OTHER:  FL   1,LAMP\n", "DONE:"),
            "Skips the line that sets LAMP.",
            "Přeskočí řádek, který nastavuje LAMP.",
        )],
        related: &["JL0", "JL1"],
        ..INSTRUCTION
    },
    Entry {
        name: "JL0",
        chapter: "3.8",
        forms: &[form("JL0 label")],
        operands: &[operand(
            "label",
            OperandKind::Label,
            "Label to continue at when RLO is 0",
            "Návěští, na kterém se pokračuje při RLO = 0",
        )],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        summary: text("Jumps when RLO is 0.", "Skočí, když je RLO 0."),
        description: text(
            "With RLO = 0 continues at the label, otherwise at the next line. RLO, DR and the stack \
             stay, so the value just computed may be used on both ways. Terminal instruction: the next \
             LDR begins a new equation. The label must lie in the same module, mechanism or procedure \
             (this implementation).",
            "Při RLO = 0 pokračuje na návěští, jinak na dalším řádku. RLO, DR ani zásobník se nemění, \
             právě spočtenou hodnotu lze tedy použít v obou větvích. Koncová instrukce: další LDR začíná \
             novou rovnici. Návěští musí ležet v témže modulu, mechanismu nebo proceduře (tato \
             implementace).",
        ),
        examples: &[example(
            concat!("        LDR  AUTO\n", "        JL0  MANUAL\n", "        PROC_CALL CYCLE\n", "MANUAL:"),
            "The procedure is called only in automatic mode.",
            "Procedura se volá jen v automatickém režimu.",
        )],
        related: &["JL1", "JUM", "FL1"],
        ..INSTRUCTION
    },
    Entry {
        name: "JL1",
        chapter: "3.8",
        forms: &[form("JL1 label")],
        operands: &[operand(
            "label",
            OperandKind::Label,
            "Label to continue at when RLO is 1",
            "Návěští, na kterém se pokračuje při RLO = 1",
        )],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        summary: text("Jumps when RLO is 1.", "Skočí, když je RLO 1."),
        description: text(
            "With RLO = 1 continues at the label, otherwise at the next line. RLO, DR and the stack \
             stay, so the value just computed may be used on both ways. Terminal instruction: the next \
             LDR begins a new equation. The label must lie in the same module, mechanism or procedure \
             (this implementation).",
            "Při RLO = 1 pokračuje na návěští, jinak na dalším řádku. RLO, DR ani zásobník se nemění, \
             právě spočtenou hodnotu lze tedy použít v obou větvích. Koncová instrukce: další LDR začíná \
             novou rovnici. Návěští musí ležet v témže modulu, mechanismu nebo proceduře (tato \
             implementace).",
        ),
        examples: &[example(
            concat!(
                "        LOD  PRESSURE\n",
                "        LT   LIMIT\n",
                "        JL1  TOO_LOW\n",
                "        FL   0,ALARM\n",
                "TOO_LOW:"
            ),
            "Below the limit the alarm stays as it is.",
            "Pod mezí zůstane alarm, jak je.",
        )],
        related: &["JL0", "JUM", "FL1"],
        ..INSTRUCTION
    },
];
