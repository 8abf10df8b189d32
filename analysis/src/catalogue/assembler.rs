//! Chapter 3.1: 80386 instructions, which a program may mix with TECHNOL.
//!
//! CLI, STI, NOP, moves, sums, logic, shifts, comparisons and jumps have a meaning here. The other integer instructions
//! are known by name, so that none is reported as unknown, and refused by `build`.

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

/// Two operands of one width.
const TWO: &[OperandSpec] = &[
    operand(
        "target",
        OperandKind::Any,
        "Register or cell, which takes the result",
        "Registr nebo buňka, kam přijde výsledek",
    ),
    operand("source", OperandKind::Any, "Register, cell or number", "Registr, buňka nebo číslo"),
];
const ONE: &[OperandSpec] = &[operand("target", OperandKind::Any, "Register or cell", "Registr nebo buňka")];
const SHIFTED: &[OperandSpec] = &[
    operand("target", OperandKind::Any, "Register or cell that is shifted", "Posouvaný registr nebo buňka"),
    operand("count", OperandKind::Number { min: 0, max: 31 }, "Number of bits, or CL", "Počet bitů, nebo CL"),
];
const CALCULATED: Bilingual = text(
    "Operands are AL to DH, AX to DX and EAX to EDX, cells and numbers, of one width (8, 16 or 32 bits) and at most one \
     of them a cell; a prefix gives a cell another width. Between instructions of TECHNOL RLO is bit 40h of AH, DR is \
     ECX with EDX above it, and BX is the index; an instruction that writes BX clears the upper half of EBX (this \
     implementation). The flags are those of the 80386 and stay until the next 80386 instruction that sets them (this \
     implementation). `build` refuses SI, DI, BP, SP and the segment registers (this implementation). A cell `[BX]` \
     outside memory is a run-time fault (this implementation).",
    "Operandy jsou AL až DH, AX až DX a EAX až EDX, buňky a čísla, stejné šířky (8, 16 nebo 32 bitů) a nejvýše jeden z \
     nich buňka; prefix dá buňce jinou šířku. Mezi instrukcemi jazyka TECHNOL je RLO bit 40h registru AH, DR je ECX a \
     nad ním EDX, BX je index; instrukce, která zapisuje BX, vynuluje horní polovinu EBX (tato implementace). Příznaky \
     jsou příznaky 80386 a platí do další instrukce 80386, která je nastaví (tato implementace). SI, DI, BP, SP a \
     segmentové registry překlad odmítne (tato implementace). Buňka `[BX]` mimo paměť způsobí chybu za běhu (tato \
     implementace).",
);
/// An instruction that changes its first operand.
const CHANGES: Entry = Entry {
    chapter: CHAPTER,
    operands: TWO,
    reads: &[Effect::Dr, Effect::Memory],
    writes: &[Effect::Dr, Effect::Memory],
    description: CALCULATED,
    ..INSTRUCTION
};

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
    /// A jump to a label.
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
        _ if name.starts_with('J') => Some(AssemblerForm::Jump),
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
        forms: &[form("MOV BX,CX"), form("MOV target,source")],
        summary: text(
            "Copies a value; `MOV BX,CX` loads the index register BX with the lower 16 bits of DR.",
            "Zkopíruje hodnotu; `MOV BX,CX` naplní indexový registr BX spodními 16 bity DR.",
        ),
        examples: &[example(
            concat!("        LOD  INDEX\n", "        MOV  BX,CX\n", "        LOD  BYTE.TABLE[BX]"),
            "Loads the byte of TABLE that INDEX selects.",
            "Načte slabiku tabulky TABLE, kterou vybírá INDEX.",
        )],
        related: &["BX", "LOD", "ADD"],
        ..CHANGES
    },
    Entry {
        name: "ADD",
        forms: &[form("ADD target,source")],
        summary: text(
            "80386 instruction: adds the source to the target.",
            "Instrukce 80386: přičte zdroj k cíli.",
        ),
        examples: &[example("        ADD  ECX,5", "Adds 5 to DR.", "Přičte 5 k DR.")],
        related: &["SUB", "INC", "AD"],
        ..CHANGES
    },
    known("ADC", ARITHMETIC),
    Entry {
        name: "SUB",
        forms: &[form("SUB target,source")],
        summary: text(
            "80386 instruction: subtracts the source from the target.",
            "Instrukce 80386: odečte zdroj od cíle.",
        ),
        examples: &[example("        SUB  ECX,5", "Subtracts 5 from DR.", "Odečte 5 od DR.")],
        related: &["ADD", "DEC", "CMP", "SU"],
        ..CHANGES
    },
    known("SBB", ARITHMETIC),
    Entry {
        name: "INC",
        forms: &[form("INC target")],
        operands: ONE,
        summary: text(
            "80386 instruction: adds 1; the carry flag stays.",
            "Instrukce 80386: přičte 1; příznak přenosu se nemění.",
        ),
        examples: &[example(
            "        INC  CX",
            "Adds 1 to the lower 16 bits of DR.",
            "Přičte 1 ke spodním 16 bitům DR.",
        )],
        related: &["DEC", "ADD", "INR"],
        ..CHANGES
    },
    Entry {
        name: "DEC",
        forms: &[form("DEC target")],
        operands: ONE,
        summary: text(
            "80386 instruction: subtracts 1; the carry flag stays.",
            "Instrukce 80386: odečte 1; příznak přenosu se nemění.",
        ),
        examples: &[example(
            "        DEC  CX",
            "Subtracts 1 from the lower 16 bits of DR.",
            "Odečte 1 od spodních 16 bitů DR.",
        )],
        related: &["INC", "SUB", "DCR"],
        ..CHANGES
    },
    known("NEG", ARITHMETIC),
    Entry {
        name: "CMP",
        forms: &[form("CMP target,source")],
        summary: text(
            "80386 instruction: sets the flags of target minus source and nothing else.",
            "Instrukce 80386: nastaví příznaky rozdílu cíl minus zdroj a nic jiného.",
        ),
        examples: &[example(
            concat!("        CMP  ECX,10\n", "        JAE  DONE\n", "        FL   1,LAMP\n", "DONE:"),
            "Sets LAMP when DR is below 10.",
            "Nastaví LAMP, když je DR menší než 10.",
        )],
        related: &["SUB", "JE", "JL", "JB", "EQ"],
        writes: &[],
        ..CHANGES
    },
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
    Entry {
        name: "AND",
        forms: &[form("AND target,source")],
        summary: text("80386 instruction: bitwise AND.", "Instrukce 80386: logický součin po bitech."),
        examples: &[example(
            "        AND  ECX,0FFh",
            "Keeps the lowest byte of DR32.",
            "Ponechá z DR32 nejnižší bajt.",
        )],
        related: &["OR", "XOR", "ANDB"],
        ..CHANGES
    },
    Entry {
        name: "OR",
        forms: &[form("OR target,source")],
        summary: text("80386 instruction: bitwise OR.", "Instrukce 80386: logický součet po bitech."),
        examples: &[example("        OR   AH,40h", "Sets RLO.", "Nastaví RLO.")],
        related: &["AND", "XOR", "ORB"],
        ..CHANGES
    },
    Entry {
        name: "XOR",
        forms: &[form("XOR target,source")],
        summary: text(
            "80386 instruction: bitwise exclusive OR.",
            "Instrukce 80386: výlučný součet po bitech.",
        ),
        examples: &[example("        XOR  AH,40h", "Negates RLO.", "Neguje RLO.")],
        related: &["AND", "OR", "XORB"],
        ..CHANGES
    },
    known("NOT", LOGIC),
    known("TEST", LOGIC),
    Entry {
        name: "SHL",
        forms: &[form("SHL target,n")],
        operands: SHIFTED,
        summary: text(
            "80386 instruction: shifts left by 0 to 31 bits; of CL the lower 5 bits count.",
            "Instrukce 80386: posune vlevo o 0 až 31 bitů; z CL platí spodních 5 bitů.",
        ),
        examples: &[example("        SHL  ECX,2", "Multiplies DR32 by 4.", "Vynásobí DR32 čtyřmi.")],
        related: &["SHR", "RL"],
        ..CHANGES
    },
    known("SAL", LOGIC),
    Entry {
        name: "SHR",
        forms: &[form("SHR target,n")],
        operands: SHIFTED,
        summary: text(
            "80386 instruction: shifts right by 0 to 31 bits, filling with 0; of CL the lower 5 bits count.",
            "Instrukce 80386: posune vpravo o 0 až 31 bitů a doplní nuly; z CL platí spodních 5 bitů.",
        ),
        examples: &[example(
            "        SHR  ECX,8",
            "Moves the second byte of DR to the first place.",
            "Přesune druhý bajt DR na první místo.",
        )],
        related: &["SHL", "RR"],
        ..CHANGES
    },
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
