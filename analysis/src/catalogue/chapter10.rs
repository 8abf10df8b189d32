//! Chapter 10: mapping of inputs and outputs.

use super::entry::{ConfigElement, Effect, Entry, NewCell, OperandKind, OperandSpec, Place};
use super::pattern::{INSTRUCTION, example, form, operand, text};

const fn bit(en: &'static str, cs: &'static str) -> OperandSpec {
    operand("bit", OperandKind::Declares(NewCell::Bit), en, cs)
}

const fn cell(en: &'static str, cs: &'static str) -> OperandSpec {
    operand("cell", OperandKind::Declares(NewCell::Real), en, cs)
}

const fn identifier(element: ConfigElement) -> OperandSpec {
    operand(
        "id",
        OperandKind::Identifier(element),
        "Attribute ID of the element: a literal in apostrophes or the label of a STR",
        "Atribut ID elementu: řetězec v apostrofech nebo návěští textu STR",
    )
}

const DEFAULT_BIT: OperandSpec = operand(
    "default",
    OperandKind::Number { min: 0, max: 1 },
    "Value when the configuration has no such element; without it 0",
    "Hodnota, když v konfiguraci takový element není; bez zadání 0",
)
.or_dash()
.or_nothing();
const DEFAULT_REAL: OperandSpec = operand(
    "default",
    OperandKind::RealConstant,
    "Value when the configuration has no such element; without it 0.0",
    "Hodnota, když v konfiguraci takový element není; bez zadání 0.0",
)
.or_dash()
.or_nothing();
const FAST: OperandSpec = operand(
    "raster",
    OperandKind::Keyword(&["FAST"]),
    "Transfer every millisecond, for MODULE_FAST; without it in the cycle of 20 ms",
    "Přenos každou milisekundu, pro MODULE_FAST; bez zadání v cyklu 20 ms",
)
.or_nothing();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "MAP_IN",
        chapter: "10.1",
        forms: &[
            form("MAP_IN bit, id"),
            form("MAP_IN bit, 'ID'"),
            form("MAP_IN bit, 'ID', default"),
            form("MAP_IN bit, 'ID', [default], FAST"),
        ],
        operands: &[
            bit(
                "Name of the bit, which this instruction declares",
                "Jméno bitu; deklaruje ho sama tato instrukce",
            ),
            identifier(ConfigElement::Input),
            DEFAULT_BIT,
            FAST,
        ],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares a binary input and binds it to an element of the channel configuration.",
            "Deklaruje binární vstup a naváže ho na prvek konfigurace kanálu.",
        ),
        description: text(
            "The bit follows the `Input` element with this ID in the ChannelConfig file, so wiring changes without \
             a change of the program. It must not be declared by DFM; it is known in all files, may be the state \
             bit of EDEF, and is shared with screens without SHARE_BIT.\n\n\
             An element with `Connected=\"1\"` gives the physical input, negated by `Invert`; one with \
             `Connected=\"0\"` gives its attribute `Default`. Without an element the bit holds `default`. Several \
             bits may name one input. Inputs are copied before MODULE_INPUT, with `FAST` before MODULE_FAST (this \
             implementation). RLO and DR stay.",
            "Bit sleduje element `Input` s tímto ID v souboru ChannelConfig, zapojení se tak mění bez zásahu do \
             programu. Nesmí být deklarován pomocí DFM; platí ve všech souborech, může být stavovým bitem EDEF a \
             obrazovky ho znají i bez SHARE_BIT.\n\n\
             Element s `Connected=\"1\"` dává fyzický vstup, negovaný podle `Invert`; s `Connected=\"0\"` svůj \
             atribut `Default`. Není-li element v konfiguraci, má bit hodnotu `default`. Jeden vstup smí uvést více \
             bitů. Vstupy se kopírují před MODULE_INPUT, s `FAST` před MODULE_FAST (tato implementace). RLO ani DR \
             se nemění.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        MAP_IN GUARD_SHUT,'GuardShut'\n",
                "        MAP_IN OIL_LOW,'OilLow',1\n",
                "        MAP_IN PROBE,'Probe',-,FAST\n",
                "MODULE_INIT_END"
            ),
            "Three inputs: without a default, with 1 as the safe value, and one for MODULE_FAST.",
            "Tři vstupy: bez náhradní hodnoty, s bezpečnou hodnotou 1 a jeden pro MODULE_FAST.",
        )],
        related: &["MAP_OUT", "DEF_IN", "FAST", "EDEF"],
        ..INSTRUCTION
    },
    Entry {
        name: "MAP_OUT",
        chapter: "10.1",
        forms: &[
            form("MAP_OUT bit, id"),
            form("MAP_OUT bit, 'ID'"),
            form("MAP_OUT bit, 'ID', default"),
            form("MAP_OUT bit, 'ID', [default], FAST"),
        ],
        operands: &[
            bit(
                "Name of the bit, which this instruction declares",
                "Jméno bitu; deklaruje ho sama tato instrukce",
            ),
            identifier(ConfigElement::Output),
            DEFAULT_BIT,
            FAST,
        ],
        place: Place::InitOrProcedure,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Declares a binary output and binds it to an element of the channel configuration.",
            "Deklaruje binární výstup a naváže ho na prvek konfigurace kanálu.",
        ),
        description: text(
            "What the program writes to the bit goes to the physical output of the `Output` element with this ID, \
             negated by its `Invert`. The bit must not be declared by DFM; it is known in all files and is shared \
             with screens without SHARE_BIT. At the start it holds `default`.\n\n\
             Several bits may drive one output: it is 1 when any of them is, and `Invert` comes last. Outputs are \
             copied after MODULE_MAIN, with `FAST` after MODULE_FAST (this implementation). RLO and DR stay.",
            "Co program do bitu zapíše, přejde na fyzický výstup elementu `Output` s tímto ID, negované podle jeho \
             `Invert`. Bit nesmí být deklarován pomocí DFM; platí ve všech souborech a obrazovky ho znají i bez \
             SHARE_BIT. Na začátku má hodnotu `default`.\n\n\
             Jeden výstup smí řídit více bitů: je 1, když je 1 kterýkoli z nich, a teprve potom se uplatní \
             `Invert`. Výstupy se kopírují po MODULE_MAIN, s `FAST` po MODULE_FAST (tato implementace). RLO ani DR \
             se nemění.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        MAP_OUT BEACON,'Beacon'\n",
                "        MAP_OUT TORCH,'Torch',0,FAST\n",
                "MODULE_INIT_END"
            ),
            "An ordinary output and one that MODULE_FAST drives.",
            "Běžný výstup a výstup, který řídí MODULE_FAST.",
        )],
        related: &["MAP_IN", "DEF_OUT", "FAST"],
        ..INSTRUCTION
    },
    Entry {
        name: "MAP_AIN",
        chapter: "10.5",
        forms: &[
            form("MAP_AIN cell, id"),
            form("MAP_AIN cell, 'ID'"),
            form("MAP_AIN cell, 'ID', default"),
            form("MAP_AIN cell, 'ID', [default], FAST"),
        ],
        operands: &[
            cell(
                "Name of the REAL cell, which this instruction declares",
                "Jméno buňky REAL; deklaruje ji sama tato instrukce",
            ),
            identifier(ConfigElement::AnalogInput),
            DEFAULT_REAL,
            FAST,
        ],
        place: Place::InitOrProcedure,
        writes: &[Effect::Memory],
        summary: text(
            "Declares an analogue input and binds it to an element of the channel configuration.",
            "Deklaruje analogový vstup a naváže ho na prvek konfigurace kanálu.",
        ),
        description: text(
            "The cell, 8 bytes of type REAL, follows the `AnalogInput` element with this ID: the voltage of the \
             physical input plus `Offset`, times `Scale`, held between `MinVal` and `MaxVal`. It must not be \
             declared by DS; it is known in all files and is shared without SHARE_VAR.\n\n\
             With `Connected=\"0\"` it holds the attribute `Default`, without an element `default`, which is \
             written with a decimal point. Inputs are copied before MODULE_INPUT, with `FAST` before MODULE_FAST \
             (this implementation). RLO and DR stay. Read the cell as `REAL.name`.",
            "Buňka, 8 bajtů typu REAL, sleduje element `AnalogInput` s tímto ID: k napětí fyzického vstupu se přičte \
             `Offset`, výsledek se vynásobí `Scale` a omezí na rozsah `MinVal` až `MaxVal`. Nesmí být deklarována \
             pomocí DS; platí ve všech souborech a sdílí se i bez SHARE_VAR.\n\n\
             Při `Connected=\"0\"` má hodnotu atributu `Default`, není-li element v konfiguraci, hodnotu `default`, \
             která se píše s desetinnou tečkou. Vstupy se kopírují před MODULE_INPUT, s `FAST` před MODULE_FAST \
             (tato implementace). RLO ani DR se nemění. Buňka se čte jako `REAL.jméno`.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        MAP_AIN AIR_BAR,'AirPressure',6.0\n",
                "MODULE_INIT_END\n",
                "MODULE_MAIN\n",
                "        LOD  REAL.AIR_BAR\n",
                "        LT   CNST.4.5\n",
                "        WR   AIR_LOW\n",
                "MODULE_MAIN_END"
            ),
            "Watches the air pressure; without the sensor in the configuration 6.0 is taken.",
            "Hlídá tlak vzduchu; není-li čidlo v konfiguraci, bere se 6.0.",
        )],
        related: &["MAP_AOUT", "DEF_IN", "REAL", "CAN_SYSIO_READ"],
        ..INSTRUCTION
    },
    Entry {
        name: "MAP_AOUT",
        chapter: "10.5",
        forms: &[
            form("MAP_AOUT cell, id"),
            form("MAP_AOUT cell, 'ID'"),
            form("MAP_AOUT cell, 'ID', default"),
            form("MAP_AOUT cell, 'ID', [default], FAST"),
        ],
        operands: &[
            cell(
                "Name of the REAL cell, which this instruction declares",
                "Jméno buňky REAL; deklaruje ji sama tato instrukce",
            ),
            identifier(ConfigElement::AnalogOutput),
            DEFAULT_REAL,
            FAST,
        ],
        place: Place::InitOrProcedure,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Declares an analogue output and binds it to an element of the channel configuration.",
            "Deklaruje analogový výstup a naváže ho na prvek konfigurace kanálu.",
        ),
        description: text(
            "The value of the cell, 8 bytes of type REAL, held between `MinVal` and `MaxVal` of the `AnalogOutput` \
             element with this ID, times `Scale`, plus `Offset`, is the voltage of the physical output. The cell \
             must not be declared by DS; it is known in all files and is shared without SHARE_VAR. At the start it \
             holds `default`, which is written with a decimal point.\n\n\
             Outputs are copied after MODULE_MAIN, with `FAST` after MODULE_FAST (this implementation). RLO and DR \
             stay. Write the cell as `REAL.name`.",
            "Hodnota buňky, 8 bajtů typu REAL, se omezí na rozsah `MinVal` až `MaxVal` elementu `AnalogOutput` s \
             tímto ID, vynásobí se `Scale` a přičte se `Offset`; výsledkem je napětí fyzického výstupu. Buňka nesmí \
             být deklarována pomocí DS; platí ve všech souborech a sdílí se i bez SHARE_VAR. Na začátku má hodnotu \
             `default`, která se píše s desetinnou tečkou.\n\n\
             Výstupy se kopírují po MODULE_MAIN, s `FAST` po MODULE_FAST (tato implementace). RLO ani DR se nemění. \
             Do buňky se zapisuje jako `REAL.jméno`.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        MAP_AOUT BELT_VOLTS,'BeltSpeed',0.0\n",
                "MODULE_INIT_END\n",
                "MODULE_MAIN\n",
                "        LOD  CNST.7.5\n",
                "        STO  REAL.BELT_VOLTS\n",
                "MODULE_MAIN_END"
            ),
            "The belt starts at rest and is then set to 7.5 V.",
            "Dopravník začíná v klidu a potom se nastaví na 7,5 V.",
        )],
        related: &["MAP_AIN", "DEF_OUT", "REAL"],
        ..INSTRUCTION
    },
];
