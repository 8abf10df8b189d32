//! Macros in the image: an expansion is what its lines would be if they stood there.

use std::fmt::Write as _;

use proptest::prelude::*;
use technol_image::Program;
use technol_image::op::Op;

use super::{built, parts, project, refused, shown, source};

const DATA: &str =
    "KEYS: DFM START,DOOR,LIMIT\nLAMPS: DFM RED,GREEN\nSMALL: DS 1\nMIDDLE: DS 2\nTABLE: DS 8\n";

fn program(before: &str, main: &str) -> Program {
    let text = format!("{before}{}", source(DATA, main));
    let built = built(&project(&[("main.plc", &text)]));
    parts(&built).0.clone()
}

/// What does not depend on lines: code, memory, and what the code refers to.
fn without_lines(mut program: Program) -> Program {
    program.statements.clear();
    for sequence in &mut program.sequences {
        sequence.line = 0;
    }
    for op in &mut program.code {
        if let Op::Ex { line, .. } | Op::ExIf { line, .. } = op {
            *line = 0;
        }
    }
    for timed in &mut program.timed {
        timed.line = 0;
    }
    program
}

#[test]
fn an_expansion_is_the_same_as_its_lines_written_by_hand() {
    let copy = "DEF_T_MACRO COPY FROM,TO\n LDR TMAC.FROM\n WR TMAC.TO\nEND_T_MACRO T_END\n";
    let wait = "DEF_T_MACRO WAIT_FOR BITS,CELL\n LDR TMAC.BITS\n LA -TMAC.CELL.LIMIT\n TEX0 -,50,OUT\n\
                \n;a comment\n FL 1,RED\nEND_T_MACRO T_NORMAL\n";
    let keep = "DEF_T_MACRO KEEP FROM\n T_LOCAL SKIP,KEPT,B0,B1,B2,B3,B4,B5,B6,B7\n DATA_LOCAL\nKEPT: DS 2\n\
                 DFM B0,B1,B2,B3,B4,B5,B6,B7\n DATA_LOCAL_END\n EDGE_H TMAC.FROM\n WR B0\n JL0 SKIP\n LOD KEPT\n\
                 INR\n STO KEPT\nSKIP:\n CU -,3,B1\nEND_T_MACRO T_END\n"
        .replace(" CU -,3,B1\n", "");
    let both =
        format!("{copy}DEF_T_MACRO BOTH ONE,TWO\n COPY TMAC.ONE,RED\n COPY TWO,GREEN\nEND_T_MACRO T_END\n");
    let push = "DEF_T_MACRO BEGUN ONE\n LDR TMAC.ONE\nEND_T_MACRO T_PUSH\nDEF_T_MACRO JOINED\n LO\nEND_T_MACRO T_POP\n";
    let mixed = "DEF_T_MACRO LOADED CELL\n MOV BX,CX\n LOD TMAC.CELL\n STO WORD.TABLE\nEND_T_MACRO\n";
    let mech = |body: &str| format!(" MECH_BEGIN M\n{body}OUT: EX\n MECH_END M\n FL 1,M\n");
    for (macros, with, by_hand) in [
        (
            copy,
            " COPY START,RED\n COPY -DOOR,SMALL.LIMIT\n".to_owned(),
            " LDR START\n WR RED\n LDR -DOOR\n WR SMALL.LIMIT\n".to_owned(),
        ),
        (
            wait,
            mech(" WAIT_FOR START,SMALL\n"),
            mech(" LDR START\n LA -SMALL.LIMIT\n TEX0 -,50,OUT\n FL 1,RED\n"),
        ),
        (
            &keep,
            " KEEP START\n KEEP DOOR\n".to_owned(),
            format!("{}{}", by_hand_keep(0, "START"), by_hand_keep(1, "DOOR")),
        ),
        (&both, " BOTH START,DOOR\n".to_owned(), " LDR START\n WR RED\n LDR DOOR\n WR GREEN\n".to_owned()),
        (
            push,
            " BEGUN START\n BEGUN DOOR\n JOINED\n WR RED\n".to_owned(),
            " LDR START\n LDR DOOR\n LO\n WR RED\n".to_owned(),
        ),
        (mixed, " LOADED MIDDLE\n".to_owned(), " MOV BX,CX\n LOD MIDDLE\n STO WORD.TABLE\n".to_owned()),
    ] {
        assert_eq!(without_lines(program(macros, &with)), without_lines(program("", &by_hand)), "{with}");
    }
}

/// What the macro KEEP is for the n-th call.
fn by_hand_keep(n: u32, from: &str) -> String {
    format!(
        " DATA_LOCAL\nKEPT{n}: DS 2\n DFM P{n},Q{n},R{n},S{n},T{n},U{n},V{n},W{n}\n DATA_LOCAL_END\n \
                         EDGE_H {from}\n WR P{n}\n JL0 SKIP{n}\n LOD KEPT{n}\n INR\n STO KEPT{n}\nSKIP{n}:\n"
    )
}

