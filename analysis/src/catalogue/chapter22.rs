//! Chapter 22: included files and user macros.

use super::entry::{Entry, OperandKind, OperandSpec};
use super::pattern::{DIRECTIVE, KEYWORD, example, form, operand, text};

const STACK: OperandSpec = operand(
    "stackflag",
    OperandKind::Keyword(&["T_NORMAL", "T_BEGIN", "T_END", "T_PUSH", "T_POP"]),
    "What a call is to the stack of logic instructions: T_NORMAL nothing, T_BEGIN empties it, T_END ends the equation, \
     T_PUSH begins one, T_POP takes a value back; T_NORMAL when left out",
    "Vztah volání k zásobníku logických instrukcí: T_NORMAL žádný, T_BEGIN ho vyprázdní, T_END ukončí rovnici, T_PUSH ji \
     začne, T_POP vybere hodnotu; bez uvedení T_NORMAL",
)
.or_nothing();
const CONVERSION: OperandSpec = operand(
    "convflag",
    OperandKind::Keyword(&["C_0", "C_1"]),
    "Conversion of the operands: C_1 allows brackets in them; C_0 when left out",
    "Konverze operandů: C_1 v nich dovolí závorky; bez uvedení C_0",
)
.or_nothing();
const DEBUGGING: OperandSpec = operand(
    "debugflag",
    OperandKind::Keyword(&["D_OFF", "D_ON"]),
    "D_ON lets a call take a break-point; D_OFF when left out",
    "D_ON dovolí na volání breakpoint; bez uvedení D_OFF",
)
.or_nothing();

/// The entries, in manual order.
pub(super) static ENTRIES: &[Entry] = &[INCLUDE, DEFINITION, END, LOCAL, PREFIX, APPEND, CONTROL];

const INCLUDE: Entry = Entry {
    name: "T_INCLUDE",
    chapter: "22.1",
    forms: &[form("T_INCLUDE file"), form("T_INCLUDE 'file'")],
    operands: &[operand(
        "file",
        OperandKind::LiteralOrAddress,
        "File name, with or without apostrophes",
        "Jméno souboru, v apostrofech i bez nich",
    )],
    summary: text(
        "Joins a file of definitions to the source text.",
        "Připojí ke zdrojovému textu soubor s definicemi.",
    ),
    description: text(
        "The file is read as if its lines stood here. A name without apostrophes is looked for from the folder of the \
         PLC source, also in a sub-folder given with `\\`, then in the folders of `include-dirs` in technol.toml; a \
         name in apostrophes in the system folder, `system-dir` in technol.toml; an absolute path is taken as it is. \
         From within an included file the same folders count (this implementation). A definition file holds \
         constants, macros and, when DATA includes it, data; code belongs there only inside of macros. By custom the \
         line stands before DATA and the file ends in `.INC`.",
        "Soubor se čte, jako by jeho řádky stály na tomto místě. Jméno bez apostrofů se hledá od složky se zdrojovým \
         textem PLC, i v podsložce zadané pomocí `\\`, potom ve složkách `include-dirs` v technol.toml; jméno \
         v apostrofech v systémové složce, `system-dir` v technol.toml; absolutní cesta platí tak, jak je. Uvnitř \
         připojeného souboru platí stejné složky (tato implementace). Definiční soubor obsahuje konstanty, makra, \
         a pokud ho připojuje DATA, i data; kód do něj patří jen uvnitř maker. Podle zvyku řádek stojí před DATA \
         a soubor má příponu `.INC`.",
    ),
    errors: text(
        "A file that is not found, that includes itself, or that holds code outside of macros.",
        "Soubor, který se nenajde, který připojuje sám sebe, nebo který má kód mimo makra.",
    ),
    examples: &[example(
        "        T_INCLUDE ERRORS.INC\n        T_INCLUDE LATHE\\SPINDLE.INC\n        T_INCLUDE 'AXES.INC'",
        "From the folder of the source, from its sub-folder LATHE, and from the system folder.",
        "Ze složky zdrojového textu, z její podsložky LATHE a ze systémové složky.",
    )],
    related: &["DEF_T_MACRO", "EQUI"],
    ..DIRECTIVE
};

