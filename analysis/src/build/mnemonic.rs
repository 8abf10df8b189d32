//! Which operation an instruction becomes.

use technol_image::assembler::{Condition, Function};
use technol_image::op::{Arith, Compare, Cond, Count, Logic, Raster, Unary};
use technol_image::service::Service;

/// How an instruction is translated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Form {
    /// Declarations, directives, opening and closing lines.
    NoCode,
    Nop,
    Ldr,
    Logic(Logic),
    Complement,
    Edge {
        rising: bool,
    },
    Write,
    Flag(Cond),
    MoveBit(Cond),
    Jump(Cond),
    Load,
    Store(Cond),
    Move(Cond),
    Arith(Arith),
    Compare {
        op: Compare,
        if_rlo: bool,
    },
    Unary(Unary),
    IncrementBcd,
    BcdToBin,
    BinToBcd,
    Shift {
        left: bool,
    },
    DrToRlo,
    RloToDr,
    IntToReal,
    Raster(Raster),
    Timer,
    Count(Count),
    Copy,
    Clear,
    Call,
    SeqInit,
    Ex,
    ExIf {
        wait_when: bool,
    },
    Bex,
    Timed(Option<bool>),
    Message(Cond),
    /// Carried out by the control, or by the runtime as a whole.
    Service(Service),
    /// An 80386 instruction.
    Assembler(Function),
    AssemblerJump(Condition),
    InitFinished,
    DoneFinished,
}

const fn compare(op: Compare) -> Form {
    Form::Compare { op, if_rlo: false }
}

/// Sorted by mnemonic.
const FORMS: &[(&str, Form)] = &[
    ("ABS", Form::Unary(Unary::Absolute)),
    ("AD", Form::Arith(Arith::Add)),
    ("ANDB", Form::Arith(Arith::And)),
    ("BCD", Form::BinToBcd),
    ("BEX", Form::Bex),
    ("BIN", Form::BcdToBin),
    ("CA", Form::Complement),
    ("CD", Form::Count(Count::Down)),
    ("CHECK", Form::NoCode),
    ("CLEAR", Form::Clear),
    ("CLI", Form::Nop),
    ("CONDR", Form::DrToRlo),
    ("CONRD", Form::RloToDr),
    ("CU", Form::Count(Count::Up)),
    ("CUBCD", Form::Count(Count::UpBcd)),
    ("DCR", Form::Unary(Unary::Decrement)),
    ("DEBUG", Form::NoCode),
    ("DFTM01", Form::Raster(Raster::Tenth)),
    ("DFTM1", Form::Raster(Raster::Second)),
    ("DFTM10", Form::Raster(Raster::TenSeconds)),
    ("DFTM100", Form::Raster(Raster::HundredSeconds)),
    ("DIVB", Form::Arith(Arith::Div)),
    ("EDGE_H", Form::Edge { rising: true }),
    ("EDGE_L", Form::Edge { rising: false }),
    ("EQ", compare(Compare::Eq)),
    ("EQ1", Form::Compare { op: Compare::Eq, if_rlo: true }),
    ("EQUI", Form::NoCode),
    ("ESET", Form::Message(Cond::Always)),
    ("ESET1", Form::Message(Cond::IfRlo)),
    ("EX", Form::Ex),
    ("EX0", Form::ExIf { wait_when: false }),
    ("EX1", Form::ExIf { wait_when: true }),
    ("FL", Form::Flag(Cond::Always)),
    ("FL1", Form::Flag(Cond::IfRlo)),
    ("GE", compare(Compare::Ge)),
    ("GT", compare(Compare::Gt)),
    ("INR", Form::Unary(Unary::Increment)),
    ("INRBCD", Form::IncrementBcd),
    ("INV", Form::Unary(Unary::Negate)),
    ("JL0", Form::Jump(Cond::IfNotRlo)),
    ("JL1", Form::Jump(Cond::IfRlo)),
    ("JMP", Form::Jump(Cond::Always)),
    ("JUM", Form::Jump(Cond::Always)),
    ("LA", Form::Logic(Logic::And)),
    ("LDR", Form::Ldr),
    ("LE", compare(Compare::Le)),
    ("LO", Form::Logic(Logic::Or)),
    ("LOD", Form::Load),
    ("LT", compare(Compare::Lt)),
    ("LX", Form::Logic(Logic::Xor)),
    ("MECH_INIT", Form::SeqInit),
    ("MODULE_DONE_FINISHED", Form::DoneFinished),
    ("MODULE_INIT_FINISHED", Form::InitFinished),
    ("MOVE", Form::Move(Cond::Always)),
    ("MOVE1", Form::Move(Cond::IfRlo)),
    ("MOVR", Form::MoveBit(Cond::Always)),
    ("MOVR1", Form::MoveBit(Cond::IfRlo)),
    ("MULB", Form::Arith(Arith::Mul)),
    ("MV", Form::Copy),
    ("NOP", Form::Nop),
    ("ORB", Form::Arith(Arith::Or)),
    ("PROC_CALL", Form::Call),
    ("REAL", Form::IntToReal),
    ("RL", Form::Shift { left: true }),
    ("RR", Form::Shift { left: false }),
    ("STI", Form::Nop),
    ("STO", Form::Store(Cond::Always)),
    ("STO0", Form::Store(Cond::IfNotRlo)),
    ("STO1", Form::Store(Cond::IfRlo)),
    ("STOP", Form::NoCode),
    ("STR", Form::NoCode),
    ("SU", Form::Arith(Arith::Sub)),
    ("TEX0", Form::Timed(Some(false))),
    ("TEX1", Form::Timed(Some(true))),
    ("TIM", Form::Timed(None)),
    ("TM", Form::Timer),
    ("T_INCLUDE", Form::NoCode),
    ("WR", Form::Write),
    ("XORB", Form::Arith(Arith::Xor)),
];

