//! COM_ instructions against the serial ports of the files.

use super::Configured;
use crate::configuration::ConfigKind;
use crate::configuration::uses::SectionUses;
use crate::diagnostics::rules::configuration as rules;
use crate::diagnostics::{Anchor, Finding};

/// Looks at the serial ports of a section.
pub(super) fn check(uses: &SectionUses, configured: &Configured, findings: &mut Vec<Finding>) {
    if !configured.complete.contains(&ConfigKind::Channel) {
        return;
    }
    for it in &uses.ports {
        let known = configured.ports.get(&it.number);
        let message = match known {
            None => format!("no ComChannel has No=\"{}\"", it.number),
            Some(port) if !port.it.active => format!("the ComChannel {} is not active", it.number),
            Some(_) => continue,
        };
        let mut finding =
            Finding::new(&rules::UNKNOWN_PORT, it.place.line, it.place.columns.clone(), message);
        if let Some(port) = known {
            finding.related.push((Anchor::Place(port.place.clone()), "defined here".to_string()));
        }
        findings.push(finding);
    }
}
