//! Positions, feeds, homing and dynamics of the axes (manual 8.1.1, 8.1.19, 8.1.23, 8.4.1, 8.4.4 and 8.4.6).

use super::Direction::{Both, CncToPlc, PlcToCnc};
use super::space::{BYTE, DWORD, REAL, Row, Shape, WORD};
use crate::catalogue::entry::Prefix;
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "B_POL",
        Shape::Array(Prefix::Dwrd, 6),
        CncToPlc,
        "8.1.1",
        text(
            "Position of the axes in space POS0, 1/8 µm; add B_INK.",
            "Poloha os v prostoru POS0 v 1/8 µm; přičítá se B_INK.",
        ),
    ),
    (
        "B_INK",
        Shape::Array(Prefix::Dwrd, 6),
        CncToPlc,
        "8.1.1",
        text("Increment of the axes in space POS0, 1/8 µm.", "Přírůstek polohy os v prostoru POS0 v 1/8 µm."),
    ),
    (
        "B_POL_EX",
        Shape::Array(Prefix::Qwrd, 16),
        CncToPlc,
        "8.1.1",
        text("Position of the axes in space POS0, 1/64000 µm.", "Poloha os v prostoru POS0 v 1/64000 µm."),
    ),
    (
        "B_INK_EX",
        Shape::Array(Prefix::Qwrd, 16),
        CncToPlc,
        "8.1.1",
        text(
            "Increment of the axes in space POS0, 1/64000 µm.",
            "Přírůstek polohy os v prostoru POS0 v 1/64000 µm.",
        ),
    ),
    (
        "POSITION_POS1_EX",
        Shape::Array(Prefix::Qwrd, 16),
        CncToPlc,
        "8.1.1",
        text("Position of the axes in space POS1, 1/64000 µm.", "Poloha os v prostoru POS1 v 1/64000 µm."),
    ),
    (
        "POSITION_POS2_EX",
        Shape::Array(Prefix::Qwrd, 16),
        CncToPlc,
        "8.1.1",
        text("Position of the axes in space POS2, 1/64000 µm.", "Poloha os v prostoru POS2 v 1/64000 µm."),
    ),
    (
        "POSITION_POS3_EX",
        Shape::Array(Prefix::Qwrd, 16),
        CncToPlc,
        "8.1.1",
        text("Position of the axes in space POS3, 1/64000 µm.", "Poloha os v prostoru POS3 v 1/64000 µm."),
    ),
    (
        "POSITION_POS4_EX",
        Shape::Array(Prefix::Qwrd, 16),
        CncToPlc,
        "8.1.1",
        text("Position of the axes in space POS4, 1/64000 µm.", "Poloha os v prostoru POS4 v 1/64000 µm."),
    ),
    (
        "POSITION_POS5_EX",
        Shape::Array(Prefix::Qwrd, 16),
        CncToPlc,
        "8.1.1",
        text("Position of the axes in space POS5, 1/64000 µm.", "Poloha os v prostoru POS5 v 1/64000 µm."),
    ),
    (
        "DIFCIT_X",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.1.1",
        text(
            "Position error of the axes in µm, with sign; X is element 0.",
            "Polohová odchylka os v µm, se znaménkem; X je prvek 0.",
        ),
    ),
    (
        "POS_SPACE_PLC",
        BYTE,
        PlcToCnc,
        "8.1.1",
        text(
            "Space in which manual motion asked for by the program takes place.",
            "Prostor, ve kterém probíhá ruční pohyb žádaný programem.",
        ),
    ),
    (
        "POS_SPACE_MMM",
        BYTE,
        PlcToCnc,
        "8.1.1",
        text(
            "Space in which manual motion asked for by a command takes place.",
            "Prostor, ve kterém probíhá ruční pohyb žádaný povelem.",
        ),
    ),
    (
        "FEED_OVR",
        Shape::Bit,
        PlcToCnc,
        "8.1.19",
        text(
            "1 takes the feed override from BZH09 instead of the potentiometer.",
            "Hodnota 1 bere korekci posuvu z BZH09 místo z potenciometru.",
        ),
    ),
    (
        "BZH09",
        BYTE,
        PlcToCnc,
        "8.1.19",
        text(
            "Feed override in per mille, lower byte; write it as `WORD.BZH09`.",
            "Korekce posuvu v promile, spodní slabika; zapisuje se jako `WORD.BZH09`.",
        ),
    ),
    (
        "BZH10",
        BYTE,
        PlcToCnc,
        "8.1.19",
        text("Feed override in per mille, upper byte.", "Korekce posuvu v promile, horní slabika."),
    ),
    (
        "FEED_OVR_MULTIPLIER",
        WORD,
        PlcToCnc,
        "8.1.19",
        text("Further multiplier of the feed in per mille.", "Další násobitel posuvu v promile."),
    ),
    (
        "LIMIT_FEED_REQ",
        Shape::Bit,
        PlcToCnc,
        "8.4.1",
        text("1 limits the working feed to LIMIT_FEED.", "Hodnota 1 omezí pracovní posuv na LIMIT_FEED."),
    ),
    (
        "LIMIT_FEED_G00_REQ",
        Shape::Bit,
        PlcToCnc,
        "8.4.1",
        text("1 limits rapid traverse to LIMIT_FEED_G00.", "Hodnota 1 omezí rychloposuv na LIMIT_FEED_G00."),
    ),
    (
        "LIMIT_FEED",
        DWORD,
        PlcToCnc,
        "8.4.1",
        text(
            "Limit of the working feed; the upper word is in mm/s.",
            "Omezení pracovního posuvu; horní slovo je v mm/s.",
        ),
    ),
    (
        "LIMIT_FEED_G00",
        DWORD,
        PlcToCnc,
        "8.4.1",
        text(
            "Limit of rapid traverse; the upper word is in mm/s.",
            "Omezení rychloposuvu; horní slovo je v mm/s.",
        ),
    ),
    (
        "HOMING",
        WORD,
        Both,
        "8.1.23",
        text("Reference is valid, a bit an axis.", "Reference je platná, bit na osu."),
    ),
    (
        "HOMING_REQ",
        WORD,
        Both,
        "8.1.23",
        text(
            "Request to set the zero point, a bit an axis.",
            "Žádost o nastavení nulového bodu, bit na osu.",
        ),
    ),
    (
        "REFPOINT_DIST",
        Shape::Array(Prefix::Qwrd, 16),
        PlcToCnc,
        "8.1.23",
        text(
            "Shift from the zero point used with HOMING_REQ, 1/64000 µm.",
            "Posun od nulového bodu pro HOMING_REQ v 1/64000 µm.",
        ),
    ),
    (
        "HOMING_START_REQ",
        WORD,
        Both,
        "8.1.23",
        text(
            "Request for a complete reference run, a bit an axis.",
            "Žádost o úplný nájezd do reference, bit na osu.",
        ),
    ),
    (
        "HOMING_SINGLE",
        Shape::Bit,
        Both,
        "8.1.23",
        text(
            "Request of the control for the reference of one axis.",
            "Žádost systému o referenci jedné osy.",
        ),
    ),
    (
        "HOMING_PLC",
        Shape::Bit,
        Both,
        "8.1.23",
        text(
            "Request that the program makes the reference of one axis; it clears the bit.",
            "Žádost, aby referenci jedné osy provedl program; ten bit vynuluje.",
        ),
    ),
    (
        "HOMING_GROUP",
        Shape::Bit,
        Both,
        "8.1.23",
        text(
            "Request that the program makes a group reference; it clears the bit.",
            "Žádost, aby skupinovou referenci provedl program; ten bit vynuluje.",
        ),
    ),
    (
        "SLS_REFER",
        WORD,
        Both,
        "8.1.23",
        text(
            "Enables the software limit switches, a bit an axis.",
            "Povolení softwarových koncových spínačů, bit na osu.",
        ),
    ),
    (
        "NlcAxisEnable",
        WORD,
        PlcToCnc,
        "8.1.23",
        text(
            "Enables the non-linear corrections by controlling axis, a bit an axis.",
            "Povolení nelineárních korekcí podle řídicí osy, bit na osu.",
        ),
    ),
    (
        "NELKOR_FLAG",
        Shape::Alias,
        PlcToCnc,
        "23.2",
        text("Another name of NlcAxisEnable.", "Jiný název buňky NlcAxisEnable."),
    ),
    (
        "NlcServoEnable",
        WORD,
        PlcToCnc,
        "8.1.23",
        text(
            "Enables the non-linear corrections by corrected loop, a bit an axis.",
            "Povolení nelineárních korekcí podle korigované smyčky, bit na osu.",
        ),
    ),
    (
        "G23ACT",
        Shape::Bit,
        CncToPlc,
        "8.4.4",
        text("Continuous run (G23) is active.", "Plynulá jízda (G23) je aktivní."),
    ),
    (
        "TIME_DIST",
        DWORD,
        CncToPlc,
        "8.4.4",
        text("Time to the end of the continuous section in ms.", "Čas do konce plynulého úseku v ms."),
    ),
    (
        "dwAxNCAcceleration",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Linear acceleration of the NC axes, from the configuration.",
            "Lineární zrychlení NC os z konfigurace.",
        ),
    ),
    (
        "dwAxNCAccelerationRT",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Linear acceleration for rapid traverse of the NC axes, from the configuration.",
            "Lineární zrychlení pro rychloposuv NC os z konfigurace.",
        ),
    ),
    (
        "dwAxNCAccelerationEmergency",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Linear acceleration for an emergency stop of the NC axes, from the configuration.",
            "Lineární zrychlení pro nouzové zastavení NC os z konfigurace.",
        ),
    ),
    (
        "rAxNCParabAccel",
        Shape::Array(Prefix::Real, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Parabolic acceleration of the NC axes, from the configuration.",
            "Parabolické zrychlení NC os z konfigurace.",
        ),
    ),
    (
        "rAxNCParabAccelRT",
        Shape::Array(Prefix::Real, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Parabolic acceleration for rapid traverse of the NC axes, from the configuration.",
            "Parabolické zrychlení pro rychloposuv NC os z konfigurace.",
        ),
    ),
    (
        "rAxNCParabAccelEmergency",
        Shape::Array(Prefix::Real, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Parabolic acceleration for an emergency stop of the NC axes, from the configuration.",
            "Parabolické zrychlení pro nouzové zastavení NC os z konfigurace.",
        ),
    ),
    (
        "dwAxNCLinearAccel",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Acceleration in the linear part of parabolic ramps of the NC axes, from the configuration.",
            "Zrychlení v lineární části parabolických ramp NC os z konfigurace.",
        ),
    ),
    (
        "dwAxNCLinearAccelRT",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Acceleration in the linear part for rapid traverse of the NC axes, from the configuration.",
            "Zrychlení v lineární části pro rychloposuv NC os z konfigurace.",
        ),
    ),
    (
        "dwAxNCLinearAccelEmergency",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text(
            "Acceleration in the linear part for an emergency stop of the NC axes, from the configuration.",
            "Zrychlení v lineární části pro nouzové zastavení NC os z konfigurace.",
        ),
    ),
    (
        "dwAxNcFeed",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text("Feed of the NC axes, from the configuration.", "Posuv NC os z konfigurace."),
    ),
    (
        "dwAxNcFeedRT",
        Shape::Array(Prefix::Dwrd, 16),
        CncToPlc,
        "8.4.6",
        text("Largest feed of the NC axes, from the configuration.", "Největší posuv NC os z konfigurace."),
    ),
    (
        "rAxGParabAccel",
        REAL,
        Both,
        "8.4.6",
        text("Parabolic acceleration of the geometric axes.", "Parabolické zrychlení geometrických os."),
    ),
    (
        "dwAxGLinearAccel",
        DWORD,
        Both,
        "8.4.6",
        text(
            "Acceleration of the geometric axes in the linear part of parabolic ramps.",
            "Zrychlení geometrických os v lineární části parabolických ramp.",
        ),
    ),
    (
        "REQ_PARABACCEL",
        Shape::Bit,
        PlcToCnc,
        "8.4.6",
        text("1: the program supplies rAxGParabAccel.", "Hodnota 1: rAxGParabAccel dodává program."),
    ),
    (
        "REQ_LINEARACCEL",
        Shape::Bit,
        PlcToCnc,
        "8.4.6",
        text("1: the program supplies dwAxGLinearAccel.", "Hodnota 1: dwAxGLinearAccel dodává program."),
    ),
];
