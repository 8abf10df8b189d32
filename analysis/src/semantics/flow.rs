//! Control flow within a section: loops that never wait, DFTM blocks (manual 3.11, 4.3).

use std::collections::BTreeMap;
use std::sync::Arc;

use super::hir::{Body, Instruction, Operand, Statement, StatementKind};
use crate::catalogue::{AssemblerForm, Effect, Equation};
use crate::diagnostics::Finding;
use crate::diagnostics::rules::sequences as rules;
use crate::syntax::ast::{Columns, Line};

/// Checks a section. `unreadable`: a line was not understood, so loops cannot be judged.
pub(super) fn check(
    body: &Body,
    lines: &[Line],
    labels: &BTreeMap<Arc<str>, (u32, Columns)>,
    unreadable: bool,
) -> Vec<Finding> {
    let targets: BTreeMap<&Arc<str>, usize> = body
        .statements
        .iter()
        .enumerate()
        .flat_map(|(index, statement)| statement.labels.iter().map(move |label| (label, index)))
        .collect();
    let mut findings = Vec::new();
    rasters(body, lines, &targets, &mut findings);
    if !unreadable && let Some(graph) = Graph::of(body, &targets) {
        loops(body, labels, &graph, &mut findings);
    }
    findings
}

fn instruction(statement: &Statement) -> Option<&Instruction> {
    match &statement.kind {
        StatementKind::Instruction(instruction) => Some(instruction),
        _ => None,
    }
}

fn is_raster(instruction: &Instruction) -> bool {
    matches!(instruction.entry.name, "DFTM01" | "DFTM1" | "DFTM10" | "DFTM100")
}

fn label_of(instruction: &Instruction) -> Option<&Arc<str>> {
    instruction.operands.iter().find_map(|operand| match operand {
        Operand::Label(label) => Some(label),
        _ => None,
    })
}

fn rasters(body: &Body, lines: &[Line], targets: &BTreeMap<&Arc<str>, usize>, findings: &mut Vec<Finding>) {
    let mut block: Option<(usize, u32)> = None;
    for (index, statement) in body.statements.iter().enumerate() {
        let Some(raster) = instruction(statement).filter(|i| is_raster(i) || i.entry.name == "TM") else {
            continue;
        };
        let source = lines.get(statement.line as usize);
        let operation = source.and_then(|line| line.operation.as_ref()).map_or(0..0, |o| o.columns.clone());
        if raster.entry.name == "TM" {
            if block.is_none_or(|(end, _)| index >= end) {
                let message = "TM counts passes of a DFTM block, but none is around it";
                findings.push(Finding::new(&rules::TIMER_OUTSIDE_RASTER, statement.line, operation, message));
            }
            continue;
        }
        if let Some((_, line)) = block.filter(|(end, _)| index < *end) {
            let message =
                format!("{} stands inside another DFTM block; end that one first", raster.entry.name);
            let first = lines.get(line as usize).and_then(|line| line.operation.as_ref());
            let mut finding = Finding::new(&rules::NESTED_RASTER, statement.line, operation, message);
            if let Some(first) = first {
                finding = finding.beside(line, first.columns.clone(), "the outer block begins here");
            }
            findings.push(finding);
            continue;
        }
        let Some(end) = label_of(raster).and_then(|label| targets.get(label)) else { continue };
        if *end <= index {
            let columns =
                source.and_then(|line| line.operands.first()).map_or(operation, |o| o.columns.clone());
            let message = format!("the end label of {} must stand after it", raster.entry.name);
            findings.push(Finding::new(&rules::RASTER_END, statement.line, columns, message));
        } else {
            block = Some((*end, statement.line));
        }
    }
}

/// Where control goes after each statement; waiting statements have no successors, the last index is the exit.
struct Graph {
    next: Vec<Vec<usize>>,
    waits: Vec<bool>,
}

