//! Words of HTML dialogs: editor of tables, shared variables, teach-in, fixed dialogs (manual 17 and 25).

use super::ConfigurationPlace;
use super::control::Group;
use crate::catalogue::pattern::text;

/// In the order of the manual.
pub(super) const GROUPS: &[Group] = &[
    (
        ConfigurationPlace::Dialog { element: "TABLE id" },
        "17.3.1",
        &[(
            "PlcTTableVieW",
            "",
            text(
                "Table in which the control shows the PLC table.",
                "Tabulka, do které systém zobrazí PLC tabulku.",
            ),
        )],
    ),
    (
        ConfigurationPlace::Dialog { element: "TD" },
        "17.3.1",
        &[(
            "PlcTColID",
            "",
            text("Column of the PLC table that is shown.", "Zobrazený sloupec PLC tabulky."),
        )],
    ),
    (
        ConfigurationPlace::Dialog { element: "TD ClickAction" },
        "17.3.1",
        &[(
            "EditedLineSet",
            "",
            text("A click chooses the row to be edited.", "Kliknutí zvolí editovaný řádek."),
        )],
    ),
    (
        ConfigurationPlace::Dialog { element: "INPUT name" },
        "17.3.1",
        &[(
            "PlcTValueEdit",
            "",
            text(
                "Field in which a value of the chosen row is edited.",
                "Pole pro editaci hodnoty zvoleného řádku.",
            ),
        )],
    ),
    (
        ConfigurationPlace::Dialog { element: "INPUT" },
        "17.3.1",
        &[
            (
                "PlcTColID",
                "",
                text(
                    "Column of the PLC table that the field edits.",
                    "Sloupec PLC tabulky, který pole edituje.",
                ),
            ),
            (
                "DdxOptions",
                "",
                text(
                    "Form of the number: NumberWidth digits, NumberPrecision decimal places.",
                    "Tvar čísla: NumberWidth číslic, NumberPrecision desetinných míst.",
                ),
            ),
        ],
    ),
    (
        ConfigurationPlace::Dialog { element: "BUTTON id" },
        "17.3.1",
        &[
            ("EditedLinePrev", "", text("Goes to the previous row.", "Přejde na předchozí řádek.")),
            ("EditedLineNext", "", text("Goes to the next row.", "Přejde na další řádek.")),
            ("AddLine", "", text("Adds a row.", "Přidá řádek.")),
            ("RemoveLine", "", text("Removes a row.", "Odebere řádek.")),
            ("OK", "", text("Confirms the dialog.", "Potvrdí dialog.")),
            ("Cancel", "", text("Leaves the dialog without a change.", "Opustí dialog beze změny.")),
        ],
    ),
    (
        ConfigurationPlace::Dialog { element: "TABLE CNCType" },
        "17.5.1",
        &[("SharedVarInfo", "", text("Table of shared variables.", "Tabulka sdílených proměnných."))],
    ),
    (
        ConfigurationPlace::Dialog { element: "TABLE" },
        "17.5.1",
        &[(
            "SVIOptions",
            "",
            text(
                "Which shared variables: Channel, VarSource, Type, Sort, Filter.",
                "Které sdílené proměnné: Channel, VarSource, Type, Sort, Filter.",
            ),
        )],
    ),
    (
        ConfigurationPlace::Dialog { element: "TD" },
        "17.5.1",
        &[
            (
                "SVIValType",
                "",
                text(
                    "What of the variable the column shows, such as VarName or VarValue.",
                    "Co z proměnné sloupec zobrazí, například VarName nebo VarValue.",
                ),
            ),
            ("TDClass", "", text("CSS class of the column.", "Třída CSS sloupce.")),
            (
                "ExtraAIPOptions",
                "",
                text(
                    "Further form of the value, such as NumberPrecision.",
                    "Další formátování hodnoty, například NumberPrecision.",
                ),
            ),
        ],
    ),
    (
        ConfigurationPlace::Dialog { element: "INPUT" },
        "17.6.2",
        &[
            (
                "TeachInOptions",
                "",
                text(
                    "What the field writes into the block of the NC program.",
                    "Co pole zapíše do bloku NC programu.",
                ),
            ),
            ("Value", "0", text("0 leaves the field out of the block.", "Hodnota 0 pole z bloku vynechá.")),
        ],
    ),
    (
        ConfigurationPlace::Dialog { element: "INPUT TeachInOptions" },
        "17.6.2",
        &[
            (
                "TypeN",
                "",
                text(
                    "Source of part N: Fixed, Element, RTMVar or PLCVar.",
                    "Zdroj části N: Fixed, Element, RTMVar nebo PLCVar.",
                ),
            ),
            ("ValueN", "", text("Text of part N of the type Fixed.", "Text části N typu Fixed.")),
            (
                "ElementIDN",
                "",
                text("ID of the element whose Value part N writes.", "ID prvku, jehož Value část N zapíše."),
            ),
            (
                "VarChannel",
                "0",
                text("Channel of the variable of RTMVar and PLCVar.", "Kanál proměnné pro RTMVar a PLCVar."),
            ),
            (
                "VarName",
                "",
                text("Shared variable of RTMVar and PLCVar.", "Sdílená proměnná pro RTMVar a PLCVar."),
            ),
            (
                "NumberWidth",
                "0",
                text(
                    "Least number of digits, filled with zeros.",
                    "Nejmenší počet číslic, doplňují se nuly.",
                ),
            ),
            ("NumberPrecision", "3", text("Number of decimal places.", "Počet desetinných míst.")),
            (
                "FilterType",
                "",
                text(
                    "Write: only the elements that FilterValue names, when Value is 1.",
                    "Write: jen prvky uvedené ve FilterValue, je-li Value 1.",
                ),
            ),
            ("FilterValue", "", text("Values of the filter.", "Hodnoty filtru.")),
        ],
    ),
    (
        ConfigurationPlace::Dialog { element: "BODY" },
        "17.6.3",
        &[
            ("CNCDirectory", "", text("Directory of the NC programs.", "Adresář NC programů.")),
            ("InitText", "", text("Text at the beginning of the program.", "Text na začátku programu.")),
            (
                "EditBlock",
                "",
                text("Asks for the edit mode of the teach-in.", "Žádost o editační režim teach-inu."),
            ),
            (
                "BlockCounter",
                "",
                text(
                    "1 writes the number of the step into the comment of a block.",
                    "Hodnota 1 zapíše číslo kroku do komentáře bloku.",
                ),
            ),
            ("BlockText", "", text("Text in the comment of each block.", "Text v komentáři každého bloku.")),
            ("FinalText", "", text("Text at the end of the program.", "Text na konci programu.")),
        ],
    ),
    (
        ConfigurationPlace::Dialog { element: "INPUT" },
        "25",
        &[
            (
                "storageName",
                "",
                text(
                    "Variable of the NC program that the field fills; the header X.NCH defines it.",
                    "Proměnná NC programu, kterou pole naplní; definuje ji hlavička X.NCH.",
                ),
            ),
            (
                "NumberCheck",
                "",
                text(
                    "Check of the number: NumberType Real or Integer.",
                    "Kontrola čísla: NumberType Real nebo Integer.",
                ),
            ),
            (
                "InitialValue",
                "",
                text(
                    "First value of a check box in the left menu.",
                    "Počáteční hodnota zaškrtávacího pole v levém menu.",
                ),
            ),
        ],
    ),
    (
        ConfigurationPlace::Dialog { element: "*" },
        "25",
        &[(
            "LocStrID",
            "",
            text(
                "ID of the text in the StringTable of the language.",
                "ID textu v tabulce StringTable daného jazyka.",
            ),
        )],
    ),
    (
        ConfigurationPlace::Dialog { element: "DIV" },
        "25",
        &[(
            "innerHTMLFile",
            "",
            text("File whose content fills the element.", "Soubor, jehož obsah prvek naplní."),
        )],
    ),
    (
        ConfigurationPlace::Dialog { element: "DIV id" },
        "25",
        &[
            ("StringTableCSY", "", text("Texts of the page in Czech.", "Texty stránky v češtině.")),
            ("StringTablePLK", "", text("Texts of the page in Polish.", "Texty stránky v polštině.")),
            ("StringTableENU", "", text("Texts of the page in English.", "Texty stránky v angličtině.")),
        ],
    ),
];
