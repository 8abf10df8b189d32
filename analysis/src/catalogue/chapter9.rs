//! Chapter 9: the CAN bus.

use super::entry::{Effect, Entry, Equation};
use super::pattern::{ANY_OPERANDS, UNMODELLED, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "CAN_SEND",
        chapter: "9.4",
        forms: &[form("CAN_SEND can, packet")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Dr],
        summary: text(
            "Queues a CAN packet of 12 bytes for sending; DR holds the result.",
            "Zařadí 12bajtový CAN paket k odeslání; výsledek je v DR.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CAN_RECV",
        chapter: "9.4",
        forms: &[form("CAN_RECV can, packet")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Dr, Effect::Memory],
        summary: text(
            "Takes a CAN packet from the receive queue; DR holds the result. CAN_RECV_REQ is preferred.",
            "Vyzvedne CAN paket z přijímací fronty; výsledek je v DR. Vhodnější je CAN_RECV_REQ.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CAN_RECV_REQ",
        chapter: "9.4",
        forms: &[form("CAN_RECV_REQ can, objl, [objh], idl, [idh], proc, packet")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Asks that a procedure be called for every CAN packet with an identifier in the given range.",
            "Požádá o volání procedury po příchodu každého CAN paketu s identifikátorem v zadaném \
             rozsahu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CAN_RECV_END",
        chapter: "9.4",
        forms: &[form("CAN_RECV_END handle")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text(
            "Cancels a request made by CAN_RECV_REQ.",
            "Zruší požadavek zadaný instrukcí CAN_RECV_REQ.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CAN_RECV_DEL",
        chapter: "9.4",
        forms: &[form("CAN_RECV_DEL handle")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo],
        summary: text("Another name of CAN_RECV_END.", "Jiné jméno instrukce CAN_RECV_END."),
        ..UNMODELLED
    },
    Entry {
        name: "CAN_SYSIO_READ",
        chapter: "9.5",
        forms: &[form("CAN_SYSIO_READ can, group, board, item")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        writes: &[Effect::Rlo, Effect::Dr],
        summary: text(
            "Reads a value of a system CAN unit into DR; RLO 0 means success.",
            "Přečte údaj systémové CAN jednotky do DR; RLO 0 znamená úspěch.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CAN_SYSIO_WRITE",
        chapter: "9.5",
        forms: &[form("CAN_SYSIO_WRITE can, group, board, item")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        reads: &[Effect::Dr],
        writes: &[Effect::Rlo],
        summary: text(
            "Writes DR to a value of a system CAN unit; RLO 0 means success.",
            "Zapíše DR do údaje systémové CAN jednotky; RLO 0 znamená úspěch.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "LDR_LIC",
        chapter: "8.4.7",
        forms: &[form("LDR_LIC feature")],
        operands: ANY_OPERANDS,
        equation: Equation::Overwrite,
        writes: &[Effect::Rlo],
        summary: text(
            "Sets RLO when a licence is valid or the hardware key is connected.",
            "Nastaví RLO, když platí licence nebo je připojen hardwarový klíč.",
        ),
        ..UNMODELLED
    },
];
