//! Time of a build at 500, 5,000 and 50,000 lines: of a new project, after an edit in one mechanism, and of the link
//! alone.

#![allow(
    missing_docs,
    clippy::unwrap_used,
    reason = "criterion's macros write the main function; a String takes every write"
)]

use std::fmt::Write;
use std::sync::Arc;

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change};

struct One(String);

impl FileReader for One {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        if path == "main.plc" { Ok(self.0.clone().into_bytes()) } else { Err("no such file".to_string()) }
    }
}

/// A complete program of about so many lines, all in mechanisms of the usual mix.
fn source(lines: usize) -> String {
    let units = (lines.saturating_sub(20) / 16).max(1);
    let mut text = String::from("DATA\n");
    for n in 0..units {
        writeln!(text, "IN{n}: DFM A{n},B{n},C{n},,,,,D{n}\nCNT{n}: DS 2").unwrap();
    }
    text.push_str("DATA_END\nMODULE_MAIN\n");
    for n in 0..units {
        write!(
            text,
            "MECH_BEGIN UNIT{n}\n FL 1,D{n}\n LDR A{n}\n LA -(IN{n}+1).B{n}\n EX0\n LOD CNT{n}\n AD CNST.1\n\
             \x20STO CNT{n}\n LDR B{n}\n TEX1 -,50,ERR{n}\n FL 0,D{n}\nERR{n}:\n MECH_END UNIT{n}\n LDR C{n}\n FL1 1,UNIT{n}\n"
        )
        .unwrap();
    }
    text.push_str("MODULE_MAIN_END\n");
    for module in ["INPUT", "BLOCK_INIT", "BLOCK_DONE", "INIT", "CLEAR", "HALT"] {
        writeln!(text, "MODULE_{module}\nMODULE_{module}_END").unwrap();
    }
    text + "STOP\n"
}

fn host(text: &str) -> AnalysisHost {
    let mut host = AnalysisHost::new();
    let project = load("main.plc", &One(text.to_string()));
    host.apply(Change { project: Some(project), texts: Vec::new() });
    host
}

fn edit(host: &mut AnalysisHost, text: &str) {
    host.apply(Change { project: None, texts: vec![("main.plc".to_string(), Arc::from(text))] });
}

fn benches(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("build");
    group.sample_size(10);
    for lines in [500, 5_000, 50_000] {
        let text = source(lines);
        let edited = text.replacen("AD CNST.1", "AD CNST.2", 1);
        let mut warm = host(&text);
        assert!(warm.analysis().build().unwrap().is_ok(), "the generated program is sound");
        group.throughput(Throughput::Elements(text.lines().count() as u64));
        group.bench_with_input(BenchmarkId::new("new project", lines), &text, |b, text| {
            b.iter_batched(
                || host(text),
                |host| host.analysis().build().unwrap().is_ok(),
                BatchSize::LargeInput,
            );
        });
        group.bench_function(BenchmarkId::new("after an edit", lines), |b| {
            let mut turn = false;
            b.iter(|| {
                turn = !turn;
                edit(&mut warm, if turn { &edited } else { &text });
                warm.analysis().build().unwrap().is_ok()
            });
        });
        group.bench_function(BenchmarkId::new("link", lines), |b| {
            let analysis = warm.analysis();
            b.iter(|| analysis.build().unwrap().is_ok());
        });
    }
    group.finish();
}

criterion_group!(build, benches);
criterion_main!(build);