impl Graph {
    /// `None` when a jump leads nowhere known.
    fn of(body: &Body, targets: &BTreeMap<&Arc<str>, usize>) -> Option<Graph> {
        let count = body.statements.len();
        let mut graph = Graph { next: vec![Vec::new(); count + 1], waits: vec![false; count + 1] };
        for (index, statement) in body.statements.iter().enumerate() {
            let Some(code) = instruction(statement) else {
                graph.next[index].push(index + 1);
                continue;
            };
            // Instructions of several cycles (PLCT_, ECAT_) leave the waiting to the EX0 behind them.
            graph.waits[index] =
                code.entry.ex_type && code.entry.equation == Equation::Terminal && code.entry.name != "BEX";
            let jumps = matches!(code.entry.name, "JUM" | "JL0" | "JL1")
                || is_raster(code)
                || code.entry.assembler_form() == Some(AssemblerForm::Jump);
            if jumps {
                let target = *targets.get(label_of(code)?)?;
                // A DFTM whose end stands before it is reported by itself.
                if target > index || !is_raster(code) {
                    graph.next[index].push(target);
                }
            }
            if !matches!(code.entry.name, "JUM" | "JMP") {
                graph.next[index].push(index + 1);
            }
        }
        Some(graph)
    }
}

fn loops(
    body: &Body,
    labels: &BTreeMap<Arc<str>, (u32, Columns)>,
    graph: &Graph,
    findings: &mut Vec<Finding>,
) {
    for circle in circles(graph) {
        let leaves =
            circle.iter().flat_map(|node| &graph.next[*node]).any(|next| circle.binary_search(next).is_err());
        let works = circle.iter().filter_map(|node| instruction(&body.statements[*node])).any(|code| {
            // What takes several cycles does not go on within this one.
            !code.entry.ex_type
                && code.entry.writes.iter().any(|effect| {
                    matches!(effect, Effect::Memory | Effect::Dr | Effect::Dr64 | Effect::DrReal)
                })
        });
        let head = circle.iter().find_map(|node| body.statements[*node].labels.first());
        let Some((name, (line, columns))) = head.and_then(|label| labels.get_key_value(label)) else {
            continue;
        };
        if !leaves {
            let message = format!(
                "the loop at {name} has no way out and no EX-type instruction that waits, so the cycle never ends"
            );
            findings.push(Finding::new(&rules::ENDLESS_LOOP, *line, columns.clone(), message));
        } else if !works {
            let message =
                format!("the loop at {name} turns without waiting until a condition changes; use EX0 or EX1");
            findings.push(Finding::new(&rules::BUSY_LOOP, *line, columns.clone(), message));
        }
    }
}

/// Sets of statements that can reach each other without waiting (Tarjan's algorithm, without recursion), each
/// ascending.
fn circles(graph: &Graph) -> Vec<Vec<usize>> {
    const NEW: usize = usize::MAX;
    let count = graph.next.len();
    let (mut order, mut low, mut on_stack) = (vec![NEW; count], vec![0; count], vec![false; count]);
    let (mut stack, mut found, mut clock) = (Vec::new(), Vec::new(), 0);
    for root in 0..count {
        if order[root] != NEW || graph.waits[root] {
            continue;
        }
        let mut path = vec![(root, 0)];
        while let Some((node, edge)) = path.pop() {
            if edge == 0 {
                order[node] = clock;
                low[node] = clock;
                clock += 1;
                stack.push(node);
                on_stack[node] = true;
            }
            match graph.next[node].get(edge) {
                Some(next) if graph.waits[*next] => path.push((node, edge + 1)),
                Some(next) if order[*next] == NEW => {
                    path.push((node, edge + 1));
                    path.push((*next, 0));
                }
                Some(next) => {
                    if on_stack[*next] {
                        low[node] = low[node].min(order[*next]);
                    }
                    path.push((node, edge + 1));
                }
                None => {
                    if let Some((parent, _)) = path.last() {
                        low[*parent] = low[*parent].min(low[node]);
                    }
                    if low[node] == order[node] {
                        let mut circle = Vec::new();
                        while let Some(member) = stack.pop() {
                            on_stack[member] = false;
                            circle.push(member);
                            if member == node {
                                break;
                            }
                        }
                        if circle.len() > 1 || graph.next[node].contains(&node) {
                            circle.sort_unstable();
                            found.push(circle);
                        }
                    }
                }
            }
        }
    }
    found
}
