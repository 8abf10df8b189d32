//! Chapter 7: the directive for debugging.

use super::entry::{Entry, OperandKind};
use super::pattern::{DIRECTIVE, form, operand, text};

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
        "Vymezí úsek zdrojového textu, ve kterém lze nastavit body zastavení.",
    ),
    ..DIRECTIVE
}];
