//! Process images and the copies between them and the port cells (manual 9; forcing masks by ruling: force
//! to 0 wins over force to 1).

use technol_image::op::Addr;
use technol_image::system;

use crate::memory::Memory;

/// Input ports P1IN … P128IN, as sensed.
pub type InputImage = [u8; system::IN_PORT_COUNT as usize];
/// Output ports P0OUT … P95OUT, as driven.
pub type OutputImage = [u8; system::OUT_PORT_COUNT as usize];

fn forced(memory: &Memory, value: u8, low: Addr, high: Addr) -> u8 {
    (value | memory.byte(high)) & !memory.byte(low)
}

/// One input port into memory; `port` 0 is P1IN.
pub(crate) fn copy_input(memory: &mut Memory, inputs: &InputImage, port: usize) {
    let n = port as Addr;
    let value = forced(memory, inputs[port], system::IN_FORCE_LOW + n, system::IN_FORCE_HIGH + n);
    memory.set_byte(system::IN_PORTS + n, value);
}

/// All input ports into memory.
pub(crate) fn copy_inputs(memory: &mut Memory, inputs: &InputImage) {
    for port in 0..inputs.len() {
        copy_input(memory, inputs, port);
    }
}

/// One output port out of memory; `port` 0 is P0OUT. A driven output that is `shorted` sets its bit of
/// ERRLI_P0OUT …; it stays off until the program clears that bit (manual 9.3).
pub(crate) fn copy_output(
    memory: &mut Memory,
    outputs: &mut OutputImage,
    shorted: &OutputImage,
    port: usize,
) {
    let n = port as Addr;
    let value = memory.byte(system::OUT_PORTS + n);
    let driven = forced(memory, value, system::OUT_FORCE_LOW + n, system::OUT_FORCE_HIGH + n);
    let errors = memory.byte(system::OUT_SHORTED + n) | driven & shorted[port];
    memory.set_byte(system::OUT_SHORTED + n, errors);
    outputs[port] = driven & !errors;
}

/// All output ports out of memory.
pub(crate) fn copy_outputs(memory: &mut Memory, outputs: &mut OutputImage, shorted: &OutputImage) {
    for port in 0..outputs.len() {
        copy_output(memory, outputs, shorted, port);
    }
}
