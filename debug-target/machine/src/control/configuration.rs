//! Configuration parameters and constants (manual 16).

use technol_image::service::Service;
use technol_runtime::{Call, FaultKind};

use super::data::{ControlData, Value, ValueKind};
use super::operand;

/// `CNF_GET_`: RLO tells whether there is the parameter. Without it the target gets the default, or stays.
pub(super) fn parameter(data: &ControlData, call: &mut Call<'_>) -> Result<(), FaultKind> {
    let id = call.text(1)?.unwrap_or_default();
    let found = data.parameters.get(id).and_then(|value| converted(value, call.service()));
    call.set_rlo(found.is_some());
    let value = match found {
        Some(value) => value,
        None if call.is_given(2) => default(call)?,
        None => return Ok(()),
    };
    operand::store(call, 0, &value)
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
fn converted(value: &Value, service: Service) -> Option<Value> {
    Some(match (kind(service), value) {
        (ValueKind::Int, Value::Real(value)) => Value::Int(rounded(*value)),
        (ValueKind::Real, Value::Int(value)) => Value::Real(*value as f64),
        (kind, value) if value.kind() == kind => value.clone(),
        _ => return None,
    })
}

fn default(call: &Call<'_>) -> Result<Value, FaultKind> {
    Ok(match kind(call.service()) {
        ValueKind::Int => Value::Int(operand::integer(call, 2)?),
        ValueKind::Real => Value::Real(operand::real(call, 2)?),
        ValueKind::Text => Value::Text(call.text(2)?.unwrap_or_default().to_vec()),
        ValueKind::Bytes => Value::Bytes(call.content(2)?.to_vec()),
    })
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
