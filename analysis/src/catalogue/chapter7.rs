//! Chapter 7: the directive for debugging.

use super::entry::{Entry, OperandKind};
use super::pattern::{DIRECTIVE, example, form, operand, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[Entry {
    name: "DEBUG",
    chapter: "7.1",
    forms: &[form("DEBUG"), form("DEBUG ON"), form("DEBUG OFF")],
    operands: &[operand(
        "mode",
        OperandKind::Keyword(&["ON", "OFF"]),
        "ON (also when left out) begins the region, OFF ends it",
        "ON (i bez operandu) úsek začíná, OFF ho končí",
    )
    .or_nothing()],
    summary: text(
        "Marks the region of the source where break-points can be set.",
        "Vymezí úsek zdrojového textu, ve kterém lze nastavovat breakpointy.",
    ),
    description: text(
        "DEBUG or DEBUG ON begins a region and DEBUG OFF ends it; outside the state is off at the \
             start of every file, and the region goes by the order of lines, across modules. A line \
             outside takes no break-point, unless the project sets `debug.everywhere = true`, which is \
             the default for the embedded target, where break-points cost nothing (this implementation). \
             In MODULE_FAST and MODULE_CONT no break-point is possible in any case.",
        "DEBUG nebo DEBUG ON úsek začíná a DEBUG OFF ho končí; na začátku každého souboru je stav \
             vypnuto a úsek se řídí pořadím řádků, i přes hranice modulů. Na řádek mimo úsek nelze \
             nastavit breakpoint, pokud projekt neobsahuje `debug.everywhere = true`, což je výchozí \
             nastavení pro vestavěný cíl, kde breakpointy nic nestojí (tato implementace). V MODULE_FAST \
             a MODULE_CONT breakpoint nastavit nelze nikdy.",
    ),
    examples: &[example(
        concat!(
            "DEBUG ON\n",
            "MODULE_MAIN\n",
            "        LDR  START\n",
            "        WR   RUNNING\n",
            "MODULE_MAIN_END\n",
            "DEBUG OFF"
        ),
        "Break-points are possible in this module.",
        "V tomto modulu lze nastavovat breakpointy.",
    )],
    related: &["ON", "OFF", "CHECK"],
    ..DIRECTIVE
}];