const DEFINITION: Entry = Entry {
    name: "DEF_T_MACRO",
    chapter: "22.2",
    forms: &[form("DEF_T_MACRO name"), form("DEF_T_MACRO name par1 [,par2 …]")],
    operands: &[
        operand(
            "name",
            OperandKind::NewName,
            "Word by which the macro is called",
            "Slovo, kterým se makro volá",
        ),
        operand(
            "par",
            OperandKind::NewName,
            "Formal parameters, separated by commas",
            "Formální parametry oddělené čárkami",
        )
        .or_nothing()
        .repeated(),
    ],
    summary: text(
        "Begins the definition of a macro, which is then used like an instruction.",
        "Začátek definice makra; to se pak používá jako instrukce.",
    ),
    description: text(
        "The lines up to END_T_MACRO are the body: TECHNOL and 80386 instructions, DATA_LOCAL, EQUI, calls of other \
         macros. A call is the name with one operand for each parameter; it is replaced by the body, in which the \
         operands stand for the parameters with their name and type. Instructions take a parameter behind TMAC., \
         80386 instructions and calls of macros without it. All names that are visible at the call can be used.\n\n\
         A definition counts from its place on, in the order of the text with included files joined, through all \
         program files (this implementation); it cannot stand inside another one, and macros that call each other \
         in a circle are an error. Macros may be nested 16 deep, and the calls of a section may have 10,000 lines \
         (this implementation). For the debugger a call is one line: one step, with all its instructions. In 80386 \
         instructions RLO is bit 40h of AH and DR is ECX.",
        "Řádky po END_T_MACRO jsou tělo: instrukce TECHNOLu i 80386, DATA_LOCAL, EQUI, volání jiných maker. Volání je \
         jméno s jedním operandem pro každý parametr; nahradí se tělem, ve kterém operandy zastupují parametry svým \
         jménem i typem. Instrukce berou parametr za TMAC., instrukce 80386 a volání maker bez něj. Použít lze \
         všechna jména, která jsou vidět v místě volání.\n\n\
         Definice platí od svého místa dál, v pořadí textu s připojenými soubory, ve všech souborech programu (tato \
         implementace); nesmí stát uvnitř jiné a makra, která se volají v kruhu, jsou chyba. Makra mohou být \
         vnořena nejvýše 16krát a volání v jedné sekci mohou mít 10 000 řádků (tato implementace). Pro ladění je \
         volání jedním řádkem: jeden krok se všemi svými instrukcemi. V instrukcích 80386 je RLO bit 40h v AH \
         a DR je ECX.",
    ),
    errors: text(
        "A call with another number of operands, before the definition, or in a circle; a name defined twice.",
        "Volání s jiným počtem operandů, před definicí nebo v kruhu; jméno definované dvakrát.",
    ),
    examples: &[
        example(
            concat!(
                "DEF_T_MACRO FOLLOW KEY, LIGHT\n",
                "        LDR     TMAC.KEY\n",
                "        WR      TMAC.LIGHT\n",
                "END_T_MACRO T_END"
            ),
            "`FOLLOW START,LAMP` becomes `LDR START` and `WR LAMP`.",
            "Z `FOLLOW START,LAMP` se stane `LDR START` a `WR LAMP`.",
        ),
        example(
            concat!(
                "DEF_T_MACRO ERRORS\n",
                "        EQUI    ERR_DOOR,4512h\n",
                "        EQUI    ERR_OIL,4612h\n",
                "END_T_MACRO"
            ),
            "A macro without parameters that declares constants; it is called once.",
            "Makro bez parametrů, které deklaruje konstanty; volá se jednou.",
        ),
    ],
    related: &["END_T_MACRO", "T_LOCAL", "TMAC", "APPEND_T_MACRO", "CONTROL_T_MACRO", "PROC_BEGIN"],
    ..DIRECTIVE
};

