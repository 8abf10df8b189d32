//! Check of a file: from nothing, and after one edit in one of its mechanisms.

mod generated;

use std::hint::black_box;
use std::sync::Arc;

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use technol_analysis::{AnalysisHost, Change};

use generated::{program, project};

fn check(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("check");
    group.sample_size(20);
    for lines in [500, 5_000, 50_000, 100_000] {
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
        assert!(clean.is_empty(), "the program of the benchmark has mistakes: {:?}", clean[0].1[0]);
        // The two texts differ in one line of the mechanism in the middle.
        let middle = format!("  FL 1,E{}     ;start", (lines / 30).max(1) / 2);
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
