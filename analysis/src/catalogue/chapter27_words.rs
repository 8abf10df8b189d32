//! Chapter 27.6: words that stand as operands of DEF_IN, DEF_OUT, SHARE_VAR and the MAP instructions: periods of
//! connections and types of cells.

use super::cell_type::CELL_TYPES;
use super::entry::{Bilingual, Entry, Example};
use super::pattern::{KEYWORD, example, form, text};

/// Types of SHARE_VAR: all but TYPE_BIT, for which there is SHARE_BIT.
pub(super) const SHARED_TYPES: &[&str] = CELL_TYPES.split_at(1).1;

/// Manual chapter of these words.
pub(super) const CHAPTER: &str = "27.6";

const WORD: Entry = Entry { chapter: CHAPTER, ..KEYWORD };

const fn period(name: &'static str, summary: Bilingual, description: Bilingual) -> Entry {
    Entry { name, summary, description, ..WORD }
}

/// The page of a type: its name, what it is, what a program needs to know, two related words.
macro_rules! cell_type {
    ($name:literal, $en:literal, $cs:literal, $more_en:literal, $more_cs:literal, $sample:literal, $related:expr) => {
        Entry {
            name: $name,
            forms: &[
                form(concat!("DEF_IN cell, 'ID', ", $name)),
                form(concat!("SHARE_VAR cell, 'name', ", $name)),
            ],
            summary: text(
                concat!("Type of a logical element or of a shared cell: ", $en, "."),
                concat!("Typ logického prvku nebo sdílené buňky: ", $cs, "."),
            ),
            description: text($more_en, $more_cs),
            examples: &[example(
                concat!("MODULE_INIT\n        DEF_IN ", $sample, ",", $name, "\nMODULE_INIT_END"),
                concat!("Declares a logical input: ", $en, "."),
                concat!("Deklaruje logický vstup: ", $cs, "."),
            )],
            related: $related,
            ..WORD
        }
    };
    ($name:literal is $other:literal, $en:literal, $cs:literal) => {
        Entry {
            name: $name,
            forms: &[
                form(concat!("DEF_IN cell, 'ID', ", $name)),
                form(concat!("SHARE_VAR cell, 'name', ", $name)),
            ],
            summary: text(
                concat!("Another spelling of ", $other, ": ", $en, "."),
                concat!("Jiný zápis typu ", $other, ": ", $cs, "."),
            ),
            description: text(
                concat!("Means the same as ", $other, "; the manual uses both spellings."),
                concat!("Znamená totéž co ", $other, "; příručka používá oba zápisy."),
            ),
            examples: &[example(
                concat!("MODULE_INIT\n        DEF_OUT SIGNAL,'Signal',", $name, "\nMODULE_INIT_END"),
                concat!("Declares a logical output: ", $en, "."),
                concat!("Deklaruje logický výstup: ", $cs, "."),
            )],
            related: &[$other, "DEF_OUT"],
            ..WORD
        }
    };
}

