//! The instructions of the virtual machine, one or a few per TECHNOL source line.
//!
//! Registers: RLO (one bit), DR (64 bits; an operation of width *w* touches its low *w* bits unless said
//! otherwise), DR_REAL (IEEE 754 double), BX (index, 32 bits), an equation stack of [`STACK_DEPTH`] bits.

use serde::{Deserialize, Serialize};

/// Index of an operation in [`Program::code`](crate::Program::code).
pub type Pc = u32;
/// Byte address in PLC memory.
pub type Addr = u32;

/// Cells of the equation stack (manual 3.2).
pub const STACK_DEPTH: usize = 8;

/// Width of a data access and of the part of DR it works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Width {
    /// 8 bits, DR8.
    Byte,
    /// 16 bits, DR16.
    Word,
    /// 32 bits, DR32.
    DWord,
    /// 64 bits, DR64.
    QWord,
    /// 64-bit floating point, DR_REAL.
    Real,
}

impl Width {
    /// Length of a memory cell of this width in bytes.
    #[must_use]
    pub const fn bytes(self) -> u32 {
        match self {
            Width::Byte => 1,
            Width::Word => 2,
            Width::DWord => 4,
            Width::QWord | Width::Real => 8,
        }
    }

    /// Length in bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.bytes() * 8
    }
}

/// A data cell: `addr`, plus the signed value of BX when `indexed`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Place {
    /// Byte address.
    pub addr: Addr,
    /// BX is added to the address at run time.
    pub indexed: bool,
}

/// One bit of a byte cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct BitRef {
    /// Byte address.
    pub addr: Addr,
    /// Bit number 0..=7; bit 0 has weight 01h.
    pub bit: u8,
    /// BX is added to the address at run time.
    pub indexed: bool,
}

/// Where the second operand of a data operation comes from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Source {
    /// A memory cell.
    Mem(Place),
    /// An integer constant, already sign-extended to 64 bits from the width of its operation.
    Int(i64),
    /// A real constant (only with [`Width::Real`]).
    Real(f64),
}

/// When a conditional form acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Cond {
    /// Always.
    Always,
    /// Only when RLO = 1.
    IfRlo,
    /// Only when RLO = 0.
    IfNotRlo,
}

/// Binary function of the bit logic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Logic {
    /// LA.
    And,
    /// LO.
    Or,
    /// LX.
    Xor,
}

/// Two-operand arithmetic on DR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Arith {
    /// AD: at the operand's width, the rest of DR stays.
    Add,
    /// SU: as AD.
    Sub,
    /// MULB: signed, result sign-extended to 64 bits.
    Mul,
    /// DIVB: signed; dividend DR16 (Byte), DR32 (Word), DR64 (DWord); result sign-extended to 64 bits.
    Div,
    /// ORB.
    Or,
    /// ANDB.
    And,
    /// XORB.
    Xor,
}

/// Comparison of DR with an operand; integer orderings are signed at the operand's width.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Compare {
    /// EQ, EQ1.
    Eq,
    /// LT.
    Lt,
    /// GT.
    Gt,
    /// LE.
    Le,
    /// GE.
    Ge,
}

/// One-operand arithmetic on DR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Unary {
    /// INR.
    Increment,
    /// DCR.
    Decrement,
    /// INV: two's complement (or the negated real).
    Negate,
    /// ABS.
    Absolute,
}

/// Rate of a DFTM block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Raster {
    /// DFTM01: every 0.1 s.
    Tenth,
    /// DFTM1: every second.
    Second,
    /// DFTM10: every 10 s.
    TenSeconds,
    /// DFTM100: every 100 s.
    HundredSeconds,
}

/// Counting function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Count {
    /// CU.
    Up,
    /// CD.
    Down,
    /// CUBCD.
    UpBcd,
}

/// Test of CONDR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum DrTest {
    /// RLO := DR at this width is not zero.
    NonZero(Width),
    /// RLO := this bit (0..=31) of DR.
    Bit(u8),
}

