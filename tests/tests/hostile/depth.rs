//! Texts and programs that are nested as deep as somebody likes: what works on them has a stack with an end.

// Each file of this test uses a part; fuzz targets take the files one by one.
#[allow(dead_code, clippy::duplicate_mod)]
#[path = "../common/families.rs"]
mod families;

use std::fmt::Write as _;
use std::thread::Builder;

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change};
use technol_runtime::PlcState;
use technol_target::Simulation;

/// What a worker of the language server has in a build that optimises nothing.
const WORKER: usize = 2 << 20;
/// A task of a controller, with the simulated control behind the program; nothing is optimised here.
const TASK: usize = 128 << 10;

/// A file and those it includes, by name.
struct Files(Vec<(String, String)>);

impl FileReader for Files {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let found = self.0.iter().find(|(name, _)| name == path);
        found.map(|(_, text)| text.clone().into_bytes()).ok_or_else(|| "no such file".to_owned())
    }
}

fn program(declarations: &str, before: &str, main: &str) -> String {
    format!(
        "{before}DATA\nIB: DFM I0,I1\nW1: DS 2\n{declarations}DATA_END\nMODULE_MAIN\n{main}MODULE_MAIN_END\nMODULE_INPUT\n\
         MODULE_INPUT_END\nMODULE_BLOCK_INIT\nMODULE_BLOCK_INIT_END\nMODULE_BLOCK_DONE\nMODULE_BLOCK_DONE_END\nMODULE_INIT\n\
         MODULE_INIT_END\nMODULE_CLEAR\nMODULE_CLEAR_END\nMODULE_HALT\nMODULE_HALT_END\nSTOP\n"
    )
}

/// Whether it is built, in a small stack; too little of it ends the whole process.
fn built(files: Files) -> bool {
    let work = move || {
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(load("plc.plc", &files)), texts: Vec::new() });
        host.analysis().build().expect("nothing cancels it").is_ok()
    };
    let thread = Builder::new().stack_size(WORKER).spawn(work).expect("a thread");
    thread.join().expect("it ends well")
}

fn alone(text: String) -> Files {
    Files(vec![("plc.plc".to_owned(), text)])
}

#[test]
fn operands_in_thousands_of_brackets_end() {
    for depth in [3, 100, 20_000] {
        let (open, close) = ("(".repeat(depth), ")".repeat(depth));
        built(alone(program(
            "",
            "",
            &format!(" LOD CNST.{open}1{close}\n STO W1\n LOD {open}W1+1{close}\n"),
        )));
        built(alone(program("", "", &format!(" LOD {open}\n STO W1[{open}\n"))));
    }
}

#[test]
fn thousands_of_open_equations_and_sections_end() {
    let main = " LDR I0\n".repeat(20_000);
    assert!(!built(alone(program("", "", &main))), "eight is the most");
    built(alone(program("", "", &"MECH_BEGIN M\n".repeat(3_000))));
    built(alone(program("", "", &"PROC_BEGIN P\n".repeat(3_000))));
    built(alone("MODULE_MAIN\n".repeat(3_000)));
}

#[test]
fn macros_that_expand_to_each_other_through_many_levels_end() {
    for levels in [20, 2_000] {
        let mut text = "DEF_T_MACRO LEVEL0\n NOP\nEND_T_MACRO T_END\n".to_owned();
        for level in 1..levels {
            write!(text, "DEF_T_MACRO LEVEL{level}\n LEVEL{}\nEND_T_MACRO T_END\n", level - 1)
                .expect("a string takes all");
        }
        built(alone(program("", &text, &format!(" LEVEL{}\n", levels - 1))));
    }
}

#[test]
fn procedures_that_call_each_other_through_many_levels_end() {
    let mut main = " PROC_CALL P0\n".to_owned();
    for level in 0..3_000 {
        write!(main, "PROC_BEGIN P{level}\n PROC_CALL P{}\nPROC_END P{level}\n", (level + 1) % 3_000)
            .expect("a string takes all");
    }
    assert!(!built(alone(program("", "", &main))), "a circle of 3000 calls is told");
}

#[test]
fn files_that_include_each_other_through_many_levels_end() {
    let mut files = vec![("plc.plc".to_owned(), program("", " T_INCLUDE 0.inc\n", ""))];
    files.extend((0..2_000).map(|n| (format!("{n}.inc"), format!(" T_INCLUDE {}.inc\n", n + 1))));
    built(Files(files));
}

#[test]
fn ticks_with_instructions_of_every_family_fit_into_a_small_stack() {
    let mut simulation = Simulation::new(families::program(), None).expect("it can be loaded");
    families::furnish(&mut simulation);
    let work = move || {
        simulation.start(true);
        let mut events = Vec::with_capacity(256);
        for cycle in 0..200 {
            families::feed(&mut simulation, cycle);
            simulation.cycle(&mut events);
            events.clear();
        }
        simulation.runtime().state()
    };
    let thread = Builder::new().stack_size(TASK).spawn(work).expect("a thread");
    assert_eq!(thread.join().expect("it ends well"), PlcState::Running);
}
