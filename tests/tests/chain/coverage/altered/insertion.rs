//! Putting operations into a program.

use technol_image::container::Image;
use technol_image::debug_info::SymbolKind;
use technol_image::op::{Op, Pc};
use technol_image::program::Program;

use super::registers::SPARE;

/// Puts operations before and behind those at the given places, which ascend. What led to an operation leads to what
/// stands before it now.
pub(super) fn insert(image: &mut Image, around: &[(usize, Vec<Op>, Vec<Op>)]) {
    let program = &mut image.program;
    let mut code = Vec::new();
    let mut moved: Vec<Pc> = Vec::new();
    let mut around = around.iter().peekable();
    for (at, op) in program.code.iter().enumerate() {
        moved.push(code.len() as Pc);
        match around.next_if(|(place, ..)| *place == at) {
            Some((_, before, behind)) => {
                code.extend(before.iter().copied());
                code.push(*op);
                code.extend(behind.iter().copied());
            }
            None => code.push(*op),
        }
    }
    moved.push(code.len() as Pc);
    program.code = code;
    relocate(program, &|pc: &mut Pc| *pc = moved[*pc as usize]);
    if let Some(region) = program.regions.last_mut() {
        region.len += SPARE;
    }
    if let Some(debug) = &mut image.debug {
        for line in &mut debug.lines {
            line.pc = moved[line.pc as usize];
        }
        for symbol in &mut debug.symbols {
            if let SymbolKind::Label { pc } = &mut symbol.kind {
                *pc = moved[*pc as usize];
            }
        }
    }
}

fn relocate(program: &mut Program, to: &dyn Fn(&mut Pc)) {
    for op in &mut program.code {
        match op {
            Op::Jump { target, .. } | Op::AssemblerJump { target, .. } | Op::Raster { end: target, .. } => {
                to(target);
            }
            _ => {}
        }
    }
    program.statements.iter_mut().for_each(to);
    for module in &mut program.modules {
        to(&mut module.start);
        to(&mut module.end);
    }
    for sequence in &mut program.sequences {
        to(&mut sequence.start);
        to(&mut sequence.end);
        sequence.resume.iter_mut().for_each(to);
    }
    for timed in &mut program.timed {
        timed.error.iter_mut().for_each(to);
    }
    for procedure in &mut program.procedures {
        to(&mut procedure.start);
        to(&mut procedure.end);
    }
}
