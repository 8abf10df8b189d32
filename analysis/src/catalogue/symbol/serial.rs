//! State of the serial channels and the packet of a CAN bus, TCANMSGS (manual 9.4, 13.14.4, 23.3.2 and 23.4).

use super::Direction::{Both, CncToPlc};
use super::space::{Row, Shape};
use crate::catalogue::entry::Prefix;
use crate::catalogue::pattern::text;

/// In the order of their addresses.
pub(super) const ROWS: &[Row] = &[
    (
        "PLC_COM_ERROR",
        Shape::Constant(1),
        CncToPlc,
        "23.3.2",
        text(
            "Flag of COM_CONTROL STATE: the channel is in error.",
            "Příznak COM_CONTROL STATE: kanál je v chybě.",
        ),
    ),
    (
        "PLC_COM_REQ",
        Shape::Constant(2),
        CncToPlc,
        "23.3.2",
        text(
            "Flag of COM_CONTROL STATE: the channel is neither requested nor configured.",
            "Příznak COM_CONTROL STATE: kanál není požadován ani konfigurován.",
        ),
    ),
    (
        "PLC_COM_SEND_OVER",
        Shape::Constant(4),
        CncToPlc,
        "23.3.2",
        text(
            "Flag of COM_CONTROL STATE: the transmit buffer has overflowed.",
            "Příznak COM_CONTROL STATE: vysílací buffer přetekl.",
        ),
    ),
    (
        "PLC_COM_RECV_OVER",
        Shape::Constant(8),
        CncToPlc,
        "23.3.2",
        text(
            "Flag of COM_CONTROL STATE: the receive buffer has overflowed.",
            "Příznak COM_CONTROL STATE: přijímací buffer přetekl.",
        ),
    ),
    (
        "CAN_ID",
        Shape::Member(0, Prefix::Word, 1),
        Both,
        "23.4",
        text(
            "Packet of a CAN bus: identifier of 11 bits (COB-ID).",
            "Paket sběrnice CAN: identifikátor o 11 bitech (COB-ID).",
        ),
    ),
    (
        "CAN_RTR",
        Shape::Member(2, Prefix::Byte, 1),
        Both,
        "23.4",
        text(
            "Packet of a CAN bus: request for remote data, 0 for none.",
            "Paket sběrnice CAN: žádost o vzdálená data, 0 žádná.",
        ),
    ),
    (
        "CAN_LEN",
        Shape::Member(3, Prefix::Byte, 1),
        Both,
        "23.4",
        text(
            "Packet of a CAN bus: number of valid data bytes, 0 to 8.",
            "Paket sběrnice CAN: počet platných bajtů dat, 0 až 8.",
        ),
    ),
    (
        "CAN_DATA",
        Shape::Member(4, Prefix::Byte, 8),
        Both,
        "23.4",
        text("Packet of a CAN bus: the eight data bytes.", "Paket sběrnice CAN: osm bajtů dat."),
    ),
    (
        "CAN_DATA_1",
        Shape::Member(5, Prefix::Byte, 1),
        Both,
        "13.14.4",
        text("Packet of a CAN bus: data byte 1.", "Paket sběrnice CAN: bajt dat 1."),
    ),
    (
        "CAN_DATA_2",
        Shape::Member(6, Prefix::Byte, 1),
        Both,
        "13.14.4",
        text("Packet of a CAN bus: data byte 2.", "Paket sběrnice CAN: bajt dat 2."),
    ),
    (
        "CAN_DATA_3",
        Shape::Member(7, Prefix::Byte, 1),
        Both,
        "13.14.4",
        text("Packet of a CAN bus: data byte 3.", "Paket sběrnice CAN: bajt dat 3."),
    ),
    (
        "CAN_DATA_4",
        Shape::Member(8, Prefix::Byte, 1),
        Both,
        "13.14.4",
        text("Packet of a CAN bus: data byte 4.", "Paket sběrnice CAN: bajt dat 4."),
    ),
    (
        "CAN_DATA_5",
        Shape::Member(9, Prefix::Byte, 1),
        Both,
        "13.14.4",
        text("Packet of a CAN bus: data byte 5.", "Paket sběrnice CAN: bajt dat 5."),
    ),
    (
        "CAN_DATA_6",
        Shape::Member(10, Prefix::Byte, 1),
        Both,
        "13.14.4",
        text("Packet of a CAN bus: data byte 6.", "Paket sběrnice CAN: bajt dat 6."),
    ),
    (
        "CAN_DATA_7",
        Shape::Member(11, Prefix::Byte, 1),
        Both,
        "13.14.4",
        text("Packet of a CAN bus: data byte 7.", "Paket sběrnice CAN: bajt dat 7."),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::{SystemKind, symbol};

    #[test]
    fn the_flags_of_a_serial_channel_are_separate_bits() {
        for (bit, name) in
            ["PLC_COM_ERROR", "PLC_COM_REQ", "PLC_COM_SEND_OVER", "PLC_COM_RECV_OVER"].iter().enumerate()
        {
            assert_eq!(
                symbol(name).map(|symbol| symbol.kind),
                Some(SystemKind::Constant(1 << bit)),
                "{name}"
            );
        }
        assert_eq!(ROWS.len(), 4 + 4 + 7);
    }

    #[test]
    fn a_packet_of_the_can_bus_has_twelve_bytes() {
        let mut end = 0;
        for name in ["CAN_ID", "CAN_RTR", "CAN_LEN", "CAN_DATA"] {
            let Some(SystemKind::Member { offset, element, len }) = symbol(name).map(|symbol| symbol.kind)
            else {
                panic!("{name} is not a member");
            };
            assert_eq!(offset, end, "{name}");
            end += element.bytes() * len;
        }
        assert_eq!(end, 12);
        for index in 1..8 {
            let expected = SystemKind::Member { offset: 4 + index, element: Prefix::Byte, len: 1 };
            assert_eq!(symbol(&format!("CAN_DATA_{index}")).map(|symbol| symbol.kind), Some(expected));
        }
    }
}
