//! Licences of the program and the hardware key they are bound to (LDR_LIC, manual 8.4.7).

use technol_runtime::Call;

/// Licences of the program.
const FEATURES: u8 = 10;

/// The key and its licences; at first there is none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Licences {
    connected: bool,
    features: u16,
}

impl Licences {
    /// The hardware key is plugged in.
    pub fn connect_key(&mut self, connected: bool) {
        self.connected = connected;
    }

    /// Whether the key holds the licence `FeaturePlc<number>`, 0 to 9; other numbers do nothing. A licence is
    /// valid while the key is plugged in.
    pub fn set_feature(&mut self, number: u8, held: bool) {
        if number < FEATURES {
            self.features = self.features & !(1 << number) | u16::from(held) << number;
        }
    }

    /// LDR_LIC.
    pub(super) fn load(self, call: &mut Call<'_>) {
        let valid = call.keyword(0).is_some_and(|name| self.holds(name));
        call.set_rlo(valid);
    }

    fn holds(self, name: &str) -> bool {
        if name.eq_ignore_ascii_case("HwKeyConnected") {
            return self.connected;
        }
        let number = name.as_bytes().last().map_or(FEATURES, |digit| digit.wrapping_sub(b'0'));
        self.connected && number < FEATURES && self.features >> number & 1 != 0
    }
}
