//! The block interface at the places the supervisor reads and writes (manual 8.1 and 8.2), and the event codes.

use technol_image::op::BitRef;
use technol_image::system;

use super::space::{axis_name, symbol};
use super::{Direction, SystemKind, SystemSymbol, generated};
use crate::catalogue::entry::{Bilingual, Prefix};
use crate::catalogue::pattern::text;

use Direction::{Both, CncToPlc, PlcToCnc};

/// Name, place, who writes it, chapter, meaning.
type Bit = (&'static str, BitRef, Direction, &'static str, Bilingual);

const BITS: &[Bit] = &[
    (
        "PO_F",
        system::PO_F,
        CncToPlc,
        "8.1.14",
        text(
            "Block in progress: 1 from taking the block over until all its functions are done.",
            "Blok rozpracován: 1 od převzetí bloku, dokud neskončí všechny jeho funkce.",
        ),
    ),
    (
        "PO_POL",
        system::PO_POL,
        CncToPlc,
        "8.1.15",
        text("Programmed position reached.", "Programovaná poloha dosažena."),
    ),
    (
        "PO_STOP",
        system::PO_STOP,
        CncToPlc,
        "8.1.16",
        text(
            "Stop confirmed: 1 from the stop of a running program until the next start.",
            "Potvrzení stopu: 1 od zastavení běžícího programu do dalšího startu.",
        ),
    ),
    (
        "INPOS",
        system::INPOS,
        CncToPlc,
        "8.1.17",
        text(
            "No axis has a position error above its tolerance.",
            "Žádná osa nemá polohovou odchylku nad tolerancí.",
        ),
    ),
    (
        "AUTPI",
        system::AUTPI,
        CncToPlc,
        "8.2.2",
        text("The block was started in automatic mode.", "Blok byl odstartován v automatickém režimu."),
    ),
    (
        "REFPI",
        system::REFPI,
        CncToPlc,
        "8.2.2",
        text("A reference run was started.", "Byl odstartován nájezd do reference."),
    ),
    (
        "CAPI",
        system::CAPI,
        CncToPlc,
        "8.2.2",
        text(
            "The block was started in the mode of central annulment.",
            "Blok byl odstartován v režimu centrální anulace.",
        ),
    ),
    (
        "G00PI",
        system::G00PI,
        CncToPlc,
        "8.2.4",
        text("A block with rapid traverse was started.", "Byl odstartován blok s rychloposuvem."),
    ),
    (
        "STOPPI",
        system::STOPPI,
        PlcToCnc,
        "8.1.12",
        text(
            "Request to stop: its rising edge acts like the STOP key; the program clears it.",
            "Žádost o stop: náběžná hrana působí jako tlačítko STOP; nuluje ji program.",
        ),
    ),
    (
        "STOP_REQ",
        system::STOP_REQ,
        Both,
        "8.1.12",
        text(
            "Request to stop that the control clears once it has taken it.",
            "Žádost o stop, kterou systém po převzetí sám vynuluje.",
        ),
    ),
    (
        "STOP_EMERGENCY_REQ",
        system::STOP_EMERGENCY_REQ,
        Both,
        "8.1.12",
        text(
            "Request for an emergency stop that the control clears once it has taken it.",
            "Žádost o nouzový stop, kterou systém po převzetí sám vynuluje.",
        ),
    ),
    (
        "START_DISABLE",
        system::START_DISABLE,
        PlcToCnc,
        "8.1.13",
        text("1 forbids every start.", "Hodnota 1 zakáže jakýkoli start."),
    ),
    (
        "START_SUSPEND",
        system::START_SUSPEND,
        Both,
        "8.1.13",
        text(
            "1 holds a start that was requested until the program lets it go.",
            "Hodnota 1 pozdrží požadovaný start, dokud ho program nepustí.",
        ),
    ),
    (
        "BLOCK_RESTART",
        system::BLOCK_RESTART,
        CncToPlc,
        "8.1.22",
        text("The block is started again after a stop.", "Blok se po stopu startuje znovu."),
    ),
    (
        "G33PI",
        system::G33PI,
        CncToPlc,
        "8.2.3",
        text("Thread cutting is programmed in the block.", "V bloku je programováno řezání závitu."),
    ),
    (
        "M03PI",
        system::M03PI,
        CncToPlc,
        "8.2.8",
        text(
            "Spindle clockwise (M03); stays until another function of its group.",
            "Vřeteno vpravo (M03); trvá do jiné funkce téže skupiny.",
        ),
    ),
    (
        "M04PI",
        system::M04PI,
        CncToPlc,
        "8.2.8",
        text(
            "Spindle counter-clockwise (M04); stays until another function of its group.",
            "Vřeteno vlevo (M04); trvá do jiné funkce téže skupiny.",
        ),
    ),
    (
        "M19PI",
        system::M19PI,
        CncToPlc,
        "8.2.8",
        text(
            "Oriented spindle stop (M19); stays until another function of its group.",
            "Orientované zastavení vřetene (M19); trvá do jiné funkce téže skupiny.",
        ),
    ),
    (
        "M07PI",
        system::M07PI,
        CncToPlc,
        "8.2.10",
        text(
            "Coolant 1 (M07); stays until another function of its group.",
            "Chlazení 1 (M07); trvá do jiné funkce téže skupiny.",
        ),
    ),
    (
        "M08PI",
        system::M08PI,
        CncToPlc,
        "8.2.10",
        text(
            "Coolant 2 (M08); stays until another function of its group.",
            "Chlazení 2 (M08); trvá do jiné funkce téže skupiny.",
        ),
    ),
    (
        "M50PI",
        system::M50PI,
        CncToPlc,
        "8.2.11",
        text(
            "Coolant 3 (M50); stays until another function of its group.",
            "Chlazení 3 (M50); trvá do jiné funkce téže skupiny.",
        ),
    ),
    (
        "M51PI",
        system::M51PI,
        CncToPlc,
        "8.2.11",
        text(
            "Coolant 4 (M51); stays until another function of its group.",
            "Chlazení 4 (M51); trvá do jiné funkce téže skupiny.",
        ),
    ),
    (
        "M00_PID",
        system::M00_PID,
        CncToPlc,
        "8.2.7",
        text("Programmed stop (M00), for one block.", "Programový stop (M00), po jeden blok."),
    ),
    (
        "M01_PID",
        system::M01_PID,
        CncToPlc,
        "8.2.7",
        text("Conditional stop (M01), for one block.", "Podmíněný stop (M01), po jeden blok."),
    ),
    (
        "M02_PID",
        system::M02_PID,
        CncToPlc,
        "8.2.7",
        text("End of program (M02), for one block.", "Konec programu (M02), po jeden blok."),
    ),
    (
        "M30_PID",
        system::M30_PID,
        CncToPlc,
        "8.2.7",
        text(
            "End of program with return (M30), for one block.",
            "Konec programu s návratem (M30), po jeden blok.",
        ),
    ),
    (
        "M10PID",
        system::M10PID,
        CncToPlc,
        "8.2.12",
        text("Clamping (M10), for one block.", "Upnutí (M10), po jeden blok."),
    ),
    (
        "M11PID",
        system::M11PID,
        CncToPlc,
        "8.2.12",
        text("Unclamping (M11), for one block.", "Uvolnění (M11), po jeden blok."),
    ),
    (
        "M06PID",
        system::M06PID,
        CncToPlc,
        "8.2.13",
        text("Tool change (M06), for one block.", "Výměna nástroje (M06), po jeden blok."),
    ),
    (
        "M60PI",
        system::M60PI,
        CncToPlc,
        "8.2.13",
        text("Workpiece change (M60), for one block.", "Výměna obrobku (M60), po jeden blok."),
    ),
    (
        "ZMSHPI",
        system::ZMSHPI,
        CncToPlc,
        "8.2.6",
        text("Function H was programmed in the block.", "V bloku byla programována funkce H."),
    ),
    (
        "ZMSSPI",
        system::ZMSSPI,
        CncToPlc,
        "12.2",
        text("Function S was programmed in the block.", "V bloku byla programována funkce S."),
    ),
    (
        "ZMSTPI",
        system::ZMSTPI,
        CncToPlc,
        "8.2.6",
        text("Function T was programmed in the block.", "V bloku byla programována funkce T."),
    ),
];