const fn sampled(entry: Entry, examples: &'static [Example], related: &'static [&'static str]) -> Entry {
    Entry { examples, related, ..entry }
}

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    sampled(
        Entry {
            forms: &[form("DEF_IN cell, 'ID', type, default, SLOW")],
            ..period(
                "SLOW",
                text(
                    "Period of a connection: with every cycle of 20 ms.",
                    "Perioda spojení: s každým cyklem 20 ms.",
                ),
                text(
                    "The period that holds when none is given. Connections are served before and after the modules \
                     of the cycle. The slower of the two periods at the ends of a connection counts.",
                    "Perioda, která platí bez zadání. Spojení se obsluhují před moduly cyklu a po nich. Rozhoduje \
                     pomalejší z period na obou koncích spojení.",
                ),
            )
        },
        &[example(
            "MODULE_INIT\n        DEF_IN TANK_LEVEL,'Tank.Level',TYPE_INT_16,0,SLOW\nMODULE_INIT_END",
            "The same as without the last operand.",
            "Totéž co bez posledního operandu.",
        )],
        &["DEF_IN", "DEF_OUT", "FAST", "FASTEST", "ONDEMAND"],
    ),
    sampled(
        Entry {
            forms: &[form("DEF_IN cell, 'ID', type, default, FAST"), form("MAP_IN bit, 'ID', default, FAST")],
            ..period(
                "FAST",
                text(
                    "Period of a connection or of a mapped input: every millisecond.",
                    "Perioda spojení nebo mapovaného vstupu: každou milisekundu.",
                ),
                text(
                    "Served right before MODULE_FAST, for which such data are meant. The element at the other end \
                     must allow FAST or FASTEST, otherwise its own slower period holds.",
                    "Obsluhuje se těsně před MODULE_FAST, pro který jsou taková data určena. Prvek na druhém konci \
                     musí dovolit FAST nebo FASTEST, jinak platí jeho pomalejší perioda.",
                ),
            )
        },
        &[example(
            "MODULE_INIT\n        MAP_IN PROBE,'Probe',-,FAST\nMODULE_INIT_END",
            "An input for MODULE_FAST.",
            "Vstup pro MODULE_FAST, čte se každou milisekundu.",
        )],
        &["DEF_IN", "MAP_IN", "MODULE_FAST", "SLOW"],
    ),
    sampled(
        Entry {
            forms: &[form("DEF_IN cell, 'ID', type, default, FASTEST")],
            ..period(
                "FASTEST",
                text(
                    "Period of a connection: with every tick of the EtherCAT master.",
                    "Perioda spojení: s každým taktem EtherCAT masteru.",
                ),
                text(
                    "Served right before and after MODULE_FASTEST, for which such data are meant. The tick is 100, \
                     200, 250, 500 or 1000 µs, 1000 by default (this implementation).",
                    "Obsluhuje se těsně před MODULE_FASTEST a po něm; pro tento modul jsou taková data určena. Takt \
                     je 100, 200, 250, 500 nebo 1000 µs, bez nastavení 1000 (tato implementace).",
                ),
            )
        },
        &[example(
            "MODULE_INIT\n        DEF_OUT LASER_STOP,'Laser.Stop',TYPE_BIT,0,FASTEST\nMODULE_INIT_END",
            "An output of MODULE_FASTEST.",
            "Výstup modulu MODULE_FASTEST, předává se v každém taktu.",
        )],
        &["DEF_IN", "MODULE_FASTEST", "FAST"],
    ),
    sampled(
        Entry {
            forms: &[form("DEF_IN cell, 'ID', type, default, ONDEMAND")],
            ..period(
                "ONDEMAND",
                text(
                    "Period of a connection: only when UPDATE_IN asks.",
                    "Perioda spojení: jen na žádost instrukce UPDATE_IN.",
                ),
                text(
                    "Nothing is transferred by itself; the program fetches the value when it needs it.",
                    "Samo se nepřenáší nic; program si hodnotu načte, když ji potřebuje.",
                ),
            )
        },
        &[example(
            concat!(
                "MODULE_INIT\n",
                "        DEF_IN LASER_GAP,'Laser.Gap',TYPE_REAL,-,ONDEMAND\n",
                "MODULE_INIT_END\n",
                "MODULE_MAIN\n",
                "        UPDATE_IN LASER_GAP\n",
                "MODULE_MAIN_END"
            ),
            "Fetched where the program wants it.",
            "Načte se tam, kde to program chce.",
        )],
        &["UPDATE_IN", "DEF_IN", "SLOW"],
    ),
    Entry {
        forms: &[form("DEF_IN cell, 'ID', TYPE_BIT")],
        ..cell_type!(
            "TYPE_BIT",
            "one bit",
            "jeden bit",
            "Used by DEF_IN and DEF_OUT alone; SHARE_BIT publishes bits. A bit takes no `[n]` (this implementation).",
            "Používá se jen u DEF_IN a DEF_OUT; bity zveřejňuje SHARE_BIT. Bit nemůže mít `[n]` (tato implementace).",
            "GATE_SHUT,'GateShut'",
            &["DEF_IN", "DEF_OUT", "SHARE_BIT"]
        )
    },
    cell_type!(
        "TYPE_INT_8",
        "a signed 8-bit number",
        "8bitové číslo se znaménkem",
        "A BYTE cell, from -128 to 127 for the screens and for conversions.",
        "Buňka BYTE; pro obrazovky a převody má rozsah -128 až 127.",
        "OIL_TEMP,'OilTemperature'",
        &["TYPE_UNS_8", "TYPE_INT_16", "DEF_IN"]
    ),
    cell_type!("TYPE_INT8" is "TYPE_INT_8", "a signed 8-bit number", "8bitové číslo se znaménkem"),
    cell_type!(
        "TYPE_UNS_8",
        "an unsigned 8-bit number",
        "8bitové číslo bez znaménka",
        "A BYTE cell, from 0 to 255 for the screens and for conversions. LOD takes its top bit as a sign.",
        "Buňka BYTE; pro obrazovky a převody má rozsah 0 až 255. LOD bere její nejvyšší bit jako znaménko.",
        "ALARM_BITS,'AlarmBits'",
        &["TYPE_BYTE", "TYPE_INT_8", "DEF_IN"]
    ),
    cell_type!("TYPE_UNS8" is "TYPE_UNS_8", "an unsigned 8-bit number", "8bitové číslo bez znaménka"),
    cell_type!("TYPE_BYTE" is "TYPE_UNS_8", "an unsigned 8-bit number", "8bitové číslo bez znaménka"),
    cell_type!(
        "TYPE_INT_16",
        "a signed 16-bit number",
        "16bitové číslo se znaménkem",
        "A WORD cell, from -32768 to 32767 for the screens and for conversions.",
        "Buňka WORD; pro obrazovky a převody má rozsah -32768 až 32767.",
        "TANK_LEVEL,'Tank.Level'",
        &["TYPE_UNS_16", "TYPE_INT_32", "DEF_IN"]
    ),
    cell_type!("TYPE_INT16" is "TYPE_INT_16", "a signed 16-bit number", "16bitové číslo se znaménkem"),
    cell_type!(
        "TYPE_UNS_16",
        "an unsigned 16-bit number",
        "16bitové číslo bez znaménka",
        "A WORD cell, from 0 to 65535 for the screens and for conversions. LOD takes its top bit as a sign.",
        "Buňka WORD; pro obrazovky a převody má rozsah 0 až 65535. LOD bere její nejvyšší bit jako znaménko.",
        "DRIVE_STATUS,'Drive.Status'",
        &["TYPE_WORD", "TYPE_INT_16", "DEF_IN"]
    ),
    cell_type!("TYPE_UNS16" is "TYPE_UNS_16", "an unsigned 16-bit number", "16bitové číslo bez znaménka"),
    cell_type!("TYPE_WORD" is "TYPE_UNS_16", "an unsigned 16-bit number", "16bitové číslo bez znaménka"),
    cell_type!(
        "TYPE_INT_32",
        "a signed 32-bit number",
        "32bitové číslo se znaménkem",
        "A DWORD cell with a sign.",
        "Buňka DWORD, která má i pro obrazovky znaménko.",
        "DRIVE_POS,'Drive.Position'",
        &["TYPE_UNS_32", "TYPE_INT_64", "DEF_IN"]
    ),
    cell_type!("TYPE_INT32" is "TYPE_INT_32", "a signed 32-bit number", "32bitové číslo se znaménkem"),
    cell_type!(
        "TYPE_UNS_32",
        "an unsigned 32-bit number",
        "32bitové číslo bez znaménka",
        "A DWORD cell, from 0 to 4294967295 for the screens and for conversions. LOD takes its top bit as a sign.",
        "Buňka DWORD; pro obrazovky a převody má rozsah 0 až 4294967295. LOD bere její nejvyšší bit jako znaménko.",
        "PART_COUNT,'PartCount'",
        &["TYPE_DWORD", "TYPE_INT_32", "DEF_IN"]
    ),
    cell_type!("TYPE_UNS32" is "TYPE_UNS_32", "an unsigned 32-bit number", "32bitové číslo bez znaménka"),
    cell_type!("TYPE_DWORD" is "TYPE_UNS_32", "an unsigned 32-bit number", "32bitové číslo bez znaménka"),
    cell_type!(
        "TYPE_INT_64",
        "a signed 64-bit number",
        "64bitové číslo se znaménkem",
        "8 bytes, which the program reads and writes as `QWRD.name`.",
        "8 bajtů; program k nim přistupuje jako `QWRD.jméno`.",
        "FINE_POS,'Scale.Position'",
        &["TYPE_UNS_64", "TYPE_INT_32", "QWRD"]
    ),
    cell_type!("TYPE_INT64" is "TYPE_INT_64", "a signed 64-bit number", "64bitové číslo se znaménkem"),
    cell_type!(
        "TYPE_UNS_64",
        "an unsigned 64-bit number",
        "64bitové číslo bez znaménka",
        "8 bytes, which the program reads and writes as `QWRD.name`.",
        "8 bajtů; program k nim přistupuje jako `QWRD.jméno`.",
        "MOTOR_HOURS,'Motor.Seconds'",
        &["TYPE_QWORD", "TYPE_INT_64", "QWRD"]
    ),
    cell_type!("TYPE_UNS64" is "TYPE_UNS_64", "an unsigned 64-bit number", "64bitové číslo bez znaménka"),
    cell_type!("TYPE_QWORD" is "TYPE_UNS_64", "an unsigned 64-bit number", "64bitové číslo bez znaménka"),
    cell_type!(
        "TYPE_REAL",
        "a real number of 8 bytes",
        "reálné číslo o 8 bajtech",
        "The program reads and writes the cell as `REAL.name`. A default is written with a decimal point.",
        "Program k buňce přistupuje jako `REAL.jméno`. Náhradní hodnota se píše s desetinnou tečkou.",
        "LASER_GAP,'Laser.Gap'",
        &["REAL", "DEF_IN", "SHARE_VAR"]
    ),
    cell_type!(
        "TYPE_STR",
        "a text that ends with a zero byte",
        "text ukončený nulovým bajtem",
        "SHARE_VAR takes the label of a STR. With DEF_IN and DEF_OUT `name[n]` holds n characters, `name` alone 255 \
         (this implementation).",
        "U SHARE_VAR stojí návěští textu STR. U DEF_IN a DEF_OUT má `jméno[n]` n znaků, samotné `jméno` 255 (tato \
         implementace).",
        "JOB_NAME[40],'Job.Name'",
        &["STR", "TYPE_BIN", "SHARE_VAR"]
    ),
    cell_type!(
        "TYPE_BIN",
        "a block of bytes",
        "blok bajtů",
        "The fourth operand of SHARE_VAR says its length in bytes. With DEF_IN and DEF_OUT `name[n]` holds n bytes, \
         `name` alone 255 (this implementation).",
        "Čtvrtý operand SHARE_VAR udává délku v bajtech. U DEF_IN a DEF_OUT má `jméno[n]` n bajtů, samotné `jméno` \
         255 (tato implementace).",
        "CODE_BLOCK[64],'Reader.Code'",
        &["TYPE_STR", "SHARE_VAR"]
    ),
];
