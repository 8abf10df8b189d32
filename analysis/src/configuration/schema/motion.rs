//! Servos, drives, encoders, axes and spindles of a `*.ChannelConfig` (manual 12, 13, 15, 23.2).

use super::channel::ACTIVE;
use super::{AttributeSpec, COUNT, FLAG, REAL, ValueKind, needed, optional};

/// Drives by number, as far as outputs and encoders share them.
const DRIVE_TYPES: &[i64] =
    &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29];
const ENCODER_TYPES: &[i64] =
    &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30];
const SERVO_TYPES: &[i64] = &[
    0, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
];
/// Codes of a gain: 00, 01 to 16, 51 to 66.
const GAIN_CODES: &[i64] = &[
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62,
    63, 64, 65, 66,
];
const REF_METHODS: &[i64] = &[1, 5, 9, 10, 11, 12, 13, 14, 15];

/// Attributes of `Servo`.
pub(super) const SERVO: &[AttributeSpec] = &[
    optional(
        "ServoType",
        ValueKind::Numbers(SERVO_TYPES),
        "0",
        "Kind of the loop, 1 is the software loop",
        "Typ servosmyčky, 1 je softwarová",
    ),
    optional(
        "FollowingErrorLimit",
        REAL,
        "1.0",
        "Limit of the difference counter in mm",
        "Limit diferenčního čítače v mm",
    ),
    optional("CheckCounter1", REAL, "1.0", "Zone of the check counter 1", "Zóna kontrolního čítače 1"),
    optional("CheckCounter2", REAL, "1.0", "Zone of the check counter 2", "Zóna kontrolního čítače 2"),
    optional("CheckCounter3", REAL, "1.0", "Zone of the check counter 3", "Zóna kontrolního čítače 3"),
    optional("DiffCountKill", FLAG, "0", "1: difference counter bridged", "1: diferenční čítač vyřazen"),
    optional(
        "DiffCountDirect",
        FLAG,
        "0",
        "1: measurement goes straight to the counter",
        "1: přímý vstup z odměřování",
    ),
    optional("InvertEncoderDirection", FLAG, "0", "1: encoder reversed", "1: inverze odměřování"),
    optional("AbsOutput", FLAG, "0", "1: absolute value of the output", "1: absolutní hodnota výstupu"),
    optional("InvertOutputPolarity", FLAG, "0", "1: output inverted", "1: invertovaný výstup"),
    optional(
        "MeasConstNumerator",
        ValueKind::Integer(i64::MIN, i64::MAX),
        "",
        "Measuring constant, numerator",
        "Konstanta odměřování, čitatel",
    ),
    optional(
        "MeasConstDenominator",
        ValueKind::Integer(i64::MIN, i64::MAX),
        "",
        "Measuring constant, denominator",
        "Konstanta odměřování, jmenovatel",
    ),
    optional(
        "ControlingServo",
        ValueKind::Any,
        "",
        "Servo that gives the demand (cascade)",
        "Servo, které dává žádanou hodnotu (kaskáda)",
    ),
];

/// Attributes of `ServoParamSet`.
pub(super) const SERVO_PARAM_SET: &[AttributeSpec] = &[
    optional("ServoParamP1", FLAG, "0", "1: speed loop on", "1: rychlostní smyčka zapnuta"),
    optional(
        "ServoParamP2",
        ValueKind::Integer(0, 2),
        "0",
        "Integrator: 0 off, 1 on, 2 at approach",
        "Integrátor: 0 vypnut, 1 zapnut, 2 při dojezdu",
    ),
    optional(
        "ServoParamK2",
        ValueKind::Numbers(GAIN_CODES),
        "0",
        "Gain of the speed loop",
        "Zesílení rychlostní smyčky",
    ),
    optional(
        "ServoParamK3",
        ValueKind::Numbers(GAIN_CODES),
        "0",
        "Coarse gain of the position loop",
        "Hrubé zesílení polohové smyčky",
    ),
    optional(
        "ServoParamK4",
        ValueKind::Numbers(GAIN_CODES),
        "0",
        "Integration constant",
        "Integrační konstanta",
    ),
    optional(
        "PPosController",
        ValueKind::Real(0.01, 99.99),
        "1.0",
        "Fine gain of the position loop",
        "Jemné zesílení polohové smyčky",
    ),
    optional("FeedForwardTs", REAL, "0.0", "Proportional feedforward", "Proporcionální feedforward"),
    optional(
        "FeedForwardFilter",
        ValueKind::Integer(0, 9),
        "0",
        "Filter of the derivative feedforward",
        "Filtr derivačního feedforwardu",
    ),
    optional(
        "FeedForwardTv",
        ValueKind::Integer(0, 7999),
        "0",
        "Derivative feedforward",
        "Derivační feedforward",
    ),
];

