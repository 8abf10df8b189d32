//! Whether a symbol moves, and whether it moves anything.

use technol_analysis::catalogue::SystemKind;

use crate::scene::{Force, Scene, Track};

/// Bits of memory: byte and mask.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bits(Vec<(usize, u8)>);

impl Bits {
    pub(crate) fn with(mut self, other: &Bits) -> Bits {
        self.0.extend(&other.0);
        self
    }

    /// Some of them are set in this mask of the memory.
    pub(crate) fn meets(&self, mask: &[u8]) -> bool {
        self.0.iter().any(|(at, bits)| mask[*at] & bits != 0)
    }

    /// Each with its byte of a value, which is repeated.
    fn given(&self, value: &[u8]) -> Vec<(usize, u8, u8)> {
        self.0.iter().zip(value.iter().cycle()).map(|((at, mask), byte)| (*at, *mask, *byte)).collect()
    }
}

/// The memory of a symbol; `None` when it has none of its own.
pub(crate) fn bits_of(kind: &SystemKind) -> Option<Bits> {
    if let SystemKind::Bit { addr, bit } = *kind {
        return Some(Bits(vec![(addr as usize, 1 << bit)]));
    }
    let (addr, len) = kind.bytes()?;
    Some(Bits((addr..addr + len).map(|at| (at as usize, 0xFF)).collect()))
}

/// Bits of the system region that change in the milliseconds of the scenes, where only the control writes.
pub(crate) fn moved_by_itself(scenes: &[Scene]) -> Vec<u8> {
    let mut all = Vec::new();
    for scene in scenes {
        let moved = scene.run().moved;
        all.resize(moved.len(), 0);
        for (all, moved) in all.iter_mut().zip(moved) {
            *all |= moved;
        }
    }
    all
}

/// Values that are tried: all bits off, all on, and numbers that are neither too small nor too great for cells of every
/// width (6.5 as a real).
const VALUES: [&[u8]; 6] =
    [&[0], &[0xFF], &[1, 0], &[2, 0, 0, 0], &[0xF4, 1, 0, 0], &[0, 0, 0, 0, 0, 0, 0x1A, 0x40]];

/// Something else happens in the scene when these bits have another value all the time, or from its middle on.
pub(crate) fn acts(scene: &Scene, baseline: &Track<'_>, bits: &Bits) -> bool {
    [0, scene.cycles * 10].into_iter().any(|from| {
        VALUES.iter().any(|value| !baseline.is_the_same_with(&Force { from, bits: &bits.given(value) }))
    })
}
