//! Bits of ports that are held at a value: the masks SETL_… and SETH_… (manual 9.3). What is forced to 0 and to 1 is 0.

use std::collections::BTreeSet;

use technol_image::op::{Addr, Width};
use technol_image::system;

use crate::memory::MemoryView;
use crate::ports::{Ports, is_output, is_port};
use crate::tree::Shown;

/// First byte of all masks, which lie behind each other.
pub(crate) const MASKS: Addr = system::IN_FORCE_LOW;
/// Bytes of all masks.
pub(crate) const MASKS_LEN: u32 = system::OUT_SHORTED - system::IN_FORCE_LOW;

/// Some bits of one port: one of them, or all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PortBits {
    pub(crate) port: Addr,
    pub(crate) mask: u8,
}

impl PortBits {
    /// The bits by their numbers.
    pub(crate) fn numbers(self) -> impl Iterator<Item = u8> {
        (0..8).filter(move |bit| self.mask >> bit & 1 == 1)
    }
}

/// A bit that is forced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Forced {
    pub(crate) port: Addr,
    pub(crate) bit: u8,
    pub(crate) value: bool,
    /// Both masks say so.
    pub(crate) both: bool,
}

/// Where the masks of a port are: force to 0, force to 1.
pub(crate) fn masks(port: Addr) -> Option<(Addr, Addr)> {
    if !is_port(port) {
        return None;
    }
    Some(if is_output(port) {
        let n = port - system::OUT_PORTS;
        (system::OUT_FORCE_LOW + n, system::OUT_FORCE_HIGH + n)
    } else {
        let n = port - system::IN_PORTS;
        (system::IN_FORCE_LOW + n, system::IN_FORCE_HIGH + n)
    })
}

/// Bits or byte of a port that are shown.
pub(crate) fn port_of(shown: &Shown) -> Option<PortBits> {
    let bits = match *shown {
        Shown::Bit { addr, bit } => PortBits { port: addr, mask: 1 << (bit & 7) },
        Shown::Cell { addr, width: Width::Byte } => PortBits { port: addr, mask: 0xFF },
        _ => return None,
    };
    is_port(bits.port).then_some(bits)
}

/// The port behind something that has a name: the port itself, or the one it is copied from or to.
pub(crate) fn behind(ports: &Ports, shown: &Shown) -> Result<PortBits, String> {
    if let Some(bits) = port_of(shown) {
        return Ok(bits);
    }
    let found: BTreeSet<(Addr, u8)> = match *shown {
        Shown::Bit { addr, bit } => ports.copies.get(&(addr, bit)).cloned().unwrap_or_default(),
        Shown::Cell { addr, width: Width::Byte } => {
            // A byte stands for a port when it is copied as a whole.
            let of_bit =
                |bit: u8| ports.copies.get(&(addr, bit)).into_iter().flatten().map(move |c| (bit, *c));
            let copies: Vec<(u8, (Addr, u8))> = (0..8).flat_map(of_bit).collect();
            let whole = |port: Addr| (0..8).all(|bit| copies.contains(&(bit, (port, bit))));
            copies.iter().map(|(_, (port, _))| (*port, 0)).filter(|(port, _)| whole(*port)).collect()
        }
        _ => BTreeSet::new(),
    };
    let is_bit = matches!(shown, Shown::Bit { .. });
    let spelled = |(port, bit): &(Addr, u8)| {
        if is_bit { format!("{}.{bit}", ports.name(*port)) } else { ports.name(*port) }
    };
    let mut found = found.iter();
    match (found.next(), found.next()) {
        (Some(&(port, bit)), None) => Ok(PortBits { port, mask: if is_bit { 1 << bit } else { 0xFF } }),
        (None, _) => Err("is not a bit or byte of a port, nor a copy of one: only ports can be forced; \
                          `NAME = VALUE` sets anything once"
            .into()),
        (Some(one), Some(two)) => {
            let more = if found.next().is_some() { " and others" } else { "" };
            let (one, two) = (spelled(one), spelled(two));
            Err(format!("is copied from or to {one}, {two}{more}; force the one you mean"))
        }
    }
}

/// The port behind something, with its masks: what is forced of a port is shown of its only copy, too.
pub(crate) fn forcible(ports: &Ports, shown: &Shown) -> Option<(PortBits, (Addr, Addr))> {
    let bits = behind(ports, shown).ok()?;
    Some((bits, masks(bits.port)?))
}

/// Whether something is a bit that can be forced.
pub(crate) fn is_on_port(ports: &Ports, shown: &Shown) -> bool {
    matches!(shown, Shown::Bit { .. }) && behind(ports, shown).is_ok()
}

/// What all masks say; `block` is what lies at [`MASKS`].
pub(crate) fn forced(block: &[u8]) -> Vec<Forced> {
    let inputs = system::IN_PORTS..system::IN_PORTS + system::IN_PORT_COUNT;
    let outputs = system::OUT_PORTS..system::OUT_PORTS + system::OUT_PORT_COUNT;
    let byte = |addr: Addr| block.get((addr - MASKS) as usize).copied().unwrap_or(0);
    let of_port = |port: Addr| {
        let (low, high) = masks(port).map_or((0, 0), |(low, high)| (byte(low), byte(high)));
        of_masks(port, low, high)
    };
    inputs.chain(outputs).flat_map(of_port).collect()
}

fn of_masks(port: Addr, low: u8, high: u8) -> impl Iterator<Item = Forced> {
    let is = |mask: u8, bit: u8| mask >> bit & 1 == 1;
    (0..8_u8).filter(move |bit| is(low | high, *bit)).map(move |bit| Forced {
        port,
        bit,
        value: !is(low, bit),
        both: is(low & high, bit),
    })
}

