//! Values of `RtmCommand`: commands of the real-time program (manual 11.3.6).

use super::expand::Row;

/// In the order of the manual.
pub(super) const ROWS: &[Row] = &[
    (
        "RTMID_{|I}MMM_SEL{00-15}",
        "Preselects NC axis {2} for manual motion{1:|; chooses MAN at once}.",
        "Předvolí NC osu {2} pro ruční pohyb{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_SEL{X|Y|Z}",
        "Preselects geometric axis {2} for manual motion{1:|; chooses MAN at once}.",
        "Předvolí geometrickou osu {2} pro ruční pohyb{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_MOVE{00-15}{|NEG}{|RT}",
        "Moves NC axis {2} by hand in the {3:positive|negative} direction{4:| at rapid traverse}{1:|; chooses MAN at once}.",
        "Ruční pohyb NC osy {2} v {3:kladném|záporném} směru{4:| rychloposuvem}{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_MOVE{X|Y|Z}{|NEG}{|RT}",
        "Moves geometric axis {2} by hand in the {3:positive|negative} direction{4:| at rapid traverse}{1:|; chooses MAN at once}.",
        "Ruční pohyb geometrické osy {2} v {3:kladném|záporném} směru{4:| rychloposuvem}{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_MOVEX{|NEG}Y{|NEG}",
        "Moves two geometric axes by hand, X in the {2:positive|negative} and Y in the {3:positive|negative} direction{1:|; chooses MAN at once}.",
        "Ruční pohyb dvou geometrických os, X v {2:kladném|záporném} a Y v {3:kladném|záporném} směru{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_MOVEZ{|NEG}X{|NEG}",
        "Moves two geometric axes by hand, Z in the {2:positive|negative} and X in the {3:positive|negative} direction{1:|; chooses MAN at once}.",
        "Ruční pohyb dvou geometrických os, Z v {2:kladném|záporném} a X v {3:kladném|záporném} směru{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_MOVEY{|NEG}Z{|NEG}",
        "Moves two geometric axes by hand, Y in the {2:positive|negative} and Z in the {3:positive|negative} direction{1:|; chooses MAN at once}.",
        "Ruční pohyb dvou geometrických os, Y v {2:kladném|záporném} a Z v {3:kladném|záporném} směru{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_MOVE{|NEG}{|RT}",
        "Moves the preselected axis by hand in the {2:positive|negative} direction{3:| at rapid traverse}{1:|; chooses MAN at once}.",
        "Ruční pohyb předvolené osy v {2:kladném|záporném} směru{3:| rychloposuvem}{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_MMM_RAPIDTRAVERSE",
        "Adds rapid traverse to manual motion.",
        "Přidá k ručnímu pohybu rychloposuv.",
    ),
    (
        "RTMID_{|I}MMM_KNOB_{ENABLE|DISABLE}{1-2}",
        "{2:Enables|Disables} control from knob {3}{1:|; chooses MAN at once}.",
        "{2:Povolí|Zakáže} ovládání z točítka {3}{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_SHIFT_REQ",
        "Permits the SHIFT mode, or cancels it when permitted{1:|; chooses MAN at once}.",
        "Povolí režim SHIFT, povolený zruší{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_SHIFT_ACT",
        "Activates the SHIFT mode, or deactivates it when active{1:|; chooses MAN at once}.",
        "Aktivuje režim SHIFT, aktivní deaktivuje{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_SHIFT_{ENABLE|DISABLE|ACTIVATE|DEACTIVATE}",
        "{2:Permits|Cancels|Activates|Deactivates} the SHIFT mode{1:|; chooses MAN at once}.",
        "{2:Povolí|Zruší|Aktivuje|Deaktivuje} režim SHIFT{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_MMM_KNOB_STEP{1|2|5|10|20|50|100|200|500|1000}",
        "Preselects the wheel step of {1} µm.",
        "Předvolí krok kolečka {1} µm.",
    ),
    (
        "RTMID_MMM_KNOB_STEP_{UP|DOWN}",
        "Takes the next {1:larger|smaller} wheel step of the series.",
        "Zvolí nejbližší {1:větší|menší} krok kolečka v řadě.",
    ),
    (
        "RTMID_{|I}MMM_MOVE{_KNOB_STEP_UP|NEG_KNOB_STEP_DOWN}",
        "Moves the preselected axis in the {2:positive|negative} direction; in the SHIFT mode takes the next {2:larger|smaller} wheel step{1:|; chooses MAN at once}.",
        "Pohyb předvolené osy v {2:kladném|záporném} směru; v režimu SHIFT nejbližší {2:větší|menší} krok kolečka{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_{|I}MMM_KNOB_{INC|DEC}",
        "Acts as the wheel: one step in the {2:positive|negative} direction{1:|; chooses MAN at once}.",
        "Nahrazuje kolečko: jeden krok v {2:kladném|záporném} směru{1:|; okamžitě zvolí MAN}.",
    ),
    (
        "RTMID_MMM_HOLD",
        "Switches the hold of manual motion on or off.",
        "Zapne nebo vypne přídrž ručního pohybu.",
    ),
    (
        "RTMID_KEYB{0-7}_FUNCTION{0-3}",
        "Function {2} of keyboard {1} while the button is held.",
        "Funkce {2} klávesnice {1} po dobu držení tlačítka.",
    ),
    (
        "RTMID_KEYB{0-7}_FUNCTION{0-3}_TOGGLE",
        "Inverts the state of function {2} of keyboard {1}.",
        "Přepne stav funkce {2} klávesnice {1}.",
    ),
    (
        "RTMID_KEYB{0-7}_FUNCTION{0-3}_SWITCH",
        "Sets keyboard {1} to function {2}, its states included.",
        "Nastaví klávesnici {1} na funkci {2} včetně stavových proměnných.",
    ),
];
