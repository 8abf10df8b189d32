//! How files are cut into sections.

use technol_analysis::syntax::section::{RawSection, SectionKind};
use technol_analysis::syntax::{lines, split};

/// The sections as an indented outline: kind, name, ordinal, own lines (1-based), `open` when not closed.
fn outline(text: &str) -> String {
    let sections = split(text);
    let mut out = String::new();
    write_section(&sections, 0, 0, &mut out);
    out
}

fn write_section(sections: &[RawSection], index: usize, depth: usize, out: &mut String) {
    let section = &sections[index];
    let kind = match section.kind {
        SectionKind::Module(kind) => kind.keyword().to_owned(),
        other => format!("{other:?}"),
    };
    let lines: Vec<_> = section.lines.iter().map(|l| (l + 1).to_string()).collect();
    let open = if section.closed { "" } else { " open" };
    let name = if section.name.is_empty() { String::new() } else { format!(" {}", section.name) };
    let indent = "  ".repeat(depth);
    let row = format!("{indent}{kind}{name} #{} [{}]{open}\n", section.ordinal, lines.join(" "));
    out.push_str(&row);
    for (child, _) in &section.children {
        assert_eq!(sections[*child].parent, Some(index));
        write_section(sections, *child, depth + 1, out);
    }
}

#[test]
fn a_file_of_modules() {
    insta::assert_snapshot!(outline("\
;Lathe
DATA
 A: DS 1
DATA_END

MODULE_MAIN
 LDR X
 MECH_BEGIN Start ;first
  EX
  DATA_LOCAL
   B: DS 1
  DATA_LOCAL_END
 MECH_END Start
 WR X
 PROC_BEGIN P
 PROC_END P
MODULE_MAIN_END
"), @r"
    File #0 [1 5]
      Data #0 [2 3 4]
      MODULE_MAIN #0 [6 7 14 17]
        Mechanism START #0 [8 9 13]
          DataLocal #0 [10 11 12]
        Procedure P #0 [15 16]
    ");
}

#[test]
fn children_know_how_many_own_lines_stand_before_them() {
    let sections = split(
        "MODULE_MAIN\n LDR X\n MECH_BEGIN A\n MECH_END A\n MECH_BEGIN B\n MECH_END B\n WR X\nMODULE_MAIN_END\n",
    );
    assert_eq!(sections[0].children, [(1, 0)]);
    assert_eq!(sections[1].children, [(2, 2), (3, 2)]);
    assert_eq!(sections[1].text, "MODULE_MAIN\n LDR X\n WR X\nMODULE_MAIN_END\n");
    assert_eq!(sections[2].text, " MECH_BEGIN A\n MECH_END A\n");
}

#[test]
fn labels_and_case_do_not_hide_a_keyword() {
    insta::assert_snapshot!(outline("L: module_main\n x : Mech_Begin abc\nmech_end\nmodule_MAIN_end\n"), @r"
    File #0 []
      MODULE_MAIN #0 [1 4]
        Mechanism ABC #0 [2 3]
    ");
}

#[test]
fn words_that_only_look_like_keywords_open_nothing() {
    let text = "MODULE_INIT_FINISHED\nDATA: DS 1\nLDR MECH_BEGIN\n;DATA\nDATAX\nMODULE_\n_END\nMODULE_DONE_FINISHED\nMECH_INIT A\n";
    assert_eq!(split(text).len(), 1);
}

#[test]
fn a_mechanism_without_an_end_closes_at_the_next_one() {
    insta::assert_snapshot!(outline("MODULE_MAIN\nMECH_BEGIN A\nEX\nMECH_BEGIN B\nEX\nPROC_BEGIN C\nMODULE_MAIN_END\nMODULE_INIT\n"), @r"
    File #0 []
      MODULE_MAIN #0 [1 7]
        Mechanism A #0 [2 3] open
        Mechanism B #0 [4 5] open
        Procedure C #0 [6] open
      MODULE_INIT #0 [8] open
    ");
}

#[test]
fn a_module_without_an_end_closes_at_the_next_one() {
    insta::assert_snapshot!(outline("DATA\nA: DS 1\nMODULE_INPUT\nMECH_BEGIN A\nDATA_LOCAL\nMODULE_MAIN\nMODULE_MAIN_END\n"), @r"
    File #0 []
      Data #0 [1 2] open
      MODULE_INPUT #0 [3] open
        Mechanism A #0 [4] open
          DataLocal #0 [5] open
      MODULE_MAIN #0 [6 7]
    ");
}

#[test]
fn an_end_with_another_name_closes_too() {
    insta::assert_snapshot!(outline("MODULE_MAIN\nMECH_BEGIN A\nMECH_END B\nMODULE_INIT_END\nDATA_LOCAL\nDATA_END\n"), @r"
    File #0 []
      MODULE_MAIN #0 [1 4]
        Mechanism A #0 [2 3]
      DataLocal #0 [5 6]
    ");
}

#[test]
fn an_end_without_a_section_is_a_plain_line() {
    insta::assert_snapshot!(outline("MECH_END A\nMODULE_MAIN\nMECH_END\nPROC_END\nDATA_END\nMODULE_MAIN_END\nMODULE_MAIN_END\nEND_T_MACRO\n"), @r"
    File #0 [1 7 8]
      MODULE_MAIN #0 [2 3 4 5 6]
    ");
}

#[test]
fn a_macro_keeps_its_body_and_ends_at_a_module() {
    insta::assert_snapshot!(outline("DEF_T_MACRO M A,B\nDATA_LOCAL\nX: DS 1\nDATA_LOCAL_END\nMECH_BEGIN Y\nMECH_END Y\nEND_T_MACRO\nDEF_T_MACRO N\nLDR A\nDATA\nDATA_END\n"), @r"
    File #0 []
      Macro M #0 [1 2 3 4 5 6 7]
      Macro N #0 [8 9] open
      Data #0 [10 11]
    ");
}

#[test]
fn data_local_may_stand_in_data_and_between_modules() {
    insta::assert_snapshot!(outline("DATA\nDATA_LOCAL\nX: DS 1\nDATA_LOCAL_END\nY: DS 1\nDATA_END\nDATA_LOCAL\nDATA_LOCAL_END\n"), @r"
    File #0 []
      Data #0 [1 5 6]
        DataLocal #0 [2 3 4]
      DataLocal #1 [7 8]
    ");
}

#[test]
fn ordinals_count_per_kind_and_name() {
    insta::assert_snapshot!(outline("MECH_BEGIN A\nMECH_END\nMECH_BEGIN a\nMECH_END\nPROC_BEGIN A\nPROC_END\nMECH_BEGIN\nMECH_END\n"), @r"
    File #0 []
      Mechanism A #0 [1 2]
      Mechanism A #1 [3 4]
      Procedure A #0 [5 6]
      Mechanism #0 [7 8]
    ");
}

#[test]
fn an_empty_file_is_one_empty_section() {
    insta::assert_snapshot!(outline(""), @"File #0 []");
    assert_eq!(lines("").count(), 0);
}
