//! The example of a controller in Rust, on hardware that a test can look at.

#[allow(unreachable_pub)] // as a crate of its own would have it
#[path = "../../../debug-target/bare/example/controller.rs"]
mod controller;

use allocation_counter::measure;
use technol_runtime::{InputImage, OutputImage, PlcState, RuntimeEvent};

use controller::{Controller, Hardware};

/// Ports, a CAN bus with room for two packets, and what was told.
#[derive(Default)]
struct Desk {
    input: u8,
    outputs: [u8; 2],
    sent: Vec<(i64, Vec<u8>)>,
    told: Vec<RuntimeEvent>,
}

impl Hardware for Desk {
    fn read(&mut self, inputs: &mut InputImage) {
        inputs[0] = self.input;
    }

    fn write(&mut self, outputs: &OutputImage) {
        self.outputs.copy_from_slice(&outputs[..2]);
    }

    fn send(&mut self, channel: i64, packet: &[u8]) -> bool {
        let room = self.sent.len() < 2;
        if room {
            self.sent.push((channel, packet.to_vec()));
        }
        room
    }

    fn tell(&mut self, event: &RuntimeEvent) {
        self.told.push(event.clone());
    }
}

#[test]
fn the_hardware_carries_out_what_it_has_and_the_simulated_control_the_rest() {
    // DR of CAN_SEND, which is 0 as long as there is room, and a ramp of 3 in each cycle.
    let image = crate::from_c::lines(
        " LOD CNST.55h\n STO WORD.PACKET\n CAN_SEND 1,PACKET\n STO P0OUT\n LOD CNST.100\n RAMP DELAY,3\n LOD DELAY\n STO P1OUT",
    );
    let mut controller = Controller::load(&image, Desk::default()).expect("it can be loaded");
    controller.start(true);
    for _ in 0..45 {
        controller.millisecond();
    }
    assert_eq!(controller.runtime().state(), PlcState::Running);
    let [answer, ramp] = controller.hardware().outputs;
    assert!(answer == 1 && ramp > 3 && ramp.is_multiple_of(3), "{answer} {ramp}");
    let sent: Vec<_> =
        controller.hardware().sent.iter().map(|(channel, it)| (*channel, it[0], it.len())).collect();
    assert_eq!(sent, [(1, 0x55, 12), (1, 0x55, 12)]);
    assert!(controller.hardware().told.contains(&RuntimeEvent::StateChanged(PlcState::Running)));
    let asked = measure(|| (0..200).for_each(|_| controller.millisecond()));
    assert_eq!(asked.count_total, 0, "a tick asks for no memory");
}

#[test]
fn a_damaged_image_is_refused_in_words() {
    let refused = Controller::load(b"TPLC", Desk::default()).err();
    assert_eq!(refused.as_deref(), Some("the image is cut short; build it again"));
}
