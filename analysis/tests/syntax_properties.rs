//! What holds for every text.

mod syntax_sexpr;

use proptest::prelude::*;
use technol_analysis::syntax::ast::SyntaxError;
use technol_analysis::syntax::{SyntaxKind, lines, parse, parse_lines, split};

/// Lines put together from what TECHNOL is made of, in any order.
fn soup() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "LDR",
        "ALFA",
        "t_include",
        "DEF_T_MACRO",
        "END_T_MACRO",
        "DATA",
        "DATA_END",
        "DATA_LOCAL",
        "DATA_LOCAL_END",
        "MODULE_MAIN",
        "MODULE_MAIN_END",
        "MODULE_INIT",
        "MODULE_INIT_END",
        "MECH_BEGIN",
        "MECH_END",
        "PROC_BEGIN",
        "PROC_END",
        "CNST",
        "DS",
        "DB",
        "DUP",
        "?",
        "$",
        "12",
        "0F8h",
        "1.8",
        "3.",
        ".",
        ",",
        ":",
        "+",
        "-",
        "(",
        ")",
        "[",
        "]",
        "'",
        "''",
        "‘",
        "’",
        "\"",
        ";",
        "ž",
        "€",
        "*",
        " ",
        "  ",
        "\t",
        "\u{a0}",
        "\u{1a}",
        "\n",
        "\r\n",
        "\r",
    ]);
    prop::collection::vec(piece, 0..80).prop_map(|pieces| pieces.concat())
}

/// Lines of single characters.
fn latin() -> impl Strategy<Value = String> {
    "[ -~\t\n\r\u{a0}-\u{17f}]{0,200}"
}

fn check(text: &str) {
    let parsed = parse(text);
    assert_eq!(parsed.root().to_string(), text, "the tree is lossless");

    let sections = split(text);
    let source: Vec<_> = lines(text).collect();
    let mut owners = vec![0; source.len()];
    let mut errors = Vec::new();
    let mut shapes = vec![Vec::new(); source.len()];
    for section in &sections {
        assert!(section.lines.is_sorted());
        let own: String =
            section.lines.iter().flat_map(|l| [source[*l as usize].text, source[*l as usize].end]).collect();
        assert_eq!(section.text, own, "a section owns its lines");
        let typed = parse_lines(&section.text);
        assert_eq!(typed.lines.len(), section.lines.len());
        for (own, file) in section.lines.iter().enumerate() {
            owners[*file as usize] += 1;
            let line = &typed.lines[own];
            assert_eq!(line.len as usize, source[*file as usize].text.len());
            line.operands.iter().for_each(|o| syntax_sexpr::shape_of_expr(o, &mut shapes[*file as usize]));
        }
        errors.extend(
            typed.errors.into_iter().map(|e| SyntaxError { line: section.lines[e.line as usize], ..e }),
        );
    }
    assert!(owners.iter().all(|n| *n == 1), "every line has one owner");
    errors.sort_by_key(|e| e.line);
    assert_eq!(errors, parsed.errors, "sections and file agree on errors");
    assert!(errors.windows(2).all(|w| w[0].line < w[1].line), "one error per line");

    let root = parsed.root();
    let nodes: Vec<_> = root.descendants().filter(|n| n.kind() == SyntaxKind::Line).collect();
    assert_eq!(nodes.len(), source.len());
    for ((node, line), shape) in nodes.iter().zip(&source).zip(&shapes) {
        assert_eq!(node.to_string(), format!("{}{}", line.text, line.end));
        assert_eq!(&syntax_sexpr::shape_of_line(node), shape, "tree and typed line agree: {:?}", line.text);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_kept_and_cut(text in any::<String>()) {
        check(&text);
    }

    #[test]
    fn any_latin_text_is_kept_and_cut(text in latin()) {
        check(&text);
    }

    #[test]
    fn any_soup_of_tokens_is_kept_and_cut(text in soup()) {
        check(&text);
    }
}
