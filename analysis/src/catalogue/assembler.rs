//! Chapter 3.1: 80386 instructions, which a program may mix with TECHNOL.
//!
//! CLI, STI, NOP and `MOV BX,CX` have a meaning here. The other integer instructions are known by name, so that
//! none is reported as unknown, and refused by `build`.

use super::entry::{Bilingual, Effect, Entry, OperandKind, OperandSpec};
use super::pattern::{INSTRUCTION, example, form, operand, text};

/// Manual chapter that allows them.
pub(super) const CHAPTER: &str = "3.1";

const ANY: &[OperandSpec] = &[operand(
    "operand",
    OperandKind::Any,
    "Register, address or number, as in the 80386 assembler",
    "Registr, adresa nebo číslo jako v asembleru 80386",
)
.or_nothing()
.repeated()];

const KNOWN_ONLY: Bilingual = text(
    "The editor knows this instruction, `build` refuses it (this implementation): write the same with \
     instructions of TECHNOL.",
    "Editor tuto instrukci zná, překlad ji odmítne (tato implementace): zapište totéž instrukcemi jazyka \
     TECHNOL.",
);

const CHECKED: Bilingual = text(
    "Its operands are checked: registers AL to DH, AX to DX, EAX to EDX and the index registers, cells and numbers, of \
     one width and at most one of them a cell; a shift count is a number or CL, a jump leads to a label of the same \
     section. `build` refuses it all the same (this implementation): write the same with instructions of TECHNOL. \
     Between instructions of TECHNOL RLO is bit 40h of AH and DR is ECX.",
    "Operandy se kontrolují: registry AL až DH, AX až DX, EAX až EDX a indexové, buňky a čísla, stejné šířky a \
     nejvýše jeden z nich buňka; počet posunů je číslo nebo CL, skok vede na návěští téže sekce. Překlad ji přesto \
     odmítne (tato implementace): zapište totéž instrukcemi jazyka TECHNOL. Mezi instrukcemi jazyka TECHNOL je RLO \
     bit 40h registru AH a DR je ECX.",
);

const fn checked(name: &'static str, summary: Bilingual) -> Entry {
    Entry { description: CHECKED, ..known(name, summary) }
}

const fn known(name: &'static str, summary: Bilingual) -> Entry {
    Entry {
        name,
        chapter: CHAPTER,
        operands: ANY,
        summary,
        description: KNOWN_ONLY,
        executable: false,
        ..INSTRUCTION
    }
}

const ARITHMETIC: Bilingual =
    text("80386 instruction: integer arithmetic.", "Instrukce 80386: celočíselná aritmetika.");
const LOGIC: Bilingual =
    text("80386 instruction: logic and shifts.", "Instrukce 80386: logické operace a posuvy.");
const MOVES: Bilingual =
    text("80386 instruction: moves or converts a value.", "Instrukce 80386: přesun nebo převod hodnoty.");
const STRINGS: Bilingual =
    text("80386 instruction: works on a string of cells.", "Instrukce 80386: práce s řetězcem buněk.");
const JUMPS: Bilingual =
    text("80386 instruction: jump, call or return.", "Instrukce 80386: skok, volání nebo návrat.");
const FLAGS: Bilingual =
    text("80386 instruction: sets or reads the flags.", "Instrukce 80386: nastavení nebo čtení příznaků.");
const BITS: Bilingual =
    text("80386 instruction: tests or finds a bit.", "Instrukce 80386: test nebo hledání bitu.");
const PORTS: Bilingual = text(
    "80386 instruction: reads or writes a processor port.",
    "Instrukce 80386: čtení nebo zápis portu procesoru.",
);

/// How the operands of an 80386 instruction are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AssemblerForm {
    /// MOV: the first operand is only written.
    Move,
    /// Two operands of one width: ADD, SUB, AND, OR, XOR, CMP.
    Two,
    /// One operand: INC, DEC.
    One,
    /// A value, and how far it is shifted: a number or CL.
    Shift,
    /// A conditional jump to a label.
    Jump,
}

