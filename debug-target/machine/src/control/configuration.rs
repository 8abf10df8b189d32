//! Configuration parameters and constants (manual 16).

use technol_image::op::Addr;
use technol_image::service::Service;
use technol_runtime::{Call, FaultKind};

use super::data::{Content, ControlData, Value, ValueKind};
use super::operand;

/// `CNF_GET_`: RLO tells whether there is the parameter. Without it the target gets the default, or stays.
pub(super) fn parameter(data: &ControlData, call: &mut Call<'_>) -> Result<(), FaultKind> {
    let id = call.text(1)?.unwrap_or_default();
    let found = data.parameters.get(id).and_then(|value| converted(value, call.service()));
    call.set_rlo(found.is_some());
    match found {
        Some(content) => operand::store(call, 0, content),
        None if call.is_given(2) => default(call),
        None => Ok(()),
    }
}

/// CONST_GET: the constant in the cell and in DR.
pub(super) fn constant(data: &ControlData, call: &mut Call<'_>) -> Result<(), FaultKind> {
    let found = data.constants.get(call.text(1)?.unwrap_or_default()).copied();
    call.set_rlo(found.is_some());
    call.set_dr(found.unwrap_or(0));
    match found {
        Some(value) => call.store(0, value),
        None => Ok(()),
    }
}

/// Type that an instruction is about.
fn kind(service: Service) -> ValueKind {
    match service {
        Service::CnfGetReal => ValueKind::Real,
        Service::CnfGetStr => ValueKind::Text,
        Service::CnfGetBin => ValueKind::Bytes,
        _ => ValueKind::Int,
    }
}

/// The parameter as the instruction wants it: numbers are converted, of another type there is no such parameter.
fn converted(value: &Value, service: Service) -> Option<Content<'_>> {
    Some(match (kind(service), value) {
        (ValueKind::Int, Value::Real(value)) => Content::Int(rounded(*value)),
        (ValueKind::Real, Value::Int(value)) => Content::Real(*value as f64),
        (kind, value) if value.kind() == kind => value.content(),
        _ => return None,
    })
}

/// The target gets the default at operand 2.
fn default(call: &mut Call<'_>) -> Result<(), FaultKind> {
    let kind = kind(call.service());
    let content = match kind {
        ValueKind::Int => Content::Int(operand::integer(call, 2)?),
        ValueKind::Real => Content::Real(operand::real(call, 2)?),
        ValueKind::Text | ValueKind::Bytes => {
            let Some((addr, room)) = call.area(0)? else { return Ok(()) };
            let text = kind == ValueKind::Text;
            let room = (room as usize).saturating_sub(usize::from(text));
            let len = if text { call.text(2)?.unwrap_or_default() } else { call.content(2)? }.len().min(room);
            call.bytes(addr, len as u32 + u32::from(text))?;
            call.copy(addr, 2, len)?;
            return if text { call.write(addr + len as Addr, &[0]) } else { Ok(()) };
        }
    };
    operand::store(call, 0, content)
}

/// Halves go away from zero.
fn rounded(value: f64) -> i64 {
    let whole = value as i64;
    let rest = value - whole as f64;
    if rest >= 0.5 {
        whole.saturating_add(1)
    } else if rest <= -0.5 {
        whole.saturating_sub(1)
    } else {
        whole
    }
}