const END: Entry = Entry {
    name: "END_T_MACRO",
    chapter: "22.2",
    forms: &[form("END_T_MACRO"), form("END_T_MACRO stackflag [,convflag [,debugflag]]")],
    operands: &[STACK, CONVERSION, DEBUGGING],
    summary: text("Ends the definition of a macro.", "Konec definice makra."),
    description: text(
        "The flags say what a call is to the lines around it. T_NORMAL: nothing to the stack of logic instructions. \
         T_BEGIN: it empties the stack. T_END: it ends the equation, as WR does. T_PUSH: it begins an equation or \
         saves RLO, as LDR does. T_POP: it takes a value back, as LO without operand does. C_1 allows brackets in \
         the operands; they are handed on with C_0 too, with a warning (this implementation). D_ON allows \
         break-points on the call within DEBUG regions; `debug.everywhere = true` lifts D_OFF as it lifts the \
         regions (this implementation). Without flags T_NORMAL, C_0, D_OFF hold.",
        "Příznaky říkají, čím je volání pro řádky kolem. T_NORMAL: k zásobníku logických instrukcí nemá vztah. \
         T_BEGIN: zásobník vyprázdní. T_END: ukončí rovnici jako WR. T_PUSH: začne rovnici nebo uloží RLO jako LDR. \
         T_POP: vybere hodnotu jako LO bez operandu. C_1 dovolí v operandech závorky; předávají se i s C_0, \
         s varováním (tato implementace). D_ON dovolí na volání breakpoint v úsecích DEBUG; \
         `debug.everywhere = true` ruší D_OFF stejně jako úseky (tato implementace). Bez příznaků platí T_NORMAL, \
         C_0, D_OFF.",
    ),
    examples: &[example(
        concat!(
            "DEF_T_MACRO BOTH ONE, TWO\n",
            "        LDR     TMAC.ONE\n",
            "        LA      TMAC.TWO\n",
            "END_T_MACRO T_PUSH, C_0, D_ON"
        ),
        "A call begins an equation like LDR and takes break-points.",
        "Volání začíná rovnici jako LDR a lze na ně dát breakpoint.",
    )],
    related: &["DEF_T_MACRO", "APPEND_T_MACRO", "LDR", "DEBUG"],
    ..DIRECTIVE
};

const LOCAL: Entry = Entry {
    name: "T_LOCAL",
    chapter: "22.3",
    forms: &[form("T_LOCAL symbol1 [,symbol2 …]")],
    operands: &[operand(
        "symbol",
        OperandKind::NewName,
        "Label, cell or bit that the body defines",
        "Návěští, buňka nebo bit, které tělo definuje",
    )
    .repeated()],
    summary: text(
        "Makes symbols of a macro local to each use.",
        "Učiní symboly makra lokálními pro každé jeho použití.",
    ),
    description: text(
        "It stands directly behind DEF_T_MACRO, on as many lines as needed. Each call then gets labels, cells and \
         bits of its own; without T_LOCAL the second call would define the same names again. Data and bits are \
         declared in DATA_LOCAL … DATA_LOCAL_END in the body with DS and DFM; DFM must name all eight bits.",
        "Stojí hned za DEF_T_MACRO, na tolika řádcích, kolik je třeba. Každé volání pak dostane vlastní návěští, \
         buňky a bity; bez T_LOCAL by druhé volání definovalo stejná jména znovu. Data a bity se deklarují \
         v DATA_LOCAL … DATA_LOCAL_END v těle pomocí DS a DFM; DFM musí pojmenovat všech osm bitů.",
    ),
    examples: &[example(
        concat!(
            "DEF_T_MACRO LIMITED CELL\n",
            "        T_LOCAL SMALLER\n",
            "        LOD     TMAC.CELL\n",
            "        LT      CNST.100\n",
            "        JL1     SMALLER\n",
            "        LOD     CNST.100\n",
            "        STO     TMAC.CELL\n",
            "SMALLER:\n",
            "END_T_MACRO T_END"
        ),
        "The label is another one in each call.",
        "Návěští je v každém volání jiné.",
    )],
    related: &["DEF_T_MACRO", "DATA_LOCAL", "DFM", "DS"],
    ..DIRECTIVE
};

const PREFIX: Entry = Entry {
    name: "TMAC",
    chapter: "22.3",
    forms: &[form("TMAC.parameter"), form("-TMAC.parameter"), form("TMAC.prefix.parameter")],
    summary: text("Announces a parameter of the macro in an operand.", "Uvádí v operandu parametr makra."),
    description: text(
        "Instructions in the body of a macro take parameters behind TMAC. It covers the whole operand: in \
         `TMAC.CELL.BIT` both names may be parameters. It stands before other prefixes and behind a minus sign. \
         80386 instructions and calls of other macros take parameters without it.",
        "Instrukce v těle makra berou parametry za TMAC. Platí pro celý operand: v `TMAC.BUNKA.BIT` mohou být \
         parametry obě jména. Stojí před dalšími prefixy a za znaménkem mínus. Instrukce 80386 a volání jiných maker \
         berou parametry bez něj.",
    ),
    examples: &[example(
        concat!(
            "DEF_T_MACRO COPY_BIT KEY, CELL, BIT\n",
            "        LDR     -TMAC.KEY\n",
            "        WR      TMAC.CELL.BIT\n",
            "        STO1    TMAC.BYTE.CELL\n",
            "END_T_MACRO T_END"
        ),
        "A negated parameter, an address with its bit, and a type prefix.",
        "Negovaný parametr, adresa s bitem a typový prefix.",
    )],
    related: &["DEF_T_MACRO", "T_LOCAL"],
    ..KEYWORD
};

