//! `*.KbdConfig` (manual 11.3).

use super::{AttributeSpec, ElementSpec, Names, ValueKind, closed, needed, optional};

const TYPE: AttributeSpec = optional(
    "Type",
    ValueKind::Words(&["Normal", "Multi"]),
    "",
    "`Multi`: each press changes the function",
    "`Multi`: pořadí stisků mění funkci",
);
const VIRTUAL_KEY: AttributeSpec = optional(
    "VirtualKey",
    ValueKind::Named(Names::VirtualKey),
    "",
    "Key of a PC keyboard that the button imitates",
    "Klávesa PC klávesnice, kterou tlačítko nahrazuje",
);
const ENABLE_REPEAT: AttributeSpec = optional(
    "EnableRepeat",
    ValueKind::Words(&["False", "True"]),
    "False",
    "Repeats while it is held",
    "Opakuje, dokud je držené",
);
const LOWER: AttributeSpec =
    optional("UnicodeCharLower", ValueKind::Hex(0x10_FFFF), "", "Character without SHIFT", "Znak bez SHIFT");
const UPPER: AttributeSpec =
    optional("UnicodeCharUpper", ValueKind::Hex(0x10_FFFF), "", "Character with SHIFT", "Znak se SHIFT");
const COMMAND: AttributeSpec =
    optional("Command", ValueKind::Named(Names::Command), "", "Command for the control", "Příkaz pro systém");
const PLC_COMMAND: AttributeSpec = optional(
    "PlcCommand",
    ValueKind::Text,
    "",
    "Command for the PLC program: `ID` of a constant of a `*.PlcConstants` file, handed to `_ON_CMD`",
    "Příkaz pro PLC program: `ID` konstanty ze souboru `*.PlcConstants`, dostane ho `_ON_CMD`",
);
const RTM_COMMAND: AttributeSpec = optional(
    "RtmCommand",
    ValueKind::Named(Names::RtmCommand),
    "",
    "Command for the real-time program",
    "Příkaz pro program reálného času",
);

/// The elements.
pub(super) const ELEMENTS: &[ElementSpec] = &[
    closed("KeyboardConfig", "11.3", "Buttons of a panel", "Tlačítka panelu"),
    ElementSpec {
        parents: &["KeyboardConfig"],
        content: Some(ValueKind::Any),
        ..closed("Comment", "11.3", "A remark", "Poznámka")
    },
    ElementSpec {
        parents: &["KeyboardConfig"],
        attributes: &[
            needed(
                "ScanCode",
                ValueKind::Hex(0xFFFF),
                "Physical code of the button, hexadecimal",
                "Fyzický kód tlačítka, hexadecimálně",
            ),
            TYPE,
            VIRTUAL_KEY,
            ENABLE_REPEAT,
            LOWER,
            UPPER,
            COMMAND,
            PLC_COMMAND,
            RTM_COMMAND,
        ],
        ..closed("KeyConfig", "11.3.1", "One button", "Jedno tlačítko")
    },
    ElementSpec {
        parents: &["KeyConfig"],
        attributes: &[
            optional(
                "No",
                ValueKind::Integer(0, 3),
                "0",
                "Number of the function, 0 is the basic one",
                "Číslo funkce, 0 je základní",
            ),
            TYPE,
            VIRTUAL_KEY,
            ENABLE_REPEAT,
            LOWER,
            UPPER,
            COMMAND,
            PLC_COMMAND,
            RTM_COMMAND,
        ],
        ..closed("Function", "11.3.2", "One function of a button with several", "Jedna z funkcí tlačítka")
    },
    ElementSpec {
        parents: &["KeyConfig", "Function"],
        content: Some(ValueKind::Text),
        ..closed("Dialog", "11.3.1", "Dialog that the button opens", "Dialog, který tlačítko otevře")
    },
    ElementSpec {
        parents: &["KeyConfig", "Function"],
        content: Some(ValueKind::Text),
        ..closed("Layout", "11.3.1", "Layout that the button shows", "Rozvržení, které tlačítko zobrazí")
    },
    ElementSpec {
        parents: &["KeyConfig"],
        content: Some(ValueKind::Any),
        closed: false,
        ..closed("Multikey", "11.3.1", "A button whose presses change the function", "Multifunkční tlačítko")
    },
];
