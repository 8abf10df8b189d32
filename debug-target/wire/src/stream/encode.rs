//! From values to samples: whole, or what differs from one that the host has.

use alloc::vec::Vec;

use super::bits::{BitWriter, difference_len, golomb_len};
use super::layout::Layout;

/// A whole sample with all bits of each value.
pub(crate) const PLAIN: u8 = 0;
/// A whole sample with each value as its difference from 0.
pub(crate) const WHOLE: u8 = 1;
/// What differs from the last whole sample.
pub(crate) const ON_WHOLE: u8 = 2;
/// What differs from the last sample.
pub(crate) const ON_LAST: u8 = 3;

/// Bits of the number in the first byte of the payload, above the 8 in the frame's `seq`.
pub(crate) const NUMBER_BITS: u32 = 2;
/// Order of the code for the distance to the last whole sample, which may be long ago; that to the last one is short.
pub(crate) const WHOLE_ORDER: u32 = 6;
/// Bytes by which what differs from the last sample may be shorter before it is preferred: what differs from the
/// last whole sample needs no unbroken row of frames.
const WORTH: u32 = 1;

/// A sample that was sent.
#[derive(Clone, Debug)]
struct Sent {
    number: u32,
    values: Vec<u64>,
}

/// Makes the samples of one stream.
#[derive(Clone, Debug)]
pub(crate) struct Encoder {
    id: u8,
    layout: Layout,
    /// Numbers and cycles do not pass evenly in time: each sample tells both in full.
    uneven: bool,
    last: Sent,
    whole: Sent,
    /// Number of the sample before the last.
    before: u32,
    /// A sample was sent, so that there is something to differ from.
    begun: bool,
    /// Number of the first sample with the present distance between number and cycle, and that distance.
    anchor: (u32, u32),
    /// The host has that distance.
    anchored: bool,
}

impl Encoder {
    /// `number`: that before the first sample.
    pub(crate) fn new(id: u8, layout: Layout, number: u32, uneven: bool) -> Self {
        let sent = Sent { number, values: layout.zeros() };
        Encoder {
            id,
            uneven,
            last: sent.clone(),
            whole: sent,
            before: number,
            begun: false,
            anchor: (0, 0),
            anchored: false,
            layout,
        }
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The values that were sent last.
    pub(crate) fn last(&self) -> &[u64] {
        &self.last.values
    }

    /// The number that was sent last; `None` before the first.
    pub(crate) fn last_number(&self) -> Option<u32> {
        self.begun.then_some(self.last.number)
    }

    /// The host has the sample of that number, which told number and cycle in full.
    pub(crate) fn confirmed(&mut self, number: u32) {
        let (since, _) = self.anchor;
        if self.begun
            && number.wrapping_sub(since) as i32 >= 0
            && self.last.number.wrapping_sub(number) as i32 >= 0
        {
            self.anchored = true;
        }
    }

    /// Writes the payload of a sample; `whole`: the host has nothing that it could differ from.
    pub(crate) fn encode(&mut self, number: u32, cycle: u32, values: &[u64], whole: bool, out: &mut Vec<u8>) {
        let distance = number.wrapping_sub(cycle);
        if !self.begun || self.anchor.1 != distance {
            self.anchor = (number, distance);
            self.anchored = false;
        }
        let form = if whole || !self.begun || self.last.number == number {
            self.whole_form(values)
        } else {
            self.form(number, values)
        };
        if number != self.last.number {
            self.before = self.last.number;
        }
        let full = self.uneven || whole || !self.anchored;
        out.clear();
        let high = (number >> 8) as u8 & ((1 << NUMBER_BITS) - 1);
        out.push(self.id << 5 | form << 3 | u8::from(full) << 2 | high);
        if full {
            put_varint(number, out);
            put_varint(cycle, out);
        }
        let mut writer = BitWriter::new(out);
        if self.layout.has_extremes() {
            writer.put_golomb(number.wrapping_sub(self.before), 0);
        }
        match form {
            PLAIN => {
                for (value, width) in values.iter().zip(self.layout.widths()) {
                    writer.put(*value, u32::from(*width));
                }
            }
            WHOLE => {
                for (value, width) in values.iter().zip(self.layout.widths()) {
                    put_value(&mut writer, *value, *width);
                }
            }
            _ => {
                let (base, order) =
                    if form == ON_WHOLE { (&self.whole, WHOLE_ORDER) } else { (&self.last, 0) };
                writer.put_golomb(number.wrapping_sub(base.number).wrapping_sub(1), order);
                put_changes(&mut writer, &self.layout, base, values);
            }
        }
        self.begun = true;
        self.last.number = number;
        self.last.values.copy_from_slice(values);
        if form <= WHOLE {
            self.whole.number = number;
            self.whole.values.copy_from_slice(values);
        }
    }

    fn whole_form(&self, values: &[u64]) -> u8 {
        if self.whole_bits(values) < self.layout.bits() { WHOLE } else { PLAIN }
    }

    fn whole_bits(&self, values: &[u64]) -> u32 {
        let bits = |(value, width): (&u64, &u8)| if *width == 1 { 1 } else { difference_len(*value, *width) };
        values.iter().zip(self.layout.widths()).map(bits).sum()
    }

    /// The shortest form.
    fn form(&self, number: u32, values: &[u64]) -> u8 {
        let bits = |base: &Sent, order| {
            let distance = number.wrapping_sub(base.number).wrapping_sub(1);
            golomb_len(distance, order) + changes_bits(&self.layout, base, values)
        };
        let on_whole = bits(&self.whole, WHOLE_ORDER).div_ceil(8);
        let on_last = bits(&self.last, 0).div_ceil(8);
        let (form, bytes) =
            if on_whole <= on_last + WORTH { (ON_WHOLE, on_whole) } else { (ON_LAST, on_last) };
        let whole = self.whole_bits(values).min(self.layout.bits()).div_ceil(8);
        if whole <= bytes { self.whole_form(values) } else { form }
    }
}

fn put_value(writer: &mut BitWriter<'_>, value: u64, width: u8) {
    if width == 1 {
        writer.put(value, 1);
    } else {
        writer.put_difference(value, width);
    }
}

/// Each change: how many values are passed over, and the difference with its width. A bit that changes needs no
/// difference.
fn changes<'a>(
    layout: &'a Layout,
    base: &'a Sent,
    values: &'a [u64],
) -> impl Iterator<Item = (u32, Option<(u64, u8)>)> + 'a {
    let mut passed = 0;
    values.iter().zip(&base.values).zip(layout.widths()).filter_map(move |((value, old), width)| {
        if value == old {
            passed += 1;
            return None;
        }
        let difference = (*width > 1).then(|| (value.wrapping_sub(*old), *width));
        Some((core::mem::take(&mut passed), difference))
    })
}