/// BYTE cells of the command block: number, chapter, meaning.
const COMMAND_BYTES: &[(u32, &str, Bilingual)] = &[
    (3, "8.2.5", text("M function of group 10, BCD.", "Funkce M skupiny 10 v kódu BCD.")),
    (4, "12.3", text("Function P, BCD.", "Funkce P v kódu BCD.")),
    (5, "8.2.5", text("Function H, BCD.", "Funkce H v kódu BCD.")),
    (6, "8.2.5", text("M function of group 2 (spindle), BCD.", "Funkce M skupiny 2 (vřeteno) v kódu BCD.")),
    (7, "8.2.5", text("Function T, BCD, lowest two digits.", "Funkce T v kódu BCD, nejnižší dvě číslice.")),
    (
        8,
        "8.2.5",
        text("Function T, BCD, third and fourth digit.", "Funkce T v kódu BCD, třetí a čtvrtá číslice."),
    ),
    (
        9,
        "8.2.5",
        text("Function T, BCD, fifth and sixth digit.", "Funkce T v kódu BCD, pátá a šestá číslice."),
    ),
    (10, "8.2.5", text("Function T, BCD, highest two digits.", "Funkce T v kódu BCD, nejvyšší dvě číslice.")),
    (
        11,
        "8.1.2",
        text(
            "Programmed spindle voltage 0 to 7FFFh, lower byte; `WORD.PB11` is the whole value.",
            "Programované napětí vřetene 0 až 7FFFh, spodní slabika; `WORD.PB11` je celá hodnota.",
        ),
    ),
    (
        12,
        "8.1.2",
        text("Programmed spindle voltage, upper byte.", "Programované napětí vřetene, horní slabika."),
    ),
    (13, "8.2.5", text("M function of group 11, BCD.", "Funkce M skupiny 11 v kódu BCD.")),
    (14, "8.2.5", text("M function of group 12, BCD.", "Funkce M skupiny 12 v kódu BCD.")),
    (15, "8.2.5", text("M function of group 13, BCD.", "Funkce M skupiny 13 v kódu BCD.")),
    (
        16,
        "8.2.5",
        text(
            "M function of group 14 (all others), BCD.",
            "Funkce M skupiny 14 (všechny ostatní) v kódu BCD.",
        ),
    ),
    (
        20,
        "8.1",
        text("Motion requested by the block, a bit an axis.", "Pohyb požadovaný blokem, bit na osu."),
    ),
];

