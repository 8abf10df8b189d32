//! The help page of an entry or a predefined symbol: hover, `technol explain` and the book show this text.

use std::fmt::Write as _;

use super::Language;
use super::entry::{
    Access, Bilingual, ConfigElement, Effect, Entry, EntryKind, Equation, NewCell, OperandKind, OperandSpec,
    Place, Prefix, PrefixSet, TimeUnit,
};
use super::pattern::text;
use super::symbol::{Direction, SystemKind, SystemSymbol};

/// The page of an instruction or keyword, as Markdown.
#[must_use]
pub fn markdown(entry: &Entry, language: Language) -> String {
    let say = |en, cs| text(en, cs).in_language(language);
    let mut page = format!("### {}\n\n{}\n", entry.name, entry.summary.in_language(language));
    if !entry.forms.is_empty() {
        page.push_str("\n```technol\n");
        for form in entry.forms {
            page.push_str(form.syntax);
            page.push('\n');
        }
        page.push_str("```\n");
    }
    push_operands(&mut page, entry.operands, language);
    page.push('\n');
    for fact in facts(entry, language) {
        // Writing to a String never fails.
        let _ = writeln!(page, "- {fact}");
    }
    let description = entry.description.in_language(language);
    if !description.is_empty() {
        let _ = write!(page, "\n{description}\n");
    }
    let errors = entry.errors.in_language(language);
    if !errors.is_empty() {
        let _ = write!(page, "\n**{}** {errors}\n", say("Errors.", "Chyby."));
    }
    if !entry.examples.is_empty() {
        let title = if entry.examples.len() == 1 {
            say("Example", "Příklad")
        } else {
            say("Examples", "Příklady")
        };
        let _ = write!(page, "\n**{title}**\n");
        for example in entry.examples {
            let note = example.note.in_language(language);
            let _ = write!(page, "\n```technol\n{}\n```\n\n{note}\n", example.code);
        }
    }
    if !entry.related.is_empty() {
        let names: Vec<String> = entry.related.iter().map(|name| format!("`{name}`")).collect();
        let _ = write!(page, "\n{}: {}\n", say("See also", "Viz též"), names.join(", "));
    }
    page
}

/// The page of a predefined symbol, as Markdown.
#[must_use]
pub fn symbol_markdown(symbol: &SystemSymbol, language: Language) -> String {
    let say = |en, cs| text(en, cs).in_language(language);
    let kind = match symbol.kind {
        SystemKind::Bit { bit, .. } => format!("bit (d{bit})"),
        SystemKind::FormalBit { bit } => {
            format!("{} (d{bit}, `ADR.{}`)", say("position of a bit", "pozice bitu"), symbol.spelling)
        }
        SystemKind::Cell { prefix, .. } => type_name(prefix).to_owned(),
        SystemKind::Array { element, len, .. } => format!("{len} × {}", type_name(element)),
        SystemKind::Area { len, .. } => format!("{len} {}", say("bytes", "bajtů")),
        SystemKind::Member { offset, element, len } => {
            let kind = if len == 1 {
                type_name(element).to_owned()
            } else {
                format!("{len} × {}", type_name(element))
            };
            format!("{kind}, {} +{offset}", say("member of a structure at", "položka struktury na"))
        }
        SystemKind::Constant(value) => format!("{} {value}", say("constant", "konstanta")),
    };
    let direction = match (symbol.kind, symbol.direction) {
        (SystemKind::Constant(_) | SystemKind::Member { .. }, _) => "",
        (_, Direction::CncToPlc) => say("\n- From the control to the program", "\n- Ze systému do programu"),
        (_, Direction::PlcToCnc) => say("\n- From the program to the control", "\n- Z programu do systému"),
        (_, Direction::Both) => {
            say("\n- Written by the control and by the program", "\n- Zapisuje systém i program")
        }
    };
    let default = symbol
        .default
        .map(|value| format!("\n- {} {value}", say("At power-on", "Po zapnutí")))
        .unwrap_or_default();
    format!(
        "### {}\n\n{}\n\n- {kind}{direction}{default}\n- {} {}\n",
        symbol.spelling,
        symbol.summary.in_language(language),
        say("Manual chapter", "Kapitola příručky"),
        symbol.chapter
    )
}

