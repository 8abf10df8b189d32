//! What is wrong on the buses.

use super::SimulatedControl;
use super::messages::message;
use crate::fault::BusFault;

impl SimulatedControl {
    /// Replaces what is wrong. Called in every millisecond; nothing happens without a change.
    pub(crate) fn set_bus_faults(&mut self, faults: &[BusFault]) {
        if self.bus_faults == faults {
            return;
        }
        let cut = |can| {
            faults.contains(&BusFault::CanCut(can)) && !self.bus_faults.contains(&BusFault::CanCut(can))
        };
        for can in [1, 2].into_iter().filter(|can| cut(*can)) {
            self.messages.of_control(message::INTERRUPTED, [Some(i64::from(can)), None, None]);
        }
        self.bus_faults.clear();
        self.bus_faults.extend_from_slice(faults);
        let has = |fault| faults.contains(&fault);
        self.ethercat.set_lost(|place| {
            let cut = |fault: &BusFault| matches!(fault, BusFault::EtherCatCut(first) if *first <= place);
            has(BusFault::SlaveLost(place)) || faults.iter().any(cut)
        });
        self.ethercat.set_error(|place| {
            faults.iter().find_map(|fault| match fault {
                BusFault::SlaveError(own, code) if *own == place => Some(*code),
                _ => None,
            })
        });
        // Drives are on the first channel.
        self.drives.set_lost(|axis| has(BusFault::CanDriveLost(axis)) || has(BusFault::CanCut(1)));
        let error = |axis| {
            faults.iter().find_map(|fault| match fault {
                BusFault::CanDriveError(own, code) if *own == axis => Some(*code),
                _ => None,
            })
        };
        self.drives.set_error(error, &mut self.messages);
        self.can.set_cut(|can| has(BusFault::CanCut(can)));
        self.units.set_cut(|can| has(BusFault::CanCut(can)));
    }
}
