//! Chapter 23: serial ports.

use super::entry::{Effect, Entry, Equation};
use super::pattern::{ANY_OPERANDS, UNMODELLED, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "COM_SEND",
        chapter: "23.3",
        forms: &[form("COM_SEND com"), form("COM_SEND com, value")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Queues a character for a serial port; RLO 0 means success.",
            "Zařadí znak k odeslání sériovým portem; RLO 0 znamená úspěch.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "COM_SEND_STR",
        chapter: "23.3",
        forms: &[form("COM_SEND_STR com, text, length")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Queues a text for a serial port, sent without gaps; RLO 0 means success.",
            "Zařadí text k odeslání sériovým portem bez mezer mezi znaky; RLO 0 znamená úspěch.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "COM_RECV",
        chapter: "23.3",
        forms: &[form("COM_RECV com"), form("COM_RECV com, cell")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Takes a character received by a serial port; RLO 1 when there is none.",
            "Vyzvedne znak přijatý sériovým portem; RLO je 1, když žádný není.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "COM_CONTROL",
        chapter: "23.3",
        forms: &[form("COM_CONTROL com, CLEAR|RECEIVED|STATE")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Dr],
        summary: text(
            "Clears the receive queue of a serial port or reads its state into DR.",
            "Vyprázdní přijímací frontu sériového portu nebo přečte jeho stav do DR.",
        ),
        ..UNMODELLED
    },
];
