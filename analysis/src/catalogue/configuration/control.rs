//! Types of panels, names in the registry, parameters of NC programs (manual 11.1, 11.2, 17, 23.1.2 and 26.1).

use super::{ConfigurationPlace, ConfigurationWord, dialogs};
use crate::catalogue::entry::Bilingual;
use crate::catalogue::pattern::text;

/// Name, value when it is left out, meaning.
pub(super) type Row = (&'static str, &'static str, Bilingual);

/// Rows of one place and chapter.
pub(super) type Group = (ConfigurationPlace, &'static str, &'static [Row]);

const GROUPS: &[Group] = &[
    (
        ConfigurationPlace::Panel,
        "11.1",
        &[
            (
                "PanelKla50",
                "",
                text(
                    "Panel on the CAN bus with up to 112 buttons and two wheels, at most four.",
                    "Panel na sběrnici CAN s až 112 tlačítky a dvěma kolečky, nejvýše čtyři.",
                ),
            ),
            (
                "EPU",
                "",
                text(
                    "External panel on the CAN bus, isolated, with up to 48 buttons; configured as PanelKla50 (this implementation).",
                    "Externí panel na sběrnici CAN s galvanickým oddělením a až 48 tlačítky; konfiguruje se jako PanelKla50 (tato implementace).",
                ),
            ),
            (
                "JoystickKla50",
                "",
                text("Joystick with 18 buttons on the CAN bus.", "Joystick s 18 tlačítky na sběrnici CAN."),
            ),
            (
                "PanelKla60",
                "",
                text(
                    "Panel on EtherCAT with up to 112 buttons and two wheels.",
                    "Panel na sběrnici EtherCAT s až 112 tlačítky a dvěma kolečky.",
                ),
            ),
            (
                "KnobKla50",
                "",
                text(
                    "Knob on the CAN bus with up to nine buttons, a display and a wheel, at most two.",
                    "Točítko na sběrnici CAN s až devíti tlačítky, displejem a kolečkem, nejvýše dvě.",
                ),
            ),
            (
                "Virtual",
                "",
                text(
                    "Virtual keyboard of 256 buttons, which bits of the program press.",
                    "Virtuální klávesnice s 256 tlačítky, která tisknou bity programu.",
                ),
            ),
        ],
    ),
    (
        ConfigurationPlace::Registry { key: r"Channels\Channel0\Keyboards" },
        "11.2",
        &[
            (
                "Keyboard0",
                "",
                text(
                    "Key of the main panel; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro hlavní panel; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
            (
                "Keyboard1",
                "",
                text(
                    "Key of the first external panel or joystick; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro první externí panel nebo joystick; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
            (
                "Keyboard2",
                "",
                text(
                    "Key of the second external panel or joystick; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro druhý externí panel nebo joystick; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
            (
                "Keyboard3",
                "",
                text(
                    "Key of the third external panel or joystick; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro třetí externí panel nebo joystick; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
            (
                "Keyboard4",
                "",
                text(
                    "Key of the first knob; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro první točítko; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
            (
                "Keyboard5",
                "",
                text(
                    "Key of the second knob; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro druhé točítko; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
            (
                "Keyboard6",
                "",
                text(
                    "Key of the virtual keyboard; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro virtuální klávesnici; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
            (
                "Keyboard7",
                "",
                text(
                    "Key of a further keyboard; its value ConfigFiles lists the KbdConfig files.",
                    "Klíč pro další klávesnici; jeho hodnota ConfigFiles uvádí soubory KbdConfig.",
                ),
            ),
        ],
    ),
    (
        ConfigurationPlace::Registry { key: r"HKLM\Software\MEFI\WinCNC\Machine\Common" },
        "26.1",
        &[
            ("RtxEtherCAT", "1", text("1 activates EtherCAT.", "Hodnota 1 aktivuje EtherCAT.")),
            (
                "EtherCATSynchMode",
                "2",
                text(
                    "Synchronisation of EtherCAT; the manual does not explain its values.",
                    "Synchronizace sítě EtherCAT; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATDebug",
                "0",
                text(
                    "Debugging of EtherCAT; the manual does not explain its values.",
                    "Ladění sítě EtherCAT; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATPhaseAdjust",
                "1",
                text(
                    "Adjustment of the phase of EtherCAT; the manual does not explain its values.",
                    "Dolaďování fáze sítě EtherCAT; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATDelayOP",
                "500",
                text(
                    "Delay of the state OPERATIONAL; the manual does not explain its values.",
                    "Zpoždění stavu OPERATIONAL; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATMasterConfigFile",
                "Master.xml",
                text("File with the configuration of the master.", "Soubor s konfigurací masteru."),
            ),
            ("EtherCATMasterCycleTime", "1000", text("Cycle of the master in µs.", "Cyklus masteru v µs.")),
            (
                "FastestPeriod",
                "1000",
                text("Period of MODULE_FASTEST in µs.", "Perioda modulu MODULE_FASTEST v µs."),
            ),
            (
                "HALTimerPeriod",
                "1000",
                text(
                    "Period of the timer of the system; the manual does not explain its values.",
                    "Perioda časovače systému; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATStatistic",
                "0",
                text(
                    "Statistics of EtherCAT; the manual does not explain its values.",
                    "Statistika sítě EtherCAT; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATWatchMaster",
                "1",
                text(
                    "Supervision of the master; the manual does not explain its values.",
                    "Hlídání masteru; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATWatchSlaves",
                "0",
                text(
                    "Supervision of the slaves; the manual does not explain its values.",
                    "Hlídání stanic slave; hodnoty příručka nevysvětluje.",
                ),
            ),
            (
                "EtherCATOPViaPLC",
                "0",
                text(
                    "1: the program starts the cyclic exchange by flEcatStartCyclicOperation.",
                    "Hodnota 1: cyklickou výměnu dat spouští program bitem flEcatStartCyclicOperation.",
                ),
            ),
        ],
    ),
    (
        ConfigurationPlace::Registry { key: r"HKLM\Software\MEFI\WinCNC\Machine\PLC\Tables" },
        "17.1.2",
        &[
            (
                "PlcTableDef",
                "",
                text(
                    "File *.PlcTDef that defines a table; the number of the table follows the name.",
                    "Definiční soubor *.PlcTDef tabulky; za názvem následuje číslo tabulky.",
                ),
            ),
            (
                "PlcTable",
                "",
                text(
                    "File *.PlcT with the data of a table; the number of the table follows the name.",
                    "Datový soubor *.PlcT tabulky; za názvem následuje číslo tabulky.",
                ),
            ),
        ],
    ),
    (
        ConfigurationPlace::Registry { key: r"HKLM\Software\MEFI\WinCNC\Machine\UserInterface\Dialogs" },
        "17.3.2",
        &[
            (
                "Library",
                "",
                text(
                    "Library of a dialog: StdPlugins for the editor of tables, WinCNC for the teach-in.",
                    "Knihovna dialogu: StdPlugins pro editor tabulek, WinCNC pro teach-in.",
                ),
            ),
            (
                "Type",
                "",
                text(
                    "Kind of a dialog: PlcTableEditor or Teachin.",
                    "Druh dialogu: PlcTableEditor nebo Teachin.",
                ),
            ),
            ("HtmlFile", "", text("HTML file of a dialog.", "Soubor HTML dialogu.")),
            ("Left", "880", text("Position of the window of the teach-in.", "Poloha okna dialogu teach-in.")),
        ],
    ),
    (
        ConfigurationPlace::SoftMenu,
        "17.3.3",
        &[(
            "SoftMenuItem",
            "",
            text(
                "Item of a soft menu; its Dialog names the dialog that it opens.",
                "Položka softwarového menu; její Dialog uvádí dialog, který otevře.",
            ),
        )],
    ),
    (
        ConfigurationPlace::NcProgram,
        "23.1.2",
        &[
            (
                "CCS",
                "",
                text(
                    "Cutting speed in m/min, instead of S under G96.",
                    "Řezná rychlost v m/min namísto S při G96.",
                ),
            ),
            (
                "SLIM",
                "",
                text(
                    "Greatest spindle speed under constant cutting speed.",
                    "Maximální otáčky vřetena při konstantní řezné rychlosti.",
                ),
            ),
        ],
    ),
];

pub(super) fn list(words: &mut Vec<ConfigurationWord>) {
    for &(place, chapter, rows) in GROUPS.iter().chain(dialogs::GROUPS) {
        words.extend(rows.iter().map(|&(name, default, summary)| ConfigurationWord {
            name,
            place,
            default,
            summary,
            chapter,
        }));
    }
}
