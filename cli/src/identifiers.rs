//! Identifiers in a machine file that are the names of symbols: nothing would go through them.

use technol_analysis::expression::{self, Target};
use technol_image::service::{Arg, Service, ServiceCall};
use technol_image::{DebugInfo, Program};
use technol_machine::{ConfigError, MachineConfig};

/// An instruction that declares an element: its cell, then its identifier.
fn declares(call: &ServiceCall) -> bool {
    use Service::{DefIn, DefOut, MapAin, MapAout, MapIn, MapOut};
    matches!(call.service, DefIn | DefOut | MapAin | MapAout | MapIn | MapOut)
}

/// What is wrong with the identifiers of a machine in front of this program. Where the program makes identifiers as it runs, nothing
/// can be said.
pub(crate) fn mistaken(machine: &MachineConfig, program: &Program, debug: &DebugInfo) -> Vec<ConfigError> {
    let declared: Vec<(&Arg, &str)> = program
        .services
        .iter()
        .filter(|call| declares(call))
        .filter_map(|call| match call.args.as_slice() {
            [cell, Arg::Text(text), ..] => Some((cell, std::str::from_utf8(text).ok()?)),
            _ => None,
        })
        .collect();
    if declared.len() < program.services.iter().filter(|call| declares(call)).count() {
        return Vec::new();
    }
    let mut errors = Vec::new();
    for (table, index, key, id) in identifiers(machine) {
        let name = element(id);
        if declared.iter().any(|(_, own)| element(own).eq_ignore_ascii_case(name)) {
            continue;
        }
        let Some(target) = expression::resolve(debug, Some(0), name).ok().filter(has_memory) else {
            continue;
        };
        let own = declared.iter().find(|(cell, _)| is_at(cell, target));
        let what = match own {
            Some((_, own)) => format!("the cell of '{own}'; write {own}"),
            None => "a symbol, and no identifier; declare one for it by DEF_IN or DEF_OUT, or name an element of the \
                     control such as RTM.Control.M03"
                .to_owned(),
        };
        errors.push(ConfigError { table, index: Some(index), key, message: format!("`{id}` is {what}") });
    }
    errors
}

/// Every identifier of a machine with its place.
fn identifiers(machine: &MachineConfig) -> Vec<(&'static str, usize, &'static str, &str)> {
    let inputs = machine.input.iter().enumerate().map(|(n, it)| ("input", n, "id", it.id.as_str()));
    let outputs = machine.output.iter().enumerate().map(|(n, it)| ("output", n, "id", it.id.as_str()));
    let links = machine.link.iter().enumerate().flat_map(|(n, it)| {
        [("link", n, "source", it.source.as_str()), ("link", n, "destination", it.destination.as_str())]
    });
    inputs.chain(outputs).chain(links).collect()
}

/// The name of an element: without group, index and bit.
fn element(id: &str) -> &str {
    let groups = ["PLC.Input.", "PLC.Output."];
    let behind = |group: &&str| id.get(..group.len()).is_some_and(|head| head.eq_ignore_ascii_case(group));
    let id = groups.iter().find(|group| behind(group)).map_or(id, |group| &id[group.len()..]);
    let end = id.to_ascii_lowercase().rfind(".bit").unwrap_or(id.len());
    id[..end].split('[').next().unwrap_or(id).trim()
}

fn has_memory(target: &Target) -> bool {
    matches!(target, Target::Bit { .. } | Target::Cell { .. } | Target::Text { .. })
}

fn is_at(cell: &Arg, target: Target) -> bool {
    match (cell, target) {
        (Arg::Bit { bit: own, .. }, Target::Bit { addr, bit }) => (own.addr, own.bit) == (addr, bit),
        (
            Arg::Cell { place, .. } | Arg::Area { place, .. },
            Target::Cell { addr, .. } | Target::Text { addr, .. },
        ) => place.addr == addr,
        _ => false,
    }
}