/// Registers with their bytes.
const REGISTERS: &[(&[&str], u32)] = &[
    (&["AL", "AH", "BL", "BH", "CL", "CH", "DL", "DH"], 1),
    (&["AX", "BX", "CX", "DX", "SI", "DI", "BP", "SP", "ES", "SS", "FS", "GS"], 2),
    (&["EAX", "EBX", "ECX", "EDX", "ESI", "EDI", "EBP", "ESP"], 4),
];

/// The bytes of the register `name`, in any case; `None` when it is none. CS and DS have no place in a program.
#[must_use]
pub fn register(name: &str) -> Option<u32> {
    let holds = |names: &[&str]| names.iter().any(|register| register.eq_ignore_ascii_case(name));
    REGISTERS.iter().find(|(names, _)| holds(names)).map(|(_, bytes)| *bytes)
}

/// The form of an instruction with a defined meaning.
pub(super) fn form_of(name: &str) -> Option<AssemblerForm> {
    match name {
        "MOV" => Some(AssemblerForm::Move),
        "ADD" | "SUB" | "AND" | "OR" | "XOR" | "CMP" => Some(AssemblerForm::Two),
        "INC" | "DEC" => Some(AssemblerForm::One),
        "SHL" | "SHR" => Some(AssemblerForm::Shift),
        "JCXZ" | "JECXZ" | "JMP" => None,
        _ if name.starts_with('J') && name.len() <= 4 => Some(AssemblerForm::Jump),
        _ => None,
    }
}

