//! Chapter 16: configuration parameters and constants of the program.

use super::entry::{
    Access, Bilingual, ConfigElement, Effect, Entry, Equation, OperandKind, OperandSpec, Prefix, PrefixSet,
};
use super::pattern::{CELLS, INSTRUCTION, VALUES, WRITE_BIT, example, form, operand, source, text};

/// Prefixes of an integer that a parameter or constant is stored in.
const INTEGER_CELLS: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Dwrd]);
/// Prefixes of an integer default.
const INTEGER_VALUES: PrefixSet = PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Cnst, Prefix::Dwrd]);
const REALS: PrefixSet = PrefixSet::of(&[Prefix::Real]);

const INTEGER_CELL: OperandKind =
    OperandKind::Data { access: Access::Write, prefixes: INTEGER_CELLS, declared: CELLS, negatable: false };

const ID: OperandSpec = operand(
    "id",
    OperandKind::Identifier(ConfigElement::Parameter),
    "Attribute ID of the `PlcParam` element: a literal in apostrophes or the label of a STR",
    "Atribut ID elementu `PlcParam`: řetězec v apostrofech nebo návěští textu STR",
);

const MISSING: Bilingual = text(
    "RLO is 1 when the configuration holds the parameter. RLO is 0 when it does not: the target then gets \
     `default`, or stays as it was when there is none (this implementation).",
    "RLO je 1, když konfigurace parametr obsahuje. RLO je 0, když ho neobsahuje: cíl pak dostane `default`, a není-li \
     zadán, zůstane beze změny (tato implementace).",
);

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "CNF_GET_INT",
        chapter: "16.1",
        forms: &[form("CNF_GET_INT cell, 'ID' [,default]"), form("CNF_GET_INT cell, id [,default]")],
        operands: &[
            operand(
                "cell",
                OperandKind::OneOf(&[INTEGER_CELL, OperandKind::Text(Access::Write)]),
                "Where the value goes: a BYTE, WORD or DWORD cell; a text buffer gets 4 bytes",
                "Kam se hodnota uloží: buňka BYTE, WORD nebo DWORD; do textu se zapíší 4 bajty",
            ),
            ID,
            operand(
                "default",
                OperandKind::OneOf(&[source(INTEGER_VALUES, VALUES), OperandKind::Text(Access::Read)]),
                "Value when the parameter is missing: a number or a cell",
                "Hodnota, když parametr chybí: číslo nebo buňka",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads an integer configuration parameter; RLO 0 when it is missing.",
            "Přečte celočíselný konfigurační parametr; RLO je 0, když chybí.",
        ),
        description: text(
            "Looks for the element `PlcParam` with this ID and `Type=\"Int\"` in the element `Plc` of the \
             ChannelConfig file and stores its value at the width of the cell. The configuration is there already \
             in MODULE_INIT; best read all of it in one procedure called from there.\n\n\
             A `Type=\"Real\"` parameter is rounded (this implementation). DR stays (this implementation).",
            "Vyhledá element `PlcParam` s tímto ID a `Type=\"Int\"` v elementu `Plc` souboru ChannelConfig a uloží \
             jeho hodnotu v šířce buňky. Konfigurace je k dispozici už v MODULE_INIT; nejlépe je načíst ji celou v \
             jedné proceduře volané odtud.\n\n\
             Parametr s `Type=\"Real\"` se zaokrouhlí (tato implementace). DR se nemění (tato implementace).",
        ),
        errors: MISSING,
        examples: &[example(
            concat!(
                "        CNF_GET_INT DELAY,'CoolantDelay',50\n",
                "        JL1  FOUND\n",
                "        ESET WARN_DEFAULT\n",
                "FOUND:"
            ),
            "Without the parameter the delay is 50, and a message says so.",
            "Bez parametru je prodleva 50 a oznámí to hlášení.",
        )],
        related: &["CNF_GET_REAL", "CNF_GET_BIT", "CONST_GET"],
        ..INSTRUCTION
    },
    Entry {
        name: "CNF_GET_REAL",
        chapter: "16.1",
        forms: &[form("CNF_GET_REAL cell, 'ID' [,default]"), form("CNF_GET_REAL cell, id [,default]")],
        operands: &[
            operand(
                "cell",
                OperandKind::Data {
                    access: Access::Write,
                    prefixes: REALS,
                    declared: REALS,
                    negatable: false,
                },
                "REAL cell of 8 bytes where the value goes",
                "Buňka REAL o 8 bajtech, kam se hodnota uloží",
            ),
            ID,
            operand(
                "default",
                OperandKind::OneOf(&[OperandKind::RealConstant, source(REALS, REALS)]),
                "Value when the parameter is missing: a number with a decimal point or a REAL cell",
                "Hodnota, když parametr chybí: číslo s desetinnou tečkou nebo buňka REAL",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a real configuration parameter; RLO 0 when it is missing.",
            "Přečte reálný konfigurační parametr; RLO je 0, když chybí.",
        ),
        description: text(
            "As CNF_GET_INT, for an element with `Type=\"Real\"`. The cell is declared by `DS 8` and needs no \
             prefix here. A `Type=\"Int\"` parameter is converted (this implementation). DR and DR_REAL stay (this \
             implementation).",
            "Jako CNF_GET_INT, ale pro element s `Type=\"Real\"`. Buňka se deklaruje jako `DS 8` a prefix se u ní \
             zde nepíše. Parametr s `Type=\"Int\"` se převede (tato implementace). DR ani DR_REAL se nemění (tato \
             implementace).",
        ),
        errors: MISSING,
        examples: &[example(
            concat!(
                "        CNF_GET_REAL GAIN,'Gain',0.2\n",
                "        LOD  REAL.GAIN\n",
                "        MULB CNST.2.0\n",
                "        STO  REAL.GAIN2"
            ),
            "GAIN comes from the configuration, or is 0.2.",
            "GAIN se vezme z konfigurace, jinak je 0.2; uloží se i dvojnásobek.",
        )],
        related: &["CNF_GET_INT", "REAL"],
        ..INSTRUCTION
    },
    Entry {
        name: "CNF_GET_STR",
        chapter: "16.1",
        forms: &[form("CNF_GET_STR text, 'ID' [,default]"), form("CNF_GET_STR text, id [,default]")],
        operands: &[
            operand(
                "text",
                OperandKind::Text(Access::Write),
                "Text declared by STR that gets the value, with an optional offset `+n`",
                "Text deklarovaný STR, který hodnotu dostane, případně s posunem `+n`",
            ),
            ID,
            operand(
                "default",
                OperandKind::TextOrLiteral,
                "Text when the parameter is missing: a literal in apostrophes or the label of a STR",
                "Text, když parametr chybí: řetězec v apostrofech nebo návěští textu STR",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a text configuration parameter; RLO 0 when it is missing.",
            "Přečte textový konfigurační parametr; RLO je 0, když chybí.",
        ),
        description: text(
            "As CNF_GET_INT, for an element with `Type=\"String\"`. A text longer than the buffer is cut, and the \
             terminating zero is always written (this implementation). DR stays (this implementation).",
            "Jako CNF_GET_INT, ale pro element s `Type=\"String\"`. Text delší než cíl se zkrátí a koncová nula se \
             zapíše vždy (tato implementace). DR se nemění (tato implementace).",
        ),
        errors: MISSING,
        examples: &[example(
            concat!("        CNF_GET_STR TITLE,'MachineName','Lathe'\n", "        WR   NAMED"),
            "TITLE is `Lathe` unless the configuration says otherwise.",
            "TITLE je `Lathe`, pokud konfigurace neříká něco jiného.",
        )],
        related: &["CNF_GET_INT", "CNF_GET_BIN", "STR", "STRCPY"],
        ..INSTRUCTION
    },
    Entry {
        name: "CNF_GET_BIN",
        chapter: "16.1",
        forms: &[form("CNF_GET_BIN area, 'ID' [,default]"), form("CNF_GET_BIN area, id [,default]")],
        operands: &[
            operand(
                "area",
                OperandKind::Text(Access::Write),
                "Text or area that gets the bytes, with an optional offset `+n`",
                "Text nebo oblast, kam se bajty uloží, případně s posunem `+n`",
            ),
            ID,
            operand(
                "default",
                OperandKind::LiteralOrAddress,
                "Bytes when the parameter is missing: a text, an area or a cell",
                "Bajty, když parametr chybí: text, oblast nebo buňka",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a binary configuration parameter; RLO 0 when it is missing.",
            "Přečte binární konfigurační parametr; RLO je 0, když chybí.",
        ),
        description: text(
            "As CNF_GET_INT, for an element with `Type=\"Binary\"`, whose content is written as pairs of hexadecimal \
             digits (this implementation). Bytes that have no room are left out, no zero is added (this \
             implementation). DR stays (this implementation).",
            "Jako CNF_GET_INT, ale pro element s `Type=\"Binary\"`, jehož obsah se zapisuje jako dvojice \
             šestnáctkových číslic (tato implementace). Bajty, které se do cíle nevejdou, se vynechají, nula se \
             nepřidává (tato implementace). DR se nemění (tato implementace).",
        ),
        errors: MISSING,
        examples: &[example(
            concat!("        CNF_GET_BIN TABLE,'StartPattern'\n", "        WR   NAMED"),
            "Fills TABLE from the configuration; without the parameter it stays.",
            "Naplní TABLE z konfigurace; bez parametru se TABLE nezmění.",
        )],
        related: &["CNF_GET_STR", "MEMCPY"],
        ..INSTRUCTION
    },
    Entry {
        name: "CNF_GET_BIT",
        chapter: "16.1",
        forms: &[form("CNF_GET_BIT bit, 'ID' [,default]"), form("CNF_GET_BIT bit, id [,default]")],
        operands: &[
            operand("bit", WRITE_BIT, "Bit that gets the value", "Bit, který hodnotu dostane"),
            ID,
            operand(
                "default",
                OperandKind::Number { min: 0, max: 1 },
                "Value when the parameter is missing",
                "Hodnota, když parametr chybí",
            )
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Memory],
        summary: text(
            "Reads a logical configuration parameter; RLO 0 when it is missing.",
            "Přečte logický konfigurační parametr; RLO je 0, když chybí.",
        ),
        description: text(
            "As CNF_GET_INT, into a bit: the parameter has `Type=\"Int\"`, and any value but 0 sets the bit (this \
             implementation). RLO says whether the parameter exists, not what it holds. DR stays (this \
             implementation).",
            "Jako CNF_GET_INT, ale do bitu: parametr má `Type=\"Int\"` a každá hodnota kromě 0 bit nastaví (tato \
             implementace). RLO říká, zda parametr existuje, ne jaký je. DR se nemění (tato implementace).",
        ),
        errors: MISSING,
        examples: &[example(
            concat!(
                "        CNF_GET_BIT HAS_PROBE,'Probe',0\n",
                "        LDR  HAS_PROBE\n",
                "        WR   LAMP"
            ),
            "The bit, not RLO, says whether the machine has a probe.",
            "Zda má stroj sondu, říká bit, nikoli RLO.",
        )],
        related: &["CNF_GET_INT", "CONST_GET"],
        ..INSTRUCTION
    },
    Entry {
        name: "CONST_GET",
        chapter: "16.2",
        forms: &[form("CONST_GET cell, 'ID'"), form("CONST_GET cell, id")],
        operands: &[
            operand(
                "cell",
                INTEGER_CELL,
                "BYTE, WORD or DWORD cell that gets the constant",
                "Buňka BYTE, WORD nebo DWORD, která konstantu dostane",
            ),
            operand(
                "id",
                OperandKind::Identifier(ConfigElement::Constant),
                "Attribute ID of the constant: a literal in apostrophes or the label of a STR",
                "Atribut ID konstanty: řetězec v apostrofech nebo návěští textu STR",
            ),
        ],
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Reads a constant of the program into a cell and DR; RLO 0 when it is missing.",
            "Přečte konstantu programu do buňky a do DR; RLO je 0, když chybí.",
        ),
        description: text(
            "Constants are shared by the program and the screens: `Constant` elements with ID and Value in the \
             PlcConstants files of the project. Their value is a number or one of `SA0INT`, `SA0REAL` and \
             `PLCCOMMAND`, which the control numbers by itself. Typical uses are WORD cells with offsets for \
             SA_READ and SA_WRITE, and DWORD cells with codes that _ON_CMD compares with DR.\n\n\
             A narrower cell gets the lower part of the value (this implementation). Results of several reads are \
             gathered by LA and WR on a bit that was set to 1 before.",
            "Konstanty sdílí program a obrazovky: jsou to elementy `Constant` s ID a Value v souborech PlcConstants \
             projektu. Hodnotou je číslo nebo jedno ze slov `SA0INT`, `SA0REAL` a `PLCCOMMAND`, kterým čísla \
             přidělí systém sám. Typicky se čtou do buněk WORD posuny pro SA_READ a SA_WRITE a do buněk DWORD kódy, \
             se kterými _ON_CMD porovnává DR.\n\n\
             Užší buňka dostane spodní část hodnoty (tato implementace). Výsledky několika čtení se shromáždí \
             pomocí LA a WR v bitu, který byl předem nastaven na 1.",
        ),
        errors: text(
            "RLO is 1 when the constant was found and DR holds it. RLO and DR are 0 when it was not; the cell then \
             stays (this implementation).",
            "RLO je 1, když se konstanta našla a je v DR. RLO i DR jsou 0, když se nenašla; buňka pak zůstane beze \
             změny (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        FL   1,READ_OK\n",
                "        CONST_GET OFFS_FEED,'OffsFeed'\n",
                "        LA   READ_OK\n",
                "        WR   READ_OK\n",
                "        CONST_GET OFFS_STATE,'OffsState'\n",
                "        LA   READ_OK\n",
                "        WR   READ_OK\n",
                "        LDR  -READ_OK\n",
                "        ESET1 ERR_CONSTANTS"
            ),
            "Reads two offsets and reports once if either is missing.",
            "Načte dva posuny, a chybí-li některý, vydá jedno hlášení.",
        )],
        related: &["SA_READ", "SA_WRITE", "_ON_CMD", "CNF_GET_INT"],
        ..INSTRUCTION
    },
];
