//! Voltages between control and machine.

use alloc::vec::Vec;

use technol_image::system::devices::ANALOG_CHANNELS;

/// Analogue outputs of axes and spindles (ANALOG_PORT).
const PORTS: usize = 16;
/// Value of such an output at 10 V.
const FULL: f64 = 32767.0;

/// An analogue output that something in the machine looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AnalogOutput {
    /// Of ANALOG_OUTPUT_PHYSICAL, from 0.
    Physical(u8),
    /// Of ANALOG_PORT, from 0.
    Port(u8),
}

/// What the machine sees of the analogue outputs, in volts.
#[derive(Clone, Debug)]
pub(crate) struct Volts {
    physical: [f64; ANALOG_CHANNELS as usize],
    ports: [f64; PORTS],
}

impl Default for Volts {
    fn default() -> Volts {
        Volts { physical: [0.0; ANALOG_CHANNELS as usize], ports: [0.0; PORTS] }
    }
}

impl Volts {
    pub(crate) fn of(&self, output: AnalogOutput) -> f64 {
        let found = match output {
            AnalogOutput::Physical(n) => self.physical.get(usize::from(n)),
            AnalogOutput::Port(n) => self.ports.get(usize::from(n)),
        };
        found.copied().unwrap_or(0.0)
    }

    /// From the bytes of ANALOG_OUTPUT_PHYSICAL and the values of the ports.
    pub(crate) fn take(&mut self, physical: &[u8], ports: &[i16]) {
        for (volts, bytes) in self.physical.iter_mut().zip(physical.chunks_exact(8)) {
            if let Ok(bytes) = bytes.try_into() {
                *volts = f64::from_le_bytes(bytes);
            }
        }
        for (volts, value) in self.ports.iter_mut().zip(ports) {
            *volts = f64::from(*value) * 10.0 / FULL;
        }
    }
}

/// Voltages of analogue inputs that the machine drives, by channel.
pub(crate) type AnalogInputs = Vec<(u8, f64)>;

/// An analogue output by its name.
pub(crate) fn output(name: &str) -> Option<AnalogOutput> {
    match element(name)? {
        ("analog_output_physical", n) if n < ANALOG_CHANNELS => Some(AnalogOutput::Physical(n)),
        ("analog_port", n) if (1..=PORTS).contains(&usize::from(n)) => Some(AnalogOutput::Port(n - 1)),
        _ => None,
    }
}

/// An analogue input by its name.
pub(crate) fn input(name: &str) -> Option<u8> {
    match element(name)? {
        ("analog_input_physical", n) if n < ANALOG_CHANNELS => Some(n),
        _ => None,
    }
}

/// Something analogue, whether it exists or not.
pub(crate) fn is_meant(name: &str) -> bool {
    name.trim().get(..7).is_some_and(|start| start.eq_ignore_ascii_case("ANALOG_"))
}

fn element(name: &str) -> Option<(&'static str, u8)> {
    let (array, index) = name.trim().strip_suffix(']')?.split_once('[')?;
    let known = ["analog_output_physical", "analog_input_physical", "analog_port"];
    let array = known.into_iter().find(|known| known.eq_ignore_ascii_case(array.trim()))?;
    Some((array, index.trim().parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analogue_channels_are_elements_of_arrays() {
        for (name, expected) in [
            ("ANALOG_OUTPUT_PHYSICAL[0]", Some(AnalogOutput::Physical(0))),
            (" analog_output_physical[ 99 ] ", Some(AnalogOutput::Physical(99))),
            ("ANALOG_OUTPUT_PHYSICAL[100]", None),
            ("ANALOG_PORT[16]", Some(AnalogOutput::Port(15))),
            ("ANALOG_PORT[0]", None),
            ("ANALOG_INPUT_PHYSICAL[1]", None),
            ("ANALOG_OUTPUT_PHYSICAL", None),
        ] {
            assert_eq!(output(name), expected, "{name}");
        }
        assert_eq!(input("ANALOG_INPUT_PHYSICAL[2]"), Some(2));
        assert_eq!(input("P1IN"), None);
    }
}
