//! The stack of the target is bounded: read from the machine code of the C library, and tried.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command as Process;

use technol_runtime::{Command, Runtime};

use crate::bare;
use crate::lathe;

/// What a tick of the C library may need, in bytes.
const MOST_BYTES: usize = 8 << 10;
/// What is enough for a tick in a build that optimises nothing.
const SMALL_STACK: usize = 64 << 10;

#[derive(Debug, Default)]
struct Function {
    /// As people read it. Several functions may be called the same: one for each type they are made for.
    shown: String,
    calls: BTreeSet<String>,
    /// Return address, saved registers and locals.
    frame: usize,
    /// Calls through a pointer; those through a fixed place (`memcpy`) do not count.
    by_pointer: bool,
}

/// The name in a line that opens a function.
fn head(line: &str) -> Option<&str> {
    line.strip_suffix(">:").and_then(|head| head.split_once(" <")).map(|(_, name)| name)
}

/// Functions of a program, as `objdump` shows x86-64 code; `readable` is the same text with names for people.
fn functions(text: &str, readable: &str) -> BTreeMap<String, Function> {
    let mut functions = BTreeMap::new();
    let mut shown = readable.lines().filter_map(head);
    let mut name = "";
    for line in text.lines() {
        if let Some(function) = head(line) {
            name = function;
            let shown = shown.next().expect("the same functions in both").to_owned();
            functions.insert(name.to_owned(), Function { shown, frame: 8, ..Function::default() });
            continue;
        }
        let Some(function) = functions.get_mut(name) else { continue };
        let Some((_, instruction)) = line.split_once('\t') else { continue };
        let (mnemonic, operands) = instruction.split_once(' ').unwrap_or((instruction, ""));
        let operands = operands.trim();
        match mnemonic {
            "push" => function.frame += 8,
            // 128 bytes are taken by adding -128, which is shorter.
            "sub" | "add" if operands.ends_with(",%rsp") => {
                let hex = operands.trim_start_matches("$0x").trim_end_matches(",%rsp");
                let number = u64::from_str_radix(hex, 16).expect("a frame of fixed length") as i64;
                let taken = if mnemonic == "sub" { number } else { number.wrapping_neg() };
                function.frame += usize::try_from(taken).unwrap_or(0);
            }
            "call" if operands.starts_with('*') => function.by_pointer |= !operands.contains("(%rip)"),
            "call" | "jmp" => {
                let target = operands.split_once('<').and_then(|(_, target)| target.strip_suffix('>'));
                function.calls.extend(target.filter(|target| !target.contains("+0x")).map(str::to_owned));
            }
            _ => {}
        }
    }
    functions
}

/// Bytes that a call may need. `path` are the functions it was reached through.
fn need<'a>(
    name: &'a str,
    functions: &'a BTreeMap<String, Function>,
    known: &mut BTreeMap<&'a str, usize>,
    path: &mut Vec<&'a str>,
) -> usize {
    assert!(!path.contains(&name), "a circle of calls: {path:?} {name}");
    if let Some(bytes) = known.get(name) {
        return *bytes;
    }
    // A function of the C library (`memcpy`) needs next to nothing and calls nothing of ours.
    let Some((name, function)) = functions.get_key_value(name) else { return 0 };
    // A panic does not come back, and is a mistake of ours anyway.
    if function.shown.starts_with("core::panicking::") {
        return 0;
    }
    path.push(name);
    let deepest = function.calls.iter().map(|call| need(call, functions, known, path)).max();
    path.pop();
    let bytes = function.frame + deepest.unwrap_or(0);
    known.insert(name, bytes);
    bytes
}

#[test]
fn nothing_below_a_tick_calls_itself_and_the_frames_are_small() {
    if !cfg!(target_arch = "x86_64") || !bare::available("objdump") {
        eprintln!("SKIPPED: the machine code is read with `objdump`, on x86-64 only");
        return;
    }
    let Some(replay) = bare::replay() else { return };
    let text = |names: &[&str]| {
        let mut objdump = Process::new("objdump");
        let output = objdump.args(["-d", "--no-show-raw-insn"]).args(names).arg(replay).output();
        String::from_utf8_lossy(&output.expect("objdump runs").stdout).into_owned()
    };
    let mut functions = functions(&text(&[]), &text(&["-C"]));
    // The one pointer below a tick: what the watched loop asks before each statement.
    let asked = |function: &Function| {
        function.shown.contains("Runtime>::execute") && function.shown.ends_with("::{{closure}}")
    };
    let asked: Vec<String> =
        functions.iter().filter(|(_, it)| asked(it)).map(|(name, _)| name.clone()).collect();
    assert!(!asked.is_empty(), "the debugger's question is there under another name");
    // One loop for programs with a trace, one for those without.
    let mut watched = 0;
    for function in functions.values_mut().filter(|it| it.shown.ends_with("execute::run_watched")) {
        function.calls.extend(asked.iter().cloned());
        watched += 1;
    }
    assert!(watched > 0, "the watched loop is there");

    let mut known = BTreeMap::new();
    let bytes = need("technol_tick", &functions, &mut known, &mut Vec::new());
    println!("a tick needs at most {bytes} bytes of stack");
    assert!(known.len() > 30, "the code was understood: {known:?}");
    // Moving and clearing memory takes `memmove` and `memset` out of a register. The others ask the control, whose own need comes
    // on top: the one of the C library carries out nothing.
    let expected = [
        "execute::run_watched",
        "::wrap_copy",
        "execute::cold",
        "::perform",
        "::tick_with",
        "::abort_block",
        "BlockCycle::arrived",
        "BlockCycle::begin",
        "BlockCycle::lost",
        "BlockCycle::publish",
        "BlockCycle::release",
        "BlockCycle::take_axes",
        "BlockCycle::tell_position",
        "prepared::write",
    ];
    let by_pointer: Vec<_> = known.keys().map(|name| &functions[*name]).filter(|it| it.by_pointer).collect();
    let unexpected = by_pointer.iter().map(|it| it.shown.as_str());
    let unexpected: Vec<_> = unexpected.filter(|it| !expected.iter().any(|end| it.ends_with(end))).collect();
    assert!(unexpected.is_empty(), "{unexpected:?}");
    assert!(bytes <= MOST_BYTES, "{bytes}");
}

#[test]
fn ticks_of_the_lathe_fit_into_a_small_stack() {
    let program = lathe::image().program.clone();
    let mut runtime = Runtime::new(program).expect("the lathe can be loaded");
    let ticks = move || {
        let mut events = Vec::with_capacity(64);
        let inputs = [0xFF; 128];
        runtime.command(Command::StartPlc { cold: true });
        for _ in 0..2_000 {
            runtime.tick(&inputs, &mut events);
            events.clear();
        }
    };
    // Too little stack ends the whole process.
    let thread = std::thread::Builder::new().stack_size(SMALL_STACK).spawn(ticks).expect("a thread");
    thread.join().expect("it ends well");
}