fn push_operands(page: &mut String, operands: &[OperandSpec], language: Language) {
    if operands.is_empty() {
        return;
    }
    let header = text("| Operand | Kind | Meaning |", "| Operand | Druh | Význam |").in_language(language);
    let _ = write!(page, "\n{header}\n|---|---|---|\n");
    for operand in operands {
        let kind = operand_kind(operand, language);
        let help = operand.help.in_language(language);
        let _ = writeln!(page, "| `{}` | {} | {} |", operand.name, escape(&kind), escape(help));
    }
}

/// What an operand may be, and whether it may be left out, skipped or repeated: Markdown on one line.
#[must_use]
pub fn operand_kind(operand: &OperandSpec, language: Language) -> String {
    let mut kind = kind_of(operand.kind, language);
    for (applies, en, cs) in [
        (operand.optional, "may be left out", "lze vynechat"),
        (operand.skippable, "`-` when not given", "`-`, když se nezadává"),
        (operand.repeatable, "repeatable", "lze opakovat"),
    ] {
        if applies {
            kind.push_str("; ");
            kind.push_str(text(en, cs).in_language(language));
        }
    }
    kind
}

/// A `|` inside a cell of a table.
fn escape(cell: &str) -> String {
    cell.replace('|', "\\|")
}

fn kind_of(kind: OperandKind, language: Language) -> String {
    let say = |en, cs| text(en, cs).in_language(language);
    match kind {
        OperandKind::Bit { access, .. } => format!("bit, {}", access_name(access, language)),
        OperandKind::Data { access, prefixes, declared, .. } => {
            let mut kind = type_names(declared, language);
            if prefixes != PrefixSet::NONE {
                let dotted: Vec<String> =
                    members(prefixes).map(|prefix| format!("`{}.`", prefix.name())).collect();
                let _ = write!(kind, "; {}", dotted.join(" "));
            }
            let _ = write!(kind, "; {}", access_name(access, language));
            kind
        }
        OperandKind::Address(access) => {
            format!("{}, {}", say("address", "adresa"), access_name(access, language))
        }
        OperandKind::AutoCounter => say("BYTE or WORD cell", "buňka BYTE nebo WORD").to_owned(),
        OperandKind::Time => say("number, BYTE or WORD cell", "číslo, buňka BYTE nebo WORD").to_owned(),
        OperandKind::Label => say("label", "návěští").to_owned(),
        OperandKind::Mechanism { .. } => say("mechanism", "mechanismus").to_owned(),
        OperandKind::Procedure { .. } => say("procedure", "procedura").to_owned(),
        OperandKind::NewName | OperandKind::NewBit => say("new name", "nové jméno").to_owned(),
        OperandKind::Number { min, max } if min == max => format!("{} {min}", say("number", "číslo")),
        OperandKind::Number { min, max } => format!("{} {min} … {max}", say("number", "číslo")),
        OperandKind::NumberOf(numbers) => {
            let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
            format!("{} {}", say("number", "číslo"), numbers.join(", "))
        }
        OperandKind::RealConstant => {
            say("number with a decimal point", "číslo s desetinnou tečkou").to_owned()
        }
        OperandKind::BitPosition => say("position of a bit", "pozice bitu").to_owned(),
        OperandKind::Constant => say("constant", "konstanta").to_owned(),
        OperandKind::Keyword(words) => quoted(words),
        OperandKind::KeywordOrNumber(words, min, max) => {
            format!("{} {} {min} … {max}", quoted(words), say("or a number", "nebo číslo"))
        }
        OperandKind::Value(types) => type_names(types, language),
        OperandKind::Text(access) => format!("{}, {}", say("text", "text"), access_name(access, language)),
        OperandKind::TextOrLiteral => say("text or literal", "text nebo řetězec").to_owned(),
        OperandKind::LiteralOrAddress => say("literal or address", "řetězec nebo adresa").to_owned(),
        OperandKind::Identifier(element) => {
            format!(
                "{} {}",
                say("identifier of", "identifikátor:"),
                element_name(element).in_language(language)
            )
        }
        OperandKind::Declares(cell) => {
            let kind = match cell {
                NewCell::Bit => say("a new bit", "nový bit"),
                NewCell::Real => say("a new REAL cell", "nová buňka REAL"),
                NewCell::Typed => {
                    say("a new bit or cell, `name[n]` an array", "nový bit nebo buňka, `jméno[n]` pole")
                }
            };
            kind.to_owned()
        }
        OperandKind::DeclaredElement => {
            say("a cell of DEF_IN, `name[n]` one element", "buňka z DEF_IN, `jméno[n]` jeden prvek")
                .to_owned()
        }
        OperandKind::OneOf(kinds) => {
            let kinds: Vec<String> = kinds.iter().map(|kind| kind_of(*kind, language)).collect();
            kinds.join(say(" or ", " nebo "))
        }
        OperandKind::Any => say("any", "cokoli").to_owned(),
    }
}

