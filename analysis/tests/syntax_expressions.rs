//! What lines and operands are read as.

mod syntax_sexpr;

use technol_analysis::syntax::ast::Line;
use technol_analysis::syntax::parse_lines;

fn parsed(text: &str) -> Line {
    let mut parsed = parse_lines(text);
    assert_eq!(parsed.errors, [], "{text}");
    assert_eq!(parsed.lines.len(), 1, "{text}");
    parsed.lines.remove(0)
}

#[track_caller]
fn check(rows: &[(&str, &str)]) {
    for (text, expected) in rows {
        assert_eq!(syntax_sexpr::line(&parsed(text)), *expected, "{text}");
    }
}

#[test]
fn a_line_is_label_operation_operands_comment() {
    check(&[
        ("   \t ", ""),
        (";only this", ""),
        ("LDR ALFA", "(LDR ALFA)"),
        ("  ldr\talfa ;why", "(ldr alfa)"),
        ("LOOP: LDR ALFA", "LOOP: (LDR ALFA)"),
        ("LOOP :LDR ALFA", "LOOP: (LDR ALFA)"),
        ("LOOP:", "LOOP:"),
        ("LOOP:;why", "LOOP:"),
        ("LO", "(LO)"),
        ("WR A,B , C", "(WR A B C)"),
        ("LDR-A", "(LDR (neg A))"),
        ("LDR(A).B", "(LDR (dot (paren A) B))"),
        ("\u{feff}DATA", "(DATA)"),
        ("DATA\u{1a}", "(DATA)"),
    ]);
}

#[test]
fn words_of_the_language_may_be_labels_and_operands() {
    check(&[
        ("LDR: WR EQ", "LDR: (WR EQ)"),
        ("DFM POS_MP,POS_RESET,BYTE", "(DFM POS_MP POS_RESET BYTE)"),
        ("LDR LDR", "(LDR LDR)"),
        ("LDR DATA", "(LDR DATA)"),
        ("T_INCLUDE: LDR A", "T_INCLUDE: (LDR A)"),
        ("LDR T_INCLUDE", "(LDR T_INCLUDE)"),
    ]);
}

#[test]
fn empty_places_are_kept() {
    check(&[
        ("NAME: DFM A,,B", "NAME: (DFM A _ B)"),
        ("NAME: DFM A,,,", "NAME: (DFM A _ _ _)"),
        ("NAME: DFM ,A", "NAME: (DFM _ A)"),
        ("NAME: DFM ,", "NAME: (DFM _ _)"),
        ("NAME: DFM A, ;last", "NAME: (DFM A _)"),
        ("ESET 12,-,-,VALUE", "(ESET 12 dash dash VALUE)"),
        ("TM - , 5", "(TM dash 5)"),
        ("TM A,-", "(TM A dash)"),
        ("TM A,- ;none", "(TM A dash)"),
    ]);
    let line = parsed("NAME: DFM A, ,B,");
    let places: Vec<_> = line.operands.iter().map(|o| o.columns.clone()).collect();
    assert_eq!(places, [10..11, 12..12, 14..15, 16..16]);
    assert_eq!(parsed("DFM  ,A").operands[0].columns, 5..5);
}

#[test]
fn numbers() {
    check(&[
        ("X 0", "(X 0)"),
        ("X 123", "(X 123)"),
        ("X 123d", "(X 123)"),
        ("X 0012", "(X 12)"),
        ("X 0F8h,0f8H,15H", "(X 248 248 21)"),
        ("X 0001b,1B,10h,10dh", "(X 1 1 16 269)"),
        ("X 0bh", "(X 11)"),
        ("X 1.8,10.25", "(X 1.8 10.25)"),
        ("X 9223372036854775807", "(X 9223372036854775807)"),
        ("X 7FFFFFFFFFFFFFFFh", "(X 9223372036854775807)"),
        ("X -10.2,+5", "(X (neg 10.2) (pos 5))"),
    ]);
}

#[test]
fn a_point_belongs_to_a_number_only_between_digits() {
    check(&[
        ("LOD CNST.1.8", "(LOD (dot CNST 1.8))"),
        ("LOD CNST.-4.8", "(LOD (dot CNST (neg 4.8)))"),
        ("LOD CNST.5", "(LOD (dot CNST 5))"),
        ("LDR $+3.ALFA", "(LDR (+ $ (dot 3 ALFA)))"),
        ("LDR 0Fh.3", "(LDR (dot 15 3))"),
        ("LDR A. B", "(LDR (dot A B))"),
        ("LDR A .B", "(LDR (dot A B))"),
        ("LDR 1 . 8", "(LDR (dot 1 8))"),
    ]);
}

#[test]
fn the_dot_binds_tighter_than_sign_and_sum() {
    check(&[
        ("LDR -A.B+1", "(LDR (+ (neg (dot A B)) 1))"),
        ("LDR -(BUN5+3).ALFA", "(LDR (neg (dot (paren (+ BUN5 3)) ALFA)))"),
        ("LOD CNST.-5", "(LOD (dot CNST (neg 5)))"),
        ("LOD CNST.10h+1", "(LOD (+ (dot CNST 16) 1))"),
        ("STO BYTE.CAN_DATA+0", "(STO (+ (dot BYTE CAN_DATA) 0))"),
        ("STO BYTE.(CAN_DATA+2)", "(STO (dot BYTE (paren (+ CAN_DATA 2))))"),
        ("LOD REAL.A.B", "(LOD (dot (dot REAL A) B))"),
        ("LOD a-b-c", "(LOD (- (- a b) c))"),
        ("LOD - - a", "(LOD (neg (neg a)))"),
        ("LOD a+-b", "(LOD (+ a (neg b)))"),
    ]);
}

