//! Every mistake the lexer and the parser can find, with its columns, and what the line is read as all the same.

mod syntax_sexpr;

use technol_analysis::syntax::ast::SyntaxErrorKind::{self as Kind, *};
use technol_analysis::syntax::ast::{Columns, MAX_OPERATORS};
use technol_analysis::syntax::{parse, parse_lines};

/// One mistake, and what is read.
#[track_caller]
fn check(text: &str, columns: Columns, kind: Kind, read: &str) {
    let parsed = parse_lines(text);
    let errors: Vec<_> = parsed.errors.iter().map(|e| (e.line, e.columns.clone(), e.kind.clone())).collect();
    assert_eq!(errors, [(0, columns, kind)], "{text}");
    assert_eq!(syntax_sexpr::line(&parsed.lines[0]), read, "{text}");
}

#[test]
fn characters_without_meaning() {
    check("LDR A*B", 5..6, UnexpectedCharacter('*'), "(LDR A B)");
    check("LDR #5", 4..5, UnexpectedCharacter('#'), "(LDR error 5)");
    check("LDR A # ", 6..7, UnexpectedCharacter('#'), "(LDR A)");
    check("# LDR A", 0..1, UnexpectedCharacter('#'), "(LDR A)");
    check("LDR č", 4..6, UnexpectedCharacter('č'), "(LDR č)");
    check("ČAS: DS 1", 0..2, UnexpectedCharacter('Č'), "ČAS: (DS 1)");
    check("X Kč", 3..5, UnexpectedCharacter('č'), "(X Kč)");
    check("A: B: LDR C", 4..5, UnexpectedCharacter(':'), "A: (B error LDR C)");
    check("LDR A:B", 5..6, UnexpectedCharacter(':'), "(LDR A B)");
    check("LDR (A B)", 7..8, UnexpectedCharacter('B'), "(LDR (paren A))");
    check("LDR (A#)", 6..7, UnexpectedCharacter('#'), "(LDR (paren A))");
}

