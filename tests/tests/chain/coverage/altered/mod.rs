//! Programs whose operations mean something else: another width, another relation, a condition turned round, an
//! operand beside the right one, RLO or DR that is written or is not.
//!
//! An alteration is called `what it is done to: what is done`. It is done to all operations of that name, as if the
//! virtual machine itself were wrong.

mod exempt;
mod insertion;
mod names;
mod operations;
mod parameters;
mod registers;

use std::collections::BTreeSet;

use technol_image::container::Image;
use technol_image::op::Op;
use technol_image::program::{Message, Program, Timed};
use technol_image::service::ServiceCall;

pub(super) use exempt::EXEMPT;

/// What becomes of an operation.
pub(super) enum Change {
    /// Another one.
    Op(Op),
    /// Operations before and behind it.
    Around(Vec<Op>, Vec<Op>),
    /// Other parameters of a call, of a TEX or TIM, of a message.
    Call(ServiceCall),
    Timed(Timed),
    Message(Message),
}

/// What is done, and what becomes of the operation.
type Changes = Vec<(String, Change)>;
/// What can be done to the operation there.
type ChangesAt = fn(&Program, usize) -> Changes;

/// The alterations that `program` has a place for.
pub(super) fn alterations(program: &Program) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut seen: Vec<&Op> = Vec::new();
    for (at, op) in program.code.iter().enumerate() {
        if seen.contains(&op) && !matches!(op, Op::Bex { .. }) {
            continue;
        }
        seen.push(op);
        for (name, changes) in names_of(program, at) {
            found.extend(changes(program, at).into_iter().map(|(what, _)| format!("{name}: {what}")));
        }
    }
    found
}

/// Alters the operations of that name.
pub(super) fn alter(image: &mut Image, alteration: &str) {
    let Some((name, what)) = alteration.split_once(": ") else { return };
    let mut around = Vec::new();
    let original = image.program.clone();
    let program = &mut image.program;
    for at in 0..original.code.len() {
        let of_name = names_of(&original, at).into_iter().filter(|(of, _)| of == name);
        let mut all = of_name.flat_map(|(_, changes)| changes(&original, at));
        let Some((_, change)) = all.find(|(of, _)| of == what) else { continue };
        match (change, original.code[at]) {
            (Change::Op(op), _) => program.code[at] = op,
            (Change::Around(before, behind), _) => around.push((at, before, behind)),
            (Change::Call(call), Op::Service(n)) => program.services[usize::from(n)] = call,
            (Change::Timed(timed), Op::Timed(n)) => program.timed[usize::from(n)] = timed,
            (Change::Message(message), Op::Message { index, .. }) => {
                program.messages[usize::from(index)] = message;
            }
            _ => {}
        }
    }
    if !around.is_empty() {
        insertion::insert(image, &around);
    }
}

/// The names of an operation: as what it does, and as what it does to registers. Each with what can be done to it.
fn names_of(program: &Program, at: usize) -> Vec<(String, ChangesAt)> {
    let mut found: Vec<(String, ChangesAt)> = Vec::new();
    if let Some(name) = names::name(program, at) {
        found.push((name, |program, at| {
            let op = &program.code[at];
            let others = operations::others(op).into_iter().map(|(what, op)| (what, Change::Op(op)));
            others.chain(parameters::others(program, op)).collect()
        }));
    }
    if let Some(name) = registers::name(program, &program.code[at]) {
        found.push((name, |program, at| registers::others(program, &program.code[at])));
    }
    found
}
