//! Check of a file: from nothing, and after one edit in one of its mechanisms.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::hint::black_box;
use std::sync::Arc;

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use technol_analysis::project::{FileReader, LoadedProject, load};
use technol_analysis::{AnalysisHost, Change};

struct Memory(BTreeMap<String, String>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).map(|text| text.clone().into_bytes()).ok_or_else(|| "no such file".to_string())
    }
}

/// A program of about `lines` lines: mechanisms of 20 lines, each with its own cells.
fn program(lines: usize) -> String {
    let count = (lines / 25).max(1);
    let mut text = String::from("DATA\n");
    for n in 0..count {
        writeln!(text, "IN{n}: DFM A{n},B{n},C{n},D{n}\nOUT{n}: DFM E{n},F{n}\nCELL{n}: DS 2")
            .expect("a String");
    }
    text.push_str(
        "DATA_END\nMODULE_INPUT\nMODULE_INPUT_END\nMODULE_BLOCK_INIT\nMODULE_BLOCK_INIT_END\n\
         MODULE_BLOCK_DONE\nMODULE_BLOCK_DONE_END\nMODULE_MAIN\n",
    );
    for n in 0..count {
        write!(
            text,
            "  LDR A{n}\n  FL1 1,MECH{n}\nMECH_BEGIN MECH{n}\n  FL 1,E{n}     ;start\n  LDR A{n}\n  LA -B{n}\n  \
             LDR C{n}\n  LO D{n}\n  LA\n  TEX0 -,500,ERR{n}\n  LOD CELL{n}\n  AD CNST.{n}\n  STO CELL{n}\n  EQ CNST.100\n  \
             JL0 NEXT{n}\n  FL 0,F{n}\nNEXT{n}:\n  TIM -,10\n  JUM END{n}\nERR{n}:\n  ESET 5\nEND{n}:\nMECH_END MECH{n}\n"
        )
        .expect("a String");
    }
    text.push_str(
        "MODULE_MAIN_END\nMODULE_INIT\nMODULE_INIT_END\nMODULE_CLEAR\nMODULE_CLEAR_END\n\
         MODULE_HALT\nMODULE_HALT_END\nSTOP\n",
    );
    text
}

fn project(text: &str) -> LoadedProject {
    load("t.plc", &Memory(BTreeMap::from([("t.plc".to_string(), text.to_string())])))
}

fn check(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("check");
    group.sample_size(20);
    for lines in [500, 5_000, 50_000] {
        let text = program(lines);
        let loaded = project(&text);
        group.throughput(Throughput::Elements(text.lines().count() as u64));
        group.bench_with_input(BenchmarkId::new("from nothing", lines), &loaded, |bencher, loaded| {
            bencher.iter_batched(
                || loaded.clone(),
                |loaded| {
                    let mut host = AnalysisHost::new();
                    host.apply(Change { project: Some(loaded), texts: Vec::new() });
                    black_box(host.analysis().all_diagnostics())
                },
                BatchSize::LargeInput,
            );
        });
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(loaded), texts: Vec::new() });
        let clean = host.analysis().all_diagnostics().expect("nothing cancels it");
        assert_eq!(clean, Vec::new(), "the program of the benchmark has no mistakes");
        // The two texts differ in one line of the mechanism in the middle.
        let middle = format!("  FL 1,E{}     ;start", (lines / 25).max(1) / 2);
        let texts = [text.clone(), text.replacen(&middle, &format!("{middle}ed"), 1)];
        assert_ne!(texts[0], texts[1]);
        let texts: Vec<Arc<str>> = texts.iter().map(|text| Arc::from(text.as_str())).collect();
        let mut turn = 0;
        group.bench_function(BenchmarkId::new("after one edit", lines), |bencher| {
            bencher.iter(|| {
                turn = 1 - turn;
                host.apply(Change { project: None, texts: vec![("t.plc".to_string(), texts[turn].clone())] });
                black_box(host.analysis().all_diagnostics())
            });
        });
    }
    group.finish();
}

criterion_group!(benches, check);
criterion_main!(benches);