#[test]
fn quotes_that_are_no_apostrophes_are_read_as_such() {
    check("STR 5,‘ab’", 6..14, TypographicQuote('‘'), r#"(STR 5 "ab")"#);
    check("STR 5,'ab’", 6..12, TypographicQuote('’'), r#"(STR 5 "ab")"#);
    check("STR 5,`ab'", 6..10, TypographicQuote('`'), r#"(STR 5 "ab")"#);
    check("STR 5,\"a;b\" ;c", 6..11, TypographicQuote('"'), r#"(STR 5 "a;b")"#);
    check("STR 5,„ab“", 6..14, TypographicQuote('„'), r#"(STR 5 "ab")"#);
    check("T_INCLUDE “a.inc”", 10..21, TypographicQuote('“'), r#"(T_INCLUDE "a.inc")"#);
}

#[test]
fn texts_without_an_end() {
    check("STR 5,'ab ;c  ", 6..12, UnclosedText, r#"(STR 5 "ab ;c")"#);
    check("STR 5,'ab''", 6..11, UnclosedText, r#"(STR 5 "ab'")"#);
    check("STR 5,'", 6..7, UnclosedText, r#"(STR 5 "")"#);
    check("STR 5,„ab'", 6..12, UnclosedText, r#"(STR 5 "ab'")"#);
}

#[test]
fn numbers_that_are_none() {
    for bad in
        ["12A", "0F8", "2b", "0x1F", "1_000", "1.8E5", "1.8h", "9223372036854775808", "8000000000000000h"]
    {
        check(&format!("X A,{bad}"), 4..4 + bad.len() as u32, BadNumber, "(X A error)");
    }
    check("X 5ALFA+1", 2..7, BadNumber, "(X (+ error 1))");
}

#[test]
fn brackets_without_a_partner() {
    check("LDR (A", 4..5, Unbalanced('('), "(LDR (paren A))");
    check("LDR ((A)", 4..5, Unbalanced('('), "(LDR (paren (paren A)))");
    check("LDR (A,B", 4..5, Unbalanced('('), "(LDR (paren A) B)");
    check("LDR A[BX", 5..6, Unbalanced('['), "(LDR (index A BX))");
    check("LDR (A]", 4..5, Unbalanced('('), "(LDR (paren A))");
    check("LDR A)", 5..6, Unbalanced(')'), "(LDR A)");
    check("LDR )", 4..5, Unbalanced(')'), "(LDR error)");
    check("LDR A],B", 5..6, Unbalanced(']'), "(LDR A B)");
}

#[test]
fn operands_that_are_not_there() {
    check("LDR A+", 5..6, ExpectedOperand, "(LDR (+ A error))");
    check("LDR A+,B", 5..6, ExpectedOperand, "(LDR (+ A error) B)");
    check("LDR A. ;c", 5..6, ExpectedOperand, "(LDR (dot A error))");
    check("LDR .A", 4..5, ExpectedOperand, "(LDR (dot error A))");
    check("LDR -.A", 4..5, ExpectedOperand, "(LDR (neg (dot error A)))");
    check("LDR ()", 4..5, ExpectedOperand, "(LDR (paren error))");
    check("LDR A[]", 5..6, ExpectedOperand, "(LDR (index A error))");
    check("LDR [A]", 4..5, ExpectedOperand, "(LDR (index error A))");
    check("LDR (A+)", 6..7, ExpectedOperand, "(LDR (paren (+ A error)))");
    check("LDR (-)", 5..6, ExpectedOperand, "(LDR (paren (neg error)))");
    check("LDR +", 4..5, ExpectedOperand, "(LDR (pos error))");
}

#[test]
fn operands_without_a_comma() {
    check("WR A B", 5..6, ExpectedComma, "(WR A B)");
    check("WR A (B)", 5..6, ExpectedComma, "(WR A (paren B))");
    check("WR A B C,D", 5..6, ExpectedComma, "(WR A B C D)");
    check("T_INCLUDE my macros.inc", 13..19, ExpectedComma, r#"(T_INCLUDE "my" (dot macros inc))"#);
    check("DEF_T_MACRO N A B", 16..17, ExpectedComma, "(DEF_T_MACRO N A B)");
}

#[test]
fn lines_that_start_with_nothing_known() {
    check("5 LDR A", 0..1, ExpectedOperation, "");
    check("L: ,A", 3..4, ExpectedOperation, "L:");
    check(": LDR A", 0..1, ExpectedOperation, "");
    check("'text'", 0..6, ExpectedOperation, "");
}

#[test]
fn declared_names_without_a_colon() {
    check("ALFA DS 1", 0..4, ExpectedColon, "ALFA: (DS 1)");
    check("ALFA dfm A0,A1", 0..4, ExpectedColon, "ALFA: (dfm A0 A1)");
    check("TXT STR 10,'x'", 0..3, ExpectedColon, "TXT: (STR 10 \"x\")");
}

#[test]
fn operands_past_every_measure_are_given_up() {
    let many = MAX_OPERATORS as usize;
    for (start, unit, end) in
        [("LDR ", "(", ""), ("LDR ", "-", "A"), ("LDR A", "+A", ""), ("LDR A", "[A", ""), ("LDR A", ".A", "")]
    {
        let text = format!("{start}{}{end} ;c", unit.repeat(100_000));
        let parsed = parse_lines(&text);
        let at = (start.len() + many * unit.len()) as u32;
        let errors: Vec<_> = parsed.errors.iter().map(|e| (e.columns.clone(), e.kind.clone())).collect();
        assert_eq!(errors, [(at..at + 1, TooComplex)], "{unit}");
        assert_eq!(parsed.lines[0].operands.len(), 1);
        assert!(parsed.lines[0].comment.is_some());
        assert_eq!(parse(&text).root().to_string(), text);
    }
    assert_eq!(parse_lines(&format!("LDR A{}", "+A".repeat(many))).errors, []);
    let brackets = format!("LDR {}A{}", "(".repeat(many), ")".repeat(many));
    assert_eq!(parse_lines(&brackets).errors, []);
    assert_eq!(parse(&brackets).root().to_string(), brackets);
}

#[test]
fn a_line_has_one_error_and_its_neighbours_none() {
    let parsed = parse_lines("LDR A B # (\r\nLDR A\r\nWR (((,,]]]..+*'x\r\nWR B\r\n");
    assert_eq!(parsed.errors.iter().map(|e| e.line).collect::<Vec<_>>(), [0, 2]);
    assert_eq!(parsed.lines.len(), 4);
}
