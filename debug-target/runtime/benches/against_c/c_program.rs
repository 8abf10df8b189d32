//! The same logic as a C program: RLO and DR are variables, cells are bytes of an array.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::Command;

use crate::Timing;
use crate::mixture::{Item, PORTS};
use crate::support::{END, GLOBAL};
use technol_image::op::{Arith, BitRef, Compare, Cond, Logic, Op, Place, Source, Width};

/// What surrounds the cycle: the inputs of `next_inputs`, the time, the number for the memory.
const FRAME: &str = r#"
static uint64_t seed = 1;
static uint64_t next(void) {
    seed ^= seed >> 12; seed ^= seed << 25; seed ^= seed >> 27;
    return seed * 0x2545F4914F6CDD1Dull >> 32;
}
int main(int argc, char **argv) {
    long cycles = atol(argv[argc - 1]), part = 40;
    double least = 1e30;
    for (long done = 0; done < cycles; done += part) {
        struct timespec a, b;
        clock_gettime(CLOCK_MONOTONIC, &a);
        for (long i = 0; i < part; i++) {
            for (int n = 0; n < 2; n++) {
                uint64_t number = next();
                mem[number & 15] ^= 1 << (number >> 4 & 7);
            }
            cycle();
        }
        clock_gettime(CLOCK_MONOTONIC, &b);
        double ns = ((b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec)) / part;
        if (ns < least) least = ns;
    }
    uint64_t hash = 0xCBF29CE484222325ull;
    for (int i = FIRST; i < LEN; i++) hash = (hash ^ mem[i]) * 0x100000001B3ull;
    printf("%f %llu\n", least, (unsigned long long)hash);
}
"#;

/// A compiled program.
pub(crate) struct CProgram {
    path: PathBuf,
}

