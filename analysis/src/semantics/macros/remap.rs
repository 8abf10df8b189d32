//! From lines of an expansion to own lines: a mistake in an expansion is shown at the call, with the line of the
//! definition beside it.

use super::expand::Expansion;
use super::without_marks;
use crate::diagnostics::{Anchor, Finding};
use crate::semantics::analysis::SectionAnalysis;
use crate::semantics::reference::{Reference, ReferenceAccess};

/// A finding at a line of an expansion as one of the section.
pub(crate) fn finding(expansion: &Expansion<'_>, mut finding: Finding) -> Finding {
    let at = finding.line;
    for (anchor, note) in &mut finding.related {
        if let Anchor::Own { line, columns } = anchor {
            let Some(origin) = expansion.origins.get(*line as usize) else { continue };
            *anchor = match &origin.body {
                None => Anchor::Own { line: origin.own, columns: columns.clone() },
                Some(_) => Anchor::Expanded { line: *line, columns: columns.clone() },
            };
        }
        *note = without_marks(note);
    }
    let Some(origin) = expansion.origins.get(at as usize) else { return finding };
    finding.line = origin.own;
    if origin.body.is_none() {
        if let Some((_, edits)) = &mut finding.fix {
            for (line, ..) in edits {
                *line = expansion.origins.get(*line as usize).map_or(*line, |origin| origin.own);
            }
        }
        return finding;
    }
    finding.fix = None;
    finding.message = without_marks(&finding.message);
    let mut step = Some((at, finding.columns.clone()));
    finding.columns = expansion.shown(at, &finding.columns);
    while let Some((line, columns)) = step {
        let body = expansion.origins.get(line as usize).and_then(|origin| origin.body.as_ref());
        let Some(call) = body.and_then(|body| expansion.calls.get(body.call as usize)) else { break };
        let note = format!("this line of the macro {}", call.word);
        finding.related.push((Anchor::Expanded { line, columns }, note));
        step = Some((call.line, call.columns.clone()));
    }
    finding
}

/// An analysis over the lines of an expansion as one of the section.
pub(crate) fn analysis(expansion: &Expansion<'_>, found: SectionAnalysis) -> SectionAnalysis {
    let own = |line: u32| expansion.origins.get(line as usize).map_or(line, |origin| origin.own);
    let mut mapped = SectionAnalysis {
        findings: found.findings.into_iter().map(|it| finding(expansion, it)).collect(),
        ..SectionAnalysis::default()
    };
    mapped.body = found.body;
    for statement in &mut mapped.body.statements {
        statement.line = own(statement.line);
    }
    for mut overrun in found.overruns {
        let line = overrun.line;
        let expanded = expansion.origins.get(line as usize).is_some_and(|origin| origin.body.is_some());
        overrun.expanded = expanded.then(|| (line, overrun.columns.clone()));
        overrun.columns = expansion.shown(line, &overrun.columns);
        overrun.line = own(line);
        mapped.overruns.push(overrun);
    }
    for mut used in found.identifiers {
        used.columns = expansion.shown(used.line, &used.columns);
        used.line = own(used.line);
        mapped.identifiers.push(used);
    }
    for mut record in found.records {
        record.columns = expansion.shown(record.line, &record.columns);
        record.line = own(record.line);
        mapped.records.push(record);
    }
    for mut device in found.devices {
        device.columns = expansion.shown(device.line, &device.columns);
        device.line = own(device.line);
        mapped.devices.push(device);
    }
    for (key, line, columns) in found.calls {
        let columns = expansion.shown(line, &columns);
        mapped.calls.push((key, own(line), columns));
    }
    for reference in found.references {
        // What a body writes is a use in the definition.
        let Some((spot, columns)) = expansion.written(reference.line, &reference.columns) else { continue };
        if spot.definition.is_none() {
            add(&mut mapped.references, Reference { line: spot.line, columns, ..reference });
        }
    }
    mapped.references.sort_by_key(|reference| reference.line);
    mapped
}

/// An operand of a call is one use, however often the expansion has it.
fn add(references: &mut Vec<Reference>, new: Reference) {
    let same = references
        .iter_mut()
        .rev()
        .take_while(|known| known.line == new.line)
        .find(|known| known.columns == new.columns && known.referent == new.referent);
    match same {
        Some(known) if known.access != new.access => {
            use ReferenceAccess::{Read, ReadWrite, Write};
            known.access = match (known.access, new.access) {
                (Read | ReadWrite, Write | ReadWrite) | (Write | ReadWrite, Read) | (Write, ReadWrite) => {
                    ReadWrite
                }
                (first, _) => first,
            };
        }
        Some(_) => {}
        None => references.push(new),
    }
}
