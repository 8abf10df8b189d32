//! Chapter 26: EtherCAT.

use super::entry::{Effect, Entry};
use super::pattern::{ANY_OPERANDS, MULTI_CYCLE, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "ECAT_COE_READ",
        chapter: "26.4",
        forms: &[form("ECAT_COE_READ master, slave, index, subindex, cell, length")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Reads a CANopen object of an EtherCAT slave.",
            "Přečte objekt CANopen zařízení na EtherCAT.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "ECAT_COE_WRITE",
        chapter: "26.4",
        forms: &[form("ECAT_COE_WRITE master, slave, index, subindex, cell, length")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Writes a CANopen object of an EtherCAT slave.",
            "Zapíše objekt CANopen zařízení na EtherCAT.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "ECAT_SOE_READ",
        chapter: "26.4",
        forms: &[form("ECAT_SOE_READ master, slave, drive, flags, idn, cell, length")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Reads a SERCOS register of an EtherCAT slave.",
            "Přečte registr SERCOS zařízení na EtherCAT.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "ECAT_SOE_WRITE",
        chapter: "26.4",
        forms: &[form("ECAT_SOE_WRITE master, slave, drive, flags, idn, cell, length")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Writes a SERCOS register of an EtherCAT slave.",
            "Zapíše registr SERCOS zařízení na EtherCAT.",
        ),
        ..MULTI_CYCLE
    },
    Entry {
        name: "ECAT_COMMAND",
        chapter: "26.4",
        forms: &[form("ECAT_COMMAND master, slave, command [,cell, length]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Rlo, Effect::Dr, Effect::Memory],
        summary: text(
            "Sends a command to the EtherCAT master: change or query of a state.",
            "Pošle příkaz EtherCAT masteru: změnu nebo dotaz na stav.",
        ),
        ..MULTI_CYCLE
    },
];
