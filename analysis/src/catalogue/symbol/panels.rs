//! States of the keyboards of the panels (manual 11.3.2).
//!
//! The manual names the members but not their places; they follow each other in its order (this implementation).

use super::Direction::CncToPlc;
use super::space::{Row, Shape};
use crate::catalogue::entry::Prefix;
use crate::catalogue::pattern::text;

/// Length of the state of a keyboard: its five members.
const STATE: u32 = 5;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "TL1W",
        Shape::Area(STATE),
        CncToPlc,
        "11.3.2",
        text("State of the keyboard of panel 1 (Keyboard0).", "Stav klávesnice panelu 1 (Keyboard0)."),
    ),
    (
        "TL2W",
        Shape::Area(STATE),
        CncToPlc,
        "11.3.2",
        text("State of the keyboard of panel 2 (Keyboard1).", "Stav klávesnice panelu 2 (Keyboard1)."),
    ),
    (
        "TL3W",
        Shape::Area(STATE),
        CncToPlc,
        "11.3.2",
        text("State of the keyboard of panel 3 (Keyboard2).", "Stav klávesnice panelu 3 (Keyboard2)."),
    ),
    (
        "TL4W",
        Shape::Area(STATE),
        CncToPlc,
        "11.3.2",
        text("State of the keyboard of panel 4 (Keyboard3).", "Stav klávesnice panelu 4 (Keyboard3)."),
    ),
    (
        "TL1K",
        Shape::Area(STATE),
        CncToPlc,
        "11.3.2",
        text("State of the keyboard of knob 1 (Keyboard4).", "Stav klávesnice točítka 1 (Keyboard4)."),
    ),
    (
        "TL2K",
        Shape::Area(STATE),
        CncToPlc,
        "11.3.2",
        text("State of the keyboard of knob 2 (Keyboard5).", "Stav klávesnice točítka 2 (Keyboard5)."),
    ),
    (
        "TL1P",
        Shape::Area(STATE),
        CncToPlc,
        "11.3.2",
        text("State of the virtual keyboard (Keyboard6).", "Stav virtuální klávesnice (Keyboard6)."),
    ),
    (
        "TL_Function",
        Shape::Member(0, Prefix::Byte, 1),
        CncToPlc,
        "11.3.2",
        text("Function level the keyboard is in, 0 to 3.", "Funkce 0 až 3, ve které klávesnice právě je."),
    ),
    (
        "TL_FunctionReq",
        Shape::Member(1, Prefix::Byte, 1),
        CncToPlc,
        "11.3.2",
        text(
            "Function level requested for the keyboard, 0 to 3.",
            "Funkce 0 až 3 požadovaná pro klávesnici.",
        ),
    ),
    (
        "TL_Fun1State",
        Shape::Member(2, Prefix::Byte, 1),
        CncToPlc,
        "11.3.2",
        text("State of function F1: 0FFh on, 0 off.", "Stavová proměnná funkce F1: 0FFh zapnuta, 0 vypnuta."),
    ),
    (
        "TL_Fun2State",
        Shape::Member(3, Prefix::Byte, 1),
        CncToPlc,
        "11.3.2",
        text("State of function F2: 0FFh on, 0 off.", "Stavová proměnná funkce F2: 0FFh zapnuta, 0 vypnuta."),
    ),
    (
        "TL_Fun3State",
        Shape::Member(4, Prefix::Byte, 1),
        CncToPlc,
        "11.3.2",
        text("State of function F3: 0FFh on, 0 off.", "Stavová proměnná funkce F3: 0FFh zapnuta, 0 vypnuta."),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{SystemKind, symbol};

    #[test]
    fn every_keyboard_has_the_members_of_its_state() {
        assert_eq!(ROWS.len(), 7 + 5);
        for name in ["TL1W", "TL2W", "TL3W", "TL4W", "TL1K", "TL2K", "TL1P"] {
            let kind = symbol(name).map(|symbol| symbol.kind);
            assert!(matches!(kind, Some(SystemKind::Area { len: STATE, .. })), "{name}");
        }
        let members = ["TL_Function", "TL_FunctionReq", "TL_Fun1State", "TL_Fun2State", "TL_Fun3State"];
        for (place, name) in (0..STATE).zip(members) {
            let expected = SystemKind::Member { offset: place, element: Prefix::Byte, len: 1 };
            assert_eq!(symbol(name).map(|symbol| symbol.kind), Some(expected), "{name}");
        }
    }
}
