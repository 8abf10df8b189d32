//! Chapter 12: spindles and rotary axes.

use super::entry::{Access, Effect, Entry, OperandKind, OperandSpec, Prefix, PrefixSet};
use super::pattern::{
    AXIS, CELLS, COUNTERS, INSTRUCTION, MESSAGE_VALUE, VALUES, WORD_CELL, example, form, operand, source,
    text,
};

/// A port or the cell that holds its number.
const PORT: OperandKind =
    OperandKind::OneOf(&[OperandKind::Number { min: 1, max: 16 }, source(PrefixSet::NONE, COUNTERS)]);
/// Letters of axes that may stand instead of a number, for the reader only.
const AXIS_LETTERS: OperandKind =
    OperandKind::KeywordOrNumber(&["X", "Y", "Z", "A", "B", "C", "U", "V", "W"], 1, 16);
/// The role a spindle gets, as a word or number; 3, 5 and S all mean SET.
const ROLE: OperandKind = OperandKind::OneOf(&[
    OperandKind::KeywordOrNumber(&["OFF", "MAIN", "ASSIST", "SET", "S"], 0, 3),
    OperandKind::Number { min: 5, max: 5 },
]);
/// A signed or unsigned word by value.
const OUTPUT_WORD: OperandKind =
    OperandKind::OneOf(&[OperandKind::Number { min: -0x8000, max: 0xFFFF }, WORD_CELL]);
/// The value that RAMP moves.
const RAMPED: OperandKind = OperandKind::Data {
    access: Access::ReadWrite,
    prefixes: PrefixSet::of(&[Prefix::Byte, Prefix::Word, Prefix::Dwrd]),
    declared: CELLS,
    negatable: false,
};
/// The step of RAMP.
const STEP: OperandKind = source(VALUES, VALUES);