/// Lines of a body with `{b}` for a bit and `{c}` for a cell.
const TEMPLATES: &[&str] = &[
    "LDR {b}\n WR GREEN",
    "LDR -{b}\n LA {c}.LIMIT\n FL1 1,RED",
    "LOD {c}\n AD CNST.3\n STO {c}",
    "LOD BYTE.{c}\n STO BYTE.TABLE",
    "EDGE_H {b}\n STO1 {c}",
    "EQ1 {c}",
    "LDR {b}\n LDR -{b}\n LO\n WR {c}.{b}",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_body_expands_to_its_lines(
        bodies in prop::collection::vec(prop::collection::vec(0..TEMPLATES.len(), 1..5), 1..4),
        calls in prop::collection::vec((any::<prop::sample::Index>(), 0..3usize, 0..2usize), 1..6),
    ) {
        let (bits, cells) = (["START", "DOOR", "RED"], ["SMALL", "MIDDLE"]);
        let fill = |body: &[usize], bit: &str, cell: &str| -> String {
            let line = |n: &usize| format!(" {}\n", TEMPLATES[*n].replace("{b}", bit).replace("{c}", cell));
            body.iter().map(line).collect()
        };
        let mut macros = String::new();
        for (number, body) in bodies.iter().enumerate() {
            // One TMAC. covers an operand, wherever in it it stands.
            let lines = fill(body, "TMAC.ONE", "TMAC.TWO").replace("TMAC.TWO.TMAC.ONE", "TMAC.TWO.ONE");
            writeln!(macros, "DEF_T_MACRO M{number} ONE,TWO\n{lines}END_T_MACRO").expect("a String");
        }
        let (mut with, mut by_hand) = (String::new(), String::new());
        for (which, bit, cell) in &calls {
            let (number, bit, cell) = (which.index(bodies.len()), bits[*bit], cells[*cell]);
            writeln!(with, " M{number} {bit},{cell}").expect("a String");
            by_hand.push_str(&fill(&bodies[number], bit, cell));
        }
        prop_assert_eq!(without_lines(program(&macros, &with)), without_lines(program("", &by_hand)));
    }
}

#[test]
fn each_call_has_edges_and_counters_of_its_own() {
    let macros = "DEF_T_MACRO ONCE FROM\n EDGE_H TMAC.FROM\n WR RED\nEND_T_MACRO T_END\n";
    let program = program(macros, " ONCE START\n ONCE START\n");
    let edges: Vec<String> =
        program.code.iter().map(|op| format!("{op:?}")).filter(|op| op.contains("Edge")).collect();
    assert_eq!(edges.len(), 2, "{edges:?}");
    assert_ne!(edges[0], edges[1]);
}

#[test]
fn a_call_is_one_line_of_the_debugger_and_d_on_allows_break_points() {
    let macros = "DEF_T_MACRO QUIET TO\n LDR START\n WR TMAC.TO\nEND_T_MACRO T_END\n\
                  DEF_T_MACRO LOUD TO\n LDR START\n WR TMAC.TO\nEND_T_MACRO T_END,C_0,D_ON\n\
                  APPEND_T_MACRO HEARD,QUIET,T_END,C_0,D_ON\nDEBUG ON\n";
    let text =
        format!("{macros}{}", source(DATA, " LDR START\n WR RED\n QUIET RED\n LOUD RED\n HEARD GREEN\n"));
    let main = text.lines().position(|line| line == "MODULE_MAIN").expect("it is there") as u32 + 1;
    let lines = |everywhere: bool| -> Vec<(u32, bool)> {
        let manifest = format!("[project]\nmain = \"main.plc\"\n[debug]\neverywhere = {everywhere}\n");
        let built = built(&project(&[("technol.toml", manifest.as_str()), ("main.plc", &text)]));
        let debug = parts(&built).1;
        let lines = debug.lines.iter().map(|line| (line.line - main, line.in_debug_region));
        lines.filter(|(line, _)| *line <= 5).collect()
    };
    assert_eq!(lines(false), [(1, true), (2, true), (3, false), (4, true), (5, true)]);
    assert_eq!(lines(true), [(1, true), (2, true), (3, true), (4, true), (5, true)]);
}

#[test]
fn data_of_macros_are_shown_by_the_debugger() {
    let macros = "DEF_T_MACRO KEEP FROM\n T_LOCAL KEPT\n DATA_LOCAL\nKEPT: DS 2\n DATA_LOCAL_END\n \
                  LDR TMAC.FROM\n STO1 KEPT\n EQUI MADE,5\nEND_T_MACRO T_END\n";
    let text = format!("{macros}{}", source(DATA, " KEEP START\n KEEP DOOR\n LOD CNST.MADE\n"));
    let built = built(&project(&[("main.plc", &text)]));
    let names: Vec<&str> = parts(&built)
        .1
        .symbols
        .iter()
        .map(|s| s.name.as_str())
        .filter(|n| n.contains("KEPT") || *n == "MADE")
        .collect();
    assert_eq!(names, ["KEPT@@MAIN@1", "KEPT@@MAIN@2", "MADE", "MADE"]);
}

#[test]
fn what_the_target_cannot_execute_is_refused_at_the_call() {
    let macros = "DEF_T_MACRO PORT\n IN AL,DX\nEND_T_MACRO\n";
    let text = format!("{macros}{}", source(DATA, " PORT\n"));
    let errors = shown(&refused(&project(&[("main.plc", &text)])));
    let line = text.lines().position(|line| line == " PORT").expect("it is there") + 1;
    assert_eq!(errors, format!("main.plc:{line}:2 T0801 not executable on this target yet: IN"));
}