const APPEND: Entry = Entry {
    name: "APPEND_T_MACRO",
    chapter: "22.4",
    forms: &[form("APPEND_T_MACRO name, alias [,stackflag [,convflag [,debugflag]]]")],
    operands: &[
        operand(
            "name",
            OperandKind::NewName,
            "Word written in the program, also that of an instruction",
            "Slovo psané v programu, i jméno instrukce",
        ),
        operand("alias", OperandKind::NewName, "Macro that it calls", "Makro, které volá"),
        STACK,
        CONVERSION,
        DEBUGGING,
    ],
    summary: text("Adds a word that expands to a macro.", "Přidá slovo, které se rozvine v makro."),
    description: text(
        "From this line on the first name calls the macro of the second name (this implementation's reading), with \
         the flags given here; without flags T_NORMAL, C_0, D_OFF hold, whatever the END_T_MACRO of the macro says. \
         Both names may be the same: then the line only sets flags. A name of an instruction is taken only where \
         CONTROL_T_MACRO PRE holds.",
        "Od tohoto řádku volá první jméno makro druhého jména (tato implementace), s příznaky uvedenými zde; bez \
         příznaků platí T_NORMAL, C_0, D_OFF, ať END_T_MACRO makra říká cokoli. Obě jména mohou být stejná: pak \
         řádek jen nastaví příznaky. Jméno instrukce se použije jen tam, kde platí CONTROL_T_MACRO PRE.",
    ),
    errors: text("No macro of the second name.", "Makro druhého jména neexistuje."),
    examples: &[example(
        concat!(
            "DEF_T_MACRO FOLLOW KEY, LIGHT\n",
            "        LDR     TMAC.KEY\n",
            "        WR      TMAC.LIGHT\n",
            "END_T_MACRO T_END\n",
            "        APPEND_T_MACRO SHOW, FOLLOW, T_END, C_0, D_ON"
        ),
        "`SHOW START,LAMP` does what `FOLLOW START,LAMP` does, and takes break-points.",
        "`SHOW START,LAMP` dělá totéž co `FOLLOW START,LAMP` a lze na ně dát breakpoint.",
    )],
    related: &["DEF_T_MACRO", "END_T_MACRO", "CONTROL_T_MACRO"],
    ..DIRECTIVE
};

const CONTROL: Entry = Entry {
    name: "CONTROL_T_MACRO",
    chapter: "22.4",
    forms: &[form("CONTROL_T_MACRO POS"), form("CONTROL_T_MACRO PRE")],
    operands: &[operand(
        "mode",
        OperandKind::Keyword(&["POS", "PRE"]),
        "POS: instructions first; PRE: macros first",
        "POS: nejdřív instrukce; PRE: nejdřív makra",
    )],
    summary: text(
        "Chooses whether macros are expanded after or before the instructions are decoded.",
        "Zvolí, zda se makra rozvíjejí po rozpoznání instrukcí, nebo před ním.",
    ),
    description: text(
        "POS holds from the start: a word that is an instruction means the instruction. Behind PRE a macro of that \
         name replaces it. The line acts on the calls behind it, in the order of the text and through all program \
         files, until the next one (this implementation). In the body of such a macro the word means the instruction \
         (this implementation), so a macro may add something to it.",
        "Od začátku platí POS: slovo, které je instrukcí, znamená instrukci. Za PRE ji nahradí makro stejného jména. \
         Řádek působí na volání za ním, v pořadí textu a ve všech souborech programu, až do dalšího (tato \
         implementace). V těle takového makra znamená slovo instrukci (tato implementace), makro k ní tedy může \
         něco přidat.",
    ),
    examples: &[example(
        concat!(
            "DEF_T_MACRO INR\n",
            "        INR\n",
            "        STO     BYTE.PASSES\n",
            "END_T_MACRO\n",
            "        CONTROL_T_MACRO PRE"
        ),
        "From here on INR also stores what it counted.",
        "Odtud INR také uloží, co napočítala.",
    )],
    related: &["DEF_T_MACRO", "APPEND_T_MACRO"],
    ..DIRECTIVE
};
