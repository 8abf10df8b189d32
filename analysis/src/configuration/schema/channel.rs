//! `*.ChannelConfig` (manual 8, 9.1, 10, 11.2, 13, 15, 16.1, 23, 27).

use super::{AttributeSpec, COUNT, ElementSpec, FLAG, REAL, ValueKind, closed, motion, needed, optional};

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
pub(super) const ACTIVE: AttributeSpec = optional("Active", FLAG, "0", "1: in use", "1: použito");

const BINARY: &[AttributeSpec] = &[ID, PORT, BIT, INVERT, DEFAULT_BIT, CONNECTED];
const ANALOG: &[AttributeSpec] = &[ID, PHYS_NO, SCALE, OFFSET, MIN_VAL, MAX_VAL, DEFAULT_REAL, CONNECTED];

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
        attributes: motion::SERVO,
        closed: false,
        ..closed("Servo", "13", "Servo loop", "Servosmyčka")
    },
    ElementSpec {
        parents: &["Servo"],
        attributes: motion::SERVO_PARAM_SET,
        closed: false,
        ..closed("ServoParamSet", "13.2", "Set of parameters of a servo loop", "Sada parametrů servosmyčky")
    },
    ElementSpec {
        parents: &["ServoParamSet"],
        attributes: motion::BAND_STOP_FILTER,
        ..closed("BandStopFilter", "13.11", "Band-stop filter", "Pásmová zádrž")
    },
    ElementSpec {
        parents: &["Servo"],
        attributes: motion::NON_LINEAR_COMPENSATION,
        ..closed(
            "NonLinearCompensation",
            "23.2",
            "Non-linear compensation; a servo has at most 3",
            "Nelineární korekce; servo jich má nejvýše 3",
        )
    },
    ElementSpec {
        attributes: motion::ENCODER_CHANNEL,
        closed: false,
        ..closed("EncoderChannel", "13.13", "Encoder channel", "Kanál odměřování")
    },
    ElementSpec {
        attributes: motion::DRIVE_CHANNEL,
        closed: false,
        ..closed("DriveChannel", "13.13", "Output channel of a drive", "Výstupní kanál pohonu")
    },
    ElementSpec {
        attributes: motion::COMMON,
        closed: false,
        ..closed("Common", "13", "What all axes share", "Společné pro všechny osy")
    },
    ElementSpec {
        attributes: motion::SPINDLE,
        closed: false,
        ..closed("Spindle", "12", "Spindle", "Vřeteno")
    },
    ElementSpec {
        parents: &["Spindle"],
        attributes: motion::GEAR,
        closed: false,
        ..closed("Gear", "12", "Gear of a spindle", "Převodový stupeň")
    },
    ElementSpec { attributes: motion::NC_AXIS, closed: false, ..closed("NCAxis", "15", "NC axis", "NC osa") },
];