/// Axes in PB20.
const BLOCK_AXES: u32 = 6;
/// Groups of M functions.
const M_GROUPS: u8 = 14;
/// Gears that M41 to M44 select.
const GEARS: u8 = 4;

/// Name, code, meaning without the full stop.
const EVENTS: &[(&str, i64, Bilingual)] = &[
    ("PLCEVENT_STOP_REQ", system::event::STOP_REQ, text("A stop was requested", "Byl vyžádán stop")),
    (
        "PLCEVENT_STOP_EMERGENCY_REQ",
        system::event::STOP_EMERGENCY_REQ,
        text("An emergency stop was requested", "Byl vyžádán nouzový stop"),
    ),
    ("PLCEVENT_STOP", system::event::STOP, text("The control has stopped", "Systém se zastavil")),
    ("PLCEVENT_START", system::event::START, text("The control has started", "Systém odstartoval")),
    (
        "PLCEVENT_START_REQ",
        system::event::START_REQ,
        text(
            "A start was requested; START_SUSPEND may hold it",
            "Byl vyžádán start; START_SUSPEND ho může pozdržet",
        ),
    ),
];

pub(super) fn list(symbols: &mut Vec<SystemSymbol>) {
    symbols.extend(BITS.iter().map(|&(name, at, direction, chapter, summary)| {
        symbol(name, at_bit(at, 0), direction, chapter, summary)
    }));
    symbols.extend((1..=GEARS).map(|gear| {
        symbol(
            generated(format!("M4{gear}PI")),
            at_bit(system::M41PI, gear - 1),
            CncToPlc,
            "8.2.9",
            Bilingual {
                en: generated(format!(
                    "Spindle gear {gear} (M4{gear}); stays until another gear is programmed."
                )),
                cs: generated(format!(
                    "Převodový stupeň vřetene {gear} (M4{gear}); trvá do programování jiného."
                )),
            },
        )
    }));
    symbols.extend((1..=M_GROUPS).map(|group| {
        symbol(
            generated(format!("ZMM{group}PI")),
            at_bit(system::ZMM1PI, group - 1),
            CncToPlc,
            "8.2.6",
            Bilingual {
                en: generated(format!("An M function of group {group} was programmed in the block.")),
                cs: generated(format!("V bloku byla programována funkce M skupiny {group}.")),
            },
        )
    }));
    symbols.extend(COMMAND_BYTES.iter().map(|&(number, chapter, summary)| {
        symbol(
            generated(format!("PB{number:02}")),
            SystemKind::Cell { addr: system::PB00 + number, prefix: Prefix::Byte },
            CncToPlc,
            chapter,
            summary,
        )
    }));
    symbols.extend((0..BLOCK_AXES).map(|index| {
        let axis = axis_name(index);
        symbol(
            generated(format!("PO_OS{axis}")),
            SystemKind::Bit { addr: system::PB00 + 20, bit: index as u8 },
            CncToPlc,
            "8.1.7",
            Bilingual {
                en: generated(format!("Motion requested by the block: axis {axis}.")),
                cs: generated(format!("Pohyb požadovaný blokem: osa {axis}.")),
            },
        )
    }));
    symbols.push(symbol(
        "STATUS_RESTART",
        SystemKind::Cell { addr: system::STATUS_RESTART, prefix: Prefix::Byte },
        CncToPlc,
        "8.1.22",
        text(
            "Stage of the block at a restart: BLOCK_IDLE to BLOCK_DONE.",
            "Fáze bloku při opětovném startu: BLOCK_IDLE až BLOCK_DONE.",
        ),
    ));
    symbols.push(symbol(
        "CNT_NEXT_BLOCKS",
        SystemKind::Cell { addr: system::CNT_NEXT_BLOCKS, prefix: Prefix::Word },
        CncToPlc,
        "8.3.2",
        text("Number of prepared blocks.", "Počet připravených bloků."),
    ));
    symbols.extend(EVENTS.iter().map(|&(name, value, summary)| {
        let summary = Bilingual {
            en: generated(format!("{} (this implementation: {value}).", summary.en)),
            cs: generated(format!("{} (tato implementace: {value}).", summary.cs)),
        };
        symbol(name, SystemKind::Constant(value), CncToPlc, "3.17", summary)
    }));
}

/// The bit `ahead` places after `first`, which may lie in the next byte.
fn at_bit(first: BitRef, ahead: u8) -> SystemKind {
    let bit = first.bit + ahead;
    SystemKind::Bit { addr: first.addr + u32::from(bit / 8), bit: bit % 8 }
}
