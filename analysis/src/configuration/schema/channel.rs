//! `*.ChannelConfig` (manual 8, 9.1, 10, 11.2, 13, 15, 16.1, 23, 27).

use super::{AttributeSpec, COUNT, ElementSpec, FLAG, REAL, ValueKind, closed, needed, optional};

const ID: AttributeSpec = needed(
    "ID",
    ValueKind::Text,
    "Identifier, as the instruction of the PLC program names it",
    "Identifikátor, který uvádí instrukce PLC programu",
);
const PORT: AttributeSpec = optional(
    "Port",
    ValueKind::Integer(0, 128),
    "0",
    "Number of the physical port: an input's `Port=\"1\"` is P2IN, an output's is P1OUT",
    "Číslo fyzického portu: `Port=\"1\"` je u vstupu P2IN, u výstupu P1OUT",
);
const BIT: AttributeSpec =
    optional("Bit", ValueKind::Integer(0, 7), "0", "Bit of the port", "Číslo bitu na portu");
const INVERT: AttributeSpec =
    optional("Invert", FLAG, "0", "1: the connection inverts", "1: propojení invertuje");
const DEFAULT_BIT: AttributeSpec =
    optional("Default", FLAG, "", "Value while it is not connected", "Hodnota, pokud není propojen");
const CONNECTED: AttributeSpec = optional("Connected", FLAG, "0", "1: connected", "1: propojeno");
const PHYS_NO: AttributeSpec = optional(
    "PhysNo",
    ValueKind::Integer(0, 99),
    "0",
    "Number of the physical channel",
    "Číslo fyzického kanálu",
);
const SCALE: AttributeSpec =
    optional("Scale", REAL, "", "Factor between voltage and quantity", "Měřítko mezi napětím a veličinou");
const OFFSET: AttributeSpec = optional("Offset", REAL, "", "Shift of the voltage", "Posunutí napětí");
const MIN_VAL: AttributeSpec = optional("MinVal", REAL, "", "Smallest value", "Nejmenší přípustná hodnota");
const MAX_VAL: AttributeSpec = optional("MaxVal", REAL, "", "Largest value", "Největší přípustná hodnota");
const DEFAULT_REAL: AttributeSpec =
    optional("Default", REAL, "", "Value while it is not connected", "Hodnota, pokud není propojen");
const ACTIVE: AttributeSpec = optional("Active", FLAG, "0", "1: in use", "1: použito");

const BINARY: &[AttributeSpec] = &[ID, PORT, BIT, INVERT, DEFAULT_BIT, CONNECTED];
const ANALOG: &[AttributeSpec] = &[ID, PHYS_NO, SCALE, OFFSET, MIN_VAL, MAX_VAL, DEFAULT_REAL, CONNECTED];

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

const CAN_SPEED: ValueKind = ValueKind::Numbers(&[1_000_000, 500_000, 250_000, 125_000, 100_000]);
const M_FUNCTION: &[AttributeSpec] = &[
    needed("No", ValueKind::Integer(0, 100), "Number of the M function", "Číslo M funkce"),
    optional("GroupNo", ValueKind::Integer(1, 14), "14", "Group it belongs to", "Skupina, do které patří"),
    optional(
        "BreakCont",
        FLAG,
        "0",
        "1: ends continuous motion at the start of the block",
        "1: ruší plynulou jízdu na začátku bloku",
    ),
    optional(
        "BreakContEnd",
        FLAG,
        "0",
        "1: ends continuous motion at the end of the block",
        "1: ruší plynulou jízdu na konci bloku",
    ),
    optional("ChangePos", FLAG, "0", "1: changes the position of the machine", "1: mění polohu stroje"),
];

