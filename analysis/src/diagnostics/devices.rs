//! Mistakes with devices that only the whole project shows: records of two bytes, the steps of a positioning.

use super::Finding;
use super::rules::lints as rules;
use crate::database::{self, Db, Project};
use crate::semantics::analysis::{Device, DeviceUse, Record, SectionAnalysis};
use crate::semantics::declarations::What;

/// The findings of a section.
pub(super) fn of_section(db: &dyn Db, project: Project, analysis: &SectionAnalysis) -> Vec<Finding> {
    let mut found: Vec<Finding> = analysis.records.iter().filter_map(|of| record(db, project, of)).collect();
    for used in &analysis.devices {
        device(db, project, used, &mut found);
    }
    found
}

/// A record of two bytes whose second byte is not declared behind the first.
fn record(db: &dyn Db, project: Project, record: &Record) -> Option<Finding> {
    let site = database::sites(db, project).get(&record.symbol)?.first()?;
    let declarations = database::section_declarations(db, site.section);
    let (What::Cell { storage } | What::Area { storage } | What::Text { storage: Some(storage), .. }) =
        declarations.names.get(site.index as usize)?.what
    else {
        return None;
    };
    let behind = match declarations.storage.get(storage as usize + 1).map(|storage| storage.len) {
        // A length of 0 comes from constants of other sections.
        Some(0 | 1) => return None,
        Some(len) => format!("a cell of {len} bytes"),
        None => "nothing".to_string(),
    };
    let (name, instruction) = (&record.symbol.name, record.instruction);
    let message = format!(
        "{instruction} takes two bytes, but behind {name} there is {behind}; declare two DFM in a row"
    );
    let finding = Finding::new(&rules::RECORD_OF_ONE_BYTE, record.line, record.columns.clone(), message);
    Some(finding.declared_at(&record.symbol))
}

/// What a use needs somewhere in the project.
fn device(db: &dyn Db, project: Project, used: &DeviceUse, found: &mut Vec<Finding>) {
    let has = |wanted: fn(&Device) -> bool| database::project_devices(db, project).iter().any(wanted);
    let names = |axis: u8, wanted: fn(u8) -> [Device; 2]| {
        let devices = database::project_devices(db, project);
        [axis, 0].into_iter().flat_map(wanted).any(|device| devices.contains(&device))
    };
    let mut report = |rule, message: String| {
        found.push(Finding::new(rule, used.line, used.columns.clone(), message));
    };
    match used.device {
        // An axis that is not known was reported by itself.
        Device::Mode(0) | Device::Init { axis: 0, .. } => {}
        Device::Mode(axis) => {
            if !names(axis, |axis| [true, false].map(|older| Device::Init { axis, older })) {
                let message = format!("no POS_INIT takes axis {axis}, so nothing is programmed here");
                report(&rules::POSITIONING_INCOMPLETE, message);
            }
            if !names(axis, |axis| [Device::Control(axis); 2]) {
                let message = format!("no POS_CONTROL gives axis {axis} a speed, so it never moves");
                report(&rules::POSITIONING_INCOMPLETE, message);
            }
        }
        // The older manual ends a motion by a second POS_INIT_x.
        Device::Init { axis, older: false } => {
            if !names(axis, |axis| [Device::Reset(axis); 2]) {
                let message = format!("no POS_RESET gives axis {axis} back to the NC");
                report(&rules::POSITIONING_INCOMPLETE, message);
            }
        }
        Device::Analog => {
            if !has(|device| *device == Device::Port) {
                let message = "no ANALOG_PORT of the project chooses an output, so this changes none";
                report(&rules::ANALOG_WITHOUT_PORT, message.to_string());
            }
        }
        Device::Spindle => {
            if has(|device| *device == Device::SimulatedSpeed) {
                let message =
                    "the program simulates the spindle through SIM_SPEED_PT; an axis must not be switched";
                report(&rules::SIMULATED_SPINDLE_SWITCHED, message.to_string());
            }
        }
        Device::Init { .. }
        | Device::Reset(_)
        | Device::Control(_)
        | Device::Port
        | Device::SimulatedSpeed => {}
    }
}
