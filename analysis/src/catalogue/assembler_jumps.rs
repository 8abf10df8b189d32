//! Chapter 3.1: the jumps of the 80386.

use super::assembler::CHAPTER;
use super::entry::{Bilingual, Entry, OperandKind, OperandSpec};
use super::pattern::{INSTRUCTION, example, form, operand, text};

const TO_LABEL: &[OperandSpec] = &[operand(
    "label",
    OperandKind::Label,
    "Label of the same section to continue at",
    "Návěští téže sekce, na kterém se pokračuje",
)];

const JUMPED: Bilingual = text(
    "Tests the flags that the last 80386 instruction set and leaves them as they are; instructions of TECHNOL do not \
     touch them (this implementation). RLO and DR stay, and so does an open equation. The label must lie in the same \
     module, mechanism or procedure (this implementation).",
    "Testuje příznaky, které nastavila poslední instrukce 80386, a nemění je; instrukce jazyka TECHNOL se jich \
     nedotknou (tato implementace). RLO, DR ani rozpracovaná rovnice se nemění. Návěští musí ležet v témže modulu, \
     mechanismu nebo proceduře (tato implementace).",
);

/// A conditional jump: name, when it jumps.
macro_rules! jump {
    ($name:literal, $en:literal, $cs:literal) => {
        Entry {
            name: $name,
            chapter: CHAPTER,
            forms: &[form(concat!($name, " label"))],
            operands: TO_LABEL,
            summary: text(
                concat!("80386 instruction: jumps when ", $en, "."),
                concat!("Instrukce 80386: skočí, když ", $cs, "."),
            ),
            description: JUMPED,
            examples: &[example(
                concat!("        CMP  ECX,10\n        ", $name, "  DONE\n        FL   1,LAMP\nDONE:"),
                concat!("Sets LAMP unless, after comparing DR with 10, ", $en, "."),
                concat!("Nastaví LAMP, pokud po porovnání DR s 10 neplatí, že ", $cs, "."),
            )],
            related: &["CMP", "JMP", "JL1"],
            ..INSTRUCTION
        }
    };
}

/// The entries.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "JMP",
        chapter: CHAPTER,
        forms: &[form("JMP label")],
        operands: TO_LABEL,
        summary: text("80386 instruction: jumps always, as JUM.", "Instrukce 80386: skočí vždy, jako JUM."),
        description: text(
            "Continues at the label, which must lie in the same module, mechanism or procedure (this implementation). \
             RLO, DR, the flags and an open equation stay.",
            "Pokračuje na návěští, které musí ležet v témže modulu, mechanismu nebo proceduře (tato implementace). \
             RLO, DR, příznaky ani rozpracovaná rovnice se nemění.",
        ),
        examples: &[example(
            concat!("        JMP  DONE\n", "OTHER:  FL   1,LAMP\n", "DONE:"),
            "Skips the line that sets LAMP.",
            "Přeskočí řádek, který nastavuje LAMP.",
        )],
        related: &["JUM", "JE"],
        ..INSTRUCTION
    },
    jump!(
        "JCXZ",
        "CX, the lower 16 bits of DR, is 0",
        "CX, spodních 16 bitů DR, je 0 (příznaky se netestují)"
    ),
    jump!(
        "JECXZ",
        "ECX, the lower 32 bits of DR, is 0",
        "ECX, spodních 32 bitů DR, je 0 (příznaky se netestují)"
    ),
    jump!(
        "JA",
        "the first value was above the second, without signs",
        "první hodnota byla větší než druhá, bez znamének"
    ),
    jump!(
        "JAE",
        "the first value was not below the second, without signs",
        "první hodnota nebyla menší než druhá, bez znamének"
    ),
    jump!(
        "JB",
        "the first value was below the second, without signs",
        "první hodnota byla menší než druhá, bez znamének"
    ),
    jump!(
        "JBE",
        "the first value was not above the second, without signs",
        "první hodnota nebyla větší než druhá, bez znamének"
    ),
    jump!("JC", "the carry flag is 1", "příznak přenosu je 1"),
    jump!("JE", "the values were equal", "hodnoty byly stejné"),
    jump!("JG", "the first value was greater, with signs", "první hodnota byla větší, se znaménky"),
    jump!("JGE", "the first value was not less, with signs", "první hodnota nebyla menší, se znaménky"),
    jump!("JL", "the first value was less, with signs", "první hodnota byla menší, se znaménky"),
    jump!("JLE", "the first value was not greater, with signs", "první hodnota nebyla větší, se znaménky"),
    jump!(
        "JNA",
        "the first value was not above the second, without signs",
        "první hodnota nebyla větší než druhá, bez znamének"
    ),
    jump!(
        "JNAE",
        "the first value was below the second, without signs",
        "první hodnota byla menší než druhá, bez znamének"
    ),
    jump!(
        "JNB",
        "the first value was not below the second, without signs",
        "první hodnota nebyla menší než druhá, bez znamének"
    ),
    jump!(
        "JNBE",
        "the first value was above the second, without signs",
        "první hodnota byla větší než druhá, bez znamének"
    ),
    jump!("JNC", "the carry flag is 0", "příznak přenosu je 0"),
    jump!("JNE", "the values differed", "hodnoty se lišily"),
    jump!("JNG", "the first value was not greater, with signs", "první hodnota nebyla větší, se znaménky"),
    jump!("JNGE", "the first value was less, with signs", "první hodnota byla menší, se znaménky"),
    jump!("JNL", "the first value was not less, with signs", "první hodnota nebyla menší, se znaménky"),
    jump!("JNLE", "the first value was greater, with signs", "první hodnota byla větší, se znaménky"),
    jump!("JNO", "the overflow flag is 0", "příznak přetečení je 0"),
    jump!(
        "JNP",
        "the low byte of the result has an odd number of ones",
        "nejnižší bajt výsledku má lichý počet jedniček"
    ),
    jump!("JNS", "the sign flag is 0", "příznak znaménka je 0"),
    jump!("JNZ", "the result was not 0", "výsledek nebyl 0, příznak nuly tedy není nastaven"),
    jump!("JO", "the overflow flag is 1", "příznak přetečení je 1"),
    jump!(
        "JP",
        "the low byte of the result has an even number of ones",
        "nejnižší bajt výsledku má sudý počet jedniček"
    ),
    jump!(
        "JPE",
        "the low byte of the result has an even number of ones",
        "nejnižší bajt výsledku má sudý počet jedniček"
    ),
    jump!(
        "JPO",
        "the low byte of the result has an odd number of ones",
        "nejnižší bajt výsledku má lichý počet jedniček"
    ),
    jump!("JS", "the sign flag is 1", "příznak znaménka je 1"),
    jump!("JZ", "the result was 0", "výsledek byl 0, příznak nuly je tedy nastaven"),
];
