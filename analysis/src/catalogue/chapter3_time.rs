//! Chapter 3.11: time blocks, timers and counters.

use super::entry::{Effect, Entry, Equation, OperandKind, OperandSpec, TimeUnit};
use super::pattern::{COUNTER, INSTRUCTION, example, form, operand, text};

const END: OperandSpec =
    operand("end", OperandKind::Label, "Label that ends the block", "Návěští, kterým blok končí");
const COUNT: OperandSpec = operand("count", COUNTER, "BYTE or WORD counter", "Čítač typu BYTE nebo WORD");

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "DFTM01",
        chapter: "3.11",
        forms: &[form("DFTM01 end")],
        operands: &[END],
        summary: text(
            "Opens a block that runs only once in 0.1 s.",
            "Otevře blok, který se provádí jen jednou za 0,1 s.",
        ),
        description: text(
            "The lines down to the label run only in one cycle out of each 0.1 s; in the other cycles \
             the program continues at the label. Inside, one step of TM is 0.1 s. EDGE_H and EDGE_L may \
             be used and compare with the last time the block ran.\n\n\
             The label must lie below in the same module, mechanism or procedure, and blocks are not \
             nested (this implementation). All blocks of one period run in the same cycle. Any number of \
             blocks may stand in every file.",
            "Řádky až po návěští se provedou jen v jednom cyklu za každých 0,1 s; v ostatních cyklech \
             program pokračuje na návěští. Jeden krok instrukce TM uvnitř bloku trvá 0,1 s. EDGE_H a \
             EDGE_L se používat smějí a porovnávají se stavem při minulém provedení bloku.\n\n\
             Návěští musí ležet níže v témže modulu, mechanismu nebo proceduře a bloky se do sebe \
             nevnořují (tato implementace). Všechny bloky jedné periody se provedou v témže cyklu. V \
             každém souboru jich může být libovolný počet.",
        ),
        examples: &[example(
            concat!(
                "        DFTM01 SLOW\n",
                "        LOD  RUN_TIME\n",
                "        INR\n",
                "        STO  RUN_TIME\n",
                "SLOW:"
            ),
            "RUN_TIME counts in steps of 0.1 s.",
            "RUN_TIME přibývá po 0,1 s.",
        )],
        related: &["TM", "DFTM1", "DFTM10", "DFTM100"],
        ..INSTRUCTION
    },
    Entry {
        name: "DFTM1",
        chapter: "3.11",
        forms: &[form("DFTM1 end")],
        operands: &[END],
        summary: text(
            "Opens a block that runs only once in 1 s.",
            "Otevře blok, který se provádí jen jednou za 1 s.",
        ),
        description: text(
            "The lines down to the label run only in one cycle out of each 1 s; in the other cycles the \
             program continues at the label. Inside, one step of TM is 1 s. EDGE_H and EDGE_L may be \
             used and compare with the last time the block ran.\n\n\
             The label must lie below in the same module, mechanism or procedure, and blocks are not \
             nested (this implementation). All blocks of one period run in the same cycle. Any number of \
             blocks may stand in every file.",
            "Řádky až po návěští se provedou jen v jednom cyklu za každých 1 s; v ostatních cyklech \
             program pokračuje na návěští. Jeden krok instrukce TM uvnitř bloku trvá 1 s. EDGE_H a \
             EDGE_L se používat smějí a porovnávají se stavem při minulém provedení bloku.\n\n\
             Návěští musí ležet níže v témže modulu, mechanismu nebo proceduře a bloky se do sebe \
             nevnořují (tato implementace). Všechny bloky jedné periody se provedou v témže cyklu. V \
             každém souboru jich může být libovolný počet.",
        ),
        examples: &[example(
            concat!(
                "        DFTM1 SLOW\n",
                "        LOD  RUN_TIME\n",
                "        INR\n",
                "        STO  RUN_TIME\n",
                "SLOW:"
            ),
            "RUN_TIME counts in steps of 1 s.",
            "RUN_TIME přibývá po 1 s.",
        )],
        related: &["TM", "DFTM01", "DFTM10", "DFTM100"],
        ..INSTRUCTION
    },
    Entry {
        name: "DFTM10",
        chapter: "3.11",
        forms: &[form("DFTM10 end")],
        operands: &[END],
        summary: text(
            "Opens a block that runs only once in 10 s.",
            "Otevře blok, který se provádí jen jednou za 10 s.",
        ),
        description: text(
            "The lines down to the label run only in one cycle out of each 10 s; in the other cycles the \
             program continues at the label. Inside, one step of TM is 10 s. EDGE_H and EDGE_L may be \
             used and compare with the last time the block ran.\n\n\
             The label must lie below in the same module, mechanism or procedure, and blocks are not \
             nested (this implementation). All blocks of one period run in the same cycle. Any number of \
             blocks may stand in every file.",
            "Řádky až po návěští se provedou jen v jednom cyklu za každých 10 s; v ostatních cyklech \
             program pokračuje na návěští. Jeden krok instrukce TM uvnitř bloku trvá 10 s. EDGE_H a \
             EDGE_L se používat smějí a porovnávají se stavem při minulém provedení bloku.\n\n\
             Návěští musí ležet níže v témže modulu, mechanismu nebo proceduře a bloky se do sebe \
             nevnořují (tato implementace). Všechny bloky jedné periody se provedou v témže cyklu. V \
             každém souboru jich může být libovolný počet.",
        ),
        examples: &[example(
            concat!(
                "        DFTM10 SLOW\n",
                "        LOD  RUN_TIME\n",
                "        INR\n",
                "        STO  RUN_TIME\n",
                "SLOW:"
            ),
            "RUN_TIME counts in steps of 10 s.",
            "RUN_TIME přibývá po 10 s.",
        )],
        related: &["TM", "DFTM01", "DFTM1", "DFTM100"],
        ..INSTRUCTION
    },
    Entry {
        name: "DFTM100",
        chapter: "3.11",
        forms: &[form("DFTM100 end")],
        operands: &[END],
        summary: text(
            "Opens a block that runs only once in 100 s.",
            "Otevře blok, který se provádí jen jednou za 100 s.",
        ),
        description: text(
            "The lines down to the label run only in one cycle out of each 100 s; in the other cycles \
             the program continues at the label. Inside, one step of TM is 100 s. EDGE_H and EDGE_L may \
             be used and compare with the last time the block ran.\n\n\
             The label must lie below in the same module, mechanism or procedure, and blocks are not \
             nested (this implementation). All blocks of one period run in the same cycle. Any number of \
             blocks may stand in every file.",
            "Řádky až po návěští se provedou jen v jednom cyklu za každých 100 s; v ostatních cyklech \
             program pokračuje na návěští. Jeden krok instrukce TM uvnitř bloku trvá 100 s. EDGE_H a \
             EDGE_L se používat smějí a porovnávají se stavem při minulém provedení bloku.\n\n\
             Návěští musí ležet níže v témže modulu, mechanismu nebo proceduře a bloky se do sebe \
             nevnořují (tato implementace). Všechny bloky jedné periody se provedou v témže cyklu. V \
             každém souboru jich může být libovolný počet.",
        ),
        examples: &[example(
            concat!(
                "        DFTM100 SLOW\n",
                "        LOD  RUN_TIME\n",
                "        INR\n",
                "        STO  RUN_TIME\n",
                "SLOW:"
            ),
            "RUN_TIME counts in steps of 100 s.",
            "RUN_TIME přibývá po 100 s.",
        )],
        related: &["TM", "DFTM01", "DFTM1", "DFTM10"],
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
        description: text(
            "RLO is the condition, DR the time in passes of the surrounding DFTM block. With RLO = 0 the \
             counter is cleared. With RLO = 1 and the counter below DR the counter grows by one and RLO \
             becomes 0; once the counter has reached DR, RLO stays 1 and the counter rests. RLO thus \
             first becomes 1 in pass DR + 1 of an unbroken condition.\n\n\
             The counter is compared without sign at its own width, BYTE or WORD. `-` or NIL makes an \
             automatic counter. Outside a DFTM block TM counts passes of the module, with a warning \
             (this implementation). RLO is overwritten without closing the equation: end it by WR or \
             FL1.",
            "RLO je podmínka, DR čas v počtu průchodů okolním blokem DFTM. Při RLO = 0 se čítač \
             vynuluje. Při RLO = 1 a čítači menším než DR se čítač zvětší o jedničku a RLO bude 0; \
             jakmile čítač hodnoty DR dosáhne, RLO zůstane 1 a čítač stojí. Poprvé je tedy RLO 1 v \
             průchodu DR + 1 nepřerušené podmínky.\n\n\
             Čítač se porovnává bez znaménka ve své šířce, BYTE nebo WORD. `-` nebo NIL vytvoří \
             automatický čítač. Mimo blok DFTM čítá TM průchody modulem, s varováním (tato \
             implementace). RLO se přepíše, rovnice se tím ale neuzavře: zakončete ji WR nebo FL1.",
        ),
        examples: &[example(
            concat!(
                "        DFTM01 T_END\n",
                "        LDR  MOTOR\n",
                "        LOD  CNST.30\n",
                "        TM   -\n",
                "        WR   MOTOR_STEADY\n",
                "T_END:"
            ),
            "MOTOR_STEADY comes 3 s after MOTOR and drops with it.",
            "MOTOR_STEADY přijde 3 s po MOTOR a odpadne spolu s ním.",
        )],
        related: &["DFTM01", "DFTM1", "TIM", "CU"],
        ..INSTRUCTION
    },
    Entry {
        name: "CU",
        chapter: "3.11",
        forms: &[form("CU count")],
        operands: &[COUNT],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Counts rising edges of RLO up and compares the count with DR.",
            "Čítá náběžné hrany RLO nahoru a porovná stav čítače s DR.",
        ),
        description: text(
            "The counter goes up by one when RLO was 0 at the last execution of this line and is 1 now; \
             the line keeps the last state in a hidden bit. Then RLO is 1 if the counter equals DR, \
             compared at the width of the counter, and DR holds the content of the counter as LOD would \
             load it. It wraps to zero past 255 or 65535 (this implementation).\n\n\
             Reaching the preset does not reset the counter; do it by STO1 or STO. The cell is BYTE or \
             WORD by its declaration, without a prefix. RLO is overwritten without closing the equation.",
            "Čítač postoupí nahoru o jedničku, když bylo RLO při minulém provedení tohoto řádku 0 a teď \
             je 1; minulý stav si řádek drží ve skrytém bitu. Potom je RLO 1, jestliže se čítač rovná DR \
             (porovnává se v šířce čítače), a v DR je obsah čítače tak, jak by ho načetlo LOD. Po 255, \
             popř. 65535 přeteče do nuly (tato implementace).\n\n\
             Dosažením předvolby se čítač nenuluje; nulujte ho pomocí STO1 nebo STO. Buňka je BYTE nebo \
             WORD podle deklarace, bez prefixu. RLO se přepíše, rovnice se tím neuzavře.",
        ),
        examples: &[example(
            concat!(
                "        LDR  PART_OUT\n",
                "        LOD  BATCH\n",
                "        CU   PARTS\n",
                "        WR   BATCH_DONE"
            ),
            "BATCH_DONE is 1 while PARTS equals BATCH.",
            "BATCH_DONE je 1, dokud se PARTS rovná BATCH.",
        )],
        related: &["CD", "CUBCD", "EDGE_H", "TM"],
        ..INSTRUCTION
    },
    Entry {
        name: "CD",
        chapter: "3.11",
        forms: &[form("CD count")],
        operands: &[COUNT],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Counts rising edges of RLO down and compares the count with DR.",
            "Čítá náběžné hrany RLO dolů a porovná stav čítače s DR.",
        ),
        description: text(
            "The counter goes down by one when RLO was 0 at the last execution of this line and is 1 \
             now; the line keeps the last state in a hidden bit. Then RLO is 1 if the counter equals DR, \
             compared at the width of the counter, and DR holds the content of the counter as LOD would \
             load it. Below zero it wraps to 255 or 65535 (this implementation).\n\n\
             Reaching the preset does not reset the counter; do it by STO1 or STO. The cell is BYTE or \
             WORD by its declaration, without a prefix. RLO is overwritten without closing the equation.",
            "Čítač postoupí dolů o jedničku, když bylo RLO při minulém provedení tohoto řádku 0 a teď je \
             1; minulý stav si řádek drží ve skrytém bitu. Potom je RLO 1, jestliže se čítač rovná DR \
             (porovnává se v šířce čítače), a v DR je obsah čítače tak, jak by ho načetlo LOD. Pod nulou \
             přeteče na 255, popř. 65535 (tato implementace).\n\n\
             Dosažením předvolby se čítač nenuluje; nulujte ho pomocí STO1 nebo STO. Buňka je BYTE nebo \
             WORD podle deklarace, bez prefixu. RLO se přepíše, rovnice se tím neuzavře.",
        ),
        examples: &[example(
            concat!(
                "        LDR  PART_TAKEN\n",
                "        LOD  CNST.0\n",
                "        CD   STOCK\n",
                "        WR   STOCK_EMPTY"
            ),
            "STOCK_EMPTY is 1 when the stock has come down to zero.",
            "STOCK_EMPTY je 1, když zásoba klesne na nulu.",
        )],
        related: &["CU", "CUBCD", "EDGE_H", "TM"],
        ..INSTRUCTION
    },
    Entry {
        name: "CUBCD",
        chapter: "3.11",
        forms: &[form("CUBCD count")],
        operands: &[COUNT],
        equation: Equation::Overwrite,
        reads: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Counts rising edges of RLO up in BCD and compares the count with DR.",
            "Čítá náběžné hrany RLO nahoru v kódu BCD a porovná stav čítače s DR.",
        ),
        description: text(
            "The counter goes up as a BCD number by one when RLO was 0 at the last execution of this \
             line and is 1 now; the line keeps the last state in a hidden bit. Then RLO is 1 if the \
             counter equals DR, compared at the width of the counter, and DR holds the content of the \
             counter as LOD would load it. It wraps to zero past 99 or 9999 (this implementation).\n\n\
             Reaching the preset does not reset the counter; do it by STO1 or STO. The cell is BYTE or \
             WORD by its declaration, without a prefix. RLO is overwritten without closing the equation.",
            "Čítač postoupí nahoru jako BCD číslo o jedničku, když bylo RLO při minulém provedení tohoto \
             řádku 0 a teď je 1; minulý stav si řádek drží ve skrytém bitu. Potom je RLO 1, jestliže se \
             čítač rovná DR (porovnává se v šířce čítače), a v DR je obsah čítače tak, jak by ho načetlo \
             LOD. Po 99, popř. 9999 přeteče do nuly (tato implementace).\n\n\
             Dosažením předvolby se čítač nenuluje; nulujte ho pomocí STO1 nebo STO. Buňka je BYTE nebo \
             WORD podle deklarace, bez prefixu. RLO se přepíše, rovnice se tím neuzavře.",
        ),
        examples: &[example(
            concat!(
                "        LDR  POCKET_SWITCH\n",
                "        LOD  BYTE.12h\n",
                "        CUBCD POCKET\n",
                "        WR   LAST_POCKET"
            ),
            "Counts pockets in BCD; LAST_POCKET marks the twelfth.",
            "Čítá lůžka v BCD; LAST_POCKET označí dvanácté.",
        )],
        related: &["CU", "CD", "EDGE_H", "TM"],
        ..INSTRUCTION
    },
];
