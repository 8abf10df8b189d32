//! Chapter 20: positioning of axes by the PLC program.

use super::entry::{Effect, Entry};
use super::pattern::{ANY_OPERANDS, UNMODELLED, form, text};

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "POS_INIT",
        chapter: "20.4",
        forms: &[form("POS_INIT axis [,space]")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Takes an axis for the PLC program.", "Převezme osu do řízení PLC programu."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_RESET",
        chapter: "20.4",
        forms: &[form("POS_RESET axis")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Gives an axis back to the NC.", "Vrátí osu do řízení NC."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_MODE",
        chapter: "20.4",
        forms: &[form("POS_MODE control, length, accel, axis")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of an axis: length and ramp.",
            "Připraví pohyb osy: délku dráhy a rampu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_CONTROL",
        chapter: "20.4",
        forms: &[form("POS_CONTROL status, feed, [mp], axis")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to an axis and reads its status.",
            "Předá ose rychlost a povolení pohybu a přečte její stav.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_INIT_X",
        chapter: "20.4",
        forms: &[form("POS_INIT_X [space]")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Takes axis 1 for the PLC program.", "Převezme 1. osu do řízení PLC programu."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_RESET_X",
        chapter: "20.4",
        forms: &[form("POS_RESET_X")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Gives axis 1 back to the NC.", "Vrátí 1. osu do řízení NC."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_MODE_X",
        chapter: "20.4",
        forms: &[form("POS_MODE_X control, length, accel")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of axis 1: length and ramp.",
            "Připraví pohyb 1. osy: délku dráhy a rampu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_CONTROL_X",
        chapter: "20.4",
        forms: &[form("POS_CONTROL_X status, feed, [mp]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to axis 1 and reads its status.",
            "Předá 1. ose rychlost a povolení pohybu a přečte její stav.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_INIT_Y",
        chapter: "20.4",
        forms: &[form("POS_INIT_Y [space]")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Takes axis 2 for the PLC program.", "Převezme 2. osu do řízení PLC programu."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_RESET_Y",
        chapter: "20.4",
        forms: &[form("POS_RESET_Y")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Gives axis 2 back to the NC.", "Vrátí 2. osu do řízení NC."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_MODE_Y",
        chapter: "20.4",
        forms: &[form("POS_MODE_Y control, length, accel")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of axis 2: length and ramp.",
            "Připraví pohyb 2. osy: délku dráhy a rampu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_CONTROL_Y",
        chapter: "20.4",
        forms: &[form("POS_CONTROL_Y status, feed, [mp]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to axis 2 and reads its status.",
            "Předá 2. ose rychlost a povolení pohybu a přečte její stav.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_INIT_Z",
        chapter: "20.4",
        forms: &[form("POS_INIT_Z [space]")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Takes axis 3 for the PLC program.", "Převezme 3. osu do řízení PLC programu."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_RESET_Z",
        chapter: "20.4",
        forms: &[form("POS_RESET_Z")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Gives axis 3 back to the NC.", "Vrátí 3. osu do řízení NC."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_MODE_Z",
        chapter: "20.4",
        forms: &[form("POS_MODE_Z control, length, accel")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of axis 3: length and ramp.",
            "Připraví pohyb 3. osy: délku dráhy a rampu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_CONTROL_Z",
        chapter: "20.4",
        forms: &[form("POS_CONTROL_Z status, feed, [mp]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to axis 3 and reads its status.",
            "Předá 3. ose rychlost a povolení pohybu a přečte její stav.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_INIT_4",
        chapter: "20.4",
        forms: &[form("POS_INIT_4 [space]")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Takes axis 4 for the PLC program.", "Převezme 4. osu do řízení PLC programu."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_RESET_4",
        chapter: "20.4",
        forms: &[form("POS_RESET_4")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Gives axis 4 back to the NC.", "Vrátí 4. osu do řízení NC."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_MODE_4",
        chapter: "20.4",
        forms: &[form("POS_MODE_4 control, length, accel")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of axis 4: length and ramp.",
            "Připraví pohyb 4. osy: délku dráhy a rampu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_CONTROL_4",
        chapter: "20.4",
        forms: &[form("POS_CONTROL_4 status, feed, [mp]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to axis 4 and reads its status.",
            "Předá 4. ose rychlost a povolení pohybu a přečte její stav.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_INIT_5",
        chapter: "20.4",
        forms: &[form("POS_INIT_5 [space]")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Takes axis 5 for the PLC program.", "Převezme 5. osu do řízení PLC programu."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_RESET_5",
        chapter: "20.4",
        forms: &[form("POS_RESET_5")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Gives axis 5 back to the NC.", "Vrátí 5. osu do řízení NC."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_MODE_5",
        chapter: "20.4",
        forms: &[form("POS_MODE_5 control, length, accel")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of axis 5: length and ramp.",
            "Připraví pohyb 5. osy: délku dráhy a rampu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_CONTROL_5",
        chapter: "20.4",
        forms: &[form("POS_CONTROL_5 status, feed, [mp]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to axis 5 and reads its status.",
            "Předá 5. ose rychlost a povolení pohybu a přečte její stav.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_INIT_6",
        chapter: "20.4",
        forms: &[form("POS_INIT_6 [space]")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Takes axis 6 for the PLC program.", "Převezme 6. osu do řízení PLC programu."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_RESET_6",
        chapter: "20.4",
        forms: &[form("POS_RESET_6")],
        operands: ANY_OPERANDS,
        writes: &[Effect::Memory],
        summary: text("Gives axis 6 back to the NC.", "Vrátí 6. osu do řízení NC."),
        ..UNMODELLED
    },
    Entry {
        name: "POS_MODE_6",
        chapter: "20.4",
        forms: &[form("POS_MODE_6 control, length, accel")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Prepares a motion of axis 6: length and ramp.",
            "Připraví pohyb 6. osy: délku dráhy a rampu.",
        ),
        ..UNMODELLED
    },
    Entry {
        name: "POS_CONTROL_6",
        chapter: "20.4",
        forms: &[form("POS_CONTROL_6 status, feed, [mp]")],
        operands: ANY_OPERANDS,
        reads: &[Effect::Memory],
        writes: &[Effect::Memory],
        summary: text(
            "Hands speed and motion enable to axis 6 and reads its status.",
            "Předá 6. ose rychlost a povolení pohybu a přečte její stav.",
        ),
        ..UNMODELLED
    },
];