#[test]
fn an_index_binds_tightest() {
    check(&[
        ("LDR BUN5[BX].ALFA", "(LDR (dot (index BUN5 BX) ALFA))"),
        ("LOD WORD.BUN5[BX]", "(LOD (dot WORD (index BUN5 BX)))"),
        ("LDR -(BUN5[BX]-6).ALFA", "(LDR (neg (dot (paren (- (index BUN5 BX) 6)) ALFA)))"),
        ("LDR (BUN5[BX]+MEMBER+2).ALFA", "(LDR (dot (paren (+ (+ (index BUN5 BX) MEMBER) 2)) ALFA))"),
        ("LOD A [ BX + 1 ]", "(LOD (index A (+ BX 1)))"),
        ("LOD BLK[1][2]", "(LOD (index (index BLK 1) 2))"),
    ]);
}

#[test]
fn texts() {
    check(&[
        ("STR 15,'Spindle on'", r#"(STR 15 "Spindle on")"#),
        ("STR 15,'a;b' ;c", r#"(STR 15 "a;b")"#),
        ("STR 15,'it''s'", r#"(STR 15 "it's")"#),
        ("STR 15,''", r#"(STR 15 "")"#),
        ("STR 15,''''", r#"(STR 15 "'")"#),
        ("LOD CNST.'A'", r#"(LOD (dot CNST "A"))"#),
        ("STR 15,'“žluť”'", r#"(STR 15 "“žluť”")"#),
    ]);
}

#[test]
fn an_include_takes_its_file_name_bare_or_quoted() {
    check(&[
        ("T_INCLUDE VXR50.INC ;defs", r#"(T_INCLUDE "VXR50.INC")"#),
        ("t_include lib\\io.inc;defs", r#"(t_include "lib\\io.inc")"#),
        ("T_INCLUDE ../lib/io-2.inc", r#"(T_INCLUDE "../lib/io-2.inc")"#),
        ("L: T_INCLUDE a.inc", r#"L: (T_INCLUDE "a.inc")"#),
        ("T_INCLUDE 'MY MACROS.INC'", r#"(T_INCLUDE "MY MACROS.INC")"#),
        ("T_INCLUDE", "(T_INCLUDE)"),
        ("T_INCLUDE ;none", "(T_INCLUDE)"),
    ]);
}

#[test]
fn lines_of_the_assembler_just_parse() {
    check(&[
        ("UNIT STRUC", "UNIT: (STRUC)"),
        ("SPEED DW ?", "SPEED: (DW ?)"),
        ("DB 0", "(DB 0)"),
        ("TABLE DW 2 DUP (0)", "TABLE: (DW 2 DUP (paren 0))"),
        ("UNIT ENDS", "UNIT: (ENDS)"),
        ("LOD DB", "(LOD DB)"),
        ("MOVE DB,1", "(MOVE DB 1)"),
        ("LOD DB.X", "(LOD (dot DB X))"),
        ("MOV BX,CX", "(MOV BX CX)"),
    ]);
}

#[test]
fn a_macro_head_separates_its_name_by_a_blank() {
    check(&[
        ("DEF_T_MACRO SWAP PAR1, PAR2", "(DEF_T_MACRO SWAP PAR1 PAR2)"),
        ("DEF_T_MACRO NUMBERS", "(DEF_T_MACRO NUMBERS)"),
        ("END_T_MACRO T_END, C_0, D_OFF", "(END_T_MACRO T_END C_0 D_OFF)"),
    ]);
}

#[test]
fn columns_are_bytes_of_the_line() {
    let line = parsed("L1 : STR 9,'ž' ;č");
    assert_eq!(line.label.unwrap().columns, 0..2);
    assert_eq!(line.operation.unwrap().columns, 5..8);
    assert_eq!(line.operands[0].columns, 9..10);
    assert_eq!(line.operands[1].columns, 11..15);
    assert_eq!(line.comment, Some(16..19));
    assert_eq!(line.len, 19);

    let sum = parsed("LOD -( A + 1 ).B [0]").operands.remove(0);
    assert_eq!(sum.columns, 4..20);
}

#[test]
fn names_are_equal_in_their_first_31_characters() {
    let line = parsed("X abcdefghijklmnopqrstuvwxyz123456789,ABCDEFGHIJKLMNOPQRSTUVWXYZ12345,f8H,FH,EACH_H");
    let keys: Vec<_> = line
        .operands
        .iter()
        .map(|o| match &o.kind {
            technol_analysis::syntax::ast::ExprKind::Name(name) => (name.key(), name.looks_hexadecimal()),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(keys[0].0, "ABCDEFGHIJKLMNOPQRSTUVWXYZ12345");
    assert_eq!(keys[0].0, keys[1].0);
    assert_eq!(keys.iter().map(|k| k.1).collect::<Vec<_>>(), [false, false, true, true, false]);
}
