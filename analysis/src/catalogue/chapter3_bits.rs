//! Chapters 3.5 to 3.7: logic equations over bits, and writing their result.

use super::entry::{Effect, Entry, Equation, OperandKind, Place};
use super::pattern::{
    DIRECTIVE, INSTRUCTION, NAMED_BIT, READ_BIT, SOURCE_BIT, WRITE_BIT, form, operand, text,
};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "LDR",
        chapter: "3.5",
        forms: &[form("LDR [-]bit"), form("LDR [-][ADR.]bit"), form("LDR [-]$+n.bit")],
        operands: &[
            operand("bit", READ_BIT, "Bit to read: a name, `ADR.bit` or `$+n.bit`; a leading `-` reads its negation", "Čtený bit: jméno, `ADR.bit` nebo `$+n.bit`; znaménko `-` vpředu čte negaci"),
        ],
        equation: Equation::Open,
        reads: &[Effect::Memory, Effect::Rlo],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text("Loads a bit into RLO, or pushes RLO first when an equation is open.", "Načte bit do RLO; je-li rovnice rozpracovaná, nejprve uloží RLO na zásobník."),
        ..INSTRUCTION
    },
    Entry {
        name: "LA",
        chapter: "3.6",
        forms: &[form("LA"), form("LA [-]bit"), form("LA [-][ADR.]bit"), form("LA [-]$+n.bit")],
        operands: &[
            operand("bit", READ_BIT, "Bit to read: a name, `ADR.bit` or `$+n.bit`; a leading `-` reads its negation; without it the stack is used", "Čtený bit: jméno, `ADR.bit` nebo `$+n.bit`; znaménko `-` vpředu čte negaci; bez operandu se bere zásobník").or_nothing(),
        ],
        equation: Equation::Combine,
        reads: &[Effect::Rlo, Effect::Stack, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text("ANDs RLO with a bit, or with the last value on the stack.", "Logický součin RLO s bitem nebo s poslední hodnotou na zásobníku."),
        ..INSTRUCTION
    },
    Entry {
        name: "LO",
        chapter: "3.6",
        forms: &[form("LO"), form("LO [-]bit"), form("LO [-][ADR.]bit"), form("LO [-]$+n.bit")],
        operands: &[
            operand("bit", READ_BIT, "Bit to read: a name, `ADR.bit` or `$+n.bit`; a leading `-` reads its negation; without it the stack is used", "Čtený bit: jméno, `ADR.bit` nebo `$+n.bit`; znaménko `-` vpředu čte negaci; bez operandu se bere zásobník").or_nothing(),
        ],
        equation: Equation::Combine,
        reads: &[Effect::Rlo, Effect::Stack, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text("ORs RLO with a bit, or with the last value on the stack.", "Logický součet RLO s bitem nebo s poslední hodnotou na zásobníku."),
        ..INSTRUCTION
    },
    Entry {
        name: "LX",
        chapter: "3.6",
        forms: &[form("LX"), form("LX [-]bit"), form("LX [-][ADR.]bit"), form("LX [-]$+n.bit")],
        operands: &[
            operand("bit", READ_BIT, "Bit to read: a name, `ADR.bit` or `$+n.bit`; a leading `-` reads its negation; without it the stack is used", "Čtený bit: jméno, `ADR.bit` nebo `$+n.bit`; znaménko `-` vpředu čte negaci; bez operandu se bere zásobník").or_nothing(),
        ],
        equation: Equation::Combine,
        reads: &[Effect::Rlo, Effect::Stack, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Stack],
        summary: text("XORs RLO with a bit, or with the last value on the stack.", "Nonekvivalence RLO s bitem nebo s poslední hodnotou na zásobníku."),
        ..INSTRUCTION
    },
    Entry {
        name: "CA",
        chapter: "3.6",
        forms: &[form("CA")],
        equation: Equation::Modify,
        reads: &[Effect::Rlo],
        writes: &[Effect::Rlo],
        summary: text("Negates RLO.", "Neguje RLO."),
        ..INSTRUCTION
    },
    Entry {
        name: "EDGE_H",
        chapter: "3.6",
        forms: &[form("EDGE_H bit")],
        operands: &[
            operand("bit", NAMED_BIT, "Watched bit, by its name", "Sledovaný bit, zadaný jménem"),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text("Sets RLO for one pass when the bit goes from 0 to 1.", "Nastaví RLO na jeden průchod, když bit přejde z 0 do 1."),
        ..INSTRUCTION
    },
    Entry {
        name: "EDGE_L",
        chapter: "3.6",
        forms: &[form("EDGE_L bit")],
        operands: &[
            operand("bit", NAMED_BIT, "Watched bit, by its name", "Sledovaný bit, zadaný jménem"),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text("Sets RLO for one pass when the bit goes from 1 to 0.", "Nastaví RLO na jeden průchod, když bit přejde z 1 do 0."),
        ..INSTRUCTION
    },
    Entry {
        name: "CHECK",
        chapter: "3.6",
        forms: &[form("CHECK")],
        place: Place::Code,
        summary: text("Makes the compiler check at this place that the stack is balanced and no equation is open.", "Přikáže překladači ověřit na tomto místě, že je zásobník vyvážený a žádná rovnice není rozpracovaná."),
        ..DIRECTIVE
    },
    Entry {
        name: "WR",
        chapter: "3.7",
        forms: &[form("WR bit [,bit2 …]"), form("WR [ADR.]bit [,[ADR2.]bit2 …]"), form("WR $+n.bit [,$+m.bit2 …]")],
        operands: &[
            operand("bit", WRITE_BIT, "Bit to write: a name, `ADR.bit` or `$+n.bit`", "Zapisovaný bit: jméno, `ADR.bit` nebo `$+n.bit`").repeated(),
        ],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        writes: &[Effect::Memory],
        summary: text("Writes RLO to one or more bits.", "Zapíše RLO do jednoho nebo více bitů."),
        ..INSTRUCTION
    },
    Entry {
        name: "FL",
        chapter: "3.7",
        forms: &[form("FL 0|1, bit [,bit2 …]"), form("FL 0|1, [ADR.]bit [,[ADR2.]bit2 …]"), form("FL 0|1, $+n.bit [,$+m.bit2 …]")],
        operands: &[
            operand("value", OperandKind::Number { min: 0, max: 1 }, "Value written: 0 or 1", "Zapisovaná hodnota: 0 nebo 1"),
            operand("bit", WRITE_BIT, "Bit to write: a name, `ADR.bit` or `$+n.bit`", "Zapisovaný bit: jméno, `ADR.bit` nebo `$+n.bit`").repeated(),
        ],
        writes: &[Effect::Memory],
        summary: text("Sets or clears bits unconditionally.", "Nepodmíněně nastaví nebo vynuluje bity."),
        ..INSTRUCTION
    },
    Entry {
        name: "FL1",
        chapter: "3.7",
        forms: &[form("FL1 0|1, bit [,bit2 …]"), form("FL1 0|1, [ADR.]bit [,[ADR2.]bit2 …]"), form("FL1 0|1, $+n.bit [,$+m.bit2 …]")],
        operands: &[
            operand("value", OperandKind::Number { min: 0, max: 1 }, "Value written: 0 or 1", "Zapisovaná hodnota: 0 nebo 1"),
            operand("bit", WRITE_BIT, "Bit to write: a name, `ADR.bit` or `$+n.bit`", "Zapisovaný bit: jméno, `ADR.bit` nebo `$+n.bit`").repeated(),
        ],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo],
        writes: &[Effect::Memory],
        summary: text("Sets or clears bits when RLO is 1.", "Nastaví nebo vynuluje bity, když je RLO 1."),
        ..INSTRUCTION
    },
    Entry {
        name: "MOVR",
        chapter: "3.7",
        forms: &[form("MOVR dst, src"), form("MOVR [ADR.]dst, [ADR.]src")],
        operands: &[
            operand("dst", WRITE_BIT, "Destination bit", "Cílový bit"),
            operand("src", SOURCE_BIT, "Source bit", "Zdrojový bit"),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Copies one bit to another.", "Zkopíruje jeden bit do druhého."),
        ..INSTRUCTION
    },
    Entry {
        name: "MOVR1",
        chapter: "3.7",
        forms: &[form("MOVR1 dst, src"), form("MOVR1 [ADR.]dst, [ADR.]src")],
        operands: &[
            operand("dst", WRITE_BIT, "Destination bit", "Cílový bit"),
            operand("src", SOURCE_BIT, "Source bit", "Zdrojový bit"),
        ],
        equation: Equation::Terminal,
        reads: &[Effect::Rlo, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Copies one bit to another when RLO is 1.", "Zkopíruje jeden bit do druhého, když je RLO 1."),
        ..INSTRUCTION
    },
];
