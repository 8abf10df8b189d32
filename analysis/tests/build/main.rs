//! From source text to program image.

mod configuration;
mod debug_information;
mod expressions;
mod incremental;
mod macros;
mod operations;
mod program;
mod refusals;

use std::collections::BTreeMap;

use technol_analysis::project::{FileReader, load};
use technol_analysis::{Analysis, AnalysisHost, Built, Change, Diagnostic};
use technol_image::{DebugInfo, Program};

struct Memory(BTreeMap<String, Vec<u8>>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).cloned().ok_or_else(|| "no such file".to_string())
    }
}

/// A project of these files; the first one stands for `load`.
fn project(files: &[(&str, &str)]) -> Analysis {
    let memory = Memory(files.iter().map(|(p, t)| ((*p).to_string(), t.as_bytes().to_vec())).collect());
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load(files[0].0, &memory)), texts: Vec::new() });
    host.analysis()
}

fn built(analysis: &Analysis) -> Built {
    analysis.build().expect("nothing cancels it").unwrap_or_else(|errors| panic!("{}", shown(&errors)))
}

fn refused(analysis: &Analysis) -> Vec<(String, Diagnostic)> {
    match analysis.build().expect("nothing cancels it") {
        Ok(_) => panic!("the build was expected to fail"),
        Err(errors) => errors,
    }
}

/// `file:line:column code message`, 1-based, a line each.
fn shown(errors: &[(String, Diagnostic)]) -> String {
    let line = |(file, d): &(String, Diagnostic)| {
        let start = d.span.start;
        format!("{file}:{}:{} {} {}", start.line + 1, start.column + 1, d.code, d.message)
    };
    errors.iter().map(line).collect::<Vec<_>>().join("\n")
}

/// File 1 with these data, this MODULE_MAIN and otherwise empty modules.
fn source(data: &str, main: &str) -> String {
    format!(
        "DATA\n{data}DATA_END\nMODULE_MAIN\n{main}MODULE_MAIN_END\n\
         MODULE_INPUT\nMODULE_INPUT_END\nMODULE_BLOCK_INIT\nMODULE_BLOCK_INIT_END\n\
         MODULE_BLOCK_DONE\nMODULE_BLOCK_DONE_END\nMODULE_INIT\nMODULE_INIT_END\n\
         MODULE_CLEAR\nMODULE_CLEAR_END\nMODULE_HALT\nMODULE_HALT_END\nSTOP\n"
    )
}

fn built_source(data: &str, main: &str) -> Built {
    built(&project(&[("main.plc", &source(data, main))]))
}

fn parts(built: &Built) -> (&Program, &DebugInfo) {
    (&built.image.program, built.image.debug.as_ref().expect("a build has debug information"))
}