/// Which of some bits of a port the masks of that port force.
pub(crate) fn forced_of(bits: PortBits, low: u8, high: u8) -> Vec<Forced> {
    of_masks(bits.port, low & bits.mask, high & bits.mask).collect()
}

/// The value as it is shown, with what is forced of it. It can still be typed back.
pub(crate) fn marked(ports: &Ports, shown: &Shown, memory: &MemoryView, text: String) -> String {
    let Some((bits, (low, high))) = forcible(ports, shown) else { return text };
    let mask = |addr: Addr| memory.number(addr, 1) as u8;
    let forced = forced_of(bits, mask(low), mask(high));
    with_mark(text, bits.mask == 0xFF, &forced)
}

/// A value with what is forced of it; `whole`: it is a port and not one of its bits.
pub(crate) fn with_mark(text: String, whole: bool, forced: &[Forced]) -> String {
    let Some(first) = forced.first() else { return text };
    if whole {
        let list: Vec<String> = forced.iter().map(|f| format!(".{}={}", f.bit, u8::from(f.value))).collect();
        return format!("{text} (forced {})", list.join(" "));
    }
    match *first {
        Forced { both: true, .. } => format!("{text} (forced to 0, which wins over forced to 1)"),
        Forced { value, .. } if text == value.to_string() => format!("{text} (forced)"),
        Forced { value, .. } => format!("{text} (forced to {})", u8::from(value)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{sample, values};

    #[test]
    fn masks_belong_to_their_ports() {
        assert_eq!(masks(system::IN_PORTS + 127), Some((0x15F, 0x1DF)));
        assert_eq!(masks(system::OUT_PORTS), Some((0x1E0, 0x240)));
        assert_eq!(masks(system::OUT_PORTS + 95), Some((0x23F, 0x29F)));
        assert_eq!(masks(system::OUT_PORTS + 96), None);
        assert_eq!(MASKS_LEN, 448);
    }

    #[test]
    fn zero_wins_over_one() {
        let mut block = vec![0; MASKS_LEN as usize];
        block[0] = 0b011;
        block[(system::IN_FORCE_HIGH - MASKS) as usize] = 0b110;
        block[(system::OUT_FORCE_HIGH - MASKS) as usize + 95] = 0x80;
        let seen: Vec<_> = forced(&block).iter().map(|f| (f.port, f.bit, f.value, f.both)).collect();
        let last = system::OUT_PORTS + 95;
        assert_eq!(
            seen,
            [(0, 0, false, false), (0, 1, false, true), (0, 2, true, false), (last, 7, true, false)]
        );
        assert_eq!(forced(&[]), []);
    }

    #[test]
    fn what_is_forced_is_marked_and_can_be_typed_back() {
        let bit = |bit: u8| Shown::Bit { addr: system::OUT_PORTS, bit };
        let byte = Shown::Cell { addr: system::OUT_PORTS, width: Width::Byte };
        let word = Shown::Cell { addr: system::OUT_PORTS, width: Width::Word };
        let mut memory = MemoryView::default();
        memory.add(&[(system::OUT_FORCE_LOW, 1), (system::OUT_FORCE_HIGH, 1)], &[0b0101, 0b0110]);
        for (shown, text, expected) in [
            (bit(0), "false", "false (forced)"),
            (bit(0), "true", "true (forced to 0)"),
            (bit(1), "true", "true (forced)"),
            (bit(1), "false", "false (forced to 1)"),
            (bit(2), "true", "true (forced to 0, which wins over forced to 1)"),
            (bit(3), "true", "true"),
            (byte, "5 (05h)", "5 (05h) (forced .0=0 .1=1 .2=0)"),
            (word, "5 (0005h)", "5 (0005h)"),
            (Shown::Bit { addr: sample::INPUTS, bit: 0 }, "true", "true"),
        ] {
            let text = marked(&Ports::default(), &shown, &memory, text.to_owned());
            assert_eq!(text, expected);
            assert!(!values::typed(&text).contains("forced"), "{text}");
        }
    }

    #[test]
    fn copies_are_marked_as_their_port_is() {
        let image = sample::image();
        let ports = crate::ports::used(&image.program, image.debug.as_ref().unwrap());
        let mut memory = MemoryView::default();
        memory.add(&[(system::IN_FORCE_LOW, 1), (system::IN_FORCE_HIGH, 1)], &[1, 0]);
        let marked = |bit| marked(&ports, &Shown::Bit { addr: sample::INPUTS, bit }, &memory, "true".into());
        assert_eq!([marked(0), marked(1)], ["true (forced to 0)", "true"]);
    }

    #[test]
    fn copies_stand_for_their_port_unless_there_are_two() {
        let image = sample::image();
        let mut ports = crate::ports::used(&image.program, image.debug.as_ref().unwrap());
        let copy = |bit| Shown::Bit { addr: sample::INPUTS, bit };
        assert_eq!(behind(&ports, &copy(0)), Ok(PortBits { port: 0, mask: 1 }));
        let output = Shown::Bit { addr: sample::OUTPUTS, bit: 4 };
        assert_eq!(behind(&ports, &output), Ok(PortBits { port: system::OUT_PORTS, mask: 16 }));
        let byte = Shown::Cell { addr: sample::INPUTS, width: Width::Byte };
        assert!(behind(&ports, &byte).unwrap_err().contains("not a bit or byte of a port"));
        for bit in 0..8 {
            ports.copies.entry((sample::INPUTS, bit)).or_default().insert((5, bit));
        }
        assert_eq!(behind(&ports, &byte), Ok(PortBits { port: 5, mask: 0xFF }));
        assert_eq!(
            behind(&ports, &copy(1)).unwrap_err(),
            "is copied from or to P1IN.1, P6IN.1; force the one you mean"
        );
    }
}
