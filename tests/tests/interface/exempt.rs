//! Symbols that the model leaves alone, and why.

use std::collections::BTreeSet;

use technol_analysis::catalogue::symbols;

/// What is not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// The control does not write it.
    Written,
    /// The control does not read it.
    Read,
}
use Way::{Read, Written};

/// Symbols; a `*` stands for any letters, a `#` at the end for a number.
pub(crate) struct Exemption {
    pub(crate) way: Way,
    pub(crate) symbols: &'static str,
    pub(crate) why: &'static str,
}

impl Exemption {
    /// Spellings of all symbols that are exempt in this way.
    pub(crate) fn names(way: Way) -> BTreeSet<&'static str> {
        let patterns = EXEMPT.iter().filter(|it| it.way == way).flat_map(|it| it.symbols.split_whitespace());
        let named = patterns.flat_map(|pattern| {
            symbols().map(|symbol| symbol.spelling).filter(move |name| fits(pattern, name))
        });
        named.collect()
    }
}

/// Whether a pattern names it.
pub(crate) fn fits(pattern: &str, name: &str) -> bool {
    if let Some(before) = pattern.strip_suffix('#') {
        let number = name.strip_prefix(before);
        return number.is_some_and(|it| !it.is_empty() && it.bytes().all(|byte| byte.is_ascii_digit()));
    }
    match pattern.split_once('*') {
        None => pattern == name,
        Some((before, after)) => {
            name.strip_prefix(before).is_some_and(|rest| (0..=rest.len()).any(|at| fits(after, &rest[at..])))
        }
    }
}

const fn exempt(way: Way, symbols: &'static str, why: &'static str) -> Exemption {
    Exemption { way, symbols, why }
}

pub(crate) const EXEMPT: &[Exemption] = &[
    exempt(Written, "SETL_P* SETH_P*", "force masks are the program's and the debugger's alone"),
    exempt(
        Written,
        "B_INK B_INK_EX",
        "the whole position is in B_POL and B_POL_EX, so the increment stays 0",
    ),
    exempt(Written, "PB04", "the address P is no part of the model: no block programs it"),
    exempt(
        Written,
        "PB20 PO_OSX PO_OSY PO_OSZ PO_OS4 PO_OS5 PO_OS6",
        "older form of PO_OSXPI …, only named in passing",
    ),
    exempt(
        Written,
        "rAxNCParabAccel* dwAxNCLinearAccel* rAxGParabAccel dwAxGLinearAccel",
        "ramps are linear here; there are no parabolic ones",
    ),
    exempt(Read, "rAxGParabAccel dwAxGLinearAccel REQ_PARABACCEL REQ_LINEARACCEL", "no parabolic ramps"),
    exempt(
        Written,
        "CONT_AUTMAN2 AUTMAN_CONT_TOC PTLTOC_P*",
        "there is no wheel panel: the keys of `machine.toml` are those of the operator panel",
    ),
    exempt(
        Read,
        "DISPTOC1 BUSY_DISPTOC1 DISPTOC2 BUSY_DISPTOC2 AUTMAN_KNOB1_DIS AUTMAN_KNOB2_DIS",
        "there is no wheel panel to show or disable anything on",
    ),
    exempt(
        Written,
        "SF_INDICATIONMODE SF_SIMULATIONMODE SF_HIGHSPEEDMODE SF_MANUALMODE SF_BLOCKBYBLOCK",
        "modes that the operator chooses; the part program of the model runs in none of them",
    ),
    exempt(
        Written,
        "TL1W TL2W TL3W TL4W TL1K TL2K TL1P",
        "function levels of keyboards are not modelled: keys act at once",
    ),
    exempt(Written, "NlcSysServoEnable", "there are no non-linear corrections"),
    exempt(Read, "NlcAxisEnable NELKOR_FLAG NlcServoEnable", "there are no non-linear corrections"),
    exempt(
        Written,
        "CAN_DRIVE_MSTAT CAN_MDRIVE_STAT",
        "the manufacturers' words of CAN drives mean something else with each",
    ),
    exempt(
        Written,
        "SU_IRC0 SU_REF0 SU_CHECK_ODM SU_CHECK_NI SU_CHECK_NI_ABS KLA_TPDO_LOST INOUT_TPDO_LOST",
        "diagnostic counters of measuring units and buses",
    ),
    exempt(Read, "SU_OUT_PLC", "the measuring unit SU05 is not there; ANALOG and MAP_AOUT drive outputs"),
    exempt(
        Written,
        "BUKON*",
        "machine constants of older controls; the configuration of the axes is in dwAxNC…",
    ),
    exempt(Written, "STARTC", "only named in an example of older programs"),
    exempt(
        Read,
        "BZH11",
        "the number is for a screen that is not there; the program reports messages by ESET",
    ),
    exempt(Read, "REQW_SPEED2_PM", "a number for the screen"),
    exempt(Read, "PRODLEVA", "a lamp of the panel, which nobody sees here; tests look at the bit"),
    exempt(
        Read,
        "HOMING_SINGLE HOMING_PLC HOMING_GROUP",
        "requests to the program, which confirms them by clearing them",
    ),
    exempt(Written, "dwEdrvDriveVeloReq*", "a drive of the model follows positions"),
    exempt(Written, "flEdrvSimul*", "only the program chooses the simulation of a drive"),
    exempt(Written, "dwEdrvEnc* flEdrvEnc*", "encoder inputs beside the drive are not modelled"),
    exempt(Read, "dwEdrvEnc* flEdrvEncLatchValid*", "encoder inputs beside the drive are not modelled"),
    exempt(
        Read,
        "dwEdrvDrivePos# wEdrvDriveErrReg* rEdrvScaleSpeed*",
        "for the program: the control looks at status words",
    ),
    exempt(Read, "CAN_AX_BUSY", "for the program: a request that still waits is replaced"),
];
