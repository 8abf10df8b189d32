//! Identifiers in apostrophes against the elements that the files define.

use super::{Configured, Defined, Definition, logical};
use crate::catalogue::ConfigElement;
use crate::configuration::channel::{ParameterKind, element_name};
use crate::configuration::constants::ConstantValue;
use crate::configuration::uses::{IdentifierUse, SectionUses};
use crate::diagnostics::rules::configuration as rules;
use crate::diagnostics::{Anchor, Finding, Rule};
use crate::semantics::suggest;

const POINTS: [ConfigElement; 4] =
    [ConfigElement::Input, ConfigElement::Output, ConfigElement::AnalogInput, ConfigElement::AnalogOutput];

/// Looks at the identifiers of a section.
pub(super) fn check(uses: &SectionUses, configured: &Configured, findings: &mut Vec<Finding>) {
    for it in &uses.identifiers {
        match it.element {
            ConfigElement::LogicalInput | ConfigElement::LogicalOutput => findings.extend(form(it)),
            ConfigElement::Input
            | ConfigElement::Output
            | ConfigElement::AnalogInput
            | ConfigElement::AnalogOutput
            | ConfigElement::Parameter
            | ConfigElement::Constant => findings.extend(named(it, configured)),
            // Columns belong to a table, see `tables`; shared names are defined by the program itself.
            ConfigElement::Table | ConfigElement::Column | ConfigElement::Shared => {}
        }
    }
}

fn finding(it: &IdentifierUse, rule: &'static Rule, message: String) -> Finding {
    Finding::new(rule, it.place.line, it.place.columns.clone(), message)
}

fn named(it: &IdentifierUse, configured: &Configured) -> Option<Finding> {
    if let Some(found) = configured.find(it.element, &it.text) {
        return typed(it, found);
    }
    let others = POINTS.into_iter().filter(|_| POINTS.contains(&it.element));
    for other in others {
        if let Some(found) = configured.find(other, &it.text) {
            let (wanted, is) = (element_name(it.element), element_name(other));
            let message = format!("'{}' is an {is}; {} reads an {wanted}", it.text, it.entry);
            return Some(defined_at(finding(it, &rules::IDENTIFIER_TYPE, message), found));
        }
    }
    let kind = Configured::kind_of(it.element)?;
    if !configured.complete.contains(&kind) {
        return None;
    }
    let near = suggest::nearest(&it.text, configured.identifiers(it.element));
    let (what, extension) = (element_name(it.element), kind.extensions()[0]);
    match near {
        Some(near) => {
            let message = format!("no {what} '{}' is configured; did you mean '{near}'?", it.text);
            let title = format!("write '{near}'");
            let finding = finding(it, &rules::UNKNOWN_IDENTIFIER, message);
            Some(finding.replace(title, it.place.columns.clone(), format!("'{near}'")))
        }
        None if it.has_default => None,
        None => {
            let message = format!("no *.{extension} of the project defines a {what} '{}'", it.text);
            Some(finding(it, &rules::UNKNOWN_IDENTIFIER, message))
        }
    }
}

/// The element is there; it must be of the type the instruction reads, and fit its cell.
fn typed(it: &IdentifierUse, found: &Definition<Defined>) -> Option<Finding> {
    let value = match &found.it {
        Defined::Point(_) => return None,
        Defined::Parameter(parameter) => {
            let kind = parameter.kind?;
            let wanted = match it.entry {
                "CNF_GET_INT" | "CNF_GET_BIT" => ParameterKind::Int,
                "CNF_GET_REAL" => ParameterKind::Real,
                "CNF_GET_STR" => ParameterKind::String,
                "CNF_GET_BIN" => ParameterKind::Binary,
                _ => return None,
            };
            if kind != wanted {
                let (is, entry) = (kind.name(), it.entry);
                let message = format!("'{}' has the type {is}; {entry} reads {}", it.text, wanted.name());
                return Some(defined_at(finding(it, &rules::IDENTIFIER_TYPE, message), found));
            }
            parameter.value.integer()
        }
        Defined::Constant(constant) => match constant.value {
            ConstantValue::Number(number) => Some(number),
            ConstantValue::Automatic(_) | ConstantValue::Wrong => None,
        },
    }?;
    let bits = it.width.filter(|width| *width < 8)? * 8;
    if (-(1 << (bits - 1))..(1 << bits)).contains(&value) {
        return None;
    }
    let message = format!("'{}' is {value}, which does not fit the {bits} bits of the cell", it.text);
    Some(defined_at(finding(it, &rules::CONSTANT_TOO_WIDE, message), found))
}

fn defined_at(mut finding: Finding, found: &Definition<Defined>) -> Finding {
    finding.related.push((Anchor::Place(found.place.clone()), "defined here".to_string()));
    finding
}

/// A group in front or an index at the end, which connections add.
fn form(it: &IdentifierUse) -> Option<Finding> {
    let end = logical::end(&it.text);
    let (message, text) = if end.group.element().is_some() {
        let group = &it.text[..it.text.len() - end.name.len()];
        (format!("the group {group} is added by connections; write '{}'", end.name), end.name.to_string())
    } else {
        let normal = logical::normal(&it.text);
        logical::without_index(&normal)?;
        let text = it.text[..it.text.rfind('[')?].to_string();
        (format!("an index at the end is one of a connection; write '{text}'"), text)
    };
    let columns = it.place.columns.clone();
    Some(finding(it, &rules::IDENTIFIER_FORM, message).replace(
        format!("write '{text}'"),
        columns,
        format!("'{text}'"),
    ))
}
