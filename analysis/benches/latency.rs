//! What a programmer waits for while typing: diagnostics after one edit, as a distribution.
//!
//! Criterion reports means; an editor is felt by its slow moments. So this prints percentiles of some hundred
//! different edits, each in another mechanism: a number changed, a line added, a line with a mistake, a comment.

mod generated;

use std::fmt::Write as _;
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use technol_analysis::{AnalysisHost, Change};

/// Edits measured for each project.
const EDITS: usize = 400;

fn main() {
    // Cargo passes `--bench`; as a test target there is nothing to do.
    if !std::env::args().any(|it| it == "--bench") {
        return;
    }
    println!("diagnostics after one edit: of the edited file, and of the whole project");
    measure("one file of 5,000 lines", &[5_000]);
    let mut many = [10_080; 64];
    many[32] = 5_000;
    measure("the same file in a project of 64 files, 640,000 lines", &many);
}

/// Edits the file in the middle of a project whose files have so many lines.
fn measure(name: &str, lines: &[usize]) {
    let begin = Instant::now();
    let (loaded, texts) = generated::project_of(lines);
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(loaded), texts: Vec::new() });
    let clean = host.analysis().all_diagnostics().expect("nothing cancels it");
    assert!(clean.is_empty(), "the program of the benchmark has mistakes: {:?}", clean[0].1[0]);
    println!("{name}: from nothing {:.0} ms", begin.elapsed().as_secs_f64() * 1000.0);
    let (mut file, mut project) = (Vec::new(), Vec::new());
    let mut found = 0;
    let (path, text) = &texts[lines.len() / 2];
    let opened = Arc::from(text.as_str());
    host.apply(Change { project: None, texts: vec![(path.clone(), opened)] });
    host.analysis().all_diagnostics().expect("nothing cancels it");
    for turn in 0..EDITS {
        let edited: Arc<str> = Arc::from(generated::edit(text, turn));
        let begin = Instant::now();
        host.apply(Change { project: None, texts: vec![(path.clone(), edited)] });
        let analysis = host.analysis();
        let diagnostics = black_box(analysis.diagnostics(path)).expect("nothing cancels it");
        file.push(begin.elapsed());
        black_box(analysis.all_diagnostics()).expect("nothing cancels it");
        project.push(begin.elapsed());
        found += usize::from(!diagnostics.is_empty());
    }
    assert!(found >= EDITS / 5, "some of the edits are mistakes");
    println!("{}", row("  file", &mut file));
    println!("{}", row("  project", &mut project));
}

fn row(name: &str, times: &mut [Duration]) -> String {
    times.sort_unstable();
    let at = |part: usize| times[(times.len() - 1) * part / 100].as_secs_f64() * 1000.0;
    let mut text = format!("{name:<12}");
    for (label, part) in [("p50", 50), ("p95", 95), ("max", 100)] {
        write!(text, "  {label} {:>6.2} ms", at(part)).expect("a String");
    }
    text
}