fn element_name(element: ConfigElement) -> Bilingual {
    match element {
        ConfigElement::Input => text("an Input", "Input"),
        ConfigElement::Output => text("an Output", "Output"),
        ConfigElement::AnalogInput => text("an AnalogInput", "AnalogInput"),
        ConfigElement::AnalogOutput => text("an AnalogOutput", "AnalogOutput"),
        ConfigElement::LogicalInput => text("a logical input", "logický vstup"),
        ConfigElement::LogicalOutput => text("a logical output", "logický výstup"),
        ConfigElement::Parameter => text("a PlcParam", "PlcParam"),
        ConfigElement::Constant => text("a PLC constant", "PLC konstanta"),
        ConfigElement::Table => text("a PLC table", "PLC tabulka"),
        ConfigElement::Column => text("a column of a PLC table", "sloupec PLC tabulky"),
        ConfigElement::Shared => text("a shared value", "sdílená hodnota"),
    }
}

fn facts(entry: &Entry, language: Language) -> Vec<String> {
    let say = |en, cs| text(en, cs).in_language(language);
    let mut facts = Vec::new();
    for (title, effects) in [(say("Reads", "Čte"), entry.reads), (say("Writes", "Mění"), entry.writes)] {
        if !effects.is_empty() {
            let names: Vec<&str> = effects.iter().map(|&effect| effect_name(effect, language)).collect();
            facts.push(format!("{title}: {}", names.join(", ")));
        }
    }
    match entry.equation {
        Equation::Terminal => facts.push(say("Terminal instruction", "Koncová instrukce").to_owned()),
        Equation::Open => facts.push(say("Opens an equation", "Otevírá rovnici").to_owned()),
        Equation::Overwrite => {
            facts.push(
                say("Overwrites RLO without a push", "Přepisuje RLO bez uložení na zásobník").to_owned(),
            );
        }
        Equation::None | Equation::Combine | Equation::Modify => {}
    }
    if entry.ex_type {
        facts.push(say("EX-type: may hold the sequence", "Typ EX: může držet sekvenci").to_owned());
    }
    if has_place(entry.kind) {
        facts.push(place_name(entry.place, language).to_owned());
    }
    match entry.time_unit {
        Some(TimeUnit::Cycle) => facts.push(
            say("Time in cycles of 20 ms, in MODULE_FAST of 1 ms", "Čas v cyklech 20 ms, v MODULE_FAST 1 ms")
                .to_owned(),
        ),
        Some(TimeUnit::Raster) => facts.push(
            say("Time in passes of the DFTM block around it", "Čas v průchodech okolním blokem DFTM")
                .to_owned(),
        ),
        None => {}
    }
    if !entry.executable && !entry.is_known_only() {
        facts.push(
            say(
                "Known to the editor; `build` does not take it yet",
                "Editor ji zná; překlad ji zatím nepřijímá",
            )
            .to_owned(),
        );
    }
    facts.push(format!("{} {}", say("Manual chapter", "Kapitola příručky"), entry.chapter));
    facts
}

/// Prefixes and keywords stand inside operands: a place of their own says nothing.
const fn has_place(kind: EntryKind) -> bool {
    !matches!(kind, EntryKind::TypePrefix | EntryKind::Keyword)
}

