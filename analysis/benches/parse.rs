//! Time of a parse, a cut and a typed parse at 500, 5,000 and 50,000 lines.

#![allow(
    missing_docs,
    clippy::unwrap_used,
    reason = "criterion's macros write the main function; a String takes every write"
)]

use std::fmt::Write;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use technol_analysis::syntax::{parse, parse_lines, split};

/// A program of about so many lines: data, then mechanisms of the usual mix in MODULE_MAIN.
fn source(lines: usize) -> String {
    let mut text = String::from("DATA\n");
    for n in 0..lines / 10 {
        writeln!(text, "CELL{n}:    DFM IN{n}_0,IN{n}_1,,OUT{n}_3,,,,  ;inputs of unit {n}").unwrap();
    }
    text.push_str("DATA_END\n\nMODULE_MAIN\n");
    let mut written = lines / 10 + 3;
    let mut n = 0;
    while written < lines {
        write!(
            text,
            "        MECH_BEGIN UNIT{n}\n\
             \x20       LDR     IN{n}_0         ;switch on\n\
             \x20       LA      -(CELL{n}+2).IN{n}_1\n\
             \x20       WR      OUT{n}_3,$+1.IN{n}_0\n\
             STEP{n}: LOD     CNST.0F8h\n\
             \x20       EQ      BYTE.CELL{n}[BX]\n\
             \x20       EX1\n\
             \x20       TEX0    -,CNST.50,ERR{n}\n\
             \n\
             ;---------------------------------- unit {n}\n\
             ERR{n}:  ESET    {n},-,-,'unit stopped; look there'\n\
             \x20       MECH_END UNIT{n}\n"
        )
        .unwrap();
        written += 12;
        n += 1;
    }
    text.push_str("MODULE_MAIN_END\n");
    text
}

fn benches(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("syntax");
    for lines in [500, 5_000, 50_000] {
        let text = source(lines);
        assert!(parse(&text).errors.is_empty(), "the generated source is sound");
        group.throughput(Throughput::Bytes(text.len() as u64));
        group.bench_with_input(BenchmarkId::new("split", lines), &text, |b, text| b.iter(|| split(text)));
        group.bench_with_input(BenchmarkId::new("parse_lines", lines), &text, |b, text| {
            b.iter(|| parse_lines(text));
        });
        group.bench_with_input(BenchmarkId::new("parse", lines), &text, |b, text| b.iter(|| parse(text)));
    }
    group.finish();
}

criterion_group!(parse_benches, benches);
criterion_main!(parse_benches);