/// The output value of an instruction that needs it or `-`.
const OUTPUT: OperandSpec = operand(
    "value",
    OUTPUT_WORD,
    "Signed 16-bit value, 7FFFh is full positive voltage; with `-` or NIL it is taken from DR",
    "Hodnota 16 bitů se znaménkem, 7FFFh je plné kladné napětí; s `-` nebo NIL se bere z DR",
)
.or_dash();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "ANALOG_PORT",
        chapter: "12.2",
        forms: &[form("ANALOG_PORT port")],
        operands: &[operand(
            "port",
            PORT,
            "Number of the analogue output, 1 to 16",
            "Číslo analogového výstupu 1 až 16",
        )],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Chooses the analogue output that following ANALOG instructions drive.",
            "Zvolí analogový výstup, který budou řídit následující instrukce ANALOG.",
        ),
        description: text(
            "Makes `port` the active output of the ordinary spindle: an ANALOG with at most one operand \
             sends its value there. The choice holds until the next ANALOG_PORT is executed, so with a \
             single ordinary spindle one in MODULE_INIT is enough. Ports of rotary axes stay as they are, \
             AX_SPI assigns them.\n\n\
             Behind the port is an output of the servo unit or a drive on CAN-BUS, whichever DriveChannel \
             of the channel configuration names. An ordinary spindle may use any free port, even that of \
             an axis the machine does not have. RLO and DR stay (this implementation). A cell that holds \
             the number is taken too, with a warning, because the number is then checked only at run time \
             (this implementation).",
            "Učiní `port` aktivním výstupem obyčejného vřetene: ANALOG s nejvýše jedním operandem na něj \
             posílá svou hodnotu. Volba platí až do provedení další instrukce ANALOG_PORT, s jediným \
             obyčejným vřetenem tedy stačí jedna v MODULE_INIT. Porty rotačních os se nemění, ty přiřazuje \
             AX_SPI.\n\n\
             Za portem je výstup servojednotky nebo pohon na CAN-BUS, podle DriveChannel v konfiguraci \
             kanálu. Obyčejné vřeteno smí použít kterýkoli volný port, i port osy, kterou stroj nemá. RLO \
             ani DR se nemění (tato implementace). Lze uvést i buňku s číslem portu, ale s varováním, \
             protože číslo se pak kontroluje až za běhu (tato implementace).",
        ),
        errors: text(
            "None is reported. Before the first ANALOG_PORT no port is active and ANALOG changes no output \
             (this implementation).",
            "Žádná se nehlásí. Před první instrukcí ANALOG_PORT není aktivní žádný port a ANALOG žádný \
             výstup nezmění (tato implementace).",
        ),
        examples: &[example(
            concat!("        ANALOG_PORT 5\n", "        LOD  VYSOVERS\n", "        ANALOG"),
            "The speed with the S override goes to the output 5.",
            "Otáčky s korekcí S se pošlou na výstup 5.",
        )],
        related: &["ANALOG", "AX_SPI", "RAMP"],
        ..INSTRUCTION
    },
    Entry {
        name: "ANALOG",
        chapter: "12.2",
        forms: &[
            form("ANALOG"),
            form("ANALOG value"),
            form("ANALOG value, axis"),
            form("ANALOG value, axis, spindle"),
            form("ANALOG -, axis [,spindle]"),
        ],
        operands: &[
            OUTPUT.or_nothing(),
            operand(
                "axis",
                AXIS_LETTERS,
                "Number 1 to 16 or letter (X, Y, Z, A, B, C, U, V, W) of the rotary axis: the value goes to its \
                 port, not to the one of ANALOG_PORT",
                "Číslo 1 až 16 nebo písmeno (X, Y, Z, A, B, C, U, V, W) rotační osy: hodnota jde na její port, ne \
                 na port z ANALOG_PORT",
            )
            .or_nothing(),
            operand(
                "spindle",
                OperandKind::Number { min: 0, max: 2 },
                "1 main spindle, 2 auxiliary spindle; 0 as if left out",
                "1 hlavní vřeteno, 2 pomocné vřeteno; 0 jako bez operandu",
            )
            .or_nothing(),
        ],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Sends a value to an analogue output or to a rotary axis working as spindle.",
            "Pošle hodnotu na analogový výstup nebo rotační ose pracující jako vřeteno.",
        ),
        description: text(
            "The value has 16 bits in two's complement: 7FFFh is full positive, -7FFFh full negative \
             voltage, 10 V. Larger magnitudes are cut to these bounds, also -32768 (this implementation). \
             Without a value, or with `-` or NIL in its place, DR16 is sent.\n\n\
             With at most one operand the value goes to the port that ANALOG_PORT chose. With two it goes \
             to the port of the rotary axis that AX_SPI has switched to spindle; a letter instead of the \
             number only helps the reader, the axis of the last AX_SPI is meant then (this \
             implementation). The third operand, for machines with two rotary axes, follows the role: 1 \
             is whichever axis is main spindle now, 2 the auxiliary one. RLO and DR stay (this \
             implementation).",
            "Hodnota má 16 bitů ve dvojkovém doplňku: 7FFFh je plné kladné, -7FFFh plné záporné napětí, \
             tedy 10 V. Větší velikosti se omezí na tyto meze, také -32768 (tato implementace). Bez \
             hodnoty, nebo s `-` či NIL na jejím místě, se pošle DR16.\n\n\
             S nejvýše jedním operandem jde hodnota na port zvolený instrukcí ANALOG_PORT. Se dvěma jde na \
             port rotační osy, kterou AX_SPI přepnulo na vřeteno; písmeno místo čísla je jen pro názornost \
             a znamená osu poslední instrukce AX_SPI (tato implementace). Třetí operand, pro stroje se \
             dvěma rotačními osami, sleduje úlohu: 1 je osa, která je právě hlavním vřetenem, 2 pomocným. \
             RLO ani DR se nemění (tato implementace).",
        ),
        errors: text(
            "None is reported. A rotary axis that is not switched to spindle takes no value.",
            "Žádná se nehlásí. Rotační osa, která není přepnuta na vřeteno, hodnotu nepřijme.",
        ),
        examples: &[
            example(
                concat!(
                    "        LDR  ZMSSPI\n",
                    "        JL0  NO_S\n",
                    "        LOD  WORD.PB11\n",
                    "        ANALOG_PORT 7\n",
                    "        ANALOG\n",
                    "NO_S:"
                ),
                "A newly programmed S goes to the ordinary spindle on port 7.",
                "Nově programované S se pošle obyčejnému vřetenu na portu 7.",
            ),
            example(
                concat!("        ANALOG SPEED_1,4,1\n", "        ANALOG SPEED_2,4,2"),
                "One value for the main spindle, one for the auxiliary one, whichever axes they are.",
                "Jedna hodnota pro hlavní, druhá pro pomocné vřeteno, ať jsou to kterékoli osy.",
            ),
        ],
        related: &["ANALOG_PORT", "ANALOG_SPI", "AX_SPI", "RAMP"],
        ..INSTRUCTION
    },
    Entry {
        name: "SPI_AX",
        chapter: "12.4",
        forms: &[
            form("SPI_AX feed1, feed2, angle, accel, axis"),
            form("SPI_AX -, -, -, -, axis"),
            form("SPI_AX feed1, feed2, angle, accel"),
        ],
        operands: &[
            operand(
                "feed1",
                OUTPUT_WORD,
                "Speed up to the zero pulse in 1/1000 ° per minute, the sign is the direction; otherwise \
                 RefSpeedLow",
                "Rychlost až na nulový pulz v 1/1000 ° za minutu, znaménko určuje směr; jinak RefSpeedLow",
            )
            .or_dash(),
            operand(
                "feed2",
                OUTPUT_WORD,
                "Speed of the additional rotation in 1/1000 ° per minute, with sign; otherwise RefSpeedLow",
                "Rychlost přídavného natočení v 1/1000 ° za minutu se znaménkem; jinak RefSpeedLow",
            )
            .or_dash(),
            operand(
                "angle",
                source(MESSAGE_VALUE, MESSAGE_VALUE),
                "Additional rotation from the zero pulse in 1/1000 °, 0 none; otherwise PosAfterRef",
                "Přídavné natočení od nulového pulzu v 1/1000 °, 0 žádné; jinak PosAfterRef",
            )
            .or_dash(),
            operand(
                "accel",
                OUTPUT_WORD,
                "Ramp of all phases in mm/s²; otherwise Acceleration",
                "Rampa všech fází v mm/s²; jinak Acceleration",
            )
            .or_dash(),
            AXIS.or_nothing(),
        ],
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Switches a spindle to an axis and positions it to its zero pulse.",
            "Přepne vřeteno na osu a napolohuje ji na nulový pulz.",
        ),
        description: text(
            "Closes the position loop of the axis and starts a positioning that runs by itself: the axis \
             moves at `feed1` over the zero pulse, stops by the ramp, then turns by `angle` at `feed2`. \
             The angle counts from the zero pulse, so the axis may move back. With RefSwitch the zero \
             pulse is looked for only after the reference switch. Each of the first four operands may be \
             `-` or NIL; the attribute of the axis then decides.\n\n\
             `POLOHV_X` to `POLOHV_16` is 1 all the time and falls at the end: the program waits for that \
             with EX1. Several axes may be positioned at once. Without `axis` the axis of the last AX_SPI \
             is meant, which is worth a warning (this implementation). RLO and DR stay (this \
             implementation).",
            "Uzavře polohovou vazbu osy a spustí polohování, které dál běží samo: osa přejede rychlostí \
             `feed1` nulový pulz, po rampě zastaví a pak se rychlostí `feed2` natočí o `angle`. Úhel se \
             počítá od nulového pulzu, osa se tedy může i vracet. S RefSwitch se nulový pulz hledá až za \
             referenčním spínačem. Každý z prvních čtyř operandů může být `-` nebo NIL; rozhodne pak \
             atribut osy.\n\n\
             `POLOHV_X` až `POLOHV_16` je po celou dobu 1 a na konci spadne: program na to čeká pomocí \
             EX1. Více os se smí polohovat současně. Bez `axis` se myslí osa poslední instrukce AX_SPI, na \
             což upozorní varování (tato implementace). RLO ani DR se nemění (tato implementace).",
        ),
        errors: text(
            "The positioning ends early when the program clears the `POLOHV_` bit of the axis, when STOP is \
             active, without the motion enable of the axis or on its limit switch. `POLOHV_` is 0 then as \
             after success; whether the axis is referenced tells its bit of HOMING.",
            "Polohování skončí předčasně, když program vynuluje bit `POLOHV_` osy, při STOP, bez povolení \
             pohybu osy nebo na jejím limitním spínači. `POLOHV_` je pak 0 stejně jako po úspěchu; zda má \
             osa referenci, říká její bit v HOMING.",
        ),
        examples: &[example(
            concat!(
                "        SPI_AX -,-,TURN_BY,-,4\n",
                "        EX\n",
                "        LDR  POLOHV_4\n",
                "        TEX1 -,500,FAULT,ERR_SPINDLE"
            ),
            "Orients the spindle of axis 4 and waits at most 10 s.",
            "Natočí vřeteno osy 4 a čeká nejvýše 10 s.",
        )],
        related: &["AX_SPI", "SPI_MAIN", "EX1"],
        ..INSTRUCTION
    },
    Entry {
        name: "AX_SPI",
        chapter: "12.4",
        forms: &[form("AX_SPI axis"), form("AX_SPI axis, 0|1|2|3"), form("AX_SPI axis, OFF|MAIN|ASSIST|SET")],
        operands: &[
            AXIS,
            operand(
                "spindle",
                ROLE,
                "0 OFF, 1 MAIN, 2 ASSIST, 3 SET; `S` and 5 also mean SET",
                "0 OFF, 1 MAIN, 2 ASSIST, 3 SET; také `S` a 5 znamenají SET",
            )
            .or_nothing(),
        ],
        writes: &[Effect::Memory],
        summary: text("Switches a rotary axis to a spindle.", "Přepne rotační osu na vřeteno."),
        description: text(
            "Opens the position loop of the axis and lets the program give its speed: the port of the \
             axis becomes the one that ANALOG with two operands drives. MAIN makes it the main spindle at \
             the first place of the screen, ASSIST the auxiliary one at the second, OFF switches the \
             spindle off, SET leaves the roles as SPI_MAIN or the last AX_SPI gave them. Without the \
             second operand SET is meant, and the axis becomes main when there is no main spindle (this \
             implementation).\n\n\
             Feed per revolution (G95) and threading (G33) follow the main spindle. Both roles may be \
             taken at once (this implementation). Only as spindle may the program drive the axis, as axis \
             it belongs to the control; SPI_AX switches back. An axis whose speed is simulated through \
             SIM_SPEED_PT must not be switched. RLO and DR stay (this implementation).",
            "Rozpojí polohovou vazbu osy a otáčky pak zadává program: port osy se stane tím, který řídí \
             ANALOG se dvěma operandy. MAIN z ní udělá hlavní vřeteno na prvním místě obrazovky, ASSIST \
             pomocné na druhém, OFF vřeteno vypne, SET ponechá úlohy tak, jak je určilo SPI_MAIN nebo \
             poslední AX_SPI. Bez druhého operandu se myslí SET, a není-li žádné hlavní vřeteno, stane se \
             jím tato osa (tato implementace).\n\n\
             Otáčkový posuv (G95) a závitování (G33) sledují hlavní vřeteno. Obsazeny smějí být obě úlohy \
             současně (tato implementace). Program smí osu řídit jen jako vřeteno, jako osa patří systému; \
             zpět ji přepne SPI_AX. Osa, jejíž otáčky se simulují přes SIM_SPEED_PT, se přepínat nesmí. RLO \
             ani DR se nemění (tato implementace).",
        ),
        errors: text(
            "None is reported. The switched axis loses its reference: clear its bit of HOMING.",
            "Žádná se nehlásí. Přepnutá osa ztrácí referenci: vynulujte její bit v HOMING.",
        ),
        examples: &[example(
            concat!(
                "        AX_SPI 4,MAIN\n",
                "        AX_SPI 5,ASSIST\n",
                "        ANALOG SPEED_1,4,1\n",
                "        ANALOG SPEED_2,5,2"
            ),
            "Two rotary axes become spindles and get their speeds by role.",
            "Dvě rotační osy se stanou vřeteny a dostanou otáčky podle úlohy.",
        )],
        related: &["SPI_AX", "SPI_MAIN", "ANALOG", "ANALOG_SPI"],
        ..INSTRUCTION
    },
    Entry {
        name: "SPI_MAIN",
        chapter: "12.4",
        forms: &[form("SPI_MAIN axis")],
        operands: &[AXIS],
        writes: &[Effect::Memory],
        summary: text("Chooses the main spindle.", "Zvolí hlavní vřeteno."),
        description: text(
            "From now on feed per revolution (G95) and threading (G33) follow this axis. Nothing else \
             changes: the axis is not switched between axis and spindle and the screen keeps its order. \
             The former main spindle becomes the auxiliary one (this implementation). For an axis that is \
             not a spindle the choice is kept until AX_SPI switches it (this implementation). RLO and DR \
             stay (this implementation).",
            "Otáčkový posuv (G95) a závitování (G33) se od této chvíle řídí touto osou. Nic dalšího se \
             nemění: osa se nepřepíná mezi osou a vřetenem a pořadí na obrazovce zůstává. Dosavadní hlavní \
             vřeteno se stane pomocným (tato implementace). U osy, která není vřetenem, se volba zapamatuje \
             do jejího přepnutí instrukcí AX_SPI (tato implementace). RLO ani DR se nemění (tato \
             implementace).",
        ),
        examples: &[example(
            concat!(
                "        LDR  SUB_SPINDLE\n",
                "        JL1  SECOND\n",
                "        SPI_MAIN 4\n",
                "        JUM  CHOSEN\n",
                "SECOND: SPI_MAIN 5\n",
                "CHOSEN:"
            ),
            "Threads are cut with the spindle that holds the part.",
            "Závity se řežou s vřetenem, které drží obrobek.",
        )],
        related: &["AX_SPI", "ANALOG"],
        ..INSTRUCTION
    },
    Entry {
        name: "ANALOG_SPI",
        chapter: "12.4",
        forms: &[form("ANALOG_SPI value, axis"), form("ANALOG_SPI -, axis")],
        operands: &[OUTPUT, AXIS],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Sends a value to an axis that works as spindle, by the number of the axis.",
            "Pošle hodnotu ose pracující jako vřeteno podle čísla osy.",
        ),
        description: text(
            "The value goes to the named axis, whatever role it has and whichever AX_SPI ran last. The \
             number is that of the axis, not that of an analogue output. The value has 16 bits in two's \
             complement, -7FFFh to 7FFFh; larger magnitudes are cut (this implementation). With `-` or \
             NIL DR16 is sent. RLO and DR stay (this implementation).",
            "Hodnota jde na uvedenou osu bez ohledu na její úlohu a na to, které AX_SPI proběhlo naposled. \
             Číslo znamená osu, ne analogový výstup. Hodnota má 16 bitů ve dvojkovém doplňku, -7FFFh až \
             7FFFh; větší velikosti se omezí (tato implementace). S `-` nebo NIL se pošle DR16. RLO ani DR \
             se nemění (tato implementace).",
        ),
        errors: text(
            "None is reported. An axis that is not switched to spindle ignores the value (this \
             implementation).",
            "Žádná se nehlásí. Osa, která není přepnuta na vřeteno, hodnotu nepřijme (tato implementace).",
        ),
        examples: &[example(
            concat!("        ANALOG_SPI SPEED_1,4\n", "        LOD  CNST.0\n", "        ANALOG_SPI -,5"),
            "Axis 4 gets its speed, axis 5 stops.",
            "Osa 4 dostane otáčky, osa 5 se zastaví.",
        )],
        related: &["ANALOG", "AX_SPI", "SPI_MAIN"],
        ..INSTRUCTION
    },
    Entry {
        name: "RAMP",
        chapter: "12.8",
        forms: &[form("RAMP value, accel"), form("RAMP TYPE.value, accel")],
        operands: &[
            operand(
                "value",
                RAMPED,
                "Cell that follows DR; read and written, at its own width and with sign",
                "Buňka, která sleduje DR; čte se i zapisuje ve své šířce a se znaménkem",
            ),
            operand(
                "accel",
                STEP,
                "Largest change in one execution: cell or constant",
                "Největší změna při jednom provedení: buňka nebo konstanta",
            ),
        ],
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr, Effect::Memory],
        summary: text(
            "Moves a value towards DR by at most the given step and leaves it in DR.",
            "Posune hodnotu směrem k DR nejvýše o zadaný krok a ponechá ji v DR.",
        ),
        description: text(
            "DR holds the demanded value. Each execution brings the cell nearer by at most `accel` and \
             stops exactly on the demand; afterwards DR has the new content of the cell with its sign \
             extended, so that ANALOG can follow. It must be executed once in every cycle: the slope is \
             `accel` per 20 ms in MODULE_MAIN and `accel` per 1 ms in MODULE_FAST. A negative step counts \
             as positive, zero holds the value (this implementation). RLO stays (this implementation).\n\n\
             It spares drives of rotary axes a step of the demanded speed. REQ_SPEED_PM and REQ_SPEED_PT \
             do not know of it.",
            "V DR je požadovaná hodnota. Každé provedení k ní buňku přiblíží nejvýše o `accel` a zastaví se \
             přesně na ní; v DR pak zůstane nový obsah buňky s rozšířeným znaménkem, takže může následovat \
             ANALOG. Instrukce se musí provádět jednou v každém cyklu: strmost je `accel` za 20 ms v \
             MODULE_MAIN a `accel` za 1 ms v MODULE_FAST. Záporný krok platí jako kladný, nula hodnotu drží \
             (tato implementace). RLO se nemění (tato implementace).\n\n\
             Ušetří pohony rotačních os skokové změny požadovaných otáček. REQ_SPEED_PM a REQ_SPEED_PT o ní \
             nevědí.",
        ),
        errors: text(
            "None. Placed behind a wait of a mechanism or in a branch that is skipped it simply does not \
             move.",
            "Žádné. Za čekáním v mechanismu nebo v přeskočené větvi se hodnota prostě nemění.",
        ),
        examples: &[example(
            concat!("        LOD  VYSOVERS\n", "        RAMP OUTPUT,150\n", "        ANALOG OUTPUT,4"),
            "The spindle on axis 4 reaches a new speed in steps of 150 per cycle.",
            "Vřeteno na ose 4 dosáhne nových otáček po krocích 150 za cyklus.",
        )],
        related: &["ANALOG", "ANALOG_SPI", "LOD"],
        ..INSTRUCTION
    },
];
