//! From samples to values. What cannot be relied on is never shown as if it could.

use alloc::vec::Vec;

use super::Sample;
use super::bits::BitReader;
use super::encode::{NUMBER_BITS, ON_WHOLE, PLAIN, WHOLE, WHOLE_ORDER};
use super::layout::Layout;

/// Numbers told by their low bits repeat after so many.
const REPEAT: u32 = 1 << (8 + NUMBER_BITS);

#[derive(Clone, Debug)]
struct Known {
    number: u32,
    values: Vec<u64>,
}

/// What became of a frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Taken {
    /// A sample. `full`: it told number and cycle in full.
    Sample {
        /// What it says.
        sample: Sample,
        /// Its number is worth confirming.
        full: bool,
    },
    /// One that is known already, or older.
    Old,
    /// Frames are missing: nothing is certain until a whole sample comes.
    Gap,
}

/// Reads the samples of one stream.
#[derive(Clone, Debug)]
pub struct SampleDecoder {
    id: u8,
    layout: Layout,
    last: Option<Known>,
    whole: Option<Known>,
    /// Number less cycle.
    distance: u32,
}

impl SampleDecoder {
    /// For the frames of the stream with this number.
    #[must_use]
    pub fn new(id: u8, layout: Layout) -> Self {
        SampleDecoder { id, layout, last: None, whole: None, distance: 0 }
    }

    /// After so long a silence the low bits of a number say nothing any more.
    pub fn forget(&mut self) {
        self.last = None;
        self.whole = None;
    }

    /// Takes the payload of a frame of this stream; `seq` is that of the frame.
    pub fn take(&mut self, seq: u8, payload: &[u8]) -> Taken {
        self.read(seq, payload).unwrap_or(Taken::Gap)
    }

    fn read(&mut self, seq: u8, payload: &[u8]) -> Option<Taken> {
        let (&head, mut rest) = payload.split_first()?;
        let form = head >> 3 & 3;
        let full = head & 4 != 0;
        let low = u32::from(head & ((1 << NUMBER_BITS) - 1)) << 8 | u32::from(seq);
        let last = self.last.as_ref().map(|l| l.number);
        let (number, distance) = if full {
            let number = take_varint(&mut rest)?;
            let cycle = take_varint(&mut rest)?;
            if number % REPEAT != low {
                return None;
            }
            (number, number.wrapping_sub(cycle))
        } else {
            let ahead = low.wrapping_sub(last?) % REPEAT;
            if ahead == 0 || ahead > REPEAT / 2 {
                return Some(Taken::Old);
            }
            (last?.wrapping_add(ahead), self.distance)
        };
        // The very sample that is known may be told again, whole; anything else that is not newer was late.
        let newer = last.map_or(1, |l| number.wrapping_sub(l) as i32);
        if newer < 0 || newer == 0 && form > WHOLE {
            return Some(Taken::Old);
        }
        let mut reader = BitReader::new(rest);
        let window = if self.layout.has_extremes() { reader.take_golomb(0)? } else { 0 };
        let values = self.values(form, number, &mut reader)?;
        if !reader.is_done() {
            return None;
        }
        self.distance = distance;
        let contiguous = last.is_none_or(|l| number.wrapping_sub(window) == l);
        let known = Known { number, values };
        if form == PLAIN || form == WHOLE {
            self.whole = Some(known.clone());
        }
        let values = known.values.clone();
        self.last = Some(known);
        let cycle = number.wrapping_sub(distance);
        Some(Taken::Sample {
            sample: Sample { id: self.id, number, cycle, values, window, contiguous },
            full,
        })
    }

    fn values(&self, form: u8, number: u32, reader: &mut BitReader<'_>) -> Option<Vec<u64>> {
        let widths = self.layout.widths();
        match form {
            PLAIN => widths.iter().map(|w| reader.take(u32::from(*w))).collect(),
            WHOLE => widths
                .iter()
                .map(|w| if *w == 1 { reader.take(1) } else { reader.take_difference(*w) })
                .collect(),
            _ => {
                let (base, order) =
                    if form == ON_WHOLE { (&self.whole, WHOLE_ORDER) } else { (&self.last, 0) };
                let from = number.wrapping_sub(reader.take_golomb(order)?).wrapping_sub(1);
                let base = base.as_ref().filter(|b| b.number == from)?;
                let mut values = base.values.clone();
                self.change(&mut values, reader)?;
                Some(values)
            }
        }
    }

    fn change(&self, values: &mut [u64], reader: &mut BitReader<'_>) -> Option<()> {
        let order = self.layout.order();
        let mut at = 0_usize;
        while !reader.is_done() {
            at = at.checked_add(reader.take_golomb(order)? as usize)?;
            let (value, width) = (values.get_mut(at)?, *self.layout.widths().get(at)?);
            let difference = if width == 1 { 1 } else { reader.take_difference(width)? };
            *value = self.layout.clip(at, value.wrapping_add(difference));
            at += 1;
        }
        Some(())
    }
}

fn take_varint(bytes: &mut &[u8]) -> Option<u32> {
    let mut value = 0_u64;
    for shift in [0, 7, 14, 21, 28] {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        value |= u64::from(byte & 0x7F) << shift;
        if byte < 0x80 {
            return u32::try_from(value).ok();
        }
    }
    None
}