const fn place_name(place: Place, language: Language) -> &'static str {
    match place {
        Place::Code => {
            text("In any module, mechanism or procedure", "V každém modulu, mechanismu i proceduře")
        }
        Place::Anywhere => text("Anywhere in a file", "Kdekoli v souboru"),
        Place::Data => text("In DATA and DATA_LOCAL", "V DATA a DATA_LOCAL"),
        Place::DataOrFileLevel => {
            text("In DATA, in DATA_LOCAL or between modules", "V DATA, v DATA_LOCAL nebo mezi moduly")
        }
        Place::FileLevel => text("Between modules", "Mezi moduly"),
        Place::FileLevelOrModule => text("Between modules or inside one", "Mezi moduly nebo uvnitř modulu"),
        Place::Sequence => text(
            "In a mechanism, MODULE_BLOCK_INIT or MODULE_BLOCK_DONE",
            "V mechanismu, v MODULE_BLOCK_INIT nebo MODULE_BLOCK_DONE",
        ),
        Place::Main => text("In MODULE_MAIN", "V MODULE_MAIN"),
        Place::MechanismHost => text(
            "In MODULE_MAIN or MODULE_FAST, with a warning in MODULE_CONT",
            "V MODULE_MAIN nebo MODULE_FAST, s varováním v MODULE_CONT",
        ),
        Place::Init => text("In MODULE_INIT", "V MODULE_INIT"),
        Place::InitOrProcedure => text(
            "In MODULE_INIT or a procedure called from it",
            "V MODULE_INIT nebo v proceduře, kterou volá",
        ),
        Place::AnyModule => text("In any module", "V každém modulu"),
    }
    .in_language(language)
}

const fn effect_name(effect: Effect, language: Language) -> &'static str {
    match effect {
        Effect::Rlo => text("RLO", "RLO"),
        Effect::Dr => text("DR", "DR"),
        Effect::Dr64 => text("DR (64 bits)", "DR (64 bitů)"),
        Effect::DrReal => text("DR_REAL", "DR_REAL"),
        Effect::Stack => text("equation stack", "zásobník"),
        Effect::Memory => text("memory", "paměť"),
    }
    .in_language(language)
}

const fn access_name(access: Access, language: Language) -> &'static str {
    match access {
        Access::Read => text("read", "čte se"),
        Access::Write => text("written", "zapisuje se"),
        Access::ReadWrite => text("read and written", "čte se i zapisuje"),
    }
    .in_language(language)
}

/// A type as declared: DWRD is DWORD, QWRD is QWORD.
const fn type_name(prefix: Prefix) -> &'static str {
    match prefix {
        Prefix::Dwrd => "DWORD",
        Prefix::Qwrd => "QWORD",
        other => other.name(),
    }
}

fn type_names(set: PrefixSet, language: Language) -> String {
    let cells = members(set).filter(|&prefix| prefix != Prefix::Cnst).map(type_name);
    let constant = set.contains(Prefix::Cnst).then(|| text("constant", "konstanta").in_language(language));
    cells.chain(constant).collect::<Vec<_>>().join(", ")
}