/// The entries: first those with a meaning here, then the others by group.
pub(super) static ENTRIES: &[Entry] = &[
    Entry {
        name: "CLI",
        chapter: CHAPTER,
        forms: &[form("CLI")],
        summary: text(
            "Disables interrupts on the 80386; has no effect (this implementation).",
            "Na 80386 zakazuje přerušení; nemá žádný účinek (tato implementace).",
        ),
        description: text(
            "A pass of a module is not interrupted by another module of the same raster, so a group of \
             cells can be read consistently without it (this implementation). RLO and DR stay.",
            "Průchod modulem nepřeruší jiný modul téhož rastru, skupinu buněk lze proto přečíst \
             konzistentně i bez ní (tato implementace). RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!("        CLI\n", "        LOD  DWRD.B_POL\n", "        AD   DWRD.B_INK\n", "        STI"),
            "Reads a position from two buffers.",
            "Přečte polohu ze dvou bufferů.",
        )],
        related: &["STI"],
        ..INSTRUCTION
    },
    Entry {
        name: "STI",
        chapter: CHAPTER,
        forms: &[form("STI")],
        summary: text(
            "Enables interrupts on the 80386; has no effect (this implementation).",
            "Na 80386 povoluje přerušení; nemá žádný účinek (tato implementace).",
        ),
        description: text(
            "Stands behind what CLI began; both may stay in programs written for the original control \
             (this implementation). RLO and DR stay.",
            "Stojí za úsekem, který začala CLI; v programech psaných pro původní systém mohou obě zůstat \
             (tato implementace). RLO ani DR se nemění.",
        ),
        examples: &[example(
            concat!("        CLI\n", "        LOD  DWRD.B_POL\n", "        AD   DWRD.B_INK\n", "        STI"),
            "Reads a position from two buffers.",
            "Přečte polohu ze dvou bufferů.",
        )],
        related: &["CLI"],
        ..INSTRUCTION
    },
    Entry {
        name: "NOP",
        chapter: CHAPTER,
        forms: &[form("NOP")],
        summary: text("Does nothing.", "Neprovede nic."),
        description: text(
            "Takes one step of the program and changes nothing.",
            "Zabere jeden krok programu a nic nezmění.",
        ),
        examples: &[example("        NOP", "An empty step.", "Prázdný krok.")],
        related: &["EX"],
        ..INSTRUCTION
    },
    Entry {
        name: "MOV",
        chapter: CHAPTER,
        forms: &[form("MOV BX,CX")],
        operands: &[
            operand(
                "target",
                OperandKind::Any,
                "Register that receives the value",
                "Registr, který hodnotu dostane",
            ),
            operand(
                "source",
                OperandKind::Any,
                "Register the value comes from",
                "Registr, ze kterého se hodnota bere",
            ),
        ],
        reads: &[Effect::Dr],
        summary: text(
            "`MOV BX,CX` loads the index register BX with the lower 16 bits of DR.",
            "`MOV BX,CX` naplní indexový registr BX spodními 16 bity DR.",
        ),
        description: text(
            "CX is the lower half of DR, so this is the way an index computed in DR gets to BX. RLO and DR \
             stay. Other registers and operands are known, but `build` refuses them (this implementation).",
            "CX je spodní polovina DR, touto cestou se tedy index spočtený v DR dostane do BX. RLO ani DR se \
             nemění. Jiné registry a operandy editor zná, překlad je ale odmítne (tato implementace).",
        ),
        examples: &[example(
            concat!("        LOD  INDEX\n", "        MOV  BX,CX\n", "        LOD  BYTE.TABLE[BX]"),
            "Loads the byte of TABLE that INDEX selects.",
            "Načte slabiku tabulky TABLE, kterou vybírá INDEX.",
        )],
        related: &["BX", "LOD"],
        ..INSTRUCTION
    },
    checked("ADD", ARITHMETIC),
    known("ADC", ARITHMETIC),
    checked("SUB", ARITHMETIC),
    known("SBB", ARITHMETIC),
    checked("INC", ARITHMETIC),
    checked("DEC", ARITHMETIC),
    known("NEG", ARITHMETIC),
    checked("CMP", ARITHMETIC),
    known("MUL", ARITHMETIC),
    known("IMUL", ARITHMETIC),
    known("DIV", ARITHMETIC),
    known("IDIV", ARITHMETIC),
    known("AAA", ARITHMETIC),
    known("AAD", ARITHMETIC),
    known("AAM", ARITHMETIC),
    known("AAS", ARITHMETIC),
    known("DAA", ARITHMETIC),
    known("DAS", ARITHMETIC),
    checked("AND", LOGIC),
    checked("OR", LOGIC),
    checked("XOR", LOGIC),
    known("NOT", LOGIC),
    known("TEST", LOGIC),
    checked("SHL", LOGIC),
    known("SAL", LOGIC),
    checked("SHR", LOGIC),
    known("SAR", LOGIC),
    known("ROL", LOGIC),
    known("ROR", LOGIC),
    known("RCL", LOGIC),
    known("RCR", LOGIC),
    known("SHLD", LOGIC),
    known("SHRD", LOGIC),
    known("MOVSX", MOVES),
    known("MOVZX", MOVES),
    known("XCHG", MOVES),
    known("LEA", MOVES),
    known("LDS", MOVES),
    known("LES", MOVES),
    known("LFS", MOVES),
    known("LGS", MOVES),
    known("LSS", MOVES),
    known("PUSH", MOVES),
    known("POP", MOVES),
    known("PUSHA", MOVES),
    known("PUSHAD", MOVES),
    known("POPA", MOVES),
    known("POPAD", MOVES),
    known("XLAT", MOVES),
    known("XLATB", MOVES),
    known("CBW", MOVES),
    known("CWD", MOVES),
    known("CWDE", MOVES),
    known("CDQ", MOVES),
    known("LAHF", MOVES),
    known("SAHF", MOVES),
    known("BOUND", MOVES),
    known("MOVS", STRINGS),
    known("MOVSB", STRINGS),
    known("MOVSW", STRINGS),
    known("MOVSD", STRINGS),
    known("CMPS", STRINGS),
    known("CMPSB", STRINGS),
    known("CMPSW", STRINGS),
    known("CMPSD", STRINGS),
    known("SCAS", STRINGS),
    known("SCASB", STRINGS),
    known("SCASW", STRINGS),
    known("SCASD", STRINGS),
    known("LODS", STRINGS),
    known("LODSB", STRINGS),
    known("LODSW", STRINGS),
    known("LODSD", STRINGS),
    known("STOS", STRINGS),
    known("STOSB", STRINGS),
    known("STOSW", STRINGS),
    known("STOSD", STRINGS),
    known("REP", STRINGS),
    known("REPE", STRINGS),
    known("REPZ", STRINGS),
    known("REPNE", STRINGS),
    known("REPNZ", STRINGS),
    known("JMP", JUMPS),
    known("CALL", JUMPS),
    known("RET", JUMPS),
    known("RETN", JUMPS),
    known("RETF", JUMPS),
    known("INT", JUMPS),
    known("INTO", JUMPS),
    known("IRET", JUMPS),
    known("IRETD", JUMPS),
    known("LOOP", JUMPS),
    known("LOOPE", JUMPS),
    known("LOOPZ", JUMPS),
    known("LOOPNE", JUMPS),
    known("LOOPNZ", JUMPS),
    known("JCXZ", JUMPS),
    known("JECXZ", JUMPS),
    checked("JA", JUMPS),
    checked("JAE", JUMPS),
    checked("JB", JUMPS),
    checked("JBE", JUMPS),
    checked("JC", JUMPS),
    checked("JE", JUMPS),
    checked("JG", JUMPS),
    checked("JGE", JUMPS),
    checked("JL", JUMPS),
    checked("JLE", JUMPS),
    checked("JNA", JUMPS),
    checked("JNAE", JUMPS),
    checked("JNB", JUMPS),
    checked("JNBE", JUMPS),
    checked("JNC", JUMPS),
    checked("JNE", JUMPS),
    checked("JNG", JUMPS),
    checked("JNGE", JUMPS),
    checked("JNL", JUMPS),
    checked("JNLE", JUMPS),
    checked("JNO", JUMPS),
    checked("JNP", JUMPS),
    checked("JNS", JUMPS),
    checked("JNZ", JUMPS),
    checked("JO", JUMPS),
    checked("JP", JUMPS),
    checked("JPE", JUMPS),
    checked("JPO", JUMPS),
    checked("JS", JUMPS),
    checked("JZ", JUMPS),
    known("ENTER", JUMPS),
    known("LEAVE", JUMPS),
    known("CLC", FLAGS),
    known("STC", FLAGS),
    known("CMC", FLAGS),
    known("CLD", FLAGS),
    known("STD", FLAGS),
    known("PUSHF", FLAGS),
    known("PUSHFD", FLAGS),
    known("POPF", FLAGS),
    known("POPFD", FLAGS),
    known("SETA", FLAGS),
    known("SETAE", FLAGS),
    known("SETB", FLAGS),
    known("SETBE", FLAGS),
    known("SETC", FLAGS),
    known("SETE", FLAGS),
    known("SETG", FLAGS),
    known("SETGE", FLAGS),
    known("SETL", FLAGS),
    known("SETLE", FLAGS),
    known("SETNA", FLAGS),
    known("SETNAE", FLAGS),
    known("SETNB", FLAGS),
    known("SETNBE", FLAGS),
    known("SETNC", FLAGS),
    known("SETNE", FLAGS),
    known("SETNG", FLAGS),
    known("SETNGE", FLAGS),
    known("SETNL", FLAGS),
    known("SETNLE", FLAGS),
    known("SETNO", FLAGS),
    known("SETNP", FLAGS),
    known("SETNS", FLAGS),
    known("SETNZ", FLAGS),
    known("SETO", FLAGS),
    known("SETP", FLAGS),
    known("SETPE", FLAGS),
    known("SETPO", FLAGS),
    known("SETS", FLAGS),
    known("SETZ", FLAGS),
    known("BT", BITS),
    known("BTC", BITS),
    known("BTR", BITS),
    known("BTS", BITS),
    known("BSF", BITS),
    known("BSR", BITS),
    known("IN", PORTS),
    known("INS", PORTS),
    known("INSB", PORTS),
    known("INSW", PORTS),
    known("INSD", PORTS),
    known("OUT", PORTS),
    known("OUTS", PORTS),
    known("OUTSB", PORTS),
    known("OUTSW", PORTS),
    known("OUTSD", PORTS),
    known("HLT", PORTS),
    known("WAIT", PORTS),
    known("LOCK", PORTS),
];