/// Attributes of `BandStopFilter`.
pub(super) const BAND_STOP_FILTER: &[AttributeSpec] = &[
    optional(
        "FilterActive",
        ValueKind::Integer(0, 2),
        "0",
        "0 off, 1 on, 2 while moving",
        "0 neaktivní, 1 aktivní, 2 při pohybu",
    ),
    optional("BandStopFilterF1", REAL, "0", "Proportional part", "Proporcionální přenos"),
    optional("BandStopFilterF2", REAL, "0", "Integral part", "Integrační složka"),
    optional("BandStopFilterF3", REAL, "0", "Derivative part", "Derivační složka"),
];

/// Attributes of `NonLinearCompensation`.
pub(super) const NON_LINEAR_COMPENSATION: &[AttributeSpec] = &[
    ACTIVE,
    optional(
        "Type",
        ValueKind::Integer(0, 2),
        "0",
        "0 basic, 1 cyclic, 2 dynamic",
        "0 základní, 1 cyklická, 2 dynamická",
    ),
    optional("ControllingAxis", COUNT, "", "Axis that leads", "Řídicí NC osa"),
    optional("Step", ValueKind::Real(0.0, 32.0), "1", "Step of the table in mm", "Krok tabulky v mm"),
    optional("Begin", REAL, "0", "Place of its first value in mm", "Umístění první položky v mm"),
    optional("StepCount", ValueKind::Integer(1, 1000), "1000", "Number of steps", "Počet kroků"),
    optional("CycleLen", REAL, "", "Length of the cycle in mm", "Délka cyklu v mm"),
    optional(
        "FileNamePos",
        ValueKind::Text,
        "",
        "Table for the positive direction",
        "Tabulka pro kladný směr",
    ),
    optional(
        "FileNameNeg",
        ValueKind::Text,
        "",
        "Table for the negative direction",
        "Tabulka pro záporný směr",
    ),
];

/// Attributes of `EncoderChannel`.
pub(super) const ENCODER_CHANNEL: &[AttributeSpec] = &[
    needed("No", COUNT, "Number of the channel", "Číslo kanálu"),
    optional("ChannelType", ValueKind::Numbers(ENCODER_TYPES), "0", "Kind of the channel", "Typ kanálu"),
    optional(
        "EncoderType",
        ValueKind::Integer(0, 5),
        "",
        "Kind of the encoder on SU05",
        "Typ odměřování na SU05",
    ),
    optional("LenReferMarks", FLAG, "0", "1: index pulse keeps its width", "1: šířka nulového pulzu zůstane"),
    optional("EncoderBegVoltage", REAL, "0.0", "Initial supply voltage", "Počáteční napětí"),
];

/// Attributes of `DriveChannel`.
pub(super) const DRIVE_CHANNEL: &[AttributeSpec] = &[
    needed("No", COUNT, "Number of the channel", "Číslo kanálu"),
    optional("DriveType", ValueKind::Numbers(DRIVE_TYPES), "0", "Kind of the channel", "Typ kanálu"),
    optional("SetDrift", REAL, "0", "Drift in volts", "Drift ve voltech"),
];

