//! Completion lists, as `kind label -> insert` when the two differ.

use crate::catalogue::{self, Language};
use crate::ide::fixture::fixture;
use crate::{Completion, CompletionKind, Span};

fn completions(text: &str) -> Vec<Completion> {
    let it = fixture(text);
    it.analysis.completion(&it.file, it.at, Language::En).expect("not cancelled")
}

fn labels(text: &str) -> Vec<String> {
    completions(text).into_iter().map(|completion| completion.label).collect()
}

/// Everything but predefined symbols, whose number is not the subject.
fn check(text: &str) -> String {
    let own = |c: &Completion| catalogue::symbol(&c.label).is_none();
    let show = |c: &Completion| {
        let insert = if c.insert == c.label { String::new() } else { format!(" -> {}", c.insert) };
        format!("{:?} {}{insert}\n", c.kind, c.label)
    };
    completions(text).iter().filter(|c| own(c)).map(show).collect()
}

/// A project with a name of every kind; `line` stands in a mechanism.
fn project(line: &str) -> String {
    format!(
        "\
EQUI LIMIT,10
DATA
 COUNT: DS 1
 SPEED: DS 2
 STATE: DFM RUN,FAULT
 OTHER: DFM SPARE,AUX
 TABLE: DS 30
 NOTE:  STR 9
DATA_END
MODULE_MAIN
 PROC_BEGIN Step
 PROC_END Step
 MECH_BEGIN Clamp
AGAIN: EX
 {line}
 MECH_END Clamp
MODULE_MAIN_END
"
    )
}

#[test]
fn operations_that_may_stand_in_a_mechanism() {
    let found = labels(&project("<CURSOR>"));
    for expected in ["LDR", "EX", "TEX0", "MECH_END", "MODULE_MAIN_END", "EQUI", "JUM"] {
        assert!(found.iter().any(|label| label == expected), "{expected}");
    }
    for unexpected in ["DS", "DFM", "DATA_END", "MODULE_INIT_END", "MODULE_INPUT", "WORD", "NIL", "PROC_END"]
    {
        assert!(!found.iter().any(|label| label == unexpected), "{unexpected}");
    }
}

#[test]
fn operations_that_may_stand_elsewhere() {
    let data = labels("DATA\n<CURSOR>\nDATA_END\n");
    assert!(data.contains(&"DFM".to_owned()) && data.contains(&"DATA_END".to_owned()));
    assert!(!data.contains(&"LDR".to_owned()) && !data.contains(&"EX".to_owned()));

    let file = labels("DATA\nDATA_END\n<CURSOR>");
    assert!(file.contains(&"MODULE_MAIN".to_owned()) && file.contains(&"EQUI".to_owned()));
    assert!(!file.contains(&"LDR".to_owned()) && !file.contains(&"DATA_END".to_owned()));

    let module = labels("MODULE_MAIN\n<CURSOR>\nMODULE_MAIN_END\n");
    assert!(module.contains(&"MECH_BEGIN".to_owned()) && module.contains(&"LDR".to_owned()));
    assert!(!module.contains(&"EX".to_owned()));
}

#[test]
fn behind_the_last_line_the_open_section_counts() {
    assert!(labels("MODULE_MAIN\n MECH_BEGIN A\n").len() > 1);
    let open = labels("MODULE_MAIN\n MECH_BEGIN A\n<CURSOR>");
    assert!(open.contains(&"EX".to_owned()) && open.contains(&"MECH_END".to_owned()));
}

#[test]
fn what_is_typed_narrows_the_list_and_is_replaced() {
    let it = fixture(&project("L: md<CURSOR>r X"));
    let found = it.analysis.completion(&it.file, it.at, Language::En).expect("not cancelled");
    assert!(found.iter().all(|c| c.label.contains('M')), "{found:?}");

    let it = fixture(&project("L: LD<CURSOR>X A"));
    let found = it.analysis.completion(&it.file, it.at, Language::En).expect("not cancelled");
    let first = found.first().expect("LDR begins with it");
    assert_eq!((first.label.as_str(), first.kind), ("LDR", CompletionKind::Instruction));
    assert_eq!(first.replace, Span::in_line(14, 4, 7));
    let page = catalogue::page::markdown(catalogue::entry("LDR").expect("LDR"), Language::En);
    assert_eq!(first.documentation.as_deref(), Some(page.as_str()));
}

