//! Chapter 3.9 and the keywords that stand as operands: type prefixes, BX, NIL, GLOBAL …

use super::entry::Entry;
use super::pattern::{KEYWORD, PREFIX, example, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "BYTE",
        forms: &[form("BYTE.name"), form("BYTE.(name+n)"), form("BYTE.number")],
        summary: text("Accesses the operand as 8 bits.", "Přistupuje k operandu jako k 8 bitům."),
        description: text(
            "Joined to the operand by a dot it sets the width of the access for this one instruction: 8 \
             bits, DR8. The prefix wins over the declared type. An access that runs past its cell is a \
             warning, one that leaves the data area an error (this implementation).\n\n\
             LOD sign-extends the byte, so 0FFh loads as -1. Before a number (`BYTE.12`) it makes an \
             8-bit constant.",
            "S operandem je spojen tečkou a jen pro tuto instrukci určuje šířku přístupu: 8 bitů, DR8. \
             Prefix má přednost před deklarovaným typem. Přístup za konec buňky je varování, přístup \
             mimo datovou oblast chyba (tato implementace).\n\n\
             LOD bajt znaménkově rozšíří, 0FFh se tedy načte jako -1. Před číslem (`BYTE.12`) vytvoří \
             8bitovou konstantu.",
        ),
        examples: &[example(
            concat!("        LOD  BYTE.(TABLE+3)\n", "        STO  LEVEL"),
            "Loads one byte of an area without a type.",
            "Načte jeden bajt oblasti bez typu.",
        )],
        related: &["WORD", "HIGH", "DWRD", "LOD"],
        ..PREFIX
    },
    Entry {
        name: "WORD",
        forms: &[form("WORD.name"), form("WORD.(name+n)"), form("WORD.number")],
        summary: text("Accesses the operand as 16 bits.", "Přistupuje k operandu jako k 16 bitům."),
        description: text(
            "Sets the width of the access to 16 bits, DR16, for this one instruction; the lower byte \
             lies at the lower address. The prefix wins over the declared type; an access past the cell \
             is a warning (this implementation). With TEX0, TEX1, TIM and TM it covers the counter, with \
             the first three also the time.",
            "Pro tuto instrukci určuje šířku přístupu 16 bitů, DR16; spodní slabika leží na nižší \
             adrese. Prefix má přednost před deklarovaným typem; přístup za konec buňky je varování \
             (tato implementace). U TEX0, TEX1, TIM a TM se vztahuje na čítač, u prvních tří i na čas.",
        ),
        examples: &[example(
            concat!("        LOD  WORD.PB11\n", "        STO  VOLTAGE"),
            "PB11 is a BYTE; with PB12 it forms the programmed spindle voltage.",
            "PB11 je BYTE; spolu s PB12 tvoří programované napětí vřetene.",
        )],
        related: &["BYTE", "HIGH", "DWRD"],
        ..PREFIX
    },
    Entry {
        name: "HIGH",
        forms: &[form("HIGH.name"), form("HIGH.(name+n)")],
        summary: text("Accesses the upper byte of a WORD.", "Přistupuje k horní slabice proměnné WORD."),
        description: text(
            "Reaches the upper byte of a WORD, that is the byte at its address plus one, as 8 bits (this \
             implementation: the manual names the prefix without explaining it). LOD sign-extends it, \
             STO writes DR8 there and leaves the lower byte.",
            "Zpřístupní horní slabiku proměnné WORD, tedy slabiku na adrese o jedna vyšší, jako 8 bitů \
             (tato implementace: příručka prefix uvádí bez vysvětlení). LOD ji znaménkově rozšíří, STO \
             do ní zapíše DR8 a spodní slabiku nechá být.",
        ),
        examples: &[example(
            concat!("        LOD  HIGH.CODE\n", "        STO  GROUP"),
            "GROUP gets the upper byte of the WORD cell CODE.",
            "Do GROUP se uloží horní slabika buňky CODE typu WORD.",
        )],
        related: &["BYTE", "WORD"],
        ..PREFIX
    },
    Entry {
        name: "CNST",
        forms: &[form("CNST.number"), form("CNST.'c'"), form("CNST.real")],
        summary: text(
            "Makes the operand a direct constant, 32 bits wide.",
            "Označí operand jako přímou konstantu o šířce 32 bitů.",
        ),
        description: text(
            "Marks a number as a direct value; the instruction then works on 32 bits of DR. With a \
             decimal point the number is real and the instruction works on DR_REAL. A sign (`CNST.-5`), \
             a character (`CNST.'A'`) and an expression of constants (`CNST.10h+1`) are allowed.\n\n\
             A bare number means the same (this implementation). The misspelling `CNTS.` is accepted \
             with a warning and a fix. A constant can't be a destination.",
            "Označí číslo jako přímou hodnotu; instrukce pak pracuje s 32 bity DR. S desetinnou tečkou \
             je číslo reálné a instrukce pracuje s DR_REAL. Povoleno je znaménko (`CNST.-5`), znak \
             (`CNST.'A'`) i výraz z konstant (`CNST.10h+1`).\n\n\
             Samotné číslo znamená totéž (tato implementace). Překlep `CNTS.` se přijme s varováním a \
             nabídkou opravy. Konstanta nemůže být cílem.",
        ),
        examples: &[example(
            concat!(
                "        LOD  CNST.250\n",
                "        STO  SPEED\n",
                "        LOD  CNST.-10.2\n",
                "        STO  REAL.OFFSET"
            ),
            "An integer and a real constant.",
            "Celočíselná a reálná konstanta.",
        )],
        related: &["EQUI", "LOD", "REAL"],
        ..PREFIX
    },
    Entry {
        name: "DWRD",
        forms: &[form("DWRD.name"), form("DWRD.(name+n)"), form("DWRD.number")],
        summary: text(
            "Accesses the operand as 32 bits; after an instruction without operand it selects the 32-bit \
             DR.",
            "Přistupuje k operandu jako k 32 bitům; u bezoperandových instrukcí volí 32bitový DR.",
        ),
        description: text(
            "Sets the width of the access to 32 bits, DR32, for this one instruction. Written as an \
             operand of its own after INR, DCR, INV, ABS, RL, RR, BIN, BCD, CONDR, CONRD or REAL it \
             selects the 32-bit DR instead of the usual 16 bits.",
            "Pro tuto instrukci určuje šířku přístupu 32 bitů, DR32. Jako samostatný operand za INR, \
             DCR, INV, ABS, RL, RR, BIN, BCD, CONDR, CONRD nebo REAL volí 32bitový DR místo obvyklých 16 \
             bitů.",
        ),
        examples: &[example(
            concat!("        LOD  DWRD.(AREA+8)\n", "        INV  DWRD\n", "        STO  RESULT"),
            "Loads 32 bits from an area and changes their sign.",
            "Načte 32 bitů z oblasti a změní jejich znaménko.",
        )],
        related: &["WORD", "QWRD", "INR"],
        ..PREFIX
    },
    Entry {
        name: "QWRD",
        forms: &[form("QWRD.name"), form("QWRD.(name+n)")],
        summary: text(
            "Accesses the operand as 64 bits; after an instruction without operand it selects the 64-bit \
             DR.",
            "Přistupuje k operandu jako k 64 bitům; u bezoperandových instrukcí volí 64bitový DR.",
        ),
        description: text(
            "Sets the width of the access to 64 bits, DR64, for this one instruction. MULB and DIVB \
             don't take it. Written as an operand of its own after INR, DCR, INV, ABS, RL, RR or REAL it \
             selects the 64-bit DR.",
            "Pro tuto instrukci určuje šířku přístupu 64 bitů, DR64. MULB a DIVB ho nepřijímají. Jako \
             samostatný operand za INR, DCR, INV, ABS, RL, RR nebo REAL volí 64bitový DR.",
        ),
        examples: &[example(
            concat!("        LOD  QWRD.B_POL_EX\n", "        STO  QWRD.POSITION"),
            "Copies a 64-bit position.",
            "Zkopíruje 64bitovou polohu.",
        )],
        related: &["DWRD", "REAL"],
        ..PREFIX
    },
    Entry {
        name: "BX",
        chapter: "3.5",
        forms: &[form("name[BX]"), form("(name[BX]+n)"), form("text+BX")],
        summary: text(
            "Index register: a byte offset added to an address at run time.",
            "Indexový registr: posun v bajtech, který se k adrese přičte za běhu.",
        ),
        description: text(
            "A byte offset added to an address while the program runs: `name[BX]`, also with a constant \
             part, `(name[BX]+n)`. BX is loaded from DR by `MOV BX,CX`, which takes its lower 16 bits. \
             Array elements wider than a byte need the index multiplied by the width first. An address \
             outside the data area is a run-time fault (this implementation).",
            "Posun v bajtech, který se k adrese přičte až za běhu: `jméno[BX]`, případně s konstantní \
             částí `(jméno[BX]+n)`. BX se plní z DR instrukcí `MOV BX,CX`, která vezme jeho spodních 16 \
             bitů. U prvků širších než bajt je nutné index předem vynásobit šířkou. Adresa mimo datovou \
             oblast způsobí chybu za běhu (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        LOD  INDEX\n",
                "        MOV  BX,CX\n",
                "        LOD  BYTE.TABLE[BX]\n",
                "        STO  LEVEL"
            ),
            "Loads the byte of TABLE that INDEX selects.",
            "Načte slabiku tabulky TABLE, kterou vybírá INDEX.",
        )],
        related: &["MOV", "LDR", "LOD"],
        ..KEYWORD
    },
    Entry {
        name: "NIL",
        chapter: "4.2",
        forms: &[form("TIM NIL, time"), form("TEX0 NIL, time, label")],
        summary: text(
            "Operand not given: the compiler creates an automatic counter (same as `-`).",
            "Operand není zadán: překladač si vytvoří automatický čítač (totéž co `-`).",
        ),
        description: text(
            "Stands in place of an operand that is not given and means the same as `-`. For the counter \
             of TIM, TEX0, TEX1 and TM the compiler then creates a WORD in the local data of the file.",
            "Stojí na místě operandu, který se nezadává, a znamená totéž co `-`. Místo čítače TIM, TEX0, \
             TEX1 a TM pak překladač vytvoří WORD v lokálních datech souboru.",
        ),
        examples: &[example(
            "        TIM  NIL,25",
            "Waits half a second with a counter of its own.",
            "Čeká půl sekundy s vlastním automatickým čítačem.",
        )],
        related: &["TIM", "TEX0", "TM"],
        ..KEYWORD
    },
    Entry {
        name: "GLOBAL",
        chapter: "3.15",
        forms: &[form("CLEAR GLOBAL, ALL")],
        summary: text(
            "With CLEAR: the global data of all files.",
            "U instrukce CLEAR: globální data všech souborů.",
        ),
        description: text(
            "Selects the global data of all files: DATA, activation bits and continuation of the \
             mechanisms. It stands before `ALL` and nowhere else.",
            "Vybírá globální data všech souborů: modul DATA, aktivační bity i pokračování mechanismů. \
             Píše se před `ALL` a nikde jinde.",
        ),
        examples: &[example(
            "        CLEAR GLOBAL,ALL",
            "Belongs to MODULE_CLEAR.",
            "Patří do modulu MODULE_CLEAR, nulování tím odpovídá zapnutí.",
        )],
        related: &["CLEAR", "ALL"],
        ..KEYWORD
    },
    Entry {
        name: "INTERNAL",
        chapter: "3.15",
        forms: &[form("CLEAR INTERNAL, ALL")],
        summary: text(
            "With CLEAR: the local data of all files, automatic variables included.",
            "U instrukce CLEAR: lokální data všech souborů včetně automatických proměnných.",
        ),
        description: text(
            "Selects the local data of all files: DATA_LOCAL and the variables the compiler created. It \
             stands before `ALL` and nowhere else.",
            "Vybírá lokální data všech souborů: DATA_LOCAL i proměnné vytvořené překladačem. Píše se \
             před `ALL` a nikde jinde.",
        ),
        examples: &[example(
            "        CLEAR INTERNAL,ALL",
            "Belongs to MODULE_CLEAR.",
            "Patří do modulu MODULE_CLEAR, nulování tím odpovídá zapnutí.",
        )],
        related: &["CLEAR", "ALL"],
        ..KEYWORD
    },
    Entry {
        name: "ALL",
        chapter: "3.15",
        forms: &[form("CLEAR GLOBAL, ALL"), form("CLEAR INTERNAL, ALL")],
        summary: text("With CLEAR: the whole area.", "U instrukce CLEAR: celá oblast."),
        description: text(
            "Completes `CLEAR GLOBAL` and `CLEAR INTERNAL`.",
            "Doplňuje `CLEAR GLOBAL` a `CLEAR INTERNAL`; znamená celou oblast.",
        ),
        examples: &[example(
            concat!("        CLEAR GLOBAL,ALL\n", "        CLEAR INTERNAL,ALL"),
            "Clears all data.",
            "Vynuluje všechna data.",
        )],
        related: &["CLEAR", "GLOBAL", "INTERNAL"],
        ..KEYWORD
    },
    Entry {
        name: "ON",
        chapter: "7.1",
        forms: &[form("DEBUG ON")],
        summary: text(
            "With DEBUG: begins the region that can be debugged.",
            "U direktivy DEBUG: začátek úseku, který lze ladit.",
        ),
        description: text("Same as DEBUG alone.", "Totéž co samotné DEBUG: od tohoto řádku lze ladit."),
        examples: &[example(
            "DEBUG ON",
            "Break-points are possible from here on.",
            "Odtud lze nastavovat breakpointy.",
        )],
        related: &["DEBUG", "OFF"],
        ..KEYWORD
    },
    Entry {
        name: "OFF",
        chapter: "7.1",
        forms: &[form("DEBUG OFF")],
        summary: text(
            "With DEBUG: ends the region that can be debugged.",
            "U direktivy DEBUG: konec úseku, který lze ladit.",
        ),
        description: text(
            "Ends what DEBUG or DEBUG ON began.",
            "Ukončí úsek začatý pomocí DEBUG nebo DEBUG ON.",
        ),
        examples: &[example("DEBUG OFF", "The region ends here.", "Tady úsek končí.")],
        related: &["DEBUG", "ON"],
        ..KEYWORD
    },
];
