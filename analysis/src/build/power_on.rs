//! What the control has set in the system region before the program runs.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use technol_image::op::Addr;
use technol_image::program::InitialData;

use crate::catalogue::{self, SystemKind};

/// Values of the predefined symbols at power-on, without the zeros, in the order of their addresses.
static POWER_ON: LazyLock<Vec<InitialData>> = LazyLock::new(|| {
    let mut bytes: BTreeMap<Addr, u8> = BTreeMap::new();
    for symbol in catalogue::symbols() {
        let Some(value) = symbol.default.filter(|value| *value != 0) else { continue };
        match symbol.kind {
            SystemKind::Bit { addr, bit } => *bytes.entry(addr).or_default() |= 1 << bit,
            SystemKind::Cell { addr, prefix } => {
                let cell = value.to_le_bytes();
                bytes.extend((addr..).zip(cell.into_iter().take(prefix.bytes() as usize)));
            }
            // Only bits and cells have a value; a test of the catalogue holds that.
            _ => {}
        }
    }
    let mut initial: Vec<InitialData> = Vec::new();
    for (addr, byte) in bytes {
        match initial.last_mut() {
            Some(last) if last.addr as usize + last.bytes.len() == addr as usize => last.bytes.push(byte),
            _ => initial.push(InitialData { addr, bytes: vec![byte] }),
        }
    }
    initial
});

/// The values of the system region at power-on, followed by those of the program.
pub(super) fn with_power_on(of_program: &[InitialData]) -> Vec<InitialData> {
    POWER_ON.iter().chain(of_program).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at_power_on(addr: Addr) -> u8 {
        let holds = |data: &&InitialData| addr >= data.addr && addr < data.addr + data.bytes.len() as Addr;
        POWER_ON.iter().find(holds).map_or(0, |data| data.bytes[(addr - data.addr) as usize])
    }

    #[test]
    fn bits_and_cells_have_their_values() {
        for symbol in catalogue::symbols() {
            let Some(value) = symbol.default else { continue };
            let found = match symbol.kind {
                SystemKind::Bit { addr, bit } => i64::from(at_power_on(addr) >> bit & 1),
                SystemKind::Cell { addr, prefix } => {
                    (0..prefix.bytes()).map(|byte| i64::from(at_power_on(addr + byte)) << (8 * byte)).sum()
                }
                other => panic!("{}: {other:?}", symbol.name),
            };
            assert_eq!(found, value, "{}", symbol.name);
        }
    }

    #[test]
    fn the_values_of_the_program_come_last() {
        let own = InitialData { addr: 0x9000, bytes: vec![7] };
        let all = with_power_on(std::slice::from_ref(&own));
        assert_eq!(all.last(), Some(&own));
        assert!(all.len() > 1);
    }
}