#[test]
fn closing_a_mechanism_names_it() {
    insta::assert_snapshot!(check(&project("MECH_E<CURSOR>")), @"
    Structure MECH_END -> MECH_END Clamp
    ");
    insta::assert_snapshot!(check(&project("MECH_E<CURSOR> Clamp")), @"
    Structure MECH_END
    ");
}

#[test]
fn bits_for_a_logic_instruction() {
    insta::assert_snapshot!(check(&project("LDR <CURSOR>")), @"
    Bit AUX
    Bit FAULT
    Bit RUN
    Bit SPARE
    Mechanism Clamp
    Cell Clamp_LINE
    Cell COUNT
    Text NOTE
    Cell OTHER
    Cell SPEED
    Cell STATE
    Area TABLE
    ");
    insta::assert_snapshot!(check(&project("LDR -R<CURSOR>")), @"
    Bit RUN
    Bit SPARE
    Cell OTHER
    ");
    insta::assert_snapshot!(check(&project("WR RUN,F<CURSOR>")), @"Bit FAULT");
}

#[test]
fn bits_behind_the_dot_of_an_address() {
    insta::assert_snapshot!(check(&project("LDR STATE.<CURSOR>")), @"
    Bit FAULT
    Bit RUN
    Bit AUX
    Bit SPARE
    ");
    insta::assert_snapshot!(check(&project("LDR -(TABLE+3).<CURSOR>")), @"
    Bit AUX
    Bit FAULT
    Bit RUN
    Bit SPARE
    ");
    insta::assert_snapshot!(check(&project("LDR $+3.sp<CURSOR>")), @"Bit SPARE");
}

#[test]
fn cells_constants_and_prefixes_for_a_data_instruction() {
    insta::assert_snapshot!(check(&project("LOD <CURSOR>")), @"
    Cell Clamp_LINE
    Cell COUNT
    Cell OTHER
    Cell SPEED
    Cell STATE
    Constant LIMIT
    Prefix BYTE.
    Prefix CNST.
    Prefix DWRD.
    Prefix HIGH.
    Prefix QWRD.
    Prefix REAL.
    Prefix WORD.
    ");
    insta::assert_snapshot!(check(&project("STO <CURSOR>")), @"
    Cell Clamp_LINE
    Cell COUNT
    Cell OTHER
    Cell SPEED
    Cell STATE
    Prefix BYTE.
    Prefix DWRD.
    Prefix HIGH.
    Prefix QWRD.
    Prefix REAL.
    Prefix WORD.
    ");
}

#[test]
fn cells_behind_a_prefix() {
    insta::assert_snapshot!(check(&project("LOD WORD.<CURSOR>")), @"
    Cell Clamp_LINE
    Cell COUNT
    Text NOTE
    Cell OTHER
    Cell SPEED
    Cell STATE
    Area TABLE
    ");
    insta::assert_snapshot!(check(&project("LOD HIGH.S<CURSOR>")), @"
    Cell SPEED
    Cell STATE
    ");
    insta::assert_snapshot!(check(&project("LOD CNST.<CURSOR>")), @"Constant LIMIT");
}

#[test]
fn mechanisms_procedures_and_labels() {
    insta::assert_snapshot!(check(&project("MECH_INIT <CURSOR>")), @"Mechanism Clamp");
    insta::assert_snapshot!(check(&project("PROC_CALL <CURSOR>")), @"Procedure Step");
    insta::assert_snapshot!(check(&project("JUM <CURSOR>")), @"Label AGAIN");
    insta::assert_snapshot!(check(&project("TEX0 -,LIMIT,<CURSOR>")), @"Label AGAIN");
}

#[test]
fn sums_and_indexes() {
    insta::assert_snapshot!(check(&project("LOD WORD.TABLE+<CURSOR>")), @"
    Constant LIMIT
    Cell Clamp_LINE
    Cell COUNT
    Text NOTE
    Cell OTHER
    Cell SPEED
    Cell STATE
    Area TABLE
    ");
    insta::assert_snapshot!(check(&project("LOD WORD.TABLE[<CURSOR>")), @"
    Keyword BX
    Constant LIMIT
    ");
}

#[test]
fn nothing_where_no_word_of_the_project_may_stand() {
    for line in [
        "LDR RUN ;L<CURSOR>",
        "STR 9,'L<CURSOR>'",
        "LOD 1<CURSOR>",
        "LOD 0<CURSOR>",
        "LDR RUN <CURSOR>",
        "LDR RUN,FAULT,X,<CURSOR>",
        "LDR RUN) <CURSOR>",
        "5 <CURSOR>",
        "T_INCLUDE li<CURSOR>",
        "MECH_BEGIN <CURSOR>",
    ] {
        assert_eq!(labels(&project(line)), Vec::<String>::new(), "{line}");
    }
}

#[test]
fn an_answer_is_bounded_and_keeps_what_fits_best() {
    let mut text = String::from("DATA\n");
    for n in 0..2_000 {
        let line = format!("CELL{n}: DFM BIT{n}\n");
        text.push_str(&line);
    }
    text.push_str("DATA_END\nMODULE_MAIN\n LDR BIT1<CURSOR>\nMODULE_MAIN_END\n");
    let found = labels(&text);
    assert_eq!(found.len(), crate::ide::MOST_COMPLETIONS);
    assert_eq!(found[..3], ["BIT1", "BIT10", "BIT100"]);
}

#[test]
fn members_behind_the_dot_of_a_block_and_of_an_address() {
    let block = labels(&project("LDR BLK[2].<CURSOR>"));
    assert!(block.iter().any(|label| label == "T"), "{block:?}");
    assert!(!block.iter().any(|label| label == "COUNT" || label == "RUN"), "{block:?}");
    let help = completions(&project("LDR BLK[2].T<CURSOR>"));
    assert!(help.iter().any(|it| it.label == "T" && !it.detail.is_empty()), "{help:?}");

    let structure =
        project("LOD TABLE.<CURSOR>").replace("DATA\n", "DATA\nUNIT STRUC\nFEED DW ?\nUNIT ENDS\n");
    let members = labels(&structure);
    assert!(members.iter().any(|label| label == "FEED"), "{members:?}");
}
