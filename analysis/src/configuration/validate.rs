//! A document against what its kind of file may hold.

use super::document::{Attribute, Document, Element, Text};
use super::kind::ConfigKind;
use super::problem::Problem;
use super::schema::{self, AttributeSpec, ElementSpec, ValueKind};
use crate::diagnostics::rules::configuration as rules;
use crate::semantics::suggest;

/// Unknown elements and attributes, values that do not fit, attributes that are missing.
pub(super) fn validate(kind: ConfigKind, document: &Document, problems: &mut Vec<Problem>) {
    for element in &document.elements {
        let parent = document.parent(element);
        match schema::element(kind, &element.name.text, parent.map(|it| it.name.text.as_str())) {
            Some(spec) => known(spec, element, problems),
            None => unknown(kind, document, element, parent, problems),
        }
    }
}

fn known(spec: &ElementSpec, element: &Element, problems: &mut Vec<Problem>) {
    for given in &element.attributes {
        match spec.attribute(&given.name.text) {
            Some(known) => problems.extend(wrong(&given.name.text, known.value, &given.value)),
            None => problems.extend(unknown_attribute(spec, given)),
        }
    }
    for missing in spec.attributes.iter().filter(|it| it.mandatory) {
        if element.attribute(missing.name).is_none() {
            problems.push(missing_attribute(spec, missing, element));
        }
    }
    match spec.content {
        Some(content) => problems.extend(wrong(spec.name, content, &element.content)),
        None if spec.closed && !element.content.text.is_empty() => {
            let message = format!("{} holds no text", spec.name);
            problems.push(Problem::new(&rules::UNKNOWN_ELEMENT, element.content.span, message));
        }
        None => {}
    }
}

fn missing_attribute(spec: &ElementSpec, missing: &AttributeSpec, element: &Element) -> Problem {
    let message = format!("{} needs the attribute {}: {}", spec.name, missing.name, missing.help.en);
    Problem::new(&rules::MISSING_ATTRIBUTE, element.name.span, message)
}

fn unknown_attribute(spec: &ElementSpec, given: &Attribute) -> Option<Problem> {
    let name = &given.name.text;
    let near = suggest::nearest(name, spec.attributes.iter().map(|it| it.name));
    let message = match near {
        Some(near) => format!("{} has no attribute {name}; did you mean {near}?", spec.name),
        None if spec.closed => format!("{} has no attribute {name}; it has no effect", spec.name),
        None => return None,
    };
    let problem = Problem::new(&rules::UNKNOWN_ATTRIBUTE, given.name.span, message);
    Some(match near {
        Some(near) => problem.replace(near),
        None => problem,
    })
}

/// A value that does not fit.
pub(super) fn wrong(name: &str, kind: ValueKind, value: &Text) -> Option<Problem> {
    let needed = kind.objection(&value.text)?;
    let near = suggest::nearest(value.text.trim(), kind.words().into_iter());
    let message = match near {
        Some(near) => format!("{name} cannot be {}; did you mean {near}?", shown(&value.text)),
        None => format!("{name} cannot be {}; it needs {needed}", shown(&value.text)),
    };
    let problem = Problem::new(&rules::WRONG_CONFIGURATION_VALUE, value.span, message);
    Some(match near {
        Some(near) => problem.replace(near),
        None => problem,
    })
}

fn shown(value: &str) -> String {
    const MOST: usize = 40;
    match value.char_indices().nth(MOST) {
        _ if value.trim().is_empty() => "empty".to_string(),
        Some((cut, _)) => format!("\"{}…\"", &value[..cut]),
        None => format!("\"{value}\""),
    }
}

fn unknown(
    kind: ConfigKind,
    document: &Document,
    element: &Element,
    parent: Option<&Element>,
    problems: &mut Vec<Problem>,
) {
    let name = &element.name.text;
    let Some(parent) = parent else {
        problems.extend(unknown_root(kind, element));
        return;
    };
    let above = document.parent(parent).map(|it| it.name.text.as_str());
    let closed = schema::element(kind, &parent.name.text, above).is_some_and(|spec| spec.closed);
    if !closed {
        return;
    }
    let inside =
        schema::elements(kind).iter().filter(|spec| spec.parents.contains(&parent.name.text.as_str()));
    let near = suggest::nearest(name, inside.map(|spec| spec.name));
    let elsewhere = schema::elements(kind).iter().find(|spec| spec.name == *name);
    let message = match (near, elsewhere) {
        (Some(near), _) => format!("{} holds no {name}; did you mean {near}?", parent.name.text),
        (None, Some(spec)) if !spec.parents.is_empty() => {
            format!("{name} belongs into {}, not into {}", spec.parents.join(" or "), parent.name.text)
        }
        _ => format!("{} holds no {name}; it has no effect", parent.name.text),
    };
    problems.push(Problem::new(&rules::UNKNOWN_ELEMENT, element.name.span, message));
}

/// Files whose root the manual names must have it; the others may have any.
fn unknown_root(kind: ConfigKind, element: &Element) -> Option<Problem> {
    let wanted = match kind {
        ConfigKind::Channel | ConfigKind::Errors => return None,
        ConfigKind::Constants => "PlcConstants",
        ConfigKind::TableDefinition => "PLCTableDef",
        ConfigKind::Table => "PLCTable",
        ConfigKind::Keyboard => "KeyboardConfig",
    };
    let message = format!("a *.{} holds {wanted}, not {}", kind.extensions()[0], element.name.text);
    Some(Problem::new(&rules::UNKNOWN_ELEMENT, element.name.span, message))
}