fn put_changes(writer: &mut BitWriter<'_>, layout: &Layout, base: &Sent, values: &[u64]) {
    for (passed, difference) in changes(layout, base, values) {
        writer.put_golomb(passed, layout.order());
        if let Some((difference, width)) = difference {
            writer.put_difference(difference, width);
        }
    }
}

/// Bits that [`put_changes`] needs.
fn changes_bits(layout: &Layout, base: &Sent, values: &[u64]) -> u32 {
    let of_change = |(passed, difference): (u32, Option<(u64, u8)>)| {
        golomb_len(passed, layout.order())
            + difference.map_or(0, |(difference, width)| difference_len(difference, width))
    };
    changes(layout, base, values).map(of_change).sum()
}

fn put_varint(mut value: u32, out: &mut Vec<u8>) {
    while value >= 0x80 {
        out.push(value as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
}

#[cfg(test)]
mod tests {
    use super::super::decode::{SampleDecoder, Taken};
    use super::*;
    use crate::frame::{self, kind};
    use crate::message::{Item, ItemKind, Mode, Subject, Subscription};
    use alloc::string::String;
    use alloc::{format, vec};

    fn layout() -> Layout {
        let item = |kind| Item { addr: 0, kind, mode: Mode::Value };
        let items = vec![item(ItemKind::Bit(0)), item(ItemKind::Unsigned(2)), item(ItemKind::Unsigned(4))];
        Layout::of(&Subscription { id: 5, period: 1, subject: Subject::Variables(items) }).unwrap()
    }

    /// The examples of PROTOCOL.md, section 8.
    #[test]
    fn samples_look_like_this_on_the_line() {
        let mut encoder = Encoder::new(5, layout(), 0, false);
        let mut decoder = SampleDecoder::new(5, layout());
        let mut payload = Vec::new();
        let mut lines = Vec::new();
        for (number, values, whole) in [
            (1000, [1, 300, 70_000], false),
            (1001, [1, 300, 70_000], false),
            (1003, [0, 300, 69_990], false),
            (1004, [0, 0x8000, 0x8000_0000], false),
            (1030, [0, 0xFFFF, 0xFFFF_FFFF], true),
        ] {
            encoder.encode(number, number - 600, &values, whole, &mut payload);
            let mut bytes = Vec::new();
            frame::encode(kind::STREAM, number as u8, &payload, &mut bytes);
            let hex =
                |bytes: &[u8]| bytes.iter().map(|b| format!("{b:02x}")).collect::<Vec<String>>().join(" ");
            lines.push(format!("{number}: {}: {}", hex(&payload), hex(&bytes)));
            let Taken::Sample { sample, .. } = decoder.take(number as u8, &payload) else {
                panic!("{number}")
            };
            assert_eq!(
                (sample.number, sample.cycle, &sample.values[..]),
                (number, number - 600, &values[..])
            );
            encoder.confirmed(1000);
        }
        assert_eq!(
            lines,
            [
                "1000: af e8 07 90 03 c4 b1 08 8b 80: 11 85 e8 af e8 07 90 03 c4 b1 08 8b 80 7b 3e d6 ae 00",
                "1001: b3 80: 09 85 e9 b3 80 1d c2 2a 81 00",
                "1003: b3 85 44 4c: 0b 85 eb b3 85 44 4c d1 f7 36 da 00",
                "1004: a3 40 00 40 00 00 00 00: 05 85 ec a3 40 02 40 01 01 01 05 51 a7 5b 25 00",
                "1030: ac 86 08 ae 03 02 04: 0e 85 06 ac 86 08 ae 03 02 04 8a 54 82 aa 00",
            ]
        );
    }
}
