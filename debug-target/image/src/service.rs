//! Instructions that are more than a few operations on registers and cells: texts, and everything that the control
//! around the program does for it. They share one operation, [`Op::Service`](crate::Op::Service), with a table of calls.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::op::{BitRef, Place, Width};

macro_rules! services {
    ($($(#[$doc:meta])* $variant:ident = $name:literal,)*) => {
        /// Which instruction a [`ServiceCall`] is.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
        pub enum Service {
            $($(#[$doc])* $variant,)*
        }

        impl Service {
            /// All of them, in the order of their numbers in images.
            pub const ALL: &'static [Service] = &[$(Service::$variant,)*];

            /// The mnemonic.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Service::$variant => $name,)*
                }
            }
        }
    };
}

// New ones are appended: the order is part of the image format.
services! {
    /// Copies a text (manual 3.18).
    StrCpy = "STRCPY",
    /// Appends a text.
    StrAdd = "STRADD",
    /// Number in binary to text.
    BinStr = "BINSTR",
    /// Number in BCD to text.
    BcdStr = "BCDSTR",
    /// Compares texts.
    StrCmp = "STRCMP",
    /// Copies bytes.
    MemCpy = "MEMCPY",
    /// Compares bytes.
    MemCmp = "MEMCMP",
    /// Reads a licence bit (9).
    LdrLic = "LDR_LIC",
    /// Sends a packet to the CAN-BUS (9).
    CanSend = "CAN_SEND",
    /// Takes a received packet.
    CanRecv = "CAN_RECV",
    /// Registers a receiver.
    CanRecvReq = "CAN_RECV_REQ",
    /// Removes a receiver.
    CanRecvEnd = "CAN_RECV_END",
    /// A synonym of CAN_RECV_END.
    CanRecvDel = "CAN_RECV_DEL",
    /// Reads the state of an INOUT unit.
    CanSysioRead = "CAN_SYSIO_READ",
    /// Writes to an INOUT unit.
    CanSysioWrite = "CAN_SYSIO_WRITE",
    /// Maps an input to a bit (10).
    MapIn = "MAP_IN",
    /// Maps a bit to an output.
    MapOut = "MAP_OUT",
    /// Maps an analog input to a cell.
    MapAin = "MAP_AIN",
    /// Maps a cell to an analog output.
    MapAout = "MAP_AOUT",
    /// Chooses the port of ANALOG (12).
    AnalogPort = "ANALOG_PORT",
    /// Sets an analog output.
    Analog = "ANALOG",
    /// Analog output of the spindle.
    AnalogSpi = "ANALOG_SPI",
    /// Spindle to axis.
    SpiAx = "SPI_AX",
    /// Axis to spindle.
    AxSpi = "AX_SPI",
    /// Chooses the main spindle.
    SpiMain = "SPI_MAIN",
    /// Ramp of a value.
    Ramp = "RAMP",
    /// Packet to a CAN drive (13).
    CanAxSend = "CAN_AX_SEND",
    /// Couples a bit with a message (14).
    Edef = "EDEF",
    /// Configuration parameter, integer (16).
    CnfGetInt = "CNF_GET_INT",
    /// Configuration parameter, real.
    CnfGetReal = "CNF_GET_REAL",
    /// Configuration parameter, text.
    CnfGetStr = "CNF_GET_STR",
    /// Configuration parameter, bytes.
    CnfGetBin = "CNF_GET_BIN",
    /// Configuration parameter, bit.
    CnfGetBit = "CNF_GET_BIT",
    /// Constant of a `*.PlcConstants` file.
    ConstGet = "CONST_GET",
    /// Shares a variable (18).
    ShareVar = "SHARE_VAR",
    /// Shares a bit.
    ShareBit = "SHARE_BIT",
    /// Reads shared memory.
    SaRead = "SA_READ",
    /// Writes shared memory.
    SaWrite = "SA_WRITE",
    /// Declares an input element (27).
    DefIn = "DEF_IN",
    /// Declares an output element.
    DefOut = "DEF_OUT",
    /// Updates an input element.
    UpdateIn = "UPDATE_IN",
    /// Sends bytes to a serial port (23).
    ComSend = "COM_SEND",
    /// Sends a text to a serial port.
    ComSendStr = "COM_SEND_STR",
    /// Receives from a serial port.
    ComRecv = "COM_RECV",
    /// Opens, closes and sets up a serial port.
    ComControl = "COM_CONTROL",
    /// Number of a table column (17).
    PlctColIndex = "PLCT_COL_INDEX",
    /// Name of a table column.
    PlctColId = "PLCT_COL_ID",
    /// Type of a table column.
    PlctColType = "PLCT_COL_TYPE",
    /// The selected line.
    PlctGetSelline = "PLCT_GET_SELLINE",
    /// Selects a line.
    PlctSetSelline = "PLCT_SET_SELLINE",
    /// Whether a table changed.
    PlctChanged = "PLCT_CHANGED",
    /// Number of lines.
    PlctGetLinescount = "PLCT_GET_LINESCOUNT",
    /// Reads an integer of a table.
    PlctGetInt = "PLCT_GET_INT",
    /// Reads a real of a table.
    PlctGetReal = "PLCT_GET_REAL",
    /// Reads a text of a table.
    PlctGetStr = "PLCT_GET_STR",
    /// Reads bytes of a table.
    PlctGetBin = "PLCT_GET_BIN",
    /// Writes an integer of a table.
    PlctSetInt = "PLCT_SET_INT",
    /// Writes a real of a table.
    PlctSetReal = "PLCT_SET_REAL",
    /// Writes a text of a table.
    PlctSetStr = "PLCT_SET_STR",
    /// Writes bytes of a table.
    PlctSetBin = "PLCT_SET_BIN",
    /// Reads an object of an EtherCAT slave (26).
    EcatCoeRead = "ECAT_COE_READ",
    /// Writes an object of an EtherCAT slave.
    EcatCoeWrite = "ECAT_COE_WRITE",
    /// Reads a parameter of a drive.
    EcatSoeRead = "ECAT_SOE_READ",
    /// Writes a parameter of a drive.
    EcatSoeWrite = "ECAT_SOE_WRITE",
    /// Commands the EtherCAT master.
    EcatCommand = "ECAT_COMMAND",
    /// Takes an axis into the hands of the PLC (19).
    PosInit = "POS_INIT",
    /// Takes an axis into the hands of the PLC (19, older form).
    PosInitX = "POS_INIT_X",
    /// Takes an axis into the hands of the PLC (19, older form).
    PosInitY = "POS_INIT_Y",
    /// Takes an axis into the hands of the PLC (19, older form).
    PosInitZ = "POS_INIT_Z",
    /// Takes an axis into the hands of the PLC (19, older form).
    PosInit4 = "POS_INIT_4",
    /// Takes an axis into the hands of the PLC (19, older form).
    PosInit5 = "POS_INIT_5",
    /// Takes an axis into the hands of the PLC (19, older form).
    PosInit6 = "POS_INIT_6",
    /// Gives an axis back.
    PosReset = "POS_RESET",
    /// Gives an axis back (older form).
    PosResetX = "POS_RESET_X",
    /// Gives an axis back (older form).
    PosResetY = "POS_RESET_Y",
    /// Gives an axis back (older form).
    PosResetZ = "POS_RESET_Z",
    /// Gives an axis back (older form).
    PosReset4 = "POS_RESET_4",
    /// Gives an axis back (older form).
    PosReset5 = "POS_RESET_5",
    /// Gives an axis back (older form).
    PosReset6 = "POS_RESET_6",
    /// Programs a movement.
    PosMode = "POS_MODE",
    /// Programs a movement (older form).
    PosModeX = "POS_MODE_X",
    /// Programs a movement (older form).
    PosModeY = "POS_MODE_Y",
    /// Programs a movement (older form).
    PosModeZ = "POS_MODE_Z",
    /// Programs a movement (older form).
    PosMode4 = "POS_MODE_4",
    /// Programs a movement (older form).
    PosMode5 = "POS_MODE_5",
    /// Programs a movement (older form).
    PosMode6 = "POS_MODE_6",
    /// Controls a movement.
    PosControl = "POS_CONTROL",
    /// Controls a movement (older form).
    PosControlX = "POS_CONTROL_X",
    /// Controls a movement (older form).
    PosControlY = "POS_CONTROL_Y",
    /// Controls a movement (older form).
    PosControlZ = "POS_CONTROL_Z",
    /// Controls a movement (older form).
    PosControl4 = "POS_CONTROL_4",
    /// Controls a movement (older form).
    PosControl5 = "POS_CONTROL_5",
    /// Controls a movement (older form).
    PosControl6 = "POS_CONTROL_6",
    /// Regulator of an axis (12).
    RegulX = "REGUL_X",
    /// Regulator of an axis (12).
    RegulY = "REGUL_Y",
    /// Regulator of an axis (12).
    RegulZ = "REGUL_Z",
    /// Regulator of an axis (12).
    Regul4 = "REGUL_4",
    /// Regulator of an axis (12).
    Regul5 = "REGUL_5",
    /// Regulator of an axis (12).
    Regul6 = "REGUL_6",
}

/// A call.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ServiceCall {
    /// The instruction.
    pub service: Service,
    /// Its operands, in order; left-out trailing ones are absent.
    pub args: Vec<Arg>,
    /// RLO goes on the equation stack before: an equation is open.
    pub push: bool,
}

/// An operand.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Arg {
    /// Left out.
    Missing,
    /// An integer constant.
    Int(i64),
    /// A real constant.
    Real(f64),
    /// A text literal, in the code page of the control.
    Text(Vec<u8>),
    /// A keyword, upper case.
    Keyword(String),
    /// A cell.
    Cell {
        /// Where.
        place: Place,
        /// Access width.
        width: Width,
        /// The value is negated.
        neg: bool,
    },
    /// A bit.
    Bit {
        /// Which.
        bit: BitRef,
        /// Read the negation.
        neg: bool,
    },
    /// Memory without access width.
    Area {
        /// Where.
        place: Place,
        /// Bytes from there to the end of the declared variable.
        len: u32,
    },
    /// A procedure, by its number.
    Procedure(u16),
}
