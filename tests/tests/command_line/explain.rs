//! `technol explain`.

use crate::ran::run;

#[test]
fn an_instruction_is_explained_in_both_languages_and_any_case() {
    let english = run(&["explain", "TEX0"]).ok();
    let czech = run(&["explain", "tex0", "--language", "cs"]).ok();
    for page in [&english, &czech] {
        assert!(page.contains("TEX0") && page.contains("```technol"), "{page}");
    }
    assert_ne!(english, czech);
    assert!(czech.contains(['ě', 'š', 'č', 'ř', 'ž', 'ů']) && !english.contains(['ě', 'ř', 'ů']));
}

#[test]
fn codes_symbols_and_keywords_are_explained() {
    for (name, said) in
        [("T0301", "declared"), ("P1IN", "port"), ("MODULE_INIT", "MODULE_INIT"), ("WORD.", "WORD")]
    {
        let page = run(&["explain", name]).ok();
        assert!(page.contains(said), "{name}: {page}");
    }
}

#[test]
fn what_is_not_known_ends_with_2_and_a_suggestion() {
    run(&["explain", "LRD"]).failed(2, &["`LRD`", "LDR"]);
    run(&["explain", "T9999"]).failed(2, &["T9999"]);
    run(&["explain", "qqqqqqqq"]).failed(2, &["qqqqqqqq", "T0101"]);
    run(&["explain", ""]).failed(2, &[]);
    run(&["explain", "LDR", "--language", "de"]).failed(2, &["en", "cs"]);
}

#[test]
fn the_list_names_every_kind_of_page() {
    let list = run(&["explain", "--list"]).ok();
    for line in ["LDR ", "CNST. ", "P1IN ", "T0301 "] {
        assert!(list.lines().any(|it| it.starts_with(line)), "{line}");
    }
    assert_ne!(list, run(&["explain", "--list", "--language", "cs"]).ok());
}

#[test]
fn a_search_lists_what_holds_all_the_words() {
    let found = run(&["explain", "--search", "tex0 counter holds"]).ok();
    assert!(found.lines().any(|it| it.starts_with("TEX0 ")), "{found}");
    assert!(!found.contains("\nDIVB "), "{found}");
    let czech = run(&["explain", "--search", "hlaseni", "--language", "cs"]).ok();
    assert!(czech.lines().any(|it| it.starts_with("ESET ")), "{czech}");
    run(&["explain", "--search", "qqqqqq"]).failed(2, &["qqqqqq"]);
    run(&["explain", "--search", "a", "--list"]).failed(2, &["--list"]);
    run(&["explain"]).failed(2, &["NAME"]);
}
