//! Values of `VirtualKey`: keys of a PC keyboard (manual 11.3.3).

use super::expand::Row;

/// In the order of the manual.
pub(super) const ROWS: &[Row] = &[
    (
        "VK_{L|R}BUTTON",
        "Key of a PC: {1:left|right} mouse button.",
        "Klávesa PC: {1:levé|pravé} tlačítko myši.",
    ),
    ("VK_CANCEL", "Key of a PC: Ctrl+Break.", "Klávesa PC: Ctrl+Break."),
    ("VK_MBUTTON", "Key of a PC: middle mouse button.", "Klávesa PC: prostřední tlačítko myši."),
    ("VK_XBUTTON{1-2}", "Key of a PC: side mouse button {1}.", "Klávesa PC: boční tlačítko myši {1}."),
    ("VK_BACK", "Key of a PC: Backspace.", "Klávesa PC: Backspace."),
    ("VK_TAB", "Key of a PC: Tab.", "Klávesa PC: tabulátor."),
    (
        "VK_CLEAR",
        "Key of a PC: Clear, the 5 of the numeric keypad without Num Lock.",
        "Klávesa PC: Clear, pětka numerické klávesnice bez Num Locku.",
    ),
    ("VK_RETURN", "Key of a PC: Enter.", "Klávesa PC: Enter."),
    (
        "VK_{SHIFT|CONTROL|MENU}",
        "Key of a PC: {1:Shift|Ctrl|Alt}, either one.",
        "Klávesa PC: {1:Shift|Ctrl|Alt}, kterýkoli.",
    ),
    ("VK_PAUSE", "Key of a PC: Pause.", "Klávesa PC: Pause."),
    ("VK_CAPITAL", "Key of a PC: Caps Lock.", "Klávesa PC: Caps Lock."),
    ("VK_KANA", "Key of a PC: Kana of the Japanese input.", "Klávesa PC: kana japonského vstupu."),
    (
        "VK_{HANGEUL|HANGUL}",
        "Key of a PC: Hangul of the Korean input.",
        "Klávesa PC: hangul korejského vstupu.",
    ),
    ("VK_JUNJA", "Key of a PC: Junja of the Korean input.", "Klávesa PC: junja korejského vstupu."),
    ("VK_FINAL", "Key of a PC: Final of the input method.", "Klávesa PC: Final vstupní metody."),
    ("VK_HANJA", "Key of a PC: Hanja of the Korean input.", "Klávesa PC: hanja korejského vstupu."),
    ("VK_KANJI", "Key of a PC: Kanji of the Japanese input.", "Klávesa PC: kandži japonského vstupu."),
    ("VK_ESCAPE", "Key of a PC: Esc.", "Klávesa PC: Esc."),
    (
        "VK_{CONVERT|NONCONVERT|ACCEPT|MODECHANGE}",
        "Key of a PC: {1:convert|do not convert|accept|change the mode} of the input method.",
        "Klávesa PC: {1:převést|nepřevádět|přijmout|změnit režim} vstupní metody.",
    ),
    ("VK_SPACE", "Key of a PC: space bar.", "Klávesa PC: mezerník."),
    (
        "VK_{PRIOR|NEXT|END|HOME}",
        "Key of a PC: {1:Page Up|Page Down|End|Home}.",
        "Klávesa PC: {1:Page Up|Page Down|End|Home}.",
    ),
    (
        "VK_{LEFT|UP|RIGHT|DOWN}",
        "Key of a PC: arrow {1:left|up|right|down}.",
        "Klávesa PC: šipka {1:vlevo|nahoru|vpravo|dolů}.",
    ),
    (
        "VK_{SELECT|PRINT|EXECUTE}",
        "Key of a PC: {1:Select|Print|Execute}.",
        "Klávesa PC: {1:Select|Print|Execute}.",
    ),
    ("VK_SNAPSHOT", "Key of a PC: Print Screen.", "Klávesa PC: Print Screen."),
    (
        "VK_{INSERT|DELETE|HELP}",
        "Key of a PC: {1:Insert|Delete|Help}.",
        "Klávesa PC: {1:Insert|Delete|Help}.",
    ),
    ("VK_{0-9}", "Key of a PC: digit {1}.", "Klávesa PC: číslice {1}."),
    (
        "VK_{A|B|C|D|E|F|G|H|I|J|K|L|M|N|O|P|Q|R|S|T|U|V|W|X|Y|Z}",
        "Key of a PC: letter {1}.",
        "Klávesa PC: písmeno {1}.",
    ),
    (
        "VK_{L|R}WIN",
        "Key of a PC: {1:left|right} Windows key.",
        "Klávesa PC: {1:levá|pravá} klávesa Windows.",
    ),
    ("VK_APPS", "Key of a PC: context menu.", "Klávesa PC: místní nabídka."),
    ("VK_SLEEP", "Key of a PC: sleep.", "Klávesa PC: režim spánku."),
    (
        "VK_NUMPAD{0-9}",
        "Key of a PC: digit {1} of the numeric keypad.",
        "Klávesa PC: číslice {1} numerické klávesnice.",
    ),
    (
        "VK_{MULTIPLY|ADD|SEPARATOR|SUBTRACT|DECIMAL|DIVIDE}",
        "Key of a PC: {1:multiply|add|separator|subtract|decimal point|divide} of the numeric keypad.",
        "Klávesa PC: {1:krát|plus|oddělovač|minus|desetinná tečka|děleno} numerické klávesnice.",
    ),
    ("VK_F{1-24}", "Key of a PC: F{1}.", "Klávesa PC: F{1}."),
    ("VK_NUMLOCK", "Key of a PC: Num Lock.", "Klávesa PC: Num Lock."),
    ("VK_SCROLL", "Key of a PC: Scroll Lock.", "Klávesa PC: Scroll Lock."),
    (
        "VK_OEM_NEC_EQUAL",
        "Key of a PC: equal sign of the numeric keypad of NEC keyboards.",
        "Klávesa PC: rovnítko numerické klávesnice u klávesnic NEC.",
    ),
    (
        "VK_OEM_FJ_{JISHO|MASSHOU|TOUROKU|LOYA|ROYA}",
        "Key of a PC: {1:dictionary|unregister a word|register a word|left Oyayubi|right Oyayubi} of Fujitsu keyboards.",
        "Klávesa PC: {1:slovník|zrušení slova|zápis slova|levé Oyayubi|pravé Oyayubi} u klávesnic Fujitsu.",
    ),
    (
        "VK_{L|R}{SHIFT|CONTROL|MENU}",
        "Key of a PC: {1:left|right} {2:Shift|Ctrl|Alt}.",
        "Klávesa PC: {1:levý|pravý} {2:Shift|Ctrl|Alt}.",
    ),
    (
        "VK_BROWSER_{BACK|FORWARD|REFRESH|STOP|SEARCH|FAVORITES|HOME}",
        "Key of a PC: {1:back|forward|refresh|stop|search|favourites|home} of the browser.",
        "Klávesa PC: {1:zpět|vpřed|obnovit|zastavit|hledat|oblíbené|domů} v prohlížeči.",
    ),
    (
        "VK_VOLUME_{MUTE|DOWN|UP}",
        "Key of a PC: {1:sound off|sound softer|sound louder}.",
        "Klávesa PC: {1:vypnutí zvuku|snížení hlasitosti|zvýšení hlasitosti}.",
    ),
    (
        "VK_MEDIA_{NEXT_TRACK|PREV_TRACK|STOP|PLAY_PAUSE}",
        "Key of a PC: {1:next track|previous track|stop|play or pause} of the player.",
        "Klávesa PC: {1:další skladba|předchozí skladba|stop|přehrát či pozastavit} v přehrávači.",
    ),
    (
        "VK_LAUNCH_{MAIL|MEDIA_SELECT}",
        "Key of a PC: {1:starts the mail program|chooses media}.",
        "Klávesa PC: {1:spuštění pošty|výběr médií}.",
    ),
    ("VK_LAUNCH_APP{1-2}", "Key of a PC: starts application {1}.", "Klávesa PC: spuštění aplikace {1}."),
    (
        "VK_OEM_{1-8}",
        "Key of a PC: key {1} that depends on the national layout.",
        "Klávesa PC: klávesa {1} závislá na národním rozložení.",
    ),
    (
        "VK_OEM_{PLUS|COMMA|MINUS|PERIOD}",
        "Key of a PC: {1:plus|comma|minus|full stop}.",
        "Klávesa PC: {1:plus|čárka|minus|tečka}.",
    ),
    ("VK_OEM_AX", "Key of a PC: AX of Japanese AX keyboards.", "Klávesa PC: AX u japonských klávesnic AX."),
    (
        "VK_OEM_102",
        "Key of a PC: key between left Shift and the letters.",
        "Klávesa PC: klávesa mezi levým Shiftem a písmeny.",
    ),
    (
        "VK_ICO_{HELP|00|CLEAR}",
        "Key of a PC: {1:Help|00|Clear} of ICO keyboards.",
        "Klávesa PC: {1:Help|00|Clear} u klávesnic ICO.",
    ),
    (
        "VK_PROCESSKEY",
        "Key of a PC: key that the input method processes.",
        "Klávesa PC: klávesa zpracovaná vstupní metodou.",
    ),
    ("VK_PACKET", "Key of a PC: character sent as if typed.", "Klávesa PC: znak zaslaný jako by byl napsán."),
    (
        "VK_OEM_{RESET|JUMP|PA1|PA2|PA3|WSCTRL|CUSEL|ATTN|FINISH|COPY|AUTO|ENLW|BACKTAB}",
        "Key of a PC: {1:Reset|Jump|PA1|PA2|PA3|WsCtrl|CuSel|Attn|Finish|Copy|Auto|Enlw|BackTab} of Nokia and Ericsson keyboards.",
        "Klávesa PC: {1:Reset|Jump|PA1|PA2|PA3|WsCtrl|CuSel|Attn|Finish|Copy|Auto|Enlw|BackTab} u klávesnic Nokia a Ericsson.",
    ),
    (
        "VK_{ATTN|CRSEL|EXSEL|EREOF|PLAY|ZOOM|PA1}",
        "Key of a PC: {1:Attn|CrSel|ExSel|Erase EOF|Play|Zoom|PA1} of terminals.",
        "Klávesa PC: {1:Attn|CrSel|ExSel|Erase EOF|Play|Zoom|PA1} u terminálů.",
    ),
    ("VK_NONAME", "Key of a PC: reserved code without a key.", "Klávesa PC: vyhrazený kód bez klávesy."),
    ("VK_OEM_CLEAR", "Key of a PC: Clear of some keyboards.", "Klávesa PC: Clear na některých klávesnicích."),
];
