//! Chapter 3.14: comparing DR with an operand.

use super::entry::{Effect, Entry, Equation, OperandSpec};
use super::pattern::{COMPARED, INSTRUCTION, example, form, operand, text};

const VAL: OperandSpec =
    operand("val", COMPARED, "Cell, EQUI constant or number", "Buňka, konstanta EQUI nebo číslo");

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "EQ",
        chapter: "3.14",
        forms: &[
            form("EQ val"),
            form("EQ [TYPE.]val"),
            form("EQ TYPE.(val+n)"),
            form("EQ CNST.number"),
            form("EQ CNST.real"),
        ],
        operands: &[VAL],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text("Sets RLO when DR equals the value.", "Nastaví RLO, když se DR rovná hodnotě."),
        description: text(
            "RLO becomes 1 when DR equals the operand, otherwise 0. DR is taken at the operand's width: \
             a BYTE is compared with DR8, a WORD with DR16, a DWORD and every constant with DR32, \
             `QWRD.` with DR64; `REAL.` and a constant with a decimal point are compared with DR_REAL. \
             DR stays.\n\n\
             RLO is overwritten without a push and without closing the equation; a warning tells when an \
             open equation would be lost. LA, LO and the like may follow, and a terminal instruction \
             ends it.",
            "RLO bude 1, když DR se rovná operandu, jinak 0. DR se bere v šířce operandu: BYTE se \
             porovnává s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64; `REAL.` a \
             konstanta s desetinnou tečkou se porovnávají s DR_REAL. DR se nemění.\n\n\
             RLO se přepíše bez uložení na zásobník a bez uzavření rovnice; na ztrátu rozpracované \
             rovnice upozorní varování. Dále mohou následovat LA, LO a podobně, rovnici ukončí koncová \
             instrukce.",
        ),
        examples: &[example(
            concat!(
                "        LOD  LEVEL\n",
                "        EQ   LIMIT\n",
                "        LA   PUMP\n",
                "        WR   LAMP"
            ),
            "The result of the comparison goes on in the equation.",
            "Výsledek porovnání dále vstupuje do rovnice.",
        )],
        related: &["LT", "GT", "LE", "GE", "EQ1"],
        ..INSTRUCTION
    },
    Entry {
        name: "LT",
        chapter: "3.14",
        forms: &[
            form("LT val"),
            form("LT [TYPE.]val"),
            form("LT TYPE.(val+n)"),
            form("LT CNST.number"),
            form("LT CNST.real"),
        ],
        operands: &[VAL],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is less than the value.",
            "Nastaví RLO, když je DR menší než hodnota.",
        ),
        description: text(
            "RLO becomes 1 when DR is less than the operand, otherwise 0. DR is taken at the operand's \
             width: a BYTE is compared with DR8, a WORD with DR16, a DWORD and every constant with DR32, \
             `QWRD.` with DR64; `REAL.` and a constant with a decimal point are compared with DR_REAL. \
             The comparison respects the sign (this implementation). DR stays.\n\n\
             RLO is overwritten without a push and without closing the equation; a warning tells when an \
             open equation would be lost. LA, LO and the like may follow, and a terminal instruction \
             ends it.",
            "RLO bude 1, když DR je menší než operand, jinak 0. DR se bere v šířce operandu: BYTE se \
             porovnává s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64; `REAL.` a \
             konstanta s desetinnou tečkou se porovnávají s DR_REAL. Porovnává se se znaménkem (tato \
             implementace). DR se nemění.\n\n\
             RLO se přepíše bez uložení na zásobník a bez uzavření rovnice; na ztrátu rozpracované \
             rovnice upozorní varování. Dále mohou následovat LA, LO a podobně, rovnici ukončí koncová \
             instrukce.",
        ),
        examples: &[example(
            concat!(
                "        LOD  LEVEL\n",
                "        LT   LIMIT\n",
                "        LA   PUMP\n",
                "        WR   LAMP"
            ),
            "The result of the comparison goes on in the equation.",
            "Výsledek porovnání dále vstupuje do rovnice.",
        )],
        related: &["EQ", "GT", "LE", "GE", "CONDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "GT",
        chapter: "3.14",
        forms: &[
            form("GT val"),
            form("GT [TYPE.]val"),
            form("GT TYPE.(val+n)"),
            form("GT CNST.number"),
            form("GT CNST.real"),
        ],
        operands: &[VAL],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is greater than the value.",
            "Nastaví RLO, když je DR větší než hodnota.",
        ),
        description: text(
            "RLO becomes 1 when DR is greater than the operand, otherwise 0. DR is taken at the \
             operand's width: a BYTE is compared with DR8, a WORD with DR16, a DWORD and every constant \
             with DR32, `QWRD.` with DR64; `REAL.` and a constant with a decimal point are compared with \
             DR_REAL. The comparison respects the sign (this implementation). DR stays.\n\n\
             RLO is overwritten without a push and without closing the equation; a warning tells when an \
             open equation would be lost. LA, LO and the like may follow, and a terminal instruction \
             ends it.",
            "RLO bude 1, když DR je větší než operand, jinak 0. DR se bere v šířce operandu: BYTE se \
             porovnává s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64; `REAL.` a \
             konstanta s desetinnou tečkou se porovnávají s DR_REAL. Porovnává se se znaménkem (tato \
             implementace). DR se nemění.\n\n\
             RLO se přepíše bez uložení na zásobník a bez uzavření rovnice; na ztrátu rozpracované \
             rovnice upozorní varování. Dále mohou následovat LA, LO a podobně, rovnici ukončí koncová \
             instrukce.",
        ),
        examples: &[example(
            concat!(
                "        LOD  LEVEL\n",
                "        GT   LIMIT\n",
                "        LA   PUMP\n",
                "        WR   LAMP"
            ),
            "The result of the comparison goes on in the equation.",
            "Výsledek porovnání dále vstupuje do rovnice.",
        )],
        related: &["EQ", "LT", "LE", "GE", "CONDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "LE",
        chapter: "3.14",
        forms: &[
            form("LE val"),
            form("LE [TYPE.]val"),
            form("LE TYPE.(val+n)"),
            form("LE CNST.number"),
            form("LE CNST.real"),
        ],
        operands: &[VAL],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is less than or equal to the value.",
            "Nastaví RLO, když je DR menší než hodnota nebo se jí rovná.",
        ),
        description: text(
            "RLO becomes 1 when DR is less than or equal to the operand, otherwise 0. DR is taken at the \
             operand's width: a BYTE is compared with DR8, a WORD with DR16, a DWORD and every constant \
             with DR32, `QWRD.` with DR64; `REAL.` and a constant with a decimal point are compared with \
             DR_REAL. The comparison respects the sign (this implementation). DR stays.\n\n\
             RLO is overwritten without a push and without closing the equation; a warning tells when an \
             open equation would be lost. LA, LO and the like may follow, and a terminal instruction \
             ends it.",
            "RLO bude 1, když DR je menší nebo roven operandu, jinak 0. DR se bere v šířce operandu: \
             BYTE se porovnává s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64; \
             `REAL.` a konstanta s desetinnou tečkou se porovnávají s DR_REAL. Porovnává se se znaménkem \
             (tato implementace). DR se nemění.\n\n\
             RLO se přepíše bez uložení na zásobník a bez uzavření rovnice; na ztrátu rozpracované \
             rovnice upozorní varování. Dále mohou následovat LA, LO a podobně, rovnici ukončí koncová \
             instrukce.",
        ),
        examples: &[example(
            concat!(
                "        LOD  LEVEL\n",
                "        LE   LIMIT\n",
                "        LA   PUMP\n",
                "        WR   LAMP"
            ),
            "The result of the comparison goes on in the equation.",
            "Výsledek porovnání dále vstupuje do rovnice.",
        )],
        related: &["EQ", "LT", "GT", "GE", "CONDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "GE",
        chapter: "3.14",
        forms: &[
            form("GE val"),
            form("GE [TYPE.]val"),
            form("GE TYPE.(val+n)"),
            form("GE CNST.number"),
            form("GE CNST.real"),
        ],
        operands: &[VAL],
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when DR is greater than or equal to the value.",
            "Nastaví RLO, když je DR větší než hodnota nebo se jí rovná.",
        ),
        description: text(
            "RLO becomes 1 when DR is greater than or equal to the operand, otherwise 0. DR is taken at \
             the operand's width: a BYTE is compared with DR8, a WORD with DR16, a DWORD and every \
             constant with DR32, `QWRD.` with DR64; `REAL.` and a constant with a decimal point are \
             compared with DR_REAL. The comparison respects the sign (this implementation). DR stays.\n\n\
             RLO is overwritten without a push and without closing the equation; a warning tells when an \
             open equation would be lost. LA, LO and the like may follow, and a terminal instruction \
             ends it.",
            "RLO bude 1, když DR je větší nebo roven operandu, jinak 0. DR se bere v šířce operandu: \
             BYTE se porovnává s DR8, WORD s DR16, DWORD a každá konstanta s DR32, `QWRD.` s DR64; \
             `REAL.` a konstanta s desetinnou tečkou se porovnávají s DR_REAL. Porovnává se se znaménkem \
             (tato implementace). DR se nemění.\n\n\
             RLO se přepíše bez uložení na zásobník a bez uzavření rovnice; na ztrátu rozpracované \
             rovnice upozorní varování. Dále mohou následovat LA, LO a podobně, rovnici ukončí koncová \
             instrukce.",
        ),
        examples: &[example(
            concat!(
                "        LOD  LEVEL\n",
                "        GE   LIMIT\n",
                "        LA   PUMP\n",
                "        WR   LAMP"
            ),
            "The result of the comparison goes on in the equation.",
            "Výsledek porovnání dále vstupuje do rovnice.",
        )],
        related: &["EQ", "LT", "GT", "LE", "CONDR"],
        ..INSTRUCTION
    },
    Entry {
        name: "EQ1",
        chapter: "3.14",
        forms: &[
            form("EQ1 val"),
            form("EQ1 [TYPE.]val"),
            form("EQ1 TYPE.(val+n)"),
            form("EQ1 CNST.number"),
            form("EQ1 CNST.real"),
        ],
        operands: &[VAL],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::DrReal, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Compares DR with the value only when RLO is 1.",
            "Porovná DR s hodnotou, jen když je RLO 1.",
        ),
        description: text(
            "With RLO = 1 compares like EQ; with RLO = 0 nothing happens and RLO stays 0. Conditions can \
             so be chained: every EQ1 can only keep or clear RLO. Widths are those of EQ. DR stays. It \
             does not close the equation, so `LDR`, `LOD`, `EQ1`, `WR` is a usual sequence.",
            "Při RLO = 1 porovnává jako EQ; při RLO = 0 se neprovede nic a RLO zůstane 0. Podmínky lze \
             tak řetězit: každé EQ1 může RLO jen ponechat, nebo vynulovat. Šířky jsou stejné jako u EQ. \
             DR se nemění. Rovnici neuzavírá, obvyklá je proto posloupnost `LDR`, `LOD`, `EQ1`, `WR`.",
        ),
        examples: &[example(
            concat!(
                "        LOD  DWRD.PALLET\n",
                "        EQ   DWRD.EXPECTED\n",
                "        LOD  DWRD.(PALLET+4)\n",
                "        EQ1  DWRD.(EXPECTED+4)\n",
                "        WR   SAME"
            ),
            "Compares 8 bytes.",
            "Porovná 8 bajtů.",
        )],
        related: &["EQ", "JL0"],
        ..INSTRUCTION
    },
];
