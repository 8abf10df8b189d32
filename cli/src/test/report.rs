//! What people read.

use std::fmt::Write as _;
use std::time::Duration;

use super::execute::{Failure, Verdict};
use super::scenario::Test;
use crate::check::count;
use crate::paint::Paint;

/// The line of a test as soon as it is over.
pub(super) fn line(test: &Test, verdict: &Verdict, width: usize, paint: Paint) -> String {
    let word = if verdict.failure.is_none() { paint.green("ok    ") } else { paint.red("FAILED") };
    format!("  {word}  {:<width$}  {}", test.name, paint.dim(format!("{:>7.2} s", seconds(verdict.ms))))
}

/// All about a failure.
pub(super) fn failure(test: &Test, failure: &Failure, paint: Paint) -> String {
    let place = format!("{}:{}:{}", test.file, failure.place.line, failure.place.column);
    let step = match (failure.step, &failure.step_name) {
        (0, _) => "before the first step".to_owned(),
        (number, None) => format!("step {number}"),
        (number, Some(name)) => format!("step {number}, {name}"),
    };
    // Writing to a string does not fail.
    let mut out = format!("{} {}\n", paint.red("FAILED"), paint.bold(&test.name));
    let _ = writeln!(out, "  {place}: {step}, at {} ms, cycle {}", failure.ms, failure.cycle);
    for problem in &failure.problems {
        let _ = writeln!(out, "    expected  {}", problem.expected);
        let _ = writeln!(out, "    actual    {}", paint.yellow(&problem.actual));
    }
    if !failure.history.is_empty() {
        let _ = writeln!(out, "  What led to it:");
        let _ = writeln!(out, "{}", paint.dim("        ms   cycle"));
        for entry in &failure.history {
            let _ = writeln!(out, "  {:>8}  {:>6}  {}", entry.ms, entry.cycle, entry.text);
        }
    }
    out
}

/// The last line.
pub(super) fn summary(verdicts: &[Verdict], left_out: usize, took: Duration, paint: Paint) -> String {
    let failed = verdicts.iter().filter(|verdict| verdict.failure.is_some()).count();
    let mut parts = vec![paint.green(format!("{} passed", verdicts.len() - failed))];
    if failed > 0 {
        parts.push(paint.red(format!("{failed} failed")));
    }
    if left_out > 0 {
        parts.push(format!("{left_out} left out by the filter"));
    }
    let virtual_time = seconds(verdicts.iter().map(|verdict| verdict.ms).sum());
    format!("{}; {virtual_time:.2} s of PLC time in {:.2} s", parts.join(", "), took.as_secs_f64())
}

/// `lathe: 12 tests in 3 files`
pub(super) fn title(project: &str, tests: usize, files: usize, paint: Paint) -> String {
    format!("{}: {} in {}", paint.bold(project), count(tests as u64, "test"), count(files as u64, "file"))
}

fn seconds(ms: u64) -> f64 {
    ms as f64 / 1000.0
}
