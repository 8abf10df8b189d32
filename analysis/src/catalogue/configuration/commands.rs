//! Values of `Command`: commands of the control (manual 11.3.4).

use super::expand::Row;

/// In the order of the manual.
pub(super) const ROWS: &[Row] = &[
    (
        "ID_SM{TOP|LEFT|RIGHT|BOTTOM}_BTN{0-15}",
        "Presses button {2} of the {1:top|left|right|bottom} soft menu.",
        "Stisk tlačítka {2} {1:horního|levého|pravého|dolního} softwarového menu.",
    ),
    (
        "ID_SM_{LAYOUT|MAIN|SWITCH}",
        "Soft menu: {1:shows the menu of the layout|shows the main menu|changes to the other menu}.",
        "Softwarové menu: {1:zobrazí menu rozvržení|zobrazí hlavní menu|přepne na druhé menu}.",
    ),
    (
        "ID_SM_{LAYOUTCOND|MAINCOND}",
        "Soft menu: shows {1:the menu of the layout|the main menu} under a condition.",
        "Softwarové menu: podmíněně zobrazí {1:menu rozvržení|hlavní menu}.",
    ),
    (
        "ID_FILE_{SAVE_ALL|NEW|OPEN|OPENSYSTEM|CLOSE}",
        "Files: {1:saves all|makes a new one|opens one|opens a system file|closes the current one}.",
        "Soubory: {1:uloží všechny|založí nový|otevře soubor|otevře systémový soubor|zavře aktuální}.",
    ),
    (
        "ID_FILE_{SAVE|SAVE_AS|SAVE_COPY_AS|UPDATE}",
        "Files: saves the current one{1:| under another name|, a copy under another name| where it came from}.",
        "Soubory: uloží aktuální{1:| pod jiným názvem|, kopii pod jiným názvem| do zdroje}.",
    ),
    (
        "ID_FILE_{PAGE_SETUP|PRINT_SETUP|PRINT|PRINT_DIRECT|PRINT_PREVIEW}",
        "Files: {1:sets the page up|sets the printer up|prints|prints without asking|shows the preview of the print}.",
        "Soubory: {1:nastaví stránku|nastaví tiskárnu|vytiskne|vytiskne bez dotazu|zobrazí náhled tisku}.",
    ),
    ("ID_FILE_SEND_MAIL", "Files: sends the current one by mail.", "Soubory: odešle aktuální poštou."),
    (
        "ID_FILE_NEW_FRAME",
        "Files: opens the current one in a new window.",
        "Soubory: otevře aktuální v novém okně.",
    ),
    ("ID_FILE_MRU_FIRST", "Opens the file edited last.", "Otevře naposledy editovaný soubor."),
    (
        "ID_FILE_MRU_FILE{1-16}",
        "Opens recently edited file {1}.",
        "Otevře naposledy editovaný soubor číslo {1}.",
    ),
    (
        "ID_EDIT_{SELECTINGMODE|CLEAR|CLEAR_ALL|COPY|CUT}",
        "Editing: {1:switches the selecting mode|deletes the selection|deletes everything|copies the selection|cuts the selection}.",
        "Editace: {1:přepne režim výběru|smaže výběr|smaže vše|zkopíruje výběr|vyjme výběr}.",
    ),
    (
        "ID_EDIT_{FIND|FIND_PREVIOUS|REPLACE|REPEAT|SELECT_ALL|UNDO|REDO}",
        "Editing: {1:finds a text|finds the one before|replaces a text|repeats the last action|selects everything|undoes the last change|does the undone change again}.",
        "Editace: {1:najde text|najde předchozí výskyt|nahradí text|zopakuje poslední akci|vybere vše|vrátí poslední změnu|znovu provede vrácenou změnu}.",
    ),
    (
        "ID_EDIT_PASTE{|_LINK|_SPECIAL}",
        "Editing: pastes the clipboard{1:| as a link| in a chosen form}.",
        "Editace: vloží schránku{1:| jako odkaz| ve zvolené podobě}.",
    ),
    (
        "ID_EDIT_{TOGGLE|GO}_BOOKMARK{0-9}",
        "Editing: {1:sets or removes|goes to} book-mark {2}.",
        "Editace: {1:nastaví nebo zruší záložku|přejde na záložku} {2}.",
    ),
    (
        "ID_EDIT_{CLEAR_BOOKMARKS|CLEAR_ALL_BOOKMARKS|TOGGLE_BOOKMARK}",
        "Editing: {1:removes the numbered book-marks|removes all book-marks|sets or removes a book-mark}.",
        "Editace: {1:zruší číslované záložky|zruší všechny záložky|nastaví nebo zruší záložku}.",
    ),
    (
        "ID_EDIT_GOTO_{NEXT_BOOKMARK|PREV_BOOKMARK|LAST_CHANGE}",
        "Editing: goes to the {1:next book-mark|previous book-mark|last change}.",
        "Editace: přejde na {1:další záložku|předchozí záložku|poslední změnu}.",
    ),
    (
        "ID_EDIT_FIND_INCREMENTAL_{FORWARD|BACKWARD}",
        "Editing: finds while typing, {1:forward|backward}.",
        "Editace: hledá během psaní {1:vpřed|vzad}.",
    ),
    ("ID_EDIT_MATCHBRACE", "Editing: goes to the matching bracket.", "Editace: přejde na párovou závorku."),
    (
        "ID_EDIT_{LOWERCASE|UPPERCASE|CAPITALIZE|SENTENCE|SWAPCASE}",
        "Editing: changes the selection to {1:lower case|upper case|capitals at words|a capital at sentences|the other case}.",
        "Editace: převede výběr na {1:malá písmena|velká písmena|velká písmena slov|velké písmeno věty|opačnou velikost písmen}.",
    ),
    ("ID_EDIT_GOTO", "Editing: goes to a line.", "Editace: přejde na řádek."),
    (
        "ID_READ_ONLY",
        "Sets or clears the read-only mark of the current file.",
        "Nastaví nebo zruší příznak „jen pro čtení“ aktuálního souboru.",
    ),
    ("ID_VIEW_LAYOUTCONFIG", "Shows the choice of indication.", "Zobrazí volbu indikace."),
    ("ID_FORMAT_BPR", "Formatting: sets the bytes in a row.", "Formátování: nastaví počet bajtů na řádku."),
    (
        "ID_FORMAT_BPR_{1-9}",
        "Formatting: choice {1} of the bytes in a row.",
        "Formátování: volba {1} počtu bajtů na řádku.",
    ),
    (
        "ID_FORMAT_SHOW_{ADDRESS|HEX|ASCII}",
        "Formatting: shows or hides the {1:addresses|hexadecimal column|column of characters}.",
        "Formátování: zobrazí nebo skryje {1:adresy|hexadecimální sloupec|sloupec znaků}.",
    ),
    (
        "ID_FORMAT_{WIDE_ADDRESS|FONT}",
        "Formatting: {1:wide addresses|chooses the font}.",
        "Formátování: {1:široké adresy|výběr písma}.",
    ),
    ("ID_TOOLS_OPTIONS", "Tools: shows their options.", "Nástroje: zobrazí jejich volby."),
    ("ID_TOOLS_TOOL{0-9}", "Tools: starts tool {1}.", "Nástroje: spustí nástroj {1}."),
    (
        "ID_WINDOW_MDI{NEXT|PREV}",
        "Windows: goes to the {1:next|previous} one.",
        "Okna: přejde na {1:další|předchozí}.",
    ),
    (
        "ID_APP_{ABOUT|EXIT}",
        "Application: {1:tells about it|ends it}.",
        "Aplikace: {1:zobrazí informace|ukončí ji}.",
    ),
    ("ID_SYSTEM_SWITCHOFF", "Switches the control off.", "Vypne systém."),
    ("ID_CNC_SELECTCANUL", "Central annulment.", "Centrální anulace."),
    (
        "ID_CNC_SELECTREF{0-9}",
        "Reference run by configuration {1}.",
        "Nájezd do reference podle konfigurace {1}.",
    ),
    ("ID_CNC_SELECTNCP", "Chooses the NC program.", "Volba programu."),
    ("ID_CNC_SELECTBLOCK", "Chooses the block.", "Volba bloku."),
    (
        "ID_CNC_SELECTBLOCK{0-9}",
        "Chooses the block by configuration {1}.",
        "Volba bloku podle konfigurace {1}.",
    ),
    ("ID_CNC_{START|STOP}", "{1:Starts|Stops} the NC program.", "{1:Start|Stop} NC programu."),
    (
        "ID_CNC_CONT",
        "Goes on after a stop, even away from the place of the stop.",
        "Pokračování po stopu, i když bylo odjeto z místa stopu.",
    ),
    (
        "ID_CNC_REVERSE",
        "Changes the direction in which the program is executed.",
        "Změna směru vykonávání programu.",
    ),
    (
        "ID_CNC_{FORWARD|BACKWARD}",
        "Executes the program {1:forward|backward}.",
        "Vykonávání programu {1:vpřed|vzad}.",
    ),
    (
        "ID_CNC_GO{FORWARD|BACKWARD}",
        "Executes the program {1:forward|backward} while held; pressed in a stop.",
        "Vykonávání programu {1:vpřed|vzad} po dobu držení; stisk ve stopu.",
    ),
    (
        "ID_CNC_IMMBACKWARD",
        "Executes the program backward while held; pressed during motion.",
        "Vykonávání programu vzad po dobu držení; stisk za jízdy.",
    ),
    (
        "ID_CNC_BLOCKBYBLOCK",
        "Switches the block-by-block mode on or off.",
        "Zapne nebo vypne režim blok po bloku.",
    ),
    (
        "ID_CNC_CONDSTOPMODE",
        "Switches the conditional stop of M01 on or off.",
        "Zapne nebo vypne podmíněný stop (M01).",
    ),
    ("ID_CNC_{START|STOP}PLC", "{1:Starts|Stops} the PLC program.", "{1:Spustí|Zastaví} PLC program."),
    (
        "ID_MMM_{MAN|MANEND}",
        "{1:Switches manual motion on|Ends manual motion}.",
        "{1:Zapnutí|Ukončení} ručních pojezdů.",
    ),
    ("ID_MMM_RAPIDTRAVERSE", "Adds rapid traverse to manual motion.", "Přidá k ručnímu pohybu rychloposuv."),
    (
        "ID_MMM_MOVE{00-15}{|NEG}",
        "Moves NC axis {1} by hand in the {2:positive|negative} direction; RtmCommand is the better way.",
        "Ruční pohyb NC osy {1} v {2:kladném|záporném} směru; vhodnější je RtmCommand.",
    ),
    (
        "ID_MMM_MOVE{X|Y|Z}{|NEG}",
        "Moves geometric axis {1} by hand in the {2:positive|negative} direction; RtmCommand is the better way.",
        "Ruční pohyb geometrické osy {1} v {2:kladném|záporném} směru; vhodnější je RtmCommand.",
    ),
    (
        "ID_MMM_MOVEX{|NEG}Y{|NEG}",
        "Moves two geometric axes by hand, X in the {1:positive|negative} and Y in the {2:positive|negative} direction; RtmCommand is the better way.",
        "Ruční pohyb dvou geometrických os, X v {1:kladném|záporném} a Y v {2:kladném|záporném} směru; vhodnější je RtmCommand.",
    ),
    (
        "ID_MMM_MOVEZ{|NEG}X{|NEG}",
        "Moves two geometric axes by hand, Z in the {1:positive|negative} and X in the {2:positive|negative} direction; RtmCommand is the better way.",
        "Ruční pohyb dvou geometrických os, Z v {1:kladném|záporném} a X v {2:kladném|záporném} směru; vhodnější je RtmCommand.",
    ),
    (
        "ID_MMM_MOVEY{|NEG}Z{|NEG}",
        "Moves two geometric axes by hand, Y in the {1:positive|negative} and Z in the {2:positive|negative} direction; RtmCommand is the better way.",
        "Ruční pohyb dvou geometrických os, Y v {1:kladném|záporném} a Z v {2:kladném|záporném} směru; vhodnější je RtmCommand.",
    ),
    (
        "ID_MMM_BACK{0-9}",
        "Returns to the path by configuration {1}.",
        "Návrat na dráhu podle konfigurace {1}.",
    ),
    (
        "ID_OVERRIDE_{FEED|SPINDLESPEED}_{INC|DEC}",
        "{2:Raises|Lowers} the override of {1:feed|spindle speed} by one click.",
        "{2:Zvýší|Sníží} override {1:posuvu|otáček vřetena} o jedno cvaknutí.",
    ),
    (
        "ID_OVERRIDE_PLC{1-6}_{INC|DEC}",
        "{2:Raises|Lowers} override {1} of the PLC by one click.",
        "{2:Zvýší|Sníží} override PLC {1} o jedno cvaknutí.",
    ),
];