/// Attributes of `Common`.
pub(super) const COMMON: &[AttributeSpec] = &[
    optional(
        "SU05ChannelCount",
        COUNT,
        "0",
        "Number of channels on SU05 units",
        "Počet kanálů na jednotkách SU05",
    ),
    optional(
        "FeedForward",
        ValueKind::Integer(0, 2),
        "",
        "0 off, 1 on, 2 by the two below",
        "0 vypnut, 1 zapnut, 2 podle dalších dvou",
    ),
    optional("FeedForwardAut", ValueKind::Integer(0, 3), "", "In automatic mode", "V automatickém režimu"),
    optional("FeedForwardMan", ValueKind::Integer(0, 3), "", "In manual mode", "V ručním režimu"),
];

/// Attributes of `Spindle`.
pub(super) const SPINDLE: &[AttributeSpec] = &[
    optional("No", ValueKind::Integer(1, 2), "1", "Number of the spindle", "Číslo vřetene"),
    optional(
        "GearCount",
        ValueKind::Integer(0, 32),
        "0",
        "Number of gears, 0: not used",
        "Počet převodů, 0: nepoužito",
    ),
    optional(
        "SpeedLimit",
        REAL,
        "0",
        "Highest speed in rev/min, 0: that of the highest gear",
        "Maximální otáčky, 0: podle nejvyššího převodu",
    ),
];

/// Attributes of `Gear`.
pub(super) const GEAR: &[AttributeSpec] = &[
    needed("No", ValueKind::Integer(0, 31), "Number of the gear", "Číslo převodového stupně"),
    optional("MaxSpeed", REAL, "", "Highest speed in rev/min", "Maximální otáčky"),
    optional(
        "MaxOutput",
        ValueKind::Integer(0, 0x7FFF),
        "",
        "Output that belongs to it",
        "Výstupní hodnota, která jim odpovídá",
    ),
];

/// Attributes of `NCAxis`.
pub(super) const NC_AXIS: &[AttributeSpec] = &[
    optional("RefMethod", ValueKind::Numbers(REF_METHODS), "9", "How it is homed", "Typ reference"),
    optional("RefViaPlc", FLAG, "0", "1: always by the PLC", "1: vždy prostřednictvím PLC"),
    optional(
        "RefSwitch",
        ValueKind::Integer(0, 2),
        "1",
        "Switch: 0 not tested, 1 edge, 2 level",
        "Spínač: 0 netestovat, 1 hrana, 2 úroveň",
    ),
    optional("SlowDownSwitch", FLAG, "0", "1: slow-down switch tested", "1: zpomalovací spínač testovat"),
    optional(
        "InvertRefDirection",
        FLAG,
        "0",
        "1: homed in the negative direction",
        "1: najíždí se v záporném směru",
    ),
    optional("RefSpeed", REAL, "10000.0", "Speed in mm/min", "Rychlost v mm/min"),
    optional(
        "RefSpeedLow",
        REAL,
        "50.0",
        "Speed behind the switch in mm/min",
        "Rychlost po najetí na spínač v mm/min",
    ),
    optional("RefSpeedLowest", REAL, "0.0", "Lowest speed in mm/min", "Nejnižší rychlost v mm/min"),
    optional(
        "MoveToPosAfterRef",
        ValueKind::Integer(0, 2),
        "0",
        "Move afterwards: 0 none, 1 relative, 2 absolute",
        "Odjezd: 0 žádný, 1 relativně, 2 absolutně",
    ),
    optional("PosAfterRef", REAL, "0.0", "Where to, in mm", "Kam, v mm"),
    optional(
        "MachineNullPoint",
        REAL,
        "0",
        "Position of the reference mark in mm",
        "Míra v okamžiku referenční značky v mm",
    ),
    optional("FeedOvrDuringRef", FLAG, "0", "1: the override does not act", "1: override nepůsobí"),
    optional(
        "RefBlckAsNormal",
        FLAG,
        "0",
        "1: the PLC serves it as a normal block",
        "1: PLC ho obslouží jako normální blok",
    ),
    optional(
        "NeedRef",
        FLAG,
        "0",
        "1: moves in a program only when homed",
        "1: z programu jede jen po referenci",
    ),
    optional(
        "AutNeedRef",
        FLAG,
        "0",
        "1: a program starts only when homed",
        "1: start programu jen po referenci",
    ),
];