impl CProgram {
    /// `None`, loudly, where there is no gcc.
    pub(crate) fn compile(name: &str, items: &[Item]) -> Option<CProgram> {
        if !Command::new("gcc").arg("--version").output().is_ok_and(|o| o.status.success()) {
            println!("SKIPPED: no gcc; nothing to compare with");
            return None;
        }
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
        let (source, path) = (folder.join(format!("{name}.c")), folder.join(format!("{name}-in-c")));
        std::fs::write(&source, text(items)).expect("the C program is written");
        let output =
            Command::new("gcc").args(["-O2", "-o"]).arg(&path).arg(&source).output().expect("gcc runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        Some(CProgram { path })
    }

    /// Nanoseconds of a cycle, the least of all parts, and what is in memory at the end.
    pub(crate) fn run(&self, cycles: u32) -> Timing {
        let output = Command::new(&self.path).arg(cycles.to_string()).output().expect("the C program runs");
        let text = String::from_utf8(output.stdout).expect("it prints ASCII");
        let (ns, memory) = text.trim().split_once(' ').expect("it prints two numbers");
        Timing { ns: ns.parse().expect("a time"), memory: memory.parse().expect("a number") }
    }
}

fn text(items: &[Item]) -> String {
    let mut out =
        String::from("#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n");
    out.push_str("#include <time.h>\n");
    writeln!(out, "enum {{ FIRST = {GLOBAL}, LEN = {END}, PORTS = {PORTS} }};").expect(FITS);
    out.push_str("static uint8_t mem[LEN];\n");
    for (name, bits) in [("b", 8), ("w", 16), ("d", 32)] {
        writeln!(
            out,
            "static inline int64_t r{name}(int a) {{ int{bits}_t v; memcpy(&v, mem + a, sizeof v); return v; }}\n\
             static inline void s{name}(int a, int64_t x) {{ int{bits}_t v = x; memcpy(mem + a, &v, sizeof v); }}"
        )
        .expect(FITS);
    }
    out.push_str(
        "static uint8_t rlo, s0;\nstatic int64_t dr;\n__attribute__((noinline)) static void cycle(void) {\n",
    );
    out.push_str("uint8_t rlo_ = rlo, s0 = 0;\nint64_t dr_ = dr;\n");
    let mut ends = Vec::new();
    for (at, item) in items.iter().enumerate() {
        while let Some(end) = ends.iter().position(|end| *end == at) {
            ends.swap_remove(end);
            writeln!(out, "L{at}:;").expect(FITS);
        }
        match item {
            Item::Op(op) => writeln!(out, "{}", statement(op)).expect(FITS),
            Item::Over(count) => {
                let end = at + 1 + count;
                writeln!(out, "if (rlo_) goto L{end};").expect(FITS);
                ends.push(end);
            }
        }
    }
    for end in ends {
        writeln!(out, "L{end}:;").expect(FITS);
    }
    out.push_str("rlo = rlo_; dr = dr_;\n}\n");
    out.push_str(FRAME);
    out
}

const FITS: &str = "a string takes all";

fn bit(bit: BitRef, neg: bool) -> String {
    let value = format!("(mem[{}] >> {} & 1)", bit.addr, bit.bit);
    if neg { format!("({value} ^ 1)") } else { value }
}

fn letter(width: Width) -> char {
    match width {
        Width::Byte => 'b',
        Width::Word => 'w',
        Width::DWord => 'd',
        Width::QWord | Width::Real => unreachable!("not in the mixture"),
    }
}

fn read(place: Place, width: Width) -> String {
    format!("r{}({})", letter(width), place.addr)
}

fn source(source: &Source, width: Width) -> String {
    match source {
        Source::Mem(place) => read(*place, width),
        Source::Int(value) => value.to_string(),
        Source::Real(_) => unreachable!("not in the mixture"),
    }
}

fn statement(op: &Op) -> String {
    let sign = |logic: &Logic| match logic {
        Logic::And => '&',
        Logic::Or => '|',
        Logic::Xor => '^',
    };
    let when = |cond: &Cond| if *cond == Cond::IfRlo { "if (rlo_) " } else { "" };
    match op {
        Op::Ldr { bit: b, neg, push } => {
            format!("{}rlo_ = {};", if *push { "s0 = rlo_; " } else { "" }, bit(*b, *neg))
        }
        Op::Logic { op, bit: b, neg } => format!("rlo_ {}= {};", sign(op), bit(*b, *neg)),
        Op::LogicPop(op) => format!("rlo_ {}= s0;", sign(op)),
        Op::Write(b) => format!("mem[{0}] = (mem[{0}] & ~(1 << {1})) | rlo_ << {1};", b.addr, b.bit),
        Op::Flag { value, bit: b, cond } => {
            let change = if *value { format!("|= 1 << {}", b.bit) } else { format!("&= ~(1 << {})", b.bit) };
            format!("{}mem[{}] {change};", when(cond), b.addr)
        }
        Op::Load { src, width, .. } => format!("dr_ = {};", source(src, *width)),
        Op::Store { dst, width, cond } => format!("{}s{}({}, dr_);", when(cond), letter(*width), dst.addr),
        Op::Move { dst, src, width, .. } => {
            format!("s{}({}, {});", letter(*width), dst.addr, read(*src, *width))
        }
        Op::Arith { op, src, width } => {
            let mask = format!("{:#x}ll", (1_u64 << width.bits()) - 1);
            let (operand, signed) = (source(src, *width), format!("(int{}_t)", width.bits()));
            let low = |sign: &str| format!("dr_ = (dr_ & ~{mask}) | ((dr_ {sign} {operand}) & {mask});");
            match op {
                Arith::Add => low("+"),
                Arith::Sub => low("-"),
                Arith::And => low("&"),
                Arith::Or => low("|"),
                Arith::Xor => low("^"),
                Arith::Mul => format!("dr_ = (int64_t){signed}dr_ * (int64_t){signed}({operand});"),
                Arith::Div => unreachable!("not in the mixture"),
            }
        }
        Op::Compare { op, src, width, .. } => {
            let sign = match op {
                Compare::Eq => "==",
                Compare::Lt => "<",
                Compare::Gt => ">",
                Compare::Le => "<=",
                Compare::Ge => ">=",
            };
            format!("rlo_ = (int{}_t)dr_ {sign} {};", width.bits(), source(src, *width))
        }
        other => unreachable!("{other:?} is not in the mixture"),
    }
}