fn members(set: PrefixSet) -> impl Iterator<Item = Prefix> {
    Prefix::ALL.into_iter().filter(move |&prefix| set.contains(prefix))
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{entry, symbol};

    fn page(name: &str, language: Language) -> String {
        markdown(entry(name).expect("an entry"), language)
    }

    fn symbol_page(name: &str, language: Language) -> String {
        symbol_markdown(symbol(name).expect("a symbol"), language)
    }

    #[test]
    fn an_english_page_shows_syntax_operands_effects_and_examples() {
        insta::assert_snapshot!(page("LA", Language::En), @r#"
        ### LA

        ANDs RLO with a bit, or with the last value on the stack.

        ```technol
        LA
        LA [-]bit
        LA [-][ADR.]bit
        LA [-]$+n.bit
        ```

        | Operand | Kind | Meaning |
        |---|---|---|
        | `bit` | bit, read; may be left out | Bit to read: a name, `ADR.bit` or `$+n.bit`; a leading `-` reads its negation; without it the stack is used |

        - Reads: RLO, equation stack, memory
        - Writes: RLO, equation stack
        - In any module, mechanism or procedure
        - Manual chapter 3.6

        With an operand: RLO becomes RLO AND bit. A leading `-` takes the negation of the bit, `ADR.bit` and `$+n.bit` work as in LDR.

        Without an operand the other input is the value last pushed on the stack, which is removed. That closes a bracket opened by an inner LDR. With nothing on the stack it is an error. DR is not changed.

        **Example**

        ```technol
                LDR  PUMP
                LO   MANUAL
                LDR  LEVEL_OK
                LO   BYPASS
                LA
                WR   COOLANT
        ```

        (PUMP or MANUAL) and (LEVEL_OK or BYPASS): the second LDR pushes, LA pops.

        See also: `LDR`, `LO`, `LX`, `CA`
        "#);
    }

    #[test]
    fn a_czech_page_says_what_ex_type_and_the_unit_of_time_are() {
        insta::assert_snapshot!(page("TEX0", Language::Cs), @r#"
        ### TEX0

        Drží sekvenci, dokud je RLO 0, nejvýše však zadanou dobu.

        ```technol
        TEX0 count, time, error [,code]
        TEX0 [TYPE.]count, time, error [,code]
        TEX0 TYPE.(count+n), (time+m), error [,code]
        TEX0 -, time, error [,code]
        TEX0 NIL, time, error [,code]
        ```

        | Operand | Druh | Význam |
        |---|---|---|
        | `count` | buňka BYTE nebo WORD; `-`, když se nezadává | Čítač typu BYTE nebo WORD; `-` nebo NIL vytvoří automatický |
        | `time` | číslo, buňka BYTE nebo WORD | Nejdelší čekání v cyklech: číslo, konstanta EQUI nebo buňka BYTE či WORD |
        | `error` | návěští | Návěští, na kterém se pokračuje po vypršení času |
        | `code` | BYTE, WORD, DWORD, konstanta; `BYTE.` `WORD.` `CNST.` `DWRD.`; čte se; lze vynechat | Hodnota, která při tomto skoku zůstane v DR, obvykle číslo hlášení |

        - Čte: RLO, paměť
        - Mění: paměť, DR (64 bitů)
        - Koncová instrukce
        - Typ EX: může držet sekvenci
        - V mechanismu, v MODULE_BLOCK_INIT nebo MODULE_BLOCK_DONE
        - Čas v cyklech 20 ms, v MODULE_FAST 1 ms
        - Kapitola příručky 4.2

        Totéž co EX0, čítá ale cykly čekání; po `time` cyklech skočí na `error`. Cyklus trvá 20 ms, i v blokových modulech, takže 50 je jedna sekunda; v MODULE_FAST trvá 1 ms. Při skoku obsahuje DR hodnotu `code` tak, jak by ji načetlo LOD, takže několik čekání může mít společné ošetření zakončené ESET.

        Čítač je buňka BYTE nebo WORD, `-` nebo NIL vytvoří automatický; začíná znovu při vstupu do stavu, jeho opuštění, vypršení času a při MECH_INIT (tato implementace). Prefix typu se vztahuje na čítač i čas; čas pak nesmí být konstanta.

        **Příklad**

        ```technol
                FL   1,TURRET_UP
                BEX
                LDR  TURRET_IS_UP
                TEX0 -,100,FAULT,ERR_TURRET
        ```

        Čeká nejvýše 2 s; pak se na FAULT předá číslo hlášení v DR.

        Viz též: `TEX1`, `EX0`, `TIM`, `ESET`, `BEX`
        "#);
    }

    #[test]
    fn a_prefix_has_no_place_of_its_own() {
        insta::assert_snapshot!(page("BYTE", Language::En), @r#"
        ### BYTE

        Accesses the operand as 8 bits.

        ```technol
        BYTE.name
        BYTE.(name+n)
        BYTE.number
        ```

        - Manual chapter 3.9

        Joined to the operand by a dot it sets the width of the access for this one instruction: 8 bits, DR8. The prefix wins over the declared type. An access that runs past its cell is a warning, one that leaves the data area an error (this implementation).

        LOD sign-extends the byte, so 0FFh loads as -1. Before a number (`BYTE.12`) it makes an 8-bit constant.

        **Example**

        ```technol
                LOD  BYTE.(TABLE+3)
                STO  LEVEL
        ```

        Loads one byte of an area without a type.

        See also: `WORD`, `HIGH`, `DWRD`, `LOD`
        "#);
    }

    #[test]
    fn a_symbol_of_the_control_is_spelled_as_in_the_manual() {
        insta::assert_snapshot!(symbol_page("dwAxNcFeed", Language::En), @r#"
        ### dwAxNcFeed

        Feed of the NC axes, from the configuration.

        - 16 × DWORD
        - From the control to the program
        - Manual chapter 8.4.6
        "#);
    }

    #[test]
    fn a_formal_bit_shows_how_it_is_addressed() {
        insta::assert_snapshot!(symbol_page("err_io8_comm", Language::Cs), @r#"
        ### ERR_IO8_COMM

        Pozice v chybovém registru jednotky: chyba komunikace.

        - pozice bitu (d4, `ADR.ERR_IO8_COMM`)
        - Ze systému do programu
        - Kapitola příručky 9.3
        "#);
    }
}
