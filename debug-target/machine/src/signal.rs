//! Inputs and outputs as the machine has them.

pub use technol_image::signal::Signal;
use technol_image::system;

/// Bytes of the input image: P1IN … P128IN.
pub const INPUT_PORTS: usize = system::IN_PORT_COUNT as usize;
/// Bytes of the output image: P0OUT … P95OUT.
pub const OUTPUT_PORTS: usize = system::OUT_PORT_COUNT as usize;

/// Inputs as the machine drives them: behind those of the ports lie the bytes of slaves on buses.
pub(crate) type InputImage = [u8; 256];
/// Outputs as the machine sees them: behind those of the ports lie the bytes of slaves on buses.
pub(crate) type OutputImage = [u8; 256];
/// Bytes that slaves may give.
pub(crate) const BUS_INPUTS: usize = 256 - INPUT_PORTS;
/// Bytes that slaves may take.
pub(crate) const BUS_OUTPUTS: usize = 256 - OUTPUT_PORTS;

/// A bit of the input image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InputBit {
    port: u8,
    mask: u8,
}

impl InputBit {
    pub(crate) fn new(port: u8, bit: u8) -> Self {
        InputBit { port, mask: 1 << bit }
    }

    pub(crate) fn set(self, inputs: &mut InputImage, value: bool) {
        let byte = &mut inputs[usize::from(self.port)];
        *byte = if value { *byte | self.mask } else { *byte & !self.mask };
    }
}

/// A bit of the output image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OutputBit {
    port: u8,
    mask: u8,
}

impl OutputBit {
    pub(crate) fn new(port: u8, bit: u8) -> Self {
        OutputBit { port, mask: 1 << bit }
    }

    pub(crate) fn get(self, outputs: &OutputImage) -> bool {
        outputs[usize::from(self.port)] & self.mask != 0
    }

    pub(crate) fn set(self, outputs: &mut OutputImage) {
        outputs[usize::from(self.port)] |= self.mask;
    }

    pub(crate) fn clear(self, outputs: &mut OutputImage) {
        outputs[usize::from(self.port)] &= !self.mask;
    }
}
