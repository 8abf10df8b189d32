//! Chapter 18: shared memory and structures.

use super::chapter27_words::SHARED_TYPES;
use super::entry::{
    Access, ConfigElement, Effect, Entry, Equation, OperandKind, OperandSpec, Place, Prefix, PrefixSet,
};
use super::pattern::{INSTRUCTION, MULTI_CYCLE, UNMODELLED_DATA, example, form, operand, source, text};

/// Length of a shared area in bytes (manual 18.3).
const AREA_LEN: i64 = 32_000;

const UNFILLED: &[OperandSpec] = &[operand(
    "content",
    OperandKind::OneOf(&[OperandKind::Keyword(&["?"]), OperandKind::Constant]),
    "`?` or a value, which has no effect; `n DUP (?)` for n elements",
    "`?` nebo hodnota, která nemá vliv; `n DUP (?)` pro n prvků",
)
.repeated()];

const NAME: OperandSpec = operand(
    "name",
    OperandKind::Identifier(ConfigElement::Shared),
    "Name for screens and dialogs: a literal in apostrophes or the label of a STR",
    "Jméno pro obrazovky a dialogy: řetězec v apostrofech nebo návěští textu STR",
);
const AREA: OperandSpec = operand(
    "area",
    OperandKind::Number { min: 0, max: 1 },
    "Shared area: 0 or 1",
    "Sdílená oblast: 0 nebo 1",
);
const OFFSET: OperandSpec = operand(
    "offset",
    source(PrefixSet::of(&[Prefix::Word, Prefix::Cnst]), PrefixSet::of(&[Prefix::Word, Prefix::Cnst])),
    "Offset in the area in bytes: a number or a WORD cell, mostly one that CONST_GET filled",
    "Posun v oblasti v bajtech: číslo nebo buňka WORD, obvykle naplněná pomocí CONST_GET",
);
const SIZE: OperandSpec = operand(
    "size",
    OperandKind::Number { min: 1, max: AREA_LEN },
    "Number of bytes to copy",
    "Počet kopírovaných bajtů",
);
const LIMITS: PrefixSet = PrefixSet::of(&[Prefix::Real]);

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "STRUC",
        chapter: "18.1",
        forms: &[form("name STRUC")],
        summary: text(
            "Begins the description of a structure, whose members are typed offsets.",
            "Začátek popisu struktury; její položky jsou posuny s typem.",
        ),
        description: text(
            "The name stands before it, without a colon. Between STRUC and ENDS each line names a member with DB, \
             DW, DD or DQ; a member is the offset of its first byte and has the width of its instruction. A \
             structure reserves no memory, it describes any: `base.MEMBER` is the cell at that offset behind `base`, \
             `(base+MEMBER+n)` counts further. `n DUP (?)` describes n elements; a value in place of `?` has no \
             effect (this implementation).\n\n\
             A type prefix before the access wins over the width of the member (this implementation). Structures \
             are known in all files (this implementation).",
            "Jméno stojí před ní, bez dvojtečky. Mezi STRUC a ENDS pojmenuje každý řádek jednu položku pomocí DB, \
             DW, DD nebo DQ; položka je posunem svého prvního bajtu a má šířku své instrukce. Struktura nevyhrazuje \
             paměť, jen popisuje kteroukoli: `základ.POLOŽKA` je buňka na tomto posunu za `základ`, \
             `(základ+POLOŽKA+n)` počítá dál. `n DUP (?)` popisuje n prvků; hodnota místo `?` nemá vliv (tato \
             implementace).\n\n\
             Prefix typu před přístupem má přednost před šířkou položky (tato implementace). Struktury platí ve \
             všech souborech (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "DATA\n",
                "TOOLDATA STRUC\n",
                "TOOL_NO  DW ?\n",
                "TOOL_LEN DD ?\n",
                "TOOLDATA ENDS\n",
                "DATA_END\n",
                "MODULE_MAIN\n",
                "        LOD  PLC_MEM_BACKUP.TOOL_LEN\n",
                "        STO  LENGTH\n",
                "MODULE_MAIN_END"
            ),
            "TOOL_LEN is the DWORD at offset 2 of the backed-up memory.",
            "TOOL_LEN je DWORD na posunu 2 v zálohované paměti.",
        )],
        related: &["ENDS", "DB", "DW", "DD", "DQ"],
        place: Place::DataOrFileLevel,
        ..UNMODELLED_DATA
    },
    Entry {
        name: "ENDS",
        chapter: "18.1",
        forms: &[form("name ENDS")],
        summary: text("Ends the description of a structure.", "Konec popisu struktury."),
        description: text(
            "Carries the name given at STRUC. Structures are not nested (this implementation).",
            "Nese jméno uvedené u STRUC. Struktury se nevnořují (tato implementace).",
        ),
        examples: &[example(
            concat!("PALLET   STRUC\n", "PALLET_X DD ?\n", "PALLET   ENDS"),
            "A structure with one member.",
            "Struktura s jedinou položkou.",
        )],
        related: &["STRUC", "DB"],
        place: Place::DataOrFileLevel,
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DB",
        chapter: "18.1",
        forms: &[form("member DB ?"), form("member DB n DUP (?)")],
        operands: UNFILLED,
        summary: text(
            "Describes a member of type BYTE in a structure.",
            "Popíše položku struktury typu BYTE.",
        ),
        description: text(
            "One line of a structure: the name of the member without a colon, the width, and `?`. The next member \
             lies 1 byte further.",
            "Jeden řádek struktury: jméno položky bez dvojtečky, šířka a `?`. Další položka leží o 1 bajt dál.",
        ),
        examples: &[example(
            concat!("DOORDATA STRUC\n", "DOOR_NO  DB ?\n", "DOOR_POS DW ?\n", "DOORDATA ENDS"),
            "DOOR_NO is the offset 0, DOOR_POS the offset 1.",
            "DOOR_NO je posun 0, DOOR_POS posun 1.",
        )],
        related: &["STRUC", "DW", "DD", "DQ"],
        place: Place::DataOrFileLevel,
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DW",
        chapter: "18.1",
        forms: &[form("member DW ?"), form("member DW n DUP (?)")],
        operands: UNFILLED,
        summary: text(
            "Describes a member of type WORD in a structure.",
            "Popíše položku struktury typu WORD.",
        ),
        description: text(
            "One line of a structure: the name of the member without a colon, the width, and `?`. The next member \
             lies 2 bytes further; nothing is aligned.",
            "Jeden řádek struktury: jméno položky bez dvojtečky, šířka a `?`. Další položka leží o 2 bajty dál; nic \
             se nezarovnává.",
        ),
        examples: &[example(
            concat!("SPINDATA STRUC\n", "SPIN_RPM DW ?\n", "SPINDATA ENDS"),
            "SPIN_RPM is 2 bytes wide.",
            "SPIN_RPM má šířku 2 bajty.",
        )],
        related: &["STRUC", "DB", "DD", "DQ"],
        place: Place::DataOrFileLevel,
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DD",
        chapter: "18.1",
        forms: &[form("member DD ?"), form("member DD n DUP (?)")],
        operands: UNFILLED,
        summary: text(
            "Describes a member of type DWORD in a structure.",
            "Popíše položku struktury typu DWORD.",
        ),
        description: text(
            "One line of a structure: the name of the member without a colon, the width, and `?`. The next member \
             lies 4 bytes further; nothing is aligned.",
            "Jeden řádek struktury: jméno položky bez dvojtečky, šířka a `?`. Další položka leží o 4 bajty dál; nic \
             se nezarovnává.",
        ),
        examples: &[example(
            concat!("AXISDATA STRUC\n", "AXIS_POS DD ?\n", "AXISDATA ENDS"),
            "AXIS_POS is 4 bytes wide.",
            "AXIS_POS má šířku 4 bajty.",
        )],
        related: &["STRUC", "DB", "DW", "DQ"],
        place: Place::DataOrFileLevel,
        ..UNMODELLED_DATA
    },
    Entry {
        name: "DQ",
        chapter: "18.1",
        forms: &[form("member DQ ?"), form("member DQ n DUP (?)")],
        operands: UNFILLED,
        summary: text(
            "Describes a member of type QWORD or REAL in a structure.",
            "Popíše položku struktury typu QWORD nebo REAL.",
        ),
        description: text(
            "One line of a structure: the name of the member without a colon, the width, and `?`. The next member \
             lies 8 bytes further. An access says `QWRD.` or `REAL.`, because 8 bytes may be either (this \
             implementation).",
            "Jeden řádek struktury: jméno položky bez dvojtečky, šířka a `?`. Další položka leží o 8 bajtů dál. \
             Přístup se píše s `QWRD.` nebo `REAL.`, protože 8 bajtů může být obojí (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "DATA\n",
                "WEARDATA STRUC\n",
                "WEAR_NO  DB ?\n",
                "WEAR_MM  DQ ?\n",
                "WEARDATA ENDS\n",
                "DATA_END\n",
                "MODULE_MAIN\n",
                "        LOD  REAL.PLC_MEM_BACKUP.WEAR_MM\n",
                "        STO  REAL.WEAR\n",
                "MODULE_MAIN_END"
            ),
            "Reads a REAL from the backed-up memory.",
            "Přečte ze zálohované paměti hodnotu REAL.",
        )],
        related: &["STRUC", "DB", "DW", "DD"],
        place: Place::DataOrFileLevel,
        ..UNMODELLED_DATA
    },
    Entry {
        name: "SHARE_VAR",
        chapter: "18.2",
        forms: &[form("SHARE_VAR cell, 'name', type [,min] [,max]"), form("SHARE_VAR cell, name, type")],
        operands: &[
            operand(
                "cell",
                OperandKind::Address(Access::Read),
                "Cell, area or text to publish, with an optional offset `+n` or `+BX`",
                "Zveřejněná buňka, oblast nebo text, případně s posunem `+n` nebo `+BX`",
            ),
            NAME,
            operand(
                "type",
                OperandKind::Keyword(SHARED_TYPES),
                "Type under which screens see the cell",
                "Typ, pod kterým buňku vidí obrazovky",
            ),
            operand(
                "min",
                OperandKind::OneOf(&[OperandKind::Number { min: 1, max: AREA_LEN }, source(LIMITS, LIMITS)]),
                "REAL cell with the smallest value; with TYPE_STR and TYPE_BIN the length in bytes, a number",
                "Buňka REAL s nejmenší hodnotou; u TYPE_STR a TYPE_BIN délka v bajtech, číslo",
            )
            .or_dash()
            .or_nothing(),
            operand(
                "max",
                source(LIMITS, LIMITS),
                "REAL cell with the largest value",
                "Buňka REAL s největší hodnotou",
            )
            .or_dash()
            .or_nothing(),
        ],
        equation: Equation::Overwrite,
        place: Place::InitOrProcedure,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Publishes a cell under a name for screens and dialogs; RLO 1 when accepted.",
            "Zveřejní buňku pod jménem pro obrazovky a dialogy; RLO je 1, když byla přijata.",
        ),
        description: text(
            "Screens, dialogs and the oscilloscope then read the cell by the name; they can't write it, DEF_IN \
             makes a cell that they can. One cell may have several names. Bits are published by SHARE_BIT; cells \
             of DEF_IN, DEF_OUT and of the MAP_ instructions are shared already.\n\n\
             `min` and `max` are REAL cells even for an integer, declared by `DS 8` and written without a prefix; \
             they are read whenever the screen asks (this implementation). When a new program is loaded while \
             debugging, a name is unknown until its window or dialog is opened again. DR stays (this \
             implementation).",
            "Obrazovky, dialogy a osciloskop pak buňku pod tímto jménem čtou; zapsat do ní nemohou, k tomu slouží \
             buňka z DEF_IN. Jedna buňka smí mít více jmen. Bity zveřejňuje SHARE_BIT; buňky z DEF_IN, DEF_OUT a z \
             instrukcí MAP_ jsou sdílené automaticky.\n\n\
             `min` a `max` jsou buňky REAL i u celých čísel, deklarují se jako `DS 8` a píší se bez prefixu; čtou \
             se pokaždé, když se obrazovka zeptá (tato implementace). Po zavedení nového programu při ladění je \
             jméno neznámé, dokud se okno nebo dialog znovu neotevře. DR se nemění (tato implementace).",
        ),
        errors: text(
            "RLO is 1 when the cell is shared, 0 when it was not accepted, for instance because the name is taken.",
            "RLO je 1, když je buňka sdílena, a 0, když nebyla přijata, například proto, že je jméno obsazeno.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        LOD  CNST.0.0\n",
                "        STO  REAL.LOWEST\n",
                "        LOD  CNST.200.0\n",
                "        STO  REAL.HIGHEST\n",
                "        SHARE_VAR LENGTH,'ToolLength',TYPE_DWORD,LOWEST,HIGHEST\n",
                "        SHARE_VAR TITLE,'Title',TYPE_STR\n",
                "        SHARE_VAR TABLE+10,'Pattern',TYPE_BIN,16\n",
                "MODULE_INIT_END"
            ),
            "A number with limits, a text, and 16 bytes of an area.",
            "Číslo s mezemi, text a 16 bajtů z oblasti.",
        )],
        related: &["SHARE_BIT", "DEF_IN", "TYPE_DWORD"],
        ..INSTRUCTION
    },
    Entry {
        name: "SHARE_BIT",
        chapter: "18.2",
        forms: &[form("SHARE_BIT cell, 'name', bit"), form("SHARE_BIT cell, name, bit")],
        operands: &[
            operand(
                "cell",
                OperandKind::Address(Access::Read),
                "Where the bit lies: the label of its DFM, or another cell with an optional offset `+n` or `+BX`",
                "Kde bit leží: návěští jeho DFM, nebo jiná buňka, případně s posunem `+n` nebo `+BX`",
            ),
            NAME,
            operand(
                "bit",
                OperandKind::BitPosition,
                "Bit of a DFM, which gives the position in the byte",
                "Bit z DFM; určuje pozici v bajtu",
            ),
        ],
        equation: Equation::Overwrite,
        place: Place::InitOrProcedure,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Publishes a bit under a name for screens and dialogs; RLO 1 when accepted.",
            "Zveřejní bit pod jménem pro obrazovky a dialogy; RLO je 1, když byl přijat.",
        ),
        description: text(
            "The byte comes from the first operand, the position in it from the last, so one bit name serves a whole \
             array of status bytes. Screens read the bit but can't write it; DEF_IN makes one that they can. When a \
             new program is loaded while debugging, the name is unknown until its window or dialog is opened again. \
             DR stays (this implementation).",
            "Bajt určuje první operand, pozici v něm poslední, jedno jméno bitu tak poslouží celému poli stavových \
             bajtů. Obrazovky bit čtou, zapsat ho nemohou; k tomu slouží bit z DEF_IN. Po zavedení nového programu \
             při ladění je jméno neznámé, dokud se okno nebo dialog znovu neotevře. DR se nemění (tato \
             implementace).",
        ),
        errors: text(
            "RLO is 1 when the bit is shared, 0 when it was not accepted, for instance because the name is taken.",
            "RLO je 1, když je bit sdílen, a 0, když nebyl přijat, například proto, že je jméno obsazeno.",
        ),
        examples: &[example(
            concat!(
                "MODULE_INIT\n",
                "        SHARE_BIT ALARMS,'AirLow',AIR_LOW\n",
                "        SHARE_BIT ALARMS+1,'AirLow2',AIR_LOW\n",
                "MODULE_INIT_END"
            ),
            "The bit itself, and the bit at the same position in the next byte.",
            "Bit samotný a bit na téže pozici v dalším bajtu.",
        )],
        related: &["SHARE_VAR", "DEF_IN", "DFM"],
        ..INSTRUCTION
    },
    Entry {
        name: "SA_READ",
        chapter: "18.3",
        forms: &[form("SA_READ area, offset, size, cell")],
        operands: &[
            AREA,
            OFFSET,
            SIZE,
            operand(
                "cell",
                OperandKind::Address(Access::Write),
                "Where the bytes go: a cell, an area or a text of at least `size` bytes",
                "Kam se bajty uloží: buňka, oblast nebo text o nejméně `size` bajtech",
            ),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Copies bytes from a shared area to the program.",
            "Zkopíruje bajty ze sdílené oblasti do programu.",
        ),
        description: text(
            "The two shared areas, 32000 bytes each, are common to the program, to the screens and to all channels. \
             While the instruction copies, nobody else touches the area, so several bytes are consistent. Offsets \
             come best from constants that the screens use too.\n\n\
             Usually EX0 follows, which holds the mechanism until RLO is 1. As EX0 would wait for ever after an \
             error, test DR when the offset is not certain.",
            "Dvě sdílené oblasti, každá o 32000 bajtech, jsou společné programu, obrazovkám a všem kanálům. Dokud \
             instrukce kopíruje, nikdo jiný do oblasti nepřistoupí, více bajtů je tedy konzistentních. Posuny je \
             nejlépe brát z konstant, které používají i obrazovky.\n\n\
             Obvykle následuje EX0, která podrží mechanismus, dokud není RLO 1. Po chybě by EX0 čekala navždy, \
             není-li tedy posun jistý, testujte DR.",
        ),
        errors: text(
            "RLO 1: done. RLO 0 and DR 0: the area is locked now, try again in the next cycle. RLO 0 and DR not 0: \
             the block does not lie within the area, `offset` + `size` is over 32000 (this implementation).",
            "RLO 1: hotovo. RLO 0 a DR 0: oblast je právě zamčena, zkuste to v dalším cyklu. RLO 0 a DR nenulové: \
             blok neleží v oblasti, `offset` + `size` přesahuje 32000 (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        MECH_BEGIN FETCH_FEED\n",
                "        SA_READ 0,OFFS_FEED,8,FEED\n",
                "        EX0\n",
                "        LOD  REAL.FEED\n",
                "        STO  REAL.GAIN\n",
                "        MECH_END FETCH_FEED"
            ),
            "Fetches a REAL whose offset CONST_GET has read.",
            "Načte REAL, jehož posun předtím přečetla CONST_GET.",
        )],
        related: &["SA_WRITE", "CONST_GET", "EX0", "SHARE_VAR"],
        executable: true,
        ..MULTI_CYCLE
    },
    Entry {
        name: "SA_WRITE",
        chapter: "18.3",
        forms: &[form("SA_WRITE area, offset, size, cell")],
        operands: &[
            AREA,
            OFFSET,
            SIZE,
            operand(
                "cell",
                OperandKind::Address(Access::Read),
                "Where the bytes come from: a cell, an area or a text of at least `size` bytes",
                "Odkud se bajty berou: buňka, oblast nebo text o nejméně `size` bajtech",
            ),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr64, Effect::Memory],
        summary: text(
            "Copies bytes from the program to a shared area.",
            "Zkopíruje bajty z programu do sdílené oblasti.",
        ),
        description: text(
            "The counterpart of SA_READ: the bytes become visible to the screens and to the other channels all at \
             once. To show a cell on a screen, SHARE_VAR is simpler.",
            "Protějšek SA_READ: bajty se obrazovkám a ostatním kanálům objeví všechny najednou. K zobrazení buňky na \
             obrazovce je jednodušší SHARE_VAR.",
        ),
        errors: text(
            "RLO 1: done. RLO 0 and DR 0: the area is locked now, try again in the next cycle. RLO 0 and DR not 0: \
             the block does not lie within the area, `offset` + `size` is over 32000 (this implementation).",
            "RLO 1: hotovo. RLO 0 a DR 0: oblast je právě zamčena, zkuste to v dalším cyklu. RLO 0 a DR nenulové: \
             blok neleží v oblasti, `offset` + `size` přesahuje 32000 (tato implementace).",
        ),
        examples: &[example(
            concat!(
                "        MECH_BEGIN TELL_STATE\n",
                "AGAIN:  EX\n",
                "        SA_WRITE 0,OFFS_STATE,4,STATE\n",
                "        EX0\n",
                "        JUM  AGAIN\n",
                "        MECH_END TELL_STATE"
            ),
            "Keeps a DWORD in the shared area up to date.",
            "Udržuje ve sdílené oblasti aktuální hodnotu DWORD.",
        )],
        related: &["SA_READ", "CONST_GET", "EX0", "SHARE_VAR"],
        executable: true,
        ..MULTI_CYCLE
    },
];