/// The elements. The root and what stands around these is not described.
pub(super) const ELEMENTS: &[ElementSpec] = &[
    closed("Plc", "10.2", "What the PLC program takes from the configuration", "Konfigurace pro PLC program"),
    ElementSpec {
        parents: &["Plc"],
        attributes: BINARY,
        ..closed("Input", "10.2", "Binary input for MAP_IN", "Binární vstup pro MAP_IN")
    },
    ElementSpec {
        parents: &["Plc"],
        attributes: BINARY,
        ..closed("Output", "10.2", "Binary output for MAP_OUT", "Binární výstup pro MAP_OUT")
    },
    ElementSpec {
        parents: &["Plc"],
        attributes: ANALOG,
        ..closed("AnalogInput", "10.3", "Analogue input for MAP_AIN", "Analogový vstup pro MAP_AIN")
    },
    ElementSpec {
        parents: &["Plc"],
        attributes: ANALOG,
        ..closed("AnalogOutput", "10.3", "Analogue output for MAP_AOUT", "Analogový výstup pro MAP_AOUT")
    },
    ElementSpec {
        parents: &["Plc"],
        attributes: &[
            ID,
            needed(
                "Type",
                ValueKind::Words(&["Int", "Real", "String", "Binary"]),
                "Type of the value",
                "Typ hodnoty",
            ),
        ],
        content: Some(ValueKind::Any),
        ..closed("PlcParam", "16.1", "Parameter for CNF_GET_…", "Parametr pro CNF_GET_…")
    },
    closed(
        "Connections",
        "27.5",
        "Links between logical outputs and inputs",
        "Spoje logických výstupů a vstupů",
    ),
    ElementSpec {
        parents: &["Connections"],
        attributes: &[
            needed(
                "Source",
                ValueKind::Text,
                "Logical output, for instance `PLC.Output.name`",
                "Logický výstup, například `PLC.Output.jméno`",
            ),
            needed(
                "Destination",
                ValueKind::Text,
                "Logical input, for instance `PLC.Input.name`",
                "Logický vstup, například `PLC.Input.jméno`",
            ),
            INVERT,
            optional("Scale", REAL, "1.0", "Factor, for numbers", "Měřítko, pro čísla"),
            optional("Offset", REAL, "0.0", "Shift, for numbers", "Posun, pro čísla"),
            CONNECTED,
        ],
        ..closed("Connection", "27.5", "One link", "Jeden spoj")
    },
    closed(
        "MFunctions",
        "8.2",
        "M functions with properties of their own",
        "M funkce s vlastními vlastnostmi",
    ),
    ElementSpec {
        parents: &["MFunctions"],
        attributes: M_FUNCTION,
        ..closed("MFunc", "8.2", "One M function", "Jedna M funkce")
    },
    // The manual's table prints this name, its examples the other.
    ElementSpec {
        parents: &["MFunctions"],
        attributes: M_FUNCTION,
        ..closed("MFuncs", "8.2", "One M function", "Jedna M funkce")
    },
    ElementSpec {
        attributes: &[
            needed(
                "No",
                COUNT,
                "Logical number, as COM_SEND and the others name it",
                "Logické číslo, které uvádí COM_SEND a ostatní",
            ),
            ACTIVE,
            optional(
                "ServiceMethod",
                ValueKind::Words(&["Buffered", "RT"]),
                "Buffered",
                "How it is served",
                "Způsob obsluhy",
            ),
            optional(
                "PhysicalComNo",
                ValueKind::Integer(1, 256),
                "",
                "Number of the port in Windows",
                "Číslo portu podle Windows",
            ),
            optional(
                "ComSpeed",
                ValueKind::Integer(1, i64::MAX),
                "115200",
                "Speed in bit/s",
                "Přenosová rychlost v bit/s",
            ),
            optional("ComDataBits", ValueKind::Numbers(&[7, 8]), "8", "Data bits", "Datové bity"),
            optional("ComStopBits", ValueKind::Numbers(&[1, 2]), "2", "Stop bits", "Stop bity"),
            optional(
                "ComParity",
                ValueKind::Words(&["None", "Odd", "Even", "Mark", "Space"]),
                "None",
                "Parity",
                "Parita",
            ),
        ],
        ..closed("ComChannel", "23.3", "Serial port of the PLC program", "Sériový port PLC programu")
    },
    ElementSpec {
        attributes: &[
            needed(
                "No",
                COUNT,
                "Number of the channel: 0 drives, 1 peripherals",
                "Číslo kanálu: 0 pohony, 1 periferie",
            ),
            ACTIVE,
            optional(
                "DeviceType",
                ValueKind::Words(&["MCAN01", "KLA60"]),
                "",
                "Unit the channel is on",
                "Jednotka, na které kanál je",
            ),
            optional(
                "DeviceName",
                ValueKind::Text,
                "",
                "Name of the unit in the EtherCAT project",
                "Název jednotky v projektu EtherCAT",
            ),
            optional(
                "PhysicalCanChannel",
                COUNT,
                "",
                "Number of the physical channel",
                "Číslo fyzického kanálu",
            ),
            optional("PhysicalCANChannel", COUNT, "", "The same in another spelling", "Totéž, jiný zápis"),
            optional("CanSpeed", CAN_SPEED, "1000000", "Speed in bit/s", "Rychlost v bit/s"),
            optional("CANSpeed", CAN_SPEED, "1000000", "The same in another spelling", "Totéž, jiný zápis"),
            optional(
                "ServicePeriod",
                ValueKind::Numbers(&[250, 500, 1000]),
                "250",
                "Period of service in µs",
                "Perioda obsluhy v µs",
            ),
            optional(
                "SyncPeriod",
                ValueKind::Integer(1, 15),
                "1",
                "Period of SYNC in ms",
                "Perioda SYNC v ms",
            ),
            optional(
                "InOut08Cnt",
                ValueKind::Integer(0, 32),
                "0",
                "Number of INOUT08 units",
                "Počet jednotek INOUT08",
            ),
            optional(
                "Kla50Cnt",
                ValueKind::Integer(0, 4),
                "0",
                "Number of KLA50 panels",
                "Počet panelů KLA50",
            ),
            optional("KnobCnt", ValueKind::Integer(0, 2), "0", "Number of handwheels", "Počet točítek"),
            optional("UseEdsFiles", FLAG, "0", "1: EDS files are used", "1: použijí se EDS soubory"),
            optional(
                "SdoDelay",
                COUNT,
                "0",
                "Pause between SDO packets in ms",
                "Prodleva mezi SDO pakety v ms",
            ),
        ],
        closed: false,
        ..closed("CANChannel", "9.1", "CAN-BUS channel", "Kanál CAN-BUS")
    },
    ElementSpec {
        attributes: &[
            optional("UseEdsFile", FLAG, "0", "1: used", "1: použit"),
            optional("NodeID", ValueKind::Integer(0, 127), "0", "Identifier of the drive", "ID pohonu"),
            optional(
                "FirstSdoIndex",
                ValueKind::Integer(0, 0xFFFF),
                "0",
                "First SDO index",
                "První SDO index",
            ),
            optional(
                "EdsFileName",
                ValueKind::Text,
                "",
                "Name of the file in the folder Config",
                "Jméno souboru v adresáři Config",
            ),
        ],
        ..closed("EdsFile", "13.16", "EDS file of a drive", "EDS soubor pohonu")
    },
    ElementSpec {
        attributes: &[
            needed(
                "No",
                ValueKind::Integer(0, 7),
                "Number of the device, 0 is the panel of the control",
                "Číslo zařízení, 0 je panel systému",
            ),
            ACTIVE,
            optional(
                "DeviceType",
                ValueKind::Words(&["PanelKla50", "PanelKla60", "KnobKla50", "JoystickKla50", "Virtual"]),
                "",
                "Kind of the device",
                "Druh zařízení",
            ),
            optional("DeviceName", ValueKind::Text, "", "Where it is connected", "Kde je připojeno"),
        ],
        ..closed(
            "HMIDevice",
            "11.2",
            "Panel, handwheel, joystick or virtual keyboard",
            "Panel, točítko, joystick nebo virtuální klávesnice",
        )
    },
    ElementSpec {
        attributes: &[
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
            optional(
                "CheckCounter1",
                REAL,
                "1.0",
                "Zone of the check counter 1",
                "Zóna kontrolního čítače 1",
            ),
            optional(
                "CheckCounter2",
                REAL,
                "1.0",
                "Zone of the check counter 2",
                "Zóna kontrolního čítače 2",
            ),
            optional(
                "CheckCounter3",
                REAL,
                "1.0",
                "Zone of the check counter 3",
                "Zóna kontrolního čítače 3",
            ),
            optional(
                "DiffCountKill",
                FLAG,
                "0",
                "1: difference counter bridged",
                "1: diferenční čítač vyřazen",
            ),
            optional(
                "DiffCountDirect",
                FLAG,
                "0",
                "1: measurement goes straight to the counter",
                "1: přímý vstup z odměřování",
            ),
            optional("InvertEncoderDirection", FLAG, "0", "1: encoder reversed", "1: inverze odměřování"),
            optional(
                "AbsOutput",
                FLAG,
                "0",
                "1: absolute value of the output",
                "1: absolutní hodnota výstupu",
            ),
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
        ],
        closed: false,
        ..closed("Servo", "13", "Servo loop", "Servosmyčka")
    },
    ElementSpec {
        parents: &["Servo"],
        attributes: &[
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
        ],
        closed: false,
        ..closed("ServoParamSet", "13.2", "Set of parameters of a servo loop", "Sada parametrů servosmyčky")
    },
    ElementSpec {
        parents: &["ServoParamSet"],
        attributes: &[
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
        ],
        ..closed("BandStopFilter", "13.11", "Band-stop filter", "Pásmová zádrž")
    },
    ElementSpec {
        parents: &["Servo"],
        attributes: &[
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
        ],
        ..closed(
            "NonLinearCompensation",
            "23.2",
            "Non-linear compensation; a servo has at most 3",
            "Nelineární korekce; servo jich má nejvýše 3",
        )
    },
    ElementSpec {
        attributes: &[
            needed("No", COUNT, "Number of the channel", "Číslo kanálu"),
            optional(
                "ChannelType",
                ValueKind::Numbers(ENCODER_TYPES),
                "0",
                "Kind of the channel",
                "Typ kanálu",
            ),
            optional(
                "EncoderType",
                ValueKind::Integer(0, 5),
                "",
                "Kind of the encoder on SU05",
                "Typ odměřování na SU05",
            ),
            optional(
                "LenReferMarks",
                FLAG,
                "0",
                "1: index pulse keeps its width",
                "1: šířka nulového pulzu zůstane",
            ),
            optional("EncoderBegVoltage", REAL, "0.0", "Initial supply voltage", "Počáteční napětí"),
        ],
        closed: false,
        ..closed("EncoderChannel", "13.13", "Encoder channel", "Kanál odměřování")
    },
    ElementSpec {
        attributes: &[
            needed("No", COUNT, "Number of the channel", "Číslo kanálu"),
            optional("DriveType", ValueKind::Numbers(DRIVE_TYPES), "0", "Kind of the channel", "Typ kanálu"),
            optional("SetDrift", REAL, "0", "Drift in volts", "Drift ve voltech"),
        ],
        closed: false,
        ..closed("DriveChannel", "13.13", "Output channel of a drive", "Výstupní kanál pohonu")
    },
    ElementSpec {
        attributes: &[
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
            optional(
                "FeedForwardAut",
                ValueKind::Integer(0, 3),
                "",
                "In automatic mode",
                "V automatickém režimu",
            ),
            optional("FeedForwardMan", ValueKind::Integer(0, 3), "", "In manual mode", "V ručním režimu"),
        ],
        closed: false,
        ..closed("Common", "13", "What all axes share", "Společné pro všechny osy")
    },
    ElementSpec {
        attributes: &[
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
        ],
        closed: false,
        ..closed("Spindle", "12", "Spindle", "Vřeteno")
    },
    ElementSpec {
        parents: &["Spindle"],
        attributes: &[
            needed("No", ValueKind::Integer(0, 31), "Number of the gear", "Číslo převodového stupně"),
            optional("MaxSpeed", REAL, "", "Highest speed in rev/min", "Maximální otáčky"),
            optional(
                "MaxOutput",
                ValueKind::Integer(0, 0x7FFF),
                "",
                "Output that belongs to it",
                "Výstupní hodnota, která jim odpovídá",
            ),
        ],
        closed: false,
        ..closed("Gear", "12", "Gear of a spindle", "Převodový stupeň")
    },
    ElementSpec {
        attributes: &[
            optional("RefMethod", ValueKind::Numbers(REF_METHODS), "9", "How it is homed", "Typ reference"),
            optional("RefViaPlc", FLAG, "0", "1: always by the PLC", "1: vždy prostřednictvím PLC"),
            optional(
                "RefSwitch",
                ValueKind::Integer(0, 2),
                "1",
                "Switch: 0 not tested, 1 edge, 2 level",
                "Spínač: 0 netestovat, 1 hrana, 2 úroveň",
            ),
            optional(
                "SlowDownSwitch",
                FLAG,
                "0",
                "1: slow-down switch tested",
                "1: zpomalovací spínač testovat",
            ),
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
        ],
        closed: false,
        ..closed("NCAxis", "15", "NC axis", "NC osa")
    },
];