/// Services the target carries out.
const SERVICES: &[Service] = &[
    Service::StrCpy,
    Service::StrAdd,
    Service::BinStr,
    Service::BcdStr,
    Service::StrCmp,
    Service::MemCpy,
    Service::MemCmp,
    Service::Edef,
    Service::AnalogPort,
    Service::Analog,
    Service::AnalogSpi,
    Service::SpiAx,
    Service::AxSpi,
    Service::SpiMain,
    Service::Ramp,
    Service::PosInit,
    Service::PosInitX,
    Service::PosInitY,
    Service::PosInitZ,
    Service::PosInit4,
    Service::PosInit5,
    Service::PosInit6,
    Service::PosReset,
    Service::PosResetX,
    Service::PosResetY,
    Service::PosResetZ,
    Service::PosReset4,
    Service::PosReset5,
    Service::PosReset6,
    Service::PosMode,
    Service::PosModeX,
    Service::PosModeY,
    Service::PosModeZ,
    Service::PosMode4,
    Service::PosMode5,
    Service::PosMode6,
    Service::PosControl,
    Service::PosControlX,
    Service::PosControlY,
    Service::PosControlZ,
    Service::PosControl4,
    Service::PosControl5,
    Service::PosControl6,
    Service::RegulX,
    Service::RegulY,
    Service::RegulZ,
    Service::Regul4,
    Service::Regul5,
    Service::Regul6,
    Service::MapIn,
    Service::MapOut,
    Service::MapAin,
    Service::MapAout,
    Service::DefIn,
    Service::DefOut,
    Service::UpdateIn,
    Service::ShareVar,
    Service::ShareBit,
    Service::SaRead,
    Service::SaWrite,
    Service::CnfGetInt,
    Service::CnfGetReal,
    Service::CnfGetStr,
    Service::CnfGetBin,
    Service::CnfGetBit,
    Service::ConstGet,
    Service::PlctColIndex,
    Service::PlctColId,
    Service::PlctColType,
    Service::PlctGetSelline,
    Service::PlctSetSelline,
    Service::PlctChanged,
    Service::PlctGetLinescount,
    Service::PlctGetInt,
    Service::PlctGetReal,
    Service::PlctGetStr,
    Service::PlctGetBin,
    Service::PlctSetInt,
    Service::PlctSetReal,
    Service::PlctSetStr,
    Service::PlctSetBin,
    Service::LdrLic,
    Service::CanSend,
    Service::CanRecv,
    Service::CanRecvReq,
    Service::CanRecvEnd,
    Service::CanRecvDel,
    Service::CanSysioRead,
    Service::CanSysioWrite,
    Service::CanAxSend,
    Service::ComSend,
    Service::ComSendStr,
    Service::ComRecv,
    Service::ComControl,
    Service::EcatCoeRead,
    Service::EcatCoeWrite,
    Service::EcatSoeRead,
    Service::EcatSoeWrite,
    Service::EcatCommand,
];

/// How `mnemonic` (upper case) is translated; `None` when the target has no code for it.
pub(super) fn form(mnemonic: &str) -> Option<Form> {
    if let Ok(found) = FORMS.binary_search_by(|(name, _)| (*name).cmp(mnemonic)) {
        return FORMS.get(found).map(|(_, form)| *form);
    }
    let service = SERVICES.iter().find(|service| service.name() == mnemonic);
    service.map(|service| Form::Service(*service)).or_else(|| super::assembler::form(mnemonic))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{self, EntryKind};

    #[test]
    fn the_table_is_sorted_and_names_each_instruction_once() {
        assert!(FORMS.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }

    #[test]
    fn every_name_of_the_table_is_found() {
        for (name, expected) in FORMS {
            assert_eq!(form(name), Some(*expected), "{name}");
        }
        assert_eq!(form("STRCPY"), Some(Form::Service(Service::StrCpy)));
        assert_eq!(form("IDIV"), None);
        assert_eq!(form(""), None);
    }

    #[test]
    fn exactly_the_executable_instructions_of_the_catalogue_have_code() {
        for entry in catalogue::entries().filter(|entry| entry.kind == EntryKind::Instruction) {
            assert_eq!(form(entry.name).is_some(), entry.executable, "{}", entry.name);
        }
        for (name, _) in FORMS {
            assert!(catalogue::entry(name).is_some(), "{name}");
        }
    }
}
