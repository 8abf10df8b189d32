//! Chapters 12 and 13: spindles, rotary axes, regulators and drives.

use super::entry::{Effect, Entry};
use super::pattern::{ANY_OPERANDS, UNMODELLED, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "ANALOG_PORT",
        chapter: "12.2",
        forms: &[form("ANALOG_PORT port")],
        operands: ANY_OPERANDS,
        summary: text(
            "Chooses the analogue output that following ANALOG instructions drive.",
            "Zvolí analogový výstup, který budou řídit následující instrukce ANALOG.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "ANALOG",
        chapter: "12.2",
        forms: &[
            form("ANALOG"),
            form("ANALOG value"),
            form("ANALOG value, axis"),
            form("ANALOG value, axis, spindle"),
        ],
        operands: ANY_OPERANDS,
        reads: &[Effect::Dr, Effect::Memory],
        summary: text(
            "Sends a value to an analogue output or to a rotary axis working as spindle.",
            "Pošle hodnotu na analogový výstup nebo rotační ose pracující jako vřeteno.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "SPI_AX",
        chapter: "12.4",
        forms: &[form("SPI_AX [feed1], [feed2], [angle], [accel], axis")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Switches a spindle to an axis and positions it to its zero pulse.",
            "Přepne vřeteno na osu a napolohuje ji na nulový pulz.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "AX_SPI",
        chapter: "12.4",
        forms: &[form("AX_SPI axis"), form("AX_SPI axis, spindle")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Switches a rotary axis to a spindle.", "Přepne rotační osu na vřeteno."),
        ..UNMODELLED
    },
    Entry {
        name: "SPI_MAIN",
        chapter: "12.4",
        forms: &[form("SPI_MAIN axis")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Chooses the main spindle.", "Zvolí hlavní vřeteno."),
        ..UNMODELLED
    },
    Entry {
        name: "ANALOG_SPI",
        chapter: "12.4",
        forms: &[form("ANALOG_SPI value, axis"), form("ANALOG_SPI -, axis")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Dr, Effect::Memory],
        summary: text(
            "Sends a value to an axis that works as spindle, by the number of the axis.",
            "Pošle hodnotu ose pracující jako vřeteno podle čísla osy.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "RAMP",
        chapter: "12.6",
        forms: &[form("RAMP value, accel")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Dr, Effect::Memory],
        writes: &[Effect::Dr, Effect::Memory],
        summary: text(
            "Moves a value towards DR by at most the given step and leaves it in DR.",
            "Posune hodnotu směrem k DR nejvýše o zadaný krok a ponechá ji v DR.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "REGUL_X",
        chapter: "13.1",
        forms: &[form("REGUL_X set")],
        operands: ANY_OPERANDS,
        summary: text(
            "Activates a set of regulator parameters for axis 1.",
            "Zvolí sadu parametrů regulátoru pro 1. osu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "REGUL_Y",
        chapter: "13.1",
        forms: &[form("REGUL_Y set")],
        operands: ANY_OPERANDS,
        summary: text(
            "Activates a set of regulator parameters for axis 2.",
            "Zvolí sadu parametrů regulátoru pro 2. osu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "REGUL_Z",
        chapter: "13.1",
        forms: &[form("REGUL_Z set")],
        operands: ANY_OPERANDS,
        summary: text(
            "Activates a set of regulator parameters for axis 3.",
            "Zvolí sadu parametrů regulátoru pro 3. osu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "REGUL_4",
        chapter: "13.1",
        forms: &[form("REGUL_4 set")],
        operands: ANY_OPERANDS,
        summary: text(
            "Activates a set of regulator parameters for axis 4.",
            "Zvolí sadu parametrů regulátoru pro 4. osu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "REGUL_5",
        chapter: "13.1",
        forms: &[form("REGUL_5 set")],
        operands: ANY_OPERANDS,
        summary: text(
            "Activates a set of regulator parameters for axis 5.",
            "Zvolí sadu parametrů regulátoru pro 5. osu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "REGUL_6",
        chapter: "13.1",
        forms: &[form("REGUL_6 set")],
        operands: ANY_OPERANDS,
        summary: text(
            "Activates a set of regulator parameters for axis 6.",
            "Zvolí sadu parametrů regulátoru pro 6. osu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "CAN_AX_SEND",
        chapter: "15.4",
        forms: &[form("CAN_AX_SEND axis")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text("Sends an SDO packet to the CAN drive of an axis.", "Pošle SDO paket CAN pohonu osy."),
        ..UNMODELLED
    },
];