/// An operation.
///
/// Operations that write a list of bits (WR a,b,c) become one operation per bit; all of them belong to one
/// source line, and only the first one starts a [statement](crate::Program::statements).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Op {
    /// No effect (CLI, STI, NOP).
    Nop,
    /// LDR: RLO := bit (negated when `neg`); the old RLO is pushed first when `push`.
    Ldr {
        /// Operand.
        bit: BitRef,
        /// Read the negation.
        neg: bool,
        /// An equation is open: push the old RLO.
        push: bool,
    },
    /// LA/LO/LX with operand.
    Logic {
        /// Function.
        op: Logic,
        /// Operand.
        bit: BitRef,
        /// Read the negation.
        neg: bool,
    },
    /// LA/LO/LX without operand: combines with, and removes, the last pushed value.
    LogicPop(Logic),
    /// CA: RLO := not RLO.
    Complement,
    /// EDGE_H/EDGE_L. Hidden byte `state`: bit 0 previous value, bit 1 valid.
    Edge {
        /// Rising (EDGE_H) or falling (EDGE_L).
        rising: bool,
        /// Watched bit.
        bit: BitRef,
        /// Address of the hidden state byte.
        state: Addr,
    },
    /// WR: bit := RLO.
    Write(BitRef),
    /// FL (Always) and FL1 (IfRlo): bit := value.
    Flag {
        /// Value stored.
        value: bool,
        /// Destination.
        bit: BitRef,
        /// When.
        cond: Cond,
    },
    /// MOVR, MOVR1: bit := bit.
    MoveBit {
        /// Destination.
        dst: BitRef,
        /// Source.
        src: BitRef,
        /// Read the negation of the source.
        neg: bool,
        /// When.
        cond: Cond,
    },
    /// JUM (Always), JL1 (IfRlo), JL0 (IfNotRlo).
    Jump {
        /// Target.
        target: Pc,
        /// When.
        cond: Cond,
    },
    /// LOD: DR := source sign-extended to 64 bits (Real: DR_REAL and its integer copy).
    Load {
        /// Source.
        src: Source,
        /// Access width.
        width: Width,
        /// Two's complement (or negated real) of the loaded value.
        neg: bool,
    },
    /// STO, STO1, STO0.
    Store {
        /// Destination.
        dst: Place,
        /// Access width.
        width: Width,
        /// When.
        cond: Cond,
    },
    /// MOVE, MOVE1: memory to memory, DR unchanged.
    Move {
        /// Destination.
        dst: Place,
        /// Source.
        src: Place,
        /// Access width.
        width: Width,
        /// When.
        cond: Cond,
    },
    /// AD, SU, MULB, DIVB, ORB, ANDB, XORB.
    Arith {
        /// Function.
        op: Arith,
        /// Second operand.
        src: Source,
        /// Operand width.
        width: Width,
    },
    /// EQ…GE, EQ1 (`if_rlo`: when RLO = 0 nothing happens and RLO stays 0).
    Compare {
        /// Relation.
        op: Compare,
        /// Second operand.
        src: Source,
        /// Operand width.
        width: Width,
        /// EQ1.
        if_rlo: bool,
    },
    /// INR, DCR, INV, ABS.
    Unary {
        /// Function.
        op: Unary,
        /// Register width.
        width: Width,
    },
    /// INRBCD on DR16.
    IncrementBcd,
    /// BIN: BCD to binary at Word or DWord width.
    BcdToBin(Width),
    /// BCD: binary to BCD at Word or DWord width.
    BinToBcd(Width),
    /// RL, RR: logical shift; counts at or above the width give 0.
    Shift {
        /// Left (RL) or right (RR).
        left: bool,
        /// Number of bits; a cell is read as unsigned byte.
        count: Source,
        /// Register width.
        width: Width,
    },
    /// CONDR.
    DrToRlo(DrTest),
    /// CONRD: DR at the width := all ones or zero by RLO.
    RloToDr(Width),
    /// REAL: DR_REAL := DR at this width, sign-extended; DR64 := the integer.
    IntToReal(Width),
    /// DFTMxx: continue at `end` unless this raster ticks in this cycle.
    Raster {
        /// Rate.
        rate: Raster,
        /// First operation after the block.
        end: Pc,
    },
    /// TM.
    Timer {
        /// Counter cell.
        count: Place,
        /// Counter width, Byte or Word; the comparison is unsigned.
        width: Width,
    },
    /// CU, CD, CUBCD. Hidden byte `state`: bit 0 previous count input.
    Counter {
        /// Function.
        op: Count,
        /// Counter cell.
        count: Place,
        /// Counter width, Byte or Word.
        width: Width,
        /// Address of the hidden state byte.
        state: Addr,
    },
    /// MV: copies bytes; overlapping areas as memmove.
    Copy {
        /// Source.
        src: Place,
        /// Destination.
        dst: Place,
        /// Number of bytes.
        len: u32,
    },
    /// CLEAR begin,end and CLEAR GLOBAL/INTERNAL,ALL: zeroes `len` bytes.
    Clear {
        /// First byte.
        addr: Addr,
        /// Number of bytes.
        len: u32,
    },
    /// PROC_CALL: index into [`Program::procedures`](crate::Program::procedures).
    Call(u16),
    /// PROC_END.
    Return,
    /// MECH_BEGIN, and the start of MODULE_BLOCK_INIT / MODULE_BLOCK_DONE: continue where sequence `seq` is,
    /// or after its end when it is not active.
    SeqBegin(u16),
    /// MECH_END, and the end of the block modules.
    SeqEnd(u16),
    /// MECH_INIT: into rest.
    SeqInit(u16),
    /// EX.
    Ex {
        /// Resume point of the current sequence, 1-based index into `Sequence::resume`.
        point: u16,
        /// Source line for `mech_LINE`.
        line: u16,
    },
    /// EX0 (`wait_when` false), EX1 (true).
    ExIf {
        /// Waits while RLO equals this.
        wait_when: bool,
        /// Resume point.
        point: u16,
        /// Source line.
        line: u16,
    },
    /// BEX: moves the continuation without waiting.
    Bex {
        /// Resume point.
        point: u16,
        /// Source line.
        line: u16,
    },
    /// TEX0/TEX1/TIM: index into [`Program::timed`](crate::Program::timed).
    Timed(u16),
    /// ESET, ESET1: index into [`Program::messages`](crate::Program::messages).
    Message {
        /// Parameters.
        index: u16,
        /// When.
        cond: Cond,
    },
    /// An instruction of [`Service`](crate::Service): index into [`Program::services`](crate::Program::services).
    Service(u16),
    /// BX := DR (low 16 bits, zero-extended): `MOV BX,CX`.
    IndexFromDr,
    /// MODULE_INIT_FINISHED in file n (0-based).
    InitFinished(u8),
    /// MODULE_DONE_FINISHED in file n (0-based).
    DoneFinished(u8),
    /// End of a module's code in one file.
    ModuleEnd,
    /// Copies `len` bytes at `offset` of the record of the prepared block whose number is in BX to
    /// [`BLOCK_WINDOW`](crate::system::BLOCK_WINDOW); zeros when there is no such block.
    SelectBlock {
        /// Offset in the record.
        offset: u16,
        /// 1 to 8 bytes.
        len: u8,
    },
}
